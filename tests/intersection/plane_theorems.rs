//! The theorems of a line and a plane.

use facette::algebra::{Scalar, Vector3, VectorSpace};
use facette::intersection::{Intersect, Plane, Side};
use facette::ray::Ray;
use num_traits::{Signed, Zero};
use proptest::prelude::*;

use crate::common::bound::Bound;
use crate::common::exact::{Exact, fraction};
use crate::common::generators::{coordinate, point};
use crate::common::law::{Law, Verdict, expect_equal};
use crate::common::motion::integer_motions;
use crate::common::oracle::{big_dot, big_length, big_minus, big_point};
use crate::float_chords::{Float, float_vector};
use crate::suspects;

type Point = [Exact; 3];

/// The point and the normal of a plane, the origin and the direction of a ray.
type Place<V> = [V; 4];

fn places() -> impl Strategy<Value = Place<Point>> {
    [point(), point(), point(), point()].prop_map(with_normal_and_direction)
}

/// Rays along axes, in the plane, parallel to it, nearly parallel, and from a point of it.
fn hard_places() -> impl Strategy<Value = Place<Point>> {
    (places(), point(), 0..5).prop_map(|([a, n, o, d], other, kind)| {
        let in_plane = n.cross(other);
        let tiny = fraction(1, 1 << 30);
        let place = match kind {
            0 => [a, n, a.plus(in_plane), in_plane],
            1 => [a, n, o, in_plane],
            2 => [a, n, o, in_plane.plus(n.times(tiny))],
            3 => [a, n, a.plus(in_plane), d],
            _ => [
                a,
                [Exact::zero(), Exact::zero(), n[2]],
                o,
                [d[0], Exact::zero(), Exact::zero()],
            ],
        };
        with_normal_and_direction(place)
    })
}

/// The same place, with z in the place of a vector without direction.
fn with_normal_and_direction([a, n, o, d]: Place<Point>) -> Place<Point> {
    let z = [0, 0, 1].map(Exact::from_i32);
    let [n, d] = [n, d].map(|v| {
        if v.largest_coordinate().is_zero() {
            z
        } else {
            v
        }
    });
    [a, n, o, d]
}

fn plane<P: Vector3>([a, n, ..]: Place<P>) -> Plane<P> {
    Plane::new(a, n).expect("a point and a normal")
}

/// **The plane.** The line $\mathbf o+t\,\mathbf d$ meets the plane $(\mathbf x-\mathbf a)\cdot\mathbf n=0$ at
/// $$t=\frac{(\mathbf a-\mathbf o)\cdot\mathbf n}{\mathbf d\cdot\mathbf n},$$
/// if $\mathbf d\cdot\mathbf n\ne0$; the point there satisfies the equation exactly. A line with $\mathbf d\cdot\mathbf n=0$ is parallel, and meets the plane nowhere or everywhere: it has no such $t$.
///
/// Course: R08, slide 99, Ray and triangle: the plane.
/// Erratum: the slide divides by $\mathbf d\cdot\mathbf n$ without a condition. It must not be zero: a ray parallel to the plane has no $t$, and even in the plane it has no single one.
#[test]
fn line_meets_the_plane_in_one_point_or_is_parallel() {
    let law = Law::new(
        "intersection::line_meets_the_plane_in_one_point_or_is_parallel",
        suspects::library,
    );
    law.holds(places(), hard_places(), |&place| {
        let [a, n, o, d] = place;
        let ray = Ray::new(o, d);
        let t = plane(place).parameter(&ray);
        let on_plane = t.map(|t| ray.point(t).minus(a).dot(n));
        let is_parallel = d.dot(n).is_zero();
        expect_equal(&(!is_parallel).then(Exact::zero), &on_plane)
    });
}

/// **Motions and magnifications.** A rigid motion of plane and ray leaves $t$ as it is, exactly; the length of the normal does not matter; and a direction $\lambda$ times as long divides $t$ by $\lambda$.
///
/// Course: R08, slide 99, Ray and triangle: the plane.
#[test]
fn plane_parameter_does_not_change_under_motions() {
    let law = Law::new(
        "intersection::plane_parameter_does_not_change_under_motions",
        suspects::library,
    );
    let factor = || coordinate().prop_filter("a factor", |factor| !factor.is_zero());
    let moved = |places| (places, integer_motions(), factor(), factor());
    law.holds(
        moved(places().boxed()),
        moved(hard_places().boxed()),
        |&(place, motion, long, steep)| {
            let [a, n, o, d] = place;
            let t = plane(place).parameter(&Ray::new(o, d));
            let normal = motion.vector(n).times(steep);
            let moved = Plane::new(motion.point(a), normal).expect("a point and a normal");
            let ray = Ray::new(motion.point(o), motion.vector(d).times(long));
            expect_equal(&t.map(|t| t / long), &moved.parameter(&ray))
        },
    );
}

/// A plane and a ray in `f64`.
fn float_places() -> impl Strategy<Value = Place<[f64; 3]>> {
    [
        float_vector(),
        float_vector(),
        float_vector(),
        float_vector(),
    ]
}

/// Grazing rays, far planes, long and short normals and directions.
fn hard_float_places() -> impl Strategy<Value = Place<[f64; 3]>> {
    let size = || prop::sample::select(vec![1.0, 1e-12, 1e12, 1e-30, 1e30]);
    (float_places(), -17..0_i32, [size(), size()], 0..3).prop_map(
        |([a, n, o, d], steepness, [long, steep], kind)| {
            let grazing = n.cross(d).plus(n.times(10.0_f64.powi(steepness)));
            match kind {
                0 => [a, n.times(steep), o, grazing.times(long)],
                1 => [a.times(1e7), n.times(steep), o, d.times(long)],
                _ => [a, n, a.plus(n.cross(d)), d],
            }
        },
    )
}

/// **The error of t.** The hit's `t_error` bounds the error: with $E_1=5\mathbf u\sum\lvert a_k-o_k\rvert\lvert n_k\rvert$ and $E_2=4\mathbf u\sum\lvert d_k\rvert\lvert n_k\rvert$ it is
/// $$\frac{E_1+\lvert t\rvert E_2}{\lvert\mathbf d\cdot\mathbf n\rvert-E_2}+2\mathbf u\lvert t\rvert.$$
/// A sum of three products is within $3\mathbf u$ of the sum of their absolute values, with terms in $\mathbf u^2$ within $4\mathbf u$; the difference $\mathbf a-\mathbf o$ rounds once more. The error of a quotient $x/y$ is at most
/// $(\delta_x+\lvert x/y\rvert\,\delta_y)/(\lvert y\rvert-\delta_y)$, and the quotient itself rounds by $\mathbf u\lvert t\rvert$. Where the denominator is not larger than its error, the ray may be parallel, and the bound is infinite.
///
/// The point is moved onto the plane: it is within `point_error` $=\mathbf u\,(12\lvert\mathbf x-\mathbf a\rvert_\infty+\lvert\mathbf x\rvert_\infty)$ of it.
///
/// Course: R08, slide 99, Ray and triangle: the plane.
#[test]
fn plane_error_stays_below_its_bound() {
    let [of_t, of_point] = [
        [Bound::default(), Bound::default()],
        [Bound::default(), Bound::default()],
    ];
    let law = Law::new(
        "intersection::plane_error_stays_below_its_bound",
        suspects::library,
    );
    law.on_cases(400)
        .holds(float_places(), hard_float_places(), |&place| {
            errors::<f64>(place, [&of_t[0], &of_point[0]])?;
            errors::<f32>(place, [&of_t[1], &of_point[1]])
        });
    for bound in of_t.iter().chain(&of_point) {
        bound.is_used_up_to(0.05);
    }
}

fn errors<S: Float>(place: Place<[f64; 3]>, [of_t, of_point]: [&Bound; 2]) -> Verdict {
    let place = place.map(|vector| vector.map(S::nearest));
    let [.., o, d] = place;
    let [exact_a, exact_n, exact_o, exact_d] =
        place.map(|vector| big_point(vector.map(Into::into)));
    let far_behind = -(S::one() / S::zero());
    let Some(hit) = plane(place).intersect(&Ray::new(o, d).after(far_behind)) else {
        return Ok(());
    };
    let approach = big_dot(&exact_d, &exact_n);
    if approach.is_zero() {
        return expect_equal(&f64::INFINITY, &hit.t_error.into());
    }
    let t = big_dot(&big_minus(&exact_a, &exact_o), &exact_n) / &approach;
    of_t.holds(hit.t.into(), &t, hit.t_error.into())?;
    let point = big_point(hit.point.map(Into::into));
    // The foot of the perpendicular is a point of the plane, and no coordinate is farther from it than the distance.
    let height = big_dot(&big_minus(&point, &exact_a), &exact_n).abs() / big_length(&exact_n);
    of_point.holds(0.0, &height, hit.point_error.into())?;
    let side = if approach.is_negative() {
        Side::Front
    } else {
        Side::Back
    };
    let is_certain = hit.t_error.into() < f64::INFINITY;
    if is_certain {
        expect_equal(&side, &hit.side)
    } else {
        Ok(())
    }
}

/// **Interval and side.** A plane is met only in the ray's interval of $t$, its end included and its start not; on the front where $\mathbf d\cdot\mathbf n<0$.
///
/// Course: R04, slide 93, Rays: a half-line, and why it is directional.
#[test]
fn plane_is_met_in_the_interval_only() {
    let [zero, one] = [[0.0; 3], [0.0, 0.0, 1.0]];
    let floor = Plane::new(zero, one).expect("a point and a normal");
    let falling = Ray::new([0.0, 0.0, 2.0], [3.0, 0.0, -1.0]);
    let rising = Ray::new([0.0, 0.0, -2.0], [3.0, 0.0, 1.0]);
    let met = |ray: Ray<[f64; 3]>| {
        floor
            .intersect(&ray)
            .map(|hit| (hit.t, hit.point, hit.side))
    };
    assert_eq!(met(falling), Some((2.0, [6.0, 0.0, 0.0], Side::Front)));
    assert_eq!(met(rising), Some((2.0, [6.0, 0.0, 0.0], Side::Back)));
    assert_eq!(met(falling.until(2.0)), met(falling));
    assert_eq!(met(falling.until(1.999)), None);
    assert_eq!(met(falling.after(2.0)), None);
    assert_eq!(
        met(Ray::new(zero, [0.0, 0.0, 1.0])),
        None,
        "the origin does not belong to the ray"
    );
}
