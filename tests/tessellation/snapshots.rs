//! What the chapter's example makes, kept: numbers as text, pictures with a tolerance.

use std::fmt::Write as _;

use facette::bspline::sphere;
use facette::tessellation::tessellate;
use facette_figure::palette::Colour;
use facette_figure::render::{Material, Scene, View};
use glam::DVec3;

#[path = "../../examples/tessellation/figures.rs"]
pub mod figures;
#[path = "../common/snapshots.rs"]
mod kept;

use crate::inputs::{moebius_band, torus, tube, wave};
use kept::{keep, keep_picture, words_of};

/// How many vertices, places and triangles the chapter's surfaces have.
#[test]
fn numbers_of_vertices_and_triangles() {
    let mut text = String::from("surface  tolerance  vertices    places  triangles\n");
    let mut line =
        |name: &str, tolerance: f64, cut: facette::tessellation::Tessellation<[f64; 3]>| {
            let places = cut.welded().positions.len();
            let [vertices, triangles] = [cut.mesh.positions.len(), cut.mesh.face_count()];
            let _ = writeln!(
                text,
                "{name:8} {tolerance:9} {vertices:9} {places:9} {triangles:10}"
            );
        };
    for tolerance in [0.1, 0.01] {
        line(
            "wave",
            tolerance,
            tessellate(&wave(), tolerance).expect("usable"),
        );
        line(
            "tube",
            tolerance,
            tessellate(&tube(), tolerance).expect("usable"),
        );
        line(
            "torus",
            tolerance,
            tessellate(&torus(), tolerance).expect("usable"),
        );
        line(
            "moebius",
            tolerance,
            tessellate(&moebius_band(), tolerance).expect("usable"),
        );
        line(
            "sphere",
            tolerance,
            tessellate(&sphere(), tolerance).expect("usable"),
        );
    }
    keep("tessellation__numbers", &text);
}

/// The words of all figures, and how large each is: a figure that comes out empty changes its line.
#[test]
fn figures_have_captions_alternatives_and_content() {
    keep("tessellation__figures", &words_of(figures::FIGURES));
}

#[test]
fn picture_of_the_bump() {
    let mesh = tessellate(&figures::meshes::bump(), 0.1)
        .expect("usable")
        .mesh;
    let view = View::orthographic(
        DVec3::new(9., -11., 10.),
        DVec3::new(3., 3., 0.3),
        DVec3::Z,
        5.6,
    );
    let scene = Scene::new(view).surface(&mesh, Material::matte(Colour::Sky));
    keep_picture("tessellation__bump", &scene, 320, 220);
}
