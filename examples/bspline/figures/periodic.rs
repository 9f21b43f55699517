//! Figures of the surfaces that close: cylinder, torus and Möbius band, with the knots of the slides.

use std::f64::consts::TAU;

use facette::bspline::{Closing, KnotVector, PeriodicSurface, closed_surface};
use facette::mesh::tessellate_uniformly;
use facette::surface::Surface;
use facette_figure::Figure;
use facette_figure::palette::Colour;
use facette_figure::render::{Material, Scene, View};
use facette_figure::svg::{Anchor, Dashes, Drawing, Panel, Stroke, panels};
use glam::DVec3;

use super::shapes::{Photo, at, clamped, knot_vector};

type Closed = PeriodicSurface<DVec3>;

/// Columns of control points round the axis, 30° apart.
const COLUMNS: usize = 12;

/// The slides' knots of the direction that closes: −3, …, 15.
fn around() -> KnotVector<f64> {
    KnotVector::uniform(3, COLUMNS + 3).expect("more columns than the degree")
}

/// The slides' knots across a band: {0, 0, 0, 1, …, 6, 7, 7, 7}.
fn across() -> KnotVector<f64> {
    clamped(2, &[1., 2., 3., 4., 5., 6.], 7.0)
}

/// The closed surface whose column `i`, at its angle round the z axis, and row `j` lie at `[radius, height]`.
fn turned(
    knots: [KnotVector<f64>; 2],
    rows: usize,
    closing: [Closing; 2],
    place: impl Fn(f64, usize) -> [f64; 2],
) -> Closed {
    let columns = (0..COLUMNS).map(|i| TAU * i as f64 / COLUMNS as f64);
    let angles: Vec<f64> = columns.collect();
    let points = (0..rows).flat_map(|j| angles.iter().map(move |&angle| (angle, j)));
    let points = points.map(|(angle, j)| {
        let [radius, height] = place(angle, j);
        at(radius * angle.cos(), radius * angle.sin(), height)
    });
    let points: Vec<DVec3> = points.collect();
    closed_surface(knots, &points, closing).expect("the slides' knots close")
}

/// A tube with straight sides: its net lies outside.
fn cylinder() -> Closed {
    let closing = [Closing::Closed, Closing::Open];
    turned([around(), across()], 9, closing, |_, j| {
        [1.0, (j as f64 - 4.0) / 3.2]
    })
}

/// Seven rows round a ring.
fn torus() -> Closed {
    let v: Vec<f64> = (-2..=9_i8).map(f64::from).collect();
    let closing = [Closing::Closed; 2];
    turned([around(), knot_vector(2, &v)], 7, closing, |_, j| {
        let (sin, cos) = (TAU * j as f64 / 7.0).sin_cos();
        [1.35 + 0.72 * cos, 0.72 * sin]
    })
}

/// A strip that makes half a turn on its way round.
fn moebius_band() -> Closed {
    let closing = [Closing::Flipped, Closing::Open];
    turned([around(), across()], 9, closing, |angle, j| {
        // Upright where u starts and ends.
        let (sin, cos) = (angle / 2.0 + TAU / 4.0).sin_cos();
        let offset = (j as f64 - 4.0) / 4.8;
        [1.35 + offset * cos, offset * sin]
    })
}

/// The surface with its knot lines.
fn scene(surface: &Closed, view: View) -> Scene {
    let mesh = tessellate_uniformly(surface, 96, 42).expect("the figures' surfaces are finite");
    Scene::new(view).surface(&mesh, Material::matte(Colour::Sky).isolines(1))
}

/// The lines of the net round the axis and across, each closed as its surface is.
fn net(surface: &Closed) -> Vec<Vec<DVec3>> {
    let [n, m] = surface.distinct_counts();
    let [_, in_v] = surface.closing();
    let point = |i, j| surface.surface().control_point(i, j);
    let rows = (0..m).map(|j| (0..=n).map(|i| point(i, j)).collect());
    let last = if in_v == Closing::Open { m - 1 } else { m };
    let columns = (0..n).map(|i| (0..=last).map(|j| point(i, j)).collect());
    rows.chain(columns).collect()
}

/// Cylinder and torus under their control nets, and the Möbius band, through which its net would run, without.
pub fn closed_surfaces() -> Figure {
    let photo =
        |surface: &Closed, lines: Vec<Vec<DVec3>>, eye: DVec3, height: f64, size: [u32; 2]| {
            let view = View::orthographic(eye, DVec3::ZERO, DVec3::Z, height);
            let lines = lines.into_iter();
            let scene = lines.fold(scene(surface, view), |scene, line| {
                scene.tube(&line, 0.011, Colour::Vermilion)
            });
            Photo::new(&scene, size).drawing
        };
    let [tube, ring, band] = [cylinder(), torus(), moebius_band()];
    let small = [368, 300];
    let above = panels(
        2,
        &[
            Panel::drawing(
                "cylinder: *u* closes",
                photo(&tube, net(&tube), at(4., -7., 4.2), 3.5, small),
            ),
            Panel::drawing(
                "torus: *u* and *v* close",
                photo(&ring, net(&ring), at(3., -6., 6.), 4.2, small),
            ),
        ],
    );
    let below = photo(&band, Vec::new(), at(3., -6., 6.), 3.1, [750, 400]);
    let drawing = panels(
        1,
        &[
            Panel::drawing("", above),
            Panel::drawing("Möbius band: *u* closes flipped", below),
        ],
    );
    Figure::drawn(
        "closed_surfaces",
        "The slides' three closed surfaces, of degree 3 round the axis and 2 across, with their knot lines (dark) and, for the upper two, their control nets (orange): $12\\cdot9$ \
         distinct control points for the cylinder and the Möbius band, $12\\cdot7$ for the torus. None of the knot lines looks different where $u=12$ meets $u=0$.",
        "Three surfaces with dark lines on them: a tube and a ring under nets of thin orange lines, and below, larger, a band that makes \
         half a turn on its way round.",
        &drawing,
    )
}

/// The net of the torus with its repeated columns and rows, and how often each point stands in it.
pub fn repeated_points() -> Figure {
    const STEP: f64 = 46.0;
    let torus = torus();
    let [n, m] = torus.distinct_counts();
    let all = torus.surface().control_points();
    let [columns, rows] = [n + 3, m + 2];
    let place = |i: usize, j: usize| [60.0 + STEP * i as f64, 30.0 + STEP * (rows - 1 - j) as f64];
    let mut drawing = Drawing::new(750.0, STEP * rows as f64 + 50.0);
    let [_, low] = place(0, 0);
    let [right, _] = place(n, 0);
    let edge = right - STEP / 2.0;
    let stroke = Stroke::new(Colour::Faint, 1.6).dashes(Dashes::Dashed);
    drawing = drawing.line([edge, 8.0], [edge, low + 24.0], stroke);
    let [_, top] = place(0, m);
    let stroke = Stroke::new(Colour::Faint, 1.6).dashes(Dashes::Dashed);
    let edge = top + STEP / 2.0;
    drawing = drawing.line(
        [20.0, edge],
        [place(columns - 1, 0)[0] + 24.0, edge],
        stroke,
    );
    for (index, point) in all.iter().enumerate() {
        let [i, j] = [index % columns, index / columns];
        let times = all.iter().filter(|&other| other == point).count();
        let (colour, radius) = match times {
            4 => (Colour::Vermilion, 12.0),
            2 => (Colour::Blue, 9.0),
            _ => (Colour::Ink, 5.0),
        };
        drawing = drawing.disc(place(i, j), radius, colour);
        if j == 0 {
            let [x, y] = place(i, 0);
            let text = format!("{}", i % n);
            drawing = drawing.text([x, y + 40.0], &text, 17.0, Anchor::Middle);
        }
        if i == 0 {
            let [x, y] = place(0, j);
            let text = format!("{}", j % m);
            drawing = drawing.text([x - 32.0, y + 6.0], &text, 17.0, Anchor::Middle);
        }
    }
    Figure::drawn(
        "repeated_points",
        "The net of the slides' torus as it is stored, $15\\cdot9$ points, with the numbers of the distinct columns and rows. Beyond the dashed lines \
         the first three columns and the first two rows stand again. The six large orange points stand four times, the blue ones twice, the small \
         ones once; every knot is simple.",
        "A grid of 15 by 9 dots. The three columns at the left are repeated at the right, the two rows at the bottom at the top. In the four \
         corners lie groups of six large dots, along the edges between them medium ones, in the middle small ones.",
        &drawing,
    )
}

/// Normals carried once round a cylinder and a Möbius band.
pub fn carried_normals() -> Figure {
    const STEPS: u32 = 24;
    let shapes = [
        (
            "cylinder: it comes back as itself",
            cylinder(),
            at(4., -7., 4.2),
            3.9,
        ),
        (
            "Möbius band: it comes back turned over",
            moebius_band(),
            at(3., -6., 6.),
            3.6,
        ),
    ];
    let panel = |(label, surface, eye, height): (&str, Closed, DVec3, f64)| {
        let view = View::orthographic(eye, DVec3::ZERO, DVec3::Z, height);
        let mut scene = scene(&surface, view);
        let arrow = |u: f64, length: f64| {
            // The open surface behind knows the seam from both sides.
            let inner = surface.surface();
            let normal = inner
                .normal_vector(u, 3.5)
                .expect("the figures' surfaces are smooth");
            let foot = inner.point(u, 3.5);
            [foot, foot + length * normal.normalize()]
        };
        for step in 1..STEPS {
            let u = 12.0 * f64::from(step) / f64::from(STEPS);
            scene = scene.tube(&arrow(u, 0.45), 0.018, Colour::Ink);
        }
        for (u, colour, radius, length) in [
            (0.0, Colour::Green, 0.055, 0.55),
            (12.0, Colour::Vermilion, 0.035, 0.8),
        ] {
            let needle = arrow(u, length);
            scene = scene
                .tube(&needle, radius, colour)
                .point(needle[1], 1.8 * radius, colour);
        }
        Panel::drawing(label, Photo::new(&scene, [368, 300]).drawing)
    };
    Figure::drawn(
        "carried_normals",
        "A normal carried along the middle line from $u=0$ (green) to $u=12$ (orange), where the two are one point of the surface. Round the cylinder it \
         comes back as itself, and the longer orange one runs through the green one; round the Möbius band it comes back as its opposite, although it never jumps on its way. The band has \
         one side only.",
        "Two surfaces with short needles along their middle lines. On the tube a longer orange needle runs through a green one. On the twisted band the green and \
         the orange one start at the same point in opposite directions.",
        &panels(2, &shapes.map(panel)),
    )
}
