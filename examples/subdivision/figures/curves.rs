//! Figures of subdivided polygons: corner cutting, ends, masks, limits, and how fast the polygon nears its limit.

use facette::bspline::BsplineCurve;
use facette::curve::Curve;
use facette::subdivision::curve::{
    Ends, distance_bound, edges, limit_curve, limit_points, subdivided,
};
use facette_figure::Figure;
use facette_figure::palette::Colour;
use facette_figure::plot::Plot;
use facette_figure::svg::{Anchor, Dashes, Drawing, Panel, Stroke, panels};
use glam::DVec2;

/// The chapter's polygon, in the units of a panel, y down.
const POLYGON: [[f64; 2]; 6] = [
    [40., 196.],
    [20., 40.],
    [160., 20.],
    [150., 130.],
    [310., 60.],
    [300., 210.],
];
/// The size of a panel.
const PANEL: [f64; 2] = [340.0, 230.0];
const TEXT: f64 = 19.0;

fn polygon() -> Vec<DVec2> {
    POLYGON.map(DVec2::from).to_vec()
}

fn refined(degree: usize, ends: Ends, rounds: u32) -> Vec<DVec2> {
    subdivided(&polygon(), degree, ends, rounds).expect("a few points, a few rounds")
}

fn limit(degree: usize, ends: Ends) -> BsplineCurve<DVec2> {
    limit_curve(&polygon(), degree, ends).expect("the chapter's polygon has a limit")
}

fn draw_polygon(drawing: Drawing, points: &[DVec2], ends: Ends, stroke: Stroke) -> Drawing {
    edges(points, ends).fold(drawing, |drawing, [p, q]| {
        drawing.line(p.to_array(), q.to_array(), stroke)
    })
}

fn draw_points(drawing: Drawing, points: &[DVec2], radius: f64, colour: Colour) -> Drawing {
    points.iter().fold(drawing, |drawing, p| {
        drawing.disc(p.to_array(), radius, colour)
    })
}

/// The curve as the points of 40 parameters to a span, which no eye tells from it.
fn draw_curve(drawing: Drawing, curve: &BsplineCurve<DVec2>, stroke: Stroke) -> Drawing {
    let [start, end] = curve.domain();
    let steps = 40 * (curve.control_points().len() - curve.degree());
    let point = |i: usize| curve.point(start + (end - start) * i as f64 / steps as f64);
    let points: Vec<[f64; 2]> = (0..=steps).map(|i| point(i).to_array()).collect();
    drawing.polyline(&points, stroke)
}

const OLD: Stroke = Stroke {
    colour: Colour::Faint,
    width: 2.0,
    dashes: Dashes::Dashed,
};

/// Three rounds of Chaikin's scheme, and the limit.
pub fn corner_cutting() -> Figure {
    let round = |rounds: u32| {
        let [before, after] = [rounds - 1, rounds].map(|rounds| refined(2, Ends::Closed, rounds));
        let mut drawing = Drawing::new(PANEL[0], PANEL[1]);
        drawing = draw_polygon(drawing, &before, Ends::Closed, OLD);
        drawing = draw_polygon(
            drawing,
            &after,
            Ends::Closed,
            Stroke::new(Colour::Vermilion, 2.4),
        );
        draw_points(
            drawing,
            &after,
            4.6 - 0.6 * f64::from(rounds),
            Colour::Vermilion,
        )
    };
    let mut last = Drawing::new(PANEL[0], PANEL[1]);
    last = draw_polygon(last, &polygon(), Ends::Closed, OLD);
    last = draw_curve(
        last,
        &limit(2, Ends::Closed),
        Stroke::new(Colour::Blue, 3.0),
    );
    let middles = limit_points(&polygon(), 2, Ends::Closed).expect("a degree");
    last = draw_points(last, &middles, 4.0, Colour::Ink);
    let drawing = panels(
        2,
        &[
            Panel::drawing("round 1: 12 points", round(1)),
            Panel::drawing("round 2: 24 points", round(2)),
            Panel::drawing("round 3: 48 points", round(3)),
            Panel::drawing("the limit", last),
        ],
    );
    Figure::drawn(
        "corner_cutting",
        "Chaikin's scheme on a closed polygon of six points. Each round puts two points on every edge of the polygon before (dashed) and so cuts off its corners. The limit touches every edge of the first polygon in its middle (dots).",
        "Four panels. In three of them a dashed polygon and, inside it, an orange one whose edges lie on its edges and across its corners; it looks rounder each time. In the fourth a smooth blue curve that touches the six edges of the first polygon in their middles.",
        &drawing,
    )
}

/// Where the old points of a mask stand in its panel.
const CORNER: [[f64; 2]; 3] = [[40., 170.], [170., 60.], [300., 170.]];
const MASK_PANEL: [f64; 2] = [340.0, 210.0];

fn ring(drawing: Drawing, place: [f64; 2]) -> Drawing {
    drawing.circle(place, 8.0, Stroke::new(Colour::Blue, 2.4))
}

/// An edge with the two points of Chaikin's scheme.
fn chaikin_mask() -> Drawing {
    let [p, next] = [[40.0, 110.0], [300.0, 110.0]];
    let [q, r] = [[105.0, 110.0], [235.0, 110.0]];
    let mut drawing = Drawing::new(MASK_PANEL[0], MASK_PANEL[1]);
    drawing = drawing.line(p, next, Stroke::new(Colour::Faint, 2.0));
    drawing = ring(ring(drawing, p), next);
    drawing = drawing
        .disc(q, 7.0, Colour::Vermilion)
        .disc(r, 7.0, Colour::Faint);
    let words = [
        ([40.0, 84.0], "*P*"),
        ([300.0, 84.0], "*P*_+"),
        ([40.0, 148.0], "3/4"),
        ([300.0, 148.0], "1/4"),
        ([105.0, 84.0], "*Q*"),
        ([235.0, 84.0], "*R*"),
    ];
    write_words(drawing, &words)
}

fn write_words(drawing: Drawing, words: &[([f64; 2], &str)]) -> Drawing {
    words.iter().fold(drawing, |drawing, &(place, word)| {
        drawing.text(place, word, TEXT, Anchor::Middle)
    })
}

/// A corner with the mean of its points that has these weights over their sum.
fn corner_mask(weights: [i32; 3], name: &str) -> Drawing {
    let sum: i32 = weights.iter().sum();
    let corner = CORNER.map(DVec2::from);
    let terms = corner.iter().zip(weights);
    let mean: DVec2 = terms.map(|(&p, w)| p * f64::from(w) / f64::from(sum)).sum();
    let mut drawing = Drawing::new(MASK_PANEL[0], MASK_PANEL[1]);
    drawing = drawing.polyline(&CORNER, Stroke::new(Colour::Faint, 2.0));
    for (index, (place, weight)) in CORNER.into_iter().zip(weights).enumerate() {
        if weight != 0 {
            let below = if index == 1 { -18.0 } else { 34.0 };
            let label = [place[0], place[1] + below];
            drawing =
                ring(drawing, place).text(label, &format!("{weight}/{sum}"), TEXT, Anchor::Middle);
        }
    }
    let beside = if weights[2] == 0 {
        [-22.0, -6.0]
    } else {
        [0.0, 30.0]
    };
    drawing = drawing.disc(mean.to_array(), 7.0, Colour::Vermilion);
    drawing.text(
        (mean + DVec2::from(beside)).to_array(),
        name,
        TEXT,
        Anchor::Middle,
    )
}

/// The masks of the two schemes, and where a vertex of the cubic one goes.
pub fn curve_masks() -> Figure {
    let masks = [
        Panel::drawing("Chaikin: one of two on an edge", chaikin_mask()),
        Panel::drawing("cubic: the edge", corner_mask([1, 1, 0], "*E*")),
        Panel::drawing("cubic: the vertex", corner_mask([1, 6, 1], "*V*")),
        Panel::drawing(
            "cubic: the vertex, in the limit",
            corner_mask([1, 4, 1], "*C*(*i*)"),
        ),
    ];
    Figure::drawn(
        "curve_masks",
        "Masks: the old points (rings) that a new point (orange) is a mean of, and their weights. For $R$ the two weights change places. The last mask is no step of a scheme: it says where the vertex goes in the end.",
        "Four panels. On an edge between two rings with the weights 3/4 and 1/4 an orange point Q near the first; a grey one, R, near the other. A corner whose left edge has an orange point E in its middle, weights 1/2 and 1/2. The corner with weights 1/8, 6/8, 1/8 and an orange point V below its tip. The same with weights 1/6, 4/6, 1/6 and the point further below.",
        &panels(2, &masks),
    )
}

/// What the three kinds of ends make of an open polygon.
pub fn polygon_ends() -> Figure {
    let kinds = [
        ("closed", Ends::Closed),
        ("open: the ends are lost", Ends::Open),
        ("kept", Ends::Kept),
    ];
    let shown = |degree: usize, (label, ends): (&str, Ends)| {
        let finer = refined(degree, ends, 1);
        let mut drawing = Drawing::new(PANEL[0], PANEL[1]);
        drawing = draw_polygon(drawing, &polygon(), ends, OLD);
        drawing = draw_curve(
            drawing,
            &limit(degree, ends),
            Stroke::new(Colour::Blue, 3.4),
        );
        drawing = draw_points(drawing, &finer, 4.6, Colour::Vermilion);
        Panel::drawing(&format!("{label}, {} points", finer.len()), drawing)
    };
    let all: Vec<Panel> = [2, 3]
        .into_iter()
        .flat_map(|degree| kinds.map(|kind| shown(degree, kind)))
        .collect();
    Figure::drawn(
        "polygon_ends",
        "Six points (dashed), the points after one round (orange) and the limit (blue): Chaikin's scheme in the upper row, the cubic one in the lower. An open polygon loses its ends, by half an edge of the polygon or by a whole one; kept, the limit runs from the first point to the last.",
        "Two rows of three panels. Left a closed blue curve in a dashed hexagon; in the middle an open one that begins and ends inside the dashed polygon; right one that begins and ends at the polygon's end points. The curves of the lower row are farther from the corners.",
        &panels(3, &all),
    )
}

/// The largest distance between the polygon after so many rounds and the limit, at equal parameters, over the vertices.
fn farthest_vertex(degree: usize, rounds: u32) -> f64 {
    let finer = refined(degree, Ends::Closed, rounds);
    let curve = limit(degree, Ends::Closed);
    let [_, period] = curve.domain();
    // Vertices of even degree stand half a span behind the knots.
    let offset = if degree.is_multiple_of(2) { -0.5 } else { 0.0 };
    let span = 0.5_f64.powi(rounds.try_into().unwrap_or(i32::MAX));
    let distance = |(i, p): (usize, &DVec2)| {
        let u = ((i as f64 + offset) * span).rem_euclid(period);
        (*p - curve.point(u)).abs().max_element()
    };
    finer.iter().enumerate().map(distance).fold(0.0, f64::max)
}

/// The distance to the limit against the number of rounds.
pub fn polygon_convergence() -> Figure {
    let rounds = 0..=9_u32;
    let of = |value: &dyn Fn(u32) -> f64| -> Vec<[f64; 2]> {
        rounds.clone().map(|k| [f64::from(k), value(k)]).collect()
    };
    let bound = |degree: usize| {
        move |k| {
            distance_bound(&polygon(), degree, Ends::Closed, k)
                .expect("a few rounds of a known degree")
        }
    };
    let plot = Plot::new("", "rounds", "largest distance")
        .log_y()
        .points("Chaikin, measured", &of(&|k| farthest_vertex(2, k)))
        .points("cubic, measured", &of(&|k| farthest_vertex(3, k)))
        .line("Chaikin, bound", &of(&bound(2)))
        .line("cubic, bound", &of(&bound(3)))
        .to_drawing()
        .expect("positive distances make a plot");
    Figure::drawn(
        "polygon_convergence",
        "How far the closed polygon of the figures is from its limit after each round: the largest difference of a coordinate between a vertex and the point of the limit with the same parameter (marks), and the bound $\\frac{d+1}{24}4^{-k}\\max|\\Delta^2P|$ (lines). Every round divides both by four; the unit is that of the drawing, 340 wide.",
        "Two falling straight lines with marks on them over the number of rounds from 0 to 9, on a logarithmic axis; the cubic one lies a little above Chaikin's.",
        &plot,
    )
}
