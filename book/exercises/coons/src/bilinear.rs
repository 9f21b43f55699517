//! Exercise 1: the bilinear Coons patch.
//!
//! Replace `todo!(...)` by your code, save, and run `cargo exercise coons/bilinear`.

use crate::algebra::VectorSpace;
use crate::coons::{Boundary, Corners};
use crate::curve::Curve;

/// The point `S(u, v)` of the bilinear Coons patch:
///
/// ```text
/// S(u,v)  = S1 + S2 - S3
/// S1(u,v) = (1-v) P1(u) + v P2(u)                              between the curves P1 (v = 0) and P2 (v = 1)
/// S2(u,v) = (1-u) Q1(v) + u Q2(v)                              between the curves Q1 (u = 0) and Q2 (u = 1)
/// S3(u,v) = (1-u)(1-v) A + u(1-v) B + uv C + (1-u)v D          between the corners
/// ```
///
/// What you can use:
///
/// ```text
/// boundary.p1()      the curve P1; so also .p2(), .q1(), .q2()
/// curve.point(t)     the point of a curve at the parameter t
/// p.plus(q)          the sum of two points;     p.minus(q)  their difference
/// p.times(t)         the point p, every coordinate multiplied by the number t
/// p.lerp(q, t)       the point (1-t) p + t q, on the way from p to q
/// ```
///
/// The last expression of the function, without a semicolon, is its result.
pub fn bilinear_point<C: Curve>(boundary: &Boundary<C>, u: C::Scalar, v: C::Scalar) -> C::Point {
    // The corners: a = S(0,0), b = S(1,0), c = S(1,1), d = S(0,1), counted around the patch.
    let Corners { a, b, c, d } = boundary.corners();

    todo!("bilinear_point: the point S1 + S2 - S3")
}
