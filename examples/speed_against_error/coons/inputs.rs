//! Typical and hard patches with parameters, the same in every run.

use std::hint::black_box;

use facette::coons::{CoonsPatch, HermiteBoundary};
use facette::curve::BezierCurve;

use crate::float_inputs::{FloatPlace, FloatPoint, rounded};

/// How many patches a set has.
const PATCHES: usize = 4;

/// The degree of the curves apart from the patches.
const HIGH_DEGREE: usize = 20;

/// Patches with the parameters at which each is evaluated.
#[derive(Clone)]
pub struct InputSet {
    /// What the report calls it.
    pub name: &'static str,
    places: Vec<FloatPlace>,
    curves: Vec<Vec<[f64; 3]>>,
    parameters: Vec<Vec<[f64; 2]>>,
}

/// Patches about as large as the unit square, bent cubic edges, parameters with all bits in use.
pub fn typical(points: usize) -> InputSet {
    let mut random = Random(1);
    let places = (0..PATCHES).map(|_| random.place([0.0; 3], [1.0; 3]));
    let places = places.collect();
    let curves = (0..PATCHES).map(|_| random.curve([0.0; 3], [1.0; 3]));
    let curves = curves.collect();
    let parameters = (0..PATCHES).map(|_| {
        (0..points)
            .map(|_| [random.unit(), random.unit()])
            .collect()
    });
    InputSet {
        name: "typical",
        places,
        curves,
        parameters: parameters.collect(),
    }
}

/// Thin patches of 1000 by 1 by 0.001, half of them 10⁸ away from the origin; a quarter of the parameters at an end of the
/// domain or next to one.
pub fn hard(points: usize) -> InputSet {
    let mut random = Random(2);
    let offset = |patch: usize| if patch.is_multiple_of(2) { 1e8 } else { 0.0 };
    let places = (0..PATCHES).map(|patch| random.place([offset(patch); 3], [1e3, 1.0, 1e-3]));
    let places = places.collect();
    let curves = (0..PATCHES).map(|patch| random.curve([offset(patch); 3], [1e3, 1.0, 1e-3]));
    let curves = curves.collect();
    let nasty = [0.0, 1.0, 1.0 - f64::EPSILON / 2.0, 1e-9];
    let parameters = (0..PATCHES).map(|_| {
        let pair = |index: usize| {
            let ordinary = [random.unit(), random.unit()];
            let [u, v] = [nasty[index / 4 % 4], nasty[index / 16 % 4]];
            if index.is_multiple_of(4) {
                [u, v]
            } else {
                ordinary
            }
        };
        (0..points).map(pair).collect()
    });
    InputSet {
        name: "hard",
        places,
        curves,
        parameters: parameters.collect(),
    }
}

impl InputSet {
    /// The same patches seen on their four edges, in turn.
    pub fn on_edges(&self) -> Self {
        let mut set = self.clone();
        for (index, pair) in set.parameters.iter_mut().flatten().enumerate() {
            let [u, v] = *pair;
            *pair = [[u, 0.0], [u, 1.0], [0.0, v], [1.0, v]][index % 4];
        }
        set
    }

    /// The first patch with as many points in a square grid, u running fastest.
    pub fn on_a_grid(&self) -> Self {
        let count: usize = self.parameters.iter().map(Vec::len).sum();
        let side = count.isqrt();
        let at = |index: usize| index as f64 / (side - 1) as f64;
        let pairs = (0..side * side).map(|index| [at(index % side), at(index / side)]);
        Self {
            name: self.name,
            places: self.places[..1].to_vec(),
            curves: Vec::new(),
            parameters: vec![pairs.collect()],
        }
    }
}

/// The patches and parameters of a set, rounded to one type of points.
pub struct Scene<P: FloatPoint> {
    /// The boundaries with their slopes.
    pub hermite: Vec<HermiteBoundary<BezierCurve<P>>>,
    /// The bilinear patches.
    pub bilinear: Vec<CoonsPatch<BezierCurve<P>>>,
    /// Curves of high degree, as many as patches.
    pub curves: Vec<BezierCurve<P>>,
    /// The parameters, one list a patch.
    pub parameters: Vec<Vec<[P::Scalar; 2]>>,
}

impl<P: FloatPoint> Scene<P> {
    /// The scene of a set.
    pub fn new(set: &InputSet) -> Self {
        let hermite: Vec<_> = set.places.iter().map(FloatPlace::hermite).collect();
        let bilinear = hermite
            .iter()
            .map(|data| CoonsPatch::new(data.boundary().clone()));
        let curve = |points: &Vec<[f64; 3]>| {
            let points = points.iter().map(|&point| P::rounded(point));
            BezierCurve::new(points.collect()).expect("finite points")
        };
        let round =
            |pairs: &Vec<[f64; 2]>| pairs.iter().map(|pair| pair.map(rounded::<P>)).collect();
        Self {
            bilinear: bilinear.collect(),
            hermite,
            curves: set.curves.iter().map(curve).collect(),
            parameters: set.parameters.iter().map(round).collect(),
        }
    }

    /// How many pairs of parameters there are.
    pub fn evaluations(&self) -> usize {
        self.parameters.iter().map(Vec::len).sum()
    }

    /// The parameters u and v of a scene on a grid.
    pub fn grid_lines(&self) -> [Vec<P::Scalar>; 2] {
        let pairs: Vec<_> = self.parameters.concat();
        let side = pairs.len().isqrt();
        let us = pairs.iter().take(side).map(|pair| pair[0]);
        let vs = pairs.iter().step_by(side).map(|pair| pair[1]);
        [us.collect(), vs.collect()]
    }

    /// The work of evaluating every patch at its parameters; each evaluation makes `N` points.
    pub fn each<'a, T: 'a, const N: usize>(
        &'a self,
        patches: impl AsRef<[T]> + 'a,
        evaluate: impl Fn(&T, P::Scalar, P::Scalar) -> [P; N] + 'a,
    ) -> impl FnMut(&mut [P]) + 'a {
        move |points| {
            let mut places = points.as_chunks_mut::<N>().0.iter_mut();
            for (patch, parameters) in black_box(patches.as_ref()).iter().zip(&self.parameters) {
                for (&[u, v], place) in parameters.iter().zip(places.by_ref()) {
                    *place = evaluate(patch, u, v);
                }
            }
        }
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

    /// The control points of a curve of high degree that goes to and fro in the box of the given size at `offset`.
    fn curve(&mut self, offset: [f64; 3], size: [f64; 3]) -> Vec<[f64; 3]> {
        let mut point = |_| std::array::from_fn(|axis| offset[axis] + size[axis] * self.unit());
        (0..=HIGH_DEGREE).map(&mut point).collect()
    }

    /// A place in the box of the given size at `offset`: corners near the corners of the box, inner control points near the
    /// lines between them.
    fn place(&mut self, offset: [f64; 3], size: [f64; 3]) -> FloatPlace {
        let mut near = |at: [f64; 2]| {
            let at = [at[0], at[1], 0.5];
            std::array::from_fn(|axis| {
                let moved = at[axis] + 0.4 * (self.unit() - 0.5);
                offset[axis] + size[axis] * moved
            })
        };
        let third = 1.0 / 3.0;
        let corners = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].map(&mut near);
        let inner = [
            vec![near([third, 0.0]), near([2.0 * third, 0.0])],
            vec![near([third, 1.0]), near([2.0 * third, 1.0])],
            vec![near([0.0, third]), near([0.0, 2.0 * third])],
            vec![near([1.0, third]), near([1.0, 2.0 * third])],
        ];
        let mut slope = || {
            let mut vector = || size.map(|length| length * (2.0 * self.unit() - 1.0));
            vec![vector(), vector()]
        };
        FloatPlace {
            corners,
            inner,
            slopes: [slope(), slope(), slope(), slope()],
            parameters: [0.5; 2],
        }
    }
}
