//! Exercise 4: a point of a surface, in the five steps of the course.
//!
//! Replace `todo!(...)` by your code, save, and run `cargo exercise bspline/surface`.

use crate::algebra::VectorSpace;
use crate::bspline::{BsplineSurface, Direction};
// The book's own functions, so that this exercise does not wait for the first.
use reference::bspline::{basis_functions, find_span};

/// The point `S(u, v)` of a tensor-product surface of the degrees `p` and `q`:
///
/// ```text
/// 1. the span i of u                   in the knots of direction u
/// 2. N_(i-p)(u), ..., N_i(u)           the functions that are not zero there
/// 3. the span j of v                   in the knots of direction v
/// 4. N_(j-q)(v), ..., N_j(v)
/// 5. S(u,v) = the sum over k = i-p, ..., i and l = j-q, ..., j of  N_k(u) N_l(v) P_kl
/// ```
///
/// What you can use:
///
/// ```text
/// find_span(in_u, u)                           the span of u
/// let mut list = vec![u; count];               a list of so many numbers, all equal to u for a start
/// basis_functions(in_u, i, u, &mut list);      fills it with N_(i-p)(u), ..., N_i(u)
/// surface.control_point(k, l)                  the control point P_kl: k belongs to u, l to v
/// a.plus(b), a.times(t)                        the sum of two points; the multiple of a point
/// P::origin()                                  the point with all coordinates 0, to begin a sum with
/// ```
pub fn surface_point<P: VectorSpace>(surface: &BsplineSurface<P>, u: P::Scalar, v: P::Scalar) -> P {
    // The knots in both directions, and their degrees.
    let [in_u, in_v] = [surface.knots(Direction::U), surface.knots(Direction::V)];
    let [p, q] = [in_u.degree(), in_v.degree()];

    todo!("surface_point: the double sum over (p+1)(q+1) control points")
}
