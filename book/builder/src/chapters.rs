//! The chapters whose examples make figures.

use crate::figures::ChapterFigures;

#[path = "../../../examples/bspline/figures.rs"]
mod bspline;
#[path = "../../../examples/camera/figures.rs"]
mod camera;
#[path = "../../../examples/coons/figures.rs"]
mod coons;
#[path = "../../../examples/intersection/figures.rs"]
mod intersection;
#[path = "../../../examples/subdivision/figures.rs"]
mod subdivision;
#[path = "../../../examples/tessellation/figures.rs"]
mod tessellation;

/// Every chapter with figures, in the order of the book.
pub const CHAPTERS: &[ChapterFigures] = &[
    ChapterFigures {
        chapter: "coons",
        figures: coons::FIGURES,
    },
    ChapterFigures {
        chapter: "bspline",
        figures: bspline::FIGURES,
    },
    ChapterFigures {
        chapter: "tessellation",
        figures: tessellation::FIGURES,
    },
    ChapterFigures {
        chapter: "subdivision",
        figures: subdivision::FIGURES,
    },
    ChapterFigures {
        chapter: "camera",
        figures: camera::FIGURES,
    },
    ChapterFigures {
        chapter: "intersection",
        figures: intersection::FIGURES,
    },
];
