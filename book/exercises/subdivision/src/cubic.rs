//! Exercise 2: the cubic scheme.
//!
//! Replace `todo!(...)` by your code, save, and run `cargo exercise subdivision/cubic`.

use crate::algebra::{Scalar, VectorSpace};
use crate::subdivision::curve::{Ends, neighbours};

/// The polygon after one round of the cubic scheme:
///
/// ```text
/// for a vertex P with two neighbours     V = 1/8 P- + 6/8 P + 1/8 P+
/// for an edge from P to P+               E = 1/2 P + 1/2 P+
///
/// in the order V0 E0 V1 E1 ...; at an end of Ends::Kept the point itself, of Ends::Open no vertex point
/// ```
///
/// What you can use, besides what exercise 1 lists:
///
/// ```text
/// P::combination([a, b, c], [p, q, r])     the point a p + b q + c r
/// if let Some(next) = next { ... }         carried out where there is such a neighbour
/// ```
pub fn cubic_step<P: VectorSpace>(points: &[P], ends: Ends) -> Vec<P> {
    let mut finer: Vec<P> = Vec::new();
    for (index, &p) in points.iter().enumerate() {
        // The neighbours of p, each of them Some(point) or None.
        let [before, next] = neighbours(points, index, ends);

        todo!("cubic_step: the vertex point of p, then the point of the edge behind it")
    }
    finer
}
