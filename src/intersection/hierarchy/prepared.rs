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
//! each at the end, one when the margin is added to `o q`, and one when it is added again where the ray leaves: at most 5u R |q|. Where |d_k| < 2⁻²³ |d_z|, it is taken as 2⁻²³ |d_z|, with its
//! sign: then |q| = 2²³, and along the whole scene, s <= R, the ray is moved by less than 2⁻²³ R = 2u R, which is s by 2u R |q|. So a margin
//! of [`SLAB_MARGIN`] u R |q| = 8u R |q| covers both, and there is no division by zero, no infinity and no NaN.
//!
//! *Triangles.* Where a ray enters the box of a leaf, at s, it is within 16u R of the box, whose longest side is D. So no corner is farther from o than
//! r = s + D + 16u R along any axis. The corner A is sheared to `x = (A − o)_x − (d_x / d_z) (A − o)_z`, and y alike: the line becomes the z axis. With
//! |d_x| <= |d_z| the error is at most `u (2 + 4) r`, and [`SHEAR_ERROR`] covers the second order: e = 6.5u r. The sheared corners are within
//! X = 2 (D + 16u R) + e of the axis. So the edge function `U = C_x B_y − C_y B_x` of two corners has an error of at most `4e X + 2e² + 4u X²`, and since
//! u X < 0.65 e this is below [`EDGE_MARGIN`] times e (D + 16u R + e): the margin m. A hit has no U, V, W below −m, or none above m. And
//! if all are above m, or all below −m, the line certainly meets the triangle.
//!
//! *Distance.* There `s = (U A_z + V B_z + W C_z) / (U + V + W)`. The weights have errors that sum to at most 6m / |U + V + W|, and the corners differ
//! from their middle by D / 2: this makes 3 m D / |U + V + W|. The roundings of the corners (1), of the products and sums (4), of the determinant (2), of
//! the reciprocal and the product with it (2) make 9u r more; [`DISTANCE_ERROR`] covers the second order.

use std::ops::{Add, Mul};

use glam::Vec3;
use wide::{f32x8, u32x8};

use crate::ray::Ray;

/// The unit roundoff of `f32`.
pub(super) const U: f32 = f32::EPSILON / 2.0;

/// The margin of a slab, in u R |q|.
const SLAB_MARGIN: f32 = 8.0;

/// The error of a sheared coordinate, in u r.
const SHEAR_ERROR: f32 = 6.5;

/// The margin of an edge function, in e (D + 16 u R + e).
const EDGE_MARGIN: f32 = 13.5;

/// The error of the distance that does not depend on the triangle, in u r.
const DISTANCE_ERROR: f32 = 10.0;

/// The least direction coordinate, as a part of the largest.
const LEAST_SLOPE: f32 = f32::EPSILON;

/// The range of R within which no product of the tests overflows, and no underflow counts.
const LEAST_REACH: f32 = 1.0 / (1_u64 << 40) as f32;
const LARGEST_REACH: f32 = (1_u64 << 40) as f32;

/// The range of the direction's largest coordinate, and of the parameter's unit, that needs no care.
const LEAST_SPEED: f32 = 1.0 / (1_u64 << 60) as f32;
const LARGEST_SPEED: f32 = (1_u64 << 60) as f32;

/// How many rays are prepared at once.
pub(super) const GROUP: usize = 8;

/// A ray ready for boxes and leaves.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub(super) struct Prepared {
    /// q, for each axis.
    pub(super) q: [f32; 3],
    /// `o q` with the margin added: what is taken from p q where the ray enters.
    pub(super) entry: [f32; 3],
    /// Twice the margin: what is added where it leaves.
    pub(super) widening: [f32; 3],
    /// The origin along the axes x, y, z of the leaf's test.
    pub(super) origin: [f32; 3],
    /// `d_x / d_z` and `d_y / d_z`.
    pub(super) shear: [f32; 2],
    /// The sign of `d_z`.
    pub(super) sign: f32,
    /// u R, which all errors are multiples of.
    pub(super) unit: f32,
    /// Where the ray's interval starts and ends, as s: between which bounds.
    pub(super) start: [f32; 2],
    pub(super) end: [f32; 2],
    /// A bit for each negative coordinate of the direction.
    pub(super) octant: u32,
    /// The axis z.
    pub(super) axis: u32,
}

/// What a tree must tell for rays to be prepared.
#[derive(Clone, Copy, Debug)]
pub(super) struct Scene {
    /// The power of two that its coordinates are multiplied by.
    pub(super) scale: f32,
    /// The largest of them after that.
    pub(super) largest: f32,
    /// The mean size of a leaf.
    pub(super) grain: f32,
}

impl Scene {
    /// Whether the tree holds other coordinates than were given.
    #[allow(
        clippy::float_cmp,
        reason = "the power of two 1 and no other number changes nothing"
    )]
    #[inline]
    pub(super) fn is_scaled(self) -> bool {
        self.scale != 1.0
    }
}

/// Some rays, prepared.
#[derive(Clone, Debug)]
pub(super) struct Group {
    pub(super) columns: Columns,
    /// A bit for each that the margins hold for: not for a start below 0, and not where origin or direction are of another world's size, NaN or zero.
    pub(super) ordinary: u32,
}

impl Group {
    pub(super) fn new() -> Self {
        Self {
            columns: Columns::default(),
            ordinary: 0,
        }
    }

    /// Prepares up to eight rays.
    #[inline(always)]
    pub(super) fn fill(&mut self, rays: &[Ray<Vec3>], scene: Scene) {
        let zero = f32x8::ZERO;
        let (mut o, mut d, mut start, mut end) = ([zero; 3], [zero; 3], zero, zero);
        for (lane, ray) in rays.iter().enumerate().take(GROUP) {
            for axis in 0..3 {
                o[axis].as_mut_array()[lane] = ray.origin[axis];
                d[axis].as_mut_array()[lane] = ray.direction[axis];
            }
            start.as_mut_array()[lane] = ray.start;
            end.as_mut_array()[lane] = ray.end.unwrap_or(f32::MAX);
        }
        self.fill_lanes(o, d, start, end, scene);
        self.ordinary &= (1 << rays.len().min(GROUP)) - 1;
    }

    #[inline(always)]
    fn fill_lanes(&mut self, o: [f32x8; 3], d: [f32x8; 3], start: f32x8, end: f32x8, scene: Scene) {
        let splat = f32x8::splat;
        let scale = splat(scene.scale);
        let [ox, oy, oz] = [o[0] * scale, o[1] * scale, o[2] * scale];
        let [dx, dy, dz] = d;
        let [sx, sy, sz] = [dx.abs(), dy.abs(), dz.abs()];
        let speed = sx.fast_max(sy).fast_max(sz);
        let length = speed * scale;
        let reach = (splat(scene.largest) + ox.abs().fast_max(oy.abs()).fast_max(oz.abs()))
            * splat(1.0 + 4.0 * U);
        // A sum is NaN where a coordinate is, unlike a maximum.
        let sums = [ox.abs() + oy.abs() + oz.abs(), sx + sy + sz];
        let is_ordinary =
            are_ordinary(reach, sums, [speed, length]) & start.simd_ge(zero()) & start.simd_lt(end);
        self.ordinary = is_ordinary.to_bitmask();

        let z_is_x = sx.simd_ge(sy) & sx.simd_ge(sz);
        let z_is_y = sy.simd_ge(sz);
        let rotated = |[x, y, z]: [f32x8; 3]| {
            let pick = |for_x: f32x8, for_y: f32x8, for_z: f32x8| {
                z_is_x.select(for_x, z_is_y.select(for_y, for_z))
            };
            [pick(y, z, x), pick(z, x, y), pick(x, y, z)]
        };
        let [ax, ay, az] = rotated([dx, dy, dz]);
        let unit = reach * splat(U);
        let least = speed * splat(LEAST_SLOPE);
        let sign_bit = splat(-0.0);
        let (mut q, mut entry, mut widening) = ([zero(); 3], [zero(); 3], [zero(); 3]);
        for (axis, (o, (d, s))) in [ox, oy, oz]
            .into_iter()
            .zip([dx, dy, dz].into_iter().zip([sx, sy, sz]))
            .enumerate()
        {
            let slope = s.fast_max(least) | (d & sign_bit);
            q[axis] = speed / slope;
            let margin = q[axis].abs() * (unit * splat(SLAB_MARGIN));
            entry[axis] = o * q[axis] + margin;
            widening[axis] = (margin + margin) * splat(1.0 + 4.0 * U);
        }
        let (start, end) = (start * length, end * length);
        let (down, up) = (splat(1.0 - 4.0 * U), splat(1.0 + 4.0 * U));
        let octant = u32x8::splat(1) & (dx.to_bits() >> 31)
            | u32x8::splat(2) & (dy.to_bits() >> 30)
            | u32x8::splat(4) & (dz.to_bits() >> 29);
        let axis = z_is_x.select(
            zero(),
            z_is_y.select(
                f32x8::from_bits(u32x8::splat(1)),
                f32x8::from_bits(u32x8::splat(2)),
            ),
        );
        self.columns = Columns {
            q,
            entry,
            widening,
            position: [ox, oy, oz],
            origin: rotated([ox, oy, oz]),
            shear: [ax / az, ay / az],
            sign: f32x8::ONE | (az & sign_bit),
            unit,
            start: [start * down, start * up],
            end: [(end * down).fast_min(splat(f32::MAX)), end * up],
            octant,
            axis: axis.to_bits(),
        };
    }

    /// One of the rays.
    #[inline(always)]
    pub(super) fn ray(&self, lane: usize) -> Prepared {
        self.columns.row(lane % GROUP)
    }
}

/// Whether the sizes of rays are in the range that the margins hold for: R, the sums of the coordinates of origin and direction, and the direction's largest coordinate in
/// both units.
#[inline(always)]
fn are_ordinary(
    reach: f32x8,
    [of_origin, of_direction]: [f32x8; 2],
    [speed, length]: [f32x8; 2],
) -> f32x8 {
    let splat = f32x8::splat;
    reach.simd_ge(splat(LEAST_REACH))
        & reach.simd_le(splat(LARGEST_REACH))
        & of_origin.simd_le(splat(3.0 * LARGEST_REACH))
        & speed.simd_ge(splat(LEAST_SPEED))
        & of_direction.simd_le(splat(LARGEST_SPEED))
        & length.simd_ge(splat(LEAST_SPEED))
        & length.simd_le(splat(LARGEST_SPEED))
}

#[inline(always)]
fn zero() -> f32x8 {
    f32x8::ZERO
}

/// The fields of [`Prepared`] for eight rays.
#[derive(Clone, Debug, Default)]
pub(super) struct Columns {
    pub(super) q: [f32x8; 3],
    pub(super) entry: [f32x8; 3],
    pub(super) widening: [f32x8; 3],
    /// The origins as they are, and along the axes of the leaf's test.
    pub(super) position: [f32x8; 3],
    pub(super) origin: [f32x8; 3],
    pub(super) shear: [f32x8; 2],
    pub(super) sign: f32x8,
    pub(super) unit: f32x8,
    pub(super) start: [f32x8; 2],
    pub(super) end: [f32x8; 2],
    pub(super) octant: u32x8,
    pub(super) axis: u32x8,
}

impl Columns {
    #[inline(always)]
    fn row(&self, lane: usize) -> Prepared {
        let three =
            |[x, y, z]: &[f32x8; 3]| [x.as_array()[lane], y.as_array()[lane], z.as_array()[lane]];
        let two = |[x, y]: &[f32x8; 2]| [x.as_array()[lane], y.as_array()[lane]];
        Prepared {
            q: three(&self.q),
            entry: three(&self.entry),
            widening: three(&self.widening),
            origin: three(&self.origin),
            shear: two(&self.shear),
            sign: self.sign.as_array()[lane],
            unit: self.unit.as_array()[lane],
            start: two(&self.start),
            end: two(&self.end),
            octant: self.octant.as_array()[lane],
            axis: self.axis.as_array()[lane],
        }
    }
}

impl Prepared {
    // ANCHOR: slabs
    /// Where the ray enters and leaves the eight boxes of a node, widened: `entry <= exit` for each box that the line meets between `start` and `end`.
    #[inline(always)]
    pub(super) fn slabs(&self, planes: &[f32x8; 6], end: f32) -> (f32x8, f32x8) {
        let mut entry = f32x8::splat(self.start[0]);
        let mut exit = f32x8::splat(end);
        for axis in 0..3 {
            let (q, o) = (f32x8::splat(self.q[axis]), f32x8::splat(self.entry[axis]));
            let first = planes[axis].mul_sub(q, o);
            let second = planes[axis + 3].mul_sub(q, o);
            entry = entry.fast_max(first.fast_min(second));
            exit = exit.fast_min(first.fast_max(second) + f32x8::splat(self.widening[axis]));
        }
        (entry, exit)
    }
    // ANCHOR_END: slabs

    /// [`errors`] of this ray.
    #[inline(always)]
    pub(super) fn errors(&self, size: f32, distance: f32) -> (f32, f32) {
        errors(self.unit, size, distance)
    }

    /// How s is made of t: the unit of `line` in the tree's coordinates.
    pub(super) fn unit_of(line: &Ray<Vec3>, scale: f32) -> f64 {
        f64::from(line.direction.abs().max_element()) * f64::from(scale)
    }
}

/// The margin of an edge function and the error of s that does not depend on the triangle, for a leaf of this size whose box the ray enters at
/// this distance. `unit` is u R.
#[inline(always)]
pub(super) fn errors<F>(unit: F, size: F, distance: F) -> (F, F)
where
    F: Copy + Add<Output = F> + Mul<Output = F> + Mul<f32, Output = F>,
{
    let slop = unit * (2.0 * SLAB_MARGIN);
    let reach = distance + size + slop;
    let e = reach * (SHEAR_ERROR * U);
    (
        e * (size + slop + e) * EDGE_MARGIN,
        reach * (DISTANCE_ERROR * U),
    )
}
