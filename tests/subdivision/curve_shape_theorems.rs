//! The theorems of what subdivision does to a polygon's shape, of counts, and of the distance to the limit. The book shows their doc comments.

use facette::algebra::VectorSpace;
use facette::curve::Curve;
use facette::subdivision::curve::{
    Ends, PolygonError, chaikin_step, distance_bound, lane_riesenfeld_step, limit_points,
    point_count, rounds_within, subdivided,
};
use num_traits::{One, Zero};
use proptest::collection::btree_set;
use proptest::prelude::*;

use crate::common::exact::{Exact, fraction};
use crate::common::generators::{parameter, point};
use crate::common::law::{Broken, Law, Verdict, expect_equal};
use crate::curve_inputs::{
    ALL_ENDS, Point, continued, hard_polygons, heights, long_hard_polygons, long_polygons,
    polygons, uniform_bspline, whole,
};
use crate::suspects;

/// Passes where `holds`.
fn expect(promise: &str, holds: bool, got: impl std::fmt::Debug) -> Verdict {
    if holds {
        return Ok(());
    }
    Err(Broken {
        expected: promise.to_owned(),
        got: format!("{got:?}"),
    })
}

/// The polygons that the schemes make of one, for a law that all of them obey.
fn all_steps(points: &[Point], ends: Ends) -> Vec<Vec<Point>> {
    let others = [3, 4, 5].into_iter();
    let others = others.filter_map(|degree| lane_riesenfeld_step(points, degree, ends).ok());
    [chaikin_step(points, ends)]
        .into_iter()
        .chain(others)
        .collect()
}

/// **A round is a mean.** A round moves with the points: if every point $P$ goes to $AP+b$, any matrix $A$ and vector $b$, every new point does.
///
/// Exercise: chaikin.
#[test]
fn subdivision_is_affinely_invariant() {
    let maps = || [point(), point(), point(), point()];
    Law::new(
        "subdivision::subdivision_is_affinely_invariant",
        suspects::chaikin,
    )
    .holds(
        (polygons(), maps()),
        (hard_polygons(), maps()),
        |(points, [x, y, z, shift])| {
            let image = |&p: &Point| Point::combination(p, [*x, *y, *z]).plus(*shift);
            let images: Vec<Point> = points.iter().map(image).collect();
            for ends in ALL_ENDS {
                let moved_after = all_steps(points, ends).into_iter();
                let moved_after = moved_after.map(|finer| finer.iter().map(image).collect());
                expect_equal(
                    &moved_after.collect::<Vec<Vec<Point>>>(),
                    &all_steps(&images, ends),
                )?;
            }
            Ok(())
        },
    );
}

/// **Convex hull.** Every new point lies in the convex hull of the old ones, and so does the limit: in no direction does anything reach further than the polygon.
///
/// Exercise: chaikin.
#[test]
fn finer_polygon_stays_in_the_convex_hull() {
    Law::new(
        "subdivision::finer_polygon_stays_in_the_convex_hull",
        suspects::chaikin,
    )
    .holds(
        (polygons(), point()),
        (hard_polygons(), point()),
        |(points, direction)| {
            let reach = |points: &[Point]| {
                let heights = heights(points, *direction).into_iter();
                heights.reduce(|a, b| if a > b { a } else { b })
            };
            for ends in ALL_ENDS {
                let mut reached = all_steps(points, ends);
                reached.extend(
                    [2, 3].map(|degree| limit_points(points, degree, ends).unwrap_or_default()),
                );
                for finer in reached {
                    expect(
                        "no further in this direction",
                        reach(&finer) <= reach(points),
                        finer,
                    )?;
                }
            }
            Ok(())
        },
    );
}

/// **No new crossings.** A plane crosses the finer polygon no more often than the old one: a round adds no wiggles. (It is the same for lines in the plane.)
///
/// Exercise: chaikin.
#[test]
fn finer_polygon_crosses_no_plane_more_often() {
    Law::new(
        "subdivision::finer_polygon_crosses_no_plane_more_often",
        suspects::chaikin,
    )
    .holds(
        (polygons(), point(), -9..=9_i32),
        (hard_polygons(), point(), Just(0)),
        |(points, normal, level)| {
            let crossings = |points: &[Point], ends: Ends| {
                let above = heights(points, *normal).into_iter();
                let above = above.map(|height| height - fraction(*level, 1));
                let sides: Vec<bool> = above
                    .filter(|height| !height.is_zero())
                    .map(|height| height > Exact::zero())
                    .collect();
                let inner = sides.windows(2).filter(|pair| pair[0] != pair[1]).count();
                let closing = ends == Ends::Closed && sides.first() != sides.last();
                inner + usize::from(closing)
            };
            for ends in ALL_ENDS {
                for finer in all_steps(points, ends) {
                    let no_more = crossings(&finer, ends) <= crossings(points, ends);
                    expect("no more crossings than before", no_more, finer)?;
                }
            }
            Ok(())
        },
    );
}

/// A polygon in the plane with corners on a circle, in order, stretched and sheared: convex.
fn convex_polygons() -> impl Strategy<Value = Vec<[Exact; 2]>> {
    let slopes = btree_set(-12..=12_i32, 3..=8);
    (slopes, 1..=4_i32, -3..=3_i32).prop_map(|(slopes, stretch, shear)| {
        let on_circle = |slope: i32| {
            let t = fraction(slope, 4);
            let over = Exact::one() / (Exact::one() + t * t);
            let [x, y] = [(Exact::one() - t * t) * over, (t + t) * over];
            [x * fraction(stretch, 1) + y * fraction(shear, 2), y]
        };
        slopes.into_iter().map(on_circle).collect()
    })
}

/// Convex polygons with points on their edges and points that stand twice.
fn hard_convex_polygons() -> impl Strategy<Value = Vec<[Exact; 2]>> {
    (convex_polygons(), 0..8_usize, parameter()).prop_map(|(mut points, edge, t)| {
        let edge = edge % points.len();
        let on_edge = points[edge].lerp(points[(edge + 1) % points.len()], t);
        points.insert(edge + 1, on_edge);
        points
    })
}

/// **Convex stays convex.** A closed convex polygon in the plane is convex after every round of Chaikin's scheme, and its limit is a convex curve: all of it lies on one side of each edge.
///
/// Course: D05, slide 55, Chaikin's algorithm: the shape of the limit.
/// Exercise: chaikin.
#[test]
fn chaikin_keeps_a_convex_polygon_convex() {
    Law::new(
        "subdivision::chaikin_keeps_a_convex_polygon_convex",
        suspects::chaikin,
    )
    .holds(convex_polygons(), hard_convex_polygons(), |points| {
        let mut finer = points.clone();
        for _ in 0..3 {
            finer = chaikin_step(&finer, Ends::Closed);
            for i in 0..finer.len() {
                let [p, next] = [finer[i], finer[(i + 1) % finer.len()]];
                let [ex, ey] = next.minus(p);
                let is_left = |q: &[Exact; 2]| {
                    let [x, y] = q.minus(p);
                    ex * y - ey * x >= Exact::zero()
                };
                expect(
                    "all points on one side",
                    finer.iter().all(is_left),
                    [p, next],
                )?;
            }
        }
        Ok(())
    });
}

/// **How many points.** In $k$ rounds of degree $d$ a closed polygon of $n$ points becomes one of $2^kn$ points, an open one of $2^k(n-d)+d$, and one with kept ends of $2^kn$ for $d=2$ and of $2^k(n-1)+1$ for odd $d$. An open
/// polygon with fewer than $d$ points dwindles to nothing; one with $d$ points keeps their number.
///
/// Course: D04, slide 54, Chaikin's algorithm: n points become 2n.
#[test]
fn point_counts_have_a_closed_form() {
    Law::new(
        "subdivision::point_counts_have_a_closed_form",
        suspects::library,
    )
    .holds(
        (polygons(), 1..=6_usize, 0..=4_u32),
        (hard_polygons(), 1..=6_usize, 0..=4_u32),
        |(points, degree, rounds)| {
            let [n, d, doublings] = [points.len(), *degree, 1 << rounds];
            let open = (doublings * n + d).saturating_sub(doublings * d);
            let kept = match d {
                2 => Ok(doublings * n),
                _ if d % 2 == 1 => Ok((doublings * n + 1).saturating_sub(doublings)),
                _ => Err(PolygonError::EndsNotKept { degree: d }),
            };
            let expected = [Ok(doublings * n), Ok(open), kept];
            let said = ALL_ENDS.map(|ends| point_count(n, d, ends, *rounds));
            let made =
                ALL_ENDS.map(|ends| subdivided(points, d, ends, *rounds).map(|finer| finer.len()));
            expect_equal(&expected, &said)?;
            expect_equal(&expected, &made)
        },
    );
}

/// The polygon after so many rounds as a function of the limit's parameter: vertex number i of the continued polygon stands at `(i − (d − 1)/2) 2⁻ᵏ`.
fn on_polygon(control_points: &[Point], degree: usize, rounds: u32, u: Exact) -> Point {
    let place = u * whole(1 << rounds) + whole(degree - 1) / whole(2);
    let below = (0..control_points.len() - 1)
        .rev()
        .find(|&i| whole(i) <= place)
        .unwrap_or(0);
    control_points[below].lerp(control_points[below + 1], place - whole(below))
}

/// **How far the polygon is from its limit.** After $k$ rounds the polygon is within $\frac{d+1}{24}\,4^{-k}\max|P_{i-1}-2P_i+P_{i+1}|$ of the limit of degree $d\ge2$, in each coordinate and at equal parameters: $\frac18$ for Chaikin, $\frac16$ for the cubic scheme. Each
/// round divides the distance by four. A parabola attains the bound at every vertex.
///
/// Proof. Let $N$ be the B-spline of degree $d$ and $\Lambda$ the hat function, both centred at 0. $N$ is the mean of $\Lambda(u-s)$ over all $s$, weighted by the B-spline of degree $d-2$, whose mean is 0. As $\Lambda$ is the second difference of $\frac12|u|$, $N-\Lambda$ is the second difference
/// of $K(u)=\frac12(\overline{|u-s|}-|u|)$, which is not negative: the mean of a convex function is at least its value at the mean. So the distance is $\sum_i K(u-i)\,\Delta^2P_i$, at most $\max|\Delta^2P|\sum_iK(u-i)$. To find the sum take $P_i=\frac12i^2$: the limit is $\frac12u^2+\frac{d+1}{24}$, and the polygon at least
/// $\frac12u^2$, with equality at the vertices. Second differences of the finer polygon are means of a quarter of the old ones.
#[test]
fn distance_to_the_limit_is_at_most_its_bound() {
    let parabola = (-4..=4_i32, 5..=8_i32, parameter()).prop_map(|(bend, count, t)| {
        let at = |i: i32| {
            [
                fraction(i, 1),
                fraction(bend * i * i, 2),
                fraction(-i * i, 3),
            ]
        };
        ((0..count).map(at).collect::<Vec<Point>>(), t)
    });
    let hard = prop_oneof![(long_hard_polygons(), Just(Exact::zero())), parabola];
    Law::new(
        "subdivision::distance_to_the_limit_is_at_most_its_bound",
        suspects::library,
    )
    .holds((long_polygons(), parameter()), hard, |(points, t)| {
        for (degree, ends) in [
            (2, Ends::Closed),
            (3, Ends::Closed),
            (3, Ends::Open),
            (2, Ends::Kept),
            (3, Ends::Kept),
            (5, Ends::Closed),
        ] {
            let (control_points, _) = continued(points, degree, ends);
            let limit = uniform_bspline(degree, &control_points);
            let [_, end] = limit.knots().domain();
            let mut bound_before = None;
            for rounds in [0, 1, 2] {
                let finer = subdivided(points, degree, ends, rounds).unwrap_or_default();
                let (finer, _) = continued(&finer, degree, ends);
                let bound = distance_bound(points, degree, ends, rounds).unwrap_or(-Exact::one());
                for u in [*t * end, Exact::zero(), end / whole(2)] {
                    let away = limit.point(u).minus(on_polygon(&finer, degree, rounds, u));
                    expect(
                        "within the bound",
                        away.largest_coordinate() <= bound,
                        (away, bound),
                    )?;
                }
                if let Some(before) = bound_before.replace(bound) {
                    expect_equal(&before, &(bound * whole(4)))?;
                }
            }
        }
        expect_equal(
            &Ok(Exact::zero()),
            &distance_bound(points, 1, Ends::Open, 0),
        )
    });
    let parabola: Vec<Point> = (0..7)
        .map(|i| [whole(i), whole(i * i), Exact::one()])
        .collect();
    for degree in [2, 3, 4, 5] {
        let limit = uniform_bspline(degree, &parabola);
        // Of even degree the vertices stand between the knots.
        let u = if degree % 2 == 0 {
            fraction(1, 2)
        } else {
            Exact::one()
        };
        let away = limit.point(u).minus(on_polygon(&parabola, degree, 0, u));
        let bound = distance_bound(&parabola, degree, Ends::Open, 0);
        assert_eq!(bound, Ok(away.largest_coordinate()), "degree {degree}");
    }
}

/// **How many rounds are enough.** The number of rounds for a tolerance is the smallest whose bound is not above it.
#[test]
fn rounds_for_a_tolerance_are_the_fewest_that_the_bound_allows() {
    let tolerances = || (1..=9_i32, 1..=2000_i32).prop_map(|(n, d)| fraction(n, d));
    Law::new(
        "subdivision::rounds_for_a_tolerance_are_the_fewest_that_the_bound_allows",
        suspects::library,
    )
    .holds(
        (long_polygons(), tolerances()),
        (long_hard_polygons(), tolerances()),
        |(points, tolerance)| {
            for degree in [2, 3] {
                let bound = |rounds| distance_bound(points, degree, Ends::Kept, rounds);
                let enough = |rounds: &u32| bound(*rounds).is_ok_and(|bound| bound <= *tolerance);
                let fewest = (0..=31).find(enough);
                let said = rounds_within(points, degree, Ends::Kept, *tolerance);
                expect_equal(&fewest, &said.ok())?;
                // A tolerance that is the bound itself is met; that of points on a line is met at once.
                let of_three = bound(3).unwrap_or_else(|_| Exact::zero());
                let expected = if of_three.is_zero() { 0 } else { 3 };
                let said = rounds_within(points, degree, Ends::Kept, of_three);
                expect_equal(&Ok(expected), &said)?;
            }
            let step = lane_riesenfeld_step(points, 3, Ends::Kept);
            let after_one = step.and_then(|finer| distance_bound(&finer, 3, Ends::Kept, 0));
            let promised = distance_bound(points, 3, Ends::Kept, 1);
            expect(
                "no larger than was promised",
                after_one.is_ok() && after_one.clone().ok() <= promised.ok(),
                after_one,
            )
        },
    );
}
