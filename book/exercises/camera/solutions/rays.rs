//! A solution of exercise 3: rays.

use crate::algebra::Vector3;
use crate::camera::CameraFrame;
use crate::ray::Ray;

/// The orthographic ray through the place (u, v) of the image plane.
pub fn orthographic_ray<P: Vector3>(frame: &CameraFrame<P>, [u, v]: [P::Scalar; 2]) -> Ray<P> {
    let eye = frame.eye();
    let [right, up, back] = frame.axes();

    let place = eye.plus(right.times(u)).plus(up.times(v));
    Ray::new(place, P::origin().minus(back))
}

/// The perspective ray through the place (u, v) of the image plane, which lies `distance` in front of the eye.
pub fn perspective_ray<P: Vector3>(
    frame: &CameraFrame<P>,
    distance: P::Scalar,
    [u, v]: [P::Scalar; 2],
) -> Ray<P> {
    let eye = frame.eye();
    let [right, up, back] = frame.axes();

    // The difference s - e, in which the eye has gone.
    let direction = right.times(u).plus(up.times(v)).minus(back.times(distance));
    Ray::new(eye, direction)
}
