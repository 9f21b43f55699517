//! Surfaces in floating point, ordinary and hard. They are drawn in `f64` and rounded to the type under test.

use std::array::from_fn;

use facette::algebra::{Scalar, VectorSpace};
use facette::bspline::{BsplineSurface, Direction, KnotVector, find_span};
use num_traits::{AsPrimitive, ToPrimitive, Zero};
use proptest::collection::vec;
use proptest::prelude::*;

use crate::common::generators::{
    float_coordinate, float_parameter, hard_float_coordinate, hard_float_parameter,
};
use crate::common::oracle::{Big, big, big_bspline_basis, big_combination, big_point};

/// A number type that tests round to.
pub trait Float: Scalar + Into<f64> + AsPrimitive<u8> {
    /// The nearest number of this type.
    fn rounded(value: f64) -> Self;
}

impl<S: Scalar + Into<f64> + AsPrimitive<u8>> Float for S
where
    f64: AsPrimitive<S>,
{
    fn rounded(value: f64) -> Self {
        value.as_()
    }
}

/// The knots of one direction: `p + 1` at either end, and inner sites one unit apart or more, each of up to `p` knots that coincide
/// or nearly do.
#[derive(Clone, Debug)]
pub struct FloatKnots {
    /// The degree.
    pub degree: usize,
    /// Where the domain starts.
    pub offset: f64,
    /// The lengths between sites.
    pub gaps: Vec<f64>,
    /// How many knots each inner site has, less one, counted round.
    pub copies: Vec<usize>,
    /// How far the knots of a site are apart.
    pub step: f64,
}

impl FloatKnots {
    /// The knot vector, rounded.
    pub fn vector<S: Float>(&self) -> KnotVector<S> {
        let order = self.degree + 1;
        let mut site = self.offset;
        let mut knots = vec![S::rounded(site); order];
        for (gap, copies) in self.gaps.iter().zip(&self.copies) {
            site += gap;
            let copies = 1 + copies % self.degree.max(1);
            knots.extend((0..copies).map(|copy| S::rounded(site + copy as f64 * self.step)));
        }
        let end = S::rounded(site + 1.5);
        knots.extend(std::iter::repeat_n(end, order));
        KnotVector::new(self.degree, knots).expect("the sites are one unit apart")
    }
}

/// A surface with a place for a pair of parameters.
#[derive(Clone, Debug)]
pub struct FloatSurface {
    /// The knots in u and in v.
    pub knots: [FloatKnots; 2],
    /// More coordinates than any net needs, counted round.
    pub coordinates: Vec<[f64; 3]>,
    /// The number of a span, counted round, and the place there.
    pub places: [(usize, f64); 2],
}

/// What a test needs of a surface in one type of numbers.
pub struct Rounded<S: Float> {
    /// The surface.
    pub surface: BsplineSurface<[S; 3]>,
    /// The parameters.
    pub at: [S; 2],
    /// Their spans.
    pub spans: [usize; 2],
}

impl FloatSurface {
    /// The surface and its parameters, rounded.
    pub fn rounded<S: Float>(&self) -> Rounded<S> {
        let knots = self.knots.each_ref().map(FloatKnots::vector::<S>);
        let count: usize = knots.iter().map(KnotVector::control_point_count).product();
        let drawn = self.coordinates.iter().cycle().take(count);
        let points = drawn.map(|point| point.map(S::rounded)).collect();
        let at = from_fn(|axis| {
            let (number, place) = self.places[axis];
            let spans: Vec<usize> = knots[axis].spans().collect();
            let [start, end] = knots[axis].span_interval(spans[number % spans.len()]);
            let u = start.lerp(end, S::rounded(place));
            if u < start {
                start
            } else if u > end {
                end
            } else {
                u
            }
        });
        let spans = from_fn(|axis| find_span(&knots[axis], at[axis]));
        let surface = BsplineSurface::new(knots, points).expect("finite points, as many as needed");
        Rounded { surface, at, spans }
    }
}

/// All basis functions at `u`, without rounding.
pub fn exact_basis<S: Float>(knots: &KnotVector<S>, u: S) -> Vec<Big> {
    let stored: Vec<f64> = knots.knots().iter().map(|&knot| knot.into()).collect();
    let [_, end] = knots.domain();
    big_bspline_basis(knots.degree(), &stored, &big(u.into()), end.into())
}

/// A point, as numbers of the widest type.
pub fn wide<S: Float>(point: [S; 3]) -> [f64; 3] {
    point.map(Into::into)
}

impl<S: Float> Rounded<S> {
    /// The exact point of the surface of these knots and control points.
    pub fn exact_point(&self) -> [Big; 3] {
        exact_sum(&self.surface, self.at)
    }

    /// The partial derivative in one direction and, for each coordinate, the largest difference quotient of control points that counts
    /// for it; both from the stored numbers, without rounding.
    pub fn exact_partial(&self, direction: Direction) -> ([Big; 3], [f64; 3]) {
        if direction == Direction::V {
            let turned = Self {
                surface: self.surface.transposed(),
                at: [self.at[1], self.at[0]],
                spans: [self.spans[1], self.spans[0]],
            };
            return turned.exact_partial(Direction::U);
        }
        let knots = self.surface.knots(Direction::U);
        let degree = knots.degree();
        let stored: Vec<f64> = knots.knots().iter().map(|&knot| knot.into()).collect();
        let [u, end] = [self.at[0], knots.domain()[1]].map(Into::into);
        let lower = big_bspline_basis(degree - 1, &stored[1..stored.len() - 1], &big(u), end);
        let in_v = exact_basis(self.surface.knots(Direction::V), self.at[1]);
        let (mut weights, mut quotients) = (Vec::new(), Vec::new());
        let mut sizes = [0.0_f64; 3];
        for (j, b) in in_v.iter().enumerate() {
            for (i, a) in lower.iter().enumerate() {
                let width = big(stored[i + degree + 1]) - big(stored[i + 1]);
                if width.is_zero() {
                    continue;
                }
                let [start, end] =
                    [i, i + 1].map(|i| big_point(wide(self.surface.control_point(i, j))));
                let factor = Big::from_integer(degree.into()) / width;
                let quotient: [Big; 3] = from_fn(|axis| (&end[axis] - &start[axis]) * &factor);
                let [first, row] = [self.spans[0] - degree, self.spans[1]];
                let height = self.surface.knots(Direction::V).degree();
                if (first..self.spans[0]).contains(&i) && (row - height..=row).contains(&j) {
                    let size = |axis: usize| quotient[axis].to_f64().unwrap_or(0.0).abs();
                    sizes = from_fn(|axis| sizes[axis].max(size(axis)));
                }
                weights.push(a * b);
                quotients.push(quotient);
            }
        }
        (big_combination(&weights, &quotients), sizes)
    }

    /// For each coordinate the largest one of the control points that count.
    pub fn sizes(&self) -> [f64; 3] {
        largest_of(&self.surface, self.spans)
    }
}

/// The point of a surface at the given parameters, by the double sum over all control points, without rounding.
fn exact_sum<S: Float>(surface: &BsplineSurface<[S; 3]>, at: [S; 2]) -> [Big; 3] {
    let [in_u, in_v] = [(Direction::U, at[0]), (Direction::V, at[1])]
        .map(|(direction, u)| exact_basis(surface.knots(direction), u));
    let (mut weights, mut points) = (Vec::new(), Vec::new());
    for (j, b) in in_v.iter().enumerate() {
        for (i, a) in in_u.iter().enumerate() {
            weights.push(a * b);
            points.push(big_point(wide(surface.control_point(i, j))));
        }
    }
    big_combination(&weights, &points)
}

/// For each coordinate the largest absolute value among the control points that count on these spans.
fn largest_of<S: Float>(surface: &BsplineSurface<[S; 3]>, spans: [usize; 2]) -> [f64; 3] {
    let [p, q] = [Direction::U, Direction::V].map(|direction| surface.knots(direction).degree());
    let mut sizes = [0.0_f64; 3];
    for i in spans[0] - p..=spans[0] {
        for j in spans[1] - q..=spans[1] {
            let point = wide(surface.control_point(i, j));
            sizes = from_fn(|axis| sizes[axis].max(point[axis].abs()));
        }
    }
    sizes
}

fn surfaces_of(
    knots: impl Strategy<Value = FloatKnots> + Clone,
    coordinate: impl Strategy<Value = f64> + Clone,
    place: impl Strategy<Value = f64> + Clone,
) -> impl Strategy<Value = FloatSurface> {
    let point = [coordinate.clone(), coordinate.clone(), coordinate];
    let place = (0..12_usize, place);
    let surface = (
        [knots.clone(), knots],
        vec(point, 37),
        [place.clone(), place],
    );
    surface.prop_map(|(knots, coordinates, places)| FloatSurface {
        knots,
        coordinates,
        places,
    })
}

fn knots_of(
    degrees: std::ops::RangeInclusive<usize>,
    offset: impl Strategy<Value = f64> + Clone,
    step: impl Strategy<Value = f64> + Clone,
) -> impl Strategy<Value = FloatKnots> + Clone {
    let sites = (vec(1.0..2.0_f64, 0..=2), vec(0..6_usize, 2));
    (degrees, offset, sites, step).prop_map(|(degree, offset, (gaps, copies), step)| FloatKnots {
        degree,
        offset,
        gaps,
        copies,
        step,
    })
}

/// Surfaces of degree 1 to 4 with ordinary control points, and parameters with all bits in use.
pub fn float_surfaces() -> impl Strategy<Value = FloatSurface> {
    let knots = knots_of(1..=4, Just(0.0), Just(0.0));
    surfaces_of(knots, float_coordinate().boxed(), float_parameter().boxed())
}

/// Surfaces whose knots are repeated, nearly so, or far from 0; whose control points are far away, tiny, huge or of all these sizes; and
/// parameters at the ends of a span or next to one.
pub fn hard_float_surfaces() -> impl Strategy<Value = FloatSurface> {
    let step = prop::sample::select(vec![0.0, f64::EPSILON, 1e-9, 1e-3]);
    let offset = prop::sample::select(vec![0.0, -1.0, 1_048_576.0]);
    let knots = knots_of(1..=4, offset, step).boxed();
    let far = (-1.0..1.0_f64).prop_map(|offset| 1e8 + offset).boxed();
    let huge = (-1.0..1.0_f64).prop_map(|factor| factor * 1e30).boxed();
    let tiny = (-1.0..1.0_f64).prop_map(|factor| factor * 1e-25).boxed();
    let mixed = hard_float_coordinate().boxed();
    let of = |coordinate: BoxedStrategy<f64>| {
        let place = prop_oneof![hard_float_parameter(), float_parameter()].boxed();
        surfaces_of(knots.clone(), coordinate, place)
    };
    prop_oneof![of(far), of(huge), of(tiny), of(mixed)]
}
