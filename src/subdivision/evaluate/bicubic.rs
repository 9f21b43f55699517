//! A regular quadrilateral: a patch of the uniform bicubic B-spline, from the 16 points of the 3 × 3 faces around it.

use num_traits::One;

use super::jet::ORDERS;
use crate::algebra::Scalar;

/// The four cubic B-splines that are not zero on a span, and their first and second derivatives.
///
/// # Accuracy
///
/// The values are sums of non-negative terms: a relative error of at most 8u for 0 <= t <= 1.
// ANCHOR: cubic
#[rustfmt::skip]
fn cubic<S: Scalar>(t: S) -> [[S; 4]; 3] {
    let [one, three] = [1, 3].map(S::from_i32);
    let s = one - t;
    let sixth = S::ratio(1, 6);
    let half = S::ratio(1, 2);
    [
        [
            s * s * s * sixth,
            (one + three * s * (one + s * t)) * sixth,
            (one + three * t * (one + s * t)) * sixth,
            t * t * t * sixth,
        ],
        [-s * s * half, -t * (one + three * s) * half, s * (one + three * t) * half, t * t * half],
        [s, three * t - one - one, three * s - one - one, t],
    ]
}
// ANCHOR_END: cubic

/// The weights of the 16 points, row by row, in each of the first K entries of a jet.
pub(super) fn weights<S: Scalar, const K: usize>([s, t]: [S; 2]) -> [[S; 16]; K] {
    let [in_s, in_t] = [cubic(s), cubic(t)];
    std::array::from_fn(|entry| {
        let [k, l] = ORDERS[entry];
        std::array::from_fn(|index| in_s[k][index % 4] * in_t[l][index / 4])
    })
}

/// Half the way between two points.
pub(super) fn midpoint<P: crate::algebra::VectorSpace>(a: P, b: P) -> P {
    a.plus(b).times(P::Scalar::ratio(1, 2))
}

/// The cubic rule `(a + 6b + c)/8`.
pub(super) fn smoothed<P: crate::algebra::VectorSpace>(a: P, b: P, c: P) -> P {
    let six_eighths = P::Scalar::ratio(3, 4);
    b.times(six_eighths)
        .plus(a.plus(c).times(P::Scalar::ratio(1, 8)))
}

/// The point on the other side of `b`, as far away as `a`: what makes a boundary row a cubic B-spline of its own.
pub(super) fn reflected<P: crate::algebra::VectorSpace>(a: P, b: P) -> P {
    b.times(P::Scalar::one() + P::Scalar::one()).minus(a)
}
