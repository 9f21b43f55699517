//! The theorems of the basis functions: what they are, where they are not zero, and what they sum to.

use facette::algebra::VectorSpace;
use facette::bspline::{basis_functions, cox_de_boor, find_span};
use num_traits::{One, Zero};
use proptest::prelude::*;

use crate::common::exact::{Exact, fraction};
use crate::common::generators::parameter;
use crate::common::law::{Law, Verdict, expect_equal};
use crate::divided_differences::all_values;
use crate::inputs::{BasisCase, Knots, bases, expect, hard_bases, hard_knot_vectors, knot_vectors};
use crate::suspects;

/// Tries a law of the basis on ordinary and hard knot vectors with a parameter of the closed domain.
fn on_bases(theorem: &'static str, check: impl Fn(&BasisCase) -> Verdict) {
    Law::new(theorem, suspects::basis).holds(bases(), hard_bases(), check);
}

/// The values of all functions, each by the recursion.
fn recursion(case: &BasisCase) -> Vec<Exact> {
    let vector = case.knots.vector();
    let value = |function| cox_de_boor(&vector, case.knots.degree, function, case.u);
    (0..case.knots.count()).map(value).collect()
}

/// The number of the span, and the values of the functions that `basis_functions` gives there.
fn triangle(case: &BasisCase) -> (usize, Vec<Exact>) {
    let vector = case.knots.vector();
    let span = case.knots.span_of(case.u);
    let mut values = vec![Exact::zero(); case.knots.degree + 1];
    basis_functions(&vector, span, case.u, &mut values);
    (span, values)
}

/// **One span for each parameter.** Every $u$ of the domain $[u_p,u_{n+1}]$ lies on exactly one span that is not empty, if spans are half-open,
/// $u_i\le u<u_{i+1}$, and the last one also has its right end. A repeated knot belongs to the span that begins there. Outside, the
/// first or the last span goes on.
///
/// Course: B11, slide 19, computing a point: find the span of u and of v.
/// Exercise: basis.
/// Erratum: the slide takes $u$ from a closed interval and writes $v\in[v_j,u_{j+1}]$. It must read $v_{j+1}$. And a knot lies in two closed intervals, or more if it is repeated: the interval must be half-open and not empty, except that the end of the domain belongs to the last one.
#[test]
fn every_parameter_has_one_span() {
    on_bases("bspline::every_parameter_has_one_span", |case| {
        let knots = &case.knots.knots;
        let vector = case.knots.vector();
        let [start, end] = case.knots.domain();
        let holds = |&span: &usize| knots[span] <= case.u && case.u < knots[span + 1];
        let spans = case.knots.spans();
        let mut expected: Vec<_> = (case.knots.degree..case.knots.count())
            .filter(holds)
            .collect();
        if case.u == end {
            expected = vec![spans[spans.len() - 1]];
        }
        expect_equal(&expected, &vec![find_span(&vector, case.u)])?;
        let outside = [start - Exact::one(), end + Exact::one()].map(|u| find_span(&vector, u));
        expect_equal(&[spans[0], spans[spans.len() - 1]], &outside)
    });
}

/// **The recursion.** Cox and de Boor's recursion computes a divided difference of a truncated power:
///
/// $$N_i^p(u)=(u_{i+p+1}-u_i)\,[u_i,\dots,u_{i+p+1}]\,(\,\cdot-u)_+^p,\qquad (x)_+^p=x^p\text{ for }x>0,\text{ else }0.$$
///
/// The **truncated power** $(\,\cdot-u)_+^p$ is a power to the right of $u$ and zero to the left of it. A **divided difference** of a function at some points is the
/// coefficient of the highest power in the polynomial that takes the function's values there; at a repeated point the polynomial takes its derivatives, too.
/// This is how Schoenberg and Curry defined B-splines, years before the recursion was found; it holds at every $u$, inside the domain and outside, for all
/// knots. The end of the domain is taken from the left.
///
/// Course: B01, slide 13, B-spline surfaces: definition.
/// Exercise: basis.
#[test]
fn recursion_is_the_divided_difference_of_a_truncated_power() {
    on_bases(
        "bspline::recursion_is_the_divided_difference_of_a_truncated_power",
        |case| expect_equal(&all_values(&case.knots, case.u), &recursion(case)),
    );
}

/// **The triangle.** On the span $i$, the functions $N_{i-p}^p,\dots,N_i^p$ that the triangular scheme computes are those of the recursion, and all others are zero.
///
/// Course: B11, slide 19, computing a point: the non-zero functions.
/// Exercise: basis.
#[test]
fn triangle_gives_the_functions_that_are_not_zero() {
    on_bases(
        "bspline::triangle_gives_the_functions_that_are_not_zero",
        |case| {
            let (span, values) = triangle(case);
            let mut all = vec![Exact::zero(); case.knots.count()];
            all[span - case.knots.degree..=span].copy_from_slice(&values);
            expect_equal(&all_values(&case.knots, case.u), &all)
        },
    );
}

/// **Non-negativity.** $N_i^p(u)\ge0$ for every $i$, every $p$ and every $u$, in the domain and outside: over any knots that do not decrease. So
/// $N_i^p(u)\,N_j^q(v)\ge0$.
///
/// Course: B03, slide 16, shape functions: non-negativity.
/// Exercise: basis.
#[test]
fn basis_functions_are_not_negative() {
    let cases = |knots: BoxedStrategy<Knots>| {
        (knots, parameter()).prop_map(|(knots, t)| {
            let last = knots.knots.len() - 1;
            // From one before the first knot to one after the last.
            let [start, end] = [
                knots.knots[0] - Exact::one(),
                knots.knots[last] + Exact::one(),
            ];
            let u = start.lerp(end, t);
            BasisCase { knots, u }
        })
    };
    let law = Law::new("bspline::basis_functions_are_not_negative", suspects::basis);
    let hard = cases(hard_knot_vectors(0..=4, 5).boxed());
    law.holds(cases(knot_vectors(0..=4, 5).boxed()), hard, |case| {
        let values = recursion(case);
        let is_negative = |value: &&Exact| **value < Exact::zero();
        let negative = values.iter().find(is_negative);
        expect("no negative value", negative.is_none(), negative)
    });
}

/// **Partition of unity.** $\sum_iN_i^p(u)=1$ for every $u$ of the closed domain $[u_p,u_{n+1}]$; so $\sum_i\sum_jN_i^p(u)\,N_j^q(v)=1$ there.
///
/// The end belongs to the domain, and it is the reason why the last span has both its ends.
///
/// Course: B04, slide 16, shape functions: partition of unity.
/// Exercise: basis.
#[test]
fn basis_functions_sum_to_one() {
    on_bases("bspline::basis_functions_sum_to_one", |case| {
        let sum = |values: Vec<Exact>| {
            values
                .into_iter()
                .fold(Exact::zero(), |sum, value| sum + value)
        };
        expect_equal(
            &[Exact::one(); 2],
            &[sum(recursion(case)), sum(triangle(case).1)],
        )
    });
}

/// **Where the sum is not one.** Two places look as if they belonged to $[u_{\min},u_{\max}]$, and the sum is not 1 there. With half-open spans everywhere, as
/// the recursion's first line has them, all functions vanish at $u_{\max}$: for $U=\{0,0,0,0,1,1,1,1\}$ the sum at 1 is 0. And if the end knots are simple,
/// the outer $p$ spans do not belong to the domain: for $U=\{-3,\dots,15\}$ and $p=3$ the sum at $-2$ is $\tfrac16$.
///
/// Course: B04, slide 16, shape functions: partition of unity.
/// Exercise: basis.
/// Erratum: the slide asserts the partition of unity for all of $[u_{\min},u_{\max}]$. It holds for $u_{\min}=u_p$ and $u_{\max}=u_{r-p}$, not for the first and the last knot, and at $u_{\max}$ only if the last span is closed.
#[test]
fn basis_functions_do_not_sum_to_one_everywhere() {
    let once = (Just(3_usize), Just(()));
    let law = Law::new(
        "bspline::basis_functions_do_not_sum_to_one_everywhere",
        suspects::basis,
    );
    law.on_cases(4).holds(once, once, |&(p, ())| {
        let bezier = Knots::integers(p, &[0, 0, 0, 0, 1, 1, 1, 1]);
        let half_open: Vec<_> = (0..4)
            .map(|i| half_open_value(&bezier.knots, p, i, Exact::one()))
            .collect();
        expect_equal(&vec![Exact::zero(); 4], &half_open)?;
        let periodic = Knots::integers(p, &(-3..=15).collect::<Vec<_>>());
        expect_equal(&[fraction(0, 1), fraction(12, 1)], &periodic.domain())?;
        let sums = [-2, -1, 0, 12, 13, 15].map(|u| {
            let u = fraction(u, 1);
            let values = recursion(&BasisCase {
                knots: periodic.clone(),
                u,
            });
            values
                .into_iter()
                .fold(Exact::zero(), |sum, value| sum + value)
        });
        let expected =
            [[1, 6], [5, 6], [1, 1], [1, 1], [5, 6], [0, 1]].map(|[a, b]| fraction(a, b));
        expect_equal(&expected, &sums)
    });
}

/// The recursion with half-open spans everywhere, the last one too.
fn half_open_value(knots: &[Exact], degree: usize, i: usize, u: Exact) -> Exact {
    if degree == 0 {
        let holds = knots[i] <= u && u < knots[i + 1];
        return if holds { Exact::one() } else { Exact::zero() };
    }
    let part = |from: usize, distance: Exact| {
        let width = knots[from + degree] - knots[from];
        if width.is_zero() {
            return Exact::zero();
        }
        distance / width * half_open_value(knots, degree - 1, from, u)
    };
    part(i, u - knots[i]) + part(i + 1, knots[i + degree + 1] - u)
}

/// **Local support.** $N_i^p$ is zero outside $[u_i,u_{i+p+1})$ and positive everywhere inside $(u_i,u_{i+p+1})$. One function may have its
/// right end too: where the domain ends at a knot that it has $p+1$ times, as the last function of a clamped knot vector, its value there is 1.
///
/// Course: B05, slide 16, shape functions: compact support.
/// Exercise: basis.
/// Erratum: the slide's second interval, $[v_j,u_{j+q+1}[$, must read $[v_j,v_{j+q+1}[$. And the support must have its right end at the end of the domain: with clamped knots $N_n^p(u_{\max})=1$, although $u_{\max}\notin[u_n,u_{n+p+1}[$.
#[test]
fn basis_function_is_positive_on_its_support_and_zero_elsewhere() {
    on_bases(
        "bspline::basis_function_is_positive_on_its_support_and_zero_elsewhere",
        |case| {
            let (p, u) = (case.knots.degree, case.u);
            let at_the_end = u == case.knots.domain()[1];
            for (function, value) in recursion(case).into_iter().enumerate() {
                let own = case.knots.support(function);
                let (start, end) = (own[0], own[p + 1]);
                let of_the_end = at_the_end && end == u && own[1] == u;
                if u < start || (u >= end && !of_the_end) {
                    expect_equal(&(function, Exact::zero()), &(function, value))?;
                }
                if of_the_end {
                    expect_equal(&(function, Exact::one()), &(function, value))?;
                }
                if start < u && u < end {
                    let promise = format!("N_{function} positive inside its support");
                    expect(&promise, value > Exact::zero(), value)?;
                }
            }
            Ok(())
        },
    );
}

/// **At most $p+1$.** On the span $[u_i,u_{i+1})$ no functions but $N_{i-p}^p,\dots,N_i^p$ are not zero. Strictly inside a span that is not empty, these
/// $p+1$ are all positive; so $(p+1)(q+1)$ products $N_k^p(u)\,N_l^q(v)$ inside a rectangle.
///
/// Course: B06, slide 16, shape functions: at most (p+1)(q+1) are not zero.
/// Exercise: basis.
/// Erratum: the slide's second interval, $[v_{j_0},u_{j_0+1}[$, must read $[v_{j_0},v_{j_0+1}[$. And it says that on $[u_{i_0},u_{i_0+1}[$ the functions with $i_0-p\le i\le i_0$ are not zero. They are the only ones that *may* be different from zero: at the knot itself, if it is simple, $N_{i_0}^p(u_{i_0})=0$. For $U=\{0,1,\dots,9\}$ and $p=2$, $N_4^2(4)=0$.
#[test]
fn at_most_p_plus_one_functions_are_not_zero() {
    let at_a_knot = BasisCase {
        knots: Knots::integers(2, &[0, 1, 2, 3, 4, 5, 6, 7, 8, 9]),
        u: fraction(4, 1),
    };
    on_bases(
        "bspline::at_most_p_plus_one_functions_are_not_zero",
        |case| {
            let p = case.knots.degree;
            let span = case.knots.span_of(case.u);
            let values = recursion(case);
            let positive: Vec<_> = (0..values.len())
                .filter(|&i| values[i] > Exact::zero())
                .collect();
            let listed = span - p..=span;
            expect(
                &format!("only functions {listed:?}"),
                positive.iter().all(|i| listed.contains(i)),
                &positive,
            )?;
            let is_inside = case.knots.knots[span] < case.u && case.u < case.knots.knots[span + 1];
            if is_inside {
                expect_equal(&listed.collect::<Vec<_>>(), &positive)?;
            }
            expect_equal(&Exact::zero(), &recursion(&at_a_knot)[4])
        },
    );
}
