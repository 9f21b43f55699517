//! Exercise 5: a triangle as the slides have it, by three half-planes.
//!
//! Replace `todo!(...)` by your code, save, and run `cargo exercise intersection/half_planes`.

use crate::algebra::Vector3;
use crate::intersection::{FacetHit, Side};
use crate::ray::Ray;
use num_traits::Zero;

/// The hit of a ray and a triangle, edges and corners included; `None` where there is none, or the ray is parallel to the plane.
///
/// ```text
/// n = (b - a) x (c - a)
/// t = (a - o).n / d.n                        where the line crosses the plane; x = o + t d is the point
/// ((c - b) x (x - b)).n = u n.n              one half-plane for each edge: u, v, w are the weights of a, b, c
/// ((a - c) x (x - c)).n = v n.n
/// ((b - a) x (x - a)).n = w n.n
/// d.n < 0                                    the ray hits the front
/// ```
///
/// The parameters are the weights of b and of c.
///
/// What you can use:
///
/// ```text
/// p.minus(q)                the difference of two points;      p.dot(q), p.cross(q)    the two products
/// ray.origin, ray.direction
/// ray.point(t)              the point o + t d
/// ray.reaches(t)            whether t belongs to the ray
/// x.is_zero()               whether the number x is 0;         P::Scalar::zero()       the number 0
/// Side::Front, Side::Back
/// Some(FacetHit { t, parameters: [v, w], side })
/// ```
pub fn half_planes<P: Vector3>(corners: &[P; 3], ray: &Ray<P>) -> Option<FacetHit<P::Scalar>> {
    let [a, b, c] = *corners;

    todo!("half_planes: the hit, or None")
}
