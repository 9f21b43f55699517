//! Figures of exact evaluation: the patches next to an extraordinary vertex, modes that shrink, and lines of equal parameters.

use facette::mesh::Mesh;
use facette::subdivision::evaluate::CatmullClarkSurface;
use facette::subdivision::limit::turn_point;
use facette::subdivision::{Connectivity, Corners};
use facette_figure::Figure;
use facette_figure::palette::Colour;
use facette_figure::plot::Plot;
use facette_figure::svg::{Drawing, Panel, Stroke, panels};

type Place = [f64; 2];

/// A plane fan of n quadrilaterals, y up: vertex 0 in the middle, then n edge neighbours, then the points across the faces.
fn fan(n: u32) -> Mesh<Place> {
    let at = |part: u32, radius: f64| {
        let [x, y] = turn_point::<f64>(part as usize, 2 * n as usize);
        [radius * x, radius * y]
    };
    let edges = (0..n).map(|k| at(2 * k, 1.0));
    let faces = (0..n).map(|k| at(2 * k + 1, 1.25));
    let places = std::iter::once([0.0, 0.0]).chain(edges).chain(faces);
    let quads = (0..n).map(|k| [0, 1 + k, 1 + n + k, 1 + (k + 1) % n]);
    Mesh::new(places.collect(), quads).expect("the faces name their places")
}

fn surface_of(mesh: &Mesh<Place>) -> CatmullClarkSurface<Place> {
    let joined = Connectivity::new(mesh).expect("a fan is a manifold");
    CatmullClarkSurface::new(&joined, &mesh.positions, Corners::Sharp)
        .expect("finite points")
        .with_eigenbasis()
}

/// The point of a face in the drawing, y down.
type Map<'a> = &'a dyn Fn([f64; 2]) -> Place;

/// The image of a segment of parameters.
fn segment(map: Map<'_>, from: [f64; 2], to: [f64; 2]) -> Vec<Place> {
    const PIECES: u32 = 24;
    let at = |i: u32| {
        let part = f64::from(i) / f64::from(PIECES);
        map([0, 1].map(|axis| from[axis] + part * (to[axis] - from[axis])))
    };
    (0..=PIECES).map(at).collect()
}

/// The sides of the square from (s, t) with this width.
fn square(map: Map<'_>, [s, t]: [f64; 2], width: f64) -> Vec<Place> {
    let corners = [
        [s, t],
        [s + width, t],
        [s + width, t + width],
        [s, t + width],
    ];
    let side = |k: usize| segment(map, corners[k], corners[(k + 1) % 4]);
    (0..4).flat_map(side).collect()
}

/// The regular patches of a corner, three to a step.
fn nested(mut drawing: Drawing, map: Map<'_>, steps: i32) -> Drawing {
    const COLOURS: [Colour; 3] = [Colour::Blue, Colour::Orange, Colour::Green];
    for step in 1..=steps {
        let width = 0.5_f64.powi(step);
        for (place, colour) in [[1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]
            .into_iter()
            .zip(COLOURS)
        {
            let sides = square(map, place.map(|parameter| parameter * width), width);
            drawing = drawing
                .area(&sides, colour, 0.9 / f64::from(step + 2))
                .outline(&sides, Stroke::new(Colour::Ink, 1.2));
        }
    }
    drawing.disc(map([0.0, 0.0]), 4.5, Colour::Vermilion)
}

/// The infinite sequence of regular patches, in the parameters and on the surface.
pub fn nested_patches() -> Figure {
    const STEPS: i32 = 7;
    let in_parameters = |[s, t]: [f64; 2]| [20.0 + 280.0 * s, 300.0 - 280.0 * t];
    let parameters = nested(Drawing::new(320.0, 320.0), &in_parameters, STEPS);
    let surface = surface_of(&fan(5));
    let place = |half_edge: u32, [s, t]: [f64; 2]| {
        let point = surface.point(half_edge / 4, s, t);
        let [x, y] = point.expect("a quadrilateral of the fan");
        [165.0 + 116.0 * x, 160.0 - 116.0 * y]
    };
    let mut on_surface = Drawing::new(320.0, 320.0);
    for face in 1..5 {
        let map = |parameters| place(4 * face, parameters);
        let sides = square(&map, [0.0, 0.0], 1.0);
        on_surface = on_surface.outline(&sides, Stroke::new(Colour::Faint, 1.8));
    }
    let on_surface = nested(on_surface, &|parameters| place(0, parameters), STEPS);
    let row = [
        Panel::drawing("the parameters of one face", parameters),
        Panel::drawing("the limit of a plane fan, *n* = 5", on_surface),
    ];
    Figure::drawn(
        "nested_patches",
        "A face with one extraordinary corner, of valence 5. Each step cuts off three regular patches, which are B-splines, and leaves a quarter, which is not. Every parameter but the corner's own lies in one of the patches.",
        "Two drawings. On the left a square: its right, upper right and upper quarters are coloured, and the lower left quarter is cut in the same way again and again towards the corner. On the right the same patches on one of five faces around a point, shrinking towards that point a little more slowly.",
        &panels(2, &row),
    )
}

/// The lines of equal parameters around vertices of valence 3, 4 and 8.
pub fn isoparametric_lines() -> Figure {
    const LINES: i32 = 8;
    let panel = |n: u32| {
        let surface = surface_of(&fan(n));
        let mut drawing = Drawing::new(280.0, 280.0);
        for face in 0..n {
            let map = |[s, t]: [f64; 2]| {
                let point = surface.point(face, s, t);
                let [x, y] = point.expect("a quadrilateral of the fan");
                [140.0 + 104.0 * x, 140.0 - 104.0 * y]
            };
            for line in 0..=LINES {
                let parameter = f64::from(line) / f64::from(LINES);
                let colour = if line == 0 { Colour::Ink } else { Colour::Blue };
                let stroke = Stroke::new(colour, 1.3);
                drawing = drawing
                    .polyline(&segment(&map, [parameter, 0.0], [parameter, 1.0]), stroke)
                    .polyline(&segment(&map, [0.0, parameter], [1.0, parameter]), stroke);
            }
        }
        Panel::drawing(&format!("*n* = {n}"), drawing)
    };
    Figure::drawn(
        "isoparametric_lines",
        "Lines of equal parameters, eight steps to a face. At valence 3 they crowd at the vertex: the surface moves slowly there, and its derivatives go to zero. At valence 8 they keep away from it: it moves faster and faster. The surface is smooth in all three, here it is a plane.",
        "Three round drawings of curved grids around a point. With three faces the lines are dense near the middle; with four they are evenly spaced; with eight there is an open star in the middle.",
        &panels(3, &[3, 4, 8].map(panel)),
    )
}

/// The height over the diagonal of a face, where the control points are waves around a vertex of valence 5.
pub fn shrinking_modes() -> Figure {
    const N: u32 = 5;
    let mesh = fan(N);
    let joined = Connectivity::new(&mesh).expect("a fan is a manifold");
    // In parts of a turn: whole for edge neighbours, half for the points across the faces.
    let wave = |frequency: usize, part: u32| {
        turn_point::<f64>(frequency * part as usize, 2 * N as usize)[0]
    };
    let heights = |name: &str, plot: Plot, of: &dyn Fn(u32, bool) -> f64| {
        let edges = (0..N).map(|k| of(2 * k, false));
        let faces = (0..N).map(|k| of(2 * k + 1, true));
        let points: Vec<f64> = std::iter::once(of(0, false) * 0.0)
            .chain(edges)
            .chain(faces)
            .collect();
        let surface = CatmullClarkSurface::new(&joined, &points, Corners::Sharp);
        let surface = surface.expect("finite numbers").with_eigenbasis();
        let limit = surface.point(0, 0.0, 0.0).expect("a face");
        let sampled = (0..=60).map(|step| {
            let s = 0.5_f64.powf(1.0 + 0.3 * f64::from(step));
            let height = surface.point(0, s, s * 0.999).expect("a face") - limit;
            [s, height.abs()]
        });
        plot.line(name, &sampled.collect::<Vec<_>>())
    };
    let plot = Plot::new(
        "Waves towards a vertex",
        "parameter s = t",
        "height above the limit point",
    )
    .log_x()
    .log_y();
    let plot = heights("a tilted plane, frequency 1", plot, &|part, _| {
        wave(1, part)
    });
    let plot = heights("a saddle, frequency 2", plot, &|part, _| wave(2, part));
    let plot = heights("a cup, frequency 0", plot, &|_, is_face| {
        if is_face { 2.0 } else { 1.0 }
    });
    let alternative = "A plot with two logarithmic axes. Three lines fall towards small parameters with constant slopes: the plane's slowest, those of the saddle and the cup about twice as steep.";
    Figure::plotted("shrinking_modes", "Control points in a wave around a vertex of valence 5, and the height of the surface on the way to it. Each halving of the parameter multiplies the height by an eigenvalue: in this picture of two logarithmic axes, lines, with slopes $\\log_{1/2}\\lambda$. A surface is a sum of such waves, and Stam's way adds them up.", alternative, &plot).expect("the plot has points")
}
