//! A solution of exercise 4: where does a point appear?

use num_traits::Zero;

use crate::algebra::Vector3;
use crate::camera::CameraFrame;

/// The place `[u, v]` at which a point appears under the orthographic projection.
pub fn project_orthographic<P: Vector3>(frame: &CameraFrame<P>, point: P) -> [P::Scalar; 2] {
    let eye = frame.eye();
    let [right, up, _] = frame.axes();

    let from_eye = point.minus(eye);
    [from_eye.dot(right), from_eye.dot(up)]
}

/// The place `[u, v]` at which a point appears under the perspective projection; `None` for a point that is not in front of the eye.
pub fn project_perspective<P: Vector3>(
    frame: &CameraFrame<P>,
    distance: P::Scalar,
    point: P,
) -> Option<[P::Scalar; 2]> {
    let eye = frame.eye();
    let [right, up, back] = frame.axes();

    let from_eye = point.minus(eye);
    let depth = -from_eye.dot(back);
    if depth > P::Scalar::zero() {
        let u = distance * from_eye.dot(right) / depth;
        let v = distance * from_eye.dot(up) / depth;
        Some([u, v])
    } else {
        None
    }
}
