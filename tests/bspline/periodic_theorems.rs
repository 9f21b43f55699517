//! The theorems of surfaces that close, in the order of the text. The book shows their doc comments.

mod inputs;

use facette::algebra::{Vector3, VectorSpace};
use facette::bspline::{
    BsplineSurface, Closing, Direction, KnotVector, PeriodicError, closed_surface,
};
use facette::surface::Surface;
use num_traits::{One, Zero};
use proptest::collection::vec;
use proptest::prelude::*;

use crate::common::exact::{Exact, fraction};
use crate::common::generators::point;
use crate::common::law::{Law, expect_equal};
use crate::suspects;
use inputs::{
    Point, Side, close, hard_side, integer, ordinary_side, period, points, share, slide_torus_v,
    slide_u, slide_v, spans, strip, unrolled,
};

/// **Cylinder.** A surface that closes in $u$ is one period of a B-spline surface whose knots and control points repeat without end: on three periods of
/// the knots, with the control points $P_{i+kN,j}=P_{ij}$ of $N$ distinct columns, all three show the same surface, whatever the spacings inside a period are.
///
/// Course: B19, slide 27, periodic surfaces: the cylinder.
#[test]
fn cylinder_is_one_period_of_an_endless_surface() {
    let law = Law::new(
        "bspline::cylinder_is_one_period_of_an_endless_surface",
        suspects::library,
    );
    let input = |side: BoxedStrategy<Side>| (side, points(), share());
    law.holds(
        input(ordinary_side().boxed()),
        input(hard_side().boxed()),
        |(side, points, v)| {
            let n = spans(side);
            let across = KnotVector::bezier(2);
            let tube = close(
                [side.knots.clone(), across.clone()],
                &points[..3 * n],
                [Closing::Closed, Closing::Open],
            );
            let endless = unrolled(side);
            let columns = endless.control_point_count();
            // The first column of the unrolled net is one period before that of the tube.
            let net = (0..3).flat_map(|j| (0..columns).map(move |i| points[j * n + i % n]));
            let endless =
                BsplineSurface::new([endless, across], net.collect()).expect("the net fits");
            for turn in -1..=1 {
                let u = side.parameter + integer(turn) * period(side);
                expect_equal(&endless.point(u, *v), &tube.point(u, *v))?;
                expect_equal(&endless.partials(u, *v), &tube.partials(u, *v))?;
            }
            Ok(())
        },
    );
}

/// **Torus.** Closed in both directions, the surface is one period in each: $S(u+T_u,v)=S(u,v+T_v)=S(u,v)$, and it is the B-spline surface whose net
/// $P_{i+kN,j+lM}=P_{ij}$ covers the plane.
///
/// Course: B19, slide 30, periodic surfaces: the torus.
#[test]
fn torus_is_one_period_of_an_endless_surface() {
    let law = Law::new(
        "bspline::torus_is_one_period_of_an_endless_surface",
        suspects::library,
    )
    .on_cases(32);
    let input = |[u, v]: [BoxedStrategy<Side>; 2]| (u, v, points());
    law.holds(
        input([ordinary_side().boxed(), hard_side().boxed()]),
        input([hard_side().boxed(), hard_side().boxed()]),
        |(in_u, in_v, points)| {
            let [n, m] = [spans(in_u), spans(in_v)];
            let torus = close(
                [in_u.knots.clone(), in_v.knots.clone()],
                &points[..n * m],
                [Closing::Closed; 2],
            );
            let endless = [unrolled(in_u), unrolled(in_v)];
            let [columns, rows] = endless.each_ref().map(KnotVector::control_point_count);
            let net = (0..rows).flat_map(|j| (0..columns).map(move |i| points[j % m * n + i % n]));
            let endless = BsplineSurface::new(endless, net.collect()).expect("the net fits");
            for (right, up) in [(0, 0), (1, 0), (0, -1), (-1, 1)] {
                let u = in_u.parameter + integer(right) * period(in_u);
                let v = in_v.parameter + integer(up) * period(in_v);
                expect_equal(&endless.point(u, v), &torus.point(u, v))?;
            }
            Ok(())
        },
    );
}

/// **The seam is an ordinary knot.** Where the knot of the seam stands $k$ times, all derivatives up to order $p-k$ agree from both sides of it. A simple
/// knot gives $C^{p-1}$, as at every other knot line: nothing tells where the surface was closed.
///
/// Course: B19, slide 27, periodic surfaces: the seam.
#[test]
fn seam_is_as_smooth_as_the_degree_promises() {
    let law = Law::new(
        "bspline::seam_is_as_smooth_as_the_degree_promises",
        suspects::library,
    );
    let input = |side: BoxedStrategy<Side>| (side, points(), share());
    law.holds(
        input(ordinary_side().boxed()),
        input(hard_side().boxed()),
        |(side, points, v)| {
            let across = KnotVector::bezier(2);
            let tube = close(
                [side.knots.clone(), across],
                &points[..3 * spans(side)],
                [Closing::Closed, Closing::Open],
            );
            let [start, end] = side.knots.domain();
            let smooth = side.knots.degree() - side.knots.multiplicity(start);
            for orders in (0..=smooth).flat_map(|k| [[k, 0], [k, 1], [k, 2]]) {
                let [after, before] =
                    [start, end].map(|u| tube.surface().derivative_at(orders, u, *v));
                expect_equal(&after, &before)?;
            }
            Ok(())
        },
    );
}

/// **And not smoother.** At a simple seam of knots with spacing 1, the derivative of order $p$ jumps by the difference of order $p+1$ of the control points
/// around it, $\Delta^{p+1}P_{-1}=\sum_i(-1)^{p+1-i}\binom{p+1}{i}P_{i-1}$, counted round the period: it is zero only by accident.
///
/// Course: B19, slide 27, periodic surfaces: the seam.
#[test]
fn derivative_of_order_p_jumps_at_the_seam_by_a_difference() {
    let law = Law::new(
        "bspline::derivative_of_order_p_jumps_at_the_seam_by_a_difference",
        suspects::library,
    );
    let jump = |degree: usize, ring: &[Point]| {
        let count = ring.len();
        let mut differences: Vec<Point> = (0..degree + 2)
            .map(|i| ring[(i + count - 1) % count])
            .collect();
        while differences.len() > 1 {
            differences = differences
                .windows(2)
                .map(|pair| pair[1].minus(pair[0]))
                .collect();
        }
        differences[0]
    };
    law.holds(
        (1..=4_usize, vec(point(), 5..8)),
        (1..=4_usize, vec(point(), 1..4)),
        |(degree, ring)| {
            let knots = KnotVector::uniform(*degree, ring.len() + degree).expect("enough points");
            let [start, end] = knots.domain();
            let net = [&ring[..], &ring[..]].concat();
            let closing = [Closing::Closed, Closing::Open];
            let tube = close([knots, KnotVector::bezier(1)], &net, closing);
            let [after, before] =
                [start, end].map(|u| tube.surface().derivative_at([*degree, 0], u, Exact::zero()));
            expect_equal(&jump(*degree, ring), &after.minus(before))
        },
    );
    let corner = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [2, 1, 5]].map(|p| p.map(integer));
    assert_ne!(
        jump(3, &corner),
        Point::origin(),
        "such points are no accident"
    );
}

/// **Equal spacings.** What must repeat is the distances between the knots, not the knots: $u_{i+N+1}-u_{i+N}=u_{i+1}-u_i$ for the $2p-2$ spacings around the seam. If
/// the knot 14 of the slides' $U$ is moved to $14\tfrac12$, the repeated control points no longer close the surface: $S(12,v)\ne S(0,v)$, and the library refuses the knots. Degree 1 has no
/// such spacing: a polygon closes over any knots.
///
/// Course: B19, slide 28, periodic surfaces: the knots of the cylinder.
#[test]
fn periodicity_needs_equal_spacings_around_the_seam() {
    let mut knots = slide_u().knots().to_vec();
    knots[17] = fraction(29, 2);
    let moved = KnotVector::new(3, knots).expect("still increasing");
    let ring = |i: i32| [integer(i % 5), integer(i * i % 7), integer(i)];
    let net: Vec<Point> = (0..2).flat_map(|_| (0..12).map(ring)).collect();
    let closing = [Closing::Closed, Closing::Open];
    let repeated = (0..2).flat_map(|_| (0..15).map(|i| ring(i % 12))).collect();
    let open =
        BsplineSurface::new([moved.clone(), KnotVector::bezier(1)], repeated).expect("15 columns");
    let [start, end] = [0, 12].map(|u| open.point(integer(u), Exact::zero()));
    assert_ne!(start, end);
    let refused = closed_surface([moved, KnotVector::bezier(1)], &net, closing);
    let error = PeriodicError::SpacingsDiffer {
        direction: Direction::U,
        index: 4,
        first: integer(1),
        later: fraction(3, 2),
    };
    assert_eq!(refused, Err(error));
    let uneven = KnotVector::new(1, [0, 1, 5, 6, 9].map(integer).to_vec()).expect("increasing");
    let polygon = close(
        [uneven, KnotVector::bezier(1)],
        &[
            [Exact::one(); 3],
            [Exact::zero(); 3],
            [Exact::one(); 3],
            [Exact::zero(); 3],
        ],
        closing,
    );
    let [first, last] =
        polygon.surface().domain()[0].map(|u| polygon.surface().point(u, Exact::zero()));
    assert_eq!(first, last);
}

/// **Control points are repeated, not knots.** In the three knot vectors of the slides that close, every knot is simple. What is repeated is control points: the first $p$ columns stand
/// again at the end, so that of the torus's $12\cdot7$ distinct points $p\,q=6$ stand four times in the net, those of the other repeated columns and rows
/// twice, the rest once.
///
/// Course: B18, slide 26, periodic surfaces: what is repeated.
/// Erratum: The slides say that closing in both directions repeats some knots four times. All knots of their torus are simple; it is some of the control points that stand four times in the net.
#[test]
fn closing_repeats_control_points_and_not_knots() {
    let knots = [slide_u(), slide_torus_v()];
    for vector in &knots {
        assert!(vector.multiplicities().iter().all(|&(_, times)| times == 1));
    }
    let distinct: Vec<Point> = (0..84)
        .map(|k| [integer(k), integer(k * k), Exact::zero()])
        .collect();
    let torus = close(knots, &distinct, [Closing::Closed; 2]);
    let times = |point: &Point| {
        torus
            .surface()
            .control_points()
            .iter()
            .filter(|&p| p == point)
            .count()
    };
    let mut counts = [0; 5];
    for point in &distinct {
        counts[times(point)] += 1;
    }
    let [p, q, n, m] = [3, 2, 12, 7];
    assert_eq!(
        counts,
        [0, (n - p) * (m - q), p * (m - q) + q * (n - p), 0, p * q]
    );
    let [i, j] = [0, 1];
    let copies = [[i, j], [i + 12, j], [i, j + 7], [i + 12, j + 7]];
    assert!(
        copies
            .iter()
            .all(|&[i, j]| torus.surface().control_point(i, j) == distinct[12])
    );
}

/// **The slides' counts.** $U=\{-3,\dots,15\}$ with $p=3$: 19 knots, $19-3-1=15$ columns, of which 12 are distinct and 3 repeated, domain $[0,12]$.
/// $V=\{0,0,0,1,\dots,6,7,7,7\}$ with $q=2$: 12 knots, 9 rows, all distinct, domain $[0,7]$. The torus's $V=\{-2,\dots,9\}$ has 12 knots and 9 rows too, but 7 are distinct and 2 repeated, on the same domain.
///
/// Course: B19, slide 31, periodic surfaces: the knots of cylinder, Möbius band and torus.
#[test]
fn knots_of_the_slides_ask_for_these_control_points() {
    let facts = |knots: KnotVector<Exact>| {
        (
            knots.knots().len(),
            knots.control_point_count(),
            knots.domain(),
        )
    };
    assert_eq!(facts(slide_u()), (19, 15, [0, 12].map(integer)));
    assert_eq!(facts(slide_v()), (12, 9, [0, 7].map(integer)));
    assert_eq!(facts(slide_torus_v()), (12, 9, [0, 7].map(integer)));
    let breaks: Vec<_> = (0..=12).map(integer).collect();
    assert_eq!(KnotVector::periodic(3, &breaks), Ok(slide_u()));
    let net = |count| vec![Point::origin(); count];
    let [closed, open, flipped] = [Closing::Closed, Closing::Open, Closing::Flipped];
    for (in_v, v, rows) in [(open, slide_v(), 9), (closed, slide_torus_v(), 7)] {
        let surface = close([slide_u(), v], &net(12 * rows), [closed, in_v]);
        assert_eq!(surface.distinct_counts(), [12, rows]);
    }
    let band = close([slide_u(), slide_v()], &net(12 * 9), [flipped, open]);
    assert_eq!(band.distinct_counts(), [12, 9]);
}

/// **Möbius band.** Repeated upside down, $P_{i+12,j}=P_{i,8-j}$, the columns close the surface with a flip: $S(u+12,v)=S(u,7-v)$. Across the seam all derivatives up
/// to order $p-1=2$ in $u$ agree, those of order $l<q$ in $v$ with the sign $(-1)^l$; the second time round everything is back in place. The knots in $v$ must be symmetric for this, which $V$ is.
///
/// Course: B19, slide 29, periodic surfaces: the Möbius band.
#[test]
fn moebius_band_closes_with_a_flip() {
    let law = Law::new(
        "bspline::moebius_band_closes_with_a_flip",
        suspects::library,
    )
    .on_cases(32);
    let seventh = || (0..=28_i32).prop_map(|part| fraction(part, 4));
    let places = || (vec(point(), 108), seventh(), seventh());
    let ends = || prop::sample::select(vec![0, 3, 7]).prop_map(integer);
    law.holds(
        places(),
        (vec(point(), 108), ends(), ends()),
        |(points, u, v)| {
            let band = close(
                [slide_u(), slide_v()],
                points,
                [Closing::Flipped, Closing::Open],
            );
            let mirrored = integer(7) - *v;
            let around = [12, 24].map(|turn| band.point(*u + integer(turn), *v));
            // Two periods of the net as an open surface: its second half is the first one upside down.
            let columns = |i: usize, j: usize| {
                if i / 12 == 1 {
                    points[(8 - j) * 12 + i % 12]
                } else {
                    points[j * 12 + i % 12]
                }
            };
            let net = (0..9).flat_map(|j| (0..27).map(move |i| columns(i, j)));
            let twice = KnotVector::uniform(3, 27).expect("27 columns");
            let twice =
                BsplineSurface::new([twice, slide_v()], net.collect()).expect("27 x 9 points");
            let expected = [twice.point(*u + integer(12), *v), twice.point(*u, *v)];
            expect_equal(&expected, &around)?;
            expect_equal(&twice.point(*u, mirrored), &around[0])?;
            for [k, l] in [[0, 0], [1, 0], [2, 0], [0, 1], [1, 1], [2, 1]] {
                let before = band.surface().derivative_at([k, l], integer(12), *v);
                let after = band
                    .surface()
                    .derivative_at([k, l], Exact::zero(), mirrored);
                let sign = if l % 2 == 1 {
                    -Exact::one()
                } else {
                    Exact::one()
                };
                expect_equal(&after.times(sign), &before)?;
                expect_equal(&before, &band.derivative_at([k, l], integer(12), *v))?;
            }
            Ok(())
        },
    );
}

/// **One side only.** Carry a normal once round a Möbius band along its middle line: it is never zero, never turns by a right angle from one step to the next, and comes
/// back as its own opposite, $n(12,\tfrac72)=-n(0,\tfrac72)$. So the band has one side only, and no choice of normals is continuous on it. On the cylinder the normal comes back as
/// itself. Everywhere $n(u+12,v)=-n(u,7-v)$.
///
/// Course: B19, slide 29, periodic surfaces: the Möbius band.
#[test]
fn normal_comes_back_turned_over_on_the_moebius_band_only() {
    let middle = fraction(7, 2);
    for (flips, closing) in [(true, Closing::Flipped), (false, Closing::Closed)] {
        let surface = close(
            [slide_u(), slide_v()],
            &strip(flips),
            [closing, Closing::Open],
        );
        let normal = |u, v| {
            surface
                .normal_vector(u, v)
                .expect("the strip has no singular point")
        };
        for step in 0..96 {
            let [here, next] = [step, step + 1].map(|step| fraction(step, 8));
            // Across the seam the next normal is that of the surface itself, before it is brought back to the start.
            let [here, next] = [here, next].map(|u| {
                let inner = surface.surface();
                inner
                    .normal_vector(u, middle)
                    .expect("the strip has no singular point")
            });
            assert!(
                here.dot(next) > Exact::zero(),
                "a step {step} to {next:?} turns too far"
            );
        }
        let at_end = surface
            .surface()
            .normal_vector(integer(12), middle)
            .expect("no singular point");
        let at_start = normal(Exact::zero(), middle);
        let expected = if flips {
            Point::origin().minus(at_start)
        } else {
            at_start
        };
        assert_eq!(at_end, expected);
        for (u, v) in [(0, 1), (5, 3), (7, 0)].map(|(u, v)| (fraction(u, 2), integer(v))) {
            let home = if flips {
                Point::origin().minus(normal(u, integer(7) - v))
            } else {
                normal(u, v)
            };
            assert_eq!(normal(u + integer(12), v), home);
        }
    }
}
