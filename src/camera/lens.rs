//! The two projections: rays through places of the image plane, and points of the scene back to their places.

use num_traits::{One, Zero};

use super::image::{check_positive, number};
use super::{
    CameraError, CameraFrame, ImageRectangle, ImageSize, Pixel, pixel_centre, pixel_sample,
};
use crate::algebra::{Real, Scalar, Vector3};
use crate::ray::Ray;

/// The orthographic ray through the place (u, v): from `e + u u + v v` along −w.
///
/// # Accuracy
///
/// Each coordinate of the origin is within `3u (|e| + |u u| + |v v|)`, coordinates of the terms, for the frame as it is stored (tested as
/// `ray_error_stays_below_its_bound`). The direction is exact.
///
/// # Source
///
/// Slide 88; Marschner and Shirley 2016, section 4.3.1.
// ANCHOR: orthographic_ray
#[inline]
pub fn orthographic_ray<P: Vector3>(frame: &CameraFrame<P>, [u, v]: [P::Scalar; 2]) -> Ray<P> {
    let [right, up, back] = frame.axes();
    let row = frame.eye().plus(up.times(v));
    Ray::new(row.plus(right.times(u)), P::origin().minus(back))
}
// ANCHOR_END: orthographic_ray

/// The perspective ray through the place (u, v) of the image plane at `distance` in front of the eye: from e along `u u + v v − distance · w`.
///
/// The direction is not unit: t = 1 is on the image plane.
///
/// # Accuracy
///
/// Each coordinate of the direction is within `3u (|u u| + |v v| + |D w|)`, coordinates of the terms, for the frame as it is stored, wherever the eye may be (tested as
/// `ray_error_stays_below_its_bound`). The origin is exact.
///
/// # Source
///
/// Slide 90; Marschner and Shirley 2016, section 4.3.2.
// ANCHOR: perspective_ray
#[inline]
pub fn perspective_ray<P: Vector3>(
    frame: &CameraFrame<P>,
    distance: P::Scalar,
    [u, v]: [P::Scalar; 2],
) -> Ray<P> {
    let [right, up, back] = frame.axes();
    let row = up.times(v).minus(back.times(distance));
    Ray::new(frame.eye(), row.plus(right.times(u)))
}
// ANCHOR_END: perspective_ray

/// The place (u, v) of a point under the orthographic projection. Defined for every point, on both sides of the image plane.
///
/// # Accuracy
///
/// Within `4u · Σ |a_k| |p_k − e_k|` for the axis a = u or v as it is stored.
// ANCHOR: project_orthographic
#[inline]
pub fn project_orthographic<P: Vector3>(frame: &CameraFrame<P>, point: P) -> [P::Scalar; 2] {
    let [u, v, _] = frame.coordinates(point);
    [u, v]
}
// ANCHOR_END: project_orthographic

/// The place (u, v) of a point on the image plane at `distance` in front of the eye; `None` for a point that is not in front of the eye, or so near to the
/// plane of the eye that its place overflows.
///
/// # Accuracy
///
/// With the coordinates (x, y, z) of the point in the frame and δ the bound of [`CameraFrame::coordinates`], u is within
/// `D (δ + δ |x/z|) / (|z| − δ) + 3u |u|` (tested as `projection_error_stays_below_its_bound`).
///
/// # Source
///
/// Marschner and Shirley 2016, section 7.3.
// ANCHOR: project_perspective
#[inline]
pub fn project_perspective<P: Vector3>(
    frame: &CameraFrame<P>,
    distance: P::Scalar,
    point: P,
) -> Option<[P::Scalar; 2]> {
    let [x, y, z] = frame.coordinates(point);
    if z < P::Scalar::zero() {
        let place = [x, y].map(|coordinate| distance * (coordinate / -z));
        place.into_iter().all(Scalar::is_finite).then_some(place)
    } else {
        None
    }
}
// ANCHOR_END: project_perspective

/// How the rays of a camera run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Projection<S> {
    /// In parallel, along −w, from the image plane (*projection orthographique*).
    Orthographic,
    /// From the eye through the image plane (*projection perspective*).
    Perspective {
        /// How far the image plane lies in front of the eye.
        distance: S,
    },
}

/// A camera: a frame, a projection, and the rectangle of the image plane that is seen.
///
/// # Examples
///
/// ```
/// use facette::camera::{Camera, CameraFrame, ImageSize, Pixel};
///
/// let size = ImageSize::new(640, 480)?;
/// let frame = CameraFrame::looking_at([0., 0., 5.], [0., 0., 0.], [0., 1., 0.])?;
/// let camera = Camera::with_field_of_view(frame, 60_f64.to_radians(), size.aspect())?;
///
/// let first_in_file = Pixel::from_file(size, 0, 0).expect("the image has a pixel");
/// let ray = camera.pixel_ray(size, first_in_file);
/// assert_eq!(ray.origin, [0., 0., 5.]);
/// assert!(ray.direction[0] < 0. && ray.direction[1] > 0.);
/// assert_eq!(camera.position_in_file(size, [0., 0., 0.]), Some([320., 240.]));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera<P: Vector3> {
    frame: CameraFrame<P>,
    rectangle: ImageRectangle<P::Scalar>,
    projection: Projection<P::Scalar>,
}

impl<P: Vector3> Camera<P> {
    /// The camera with parallel rays.
    pub fn orthographic(frame: CameraFrame<P>, rectangle: ImageRectangle<P::Scalar>) -> Self {
        let projection = Projection::Orthographic;
        Self {
            frame,
            rectangle,
            projection,
        }
    }

    /// The camera whose rays leave the eye and pass through the rectangle at `distance` in front of it.
    ///
    /// # Errors
    ///
    /// [`CameraError::NumberOutOfRange`] for a distance that is not positive and finite.
    pub fn perspective(
        frame: CameraFrame<P>,
        rectangle: ImageRectangle<P::Scalar>,
        distance: P::Scalar,
    ) -> Result<Self, CameraError<P::Scalar>> {
        check_positive("the distance of the image plane", distance)?;
        let projection = Projection::Perspective { distance };
        Ok(Self {
            frame,
            rectangle,
            projection,
        })
    }

    /// The perspective camera that sees the vertical angle `field_of_view` (in radians, from the lower to the upper border), on an image that is `aspect` times
    /// as wide as high. Its image plane lies at distance 1.
    ///
    /// # Errors
    ///
    /// As [`ImageRectangle::from_field_of_view`].
    pub fn with_field_of_view(
        frame: CameraFrame<P>,
        field_of_view: P::Scalar,
        aspect: P::Scalar,
    ) -> Result<Self, CameraError<P::Scalar>>
    where
        P::Scalar: Real,
    {
        let distance = P::Scalar::one();
        let rectangle = ImageRectangle::from_field_of_view(field_of_view, aspect, distance)?;
        Self::perspective(frame, rectangle, distance)
    }

    /// The frame.
    #[inline]
    pub fn frame(&self) -> &CameraFrame<P> {
        &self.frame
    }

    /// The rectangle of the image plane that is seen.
    #[inline]
    pub fn rectangle(&self) -> &ImageRectangle<P::Scalar> {
        &self.rectangle
    }

    /// How the rays run.
    #[inline]
    pub fn projection(&self) -> Projection<P::Scalar> {
        self.projection
    }

    /// The ray through a place (u, v) of the image plane, inside the rectangle or not.
    // ANCHOR: ray
    #[inline]
    pub fn ray(&self, place: [P::Scalar; 2]) -> Ray<P> {
        match self.projection {
            Projection::Orthographic => orthographic_ray(&self.frame, place),
            Projection::Perspective { distance } => perspective_ray(&self.frame, distance, place),
        }
    }
    // ANCHOR_END: ray

    /// The ray through the centre of a pixel of an image of this size.
    #[inline]
    pub fn pixel_ray(&self, size: ImageSize, pixel: Pixel) -> Ray<P> {
        self.ray(pixel_centre(&self.rectangle, size, pixel))
    }

    /// The ray through a point inside a pixel, `[0, 0]` being its lower left corner and `[1, 1]` its upper right one.
    #[inline]
    pub fn pixel_sample_ray(
        &self,
        size: ImageSize,
        pixel: Pixel,
        within: [P::Scalar; 2],
    ) -> Ray<P> {
        self.ray(pixel_sample(&self.rectangle, size, pixel, within))
    }

    /// The place (u, v) at which a point appears, inside the rectangle or not; `None` for a point that no ray of the camera reaches, because it is not in front
    /// of the eye (perspective) or of the image plane (orthographic), for one with NaN or infinity, and where the place overflows.
    pub fn project(&self, point: P) -> Option<[P::Scalar; 2]> {
        match self.projection {
            Projection::Orthographic => {
                let [u, v, behind] = self.frame.coordinates(point);
                (behind < P::Scalar::zero())
                    .then_some([u, v])
                    .filter(|place| place.iter().all(|&number| Scalar::is_finite(number)))
            }
            Projection::Perspective { distance } => {
                project_perspective(&self.frame, distance, point)
            }
        }
    }

    /// Where a point appears in an image *file* of this size: pixels to the right of its left border and **below** its upper border, the centre of the first pixel being
    /// `[½, ½]`. Outside the image the numbers go on. `None` as [`Camera::project`], and where the position overflows.
    pub fn position_in_file(&self, size: ImageSize, point: P) -> Option<[P::Scalar; 2]> {
        let [u, v] = self.project(point)?;
        let Self { rectangle, .. } = self;
        let [columns, rows] = [size.columns(), size.rows()].map(number::<P::Scalar>);
        let position = [
            columns * ((u - rectangle.left()) / rectangle.width()),
            rows * ((rectangle.top() - v) / rectangle.height()),
        ];
        position
            .into_iter()
            .all(Scalar::is_finite)
            .then_some(position)
    }
}
