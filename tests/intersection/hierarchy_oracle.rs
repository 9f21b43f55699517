//! The first hit among triangles over exact numbers: what every answer of the hierarchy is held against.
//!
//! Every number of single precision is a whole multiple of 2⁻¹⁴⁹. In this unit all coordinates are integers, and no fraction is reduced before the end.

use std::array::from_fn;

use facette::intersection::Side;
use facette::ray::Ray;
use glam::Vec3;
use num_bigint::BigInt;
use num_traits::{Signed, Zero};

use crate::common::oracle::{Big, big};

/// The exact answer.
#[derive(Clone, Debug, PartialEq)]
pub struct ExactHit {
    pub triangle: u32,
    pub t: Big,
    /// The weights of the three corners.
    pub weights: [Big; 3],
    pub side: Side,
}

type Point = [BigInt; 3];

/// In units of 2⁻¹⁴⁹: the significand, shifted by the exponent above that of the denormal numbers.
fn point(p: Vec3) -> Point {
    p.to_array().map(|x| {
        let (exponent, fraction) = (x.to_bits() >> 23 & 0xff, x.to_bits() & 0x7f_ffff);
        let implied = if exponent == 0 { 0 } else { 1 << 23 };
        let magnitude = BigInt::from(fraction | implied) << exponent.saturating_sub(1);
        if x.is_sign_negative() {
            -magnitude
        } else {
            magnitude
        }
    })
}

fn minus(p: &Point, q: &Point) -> Point {
    from_fn(|axis| &p[axis] - &q[axis])
}

fn cross(p: &Point, q: &Point) -> Point {
    [(1, 2), (2, 0), (0, 1)].map(|(j, k)| &p[j] * &q[k] - &p[k] * &q[j])
}

fn dot(p: &Point, q: &Point) -> BigInt {
    &p[0] * &q[0] + &p[1] * &q[1] + &p[2] * &q[2]
}

/// Plane first, then the weights from the point in the plane: another formula than the library's.
pub fn exact_hit(triangle: u32, corners: [Vec3; 3], ray: &Ray<Vec3>) -> Option<ExactHit> {
    let (o, d) = (point(ray.origin), point(ray.direction));
    let [a, b, c] = corners.map(point);
    let n = cross(&minus(&b, &a), &minus(&c, &a));
    let slope = dot(&n, &d);
    if slope.is_zero() {
        return None;
    }
    let distance = dot(&n, &minus(&a, &o));
    // The point, and the corners, times the slope.
    let x: Point = from_fn(|axis| &o[axis] * &slope + &distance * &d[axis]);
    let area = dot(&n, &n) * &slope;
    let weight = |p: &Point, q: &Point| {
        let from_p: Point = from_fn(|axis| &x[axis] - &p[axis] * &slope);
        dot(&cross(&minus(q, p), &from_p), &n)
    };
    let weights = [weight(&b, &c), weight(&c, &a), weight(&a, &b)];
    if weights.iter().any(|weight| (weight * &area).is_negative()) {
        return None;
    }
    let side = if slope.is_negative() {
        Side::Front
    } else {
        Side::Back
    };
    let t = Big::new(distance, slope);
    let end = ray.end.map_or(f32::MAX, |end| end.min(f32::MAX));
    let is_in_interval = t > big(ray.start.into()) && t <= big(end.into());
    is_in_interval.then(|| ExactHit {
        triangle,
        t,
        weights: weights.map(|weight| Big::new(weight, area.clone())),
        side,
    })
}

/// The nearest hit, the smaller number first among equals.
pub fn nearest_exactly(triangles: &[[Vec3; 3]], ray: &Ray<Vec3>) -> Option<ExactHit> {
    let hits = (0..)
        .zip(triangles)
        .filter_map(|(triangle, &corners)| exact_hit(triangle, corners, ray));
    hits.reduce(|best, hit| if hit.t < best.t { hit } else { best })
}
