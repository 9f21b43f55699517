//! The chapters whose examples make figures.

use crate::figures::ChapterFigures;

#[path = "../../../examples/coons/figures.rs"]
mod coons;

/// Every chapter with figures, in the order of the book.
pub const CHAPTERS: &[ChapterFigures] = &[ChapterFigures {
    chapter: "coons",
    figures: coons::FIGURES,
}];
