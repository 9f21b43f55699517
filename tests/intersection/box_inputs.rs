//! Boxes and rays over exact numbers, ordinary and hard.

use facette::algebra::{Scalar, VectorSpace};
use facette::intersection::BoundingBox;
use facette::ray::Ray;
use num_traits::Zero;
use proptest::prelude::*;

use crate::common::exact::{Exact, fraction};
use crate::common::generators::point;

/// A point of space over the rationals.
pub type Point = [Exact; 3];

/// A box and a line.
#[derive(Clone, Copy, Debug)]
pub struct BoxPlace {
    /// The corner with the smallest coordinates.
    pub min: Point,
    /// The corner with the largest.
    pub max: Point,
    /// The origin of the line.
    pub origin: Point,
    /// Its direction.
    pub direction: Point,
}

impl BoxPlace {
    /// The box.
    pub fn bounds(&self) -> BoundingBox<Point> {
        BoundingBox::new(self.min, self.max).expect("the corners are in order")
    }

    /// The half-line t > 0.
    pub fn ray(&self) -> Ray<Point> {
        Ray::new(self.origin, self.direction)
    }

    /// Whether a point is in the box, coordinate by coordinate.
    pub fn holds(&self, point: Point) -> bool {
        (0..3).all(|axis| self.min[axis] <= point[axis] && point[axis] <= self.max[axis])
    }

    /// The parameters at which the line meets the six planes of the faces, in order.
    pub fn face_parameters(&self) -> Vec<Exact> {
        let mut all: Vec<Exact> = (0..3)
            .filter(|&axis| !self.direction[axis].is_zero())
            .flat_map(|axis| {
                [self.min, self.max]
                    .map(|corner| (corner[axis] - self.origin[axis]) / self.direction[axis])
            })
            .collect();
        all.sort_by(|a, b| a.partial_cmp(b).expect("exact numbers are in order"));
        all
    }
}

fn place([a, b, origin, direction]: [Point; 4]) -> BoxPlace {
    let smaller = |axis: usize| if a[axis] < b[axis] { a[axis] } else { b[axis] };
    let larger = |axis: usize| if a[axis] < b[axis] { b[axis] } else { a[axis] };
    let x = [1, 0, 0].map(Exact::from_i32);
    BoxPlace {
        min: [0, 1, 2].map(smaller),
        max: [0, 1, 2].map(larger),
        origin,
        direction: if direction.largest_coordinate().is_zero() {
            x
        } else {
            direction
        },
    }
}

/// Boxes, and lines through a point near or in them.
pub fn boxes() -> impl Strategy<Value = BoxPlace> {
    let weight = || (0..=6_i32).prop_map(|fifths| fraction(fifths, 5));
    ([point(), point()], point(), [weight(), weight(), weight()]).prop_map(
        |([a, b], direction, weights)| {
            let target: Point =
                std::array::from_fn(|axis| a[axis] + (b[axis] - a[axis]) * weights[axis]);
            place([a, b, target.minus(direction), direction])
        },
    )
}

/// Lines along an axis or a face, through an edge or a corner, from a face, past a flat box or a single point.
pub fn hard_boxes() -> impl Strategy<Value = BoxPlace> {
    let choice = || prop::sample::select(vec![0, 0, 1, 2, 2]);
    let zeros = [any::<bool>(), any::<bool>(), any::<bool>()];
    let flat = [any::<bool>(), any::<bool>(), any::<bool>()];
    let target = [choice(), choice(), choice()];
    (
        [point(), point(), point()],
        target,
        zeros,
        flat,
        prop::sample::select(vec![-1, 0, 1]),
    )
        .prop_map(|([a, b, direction], target, zeros, flat, before)| {
            let b: Point = std::array::from_fn(|axis| if flat[axis] { a[axis] } else { b[axis] });
            let half = |axis: usize| (b[axis] - a[axis]) * fraction(target[axis], 2);
            let target: Point = std::array::from_fn(|axis| a[axis] + half(axis));
            let direction: Point = std::array::from_fn(|axis| {
                if zeros[axis] {
                    Exact::zero()
                } else {
                    direction[axis]
                }
            });
            place([
                a,
                b,
                target.minus(direction.times(Exact::from_i32(before))),
                direction,
            ])
        })
}
