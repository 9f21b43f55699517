//! What the chapter's example makes, kept: numbers as text, pictures with a tolerance.

use std::fmt::Write as _;
use std::path::Path;

use facette::algebra::unit_vector;
use facette::bspline::{KnotVector, basis_functions, find_span};
use facette::surface::Surface;
use facette_figure::Content;
use facette_figure::difference::{Difference, assert_picture_matches};
use facette_figure::palette::Colour;
use facette_figure::render::{Material, Scene, View};
use glam::DVec3;

#[path = "../../examples/bspline/figures.rs"]
mod figures;

use figures::shapes::{at, clamped, five_by_five, nine_by_nine, pieces, slide_15, surface};

/// Pictures are made of the same operations on every processor; a channel may still differ by this part of its range where a
/// triangle's edge passes through a sample.
const PICTURE_BOUND: f64 = 0.05;

fn keep(name: &str, text: &str) {
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path(concat!(env!("CARGO_MANIFEST_DIR"), "/snapshots"));
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.bind(|| insta::assert_snapshot!(format!("bspline__{name}"), text));
}

/// The basis functions that are not zero, at 21 places of the domain: span, then the values.
fn basis_table(knots: &KnotVector<f64>) -> String {
    let mut table = String::from("    u  span  values\n");
    let [start, end] = knots.domain();
    for step in 0..=20 {
        let u = start + (end - start) * f64::from(step) / 20.0;
        let span = find_span(knots, u);
        let mut values = vec![0.0; knots.degree() + 1];
        basis_functions(knots, span, u, &mut values);
        let _ = write!(table, "{u:.2}  {span:4} ");
        for value in values {
            let _ = write!(table, " {value:.6}");
        }
        table.push('\n');
    }
    table
}

#[test]
fn shape_functions_of_the_slides() {
    let [u, v] = slide_15();
    keep(
        "shape_functions",
        &format!(
            "U, p = 3\n{}\nV, q = 2\n{}",
            basis_table(&u),
            basis_table(&v)
        ),
    );
}

fn table(surface: &impl Surface<Scalar = f64, Point = DVec3>) -> String {
    let [[u0, u1], [v0, v1]] = surface.domain();
    let mut table =
        String::from("   u    v |         x         y         z |       n_x       n_y       n_z\n");
    for (i, j) in (0..=4).flat_map(|i| (0..=4).map(move |j| (i, j))) {
        let u = u0 + (u1 - u0) * f64::from(i) / 4.0;
        let v = v0 + (v1 - v0) * f64::from(j) / 4.0;
        let normal = surface.normal_vector(u, v).and_then(unit_vector);
        let normal = normal.unwrap_or(DVec3::NAN);
        // Rounding, then adding zero, turns -0 into 0, which would print a sign.
        let rounded = |x: f64| (x * 1e6).round() / 1e6 + 0.0;
        let [x, y, z] = surface.point(u, v).to_array().map(rounded);
        let [a, b, c] = normal.to_array().map(rounded);
        let _ = writeln!(
            table,
            "{u:.2} {v:.2} | {x:9.6} {y:9.6} {z:9.6} | {a:9.6} {b:9.6} {c:9.6}"
        );
    }
    table
}

#[test]
fn points_and_normals_of_the_two_pictured_surfaces() {
    keep("five_by_five", &table(&five_by_five()));
    keep("nine_by_nine", &table(&nine_by_nine()));
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
fn plots_of_the_shape_functions() {
    for name in ["basis_u", "basis_v"] {
        let maker = figures::FIGURES.iter().find(|maker| maker.name == name);
        let figure = (maker.expect("the chapter has this figure").make)();
        let Content::Svg(svg) = figure.content else {
            unreachable!("a plot is SVG")
        };
        keep(name, &svg);
    }
}

fn keep_picture(name: &str, scene: &Scene, width: u32, height: u32) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("snapshots/bspline__{name}.png"));
    assert_picture_matches(
        &path,
        &scene.render(width, height),
        &Difference::bound(PICTURE_BOUND),
    );
}

#[test]
fn picture_of_one_polynomial_for_each_rectangle() {
    const COLOURS: [Colour; 3] = [Colour::Sky, Colour::Orange, Colour::Vermilion];
    let view = View::perspective(at(9., -7., 8.), at(2., 2., 0.4), DVec3::Z, 20.0);
    let mut scene = Scene::new(view);
    for piece in pieces(&five_by_five(), 16) {
        let [column, row] = piece.span;
        let material = Material::matte(COLOURS[(column + row) % 3]);
        scene = scene.surface(&piece.mesh, material);
    }
    keep_picture("coloured_spans", &scene, 360, 260);
}

#[test]
fn picture_of_isophotes_across_a_double_knot() {
    const ACROSS: [f64; 7] = [0.0, 0.4, 0.9, 1.4, 0.7, 0.5, 0.4];
    let knots = [clamped(3, &[1.5, 3.0, 3.0], 5.0), clamped(2, &[], 1.0)];
    let shown = surface(knots, |i, j| {
        at(i as f64, 1.5 * j as f64, ACROSS[i] * [0.5, 1.2, 0.4][j])
    });
    let view = View::orthographic(at(4., -6., 8.), at(3., 1.5, 0.4), DVec3::Z, 5.2);
    let mut scene = Scene::new(view);
    for piece in pieces(&shown, 24) {
        let material = Material::isophotes(Colour::Sky, at(0.1, -0.8, 0.55), 30);
        scene = scene.surface(&piece.mesh, material);
    }
    keep_picture("double_knot", &scene, 320, 220);
}
