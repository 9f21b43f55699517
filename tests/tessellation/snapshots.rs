//! What the chapter's example makes, kept: numbers as text, pictures with a tolerance.

use std::fmt::Write as _;
use std::path::Path;

use facette::bspline::sphere;
use facette::tessellation::tessellate;
use facette_figure::Content;
use facette_figure::difference::{Difference, assert_picture_matches};
use facette_figure::palette::Colour;
use facette_figure::render::{Material, Scene, View};
use glam::DVec3;

#[path = "../../examples/tessellation/figures.rs"]
pub mod figures;

use crate::inputs::{moebius_band, torus, tube, wave};

/// As for the pictures of the other chapters: a channel may differ by this part of its range where a triangle's edge passes through
/// a sample.
const PICTURE_BOUND: f64 = 0.05;

fn keep(name: &str, text: &str) {
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path(concat!(env!("CARGO_MANIFEST_DIR"), "/snapshots"));
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.bind(|| insta::assert_snapshot!(format!("tessellation__{name}"), text));
}

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
    keep("numbers", &text);
}

/// The words of all figures, and how large each is: a figure that comes out empty changes its line.
#[test]
fn figures_have_captions_alternatives_and_content() {
    let mut text = String::new();
    for maker in figures::FIGURES {
        let figure = (maker.make)();
        assert_eq!(figure.name, maker.name);
        let Content::Svg(svg) = &figure.content else {
            unreachable!("the chapter's figures are SVG")
        };
        assert!(
            svg.contains("viewBox") && svg.contains("<desc>"),
            "{} is no figure",
            maker.name
        );
        let [pictures, polygons, words] =
            ["<image", "<polygon", "<text"].map(|tag| svg.matches(tag).count());
        let _ = writeln!(
            text,
            "{}: {pictures} pictures, {polygons} polygons, {words} texts\n  {}\n  {}\n",
            figure.name, figure.caption, figure.alternative
        );
    }
    keep("figures", &text);
}

#[test]
fn picture_of_the_bump() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("snapshots/tessellation__bump.png");
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
    assert_picture_matches(
        &path,
        &scene.render(320, 220),
        &Difference::bound(PICTURE_BOUND),
    );
}
