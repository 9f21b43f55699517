//! Exercise 1: the span of a parameter and the basis functions.
//!
//! Replace each `todo!(...)` by your code, save, and run `cargo exercise bspline/basis`. The theorems come in the order of
//! the functions: you can begin with one and leave the others.

use crate::algebra::Scalar;
use crate::bspline::KnotVector;

/// The number `i` of the span on which `u` lies: `u_i <= u < u_(i+1)`.
///
/// ```text
/// inside the domain [u_p, u_(n+1)]   p <= i <= n, and the span is not empty: u_i < u_(i+1)
/// at the end of the domain           the last span that is not empty, as if it were closed
/// before / behind the domain         the first / the last span of the domain that is not empty
/// ```
///
/// What you can use:
///
/// ```text
/// knots.degree()                 p
/// knots.control_point_count()    n + 1
/// knots.knots()[i]               the knot u_i, for i from 0 to n + p + 1
/// ```
pub fn find_span<S: Scalar>(knots: &KnotVector<S>, u: S) -> usize {
    todo!("find_span: the number i with u_i <= u < u_(i+1)")
}

/// The basis function number `i` of degree `d = degree` at `u`, by the recursion that defines it:
///
/// ```text
/// N_i^0(u) = 1 for u_i <= u < u_(i+1), else 0
///
///               u - u_i                     u_(i+d+1) - u
/// N_i^d(u) = ------------- N_i^(d-1)(u) + ------------------- N_(i+1)^(d-1)(u)        0/0 counts as 0
///            u_(i+d) - u_i                u_(i+d+1) - u_(i+1)
/// ```
///
/// At the end of the domain the last span that is not empty counts as closed: there N_i^0 is 1 for that span alone.
///
/// What you can use, besides what stands above:
///
/// ```text
/// knots.domain()              the ends [u_p, u_(n+1)] of the domain
/// find_span(knots, u)         your function from above
/// S::zero(), S::one()         the numbers 0 and 1 of the type S
/// cox_de_boor(...)            a function may call itself
/// ```
pub fn cox_de_boor<S: Scalar>(knots: &KnotVector<S>, degree: usize, i: usize, u: S) -> S {
    todo!("cox_de_boor: the basis function number i at u")
}

/// Writes all basis functions that may differ from 0 on the span `i = span` to `values`: `N_(i-p)^p(u)` to `values[0]`, and so
/// on up to `N_i^p(u)` to `values[p]`.
///
/// The recursion from above computes the same values again and again. Go the other way instead, from degree 0 to degree p:
/// of degree d, only d + 1 functions are not zero on the span.
///
/// ```text
/// degree 0                    N_i
/// degree 1              N_(i-1)   N_i             each value goes to its two lower neighbours:
/// degree 2        N_(i-2)   N_(i-1)   N_i         falling part to the left, rising part to the right
/// ```
///
/// The value of `N_k^(d-1)`, whose support is from `u_k` to `u_(k+d)`, is split by
/// `t = (u - u_k) / (u_(k+d) - u_k)`: the part `1 - t` of it belongs to `N_(k-1)^d`, the part `t` to `N_k^d`.
///
/// What you can use:
///
/// ```text
/// knots.degree()              p
/// knots.knots()[i]            the knot u_i
/// values[0] to values[p]      p + 1 places to write to; what they hold when your function begins means nothing
/// S::zero(), S::one()         the numbers 0 and 1 of the type S
/// ```
pub fn basis_functions<S: Scalar>(knots: &KnotVector<S>, span: usize, u: S, values: &mut [S]) {
    todo!("basis_functions: the p + 1 values on the span")
}
