//! The figure of the chapter's measurements.

use facette_figure::{Figure, speed};

/// The chapter's measurements.
pub fn speed_against_error() -> Figure {
    let committed = include_str!("../../../book/measurements/bspline.csv");
    speed::of_chapter("bspline", committed).expect("the committed measurements can be read")
}
