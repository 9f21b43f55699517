//! Knots and control points of surfaces that close.

use facette::algebra::VectorSpace;
use facette::bspline::{Closing, KnotVector, PeriodicSurface, closed_surface};
use num_traits::{One, Zero};
use proptest::collection::vec;
use proptest::prelude::*;

use crate::common::exact::{Exact, fraction};
use crate::common::generators::point;

/// A point of space over the rationals.
pub type Point = [Exact; 3];

/// The knots of one direction, how many distinct control points they take, and the parameter at which a law looks.
#[derive(Clone, Debug)]
pub struct Side {
    /// The knots of the closed surface.
    pub knots: KnotVector<Exact>,
    /// Those of one period, both ends included.
    pub breaks: Vec<Exact>,
    /// A parameter of the domain.
    pub parameter: Exact,
}

/// A whole number.
pub fn integer(value: i32) -> Exact {
    fraction(value, 1)
}

/// The breaks with these spacings from `start` on, and the parameter at this share of the way.
fn breaks(start: Exact, spacings: &[Exact], share: Exact) -> (Vec<Exact>, Exact) {
    let mut breaks = vec![start];
    for &spacing in spacings {
        breaks.push(breaks[breaks.len() - 1] + spacing);
    }
    let parameter = start.lerp(breaks[breaks.len() - 1], share);
    (breaks, parameter)
}

/// A share of the way through a period, the start included.
pub fn share() -> impl Strategy<Value = Exact> {
    (0..24_i32).prop_map(|part| fraction(part, 24))
}

/// A direction that closes: some spans of different lengths.
fn closed_side(
    degree: impl Strategy<Value = usize>,
    spacing: impl Strategy<Value = Vec<Exact>>,
) -> impl Strategy<Value = Side> {
    (degree, -3..4_i32, spacing, share()).prop_map(|(degree, start, spacings, share)| {
        let (breaks, parameter) = breaks(integer(start), &spacings, share);
        let knots = KnotVector::periodic(degree, &breaks)
            .expect("the generator's spacings are sums of positive numbers");
        Side {
            knots,
            breaks,
            parameter,
        }
    })
}

fn spacing() -> impl Strategy<Value = Exact> {
    (1..6_i32, 1..4_i32).prop_map(|(numerator, denominator)| fraction(numerator, denominator))
}

/// Ordinary: at least as many spans as the degree.
pub fn ordinary_side() -> impl Strategy<Value = Side> {
    closed_side(1..=3_usize, vec(spacing(), 3..6))
}

/// Hard: one or two spans, so that one control point counts several times on a span; or a double knot at the seam or elsewhere.
pub fn hard_side() -> impl Strategy<Value = Side> {
    let few = closed_side(1..=3_usize, vec(spacing(), 1..3));
    let double = (vec(spacing(), 3..5), 0..3_usize).prop_map(|(mut spacings, place)| {
        spacings[place] = Exact::zero();
        spacings
    });
    prop_oneof![few, closed_side(2..=3_usize, double)]
}

/// The distinct points of a surface, as many as any generated sides take.
pub fn points() -> impl Strategy<Value = Vec<Point>> {
    vec(point(), 36)
}

/// How often a control point stands along a period: its distinct number.
pub fn spans(side: &Side) -> usize {
    side.breaks.len() - 1
}

/// The length of a period.
pub fn period(side: &Side) -> Exact {
    side.breaks[spans(side)] - side.breaks[0]
}

/// The knots of three periods, without closing: the one in the middle is the side's own.
pub fn unrolled(side: &Side) -> KnotVector<Exact> {
    let degree = side.knots.degree();
    let mut breaks: Vec<Exact> = Vec::new();
    for turn in -1..=1 {
        let moved = side
            .breaks
            .iter()
            .map(|&knot| knot + integer(turn) * period(side));
        breaks.extend(moved.skip(usize::from(turn > -1)));
    }
    KnotVector::periodic(degree, &breaks).expect("three periods are as good as one")
}

/// The knots `{0, …, 0, 1, …, 7, …, 7}` of the slides, of degree 2.
pub fn slide_v() -> KnotVector<Exact> {
    let breaks: Vec<_> = (0..=7).map(integer).collect();
    KnotVector::clamped(2, &breaks).expect("the slides' knots are good")
}

/// The knots −3, …, 15 of the slides, of degree 3.
pub fn slide_u() -> KnotVector<Exact> {
    KnotVector::new(3, (-3..=15).map(integer).collect()).expect("the slides' knots are good")
}

/// The knots −2, …, 9 of the slides' torus, of degree 2.
pub fn slide_torus_v() -> KnotVector<Exact> {
    KnotVector::new(2, (-2..=9).map(integer).collect()).expect("the slides' knots are good")
}

/// The closed surface of knots and points that fit.
pub fn close(
    knots: [KnotVector<Exact>; 2],
    points: &[Point],
    closing: [Closing; 2],
) -> PeriodicSurface<Point> {
    closed_surface(knots, points, closing).expect("the generator's knots close")
}

/// Control points of a ring of 12 columns round the z axis, each a strip of these half-lengths that is turned out of the plane by a rational angle: none for a
/// cylinder, half a turn in all for the Möbius band.
pub fn strip(half_turns: bool) -> Vec<Point> {
    // Points of the unit circle at roughly equal angles, from t = tan(angle / 2).
    let on_circle = |t: Exact| {
        let w = Exact::one() + t * t;
        [(Exact::one() - t * t) / w, (t + t) / w]
    };
    let tangents = [(0, 1), (4, 15), (4, 7), (1, 1), (7, 4), (15, 4)].map(|(a, b)| fraction(a, b));
    let half_ring = tangents.map(on_circle);
    let opposite = half_ring.map(|[c, s]| [-c, -s]);
    let ring = [half_ring, opposite].concat();
    // Twelve half steps: the angle of the strip runs from 0 towards half a turn, as the cosine and sine of a quarter ring do twice as slowly.
    let halves = [
        (0, 1),
        (1, 8),
        (4, 15),
        (2, 5),
        (4, 7),
        (3, 4),
        (1, 1),
        (4, 3),
        (7, 4),
        (5, 2),
        (15, 4),
        (8, 1),
    ];
    let mut net = vec![Point::origin(); 12 * 9];
    for (i, [x, y]) in ring.into_iter().enumerate() {
        let (a, b) = halves[i];
        let [across, up] = if half_turns {
            on_circle(fraction(a, b))
        } else {
            on_circle(Exact::zero())
        };
        for j in 0..9 {
            let offset = fraction(i32::try_from(j).expect("a small number") - 4, 8);
            // The strip stands upright on the ring, turned about the ring's tangent by the angle.
            let [radius, height] = [Exact::one() - offset * up, offset * across];
            net[j * 12 + i] = [x * radius, y * radius, height];
        }
    }
    net
}
