//! The theorems of B-spline curves, in the order of the text.

use facette::algebra::VectorSpace;
use facette::bspline::{curve_point, de_boor_point};
use facette::curve::Curve;
use num_traits::{One, Zero};

use crate::common::exact::{Exact, fraction};
use crate::common::generators::{coordinate, point};
use crate::common::law::{Law, Verdict, expect_equal};
use crate::divided_differences::all_values;
use crate::inputs::{CurveCase, Knots, Point, curves, expect, hard_curves, whole};
use crate::suspects;

/// Tries a law of de Boor's points on ordinary and hard curves with a parameter of the closed domain.
fn on_curves(theorem: &'static str, check: impl Fn(&CurveCase) -> Verdict) {
    Law::new(theorem, suspects::curve).holds(curves(), hard_curves(), check);
}

/// The point by the function under test.
fn de_boor(case: &CurveCase, u: Exact) -> Point {
    de_boor_point(&case.knots.vector(), &case.points, u)
}

/// **De Boor's points.** Repeated interpolation between neighbours, from $p+1$ control points down to one, gives $C(u)=\sum_iN_i^p(u)\,P_i$: the test sums all $n+1$ terms, with basis
/// functions by divided differences.
///
/// Course: B11, slide 19, computing a point: combine the control points.
/// Exercise: curve.
#[test]
fn de_boors_points_give_the_sum_of_the_basis() {
    on_curves(
        "bspline::de_boors_points_give_the_sum_of_the_basis",
        |case| {
            expect_equal(&case.expected(), &de_boor(case, case.u))?;
            let summed = curve_point(&case.knots.vector(), &case.points, case.u);
            expect_equal(&case.expected(), &summed)
        },
    );
}

/// **Bézier pieces.** On each span the curve is a Bézier curve: de Casteljau's points of the piece that `bezier_pieces` gives for it are the curve's points. Inner pieces meet where the
/// knot between them stands at most $p$ times.
///
/// Course: B12, slide 20, one polynomial for each rectangle of knots.
/// Exercise: curve.
#[test]
fn curve_is_a_bezier_curve_on_each_span() {
    on_curves("bspline::curve_is_a_bezier_curve_on_each_span", |case| {
        let pieces = case.curve().bezier_pieces();
        let intervals: Vec<_> = pieces.iter().map(|piece| piece.interval).collect();
        let knots = &case.knots.knots;
        let spans = case.knots.spans();
        expect_equal(
            &spans
                .iter()
                .map(|&span| [knots[span], knots[span + 1]])
                .collect::<Vec<_>>(),
            &intervals,
        )?;
        let place = spans
            .iter()
            .position(|&span| span == case.knots.span_of(case.u));
        let piece = &pieces[place.expect("every parameter has a span")];
        let [start, end] = piece.interval;
        let t = (case.u - start) / (end - start);
        expect_equal(&piece.curve.point(t), &de_boor(case, case.u))?;
        for (pair, &span) in pieces.windows(2).zip(&spans[1..]) {
            let multiplicity = knots.iter().filter(|&&knot| knot == knots[span]).count();
            if multiplicity <= case.knots.degree {
                expect_equal(
                    &pair[0].curve.point(Exact::one()),
                    &pair[1].curve.point(Exact::zero()),
                )?;
            }
        }
        Ok(())
    });
}

/// **The ends.** Where the first knot of the domain stands $p+1$ times the curve starts on its first control point, and likewise at the end. So does any inner
/// knot of multiplicity $p$ make the curve pass through a control point.
///
/// Course: B14, slide 23, properties of the surface: the corners.
/// Exercise: curve.
#[test]
fn clamped_curve_interpolates_its_ends() {
    on_curves("bspline::clamped_curve_interpolates_its_ends", |case| {
        let (knots, p) = (&case.knots.knots, case.knots.degree);
        let [start, end] = case.knots.domain();
        let last = case.points.len() - 1;
        if knots[0] == start {
            expect_equal(&case.points[0], &de_boor(case, start))?;
        }
        if knots[knots.len() - 1] == end {
            expect_equal(&case.points[last], &de_boor(case, end))?;
        }
        for i in 1..last {
            // Function i has the knot p times inside: all others vanish there.
            let own = case.knots.support(i);
            let knot = own[1];
            let is_p_fold = p > 0 && knot == own[p] && own[0] < knot && knot < own[p + 1];
            if is_p_fold && start <= knot && knot <= end {
                expect_equal(&case.points[i], &de_boor(case, knot))?;
            }
        }
        Ok(())
    });
}

/// **Affine invariance.** Mapping the control points by an affine map maps the curve: since the weights sum to 1, the shift goes through, and since the sum is linear, the rest does.
///
/// Course: B15, slide 24, properties of the surface: affine invariance.
/// Exercise: curve.
#[test]
fn curve_is_affinely_invariant() {
    let maps = || [point(), point(), point(), point()];
    let law = Law::new("bspline::curve_is_affinely_invariant", suspects::curve);
    law.holds(
        (curves(), maps()),
        (hard_curves(), maps()),
        |(case, [x, y, z, shift])| {
            let map =
                |[px, py, pz]: Point| Point::combination([px, py, pz], [*x, *y, *z]).plus(*shift);
            let image = case.mapped(map);
            expect_equal(&map(de_boor(case, case.u)), &de_boor(&image, case.u))
        },
    );
}

/// **Convex hull.** On the span $i$ the curve lies in the convex hull of $P_{i-p},\dots,P_i$. In every direction, then, it goes no farther than the farthest of these $p+1$ points, and in
/// particular no farther than all control points.
///
/// Course: B15, slide 24, properties of the surface: convex hull.
/// Exercise: curve.
#[test]
fn curve_lies_in_the_convex_hull_of_the_points_of_its_span() {
    let law = Law::new(
        "bspline::curve_lies_in_the_convex_hull_of_the_points_of_its_span",
        suspects::curve,
    );
    law.holds(
        (curves(), point()),
        (hard_curves(), point()),
        |(case, direction)| {
            let height = |p: Point| {
                direction
                    .iter()
                    .zip(p)
                    .fold(Exact::zero(), |sum, (&d, x)| sum + d * x)
            };
            let span = case.knots.span_of(case.u);
            let heights: Vec<_> = case.points[span - case.knots.degree..=span]
                .iter()
                .map(|&p| height(p))
                .collect();
            let reached = height(de_boor(case, case.u));
            let is_between =
                heights.iter().any(|&h| h <= reached) && heights.iter().any(|&h| h >= reached);
            expect(
                "a height between those of the span's control points",
                is_between,
                (reached, heights),
            )
        },
    );
}

/// **Local control.** Moving $P_i$ by a vector $d$ moves the point $C(u)$ by $N_i^p(u)\,d$: not at all outside $[u_i,u_{i+p+1}]$, and by a positive part of $d$ inside.
///
/// Course: B15, slide 24, properties of the surface: local control.
/// Exercise: curve.
#[test]
fn moving_a_control_point_moves_its_support_only() {
    let law = Law::new(
        "bspline::moving_a_control_point_moves_its_support_only",
        suspects::curve,
    );
    let which = || 0..32_usize;
    law.holds(
        (curves(), which(), point()),
        (hard_curves(), which(), point()),
        |(case, which, by)| {
            let moved = which % case.points.len();
            let mut other = case.clone();
            other.points[moved] = other.points[moved].plus(*by);
            let weight = all_values(&case.knots, case.u)[moved];
            let own = case.knots.support(moved);
            let (start, end) = (own[0], own[own.len() - 1]);
            if case.u < start || end < case.u {
                expect_equal(&Exact::zero(), &weight)?;
            }
            if start < case.u && case.u < end {
                expect(
                    "a positive weight inside the support",
                    weight > Exact::zero(),
                    weight,
                )?;
            }
            let expected = de_boor(case, case.u).plus(by.times(weight));
            expect_equal(&expected, &de_boor(&other, case.u))
        },
    );
}

/// **Variation diminishing.** No plane meets the curve more often than its control polygon: along the curve, jumps included, the distance from the plane changes its sign at most as often as along the sequence
/// $P_0,\dots,P_n$. The curve wiggles no more than its polygon. (Surfaces have no such property.)
///
/// Course: B16, slide 24, properties of the surface: no variation diminishing, contrary to curves.
/// Exercise: curve.
#[test]
fn plane_meets_a_curve_no_more_often_than_its_polygon() {
    let law = Law::new(
        "bspline::plane_meets_a_curve_no_more_often_than_its_polygon",
        suspects::curve,
    );
    let planes = || (point(), coordinate());
    law.holds(
        (curves(), planes()),
        (hard_curves(), planes()),
        |(case, (normal, offset))| {
            let side = |p: Point| {
                normal
                    .iter()
                    .zip(p)
                    .fold(-*offset, |sum, (&n, x)| sum + n * x)
            };
            let spans = case.knots.spans();
            let places = (0..spans.len())
                .flat_map(|span| (0..=6).map(move |sixth| (span, fraction(sixth, 6))));
            let on_curve =
                places.map(|(span, t)| side(de_boor(case, case.knots.parameter(span, t))));
            let of_curve = sign_changes(on_curve);
            let of_polygon = sign_changes(case.points.iter().map(|&p| side(p)));
            expect(
                &format!("at most {of_polygon} changes of side"),
                of_curve <= of_polygon,
                of_curve,
            )
        },
    );
}

/// How often the sign changes along a sequence; zeros do not count.
fn sign_changes(values: impl Iterator<Item = Exact>) -> usize {
    let signs: Vec<_> = values
        .filter(|value| !value.is_zero())
        .map(|value| value > Exact::zero())
        .collect();
    signs.windows(2).filter(|pair| pair[0] != pair[1]).count()
}

/// **Straight lines.** Control points that lie at Greville's abscissae on a line, $P_i=a+\xi_i\,d$, make the line $C(u)=a+u\,d$, run through at constant speed, over any knots.
///
/// Course: B15, slide 24, properties of the surface: affine invariance.
/// Exercise: curve.
#[test]
fn points_at_grevilles_abscissae_make_a_straight_line() {
    let law = Law::new(
        "bspline::points_at_grevilles_abscissae_make_a_straight_line",
        suspects::curve,
    );
    law.holds(
        (curves(), point(), point()),
        (hard_curves(), point(), point()),
        |(case, a, d)| {
            if case.knots.degree == 0 {
                return Ok(());
            }
            let abscissae = case.knots.vector().greville_abscissae();
            let points = abscissae.iter().map(|&xi| a.plus(d.times(xi))).collect();
            let line = CurveCase {
                points,
                ..case.clone()
            };
            expect_equal(&a.plus(d.times(case.u)), &de_boor(&line, case.u))
        },
    );
}

/// **Degree 0 and degree 1.** Degree 0 is a staircase: $C(u)=P_i$ on the span $i$. Degree 1 is the control polygon, with vertices at the knots $u_{i+1}$.
///
/// Course: B15, slide 24, properties of the surface: local control.
/// Exercise: curve.
#[test]
fn lowest_degrees_are_the_staircase_and_the_polygon() {
    on_curves(
        "bspline::lowest_degrees_are_the_staircase_and_the_polygon",
        |case| {
            let breaks: Vec<_> = (0..case.points.len()).map(|i| whole(3 * i)).collect();
            let after = whole(3 * breaks.len());
            let steps = Knots {
                degree: 0,
                knots: [&breaks[..], &[after]].concat(),
            };
            let first = breaks[0] - Exact::one();
            let polygon = Knots {
                degree: 1,
                knots: [&[first], &breaks[..], &[after]].concat(),
            };
            for (i, &point) in case.points.iter().enumerate() {
                let step = CurveCase {
                    knots: steps.clone(),
                    ..case.clone()
                };
                let inside = breaks[i] + Exact::one();
                expect_equal(
                    &[point; 2],
                    &[de_boor(&step, breaks[i]), de_boor(&step, inside)],
                )?;
                if let Some(&next) = case.points.get(i + 1) {
                    let side = CurveCase {
                        knots: polygon.clone(),
                        ..case.clone()
                    };
                    expect_equal(&point.lerp(next, fraction(1, 3)), &de_boor(&side, inside))?;
                }
            }
            Ok(())
        },
    );
}
