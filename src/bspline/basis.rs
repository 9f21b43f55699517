//! The basis functions: by their definition, and only those that are not zero.

use super::KnotVector;
use crate::algebra::Scalar;
use crate::curve::count;

/// The span `i` that carries `u`: the one with `uᵢ <= u < uᵢ₊₁`.
///
/// # Edge cases
///
/// The span is never empty. The end of the domain belongs to the last span; a parameter before the domain, and NaN, get the
/// first span, one behind it the last.
///
/// # Cost
///
/// A binary search.
#[inline]
// ANCHOR: find_span
pub fn find_span<S: Scalar>(knots: &KnotVector<S>, u: S) -> usize {
    let [first, last] = knots.end_spans();
    let inner = &knots.knots()[first + 1..=last];
    first + inner.partition_point(|&knot| knot <= u)
}
// ANCHOR_END: find_span

/// The basis function `Nᵢᵈ(u)` of degree `d = degree`, by the recursion that defines it. A fraction with a zero denominator
/// counts as 0.
///
/// At the end of the domain the last span counts as closed; elsewhere, outside the domain too, spans are half-open.
///
/// # Cost
///
/// `2ᵈ` calls: for reading and for comparison. [`basis_functions`] gives all that are not zero in `d (d + 1) / 2` steps.
///
/// # Panics
///
/// When there is no knot `i + degree + 1`.
///
/// # Source
///
/// Cox 1972, de Boor 1972; slide 57.
// ANCHOR: cox_de_boor
pub fn cox_de_boor<S: Scalar>(knots: &KnotVector<S>, degree: usize, i: usize, u: S) -> S {
    let u_at = |index: usize| knots.knots()[index];
    if degree == 0 {
        let is_end = u == knots.domain()[1];
        let is_inside = if is_end {
            i == knots.end_spans()[1]
        } else {
            u_at(i) <= u && u < u_at(i + 1)
        };
        return if is_inside { S::one() } else { S::zero() };
    }
    let mut value = S::zero();
    if u_at(i) < u_at(i + degree) {
        let [_, rising] = knots.weights(u, [u_at(i), u_at(i + degree)]);
        value = value + rising * cox_de_boor(knots, degree - 1, i, u);
    }
    if u_at(i + 1) < u_at(i + degree + 1) {
        let [falling, _] = knots.weights(u, [u_at(i + 1), u_at(i + degree + 1)]);
        value = value + falling * cox_de_boor(knots, degree - 1, i + 1, u);
    }
    value
}
// ANCHOR_END: cox_de_boor

/// Writes the basis functions `Nᵢ₋ₚ(u), …, Nᵢ(u)` of the span `i` to `values`: all that may differ from 0 there.
///
/// # Shape
///
/// `values` has `p + 1` places.
///
/// # Accuracy
///
/// In the span, each value has a relative error of at most about `5pu`: all are sums of products of non-negative numbers
/// (tested as `basis_error_stays_below_its_bound`).
///
/// # Edge cases
///
/// Outside its span the polynomials go on; NaN gives NaN.
///
/// # Panics
///
/// When `values` has another length, or the span is not one of [`KnotVector::spans`] and has no knots around it.
///
/// # Source
///
/// Piegl and Tiller 1997, algorithm A2.2, with the quotients taken first.
#[inline]
pub fn basis_functions<S: Scalar>(knots: &KnotVector<S>, span: usize, u: S, values: &mut [S]) {
    let degree = knots.degree();
    assert!(
        values.len() == degree + 1,
        "degree {degree} has {} basis functions a span, not {}",
        degree + 1,
        values.len()
    );
    triangle(knots, span, u, values);
}

/// The basis functions of degree `values.len() − 1` on the same knots.
#[allow(
    clippy::inline_always,
    reason = "where the caller knows the degree, the compiler unrolls both loops"
)]
#[inline(always)]
// ANCHOR: basis_functions
pub(super) fn triangle<S: Scalar>(knots: &KnotVector<S>, span: usize, u: S, values: &mut [S]) {
    let highest = values.len() - 1;
    let around = &knots.knots()[span + 1 - highest..=span + highest];
    values[0] = S::one();
    for degree in 1..=highest {
        let mut carried = S::zero();
        for index in 0..degree {
            let support = [around[highest - degree + index], around[highest + index]];
            let [falling, rising] = knots.weights(u, support);
            let lower = values[index];
            values[index] = carried + falling * lower;
            carried = rising * lower;
        }
        values[degree] = carried;
    }
}
// ANCHOR_END: basis_functions

/// Writes the derivatives of the basis functions of the span `i` to `values`, row after row: row `k` holds the derivatives of
/// order `k` of `Nᵢ₋ₚ, …, Nᵢ`.
///
/// # Shape
///
/// `values` has `(order + 1)(p + 1)` places. Rows above the degree are zero.
///
/// # Edge cases
///
/// As [`basis_functions`]: at a knot, the derivatives of the span's own polynomials, so right-sided ones where the span starts.
///
/// # Panics
///
/// When the length of `values` is not a positive multiple of `p + 1`, or as [`basis_functions`].
///
/// # Source
///
/// `N' = p (Nᵢᵖ⁻¹ / (uᵢ₊ₚ − uᵢ) − Nᵢ₊₁ᵖ⁻¹ / (uᵢ₊ₚ₊₁ − uᵢ₊₁))`, de Boor 1972, repeated.
pub fn basis_derivatives<S: Scalar>(knots: &KnotVector<S>, span: usize, u: S, values: &mut [S]) {
    let degree = knots.degree();
    assert!(
        !values.is_empty() && values.len().is_multiple_of(degree + 1),
        "derivatives of degree {degree} come in rows of {}, not in {} places",
        degree + 1,
        values.len()
    );
    for (order, row) in values.chunks_exact_mut(degree + 1).enumerate() {
        if order > degree {
            row.fill(S::zero());
            continue;
        }
        triangle(knots, span, u, &mut row[..=degree - order]);
        for raised in degree - order + 1..=degree {
            differentiate(knots, span, &mut row[..=raised]);
        }
    }
}

/// Makes the derivatives of the functions of degree `d = values.len() − 1` from the values (or derivatives) of those of degree
/// `d − 1`, which stand in all places but the last.
fn differentiate<S: Scalar>(knots: &KnotVector<S>, span: usize, values: &mut [S]) {
    let degree = values.len() - 1;
    let factor = S::from_i32(count(degree));
    let mut carried = S::zero();
    for (index, value) in values[..degree].iter_mut().enumerate() {
        let support = [span + 1 + index - degree, span + 1 + index];
        let [start, end] = support.map(|knot| knots.knots()[knot]);
        let slope = factor * *value / (end - start);
        *value = carried - slope;
        carried = slope;
    }
    values[degree] = carried;
}

/// Hands `values` of so many zeros to `work`: on the stack where they are few.
#[inline]
pub(super) fn with_buffer<T: Copy, R>(
    length: usize,
    zero: T,
    work: impl FnOnce(&mut [T]) -> R,
) -> R {
    match length {
        0..=4 => work(&mut [zero; 4][..length]),
        5..=16 => work(&mut [zero; 16][..length]),
        _ => work(&mut vec![zero; length]),
    }
}
