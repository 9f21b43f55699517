//! The theorems of Bézier curves and of curves in general. The book shows their doc comments.

use std::cell::Cell;

use facette::algebra::{Scalar, VectorSpace};
use facette::curve::{BezierCurve, BoxedCurve, Curve, FunctionCurve, Polyline};
use num_traits::One;
use proptest::collection::vec;
use proptest::prelude::*;

use crate::common::dual::{dual_bezier, slopes, variable};
use crate::common::exact::{Exact, fraction};
use crate::common::generators::{
    float_coordinate, float_parameter, hard_float_coordinate, hard_float_parameter, hard_parameter,
    parameter, point,
};
use crate::common::law::{expect_at_most, expect_equal};
use crate::common::oracle::{big, big_bezier, largest_error};
use crate::inputs::{
    Point, bezier, control_points, expect, extreme, finite, hard_control_points, law,
};

/// The Bernstein polynomials of degree `n` at `t`, each from Pascal's triangle and powers.
fn bernstein(n: usize, t: Exact) -> Vec<Exact> {
    let mut row = vec![Exact::one()];
    for _ in 0..n {
        let inner = row.windows(2).map(|pair| pair[0] + pair[1]);
        row = [vec![Exact::one()], inner.collect(), vec![Exact::one()]].concat();
    }
    let power = |base, exponent| num_traits::pow(base, exponent);
    let weight =
        |(i, binomial): (usize, Exact)| binomial * power(Exact::one() - t, n - i) * power(t, i);
    row.into_iter().enumerate().map(weight).collect()
}

fn weighted_sum(weights: &[Exact], points: &[Point]) -> Point {
    let terms = weights
        .iter()
        .zip(points)
        .map(|(&weight, point)| point.times(weight));
    terms.fold(Point::origin(), VectorSpace::plus)
}

/// **De Casteljau is Bernstein.** Repeated interpolation between neighbouring points gives the sum
/// $C(t)=\sum_{i=0}^n\binom ni(1-t)^{n-i}\,t^i\,b_i$, for every degree $n$ and every $t$, outside $[0,1]$ too.
#[test]
fn de_casteljau_is_the_bernstein_sum() {
    let curves = (control_points(0..=6), parameter());
    let hard = (hard_control_points(), hard_parameter());
    law("ground_floor::de_casteljau_is_the_bernstein_sum").holds(curves, hard, |(points, t)| {
        let sum = weighted_sum(&bernstein(points.len() - 1, *t), points);
        expect_equal(&sum, &bezier(points).point(*t))
    });
    assert_eq!(bezier(&[[1.0], [2.0], [4.0]]).degree(), 2);
}

/// **The ends of a Bézier curve.** $C(0)=b_0$ and $C(1)=b_n$, exactly, in floating point too and for all finite control points.
#[test]
fn bezier_begins_and_ends_at_its_control_points() {
    let curves = vec([finite(), finite(), finite()], 1..=25);
    let hard = vec([extreme(), extreme(), extreme()], 1..=25);
    law("ground_floor::bezier_begins_and_ends_at_its_control_points").holds(
        curves,
        hard,
        |points| {
            let curve = bezier(points);
            expect_equal(&[0.0, 1.0], &curve.domain())?;
            expect_equal(
                &[points[0], points[points.len() - 1]],
                &[curve.point(0.0), curve.point(1.0)],
            )
        },
    );
}

/// **The derivative.** $C'(t)$ is the derivative of $C$: what dual numbers find by differentiating de Casteljau's scheme step by
/// step is $n$ times the difference of its last two points.
#[test]
fn bezier_derivative_is_the_derivative() {
    let curves = (control_points(0..=6), parameter());
    let hard = (hard_control_points(), hard_parameter());
    law("ground_floor::bezier_derivative_is_the_derivative").holds(curves, hard, |(points, t)| {
        let curve = bezier(points);
        let slope = slopes(dual_bezier(&curve).point(variable(*t)));
        expect_equal(&Some(slope), &curve.derivative(*t))
    });
}

/// **Affine invariance.** An affine map of space (a linear map $A$ and a shift $x$) may be applied to the curve or to its control
/// points: $C$ of the points $A\,b_i+x$ is $A\,C(t)+x$. So a curve moves, turns, shears and grows with its control points.
#[test]
fn bezier_is_affinely_invariant() {
    let maps = || [point(), point(), point(), point()];
    let curves = (control_points(0..=5), parameter(), maps());
    let onto_a_plane = maps().prop_map(|[a, b, _, shift]| [a, b, Point::origin(), shift]);
    let hard = (hard_control_points(), hard_parameter(), onto_a_plane);
    let theorem = law("ground_floor::bezier_is_affinely_invariant");
    theorem.holds(curves, hard, |(points, t, [a, b, c, shift])| {
        let linear = |p: Point| a.times(p[0]).plus(b.times(p[1])).plus(c.times(p[2]));
        let map = |p: Point| linear(p).plus(*shift);
        let mapped: Vec<_> = points.iter().map(|&p| map(p)).collect();
        expect_equal(&map(bezier(points).point(*t)), &bezier(&mapped).point(*t))
    });
}

/// **Convex hull.** For $0\le t\le1$ the weights are not negative and their sum is 1, so the curve stays in the convex hull of its
/// control points. In particular it never leaves the box of their coordinates.
#[test]
fn bezier_stays_in_the_box_of_its_control_points() {
    let curves = (control_points(0..=6), parameter());
    let inside =
        hard_parameter().prop_filter("inside", |t| Exact::from_i32(0) <= *t && *t <= Exact::one());
    law("ground_floor::bezier_stays_in_the_box_of_its_control_points").holds(
        curves,
        (hard_control_points(), inside),
        |(points, t)| {
            let weights = bernstein(points.len() - 1, *t);
            let sum = weights
                .iter()
                .fold(Exact::from_i32(0), |sum, &weight| sum + weight);
            expect_equal(&Exact::one(), &sum)?;
            expect(
                "no negative weight",
                weights.iter().all(|w| *w >= Exact::from_i32(0)),
                &weights,
            )?;
            let on_curve = bezier(points).point(*t);
            for axis in 0..3 {
                let below = points.iter().any(|p| p[axis] <= on_curve[axis]);
                let above = points.iter().any(|p| p[axis] >= on_curve[axis]);
                expect("a point in the box", below && above, on_curve)?;
            }
            Ok(())
        },
    );
}

/// **The error of de Casteljau's scheme.** For $0\le t\le1$ each computed coordinate of a curve of degree $n$ is at most
/// $3n\,u\,\max|b_i|$ away from the true one: $n$ rounds of interpolations, of at most $3u$ each, between numbers that never grow.
/// Tried up to degree 60. At such degrees the bound is far above what happens, since the errors of so many steps cancel; the
/// largest errors in its terms come from low degrees.
#[test]
fn bezier_error_stays_below_its_bound() {
    let worst = Cell::new(0.0_f64);
    let degrees = || prop_oneof![20 => 1..=6_usize, 2 => Just(20), 1 => Just(60)];
    let points = |degree| vec([float_coordinate(), float_coordinate()], degree + 1);
    let hard_points = |degree| {
        vec(
            [hard_float_coordinate(), hard_float_coordinate()],
            degree + 1,
        )
    };
    let curves = (degrees().prop_flat_map(points), float_parameter());
    let hard = (degrees().prop_flat_map(hard_points), hard_float_parameter());
    law("ground_floor::bezier_error_stays_below_its_bound")
        .on_cases(200)
        .holds(curves, hard, |(points, t)| {
            let degree = f64::from(u32::try_from(points.len() - 1).expect("a small degree"));
            let size = points
                .iter()
                .map(|p| p.largest_coordinate())
                .fold(f64::MIN_POSITIVE, f64::max);
            let exact = big_bezier(points, &big(*t));
            let unit = degree * size * f64::unit_roundoff();
            let error = largest_error(bezier(points).point(*t), &exact, unit);
            worst.set(worst.get().max(error));
            expect_at_most("error in n u max|b|", 3.0, error)
        });
    assert!(
        worst.get() >= 3.0 / 20.0,
        "the bound is not idle: {}",
        worst.get()
    );
}

/// **Any degree.** A curve with many control points is computed as one with few: up to 40 points it gives the bits of de
/// Casteljau's triangle written out row by row, and so does its derivative.
#[test]
fn bezier_of_many_points_is_computed_as_one_of_few() {
    let curves = (
        vec([float_coordinate(), float_coordinate()], 2..=40),
        float_parameter(),
    );
    let around_the_stack =
        (15..=18_usize).prop_flat_map(|count| vec([float_coordinate(), float_coordinate()], count));
    let hard = (around_the_stack, hard_float_parameter());
    law("ground_floor::bezier_of_many_points_is_computed_as_one_of_few").holds(
        curves,
        hard,
        |(points, t)| {
            let mut rows = vec![points.clone()];
            while let Some([_, _, ..]) = rows.last().map(Vec::as_slice) {
                let between = |pair: &[[f64; 2]]| {
                    [0, 1].map(|axis| pair[0][axis] * (1.0 - t) + pair[1][axis] * t)
                };
                let next = rows[rows.len() - 1].windows(2).map(between).collect();
                rows.push(next);
            }
            let curve = bezier(points);
            expect_equal(&rows[rows.len() - 1][0], &curve.point(*t))?;
            let degree = f64::from(u32::try_from(curve.degree()).expect("a small degree"));
            let last_pair = &rows[rows.len() - 2];
            let slope = [0, 1].map(|axis| (last_pair[1][axis] - last_pair[0][axis]) * degree);
            expect_equal(&Some(slope), &curve.derivative(*t))?;
            expect_equal(&points.as_slice(), &curve.control_points())
        },
    );
}

/// **Linear precision.** Control points in equal steps on a straight line make the curve that runs along this line at constant speed:
/// $C(t)=(1-t)\,a+t\,b$.
#[test]
fn bezier_of_equal_steps_is_the_straight_line() {
    let lines = (point(), point(), 1..=6_i32, parameter());
    let hard = (point().prop_map(|p| (p, p)), Just(5), hard_parameter());
    let hard = hard.prop_map(|((a, b), steps, t)| (a, b, steps, t));
    law("ground_floor::bezier_of_equal_steps_is_the_straight_line").holds(
        lines,
        hard,
        |&(a, b, steps, t)| {
            let points: Vec<_> = (0..=steps).map(|i| a.lerp(b, fraction(i, steps))).collect();
            let curve = bezier(&points);
            expect_equal(&a.lerp(b, t), &curve.point(t))?;
            expect_equal(&Some(b.minus(a)), &curve.derivative(t))
        },
    );
}

/// **Curves behind pointers.** A reference to a curve and a box around it are the same curve. So curves of different kinds (a
/// function, a polyline, a Bézier curve) can bound one patch.
#[test]
fn curve_behind_a_pointer_is_the_same_curve() {
    let curves = (
        vec(
            [float_coordinate(), float_coordinate(), float_coordinate()],
            2..=6,
        ),
        float_parameter(),
    );
    let hard = (
        vec(
            [
                hard_float_coordinate(),
                hard_float_coordinate(),
                hard_float_coordinate(),
            ],
            2..=6,
        ),
        hard_float_parameter(),
    );
    law("ground_floor::curve_behind_a_pointer_is_the_same_curve").holds(
        curves,
        hard,
        |(points, t)| {
            let line = Polyline::new(points.clone()).expect("finite points");
            let arch = bezier(points);
            let boxes: [BoxedCurve<[f64; 3]>; 2] = [Box::new(line.clone()), Box::new(arch.clone())];
            expect_equal(
                &[line.point(*t), arch.point(*t)],
                &boxes.each_ref().map(|curve| curve.point(*t)),
            )?;
            let derivatives = [line.derivative(*t), arch.derivative(*t)];
            expect_equal(
                &derivatives,
                &boxes.each_ref().map(|curve| curve.derivative(*t)),
            )?;
            expect_equal(&seen_through(&&arch, *t), &seen_through(&boxes[1], *t))
        },
    );
    let curve = OnTwoToFive;
    let boxed: Box<dyn Curve<Scalar = f64, Point = f64>> = Box::new(OnTwoToFive);
    assert_eq!([(&&curve).domain(), boxed.domain()], [[2.0, 5.0]; 2]);
}

fn seen_through<C: Curve>(curve: C, t: C::Scalar) -> (C::Point, Option<C::Point>) {
    (curve.point(t), curve.derivative(t))
}

/// A curve with a domain of its own.
struct OnTwoToFive;

impl Curve for OnTwoToFive {
    type Scalar = f64;
    type Point = f64;

    fn domain(&self) -> [f64; 2] {
        [2.0, 5.0]
    }

    fn point(&self, t: f64) -> f64 {
        t
    }

    fn derivative(&self, _: f64) -> Option<f64> {
        Some(1.0)
    }
}

/// **Curves from functions.** Any function on $[0,1]$ is a curve. Its derivative is known when it is given, and unknown otherwise: no
/// difference quotient stands in for it.
#[test]
fn function_is_a_curve() {
    law("ground_floor::function_is_a_curve").holds(
        (point(), parameter()),
        (point(), hard_parameter()),
        |&(a, t)| {
            let parabola = FunctionCurve::new(move |t: Exact| a.times(t * t));
            expect_equal(&a.times(t * t), &parabola.point(t))?;
            expect_equal(&None, &parabola.derivative(t))?;
            let known = parabola.with_derivative(move |t| a.times(t + t));
            expect_equal(&a.times(t * t), &known.point(t))?;
            expect_equal(&Some(a.times(t + t)), &known.derivative(t))?;
            expect_equal(&[fraction(0, 1), fraction(1, 1)], &known.domain())
        },
    );
    let constant = BezierCurve::new(vec![[1.5_f32, 2.5]]).expect("one point is enough");
    assert_eq!(
        (constant.degree(), constant.derivative(0.25)),
        (0, Some([0.0, 0.0]))
    );
}
