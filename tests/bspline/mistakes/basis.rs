//! The typical mistakes in the search for the span and in the basis functions.

use facette::algebra::Scalar;
use facette::bspline::KnotVector;

use super::{RECURSION, SPAN, TRIANGLE, is_of};

/// The span of `u`, rightly.
pub fn span_of<S: Scalar>(knots: &KnotVector<S>, u: S) -> usize {
    let starts_before = |&span: &usize| knots.knots()[span] <= u;
    let first = knots.spans().next().unwrap_or_default();
    knots.spans().filter(starts_before).last().unwrap_or(first)
}

/// The span that the mistake finds; `None` for a mistake of another function.
pub fn find_span<S: Scalar>(mistake: &str, knots: &KnotVector<S>, u: S) -> Option<usize> {
    let all = knots.knots();
    let [first, last] = [span_of(knots, all[0]), span_of(knots, all[all.len() - 1])];
    let right = span_of(knots, u);
    let [start, end] = knots.domain();
    Some(match mistake {
        "closed_span" => knots
            .spans()
            .find(|&span| u <= all[span + 1])
            .unwrap_or(last),
        "span_behind_the_end" if u >= end => all.partition_point(|&knot| knot <= u) - 1,
        "empty_span" if start < u && u < end && knots.multiplicity(u) > 1 => {
            all.partition_point(|&knot| knot < u)
        }
        "empty_span_at_an_end" => {
            let mut spans = (knots.degree()..knots.control_point_count()).rev();
            let found = spans.find(|&span| all[span] <= u);
            found.unwrap_or(knots.degree())
        }
        "span_outside_the_domain" if u < start => {
            all.partition_point(|&knot| knot <= u).saturating_sub(1)
        }
        "span_counted_from_the_domain" => right - first,
        _ if is_of(SPAN, mistake) => right,
        _ => return None,
    })
}

/// What the mistake makes of the recursion; `None` for a mistake of another function.
pub fn cox_de_boor<S: Scalar>(
    mistake: &str,
    knots: &KnotVector<S>,
    degree: usize,
    i: usize,
    u: S,
) -> Option<S> {
    is_of(RECURSION, mistake).then(|| wrong_recursion(mistake, knots, degree, i, u))
}

fn wrong_recursion<S: Scalar>(
    mistake: &str,
    knots: &KnotVector<S>,
    degree: usize,
    i: usize,
    u: S,
) -> S {
    let at = |index: usize| knots.knots()[index];
    if degree == 0 {
        let is_inside = match mistake {
            "zero_at_the_end" => at(i) <= u && u < at(i + 1),
            "two_spans_at_a_knot" => at(i) <= u && u <= at(i + 1),
            _ if u == knots.domain()[1] => i == span_of(knots, u),
            _ => at(i) <= u && u < at(i + 1),
        };
        return if is_inside { S::one() } else { S::zero() };
    }
    let next = |i: usize| wrong_recursion(mistake, knots, degree - 1, i, u);
    let term = |distance: S, width: S, i: usize| {
        if width.is_zero() && mistake != "zero_over_zero" {
            return S::zero();
        }
        distance / width * next(i)
    };
    let [a, b, c, d] = [at(i), at(i + 1), at(i + degree), at(i + degree + 1)];
    let [rising, falling] = [term(u - a, c - a, i), term(d - u, d - b, i + 1)];
    match mistake {
        "swapped_denominators" => term(u - a, d - b, i) + term(d - u, c - a, i + 1),
        "one_knot_short" => rising + term(c - u, c - b, i + 1),
        "one_term" => rising,
        "same_function_twice" => rising + term(d - u, d - b, i),
        "rising_twice" => rising + term(u - b, d - b, i + 1),
        _ => rising + falling,
    }
}

/// What the mistake makes of the values on a span; `None` for a mistake of another function.
pub fn basis_functions<S: Scalar>(
    mistake: &str,
    knots: &KnotVector<S>,
    span: usize,
    u: S,
) -> Option<Vec<S>> {
    is_of(TRIANGLE, mistake).then(|| wrong_values(mistake, knots, span, u))
}

fn wrong_values<S: Scalar>(mistake: &str, knots: &KnotVector<S>, span: usize, u: S) -> Vec<S> {
    let at = |index: usize| knots.knots()[index];
    let p = knots.degree();
    let levels = if mistake == "triangle_one_level_short" {
        p.saturating_sub(1)
    } else {
        p
    };
    let mut values = vec![S::one()];
    for degree in 1..=levels {
        let mut next = vec![S::zero(); degree + 1];
        for (place, value) in values.into_iter().enumerate() {
            let k = span + 1 + place - degree;
            let t = (u - at(k)) / (at(k + degree) - at(k));
            let mut parts = [(S::one() - t) * value, t * value];
            if mistake == "exchanged_parts" {
                parts.reverse();
            }
            let kept = if mistake == "lost_part" {
                S::zero()
            } else {
                next[place]
            };
            next[place] = kept + parts[0];
            next[place + 1] = parts[1];
        }
        values = next;
    }
    values.resize(p + 1, S::zero());
    match mistake {
        "reversed_values" => values.reverse(),
        "functions_after_the_span" => {
            let last = values[p];
            values.fill(S::zero());
            values[0] = last;
        }
        _ => {}
    }
    values
}

/// The values of the functions `N_(i-p), ..., N_i` on the span `i`, rightly.
pub fn values_on<S: Scalar>(knots: &KnotVector<S>, span: usize, u: S) -> Vec<S> {
    wrong_values("", knots, span, u)
}
