//! Figures of the bilinear patch.

use facette::algebra::VectorSpace;
use facette::coons::{Boundary, CoonsPatch, bilinear_point, ruled_surfaces as ruled_points};
use facette::curve::{BezierCurve, Curve};
use facette::surface::Surface;
use facette_figure::palette::Colour;
use facette_figure::plot::Plot;
use facette_figure::render::{Scene, View};
use facette_figure::svg::{Anchor, Drawing, Panel, panels};
use facette_figure::{Figure, speed};
use glam::DVec3;

use super::shapes::{at, bezier, boundary, gallery as shapes, mesh, sail, samples, scene};

/// The view of the standard boundary.
fn sail_view() -> View {
    View::orthographic(at(10., -9., 8.), at(2.1, 1.5, 0.5), DVec3::Z, 4.6)
}

/// Four curves, their names and their corners.
pub fn four_curves() -> Figure {
    let [width, height] = [750, 460];
    let edges = sail();
    let corners = edges.corners();
    let mut scene = Scene::new(sail_view());
    for (curve, colour) in [
        (edges.p1(), Colour::Blue),
        (edges.p2(), Colour::Blue),
        (edges.q1(), Colour::Vermilion),
        (edges.q2(), Colour::Vermilion),
    ] {
        scene = scene.tube(&samples(curve), 0.03, colour);
    }
    for corner in [corners.a, corners.b, corners.c, corners.d] {
        scene = scene.point(corner, 0.07, Colour::Green);
    }
    let picture = scene.render(2 * width, 2 * height);
    let size = [f64::from(width), f64::from(height)];
    let mut drawing = Drawing::new(size[0], size[1]).picture([0., 0.], size, &picture);
    let labels = [
        ("*A*", corners.a, [-16., 24.]),
        ("*B*", corners.b, [4., 28.]),
        ("*C*", corners.c, [20., 4.]),
        ("*D*", corners.d, [-8., -14.]),
        ("*P*_1(*u*)", edges.p1().point(0.5), [-36., 36.]),
        ("*P*_2(*u*)", edges.p2().point(0.5), [10., -22.]),
        ("*Q*_1(*v*)", edges.q1().point(0.5), [-30., -18.]),
        ("*Q*_2(*v*)", edges.q2().point(0.5), [48., 40.]),
    ];
    for (label, point, [right, down]) in labels {
        if let Some([x, y]) = sail_view().project(point, width, height) {
            drawing = drawing.text([x + right, y + down], label, 19., Anchor::Middle);
        }
    }
    let alternative = "Four curves in space that meet in four marked corners. P1 leads from A to B in front, P2 from D to \
                       C behind, Q1 from A to D on the left, Q2 from B to C on the right.";
    Figure::drawn(
        "four_curves",
        "What is given: the curves $P_1$ and $P_2$ in $u$ (blue), $Q_1$ and $Q_2$ in $v$ (orange), and the corners \
         $A=S(0,0)$, $B=S(1,0)$, $C=S(1,1)$, $D=S(0,1)$ in which they meet.",
        alternative,
        &drawing,
    )
}

/// One of the three ruled surfaces, by its number.
struct RuledSurface<'a>(&'a Boundary<BezierCurve<DVec3>>, usize);

impl Surface for RuledSurface<'_> {
    type Scalar = f64;
    type Point = DVec3;

    fn domain(&self) -> [[f64; 2]; 2] {
        [[0.0, 1.0]; 2]
    }

    fn point(&self, u: f64, v: f64) -> DVec3 {
        ruled_points(self.0, u, v)[self.1]
    }

    fn partials(&self, _: f64, _: f64) -> Option<[DVec3; 2]> {
        None
    }
}

/// The three ruled surfaces and the patch, as a sum.
pub fn ruled_surfaces() -> Figure {
    let edges = sail();
    let panel = |label: &str, mesh| {
        Panel::picture(
            label,
            scene(&mesh, &edges, sail_view(), 0.035).render(750, 520),
        )
    };
    let [s1, s2, s3] = [0, 1, 2].map(|which| mesh(&RuledSurface(&edges, which)));
    let patch = mesh(&CoonsPatch::new(edges.clone()));
    let drawing = panels(
        2,
        &[
            panel("*S*_1 joins *P*_1 and *P*_2", s1),
            panel("plus *S*_2, which joins *Q*_1 and *Q*_2", s2),
            panel("minus *S*_3, which joins the corners", s3),
            panel("makes *S*, which carries all four curves", patch),
        ],
    );
    Figure::drawn(
        "ruled_surfaces",
        "$S_1$ follows the blue curves and joins their ends by straight lines instead of the orange ones, $S_2$ the other way round; \
         the bilinear surface $S_3$ meets the corners alone. $S=S_1+S_2-S_3$ meets all four.",
        "Four surfaces with their parameter lines over the same four boundary curves. The first follows the two blue curves, \
         the second the two orange ones, the third only the four corners, the fourth all four curves.",
        &drawing,
    )
}

/// What four curves can do.
pub fn gallery() -> Figure {
    let view = View::orthographic(at(4., -6., 4.5), at(0., 0., 0.), DVec3::Z, 2.9);
    let panel = |(name, edges): (&str, Boundary<_>)| {
        let patch = CoonsPatch::new(edges);
        Panel::picture(
            name,
            scene(&mesh(&patch), patch.boundary(), view, 0.025).render(500, 400),
        )
    };
    Figure::drawn(
        "gallery",
        "Six bilinear patches. The boundary may be straight, smooth or broken, and a side may shrink to a point; the folds \
         of the roof run on into its interior.",
        "Six pictures: a saddle between four lines, a vault over a high and a low arch, a wave, a roof with folds, a fan whose \
         front side is one point, and a ribbon that turns by half a turn.",
        &panels(3, &shapes().map(panel)),
    )
}

/// Four arches, and a middle that is twice as high.
pub fn outside_the_hull() -> Figure {
    let arch = |a: DVec3, b: DVec3| bezier(&[a, (a + b) / 2.0 + DVec3::Z * 2.0, b]);
    let [a, b, c, d] = [
        at(0., 0., 0.),
        at(1., 0., 0.),
        at(1., 1., 0.),
        at(0., 1., 0.),
    ];
    let edges = boundary([arch(a, b), arch(d, c), arch(a, d), arch(b, c)]);
    let view = View::orthographic(at(5., -8., 4.), at(0.5, 0.5, 0.85), DVec3::Z, 2.9);
    let patch = mesh(&CoonsPatch::new(edges.clone()));
    let picture = scene(&patch, &edges, view, 0.02).render(1100, 560);
    let height = |u: f64, v: f64| [u, bilinear_point(&edges, u, v).z];
    let section = |v: f64| -> Vec<_> { (0..=60).map(|i| height(f64::from(i) / 60.0, v)).collect() };
    let plot = Plot::new("", "u", "height z")
        .height(300.)
        .line("middle, v = 1/2", &section(0.5))
        .line("boundary, v = 0", &section(0.0))
        .to_drawing()
        .expect("finite heights make a plot");
    Figure::drawn(
        "outside_the_hull",
        "Four arches of height 1 over a square: their patch is 2 high in the middle, far outside the convex hull of its \
         boundary.",
        "Above: a dome over four arches, higher than any of them. Below: two parabolas over u, the boundary with its top at 1 and \
         the section through the middle, which starts at 1 and has its top at 2.",
        &panels(1, &[Panel::picture("", picture), Panel::drawing("", plot)]),
    )
}

/// How far two ways to add three numbers miss the boundary, in single precision.
pub fn missed_edges() -> Figure {
    const SAMPLES: u16 = 240;
    let single = |curve: &BezierCurve<DVec3>| {
        let points = curve
            .control_points()
            .iter()
            .map(|point| point.as_vec3().to_array());
        BezierCurve::new(points.collect()).expect("the figure's points are finite")
    };
    let edges = sail();
    let [p1, p2, q1, q2] = [edges.p1(), edges.p2(), edges.q1(), edges.q2()].map(single);
    let edges = Boundary::new(p1, p2, q1, q2).expect("rounding moves equal corners alike");
    let miss =
        |point: [f32; 3], curve: [f32; 3]| f64::from(point.minus(curve).largest_coordinate());
    let along = |miss: &dyn Fn(f32) -> f64| -> Vec<[f64; 2]> {
        let parameters = (0..=SAMPLES).map(|i| f32::from(i) / f32::from(SAMPLES));
        parameters.map(|v| [f64::from(v), miss(v) * 1e7]).collect()
    };
    let direct = along(&|v| {
        let [s1, s2, s3] = ruled_points(&edges, 1.0, v);
        miss(s1.plus(s2).minus(s3), edges.q2().point(v))
    });
    let library = along(&|v| miss(bilinear_point(&edges, 1.0, v), edges.q2().point(v)));
    let plot = Plot::new(
        "",
        "v along the edge u = 1",
        "distance from Q2, in units of 1e-7",
    )
    .points("added from the left", &direct)
    .points("rounding errors carried along", &library)
    .to_drawing()
    .expect("finite distances make a plot");
    Figure::drawn(
        "missed_edges",
        "How far a patch of `f32` points, about four units wide, misses its own edge $Q_2$. Added from the left, $S_1+S_2-S_3$ \
         misses it at almost all parameters, by up to $4.8\\cdot10^{-7}$, two ulps of a coordinate near 4; with the rounding errors \
         carried along it is met everywhere.",
        "A scatter of distances over the parameter v. The points of the plain sum lie at several levels up to a few times ten to \
         the minus seven, those of the compensated sum all at zero.",
        &plot,
    )
}

/// The chapter's measurements.
pub fn speed_against_error() -> Figure {
    let committed = include_str!("../../../book/measurements/coons.csv");
    speed::of_chapter("coons", committed).expect("the committed measurements can be read")
}
