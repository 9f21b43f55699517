//! A solution of exercise 2: the partial derivatives of the bilinear Coons patch.

use crate::algebra::VectorSpace;
use crate::coons::{Boundary, Corners};
use crate::curve::Curve;

/// The partial derivatives `[S_u, S_v]` of the bilinear Coons patch, or `None` where a curve has no derivative.
pub fn bilinear_partials<C: Curve>(
    boundary: &Boundary<C>,
    u: C::Scalar,
    v: C::Scalar,
) -> Option<[C::Point; 2]> {
    let Corners { a, b, c, d } = boundary.corners();
    let [p1, p2] = [boundary.p1(), boundary.p2()];
    let [q1, q2] = [boundary.q1(), boundary.q2()];

    // By u: P1 and P2 move, the weights (1-u) and u become -1 and 1.
    let s1_u = p1.derivative(u)?.lerp(p2.derivative(u)?, v);
    let s2_u = q2.point(v).minus(q1.point(v));
    let s3_u = b.minus(a).lerp(c.minus(d), v);

    // By v: Q1 and Q2 move, the weights (1-v) and v become -1 and 1.
    let s1_v = p2.point(u).minus(p1.point(u));
    let s2_v = q1.derivative(v)?.lerp(q2.derivative(v)?, u);
    let s3_v = d.minus(a).lerp(c.minus(b), u);

    Some([s1_u.plus(s2_u).minus(s3_u), s1_v.plus(s2_v).minus(s3_v)])
}
