//! A solution of exercise 2: the cubic scheme.

use crate::algebra::{Scalar, VectorSpace};
use crate::subdivision::curve::{Ends, neighbours};

/// The polygon after one round of the cubic scheme.
pub fn cubic_step<P: VectorSpace>(points: &[P], ends: Ends) -> Vec<P> {
    let eighth = P::Scalar::ratio(1, 8);
    let mut finer: Vec<P> = Vec::new();
    for (index, &p) in points.iter().enumerate() {
        // The neighbours of p, each of them Some(point) or None.
        let [before, next] = neighbours(points, index, ends);

        if let (Some(before), Some(next)) = (before, next) {
            let weights = [eighth, P::Scalar::ratio(6, 8), eighth];
            finer.push(P::combination(weights, [before, p, next]));
        } else if ends == Ends::Kept {
            finer.push(p);
        }
        if let Some(next) = next {
            finer.push(p.lerp(next, P::Scalar::ratio(1, 2)));
        }
    }
    finer
}
