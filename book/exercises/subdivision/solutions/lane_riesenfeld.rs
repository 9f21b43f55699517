//! A solution of exercise 3: doubling and averaging.

use crate::algebra::{Scalar, VectorSpace};

/// The control points of the uniform B-spline of this degree on halved spans.
pub fn double_and_average<P: VectorSpace>(points: &[P], degree: usize) -> Vec<P> {
    let mut finer: Vec<P> = points.iter().flat_map(|&p| [p, p]).collect();
    for _ in 0..degree {
        let midpoint = |pair: &[P]| pair[0].lerp(pair[1], P::Scalar::ratio(1, 2));
        finer = finer.windows(2).map(midpoint).collect();
    }
    finer
}
