//! Exercise 3: the bicubically blended Coons patch.
//!
//! Replace each `todo!(...)` by your code, save, and run `cargo exercise coons/bicubic`.

use crate::algebra::{Scalar, VectorSpace};
use crate::coons::HermiteBoundary;
use crate::curve::Curve;

/// Hermite's four cubics at `t`. Each has one of the four data 1 and the other three 0:
///
/// ```text
///         value at 0   slope at 0   slope at 1   value at 1
/// [0]         1            0            0            0
/// [1]         0            1            0            0
/// [2]         0            0            1            0
/// [3]         0            0            0            1
/// ```
///
/// Numbers have + - * / as usual; `S::from_i32(3)` is the number 3 in the type S of the parameter.
pub fn hermite_basis<S: Scalar>(t: S) -> [S; 4] {
    todo!("hermite_basis: the four cubics at t")
}

/// The point `S(u, v)` of the bicubically blended Coons patch: the bilinear construction S1 + S2 - S3, with Hermite's
/// cubics H0 to H3 in the place of 1-t and t.
///
/// ```text
/// S1(u,v) = H0(v) P1(u) + H1(v) P1_v(u) + H2(v) P2_v(u) + H3(v) P2(u)      P1_v, P2_v: slopes across P1, P2
/// S2(u,v) = H0(u) Q1(v) + H1(u) Q1_u(v) + H2(u) Q2_u(v) + H3(u) Q2(v)      Q1_u, Q2_u: slopes across Q1, Q2
/// S3(u,v) = the sum over i and j of  Hi(u) Hj(v) M[i][j]                   M: the 16 vectors at the corners
/// ```
///
/// What you can use:
///
/// ```text
/// data.boundary().p1()                    the curve P1; so also .p2(), .q1(), .q2()
/// data.p1_v()                             the curve P1_v; so also .p2_v(), .q1_u(), .q2_u()
/// data.corner_vectors(u, v)               M: the row i belongs to u, the column j to v
/// C::Point::combination([g, h], [p, q])   the point g p + h q, for as many numbers as points
/// ```
pub fn bicubic_point<C: Curve>(data: &HermiteBoundary<C>, u: C::Scalar, v: C::Scalar) -> C::Point {
    let [in_u, in_v] = [hermite_basis(u), hermite_basis(v)];
    let vectors = data.corner_vectors(u, v);

    todo!("bicubic_point: the point S1 + S2 - S3, blended by in_u and in_v")
}
