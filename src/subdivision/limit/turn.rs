//! Points on the unit circle, and tables of them.

use std::collections::HashMap;

use crate::algebra::{Real, Scalar};
use crate::subdivision::mask::turn_cosine;

/// The point of the unit circle after k of n equal parts of a turn: cos(2πk/n) and sin(2πk/n), exact wherever they are rational.
///
/// # Accuracy
///
/// Each within 3u of the true value, relatively.
pub fn turn_point<S: Real>(k: usize, n: usize) -> [S; 2] {
    // sin(x) = cos(x − π/2): a quarter of a turn less is three quarters more.
    [turn_cosine(k, n), turn_cosine(4 * (k % n) + 3 * n, 4 * n)]
}

/// The directions of the spokes around a vertex, kept for each number of parts.
pub(super) struct Spokes<S, F> {
    circle: F,
    tables: HashMap<usize, Vec<[S; 2]>>,
}

impl<S: Scalar, F: Fn(usize, usize) -> [S; 2]> Spokes<S, F> {
    pub fn new(circle: F) -> Self {
        Self {
            circle,
            tables: HashMap::new(),
        }
    }

    /// All points of a turn in `n` parts.
    pub fn of(&mut self, n: usize) -> &[[S; 2]] {
        let circle = &self.circle;
        self.tables
            .entry(n)
            .or_insert_with(|| (0..n).map(|k| circle(k, n)).collect())
    }
}
