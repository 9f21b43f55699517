//! A solution of exercise 3: the part of a line that is in a box.

use crate::algebra::Vector3;
use crate::intersection::BoundingBox;
use crate::ray::Ray;
use num_traits::Zero;

/// The largest entry and the smallest exit of the three slabs, or `None`.
pub fn box_interval<P: Vector3>(bounds: &BoundingBox<P>, ray: &Ray<P>) -> Option<[P::Scalar; 2]> {
    let mut interval: Option<[P::Scalar; 2]> = None;
    for axis in 0..3 {
        let o = ray.origin.coordinate(axis);
        let d = ray.direction.coordinate(axis);
        let min = bounds.min().coordinate(axis);
        let max = bounds.max().coordinate(axis);
        if d.is_zero() {
            if o < min || o > max {
                return None;
            }
            continue;
        }
        let mut near = (min - o) / d;
        let mut far = (max - o) / d;
        if d < P::Scalar::zero() {
            (near, far) = (far, near);
        }
        if let Some([entry, exit]) = interval {
            if entry > near {
                near = entry;
            }
            if exit < far {
                far = exit;
            }
        }
        interval = Some([near, far]);
    }
    let [entry, exit] = interval?;
    if entry <= exit { Some([entry, exit]) } else { None }
}
