//! A solution of exercise 1: the bilinear Coons patch.

use crate::algebra::VectorSpace;
use crate::coons::{Boundary, Corners};
use crate::curve::Curve;

/// The point `S(u, v) = S1 + S2 - S3` of the bilinear Coons patch.
pub fn bilinear_point<C: Curve>(boundary: &Boundary<C>, u: C::Scalar, v: C::Scalar) -> C::Point {
    let Corners { a, b, c, d } = boundary.corners();

    let s1 = boundary.p1().point(u).lerp(boundary.p2().point(u), v);
    let s2 = boundary.q1().point(v).lerp(boundary.q2().point(v), u);

    let bottom = a.lerp(b, u);
    let top = d.lerp(c, u);
    let s3 = bottom.lerp(top, v);

    s1.plus(s2).minus(s3)
}
