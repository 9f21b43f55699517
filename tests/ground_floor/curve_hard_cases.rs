//! Inputs that make curves difficult, and what comes of them.

use facette::algebra::Scalar;
use facette::curve::{BezierCurve, Curve, CurveError, Polyline};

use crate::common::oracle::{big, largest_error};
use crate::inputs::bezier;

const NAN: f64 = f64::NAN;

/// **Points that coincide.** With the arc length as parameter, a repeated point takes no time: the sides of no length are
/// passed over, at the start, in the middle and at the end, and before the start the polyline still goes straight on. If all points
/// coincide, there is no arc length: the parameter is that of the points' numbers, and the derivative is zero.
#[test]
fn repeated_points_take_no_time() {
    let [a, b, c] = [[0.0, 0.0, 0.0], [3.0, 0.0, 4.0], [3.0, 5.0, 4.0]];
    let line = Polyline::by_arc_length(vec![a, a, b, b, b, c, c]).expect("finite points");
    for (t, expected) in [
        (0.0, a),
        (0.25, [1.5, 0.0, 2.0]),
        (0.5, b),
        (0.75, [3.0, 2.5, 4.0]),
        (1.0, c),
    ] {
        assert_eq!(line.point(t), expected, "t = {t}");
    }
    assert_eq!(line.point(-0.5), [-3.0, 0.0, -4.0]);
    assert_eq!(line.point(1.5), [3.0, 10.0, 4.0]);
    for (t, expected) in [
        (-0.5, [6.0, 0.0, 8.0]),
        (0.0, [6.0, 0.0, 8.0]),
        (0.5, [0.0, 10.0, 0.0]),
        (1.0, [0.0, 10.0, 0.0]),
    ] {
        assert_eq!(line.derivative(t), Some(expected), "t = {t}");
    }
    let nowhere = Polyline::by_arc_length(vec![b; 3]).expect("finite points");
    for t in [-1.0, 0.0, 0.3, 0.5, 1.0, 2.0] {
        assert_eq!(nowhere.point(t), b);
        assert_eq!(nowhere.derivative(t), Some([0.0; 3]));
    }
}

/// **A side that is lost in the rounding of the others.** After a side of length $10^{30}$, a side of length $10^8$ has no parameters of
/// its own: both its ends are at $t=1$. There the polyline is at its last point, and at $t=0$ at its first, exactly.
#[test]
fn ends_stay_exact_where_a_side_is_lost_in_rounding() {
    let points = vec![[1e30, 0.0, 0.0], [0.0, 0.0, 0.0], [1e8, 0.0, 0.0]];
    let line = Polyline::by_arc_length(points.clone()).expect("finite points");
    assert_eq!([line.point(0.0), line.point(1.0)], [points[0], points[2]]);
    let backwards: Vec<_> = points.into_iter().rev().collect();
    let line = Polyline::by_arc_length(backwards.clone()).expect("finite points");
    assert_eq!(
        [line.point(0.0), line.point(1.0)],
        [backwards[0], backwards[2]]
    );
    assert_eq!(line.point(0.5), [5e29, 0.0, 0.0]);
    let tiny_start = vec![[1e-300, 0.0, 0.0], [0.0, 0.0, 0.0], [1e30, 0.0, 0.0]];
    let line = Polyline::by_arc_length(tiny_start.clone()).expect("finite points");
    assert_eq!(
        [line.point(0.0), line.point(1.0)],
        [tiny_start[0], tiny_start[2]]
    );
}

/// **A length that overflows.** Two points may be finite and their distance not: $(\pm1.5\cdot10^{308},0,0)$. The polyline then keeps
/// the parameter of the points' numbers.
#[test]
fn length_that_overflows_leaves_the_numbers_as_parameter() {
    let [left, right] = [[-1.5e308, 0.0, 0.0], [1.5e308, 0.0, 0.0]];
    let line = Polyline::by_arc_length(vec![left, right, right]).expect("finite points");
    assert_eq!(
        [line.point(0.0), line.point(0.5), line.point(1.0)],
        [left, right, right]
    );
    assert_eq!(line.point(0.25), [0.0; 3]);
}

/// **Cancelling coefficients.** The polynomial $(1-2t)^{20}$ is a Bézier curve with the control points $1,-1,1,\dots$ Horner's rule adds
/// monomial coefficients of up to $6\cdot10^8$ that cancel: at $t=0.95$, where the result is $0.1216$, half of the
/// digits are wrong. De Casteljau's scheme adds numbers of at most 1, and stays within $3n\,u$.
#[test]
fn horner_loses_digits_that_de_casteljau_keeps() {
    let signs: Vec<_> = (0..=20)
        .map(|i| [if i % 2 == 0 { 1.0 } else { -1.0 }])
        .collect();
    let mut coefficients = vec![1.0_f64];
    for i in 0..20_u32 {
        let last = coefficients[coefficients.len() - 1];
        coefficients.push(last * -2.0 * f64::from(20 - i) / f64::from(i + 1));
    }
    let t = 0.95;
    let horner = coefficients.iter().rev().fold(0.0, |sum, c| sum * t + c);
    let exact = [num_traits::pow(big(1.0) - big(2.0) * big(t), 20)];
    let error = |computed: f64| largest_error([computed], &exact, f64::unit_roundoff());
    assert!(error(bezier(&signs).point(t)[0]) <= 3.0 * 20.0);
    assert!(error(horner) > 1e6, "{horner}");
}

/// **NaN as a parameter.** What is not a number gives a point that is not a number: nothing stops, and nothing looks like a result.
#[test]
fn nan_gives_nan() {
    let points = vec![[0.0, 1.0, 2.0], [3.0, 4.0, 5.0], [6.0, 7.0, 9.0]];
    let line = Polyline::new(points.clone()).expect("finite points");
    let by_length = Polyline::by_arc_length(points.clone()).expect("finite points");
    let arch = bezier(&points);
    let high = bezier(&[points.clone(), points].concat().repeat(4));
    for point in [
        line.point(NAN),
        by_length.point(NAN),
        arch.point(NAN),
        high.point(NAN),
    ] {
        assert!(point.iter().all(|x| x.is_nan()), "{point:?}");
    }
    let derivative = arch
        .derivative(NAN)
        .expect("a Bézier curve knows its derivative");
    assert!(derivative.iter().all(|x| x.is_nan()));
}

/// **Curves that cannot be.** Too few points, or a coordinate that is infinite or NaN, are refused with a message that says what
/// is wrong and where.
#[test]
fn curve_of_bad_points_is_refused() {
    let message = |result: Result<(), CurveError>| result.expect_err("a refusal").to_string();
    let line = |points: &[[f64; 2]]| message(Polyline::new(points.to_vec()).map(|_| ()));
    let arch = |points: &[[f64; 2]]| message(BezierCurve::new(points.to_vec()).map(|_| ()));
    assert_eq!(
        line(&[]),
        "a polyline needs at least 2 points, but 0 are given"
    );
    assert_eq!(
        line(&[[0.0, 0.0]]),
        "a polyline needs at least 2 points, but 1 are given"
    );
    assert_eq!(
        arch(&[]),
        "a Bézier curve needs at least 1 points, but 0 are given"
    );
    assert_eq!(
        line(&[[0.0, 0.0], [1.0, NAN]]),
        "point 1 of a polyline is [1.0, NaN]: every coordinate must be finite"
    );
    assert_eq!(
        arch(&[[0.0, 0.0], [1.0, 0.0], [f64::INFINITY, 2.0]]),
        "point 2 of a Bézier curve is [inf, 2.0]: every coordinate must be finite"
    );
    let by_length = Polyline::by_arc_length(vec![[0.0, NAN, 0.0]; 2]);
    assert!(matches!(
        by_length,
        Err(CurveError::NotFinite { index: 0, .. })
    ));
    let two_points = Polyline::new(vec![[0.0], [1.0]]);
    assert!(two_points.is_ok_and(|line| line.point(0.5) == [0.5]));
}
