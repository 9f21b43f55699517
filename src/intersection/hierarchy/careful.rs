//! The walk for rays whose size leaves the range of the fast one: in `f64`, box by box, triangle by triangle.
//!
//! # Numerics
//!
//! Differences of `f32` numbers and their products with 1 / d neither overflow nor underflow in `f64`. Three roundings make a relative error of at most
//! 3u in each plane's t, which [`WIDENING`] exceeds by far. A product 0 · ∞, of an origin in a face and a direction along it, is NaN, and the ordered
//! comparisons leave the interval as it was: the ray is within the slab.

use glam::{DVec3, Vec3};

use super::Hierarchy;
use super::confirm::{Confirmed, Line, confirm};
use super::node::{Child, Leaf};

/// By what part of itself a plane's t is widened.
const WIDENING: f64 = 16.0 * f64::EPSILON;

impl Hierarchy {
    /// The nearest hit, or any hit.
    #[cold]
    pub(super) fn walk_carefully(&self, line: &Line, any: bool) -> Option<Confirmed> {
        let scale = f64::from(self.scene.scale);
        let slabs = Slabs {
            origin: line.origin.as_dvec3() * scale,
            inverse: 1.0 / (line.direction.as_dvec3() * scale),
            start: f64::from(line.start),
        };
        let mut best: Option<Confirmed> = None;
        let mut waiting = vec![Child::ROOT];
        while let Some(next) = waiting.pop() {
            if next.is_leaf() {
                let leaf = &self.tree.leaves[next.index()];
                for hit in self.hits(line, leaf, next.lanes().count_ones()) {
                    if best.is_none_or(|best| hit.is_before(&best, line, &self.triangles)) {
                        best = Some(hit);
                    }
                }
                if any && best.is_some() {
                    return best;
                }
                continue;
            }
            let node = &self.tree.nodes[next.index()];
            let end = best.map_or(f64::from(line.end), |best| best.latest());
            let met = node.boxes().filter(|&(_, bounds)| slabs.meet(bounds, end));
            waiting.extend(met.map(|(child, _)| child));
        }
        best
    }

    fn hits(&self, line: &Line, leaf: &Leaf, count: u32) -> impl Iterator<Item = Confirmed> {
        let places = leaf.first()..leaf.first() + count as usize;
        let corners = |&triangle: &u32| confirm(line, triangle, self.triangles[triangle as usize]);
        self.tree.order[places].iter().filter_map(corners)
    }
}

struct Slabs {
    origin: DVec3,
    inverse: DVec3,
    start: f64,
}

impl Slabs {
    /// Whether the line may meet a box before `end`.
    fn meet(&self, [low, high]: [Vec3; 2], end: f64) -> bool {
        let (mut entry, mut exit) = (self.start, end);
        for axis in 0..3 {
            let (mut near, mut far) = (f64::from(low[axis]), f64::from(high[axis]));
            if self.inverse[axis].is_sign_negative() {
                std::mem::swap(&mut near, &mut far);
            }
            let at = |plane: f64| (plane - self.origin[axis]) * self.inverse[axis];
            let (near, far) = (at(near), at(far));
            // `max` and `min` leave out NaN.
            entry = entry.max(near - near.abs() * WIDENING);
            exit = exit.min(far + far.abs() * WIDENING);
        }
        entry <= exit
    }
}
