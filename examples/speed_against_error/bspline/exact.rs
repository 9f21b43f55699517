//! The exact values of a scene: every rounded knot, control point and parameter is a rational number.

use facette::algebra::{VectorSpace, unit_vector};
use facette::bspline::{BsplineCurve, BsplineSurface, Direction, KnotVector, find_span};
use num_traits::ToPrimitive;

use super::inputs::Number;
use crate::common::oracle::{Big, big, big_bspline_basis, big_combination, big_point};
use crate::harness::ExactPoint;

/// The basis functions of degree `degree` on the span of `u` that may differ from 0, and the number of the first of them.
fn local_basis<S: Number>(knots: &KnotVector<S>, degree: usize, u: S) -> (usize, Vec<Big>) {
    let span = find_span(knots, u);
    let stored = &knots.knots()[span - degree..=span + degree + 1];
    let stored: Vec<f64> = stored.iter().map(|&knot| knot.into()).collect();
    let [_, end] = knots.domain();
    let basis = big_bspline_basis(degree, &stored, &big(u.into()), end.into());
    (span - degree, basis)
}

fn wide<S: Number>(point: [S; 3]) -> ExactPoint {
    big_point(point.map(Into::into))
}

/// The exact point of a curve.
pub fn curve_point<S: Number>(curve: &BsplineCurve<[S; 3]>, u: S) -> ExactPoint {
    let (first, basis) = local_basis(curve.knots(), curve.degree(), u);
    let points = &curve.control_points()[first..first + basis.len()];
    let points: Vec<_> = points.iter().map(|&point| wide(point)).collect();
    big_combination(&basis, &points)
}

/// The exact point of a surface.
pub fn point<S: Number>(surface: &BsplineSurface<[S; 3]>, [u, v]: [S; 2]) -> ExactPoint {
    derivative(surface, [u, v], None)
}

/// The exact partial derivatives `[S_u, S_v]`.
pub fn partials<S: Number>(surface: &BsplineSurface<[S; 3]>, at: [S; 2]) -> [ExactPoint; 2] {
    [Direction::U, Direction::V].map(|direction| derivative(surface, at, Some(direction)))
}

/// The unit normal, rounded to `f64` at the end.
pub fn normal<S: Number>(surface: &BsplineSurface<[S; 3]>, at: [S; 2]) -> ExactPoint {
    let [a, b] = partials(surface, at);
    let minor = |i: usize, j: usize| &a[i] * &b[j] - &a[j] * &b[i];
    let normal = [minor(1, 2), minor(2, 0), minor(0, 1)];
    let normal = normal.map(|coordinate| coordinate.to_f64().unwrap_or(f64::NAN));
    big_point(unit_vector(normal).unwrap_or(VectorSpace::origin()))
}

/// The point, or the derivative in one direction: in that one the weights are `p (N_{i-1} / (u_{i+p-1} - u_{i-1}) - N_i / ...)` of the degree below.
fn derivative<S: Number>(
    surface: &BsplineSurface<[S; 3]>,
    [u, v]: [S; 2],
    along: Option<Direction>,
) -> ExactPoint {
    let weights = |direction: Direction, u: S| {
        let knots = surface.knots(direction);
        if along == Some(direction) {
            derivative_weights(knots, u)
        } else {
            local_basis(knots, knots.degree(), u)
        }
    };
    let (first_u, in_u) = weights(Direction::U, u);
    let (first_v, in_v) = weights(Direction::V, v);
    let (mut products, mut points) = (Vec::new(), Vec::new());
    for (j, b) in in_v.iter().enumerate() {
        for (i, a) in in_u.iter().enumerate() {
            products.push(a * b);
            points.push(wide(surface.control_point(first_u + i, first_v + j)));
        }
    }
    big_combination(&products, &points)
}

/// The derivatives of the basis functions on the span of `u`, and the number of the first.
fn derivative_weights<S: Number>(knots: &KnotVector<S>, u: S) -> (usize, Vec<Big>) {
    let degree = knots.degree();
    let (first, lower) = local_basis(knots, degree - 1, u);
    let knot = |index: usize| big(knots.knots()[index].into());
    let slopes: Vec<Big> = lower
        .iter()
        .enumerate()
        .map(|(k, value)| value * big(degree as f64) / (knot(first + k + degree) - knot(first + k)))
        .collect();
    let weight = |i: usize| {
        let left = i
            .checked_sub(1)
            .map_or_else(|| big(0.0), |i| slopes[i].clone());
        let right = slopes.get(i).cloned().unwrap_or_else(|| big(0.0));
        left - right
    };
    (first - 1, (0..=degree).map(weight).collect())
}
