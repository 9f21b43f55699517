//! Figures of the bicubically blended patch.

use facette::coons::{BicubicPatch, FergusonPatch, hermite_basis as basis};
use facette::mesh::Mesh;
use facette::surface::Surface;
use facette_figure::Figure;
use facette_figure::palette::Colour;
use facette_figure::plot::Plot;
use facette_figure::render::{Material, Picture, Scene, View};
use facette_figure::svg::{Panel, panels};
use glam::DVec3;

use super::shapes::{
    Net, at, bilinear_patch_of, edges_of, mesh, samples, slopes_of, smooth_neighbours,
};

/// Two neighbouring patches with isophotes, and the curve that they share.
fn neighbours(meshes: &[Mesh<DVec3>; 2], below: &Net) -> Picture {
    let view = View::orthographic(at(6., -9., 9.), at(1.5, 0., 0.5), DVec3::Z, 6.2);
    let mut scene = Scene::new(view).tube(&samples(edges_of(below).p2()), 0.025, Colour::Vermilion);
    for mesh in meshes {
        scene = scene.surface(
            mesh,
            Material::isophotes(Colour::Sky, at(0.3, -0.5, 0.8), 40),
        );
    }
    scene.render(750, 760)
}

/// Isophotes across the edge of two bilinear patches, and of two bicubically blended ones.
pub fn crease_and_cure() -> Figure {
    let nets = smooth_neighbours();
    let bilinear = nets.each_ref().map(|net| mesh(&bilinear_patch_of(net)));
    let bicubic = nets
        .each_ref()
        .map(|net| mesh(&BicubicPatch::new(slopes_of(net))));
    let drawing = panels(
        2,
        &[
            Panel::picture("bilinear: a crease", neighbours(&bilinear, &nets[0])),
            Panel::picture(
                "bicubically blended: smooth",
                neighbours(&bicubic, &nets[0]),
            ),
        ],
    );
    Figure::drawn(
        "crease_and_cure",
        "Isophotes, the lines of equal light, on two patches that share the orange curve; all other curves pass smoothly from one \
         patch to the other. On bilinear patches (left) the isophotes break at the orange curve: the normal jumps. On bicubically \
         blended ones that share the derivative across it (right) they run through.",
        "Two striped pictures of a surface of two halves. On the left the stripes are broken at the common curve, on the right \
         each stripe goes on without a break.",
        &drawing,
    )
}

/// Hermite's four cubics.
pub fn hermite_basis() -> Figure {
    let curve = |which: usize| -> Vec<[f64; 2]> {
        let parameters = (0..=80).map(|i| f64::from(i) / 80.0);
        parameters.map(|t| [t, basis(t)[which]]).collect()
    };
    let plot = Plot::new("", "t", "weight")
        .line("value at 0", &curve(0))
        .line("slope at 0", &curve(1))
        .line("slope at 1", &curve(2))
        .line("value at 1", &curve(3))
        .to_drawing()
        .expect("finite weights make a plot");
    Figure::drawn(
        "hermite_basis",
        "Hermite's cubics. Each carries one datum: it has that value or slope at that end, and none of the other three.",
        "Four curves over t from 0 to 1. One falls from 1 to 0 and one rises from 0 to 1, both flat at the ends; one starts at 0 \
         with slope 1 and comes back to 0, one leaves 0 downwards and arrives at 0 with slope 1.",
        &plot,
    )
}

/// A bicubic surface, and the same 16 vectors with the twists set to zero.
pub fn twists() -> Figure {
    let [_, net] = smooth_neighbours();
    let own = FergusonPatch::from_bezier(net).expect("the figure's points are finite");
    let mut vectors = *own.vectors();
    for (i, j) in [(1, 1), (1, 2), (2, 1), (2, 2)] {
        vectors[i][j] = DVec3::ZERO;
    }
    let without = FergusonPatch::new(vectors).expect("zero is finite");
    let view = View::orthographic(at(5., -8., 7.), at(1.5, 1.5, 0.6), DVec3::Z, 4.4);
    let panel = |label, patch: &FergusonPatch<DVec3>| {
        let material = Material::isophotes(Colour::Sky, at(0.3, -0.5, 0.8), 40);
        let [middle, end] = [patch.point(0.5, 0.5), patch.point(1.0, 1.0)];
        debug_assert!(
            middle.is_finite() && end.is_finite(),
            "a patch of finite vectors is finite"
        );
        Panel::picture(
            label,
            Scene::new(view)
                .surface(&mesh(patch), material)
                .render(750, 620),
        )
    };
    Figure::drawn(
        "twists",
        "A bicubic surface (left), and what becomes of it when its four twists are set to zero (right). Positions and slopes at the \
         corners are the same. Compare the far corner on the right: without its twist the tangent plane hardly turns there, and one broad \
         stripe covers it.",
        "Two striped pictures of a wavy patch with the same corners. On the right the stripes are wider next to the corners.",
        &panels(
            2,
            &[
                panel("its own twists", &own),
                panel("twists set to zero", &without),
            ],
        ),
    )
}
