//! Triangles and rays in floating point, ordinary and hard, and what exact arithmetic says of them.

use facette::algebra::{Real, VectorSpace};
use facette::intersection::Side;
use facette::ray::Ray;
use num_traits::{Signed, Zero};
use proptest::prelude::*;

use crate::common::generators::{float_coordinate, float_parameter, hard_float_parameter};
use crate::common::oracle::{Big, big, big_cross, big_dot, big_minus, big_point};

/// A triangle and a ray, drawn in `f64` and rounded to the type under test.
#[derive(Clone, Copy, Debug)]
pub struct FloatPlace {
    pub corners: [[f64; 3]; 3],
    pub origin: [f64; 3],
    pub direction: [f64; 3],
}

impl FloatPlace {
    pub fn corners<S: Real>(&self) -> [[S; 3]; 3] {
        self.corners.map(|corner| corner.map(S::from_f64))
    }

    pub fn ray<S: Real>(&self) -> Ray<[S; 3]> {
        Ray::new(
            self.origin.map(S::from_f64),
            self.direction.map(S::from_f64),
        )
    }

    /// The place as the type under test has it.
    pub fn rounded<S: Real>(&self) -> Self {
        let rounded = |point: [f64; 3]| point.map(|x| S::from_f64(x).to_f64());
        Self {
            corners: self.corners.map(rounded),
            origin: rounded(self.origin),
            direction: rounded(self.direction),
        }
    }
}

fn point() -> impl Strategy<Value = [f64; 3]> {
    [float_coordinate(), float_coordinate(), float_coordinate()]
}

/// A ray at the point with these weights, as far as `f64` can aim.
pub fn aimed(corners: [[f64; 3]; 3], origin: [f64; 3], [v, w]: [f64; 2]) -> FloatPlace {
    let [a, b, c] = corners;
    let along = b.minus(a).times(v).plus(c.minus(a).times(w));
    FloatPlace {
        corners,
        origin,
        direction: a.plus(along).minus(origin),
    }
}

fn weights() -> impl Strategy<Value = [f64; 2]> {
    [-0.5..1.5_f64, -0.5..1.5_f64]
}

/// Rays of unit size at points in and around a triangle.
pub fn float_places() -> impl Strategy<Value = FloatPlace> {
    ([point(), point(), point()], point(), weights())
        .prop_map(|(corners, origin, weights)| aimed(corners, origin, weights))
}

/// Weights of corners, of points of edges, and one step from them.
fn border_weights() -> impl Strategy<Value = [f64; 2]> {
    let parameter = || prop_oneof![float_parameter(), hard_float_parameter()];
    (parameter(), parameter(), 0..4).prop_map(|(t, step, kind)| match kind {
        0 => [t, 0.0],
        1 => [0.0, t],
        2 => [t, 1.0 - t],
        _ => [t, step * 1e-16],
    })
}

/// Rays at edges and corners: of triangles far from the origin, small ones seen from far away, needles and slivers, with integer coordinates (where many a
/// determinant is zero), along axes, nearly in the plane and in it; everything scaled by powers of ten.
pub fn hard_float_places() -> impl Strategy<Value = FloatPlace> {
    let grid = || [-3..=3_i32, -3..=3, -3..=3].prop_map(|point| point.map(f64::from));
    let of_grid = ([grid(), grid(), grid()], grid(), grid());
    let of_grid = of_grid.prop_map(|(corners, origin, direction)| FloatPlace {
        corners,
        origin,
        direction,
    });
    let far = prop::sample::select(vec![1.0, 1e4, 1e7]);
    let bordering = ([point(), point(), point()], point(), border_weights(), far);
    let bordering = (bordering, 0..4).prop_map(|((corners, origin, weights, far), kind)| {
        let [a, b, c] = corners;
        let near_b = b.lerp(c, 1e-9);
        let shift = [far, -far, 2.0 * far];
        match kind {
            0 => aimed(corners.map(|corner| corner.plus(shift)), origin, weights),
            1 => aimed(corners, origin.plus(shift), weights),
            2 => aimed([a, b, near_b], origin, weights),
            _ => aimed(
                corners,
                a.lerp(b, 0.3).plus(c.minus(a).times(1e-9)),
                weights,
            ),
        }
    });
    let scale = prop::sample::select(vec![1.0, 1e-3, 1e6]);
    (prop_oneof![of_grid.boxed(), bordering.boxed()], scale).prop_map(|(place, scale)| FloatPlace {
        corners: place.corners.map(|corner| corner.times(scale)),
        origin: place.origin.times(scale),
        ..place
    })
}

/// What exact arithmetic says of a line and a triangle: the weights of the corners and t, unless the line is parallel.
#[derive(Clone, Debug)]
pub struct ExactCrossing {
    pub weights: [Big; 3],
    pub t: Big,
    pub side: Side,
}

impl ExactCrossing {
    pub fn is_hit(&self) -> bool {
        self.weights.iter().all(|weight| !weight.is_negative()) && self.t.is_positive()
    }
}

/// The crossing, by the signed volumes of the corners as seen from the origin.
pub fn exactly(place: &FloatPlace) -> Option<ExactCrossing> {
    let [o, d] = [place.origin, place.direction].map(big_point);
    let [a, b, c] = place
        .corners
        .map(|corner| big_minus(&big_point(corner), &o));
    let volume = |x: &[Big; 3], y: &[Big; 3]| big_dot(&d, &big_cross(x, y));
    let volumes = [volume(&b, &c), volume(&c, &a), volume(&a, &b)];
    let along = volumes.iter().fold(Big::zero(), |sum, volume| sum + volume);
    if along.is_zero() {
        return None;
    }
    Some(ExactCrossing {
        t: big_dot(&a, &big_cross(&b, &c)) / &along,
        side: if along.is_negative() {
            Side::Front
        } else {
            Side::Back
        },
        weights: volumes.map(|volume| volume / &along),
    })
}

/// The normal `(b − a) × (c − a)`.
pub fn exact_normal(corners: [[f64; 3]; 3]) -> [Big; 3] {
    let [a, b, c] = corners.map(big_point);
    big_cross(&big_minus(&b, &a), &big_minus(&c, &a))
}

/// The point with these weights of b and c.
pub fn exact_point(corners: [[f64; 3]; 3], v: &Big, w: &Big) -> [Big; 3] {
    let [a, b, c] = corners.map(big_point);
    let u = big(1.0) - v - w;
    std::array::from_fn(|axis| &u * &a[axis] + v * &b[axis] + w * &c[axis])
}
