//! Rays that leave a surface: where they begin, so that they do not meet what they leave.
//!
//! A computed hit point lies a rounding beside the surface, on one side or the other. A shadow ray that begins there finds the surface itself in its way (*acne*: a lit
//! surface speckled with shadow). Beginning at t > ε instead, with one ε for all, fails at both ends: next to large coordinates it is less than a rounding, and on a small model it
//! jumps over what should cast the shadow (*light leaks*). The error is known, hit by hit; so the origin is moved by that:
//!
//! ```text
//! o = point ± δ n,     δ = 2 e (|n_x| + |n_y| + |n_z|),     e = point_error
//! ```
//!
//! to the side that the ray's direction points to.
//!
//! # Numerics
//!
//! A point of the surface lies in the box of half-side e around the computed point. Seen along a unit vector n, that box reaches `e (|n_x| + |n_y| + |n_z|)` to either side. Once
//! that far, the origin is outside the box, and beyond the tangent plane of every point in it; twice that far, it keeps the other half for the rounding
//! of the sum and of the next intersection, which are of the same kind and size as e. A last step away from the surface by one or two units in the
//! last place, in each coordinate, makes it move where e is 0, too, but for coordinates that are 0: units in the last place of 0 are 0.
//!
//! To which side the ray goes is the sign of `d · n`. Directions with `|d · n| <= 10u (|d_x n_x| + |d_y n_y| + |d_z n_z|)` lie in the tangent plane as far as rounding can tell (5u for the unit normal
//! and its product with d, 4u for the product that the surface computes, one for the second order): the two signs may differ, and a [`Plane`](super::Plane) may be met again,
//! by a hit whose `t_error` is infinite or of the size of its t.
//!
//! # Sources
//!
//! M. Pharr, W. Jakob, G. Humphreys, *Physically Based Rendering*, 4th edition, 2023, section 6.8 (the box and the last step; its δ has no factor 2, but its shapes refuse a t within its own
//! error); C. Wächter, N. Binder, *A fast and robust method for avoiding self-intersection*, 2019 (an offset in units of the last place, without a bound).
//!
//! *In the course*: slide 93 (*t > 0*).
//!
//! *In the book*: [Hit points](../../../intersection/hit_points.html).

use num_traits::{One, Zero};

use super::{Hit, Side};
use crate::algebra::{Real, Scalar, Vector3};
use crate::ray::Ray;

/// So many times the reach of the error box along the normal is the offset: once to leave the box, once for the rounding that follows.
const REACHES: i32 = 2;

/// The ray that leaves a hit in a direction, of any length: reflected where that points to the side that was hit, refracted where it points to the other.
///
/// # Accuracy
///
/// The origin is at most `2√3 · point_error` away from the hit's point, and 3 units in the last place of each coordinate. From there a plane, a triangle, or a sphere seen from outside is
/// not hit again (tested as `ray_that_leaves_a_facet_does_not_meet_it_again`), and nothing farther in front than that, plus its own error, is missed (tested as
/// `ray_that_leaves_a_facet_meets_what_is_in_front`). Excepted are directions in the tangent plane up to rounding, `|d · n| <= 10u (|d_x n_x| + |d_y n_y| + |d_z n_z|)`, by which a plane may be met
/// again.
///
/// # Edge cases
///
/// A direction along the tangent plane leaves on the side that was hit. NaN gives a ray that meets nothing.
///
/// # Source
///
/// Pharr, Jakob, Humphreys 2023, section 6.8.6.
///
/// # Examples
///
/// ```
/// use facette::intersection::offset::spawn_ray;
/// use facette::intersection::{Intersect, Sphere};
/// use facette::ray::Ray;
///
/// let planet = Sphere::new([0.0, 0.0, -1e7], 1e7)?;
/// let hit = planet.intersect(&Ray::new([3.0, 4.0, 9.0], [0.0, 0.0, -1.0])).expect("it is below");
/// let up = spawn_ray(&hit, [1.0, 0.0, 0.01]);
/// assert!(!planet.is_hit_by(&up));
/// assert!(up.origin[2] - hit.point[2] < 1e-7);
/// # Ok::<(), facette::intersection::IntersectionError<f64>>(())
/// ```
// ANCHOR: spawn_ray
pub fn spawn_ray<P>(hit: &Hit<P>, direction: P) -> Ray<P>
where
    P: Vector3<Scalar: Real>,
{
    Ray::new(offset_point(hit, direction), direction)
}
// ANCHOR_END: spawn_ray

/// The segment from a hit to a point, such as a lamp, without the point itself: what a shadow ray is.
///
/// The direction is not a unit vector: t counts from 0 at the hit to 1 at the point. The end is the largest number below 1, so that the lamp's own surface, met at t = 1, does not stand in its
/// light.
///
/// # Accuracy
///
/// As [`spawn_ray`]. What is met at a true t of 1 may be found before it, where its `t_error` allows that.
///
/// # Examples
///
/// ```
/// use facette::intersection::offset::spawn_ray_to;
/// use facette::intersection::{Intersect, Plane};
/// use facette::ray::Ray;
///
/// let floor = Plane::new([0.0, 0.0, 0.0], [0.0, 0.0, 1.0])?;
/// let ceiling = Plane::new([0.0, 0.0, 3.0], [0.0, 0.0, -1.0])?;
/// let hit = floor.intersect(&Ray::new([1.0, 0.0, 2.0], [0.0, 0.0, -1.0])).expect("it falls");
/// let lamp = [0.0, 0.0, 3.0]; // in the ceiling
/// let shadow_ray = spawn_ray_to(&hit, lamp);
/// assert!(!floor.is_hit_by(&shadow_ray) && !ceiling.is_hit_by(&shadow_ray));
/// # Ok::<(), facette::intersection::IntersectionError<f64>>(())
/// ```
// ANCHOR: spawn_ray_to
pub fn spawn_ray_to<P>(hit: &Hit<P>, point: P) -> Ray<P>
where
    P: Vector3<Scalar: Real>,
{
    let origin = offset_point(hit, point.minus(hit.point));
    let before_one = P::Scalar::one() - P::Scalar::unit_roundoff();
    Ray::new(origin, point.minus(origin)).until(before_one)
}
// ANCHOR_END: spawn_ray_to

/// The point of a hit, moved off the surface to the side that `direction` points to.
// ANCHOR: offset_point
fn offset_point<P>(hit: &Hit<P>, direction: P) -> P
where
    P: Vector3<Scalar: Real>,
{
    let along = direction.dot(hit.normal);
    let is_to_the_front = match hit.side {
        Side::Front => along >= P::Scalar::zero(),
        Side::Back => along > P::Scalar::zero(),
    };
    let n = if is_to_the_front {
        hit.normal
    } else {
        P::origin().minus(hit.normal)
    };
    let n = n.coordinates();
    let reach = hit.point_error * (n[0].magnitude() + n[1].magnitude() + n[2].magnitude());
    let delta = P::Scalar::from_i32(REACHES) * reach;
    P::from_coordinates([0, 1, 2].map(|axis| {
        let moved = hit.point.coordinate(axis) + delta * n[axis];
        stepped(moved, n[axis])
    }))
}
// ANCHOR_END: offset_point

/// The number one or two units in the last place further towards the sign of `towards`: `2u |x|` is at least one unit, and rounds to at most two.
fn stepped<S: Scalar>(x: S, towards: S) -> S {
    let step = S::from_i32(2) * S::unit_roundoff() * x.magnitude();
    if towards > S::zero() {
        x + step
    } else if towards < S::zero() {
        x - step
    } else {
        x
    }
}
