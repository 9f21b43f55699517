//! Figures of rational curves and surfaces: weights, the circle, the sphere.

use facette::bspline::{KnotVector, RationalCurve, circle, sphere};
use facette::curve::Curve;
use facette::mesh::tessellate_uniformly;
use facette_figure::Figure;
use facette_figure::palette::Colour;
use facette_figure::render::{Material, Scene, View};
use facette_figure::svg::{Anchor, Drawing, Panel, Stroke, panels};
use glam::DVec3;

use super::shapes::{Photo, at};

/// From the plane of a curve to a drawing: this many units for one, y upwards.
struct Plane {
    origin: [f64; 2],
    unit: f64,
}

impl Plane {
    fn place(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        [
            self.origin[0] + self.unit * x,
            self.origin[1] - self.unit * y,
        ]
    }

    fn places(&self, points: &[[f64; 2]]) -> Vec<[f64; 2]> {
        points.iter().map(|&point| self.place(point)).collect()
    }

    /// The curve, from samples close enough together to look smooth.
    fn curve(&self, curve: &impl Curve<Scalar = f64, Point = [f64; 2]>) -> Vec<[f64; 2]> {
        let [start, end] = curve.domain();
        let samples = (0..=240).map(|k| curve.point(start + (end - start) * f64::from(k) / 240.0));
        samples.map(|point| self.place(point)).collect()
    }
}

/// One control polygon, several weights of its middle point.
pub fn weights() -> Figure {
    let corners = [[0.0, 0.0], [1.0, 1.0], [2.0, 0.0]];
    let plane = Plane {
        origin: [75.0, 360.0],
        unit: 300.0,
    };
    let thin = Stroke::new(Colour::Ink, 1.4);
    let mut drawing = Drawing::new(750.0, 400.0).polyline(&plane.places(&corners), thin);
    let looks = [
        (0.2, "1/5", Colour::Purple),
        (0.5, "1/2", Colour::Green),
        (1.0, "1", Colour::Blue),
        (2.0, "2", Colour::Orange),
        (5.0, "5", Colour::Vermilion),
    ];
    for (weight, text, colour) in looks {
        let curve = RationalCurve::new(KnotVector::bezier(2), &corners, &[1.0, weight, 1.0])
            .expect("the weights are positive");
        let [x, y] = plane.place(curve.point(0.5));
        drawing = drawing
            .polyline(&plane.curve(&curve), Stroke::new(colour, 2.6))
            .haloed_text(
                [x, y - 7.0],
                &format!("*w*_1 = {text}"),
                17.0,
                Anchor::Middle,
            );
    }
    for (corner, name, down) in [(0, "*P*_0", 30.0), (1, "*P*_1", -14.0), (2, "*P*_2", 30.0)] {
        let [x, y] = plane.place(corners[corner]);
        drawing =
            drawing
                .disc([x, y], 5.0, Colour::Ink)
                .text([x, y + down], name, 18.0, Anchor::Middle);
    }
    Figure::drawn(
        "weights",
        "Quadratic pieces with the same three control points and the weights $1,w_1,1$. With $w_1=1$ it is a parabola, the B-spline; smaller weights give \
         ellipses, larger ones hyperbolas. Each point moves on a straight line towards $P_1$ as the weight grows.",
        "A triangle without its base, and five arches below it from one foot to the other, the higher the larger the weight of the top corner.",
        &drawing,
    )
}

/// The circle, its control points and weights, and points at equal steps of the parameter.
pub fn rational_circle() -> Figure {
    let circle = circle::<f64>();
    let plane = Plane {
        origin: [375.0, 265.0],
        unit: 190.0,
    };
    let control: Vec<_> = circle.homogeneous().control_points().to_vec();
    let corners: Vec<[f64; 2]> = control.iter().map(|point| point.projected()).collect();
    let mut drawing = Drawing::new(750.0, 530.0)
        .polyline(&plane.places(&corners), Stroke::new(Colour::Ink, 1.3))
        .polyline(&plane.curve(&circle), Stroke::new(Colour::Blue, 2.8));
    for step in 0..32 {
        let u = f64::from(step) / 8.0;
        drawing = drawing.disc(plane.place(circle.point(u)), 4.5, Colour::Vermilion);
    }
    for (index, (&corner, point)) in corners.iter().zip(&control).enumerate().take(8) {
        let [x, y] = plane.place(corner);
        drawing = drawing.disc([x, y], 5.0, Colour::Ink);
        let label = if index % 2 == 0 {
            format!("*w* = {}, *u* = {}", point.weight, index / 2)
        } else {
            format!("*w* = {}", point.weight)
        };
        let ([dx, dy], anchor) = match index {
            0 | 1 | 7 => ([14.0, 6.0], Anchor::Start),
            2 => ([0.0, -14.0], Anchor::Middle),
            3..=5 => ([-14.0, 6.0], Anchor::End),
            _ => ([0.0, 28.0], Anchor::Middle),
        };
        drawing = drawing.text([x + dx, y + dy], &label, 18.0, anchor);
    }
    Figure::drawn(
        "rational_circle",
        "The exact circle: four quadratic quarters, each control point with its weight, and the parameters of the joints. The orange points stand at equal steps of $\\tfrac18$ of the \
         parameter; on the circle they crowd towards $(0,\\pm1)$, where the curve is half as fast as at $(\\pm1,0)$.",
        "A circle in a square of eight control points with the weights 1 and, at its top and bottom, 2. Thirty-two dots on the circle are farther apart at \
         the left and right than at the top and bottom.",
        &drawing,
    )
}

/// The sphere with its net, and its pole from above.
pub fn rational_sphere() -> Figure {
    let sphere = sphere::<DVec3>();
    let mesh = tessellate_uniformly(&sphere, 96, 48).expect("the sphere is finite");
    let points: Vec<DVec3> = sphere
        .homogeneous()
        .control_points()
        .iter()
        .map(|point| point.projected())
        .collect();
    let rows = points.chunks(9).map(<[DVec3]>::to_vec);
    let columns = (0..8).map(|i| points.iter().skip(i).step_by(9).copied().collect());
    let net: Vec<Vec<DVec3>> = rows.chain(columns).collect();
    let panel = |label: &str, eye: DVec3, up: DVec3, with_net: bool| {
        let view = View::orthographic(eye, DVec3::ZERO, up, if with_net { 3.5 } else { 2.2 });
        let mut scene = Scene::new(view).surface(&mesh, Material::matte(Colour::Sky).isolines(4));
        if with_net {
            scene = net.iter().fold(scene, |scene, line| {
                scene.tube(line, 0.014, Colour::Vermilion)
            });
            scene = points.iter().fold(scene, |scene, &point| {
                scene.point(point, 0.045, Colour::Vermilion)
            });
        }
        Panel::drawing(label, Photo::new(&scene, [368, 330]).drawing)
    };
    let drawing = panels(
        2,
        &[
            panel("sphere and control net", at(4., -7., 4.), DVec3::Z, true),
            panel(
                "the north pole from above",
                at(0.6, -0.9, 8.),
                DVec3::Y,
                false,
            ),
        ],
    );
    Figure::drawn(
        "rational_sphere",
        "The exact sphere: a circle of $9$ points times a half circle of $5$, with parameter lines at steps of $\\tfrac14$. At a pole all meridians meet, and one of the \
         partial derivatives is zero; the normal is there all the same, so that the shading shows nothing of it.",
        "Left, a sphere in a cube-like net of points. Right, the same sphere seen from above its pole, with meridians that run together in one point and \
         parallels round it; the shading is even.",
        &drawing,
    )
}
