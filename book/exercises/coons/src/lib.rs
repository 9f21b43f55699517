//! Your version of the chapter on Coons patches.
//!
//! Everything comes from the library of the book (here called `reference`), except the functions listed below: they
//! come from your files. The theorems of the chapter see no difference, so they grade yours.

mod bicubic;
mod bilinear;
mod derivative;

pub use reference::*;

/// Coons patches: the book's, with your functions in the place of its own.
pub mod coons {
    pub use reference::coons::*;

    pub use crate::bicubic::{bicubic_point, hermite_basis};
    pub use crate::bilinear::bilinear_point;
    pub use crate::derivative::bilinear_partials;
}
