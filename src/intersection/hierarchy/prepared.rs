//! A ray prepared for the tests of boxes and triangles in `f32`, with the margins that keep them from ever rejecting a hit.
//!
//! # Units
//!
//! The ray is measured along z, the axis of its largest direction coordinate: the parameter is `s = t |d_z|`, a length like the coordinates, so
//! that no scale of the direction can make anything overflow. The coordinates are those of the tree, scaled by a power of two.
//!
//! # Numerics
//!
//! Let u = 2⁻²⁴, S the largest coordinate of the scene and R = S + |o|, which no distance from o to a point of the scene exceeds along any axis.
//!
//! *Boxes.* The plane p of axis k is met at `s = (p − o) q`, q = |d_z| / d_k, computed as `p q − o q`: two roundings of |p q|, two of |o q|, one more of
//! each at the end, and one when the margin is added to `o q`: at most 4u R |q|. Where |d_k| < 2⁻²³ |d_z|, it is taken as 2⁻²³ |d_z|, with its
//! sign: then |q| = 2²³, and along the whole scene, s <= R, the ray is moved by less than 2⁻²³ R = 2u R, which is s by 2u R |q|. So a margin
//! of [`SLAB_MARGIN`] u R |q| = 8u R |q| covers both, and there is no division by zero, no infinity and no NaN.
//!
//! *Triangles.* The corner A is sheared to `x = (A − o)_x − (d_x / d_z) (A − o)_z`, and y alike: the line becomes the z axis. With |d_x| <= |d_z| the
//! error is at most `u (2 + 4) R`, and [`SHEAR_ERROR`] covers the second order: e = 6.5u R. A leaf whose box, widened by the slabs' margins (16u R < 2.5e), is
//! met by the line has all its corners within X = 2 (D + 2.5e) + e of the axis, D being the box's longest side. So the edge function
//! `U = C_x B_y − C_y B_x` of two corners has an error of at most `4eX + 2e² + 4u X² <= 13 e (D + 3e)` (16u D² < 4.9 e D since D <= 2R): the margin m.
//! A hit has no U, V, W below −m, or none above m. And if all are above m, or all below −m, the line certainly meets the triangle.
//!
//! *Distance.* There `s = (U A_z + V B_z + W C_z) / (U + V + W)`. The weights have errors that sum to at most 6m / |U + V + W|, and the corners differ
//! from their middle by D / 2: this makes 3 m D / |U + V + W|. The roundings of the corners (1), of the products and sums (4), of the determinant (2), of
//! the reciprocal and the product with it (2) make 9u R more; [`DISTANCE_ERROR`] covers the second order.

use glam::Vec3;
use wide::f32x8;

use super::confirm::Line;

/// The unit roundoff of `f32`.
const U: f32 = f32::EPSILON / 2.0;

/// The margin of a slab, in u R |q|.
const SLAB_MARGIN: f32 = 8.0;

/// The error of a sheared coordinate, in u R.
const SHEAR_ERROR: f32 = 6.5;

/// The error of the distance that does not depend on the triangle, in u R.
const DISTANCE_ERROR: f32 = 10.0;

/// The least direction coordinate, as a part of the largest.
const LEAST_SLOPE: f32 = f32::EPSILON;

/// The range of R within which no product of the tests overflows, and no underflow counts.
const ORDINARY_REACH: std::ops::Range<f32> = 1.0 / (1_u64 << 40) as f32..(1_u64 << 40) as f32;

/// The range of the direction's largest coordinate that needs no care.
const ORDINARY_SPEED: std::ops::Range<f32> = 1.0 / (1_u128 << 100) as f32..(1_u128 << 100) as f32;

/// A number known to be between two others.
#[derive(Clone, Copy, Debug)]
pub(super) struct Interval {
    pub(super) low: f32,
    pub(super) high: f32,
}

impl Interval {
    /// Around a number that is not negative.
    #[inline]
    fn around(value: f64) -> Self {
        #[allow(
            clippy::cast_possible_truncation,
            reason = "widened by one rounding on both sides"
        )]
        let rounded = value as f32;
        Self {
            low: (rounded * (1.0 - 2.0 * U)).min(f32::MAX),
            high: rounded * (1.0 + 2.0 * U),
        }
    }
}

/// A ray ready for boxes and leaves.
#[derive(Clone, Copy, Debug)]
pub(super) struct Prepared {
    /// q, for each axis.
    pub(super) inverse: [f32; 3],
    /// `o q` with the margin added: what is taken from p q where the ray enters.
    pub(super) entry: [f32; 3],
    /// `o q` with the margin taken away.
    pub(super) exit: [f32; 3],
    /// Which planes of a node are those of entry: 0, 1, 2 for the low ones and 3, 4, 5 for the high ones.
    pub(super) near: [usize; 3],
    /// A bit for each negative coordinate of the direction.
    pub(super) octant: usize,
    pub(super) far: [usize; 3],
    /// The axes x, y, z of the leaf's test.
    pub(super) axes: [usize; 3],
    /// The origin in their order.
    pub(super) origin: [f32; 3],
    /// `d_x / d_z` and `d_y / d_z`.
    pub(super) shear: [f32; 2],
    /// The sign of `d_z`.
    pub(super) sign: f32,
    /// 13 e.
    pub(super) edge_margin: f32,
    /// 3 e.
    pub(super) slack: f32,
    pub(super) distance_error: f32,
    /// Where the ray's interval starts and ends, as s.
    pub(super) start: Interval,
    pub(super) end: Interval,
}

impl Prepared {
    /// Whether the margins hold: not for a start below 0, and not where origin or direction are of another world's size. `reach` is R.
    #[inline(always)]
    pub(super) fn is_ordinary(line: &Line, reach: f32) -> bool {
        let speed = line.direction.abs().max_element();
        ORDINARY_REACH.contains(&reach) && ORDINARY_SPEED.contains(&speed) && line.start >= 0.0
    }

    /// R, for a scene with this largest coordinate.
    #[inline(always)]
    pub(super) fn reach(line: &Line, scale: f32, largest: f32) -> f32 {
        let o = line.origin * scale;
        (largest + o.abs().max_element()) * (1.0 + 4.0 * U)
    }

    /// An ordinary line, for a tree with coordinates scaled by `scale`.
    #[inline(always)]
    pub(super) fn new(line: &Line, scale: f32, reach: f32) -> Self {
        let (o, d) = (line.origin * scale, line.direction);
        let size = d.abs();
        let speed = size.max_element();
        let z = if size.x >= size.y {
            if size.x >= size.z { 0 } else { 2 }
        } else if size.y >= size.z {
            1
        } else {
            2
        };
        let x = if z == 2 { 0 } else { z + 1 };
        let y = if x == 2 { 0 } else { x + 1 };
        let slope = size.max(Vec3::splat(LEAST_SLOPE * speed)).copysign(d);
        let inverse = Vec3::splat(speed) / slope;
        let margin = inverse.abs() * (SLAB_MARGIN * U * reach);
        let offset = o * inverse;
        let is_backwards = d.is_negative_bitmask() as usize;
        let near = [0, 1, 2].map(|axis| axis + 3 * (is_backwards >> axis & 1));
        let unit = f64::from(speed) * f64::from(scale);
        let e = SHEAR_ERROR * U * reach;
        let shear = d / d[z];
        Self {
            inverse: inverse.into(),
            entry: (offset + margin).into(),
            exit: (offset - margin).into(),
            near,
            octant: is_backwards,
            far: [3 - near[0], 5 - near[1], 7 - near[2]],
            axes: [x, y, z],
            origin: [o[x], o[y], o[z]],
            shear: [shear[x], shear[y]],
            sign: 1.0_f32.copysign(d[z]),
            edge_margin: 13.0 * e,
            slack: 3.0 * e,
            distance_error: DISTANCE_ERROR * U * reach,
            start: Interval::around(f64::from(line.start) * unit),
            end: Interval::around(f64::from(line.end) * unit),
        }
    }

    /// Where the ray enters and leaves the eight boxes of a node, widened: `entry <= exit` for each box that the line meets between `start` and `end`.
    #[inline(always)]
    pub(super) fn slabs(&self, planes: &[f32x8; 6], start: f32, end: f32) -> (f32x8, f32x8) {
        let mut entry = f32x8::splat(start);
        let mut exit = f32x8::splat(end);
        for axis in 0..3 {
            let q = f32x8::splat(self.inverse[axis]);
            let near = planes[self.near[axis]].mul_sub(q, f32x8::splat(self.entry[axis]));
            let far = planes[self.far[axis]].mul_sub(q, f32x8::splat(self.exit[axis]));
            entry = near.fast_max(entry);
            exit = far.fast_min(exit);
        }
        (entry, exit)
    }
}
