//! The test of a leaf: up to eight triangles at once, certain or possible.

use wide::{f32x8, u32x8};

use super::node::Leaf;
use super::order::lanes_of;
use super::prepared::Prepared;

/// Which triangles of a leaf the ray may meet first, and what is known of where.
pub(super) struct Candidates {
    /// A bit for each triangle that may be met in the ray's interval, before what it has met.
    pub(super) possible: u32,
    /// A bit for each that the line certainly meets.
    pub(super) certain: u32,
    /// For those: between which bounds s is.
    pub(super) low: f32x8,
    pub(super) high: f32x8,
}

impl Prepared {
    /// The triangles of a leaf that the ray may meet between its start and s = `end`. It enters the leaf's box at `distance`.
    ///
    /// All is computed for all triangles: a branch that nobody can foretell costs more.
    #[inline(always)]
    pub(super) fn candidates(
        &self,
        leaf: &Leaf,
        lanes: u32,
        distance: f32,
        end: f32,
    ) -> Candidates {
        let splat = f32x8::splat;
        let [px, py, pz] = self.sheared(leaf);
        let [a, b, c] = [
            lanes_of(&leaf.indices[0]),
            lanes_of(&leaf.indices[1]),
            lanes_of(&leaf.indices[2]),
        ];
        let at =
            |row: f32x8, corner: u32x8| f32x8::from_bits(row.to_bits().shuffle_wrapping(corner));
        let (ax, ay, bx, by, cx, cy) = (
            at(px, a),
            at(py, a),
            at(px, b),
            at(py, b),
            at(px, c),
            at(py, c),
        );
        let u = cx.mul_sub(by, cy * bx);
        let v = ax.mul_sub(cy, ay * cx);
        let w = bx.mul_sub(ay, by * ax);
        let least = u.fast_min(v).fast_min(w);
        let most = u.fast_max(v).fast_max(w);
        let (margin, distance_error) = self.errors(leaf.size, distance);
        let possible = least.simd_ge(splat(-margin)) | most.simd_le(splat(margin));
        let certain = least.simd_gt(splat(margin)) | most.simd_lt(splat(-margin));
        let reciprocal = f32x8::ONE / (u + v + w);
        let s = (u * at(pz, a) + v * at(pz, b) + w * at(pz, c)) * (reciprocal * splat(self.sign));
        let error = reciprocal.abs() * splat(3.0 * margin * leaf.size) + splat(distance_error);
        let (low, high) = (s - error, s + error);
        let is_out = certain & (low.simd_gt(splat(end)) | high.simd_lt(splat(self.start[0])));
        Candidates {
            possible: possible.to_bitmask() & !is_out.to_bitmask() & lanes,
            certain: certain.to_bitmask(),
            low,
            high,
        }
    }

    /// The corners of a leaf from the ray's origin, sheared so that the ray is the axis z.
    #[inline(always)]
    fn sheared(&self, leaf: &Leaf) -> [f32x8; 3] {
        let splat = f32x8::splat;
        let z = self.axis as usize;
        let x = if z == 2 { 0 } else { z + 1 };
        let y = if z == 0 { 2 } else { z - 1 };
        let pz = leaf.corners[z] - splat(self.origin[2]);
        let px = pz.mul_neg_add(
            splat(self.shear[0]),
            leaf.corners[x] - splat(self.origin[0]),
        );
        let py = pz.mul_neg_add(
            splat(self.shear[1]),
            leaf.corners[y] - splat(self.origin[1]),
        );
        [px, py, pz]
    }
}
