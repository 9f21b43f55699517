//! Whether, and where, a ray of `f32` meets a triangle of `f32`: decided without any error.
//!
//! The filter computes in `f64` with a bound on its error, which decides nearly always; what it cannot decide, [`exact`](super::exact) does.
//!
//! # Numerics
//!
//! Let u = 2⁻⁵³. Differences, products and sums of `f32` numbers neither overflow nor underflow in `f64`, so every operation has a relative error
//! of at most u. With |d| the largest coordinate of d and m the largest of all corners as seen from o, an edge's volume is a sum of six
//! products of at most |d| m². Each term passes two differences, two products, and at most a subtraction and two additions:
//! seven roundings. So the error is at most 6 · 7u |d| m² to first order, and [`EDGE_ERROR`] = 43u covers the rest.
//!
//! The determinant d · n and the distance (a − o) · n have six products each of two edges and of |d| or m; again two differences, two
//! products, a subtraction and two additions, and one more difference for a − o: 8 roundings, 6 · 8u, and [`PLANE_ERROR`] = 49u.

use std::cmp::Ordering;
use std::ops::{Add, Div, Mul, Sub};

use glam::Vec3;
use wide::f64x8;

use super::exact::{Ratio, Volumes};
use crate::intersection::{FacetHit, Side};
use crate::ray::Ray;

/// The unit roundoff of `f64`.
const U: f64 = f64::EPSILON / 2.0;

/// The error of an edge's volume over `|d| m²`.
const EDGE_ERROR: f64 = 43.0 * U;

/// The error of the determinant over `|d| |b − a| |c − a|`, and of the distance over `|a − o| |b − a| |c − a|`.
const PLANE_ERROR: f64 = 49.0 * U;

/// The largest relative error of t, and the largest absolute error of a weight, that the filter lets pass: a quarter of the bits of `f32` below
/// its last place.
pub(super) const LARGEST_ERROR: f64 = 1.0 / (1_u64 << 34) as f64;

/// A ray ready for the filter: finite, with a direction, and an interval of finite ends.
#[derive(Clone, Copy, Debug)]
pub(super) struct Line {
    pub(super) origin: Vec3,
    pub(super) direction: Vec3,
    pub(super) start: f32,
    pub(super) end: f32,
}

impl Line {
    /// The line of a ray that is known to be sound.
    #[inline(always)]
    pub(super) fn of(ray: &Ray<Vec3>) -> Self {
        Self {
            origin: ray.origin,
            direction: ray.direction,
            start: ray.start.max(-f32::MAX),
            end: ray.end.unwrap_or(f32::MAX).min(f32::MAX),
        }
    }

    /// The ray's line; `None` for a ray that meets nothing whatever there is. A ray without an end ends at `f32::MAX`.
    #[inline(always)]
    pub(super) fn new(ray: &Ray<Vec3>) -> Option<Self> {
        let line = Self::of(ray);
        let is_sound = ray.origin.is_finite()
            && ray.direction.is_finite()
            && ray.direction != Vec3::ZERO
            && line.start < line.end
            && !ray.start.is_nan()
            && !ray.end.is_some_and(f32::is_nan);
        is_sound.then_some(line)
    }
}
/// A hit that is certain, in the interval of its ray.
#[derive(Clone, Copy, Debug)]
pub(super) struct Confirmed {
    pub(super) triangle: u32,
    pub(super) t: f64,
    /// A bound on the error of t.
    t_error: f64,
    pub(super) weights: [f64; 2],
    pub(super) side: Side,
}

impl Confirmed {
    pub(super) fn facet_hit(&self) -> FacetHit<f32> {
        #[allow(
            clippy::cast_possible_truncation,
            reason = "rounded once, to the nearest f32"
        )]
        let rounded = |value: f64| value as f32;
        FacetHit {
            t: rounded(self.t),
            parameters: self.weights.map(rounded),
            side: self.side,
        }
    }

    /// Not before the exact t.
    pub(super) fn latest(&self) -> f64 {
        self.t + self.t_error
    }

    /// Not after the exact t.
    pub(super) fn earliest(&self) -> f64 {
        self.t - self.t_error
    }

    // ANCHOR: is_before
    /// Whether this hit comes before another one of the same line: by t, exactly, and then by the triangles' numbers.
    pub(super) fn is_before(&self, other: &Self, line: &Line, triangles: &[[Vec3; 3]]) -> bool {
        let gap = self.t - other.t;
        let order = if gap.abs() > self.t_error + other.t_error {
            self.t.total_cmp(&other.t)
        } else {
            let exact = |hit: &Self| {
                let corners = triangles[hit.triangle as usize];
                Volumes::new(line.origin, line.direction, corners).t()
            };
            exact(self).compare(&exact(other))
        };
        order.then(self.triangle.cmp(&other.triangle)) == Ordering::Less
    }
    // ANCHOR_END: is_before
}

/// The hit of a line in its interval with a triangle, edges and corners included; `None` for a miss, or where the line lies in the triangle's plane, or
/// the triangle has no area.
#[inline]
pub(super) fn confirm(line: &Line, triangle: u32, corners: [Vec3; 3]) -> Option<Confirmed> {
    match filter(line, corners) {
        Filtered::Miss => None,
        Filtered::Hit {
            t,
            t_error,
            weights,
            side,
        } => Some(Confirmed {
            triangle,
            t,
            t_error,
            weights,
            side,
        }),
        Filtered::Undecided => confirm_exactly(line, triangle, corners),
    }
}

/// What the filter finds.
enum Filtered {
    Miss,
    Hit {
        t: f64,
        t_error: f64,
        weights: [f64; 2],
        side: Side,
    },
    Undecided,
}

/// A number, or eight of them: the filter is written once, and gives the same bits for one ray and for eight.
pub(super) trait Lanes:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self>
{
    fn of(value: f64) -> Self;
    fn absolute(self) -> Self;
    fn smaller(self, other: Self) -> Self;
    fn larger(self, other: Self) -> Self;
}

impl Lanes for f64 {
    #[inline(always)]
    fn of(value: f64) -> Self {
        value
    }

    #[inline(always)]
    fn absolute(self) -> Self {
        self.abs()
    }

    #[inline(always)]
    fn smaller(self, other: Self) -> Self {
        if self < other { self } else { other }
    }

    #[inline(always)]
    fn larger(self, other: Self) -> Self {
        if self > other { self } else { other }
    }
}

impl Lanes for f64x8 {
    #[inline(always)]
    fn of(value: f64) -> Self {
        Self::splat(value)
    }

    #[inline(always)]
    fn absolute(self) -> Self {
        self.abs()
    }

    #[inline(always)]
    fn smaller(self, other: Self) -> Self {
        self.fast_min(other)
    }

    #[inline(always)]
    fn larger(self, other: Self) -> Self {
        self.fast_max(other)
    }
}

/// What the filter computes, and bounds on the errors.
pub(super) struct Estimate<F> {
    /// The least and the largest of the three edges' volumes, and a bound on their errors.
    pub(super) least: F,
    pub(super) most: F,
    pub(super) edge_error: F,
    pub(super) determinant: F,
    /// The relative error of the determinant.
    pub(super) determinant_error: F,
    pub(super) t: F,
    pub(super) t_error: F,
    pub(super) weights: [F; 2],
    pub(super) weight_error: F,
}

impl<F: Lanes> Estimate<F> {
    /// Of the line `o + t d` and the triangle `a b c`.
    #[inline(always)]
    pub(super) fn new(o: [F; 3], d: [F; 3], [first, second, third]: [[F; 3]; 3]) -> Self {
        let [a, b, c] = [minus(first, o), minus(second, o), minus(third, o)];
        let [ab, bc, ca] = [
            minus(second, first),
            minus(third, second),
            minus(first, third),
        ];
        let speed = largest(d);
        let reach = largest(a).larger(largest(b)).larger(largest(c));
        let size = largest(ab).larger(largest(bc)).larger(largest(ca));
        let edges = [
            dot(cross(d, b), bc),
            dot(cross(d, c), ca),
            dot(cross(d, a), ab),
        ];
        let normal = cross(ca, ab);
        let (determinant, distance) = (dot(d, normal), dot(a, normal));
        let reciprocal = F::of(1.0) / determinant;
        let t = distance * reciprocal;
        // All errors in multiples of the determinant, and twice that: the determinant may be half of what was computed.
        let unit = F::of(2.0) * size * reciprocal.absolute();
        let determinant_error = F::of(PLANE_ERROR) * speed * size * unit;
        let edge_error = F::of(EDGE_ERROR) * speed * reach;
        Self {
            least: edges[0].smaller(edges[1]).smaller(edges[2]),
            most: edges[0].larger(edges[1]).larger(edges[2]),
            edge_error: edge_error * size,
            determinant,
            determinant_error,
            t,
            t_error: F::of(PLANE_ERROR) * reach * size * unit
                + (determinant_error + F::of(4.0 * U)) * t.absolute(),
            weights: [edges[1] * reciprocal, edges[2] * reciprocal],
            weight_error: edge_error * unit + determinant_error + F::of(4.0 * U),
        }
    }
}

#[inline(always)]
fn minus<F: Lanes>(p: [F; 3], q: [F; 3]) -> [F; 3] {
    [p[0] - q[0], p[1] - q[1], p[2] - q[2]]
}

#[inline(always)]
fn dot<F: Lanes>(p: [F; 3], q: [F; 3]) -> F {
    p[0] * q[0] + p[1] * q[1] + p[2] * q[2]
}

#[inline(always)]
#[rustfmt::skip]
fn cross<F: Lanes>(p: [F; 3], q: [F; 3]) -> [F; 3] {
    [
        p[1] * q[2] - p[2] * q[1],
        p[2] * q[0] - p[0] * q[2],
        p[0] * q[1] - p[1] * q[0],
    ]
}

#[inline(always)]
fn largest<F: Lanes>(p: [F; 3]) -> F {
    p[0].absolute()
        .larger(p[1].absolute())
        .larger(p[2].absolute())
}

#[inline]
fn filter(line: &Line, corners: [Vec3; 3]) -> Filtered {
    let wide = |p: Vec3| p.as_dvec3().to_array();
    let [a, b, c] = corners;
    let of = Estimate::<f64>::new(
        wide(line.origin),
        wide(line.direction),
        [wide(a), wide(b), wide(c)],
    );
    if of.least < -of.edge_error && of.most > of.edge_error {
        return Filtered::Miss;
    }
    let is_bounded = of.determinant_error < 0.5;
    let (start, end) = (f64::from(line.start), f64::from(line.end));
    if is_bounded && (of.t + of.t_error <= start || of.t - of.t_error > end) {
        return Filtered::Miss;
    }
    let is_inside = of.least > of.edge_error || of.most < -of.edge_error;
    let is_sure = is_inside
        && is_bounded
        && of.t_error <= LARGEST_ERROR * of.t.abs()
        && of.weight_error <= LARGEST_ERROR
        && of.t - of.t_error > start
        && of.t + of.t_error <= end;
    if !is_sure {
        return Filtered::Undecided;
    }
    Filtered::Hit {
        t: of.t,
        t_error: of.t_error,
        weights: of.weights,
        side: side(of.determinant),
    }
}

/// The side that is hit, by the sign of the determinant `d · n`.
#[inline(always)]
pub(super) fn side(determinant: f64) -> Side {
    if determinant < 0.0 {
        Side::Front
    } else {
        Side::Back
    }
}

#[cold]
fn confirm_exactly(line: &Line, triangle: u32, corners: [Vec3; 3]) -> Option<Confirmed> {
    let volumes = Volumes::new(line.origin, line.direction, corners);
    let sign = volumes.determinant.sign();
    let is_outside = |e: Ordering| e == sign.reverse();
    if sign == Ordering::Equal || volumes.edges.iter().any(|edge| is_outside(edge.sign())) {
        return None;
    }
    let exact_t = volumes.t();
    let is_after = exact_t.compare(&Ratio::from_f32(line.start)) == Ordering::Greater;
    let is_too_far = exact_t.compare(&Ratio::from_f32(line.end)) == Ordering::Greater;
    if !is_after || is_too_far {
        return None;
    }
    let determinant = volumes.determinant.to_f64();
    let t = exact_t.to_f64();
    Some(Confirmed {
        triangle,
        t,
        t_error: 16.0 * U * t.abs(),
        weights: [1, 2].map(|corner| volumes.edges[corner].to_f64() / determinant),
        side: if sign == Ordering::Less {
            Side::Front
        } else {
            Side::Back
        },
    })
}
