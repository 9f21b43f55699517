//! Exercise 4: where does a point appear?
//!
//! Replace each `todo!(...)` by your code, save, and run `cargo exercise camera/projection`.

use num_traits::Zero;

use crate::algebra::Vector3;
use crate::camera::CameraFrame;

/// The place `[u, v]` at which a point appears under the orthographic projection.
///
/// What you can use:
///
/// ```text
/// point.minus(eye)      the vector from the eye to the point
/// a.dot(b)              the scalar product of two vectors
/// ```
pub fn project_orthographic<P: Vector3>(frame: &CameraFrame<P>, point: P) -> [P::Scalar; 2] {
    let eye = frame.eye();
    let [right, up, _] = frame.axes();

    todo!("project_orthographic: the place [u, v]")
}

/// The place `[u, v]` at which a point appears under the perspective projection, on the image plane at `distance` in front of the eye; `None` for a
/// point that is not in front of the eye.
///
/// ```text
/// P::Scalar::zero()     the number 0
/// if a > b { Some([u, v]) } else { None }
/// ```
pub fn project_perspective<P: Vector3>(
    frame: &CameraFrame<P>,
    distance: P::Scalar,
    point: P,
) -> Option<[P::Scalar; 2]> {
    let eye = frame.eye();
    let [right, up, back] = frame.axes();

    todo!("project_perspective: perhaps a place [u, v]")
}
