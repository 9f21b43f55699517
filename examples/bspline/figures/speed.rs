//! The figure of the chapter's measurements.

use facette_figure::{Figure, speed};

/// The chapter's measurements.
pub fn speed_against_error() -> Figure {
    speed::scatter(
        &measurements(),
        "speed_against_error",
        "Speed against error for each quantity of the chapter: the lower left corner wins. The reading is below.".to_owned(),
        "Scatter plots with the error across and the time up, one for each quantity; the same numbers stand in the table below."
            .to_owned(),
    )
    .expect("the committed measurements can be read")
}

/// The measurements made here, if any (below the current folder, the repository's root), otherwise the committed ones.
fn measurements() -> String {
    let committed = include_str!("../../../book/measurements/bspline.csv");
    std::fs::read_to_string("target/speed_against_error/bspline.csv")
        .unwrap_or_else(|_| committed.to_owned())
}
