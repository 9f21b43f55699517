//! The theorems of a line and a sphere, in the order of the text: on numbers that floating point holds exactly, so that `==` decides.

use facette::algebra::{Vector3, VectorSpace};
use facette::intersection::{Sphere, first_root, roots_by_projection, roots_by_quadratic};
use facette::ray::Ray;
use num_traits::Zero;
use proptest::prelude::*;

use crate::common::bound::Bound;
use crate::common::exact::Exact;
use crate::common::law::{Broken, Law, Verdict, expect_equal};
use crate::common::motion::integer_motions;
use crate::common::oracle::{big, big_point};
use crate::roots::big_roots;
use crate::sphere_inputs::{IntegerChord, exact, hard_integer_chords, integer_chords};
use crate::suspects;

/// **A half-line does not look back.** A ray $\mathbf r(t)=\mathbf o+t\,\mathbf d$ has $t>0$: of the points where its line meets a surface it sees those in front of
/// its origin, and the ray in the direction $-\mathbf d$ sees the others. The origin itself belongs to neither.
///
/// More generally a ray has an interval $t_{\text{start}}<t\le t_{\text{end}}$, half-open: start and end may be set so that a piece of a line is cut into rays without a gap and without overlap.
///
/// Course: R04, slide 93, Rays: a half-line, and why it is directional.
/// Exercise: sphere.
#[test]
fn ray_and_its_opposite_share_the_line() {
    let law = Law::new(
        "intersection::ray_and_its_opposite_share_the_line",
        suspects::sphere,
    );
    law.holds(integer_chords(), hard_integer_chords(), |chord| {
        let [near, far] = chord.roots;
        let ahead = first_root(chord.roots, &chord.ray());
        let opposite = Ray::new(chord.origin, chord.direction.times(-1.0));
        let behind = first_root([-far, -near], &opposite);
        let all = [near, far].into_iter();
        let nearest_ahead = all.clone().filter(|&t| t > 0.0).reduce(f64::min);
        let nearest_behind = all.filter(|&t| t < 0.0).map(|t| -t).reduce(f64::min);
        expect_equal(&[nearest_ahead, nearest_behind], &[ahead, behind])?;
        let [before, after] = [
            chord.ray().after(near),
            chord.ray().after(near - 1.0).until(near),
        ];
        let rest = (far > near).then_some(far);
        expect_equal(
            &[rest, Some(near)],
            &[before, after].map(|ray| first_root(chord.roots, &ray)),
        )
    });
}

/// **The quadratic.** With $\mathbf p=\mathbf o-\mathbf c$, the line $\mathbf o+t\,\mathbf d$ meets the sphere of radius $r$ around $\mathbf c$ where
/// $$t=\frac{-\mathbf d\cdot\mathbf p\pm\sqrt{(\mathbf d\cdot\mathbf p)^2-(\mathbf d\cdot\mathbf d)(\mathbf p\cdot\mathbf p-r^2)}}{\mathbf d\cdot\mathbf d}.$$
///
/// The test knows the answer beforehand: it lays lines through two points of a sphere with integer coordinates, such as $(1,2,2)$ and $(2,-1,2)$ at distance 3, so that all
/// numbers of the formula are small, and floating point gives the roots themselves.
///
/// Course: R05, slides 94-95, Ray and sphere: the quadratic equation in t.
/// Exercise: sphere.
#[test]
fn quadratic_gives_both_ends_of_a_chord() {
    let law = Law::new(
        "intersection::quadratic_gives_both_ends_of_a_chord",
        suspects::sphere,
    );
    law.holds(integer_chords(), hard_integer_chords(), |chord| {
        let roots = roots_by_quadratic(chord.p(), chord.direction, chord.radius);
        expect_equal(&Some(chord.roots), &roots)
    });
}

/// **How often a line meets a sphere** is told by the sign of the discriminant
/// $\Delta=(\mathbf d\cdot\mathbf p)^2-(\mathbf d\cdot\mathbf d)(\mathbf p\cdot\mathbf p-r^2)$: twice for $\Delta>0$, once for $\Delta=0$, never for $\Delta<0$. For $\Delta=(\mathbf d\cdot\mathbf d)\,(r^2-h^2)$,
/// where $h=\lvert\mathbf p\times\mathbf d\rvert/\lvert\mathbf d\rvert$ is the distance of the line from the centre.
///
/// Course: R05, slides 94-95, Ray and sphere: the quadratic equation in t.
/// Exercise: sphere.
#[test]
fn discriminant_counts_the_points() {
    let small = || [-6..=6_i32, -6..=6, -6..=6];
    let lines = (small(), small(), 1..=12_i32)
        .prop_filter("a line has a direction", |(_, d, _)| *d != [0; 3])
        .prop_map(|(p, d, halves)| ([p, d].map(|v| v.map(f64::from)), f64::from(halves) / 2.0));
    let tangents = hard_integer_chords().prop_map(|chord| {
        let IntegerChord {
            radius, direction, ..
        } = chord;
        ([chord.p(), direction], radius)
    });
    let law = Law::new(
        "intersection::discriminant_counts_the_points",
        suspects::sphere,
    );
    law.holds(lines, tangents, |&([p, d], r)| {
        let [exact_p, exact_d] = [p, d].map(|vector| vector.map(exact));
        let across = exact_p.cross(exact_d);
        let by_distance = exact(r) * exact(r) * exact_d.dot(exact_d) - across.dot(across);
        let sphere = Sphere::new([Exact::zero(); 3], exact(r)).expect("a positive radius");
        let discriminant = sphere.discriminant(&Ray::new(exact_p, exact_d));
        expect_equal(&by_distance, &discriminant)?;
        let count =
            roots_by_quadratic(p, d, r).map_or(0, |[near, far]| if near < far { 2 } else { 1 });
        let expected = match by_distance.partial_cmp(&Exact::zero()) {
            Some(std::cmp::Ordering::Less) => 0,
            Some(std::cmp::Ordering::Equal) => 1,
            _ => 2,
        };
        expect_equal(&expected, &count)
    });
}

/// **The nearest in front.** Of the two solutions the ray's answer is the smaller one with $t>0$: from outside the near one, from inside the far one, with the sphere behind none.
/// So the same goes for every interval $t_{\text{start}}<t\le t_{\text{end}}$.
///
/// Course: R06, slide 95, Ray and sphere: the nearest solution on the right side.
/// Exercise: sphere.
#[test]
fn nearest_root_in_front_is_the_answer() {
    let law = Law::new(
        "intersection::nearest_root_in_front_is_the_answer",
        suspects::sphere,
    );
    let places = || prop::sample::select(vec![-2.0, -0.5, 0.0, 0.5, 2.0]);
    let with_places = |chords| (chords, places(), places());
    law.holds(
        with_places(integer_chords().boxed()),
        with_places(hard_integer_chords().boxed()),
        |&(chord, after_near, after_far)| {
            let [near, far] = chord.roots;
            let first = |ray: Ray<[f64; 3]>| first_root(chord.roots, &ray);
            let [outside, inside, behind] =
                [near - 1.0, near, far].map(|start| chord.ray().after(start));
            let expected = [Some(near), (near < far).then_some(far), None];
            expect_equal(&expected, &[outside, inside, behind].map(first))?;
            let between = chord.ray().after(near + after_near).until(far + after_far);
            let is_near = after_near < 0.0 && near <= far + after_far;
            let is_far = near + after_near < far && after_far >= 0.0;
            let expected = if is_near {
                Some(near)
            } else {
                is_far.then_some(far)
            };
            expect_equal(&expected, &first(between))
        },
    );
}

/// **Motions.** Moving ray and sphere together by a rigid motion leaves $t$ as it is, and so does magnifying both: $t$ counts multiples of $\mathbf d$, which grows with everything.
///
/// The test moves chords by rotations with rational coefficients, magnified so that all numbers become integers, and compares the roots with `==`.
///
/// Course: R05, slides 94-95, Ray and sphere: the quadratic equation in t.
/// Exercise: sphere.
#[test]
fn roots_do_not_change_under_motions() {
    let law = Law::new(
        "intersection::roots_do_not_change_under_motions",
        suspects::sphere,
    );
    let moved = |chords| (chords, integer_motions());
    law.holds(
        moved(integer_chords().boxed()),
        moved(hard_integer_chords().boxed()),
        |(chord, motion)| {
            let p = motion.point(chord.origin).minus(motion.point(chord.centre));
            let d = motion.vector(chord.direction);
            let r = f64::from(motion.scale) * chord.radius;
            expect_equal(&Some(chord.roots), &roots_by_quadratic(p, d, r))
        },
    );
}

/// **The direction's length.** A direction $\lambda\,\mathbf d$ with $\lambda>0$ gives $t/\lambda$: the same points. With a unit vector $\mathbf d\cdot\mathbf d=1$ drops out of the formula,
/// and $t$ is a distance; with any other it must not be left out.
///
/// Course: R05, slides 94-95, Ray and sphere: the quadratic equation in t.
/// Exercise: sphere.
#[test]
fn longer_direction_means_smaller_t() {
    let law = Law::new(
        "intersection::longer_direction_means_smaller_t",
        suspects::sphere,
    );
    let scaled = |chords| (chords, prop::sample::select(vec![0.125, 0.5, 2.0, 16.0]));
    law.holds(
        scaled(integer_chords().boxed()),
        scaled(hard_integer_chords().boxed()),
        |&(chord, factor)| {
            let roots = roots_by_quadratic(chord.p(), chord.direction.times(factor), chord.radius);
            expect_equal(&Some(chord.roots.map(|t| t / factor)), &roots)
        },
    );
}

/// **The same line, by projection.** The line comes nearest to the centre at $t_m=-\mathbf p\cdot\mathbf d/\mathbf d\cdot\mathbf d$, in the point $\mathbf c+\mathbf p_\perp$ with
/// $\mathbf p_\perp=\mathbf p+t_m\mathbf d$. By Pythagoras, half the chord is $\sqrt{r^2-\lvert\mathbf p_\perp\rvert^2}$ long, and the roots are
/// $$t=t_m\pm\frac{\sqrt{(r-\lvert\mathbf p_\perp\rvert)(r+\lvert\mathbf p_\perp\rvert)}}{\lvert\mathbf d\rvert}.$$
///
/// On the integer chords that the quadratic solves exactly, both roots must agree with it up to a few roundings of $\lvert\mathbf p\rvert$, taken with the slope of the root there.
///
/// Course: R05, slides 94-95, Ray and sphere: the quadratic equation in t.
/// Exercise: stable.
#[test]
fn projection_gives_the_same_roots() {
    let law = Law::new(
        "intersection::projection_gives_the_same_roots",
        suspects::stable,
    );
    law.holds(integer_chords(), integer_chords(), |chord| {
        let roots = roots_by_projection(chord.p(), chord.direction, chord.radius);
        let Some(got) = roots else {
            return Err(Broken {
                expected: format!("{:?}", chord.roots),
                got: "no roots".to_owned(),
            });
        };
        // The half chord of distinct integer points is at least 1/2, so that |p⊥| has at most 20 r as its slope there; 20 roundings of |p|
        // and |t d|, in each of the two terms, are more than the formula makes.
        let speed = chord.direction.dot(chord.direction).sqrt();
        let [near, far] = chord.roots.map(f64::abs);
        let lengths = chord.p().largest_coordinate() + chord.radius + near.max(far) * speed;
        let bound = 800.0 * f64::EPSILON * lengths * chord.radius / speed;
        close(chord.roots, got, bound)
    });
}

fn close(expected: [f64; 2], got: [f64; 2], bound: f64) -> Verdict {
    let is_close = (0..2).all(|which| (expected[which] - got[which]).abs() <= bound);
    if is_close {
        return Ok(());
    }
    Err(Broken {
        expected: format!("{expected:?} within {bound:e}"),
        got: format!("{got:?}"),
    })
}

/// A line along an axis past the unit sphere or a larger one, and whether floating point knows `p⊥` exactly.
fn along_axis((across, before): ([f64; 2], f64), axis: usize, speed: f64) -> [[f64; 3]; 2] {
    let mut p = [across[0], across[1], -before];
    let mut d = [0.0, 0.0, speed];
    p.rotate_left(axis);
    d.rotate_left(axis);
    [p, d]
}

/// **No digits are lost on the way.** On lines along an axis $\mathbf p_\perp$ is known exactly, and the roots by projection are within
/// $$\frac1{\lvert\mathbf d\rvert}\,\frac{8\mathbf uh^2+3\mathbf ug}{\sqrt g}+4\mathbf u\frac{\sqrt g}{\lvert\mathbf d\rvert}+16\mathbf u\lvert t\rvert,\qquad g=(r-h)(r+h),$$
/// of the true ones from any distance: $c$ is within $10\mathbf u$ of its size from two radii on, and $q$ and the quotients add less than six. A line that passes by, if only by one ulp, is found to miss. The slides' discriminant squares the distance, and at $10^8$ radii nothing of the radius is left.
///
/// Course: R05, slides 94-95, Ray and sphere: the quadratic equation in t.
/// Exercise: stable.
#[test]
fn projection_loses_no_digits_from_afar() {
    let law = Law::new(
        "intersection::projection_loses_no_digits_from_afar",
        suspects::stable,
    );
    let axis = || 0..3_usize;
    let powers = || prop::sample::select(vec![0.25, 1.0, 2.0, 16.0]);
    let ordinary = ([-0.7..0.7_f64, -0.7..0.7_f64], 2.0..1000.0_f64);
    let next_to_tangent =
        (prop::sample::select(vec![-64, -8, -1, 0, 1, 8]), 3..16_i32).prop_map(|(ulps, e)| {
            (
                [1.0 + f64::from(ulps) * f64::EPSILON, 0.0],
                10.0_f64.powi(e),
            )
        });
    let far = ([-0.7..0.7_f64, -0.7..0.7_f64], 4..16_i32)
        .prop_map(|(across, e)| (across, 10.0_f64.powi(e)));
    let hard = prop_oneof![next_to_tangent, far];
    law.on_cases(256).holds(
        (ordinary, axis(), powers()),
        (hard, axis(), powers()),
        |&(place, axis, speed)| {
            let [p, d] = along_axis(place, axis, speed);
            let truth = big_roots(&big_point(p), &big_point(d), &big(1.0));
            let got = roots_by_projection(p, d, 1.0);
            let (Some(truth), Some(got)) = (&truth, got) else {
                return expect_equal(&truth.is_some(), &got.is_some());
            };
            let u = f64::EPSILON / 2.0;
            let h = place.0[0].hypot(place.0[1]);
            let g = ((1.0 - h) * (1.0 + h)).max(f64::MIN_POSITIVE);
            let of_gap = ((8.0 * u * h * h + 3.0 * u * g) / g.sqrt()).min((8.0 * u * h * h).sqrt());
            for (got, truth) in got.into_iter().zip(truth) {
                let bound = (of_gap + 4.0 * u * g.sqrt()) / speed + 16.0 * u * got.abs();
                Bound::default().holds(got, truth, bound)?;
            }
            Ok(())
        },
    );
}

/// **The near root next to the surface.** With the origin just outside a large sphere, $t=(-b-\sqrt\Delta)/\mathbf d\cdot\mathbf d$ is a small difference of large numbers. The two roots have the product $c/\mathbf d\cdot\mathbf d$, with
/// $c=(\lvert\mathbf p\rvert-r)(\lvert\mathbf p\rvert+r)$: so the smaller is $c/q$, where $q/\mathbf d\cdot\mathbf d$ is the larger, and nothing cancels. From an origin on an axis, whose distance from the centre is exact, the near root is
/// within $20\mathbf u$ of its own size, however near the surface is.
///
/// The directions of the test pass the centre at less than $0.6\,r$. Then $q=\lvert b\rvert+\sqrt D$ is within $3\mathbf u$ for the first term and within $4\mathbf u+h\,\delta_h/g\le15\mathbf u$ for the second, its smaller half; $c$ rounds twice, the quotient once.
///
/// Course: R05, slides 94-95, Ray and sphere: the quadratic equation in t.
/// Exercise: stable.
#[test]
fn near_root_keeps_its_digits_next_to_the_surface() {
    let law = Law::new(
        "intersection::near_root_keeps_its_digits_next_to_the_surface",
        suspects::stable,
    );
    let radii = || prop::sample::select(vec![1.0, 2.0_f64.powi(20), 1e6, 1e10]);
    let slants = || [-0.5..0.5_f64, -0.5..0.5_f64];
    let gaps = (1.0..4.0_f64, -30..-3_i32).prop_map(|(gap, e)| gap * 2.0_f64.powi(e));
    let hard_gaps = prop::sample::select(vec![0.5, 2.0_f64.powi(-15), 1e-3]);
    let hard_slants = prop::sample::select(vec![[0.6, 0.0], [0.0, -0.1], [0.3, 0.4]]);
    let axis = || 0..3_usize;
    law.holds(
        (radii(), gaps, axis(), slants()),
        (radii(), hard_gaps, axis(), hard_slants),
        |&(radius, gap, axis, slant)| {
            let [p, mut d] = along_axis(([0.0, 0.0], radius + gap * radius.sqrt()), axis, 1.0);
            d[(3 - axis) % 3] = slant[0];
            d[(4 - axis) % 3] = slant[1];
            let Some([truth, _]) = big_roots(&big_point(p), &big_point(d), &big(radius)) else {
                return Ok(());
            };
            let Some([near, _]) = roots_by_projection(p, d, radius) else {
                return Err(Broken {
                    expected: format!("{truth}"),
                    got: "no roots".to_owned(),
                });
            };
            Bound::default().holds(near, &truth, 10.0 * f64::EPSILON * near.abs())
        },
    );
}
