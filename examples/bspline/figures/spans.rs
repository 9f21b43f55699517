//! Figures of the spans of a surface, and of what one control point moves.

use facette::bspline::{Direction, KnotVector};
use facette_figure::Figure;
use facette_figure::palette::{Colour, SERIES};
use facette_figure::render::{Material, Scene, View};
use facette_figure::svg::{Drawing, Panel, Stroke, panels};
use glam::DVec3;

use super::shapes::{
    Photo, Surface, at, clamped, column, five_by_five, nine_by_nine, pieces, row, surface,
};

/// The colour of a span, different from those of its eight neighbours.
fn span_colour([column, row]: [usize; 2]) -> Colour {
    SERIES[(column + 2 * row) % SERIES.len()]
}

/// A surface whose spans have the colours that `colour` gives them.
fn coloured(
    scene: Scene,
    surface: &Surface,
    colour: impl Fn([usize; 2]) -> Colour,
    isolines: u32,
) -> Scene {
    pieces(surface, 24).iter().fold(scene, |scene, piece| {
        scene.surface(
            &piece.mesh,
            Material::matte(colour(piece.span)).isolines(isolines),
        )
    })
}

/// The chapter's first picture: a surface, its net, and one span with the control points that alone make it.
pub fn control_net() -> Figure {
    let whole = nine_by_nine();
    let view = View::orthographic(at(9., -10., 11.), at(4., 4., 0.35), DVec3::Z, 7.5);
    let chosen = [2, 3];
    let colour = |span: [usize; 2]| match (span == chosen, (span[0] + span[1]) % 2) {
        (true, _) => Colour::Orange,
        (false, 0) => Colour::Sky,
        (false, _) => Colour::Blue,
    };
    let scene = coloured(Scene::new(view), &whole, colour, 0);
    let [p, q] = [Direction::U, Direction::V].map(|direction| whole.knots(direction).degree());
    let [first_i, first_j] = chosen;
    let own: Vec<_> = (first_j..=first_j + q)
        .flat_map(|j| row(&whole, j)[first_i..=first_i + p].to_vec())
        .collect();
    let photo = Photo::new(&scene, [750, 500])
        .net(&whole, Stroke::new(Colour::Ink, 1.1))
        .discs(&own, 6.5, Colour::Orange);
    Figure::drawn(
        "control_net",
        "A B-spline surface of degrees 3 and 2 and its net of $9\\cdot9$ control points. The knot lines cut it into $6\\cdot7$ spans, here chequered. \
         The orange one is a polynomial of its own, made by the $4\\cdot3$ orange points alone.",
        "A surface with a hill and a hollow, chequered in two blues, and a net of points and lines that follows it. One cell on the hill is \
         orange, and so are twelve points of the net around it.",
        &photo.drawing,
    )
}

/// The slides' two surfaces, each span in another colour.
pub fn coloured_spans() -> Figure {
    let small = five_by_five();
    let view = View::orthographic(at(4., -7., 6.5), at(2., 2., 0.35), DVec3::Z, 4.0);
    let scene = coloured(Scene::new(view), &small, span_colour, 0);
    let left = Photo::new(&scene, [368, 290]).net(&small, Stroke::new(Colour::Ink, 1.3));
    let large = nine_by_nine();
    let view = View::orthographic(at(6., -12., 12.), at(4., 4., 0.2), DVec3::Z, 7.4);
    let scene = coloured(Scene::new(view), &large, span_colour, 0);
    let right = Photo::new(&scene, [368, 290]);
    let drawing = panels(
        2,
        &[
            Panel::drawing("5 · 5 control points, 2 · 3 spans", left.drawing),
            Panel::drawing("9 · 9 control points, 6 · 7 spans", right.drawing),
        ],
    );
    Figure::drawn(
        "coloured_spans",
        "Each cell is one polynomial; neighbours differ in colour. Left: $U=\\{0,0,0,0,1,2,2,2,2\\}$, $p=3$ and $V=\\{0,0,0,1,2,3,3,3\\}$, $q=2$ with the control net. \
         Right: $U=\\{0,0,0,0,1,\\dots,5,6,6,6,6\\}$ and $V=\\{0,0,0,1,\\dots,6,7,7,7\\}$. The light shows no seam: across a knot line of \
         $u$ the surface is $C^2$, across one of $v$ it is $C^1$.",
        "Two smooth surfaces cut into coloured cells, no two neighbours alike. The left one has six cells under a net of 25 \
         points, the right one 42 cells.",
        &drawing,
    )
}

/// A surface with the spans that the control point `P_ij` moves in orange, the point itself, and its four neighbours.
fn moved_spans(shown: &Surface, [i, j]: [usize; 2]) -> Drawing {
    let [[u0, u1], [v0, v1]] = shown.support_of(i, j);
    let view = View::orthographic(at(6., -9., 8.), at(4., 4., 1.2), DVec3::Z, 8.3);
    let mut scene = Scene::new(view);
    for piece in pieces(shown, 20) {
        let [[a, b], [c, d]] = piece.domain;
        let colour = if u0 <= a && b <= u1 && v0 <= c && d <= v1 {
            Colour::Orange
        } else {
            Colour::Sky
        };
        scene = scene.surface(&piece.mesh, Material::matte(colour).isolines(1));
    }
    let cross = [
        row(shown, j)[i - 1..=i + 1].to_vec(),
        column(shown, i)[j - 1..=j + 1].to_vec(),
    ];
    Photo::new(&scene, [368, 310])
        .polylines(&cross, Stroke::new(Colour::Ink, 1.5))
        .discs(&cross.concat(), 3.6, Colour::Ink)
        .discs(&[shown.control_point(i, j)], 6.0, Colour::Vermilion)
        .drawing
}

/// One control point lifted, and the spans that move.
pub fn local_control() -> Figure {
    let low = nine_by_nine().mapped(|point| at(point.x, point.y, 0.25 * point.z));
    let before = low.expect("a part of a finite height is finite");
    let [i, j] = [4, 3];
    let lifted = before.control_point(i, j) + at(0., 0., 4.6);
    let after = before.clone().with_control_point(i, j, lifted);
    let after = after.expect("a lifted point is finite");
    let drawing = panels(
        2,
        &[
            Panel::drawing("before", moved_spans(&before, [i, j])),
            Panel::drawing("after: *P*_{43} is lifted", moved_spans(&after, [i, j])),
        ],
    );
    Figure::drawn(
        "local_control",
        "One control point is lifted, and exactly $4\\cdot3$ of the 42 spans move (orange): those with $u$ in $[u_4,u_8]$ and \
         $v$ in $[v_3,v_6]$. All others keep every bit.",
        "Two pictures of a surface cut into cells. In the second one control point is raised high above its four neighbours, and a block of \
         orange cells bulges towards it; the blue cells around are the same in both.",
        &drawing,
    )
}

/// A surface over one net of 8 by 8 control points, two ridges that cross, whatever its knots.
fn over_the_same_net(knots: [KnotVector<f64>; 2]) -> Surface {
    const ALONG: [f64; 8] = [0.2, 0.5, 0.4, 0.5, 1.9, 0.5, 0.4, 0.1];
    surface(knots, |i, j| {
        let (x, y) = (i as f64, j as f64);
        at(x, y, 0.8 * (ALONG[i] + ALONG[j]))
    })
}

/// A double and a triple knot, in u and in v.
pub fn repeated_knots() -> Figure {
    let simple = || clamped(2, &[1., 2., 3., 4., 5.], 6.0);
    let double = || clamped(2, &[1., 2., 3., 3., 4.5], 6.0);
    let triple = || clamped(2, &[1.5, 3., 3., 3., 4.5], 6.0);
    let view = View::orthographic(at(12.5, -7., 11.), at(3.5, 3.5, 0.7), DVec3::Z, 7.4);
    let panel = |label: &str, knots| {
        let mut scene = Scene::new(view);
        for piece in pieces(&over_the_same_net(knots), 16) {
            scene = scene.surface(&piece.mesh, Material::matte(Colour::Sky).isolines(2));
        }
        Panel::picture(label, scene.render(736, 500))
    };
    let drawing = panels(
        2,
        &[
            panel("*u* = 3 double", [double(), simple()]),
            panel("*v* = 3 double", [simple(), double()]),
            panel("*u* = 3 triple", [triple(), simple()]),
            panel("*v* = 3 triple", [simple(), triple()]),
        ],
    );
    Figure::drawn(
        "repeated_knots",
        "The same $8\\cdot8$ control points, degrees 2 and 2, and only the knots changed: two ridges that cross. A double knot turns a round \
         ridge into a crease along the whole line $u=3$ or $v=3$; a triple one tears the surface there. The other ridge, \
         whose knots are simple, stays round.",
        "Four pictures of a surface with two crossing ridges and lines of constant parameters: with a sharp fold along one ridge; along the other; \
         cut in two along the first; cut in two along the second.",
        &drawing,
    )
}
