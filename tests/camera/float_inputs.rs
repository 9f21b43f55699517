//! Cameras in floating point, ordinary and hard. They are drawn in `f64` and rounded to the type under test.

use facette::algebra::{Real, Scalar, Vector3, VectorSpace};
use num_traits::AsPrimitive;
use proptest::prelude::*;

use crate::common::oracle::{Big, big_point};

/// A point type whose coordinates are `f32` or `f64`.
pub trait FloatPoint: Vector3<Scalar: Real + Into<f64>> {
    /// The smallest positive number of the type: underflow errs by half of it.
    const SMALLEST: f64;

    /// The nearest point of this type.
    fn rounded(point: [f64; 3]) -> Self;

    /// The coordinates, without change.
    fn exact(self) -> [f64; 3] {
        [0, 1, 2].map(|axis| self.coordinate(axis).into())
    }

    /// The coordinates as rational numbers.
    fn big(self) -> [Big; 3] {
        big_point(self.exact())
    }

    /// The number nearest to `value`.
    fn number(value: f64) -> Self::Scalar {
        Self::rounded([value; 3]).coordinate(0)
    }

    /// The unit roundoff.
    fn roundoff() -> f64 {
        Self::Scalar::unit_roundoff().into()
    }
}

impl FloatPoint for [f32; 3] {
    const SMALLEST: f64 = 1.401_298_464_324_817e-45;

    fn rounded(point: [f64; 3]) -> Self {
        point.map(AsPrimitive::as_)
    }
}

impl FloatPoint for [f64; 3] {
    const SMALLEST: f64 = 5e-324;

    fn rounded(point: [f64; 3]) -> Self {
        point
    }
}

impl FloatPoint for glam::Vec3A {
    const SMALLEST: f64 = <[f32; 3]>::SMALLEST;

    fn rounded(point: [f64; 3]) -> Self {
        Self::from_array(<[f32; 3]>::rounded(point))
    }
}

/// A camera's data, and a point of the scene.
#[derive(Clone, Debug)]
pub struct FloatView {
    /// The eye.
    pub eye: [f64; 3],
    /// The target.
    pub target: [f64; 3],
    /// The direction up.
    pub up: [f64; 3],
    /// The distance of the image plane.
    pub distance: f64,
    /// The place (u, v) on the image plane.
    pub place: [f64; 2],
    /// A point of the scene.
    pub point: [f64; 3],
}

fn vector(size: f64) -> impl Strategy<Value = [f64; 3]> + Clone {
    let coordinate = (-1.0..1.0_f64).prop_map(move |factor| factor * size);
    [coordinate.clone(), coordinate.clone(), coordinate]
}

/// Views of this size around `origin`, with a direction up that is `lean` away from the view, as a part of its length.
fn views_of(
    origin: [f64; 3],
    size: f64,
    lean: impl Strategy<Value = f64>,
) -> impl Strategy<Value = FloatView> {
    let points = [vector(size), vector(size), vector(size), vector(size)];
    let numbers = [0.5..2.0_f64, -2.0..2.0, -2.0..2.0, 0.1..10.0];
    (points, numbers, lean).prop_map(
        move |([eye, along, aside, point], [distance, u, v, up_size], lean)| {
            let view = along.times(up_size);
            FloatView {
                eye: eye.plus(origin),
                target: eye.plus(origin).plus(along),
                up: view.plus(aside.times(lean)),
                distance: distance * size,
                place: [u * size, v * size],
                point: point.plus(origin),
            }
        },
    )
}

/// Views of ordinary size near the origin, with a direction up that is well away from the view.
pub fn views() -> impl Strategy<Value = FloatView> {
    views_of([0.0; 3], 10.0, 0.5..2.0_f64)
}

/// Views far from the origin, tiny, huge, or with a direction up that is nearly parallel to the view, or parallel up to rounding.
pub fn hard_views() -> impl Strategy<Value = FloatView> {
    let ordinary = || 0.5..2.0_f64;
    let nearly = prop::sample::select(vec![1e-2, 1e-4, 1e-6, 1e-7, 1e-9, 1e-12, 1e-15, 0.0]);
    prop_oneof![
        views_of([1e7, -1e7, 1e7], 30.0, ordinary()),
        views_of([0.0; 3], 1e-30, ordinary()),
        views_of([0.0; 3], 1e30, ordinary()),
        views_of([0.0; 3], 1.0, nearly.clone()),
        views_of([1e5, 1e5, 0.0], 1.0, nearly),
    ]
}
