//! Fans in floating point: what others lose at spokes, and what is no fan.

use facette::intersection::fan::{Fan, FanError};
use facette::intersection::triangle::{
    half_planes, moller_trumbore, strict_half_planes, watertight,
};

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
    assert!(
        bad.to_string()
            .starts_with("point 1 of the rim is [NaN, 0.0, 0.0]"),
        "{bad}"
    );
    let far = Fan::open([-1e308, 0.0, 0.0], [[1e308, 0.0, 0.0]; 2]).expect_err("too far");
    assert!(matches!(far, FanError::NotFinite { index: 0, .. }), "{far}");
    let fan = Fan::open(o, [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]).expect("one triangle");
    assert_eq!(fan.triangle_count(), 1);
}
