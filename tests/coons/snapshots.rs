//! What the chapter's example makes, kept: numbers as text, pictures with a tolerance.

use facette::coons::{BicubicPatch, CoonsPatch};
use facette_figure::palette::Colour;
use facette_figure::render::{Material, Scene, View};
use glam::DVec3;

#[path = "../../examples/coons/figures.rs"]
mod figures;
#[path = "../common/snapshots.rs"]
mod kept;

use figures::shapes::{at, gallery, mesh, sail, scene, slopes_of, smooth_neighbours};
use kept::{drawing_of, keep, keep_picture, table_of, words_of};

#[test]
fn points_and_normals_of_the_standard_patch() {
    keep("coons__standard_patch", &table_of(&CoonsPatch::new(sail())));
}

#[test]
fn points_and_normals_of_a_bicubically_blended_patch() {
    let [below, _] = smooth_neighbours();
    keep(
        "coons__bicubic_patch",
        &table_of(&BicubicPatch::new(slopes_of(&below))),
    );
}

/// The words of all figures, and how large each is: a figure that comes out empty changes its line.
#[test]
fn figures_have_captions_alternatives_and_content() {
    keep("coons__figures", &words_of(figures::FIGURES));
}

#[test]
fn hermite_basis_plot() {
    let drawing = drawing_of(figures::FIGURES, "hermite_basis");
    keep("coons__hermite_basis", &drawing);
}

#[test]
fn picture_of_the_standard_patch() {
    let edges = sail();
    let view = View::perspective(at(10., -9., 8.), at(2.1, 1.5, 0.5), DVec3::Z, 19.0);
    let patch = mesh(&CoonsPatch::new(edges.clone()));
    keep_picture(
        "coons__standard_patch",
        &scene(&patch, &edges, view, 0.04),
        480,
        320,
    );
}

#[test]
fn picture_of_a_fan_with_a_collapsed_side() {
    let [.., (_, fan), _] = gallery();
    let patch = CoonsPatch::new(fan);
    let view = View::orthographic(at(4., -6., 4.5), at(0., 0., 0.), DVec3::Z, 2.6);
    keep_picture(
        "coons__collapsed_side",
        &scene(&mesh(&patch), patch.boundary(), view, 0.03),
        320,
        220,
    );
}

#[test]
fn picture_of_isophotes_across_smooth_neighbours() {
    let view = View::orthographic(at(6., -9., 9.), at(1.5, 0., 0.5), DVec3::Z, 6.2);
    let mut scene = Scene::new(view);
    for net in smooth_neighbours() {
        let material = Material::isophotes(Colour::Sky, at(0.3, -0.5, 0.8), 40);
        scene = scene.surface(&mesh(&BicubicPatch::new(slopes_of(&net))), material);
    }
    keep_picture("coons__smooth_neighbours", &scene, 320, 300);
}
