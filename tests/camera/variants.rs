//! Other ways to compute the same frame and the same rays. The report of speed against error compares them with the library, and the hard
//! cases refute those that do not survive.
//!
//! | variant | survives | why it is here |
//! | --- | --- | --- |
//! | [`textbook_axes`] | not an up near the view: the axes are no longer orthogonal | the textbook's frame |
//! | [`plain_unit_vector`] | neither huge nor tiny coordinates | the textbook's normalisation |
//! | [`ray_through_s`] | not an eye far from the origin | the slides' `d = s − e` |
//! | [`slides_place`] | not the last border: it may miss it by an ulp | the slides' `l + (r − l) (i + ½) / n` |
//! | [`SteppedRow`] | within its bound: the start plus i steps | two vectors for a row, one product and sum for a pixel |
//! | [`AddedRow`] | not long rows: the error grows with the column | no product for a pixel, only a sum |
#![allow(
    dead_code,
    reason = "tests and report each use their part of these variants"
)]

use facette::algebra::{Real, Scalar, Vector3};
use facette::camera::{Camera, CameraFrame, ImageRectangle, ImageSize, Pixel, pixel_centre};
use facette::ray::Ray;

/// `vector / √(vector · vector)`.
pub fn plain_unit_vector<P>(vector: P) -> P
where
    P: Vector3,
    P::Scalar: Real,
{
    vector.times(P::Scalar::from_i32(1) / vector.dot(vector).sqrt())
}

/// The textbook's frame: w, the unit vector along `up × w`, and `w × u`.
pub fn textbook_axes<P>(eye: P, target: P, up: P) -> [P; 3]
where
    P: Vector3,
    P::Scalar: Real,
{
    let w = plain_unit_vector(eye.minus(target));
    let u = plain_unit_vector(up.cross(w));
    [u, w.cross(u), w]
}

/// The slides' perspective ray: first the point s, then the direction `s − e`.
#[inline]
pub fn ray_through_s<P: Vector3>(
    frame: &CameraFrame<P>,
    distance: P::Scalar,
    [u, v]: [P::Scalar; 2],
) -> Ray<P> {
    let ([right, up, back], eye) = (frame.axes(), frame.eye());
    let s = eye.plus(right.times(u)).plus(up.times(v));
    let s = s.minus(back.times(distance));
    Ray::new(eye, s.minus(eye))
}

/// The slides' place in a pixel: `l + (r − l) (i + x) / n`.
#[inline]
pub fn slides_place<S: Scalar>(
    rectangle: &ImageRectangle<S>,
    size: ImageSize,
    pixel: Pixel,
    [x, y]: [S; 2],
) -> [S; 2] {
    let number = |n: u32| S::from_i32(i32::try_from(n).unwrap_or(i32::MAX));
    [
        rectangle.left() + rectangle.width() * (number(pixel.column) + x) / number(size.columns()),
        rectangle.bottom() + rectangle.height() * (number(pixel.row) + y) / number(size.rows()),
    ]
}

/// The rays of a row as `start + i · step`: the vectors of the first pixel and from one pixel to the next.
#[derive(Clone, Copy)]
pub struct SteppedRow<P: Vector3> {
    eye: P,
    start: P,
    step: P,
}

impl<P: Vector3> SteppedRow<P> {
    /// The row of a perspective camera with its image plane at `distance`.
    pub fn new(camera: &Camera<P>, distance: P::Scalar, size: ImageSize, row: u32) -> Self {
        let [right, up, back] = camera.frame().axes();
        let [u, v] = pixel_centre(camera.rectangle(), size, Pixel { column: 0, row });
        let columns = P::Scalar::from_i32(size.columns().cast_signed());
        Self {
            eye: camera.frame().eye(),
            start: up.times(v).minus(back.times(distance)).plus(right.times(u)),
            step: right.times(camera.rectangle().width() / columns),
        }
    }

    /// The ray of a pixel of the row.
    #[inline]
    pub fn ray(&self, column: u32) -> Ray<P> {
        let index = P::Scalar::from_i32(column.cast_signed());
        Ray::new(self.eye, self.start.plus(self.step.times(index)))
    }
}

/// The rays of a row one after the other, each direction being the one before plus a step.
pub struct AddedRow<P: Vector3> {
    eye: P,
    next: P,
    step: P,
}

impl<P: Vector3> AddedRow<P> {
    /// The row of a perspective camera with its image plane at `distance`.
    pub fn new(camera: &Camera<P>, distance: P::Scalar, size: ImageSize, row: u32) -> Self {
        let SteppedRow { eye, start, step } = SteppedRow::new(camera, distance, size, row);
        Self {
            eye,
            next: start,
            step,
        }
    }
}

impl<P: Vector3> Iterator for AddedRow<P> {
    type Item = Ray<P>;

    #[inline]
    fn next(&mut self) -> Option<Ray<P>> {
        let ray = Ray::new(self.eye, self.next);
        self.next = self.next.plus(self.step);
        Some(ray)
    }
}
