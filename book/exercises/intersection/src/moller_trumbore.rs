//! Exercise 6: a triangle by Möller and Trumbore's test.
//!
//! Replace `todo!(...)` by your code, save, and run `cargo exercise intersection/moller_trumbore`.

use crate::algebra::Vector3;
use crate::intersection::{FacetHit, Side};
use crate::ray::Ray;
use num_traits::{One, Zero};

/// The hit of a ray and a triangle, edges and corners included; `None` where there is none, or the ray is parallel to the plane.
///
/// By Cramer's rule the equations `o + t d = a + v (b - a) + w (c - a)` have the solution
///
/// ```text
/// e1 = b - a,  e2 = c - a,  s = o - a,  p = d x e2,  q = s x e1
/// v = s.p / e1.p      w = d.q / e1.p      t = e2.q / e1.p
/// e1.p = -d.n                                the ray hits the front where it is positive
/// ```
///
/// The parameters are v and w. The number 1 is `P::Scalar::one()`.
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
pub fn moller_trumbore<P: Vector3>(corners: &[P; 3], ray: &Ray<P>) -> Option<FacetHit<P::Scalar>> {
    let [a, b, c] = *corners;

    todo!("moller_trumbore: the hit, or None")
}
