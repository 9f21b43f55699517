//! What the chapter's example makes, kept: numbers as text, pictures with a tolerance.

use std::fmt::Write as _;

use facette::bspline::{KnotVector, basis_functions, find_span};
use facette_figure::palette::Colour;
use facette_figure::render::{Material, Scene, View};
use glam::DVec3;

#[path = "../../examples/bspline/figures.rs"]
mod figures;
#[path = "../common/snapshots.rs"]
mod kept;

use figures::shapes::{at, clamped, five_by_five, nine_by_nine, pieces, slide_15, surface};
use kept::{drawing_of, keep, keep_picture, table_of, words_of};

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
        "bspline__shape_functions",
        &format!(
            "U, p = 3\n{}\nV, q = 2\n{}",
            basis_table(&u),
            basis_table(&v)
        ),
    );
}

#[test]
fn points_and_normals_of_the_two_pictured_surfaces() {
    keep("bspline__five_by_five", &table_of(&five_by_five()));
    keep("bspline__nine_by_nine", &table_of(&nine_by_nine()));
}

/// The words of all figures, and how large each is: a figure that comes out empty changes its line.
#[test]
fn figures_have_captions_alternatives_and_content() {
    keep("bspline__figures", &words_of(figures::FIGURES));
}

#[test]
fn plots_of_the_shape_functions() {
    for name in ["basis_u", "basis_v"] {
        let drawing = drawing_of(figures::FIGURES, name);
        keep(&format!("bspline__{name}"), &drawing);
    }
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
    keep_picture("bspline__coloured_spans", &scene, 360, 260);
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
    keep_picture("bspline__double_knot", &scene, 320, 220);
}
