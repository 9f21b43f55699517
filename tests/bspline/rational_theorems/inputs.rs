//! Curves and surfaces with weights.

use facette::algebra::Scalar;
use facette::bspline::{
    BsplineCurve, Homogeneous, KnotVector, RationalCurve, RationalSurface, circle,
};
use proptest::collection::vec;
use proptest::prelude::*;

use crate::common::dual::{Dual, constant};
use crate::common::exact::{Exact, fraction};
use crate::common::generators::{parameter, point};

/// A point of space over the rationals.
pub type Point = [Exact; 3];

/// A whole number.
pub fn integer(value: i32) -> Exact {
    fraction(value, 1)
}

/// An ordinary weight.
pub fn weight() -> impl Strategy<Value = Exact> {
    (1..6_i32, 1..4_i32).prop_map(|(numerator, denominator)| fraction(numerator, denominator))
}

/// A weight that is much larger or smaller than the others.
pub fn hard_weight() -> impl Strategy<Value = Exact> {
    prop::sample::select(vec![fraction(1, 1), fraction(1, 100), fraction(100, 1)])
}

/// Seven control points with weights, and a parameter.
pub fn places() -> impl Strategy<Value = (Vec<Point>, Vec<Exact>, Exact)> {
    (vec(point(), 7), vec(weight(), 7), parameter())
}

/// As [`places`], at an end or in a corner of the domain, with weights of very different size.
pub fn hard_places() -> impl Strategy<Value = (Vec<Point>, Vec<Exact>, Exact)> {
    let inside = prop::sample::select(vec![
        integer(0),
        integer(1),
        fraction(1, 2),
        fraction(1, 1 << 30),
    ]);
    (vec(point(), 7), vec(hard_weight(), 7), inside)
}

/// Cubic knots on `[0, 1]` for seven control points, with a double knot at ½.
pub fn knots() -> KnotVector<Exact> {
    let breaks = [(0, 1), (1, 4), (1, 2), (1, 2), (1, 1)].map(|(a, b)| fraction(a, b));
    KnotVector::clamped(3, &breaks).expect("increasing knots")
}

/// The rational cubic of these points and weights.
pub fn curve(points: &[Point], weights: &[Exact]) -> RationalCurve<Point> {
    RationalCurve::new(knots(), points, weights).expect("positive weights")
}

/// The curve over numbers that carry a derivative; at both levels the knots, points and weights do not vary.
pub fn dual_curve<S: Scalar>(curve: &RationalCurve<[S; 3]>) -> RationalCurve<[Dual<S>; 3]> {
    let homogeneous = curve.homogeneous();
    let knots = homogeneous
        .knots()
        .knots()
        .iter()
        .map(|&knot| constant(knot))
        .collect();
    let knots = KnotVector::new(homogeneous.degree(), knots).expect("the same order");
    let points = homogeneous
        .control_points()
        .iter()
        .map(|point| Homogeneous {
            weighted: point.weighted.map(constant),
            weight: constant(point.weight),
        });
    let homogeneous = BsplineCurve::new(knots, points.collect()).expect("the same numbers");
    RationalCurve::from_homogeneous(homogeneous).expect("the same weights")
}

/// A surface of degrees 2 and 2 with 4 x 3 control points, over numbers of any kind.
pub fn surface<S: Scalar>(
    points: &[Point],
    weights: &[Exact],
    number: impl Fn(Exact) -> S,
) -> RationalSurface<[S; 3]> {
    let numbers = |values: &[Exact]| {
        values
            .iter()
            .map(|&value| number(value))
            .collect::<Vec<S>>()
    };
    let breaks = numbers(&[integer(0), fraction(1, 2), integer(1)]);
    let knots = [
        KnotVector::clamped(2, &breaks).expect("increasing"),
        KnotVector::bezier(2),
    ];
    let points: Vec<[S; 3]> = points.iter().map(|point| point.map(&number)).collect();
    RationalSurface::new(knots, &points, &numbers(weights)).expect("positive weights")
}

/// The pieces of the circle, each a rational curve of its own on `[0, 1]`.
pub fn quarters() -> Vec<RationalCurve<[Exact; 2]>> {
    let pieces = circle::<Exact>().homogeneous().bezier_pieces();
    let quarter =
        |points: &[_]| BsplineCurve::new(KnotVector::bezier(2), points.to_vec()).expect("finite");
    let curves = pieces
        .iter()
        .map(|piece| quarter(piece.curve.control_points()));
    curves
        .map(|curve| RationalCurve::from_homogeneous(curve).expect("positive"))
        .collect()
}

/// Parameters of the sphere, its poles and seam among the hard ones.
pub fn sphere_places(hard: bool) -> impl Strategy<Value = (Exact, Exact)> {
    let around = (0..=48_i32).prop_map(|part| fraction(part, 12));
    let up = (0..=24_i32).prop_map(|part| fraction(part, 12));
    let ends = prop::sample::select(vec![fraction(0, 1), fraction(1, 1 << 20), fraction(2, 1)]);
    let up = if hard { ends.boxed() } else { up.boxed() };
    (around, up)
}
