//! Exercise 2: a point of a curve by de Boor's points.
//!
//! Replace `todo!(...)` by your code, save, and run `cargo exercise bspline/curve`.

use crate::algebra::VectorSpace;
use crate::bspline::KnotVector;
// The book's own function, so that this exercise does not wait for the first.
use reference::bspline::find_span;

/// The point `C(u)` of the B-spline curve with these knots and control points, by repeated interpolation:
///
/// ```text
/// level 0:       P_i^0 = P_i                                         for the p + 1 points  i = k-p, ..., k  of the span k
/// level r:       P_i^r = (1 - a) P_(i-1)^(r-1) + a P_i^(r-1)         for                   i = k-p+r, ..., k
///                with  a = (u - u_i) / (u_(i+p+1-r) - u_i)           r = 1, ..., p: a level, not a power
/// C(u) = P_k^p
/// ```
///
/// What you can use:
///
/// ```text
/// knots.degree()              p
/// knots.knots()[i]            the knot u_i
/// p.lerp(q, t)                the point (1-t) p + t q
/// list[a..=b].to_vec()        a copy of the entries a, ..., b of a list, which you can then change
/// for r in 1..=p { ... }      counts upwards;   (a..=b).rev() counts downwards
/// ```
pub fn de_boor_point<P: VectorSpace>(
    knots: &KnotVector<P::Scalar>,
    control_points: &[P],
    u: P::Scalar,
) -> P {
    // The span k.
    let k = find_span(knots, u);

    todo!("de_boor_point: the last point, P_k^p")
}
