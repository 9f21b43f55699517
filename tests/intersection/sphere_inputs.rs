//! Lines and spheres with roots that are small dyadic numbers, so that floating point holds everything exactly.

use facette::algebra::{Vector3, VectorSpace};
use facette::intersection::Sphere;
use facette::ray::Ray;
use proptest::prelude::*;

use crate::common::exact::{Exact, fraction};

/// Points with integer coordinates and an integer distance from the origin.
const INTEGER_ARMS: [[i32; 4]; 8] = [
    [1, 2, 2, 3],
    [2, 3, 6, 7],
    [1, 4, 8, 9],
    [4, 4, 7, 9],
    [2, 6, 9, 11],
    [3, 4, 0, 5],
    [0, 0, 2, 2],
    [3, 4, 12, 13],
];

/// A line through a sphere, all of whose numbers floating point holds exactly, together with the discriminant and the roots.
#[derive(Clone, Copy, Debug)]
pub struct IntegerChord {
    /// The centre c of the sphere.
    pub centre: [f64; 3],
    /// Its radius r.
    pub radius: f64,
    /// The origin o of the line.
    pub origin: [f64; 3],
    /// Its direction d.
    pub direction: [f64; 3],
    /// Where it meets the sphere, smaller first.
    pub roots: [f64; 2],
}

impl IntegerChord {
    /// From the centre to the origin.
    pub fn p(&self) -> [f64; 3] {
        self.origin.minus(self.centre)
    }

    /// The half-line t > 0.
    pub fn ray(&self) -> Ray<[f64; 3]> {
        Ray::new(self.origin, self.direction)
    }

    /// The sphere.
    pub fn sphere(&self) -> Sphere<[f64; 3]> {
        Sphere::new(self.centre, self.radius).expect("a positive radius")
    }
}

/// An arm with its coordinates in another order, and some of their signs turned.
fn turned([x, y, z]: [i32; 3], turns: usize, signs: usize) -> [f64; 3] {
    let mut arm = [x, y, z];
    arm.rotate_left(turns % 3);
    std::array::from_fn(|axis| {
        let sign = if signs >> axis & 1 == 1 { -1.0 } else { 1.0 };
        sign * f64::from(arm[axis])
    })
}

fn integer_point() -> impl Strategy<Value = [f64; 3]> {
    [-9..=9_i32, -9..=9_i32, -9..=9_i32].prop_map(|point| point.map(f64::from))
}

/// Two arms of the same sphere, different ones, and its radius.
fn two_arms() -> impl Strategy<Value = ([f64; 3], [f64; 3], f64)> {
    (
        0..INTEGER_ARMS.len(),
        [0..3_usize, 0..3],
        [0..8_usize, 0..8],
    )
        .prop_map(|(index, turns, signs)| {
            let [x, y, z, radius] = INTEGER_ARMS[index];
            let [a, b] = [0, 1].map(|which| turned([x, y, z], turns[which], signs[which]));
            let b = if a == b { a.times(-1.0) } else { b };
            (a, b, f64::from(radius))
        })
}

fn chord(
    (centre, (a, b, radius)): ([f64; 3], ([f64; 3], [f64; 3], f64)),
    before: f64,
    speed: f64,
) -> IntegerChord {
    let along = b.minus(a);
    IntegerChord {
        centre,
        radius,
        origin: centre.plus(a).minus(along.times(before)),
        direction: along.times(speed),
        roots: [before / speed, (before + 1.0) / speed],
    }
}

fn speed() -> impl Strategy<Value = f64> {
    prop::sample::select(vec![0.25, 0.5, 1.0, 2.0, 8.0])
}

/// Chords from an origin up to five lengths before the sphere, or in it, or behind.
pub fn integer_chords() -> impl Strategy<Value = IntegerChord> {
    let data = (integer_point(), two_arms());
    (data, -10..=10_i32, speed())
        .prop_map(|(data, halves, speed)| chord(data, f64::from(halves) / 2.0, speed))
}

/// Chords from the surface, through the centre, from far away, and tangents.
pub fn hard_integer_chords() -> impl Strategy<Value = IntegerChord> {
    let on_surface = (integer_point(), two_arms(), 0..2_i32, speed())
        .prop_map(|(centre, arms, back, speed)| chord((centre, arms), -f64::from(back), speed));
    let far = (integer_point(), two_arms(), speed()).prop_map(|(centre, (a, _, radius), speed)| {
        chord((centre, (a, a.times(-1.0), radius)), 1000.0, speed)
    });
    let tangent = (integer_point(), two_arms(), integer_point(), -4..=4_i32).prop_map(
        |(centre, (a, _, radius), other, before)| {
            let across = a.cross(other);
            let is_tangent = across != [0.0; 3];
            let direction = if is_tangent {
                across
            } else {
                a.cross([1.0, 2.0, 4.0])
            };
            let before = f64::from(before);
            IntegerChord {
                centre,
                radius,
                origin: centre.plus(a).minus(direction.times(before)),
                direction,
                roots: [before; 2],
            }
        },
    );
    prop_oneof![on_surface, far, tangent]
}

/// The exact number that a multiple of 1/16 is.
pub fn exact(value: f64) -> Exact {
    let sixteenths = value * 16.0;
    assert!(
        sixteenths.fract() == 0.0 && sixteenths.abs() < 1e9,
        "{value} is a sixteenth"
    );
    #[allow(clippy::cast_possible_truncation, reason = "asserted above")]
    fraction(sixteenths as i32, 16)
}
