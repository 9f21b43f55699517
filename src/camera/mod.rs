//! Cameras: from a pixel of the image to a ray into the scene, and from a point of the scene back to its pixel.
//!
//! A ray tracer begins with the question which half-line is seen through a pixel. The answer takes two steps: the pixel has a place (u, v) on
//! the image plane, and that place has a ray.
//!
//! ```text
//! u = l + (r − l) (i + ½) / n_x          v = b + (t − b) (j + ½) / n_y         centre of the pixel in column i, row j
//!
//! orthographic    o = e + u u + v v      d = −w
//! perspective     o = e                  d = s − e = u u + v v − D w           through s = e + u u + v v − D w
//! ```
//!
//! # Conventions
//!
//! The frame (u, v, w) of a camera is orthonormal and right-handed: u to the right, v up, w *backwards*, from the target to the eye e. The
//! image rectangle is `[l, r] × [b, t]` in the coordinates (u, v), in units of the scene. Columns count from the left, rows from the **bottom**, as in
//! the course; image files store their rows from the **top**, which [`flipped_row`] and [`Pixel::from_file`] translate. Angles are in radians.
//!
//! The letter d means two things in the course: the distance D of the image plane, and the ray's direction. The direction of a perspective ray is not
//! unit; t = 1 is on the image plane.
//!
//! # Numerics
//!
//! The direction is never computed as the difference `s − e`: far from the origin the eye's coordinates eat the digits of the direction. The frame
//! is made orthonormal once more after the cross product, since that loses digits where up and the view are nearly parallel; where the data
//! cannot tell which way is up, the frame is refused. Place on the image is interpolated so that the border of the last pixel is the
//! border of the rectangle, to the bit.
//!
//! # Sources
//!
//! S. Marschner and P. Shirley, *Fundamentals of Computer Graphics*, 4th edition, 2016, sections 4.3 and 7.1; L. Giraud, J. Langou and
//! M. Rozložník, *The loss of orthogonality in the Gram-Schmidt orthogonalization process*, 2005.
//!
//! *In the course*: slides 86 to 91 (*repère lié à la caméra*, *plan de vue*, *projection orthographique*, *projection perspective*).
//!
//! *In the book*: [Cameras](../../../camera.html).

mod error;
mod frame;
mod image;
mod lens;

pub use error::{CameraError, ImageSizeError};
pub use frame::{CameraFrame, look_at_axes};
pub use image::{
    ImageRectangle, ImageSize, Pixel, flipped_row, half_extent, pixel_centre, pixel_sample,
};
pub use lens::{
    Camera, Projection, orthographic_ray, perspective_ray, project_orthographic,
    project_perspective,
};
