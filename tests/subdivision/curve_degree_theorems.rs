//! The theorems of the cubic scheme and of Lane and Riesenfeld's for every degree, and of their limits. The book shows their doc comments.

use facette::algebra::VectorSpace;
use facette::bspline::{KnotVector, basis_functions};
use facette::curve::Curve;
use facette::subdivision::curve::{
    Ends, chaikin_step, cubic_step, double_and_average, lane_riesenfeld_step, limit_curve,
    limit_points, limit_tangents, limit_weights, subdivided,
};
use num_traits::{One, Zero};
use proptest::prelude::*;

use crate::common::exact::{Exact, fraction};
use crate::common::law::{Broken, Law, expect_equal};
use crate::curve_inputs::{
    ALL_ENDS, Point, continued, hard_polygons, long_hard_polygons, long_polygons, polygons,
    refined, uniform_bspline, whole,
};
use crate::suspects;

/// Polygons that have a limit with open ends for the degree drawn with them.
fn with_degrees(
    polygons: impl Strategy<Value = Vec<Point>>,
) -> impl Strategy<Value = (usize, Vec<Point>)> {
    (polygons, 1..=6_usize).prop_map(|(points, degree)| (degree.min(points.len() - 1), points))
}

/// Degrees and ends, for which there is a rule.
fn rules() -> impl Iterator<Item = (usize, Ends)> {
    let pairs = (1..=7).flat_map(|degree| ALL_ENDS.map(|ends| (degree, ends)));
    pairs.filter(|&(degree, ends)| ends != Ends::Kept || degree == 2 || degree % 2 == 1)
}

/// **A point for each vertex, a point for each edge.** A round of the cubic scheme takes a vertex to $V=\frac18(P_-+6P+P_+)$ and puts $E=\frac12(P+P_+)$ on every edge, in turn. A closed polygon of $n$ points becomes
/// one of $2n$, $V_0,E_0,V_1,\dots$; an open one, whose end points have one neighbour only, one of $2n-3$, $E_0,V_1,\dots,E_{n-2}$. Kept ends stand before and behind: $2n-1$ points.
///
/// Course: D12, slide 63, the cubic scheme.
/// Exercise: cubic.
#[test]
fn cubic_step_takes_vertices_and_edges_in_turn() {
    Law::new(
        "subdivision::cubic_step_takes_vertices_and_edges_in_turn",
        suspects::cubic,
    )
    .holds(polygons(), hard_polygons(), |points| {
        let n = points.len();
        let mean = |weights: [i32; 3], of: [Point; 3]| {
            let term = |k: usize, axis: usize| fraction(weights[k], 8) * of[k][axis];
            [0, 1, 2].map(|axis| term(0, axis) + term(1, axis) + term(2, axis))
        };
        let around = |i: usize| [points[(i + n - 1) % n], points[i], points[(i + 1) % n]];
        let in_turn = |i: usize| [mean([1, 6, 1], around(i)), mean([0, 4, 4], around(i))];
        let closed: Vec<Point> = (0..n).flat_map(in_turn).collect();
        let open = closed
            .get(1..(2 * n).max(2) - 2)
            .unwrap_or_default()
            .to_vec();
        let [first, last] = [points.first(), points.last()].map(|end| end.into_iter().copied());
        let last = last.skip(usize::from(n == 1));
        let kept: Vec<Point> = first.chain(open.clone()).chain(last).collect();
        expect_equal(&closed, &cubic_step(points, Ends::Closed))?;
        expect_equal(&open, &cubic_step(points, Ends::Open))?;
        expect_equal(&kept, &cubic_step(points, Ends::Kept))?;
        let counts = [closed, open, kept].map(|finer| finer.len());
        let expected = [2 * n, (2 * n).saturating_sub(3), (2 * n).saturating_sub(1)];
        expect_equal(&expected, &counts)
    });
}

/// **The cubic scheme's limit.** After $k$ rounds the polygon is the control polygon of the same uniform *cubic* B-spline, on spans of length $2^{-k}$: Chaikin's scheme one degree higher.
///
/// Course: D12, slide 63, the cubic scheme: extension to cubic B-splines.
/// Exercise: cubic.
#[test]
fn cubic_schemes_limit_is_the_uniform_cubic_bspline() {
    Law::new(
        "subdivision::cubic_schemes_limit_is_the_uniform_cubic_bspline",
        suspects::cubic,
    )
    .on_cases(32)
    .holds(long_polygons(), long_hard_polygons(), |points| {
        for ends in ALL_ENDS {
            let (control_points, _) = continued(points, 3, ends);
            let limit = uniform_bspline(3, &control_points);
            let mut finer = points.clone();
            for parts in [2, 4, 8] {
                finer = cubic_step(&finer, ends);
                let (with_phantoms, _) = continued(&finer, 3, ends);
                expect_equal(&refined(&limit, parts), &with_phantoms)?;
            }
            expect_equal(&Ok(limit), &limit_curve(points, 3, ends))?;
        }
        Ok(())
    });
}

/// **Doubling and averaging.** Write every control point of a uniform B-spline of degree $d$ twice, and then $d$ times replace the list by the midpoints of its neighbours. What is left is the control polygon of the same curve on
/// halved spans: $2n-d$ points of $n$. So this scheme, too, is a parametric curve written otherwise, whatever the degree.
///
/// Course: D01, slide 49, subdivision: some schemes are parametric curves and surfaces.
/// Exercise: lane_riesenfeld.
#[test]
fn doubling_and_averaging_halves_the_spans() {
    Law::new(
        "subdivision::doubling_and_averaging_halves_the_spans",
        suspects::lane_riesenfeld,
    )
    .holds(
        with_degrees(long_polygons()),
        with_degrees(long_hard_polygons()),
        |(degree, points)| {
            let limit = uniform_bspline(*degree, points);
            let finer = double_and_average(points, *degree);
            expect_equal(&refined(&limit, 2), &finer)?;
            expect_equal(&(2 * points.len() - degree), &finer.len())
        },
    );
}

/// **One scheme for all degrees.** Lane and Riesenfeld's scheme is Chaikin's for $d=2$ and the cubic one for $d=3$, with all three kinds of ends. With $d=1$ it adds the midpoints of the edges.
///
/// Course: D12, slide 63, the cubic scheme: from degree 2 to degree 3 and on.
#[test]
fn degree_two_is_chaikins_scheme_and_three_the_cubic_one() {
    Law::new(
        "subdivision::degree_two_is_chaikins_scheme_and_three_the_cubic_one",
        suspects::library,
    )
    .holds(polygons(), hard_polygons(), |points| {
        for ends in ALL_ENDS {
            let of_degree = |degree| lane_riesenfeld_step(points, degree, ends);
            expect_equal(&of_degree(2), &Ok(chaikin_step(points, ends)))?;
            expect_equal(&of_degree(3), &Ok(cubic_step(points, ends)))?;
        }
        let with_midpoints = lane_riesenfeld_step(points, 1, Ends::Closed);
        let next = |i: usize| points[(i + 1) % points.len()];
        let expected = points
            .iter()
            .enumerate()
            .flat_map(|(i, &p)| [p, p.plus(next(i)).times(fraction(1, 2))]);
        expect_equal(&Ok(expected.collect()), &with_midpoints)
    });
}

/// **Every degree, with ends.** For every degree the refined polygon, continued beyond its ends, is the control polygon of the same B-spline on halved spans: closed, open, and with kept ends for $d=2$ and odd $d$. For
/// even $d\ge4$ kept ends are refused.
#[test]
fn every_degree_refines_its_bspline_with_every_kind_of_ends() {
    Law::new(
        "subdivision::every_degree_refines_its_bspline_with_every_kind_of_ends",
        suspects::library,
    )
    .on_cases(16)
    .holds(polygons(), hard_polygons(), |points| {
        for (degree, ends) in rules() {
            let (control_points, _) = continued(points, degree, ends);
            let step = lane_riesenfeld_step(points, degree, ends);
            let finer = step.map_err(|error| Broken {
                expected: "a finer polygon".to_owned(),
                got: error.to_string(),
            })?;
            if control_points.len() <= degree {
                // No span, and no limit. A single point with kept ends stays as it is.
                let expected = match ends {
                    Ends::Kept => points.clone(),
                    Ends::Closed | Ends::Open => double_and_average(points, degree),
                };
                expect_equal(&expected, &finer)?;
                continue;
            }
            let limit = uniform_bspline(degree, &control_points);
            let (with_phantoms, _) = continued(&finer, degree, ends);
            expect_equal(&refined(&limit, 2), &with_phantoms)?;
        }
        expect_equal(&true, &lane_riesenfeld_step(points, 4, Ends::Kept).is_err())
    });
}

/// **As smooth as the degree allows.** The limit of degree $d$ is a polynomial of degree $d$ on every span. At a knot its derivatives up to order $d-1$ agree on both sides, and that of order $d$ jumps by the difference
/// $\Delta^{d+1}P$ of the $d+2$ points around. So Chaikin's limit is C¹, the cubic scheme's C², and not smoother unless that difference is zero.
///
/// Measured on limit points of the third round alone, nine to a span: the polynomial through those of one span, continued over the next, misses those there by $\frac1{d!}\Delta^{d+1}P\,(u-u_i)^d$.
///
/// Course: D05, slide 55, Chaikin's algorithm: continuity C¹.
/// Course: D12, slide 63, the cubic scheme: continuity C².
#[test]
fn limit_of_degree_d_has_d_minus_one_continuous_derivatives_and_not_more() {
    Law::new(
        "subdivision::limit_of_degree_d_has_d_minus_one_continuous_derivatives_and_not_more",
        suspects::library,
    )
    .on_cases(16)
    .holds(long_polygons(), long_hard_polygons(), |points| {
        for degree in 2..points.len().min(6) {
            let third = subdivided(points, degree, Ends::Open, 3);
            let samples = third.and_then(|finer| limit_points(&finer, degree, Ends::Open));
            let samples = samples.map_err(|error| Broken {
                expected: "limit points".to_owned(),
                got: error.to_string(),
            })?;
            let factorial = (1..=degree).fold(Exact::one(), |product, k| product * whole(k));
            for (knot, around) in points.windows(degree + 2).enumerate() {
                let jump = difference(around);
                let [left, right] = [knot, knot + 1].map(|span| &samples[8 * span..=8 * span + 8]);
                for span in [left, right] {
                    let polynomial = continued_polynomial(&span[..=degree], 9);
                    expect_equal(&polynomial, &span.to_vec())?;
                }
                let over_the_knot = continued_polynomial(&left[8 - degree..], degree + 9);
                for (m, &sample) in right.iter().enumerate() {
                    let offset = fraction(i32::try_from(m).expect("at most 8"), 8);
                    let power = (0..degree).fold(Exact::one(), |power, _| power * offset);
                    let missed = sample.minus(over_the_knot[degree + m]);
                    expect_equal(&jump.times(power / factorial), &missed)?;
                }
            }
        }
        Ok(())
    });
}

/// The difference of the highest order that so many points have.
fn difference(points: &[Point]) -> Point {
    let mut differences = points.to_vec();
    while differences.len() > 1 {
        let next = differences.windows(2).map(|pair| pair[1].minus(pair[0]));
        differences = next.collect();
    }
    differences[0]
}

/// The first `count` values, at equal distances, of the polynomial of lowest degree through the given ones.
fn continued_polynomial(values: &[Point], count: usize) -> Vec<Point> {
    // The last entries of each row of the table of differences; the highest difference does not change.
    let mut row = values.to_vec();
    let mut lasts = Vec::new();
    while let Some(&last) = row.last() {
        lasts.push(last);
        row = row.windows(2).map(|pair| pair[1].minus(pair[0])).collect();
    }
    let mut continued = values.to_vec();
    while continued.len() < count {
        for order in (0..lasts.len() - 1).rev() {
            lasts[order] = lasts[order].plus(lasts[order + 1]);
        }
        continued.push(lasts[0]);
    }
    continued
}

/// **Limit points.** The point of the limit at the knot in the middle of $d$ neighbouring points is their mean with the values of the B-spline at its knots for weights: $\frac12(P+P_+)$ for $d=2$, $\frac16(P_-+4P+P_+)$ for
/// $d=3$, $\frac1{24}(1,11,11,1)$ for $d=4$.
///
/// Course: D12, slide 63, the cubic scheme: where a vertex goes.
#[test]
fn limit_masks_are_the_bspline_at_its_knots() {
    let masks = [
        (1, vec![1]),
        (2, vec![1, 1]),
        (3, vec![1, 4, 1]),
        (4, vec![1, 11, 11, 1]),
    ];
    for (degree, numerators) in masks {
        let sum = numerators.iter().sum();
        let expected: Vec<Exact> = numerators.iter().map(|&n| fraction(n, sum)).collect();
        assert_eq!(limit_weights(degree), Ok(expected));
    }
    Law::new(
        "subdivision::limit_masks_are_the_bspline_at_its_knots",
        suspects::library,
    )
    .on_cases(33)
    .holds(1..=12_usize, 13..=33_usize, |&degree| {
        let knots = KnotVector::uniform(degree, 2 * degree + 1).expect("a small degree");
        let mut values = vec![Exact::zero(); degree + 1];
        basis_functions(&knots, 2 * degree, whole(degree), &mut values);
        // At a knot the last of the functions that may count does not.
        expect_equal(&Some(Exact::zero()), &values.pop())?;
        expect_equal(&Ok(values), &limit_weights(degree))
    });
}

/// **Points and tangents without going to the limit.** The limit points and tangents of a polygon are the points and first derivatives of its B-spline at the knots $0,1,2,\dots$: for $d=3$, at a vertex, $\frac16(P_-+4P+P_+)$ and
/// $\frac12(P_+-P_-)$. A polygon has as many as it has spans, and one more where it does not close.
///
/// Course: D12, slide 63, the cubic scheme: where a vertex goes, and its tangent.
#[test]
fn limit_points_and_tangents_are_those_of_the_bspline() {
    Law::new(
        "subdivision::limit_points_and_tangents_are_those_of_the_bspline",
        suspects::library,
    )
    .on_cases(32)
    .holds(long_polygons(), long_hard_polygons(), |points| {
        for (degree, ends) in rules() {
            let (control_points, _) = continued(points, degree, ends);
            let Some(spans) = control_points
                .len()
                .checked_sub(degree)
                .filter(|&spans| spans > 0)
            else {
                continue;
            };
            let limit = uniform_bspline(degree, &control_points);
            let knots = 0..spans + usize::from(ends != Ends::Closed);
            let on_curve = knots.clone().map(|i| limit.point(whole(i))).collect();
            expect_equal(&Ok(on_curve), &limit_points(points, degree, ends))?;
            let tangents = limit_tangents(points, degree, ends);
            if degree == 1 {
                expect_equal(&true, &tangents.is_err())?;
                continue;
            }
            let derivatives = knots.map(|i| limit.derivative_at(1, whole(i))).collect();
            expect_equal(&Ok(derivatives), &tangents)?;
        }
        let third = [0, 1, 2].map(|axis| {
            let [before, p, next] = [points[0], points[1], points[2]].map(|p| p[axis]);
            (before + p * whole(4) + next) / whole(6)
        });
        let limits = limit_points(points, 3, Ends::Open);
        expect_equal(
            &Ok(Some(third)),
            &limits.map(|limits| limits.first().copied()),
        )
    });
}

/// **A round keeps the limit.** The limit points of a polygon are limit points of the finer one, every other of them; and its tangents are half as long, since the finer polygon's spans are.
#[test]
fn a_round_keeps_the_limit_points() {
    Law::new(
        "subdivision::a_round_keeps_the_limit_points",
        suspects::library,
    )
    .on_cases(32)
    .holds(long_polygons(), long_hard_polygons(), |points| {
        for (degree, ends) in rules().filter(|&(degree, _)| degree > 1) {
            let finer = subdivided(points, degree, ends, 1);
            let of_both = |limit: fn(&[Point], usize, Ends) -> _| {
                let coarse = limit(points, degree, ends);
                let fine = finer.clone().and_then(|finer| limit(&finer, degree, ends));
                let every_other =
                    fine.map(|fine: Vec<Point>| fine.into_iter().step_by(2).collect::<Vec<_>>());
                (coarse, every_other)
            };
            let (coarse, fine) = of_both(limit_points);
            expect_equal(&coarse, &fine)?;
            let (coarse, fine) = of_both(limit_tangents);
            let halved = coarse.map(|tangents| {
                let halves = tangents
                    .into_iter()
                    .map(|tangent| tangent.times(fraction(1, 2)));
                halves.collect::<Vec<_>>()
            });
            expect_equal(&halved, &fine)?;
        }
        Ok(())
    });
}

/// **Kept ends.** With kept ends the limit runs from the first point to the last. The cubic limit leaves along the first edge, with the derivative $P_1-P_0$ and with second derivative zero; Chaikin's first piece is the first half of that edge
/// itself, run through as $P_0+\frac12u^2(P_1-P_0)$, so that it starts with speed zero. At the other end likewise.
#[test]
fn kept_ends_are_ends_of_the_limit() {
    Law::new(
        "subdivision::kept_ends_are_ends_of_the_limit",
        suspects::library,
    )
    .holds(long_polygons(), long_hard_polygons(), |points| {
        let backwards: Vec<Point> = points.iter().rev().copied().collect();
        for points in [points, &backwards] {
            let limit = |degree| limit_curve(points, degree, Ends::Kept);
            let (Ok(quadratic), Ok(cubic)) = (limit(2), limit(3)) else {
                return Err(Broken {
                    expected: "two limits".to_owned(),
                    got: "a refusal".to_owned(),
                });
            };
            let [p, q] = [points[0], points[1]];
            let u = fraction(2, 3);
            let on_edge = p.plus(q.minus(p).times(u * u / whole(2)));
            expect_equal(
                &[p, on_edge],
                &[Exact::zero(), u].map(|u| quadratic.point(u)),
            )?;
            let start = [0, 1, 2].map(|order| cubic.derivative_at(order, Exact::zero()));
            expect_equal(&[p, q.minus(p), Point::origin()], &start)?;
        }
        Ok(())
    });
}
