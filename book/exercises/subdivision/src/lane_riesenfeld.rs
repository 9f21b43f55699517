//! Exercise 3: doubling and averaging.
//!
//! Replace `todo!(...)` by your code, save, and run `cargo exercise subdivision/lane_riesenfeld`.

use crate::algebra::{Scalar, VectorSpace};

/// The control points of the uniform B-spline of this degree on halved spans: every point twice, and then `degree` times the midpoints of
/// neighbours.
///
/// ```text
/// degree 1:   P0 P1 P2   ->   P0 P0 P1 P1 P2 P2   ->   P0 (P0+P1)/2 P1 (P1+P2)/2 P2
/// ```
///
/// What you can use, besides what exercise 1 lists:
///
/// ```text
/// for _ in 0..degree { ... }     carried out `degree` times
/// list.windows(2)                the pairs of neighbours in a list; the points of a pair are pair[0] and pair[1]
/// list.len()                     how many points there are
/// ```
pub fn double_and_average<P: VectorSpace>(points: &[P], degree: usize) -> Vec<P> {
    todo!("double_and_average: the points of the refined polygon")
}
