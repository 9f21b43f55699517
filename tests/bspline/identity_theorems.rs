//! Identities of the basis functions: what they sum to with other weights, and what they are over other knots.

use facette::bspline::{KnotVector, basis_functions, cox_de_boor};
use num_traits::{One, Zero};
use proptest::prelude::*;

use crate::common::exact::{Exact, fraction};
use crate::common::generators::{coordinate, hard_parameter, parameter};
use crate::common::law::{Law, expect_equal};
use crate::divided_differences::all_values;
use crate::inputs::{BasisCase, Knots, bases, hard_bases, whole};
use crate::suspects;

/// The number of the span, and the values that `basis_functions` gives there.
fn triangle(case: &BasisCase) -> (usize, Vec<Exact>) {
    let span = case.knots.span_of(case.u);
    let mut values = vec![Exact::zero(); case.knots.degree + 1];
    basis_functions(&case.knots.vector(), span, case.u, &mut values);
    (span, values)
}

/// **Marsden's identity.** For every $u$ of the domain and every $t$,
///
/// $$(t-u)^p=\sum_i\Bigl(\prod_{j=1}^p(t-u_{i+j})\Bigr)N_i^p(u).$$
///
/// Both sides are polynomials in $t$; each power of $t$ says how to write a power of $u$ as a B-spline. The highest says that the
/// functions sum to 1, and all together that *every* polynomial of degree $p$ is a B-spline.
///
/// Course: B04, slide 16, shape functions: partition of unity.
/// Exercise: basis.
#[test]
fn marsdens_identity_writes_every_polynomial() {
    let law = Law::new(
        "bspline::marsdens_identity_writes_every_polynomial",
        suspects::basis,
    );
    law.holds(
        (bases(), coordinate()),
        (hard_bases(), coordinate()),
        |(case, t)| {
            let p = case.knots.degree;
            let (span, values) = triangle(case);
            let factor = |function: usize| {
                let own = &case.knots.support(function)[1..=p];
                own.iter()
                    .fold(Exact::one(), |product, &knot| product * (*t - knot))
            };
            let terms = values.into_iter().zip(span - p..=span);
            let sum = terms.fold(Exact::zero(), |sum, (value, function)| {
                sum + value * factor(function)
            });
            expect_equal(&num_traits::pow(*t - case.u, p), &sum)
        },
    );
}

/// **Linear precision.** The parameter itself is a B-spline: $\sum_i\xi_i\,N_i^p(u)=u$ for $p\ge1$ on the whole domain, with the **Greville abscissae**
/// $\xi_i=\frac{u_{i+1}+\dots+u_{i+p}}p$. So control points that lie evenly *at the abscissae* make a straight line at constant speed.
///
/// Course: B04, slide 16, shape functions: partition of unity.
/// Exercise: basis.
#[test]
fn greville_abscissae_reproduce_the_parameter() {
    let law = Law::new(
        "bspline::greville_abscissae_reproduce_the_parameter",
        suspects::basis,
    );
    law.holds(bases(), hard_bases(), |case| {
        let p = case.knots.degree;
        if p == 0 {
            return Ok(());
        }
        let mean = |function: usize| {
            let own = &case.knots.support(function)[1..=p];
            own.iter().fold(Exact::zero(), |sum, &knot| sum + knot) / whole(p)
        };
        let means: Vec<_> = (0..case.knots.count()).map(mean).collect();
        expect_equal(&means, &case.knots.vector().greville_abscissae())?;
        let (span, values) = triangle(case);
        let terms = values.into_iter().zip(&means[span - p..]);
        expect_equal(
            &case.u,
            &terms.fold(Exact::zero(), |sum, (value, &mean)| sum + value * mean),
        )
    });
}

/// **Bernstein's polynomials.** Over the knots $\{0^{p+1},1^{p+1}\}$ (each end $p+1$ times) the functions are the Bernstein polynomials
/// $\binom{p}{i}(1-u)^{p-i}u^i$: Bézier curves are the B-splines without inner knots.
///
/// Course: B14, slide 23, properties of the surface: a Bézier patch as a special case.
/// Exercise: basis.
#[test]
fn basis_without_inner_knots_is_bernsteins() {
    let law = Law::new(
        "bspline::basis_without_inner_knots_is_bernsteins",
        suspects::basis,
    );
    let ends = prop::sample::select(vec![
        fraction(0, 1),
        fraction(1, 1),
        fraction(1, 1 << 30),
        fraction(1, 2),
    ]);
    law.holds(
        (0..=9_usize, parameter()),
        (0..=9_usize, ends),
        |&(p, u)| {
            let vector = KnotVector::<Exact>::bezier(p);
            let mut values = vec![Exact::zero(); p + 1];
            basis_functions(&vector, p, u, &mut values);
            let binomial = |i: usize| {
                (0..i).fold(Exact::one(), |product, j| {
                    product * whole(p - j) / whole(j + 1)
                })
            };
            let power = num_traits::pow::<Exact>;
            let bernstein = |i: usize| binomial(i) * power(Exact::one() - u, p - i) * power(u, i);
            expect_equal(&(0..=p).map(bernstein).collect::<Vec<_>>(), &values)
        },
    );
}

/// **Only ratios count.** Scaling and shifting the knots and the parameter alike changes no value: with $\varphi(t)=at+b$, $a>0$, the functions over
/// $\varphi(U)$ at $\varphi(u)$ are those over $U$ at $u$. Whether a domain is $[0,1]$ or $[0,12]$ is a matter of taste.
///
/// Course: B19, slide 27, periodic surfaces: knot vectors over other domains.
/// Exercise: basis.
#[test]
fn basis_does_not_change_with_the_scale_of_the_knots() {
    let scale = || (1..=12, 1..=6).prop_map(|(a, b)| fraction(a, b));
    let law = Law::new(
        "bspline::basis_does_not_change_with_the_scale_of_the_knots",
        suspects::basis,
    );
    law.holds(
        (bases(), scale(), coordinate()),
        (hard_bases(), scale(), hard_parameter()),
        |(case, a, b)| {
            let map = |t: Exact| *a * t + *b;
            let knots = case.knots.knots.iter().map(|&knot| map(knot)).collect();
            let mapped = BasisCase {
                knots: Knots {
                    knots,
                    ..case.knots.clone()
                },
                u: map(case.u),
            };
            let vector = mapped.knots.vector();
            let value = |i| cox_de_boor(&vector, mapped.knots.degree, i, mapped.u);
            let recursion: Vec<_> = (0..mapped.knots.count()).map(value).collect();
            expect_equal(&all_values(&case.knots, case.u), &recursion)?;
            let domain = mapped.knots.domain();
            let library = case
                .knots
                .vector()
                .reparametrised(domain)
                .expect("the domain is an interval");
            expect_equal(&mapped.knots.knots, &library.knots().to_vec())
        },
    );
}
