//! Fans in floating point: what others lose at spokes, and what is no fan.

use facette::algebra::{Real, VectorSpace};
use facette::intersection::fan::{Fan, FanError, FanHit};
use facette::intersection::triangle::{
    half_planes, moller_trumbore, strict_half_planes, watertight,
};
use facette::ray::Ray;

use crate::fan_theorems::lost;

/// **Fans lose rays where edges are not shared.** Sixty fans and a ray at the hub or at a spoke of each: Möller and Trumbore's test and the half-planes lose some of them, in `f64`. The watertight test and the fan itself lose none.
#[test]
fn fans_lose_rays_where_edges_are_not_shared() {
    let counts = [moller_trumbore, half_planes, strict_half_planes, watertight]
        .map(|test| lost::<f64>(60, Some(test)));
    println!(
        "of 60 rays: {counts:?} lost by Möller-Trumbore, closed, open half-planes, watertight"
    );
    let [moller_trumbore, closed, open, watertight] = counts;
    assert!(moller_trumbore >= 1 && closed >= 1 && open >= 10);
    assert_eq!((watertight, lost::<f64>(60, None)), (0, 0));
}

/// A fan of size 2^exponents[0], and a ray whose direction has the length 2^exponents[1]: met at t = 3 size / speed.
fn fan_of_size<S: Real>(exponents: [i32; 2]) -> Option<FanHit<S>> {
    let [size, speed] = exponents.map(|exponent| S::from_f64(2.0_f64.powi(exponent)));
    let scaled = |point: [f64; 3], unit: S| point.map(S::from_f64).times(unit);
    let rim = [[1., 0., 0.], [0., 1., 0.], [-1., 0., 0.], [0., -1., 0.]];
    let fan = Fan::closed([S::zero(); 3], rim.map(|point| scaled(point, size)));
    let ray = Ray::new(
        scaled([-0.25, -0.5, 3.0], size),
        scaled([0.0, 0.0, -1.0], speed),
    );
    fan.expect("finite points").intersect(&ray)
}

/// **Fans have a range of sizes.** A fan and a direction between $2^{-30}$ and $2^{30}$ in `f32`, $2^{-300}$ and $2^{300}$ in `f64`, are met at the exact $t$. A fan of $2^{-42}$ and a direction of $2^{-68}$ are too small for `f32`: their triple product underflows, and the hit is lost.
#[test]
fn fan_is_met_at_all_sizes_in_its_range() {
    for size in [-30, -15, 0, 15, 30] {
        for speed in [-30, -15, 0, 15, 30] {
            let narrow = fan_of_size::<f32>([size, speed]).expect("inside");
            let wide = fan_of_size::<f64>([10 * size, 10 * speed]).expect("inside");
            assert_eq!((narrow.triangle, wide.triangle), (2, 2));
            assert_eq!(narrow.facet.t, 3.0 * 2.0_f32.powi(size - speed));
            assert_eq!(wide.facet.t, 3.0 * 2.0_f64.powi(10 * (size - speed)));
        }
    }
    assert_eq!(fan_of_size::<f32>([-42, -68]), None);
    assert!(fan_of_size::<f64>([-42, -68]).is_some());
}

/// **What is no fan is refused.** A rim that is too short, and points that are not finite or too far apart: the message says which.
#[test]
fn unusable_fans_are_refused() {
    let o = [0.0; 3];
    let short = Fan::open(o, [[1.0, 0.0, 0.0]]);
    assert_eq!(
        short,
        Err(FanError::RimTooShort {
            found: 1,
            needed: 2
        })
    );
    let short = Fan::closed(o, [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]).expect_err("two points");
    assert_eq!(
        short.to_string(),
        "the rim has 2 points: a fan needs at least 3"
    );
    let bad = Fan::open(o, [[1.0, 0.0, 0.0], [f64::NAN, 0.0, 0.0]]).expect_err("NaN");
    assert_eq!(
        bad.to_string(),
        "point 1 of the rim is [NaN, 0.0, 0.0], the hub [0.0, 0.0, 0.0]: both and their difference must be finite"
    );
    let far = Fan::open([-1e308, 0.0, 0.0], [[1e308, 0.0, 0.0]; 2]).expect_err("too far");
    assert_eq!(
        far,
        FanError::NotFinite {
            index: 0,
            point: [1e308, 0.0, 0.0],
            hub: [-1e308, 0.0, 0.0]
        }
    );
    let fan = Fan::open(o, [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]).expect("one triangle");
    assert_eq!(fan.triangle_count(), 1);
}
