//! Typical and hard curves and surfaces with parameters, the same in every run.

use std::hint::black_box;

use facette::algebra::{Scalar, VectorSpace};
use facette::bspline::{BsplineCurve, BsplineSurface, KnotVector, SurfaceEvaluator};
use num_traits::AsPrimitive;

use super::exact;
use crate::float_inputs::FloatPoint;
use crate::harness::ExactPoint;

/// The number of control points in each direction.
const CONTROL_POINTS: usize = 20;

/// The degree of the curves of high degree.
const HIGH_DEGREE: usize = 20;

/// A number type that the chapter measures.
pub trait Number: Scalar + Into<f64> + AsPrimitive<u8> {
    /// The nearest number of this type.
    fn rounded(value: f64) -> Self;
}

impl<S: Scalar + Into<f64> + AsPrimitive<u8>> Number for S
where
    f64: AsPrimitive<S>,
{
    fn rounded(value: f64) -> Self {
        value.as_()
    }
}

/// A bicubic surface, curves of degree 3 and 20, and parameters.
pub struct InputSet {
    /// What the report calls it.
    pub name: &'static str,
    breaks: [Vec<f64>; 2],
    net: Vec<[f64; 3]>,
    /// For a list, and for a grid of as many points.
    parameters: Vec<[f64; 2]>,
    lines: [Vec<f64>; 2],
}

/// A surface over the unit square with clamped knots at uneven distances, parameters with all bits in use.
pub fn typical(points: usize) -> InputSet {
    let mut random = Random(7);
    let breaks = [0, 1].map(|_| random.breaks(0.0));
    let net = random.net([0.0; 3], [1.0; 3]);
    let parameters = (0..points).map(|_| [random.unit(), random.unit()]);
    let parameters = parameters.collect();
    InputSet {
        name: "typical",
        breaks,
        net,
        parameters,
        lines: [0, 1].map(|_| random.line(points.isqrt())),
    }
}

/// A surface of 1000 by 1 by 0.001 that lies 10⁸ away from the origin, with knots in pairs that nearly coincide; a quarter of the parameters at an end
/// of the domain or next to one.
pub fn hard(points: usize) -> InputSet {
    let mut random = Random(8);
    let breaks = [0, 1].map(|_| random.breaks(1e-6));
    let net = random.net([1e8; 3], [1e3, 1.0, 1e-3]);
    let nasty = [0.0, 1.0, 1.0 - f64::EPSILON / 2.0, 1e-9];
    let parameters = (0..points).map(|index| {
        let ordinary = [random.unit(), random.unit()];
        let [u, v] = [nasty[index / 4 % 4], nasty[index / 16 % 4]];
        if index.is_multiple_of(4) {
            [u, v]
        } else {
            ordinary
        }
    });
    let parameters = parameters.collect();
    InputSet {
        name: "hard",
        breaks,
        net,
        parameters,
        lines: [0, 1].map(|_| random.line(points.isqrt())),
    }
}

/// A set in one type of numbers.
pub struct Scene<S: Number> {
    /// The surface.
    pub surface: BsplineSurface<[S; 3]>,
    /// The surface prepared.
    pub evaluator: SurfaceEvaluator<[S; 3]>,
    /// A cubic curve.
    pub curve: BsplineCurve<[S; 3]>,
    /// A curve of degree 20.
    pub high: BsplineCurve<[S; 3]>,
    /// The parameters of a list.
    pub parameters: Vec<[S; 2]>,
    /// The lines of a grid of as many points.
    pub lines: [Vec<S>; 2],
}

impl<S: Number> Scene<S>
where
    [S; 3]: FloatPoint + VectorSpace<Scalar = S>,
{
    /// The scene of a set.
    pub fn new(set: &InputSet) -> Self {
        let vector = |degree: usize, breaks: &[f64]| {
            let breaks: Vec<S> = breaks.iter().map(|&u| S::rounded(u)).collect();
            KnotVector::clamped(degree, &breaks).expect("increasing breaks")
        };
        let points: Vec<_> = set.net.iter().map(|point| point.map(S::rounded)).collect();
        let knots = set.breaks.each_ref().map(|breaks| vector(3, breaks));
        let surface = BsplineSurface::new(knots, points.clone()).expect("20 x 20 points");
        let curve = |degree| {
            let breaks = &set.breaks[0][..];
            let knots = vector(degree, breaks);
            let points = points[..knots.control_point_count()].to_vec();
            BsplineCurve::new(knots, points).expect("as many points as functions")
        };
        Self {
            evaluator: SurfaceEvaluator::new(surface.clone()),
            surface,
            curve: curve(3),
            high: curve(HIGH_DEGREE),
            parameters: set
                .parameters
                .iter()
                .map(|pair| pair.map(S::rounded))
                .collect(),
            lines: set
                .lines
                .each_ref()
                .map(|line| line.iter().map(|&u| S::rounded(u)).collect()),
        }
    }

    /// The work of evaluating something at the parameters, of which at most `places.len()` are taken; each evaluation makes `N` points.
    pub fn each<'a, T: 'a, const N: usize>(
        &'a self,
        what: T,
        evaluate: impl Fn(&T, [S; 2]) -> [[S; 3]; N] + 'a,
    ) -> impl FnMut(&mut [[S; 3]]) + 'a {
        move |points| {
            let what = black_box(&what);
            let places = points.as_chunks_mut::<N>().0;
            for (&parameters, place) in self.parameters.iter().zip(places) {
                *place = evaluate(what, parameters);
            }
        }
    }

    /// The pairs of parameters of the grid, u running fastest.
    pub fn grid(&self) -> Vec<[S; 2]> {
        let [us, vs] = &self.lines;
        let pairs = vs.iter().flat_map(|&v| us.iter().map(move |&u| [u, v]));
        pairs.collect()
    }

    /// The exact points at the parameters of the list.
    pub fn exact_points(&self) -> Vec<ExactPoint> {
        let points = self.parameters.iter();
        points.map(|&at| exact::point(&self.surface, at)).collect()
    }
}

/// A sequence of numbers without visible order, the same in every run: multiples of the golden ratio, stirred.
struct Random(u64);

impl Random {
    /// A number from 0 to below 1, with 53 bits.
    fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let stirred = (self.0 ^ (self.0 >> 29)).wrapping_mul(0xd6e8_feb8_6659_fd93);
        let stirred = (stirred ^ (stirred >> 32)).wrapping_mul(0xd6e8_feb8_6659_fd93);
        (stirred >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// Breaks from 0 to 1 at uneven distances, every other one that far behind the one before unless that is 0.
    fn breaks(&mut self, pair: f64) -> Vec<f64> {
        let spans = CONTROL_POINTS - 3;
        let mut ends: Vec<f64> = vec![0.0];
        for span in 0..spans {
            let is_close = pair > 0.0 && span % 2 == 1;
            let length = if is_close { pair } else { 0.2 + self.unit() };
            ends.push(ends[span] + length);
        }
        let whole = ends[spans];
        ends.into_iter().map(|end| end / whole).collect()
    }

    /// A net of control points near a lattice in the box of the given size at `offset`, their heights anywhere in it.
    fn net(&mut self, offset: [f64; 3], size: [f64; 3]) -> Vec<[f64; 3]> {
        let last = (CONTROL_POINTS - 1) as f64;
        let mut point = |k: usize| {
            let [i, j] = [k % CONTROL_POINTS, k / CONTROL_POINTS].map(|index| index as f64 / last);
            let at = [i + 0.02 * self.unit(), j + 0.02 * self.unit(), self.unit()];
            std::array::from_fn(|axis| offset[axis] + size[axis] * at[axis])
        };
        (0..CONTROL_POINTS * CONTROL_POINTS)
            .map(&mut point)
            .collect()
    }

    /// Numbers from 0 to 1 in order, about equally far apart.
    fn line(&mut self, count: usize) -> Vec<f64> {
        let number = |k| (k as f64 + self.unit()) / count as f64;
        (0..count).map(number).collect()
    }
}
