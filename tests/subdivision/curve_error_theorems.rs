//! Floating point against arbitrary precision: the bounds that the subdivided curves state.

use facette::algebra::Real;
use facette::subdivision::curve::{Ends, limit_points, limit_tangents, subdivided};
use num_traits::{Signed, Zero};
use proptest::collection::vec;
use proptest::prelude::*;

use crate::common::bound::Bound;
use crate::common::generators::{float_coordinate, hard_float_coordinate};
use crate::common::law::{Broken, Law, Verdict};
use crate::common::oracle::{Big, big, big_bspline_basis};
use crate::suspects;

/// The coordinates of a polygon in one direction, a degree, and a number of rounds.
#[derive(Clone, Debug)]
struct Case {
    heights: Vec<f64>,
    degree: usize,
    rounds: u32,
}

fn cases(heights: impl Strategy<Value = f64>) -> impl Strategy<Value = Case> {
    (vec(heights, 7..=9), 2..=6_usize, 1..=5_u32).prop_map(|(heights, degree, rounds)| Case {
        heights,
        degree,
        rounds,
    })
}

/// The largest absolute value.
fn largest(values: &[Big]) -> Big {
    let sizes = values.iter().map(Signed::abs);
    sizes.fold(Big::zero(), |a, b| if b > a { b } else { a })
}

/// A round of doubling and averaging without rounding.
fn exact_round(points: &[Big], degree: usize) -> Vec<Big> {
    let two = big(2.0);
    let mut finer: Vec<Big> = points.iter().flat_map(|p| [p.clone(), p.clone()]).collect();
    for _ in 0..degree {
        finer = finer
            .windows(2)
            .map(|pair| (&pair[0] + &pair[1]) / &two)
            .collect();
    }
    finer
}

/// The heights as numbers of this type, and exactly those.
fn given<S: Real>(heights: &[f64]) -> (Vec<S>, Vec<Big>) {
    let rounded: Vec<S> = heights.iter().map(|&height| S::from_f64(height)).collect();
    let exact = rounded.iter().map(|height| big(height.to_f64())).collect();
    (rounded, exact)
}

fn refusal(error: &impl ToString) -> Broken {
    Broken {
        expected: "an answer".to_owned(),
        got: error.to_string(),
    }
}

/// **Rounding does not pile up.** After $k$ rounds of degree $d$ every coordinate is within $k\max(2,d)\,\mathbf u$ times the largest of the first polygon, in `f32` as in `f64`.
///
/// A round makes means, which pass errors on without magnifying them, so that $k$ rounds have at most $k$ times the error of one. Chaikin's rounds $\frac34P$, to an error of $\frac34\mathbf u$, and the sum; together $\frac74\mathbf u$ to first order. The cubic scheme rounds $\frac68P$
/// and two sums, the first of them below $\frac78$: $\frac{21}8\mathbf u$. A mean of two halves is rounded once, so that $d$ averagings have $d\,\mathbf u$, less a half since in the first every other mean is that of equal points. What is left to the bound exceeds the terms in $\mathbf u^2$.
#[test]
fn rounding_does_not_pile_up() {
    let bounds = [Bound::default(), Bound::default()];
    Law::new("subdivision::rounding_does_not_pile_up", suspects::library)
        .on_cases(48)
        .holds(
            cases(float_coordinate()),
            cases(hard_float_coordinate()),
            |case| {
                refined_error::<f64>(case, &bounds[0])?;
                refined_error::<f32>(case, &bounds[1])
            },
        );
    // With one round errors reach most of the bound; with several they cancel in part.
    for bound in &bounds {
        bound.is_used_up_to(0.3);
    }
}

fn refined_error<S: Real>(case: &Case, bound: &Bound) -> Verdict {
    let (heights, exact) = given::<S>(&case.heights);
    let size = largest(&exact);
    let mut finer = exact;
    for rounds in 1..=case.rounds {
        finer = exact_round(&finer, case.degree);
        let computed = subdivided(&heights, case.degree, Ends::Open, rounds);
        let computed = computed.map_err(|error| refusal(&error))?;
        let factor = f64::from(rounds) * case.degree as f64 * S::unit_roundoff().to_f64();
        for (computed, exact) in computed.iter().zip(&finer) {
            bound.holds_error(&(big(computed.to_f64()) - exact), &(&size * big(factor)))?;
        }
    }
    Ok(())
}

/// **The error of limit points and tangents.** A limit point is within $4d\,\mathbf u$ times the largest of the $d$ points that count, a tangent within $4d\,\mathbf u$ times the largest of the $d-1$ differences.
///
/// A degree more costs a weight a product, a sum of positive terms and a quotient, $3\mathbf u$: the weights have $3(d-1)\mathbf u$. They sum to 1, so that the products add $\mathbf u$ and the sums $(d-1)\mathbf u$: $(4d-3)\mathbf u$. A tangent has weights of one degree less, and differences that are rounded once.
#[test]
fn limit_point_error_stays_below_its_bound() {
    let bounds = [Bound::default(), Bound::default()];
    Law::new(
        "subdivision::limit_point_error_stays_below_its_bound",
        suspects::library,
    )
    .holds(
        cases(float_coordinate()),
        cases(hard_float_coordinate()),
        |case| {
            limit_error::<f64>(case, &bounds[0])?;
            limit_error::<f32>(case, &bounds[1])
        },
    );
    for bound in &bounds {
        bound.is_used_up_to(0.08);
    }
}

/// The B-spline of integer knots at its inner ones, exactly.
fn exact_weights(degree: usize) -> Vec<Big> {
    let knots: Vec<f64> = (0..=2 * degree + 1).map(|knot| knot as f64).collect();
    let middle = big(degree as f64);
    let mut values = big_bspline_basis(degree, &knots, &middle, knots[degree + 1]);
    values.truncate(degree);
    values
}

fn limit_error<S: Real>(case: &Case, bound: &Bound) -> Verdict {
    let (heights, exact) = given::<S>(&case.heights);
    let degree = case.degree;
    let factor = big(4.0 * degree as f64 * S::unit_roundoff().to_f64());
    let differences: Vec<Big> = exact.windows(2).map(|pair| &pair[1] - &pair[0]).collect();
    let points = limit_points(&heights, degree, Ends::Open).map_err(|error| refusal(&error))?;
    let tangents = limit_tangents(&heights, degree, Ends::Open).map_err(|error| refusal(&error))?;
    for (of, weights, computed) in [
        (&exact, exact_weights(degree), points),
        (&differences, exact_weights(degree - 1), tangents),
    ] {
        for (window, computed) in of.windows(weights.len()).zip(computed) {
            let terms = window.iter().zip(&weights).map(|(p, weight)| p * weight);
            let mean = terms.fold(Big::zero(), |sum, term| sum + term);
            bound.holds_error(
                &(big(computed.to_f64()) - mean),
                &(largest(window) * &factor),
            )?;
        }
    }
    Ok(())
}
