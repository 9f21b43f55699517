//! Knot vectors, curves and surfaces over the fractions, ordinary and hard, for the tests of this chapter.

use std::fmt;
use std::ops::RangeInclusive;

use facette::algebra::{Scalar, VectorSpace};
use facette::bspline::{BsplineCurve, BsplineSurface, KnotVector};
use num_traits::Zero;
use proptest::collection::vec;
use proptest::prelude::*;

use crate::common::exact::{Exact, fraction};
use crate::common::generators::{coordinate, parameter, point};
use crate::common::law::{Broken, Verdict};
use crate::divided_differences::{all_values, weighted_sum};

/// A point of space over the fractions.
pub type Point = [Exact; 3];

/// Passes where `holds`; otherwise says what was promised of what.
pub fn expect(promise: &str, holds: bool, got: impl fmt::Debug) -> Verdict {
    if holds {
        return Ok(());
    }
    Err(Broken {
        expected: promise.to_owned(),
        got: format!("{got:?}"),
    })
}

/// A number of something as a fraction.
pub fn whole(number: usize) -> Exact {
    Exact::from_i32(i32::try_from(number).expect("a small number"))
}

/// Knots that make a knot vector of their degree.
#[derive(Clone)]
pub struct Knots {
    /// The degree p.
    pub degree: usize,
    /// The knots, not decreasing.
    pub knots: Vec<Exact>,
}

impl fmt::Debug for Knots {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "p = {}, U = {:?}", self.degree, self.knots)
    }
}

impl Knots {
    /// The knots as integers.
    pub fn integers(degree: usize, knots: &[i32]) -> Self {
        let knots = knots.iter().map(|&knot| fraction(knot, 1)).collect();
        Self { degree, knots }
    }

    /// The library's knot vector.
    pub fn vector(&self) -> KnotVector<Exact> {
        KnotVector::new(self.degree, self.knots.clone())
            .expect("the generators make valid knot vectors")
    }

    /// The number n + 1 of basis functions.
    pub fn count(&self) -> usize {
        self.knots.len() - self.degree - 1
    }

    /// The domain from the knot number p to the knot number n + 1.
    pub fn domain(&self) -> [Exact; 2] {
        [self.knots[self.degree], self.knots[self.count()]]
    }

    /// The spans of the domain that are not empty.
    pub fn spans(&self) -> Vec<usize> {
        (self.degree..self.count())
            .filter(|&span| self.knots[span] < self.knots[span + 1])
            .collect()
    }

    /// The span on which `u` lies: the definition, with the end of the domain in the last one.
    pub fn span_of(&self, u: Exact) -> usize {
        let spans = self.spans();
        let holds = |&span: &usize| self.knots[span] <= u && u < self.knots[span + 1];
        let found = spans.iter().copied().find(holds);
        found.unwrap_or_else(|| {
            if u < self.domain()[0] {
                spans[0]
            } else {
                spans[spans.len() - 1]
            }
        })
    }

    /// How often the function number `function` has `knot` among its own p + 2 knots.
    pub fn own_multiplicity(&self, function: usize, knot: Exact) -> usize {
        self.support(function)
            .iter()
            .filter(|&&own| own == knot)
            .count()
    }

    /// The p + 2 knots of the function number `function`.
    pub fn support(&self, function: usize) -> &[Exact] {
        &self.knots[function..=function + self.degree + 1]
    }

    /// The parameter at the part `t` of the span number `choice` (counted round).
    pub fn parameter(&self, choice: usize, t: Exact) -> Exact {
        let spans = self.spans();
        let span = spans[choice % spans.len()];
        self.knots[span].lerp(self.knots[span + 1], t)
    }
}

/// How a knot vector is drawn: degree, first break, gaps between breaks, multiplicities (counted round), ends clamped or not.
type Recipe = (usize, Exact, Vec<Exact>, Vec<usize>, bool);

fn assembled((degree, start, gaps, multiplicities, clamped): Recipe) -> Knots {
    let mut breaks = vec![start];
    for gap in gaps {
        breaks.push(breaks[breaks.len() - 1] + gap);
    }
    let repeated = |ends: Option<usize>| -> Vec<Exact> {
        let last = breaks.len() - 1;
        let times = |index: usize| match ends {
            Some(times) if index == 0 || index == last => times,
            _ => 1 + multiplicities[index] % (degree + 1),
        };
        let each = breaks.iter().enumerate();
        each.flat_map(|(index, &knot)| std::iter::repeat_n(knot, times(index)))
            .collect()
    };
    let floating = repeated(None);
    let has_domain = floating.len() >= 2 * degree + 2
        && floating[degree] < floating[floating.len() - 1 - degree];
    let knots = if clamped || !has_domain {
        repeated(Some(degree + 1))
    } else {
        floating
    };
    Knots { degree, knots }
}

fn gap() -> impl Strategy<Value = Exact> {
    (1..=6, 1..=4).prop_map(|(numerator, denominator)| fraction(numerator, denominator))
}

/// Knot vectors of these degrees with up to `spans` spans, most inner knots simple, half of them clamped.
pub fn knot_vectors(degrees: RangeInclusive<usize>, spans: usize) -> impl Strategy<Value = Knots> {
    let multiplicities = vec(prop_oneof![3 => Just(0_usize), 1 => 0..6_usize], spans + 1);
    let gaps = vec(gap(), 1..=spans);
    (degrees, coordinate(), gaps, multiplicities, any::<bool>()).prop_map(assembled)
}

/// Knot vectors with inner knots of every multiplicity up to p + 1, some nearly repeated, some far from the others.
pub fn hard_knot_vectors(
    degrees: RangeInclusive<usize>,
    spans: usize,
) -> impl Strategy<Value = Knots> {
    let gaps = prop_oneof![
        2 => Just(fraction(1, 1)),
        1 => Just(fraction(1, 1 << 20)),
        1 => Just(fraction(1000, 1)),
    ];
    let recipe = (
        degrees,
        Just(Exact::zero()),
        vec(gaps, 1..=spans),
        vec(0..6_usize, spans + 1),
        any::<bool>(),
    );
    recipe.prop_map(assembled)
}

/// The two ends of a span, and the two places next to them.
fn next_to_an_end() -> impl Strategy<Value = Exact> {
    const TINY: i32 = 1 << 20;
    prop::sample::select(vec![
        fraction(0, 1),
        fraction(1, 1),
        fraction(1, TINY),
        fraction(TINY - 1, TINY),
    ])
}

/// A knot vector and a parameter of its domain.
#[derive(Clone, Debug)]
pub struct BasisCase {
    /// The knots.
    pub knots: Knots,
    /// The parameter.
    pub u: Exact,
}

fn placed(knots: Knots, (choice, t): (usize, Exact)) -> BasisCase {
    let u = knots.parameter(choice, t);
    BasisCase { knots, u }
}

/// Knot vectors of degree 0 to 4 with a parameter of the closed domain.
pub fn bases() -> impl Strategy<Value = BasisCase> {
    (knot_vectors(0..=4, 5), (0..8_usize, parameter()))
        .prop_map(|(knots, place)| placed(knots, place))
}

/// Hard knot vectors with a parameter at a knot or next to it.
pub fn hard_bases() -> impl Strategy<Value = BasisCase> {
    let place = (0..8_usize, next_to_an_end());
    (hard_knot_vectors(0..=4, 5), place).prop_map(|(knots, place)| placed(knots, place))
}

/// A B-spline curve and a parameter of its domain.
#[derive(Clone)]
pub struct CurveCase {
    /// The knots.
    pub knots: Knots,
    /// The control points.
    pub points: Vec<Point>,
    /// The parameter.
    pub u: Exact,
}

impl fmt::Debug for CurveCase {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            formatter,
            "{:?}, P = {:?}, u = {:?}",
            self.knots, self.points, self.u
        )
    }
}

impl CurveCase {
    /// The library's curve.
    pub fn curve(&self) -> BsplineCurve<Point> {
        BsplineCurve::new(self.knots.vector(), self.points.clone())
            .expect("the generators make one point for each function")
    }

    /// The point by the definition, with basis functions by divided differences.
    pub fn expected(&self) -> Point {
        weighted_sum(&all_values(&self.knots, self.u), &self.points)
    }

    /// The same with every control point mapped.
    pub fn mapped(&self, map: impl Fn(Point) -> Point) -> Self {
        let points = self.points.iter().map(|&point| map(point)).collect();
        Self {
            points,
            ..self.clone()
        }
    }
}

fn with_points(
    case: BasisCase,
    points: impl Strategy<Value = Point>,
) -> impl Strategy<Value = CurveCase> {
    let BasisCase { knots, u } = case;
    let points = vec(points, knots.count());
    points.prop_map(move |points| CurveCase {
        knots: knots.clone(),
        points,
        u,
    })
}

/// Curves of degree 0 to 4 with a parameter of the closed domain.
pub fn curves() -> impl Strategy<Value = CurveCase> {
    bases().prop_flat_map(|case| with_points(case, point()))
}

/// Curves over hard knot vectors, with many control points in one place.
pub fn hard_curves() -> impl Strategy<Value = CurveCase> {
    let points = || prop_oneof![2 => point(), 1 => Just(Point::origin())];
    hard_bases().prop_flat_map(move |case| with_points(case, points()))
}

/// A B-spline surface and a parameter pair of its domain.
#[derive(Clone)]
pub struct SurfaceCase {
    /// The knots in u and in v.
    pub knots: [Knots; 2],
    /// The control points, row by row, u fastest.
    pub points: Vec<Point>,
    /// The parameters u and v.
    pub at: [Exact; 2],
}

impl fmt::Debug for SurfaceCase {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [in_u, in_v] = &self.knots;
        write!(
            formatter,
            "{in_u:?}, q = {}, V = {:?}, ",
            in_v.degree, in_v.knots
        )?;
        let [u, v] = self.at;
        write!(
            formatter,
            "P = {:?} (u fastest), u = {u:?}, v = {v:?}",
            self.points
        )
    }
}

impl SurfaceCase {
    /// The library's surface.
    pub fn surface(&self) -> BsplineSurface<Point> {
        let vectors = self.knots.each_ref().map(Knots::vector);
        BsplineSurface::new(vectors, self.points.clone())
            .expect("the generators make one point for each pair of functions")
    }

    /// The control point `P_ij`.
    pub fn control_point(&self, i: usize, j: usize) -> Point {
        self.points[j * self.knots[0].count() + i]
    }

    /// The point by the definition, the double sum over all pairs of functions.
    pub fn expected(&self) -> Point {
        let [u, v] = self.at;
        let [in_u, in_v] = [all_values(&self.knots[0], u), all_values(&self.knots[1], v)];
        let weights: Vec<_> = in_v
            .iter()
            .flat_map(|&b| in_u.iter().map(move |&a| a * b))
            .collect();
        weighted_sum(&weights, &self.points)
    }

    /// The same with every control point mapped.
    pub fn mapped(&self, map: impl Fn(Point) -> Point) -> Self {
        let points = self.points.iter().map(|&point| map(point)).collect();
        Self {
            points,
            ..self.clone()
        }
    }
}

fn with_net(
    cases: [BasisCase; 2],
    points: impl Strategy<Value = Point>,
) -> impl Strategy<Value = SurfaceCase> {
    let count = cases[0].knots.count() * cases[1].knots.count();
    vec(points, count).prop_map(move |points| {
        let knots = cases.each_ref().map(|case| case.knots.clone());
        let at = cases.each_ref().map(|case| case.u);
        SurfaceCase { knots, points, at }
    })
}

/// Surfaces of degree 0 to 3 in each direction with a parameter pair of the closed domain.
pub fn surfaces() -> impl Strategy<Value = SurfaceCase> {
    let side = || {
        (knot_vectors(0..=3, 3), (0..8_usize, parameter()))
            .prop_map(|(knots, place)| placed(knots, place))
    };
    [side(), side()].prop_flat_map(|cases| with_net(cases, point()))
}

/// Surfaces over hard knot vectors, with many control points in one place.
pub fn hard_surfaces() -> impl Strategy<Value = SurfaceCase> {
    let side = || {
        (hard_knot_vectors(0..=3, 2), (0..8_usize, next_to_an_end()))
            .prop_map(|(knots, place)| placed(knots, place))
    };
    let points = || prop_oneof![2 => point(), 1 => Just(Point::origin())];
    [side(), side()].prop_flat_map(move |cases| with_net(cases, points()))
}
