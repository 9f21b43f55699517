//! The theorems of refinement: knots in and out, the degree raised, and the curve or surface as it was.

use facette::algebra::VectorSpace;
use facette::bspline::{BsplineCurve, BsplineError, KnotVector, blossom, insert_knot};
use facette::curve::Curve;
use num_traits::Zero;
use proptest::prelude::*;

use crate::common::exact::{Exact, fraction};
use crate::common::generators::{coordinate, parameter, point};
use crate::common::law::{Broken, Law, Verdict, expect_equal};
use crate::inputs::{CurveCase, Point, curves, expect, hard_curves};
use crate::suspects;

/// A curve, the parameter of a new knot that the curve has at most p times so far, and a parameter to look at.
#[derive(Clone, Debug)]
struct Insertion {
    case: CurveCase,
    knot: Exact,
}

fn insertions(cases: impl Strategy<Value = CurveCase>) -> impl Strategy<Value = Insertion> {
    (cases, 0..8_usize, parameter()).prop_filter_map(
        "a knot that has room for one more",
        |(case, span, t)| {
            let knot = case.knots.parameter(span, t);
            let room = case
                .knots
                .knots
                .iter()
                .filter(|&&other| other == knot)
                .count()
                <= case.knots.degree;
            room.then_some(Insertion { case, knot })
        },
    )
}

/// Tries a law of `insert_knot` on ordinary and hard curves.
fn on_insertions(theorem: &'static str, check: impl Fn(&Insertion) -> Verdict) {
    Law::new(theorem, suspects::insertion).holds(
        insertions(curves()),
        insertions(hard_curves()),
        check,
    );
}

impl Insertion {
    /// The knots with the new one in its place.
    fn finer(&self) -> KnotVector<Exact> {
        let mut knots = self.case.knots.knots.clone();
        // At the end of the domain the new knot goes before those there: the domain stays as it is.
        let is_end = self.knot == self.case.knots.domain()[1];
        let before = |&other: &Exact| {
            if is_end {
                other < self.knot
            } else {
                other <= self.knot
            }
        };
        knots.insert(knots.partition_point(before), self.knot);
        KnotVector::new(self.case.knots.degree, knots).expect("there is room for one more")
    }

    /// The control points by the function under test.
    fn points(&self) -> Vec<Point> {
        insert_knot(&self.case.knots.vector(), &self.case.points, self.knot)
    }
}

/// **A knot more, the same curve.** Boehm's algorithm gives the control points of the *same* curve over the knots with one more: $n+2$ points for $n+1$, and $C(u)$ is what it was, at every $u$.
///
/// Course: B11, slide 19, computing a point: combine the control points.
/// Exercise: insertion.
#[test]
fn inserting_a_knot_keeps_the_curve() {
    on_insertions("bspline::inserting_a_knot_keeps_the_curve", |insertion| {
        let (case, points) = (&insertion.case, insertion.points());
        expect_equal(&(case.points.len() + 1), &points.len())?;
        let curve = BsplineCurve::new(insertion.finer(), points)
            .expect("one control point more for one knot more");
        expect_equal(&case.expected(), &curve.point(case.u))?;
        let library = case
            .curve()
            .with_knot(insertion.knot)
            .expect("there is room for one more");
        expect_equal(&curve, &library)
    });
}

/// **What insertion does to the polygon.** Let $\hat u$ lie on the span $k$. The points $P_0,\dots,P_{k-p}$ and $P_{k-s},\dots,P_n$ stay, $s$ the multiplicity that $\hat u$ has already; between them each new point
/// lies on an edge of the old polygon: $Q_i=(1-\alpha_i)P_{i-1}+\alpha_iP_i$ with $\alpha_i=\frac{\hat u-u_i}{u_{i+p}-u_i}$. The polygon's corners are cut, and it moves towards the curve.
///
/// Course: B15, slide 24, properties of the surface: local control.
/// Exercise: insertion.
#[test]
fn inserting_a_knot_cuts_corners_of_the_polygon() {
    on_insertions(
        "bspline::inserting_a_knot_cuts_corners_of_the_polygon",
        |insertion| {
            let Insertion { case, knot } = insertion;
            let (knots, p, k) = (
                &case.knots.knots,
                case.knots.degree,
                case.knots.span_of(*knot),
            );
            let expected = (0..=case.points.len()).map(|i| {
                if i + p <= k {
                    return case.points[i];
                }
                if i > k {
                    return case.points[i - 1];
                }
                let alpha = (*knot - knots[i]) / (knots[i + p] - knots[i]);
                case.points[i - 1].lerp(case.points[i], alpha)
            });
            expect_equal(&expected.collect::<Vec<_>>(), &insertion.points())?;
            let repeated = (p..=k).filter(|&i| knots[i] == *knot).count();
            let tail = case.points.len() - (k - repeated.min(k));
            let points = insertion.points();
            expect_equal(
                &&case.points[case.points.len() - tail..],
                &&points[points.len() - tail..],
            )
        },
    );
}

/// **Insertion computes points.** A knot that is inserted until it stands $p$ times makes the curve pass through a control point there. De Boor's algorithm is nothing else: it inserts $u$ so often, and keeps
/// only what it needs.
///
/// Course: B11, slide 19, computing a point: combine the control points.
/// Exercise: insertion.
#[test]
fn inserting_a_knot_p_times_gives_the_point() {
    on_insertions(
        "bspline::inserting_a_knot_p_times_gives_the_point",
        |insertion| {
            let Insertion { case, knot } = insertion;
            let [start, end] = case.knots.domain();
            if *knot == start || *knot == end {
                return Ok(());
            }
            let (mut vector, mut points) = (case.knots.vector(), case.points.clone());
            while vector.multiplicity(*knot) < case.knots.degree {
                points = insert_knot(&vector, &points, *knot);
                vector = vector
                    .with_knot(*knot)
                    .expect("the knot has room for one more");
            }
            let at_knot = CurveCase {
                u: *knot,
                ..case.clone()
            }
            .expected();
            expect(
                "the point among the control points",
                points.contains(&at_knot),
                (at_knot, points),
            )
        },
    );
}

/// **No new wiggles.** Inserting a knot adds no change of side: a plane meets the new polygon no more often than the old one, since it only cuts corners. Inserted again and again, polygons tend to the curve,
/// which is why the curve meets a plane no more often either.
///
/// Course: B16, slide 24, properties of the surface: no variation diminishing, contrary to curves.
/// Exercise: insertion.
#[test]
fn inserting_a_knot_adds_no_change_of_side() {
    let law = Law::new(
        "bspline::inserting_a_knot_adds_no_change_of_side",
        suspects::insertion,
    );
    let planes = || (point(), coordinate());
    law.holds(
        (insertions(curves()), planes()),
        (insertions(hard_curves()), planes()),
        |(insertion, (normal, offset))| {
            let changes = |points: &[Point]| {
                let side = |p: &Point| {
                    normal
                        .iter()
                        .zip(p)
                        .fold(-*offset, |sum, (&n, &x)| sum + n * x)
                };
                let sides: Vec<_> = points
                    .iter()
                    .map(side)
                    .filter(|side| !side.is_zero())
                    .collect();
                sides
                    .windows(2)
                    .filter(|pair| (pair[0] < Exact::zero()) != (pair[1] < Exact::zero()))
                    .count()
            };
            let [old, new] = [
                changes(&insertion.case.points),
                changes(&insertion.points()),
            ];
            expect(&format!("at most {old} changes of side"), new <= old, new)
        },
    );
}

/// **Many knots at once.** The Oslo algorithm gives the control points over finer knots in one step, each as the blossom of the old curve at $p$ consecutive new knots. They are the same that Boehm's algorithm gives knot by
/// knot, in any order: all those, that is, whose function is not zero on the whole domain. What else there is does not count, and each algorithm leaves it as it likes.
///
/// Course: B11, slide 19, computing a point: combine the control points.
/// Exercise: insertion.
#[test]
fn oslo_and_boehm_give_the_same_points() {
    let law = Law::new(
        "bspline::oslo_and_boehm_give_the_same_points",
        suspects::insertion,
    );
    let more = || proptest::collection::vec((0..8_usize, parameter()), 0..=3);
    law.holds(
        (curves(), more()),
        (hard_curves(), more()),
        |(case, more)| {
            let (mut vector, mut points) = (case.knots.vector(), case.points.clone());
            for &(span, t) in more {
                let knot = case.knots.parameter(span, t);
                if vector.multiplicity(knot) <= case.knots.degree {
                    points = insert_knot(&vector, &points, knot);
                    vector = vector.with_knot(knot).expect("there is room for one more");
                }
            }
            let refined = case
                .curve()
                .refined(&vector)
                .expect("these knots are finer");
            expect_equal(&points.len(), &refined.control_points().len())?;
            let [start, end] = case.knots.domain();
            for (i, pair) in points.iter().zip(refined.control_points()).enumerate() {
                let counts =
                    vector.knots()[i] < end && vector.knots()[i + case.knots.degree + 1] > start;
                if counts {
                    expect_equal(&(i, pair.0), &(i, pair.1))?;
                }
            }
            expect_equal(&case.expected(), &refined.point(case.u))
        },
    );
}

/// **Out again.** Removing a knot that was inserted gives the old control points back, exactly. A knot that the curve needs is refused, with the distance by which control points would miss.
///
/// Course: B08, slide 17, shape functions: continuity.
/// Exercise: insertion.
#[test]
fn removing_an_inserted_knot_gives_the_old_points() {
    on_insertions(
        "bspline::removing_an_inserted_knot_gives_the_old_points",
        |insertion| {
            let Insertion { case, knot } = insertion;
            let [start, end] = case.knots.domain();
            if *knot <= start || end <= *knot {
                return Ok(());
            }
            let finer =
                BsplineCurve::new(insertion.finer(), insertion.points()).expect("one of each more");
            let back = finer.without_knot(*knot, Exact::zero());
            expect_equal(&Ok(case.curve()), &back)?;
            refuses_needed_knots(case)
        },
    );
}

/// Passes where every inner knot at which a derivative really jumps is kept.
fn refuses_needed_knots(case: &CurveCase) -> Verdict {
    for pair in case.knots.spans().windows(2) {
        let inner = case.knots.knots[pair[1]];
        let multiplicity = case.knots.vector().multiplicity(inner);
        if !is_needed(case, [pair[0], pair[1]], multiplicity) {
            continue;
        }
        match case.curve().without_knot(inner, Exact::zero()) {
            Err(BsplineError::KnotNotRemovable {
                knot,
                distance,
                tolerance,
            }) => {
                expect_equal(&(inner, Exact::zero()), &(knot, tolerance))?;
                expect("a distance", distance > Exact::zero(), distance)?;
            }
            other => {
                return Err(Broken {
                    expected: format!("a refusal to remove {inner:?}"),
                    got: format!("{other:?}"),
                });
            }
        }
    }
    Ok(())
}

/// Whether the polynomials on two neighbouring spans differ in a derivative that a knot of one multiplicity less would make continuous.
fn is_needed(case: &CurveCase, spans: [usize; 2], multiplicity: usize) -> bool {
    let knot = case.knots.knots[spans[1]];
    let p = case.knots.degree;
    let vector = case.knots.vector();
    // The blossoms of two polynomials that join with p + 1 − k derivatives agree wherever the knot is an argument k − 1 times.
    let arguments = |other: &[Exact]| [vec![knot; multiplicity - 1], other.to_vec()].concat();
    let others: Vec<_> = (0..=p + 1 - multiplicity)
        .map(|i| knot + fraction(i32::try_from(i).expect("small") + 1, 1))
        .collect();
    (0..others.len()).any(|start| {
        let mut rest = others.clone();
        rest.rotate_left(start);
        rest.truncate(p + 1 - multiplicity);
        let sides = spans.map(|span| blossom(&vector, &case.points, span, &arguments(&rest)));
        sides[0] != sides[1]
    })
}

/// **A degree more, the same curve.** Every B-spline of degree $p$ is one of degree $p+1$ over the knots that each stand one time more: then it is as smooth as before at every one. The degree is raised, the points of
/// the curve are not moved.
///
/// Course: B08, slide 17, shape functions: continuity.
#[test]
fn raising_the_degree_keeps_the_curve() {
    let law = Law::new(
        "bspline::raising_the_degree_keeps_the_curve",
        suspects::library,
    );
    law.holds(curves(), hard_curves(), |case| {
        let elevated = case.curve().elevated();
        expect_equal(&(case.knots.degree + 1), &elevated.degree())?;
        expect_equal(&case.knots.domain(), &elevated.domain())?;
        let [start, end] = case.knots.domain();
        let inner = |vector: &KnotVector<Exact>| {
            let counted = vector.multiplicities().into_iter();
            counted
                .filter(|&(knot, _)| start < knot && knot < end)
                .collect::<Vec<_>>()
        };
        let raised: Vec<_> = inner(&case.knots.vector())
            .into_iter()
            .map(|(knot, times)| (knot, times + 1))
            .collect();
        expect_equal(&raised, &inner(elevated.knots()))?;
        expect_equal(&case.expected(), &elevated.point(case.u))?;
        expect_equal(&case.expected(), &elevated.elevated().point(case.u))
    });
}
