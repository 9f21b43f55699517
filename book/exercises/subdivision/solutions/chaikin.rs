//! A solution of exercise 1: cutting corners.

use crate::algebra::{Scalar, VectorSpace};
use crate::subdivision::curve::{Ends, edges};

/// The polygon after one round of Chaikin's scheme.
pub fn chaikin_step<P: VectorSpace>(points: &[P], ends: Ends) -> Vec<P> {
    let mut finer: Vec<P> = Vec::new();
    if ends == Ends::Kept {
        finer.extend(points.first());
    }
    for [p, next] in edges(points, ends) {
        finer.push(p.lerp(next, P::Scalar::ratio(1, 4)));
        finer.push(p.lerp(next, P::Scalar::ratio(3, 4)));
    }
    if ends == Ends::Kept {
        finer.extend(points.last());
    }
    finer
}
