//! Exercise 4: the nearest of many surfaces.
//!
//! Replace `todo!(...)` by your code, save, and run `cargo exercise intersection/group`.

use crate::intersection::{Hit, Intersect};
use crate::ray::Ray;

/// The nearest hit among the members, with the number of the member; where several are hit at the same t, the first of them.
///
/// ```text
/// best so far: nothing, and the ray as it is
/// for each member:
///     ask it with the ray, up to the best distance so far
///     if it is hit, and nearer: that is the best so far
/// ```
///
/// What you can use:
///
/// ```text
/// for (index, member) in members.iter().enumerate() { ... }      counts the members from 0
/// member.intersect(&ray)         perhaps a hit: Some(hit) or None; ask each member once
/// if let Some(hit) = ... { }     does something with the hit, if there is one
/// hit.t                          its parameter
/// ray.until(t)                   the same ray, ended at t
/// Some((index, hit))             the result
/// ```
pub fn nearest<T: Intersect>(
    members: &[T],
    ray: &Ray<T::Point>,
) -> Option<(usize, Hit<T::Point>)> {
    let mut best: Option<(usize, Hit<T::Point>)> = None;
    let mut shortened = *ray;

    todo!("nearest: the nearest hit and the number of its member, or None")
}
