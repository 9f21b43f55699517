//! The control net in the ray's coordinates: projected, halved, evaluated.

use super::ROUNDOFF;
use crate::algebra::{Vector3, VectorSpace};
use crate::ray::Ray;

/// A control point as the ray sees it: its distances from the two planes through the ray, and its depth.
pub(super) type Seen = [f64; 3];

/// So many unit roundoffs of the largest coordinate difference may a projected control point be wrong by. With that difference as the unit:
/// `w = (p − o)/W` has 2; its product with the slope `d_a/d_k`, at most 1 and itself rounded, has 4; the difference of both is at most 2 and rounded,
/// which adds 2: together 8, and one for the terms of second order.
pub(super) const ROUNDOFFS_OF_A_PROJECTION: f64 = 9.0;

/// The coordinates of a ray: the axis along which it runs fastest, and two planes that meet in it.
#[derive(Clone, Copy, Debug)]
pub(super) struct RayFrame {
    origin: [f64; 3],
    /// The other two axes, and the axis k of the direction's largest coordinate.
    axes: [usize; 3],
    /// `d_a / d_k` and `d_b / d_k`.
    slopes: [f64; 2],
    /// The largest coordinate of a control point seen from the origin: the unit of the frame, signed so that the depth grows along the ray.
    unit: f64,
    /// What a depth is multiplied with to become t.
    pub(super) t_per_depth: f64,
}

impl RayFrame {
    /// The frame of a ray, as large as the control points; `None` for a ray or a size that is not finite, and for no direction.
    // ANCHOR: frame
    pub(super) fn new(ray: &Ray<[f64; 3]>, control_points: &[[f64; 3]]) -> Option<Self> {
        let k = ray.direction.largest_axis();
        let axes = [(k + 1) % 3, (k + 2) % 3, k];
        let along = ray.direction[k];
        let slopes = [0, 1].map(|i| ray.direction[axes[i]] / along);
        let sizes = control_points.iter();
        let sizes = sizes.map(|point| point.minus(ray.origin).largest_coordinate());
        let size = sizes.fold(0.0, f64::max);
        // ANCHOR_END: frame
        let largest = ray.direction.largest_coordinate();
        let is_usable = |x: f64| x > 0.0 && x.is_finite();
        if !(is_usable(largest) && is_usable(size) && ray.origin.has_finite_coordinates()) {
            return None;
        }
        Some(Self {
            origin: ray.origin,
            axes,
            slopes,
            unit: if along < 0.0 { -size } else { size },
            t_per_depth: size / largest,
        })
    }

    /// A parameter of the ray as a depth, moved by more than its rounding (of two quotients and a sum) towards `outwards`, which is 1 or -1.
    pub(super) fn depth_beyond(&self, t: f64, outwards: f64) -> f64 {
        let depth = t / self.t_per_depth;
        depth + outwards * 4.0 * ROUNDOFF * depth.abs()
    }

    /// A point in the ray's coordinates: the ray is where the first two are 0. None is larger than 2.
    // ANCHOR: seen
    pub(super) fn seen(&self, point: [f64; 3]) -> Seen {
        let w = point.minus(self.origin);
        let [w_a, w_b, depth] = self.axes.map(|axis| w[axis] / self.unit);
        [
            w_a - self.slopes[0] * depth,
            w_b - self.slopes[1] * depth,
            depth,
        ]
    }
    // ANCHOR_END: seen

    /// How much the depth changes on a surface with this normal, at most, where the two other coordinates change by 1.
    pub(super) fn depth_per_offset(&self, normal: [f64; 3]) -> f64 {
        let [a, b, k] = self.axes.map(|axis| normal[axis]);
        let along = self.slopes[0] * a + self.slopes[1] * b + k;
        (a.abs() + b.abs()) / along.abs()
    }

    /// The ray's parameter at a depth, and a bound on its error where the depth has this one.
    pub(super) fn ray_parameter(&self, depth: f64, error: f64) -> [f64; 2] {
        let t = depth * self.t_per_depth;
        // The unit's quotient and the product are rounded, and so is this bound.
        let roundoffs = 4.0 * ROUNDOFF;
        [
            t,
            (error * self.t_per_depth + roundoffs * t.abs()) * (1.0 + roundoffs),
        ]
    }
}

/// The middle of two points.
fn middle(a: Seen, b: Seen) -> Seen {
    a.plus(b).times(0.5)
}

/// Halves the last net in `nets` across u (`direction` 0) or v (1) by de Casteljau: it becomes its upper half, and the lower half is appended.
// ANCHOR: halve
pub(super) fn halve(nets: &mut Vec<Seen>, degrees: [usize; 2], direction: usize) -> usize {
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
fn de_casteljau(points: &mut [Seen], keep: usize, t: f64) {
    for left in (keep..points.len()).rev() {
        for i in 0..left {
            points[i] = points[i].lerp(points[i + 1], t);
        }
    }
}

/// The point of a net at `[s, t]` in its unit square, and its two partial derivatives. The buffer is scratch space.
pub(super) fn evaluate(
    net: &[Seen],
    [p, q]: [usize; 2],
    [s, t]: [f64; 2],
    buffer: &mut Vec<Seen>,
) -> [Seen; 3] {
    buffer.clear();
    buffer.resize(p + 1 + 2 * (q + 1), [0.0; 3]);
    let (row, columns) = buffer.split_at_mut(p + 1);
    let (values, slopes) = columns.split_at_mut(q + 1);
    for (j, points) in net.chunks_exact(p + 1).enumerate() {
        row.copy_from_slice(points);
        de_casteljau(row, 2, s);
        values[j] = row[0].lerp(row[1], s);
        slopes[j] = row[1].minus(row[0]).times(p as f64);
    }
    de_casteljau(values, 2, t);
    de_casteljau(slopes, 1, t);
    let along_t = values[1].minus(values[0]).times(q as f64);
    [values[0].lerp(values[1], t), slopes[0], along_t]
}
