//! A regular triangle: a patch of the quartic box spline, from the 12 points of the triangles around it, as a Bézier triangle.
//!
//! ```text
//!        10 --- 11
//!       /  \   /  \           the triangle is (4, 5, 8): A, B, C
//!      7 --- 8 --- 9
//!     /  \  /  \  /  \        in steps along AB and AC the points are at
//!    3 --- 4 --- 5 --- 6      (0,−1) (1,−1) (2,−1)   (−1,0) (0,0) (1,0) (2,0)
//!     \  /  \  /  \  /        (−1,1) (0,1) (1,1)     (−1,2) (0,2)
//!      0 --- 1 --- 2
//! ```
//!
//! # Sources
//!
//! M. Sabin, *The use of piecewise forms for the numerical representation of shape*, 1977 (the box spline); M. Lai, *Fortran subroutines for
//! B-nets of box splines on three- and four-directional meshes*, 1992 (its Bézier points); J. Stam, *Evaluation of Loop subdivision surfaces*, 1998.

use super::jet::ORDERS;
use crate::algebra::{Scalar, VectorSpace};

/// Where the twelve points lie, in steps along AB and AC.
pub(super) const PLACES: [[isize; 2]; 12] = [
    [0, -1],
    [1, -1],
    [2, -1],
    [-1, 0],
    [0, 0],
    [1, 0],
    [2, 0],
    [-1, 1],
    [0, 1],
    [1, 1],
    [-1, 2],
    [0, 2],
];

/// What the twelve points weigh in the Bézier points, in 24ths.
#[rustfmt::skip]
const BEZIER: [[i32; 12]; 15] = [
    [ 2,  2,  0,  2, 12,  2,  0,  2,  2,  0,  0,  0],
    [ 1,  3,  0,  0, 12,  4,  0,  1,  3,  0,  0,  0],
    [ 0,  4,  0,  0,  8,  8,  0,  0,  4,  0,  0,  0],
    [ 0,  3,  1,  0,  4, 12,  0,  0,  3,  1,  0,  0],
    [ 0,  2,  2,  0,  2, 12,  2,  0,  2,  2,  0,  0],
    [ 0,  1,  0,  1, 12,  3,  0,  3,  4,  0,  0,  0],
    [ 0,  1,  0,  0, 10,  6,  0,  1,  6,  0,  0,  0],
    [ 0,  1,  0,  0,  6, 10,  0,  0,  6,  1,  0,  0],
    [ 0,  1,  0,  0,  3, 12,  1,  0,  4,  3,  0,  0],
    [ 0,  0,  0,  0,  8,  4,  0,  4,  8,  0,  0,  0],
    [ 0,  0,  0,  0,  6,  6,  0,  1, 10,  1,  0,  0],
    [ 0,  0,  0,  0,  4,  8,  0,  0,  8,  4,  0,  0],
    [ 0,  0,  0,  0,  4,  3,  0,  3, 12,  1,  1,  0],
    [ 0,  0,  0,  0,  3,  4,  0,  1, 12,  3,  0,  1],
    [ 0,  0,  0,  0,  2,  2,  0,  2, 12,  2,  2,  2],
];

/// The exponents `[i, j, k]` of A, B, C in the Bernstein polynomials, in the order of the Bézier points.
#[rustfmt::skip]
const EXPONENTS: [[i32; 3]; 15] = [
    [4, 0, 0], [3, 1, 0], [2, 2, 0], [1, 3, 0], [0, 4, 0],
    [3, 0, 1], [2, 1, 1], [1, 2, 1], [0, 3, 1],
    [2, 0, 2], [1, 1, 2], [0, 2, 2],
    [1, 0, 3], [0, 1, 3],
    [0, 0, 4],
];

/// The Bézier points of the polynomial above the triangle.
pub(super) fn bezier_points<P: VectorSpace>(net: &[P; 12]) -> [P; 15] {
    BEZIER.map(|row| {
        let terms = net.iter().zip(row).filter(|&(_, weight)| weight != 0);
        let terms = terms.map(|(point, weight)| point.times(P::Scalar::from_i32(weight)));
        let sum = terms.reduce(P::plus).unwrap_or_else(P::origin);
        sum.times(P::Scalar::ratio(1, 24))
    })
}

/// The weights of the Bézier points in each of the first K entries of a jet, at `A + s (B − A) + t (C − A)`.
// ANCHOR: weights
pub(super) fn weights<S: Scalar, const K: usize>([s, t]: [S; 2]) -> [[S; 15]; K] {
    let bernstein = Bernstein::new([S::one() - s - t, s, t]);
    std::array::from_fn(|entry| {
        let [along_s, along_t] = ORDERS[entry];
        EXPONENTS.map(|exponents| bernstein.derivative(exponents, along_s, along_t))
    })
}
// ANCHOR_END: weights

/// The powers 0 to 4 of the three barycentric coordinates.
struct Bernstein<S> {
    powers: [[S; 5]; 3],
}

impl<S: Scalar> Bernstein<S> {
    fn new(coordinates: [S; 3]) -> Self {
        let powers = coordinates.map(|x| [S::one(), x, x * x, x * x * x, x * x * (x * x)]);
        Self { powers }
    }

    /// A Bernstein polynomial of any degree up to 4; zero where an exponent is negative.
    fn value(&self, exponents: [i32; 3]) -> S {
        const FACTORIALS: [i32; 5] = [1, 1, 2, 6, 24];
        let [Ok(i), Ok(j), Ok(k)] = exponents.map(usize::try_from) else {
            return S::zero();
        };
        let count = FACTORIALS[i + j + k] / (FACTORIALS[i] * FACTORIALS[j] * FACTORIALS[k]);
        let [a, b, c] = &self.powers;
        S::from_i32(count) * (a[i] * b[j] * c[k])
    }

    /// A derivative along AB and AC: the degree times a difference of polynomials of one degree less.
    fn derivative(&self, [i, j, k]: [i32; 3], along_s: usize, along_t: usize) -> S {
        let degree = S::from_i32(i + j + k);
        let (gained, rest) = match [along_s, along_t] {
            [0, 0] => return self.value([i, j, k]),
            [0, _] => ([i, j, k - 1], [0, along_t - 1]),
            _ => ([i, j - 1, k], [along_s - 1, along_t]),
        };
        let [s, t] = rest;
        degree * (self.derivative(gained, s, t) - self.derivative([i - 1, j, k], s, t))
    }
}
