//! Your version of the chapter on B-splines.
//!
//! Everything comes from the library of the book (here called `reference`), except the functions listed below: they
//! come from your files. The theorems of the chapter see no difference, so they grade yours.

mod basis;
mod de_boor;
mod insertion;
mod surface_point;

pub use reference::*;

/// B-splines: the book's, with your functions in the place of its own.
pub mod bspline {
    pub use reference::bspline::*;

    pub use crate::basis::{basis_functions, cox_de_boor, find_span};
    pub use crate::de_boor::de_boor_point;
    pub use crate::insertion::insert_knot;
    pub use crate::surface_point::surface_point;
}
