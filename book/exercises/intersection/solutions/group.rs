//! A solution of exercise 4: the nearest of many surfaces.

use crate::intersection::{Hit, Intersect};
use crate::ray::Ray;

/// The nearest hit and the number of its member.
pub fn nearest<T: Intersect>(
    members: &[T],
    ray: &Ray<T::Point>,
) -> Option<(usize, Hit<T::Point>)> {
    let mut best: Option<(usize, Hit<T::Point>)> = None;
    let mut shortened = *ray;
    for (index, member) in members.iter().enumerate() {
        if let Some(hit) = member.intersect(&shortened) {
            // The ray includes its end: a member at the same distance is found, and does not count.
            let is_nearer = match best {
                None => true,
                Some((_, nearest)) => hit.t < nearest.t,
            };
            if is_nearer {
                shortened = shortened.until(hit.t);
                best = Some((index, hit));
            }
        }
    }
    best
}
