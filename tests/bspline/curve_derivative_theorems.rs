//! The theorems of a curve's derivatives and of its blossom.

use facette::algebra::VectorSpace;
use facette::bspline::{BsplineCurve, KnotVector, blossom, de_boor_point};
use facette::coons::{Boundary, bilinear_point};
use facette::curve::Curve;
use num_traits::{One, Zero};

use crate::common::dual::{constant, slopes, variable};
use crate::common::exact::{Exact, fraction};
use crate::common::generators::{coordinate, parameter};
use crate::common::law::{Law, expect_equal};
use crate::inputs::{Point, curves, hard_curves, whole};
use crate::suspects;

/// **The derivative is a B-spline.** $C'$ is the B-spline of degree $p-1$ over the same knots without the first and the last, with the control points
///
/// $$Q_i=\frac p{u_{i+p+1}-u_{i+1}}\,(P_{i+1}-P_i).$$
///
/// The test takes the derivative of de Boor's points with dual numbers $u+\varepsilon$, and compares `derivative_curve` and `derivative_at` with it.
///
/// Course: B08, slide 17, shape functions: continuity.
/// Exercise: curve.
#[test]
fn derivative_of_a_curve_is_a_bspline() {
    let law = Law::new(
        "bspline::derivative_of_a_curve_is_a_bspline",
        suspects::curve,
    );
    law.holds(curves(), hard_curves(), |case| {
        let duals = case
            .knots
            .knots
            .iter()
            .map(|&knot| constant(knot))
            .collect();
        let vector = KnotVector::new(case.knots.degree, duals)
            .expect("constant knots are as valid as the numbers");
        let points: Vec<_> = case
            .points
            .iter()
            .map(|point| point.map(constant))
            .collect();
        let slope = slopes(de_boor_point(&vector, &points, variable(case.u)));
        let curve = case.curve();
        expect_equal(&slope, &curve.derivative_curve().point(case.u))?;
        expect_equal(&slope, &curve.derivative_at(1, case.u))?;
        expect_equal(&Some(slope), &curve.derivative(case.u))
    });
}

/// **Control points of the derivative.** Over knots of which none stands more than $p$ times inside, these are the differences of neighbours, one less than there are control points.
///
/// Course: B08, slide 17, shape functions: continuity.
#[test]
fn control_points_of_the_derivative_are_differences() {
    let law = Law::new(
        "bspline::control_points_of_the_derivative_are_differences",
        suspects::library,
    );
    law.holds(curves(), hard_curves(), |case| {
        let (knots, p) = (&case.knots.knots, case.knots.degree);
        let inner = &knots[1..knots.len() - 1];
        if p == 0 || inner.windows(p + 1).any(|window| window[0] == window[p]) {
            return Ok(());
        }
        let difference = |i: usize| {
            let factor = whole(p) / (knots[i + p + 1] - knots[i + 1]);
            case.points[i + 1].minus(case.points[i]).times(factor)
        };
        let expected: Vec<_> = (0..case.points.len() - 1).map(difference).collect();
        let derivative = case.curve().derivative_curve();
        expect_equal(&inner, &derivative.knots().knots())?;
        expect_equal(&&expected[..], &derivative.control_points())
    });
}

/// **Derivatives of every order.** The derivative of order $k+1$ is the derivative of the one of order $k$; those above the degree are zero.
///
/// Course: B08, slide 17, shape functions: continuity.
#[test]
fn higher_derivatives_are_derivatives_of_derivatives() {
    let law = Law::new(
        "bspline::higher_derivatives_are_derivatives_of_derivatives",
        suspects::library,
    );
    law.holds(curves(), hard_curves(), |case| {
        let curve = case.curve();
        let mut derivative = curve.clone();
        for order in 0..=case.knots.degree + 2 {
            let expected = derivative.point(case.u);
            expect_equal(
                &(order, expected),
                &(order, curve.derivative_at(order, case.u)),
            )?;
            derivative = derivative.derivative_curve();
        }
        expect_equal(
            &Point::origin(),
            &curve.derivative_at(case.knots.degree + 1, case.u),
        )
    });
}

/// **The blossom.** The polynomial of a span has a *blossom*: a function of $p$ arguments that is symmetric, affine in each of them, and the curve's point where all are equal to $u$. At $p$
/// consecutive knots it is a control point: $b(u_{j+1},\dots,u_{j+p})=P_j$. Knot insertion, Bézier points and de Boor's points are all its values.
///
/// Course: B11, slide 19, computing a point: combine the control points.
#[test]
fn blossom_is_symmetric_affine_and_the_curve_on_its_diagonal() {
    let law = Law::new(
        "bspline::blossom_is_symmetric_affine_and_the_curve_on_its_diagonal",
        suspects::library,
    );
    let more = || (proptest::collection::vec(coordinate(), 5), parameter());
    law.holds(
        (curves(), more()),
        (hard_curves(), more()),
        |(case, (others, t))| {
            let (p, span) = (case.knots.degree, case.knots.span_of(case.u));
            let vector = case.knots.vector();
            let b = |arguments: &[Exact]| blossom(&vector, &case.points, span, arguments);
            expect_equal(&case.expected(), &b(&vec![case.u; p]))?;
            for j in span - p..=span {
                expect_equal(
                    &(j, case.points[j]),
                    &(j, b(&case.knots.knots[j + 1..=j + p])),
                )?;
            }
            let mut arguments = others[..p].to_vec();
            let original = b(&arguments);
            arguments.reverse();
            expect_equal(&original, &b(&arguments))?;
            if p == 0 {
                return Ok(());
            }
            let (first, end) = (arguments[0], others[p]);
            let at = |argument: Exact| b(&[&[argument], &arguments[1..]].concat());
            expect_equal(&at(first).lerp(at(end), *t), &at(first.lerp(end, *t)))
        },
    );
}

/// **A boundary of a Coons patch.** A B-spline curve is a curve as any other: reparametrised to $[0,1]$, which changes no point, four of them that meet bound a Coons patch, and the patch carries them.
///
/// Course: B19, slide 27, periodic surfaces: knot vectors over other domains.
#[test]
fn reparametrised_curves_bound_a_coons_patch() {
    let law = Law::new(
        "bspline::reparametrised_curves_bound_a_coons_patch",
        suspects::library,
    );
    law.on_cases(32).holds(
        (curves(), parameter()),
        (hard_curves(), parameter()),
        |(case, t)| {
            let unit = [Exact::zero(), Exact::one()];
            let [start, end] = case.knots.domain();
            let p1 = case
                .curve()
                .reparametrised(unit)
                .expect("the unit interval is a domain");
            expect_equal(&unit, &p1.domain())?;
            let moved = p1.point((case.u - start) / (end - start));
            expect_equal(&case.expected(), &moved)?;
            let lift = [Exact::one(), fraction(2, 1), fraction(3, 1)];
            let p2 = case
                .mapped(|p| p.plus(lift))
                .curve()
                .reparametrised(unit)
                .expect("as before");
            let side = |u: Exact| {
                let foot = case.curve().point(u);
                let knots = KnotVector::bezier(1);
                BsplineCurve::new(knots, vec![foot, foot.plus(lift)])
                    .expect("two points and four knots")
            };
            let boundary = Boundary::new(p1.clone(), p2, side(start), side(end))
                .expect("the sides join the ends");
            expect_equal(&p1.point(*t), &bilinear_point(&boundary, *t, Exact::zero()))
        },
    );
}
