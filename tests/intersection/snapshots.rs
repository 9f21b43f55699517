//! What the chapter's example makes, kept: words as text, pictures with a tolerance.

#[path = "../../examples/intersection/figures.rs"]
pub mod figures;
#[path = "../common/snapshots.rs"]
#[allow(dead_code, reason = "this chapter keeps no tables of surfaces")]
mod kept;

use figures::pictures::{first_pictures, portrait, shadings};
use kept::{keep, keep_picture, keep_rendered, words_of};

/// The words of all figures, and how large each is: a figure that comes out empty changes its line.
#[test]
fn figures_have_captions_alternatives_and_content() {
    keep("intersection__figures", &words_of(figures::FIGURES));
}

#[test]
fn pictures_of_the_first_two_programs() {
    let [white, coloured] = first_pictures(320);
    keep_rendered("intersection__white_on_a_hit", &white);
    keep_rendered("intersection__nearest_in_its_colour", &coloured);
}

#[test]
fn picture_of_a_model_with_its_own_normals() {
    let [_, _, kept] = shadings();
    keep_picture("intersection__pawn", &portrait(&kept), 240, 280);
}
