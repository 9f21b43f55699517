//! A solution of exercise 3: the bicubically blended Coons patch.

use crate::algebra::{Scalar, VectorSpace};
use crate::coons::HermiteBoundary;
use crate::curve::Curve;

/// Hermite's four cubics at `t`, in the order value at 0, slope at 0, slope at 1, value at 1.
pub fn hermite_basis<S: Scalar>(t: S) -> [S; 4] {
    let one = S::from_i32(1);
    let two = S::from_i32(2);
    let three = S::from_i32(3);
    [
        (one + two * t) * (one - t) * (one - t),
        t * (one - t) * (one - t),
        t * t * (t - one),
        t * t * (three - two * t),
    ]
}

/// The point `S(u, v) = S1 + S2 - S3` of the bicubically blended Coons patch.
pub fn bicubic_point<C: Curve>(data: &HermiteBoundary<C>, u: C::Scalar, v: C::Scalar) -> C::Point {
    let [in_u, in_v] = [hermite_basis(u), hermite_basis(v)];
    let vectors = data.corner_vectors(u, v);
    let boundary = data.boundary();

    let s1 = C::Point::combination(
        in_v,
        [
            boundary.p1().point(u),
            data.p1_v().point(u),
            data.p2_v().point(u),
            boundary.p2().point(u),
        ],
    );
    let s2 = C::Point::combination(
        in_u,
        [
            boundary.q1().point(v),
            data.q1_u().point(v),
            data.q2_u().point(v),
            boundary.q2().point(v),
        ],
    );
    // One row after the other: each becomes a point by the weights in v, the four points one by the weights in u.
    let rows = vectors.map(|row| C::Point::combination(in_v, row));
    let s3 = C::Point::combination(in_u, rows);

    s1.plus(s2).minus(s3)
}
