//! Other ways to compute the same bilinear patch. The report of speed against error compares them with the library, and the
//! hard cases refute those that do not survive.
//!
//! | variant | survives an edge | why it is here |
//! | --- | --- | --- |
//! | [`direct_point`] | no: an ulp or two off | the textbook's formula, baseline of the report |
//! | [`fused_point`] | no: an ulp off where the curve leaves its chord | the fewest operations |
//! | [`short_lerp_point`] | no: it can miss even the corners | the interpolation that saves a multiplication |
//! | [`HandWrittenPatch`] | yes: the library's operations | what the type parameters cost |
#![allow(
    dead_code,
    reason = "tests and report each use their part of these variants"
)]

use facette::algebra::{Scalar, VectorSpace};
use facette::coons::{Boundary, Corners, HermiteBoundary, hermite_basis, ruled_surfaces};
use facette::curve::Curve;
use num_traits::One;

/// The textbook's form: `S1 + S2 − S3`, added from the left.
pub fn direct_point<C: Curve>(boundary: &Boundary<C>, u: C::Scalar, v: C::Scalar) -> C::Point {
    let [s1, s2, s3] = ruled_surfaces(boundary, u, v);
    s1.plus(s2).minus(s3)
}

/// The form with the fewest operations: `S2`, and what `P1` and `P2` have more than their chords.
pub fn fused_point<C: Curve>(boundary: &Boundary<C>, u: C::Scalar, v: C::Scalar) -> C::Point {
    let Corners { a, b, c, d } = boundary.corners();
    let s2 = boundary.q1().point(v).lerp(boundary.q2().point(v), u);
    let bottom = boundary.p1().point(u).minus(a.lerp(b, u));
    let top = boundary.p2().point(u).minus(d.lerp(c, u));
    s2.plus(bottom.times(C::Scalar::one() - v))
        .plus(top.times(v))
}

/// As [`direct_point`], with the interpolation `a + t (b − a)`, which misses `b` at t = 1.
pub fn short_lerp_point<C: Curve>(boundary: &Boundary<C>, u: C::Scalar, v: C::Scalar) -> C::Point {
    let Corners { a, b, c, d } = boundary.corners();
    let s1 = short_lerp(boundary.p1().point(u), boundary.p2().point(u), v);
    let s2 = short_lerp(boundary.q1().point(v), boundary.q2().point(v), u);
    let s3 = short_lerp(short_lerp(a, b, u), short_lerp(d, c, u), v);
    s1.plus(s2).minus(s3)
}

/// `a + t (b − a)`: one multiplication instead of two.
pub fn short_lerp<P: VectorSpace>(a: P, b: P, t: P::Scalar) -> P {
    a.plus(b.minus(a).times(t))
}

/// The bicubically blended patch, its three terms added from the left.
pub fn direct_bicubic_point<C: Curve>(
    data: &HermiteBoundary<C>,
    u: C::Scalar,
    v: C::Scalar,
) -> C::Point {
    let boundary = data.boundary();
    let [in_u, in_v] = [hermite_basis(u), hermite_basis(v)];
    let along_u = [
        boundary.p1().point(u),
        data.p1_v().point(u),
        data.p2_v().point(u),
        boundary.p2().point(u),
    ];
    let along_v = [
        boundary.q1().point(v),
        data.q1_u().point(v),
        data.q2_u().point(v),
        boundary.q2().point(v),
    ];
    let s1 = C::Point::combination(in_v, along_u);
    let s2 = C::Point::combination(in_u, along_v);
    let vectors = data.corner_vectors(u, v);
    let column = |j: usize| C::Point::combination(in_u, vectors.map(|row| row[j]));
    let s3 = C::Point::combination(in_v, [column(0), column(1), column(2), column(3)]);
    s1.plus(s2).minus(s3)
}

/// The partial derivatives by central differences with the given step: for where no derivative is known.
pub fn central_differences<P: VectorSpace>(
    point: impl Fn(P::Scalar, P::Scalar) -> P,
    [u, v]: [P::Scalar; 2],
    step: P::Scalar,
) -> [P; 2] {
    let over_two_steps = P::Scalar::one() / (step + step);
    [
        point(u + step, v).minus(point(u - step, v)),
        point(u, v + step).minus(point(u, v - step)),
    ]
    .map(|difference| difference.times(over_two_steps))
}

/// The coefficients of a Bézier curve in the powers of t, for [`horner_point`]: `binomial(n, i)` times the i-th difference of
/// the control points at the first one.
pub fn monomial_coefficients<P: VectorSpace>(control_points: &[P]) -> Vec<P> {
    let mut differences = control_points.to_vec();
    let mut binomial = 1;
    let mut coefficients = Vec::new();
    for (i, left) in (0..differences.len()).rev().enumerate() {
        coefficients.push(differences[0].times(P::Scalar::from_i32(binomial)));
        let [left, step] = [left, i + 1].map(|n| i32::try_from(n).expect("a small degree"));
        binomial = binomial * left / step;
        differences = differences
            .windows(2)
            .map(|pair| pair[1].minus(pair[0]))
            .collect();
    }
    coefficients
}

/// The polynomial `c0 + t (c1 + t (c2 + ...))`: n multiplications of points where de Casteljau's scheme has n(n + 1).
pub fn horner_point<P: VectorSpace>(coefficients: &[P], t: P::Scalar) -> P {
    let terms = coefficients.iter().rev().copied();
    terms
        .reduce(|sum, coefficient| sum.times(t).plus(coefficient))
        .unwrap_or_else(P::origin)
}

/// De Casteljau's scheme without a branch for cubics: loops whose lengths are not known when the code is compiled.
pub fn looped_de_casteljau<P: VectorSpace>(control_points: &[P], t: P::Scalar) -> P {
    let mut on_stack = [P::origin(); 16];
    let points = &mut on_stack[..control_points.len()];
    points.copy_from_slice(control_points);
    for left in (1..points.len()).rev() {
        for index in 0..left {
            points[index] = points[index].lerp(points[index + 1], t);
        }
    }
    points[0]
}

/// A point as the hand-written kernel has it.
type Point = [f64; 3];

/// The library's kernel written out for `f64`, without type parameters: the same operations in the same order, so the same
/// bits.
pub struct HandWrittenPatch {
    p1: HandWrittenCurve,
    p2: HandWrittenCurve,
    q1: HandWrittenCurve,
    q2: HandWrittenCurve,
    corners: [Point; 4],
}

/// A Bézier curve as [`facette::curve::BezierCurve`] keeps it.
pub struct HandWrittenCurve {
    control_points: Vec<Point>,
}

impl HandWrittenPatch {
    /// The patch of four edges P1, P2, Q1, Q2, each given by two control points at least.
    pub fn new(edges: [Vec<Point>; 4]) -> Self {
        let [p1, p2, q1, q2] = edges.map(|control_points| HandWrittenCurve { control_points });
        let ends = |curve: &HandWrittenCurve| [curve.point(0.0), curve.point(1.0)];
        let [[a, b], [d, c]] = [ends(&p1), ends(&p2)];
        Self {
            p1,
            p2,
            q1,
            q2,
            corners: [a, b, c, d],
        }
    }

    /// The point `S(u, v)`.
    #[inline]
    pub fn point(&self, u: f64, v: f64) -> Point {
        let [a, b, c, d] = self.corners;
        let s1 = lerp(self.p1.point(u), self.p2.point(u), v);
        let s2 = lerp(self.q1.point(v), self.q2.point(v), u);
        let s3 = lerp(lerp(a, b, u), lerp(d, c, u), v);
        boolean_sum(s1, s2, s3)
    }

    /// The points of a grid, u running fastest.
    pub fn points_on_grid(&self, us: &[f64], vs: &[f64], points: &mut [Point]) {
        assert_eq!(points.len(), us.len() * vs.len(), "one place for each pair");
        let [a, b, c, d] = self.corners;
        let column = |&u: &f64| {
            let [p1, p2] = [self.p1.point(u), self.p2.point(u)];
            (u, p1, p2, lerp(a, b, u), lerp(d, c, u))
        };
        let columns: Vec<_> = us.iter().map(column).collect();
        for (row, &v) in points.chunks_exact_mut(us.len().max(1)).zip(vs) {
            let [q1, q2] = [self.q1.point(v), self.q2.point(v)];
            for (point, &(u, p1, p2, bottom, top)) in row.iter_mut().zip(&columns) {
                *point = boolean_sum(lerp(p1, p2, v), lerp(q1, q2, u), lerp(bottom, top, v));
            }
        }
    }
}

impl HandWrittenCurve {
    /// The point at `t`, by de Casteljau's scheme.
    pub fn point(&self, t: f64) -> Point {
        if let &[b0, b1, b2, b3] = &self.control_points[..] {
            let [c0, c1, c2] = [lerp(b0, b1, t), lerp(b1, b2, t), lerp(b2, b3, t)];
            return lerp(lerp(c0, c1, t), lerp(c1, c2, t), t);
        }
        let mut points = self.control_points.clone();
        while points.len() > 1 {
            points = points
                .windows(2)
                .map(|pair| lerp(pair[0], pair[1], t))
                .collect();
        }
        points[0]
    }
}

#[rustfmt::skip]
fn lerp(a: Point, b: Point, t: f64) -> Point {
    let s = 1.0 - t;
    [
        a[0] * s + b[0] * t,
        a[1] * s + b[1] * t,
        a[2] * s + b[2] * t,
    ]
}

fn boolean_sum(s1: Point, s2: Point, s3: Point) -> Point {
    [
        sum_of_three(s1[0], s2[0], s3[0]),
        sum_of_three(s1[1], s2[1], s3[1]),
        sum_of_three(s1[2], s2[2], s3[2]),
    ]
}

/// `s1 + s2 − s3` with both rounding errors carried along.
fn sum_of_three(s1: f64, s2: f64, s3: f64) -> f64 {
    let sum = s1 + s2;
    let used = sum - s1;
    let first_error = (s1 - (sum - used)) + (s2 - used);
    let difference = sum + -s3;
    let used = difference - sum;
    let second_error = (sum - (difference - used)) + (-s3 - used);
    difference + (first_error + second_error)
}
