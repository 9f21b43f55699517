//! A solution of exercise 1: where a line meets a sphere, and where a ray does.

use crate::algebra::{Real, Vector3};
use crate::ray::Ray;
use num_traits::Zero;

/// Both roots of the quadratic equation, or `None`.
pub fn roots_by_quadratic<P>(p: P, d: P, r: P::Scalar) -> Option<[P::Scalar; 2]>
where
    P: Vector3,
    P::Scalar: Real,
{
    let dd = d.dot(d);
    let dp = d.dot(p);
    let discriminant = dp * dp - dd * (p.dot(p) - r * r);
    if discriminant < P::Scalar::zero() {
        return None;
    }
    let root = discriminant.sqrt();
    Some([(-dp - root) / dd, (-dp + root) / dd])
}

/// The first of two roots that the ray reaches.
pub fn first_root<P: Vector3>(roots: [P::Scalar; 2], ray: &Ray<P>) -> Option<P::Scalar> {
    let [near, far] = roots;
    if ray.reaches(near) {
        Some(near)
    } else if ray.reaches(far) {
        Some(far)
    } else {
        None
    }
}
