//! Formulas kept only to be compared with.

use facette::algebra::{Scalar, Vector3};
use facette::intersection::FacetHit;
use facette::intersection::triangle::moller_trumbore;
use facette::ray::Ray;

/// Möller and Trumbore's test with the customary threshold on the determinant, `1e-8`.
pub fn moller_trumbore_with_threshold<P: Vector3>(
    corners: &[P; 3],
    ray: &Ray<P>,
) -> Option<FacetHit<P::Scalar>> {
    let threshold = P::Scalar::ratio(1, 100_000_000);
    let [a, b, c] = *corners;
    let determinant = b.minus(a).dot(ray.direction.cross(c.minus(a)));
    if determinant.magnitude() < threshold {
        return None;
    }
    moller_trumbore(corners, ray)
}
