//! Boxes along the axes, and the surface area that tells how many rays meet them.

use glam::Vec3;
use wide::f32x8;

/// A box along the axes: `[low, ·, −high, ·]`, so that one minimum of eight lanes unites two boxes. The two lanes left over mean nothing.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bounds(pub(super) f32x8);

impl Bounds {
    /// The box of nothing: the neutral element of [`union`](Self::union).
    pub(super) const EMPTY: Self = Self(f32x8::new([f32::INFINITY; 8]));

    /// The box of some points.
    #[inline]
    pub(super) fn of_points(points: &[Vec3]) -> Self {
        let lanes = |&p: &Vec3| Self(f32x8::new([p.x, p.y, p.z, 0.0, -p.x, -p.y, -p.z, 0.0]));
        points.iter().map(lanes).fold(Self::EMPTY, Self::union)
    }

    /// The smallest box around both.
    #[inline]
    pub(super) fn union(self, other: Self) -> Self {
        Self(self.0.fast_min(other.0))
    }

    #[inline]
    pub(super) fn low(self) -> Vec3 {
        let [x, y, z, ..] = self.0.to_array();
        Vec3::new(x, y, z)
    }

    #[inline]
    pub(super) fn high(self) -> Vec3 {
        let [.., x, y, z, _] = self.0.to_array();
        -Vec3::new(x, y, z)
    }

    /// The lengths of the sides.
    #[inline]
    pub(super) fn extent(self) -> Vec3 {
        let [x, y, z, _, p, q, r, _] = self.0.to_array();
        -Vec3::new(x + p, y + q, z + r)
    }

    // ANCHOR: half_area
    /// Half the surface area: a random line that meets the scene meets a convex body with a probability proportional to it (Crofton).
    #[inline]
    pub(super) fn half_area(self) -> f32 {
        let Vec3 { x, y, z } = self.extent();
        x * y + y * z + z * x
    }
    // ANCHOR_END: half_area
}
