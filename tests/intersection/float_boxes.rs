//! Boxes and rays in floating point, ordinary and hard, and the true interval of a line in a box.

use facette::algebra::VectorSpace;
use facette::intersection::BoundingBox;
use facette::ray::Ray;
use num_traits::Zero;
use proptest::prelude::*;

use crate::common::generators::{float_coordinate, hard_float_coordinate};
use crate::common::oracle::{Big, big_point};
use crate::float_chords::{Float, float_vector};

/// A box and a line, drawn in `f64`.
#[derive(Clone, Copy, Debug)]
pub struct FloatBox {
    /// Two corners, in any order.
    pub corners: [[f64; 3]; 2],
    /// The origin of the line.
    pub origin: [f64; 3],
    /// Its direction.
    pub direction: [f64; 3],
}

impl FloatBox {
    /// Box and line, rounded.
    pub fn rounded<S: Float>(&self) -> (BoundingBox<[S; 3]>, Ray<[S; 3]>) {
        let point = |point: [f64; 3]| point.map(S::nearest);
        let bounds = BoundingBox::around(self.corners.map(point));
        let ray = Ray::new(point(self.origin), point(self.direction));
        (bounds.expect("finite corners"), ray)
    }
}

/// The true interval of the line in the box.
pub fn big_interval<S: Float>(bounds: &BoundingBox<[S; 3]>, ray: &Ray<[S; 3]>) -> Option<[Big; 2]> {
    let exactly = |point: [S; 3]| big_point(point.map(Into::into));
    big_interval_between(
        &[bounds.min(), bounds.max()].map(exactly),
        &[ray.origin, ray.direction].map(exactly),
    )
}

/// The true interval of the line with this origin and direction, between these corners of a box.
pub fn big_interval_between(
    [min, max]: &[[Big; 3]; 2],
    [o, d]: &[[Big; 3]; 2],
) -> Option<[Big; 2]> {
    let mut interval: Option<[Big; 2]> = None;
    for axis in 0..3 {
        if d[axis].is_zero() {
            if o[axis] < min[axis] || max[axis] < o[axis] {
                return None;
            }
            continue;
        }
        let mut slab = [min, max].map(|corner| (&corner[axis] - &o[axis]) / &d[axis]);
        slab.sort();
        let [entry, exit] = slab;
        interval = Some(match interval {
            None => [entry, exit],
            Some([first, last]) => [first.max(entry), last.min(exit)],
        });
    }
    interval.filter(|[entry, exit]| entry <= exit)
}

/// The line from `origin` to the point of the box with these weights.
fn aimed(corners: [[f64; 3]; 2], origin: [f64; 3], weights: [f64; 3]) -> FloatBox {
    let [a, b] = corners;
    let target: [f64; 3] = std::array::from_fn(|axis| {
        let weight = weights[axis];
        a[axis] * (1.0 - weight) + b[axis] * weight
    });
    FloatBox {
        corners,
        origin,
        direction: target.minus(origin),
    }
}

/// Lines to points in boxes of ordinary size, or past them.
pub fn float_boxes() -> impl Strategy<Value = FloatBox> {
    let weight = || -0.25..1.25_f64;
    (
        [float_vector(), float_vector()],
        float_vector(),
        [weight(), weight(), weight()],
    )
        .prop_map(|(corners, origin, weights)| aimed(corners, origin, weights))
}

/// Lines to edges and corners, along axes with either zero, from a plane of the box, to flat boxes and points, over coordinates of any size.
pub fn hard_float_boxes() -> impl Strategy<Value = FloatBox> {
    let coordinate = || prop_oneof![2 => float_coordinate(), 1 => hard_float_coordinate()];
    let vector = || [coordinate(), coordinate(), coordinate()];
    let end = || prop::sample::select(vec![0.0, 0.0, 1.0, 0.5]);
    let kinds = [0..8_usize, 0..8, 0..8];
    ([vector(), vector()], vector(), [end(), end(), end()], kinds).prop_map(
        |(corners, origin, weights, kinds)| {
            let [a, mut b] = corners;
            for axis in 0..3 {
                if kinds[axis] == 0 {
                    b[axis] = a[axis];
                }
            }
            let mut line = aimed([a, b], origin, weights);
            for axis in 0..3 {
                match kinds[axis] {
                    1 => line.origin[axis] = a[axis],
                    2 => (line.origin[axis], line.direction[axis]) = (b[axis], 0.0),
                    3 => (line.origin[axis], line.direction[axis]) = (a[axis], -0.0),
                    4 => line.direction[axis] = -0.0,
                    _ => {}
                }
            }
            line
        },
    )
}
