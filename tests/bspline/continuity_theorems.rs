//! The theorems of the basis functions' shape: one maximum, polynomials on the spans, and how smoothly these join at the knots.

use std::cmp::Ordering;

use facette::algebra::{Scalar, VectorSpace};
use facette::bspline::{basis_derivatives, cox_de_boor};
use num_traits::{One, Zero};

use crate::common::dual::{Dual, constant, variable};
use crate::common::exact::{Exact, fraction};
use crate::common::law::{Law, Verdict, expect_equal};
use crate::divided_differences::divided_difference_basis;
use crate::inputs::{BasisCase, Knots, bases, expect, hard_bases, whole};
use crate::suspects;

fn on_bases(theorem: &'static str, check: impl Fn(&BasisCase) -> Verdict) {
    Law::new(theorem, suspects::library).holds(bases(), hard_bases(), check);
}

/// The derivatives of orders 0 to `order` at `u` of the polynomials on `span`: one row of p + 1 values for each order.
fn rows<S: Scalar>(
    vector: &facette::bspline::KnotVector<S>,
    span: usize,
    u: S,
    order: usize,
) -> Vec<Vec<S>> {
    let width = vector.degree() + 1;
    let mut values = vec![S::zero(); (order + 1) * width];
    basis_derivatives(vector, span, u, &mut values);
    values.chunks(width).map(<[S]>::to_vec).collect()
}

/// The derivative of this order of the function number `function` at `u`, by the polynomial on `span`.
fn derivative(knots: &Knots, function: usize, span: usize, u: Exact, order: usize) -> Exact {
    let first = span - knots.degree;
    let row = &rows(&knots.vector(), span, u, order)[order];
    function
        .checked_sub(first)
        .and_then(|place| row.get(place).copied())
        .unwrap_or_else(Exact::zero)
}

/// **One polynomial on each span.** On a span each $N_i^p$ is one polynomial of degree at most $p$: the differences of order $p+1$ of its values at $p+2$ equidistant
/// places vanish. So it has all derivatives there, and those above the $p$-th are zero.
///
/// Course: B12, slide 20, one polynomial for each rectangle of knots.
/// Exercise: basis.
#[test]
fn basis_functions_are_polynomials_on_each_span() {
    let law = Law::new(
        "bspline::basis_functions_are_polynomials_on_each_span",
        suspects::basis,
    );
    law.holds(bases(), hard_bases(), |case| {
        let (p, vector) = (case.knots.degree, case.knots.vector());
        let span = case.knots.span_of(case.u);
        let [start, end] = [case.knots.knots[span], case.knots.knots[span + 1]];
        for function in span - p..=span {
            let at = |place: usize| {
                let u = start.lerp(end, whole(place) / whole(p + 2));
                cox_de_boor(&vector, p, function, u)
            };
            let mut values: Vec<_> = (0..p + 2).map(at).collect();
            while values.len() > 1 {
                values = values.windows(2).map(|pair| pair[1] - pair[0]).collect();
            }
            expect_equal(&(function, Exact::zero()), &(function, values[0]))?;
        }
        Ok(())
    });
}

/// **Derivatives of the functions.** The rows of `basis_derivatives` are derivatives of each other: row $k+1$ is what dual numbers $u+\varepsilon$ make of row $k$, and row 0
/// are the functions. Beyond row $p$ there are zeros.
///
/// Course: B08, slide 17, shape functions: continuity.
#[test]
fn basis_derivatives_agree_with_dual_numbers() {
    on_bases(
        "bspline::basis_derivatives_agree_with_dual_numbers",
        |case| {
            let p = case.knots.degree;
            let span = case.knots.span_of(case.u);
            let derivatives = rows(&case.knots.vector(), span, case.u, p + 2);
            let duals = case
                .knots
                .knots
                .iter()
                .map(|&knot| constant(knot))
                .collect();
            let dual_vector = facette::bspline::KnotVector::<Dual<Exact>>::new(p, duals);
            let dual_vector = dual_vector.expect("constant knots are as valid as the numbers");
            let dual_rows = rows(&dual_vector, span, variable(case.u), p + 2);
            let functions = (span - p..=span)
                .map(|function| divided_difference_basis(&case.knots, function, case.u));
            expect_equal(&functions.collect::<Vec<_>>(), &derivatives[0])?;
            for order in 0..p + 2 {
                let slopes: Vec<_> = dual_rows[order].iter().map(|value| value.slope).collect();
                expect_equal(&(order + 1, &slopes), &(order + 1, &derivatives[order + 1]))?;
            }
            expect_equal(&vec![Exact::zero(); p + 1], &derivatives[p + 1])
        },
    );
}

/// **The derivative is a difference.** For $p\ge1$ the derivative of a basis function is a difference of two functions of the next lower degree:
///
/// $$\frac{d}{du}N_i^p(u)=\frac p{u_{i+p}-u_i}\,N_i^{p-1}(u)-\frac p{u_{i+p+1}-u_{i+1}}\,N_{i+1}^{p-1}(u),$$
///
/// where a term over zero is zero: its function is zero everywhere.
///
/// Course: B08, slide 17, shape functions: continuity.
/// Exercise: basis.
#[test]
fn derivative_is_a_difference_of_functions_of_lower_degree() {
    let law = Law::new(
        "bspline::derivative_is_a_difference_of_functions_of_lower_degree",
        suspects::basis,
    );
    law.holds(bases(), hard_bases(), |case| {
        let (p, vector) = (case.knots.degree, case.knots.vector());
        if p == 0 {
            return Ok(());
        }
        let span = case.knots.span_of(case.u);
        let knots = &case.knots.knots;
        let term = |i: usize| {
            let width = knots[i + p] - knots[i];
            if width.is_zero() {
                width
            } else {
                whole(p) / width * cox_de_boor(&vector, p - 1, i, case.u)
            }
        };
        for function in span - p..=span {
            let expected = derivative(&case.knots, function, span, case.u, 1);
            expect_equal(
                &(function, expected),
                &(function, term(function) - term(function + 1)),
            )?;
        }
        Ok(())
    });
}

/// **$C^{p-k}$ and not more.** Let $N_i^p$ have the inner knot $t$ exactly $k'$ times among its own $p+2$ knots. There its derivatives up to the order $p-k'$ agree from both
/// sides, and the next one, of order $p-k'+1$, jumps. A knot of multiplicity $k$ stands among the knots of any function at most $k$ times, so all functions have at least $p-k$
/// continuous derivatives; with $k=p$ they are continuous with a kink, with $k=p+1$ they jump.
///
/// Course: B08, slide 17, shape functions: continuity.
#[test]
fn functions_are_as_smooth_as_their_own_knots_say_and_not_more() {
    on_bases(
        "bspline::functions_are_as_smooth_as_their_own_knots_say_and_not_more",
        |case| {
            let (p, spans) = (case.knots.degree, case.knots.spans());
            for pair in spans.windows(2) {
                let knot = case.knots.knots[pair[1]];
                for function in pair[0] - p..=pair[1] {
                    let own = case.knots.own_multiplicity(function, knot);
                    let jump = |order: usize| {
                        let [left, right] = [pair[0], pair[1]]
                            .map(|span| derivative(&case.knots, function, span, knot, order));
                        right - left
                    };
                    let first = (0..=p + 1).find(|&order| !jump(order).is_zero());
                    let expected = (own > 0).then(|| p + 1 - own);
                    expect_equal(&(function, knot, expected), &(function, knot, first))?;
                }
            }
            Ok(())
        },
    );
}

/// **Smoother than the knot says.** Over $U=\{0,0,0,1,1,2,2,2\}$, $p=2$, the knot 1 is double, so that $p-k=0$. But $N_0^2$ has it only once among its own knots $\{0,0,0,1\}$, and its first
/// derivative is continuous there: 0 from both sides. $N_1^2$, with the knots $\{0,0,1,1\}$, has it twice, and a kink: its slope is $-2$ before and 0 after.
///
/// Course: B08, slide 17, shape functions: continuity.
/// Erratum: the slide says that at a knot of multiplicity $k$ the functions are $p-k$ times differentiable. That is what all of them have in common; a function that has the knot only $k'<k$ times among its own is smoother, $p-k'$ times.
#[test]
fn functions_may_be_smoother_than_the_knot_says() {
    let knots = Knots::integers(2, &[0, 0, 0, 1, 1, 2, 2, 2]);
    let slopes = |function| [2, 4].map(|span| derivative(&knots, function, span, Exact::one(), 1));
    assert_eq!(slopes(0), [0, 0].map(Exact::from_i32));
    assert_eq!(slopes(1), [-2, 0].map(Exact::from_i32));
}

/// **One maximum.** Let $p\ge1$, and let the right end $u_{i+p+1}$ of the support stand at most $p$ times among the function's knots, or be the end of the domain. Then $N_i^p$ rises
/// strictly up to one place and falls strictly after it: its maximum is unique. The maximum of $N_i^p(u)\,N_j^q(v)$ is at the pair of both places, and nowhere else.
///
/// The test samples each span at 13 places, exactly: the differences must change sign once, from plus to minus, and only the two values next to the maximum may be equal.
///
/// Course: B07, slide 17, shape functions: extrema.
/// Exercise: basis.
#[test]
fn basis_function_has_one_maximum() {
    let law = Law::new("bspline::basis_function_has_one_maximum", suspects::basis);
    law.holds(bases(), hard_bases(), |case| {
        let (p, vector) = (case.knots.degree, case.knots.vector());
        let [start, end] = case.knots.domain();
        let function = case.knots.span_of(case.u) - p / 2;
        let own = case.knots.support(function);
        let open_right_end = own[1] == own[p + 1] && own[p + 1] != end;
        if p == 0 || open_right_end {
            return Ok(());
        }
        let mut places: Vec<_> = own
            .windows(2)
            .flat_map(|span| (0..12).map(|twelfth| span[0].lerp(span[1], fraction(twelfth, 12))))
            .collect();
        places.push(own[p + 1]);
        places.retain(|&u| start <= u && u <= end);
        places.dedup();
        let values: Vec<_> = places
            .iter()
            .map(|&u| cox_de_boor(&vector, p, function, u))
            .collect();
        let promise = format!("N_{function} rising to one maximum, then falling");
        expect(
            &promise,
            rises_then_falls(&values),
            places.iter().zip(&values).collect::<Vec<_>>(),
        )
    });
}

/// Whether the values increase, then decrease, strictly; only the two next to the top may be equal.
fn rises_then_falls(values: &[Exact]) -> bool {
    let steps = values.windows(2).map(|pair| pair[1].partial_cmp(&pair[0]));
    let steps: Vec<_> = steps
        .skip_while(|&step| step == Some(Ordering::Greater))
        .collect();
    let rest = match steps.split_first() {
        Some((&Some(Ordering::Equal), rest)) => rest,
        _ => &steps[..],
    };
    rest.iter().all(|&step| step == Some(Ordering::Less))
}

/// **A maximum that is not attained.** Over $U=\{0,0,1,1,2,2\}$, $p=1$, the function $N_1^1(u)=u$ on $[0,1)$ comes as near to 1 as one likes, but at 1 it is already 0, since the knot 1 stands $p+1$
/// times in $U$: there is no maximum, let alone a unique one. At the end of the domain, where the last span has both its ends, $N_3^1(2)=1$ is one.
///
/// Course: B07, slide 17, shape functions: extrema.
/// Erratum: the slide promises a unique maximum whenever $p>0$ and $q>0$. It needs one more condition: no inner knot of multiplicity $p+1$ may end the support.
#[test]
fn maximum_may_not_be_attained() {
    let vector = Knots::integers(1, &[0, 0, 1, 1, 2, 2]).vector();
    let value = |function: usize, u: Exact| cox_de_boor(&vector, 1, function, u);
    let below_one = fraction((1 << 30) - 1, 1 << 30);
    assert_eq!(value(1, below_one), below_one);
    assert_eq!(value(1, Exact::one()), Exact::zero());
    assert_eq!(value(3, fraction(2, 1)), Exact::one());
}
