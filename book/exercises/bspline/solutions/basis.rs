//! A solution of exercise 1: the span of a parameter and the basis functions.

use crate::algebra::Scalar;
use crate::bspline::KnotVector;

/// The number `i` of the span on which `u` lies. (A search by halves would be faster; the book's function does one.)
pub fn find_span<S: Scalar>(knots: &KnotVector<S>, u: S) -> usize {
    let u_at = |i: usize| knots.knots()[i];
    let last = knots.control_point_count() - 1;

    // The first span that is not empty, for a `u` before the domain.
    let mut span = knots.degree();
    while u_at(span) == u_at(span + 1) {
        span += 1;
    }
    // The last one that is not empty and begins at `u` or before.
    for i in span..=last {
        if u_at(i) < u_at(i + 1) && u_at(i) <= u {
            span = i;
        }
    }
    span
}

/// The basis function number `i` of this degree at `u`, by the recursion that defines it.
pub fn cox_de_boor<S: Scalar>(knots: &KnotVector<S>, degree: usize, i: usize, u: S) -> S {
    let u_at = |i: usize| knots.knots()[i];
    if degree == 0 {
        let [_, end] = knots.domain();
        let is_inside = if u == end {
            i == find_span(knots, end)
        } else {
            u_at(i) <= u && u < u_at(i + 1)
        };
        return if is_inside { S::one() } else { S::zero() };
    }

    let mut value = S::zero();
    let width = u_at(i + degree) - u_at(i);
    if width != S::zero() {
        value = value + (u - u_at(i)) / width * cox_de_boor(knots, degree - 1, i, u);
    }
    let width = u_at(i + degree + 1) - u_at(i + 1);
    if width != S::zero() {
        value =
            value + (u_at(i + degree + 1) - u) / width * cox_de_boor(knots, degree - 1, i + 1, u);
    }
    value
}

/// Writes the basis functions that may differ from 0 on the span to `values`.
pub fn basis_functions<S: Scalar>(knots: &KnotVector<S>, span: usize, u: S, values: &mut [S]) {
    let u_at = |i: usize| knots.knots()[i];
    values[0] = S::one();
    for d in 1..=knots.degree() {
        // What the left neighbour hands over to the right.
        let mut rising = S::zero();
        for place in 0..d {
            let k = span + 1 - d + place;
            let t = (u - u_at(k)) / (u_at(k + d) - u_at(k));
            let value = values[place];
            values[place] = rising + (S::one() - t) * value;
            rising = t * value;
        }
        values[d] = rising;
    }
}
