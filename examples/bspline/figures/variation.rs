//! The figure of what surfaces lack: variation diminishing.

use facette::bspline::KnotVector;
use facette_figure::Figure;
use facette_figure::palette::Colour;
use facette_figure::render::{Material, Scene, Triangles, View};
use facette_figure::svg::{Panel, panels};
use glam::DVec3;

use super::shapes::{Surface, at, clamped, pieces, surface};

/// Heights are drawn at this part of their size: affine maps move a surface as they move its net.
const SCALE: f64 = 0.3;

/// The surface of these knots over the net of the counterexample.
fn over_the_net(knots: [KnotVector<f64>; 2]) -> Surface {
    const HEIGHTS: [[f64; 3]; 3] = [[4.0, -1.9, -1.9], [-1.9, 1.0, -1.9], [-1.9, -1.9, 4.0]];
    surface(knots, |i, j| at(i as f64, j as f64, SCALE * HEIGHTS[j][i]))
}

/// What of a surface rises above the plane z = 0.
fn above_the_plane(knots: [KnotVector<f64>; 2], isolines: u32) -> Scene {
    let view = View::orthographic(at(5., -3., 6.), at(1., 1., 0.2), DVec3::Z, 2.2);
    let plane = Triangles::grid(1, 1, |u, v| {
        (at(6.0 * u - 2.0, 6.0 * v - 2.0, 0.0), DVec3::Z)
    });
    let scene = Scene::new(view).surface(&plane, Material::matte(Colour::Sky));
    pieces(&over_the_net(knots), 48)
        .iter()
        .fold(scene, |scene, piece| {
            let material = Material::matte(Colour::Orange).isolines(isolines);
            scene.surface(&piece.mesh, material)
        })
}

/// A plane that cuts the net into fewer pieces than the surface.
pub fn two_islands() -> Figure {
    let net = || clamped(1, &[1.0], 2.0);
    let patch = || KnotVector::bezier(2);
    let drawing = panels(
        2,
        &[
            Panel::picture(
                "the control net: one island",
                above_the_plane([net(), net()], 1).render(736, 500),
            ),
            Panel::picture(
                "the surface: two islands",
                above_the_plane([patch(), patch()], 2).render(736, 500),
            ),
        ],
    );
    Figure::drawn(
        "two_islands",
        "A plane (blue, as water) cuts a net of $3\\cdot3$ control points, filled by bilinear pieces, and the biquadratic patch that it \
         controls. The net has one piece above the water, with an isthmus; the patch has two. A plane meets a curve \
         at most as often as its polygon; nothing of the kind holds for surfaces.",
        "Two pictures of an orange surface that rises from a blue plane. On the left two peaks at opposite corners are joined by a narrow \
         ridge with a small summit in the middle; on the right the peaks stand apart, with water between them.",
        &drawing,
    )
}
