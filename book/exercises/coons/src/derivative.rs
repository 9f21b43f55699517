//! Exercise 2: the partial derivatives of the bilinear Coons patch.
//!
//! Replace `todo!(...)` by your code, save, and run `cargo exercise coons/derivative`.

use crate::algebra::VectorSpace;
use crate::coons::{Boundary, Corners};
use crate::curve::Curve;

/// The partial derivatives `[S_u, S_v]` of the bilinear Coons patch at `(u, v)`, or `None` where a boundary curve has
/// no derivative.
///
/// ```text
/// S(u,v) = (1-v) P1(u) + v P2(u)  +  (1-u) Q1(v) + u Q2(v)  -  [ (1-u)(1-v) A + u(1-v) B + uv C + (1-u)v D ]
/// ```
///
/// Differentiate this on paper, first by u with v held fixed, then by v with u held fixed.
///
/// What you can use, besides what exercise 1 lists:
///
/// ```text
/// curve.derivative(t)     perhaps the derivative of a curve at t: Some(vector) or None
/// curve.derivative(t)?    the vector; where it is None, the function ends here and gives None itself
/// Some([s_u, s_v])        the result where all went well
/// ```
pub fn bilinear_partials<C: Curve>(
    boundary: &Boundary<C>,
    u: C::Scalar,
    v: C::Scalar,
) -> Option<[C::Point; 2]> {
    // The corners: a = S(0,0), b = S(1,0), c = S(1,1), d = S(0,1), counted around the patch.
    let Corners { a, b, c, d } = boundary.corners();

    todo!("bilinear_partials: the two vectors [S_u, S_v]")
}
