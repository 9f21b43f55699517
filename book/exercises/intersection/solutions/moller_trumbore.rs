//! A solution of exercise 6: a triangle by Möller and Trumbore's test.

use crate::algebra::Vector3;
use crate::intersection::{FacetHit, Side};
use crate::ray::Ray;
use num_traits::{One, Zero};

/// The hit by Cramer's rule.
pub fn moller_trumbore<P: Vector3>(corners: &[P; 3], ray: &Ray<P>) -> Option<FacetHit<P::Scalar>> {
    let [a, b, c] = *corners;
    let e1 = b.minus(a);
    let e2 = c.minus(a);
    let p = ray.direction.cross(e2);
    let determinant = e1.dot(p);
    if determinant.is_zero() {
        return None;
    }
    let s = ray.origin.minus(a);
    let q = s.cross(e1);
    let v = s.dot(p) / determinant;
    let w = ray.direction.dot(q) / determinant;
    let t = e2.dot(q) / determinant;
    let zero = P::Scalar::zero();
    if v < zero || w < zero || v + w > P::Scalar::one() || !ray.reaches(t) {
        return None;
    }
    let side = if determinant > zero { Side::Front } else { Side::Back };
    Some(FacetHit { t, parameters: [v, w], side })
}
