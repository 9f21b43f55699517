//! What the chapter's example makes, kept: numbers as text, pictures with a tolerance.

use std::fmt::Write as _;
use std::path::Path;

use facette::algebra::unit_vector;
use facette::coons::{BicubicPatch, CoonsPatch};
use facette::surface::Surface;
use facette_figure::Content;
use facette_figure::difference::{Difference, assert_picture_matches};
use facette_figure::palette::Colour;
use facette_figure::render::{Material, Scene, View};
use glam::DVec3;

#[path = "../../examples/coons/figures.rs"]
mod figures;

use figures::shapes::{at, gallery, mesh, sail, scene, slopes_of, smooth_neighbours};

/// Pictures are made of the same operations on every processor; a channel may still differ by this part of its range where a
/// triangle's edge passes through a sample.
const PICTURE_BOUND: f64 = 0.05;

fn keep(name: &str, text: &str) {
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path(concat!(env!("CARGO_MANIFEST_DIR"), "/snapshots"));
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.bind(|| insta::assert_snapshot!(format!("coons__{name}"), text));
}

fn table(surface: &impl Surface<Scalar = f64, Point = DVec3>) -> String {
    let mut table =
        String::from("   u    v |         x         y         z |       n_x       n_y       n_z\n");
    for (u, v) in
        (0..=4).flat_map(|i| (0..=4).map(move |j| (f64::from(i) / 4.0, f64::from(j) / 4.0)))
    {
        let point = surface.point(u, v);
        let normal = surface
            .normal_vector(u, v)
            .and_then(unit_vector)
            .unwrap_or(DVec3::NAN);
        // Adding zero turns -0 into 0, which would print a sign.
        let [x, y, z] = (point + 0.0).to_array();
        let [a, b, c] = normal.to_array().map(|n| (n * 1e6).round() / 1e6 + 0.0);
        let _ = writeln!(
            table,
            "{u:.2} {v:.2} | {x:9.6} {y:9.6} {z:9.6} | {a:9.6} {b:9.6} {c:9.6}"
        );
    }
    table
}

#[test]
fn points_and_normals_of_the_standard_patch() {
    keep("standard_patch", &table(&CoonsPatch::new(sail())));
}

#[test]
fn points_and_normals_of_a_bicubically_blended_patch() {
    let [below, _] = smooth_neighbours();
    keep(
        "bicubic_patch",
        &table(&BicubicPatch::new(slopes_of(&below))),
    );
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
        let [pictures, paths, words] =
            ["<image", "<path", "<text"].map(|tag| svg.matches(tag).count());
        // Measurements are made anew with every report, and so are the marks that show them.
        let size = match maker.name {
            "speed_against_error" => String::new(),
            _ => format!("{pictures} pictures, {paths} paths, {words} texts"),
        };
        let _ = writeln!(
            text,
            "{}: {size}\n  {}\n  {}\n",
            figure.name, figure.caption, figure.alternative
        );
    }
    keep("figures", &text);
}

#[test]
fn hermite_basis_plot() {
    let figure = figures::FIGURES
        .iter()
        .find(|maker| maker.name == "hermite_basis");
    let figure = (figure.expect("the chapter has this figure").make)();
    let Content::Svg(svg) = figure.content else {
        unreachable!("a plot is SVG")
    };
    keep("hermite_basis", &svg);
}

fn keep_picture(name: &str, scene: &Scene, width: u32, height: u32) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("snapshots/coons__{name}.png"));
    assert_picture_matches(
        &path,
        &scene.render(width, height),
        &Difference::bound(PICTURE_BOUND),
    );
}

#[test]
fn picture_of_the_standard_patch() {
    let edges = sail();
    let view = View::perspective(at(10., -9., 8.), at(2.1, 1.5, 0.5), DVec3::Z, 19.0);
    let patch = mesh(&CoonsPatch::new(edges.clone()));
    keep_picture(
        "standard_patch",
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
        "collapsed_side",
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
    keep_picture("smooth_neighbours", &scene, 320, 300);
}
