//! Your version of the chapter on cameras.
//!
//! Everything comes from the library of the book (here called `reference`), except the functions listed below: they
//! come from your files. The theorems of the chapter see no difference, so they grade yours.

mod field_of_view;
mod frame;
mod pixel;
mod projection;
mod rays;

pub use reference::*;

/// Cameras: the book's, with your functions in the place of its own.
pub mod camera {
    pub use reference::camera::*;

    pub use crate::field_of_view::half_extent;
    pub use crate::frame::look_at_axes;
    pub use crate::pixel::{flipped_row, pixel_centre};
    pub use crate::projection::{project_orthographic, project_perspective};
    pub use crate::rays::{orthographic_ray, perspective_ray};
}
