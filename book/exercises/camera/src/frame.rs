//! Exercise 1: the frame of a camera.
//!
//! Replace `todo!(...)` by your code, save, and run `cargo exercise camera/frame`.

use crate::algebra::{Real, Vector3, unit_vector};

/// The axes `[u, v, w]` of a camera at the point `eye` that looks at the point `target`: u to the right, v up, w
/// backwards. All three are unit vectors, and perpendicular to each other. The direction `up` need not be perpendicular
/// to the view, but it is to appear upright: perpendicular to u, and on the side of v.
///
/// What you can use:
///
/// ```text
/// p.minus(q)          the vector from the point q to the point p
/// a.cross(b)          the vector product a x b, perpendicular to both; with x to the right and y up, x.cross(y) points at you
/// unit_vector(a)      perhaps the vector of length 1 along a: Some(vector), or None for the zero vector
/// unit_vector(a)?     that vector; where there is none, the function ends here and gives None itself
/// Some([u, v, w])     the result where all went well
/// ```
///
/// The last expression of the function, without a semicolon, is its result.
pub fn look_at_axes<P>(eye: P, target: P, up: P) -> Option<[P; 3]>
where
    P: Vector3,
    P::Scalar: Real,
{
    todo!("look_at_axes: the axes u, v, w")
}
