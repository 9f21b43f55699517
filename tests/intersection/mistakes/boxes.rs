//! The typical mistakes with a line and a box.

use facette::algebra::Vector3;
use facette::intersection::BoundingBox;
use facette::ray::Ray;
use num_traits::Zero;

use super::{SLABS, is_of};

/// What the mistake makes of the interval; `None` for a mistake of another function.
#[allow(
    clippy::option_option,
    reason = "the outer one says whether the mistake is of this function"
)]
pub fn box_interval<P: Vector3>(
    mistake: &str,
    bounds: &BoundingBox<P>,
    ray: &Ray<P>,
) -> Option<Option<[P::Scalar; 2]>> {
    is_of(&[SLABS], mistake).then(|| wrong_interval(mistake, bounds, ray))
}

fn wrong_interval<P: Vector3>(
    mistake: &str,
    bounds: &BoundingBox<P>,
    ray: &Ray<P>,
) -> Option<[P::Scalar; 2]> {
    let zero = P::Scalar::zero();
    let mut interval: Option<[P::Scalar; 2]> = None;
    for axis in 0..3 {
        let [o, d] = [ray.origin, ray.direction].map(|vector| vector.coordinate(axis));
        let [min, max] = [bounds.min(), bounds.max()].map(|corner| corner.coordinate(axis));
        if d.is_zero() {
            let is_in = match mistake {
                "parallel_ignored" => true,
                "parallel_misses" => false,
                "open_slab" => min < o && o < max,
                _ => min <= o && o <= max,
            };
            if !is_in {
                return None;
            }
            continue;
        }
        let slab = [(min - o) / d, (max - o) / d];
        let is_sorted = d > zero || mistake == "near_and_far_not_sorted";
        let slab = if is_sorted { slab } else { [slab[1], slab[0]] };
        interval = Some(interval.map_or(slab, |so_far| combined(mistake, so_far, slab)));
    }
    let [entry, exit] = interval?;
    let entry = if mistake == "ray_instead_of_line" && entry < zero {
        zero
    } else {
        entry
    };
    let is_met = match mistake {
        "never_misses" => true,
        "touching_forgotten" => entry < exit,
        _ => entry <= exit,
    };
    is_met.then_some([entry, exit])
}

fn combined<S: PartialOrd + Copy>(
    mistake: &str,
    [entry, exit]: [S; 2],
    [near, far]: [S; 2],
) -> [S; 2] {
    let later = if near > entry { near } else { entry };
    let earlier = if far < exit { far } else { exit };
    match mistake {
        "first_entry" => [if near < entry { near } else { entry }, earlier],
        "last_exit" => [later, if far > exit { far } else { exit }],
        _ => [later, earlier],
    }
}
