//! Möller and Trumbore's test: t and two barycentric coordinates by Cramer's rule.

use num_traits::{One, Zero};

use super::facet_hit;
use crate::algebra::Vector3;
use crate::intersection::{FacetHit, Side};
use crate::ray::Ray;

/// The hit by Möller and Trumbore's test: the solution of `o + t d = a + v (b − a) + w (c − a)` by Cramer's rule.
///
/// # Accuracy
///
/// Two triangles round the values at a shared edge differently: about one ray in a dozen through the hub of a fan is lost (hard case
/// `fans_lose_rays_where_edges_are_not_shared`). Good where a lost ray in a million does no harm.
///
/// The determinant is compared with zero and with no threshold: it scales with the triangle's area and the direction's length, so that any
/// fixed threshold refuses small triangles (hard case `fixed_threshold_refuses_needles_and_small_triangles`). Coordinates beyond about
/// 1e±100 in `f64` and 1e±12 in `f32` overflow or underflow in the products of three: [`prescaled`](super::prescaled) cures that.
///
/// # Cost
///
/// 45 multiplications and additions, 3 divisions.
///
/// # Edge cases
///
/// `None` for a triangle without area, and for a ray parallel to its plane, also in it.
///
/// # Source
///
/// Möller, Trumbore 1997, with the two-sided test and the threshold 0.
#[inline]
// ANCHOR: moller_trumbore
pub fn moller_trumbore<P: Vector3>(corners: &[P; 3], ray: &Ray<P>) -> Option<FacetHit<P::Scalar>> {
    let [a, b, c] = *corners;
    let [e1, e2] = [b.minus(a), c.minus(a)];
    let p = ray.direction.cross(e2);
    let determinant = e1.dot(p);
    if determinant.is_zero() {
        return None;
    }
    let s = ray.origin.minus(a);
    let v = s.dot(p) / determinant;
    let [zero, one] = [P::Scalar::zero(), P::Scalar::one()];
    if v < zero || v > one {
        return None;
    }
    let q = s.cross(e1);
    let w = ray.direction.dot(q) / determinant;
    // Written so that NaN is a miss.
    if !(v >= zero && w >= zero && v + w <= one) {
        return None;
    }
    let t = e2.dot(q) / determinant;
    facet_hit(ray, t, [v, w], Side::of(-determinant))
}
// ANCHOR_END: moller_trumbore
