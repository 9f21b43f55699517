//! The chapter with one typical mistake in it, chosen at run time: what `cargo exercise verify` runs the theorems on.

use std::env;
use std::sync::OnceLock;

// The mistakes call the book's library by its own name.
extern crate reference as facette;

pub use reference::*;

#[path = "@ROOT@/tests/camera/mistakes.rs"]
#[allow(dead_code, reason = "the tests use more of it than this package")]
pub mod mistakes;

/// The name of the mistake, from `FACETTE_MISTAKE`; empty for none.
fn chosen() -> &'static str {
    static NAME: OnceLock<String> = OnceLock::new();
    NAME.get_or_init(|| env::var("FACETTE_MISTAKE").unwrap_or_default())
}

/// Cameras, with the mistake where it belongs to a function and the book's own elsewhere.
pub mod camera {
    pub use reference::camera::*;

    use crate::algebra::{Real, Scalar, Vector3};
    use crate::ray::Ray;
    use crate::{chosen, mistakes};

    /// Exercise 1.
    pub fn look_at_axes<P>(eye: P, target: P, up: P) -> Option<[P; 3]>
    where
        P: Vector3,
        P::Scalar: Real,
    {
        mistakes::look_at_axes(chosen(), eye, target, up)
            .unwrap_or_else(|| reference::camera::look_at_axes(eye, target, up))
    }

    /// Exercise 2, first part.
    pub fn pixel_centre<S: Scalar>(
        rectangle: &ImageRectangle<S>,
        size: ImageSize,
        pixel: Pixel,
    ) -> [S; 2] {
        mistakes::pixel_centre(chosen(), rectangle, size, pixel)
            .unwrap_or_else(|| reference::camera::pixel_centre(rectangle, size, pixel))
    }

    /// Exercise 2, second part.
    pub fn flipped_row(size: ImageSize, row: u32) -> Option<u32> {
        mistakes::flipped_row(chosen(), size, row)
            .unwrap_or_else(|| reference::camera::flipped_row(size, row))
    }

    /// Exercise 3, first part.
    pub fn orthographic_ray<P: Vector3>(frame: &CameraFrame<P>, place: [P::Scalar; 2]) -> Ray<P> {
        mistakes::orthographic_ray(chosen(), frame, place)
            .unwrap_or_else(|| reference::camera::orthographic_ray(frame, place))
    }

    /// Exercise 3, second part.
    pub fn perspective_ray<P: Vector3>(
        frame: &CameraFrame<P>,
        distance: P::Scalar,
        place: [P::Scalar; 2],
    ) -> Ray<P> {
        mistakes::perspective_ray(chosen(), frame, distance, place)
            .unwrap_or_else(|| reference::camera::perspective_ray(frame, distance, place))
    }

    /// Exercise 4, first part.
    pub fn project_orthographic<P: Vector3>(frame: &CameraFrame<P>, point: P) -> [P::Scalar; 2] {
        mistakes::project_orthographic(chosen(), frame, point)
            .unwrap_or_else(|| reference::camera::project_orthographic(frame, point))
    }

    /// Exercise 4, second part.
    pub fn project_perspective<P: Vector3>(
        frame: &CameraFrame<P>,
        distance: P::Scalar,
        point: P,
    ) -> Option<[P::Scalar; 2]> {
        mistakes::project_perspective(chosen(), frame, distance, point)
            .unwrap_or_else(|| reference::camera::project_perspective(frame, distance, point))
    }

    /// Exercise 5.
    pub fn half_extent<S: Real>(field_of_view: S, distance: S) -> S {
        mistakes::half_extent(chosen(), field_of_view, distance)
            .unwrap_or_else(|| reference::camera::half_extent(field_of_view, distance))
    }
}
