//! What the chapter's example makes, kept: numbers as text, pictures with a tolerance.

#[path = "../../examples/subdivision/figures.rs"]
mod figures;
#[path = "../common/snapshots.rs"]
#[allow(dead_code, reason = "the chapter uses its part of this toolbox")]
mod kept;

use kept::{keep, words_of};

/// The words of all figures, and how large each is: a figure that comes out empty changes its line.
#[test]
fn figures_have_captions_alternatives_and_content() {
    keep("subdivision__figures", &words_of(figures::FIGURES));
}
