//! Figures of triangles on surfaces and in the parameter plane.

use facette::bspline::{BsplineSurface, KnotVector};
use facette::mesh::{Mesh, tessellate_uniformly};
use facette::surface::Surface;
use facette::tessellation::tessellate;
use facette_figure::Figure;
use facette_figure::palette::Colour;
use facette_figure::render::{Scene, View};
use facette_figure::svg::{Drawing, Panel, Stroke, panels};
use glam::DVec3;

use super::wires;

/// The tolerance of the pictures: a fiftieth of a unit.
const TOLERANCE: f64 = 0.02;

/// A bicubic sheet of 6 x 6 spans with one control point raised.
pub fn bump() -> BsplineSurface<DVec3> {
    let breaks: Vec<f64> = (0..=6).map(f64::from).collect();
    let knots = KnotVector::clamped(3, &breaks).expect("the breaks increase");
    let at = knots.greville_abscissae();
    let middle = at.len() / 2;
    let points = (0..at.len()).flat_map(|j| (0..at.len()).map(move |i| (i, j)));
    let points = points
        .map(|(i, j)| DVec3::new(at[i], at[j], if [i, j] == [middle; 2] { 4.0 } else { 0.0 }));
    BsplineSurface::new([knots.clone(), knots.clone()], points.collect())
        .expect("a net of finite points")
}

/// The largest distance between triangles and surface, over a lattice of points of each triangle.
pub fn measured_error(
    surface: &impl Surface<Scalar = f64, Point = DVec3>,
    mesh: &Mesh<DVec3>,
) -> f64 {
    const STEPS: u32 = 4;
    let lattice = (0..=STEPS).flat_map(|i| (0..=STEPS - i).map(move |j| [i, j, STEPS - i - j]));
    let lattice: Vec<[f64; 3]> = lattice
        .map(|parts| parts.map(|part| f64::from(part) / f64::from(STEPS)))
        .collect();
    let mut largest = 0.0_f64;
    for corners in mesh.triangles() {
        for weights in &lattice {
            let (mut u, mut v, mut on_triangle) = (0.0, 0.0, DVec3::ZERO);
            for (weight, vertex) in weights.iter().zip(corners) {
                let [at_u, at_v] = mesh.parameters[vertex as usize];
                u += weight * at_u;
                v += weight * at_v;
                on_triangle += mesh.positions[vertex as usize] * *weight;
            }
            largest = largest.max(surface.point(u, v).distance(on_triangle));
        }
    }
    largest
}

/// The uniform grid with the fewest cells that keeps the tolerance.
fn uniform_within(surface: &BsplineSurface<DVec3>, tolerance: f64) -> Mesh<DVec3> {
    let mesh = |cells| {
        tessellate_uniformly(surface, cells, cells).expect("the figure's surface is finite")
    };
    let fits = |mesh: &Mesh<DVec3>| measured_error(surface, mesh) <= tolerance;
    (1..500)
        .map(mesh)
        .find(fits)
        .expect("a grid of 499 x 499 cells keeps the figures' tolerance")
}

fn adaptive_within(surface: &BsplineSurface<DVec3>, tolerance: f64) -> Mesh<DVec3> {
    tessellate(surface, tolerance)
        .expect("the figure's tolerance is usable")
        .mesh
}

/// The same tolerance, kept by a uniform grid and adaptively.
pub fn adaptive_and_uniform() -> Figure {
    let surface = bump();
    let view = View::orthographic(
        DVec3::new(9., -11., 10.),
        DVec3::new(3., 3., 0.3),
        DVec3::Z,
        5.6,
    );
    let panel = |name: &str, mesh: &Mesh<DVec3>| {
        let label = format!("{name}: {} triangles", mesh.face_count());
        Panel::picture(
            &label,
            wires(Scene::new(view), mesh, Colour::Sky, 0.005).render(1100, 720),
        )
    };
    let drawing = panels(
        2,
        &[
            panel("uniform", &uniform_within(&surface, TOLERANCE)),
            panel("adaptive", &adaptive_within(&surface, TOLERANCE)),
        ],
    );
    Figure::drawn(
        "adaptive_and_uniform",
        "A bump in a plane, cut into triangles that stay within $\\tau=0.02$ of it. The uniform grid (left) is as fine everywhere as the bump needs it; it is the coarsest one that was found to keep $\\tau$ by trying. \
         The adaptive triangles (right) follow the bending, and keep $\\tau$ by a bound, without trying.",
        "Two pictures of a square sheet with a bump in the middle and the edges of its triangles. On the left small triangles cover all of it; on the right they are small on the bump, and two large ones fill each flat square around.",
        &drawing,
    )
}

/// A coarse and a fine piece side by side, joined badly and well.
pub fn crack() -> Figure {
    let point = |u: f64, v: f64| DVec3::new(u, v, -(1.57 * u).sin());
    let view = View::orthographic(
        DVec3::new(2.2, -5., 2.6),
        DVec3::new(1.0, 0.0, -0.5),
        DVec3::Z,
        2.2,
    );
    let strip = |edges: [&[f64]; 2], depths: [f64; 2]| {
        let row = |parameters: &[f64], v: f64| {
            parameters.iter().map(|&u| point(u, v)).collect::<Vec<_>>()
        };
        let [low, high] = [row(edges[0], depths[0]), row(edges[1], depths[1])];
        zip(&low, &high)
    };
    let uniform = |cells: u32| {
        (0..=cells)
            .map(|i| 2.0 * f64::from(i) / f64::from(cells))
            .collect::<Vec<_>>()
    };
    let [coarse, fine] = [uniform(3), uniform(12)];
    let scene = |on_the_line: &[f64]| {
        let scene = Scene::new(view);
        let far = strip([on_the_line, &coarse], [0.0, 1.0]);
        let near = strip([&fine, &fine], [-1.0, 0.0]);
        let scene = wires(scene, &far, Colour::Sky, 0.006);
        wires(scene, &near, Colour::Orange, 0.006).render(900, 640)
    };
    Figure::drawn(
        "crack",
        "A finely cut piece (orange) beside a coarse one (blue). Left: the coarse piece has three segments on the common side, the fine one twelve. The fine one's vertices there stand in the middle of the coarse \
         one's edges (T-junctions), and the background shows between. Right: both have the twelve that the side asks for, and the coarse piece is stitched to them.",
        "Two pictures of a trough made of an orange and a blue half. On the left gaps open between the halves where straight blue edges bridge the curved orange side; on the right blue triangles fan out to every vertex of the orange side.",
        &panels(
            2,
            &[
                Panel::picture("a crack", scene(&coarse)),
                Panel::picture("stitched", scene(&fine)),
            ],
        ),
    )
}

/// Triangles between two rows of points.
fn zip(low: &[DVec3], high: &[DVec3]) -> Mesh<DVec3> {
    let positions: Vec<DVec3> = low.iter().chain(high).copied().collect();
    let start = low.len();
    let (mut faces, mut r, mut l) = (Vec::new(), 0, 0);
    while r + 1 < low.len() || l + 1 < high.len() {
        let is_low = l + 1 == high.len()
            || (r + 1 < low.len() && low[r].x + low[r + 1].x <= high[l].x + high[l + 1].x);
        let face = if is_low {
            [r, r + 1, start + l]
        } else {
            [r, start + l + 1, start + l]
        };
        faces.push(face.map(|vertex| u32::try_from(vertex).unwrap_or(u32::MAX)));
        if is_low { r += 1 } else { l += 1 }
    }
    let mut mesh = Mesh::new(positions, faces).expect("the figure's points are finite");
    mesh.normals = mesh.vertex_normals();
    mesh
}

/// The triangles of the bump, and of a twisted square, in the parameter plane.
pub fn triangles_in_the_parameter_plane() -> Figure {
    let twist = BsplineSurface::new(
        [KnotVector::bezier(1), KnotVector::bezier(1)],
        vec![DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::ONE],
    );
    let twist = twist.expect("four corners");
    let drawn = |surface: &BsplineSurface<DVec3>, tolerance: f64| {
        let mesh = adaptive_within(surface, tolerance);
        let [[_, u1], [_, v1]] = surface.domain();
        let at = |vertex: u32| {
            let [u, v] = mesh.parameters[vertex as usize];
            [10.0 + 330.0 * u / u1, 340.0 - 330.0 * v / v1]
        };
        mesh.triangles()
            .fold(Drawing::new(350.0, 350.0), |drawing, corners| {
                drawing.outline(&corners.map(at), Stroke::new(Colour::Ink, 0.8))
            })
    };
    Figure::drawn(
        "triangles_in_the_parameter_plane",
        "Triangles in the parameter plane. Left, the bump of the first figure: each piece has a grid of its own, stitched to what stands on its sides; flat pieces have two triangles. Right, the twisted square $(u,v,uv)$ with $\\tau=0.002$: its sides are straight lines and stay whole, \
         and the triangles beside them are cut until they are thin enough.",
        "Two squares with triangles. The left one is divided into six by six squares, with grids in the middle ones and one diagonal in the outer ones. The right one has a regular pattern inside and long thin triangles along its four sides, which have no vertex but their ends.",
        &panels(
            2,
            &[
                Panel::drawing("the bump", drawn(&bump(), TOLERANCE)),
                Panel::drawing("a twist", drawn(&twist, 0.002)),
            ],
        ),
    )
}
