//! Exercise 3: one more knot, the same curve.
//!
//! Replace `todo!(...)` by your code, save, and run `cargo exercise bspline/insertion`.

use crate::algebra::VectorSpace;
use crate::bspline::KnotVector;
// The book's own function, so that this exercise does not wait for the first.
use reference::bspline::find_span;

/// The control points of the same curve when one more knot is put in at `u`, by Boehm's algorithm. One knot more means one
/// control point more: there were `n + 1`, and there will be `n + 2`.
///
/// ```text
/// Q_i = P_i                            for  i = 0, ..., k-p        before the place
/// Q_i = (1 - a) P_(i-1) + a P_i        for  i = k-p+1, ..., k      around it, with  a = (u - u_i) / (u_(i+p) - u_i)
/// Q_i = P_(i-1)                        for  i = k+1, ..., n+1      behind it
/// ```
///
/// `k` is the span of `u`, and `u_i` are the knots as they were before. `u` lies in the domain.
///
/// What you can use:
///
/// ```text
/// knots.degree()                           p
/// knots.knots()[i]                         the knot u_i
/// p.lerp(q, t)                             the point (1-t) p + t q
/// let mut list = list[..=b].to_vec();      a new list with the entries 0, ..., b
/// list.push(point);                        puts a point at its end
/// list.extend_from_slice(&points[a..]);    puts all points from number a on at its end
/// ```
pub fn insert_knot<P: VectorSpace>(
    knots: &KnotVector<P::Scalar>,
    control_points: &[P],
    u: P::Scalar,
) -> Vec<P> {
    // The span k.
    let k = find_span(knots, u);

    todo!("insert_knot: the n + 2 new control points")
}
