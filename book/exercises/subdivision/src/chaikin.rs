//! Exercise 1: cutting corners.
//!
//! Replace `todo!(...)` by your code, save, and run `cargo exercise subdivision/chaikin`.

use crate::algebra::{Scalar, VectorSpace};
use crate::subdivision::curve::{Ends, edges};

/// The polygon after one round of Chaikin's scheme:
///
/// ```text
/// on the edge from P to P+     Q = 3/4 P + 1/4 P+     R = 1/4 P + 3/4 P+
///
/// Ends::Closed    the last point is joined to the first: the edges include that one
/// Ends::Open      nothing but the points on the edges
/// Ends::Kept      the first point before, the last point behind
/// ```
///
/// What you can use:
///
/// ```text
/// p.lerp(next, t)            the point (1-t) p + t next
/// P::Scalar::ratio(1, 4)     the number 1/4
/// finer.push(p)              puts a point behind the others
/// points.first()             the first point, if there is one;   points.last()  the last
/// finer.extend(...)          pushes all that is given: nothing, one point, many
/// ends == Ends::Kept         whether the ends are to be kept
/// ```
pub fn chaikin_step<P: VectorSpace>(points: &[P], ends: Ends) -> Vec<P> {
    let mut finer: Vec<P> = Vec::new();
    for [p, next] in edges(points, ends) {
        todo!("chaikin_step: the points Q and R of the edge, then the ends")
    }
    finer
}
