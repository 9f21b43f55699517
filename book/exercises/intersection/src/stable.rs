//! Exercise 2: the same roots without the loss of digits.
//!
//! Replace `todo!(...)` by your code, save, and run `cargo exercise intersection/stable`.

use crate::algebra::{Real, Vector3};
use num_traits::Zero;

/// The two parameters at which the line `p + t d` meets the sphere of radius r around the origin, smaller first, or `None`
/// where it passes by. This time they are to be right for a sphere that is far away, or huge, or only grazed.
///
/// ```text
/// a  = p - (p.d / d.d) d              from the centre to the nearest point of the line
/// h  = |a|                            the distance of the line from the centre
/// D  = (d.d) (r - h) (r + h)          the discriminant, without squares of large numbers
/// b  = p.d
/// q  = -(b + root of D)   if b > 0,   and   root of D - b   otherwise:  nothing cancels
/// t  = q / d.d   and   c / q          with  c = (|p| - r)(|p| + r);     both are 0 where q is 0
/// ```
///
/// What you can use, besides what exercise 1 lists:
///
/// ```text
/// p.minus(q)          the difference of two vectors
/// d.times(x)          the vector d, every coordinate multiplied by the number x
/// ```
///
/// The length of a vector is the square root of its scalar product with itself.
pub fn roots_by_projection<P>(p: P, d: P, r: P::Scalar) -> Option<[P::Scalar; 2]>
where
    P: Vector3,
    P::Scalar: Real,
{
    todo!("roots_by_projection: both roots, smaller first, or None")
}
