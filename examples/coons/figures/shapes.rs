//! The boundaries that the figures show, and how they are lit and seen.

use std::f64::consts::{PI, TAU};

use facette::coons::{Boundary, CoonsPatch, CrossDerivatives, HermiteBoundary};
use facette::curve::{BezierCurve, BoxedCurve, Curve, FunctionCurve, Polyline};
use facette::mesh::{Mesh, tessellate_uniformly};
use facette::surface::Surface;
use facette_figure::palette::Colour;
use facette_figure::render::{Material, Scene, View};
use glam::DVec3;

/// Cells along each side of a surface in a picture.
pub const CELLS: usize = 80;

/// A point from its coordinates.
pub fn at(x: f64, y: f64, z: f64) -> DVec3 {
    DVec3::new(x, y, z)
}

/// A Bézier curve with these control points.
pub fn bezier(points: &[DVec3]) -> BezierCurve<DVec3> {
    BezierCurve::new(points.to_vec()).expect("the figures' points are finite")
}

/// The boundary of four curves of any kind.
pub fn boundary<C: Curve<Scalar = f64, Point = DVec3>>([p1, p2, q1, q2]: [C; 4]) -> Boundary<C> {
    Boundary::new(p1, p2, q1, q2).expect("the figures' curves meet")
}

/// The surface's mesh, fine enough for a picture.
pub fn mesh<S: Surface<Scalar = f64, Point = DVec3>>(surface: &S) -> Mesh<DVec3> {
    tessellate_uniformly(surface, CELLS, CELLS).expect("the figures' surfaces are finite")
}

/// Points on a curve, close enough together to look smooth.
pub fn samples(curve: &impl Curve<Scalar = f64, Point = DVec3>) -> Vec<DVec3> {
    (0..=96)
        .map(|index| curve.point(f64::from(index) / 96.0))
        .collect()
}

/// The chapter's standard boundary, four cubics.
pub fn sail() -> Boundary<BezierCurve<DVec3>> {
    let [a, b, c, d] = [
        at(0., 0., 0.),
        at(4., 0., 0.6),
        at(4.2, 3.2, 0.),
        at(0., 3., 0.8),
    ];
    boundary([
        bezier(&[a, at(1., -0.5, 1.9), at(3., 0.3, -0.7), b]),
        bezier(&[d, at(1.2, 3.5, -0.5), at(2.8, 2.9, 1.9), c]),
        bezier(&[a, at(-0.6, 1., 0.9), at(0.4, 2., 1.3), d]),
        bezier(&[b, at(4.7, 1., 1.6), at(3.6, 2., -0.5), c]),
    ])
}

/// A patch in a scene of its own, with its boundary in two colours.
pub fn scene<C>(surface: &Mesh<DVec3>, edges: &Boundary<C>, view: View, width: f64) -> Scene
where
    C: Curve<Scalar = f64, Point = DVec3>,
{
    let mut scene = Scene::new(view).surface(surface, Material::matte(Colour::Sky).isolines(8));
    for curve in [edges.p1(), edges.p2()] {
        scene = scene.tube(&samples(curve), width, Colour::Blue);
    }
    for curve in [edges.q1(), edges.q2()] {
        scene = scene.tube(&samples(curve), width, Colour::Vermilion);
    }
    scene
}

type Boxed = BoxedCurve<DVec3>;

fn function(point: impl Fn(f64) -> DVec3 + Send + Sync + 'static) -> Boxed {
    Box::new(FunctionCurve::new(point))
}

fn smooth(points: &[DVec3]) -> Boxed {
    Box::new(bezier(points))
}

fn polyline(points: &[DVec3]) -> Boxed {
    Box::new(Polyline::new(points.to_vec()).expect("the figures' points are finite"))
}

/// The gallery: a name and a boundary for each patch. All fit into a box of about 2 by 2 by 1 around the origin.
pub fn gallery() -> [(&'static str, Boundary<Boxed>); 6] {
    [
        ("saddle of four lines", saddle()),
        ("vault of two arches", vault()),
        ("wave", wave()),
        ("folded roof", roof()),
        ("fan with a collapsed side", fan()),
        ("twisted ribbon", ribbon()),
    ]
}

fn saddle() -> Boundary<Boxed> {
    let [a, b, c, d] = [
        at(-1., -1., 0.6),
        at(1., -1., -0.6),
        at(1., 1., 0.6),
        at(-1., 1., -0.6),
    ];
    boundary([
        smooth(&[a, b]),
        smooth(&[d, c]),
        smooth(&[a, d]),
        smooth(&[b, c]),
    ])
}

fn vault() -> Boundary<Boxed> {
    let arch = |y: f64, height: f64| {
        function(move |t| at(-(PI * t).cos(), y, height * (PI * t).sin() - 0.4))
    };
    let line = |x: f64| smooth(&[at(x, -1., -0.4), at(x, 1., -0.4)]);
    boundary([arch(-1., 1.0), arch(1., 0.5), line(-1.), line(1.)])
}

fn wave() -> Boundary<Boxed> {
    let wave =
        |y: f64, phase: f64| function(move |t| at(2. * t - 1., y, 0.3 * (TAU * t + phase).sin()));
    let height = |phase: f64| 0.3 * phase.sin();
    let side = |x: f64| {
        smooth(&[
            at(x, -1., height(0.)),
            at(x, -0.3, 0.7),
            at(x, 0.3, -0.7),
            at(x, 1., height(PI)),
        ])
    };
    boundary([wave(-1., 0.), wave(1., PI), side(-1.), side(1.)])
}

fn roof() -> Boundary<Boxed> {
    let gable = |y: f64| polyline(&[at(-1., y, -0.3), at(0., y, 0.5), at(1., y, -0.3)]);
    let eaves = |x: f64| polyline(&[at(x, -1., -0.3), at(x, 0., -0.6), at(x, 1., -0.3)]);
    boundary([gable(-1.), gable(1.), eaves(-1.), eaves(1.)])
}

fn fan() -> Boundary<Boxed> {
    let apex = at(0., -1., 0.);
    let rim = function(|t| {
        let angle = PI * (0.85 - 0.7 * t);
        at(
            1.5 * angle.cos(),
            1.9 * angle.sin() - 1.,
            0.25 * (6. * PI * t).sin(),
        )
    });
    let [d, c] = [rim.point(0.), rim.point(1.)];
    boundary([
        smooth(&[apex; 2]),
        rim,
        smooth(&[apex, d]),
        smooth(&[apex, c]),
    ])
}

fn ribbon() -> Boundary<Boxed> {
    let rail = |sign: f64| {
        function(move |t| {
            let turn = PI * t;
            at(
                2.4 * t - 1.2,
                0.7 * sign * turn.cos(),
                0.7 * sign * turn.sin(),
            )
        })
    };
    let [low, high] = [rail(-1.), rail(1.)];
    let line = |t: f64| smooth(&[low.point(t), high.point(t)]);
    let ends = [line(0.), line(1.)];
    let [q1, q2] = ends;
    boundary([low, high, q1, q2])
}

/// A net of control points, `net[i][j]` with i along u.
pub type Net = [[DVec3; 4]; 4];

/// Two bicubic surfaces of which the second continues the first smoothly across y = 0.
pub fn smooth_neighbours() -> [Net; 2] {
    const ACROSS: [f64; 4] = [0.0, 1.1, 0.8, 0.1];
    const BELOW: [f64; 4] = [0.0, 0.3, 1.3, 1.5];
    const ABOVE: [f64; 4] = [1.5, 1.7, 0.9, 0.2];
    let net = |heights: &dyn Fn(usize, usize) -> f64, start: f64| {
        let row = |i: usize| std::array::from_fn(|j| at(i as f64, start + j as f64, heights(i, j)));
        std::array::from_fn(row)
    };
    [
        net(&|i, j| ACROSS[i] * BELOW[j], -3.0),
        net(&|i, j| ACROSS[i] * ABOVE[j], 0.0),
    ]
}

/// The four edges of the bicubic surface with this net.
pub fn edges_of(net: &Net) -> Boundary<BezierCurve<DVec3>> {
    let column = |j: usize| bezier(&net.map(|row| row[j]));
    boundary([column(0), column(3), bezier(&net[0]), bezier(&net[3])])
}

/// The edges of that surface with its derivatives across them.
pub fn slopes_of(net: &Net) -> HermiteBoundary<BezierCurve<DVec3>> {
    let across_u = |low: usize| bezier(&net.map(|row| (row[low + 1] - row[low]) * 3.0));
    let across_v = |low: usize| {
        let sides: Vec<_> = (0..4)
            .map(|j| (net[low + 1][j] - net[low][j]) * 3.0)
            .collect();
        bezier(&sides)
    };
    let cross = CrossDerivatives {
        p1_v: across_u(0),
        p2_v: across_u(2),
        q1_u: across_v(0),
        q2_u: across_v(2),
    };
    HermiteBoundary::gregory(edges_of(net), cross).expect("a surface's own slopes fit its edges")
}

/// The bilinear patch of a surface's edges.
pub fn bilinear_patch_of(net: &Net) -> CoonsPatch<BezierCurve<DVec3>> {
    CoonsPatch::new(edges_of(net))
}
