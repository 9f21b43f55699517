//! The theorems of polylines. The book shows their doc comments.

use facette::algebra::{Scalar, VectorSpace, length};
use facette::curve::{Curve, Polyline};
use proptest::collection::vec;
use proptest::prelude::*;

use crate::common::exact::{Exact, fraction};
use crate::common::generators::{
    coordinate, float_coordinate, hard_float_coordinate, parameter, point,
};
use crate::common::law::{expect_at_most, expect_equal};
use crate::inputs::{Point, law};

fn polyline<P: VectorSpace>(points: &[P]) -> Polyline<P> {
    Polyline::new(points.to_vec()).expect("the generators make finite points")
}

/// The number of segments.
fn sides<P>(points: &[P]) -> i32 {
    i32::try_from(points.len() - 1).expect("a short list")
}

fn repeated_points() -> impl Strategy<Value = Vec<Point>> {
    (point(), point(), 1..=3_usize, 1..=3_usize)
        .prop_map(|(p, q, first, last)| [vec![p; first], vec![q; last]].concat())
}

/// **Interpolation.** The polyline through $p_0,\dots,p_n$ is at $p_i$ for $t=i/n$, and moves from there to $p_{i+1}$ at constant
/// speed: $C\bigl(\tfrac{i+s}{n}\bigr)=(1-s)\,p_i+s\,p_{i+1}$ for $0\le s\le1$.
#[test]
fn polyline_passes_through_its_points() {
    let lines = (vec(point(), 2..=6), parameter());
    let ends = prop::sample::select(vec![fraction(0, 1), fraction(1, 1), fraction(1, 1 << 30)]);
    law("ground_floor::polyline_passes_through_its_points").holds(
        lines,
        (repeated_points(), ends),
        |(points, s)| {
            let line = polyline(points);
            let n = sides(points);
            for (i, pair) in (0..).zip(points.windows(2)) {
                let t = (Exact::from_i32(i) + *s) / Exact::from_i32(n);
                expect_equal(&pair[0].lerp(pair[1], *s), &line.point(t))?;
            }
            expect_equal(&points.as_slice(), &line.points())?;
            expect_equal(&[fraction(0, 1), fraction(1, 1)], &line.domain())
        },
    );
}

/// **Interpolation in floating point.** At $t=i/n$, divided in the same arithmetic, the polyline gives $p_i$ to the bit.
#[test]
fn polyline_gives_its_points_to_the_bit() {
    let lines = vec([float_coordinate(), float_coordinate()], 2..=50);
    let hard = vec([hard_float_coordinate(), hard_float_coordinate()], 2..=50);
    law("ground_floor::polyline_gives_its_points_to_the_bit").holds(lines, hard, |points| {
        let line = polyline(points);
        let n = sides(points);
        let computed: Vec<_> = (0..=n).map(|i| line.point(f64::ratio(i, n))).collect();
        expect_equal(points, &computed)
    });
}

/// **The corners of a polyline.** Between two points the derivative is $n\,(p_{i+1}-p_i)$. At an inner point, where two sides meet, it
/// is that of the side that follows; at the last point that of the last side.
#[test]
fn polyline_derivative_is_that_of_the_side_that_follows() {
    let lines = (vec(point(), 2..=6), coordinate());
    let hard = (repeated_points(), Just(fraction(1, 1)));
    law("ground_floor::polyline_derivative_is_that_of_the_side_that_follows").holds(
        lines,
        hard,
        |(points, beyond)| {
            let line = polyline(points);
            let n = Exact::from_i32(sides(points));
            let slopes: Vec<_> = points
                .windows(2)
                .map(|pair| pair[1].minus(pair[0]).times(n))
                .collect();
            for (i, slope) in (0..).zip(&slopes) {
                for shift in [fraction(0, 1), fraction(1, 2), fraction(99, 100)] {
                    let t = (Exact::from_i32(i) + shift) / n;
                    expect_equal(&Some(*slope), &line.derivative(t))?;
                }
            }
            let after_the_end = Exact::from_i32(1) + beyond.magnitude();
            expect_equal(
                &Some(slopes[slopes.len() - 1]),
                &line.derivative(after_the_end),
            )?;
            let before_the_start = -beyond.magnitude() - fraction(1, 5);
            expect_equal(&Some(slopes[0]), &line.derivative(before_the_start))
        },
    );
}

/// **Beyond the ends.** Outside $[0,1]$ the polyline goes straight on, along its first or its last side:
/// $C(t)=p_0+t\,n\,(p_1-p_0)$ for $t<0$.
#[test]
fn polyline_goes_straight_on_beyond_its_ends() {
    let far = || (0..=40_i32).prop_map(|tenths| fraction(tenths, 10));
    law("ground_floor::polyline_goes_straight_on_beyond_its_ends").holds(
        (vec(point(), 2..=6), far()),
        (repeated_points(), far()),
        |(points, far)| {
            let line = polyline(points);
            let n = Exact::from_i32(sides(points));
            let [.., before, last] = points.as_slice() else {
                return Ok(());
            };
            let first_side = points[1].minus(points[0]).times(n);
            expect_equal(&points[0].minus(first_side.times(*far)), &line.point(-*far))?;
            let last_side = last.minus(*before).times(n);
            expect_equal(
                &last.plus(last_side.times(*far)),
                &line.point(Exact::from_i32(1) + *far),
            )
        },
    );
}

/// **Arc length.** With the arc length as parameter, all sides have the same speed, the whole length $L$ of the polyline:
/// $|C'(t)|=L$. In floating point, a side with the share $h$ of the length has it up to $2(n+8)u/h$: its ends are sums of
/// up to $n$ rounded lengths, and their difference is divided by $h$.
#[test]
fn arc_length_gives_constant_speed() {
    let lines = vec(
        [float_coordinate(), float_coordinate(), float_coordinate()],
        2..=8,
    );
    let hard = vec(hard_float_coordinate().prop_map(|x| [x, 0.0, 1.0]), 2..=8);
    law("ground_floor::arc_length_gives_constant_speed").holds(lines, hard, |points| {
        let line = Polyline::by_arc_length(points.clone()).expect("finite points");
        let lengths: Vec<_> = points
            .windows(2)
            .map(|pair| length(pair[1].minus(pair[0])))
            .collect();
        let whole: f64 = lengths.iter().sum();
        let mut travelled = 0.0;
        for part in lengths {
            let share = part / whole;
            let bound = 2.0 * f64::from(sides(points) + 8) * f64::unit_roundoff() / share;
            // A side that is lost in the rounding of the others has no parameter of its own.
            if bound < 0.5 {
                let middle = (travelled + part / 2.0) / whole;
                let speed = length(
                    line.derivative(middle)
                        .expect("a polyline knows its derivative"),
                );
                expect_at_most(
                    "relative error of the speed",
                    bound,
                    (speed / whole - 1.0).abs(),
                )?;
            }
            travelled += part;
        }
        expect_equal(
            &[points[0], points[points.len() - 1]],
            &[line.point(0.0), line.point(1.0)],
        )
    });
}
