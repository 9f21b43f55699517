//! Numbers, points, curves and surfaces for the tests of this chapter.

use facette::algebra::{Vector3, VectorSpace};
use facette::curve::BezierCurve;
use facette::surface::Surface;
use proptest::collection::vec;
use proptest::prelude::*;

use crate::common::exact::Exact;
use crate::common::generators::point;
use crate::common::law::{Broken, Law, LikelyMistake, Verdict};

/// A point of space over the rationals.
pub type Point = [Exact; 3];

/// The law behind the test `ground_floor::name`: no exercise replaces this code.
pub fn law(theorem: &'static str) -> Law {
    Law::new(theorem, || LikelyMistake {
        name: "",
        hint: "this is the library's own code: no exercise replaces it",
    })
}

/// Passes where `holds`; otherwise says what was promised of what.
pub fn expect(promise: &str, holds: bool, got: impl std::fmt::Debug) -> Verdict {
    if holds {
        return Ok(());
    }
    Err(Broken {
        expected: promise.to_owned(),
        got: format!("{got:?}"),
    })
}

/// Any number that is neither infinite nor NaN: both signs, all sizes, denormal ones and zeros among them.
pub fn finite() -> impl Strategy<Value = f64> {
    use prop::num::f64::{NEGATIVE, NORMAL, POSITIVE, SUBNORMAL, ZERO};
    POSITIVE | NEGATIVE | NORMAL | SUBNORMAL | ZERO
}

/// As [`finite`], in single precision.
pub fn finite_f32() -> impl Strategy<Value = f32> {
    use prop::num::f32::{NEGATIVE, NORMAL, POSITIVE, SUBNORMAL, ZERO};
    POSITIVE | NEGATIVE | NORMAL | SUBNORMAL | ZERO
}

/// The ends of the range of finite numbers, and some that lie badly.
pub fn extreme() -> impl Strategy<Value = f64> {
    prop::sample::select(vec![
        f64::MAX,
        f64::MIN,
        f64::MIN_POSITIVE,
        f64::from_bits(1),
        -f64::from_bits(1),
        0.0,
        1.0,
        1.0 - f64::EPSILON / 2.0,
        1.0 / 3.0,
        1e-17,
        1e16,
    ])
}

/// As [`extreme`], in single precision.
pub fn extreme_f32() -> impl Strategy<Value = f32> {
    prop::sample::select(vec![
        f32::MAX,
        f32::MIN,
        f32::MIN_POSITIVE,
        f32::from_bits(1),
        0.0,
        1.0,
        1.0 - f32::EPSILON / 2.0,
        1.0 / 3.0,
        1e-9,
        1e8,
    ])
}

/// Exact control points of Bézier curves of the given degrees.
pub fn control_points(
    degrees: std::ops::RangeInclusive<usize>,
) -> impl Strategy<Value = Vec<Point>> {
    degrees.prop_flat_map(|degree| vec(point(), degree + 1))
}

/// Control points that coincide, all or all but one.
pub fn hard_control_points() -> impl Strategy<Value = Vec<Point>> {
    (point(), point(), 1..=5_usize).prop_map(|(p, q, count)| {
        let mut points = vec![p; count];
        points.push(q);
        points
    })
}

/// The Bézier curve with these control points.
pub fn bezier<P: VectorSpace>(points: &[P]) -> BezierCurve<P> {
    BezierCurve::new(points.to_vec()).expect("the generators make finite points")
}

/// The hyperbolic paraboloid `(u, v, factor · u v)` over a rectangle: a surface with everything known.
#[derive(Clone, Debug)]
pub struct Saddle {
    /// The parameter rectangle.
    pub domain: [[f64; 2]; 2],
    /// How strongly it is twisted.
    pub factor: f64,
    /// Whether it tells its derivatives.
    pub has_partials: bool,
}

impl Surface for Saddle {
    type Scalar = f64;
    type Point = [f64; 3];

    fn domain(&self) -> [[f64; 2]; 2] {
        self.domain
    }

    fn point(&self, u: f64, v: f64) -> [f64; 3] {
        [u, v, self.factor * u * v]
    }

    fn partials(&self, u: f64, v: f64) -> Option<[[f64; 3]; 2]> {
        let partials = [[1.0, 0.0, self.factor * v], [0.0, 1.0, self.factor * u]];
        self.has_partials.then_some(partials)
    }
}

/// Saddles over rectangles of different places and sizes.
pub fn saddles() -> impl Strategy<Value = Saddle> {
    let start = -2.0..2.0_f64;
    let size = 0.1..3.0_f64;
    (start.clone(), size.clone(), start, size, -1.0..1.0_f64).prop_map(
        |(u, width, v, height, factor)| Saddle {
            domain: [[u, u + width], [v, v + height]],
            factor,
            has_partials: true,
        },
    )
}

/// Saddles that are flat, tiny, huge or far away, and do not know their derivatives.
pub fn hard_saddles() -> impl Strategy<Value = Saddle> {
    let corners = [[0.0, 1.0], [1e-9, 3e-9], [-1e9, 1e9], [1e6, 1e6 + 1.0]];
    let interval = || prop::sample::select(corners.to_vec());
    (interval(), interval()).prop_map(|(us, vs)| Saddle {
        domain: [us, vs],
        factor: 0.0,
        has_partials: false,
    })
}

/// The vector product of a triangle's sides, anticlockwise.
pub fn triangle_normal<P: Vector3>([a, b, c]: [P; 3]) -> P {
    b.minus(a).cross(c.minus(a))
}
