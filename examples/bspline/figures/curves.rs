//! Figures of curves: de Boor's points, knot insertion, degree elevation, and the curves of a surface.

use facette::bspline::{BsplineCurve, Direction, KnotVector, blossom, find_span};
use facette::curve::Curve;
use facette_figure::Figure;
use facette_figure::palette::Colour;
use facette_figure::render::{Material, Scene, View};
use facette_figure::svg::{Anchor, Dashes, Drawing, PAGE_WIDTH, Stroke};
use glam::{DVec2, DVec3};

use super::shapes::{Photo, Surface, at, five_by_five, knot_text, net_size, pieces, row, slide_15};

/// The control points of the chapter's plane cubic, in the units of a drawing, y down.
const POINTS: [[f64; 2]; 7] = [
    [30., 130.],
    [64., 320.],
    [220., 30.],
    [480., 30.],
    [556., 300.],
    [700., 316.],
    [722., 100.],
];
const HEIGHT: f64 = 346.0;
const TEXT: f64 = 17.0;

/// The chapter's plane cubic, with the slides' knots U.
fn plane_curve() -> BsplineCurve<DVec2> {
    let [knots, _] = slide_15();
    BsplineCurve::new(knots, POINTS.map(DVec2::from).to_vec()).expect("seven finite points fit U")
}

fn places(points: &[DVec2]) -> Vec<[f64; 2]> {
    points.iter().map(DVec2::to_array).collect()
}

/// The curve, exactly: its Bézier pieces are cubics, as SVG's are.
fn draw_curve(drawing: Drawing, curve: &BsplineCurve<DVec2>) -> Drawing {
    let pieces = curve.bezier_pieces().into_iter();
    pieces.fold(drawing, |drawing, piece| {
        match places(piece.curve.control_points())[..] {
            [a, b, c, d] => drawing.bezier([a, b, c, d], Stroke::new(Colour::Blue, 3.2)),
            _ => drawing,
        }
    })
}

/// A control polygon: its sides, and its points as rings or discs.
fn draw_polygon(drawing: Drawing, points: &[DVec2], stroke: Stroke, is_filled: bool) -> Drawing {
    let places = places(points);
    let drawing = drawing.polyline(&places, stroke);
    places.into_iter().fold(drawing, |drawing, place| {
        if is_filled {
            drawing.disc(place, 5.0, stroke.colour)
        } else {
            drawing.circle(place, 7.5, Stroke::new(stroke.colour, 2.0))
        }
    })
}

/// Names beside points: text, point, offset.
fn draw_names(drawing: Drawing, names: &[(&str, DVec2, [f64; 2])]) -> Drawing {
    names
        .iter()
        .fold(drawing, |drawing, (name, point, [right, down])| {
            let place = [point.x + right, point.y + down];
            drawing.text(place, name, TEXT, Anchor::Middle)
        })
}

/// Marks on the curve where its pieces meet, with the knots beside them, on the side to which the curve bends.
fn draw_knots(drawing: Drawing, curve: &BsplineCurve<DVec2>) -> Drawing {
    let knots = curve.knots();
    let spans = knots.spans().skip(1);
    spans.fold(drawing, |drawing, span| {
        let [knot, _] = knots.span_interval(span);
        let point = curve.point(knot);
        let across = curve.derivative_at(1, knot).perp().normalize_or_zero();
        let inwards = across * across.dot(curve.derivative_at(2, knot)).signum();
        let [x, y] = (point + 20.0 * inwards).to_array();
        drawing.disc(point.to_array(), 3.6, Colour::Ink).text(
            [x, y + 5.0],
            &knot_text(knot),
            15.0,
            Anchor::Middle,
        )
    })
}

/// The names of the points in de Boor's triangle.
fn name_de_boor(
    drawing: Drawing,
    points: &[DVec2],
    rounds: &[Vec<DVec2>; 2],
    end: DVec2,
) -> Drawing {
    draw_names(
        drawing,
        &[
            ("*P*_1", points[1], [-20.0, 6.0]),
            ("*P*_2", points[2], [-6.0, -12.0]),
            ("*P*_3", points[3], [10.0, -12.0]),
            ("*P*_4", points[4], [-22.0, 8.0]),
            ("*P*_2^1", rounds[0][0], [-30.0, 0.0]),
            ("*P*_3^1", rounds[0][1], [0.0, -12.0]),
            ("*P*_4^1", rounds[0][2], [28.0, 4.0]),
            ("*P*_3^2", rounds[1][0], [-10.0, 26.0]),
            ("*P*_4^2", rounds[1][1], [14.0, 26.0]),
            ("*C*(*u*)", end, [0.0, 30.0]),
        ],
    )
}

/// De Boor's triangle of points.
pub fn de_boor() -> Figure {
    const U: f64 = 0.375;
    let curve = plane_curve();
    let (knots, points) = (curve.knots(), curve.control_points());
    let span = find_span(knots, U);
    let mut drawing = Drawing::new(PAGE_WIDTH, HEIGHT);
    drawing = draw_polygon(drawing, points, Stroke::new(Colour::Faint, 1.6), true);
    drawing = draw_curve(drawing, &curve);
    let rounds = [1, 2].map(|round| de_boor_row(knots, points, span, round, U));
    let looks = [
        Stroke::new(Colour::Vermilion, 2.2),
        Stroke::new(Colour::Green, 3.0),
    ];
    for (row, look) in rounds.iter().zip(looks) {
        drawing = draw_polygon(drawing, row, look, true);
    }
    let end = curve.point(U);
    drawing = drawing.disc(end.to_array(), 6.5, Colour::Ink);
    drawing = name_de_boor(drawing, points, &rounds, end);
    Figure::drawn(
        "de_boor",
        "De Boor's points for $u=\\frac38$, which lies in the span $[\\frac14,\\frac12]$ of $P_1,\\dots,P_4$. Each round puts a point on every side \
         of the polygon before (orange, then green), at a ratio of knot differences; the last round has one \
         side, and its point is $P_4^3=C(u)$.",
        "A blue curve and its grey control polygon. Three orange points lie on the sides from P1 to P4, two green points on the \
         sides between those, and one black point between the green ones, on the curve.",
        &drawing,
    )
}

/// The points of one round of de Boor's scheme: blossoms whose first arguments are u, the others knots around its span.
fn de_boor_row(
    knots: &KnotVector<f64>,
    points: &[DVec2],
    span: usize,
    round: usize,
    u: f64,
) -> Vec<DVec2> {
    let degree = knots.degree();
    let point = |index: usize| {
        let mut arguments = vec![u; round];
        arguments.extend(&knots.knots()[index + 1..=index + degree - round]);
        blossom(knots, points, span, &arguments)
    };
    (span - degree + round..=span).map(point).collect()
}

/// Boehm's insertion of one knot.
pub fn knot_insertion() -> Figure {
    const NEW: f64 = 0.4;
    let old = plane_curve();
    let new = old.with_knot(NEW).expect("the knot lies in the domain");
    let mut drawing = Drawing::new(PAGE_WIDTH, HEIGHT);
    let dashed = Stroke::new(Colour::Faint, 2.0).dashes(Dashes::Dashed);
    drawing = draw_polygon(drawing, old.control_points(), dashed, false);
    drawing = draw_polygon(
        drawing,
        new.control_points(),
        Stroke::new(Colour::Vermilion, 2.2),
        true,
    );
    drawing = draw_knots(draw_curve(drawing, &new), &new);
    let (before, after) = (old.control_points(), new.control_points());
    drawing = draw_names(
        drawing,
        &[
            ("*P*_2", before[2], [-4.0, -14.0]),
            ("*P*_3", before[3], [6.0, -14.0]),
            ("*Q*_2", after[2], [-24.0, 2.0]),
            ("*Q*_3", after[3], [0.0, -12.0]),
            ("*Q*_4", after[4], [24.0, 4.0]),
        ],
    );
    Figure::drawn(
        "knot_insertion",
        "The knot $\\frac25$ is inserted, and the curve does not move. $Q_2$, $Q_3$ and $Q_4$ take the place of $P_2$ and $P_3$ (rings); all other \
         control points stay. The new ones lie on the sides of the old polygon: they are the first round of de Boor's scheme at \
         $u=\\frac25$. The dots on the curve are its knots.",
        "A blue curve with dots at its knots 1/4, 2/5, 1/2 and 3/4. Its old control polygon is grey and dashed; the new one is \
         orange and cuts two corners of it by three new points.",
        &drawing,
    )
}

/// The polygon of degree 3, and that of the same curve as one of degree 4.
pub fn degree_elevation() -> Figure {
    let old = plane_curve();
    let new = old.elevated();
    let mut drawing = Drawing::new(PAGE_WIDTH, HEIGHT);
    let dashed = Stroke::new(Colour::Faint, 2.0).dashes(Dashes::Dashed);
    drawing = draw_polygon(drawing, old.control_points(), dashed, false);
    drawing = draw_polygon(
        drawing,
        new.control_points(),
        Stroke::new(Colour::Vermilion, 2.2),
        true,
    );
    drawing = draw_knots(draw_curve(drawing, &old), &old);
    Figure::drawn(
        "degree_elevation",
        "The same curve as one of degree 4 (orange polygon, eleven points) instead of 3 (dashed, seven points). Each inner knot is now \
         double, because the curve has not become smoother than $C^2$ there.",
        "A blue curve with dots at its knots 1/4, 1/2 and 3/4, its grey dashed control polygon of seven points, and an orange one of eleven \
         that runs closer to the curve.",
        &drawing,
    )
}

/// A curve of constant u on a surface, with the points Q_j(u0) that control it.
pub fn isoparametric() -> Figure {
    const U: f64 = 1.4;
    let surface = five_by_five();
    let [_, rows] = net_size(&surface);
    let view = View::orthographic(at(8., -5., 7.), at(2., 2., 0.45), DVec3::Z, 4.2);
    let across = surface.curve_at_u(U);
    let surface_alone = pieces(&surface, 24)
        .iter()
        .fold(Scene::new(view), |scene, piece| {
            scene.surface(&piece.mesh, Material::matte(Colour::Faint))
        });
    let scene = surface_alone.tube(&samples(&across), 0.04, Colour::Vermilion);
    let net: Vec<_> = (0..rows).map(|j| row(&surface, j)).collect();
    let row_curves: Vec<_> = net.iter().map(|row| row_curve(&surface, row)).collect();
    let mut photo = Photo::new(&scene, [750, 470])
        .polylines(&row_curves, Stroke::new(Colour::Blue, 3.4))
        .polylines(&net, Stroke::new(Colour::Ink, 1.0))
        .discs(surface.control_points(), 3.0, Colour::Ink)
        .discs(across.control_points(), 5.5, Colour::Vermilion);
    for (j, &point) in across.control_points().iter().enumerate() {
        photo = photo.text(point, [2.0, 28.0], &format!("*Q*_{j}"), 18.0);
    }
    Figure::drawn(
        "isoparametric",
        "The curve $u=\\frac75$ of a surface (orange). Each row of the net controls a curve in $u$ (blue); its point at $\\frac75$ is \
         $Q_j$, and the $Q_j$ are the control points of the orange curve, with the knots $V$.",
        "A wavy grey surface with five rows of control points joined by thin lines. Along each runs a blue curve with an orange point \
         Q0 to Q4 on it; the five orange points control an orange curve across the surface.",
        &photo.drawing,
    )
}

/// Points on the curve in u that a row of the net controls.
fn row_curve(surface: &Surface, row: &[DVec3]) -> Vec<DVec3> {
    let knots = surface.knots(Direction::U).clone();
    let curve =
        BsplineCurve::new(knots, row.to_vec()).expect("a row of the net fits the knots of u");
    samples(&curve)
}

/// Points on a curve, close enough together to look smooth.
fn samples(curve: &BsplineCurve<DVec3>) -> Vec<DVec3> {
    let [start, end] = curve.domain();
    (0..=96)
        .map(|index| f64::from(index) / 96.0)
        .map(|t| curve.point(start * (1.0 - t) + end * t))
        .collect()
}
