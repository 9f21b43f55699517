//! What the chapter's example makes, kept: numbers as text, pictures with a tolerance.

#[path = "../../examples/subdivision/figures.rs"]
mod figures;
#[path = "../common/snapshots.rs"]
#[allow(dead_code, reason = "the chapter uses its part of this toolbox")]
mod kept;

use facette::subdivision::Corners;
use facette_figure::palette::Colour;
use figures::scheme::Scheme;
use figures::{cages, pictures};
use kept::{keep, keep_picture, words_of};

/// The words of all figures, and how large each is: a figure that comes out empty changes its line.
#[test]
fn figures_have_captions_alternatives_and_content() {
    keep("subdivision__figures", &words_of(figures::FIGURES));
}

/// The size of the pictures that are kept.
const SIZE: [u32; 2] = [184, 148];

#[test]
fn pictures_of_the_piggy_bank_after_a_step_of_each_scheme() {
    let cage = cages::piggy_bank();
    let view = cages::view_of(&cage, SIZE);
    for (scheme, name) in Scheme::ALL.into_iter().zip(NAMES) {
        let mesh = cages::refined(scheme, &cage, 1, Corners::Sharp);
        let scene = pictures::faceted(view, &mesh, 1);
        keep_picture(
            &format!("subdivision__step_of_{name}"),
            &scene,
            SIZE[0],
            SIZE[1],
        );
    }
}

#[test]
fn pictures_of_the_piggy_bank_in_the_limit_of_each_scheme() {
    let view = cages::view_of(&cages::piggy_bank(), SIZE);
    for (scheme, name) in Scheme::ALL.into_iter().zip(NAMES) {
        let scene = pictures::smooth(view, scheme);
        keep_picture(
            &format!("subdivision__limit_of_{name}"),
            &scene,
            SIZE[0],
            SIZE[1],
        );
    }
}

#[test]
fn picture_of_smooth_corners_in_the_limit_of_doo_sabin() {
    let cage = cages::handkerchief();
    let surface = cages::limit(Scheme::DooSabin, &cage, Corners::Smooth);
    let scene = cages::scene_of(cages::view_of(&cage, SIZE), &surface, Colour::Sky);
    keep_picture("subdivision__smooth_corners", &scene, SIZE[0], SIZE[1]);
}

/// The names of the schemes in the order of [`Scheme::ALL`].
const NAMES: [&str; 4] = ["catmull_clark", "doo_sabin", "loop", "sqrt3"];
