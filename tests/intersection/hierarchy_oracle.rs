//! The first hit among triangles over exact rationals: what every answer of the hierarchy is held against.

use facette::intersection::Side;
use facette::ray::Ray;
use glam::Vec3;
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

type Point = [Big; 3];

fn point(p: Vec3) -> Point {
    p.to_array().map(|x| big(f64::from(x)))
}

fn minus(p: &Point, q: &Point) -> Point {
    std::array::from_fn(|i| &p[i] - &q[i])
}

fn cross(p: &Point, q: &Point) -> Point {
    std::array::from_fn(|i| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        &p[j] * &q[k] - &p[k] * &q[j]
    })
}

fn dot(p: &Point, q: &Point) -> Big {
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
    let t = dot(&n, &minus(&a, &o)) / &slope;
    let end = ray.end.map_or(f32::MAX, |end| end.min(f32::MAX));
    let is_in_interval = t > big(f64::from(ray.start)) && t <= big(f64::from(end));
    let x: Point = std::array::from_fn(|i| &o[i] + &t * &d[i]);
    let area = dot(&n, &n);
    let weight = |p: &Point, q: &Point| dot(&cross(&minus(q, p), &minus(&x, p)), &n) / &area;
    let weights = [weight(&b, &c), weight(&c, &a), weight(&a, &b)];
    let is_inside = weights.iter().all(|weight| !weight.is_negative());
    let side = if slope.is_negative() {
        Side::Front
    } else {
        Side::Back
    };
    (is_in_interval && is_inside).then_some(ExactHit {
        triangle,
        t,
        weights,
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
