//! The whole hit on a triangle: the point and its error, and the unit normal.

use glam::{DVec3, Vec3};

use super::confirm::Confirmed;
use super::exact;
use crate::algebra::unit_vector;
use crate::intersection::Hit;

/// The unit roundoff of `f32`.
const U32: f32 = f32::EPSILON / 2.0;

/// What a rounding to `f32` may add to a number below the least normal one: half of the least denormal number, rounded up to a whole one.
const LEAST: f32 = f32::from_bits(1);

/// The relative error of a normal's coordinate, over the edges' largest coordinates: two differences, a product, a subtraction, of two products.
const NORMAL_ERROR: f64 = 9.0 * f64::EPSILON / 2.0;

/// The normal's relative error above which it is computed exactly.
const LARGEST_NORMAL_ERROR: f64 = 1.0 / (1_u64 << 30) as f64;

impl Confirmed {
    /// The hit in full, on the triangle with these corners.
    ///
    /// The point is `a + v (b − a) + w (c − a)` in `f64`, where v and w have an error of at most 2⁻³⁴, and is rounded once: so it is within
    /// `u |p| + 2⁻³⁴ (|b − a| + |c − a|)` of the exact one in each coordinate, u = 2⁻²⁴, and half a denormal number more.
    pub(super) fn hit(&self, corners: [Vec3; 3]) -> Option<Hit<Vec3>> {
        let [a, b, c] = corners.map(Vec3::as_dvec3);
        let [v, w] = self.weights;
        let (ab, ac) = (b - a, c - a);
        let point = (a + v * ab + w * ac).as_vec3();
        let spread = (ab.abs().max_element() + ac.abs().max_element()) / (1_u64 << 34) as f64;
        let facet = self.facet_hit();
        // 2u instead of u: a power of two that covers the roundings of the bound itself.
        #[allow(clippy::cast_possible_truncation, reason = "a bound, rounded up below")]
        let point_error = U32 * point.abs().max_element() + 2.0 * spread as f32 + LEAST;
        Some(Hit {
            t: facet.t,
            t_error: (U32 * facet.t.abs() * (1.0 + 1.0 / 1024.0)).next_up(),
            point,
            point_error: point_error.next_up(),
            normal: unit_normal(corners)?,
            parameters: Some(facet.parameters),
            side: facet.side,
        })
    }
}

/// The unit vector along `(b − a) × (c − a)`; `None` for a triangle without area, which no ray hits.
fn unit_normal(corners: [Vec3; 3]) -> Option<Vec3> {
    let [a, b, c] = corners.map(Vec3::as_dvec3);
    let (ab, ac) = (b - a, c - a);
    let mut normal = ab.cross(ac);
    let error = NORMAL_ERROR * ab.abs().max_element() * ac.abs().max_element();
    if error > LARGEST_NORMAL_ERROR * normal.abs().max_element() {
        normal = DVec3::from_array(exact::normal(corners));
    }
    Some(unit_vector(normal)?.as_vec3())
}
