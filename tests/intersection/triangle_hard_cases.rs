//! Rays and triangles that break a formula of the chapter, what survives them, and both shown.

use facette::algebra::VectorSpace;
use facette::intersection::triangle::{
    BaldwinWeberTriangle, ShevtsovTriangle, Triangle, half_planes, moller_trumbore, prescaled,
    robust, strict_half_planes, watertight,
};
use facette::intersection::{FacetHit, Intersect, IntersectionError, Side};
use facette::ray::Ray;

use crate::triangle_floats::{FloatPlace, aimed, exactly};
use crate::triangle_inputs::{Test, closed_tests};
use crate::variants_triangles::moller_trumbore_with_threshold;

type Point = [f64; 3];
type Hits = Vec<(&'static str, Option<FacetHit<f64>>)>;

fn all_tests() -> Vec<(&'static str, Test<Point, f64>)> {
    let mut tests = closed_tests::<Point>().to_vec();
    tests.push(("robust", robust));
    tests
}

fn hits(corners: &[Point; 3], ray: &Ray<Point>) -> Hits {
    all_tests()
        .into_iter()
        .map(|(name, test)| (name, test(corners, ray)))
        .collect()
}

/// **A fixed threshold refuses small triangles.** The determinant is about the length of $\mathbf d$ times twice the area. With the customary test $\lvert\det\rvert<10^{-8}$ a ray along the surface, a needle and a triangle of $10^{-5}$ are missed, although
/// floating point has no trouble with them. Only a determinant of zero divides by zero.
#[test]
fn fixed_threshold_refuses_needles_and_small_triangles() {
    let unit = [[0., 0., 0.], [1., 0., 0.], [0., 1., 0.]];
    for exponent in [-30, -60] {
        let tiny = 2.0_f64.powi(exponent);
        let grazing = Ray::new([-0.75, 0.25, tiny], [1.0, 0.0, -tiny]);
        let down = Ray::new([0.25, 0.25, 1.0], [0.0, 0.0, -1.0]);
        let needle = unit.map(|[x, y, z]| [x, y * tiny, z]);
        let small = unit.map(|corner| corner.times(tiny));
        let cases = [
            (unit, grazing),
            (needle, Ray::new([0.25, 0.25 * tiny, 1.0], down.direction)),
            (
                small,
                Ray::new([0.25 * tiny, 0.25 * tiny, 1.0], down.direction),
            ),
        ];
        for (corners, ray) in cases {
            assert_eq!(moller_trumbore_with_threshold(&corners, &ray), None);
            for (name, hit) in hits(&corners, &ray) {
                let hit = hit.expect(name);
                assert_eq!((hit.t, hit.parameters), (1.0, [0.25, 0.25]), "{name}");
            }
        }
    }
}

/// **Products overflow and underflow.** A triangle of $10^{-110}$ or $10^{150}$, seen from its own size away: the products of three or four lengths leave the range of `f64`, and the plain tests miss it. Multiply everything by a power of two before: that changes no digit.
#[test]
fn size_of_a_triangle_may_be_anything() {
    // About 1e-301, 1e-110, 1e150 and 1e301.
    for size in [-1000, -365, 498, 1000].map(|exponent| 2.0_f64.powi(exponent)) {
        let corners =
            [[0., 0., 0.], [1., 0., 0.], [0., 1., 0.]].map(|corner: Point| corner.times(size));
        let ray = Ray::new([0.25 * size, 0.25 * size, 3.0 * size], [0.0, 0.0, -size]);
        let plain = moller_trumbore(&corners, &ray);
        assert!(
            plain.is_none_or(|hit| !hit.t.is_finite()),
            "{size:e}: {plain:?}"
        );
        for (name, test) in closed_tests::<Point>() {
            let hit = prescaled(&corners, &ray, test).expect(name);
            assert_eq!(
                (hit.t, hit.parameters),
                (3.0, [0.25, 0.25]),
                "{name}, {size:e}"
            );
            // The interval is measured in the same powers of two: its start is left out, its end belongs to it.
            let is_met = |ray: Ray<Point>| prescaled(&corners, &ray, test).is_some();
            let kept = [
                ray.after(2.0),
                ray.after(3.0),
                ray.until(3.0),
                ray.until(2.0),
            ]
            .map(is_met);
            assert_eq!(kept, [true, false, true, false], "{name}, {size:e}");
        }
        let hit = Triangle::new(corners)
            .expect("finite")
            .intersect(&ray)
            .expect("exact at any size");
        assert_eq!(
            (hit.t, hit.parameters),
            (3.0, Some([0.25, 0.25])),
            "{size:e}"
        );
    }
}

/// **A bound that overflows bounds nothing.** A triangle of size $2^i$ at the distance $2^j$, and a ray with a direction of length $2^k$, from $2^{-1000}$ to $2^{1000}$. The volumes that decide may be finite while the one that gives $t$, and its error bound, are infinite; and infinity is not
/// above infinity, so that a comparison lets it pass. What is not finite is therefore computed exactly, and each ray hits at $t=2^{j-k}$.
#[test]
fn infinite_bound_is_no_bound() {
    let power = |exponent: i32| 2.0_f64.powi(exponent);
    let exponents = || (-1000_i32..=1000).step_by(125);
    let mut tried = 0;
    for i in exponents().chain([342, 398, 499]) {
        for j in exponents().chain([342, 398, 532, 665]) {
            for k in exponents().chain([0]).filter(|k| (j - k).abs() <= 1000) {
                let [s, z] = [i, j].map(power);
                let corners = [[-s, -s, z], [2.0 * s, -s, z], [-s, 2.0 * s, z]];
                let ray = Ray::new([0.0; 3], [0.0, 0.0, power(k)]);
                let hit = robust(&corners, &ray).expect("inside");
                assert_eq!((hit.t, hit.side), (power(j - k), Side::Back), "{i} {j} {k}");
                let hit = Triangle::new(corners).expect("finite").intersect(&ray);
                let hit = hit.expect("inside");
                assert_eq!((hit.t, hit.normal), (power(j - k), [0.0, 0.0, 1.0]));
                assert!(hit.point[0].abs() <= s * power(-17) && hit.point[2] == z);
                tried += 1;
            }
        }
    }
    println!("{tried} triangles");
}

/// **Corners farther apart than the largest number.** With corners at $\pm1.5\cdot10^{308}$ the difference $\mathbf b-\mathbf a$ overflows. The point of the hit is between them all the same, and so is its bound.
#[test]
fn corners_may_be_farther_apart_than_the_largest_number() {
    let s = 1.5e308;
    let triangle = Triangle::new([[-s, -s, 1.0], [s, -s, 1.0], [-s, s, 1.0]]).expect("finite");
    for [x, y] in [
        [-0.5_f64, 0.25],
        [-0.25, -0.5],
        [0.5, -0.75],
        [-0.875, 0.75],
    ] {
        let ray = Ray::new([x * s, y * s, 3.0], [0.0, 0.0, -1.0]);
        let hit = triangle.intersect(&ray).expect("inside");
        assert_eq!((hit.t, hit.side), (2.0, Side::Front));
        let error = [0, 1].map(|axis: usize| f64::abs(hit.point[axis] - ray.origin[axis]));
        assert!(
            error.into_iter().all(|error| error <= hit.point_error),
            "{hit:?}"
        );
        assert!(hit.point_error < 8.0 * f64::EPSILON * s, "{hit:?}");
    }
}

/// **Scaling by powers of two changes no bit.** In the middle of the range of numbers the scaled tests give what the plain ones give, to the last bit.
#[test]
fn scaling_by_powers_of_two_changes_no_bit() {
    let mut dice = crate::common::dice::Dice::new(11);
    let mut count = 0;
    for _ in 0..2000 {
        let corners = [dice.vector(), dice.vector(), dice.vector()];
        let place = aimed(
            corners,
            dice.vector(),
            [0.4, 0.4].map(|weight| weight + 0.4 * dice.roll()),
        );
        for (name, test) in closed_tests::<Point>() {
            let plain = test(&corners, &place.ray());
            assert_eq!(prescaled(&corners, &place.ray(), test), plain, "{name}");
            count += usize::from(plain.is_some());
        }
    }
    assert!(count > 3000, "{count}");
}

/// **A stored plane loses digits far away.** A triangle of size 1 at $10^{12}$, hit obliquely from a point near it. Tests that subtract the ray's origin first lose nothing, since the differences are exact. Shevtsov's test, and Baldwin and Weber's, have stored
/// $\mathbf n\cdot\mathbf a\approx10^{12}$, rounded to $10^{-4}$: that is the error of their $t$.
#[test]
fn stored_plane_loses_digits_far_away() {
    let far = [1e12, -1e12, 1e12];
    let corners =
        [[0.0, 0.0, 0.25], [1.0, 0.3, 0.0], [0.1, 1.0, 0.6]].map(|corner: Point| corner.plus(far));
    let ray = Ray::new([-1.0, -0.5, 1.5].plus(far), [0.4, 0.23, -0.41]);
    let place = FloatPlace {
        corners,
        origin: ray.origin,
        direction: ray.direction,
    };
    let crossing = exactly(&place).expect("not parallel");
    assert!(crossing.is_hit());
    let t = num_traits::ToPrimitive::to_f64(&crossing.t).expect("finite");
    for (name, hit) in hits(&corners, &ray) {
        let error = (hit.map_or(f64::INFINITY, |hit| hit.t) - t).abs();
        let is_stored = name == "Shevtsov" || name == "Baldwin and Weber";
        println!("{name}: t is wrong by {error:e}");
        assert_eq!(error > 1e-6, is_stored, "{name}: {error:e}");
        assert!(
            name == "half_planes" || is_stored || error < 1e-15 * t * 4.0,
            "{name}: {error:e}"
        );
    }
}

/// **A needle is hit exactly.** The triangle $(0,0)$, $(1,0)$, $(\tfrac12,2^{-50})$ at the point $(\tfrac12,2^{-52})$: the weights are $\tfrac38$ and $\tfrac14$, without any error.
#[test]
fn needle_is_hit_exactly() {
    let thin = 2.0_f64.powi(-50);
    let corners = [[0., 0., 0.], [1., 0., 0.], [0.5, thin, 0.]];
    let ray = Ray::new([0.5, thin / 4.0, 2.0], [0.0, 0.0, -1.0]);
    for (name, hit) in hits(&corners, &ray) {
        let hit = hit.expect(name);
        assert_eq!((hit.t, hit.parameters), (2.0, [0.375, 0.25]), "{name}");
    }
}

/// **A ray in the plane misses.** Along an edge, through the inside, towards a corner from outside: where the ray lies in the plane of the triangle, $\mathbf d\cdot\mathbf n=0$, and there is no single $t$. All tests answer: a miss. So do they for a ray parallel to it.
#[test]
fn ray_in_the_plane_misses() {
    let corners = [[0., 0., 1.], [4., 0., 1.], [0., 4., 1.]];
    for (origin, direction) in [
        ([-1., 0., 1.], [1., 0., 0.]),
        ([-1., 1., 1.], [1., 0., -0.]),
        ([-1., 1., 1.], [1., -1., 0.]),
        ([1., 1., 1.], [1., 2., 0.]),
        ([1., 1., 0.], [1., 2., 0.]),
    ] {
        for (name, hit) in hits(&corners, &Ray::new(origin, direction)) {
            assert_eq!(hit, None, "{name}");
        }
    }
}

/// **One step outside is outside.** A point one ulp beyond an edge, within it, and on it. Only the exact test is bound to tell them apart; the others may go either way, and here one of them does.
#[test]
fn one_ulp_beside_an_edge_is_told_apart() {
    let corners = [[0., 0., 0.], [3., 1., 0.], [1., 3., 0.]];
    let (mut wrong, mut tried) = (0, 0);
    for step in 1..40 {
        let x = f64::from(step) / 16.0;
        let on_edge = x / 3.0;
        for y in [on_edge.next_down(), on_edge, on_edge.next_up()] {
            let ray = Ray::new([x, y, 7.0], [0.1, 0.1, -0.7]).after(-1e9);
            let place = FloatPlace {
                corners,
                origin: ray.origin,
                direction: ray.direction,
            };
            let is_inside = exactly(&place).is_some_and(|crossing| crossing.is_hit());
            assert_eq!(robust(&corners, &ray).is_some(), is_inside, "{ray:?}");
            wrong += i32::from(half_planes(&corners, &ray).is_some() != is_inside);
            tried += 1;
        }
    }
    println!("{wrong} of {tried} rays beside an edge are misjudged by the half-planes");
}

/// **A triangle without area is never hit.** Where two corners coincide, all tests miss. Three in a row have a rounded normal that need not be zero: one of the tests is taken in. In the exact test the normal is zero, and every ray misses, also one at a corner.
#[test]
fn triangle_without_area_is_never_hit() {
    let [a, b] = [[1., 2., 3.], [4., 5., 7.]];
    let mut taken_in = 0;
    for step in 1..16 {
        let on_the_way = a.plus(b.minus(a).times(f64::from(step) / 16.0));
        let pairs = [[a, a, b], [a, b, b], [a, b, a], [a, a, a]];
        for corners in [[a, on_the_way, b], [b, a, on_the_way]]
            .into_iter()
            .chain(pairs)
        {
            let is_pair = pairs.contains(&corners);
            let is_stored = ShevtsovTriangle::new(&corners).is_some()
                || BaldwinWeberTriangle::new(&corners).is_some();
            assert!(!(is_pair && is_stored));
            for target in [a, b, on_the_way] {
                let origin = [-1.0, 0.5, 0.25];
                let ray = Ray::new(origin, target.minus(origin));
                for (name, hit) in hits(&corners, &ray) {
                    assert!(
                        hit.is_none() || !is_pair && name != "robust",
                        "{name} {corners:?}"
                    );
                    taken_in += i32::from(hit.is_some());
                }
                assert_eq!(
                    Triangle::new(corners).expect("finite").intersect(&ray),
                    None
                );
            }
        }
    }
    println!("{taken_in} hits with triangles without area");
    assert!(taken_in > 0);
}

/// **A sliver by rounding.** Three corners that lie in a row up to one ulp: the rounded vector product may vanish where the exact one does not. The exact test still finds the hits, and their normal.
#[test]
fn sliver_of_one_ulp_has_a_normal() {
    let a = [0.1, 0.1, 0.0];
    let b = [0.7, 0.7, 0.0];
    let c = [0.4, 0.4_f64.next_up(), 0.0];
    let triangle = Triangle::new([a, b, c]).expect("finite");
    let ray = Ray::new([0.4, 0.4, 1.0], [0.0, 0.0, -1.0]);
    let below = Ray::new([0.4, 0.4_f64.next_down(), 1.0], [0.0, 0.0, -1.0]);
    let hit = triangle.intersect(&ray).expect("on the edge or inside");
    assert_eq!(
        (hit.t, hit.normal, hit.side),
        (1.0, [0., 0., 1.], Side::Front)
    );
    assert_eq!(triangle.intersect(&below), None);
}

/// **The zero has a sign, and it does not matter.** Direction components of $-0$ and $0$ give the same hits, and axis-parallel rays at edges and corners of a grid hit for every test.
#[test]
fn negative_zero_in_a_direction_changes_nothing() {
    let corners = [[0., 0., 0.], [4., 0., 0.], [0., 4., 0.]];
    for (x, y) in [(0.0, 0.0), (4.0, 0.0), (2.0, 2.0), (0.0, 1.0), (1.0, 1.0)] {
        for zeros in [[0.0, 0.0], [-0.0, 0.0], [0.0, -0.0], [-0.0, -0.0]] {
            let ray = Ray::new([x, y, 5.0], [zeros[0], zeros[1], -1.0]);
            for (name, hit) in hits(&corners, &ray) {
                assert_eq!(
                    hit.map(|hit| (hit.t, hit.side)),
                    Some((5.0, Side::Front)),
                    "{name} {ray:?}"
                );
            }
        }
    }
}

/// **The origin on the triangle.** A ray that starts in the plane is not stopped by it: $t=0$ is not in the interval, however the ray leaves. One ulp before the plane it is stopped.
#[test]
fn ray_from_the_plane_leaves_it() {
    let corners = [[1., 1., 1.], [4., 1., 2.], [1., 4., 3.]];
    let on_it = [2.0, 2.0, 1.0 + 1.0 / 3.0 + 2.0 / 3.0];
    for direction in [[0.1, 0.2, 0.7], [-0.1, -0.2, -0.7], [1.0, 0.0, -1e-8]] {
        assert_eq!(robust(&corners, &Ray::new(on_it, direction)), None);
    }
    let below = [2.0, 2.0, 2.0_f64.next_down()];
    let hit = robust(&corners, &Ray::new(below, [0.0, 0.0, 1.0])).expect("the plane is above");
    assert_eq!(hit.t, 2.0 - 2.0_f64.next_down());
    assert_eq!(robust(&corners, &Ray::new(below, [0.0, 0.0, -1.0])), None);
}

/// **What is not finite is met nowhere.** A ray with NaN, an infinite coordinate or no direction meets no triangle; a `Triangle` with such a corner is refused by name.
#[test]
fn rays_that_are_not_finite_miss_every_triangle() {
    let corners = [[0., 0., 0.], [4., 0., 0.], [0., 4., 0.]];
    let good = ([1., 1., 5.], [0., 0., -1.]);
    let mut rays = vec![Ray::new(good.0, [0.0; 3])];
    for axis in 0..3 {
        for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            let (mut origin, mut direction) = good;
            origin[axis] = bad;
            direction[axis] = bad;
            rays.extend([Ray::new(origin, good.1), Ray::new(good.0, direction)]);
        }
    }
    rays.push(Ray::new(good.0, good.1).after(f64::NAN));
    for ray in rays {
        for (name, hit) in hits(&corners, &ray) {
            assert_eq!(hit, None, "{name} {ray:?}");
        }
        assert_eq!(strict_half_planes(&corners, &ray), None);
    }
    let refusal = Triangle::new([corners[0], [0.0, f64::NAN, 1.0], corners[2]]).expect_err("NaN");
    assert!(
        matches!(
            refusal,
            IntersectionError::NotFinite {
                what: "corner b",
                ..
            }
        ),
        "{refusal}"
    );
}

/// **Rounded products that are equal.** Two products of `f64` that differ by less than an ulp: their rounded difference is zero, and says nothing. Woop's test then takes the difference of the two rounding errors, which is exact. So the point is on
/// its side of the edge, and not on the edge.
#[test]
fn equal_rounded_products_are_told_apart() {
    let e = f64::EPSILON;
    // Sheared corners p and q with p × q = (1 + e)(1 − e) − 1 = −e².
    let [p, q] = [[1.0 + e, 1.0, 0.0], [1.0, 1.0 - e, 0.0]];
    let beside = [0.0, -3.0, 0.0];
    let ray = Ray::new([0.0, 0.0, 1.0], [0.0, 0.0, -1.0]);
    assert_eq!(p[0] * q[1] - p[1] * q[0], 0.0);
    let hits = [[p, q, [-3.0, 0.0, 0.0]], [q, p, beside]]
        .map(|corners| watertight(&corners, &ray).is_some());
    let exact =
        [[p, q, [-3.0, 0.0, 0.0]], [q, p, beside]].map(|corners| robust(&corners, &ray).is_some());
    assert_eq!(hits, exact);
    // Here the products differ by e², and their rounded values are the same: on the edge by the one, beside it in truth.
    let [a, b] = [[1.0 + e, 1.0, 1.0], [-(1.0 + 2.0 * e), -(1.0 + e), 1.0]];
    let ray = Ray::new([0.0; 3], [0.0, 0.0, 1.0]);
    let thirds = [[-1.0, 1.0, 1.0], [1.0, -1.0, 1.0]];
    let by =
        |test: fn(&[Point; 3], &Ray<Point>) -> bool| thirds.map(|third| test(&[a, b, third], &ray));
    assert_eq!(
        by(|corners, ray| watertight(corners, ray).is_some()),
        [true, false]
    );
    assert_eq!(
        by(|corners, ray| robust(corners, ray).is_some()),
        [true, false]
    );
}
