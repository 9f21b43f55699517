//! Loops that no trimmed surface can have, and points so near to a loop that rounding decides.

use facette::bspline::{
    BsplineSurface, KnotVector, Place, RationalCurve, TrimError, TrimmedSurface, circle,
};

use crate::common::oracle::big;

type Sheet = BsplineSurface<[f64; 3]>;

/// A flat square of this domain in both directions.
fn sheet(domain: [f64; 2]) -> Sheet {
    let knots = KnotVector::bezier(1)
        .reparametrised(domain)
        .expect("a domain");
    let corners = vec![[0., 0., 0.], [1., 0., 0.], [0., 1., 0.], [1., 1., 0.]];
    BsplineSurface::new([knots.clone(), knots], corners).expect("2 x 2 points")
}

fn outline(points: &[[f64; 2]]) -> RationalCurve<[f64; 2]> {
    let knots = KnotVector::clamped_uniform(1, points.len()).expect("at least two points");
    RationalCurve::new(knots, points, &vec![1.0; points.len()]).expect("weights of 1")
}

fn refusal(points: &[[f64; 2]], tolerance: f64) -> TrimError<f64> {
    TrimmedSurface::new(sheet([0.0, 4.0]), outline(points), tolerance).expect_err("no loop")
}

/// **Loops that are none.** A curve that does not close, jumps, leaves the domain, encloses nothing, crosses itself or runs clockwise is refused, and so is a tolerance that is not positive or asks for too much: each with what is wrong, and where.
#[test]
fn unusable_loops_are_refused() {
    let square = [[1., 1.], [3., 1.], [3., 3.], [1., 3.], [1., 1.]];
    for tolerance in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let message = refusal(&square, tolerance).to_string();
        assert_eq!(
            message,
            format!("the tolerance is {tolerance:?}: it must be finite and positive")
        );
    }
    assert_eq!(
        refusal(&square[..4], 1e-3).to_string(),
        "the curve starts at [1.0, 1.0] and ends at [1.0, 3.0]: a loop ends where it starts"
    );
    let mut outside = square;
    outside[2] = [5., 3.];
    assert_eq!(
        refusal(&outside, 1e-3).to_string(),
        "the curve passes through [5.0, 3.0], outside the domain [[0.0, 4.0], [0.0, 4.0]] of the surface"
    );
    let flat = [[1., 1.], [3., 1.], [1., 1.]];
    assert_eq!(
        refusal(&flat, 1e-3).to_string(),
        "the curve encloses no area: its polygon of 2 sides is flat as far as rounding can tell"
    );
    let bow_tie = [[1., 1.], [3., 3.], [3., 1.], [1., 3.], [1., 1.]];
    assert_eq!(
        refusal(&bow_tie, 1e-3).to_string(),
        "the sides from [1.0, 1.0] to [3.0, 3.0] and from [3.0, 1.0] to [1.0, 3.0] of the curve's polygon meet: a loop must not cross or touch itself"
    );
    let mut clockwise = square;
    clockwise.reverse();
    assert_eq!(refusal(&clockwise, 1e-3), TrimError::Clockwise);
    let torn = KnotVector::new(1, vec![0., 0., 1., 2., 2., 3., 4., 4.]).expect("a double knot");
    let points = [[1., 1.], [3., 1.], [3., 3.], [2., 3.], [1., 3.], [1., 1.]];
    let torn = RationalCurve::new(torn, &points, &[1.0; 6]).expect("weights of 1");
    let torn = TrimmedSurface::new(sheet([0.0, 4.0]), torn, 1e-3).expect_err("a jump");
    assert_eq!(
        torn.to_string(),
        "the curve jumps from [3.0, 3.0] to [2.0, 3.0] at the parameter 2.0: a loop is continuous"
    );
}

/// **A tolerance below rounding.** Sides can follow a curve no closer than their number allows: a tolerance of $10^{-12}$ for the unit circle would take more than $2^{16}$ sides a piece, and is refused instead of filling the memory. So is one below rounding.
#[test]
fn tolerance_that_needs_too_many_sides_is_refused() {
    for tolerance in [1e-12, 1e-30, f64::MIN_POSITIVE] {
        let refused =
            TrimmedSurface::new(sheet([-2.0, 2.0]), circle(), tolerance).expect_err("too fine");
        assert!(
            matches!(
                refused,
                TrimError::TooManySides {
                    start: 0.0,
                    end: 1.0,
                    ..
                }
            ),
            "{refused}"
        );
    }
    let fine = TrimmedSurface::new(sheet([-2.0, 2.0]), circle(), 1e-8).expect("fine, but possible");
    assert!(
        (10_000..100_000).contains(&fine.polygon().len()),
        "{}",
        fine.polygon().len()
    );
}

/// **A loop along the edge of the domain.** A circle that touches all four edges of the domain leaves it by rounding. Corners that lie outside by less than a quarter of the tolerance are moved to the edge; the
/// whole domain may be its own loop.
#[test]
fn loop_may_touch_the_edge_of_the_domain() {
    let touching = TrimmedSurface::new(sheet([-1.0, 1.0]), circle(), 1e-6).expect("it touches");
    let is_inside = |corner: &[f64; 2]| corner.iter().all(|x| (-1.0..=1.0).contains(x));
    assert!(touching.polygon().iter().all(is_inside));
    let whole = [[0., 0.], [4., 0.], [4., 4.], [0., 4.], [0., 0.]];
    let whole =
        TrimmedSurface::new(sheet([0.0, 4.0]), outline(&whole), 1e-6).expect("the whole domain");
    for (u, v, place) in [
        (0.0, 0.0, Place::Edge),
        (4.0, 2.0, Place::Edge),
        (2.0, 2.0, Place::Inside),
        (4.1, 4.0, Place::Outside),
    ] {
        assert_eq!(whole.place_of(u, v), place, "({u}, {v})");
    }
    for lost in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        assert!(!whole.contains(lost, 2.0) && !whole.contains(2.0, lost));
    }
}

/// **Points next to a slanted side.** The textbook's determinant has the opposite sign for many points within a few ulps of a side: they land on the wrong side of it. Here a point is inside or outside only where the sign is certain; for the others the
/// answer is that they lie on the edge. Checked against rational arithmetic at 4096 points around a side from $(-12.3,-7.7)$ to $(24.6,17.1)$.
#[test]
fn points_next_to_a_slanted_side_are_never_on_the_wrong_one() {
    let [a, b] = [[-12.3, -7.7], [24.6, 17.1]];
    let corners = [a, b, [-12.3, 17.1], a];
    let surface =
        TrimmedSurface::new(sheet([-13.0, 25.0]), outline(&corners), 1e-6).expect("a loop");
    let [mut wrong, mut certain] = [0, 0];
    for (i, j) in (-32..32).flat_map(|i| (-32..32).map(move |j| (i, j))) {
        let u = 0.5 + f64::from(i) * f64::EPSILON;
        let v = 0.902_710_027_100_271_4 + f64::from(j) * f64::EPSILON / 4.0;
        let [left, right] = [
            (big(a[0]) - big(u)) * (big(b[1]) - big(v)),
            (big(a[1]) - big(v)) * (big(b[0]) - big(u)),
        ];
        let exact = left.cmp(&right);
        let naive = (a[0] - u) * (b[1] - v) - (a[1] - v) * (b[0] - u);
        wrong += u32::from(naive > 0.0 && exact.is_lt() || naive < 0.0 && exact.is_gt());
        match surface.place_of(u, v) {
            Place::Inside => assert!(exact.is_gt(), "({i}, {j})"),
            Place::Outside => assert!(exact.is_lt(), "({i}, {j})"),
            Place::Edge => continue,
        }
        certain += 1;
    }
    assert!(wrong > 100, "the sign is the opposite at {wrong} points");
    assert!(certain > 1000, "only {certain} points are certain");
}
