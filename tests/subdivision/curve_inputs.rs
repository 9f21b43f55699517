//! Polygons over the fractions, ordinary and hard, for the tests of subdivided curves.

use facette::algebra::VectorSpace;
use facette::bspline::{BsplineCurve, KnotVector};
use facette::subdivision::curve::Ends;
use proptest::collection::vec;
use proptest::prelude::*;

use crate::common::exact::{Exact, fraction};
use crate::common::generators::point;

/// A point of space over the fractions.
pub type Point = [Exact; 3];

/// All three kinds of ends.
pub const ALL_ENDS: [Ends; 3] = [Ends::Closed, Ends::Open, Ends::Kept];

/// Polygons of 1 to 7 points.
pub fn polygons() -> impl Strategy<Value = Vec<Point>> {
    vec(point(), 1..=7)
}

/// Polygons that have no points, one or two, that stand still, fold back, stay on a line, or repeat their points.
pub fn hard_polygons() -> impl Strategy<Value = Vec<Point>> {
    let still = (point(), 1..=5_usize).prop_map(|(p, count)| vec![p; count]);
    let there_and_back = [point(), point()].prop_map(|[p, q]| vec![p, q, p]);
    let doubled =
        vec(point(), 2..=4).prop_map(|points| points.into_iter().flat_map(|p| [p, p]).collect());
    let on_a_line = ([point(), point()], vec(-3..=3_i32, 2..=6)).prop_map(|([p, step], places)| {
        let at = |place: i32| p.plus(step.times(fraction(place, 1)));
        places.into_iter().map(at).collect()
    });
    prop_oneof![
        vec(point(), 0..=2),
        still,
        there_and_back,
        doubled,
        on_a_line
    ]
}

/// Polygons of 4 to 7 points, which have a limit with open ends for degrees up to 3.
pub fn long_polygons() -> impl Strategy<Value = Vec<Point>> {
    vec(point(), 4..=7)
}

/// Polygons of at least 4 points that stand still, fold back, or repeat their points.
pub fn long_hard_polygons() -> impl Strategy<Value = Vec<Point>> {
    hard_polygons().prop_flat_map(|points| {
        let rest = vec(point(), 4 - points.len().min(4));
        rest.prop_map(move |rest| [&points[..], &rest].concat())
    })
}

/// An integer as a fraction.
pub fn whole(number: usize) -> Exact {
    fraction(i32::try_from(number).expect("a small number"), 1)
}

/// The B-spline of this degree with the integers for knots, from `−d` on: written with the knots in full, apart from the code under test.
pub fn uniform_bspline(degree: usize, points: &[Point]) -> BsplineCurve<Point> {
    let count = points.len() + degree + 1;
    let knots = (0..count).map(|index| whole(index) - whole(degree));
    let knots = KnotVector::new(degree, knots.collect()).expect("integers are knots");
    BsplineCurve::new(knots, points.to_vec()).expect("as many points as the knots ask for")
}

/// The control points of the limit of a polygon, and how many stand before the polygon's own: written by index, `P` with the period n where
/// the polygon closes, and with `Pᵢ₊₂ₘ = Pᵢ + 2 (Pₘ − P₀)`, `m = n − 1`, where it is mirrored through its ends.
pub fn continued(points: &[Point], degree: usize, ends: Ends) -> (Vec<Point>, usize) {
    let [Some(&first), Some(&last)] = [points.first(), points.last()] else {
        return (Vec::new(), 0);
    };
    let signed = |number: usize| i32::try_from(number).expect("a small number");
    let [n, m] = [signed(points.len()), signed(points.len() - 1)];
    let at = |index: i32| points[index.unsigned_abs() as usize];
    let mirrored = |index: i32| {
        if m == 0 {
            return first;
        }
        let [turns, place] = [index.div_euclid(2 * m), index.rem_euclid(2 * m)];
        let once = if place <= m {
            at(place)
        } else {
            last.plus(last).minus(at(2 * m - place))
        };
        once.plus(last.minus(first).times(fraction(2 * turns, 1)))
    };
    match ends {
        Ends::Open => (points.to_vec(), 0),
        Ends::Kept if degree == 2 => ([&[first], points, &[last]].concat(), 1),
        Ends::Kept => {
            let before = signed((degree - 1) / 2);
            (
                (-before..n + before).map(mirrored).collect(),
                (degree - 1) / 2,
            )
        }
        Ends::Closed => {
            let before = signed((degree - 1) / 2);
            let all = -before..n + signed(degree) - before;
            (
                all.map(|index| at(index.rem_euclid(n))).collect(),
                (degree - 1) / 2,
            )
        }
    }
}

/// The control points of the same curve on spans of length `1/parts`, by the blossoms of the chapter on B-splines.
pub fn refined(curve: &BsplineCurve<Point>, parts: usize) -> Vec<Point> {
    let degree = curve.degree();
    let [start, end] = curve.knots().domain();
    let spans = (curve.control_points().len() - degree) * parts;
    let knot = |index: usize| start + (whole(index) - whole(degree)) / whole(parts);
    let knots: Vec<Exact> = (0..=spans + 2 * degree).map(knot).collect();
    debug_assert_eq!(knots[spans + degree], end, "the same domain");
    let finer = KnotVector::new(degree, knots).expect("fractions are knots");
    let refined = curve.refined(&finer).expect("the finer knots hold the old");
    refined.control_points().to_vec()
}

/// The coordinates of the polygon in a direction: a function of the points, `a x + b y + c z`.
pub fn heights(points: &[Point], [a, b, c]: Point) -> Vec<Exact> {
    let height = |&[x, y, z]: &Point| a * x + b * y + c * z;
    points.iter().map(height).collect()
}
