//! The plane of a triangle, then three half-planes: the test of the slides, closed and strict.

use num_traits::Zero;

use super::facet_hit;
use crate::algebra::Vector3;
use crate::intersection::{FacetHit, Side};
use crate::ray::Ray;

/// The hit by the plane and three **closed** half-planes: a point on an edge is inside.
///
/// # Accuracy
///
/// The point `x = o + t d` is rounded before the half-planes see it, with an error of about `u |t d|`: two triangles that share an edge
/// may both refuse a ray through it. For a mesh take [`watertight`](super::watertight) or [`robust`](super::robust).
///
/// # Cost
///
/// 62 multiplications and additions or so, and 3 divisions: about twice as much as [`moller_trumbore`](super::moller_trumbore).
///
/// # Edge cases
///
/// `None` for a triangle without area, and for a ray parallel to its plane, also in it.
///
/// # Source
///
/// Slides 99 and 100, with `>=` for `>`.
#[inline]
pub fn half_planes<P: Vector3>(corners: &[P; 3], ray: &Ray<P>) -> Option<FacetHit<P::Scalar>> {
    plane_and_half_planes(corners, ray, |side| side >= P::Scalar::zero())
}

/// The hit by the plane and three **open** half-planes, as the slides have them: kept to show its cracks.
///
/// # Accuracy
///
/// A ray through an edge or a corner meets no triangle at all, even in exact arithmetic: a mesh has a crack along every edge (tested as
/// `strict_half_planes_leave_cracks`).
///
/// # Source
///
/// Slides 99 and 100.
#[inline]
pub fn strict_half_planes<P: Vector3>(
    corners: &[P; 3],
    ray: &Ray<P>,
) -> Option<FacetHit<P::Scalar>> {
    plane_and_half_planes(corners, ray, |side| side > P::Scalar::zero())
}

// ANCHOR: half_planes
fn plane_and_half_planes<P: Vector3>(
    corners: &[P; 3],
    ray: &Ray<P>,
    is_inside: impl Fn(P::Scalar) -> bool,
) -> Option<FacetHit<P::Scalar>> {
    let [a, b, c] = *corners;
    let n = b.minus(a).cross(c.minus(a));
    let along = ray.direction.dot(n);
    if along.is_zero() {
        return None;
    }
    let t = a.minus(ray.origin).dot(n) / along;
    let x = ray.point(t);
    let half_plane = |from: P, to: P| to.minus(from).cross(x.minus(from)).dot(n);
    let sides = [half_plane(b, c), half_plane(c, a), half_plane(a, b)];
    if !sides.into_iter().all(is_inside) {
        return None;
    }
    let square = n.dot(n);
    let parameters = [sides[1] / square, sides[2] / square];
    facet_hit(ray, t, parameters, Side::of(along))
}
// ANCHOR_END: half_planes
