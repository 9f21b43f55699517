//! The sphere in floating point against arbitrary precision, with bounds derived, and what floating point keeps exactly.

use std::cell::Cell;

use facette::algebra::VectorSpace;
use facette::intersection::{Hit, Intersect, Side, Sphere};
use facette::ray::Ray;
use num_traits::{One, Signed, ToPrimitive, Zero};
use proptest::prelude::*;

use crate::common::bound::Bound;
use crate::common::law::{Broken, Law, Verdict, expect_at_most, expect_equal};
use crate::common::motion::integer_motions;
use crate::common::oracle::{Big, big, big_dot, big_length, big_minus, big_point};
use crate::float_chords::{Float, FloatChord, float_chords, hard_float_chords};
use crate::roots::{big_passing_distance, big_roots};
use crate::sphere_inputs::{hard_integer_chords, integer_chords};
use crate::suspects;

/// Line and sphere, exactly: p, d and r.
fn exactly<S: Float>(sphere: &Sphere<[S; 3]>, ray: &Ray<[S; 3]>) -> ([Big; 3], [Big; 3], Big) {
    let point = |point: [S; 3]| big_point(point.map(Into::into));
    let p = big_minus(&point(ray.origin), &point(sphere.centre()));
    (p, point(ray.direction), big(sphere.radius().into()))
}

/// The hits of the whole line, one after the other.
fn hits_of_line<S: Float>(sphere: &Sphere<[S; 3]>, ray: &Ray<[S; 3]>) -> Vec<Hit<[S; 3]>> {
    let far_behind = -(S::one() / S::zero());
    let mut hits = Vec::new();
    let mut rest = ray.after(far_behind);
    while let Some(hit) = sphere.intersect(&rest) {
        rest = rest.after(hit.t);
        hits.push(hit);
    }
    hits
}

/// **The error of t.** In floating point with the unit roundoff $\mathbf u$, let $P=\lvert\mathbf p\rvert$, $L=\lvert\mathbf d\rvert$, $h=\lvert\mathbf p_\perp\rvert$, and
/// $g=(r-h)(r+h)$. Both roots by projection are within
/// $$8\mathbf u\frac PL+\frac{\epsilon_g}L+4\mathbf u\frac{\sqrt g}L+2\mathbf u\lvert t\rvert,\qquad
/// \epsilon_g=\min\Bigl(\frac{\delta_g}{\sqrt g},\sqrt{\delta_g},r\Bigr),\quad\delta_g=2h\,\delta_h+\delta_h^2+3\mathbf ug,\quad\delta_h=\mathbf u(9P+4h),$$
/// of the true ones, the smaller of them in a slightly different form (below). Near tangency $\sqrt g$ is small: an error $\delta_h$ of the distance is divided by it, or at worst has its root taken. That is no fault of the formula, but
/// of the question.
///
/// *The middle of the chord.* $\mathbf p=\mathbf o-\mathbf c$ is rounded once, by $\mathbf uP$ in length; $\mathbf p\cdot\mathbf d$ and $\mathbf d\cdot\mathbf d$ are rounded by $3\mathbf u$ of $PL$ and $L^2$. So $t_m$ is within
/// $7\mathbf uP/L$, and with the terms in $\mathbf u^2$ within $8\mathbf uP/L$. *The distance.* $\mathbf p_\perp=\mathbf p+t_m\mathbf d$ has that error and the quotient's rounding along $\mathbf d$, at most
/// $8\mathbf uP$; one of $\mathbf uP$ from the product and of $\mathbf uh$ from the sum. The length takes $2.5\mathbf uh$ more. Together with $\mathbf u^2$ terms $\delta_h$; the error of $\mathbf o-\mathbf c$ across the line belongs to it too, and the part along $\mathbf d$ counts only as its square, which leaves room for it.
/// *The half chord.* Three roundings make $g$; $\lvert\sqrt a-\sqrt b\rvert$ is at most $\lvert a-b\rvert/\sqrt a$ and $\sqrt{\lvert a-b\rvert}$, and no half chord is longer than $r$. The product with $\mathbf d\cdot\mathbf d$, the root and the quotient round it by $4\mathbf u$. *The sum*
/// and its quotient round by $2\mathbf u\lvert t\rvert$.
///
/// *The smaller root* is $c/q$, with $c=(P-r)(P+r)$ within $8\mathbf uP^2+4\mathbf u\lvert c\rvert$, since $P$ is within $3.5\mathbf uP$. That is divided by $\lvert q\rvert$; to it comes the relative error of $q$, the other root's.
///
/// A hit is missed, or found where there is none, only where the true distance of the line is within $\delta_h$ of $r$.
///
/// Course: R05, slides 94-95, Ray and sphere: the quadratic equation in t.
#[test]
fn sphere_error_stays_below_its_bound() {
    let bounds = [Bound::default(), Bound::default()];
    let [tried, doubtful] = [Cell::new(0), Cell::new(0)];
    let law = Law::new(
        "intersection::sphere_error_stays_below_its_bound",
        suspects::library,
    );
    law.on_cases(800)
        .holds(float_chords(), hard_float_chords(), |chord| {
            tried.set(tried.get() + 2);
            let both = [
                errors::<f64>(chord, &bounds[0])?,
                errors::<f32>(chord, &bounds[1])?,
            ];
            doubtful.set(doubtful.get() + both.iter().filter(|&&is_certain| !is_certain).count());
            Ok(())
        });
    for bound in &bounds {
        bound.is_used_up_to(0.05);
    }
    assert!(
        2 * doubtful.get() < tried.get(),
        "{} of {} tangents are doubtful",
        doubtful.get(),
        tried.get()
    );
}

/// Whether the numbers of hits agree; where they do not, the line must be within the bound of a tangent.
fn errors<S: Float>(chord: &FloatChord, bound: &Bound) -> Result<bool, Broken> {
    let (sphere, ray) = chord.rounded::<S>();
    let (p, d, r) = exactly(&sphere, &ray);
    let hits = hits_of_line(&sphere, &ray);
    let truth = big_roots(&p, &d, &r);
    let largest = if S::unit_roundoff().into() < 1e-10 {
        f64::MAX
    } else {
        f32::MAX.into()
    };
    let is_held = |roots: &[Big; 2]| roots.iter().all(|root| root.abs() < big(largest));
    if !truth.as_ref().is_none_or(is_held) {
        // A parameter that the type cannot hold is no hit.
        return Ok(true);
    }
    let count = |[near, far]: &[Big; 2]| if near == far { 1 } else { 2 };
    if let Some(roots) = &truth
        && hits.len() == 2
    {
        for (hit, root) in hits.iter().zip(roots) {
            bound.holds(hit.t.into(), root, hit.t_error.into())?;
        }
        return Ok(true);
    }
    if truth.as_ref().map_or(0, count) == hits.len() {
        return Ok(true);
    }
    let passing = big_passing_distance(&p, &d);
    let u = big(S::unit_roundoff().into());
    let nine = Big::from_integer(9.into());
    let margin = u * (nine * big_length(&p) + Big::from_integer(4.into()) * &passing);
    let away = (passing - r).abs();
    let away = (away / margin).to_f64().unwrap_or(f64::INFINITY);
    expect_at_most(
        "a distance from tangency, as a part of its bound,",
        1.0,
        away,
    )?;
    Ok(false)
}

/// **The point lies on the sphere.** The hit's point is not $\mathbf o+t\,\mathbf d$, whose error grows with $t$, but $\mathbf c+r\,\mathbf n$ with the unit normal $\mathbf n$: within
/// $\mathbf u\,(7r+\lvert\mathbf x\rvert_\infty)$ of every coordinate there is a point of the sphere, and it satisfies $(\mathbf x-\mathbf c)\cdot(\mathbf x-\mathbf c)=r^2$ up to that.
///
/// A unit normal's coordinates are within $5\mathbf u$ of their size, the product with $r$ rounds once and the sum once: $6\mathbf ur+\mathbf u\lvert x_k\rvert$, and one $\mathbf ur$ for the terms in $\mathbf u^2$.
///
/// Course: R05, slide 94, Ray and sphere: the implicit equation.
#[test]
fn sphere_point_error_stays_below_its_bound() {
    let bounds = [Bound::default(), Bound::default()];
    let law = Law::new(
        "intersection::sphere_point_error_stays_below_its_bound",
        suspects::library,
    );
    law.on_cases(400)
        .holds(float_chords(), hard_float_chords(), |chord| {
            point_errors::<f64>(chord, &bounds[0])?;
            point_errors::<f32>(chord, &bounds[1])
        });
    for bound in &bounds {
        bound.is_used_up_to(0.05);
    }
}

fn point_errors<S: Float>(chord: &FloatChord, bound: &Bound) -> Verdict {
    let (sphere, ray) = chord.rounded::<S>();
    for hit in hits_of_line(&sphere, &ray) {
        let point = big_point(hit.point.map(Into::into));
        let centre = big_point(sphere.centre().map(Into::into));
        let arm = big_minus(&point, &centre);
        if big_dot(&arm, &arm).is_zero() {
            // The sphere is smaller than the spacing of the coordinates: the nearest of its points are a radius away.
            let zero = Big::zero();
            bound.holds(sphere.radius().into(), &zero, hit.point_error.into())?;
            continue;
        }
        let stretch = big(sphere.radius().into()) / big_length(&arm);
        for axis in 0..3 {
            let on_sphere = &centre[axis] + &arm[axis] * &stretch;
            bound.holds(hit.point[axis].into(), &on_sphere, hit.point_error.into())?;
        }
    }
    Ok(())
}

/// **The side.** From outside a ray meets the front of the sphere, $\mathbf d\cdot\mathbf n<0$; from inside its back, $\mathbf d\cdot\mathbf n>0$. The normal points from the centre to the point, and its length is 1 up to rounding.
///
/// Course: R06, slide 95, Ray and sphere: the nearest solution on the right side.
#[test]
fn sphere_is_hit_on_its_front_from_outside_and_on_its_back_from_inside() {
    let name = "intersection::sphere_is_hit_on_its_front_from_outside_and_on_its_back_from_inside";
    let law = Law::new(name, suspects::library);
    law.holds(integer_chords(), hard_integer_chords(), |chord| {
        let hit = chord.sphere().intersect(&chord.ray());
        let [near, far] = chord.roots;
        let side = if near > 0.0 { Side::Front } else { Side::Back };
        let expected = (far > 0.0).then_some(side);
        let is_tangent = near == far;
        if !is_tangent {
            expect_equal(&expected, &hit.map(|hit| hit.side))?;
        }
        let Some(hit) = hit else { return Ok(()) };
        let t = if near > 0.0 { near } else { far };
        let away = (hit.t - t).abs();
        expect_at_most("the error of t", hit.t_error, away)?;
        let arm = big_minus(&big_point(chord.ray().point(t)), &big_point(chord.centre));
        let true_normal = arm.map(|coordinate| coordinate / big(chord.radius));
        // Where the line is not near tangency, an error of t moves the arm by as much times |d|.
        let speed = chord.direction.largest_coordinate() * 2.0;
        let bound = (hit.t_error * speed + hit.point_error) / chord.radius + 8.0 * f64::EPSILON;
        for (computed, truth) in hit.normal.into_iter().zip(&true_normal) {
            Bound::default().holds(computed, truth, bound)?;
        }
        let norm = big_dot(&big_point(hit.normal), &big_point(hit.normal));
        let from_one = (norm - Big::one()).abs().to_f64().unwrap_or(f64::INFINITY);
        expect_at_most(
            "the square of the normal's length less 1",
            10.0 * f64::EPSILON,
            from_one,
        )
    });
}

/// **Powers of two change nothing.** Magnifying the direction by $2^k$ divides $t$ by $2^k$, magnifying ray and sphere by $2^m$ leaves $t$ as it is: not within a bound, but to the last bit. For
/// the sphere is measured in powers of two near the sizes of $\mathbf d$ and $\mathbf p$ before anything is squared.
///
/// Course: R05, slides 94-95, Ray and sphere: the quadratic equation in t.
#[test]
fn powers_of_two_scale_the_sphere_exactly() {
    let law = Law::new(
        "intersection::powers_of_two_scale_the_sphere_exactly",
        suspects::library,
    );
    let exponents = |limit: i32| (-limit..=limit, -limit..=limit);
    law.holds(
        (float_chords(), exponents(20)),
        (float_chords(), exponents(400)),
        |&(chord, (speed, size))| {
            let [speed, size] = [speed, size].map(|exponent| 2.0_f64.powi(exponent));
            let (sphere, ray) = chord.rounded::<f64>();
            let larger = Sphere::new(sphere.centre().times(size), sphere.radius() * size);
            let larger = larger.expect("still a positive radius");
            let longer = Ray::new(
                ray.origin.times(size),
                ray.direction.times(size).times(speed),
            );
            let chord = sphere.chord(&ray).map(|roots| roots.map(|t| t / speed));
            expect_equal(&chord, &larger.chord(&longer))?;
            let errors = |hit: Hit<[f64; 3]>| [hit.t_error, hit.point_error];
            let before = sphere.intersect(&ray).map(errors);
            let before = before.map(|[of_t, of_point]| [of_t / speed, of_point * size]);
            expect_equal(&before, &larger.intersect(&longer).map(errors))
        },
    );
}

/// **Motions, in floating point.** A ray and a sphere that are moved by a rotation and a shift are rounded anew; what they give stays within both bounds as long as
/// the moved coordinates are exact.
///
/// The test moves integer chords by magnified rotations, so that the true $t$ is the same number before and after, and both answers must be within their bounds of it.
///
/// Course: R05, slides 94-95, Ray and sphere: the quadratic equation in t.
#[test]
fn moved_sphere_is_hit_at_the_same_t() {
    let law = Law::new(
        "intersection::moved_sphere_is_hit_at_the_same_t",
        suspects::library,
    );
    let moved = |chords| (chords, integer_motions());
    law.holds(
        moved(integer_chords().boxed()),
        moved(hard_integer_chords().boxed()),
        |(chord, motion)| {
            if chord.roots[0] == chord.roots[1] {
                return Ok(());
            }
            let radius = f64::from(motion.scale) * chord.radius;
            let sphere =
                Sphere::new(motion.point(chord.centre), radius).expect("a positive radius");
            let ray = Ray::new(motion.point(chord.origin), motion.vector(chord.direction));
            let [before, after] = [
                chord.sphere().intersect(&chord.ray()),
                sphere.intersect(&ray),
            ];
            let truth = chord.roots.into_iter().find(|&t| t > 0.0);
            for hit in [before, after] {
                expect_equal(&truth.is_some(), &hit.is_some())?;
                let Some((hit, truth)) = hit.zip(truth) else {
                    continue;
                };
                Bound::default().holds(hit.t, &big(truth), hit.t_error)?;
            }
            Ok(())
        },
    );
}

/// **A shadow ray's question.** Whether anything is met is answered without the point, the normal and the bounds, and alike: `is_hit_by` says yes exactly where `intersect` finds a hit.
///
/// Course: R04, slide 93, Rays: a half-line, and why it is directional.
#[test]
fn sphere_is_hit_exactly_where_it_has_a_hit() {
    let law = Law::new(
        "intersection::sphere_is_hit_exactly_where_it_has_a_hit",
        suspects::library,
    );
    law.holds(
        (float_chords(), 0.0..3.0_f64),
        (hard_float_chords(), 0.0..3.0_f64),
        |&(chord, end)| {
            let (sphere, ray) = chord.rounded::<f64>();
            for ray in [ray, ray.until(end), ray.after(end)] {
                expect_equal(&sphere.intersect(&ray).is_some(), &sphere.is_hit_by(&ray))?;
            }
            Ok(())
        },
    );
}
