//! Figures of the shape functions, of one parameter and of two.

use facette::bspline::{KnotVector, basis_functions, cox_de_boor};
use facette::surface::Surface as _;
use facette_figure::Figure;
use facette_figure::palette::Colour;
use facette_figure::render::{Material, Scene, View};
use facette_figure::svg::{Anchor, Dashes, Drawing, PAGE_WIDTH, Panel, Stroke, panels};
use glam::DVec3;

use super::shapes::{Surface, at, knot_text, pieces, slide_15, surface};

/// Where a plot of shape functions lies in its drawing.
struct Frame {
    domain: [f64; 2],
}

const LEFT: f64 = 44.0;
const RIGHT: f64 = PAGE_WIDTH - 26.0;
const TOP: f64 = 30.0;
const BOTTOM: f64 = 250.0;
const HEIGHT: f64 = 318.0;
const TEXT: f64 = 16.0;
/// Parameters in each span.
const STEPS: u32 = 40;

impl Frame {
    fn place(&self, [u, value]: [f64; 2]) -> [f64; 2] {
        let [start, end] = self.domain;
        let across = (u - start) / (end - start);
        [
            LEFT + across * (RIGHT - LEFT),
            BOTTOM + value * (TOP - BOTTOM),
        ]
    }
}

/// The graph of each shape function: the parameters and values, span by span, so that a corner at a knot stays sharp.
fn graphs(knots: &KnotVector<f64>) -> Vec<Vec<[f64; 2]>> {
    let degree = knots.degree();
    let mut graphs = vec![Vec::new(); knots.control_point_count()];
    let mut values = vec![0.0; degree + 1];
    for span in knots.spans() {
        let [start, end] = knots.span_interval(span);
        for step in 0..=STEPS {
            let u = start + (end - start) * f64::from(step) / f64::from(STEPS);
            basis_functions(knots, span, u, &mut values);
            for (graph, &value) in graphs[span - degree..=span].iter_mut().zip(&values) {
                graph.push([u, value]);
            }
        }
    }
    graphs
}

/// Colours and dashes by number: neighbours differ in colour, those three apart in dashes.
fn look(index: usize) -> Stroke {
    const COLOURS: [Colour; 3] = [Colour::Blue, Colour::Vermilion, Colour::Green];
    const BROKEN: [Dashes; 3] = [Dashes::Solid, Dashes::Dashed, Dashes::DashDotted];
    Stroke::new(COLOURS[index % 3], 2.4).dashes(BROKEN[index / 3 % 3])
}

/// The axes: a vertical line and a stack of dots at each knot, as many as the knot is repeated.
fn axes(frame: &Frame, knots: &KnotVector<f64>, letter: &str) -> Drawing {
    let guide = Stroke::new(Colour::Faint, 1.0);
    let mut drawing = Drawing::new(PAGE_WIDTH, HEIGHT);
    for (knot, multiplicity) in knots.multiplicities() {
        let [x, bottom] = frame.place([knot, 0.0]);
        let [_, top] = frame.place([knot, 1.0]);
        drawing = drawing.line([x, bottom], [x, top], guide);
        for dot in 0..multiplicity {
            let y = bottom + 12.0 + 9.0 * dot as f64;
            drawing = drawing.disc([x, y], 3.6, Colour::Ink);
        }
        drawing = drawing.text([x, HEIGHT - 6.0], &knot_text(knot), TEXT, Anchor::Middle);
    }
    for value in [0.0, 0.5, 1.0] {
        let [x, y] = frame.place([frame.domain[0], value]);
        drawing = drawing.text([x - 10.0, y + 5.0], &knot_text(value), TEXT, Anchor::End);
    }
    let ends = frame.domain.map(|u| frame.place([u, 0.0]));
    drawing
        .line(ends[0], ends[1], Stroke::new(Colour::Ink, 1.2))
        .text([20.0, BOTTOM + 26.0], letter, TEXT, Anchor::Middle)
}

/// Where the name of a shape function stands: above its top, or inside the plot where the top is at an end.
fn name_place(frame: &Frame, graph: &[[f64; 2]]) -> [f64; 2] {
    let [start, end] = frame.domain;
    let highest = |best: [f64; 2], point: &[f64; 2]| if point[1] > best[1] { *point } else { best };
    let top = graph.iter().fold([start, -1.0], highest);
    let [x, y] = frame.place(top);
    if top[1] < 0.99 {
        [x, y - 9.0]
    } else if top[0] <= start {
        [x + 34.0, y + 24.0]
    } else if top[0] >= end {
        [x - 32.0, y + 24.0]
    } else {
        [x + 26.0, y + 24.0]
    }
}

/// The shape functions of a knot vector, and their sum.
fn shape_functions(knots: &KnotVector<f64>, degree: &str, letter: &str) -> Drawing {
    let domain = knots.domain();
    let frame = Frame { domain };
    let mut drawing = axes(&frame, knots, letter);
    let sum = domain.map(|u| frame.place([u, 1.0]));
    drawing = drawing
        .line(
            sum[0],
            sum[1],
            Stroke::new(Colour::Ink, 1.6).dashes(Dashes::Dotted),
        )
        .text(
            [f64::midpoint(LEFT, RIGHT), TOP - 9.0],
            "the sum of all",
            TEXT,
            Anchor::Middle,
        );
    let graphs = graphs(knots);
    for (index, graph) in graphs.iter().enumerate() {
        let points: Vec<_> = graph.iter().map(|&point| frame.place(point)).collect();
        drawing = drawing.polyline(&points, look(index));
    }
    for (index, graph) in graphs.iter().enumerate() {
        let name = format!("*N*_{index}^{degree}");
        let place = name_place(&frame, graph);
        drawing = drawing.coloured_text(place, &name, TEXT, Anchor::Middle, look(index).colour);
    }
    drawing
}

/// The seven cubic shape functions of the slides' U.
pub fn basis_u() -> Figure {
    let [u, _] = slide_15();
    Figure::drawn(
        "basis_u",
        "The seven shape functions of degree 3 of $U=\\{0,0,0,0,\\frac14,\\frac12,\\frac34,1,1,1,1\\}$. Each lives on at most four spans, and \
         at most four overlap anywhere. A dot below the axis is a knot; four at each end let $N_0$ and $N_6$ reach 1 there.",
        "Seven bell-shaped curves over the interval from 0 to 1, the first and the last with their top 1 at the ends. Dots below \
         the axis mark the knots: four at 0, one each at 1/4, 1/2 and 3/4, four at 1. A dotted line at height 1 is their sum.",
        &shape_functions(&u, "3", "*U*"),
    )
}

/// The eight quadratic shape functions of the slides' V, with its double knot.
pub fn basis_v() -> Figure {
    let [_, v] = slide_15();
    Figure::drawn(
        "basis_v",
        "The eight shape functions of degree 2 of $V=\\{0,0,0,\\frac15,\\frac25,\\frac35,\\frac35,\\frac45,1,1,1\\}$. At the double knot \
         $\\frac35$ one of them, $N_4$, reaches 1 in a corner: continuity falls from $C^1$ to $C^0$, and all others are 0 there.",
        "Eight curves over the interval from 0 to 1 with knots at multiples of one fifth. At 3/5, where two dots are stacked, the \
         fifth curve rises to 1 in a sharp tip; all others are smooth inside the interval or zero there.",
        &shape_functions(&v, "2", "*V*"),
    )
}

/// The cubic shape functions of simple knots over all of the knots, inside and outside the domain, and their sum.
fn draw_everywhere(mut drawing: Drawing, frame: &Frame, knots: &KnotVector<f64>) -> Drawing {
    let [first, last] = frame.domain;
    let steps = 18 * STEPS;
    let parameter = |step| first + (last - first) * f64::from(step) / f64::from(steps);
    let mut sums: Vec<[f64; 2]> = (0..=steps).map(|step| [parameter(step), 0.0]).collect();
    for index in 0..knots.control_point_count() {
        let support = [knots.knots()[index], knots.knots()[index + 4]];
        let mut graph = Vec::new();
        for [u, sum] in &mut sums {
            let value = cox_de_boor(knots, 3, index, *u);
            *sum += value;
            if support[0] <= *u && *u <= support[1] {
                graph.push(frame.place([*u, value]));
            }
        }
        drawing = drawing.polyline(&graph, look(index));
    }
    let sums: Vec<_> = sums.into_iter().map(|sum| frame.place(sum)).collect();
    drawing.polyline(&sums, Stroke::new(Colour::Ink, 2.4).dashes(Dashes::Dotted))
}

/// The shape functions of the slides' periodic U over all of its knots.
pub fn basis_domain() -> Figure {
    let breaks: Vec<f64> = (0..=12).map(f64::from).collect();
    let knots = KnotVector::periodic(3, &breaks).expect("thirteen breaks make a periodic vector");
    let all = knots.knots();
    let frame = Frame {
        domain: [all[0], all[all.len() - 1]],
    };
    let [start, end] = knots.domain();
    let corners = [[start, 0.0], [end, 0.0], [end, 1.0], [start, 1.0]];
    let corners = corners.map(|corner| frame.place(corner));
    let drawing = axes(&frame, &knots, "*U*").area(&corners, Colour::Faint, 0.16);
    let middle = [f64::midpoint(LEFT, RIGHT), TOP - 9.0];
    let drawing = draw_everywhere(drawing, &frame, &knots).text(
        middle,
        "the sum of all",
        TEXT,
        Anchor::Middle,
    );
    Figure::drawn(
        "basis_domain",
        "The fifteen shape functions of degree 3 of $U=\\{-3,-2,\\dots,15\\}$, all alike. Their sum (dotted) is 1 on the domain $[u_3,u_{15}]=[0,12]$, \
         shaded, and on no more: further out some of the four that ought to overlap are missing.",
        "Fifteen equal bells, each one unit right of the one before, over the interval from -3 to 15 with a knot at every integer. A dotted line \
         rises from 0 at -3 to 1 at 0, stays there over the shaded part up to 12, and falls to 0 at 15.",
        &drawing,
    )
}

/// The graph of the shape function `N_i(u) N_j(v)`, lifted by `scale`: linear precision turns Greville's abscissae into
/// the parameters themselves, so that the surface is `(u, v, scale · N_i(u) N_j(v))`.
fn graph_scene([i, j]: [usize; 2], view: View, scale: f64) -> Scene {
    let knots = slide_15();
    let abscissae = knots.each_ref().map(KnotVector::greville_abscissae);
    let graph = surface(knots, |k, l| {
        let height = if [k, l] == [i, j] { scale } else { 0.0 };
        at(abscissae[0][k], abscissae[1][l], height)
    });
    let support = graph.support_of(i, j);
    let is_inside = |[[u0, u1], [v0, v1]]: [[f64; 2]; 2]| {
        let [[a, b], [c, d]] = support;
        a <= u0 && u1 <= b && c <= v0 && v1 <= d
    };
    let mut scene = Scene::new(view);
    for piece in pieces(&graph, 20) {
        let colour = if is_inside(piece.domain) {
            Colour::Orange
        } else {
            Colour::Sky
        };
        scene = scene.surface(&piece.mesh, Material::matte(colour));
    }
    knot_lines(scene, &graph)
}

/// Adds the knot lines of a surface.
fn knot_lines(scene: Scene, graph: &Surface) -> Scene {
    let curve = |ends: [[f64; 2]; 2]| -> Vec<DVec3> {
        let parameter = |which: usize, t: f64| ends[0][which] * (1.0 - t) + ends[1][which] * t;
        let steps = (0..=96).map(|step| f64::from(step) / 96.0);
        steps
            .map(|t| graph.point(parameter(0, t), parameter(1, t)))
            .collect()
    };
    let [us, vs] = graph.breaks();
    let along_v = us.iter().map(|&u| [[u, 0.0], [u, 1.0]]);
    let along_u = vs.iter().map(|&v| [[0.0, v], [1.0, v]]);
    along_v.chain(along_u).fold(scene, |scene, ends| {
        scene.tube(&curve(ends), 0.003, Colour::Ink)
    })
}

/// Four shape functions of the tensor product.
pub fn surface_basis() -> Figure {
    let view = View::orthographic(at(5.5, -1.4, 2.6), at(0.5, 0.5, 0.12), DVec3::Z, 0.95);
    let panel = |label: &str, place, scale| {
        Panel::picture(label, graph_scene(place, view, scale).render(736, 520))
    };
    let scale = 0.5;
    let drawing = panels(
        2,
        &[
            panel("*N*_3(*u*) *N*_2(*v*), inside", [3, 2], scale),
            panel("*N*_2(*u*) *N*_4(*v*), at the double knot", [2, 4], scale),
            panel("*N*_6(*u*) *N*_2(*v*), at an edge", [6, 2], scale),
            panel("*N*_0(*u*) *N*_0(*v*), at a corner", [0, 0], scale),
        ],
    );
    Figure::drawn(
        "surface_basis",
        "Four of the $7\\cdot8$ products $N_i^3(u)N_j^2(v)$ over the parameter square, on the same scale. Orange is the support: at most \
         four spans by three, and the function is zero on all others. At the double knot $v=\\frac35$ the hill is pointed \
         across the knot line and round along it; at the corner it reaches 1, because $N_0^3(0)=N_0^2(0)=1$.",
        "Four graphs over a square with knot lines. An isolated hill over orange cells; a steep hill, pointed across a knot line; \
         half a hill on the front edge; a spike at the left corner. All other cells are flat.",
        &drawing,
    )
}
