//! Patches and rays whose meeting points are known exactly.

use facette::algebra::{Real, VectorSpace};
use facette::bspline;
use facette::intersection::bezier_patch::PatchIntersector;
use facette::ray::Ray;
use proptest::prelude::*;

use crate::common::oracle::{Big, big, big_bernstein, big_combination};

/// A patch over the unit square, of control points with small whole coordinates, and a ray that passes through a point of it with a short
/// binary fraction for parameters: the point and the ray's origin are floating-point numbers without rounding.
#[derive(Clone, Debug)]
pub struct ThroughAPoint {
    pub degrees: [usize; 2],
    pub control_points: Vec<[i32; 3]>,
    pub sixteenths: [i32; 2],
    pub direction: [i32; 3],
    pub t: i32,
}

/// The patch of these control points over the unit square.
pub fn patch<S: Real>(
    degrees: [usize; 2],
    control_points: Vec<[S; 3]>,
) -> PatchIntersector<[S; 3]> {
    PatchIntersector::new(bspline::BezierPatch {
        domain: [[S::zero(), S::one()]; 2],
        degrees,
        control_points,
    })
    .expect("a patch with area and as many control points as its degrees ask for")
}

impl ThroughAPoint {
    pub fn parameters(&self) -> [f64; 2] {
        self.sixteenths.map(|sixteenth| f64::from(sixteenth) / 16.0)
    }

    pub fn patch<S: Real>(&self) -> PatchIntersector<[S; 3]> {
        let points = self.control_points.iter();
        let points = points.map(|point| point.map(S::from_i32)).collect();
        patch(self.degrees, points)
    }

    /// The point that the ray passes through: a sum of whole numbers over a power of 16, by Bernstein's polynomials.
    pub fn point(&self) -> [f64; 3] {
        let [u, v] = self.parameters().map(big);
        let point = big_patch_point(self.degrees, &self.floats(), [&u, &v]);
        point.map(|coordinate| {
            let rounded = num_traits::ToPrimitive::to_f64(&coordinate).expect("a finite number");
            assert_eq!(
                big(rounded),
                coordinate,
                "the generator keeps points representable"
            );
            rounded
        })
    }

    pub fn floats(&self) -> Vec<[f64; 3]> {
        let points = self.control_points.iter();
        points.map(|point| point.map(f64::from)).collect()
    }

    /// The ray through [`Self::point`] at t = [`Self::t`].
    pub fn ray(&self) -> Ray<[f64; 3]> {
        let direction = self.direction.map(f64::from);
        let origin = self.point().minus(direction.times(f64::from(self.t)));
        Ray::new(origin, direction)
    }
}

/// The point of a patch, by Bernstein's polynomials.
pub fn big_patch_point(
    degrees: [usize; 2],
    control_points: &[[f64; 3]],
    [u, v]: [&Big; 2],
) -> [Big; 3] {
    let [in_u, in_v] = [big_bernstein(degrees[0], u), big_bernstein(degrees[1], v)];
    let weights: Vec<Big> = in_v
        .iter()
        .flat_map(|b| in_u.iter().map(move |a| a * b))
        .collect();
    let points: Vec<[Big; 3]> = control_points.iter().map(|&p| p.map(big)).collect();
    big_combination(&weights, &points)
}

fn inputs(
    degrees: impl Strategy<Value = [usize; 2]>,
    sixteenths: impl Strategy<Value = [i32; 2]>,
    largest: i32,
    t: impl Strategy<Value = i32>,
) -> impl Strategy<Value = ThroughAPoint> {
    let coordinate = move || -largest..=largest;
    let direction = [-8..=8_i32, -8..=8_i32, -8..=8_i32]
        .prop_filter("a direction is not zero", |d| d.iter().any(|&c| c != 0));
    let place = (degrees, sixteenths, direction, t);
    place.prop_flat_map(move |(degrees, sixteenths, direction, t)| {
        let count = (degrees[0] + 1) * (degrees[1] + 1);
        prop::collection::vec([coordinate(), coordinate(), coordinate()], count).prop_map(
            move |control_points| ThroughAPoint {
                degrees,
                control_points,
                sixteenths,
                direction,
                t,
            },
        )
    })
}

/// Wild patches: control points anywhere, so that they cross themselves, fold and turn their backs.
pub fn wild() -> impl Strategy<Value = ThroughAPoint> {
    let degree = || 1..=3_usize;
    inputs([degree(), degree()], [1..=15, 1..=15], 32, 1..=100_i32)
}

/// The same, met at sides and corners, with higher degrees, or from close by.
pub fn hard() -> impl Strategy<Value = ThroughAPoint> {
    let at_a_side = prop::sample::select(vec![[0, 5], [16, 9], [3, 0], [7, 16], [0, 0], [16, 16]]);
    let degree = || 1..=4_usize;
    inputs([degree(), degree()], at_a_side, 8, 1..=1000_i32)
}

/// The input with all bits in use: control points and origin moved by less than a thousandth, so that nothing is exact any more, and the ray passes near the point.
pub fn near_meeting(input: &ThroughAPoint) -> (Vec<[f64; 3]>, Ray<[f64; 3]>) {
    // Fractions that repeat nowhere: multiples of the golden ratio, without their whole part.
    let mut number = 0.0;
    let mut moved = |x: f64| {
        number += 0.618_033_988_749_894_9;
        x + (number - f64::floor(number) - 0.5) / 512.0
    };
    let points = input
        .floats()
        .into_iter()
        .map(|p| p.map(&mut moved))
        .collect();
    let ray = input.ray();
    let [origin, direction] = [ray.origin, ray.direction].map(|p| p.map(&mut moved));
    (points, Ray::new(origin, direction))
}
