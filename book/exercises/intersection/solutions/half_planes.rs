//! A solution of exercise 5: a triangle as the slides have it, by three half-planes.

use crate::algebra::Vector3;
use crate::intersection::{FacetHit, Side};
use crate::ray::Ray;
use num_traits::Zero;

/// The hit by the plane and three closed half-planes.
pub fn half_planes<P: Vector3>(corners: &[P; 3], ray: &Ray<P>) -> Option<FacetHit<P::Scalar>> {
    let [a, b, c] = *corners;
    let n = b.minus(a).cross(c.minus(a));
    let along = ray.direction.dot(n);
    if along.is_zero() {
        return None;
    }
    let t = a.minus(ray.origin).dot(n) / along;
    let x = ray.point(t);
    let u = c.minus(b).cross(x.minus(b)).dot(n);
    let v = a.minus(c).cross(x.minus(c)).dot(n);
    let w = b.minus(a).cross(x.minus(a)).dot(n);
    let zero = P::Scalar::zero();
    if u < zero || v < zero || w < zero || !ray.reaches(t) {
        return None;
    }
    let square = n.dot(n);
    let side = if along < zero { Side::Front } else { Side::Back };
    Some(FacetHit { t, parameters: [v / square, w / square], side })
}
