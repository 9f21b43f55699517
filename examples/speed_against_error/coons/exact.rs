//! The exact values of a scene: every rounded control point and parameter is a rational number.

use facette::coons::{Boundary, Corners, HermiteBoundary};
use facette::curve::{BezierCurve, Curve};
use num_traits::{One, Zero};

use super::exact_patch::{self, BicubicData, BilinearData};
use super::inputs::Scene;
use crate::common::oracle::{Big, big, big_bernstein, big_bezier, big_combination, big_point};
use crate::float_inputs::{FloatPoint, coordinates};
use crate::harness::ExactPoint;

/// A boundary with slopes, of Bézier curves.
type Data<P> = HermiteBoundary<BezierCurve<P>>;

/// The exact points of the bilinear patches.
pub fn points<P: FloatPoint>(scene: &Scene<P>) -> Vec<ExactPoint> {
    at_all(scene, |data, u, v| {
        vec![exact_patch::bilinear(&bilinear_data(data, u, v), u, v)]
    })
}

/// The exact partial derivatives of the bilinear patches: `S_u`, then `S_v`.
pub fn partials<P: FloatPoint>(scene: &Scene<P>) -> Vec<ExactPoint> {
    at_all(scene, |data, u, v| {
        let [p1, p2, q1, q2] = edges(data.boundary());
        let derivatives = [(p1, u), (p2, u), (q1, v), (q2, v)].map(|(edge, t)| derivative(edge, t));
        exact_patch::partials(&bilinear_data(data, u, v), &derivatives, u, v).into()
    })
}

/// The exact points of the bicubically blended patches.
pub fn bicubic_points<P: FloatPoint>(scene: &Scene<P>) -> Vec<ExactPoint> {
    at_all(scene, |data, u, v| {
        vec![exact_patch::bicubic(&bicubic_data(data, u, v), u, v)]
    })
}

/// The exact points of the edges P1.
pub fn edge_points<P: FloatPoint>(scene: &Scene<P>) -> Vec<ExactPoint> {
    at_all(scene, |data, u, _| vec![point(data.boundary().p1(), u)])
}

/// The exact points of the curves of high degree.
pub fn curve_points<P: FloatPoint>(scene: &Scene<P>) -> Vec<ExactPoint> {
    let curves = scene.curves.iter().zip(&scene.parameters);
    let parameters = curves.flat_map(|(curve, pairs)| pairs.iter().map(move |pair| (curve, pair)));
    parameters
        .map(|(curve, [u, _])| point(curve, &big((*u).into())))
        .collect()
}

/// The points on the edge curves as the library computes them: what a patch without a crack gives there.
pub fn computed_edges<P: FloatPoint>(scene: &Scene<P>) -> Vec<ExactPoint> {
    let edge = |data: &Data<P>, [u, v]: [P::Scalar; 2]| {
        let [p1, p2, q1, q2] = edges(data.boundary());
        if v.is_zero() {
            p1.point(u)
        } else if v.is_one() {
            p2.point(u)
        } else if u.is_zero() {
            q1.point(v)
        } else {
            q2.point(v)
        }
    };
    let patches = scene.hermite.iter().zip(&scene.parameters);
    let points = patches.flat_map(|(data, pairs)| pairs.iter().map(move |&pair| edge(data, pair)));
    points.map(|point| big_point(coordinates(point))).collect()
}

fn at_all<P: FloatPoint>(
    scene: &Scene<P>,
    evaluate: impl Fn(&Data<P>, &Big, &Big) -> Vec<ExactPoint>,
) -> Vec<ExactPoint> {
    let mut exact = Vec::new();
    for (data, pairs) in scene.hermite.iter().zip(&scene.parameters) {
        for &[u, v] in pairs {
            let [u, v] = [u, v].map(|parameter| big(parameter.into()));
            exact.extend(evaluate(data, &u, &v));
        }
    }
    exact
}

fn edges<C: Curve>(boundary: &Boundary<C>) -> [&C; 4] {
    [boundary.p1(), boundary.p2(), boundary.q1(), boundary.q2()]
}

fn control_points<P: FloatPoint>(curve: &BezierCurve<P>) -> Vec<[f64; 3]> {
    curve
        .control_points()
        .iter()
        .map(|&point| coordinates(point))
        .collect()
}

fn point<P: FloatPoint>(curve: &BezierCurve<P>, t: &Big) -> ExactPoint {
    big_bezier(&control_points(curve), t)
}

/// `n Σ Bernstein(n − 1, i) (b_{i+1} − b_i)`.
fn derivative<P: FloatPoint>(curve: &BezierCurve<P>, t: &Big) -> ExactPoint {
    let points: Vec<_> = control_points(curve).into_iter().map(big_point).collect();
    let degree = points.len() - 1;
    let sides = points.windows(2).map(|pair| {
        let [start, end] = [&pair[0], &pair[1]];
        std::array::from_fn(|axis| (&end[axis] - &start[axis]) * Big::from_integer(degree.into()))
    });
    big_combination(&big_bernstein(degree - 1, t), &sides.collect::<Vec<_>>())
}

fn bilinear_data<P: FloatPoint>(data: &Data<P>, u: &Big, v: &Big) -> BilinearData {
    let boundary = data.boundary();
    let [p1, p2, q1, q2] = edges(boundary);
    let Corners { a, b, c, d } = boundary.corners();
    BilinearData {
        edge_points: [point(p1, u), point(p2, u), point(q1, v), point(q2, v)],
        corners: [a, b, c, d].map(|corner| big_point(coordinates(corner))),
    }
}

fn bicubic_data<P: FloatPoint>(data: &Data<P>, u: &Big, v: &Big) -> BicubicData {
    let [p1, p2, q1, q2] = edges(data.boundary());
    let cross = [data.p1_v(), data.p2_v(), data.q1_u(), data.q2_u()];
    let [p1_v, p2_v, q1_u, q2_u] = cross;
    let ends = [Big::zero(), Big::one()];
    let [[p_a, p_b], [p_d, p_c], [q_a, q_d], [q_b, q_c]] =
        cross.map(|curve| ends.each_ref().map(|end| derivative(curve, end)));
    let zero = P::origin().coordinate(0);
    let vectors = data.corner_vectors(zero, zero);
    BicubicData {
        along_u: [p1, p1_v, p2_v, p2].map(|curve| point(curve, u)),
        along_v: [q1, q1_u, q2_u, q2].map(|curve| point(curve, v)),
        vectors: vectors.map(|row| row.map(|vector| big_point(coordinates(vector)))),
        twists_from_p: [p_a, p_b, p_c, p_d],
        twists_from_q: [q_a, q_b, q_c, q_d],
    }
}
