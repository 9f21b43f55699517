//! Other ways to ask whether a ray meets a box, kept for comparison: the hard cases refute them, and the report of speed against error
//! measures them.
//!
//! | variant | what it loses |
//! | --- | --- |
//! | [`propagating_slabs`] | rays in a face's plane: 0 · ∞ is NaN, and NaN spreads |
//! | [`ignoring_slabs`] | the same rays: the other plane of the slab, infinitely far, takes the place of NaN |
//! | [`slabs_by_sign`] | rays with −0 in the direction: it takes near for far |
//! | [`unwidened_slabs`] | rays through an edge, where rounding puts the entry behind the exit |
#![allow(
    dead_code,
    reason = "tests and report each use their part of these variants"
)]

use facette::algebra::{Real, Scalar, Vector3};
use facette::intersection::BoundingBox;
use facette::ray::Ray;
use num_traits::{One, Zero};

/// How one slab's two parameters are put in order, and combined with what the others have left.
type Combine<S> = fn([S; 2], [S; 2], bool) -> [S; 2];

fn slabs<P>(
    bounds: &BoundingBox<P>,
    ray: &Ray<P>,
    by_sign_of_d: bool,
    combine: Combine<P::Scalar>,
) -> bool
where
    P: Vector3,
    P::Scalar: Real,
{
    let [zero, one] = [P::Scalar::zero(), P::Scalar::one()];
    let mut interval = [ray.start, ray.end.unwrap_or(one / zero)];
    for axis in 0..3 {
        let [o, d] = [ray.origin, ray.direction].map(|vector| vector.coordinate(axis));
        let reciprocal = one / d;
        let planes = [bounds.min(), bounds.max()];
        let slab = planes.map(|corner| (corner.coordinate(axis) - o) * reciprocal);
        let is_backward = if by_sign_of_d {
            d < zero
        } else {
            reciprocal < zero
        };
        interval = combine(interval, slab, is_backward);
    }
    interval[0] <= interval[1]
}

fn is_nan<S: Scalar>(value: S) -> bool {
    value.partial_cmp(&value).is_none()
}

/// The smaller number, NaN where one is NaN: as the instructions of some processors and of some languages.
fn propagating_min<S: Scalar>(a: S, b: S) -> S {
    if is_nan(a) || a < b { a } else { b }
}

fn propagating_max<S: Scalar>(a: S, b: S) -> S {
    if is_nan(a) || a > b { a } else { b }
}

/// The smaller number, the other one where one is NaN: as Rust's and C's `fmin`.
fn ignoring_min<S: Scalar>(a: S, b: S) -> S {
    if is_nan(b) || a < b { a } else { b }
}

fn ignoring_max<S: Scalar>(a: S, b: S) -> S {
    if is_nan(b) || a > b { a } else { b }
}

/// Slabs by minimum and maximum that give NaN for NaN.
pub fn propagating_slabs<P>(bounds: &BoundingBox<P>, ray: &Ray<P>) -> bool
where
    P: Vector3,
    P::Scalar: Real,
{
    slabs(bounds, ray, false, |[entry, exit], [a, b], _| {
        let [near, far] = [propagating_min(a, b), propagating_max(a, b)];
        [propagating_max(near, entry), propagating_min(far, exit)]
    })
}

/// Slabs by minimum and maximum that ignore NaN.
pub fn ignoring_slabs<P>(bounds: &BoundingBox<P>, ray: &Ray<P>) -> bool
where
    P: Vector3,
    P::Scalar: Real,
{
    slabs(bounds, ray, false, |[entry, exit], [a, b], _| {
        let [near, far] = [ignoring_min(a, b), ignoring_max(a, b)];
        [ignoring_max(entry, near), ignoring_min(exit, far)]
    })
}

fn ordered<S: Scalar>([entry, exit]: [S; 2], [a, b]: [S; 2], is_backward: bool) -> [S; 2] {
    let [near, far] = if is_backward { [b, a] } else { [a, b] };
    [
        if near > entry { near } else { entry },
        if far < exit { far } else { exit },
    ]
}

/// Slabs put in order by `d < 0`, which −0 is not.
pub fn slabs_by_sign<P>(bounds: &BoundingBox<P>, ray: &Ray<P>) -> bool
where
    P: Vector3,
    P::Scalar: Real,
{
    slabs(bounds, ray, true, ordered)
}

/// The library's slabs, without the widening of the exit.
pub fn unwidened_slabs<P>(bounds: &BoundingBox<P>, ray: &Ray<P>) -> bool
where
    P: Vector3,
    P::Scalar: Real,
{
    slabs(bounds, ray, false, ordered)
}
