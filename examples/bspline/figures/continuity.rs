//! Figures of smoothness: isophotes across a knot line.

use facette::bspline::KnotVector;
use facette::curve::Curve;
use facette_figure::Figure;
use facette_figure::palette::Colour;
use facette_figure::render::{Material, Scene, View};
use facette_figure::svg::{Panel, panels};
use glam::DVec3;

use super::shapes::{Surface, at, clamped, pieces, surface};

/// A surface over one net of 8 by 5 control points, of degrees 3 and 3.
fn over_the_net(u: KnotVector<f64>) -> Surface {
    const ACROSS: [f64; 8] = [0.0, 0.35, 0.7, 1.05, 1.45, 0.6, 0.5, 0.4];
    const ALONG: [f64; 5] = [0.5, 1.1, 1.4, 1.1, 0.4];
    let v = clamped(3, &[1.0], 2.0);
    surface([u, v], |i, j| at(i as f64, j as f64, ACROSS[i] * ALONG[j]))
}

/// Isophotes across u = 3, a knot of multiplicity 1 to 4.
pub fn continuity() -> Figure {
    let view = View::orthographic(at(4.5, -7., 9.), at(3.5, 2., 0.4), DVec3::Z, 4.5);
    let panel = |label: &str, inner: &[f64]| {
        let shown = over_the_net(clamped(3, inner, 6.0));
        let mut scene = Scene::new(view);
        for piece in pieces(&shown, 40) {
            let material = Material::isophotes(Colour::Sky, at(0.1, -0.8, 0.55), 30);
            scene = scene.surface(&piece.mesh, material);
        }
        let line = shown.curve_at_u(3.0);
        let [start, end] = line.domain();
        for t in [start, end] {
            scene = scene.point(line.point(t), 0.09, Colour::Vermilion);
        }
        Panel::picture(label, scene.render(736, 440))
    };
    let drawing = panels(
        2,
        &[
            panel("*u* = 3 simple: *C*^2", &[1., 2., 3., 4.5]),
            panel("*u* = 3 double: *C*^1", &[1.5, 3., 3., 4.5]),
            panel("*u* = 3 triple: *C*^0", &[1.5, 3., 3., 3.]),
            panel("*u* = 3 four times: torn", &[3., 3., 3., 3.]),
        ],
    );
    Figure::drawn(
        "continuity",
        "Isophotes, the lines of equal light, on surfaces of degree 3 in $u$ over the same net; the orange points end the line $u=3$. Where \
         that knot is simple the stripes cross it smoothly; where it is double they stay whole but break their direction; where it is \
         triple they jump, as the normal does. Four times, and the surface is torn: evaluation at $u=3$ takes the piece on the right.",
        "Four striped pictures of a surface with a ridge between two orange points. The stripes bend round over the ridge; they turn there with a \
         corner; they are cut off and go on elsewhere; the surface is in two halves with a gap.",
        &drawing,
    )
}
