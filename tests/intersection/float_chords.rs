//! Lines and spheres in floating point, in general position and near trouble.

use facette::algebra::{Real, Vector3, VectorSpace, unit_vector};
use facette::intersection::Sphere;
use facette::ray::Ray;
use num_traits::AsPrimitive;
use proptest::prelude::*;

use crate::common::generators::{float_coordinate, hard_float_coordinate};

/// `f32` and `f64`.
pub trait Float: Real + Into<f64> {
    /// The nearest number of this type.
    fn nearest(value: f64) -> Self;
}

impl<S: Real + Into<f64>> Float for S
where
    f64: AsPrimitive<S>,
{
    fn nearest(value: f64) -> Self {
        value.as_()
    }
}

/// A line and a sphere in floating point, in general position; drawn in `f64`.
#[derive(Clone, Copy, Debug)]
pub struct FloatChord {
    /// The centre of the sphere.
    pub centre: [f64; 3],
    /// Its radius.
    pub radius: f64,
    /// The origin of the line.
    pub origin: [f64; 3],
    /// Its direction.
    pub direction: [f64; 3],
}

impl FloatChord {
    /// Sphere and line, rounded.
    pub fn rounded<S: Float>(&self) -> (Sphere<[S; 3]>, Ray<[S; 3]>) {
        let point = |point: [f64; 3]| point.map(S::nearest);
        let sphere = Sphere::new(point(self.centre), S::nearest(self.radius));
        let ray = Ray::new(point(self.origin), point(self.direction));
        (sphere.expect("a positive radius"), ray)
    }
}

/// The line past `centre` at the distance `rho · radius`, from an origin `before · radius` before its nearest point.
fn passing(
    (centre, radius): ([f64; 3], f64),
    (direction, other): ([f64; 3], [f64; 3]),
    (rho, before): (f64, f64),
    speed: f64,
) -> FloatChord {
    let along = unit_vector(direction).unwrap_or([0.0, 0.0, 1.0]);
    let across = unit_vector(along.cross(other)).unwrap_or([0.6, 0.8, 0.0]);
    let nearest = centre.plus(across.times(rho * radius));
    FloatChord {
        centre,
        radius,
        origin: nearest.minus(along.times(before * radius)),
        direction: along.times(speed),
    }
}

pub fn float_vector() -> impl Strategy<Value = [f64; 3]> {
    [float_coordinate(), float_coordinate(), float_coordinate()]
}

/// Lines near spheres of ordinary size.
pub fn float_chords() -> impl Strategy<Value = FloatChord> {
    let sphere = (float_vector(), 0.1..10.0_f64);
    let line = (float_vector(), float_vector());
    let place = (0.0..1.1_f64, -5.0..20.0_f64);
    (sphere, line, place, 0.1..10.0_f64)
        .prop_map(|(sphere, line, place, speed)| passing(sphere, line, place, speed))
}

/// Lines near tangency, through the centre, along an axis, with origins far away or on the surface, past tiny and huge spheres.
pub fn hard_float_chords() -> impl Strategy<Value = FloatChord> {
    let coordinate = || prop_oneof![float_coordinate(), Just(0.0), hard_float_coordinate()];
    let centre = [coordinate(), coordinate(), coordinate()];
    // Beyond 1e12 in f32 the squares of the coordinates leave room for nothing else: what a bound could still say is that all is lost.
    let centre =
        centre.prop_map(|centre| centre.map(|c: f64| if c.abs() > 1e12 { 0.0 } else { c }));
    let radius = prop::sample::select(vec![1.0, 1e-3, 1e-8, 1e3, 1e8]);
    let axis = prop::sample::select(vec![[1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, 1.0]]);
    let direction = prop_oneof![axis, float_vector()];
    let graze = (-15..0_i32, prop::bool::ANY)
        .prop_map(|(e, inside)| 1.0 + 10.0_f64.powi(e) * if inside { -1.0 } else { 1.0 });
    let rho = prop_oneof![2 => graze, 1 => Just(0.0), 1 => Just(1.0), 1 => 0.0..1.0_f64];
    let before = prop_oneof![
        Just(0.0),
        Just(1.0),
        -1.0..1.0_f64,
        prop::sample::select(vec![1e2, 1e4, 1e8])
    ];
    let speed = prop::sample::select(vec![1.0, 1e-12, 1e12, 1e-30, 1e30]);
    (
        (centre, radius),
        (direction, float_vector()),
        (rho, before),
        speed,
    )
        .prop_map(|(sphere, line, place, speed)| passing(sphere, line, place, speed))
}
