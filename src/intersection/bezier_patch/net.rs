//! The control net in the ray's coordinates: projected, halved, evaluated.

use num_traits::{One, Zero};

use crate::algebra::{Scalar, Vector3, VectorSpace, larger};
use crate::curve::count;
use crate::ray::Ray;

/// A control point as the ray sees it: its distances from the two planes through the ray, and its depth.
pub(super) type Seen<S> = [S; 3];

/// So many unit roundoffs of the largest coordinate difference may a projected control point be wrong by. With that difference as the unit:
/// `w = (p − o)/W` has 2; its product with the slope `d_a/d_k`, at most 1 and itself rounded, has 4; the difference of both is at most 2 and rounded,
/// which adds 2: together 8, and one for the terms of second order.
pub(super) const ROUNDOFFS_OF_A_PROJECTION: i32 = 9;

/// The coordinates of a ray: the axis along which it runs fastest, and two planes that meet in it.
#[derive(Clone, Copy, Debug)]
pub(super) struct RayFrame<P: Vector3> {
    origin: P,
    /// The other two axes, and the axis k of the direction's largest coordinate.
    axes: [usize; 3],
    /// `d_a / d_k` and `d_b / d_k`.
    slopes: [P::Scalar; 2],
    /// The largest coordinate of a control point seen from the origin: the unit of the frame, signed so that the depth grows along the ray.
    unit: P::Scalar,
    /// What a depth is multiplied with to become t.
    pub(super) t_per_depth: P::Scalar,
}

impl<P: Vector3> RayFrame<P> {
    /// The frame of a ray, as large as the control points; `None` for a ray or a size that is not finite, and for no direction.
    // ANCHOR: frame
    pub(super) fn new(ray: &Ray<P>, control_points: &[P]) -> Option<Self> {
        let zero = P::Scalar::zero();
        let largest = ray.direction.largest_coordinate();
        let k = (0..3).find(|&axis| ray.direction.coordinate(axis).magnitude() == largest)?;
        let axes = [(k + 1) % 3, (k + 2) % 3, k];
        let along = ray.direction.coordinate(k);
        let slopes = [0, 1].map(|i| ray.direction.coordinate(axes[i]) / along);
        let sizes = control_points.iter();
        let sizes = sizes.map(|point| point.minus(ray.origin).largest_coordinate());
        let size = sizes.fold(zero, larger);
        // ANCHOR_END: frame
        if largest.is_zero() || size.is_zero() || !(largest.is_finite() && size.is_finite()) {
            return None;
        }
        Some(Self {
            origin: ray.origin,
            axes,
            slopes,
            unit: if along < zero { -size } else { size },
            t_per_depth: size / largest,
        })
    }

    /// A parameter of the ray as a depth, moved by more than its rounding (of two quotients and a sum) towards `outwards`, which is 1 or -1.
    pub(super) fn depth_beyond(&self, t: P::Scalar, outwards: i32) -> P::Scalar {
        let depth = t / self.t_per_depth;
        let slack = P::Scalar::from_i32(4 * outwards) * P::Scalar::unit_roundoff();
        depth + slack * depth.magnitude()
    }

    /// A point in the ray's coordinates: the ray is where the first two are 0. None is larger than 2.
    // ANCHOR: seen
    pub(super) fn seen(&self, point: P) -> Seen<P::Scalar> {
        let [a, b, k] = self.axes;
        let w = point.minus(self.origin);
        let [w_a, w_b, depth] = [a, b, k].map(|axis| w.coordinate(axis) / self.unit);
        [
            w_a - self.slopes[0] * depth,
            w_b - self.slopes[1] * depth,
            depth,
        ]
    }
    // ANCHOR_END: seen

    /// The ray's parameter at a depth, and a bound on its error where the depth has this one.
    pub(super) fn ray_parameter(&self, depth: P::Scalar, error: P::Scalar) -> [P::Scalar; 2] {
        let t = depth * self.t_per_depth;
        // The quotient and the two products are rounded, and the sum.
        let roundoffs = P::Scalar::from_i32(4) * P::Scalar::unit_roundoff();
        let factor = P::Scalar::one() + roundoffs;
        [
            t,
            (error * self.t_per_depth + roundoffs * t.magnitude()) * factor,
        ]
    }
}

/// The middle of two points.
fn middle<S: Scalar>(a: Seen<S>, b: Seen<S>) -> Seen<S> {
    a.plus(b).times(S::ratio(1, 2))
}

/// Halves the last net in `nets` across u (`direction` 0) or v (1) by de Casteljau: it becomes its upper half, and the lower half is appended.
// ANCHOR: halve
pub(super) fn halve<S: Scalar>(
    nets: &mut Vec<Seen<S>>,
    degrees: [usize; 2],
    direction: usize,
) -> usize {
    let [columns, rows] = degrees.map(|degree| degree + 1);
    let upper = nets.len() - columns * rows;
    nets.extend_from_within(upper..);
    let lower = upper + columns * rows;
    let (lines, between_lines, step) = if direction == 0 {
        (rows, columns, 1)
    } else {
        (columns, 1, columns)
    };
    for line in 0..lines {
        let first = line * between_lines;
        for level in 1..=degrees[direction] {
            for i in 0..=degrees[direction] - level {
                let at = upper + first + i * step;
                nets[at] = middle(nets[at], nets[at + step]);
            }
            nets[lower + first + level * step] = nets[upper + first];
        }
    }
    lower
}
// ANCHOR_END: halve

/// Replaces `points` by the points between neighbours, again and again, until `keep` are left.
fn de_casteljau<S: Scalar>(points: &mut [Seen<S>], keep: usize, t: S) {
    for left in (keep..points.len()).rev() {
        for i in 0..left {
            points[i] = points[i].lerp(points[i + 1], t);
        }
    }
}

/// The point of a net at `[s, t]` in its unit square, and its two partial derivatives. The buffer is scratch space.
pub(super) fn evaluate<S: Scalar>(
    net: &[Seen<S>],
    [p, q]: [usize; 2],
    [s, t]: [S; 2],
    buffer: &mut Vec<Seen<S>>,
) -> [Seen<S>; 3] {
    buffer.clear();
    buffer.resize(p + 1 + 2 * (q + 1), [S::zero(); 3]);
    let (row, columns) = buffer.split_at_mut(p + 1);
    let (values, slopes) = columns.split_at_mut(q + 1);
    for (j, points) in net.chunks_exact(p + 1).enumerate() {
        row.copy_from_slice(points);
        de_casteljau(row, 2, s);
        values[j] = row[0].lerp(row[1], s);
        slopes[j] = row[1].minus(row[0]).times(S::from_i32(count(p)));
    }
    de_casteljau(values, 2, t);
    de_casteljau(slopes, 1, t);
    let along_t = values[1].minus(values[0]).times(S::from_i32(count(q)));
    [values[0].lerp(values[1], t), slopes[0], along_t]
}
