//! The figure of a surface cut along a curve.

use facette::bspline::{KnotVector, RationalCurve, TrimmedSurface};
use facette::curve::Curve;
use facette::surface::Surface as _;
use facette_figure::Figure;
use facette_figure::palette::Colour;
use facette_figure::render::{Material, Picture, Scene, Triangles, View};
use facette_figure::svg::{Anchor, Dashes, Drawing, Panel, Stroke, panels};
use glam::DVec3;

use super::shapes::{Surface, at, clamped, knot_vector, surface};

/// How far the polygon may lie from the loop, in the unit of the parameters.
const TOLERANCE: f64 = 1e-3;

/// The control points of the loop: the sides of the square, and an arc around the corner (1, 1).
const LOOP: [[f64; 2]; 11] = [
    [0.0, 0.0],
    [0.5, 0.0],
    [1.0, 0.0],
    [1.0, 0.15],
    [1.0, 0.3],
    [1.0, 1.0],
    [0.3, 1.0],
    [0.15, 1.0],
    [0.0, 1.0],
    [0.0, 0.5],
    [0.0, 0.0],
];

/// The rounded corner of a case, over the unit square.
fn corner() -> Surface {
    const OUT: [f64; 6] = [0.0, 0.5, 1.0, 1.5, 1.95, 2.0];
    const DOWN: [f64; 6] = [0.0, 0.0, 0.02, 0.05, 0.25, 0.8];
    let knots = || clamped(3, &[0.3, 0.7], 1.0);
    surface([knots(), knots()], |i, j| {
        at(OUT[i], OUT[j], -DOWN[i] - DOWN[j])
    })
}

/// The loop: four straight pieces and a quarter of an ellipse.
fn outline() -> RationalCurve<[f64; 2]> {
    let knots = [0., 0., 0., 1., 1., 2., 2., 3., 3., 4., 4., 5., 5., 5.];
    let mut weights = [1.0; 11];
    weights[5] = 0.5_f64.sqrt();
    let knots: KnotVector<f64> = knot_vector(2, &knots);
    RationalCurve::new(knots, &LOOP, &weights).expect("eleven points fit the knots")
}

/// The plane of the parameters: knot lines, the loop with its control points, and its inside.
fn plane(trimmed: &TrimmedSurface<Surface>) -> Drawing {
    let place = |[u, v]: [f64; 2]| [44.0 + 270.0 * u, 286.0 - 270.0 * v];
    let places = |points: &[[f64; 2]]| points.iter().map(|&point| place(point)).collect::<Vec<_>>();
    let polygon = places(trimmed.polygon());
    let mut drawing = Drawing::new(368.0, 330.0).area(&polygon, Colour::Sky, 0.3);
    let [us, vs] = trimmed.surface().breaks();
    let lines = us.iter().map(|&u| [[u, 0.0], [u, 1.0]]);
    let lines = lines.chain(vs.iter().map(|&v| [[0.0, v], [1.0, v]]));
    for [from, to] in lines {
        drawing = drawing.line(place(from), place(to), Stroke::new(Colour::Faint, 1.2));
    }
    let control = Stroke::new(Colour::Ink, 1.2).dashes(Dashes::Dashed);
    drawing = drawing
        .polyline(&places(&LOOP), control)
        .outline(&polygon, Stroke::new(Colour::Vermilion, 3.0));
    for point in places(&LOOP) {
        drawing = drawing.disc(point, 4.0, Colour::Ink);
    }
    drawing
        .text([180.0, 318.0], "*u*", 17.0, Anchor::Middle)
        .text([22.0, 156.0], "*v*", 17.0, Anchor::Middle)
}

/// The part of the surface inside the loop, and the wires of what is cut away.
fn picture(trimmed: &TrimmedSurface<Surface>) -> Picture {
    let (whole, outline) = (trimmed.surface(), trimmed.outline());
    // The loop's inside is seen whole from its middle: rays from there make a grid that ends on the loop.
    let parameter = |turn: f64, out: f64| {
        let end = outline.point(5.0 * turn);
        end.map(|coordinate| 0.4 * (1.0 - out) + coordinate * out)
    };
    let point = |[u, v]: [f64; 2]| whole.point(u, v);
    let mut kept = Triangles::grid(300, 60, |turn, out| {
        let [u, v] = parameter(turn, out);
        (point([u, v]), whole.normal_vector(u, v).unwrap_or(DVec3::Z))
    });
    for parameters in &mut kept.parameters {
        *parameters = parameter(parameters[0], parameters[1]);
    }
    let view = View::orthographic(at(7., 4.6, 3.2), at(1.1, 1.0, -0.68), DVec3::Z, 2.9);
    let mut scene = Scene::new(view).surface(&kept, Material::matte(Colour::Sky).isolines(10));
    let steps = || (0..=60).map(|step| f64::from(step) / 60.0);
    for fixed in [0.5, 0.6, 0.7, 0.8, 0.9, 1.0] {
        for wire in [
            steps().map(|t| [fixed, t]).collect::<Vec<_>>(),
            steps().map(|t| [t, fixed]).collect(),
        ] {
            let cut = wire.into_iter().filter(|&[u, v]| !trimmed.contains(u, v));
            let points: Vec<_> = cut.map(point).collect();
            scene = scene.tube(&points, 0.006, Colour::Faint);
        }
    }
    let edge: Vec<_> = (0..=300)
        .map(|step| point(outline.point(f64::from(step) / 60.0)))
        .collect();
    scene.tube(&edge, 0.014, Colour::Vermilion).render(736, 660)
}

/// The rounded corner of a case, cut along a curve.
pub fn trimmed_corner() -> Figure {
    let trimmed = TrimmedSurface::new(corner(), outline(), TOLERANCE);
    let trimmed = trimmed.expect("the figure's loop is simple and runs anticlockwise");
    let drawing = panels(
        2,
        &[
            Panel::drawing("the loop in the plane of the parameters", plane(&trimmed)),
            Panel::picture("what it leaves of the surface", picture(&trimmed)),
        ],
    );
    Figure::drawn(
        "trimmed_corner",
        "A loop (orange) limits a surface. Left: the loop in the domain of the surface, with its control points: four straight pieces and a quarter of an \
         ellipse. Right: the part of the surface inside it; the grey wires are the corner that is cut away.",
        "Two pictures. A square of parameters with a shaded region whose upper right corner is rounded off by an arc; and a rounded corner \
         of a case in space that ends at an arc, beyond which only thin wires go on down to a tip.",
        &drawing,
    )
}
