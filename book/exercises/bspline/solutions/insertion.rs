//! A solution of exercise 3: one more knot, the same curve.

use crate::algebra::VectorSpace;
use crate::bspline::KnotVector;
use reference::bspline::find_span;

/// The control points of the same curve with one more knot at `u`.
pub fn insert_knot<P: VectorSpace>(
    knots: &KnotVector<P::Scalar>,
    control_points: &[P],
    u: P::Scalar,
) -> Vec<P> {
    let k = find_span(knots, u);
    let p = knots.degree();
    let u_at = |i: usize| knots.knots()[i];

    let mut points = control_points[..=k - p].to_vec();
    for i in k - p + 1..=k {
        let a = (u - u_at(i)) / (u_at(i + p) - u_at(i));
        points.push(control_points[i - 1].lerp(control_points[i], a));
    }
    points.extend_from_slice(&control_points[k..]);
    points
}
