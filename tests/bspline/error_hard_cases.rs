//! What is no B-spline is refused, and every refusal says what is wrong, where, and what would be right.

use facette::bspline::{BsplineCurve, BsplineError, BsplineSurface, KnotVector};

use crate::common::exact::{Exact, fraction};

/// The message of what must be refused.
fn message<T, S: std::fmt::Debug>(outcome: Result<T, BsplineError<S>>) -> String {
    outcome
        .err()
        .map(|error| error.to_string())
        .unwrap_or_default()
}

fn arch() -> BsplineCurve<[f64; 2]> {
    let knots = KnotVector::clamped(2, &[0.0, 1.0, 2.0]).expect("valid knots");
    BsplineCurve::new(knots, vec![[0., 0.], [1., 2.], [3., 3.], [4., 0.]])
        .expect("four control points")
}

/// **Knots that are none.** Too few, not finite, decreasing, too often repeated, or with an empty domain: the constructor names the first knot at fault, with its number and its value.
#[test]
fn unusable_knots_are_refused_by_number() {
    let new = |degree, knots: &[f64]| message(KnotVector::new(degree, knots.to_vec()));
    let short = new(3, &[0.0, 0.0, 1.0, 1.0]);
    let expected = "4 knots of degree 3: at least 2 (p + 1) = 8 are needed";
    assert!(short.starts_with(expected), "{short}");
    let one_short = new(1, &[0.0, 0.0, 1.0]);
    let expected = "3 knots of degree 1: at least 2 (p + 1) = 4 are needed";
    assert!(one_short.starts_with(expected), "{one_short}");
    assert_eq!(
        new(1, &[0.0, 0.0, f64::NAN, 1.0, 1.0]),
        "knot 2 is NaN: every knot must be finite"
    );
    assert_eq!(
        new(1, &[0.0, 0.0, 1.0, f64::INFINITY]),
        "knot 3 is inf: every knot must be finite"
    );
    assert_eq!(
        new(1, &[0.0, 0.0, 0.5, 0.25, 1.0, 1.0]),
        "knot 3 is 0.25, less than the 0.5 before it: knots must not decrease"
    );
    assert_eq!(
        new(2, &[0.0, 0.0, 0.0, 0.5, 0.5, 0.5, 0.5, 0.5, 1.0, 1.0, 1.0]),
        "the knot 0.5 stands 5 times, from knot 3 on: degree 2 allows p + 1 = 3"
    );
    assert_eq!(
        new(1, &[0.0, 1.0, 1.0, 2.0]),
        "the domain [u_p, u_(n+1)] = [1.0, 1.0] of knots 1 to 2 is empty: its end must be larger than its start"
    );
}

/// **Absurd sizes.** A degree above 65535, or more control points than 32 bits count, is refused before anything is computed or allocated, by every constructor.
#[test]
fn absurd_degrees_and_counts_are_refused() {
    let huge = usize::MAX;
    let degree = format!("degree {huge}: at most 65535 is possible");
    let ends = [0.0, 1.0];
    assert_eq!(message(KnotVector::new(huge, ends.to_vec())), degree);
    assert_eq!(message(KnotVector::clamped(huge, &ends)), degree);
    assert_eq!(message(KnotVector::periodic(huge, &ends)), degree);
    assert_eq!(message(KnotVector::<f64>::uniform(huge, huge)), degree);
    assert_eq!(
        message(KnotVector::<f64>::clamped_uniform(65536, 3)),
        "degree 65536: at most 65535 is possible"
    );
    let points = format!("number of control points {huge}: at most 2147418112 is possible");
    assert_eq!(message(KnotVector::<f64>::uniform(2, huge)), points);
    assert_eq!(message(KnotVector::<f64>::clamped_uniform(2, huge)), points);
    assert_eq!(
        message(KnotVector::new(65535, ends.to_vec())),
        "2 knots of degree 65535: at least 2 (p + 1) = 131072 are needed"
    );
}

/// **End knots that stand too often.** A clamped end has its knot $p+1$ times. Once more is a common slip, and would make a function that is zero everywhere: it is refused, while $-0$ and $0$ are the same knot.
#[test]
fn end_knots_may_not_stand_more_than_p_plus_one_times() {
    let refused = KnotVector::new(1, vec![0.0, 0.0, 1.0, 1.0, 1.0]);
    assert_eq!(
        message(refused),
        "the knot 1.0 stands 3 times, from knot 2 on: degree 1 allows p + 1 = 2"
    );
    let signed = KnotVector::new(1, vec![-0.0, 0.0, 1.0, 1.0]).expect("two zeros and two ones");
    assert_eq!(signed.multiplicity(0.0), 2);
    let refused = KnotVector::new(1, vec![-0.0, 0.0, 0.0, 1.0, 1.0]);
    assert!(message(refused).contains("stands 3 times"));
}

/// **Shorthands.** The constructors of clamped, uniform and periodic knots refuse what makes no knot vector in the same words: no breaks, fewer control points than the degree asks for, breaks of no length.
#[test]
fn shorthand_constructors_refuse_in_the_same_words() {
    let short = [
        (
            KnotVector::<f64>::clamped(2, &[]),
            "0 knots of degree 2: at least 2 (p + 1) = 6 are needed",
        ),
        (
            KnotVector::clamped_uniform(3, 3),
            "7 knots of degree 3: at least 2 (p + 1) = 8 are needed",
        ),
        (
            KnotVector::uniform(3, 3),
            "7 knots of degree 3: at least 2 (p + 1) = 8 are needed",
        ),
    ];
    for (refused, expected) in short {
        let found = message(refused);
        assert!(found.starts_with(expected), "{found}");
    }
    let point = KnotVector::clamped(1, &[1.0, 1.0]);
    assert!(message(point).contains("the knot 1.0 stands 4 times"));
    let backwards = KnotVector::clamped(1, &[1.0, 0.0]);
    assert_eq!(
        message(backwards),
        "knot 2 is 0.0, less than the 1.0 before it: knots must not decrease"
    );
    assert!(KnotVector::<f64>::periodic(2, &[1.0]).is_err());
    assert!(KnotVector::<f64>::periodic(2, &[]).is_err());
    assert!(KnotVector::periodic(2, &[1.0, 1.0]).is_err());
    assert!(KnotVector::periodic(1, &[0.0, f64::NAN, 1.0]).is_err());
}

/// **As many points as functions.** The messages count with the relations of the course, $r=n+p+1$ and $s=m+q+1$, and say how many control points would fit.
#[test]
fn wrong_numbers_of_control_points_are_explained() {
    let knots = || KnotVector::<f64>::clamped_uniform(2, 4).expect("more points than the degree");
    assert_eq!(
        message(BsplineCurve::new(knots(), vec![0.0; 5])),
        "7 knots and degree p = 2 ask for 4 control points (r = n + p + 1, with r + 1 knots and n + 1 points), but there are 5"
    );
    let in_v = KnotVector::<f64>::bezier(1);
    assert_eq!(
        message(BsplineSurface::new([knots(), in_v.clone()], vec![0.0; 7])),
        "7 x 4 knots of degrees p = 2 and q = 1 ask for a net of 4 x 2 control points (r = n + p + 1, s = m + q + 1), but there are 7"
    );
    let mut points = vec![[0.0, 1.0]; 8];
    points[6][1] = f64::NEG_INFINITY;
    let refused = message(BsplineSurface::new([knots(), in_v.clone()], points));
    assert_eq!(
        refused,
        "control point 6 is [0.0, -inf]: every coordinate must be finite"
    );
    let refused = message(BsplineCurve::new(knots(), vec![1.0, f64::NAN, 0.0, 0.0]));
    assert_eq!(
        refused,
        "control point 1 is NaN: every coordinate must be finite"
    );
    let flat =
        BsplineSurface::new([knots(), in_v], vec![[0.0, 1.0]; 8]).expect("four by two points");
    let refused = message(flat.with_control_point(2, 1, [f64::NAN, 0.0]));
    assert_eq!(
        refused,
        "control point 6 is [NaN, 0.0]: every coordinate must be finite"
    );
}

/// **Insertion outside.** A knot can be inserted in the closed domain, and not more often than $p+1$ times.
#[test]
fn knots_outside_the_domain_are_not_inserted() {
    let arch = arch();
    assert_eq!(
        message(arch.with_knot(-0.5)),
        "the parameter -0.5 lies outside the domain [0.0, 2.0]"
    );
    assert_eq!(
        message(arch.with_knot(2.5)),
        "the parameter 2.5 lies outside the domain [0.0, 2.0]"
    );
    assert_eq!(
        message(arch.with_knot(f64::NAN)),
        "the parameter NaN lies outside the domain [0.0, 2.0]"
    );
    assert_eq!(
        message(arch.with_knot(2.0)),
        "the knot 2.0 stands 4 times, from knot 4 on: degree 2 allows p + 1 = 3"
    );
    let twice = arch
        .with_knot(1.0)
        .and_then(|curve| curve.with_knot(1.0))
        .expect("three times is allowed");
    assert_eq!(twice.knots().multiplicity(1.0), 3);
    assert!(message(twice.with_knot(1.0)).contains("the knot 1.0 stands 4 times"));
}

/// **Not finer.** The Oslo algorithm needs knots that hold all knots of the curve, on the same domain and with the same degree; what is missing is named.
#[test]
fn knots_that_are_not_finer_are_refused() {
    let arch = arch();
    let refine = |degree, breaks: &[f64]| {
        message(arch.refined(&KnotVector::clamped(degree, breaks).expect("valid knots")))
    };
    assert_eq!(
        refine(2, &[0.0, 0.5, 2.0]),
        "the knot 1.0 stands 0 times in the knots that are to be finer: at least 1 times, as in those of the curve, is needed"
    );
    assert_eq!(
        refine(3, &[0.0, 1.0, 2.0]),
        "the knots that are to be finer have degree 3, those of the curve 2: both must be the same"
    );
    assert_eq!(
        refine(2, &[0.0, 1.0, 3.0]),
        "the knots that are to be finer have the domain [0.0, 3.0], those of the curve [0.0, 2.0]: both must be the same"
    );
    assert_eq!(refine(2, &[0.0, 0.5, 1.0, 2.0]), "");
}

/// **Removal.** Only an inner knot can be removed, and only one that the curve does not need; the message tells by how much the control points would miss.
#[test]
fn knots_that_cannot_be_removed_are_explained() {
    let arch = arch();
    for knot in [0.0, 2.0, 0.5, 3.0, f64::NAN] {
        let expected = format!(
            "{knot:?} is not a knot between the ends of the domain: only such a knot can be removed"
        );
        assert_eq!(message(arch.without_knot(knot, 1.0)), expected);
    }
    let refused = message(arch.without_knot(1.0, 1e-9));
    let start = "without the knot 1.0 the control points would move by ";
    assert!(
        refused.starts_with(start) && refused.ends_with(", where the tolerance is 1e-9"),
        "{refused}"
    );
}

/// **New domains.** A domain must be finite and have a length. And if it is so far away that rounding makes different knots coincide too often, that is refused as well, instead of a curve with other pieces.
#[test]
fn unusable_domains_are_refused() {
    let arch = arch();
    assert_eq!(
        message(arch.reparametrised([1.0, 1.0])),
        "[1.0, 1.0] is no domain: both ends must be finite, and the second larger"
    );
    for domain in [[1.0, 0.0], [0.0, f64::INFINITY], [f64::NAN, 1.0]] {
        assert!(message(arch.reparametrised(domain)).contains("is no domain"));
    }
    let knots = KnotVector::clamped(1, &[0.0, 0.25, 0.5, 0.75, 1.0]).expect("valid knots");
    let neighbours = [1.0, 1.0_f64.next_up()];
    assert!(message(knots.reparametrised(neighbours)).contains("degree 1 allows p + 1 = 2"));
}

/// **Exact knots.** The same refusals over the fractions, where nothing is rounded, print fractions.
#[test]
fn exact_knots_are_refused_with_fractions() {
    let knots = [[0, 1], [0, 1], [2, 3], [1, 3], [1, 1], [1, 1]].map(|[a, b]| fraction(a, b));
    let refused = KnotVector::<Exact>::new(1, knots.to_vec());
    assert_eq!(
        message(refused),
        "knot 3 is 1/3, less than the 2/3 before it: knots must not decrease"
    );
}
