//! Your version of the chapter on intersections.
//!
//! Everything comes from the library of the book (here called `reference`), except the functions listed below: they
//! come from your files. The theorems of the chapter see no difference, so they grade yours.

mod group;
mod half_planes;
mod moller_trumbore;
mod slabs;
mod sphere;
mod stable;

pub use reference::*;

/// Intersections: the book's, with your functions in the place of its own.
pub mod intersection {
    pub use reference::intersection::*;

    pub use crate::group::nearest;
    pub use crate::slabs::box_interval;
    pub use crate::sphere::{first_root, roots_by_quadratic};
    pub use crate::stable::roots_by_projection;

    /// Triangles: likewise.
    pub mod triangle {
        pub use reference::intersection::triangle::*;

        pub use crate::half_planes::half_planes;
        pub use crate::moller_trumbore::moller_trumbore;
    }
}
