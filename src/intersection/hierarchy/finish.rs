//! The answers of rays that have arrived, eight at a time.

use glam::Vec3;
use wide::{f32x8, f64x8};

use super::confirm::{Estimate, LARGEST_ERROR, side};
use super::prepared::GROUP;
use super::walk::Place;
use super::{Found, Hierarchy, found};
use crate::intersection::FacetHit;
use crate::ray::Ray;

/// Rays that have arrived, with the triangle that each has found, in lanes.
#[derive(Clone, Debug)]
pub(super) struct Arrived {
    count: usize,
    indices: [usize; GROUP],
    places: [Place; GROUP],
    triangles: [u32; GROUP],
    origin: [f32x8; 3],
    direction: [f32x8; 3],
    corners: [[f32x8; 3]; 3],
}

impl Arrived {
    pub(super) fn new() -> Self {
        Self {
            count: 0,
            indices: [0; GROUP],
            places: [Place::NONE; GROUP],
            triangles: [0; GROUP],
            origin: [f32x8::ZERO; 3],
            direction: [f32x8::ZERO; 3],
            corners: [[f32x8::ZERO; 3]; 3],
        }
    }

    /// Adds a ray, and answers all that are here when there are eight.
    #[inline(always)]
    pub(super) fn add(
        &mut self,
        hierarchy: &Hierarchy,
        rays: &[Ray<Vec3>],
        index: usize,
        place: Place,
        answers: &mut [Option<Found>],
    ) {
        let lane = self.count % GROUP;
        let (triangle, corners) = hierarchy.triangle_at(place);
        let ray = &rays[index];
        (self.indices[lane], self.places[lane], self.triangles[lane]) = (index, place, triangle);
        for axis in 0..3 {
            self.origin[axis].as_mut_array()[lane] = ray.origin[axis];
            self.direction[axis].as_mut_array()[lane] = ray.direction[axis];
            for (row, corner) in self.corners.iter_mut().zip(&corners) {
                row[axis].as_mut_array()[lane] = corner[axis];
            }
        }
        self.count += 1;
        if self.count == GROUP {
            self.answer(hierarchy, rays, answers);
        }
    }

    /// Answers the rays that are here.
    #[inline(never)]
    pub(super) fn answer(
        &mut self,
        hierarchy: &Hierarchy,
        rays: &[Ray<Vec3>],
        answers: &mut [Option<Found>],
    ) {
        let wide = |row: [f32x8; 3]| [widened(row[0]), widened(row[1]), widened(row[2])];
        let [a, b, c] = self.corners;
        let of = Estimate::new(
            wide(self.origin),
            wide(self.direction),
            [wide(a), wide(b), wide(c)],
        );
        let sure = are_sure(&of);
        let (early, late) = (
            (of.t - of.t_error).to_array(),
            (of.t + of.t_error).to_array(),
        );
        for lane in 0..self.count {
            let ray = &rays[self.indices[lane]];
            let is_within = early[lane] > f64::from(ray.start)
                && late[lane] <= f64::from(ray.end.unwrap_or(f32::MAX).min(f32::MAX));
            answers[self.indices[lane]] = if sure >> lane & 1 == 1 && is_within {
                #[allow(
                    clippy::cast_possible_truncation,
                    reason = "rounded once, to the nearest f32"
                )]
                let at = |row: &f64x8| row.as_array()[lane] as f32;
                Some(Found {
                    triangle: self.triangles[lane],
                    hit: FacetHit {
                        t: at(&of.t),
                        parameters: [at(&of.weights[0]), at(&of.weights[1])],
                        side: side(of.determinant.as_array()[lane]),
                    },
                })
            } else {
                hierarchy
                    .confirmed(ray, self.places[lane])
                    .as_ref()
                    .map(found)
            };
        }
        self.count = 0;
    }
}

/// A bit for each hit that is certain but for the ray's interval, and precise enough.
#[inline(always)]
fn are_sure(of: &Estimate<f64x8>) -> u32 {
    let is_inside = of.least.simd_gt(of.edge_error) | of.most.simd_lt(-of.edge_error);
    let sure = is_inside
        & of.determinant_error.simd_lt(f64x8::splat(0.5))
        & of.t_error.simd_le(of.t.abs() * LARGEST_ERROR)
        & of.weight_error.simd_le(f64x8::splat(LARGEST_ERROR));
    sure.to_bitmask()
}

#[inline(always)]
fn widened(row: f32x8) -> f64x8 {
    let [a, b, c, d, e, f, g, h] = row.to_array();
    f64x8::new([
        a.into(),
        b.into(),
        c.into(),
        d.into(),
        e.into(),
        f.into(),
        g.into(),
        h.into(),
    ])
}
