//! Boundaries in floating point, ordinary and hard. They are drawn in `f64` and rounded to the type under test, so that
//! curves that share a corner share it exactly.

use facette::algebra::{Scalar, VectorSpace};
use facette::coons::{Boundary, CrossDerivatives, HermiteBoundary};
use facette::curve::{BezierCurve, Curve};
use num_traits::AsPrimitive;
use proptest::collection::vec;
use proptest::prelude::*;

use crate::common::generators::{
    float_coordinate, float_parameter, hard_float_coordinate, hard_float_parameter,
};

/// A point type whose coordinates are `f32` or `f64`.
pub trait FloatPoint: VectorSpace<Scalar: Into<f64>> {
    /// The nearest point of this type.
    fn rounded(point: [f64; 3]) -> Self;
}

impl<S: Scalar + Into<f64>> FloatPoint for [S; 3]
where
    f64: AsPrimitive<S>,
{
    fn rounded(point: [f64; 3]) -> Self {
        point.map(AsPrimitive::as_)
    }
}

impl FloatPoint for glam::DVec3 {
    fn rounded(point: [f64; 3]) -> Self {
        Self::from_array(point)
    }
}

impl FloatPoint for glam::Vec3A {
    fn rounded(point: [f64; 3]) -> Self {
        Self::from_array(<[f32; 3]>::rounded(point))
    }
}

/// The scalar nearest to `value`.
pub fn rounded<P: FloatPoint>(value: f64) -> P::Scalar {
    P::rounded([value; 3]).coordinate(0)
}

/// The coordinates of a point, without change.
pub fn coordinates<P: FloatPoint>(point: P) -> [f64; 3] {
    [0, 1, 2].map(|axis| point.coordinate(axis).into())
}

/// A boundary, slopes across it, and a pair of parameters.
#[derive(Clone, Debug)]
pub struct FloatPlace {
    /// The corners A, B, C, D.
    pub corners: [[f64; 3]; 4],
    /// The inner control points of P1, P2, Q1, Q2.
    pub inner: [Vec<[f64; 3]>; 4],
    /// The inner control points of the four cross derivatives.
    pub slopes: [Vec<[f64; 3]>; 4],
    /// The parameters u and v.
    pub parameters: [f64; 2],
}

impl FloatPlace {
    /// The parameters, rounded.
    pub fn parameters<P: FloatPoint>(&self) -> [P::Scalar; 2] {
        self.parameters.map(rounded::<P>)
    }

    /// The boundary, rounded.
    pub fn boundary<P: FloatPoint>(&self) -> Boundary<BezierCurve<P>> {
        let [a, b, c, d] = self.corners.map(P::rounded);
        let ends = [[a, b], [d, c], [a, d], [b, c]];
        let [p1, p2, q1, q2] = curves(ends, &self.inner);
        Boundary::new(p1, p2, q1, q2).expect("edges through the same corners")
    }

    /// The boundary with slopes across it that fit at the corners; its twists do not, in general.
    pub fn hermite<P: FloatPoint>(&self) -> HermiteBoundary<BezierCurve<P>> {
        let boundary = self.boundary::<P>();
        let edges = [boundary.p1(), boundary.p2(), boundary.q1(), boundary.q2()];
        let [[p1_a, p1_b], [p2_d, p2_c], [q1_a, q1_d], [q2_b, q2_c]] = edges.map(|curve| {
            [0, 1].map(|end| {
                let derivative = curve.derivative(P::Scalar::from_i32(end));
                derivative.expect("a Bézier curve has one")
            })
        });
        let ends = [[q1_a, q2_b], [q1_d, q2_c], [p1_a, p2_d], [p1_b, p2_c]];
        let [p1_v, p2_v, q1_u, q2_u] = curves(ends, &self.slopes);
        let cross = CrossDerivatives {
            p1_v,
            p2_v,
            q1_u,
            q2_u,
        };
        HermiteBoundary::gregory(boundary, cross).expect("slopes that fit")
    }
}

fn curves<P: FloatPoint>(ends: [[P; 2]; 4], inner: &[Vec<[f64; 3]>; 4]) -> [BezierCurve<P>; 4] {
    std::array::from_fn(|index| {
        let [start, end] = ends[index];
        let inner = inner[index].iter().map(|&point| P::rounded(point));
        let points = std::iter::once(start).chain(inner).chain([end]);
        BezierCurve::new(points.collect()).expect("finite points")
    })
}

fn places_of(
    coordinate: impl Strategy<Value = f64> + Clone,
    parameter: impl Strategy<Value = f64> + Clone,
) -> impl Strategy<Value = FloatPlace> {
    let point = [coordinate.clone(), coordinate.clone(), coordinate];
    let corners = [point.clone(), point.clone(), point.clone(), point.clone()];
    let inner = vec(point, 0..=3);
    let four = [inner.clone(), inner.clone(), inner.clone(), inner];
    (corners, four.clone(), four, [parameter.clone(), parameter]).prop_map(
        |(corners, inner, slopes, parameters)| FloatPlace {
            corners,
            inner,
            slopes,
            parameters,
        },
    )
}

/// Boundaries of ordinary size, of curves of degree 1 to 4, and parameters with all bits in use.
pub fn float_places() -> impl Strategy<Value = FloatPlace> {
    places_of(float_coordinate().boxed(), float_parameter().boxed())
}

/// Boundaries far from the origin, tiny, huge, or with coordinates of all these sizes; parameters at the ends or next to them.
pub fn hard_float_places() -> impl Strategy<Value = FloatPlace> {
    let far = (-1.0..1.0_f64).prop_map(|offset| 1e8 + offset).boxed();
    let tiny = (-1.0..1.0_f64).prop_map(|factor| factor * 1e-30).boxed();
    let huge = (-1.0..1.0_f64).prop_map(|factor| factor * 1e30).boxed();
    let mixed = hard_float_coordinate().boxed();
    let of = |coordinate: BoxedStrategy<f64>| {
        let parameter = prop_oneof![hard_float_parameter(), float_parameter()].boxed();
        places_of(coordinate, parameter)
    };
    prop_oneof![of(far), of(tiny), of(huge), of(mixed)]
}
