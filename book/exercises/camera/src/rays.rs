//! Exercise 3: rays.
//!
//! Replace each `todo!(...)` by your code, save, and run `cargo exercise camera/rays`.

use crate::algebra::Vector3;
use crate::camera::CameraFrame;
use crate::ray::Ray;

/// The orthographic ray through the place (u, v) of the image plane. It begins on the plane through the eye that is spanned by the axes u and v,
/// and runs in the direction of view.
///
/// What you can use:
///
/// ```text
/// p.plus(q)                     the sum of two vectors;     p.minus(q)  their difference
/// a.times(x)                    the vector a, every coordinate multiplied by the number x
/// P::origin()                   the zero vector
/// Ray::new(origin, direction)   the ray from the point `origin` in the direction `direction`
/// ```
pub fn orthographic_ray<P: Vector3>(frame: &CameraFrame<P>, [u, v]: [P::Scalar; 2]) -> Ray<P> {
    // The eye, and the axes of the frame: to the right, up, and backwards. In the slides they are e, u, v, w in bold.
    let eye = frame.eye();
    let [right, up, back] = frame.axes();

    todo!("orthographic_ray: the ray through (u, v)")
}

/// The perspective ray through the place (u, v) of the image plane, which lies `distance` in front of the eye. It begins at the eye, and is on
/// the image plane at t = 1.
pub fn perspective_ray<P: Vector3>(
    frame: &CameraFrame<P>,
    distance: P::Scalar,
    [u, v]: [P::Scalar; 2],
) -> Ray<P> {
    let eye = frame.eye();
    let [right, up, back] = frame.axes();

    todo!("perspective_ray: the ray through (u, v)")
}
