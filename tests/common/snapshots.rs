//! How snapshots are kept: numbers and words as text, pictures with a tolerance. Not part of [`super`], since the readers' package has
//! no figures.

use std::fmt::Write as _;
use std::path::Path;

use facette::algebra::unit_vector;
use facette::surface::Surface;
use facette_figure::difference::{Difference, assert_picture_matches};
use facette_figure::render::{Picture, Scene};
use facette_figure::{Content, FigureMaker};
use glam::DVec3;

/// Pictures are made of the same operations on every processor; a channel may still differ by this part of its range where a
/// triangle's edge passes through a sample.
const PICTURE_BOUND: f64 = 0.05;

/// Compares a text with the snapshot `name`, which begins with the chapter's name.
pub fn keep(name: &str, text: &str) {
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path(concat!(env!("CARGO_MANIFEST_DIR"), "/snapshots"));
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.bind(|| insta::assert_snapshot!(name, text));
}

/// Compares the picture of a scene with the snapshot `name`, which begins with the chapter's name.
pub fn keep_picture(name: &str, scene: &Scene, width: u32, height: u32) {
    keep_rendered(name, &scene.render(width, height));
}

/// Compares a picture with the snapshot `name`, which begins with the chapter's name.
pub fn keep_rendered(name: &str, picture: &Picture) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("snapshots/{name}.png"));
    assert_picture_matches(&path, picture, &Difference::bound(PICTURE_BOUND));
}

/// The words of all figures, and how large each is: a figure that comes out empty changes its line.
pub fn words_of(figures: &[FigureMaker]) -> String {
    let mut text = String::new();
    for maker in figures {
        let figure = (maker.make)();
        assert_eq!(figure.name, maker.name);
        let svg = svg_of(&figure.content);
        assert!(
            svg.contains("viewBox") && svg.contains("<desc>"),
            "{} is no figure",
            maker.name
        );
        let [pictures, paths, polygons, words] =
            ["<image", "<path", "<polygon", "<text"].map(|tag| svg.matches(tag).count());
        // Measurements are made anew with every report, and so are the marks that show them.
        let size = match maker.name {
            name if name.starts_with("speed_") => String::new(),
            _ => format!("{pictures} pictures, {paths} paths, {polygons} polygons, {words} texts"),
        };
        let _ = writeln!(
            text,
            "{}: {size}\n  {}\n  {}\n",
            figure.name, figure.caption, figure.alternative
        );
    }
    text
}

/// The drawing of the figure `name`.
#[allow(dead_code, reason = "a chapter without plots keeps none")]
pub fn drawing_of(figures: &[FigureMaker], name: &str) -> String {
    let maker = figures.iter().find(|maker| maker.name == name);
    let figure = (maker.expect("the chapter has this figure").make)();
    svg_of(&figure.content).to_owned()
}

fn svg_of(content: &Content) -> &str {
    match content {
        Content::Svg(svg) => svg,
        Content::Png(_) => unreachable!("the chapters' figures are SVG"),
    }
}

/// Points and unit normals of a surface at 25 pairs of parameters.
#[allow(dead_code, reason = "not every chapter has surfaces of its own")]
pub fn table_of(surface: &impl Surface<Scalar = f64, Point = DVec3>) -> String {
    let [[u0, u1], [v0, v1]] = surface.domain();
    let mut table =
        String::from("   u    v |         x         y         z |       n_x       n_y       n_z\n");
    for (i, j) in (0..=4).flat_map(|i| (0..=4).map(move |j| (i, j))) {
        let u = u0 + (u1 - u0) * f64::from(i) / 4.0;
        let v = v0 + (v1 - v0) * f64::from(j) / 4.0;
        let normal = surface.normal_vector(u, v).and_then(unit_vector);
        // Rounding, then adding zero, turns -0 into 0, which would print a sign.
        let rounded = |x: f64| (x * 1e6).round() / 1e6 + 0.0;
        let [x, y, z] = surface.point(u, v).to_array().map(rounded);
        let [a, b, c] = normal.unwrap_or(DVec3::NAN).to_array().map(rounded);
        let _ = writeln!(
            table,
            "{u:.2} {v:.2} | {x:9.6} {y:9.6} {z:9.6} | {a:9.6} {b:9.6} {c:9.6}"
        );
    }
    table
}
