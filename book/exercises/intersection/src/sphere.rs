//! Exercise 1: where a line meets a sphere, and where a ray does.
//!
//! Replace each `todo!(...)` by your code, save, and run `cargo exercise intersection/sphere`.

use crate::algebra::{Real, Vector3};
use crate::ray::Ray;
use num_traits::Zero;

/// The two parameters at which the line `p + t d` meets the sphere of radius r around the origin, or `None` where it passes by:
///
/// ```text
///      -d.p ± root of the discriminant
/// t = ---------------------------------      discriminant = (d.p)(d.p) - (d.d)(p.p - r r)
///                   d.d
/// ```
///
/// The smaller one comes first. Where the line touches the sphere, both are the same. The direction may have any length.
///
/// What you can use:
///
/// ```text
/// a.dot(b)            the scalar product of two vectors
/// x.sqrt()            the square root of a number
/// P::Scalar::zero()   the number 0, to compare with
/// Some([s, t])        the result where there are two parameters;   None   where there are none
/// ```
pub fn roots_by_quadratic<P>(p: P, d: P, r: P::Scalar) -> Option<[P::Scalar; 2]>
where
    P: Vector3,
    P::Scalar: Real,
{
    todo!("roots_by_quadratic: both roots of the quadratic equation, or None")
}

/// The first of two roots, smaller one first, that the ray reaches; `None` where it reaches neither.
///
/// ```text
/// ray.reaches(t)      whether t is in the ray's interval: after its start, and not after its end
/// ```
pub fn first_root<P: Vector3>(roots: [P::Scalar; 2], ray: &Ray<P>) -> Option<P::Scalar> {
    todo!("first_root: the near one, or the far one, or None")
}
