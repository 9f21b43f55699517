//! The search for the nearest hit, and for any hit.

use glam::Vec3;

use super::Hierarchy;
use super::confirm::{Confirmed, Line, confirm};
use super::leaf_test::Candidates;
use super::node::{Child, number};
use super::prepared::Prepared;
use super::stack::Stack;
use super::statistics::Observer;
use super::walk::{Place, Walk};
use crate::ray::Ray;

impl Hierarchy {
    /// The number of the triangle in a place, and its corners.
    #[inline(always)]
    pub(super) fn triangle_at(&self, place: Place) -> (u32, [Vec3; 3]) {
        let leaf = &self.tree.leaves[place.leaf as usize];
        let triangle = self.tree.order[leaf.first() + place.lane as usize];
        if !self.scene.is_scaled() {
            return (triangle, leaf.triangle(place.lane as usize));
        }
        (triangle, self.triangles[triangle as usize])
    }

    pub(super) fn confirmed(&self, line: &Ray<Vec3>, place: Place) -> Option<Confirmed> {
        let (triangle, corners) = self.triangle_at(place);
        confirm(&Line::of(line), triangle, corners)
    }

    /// The nearest hit.
    #[inline(always)]
    pub(super) fn nearest<O: Observer>(
        &self,
        line: &Ray<Vec3>,
        ray: &Prepared,
        stack: &mut Stack,
        observer: &mut O,
    ) -> Option<Confirmed> {
        let mut walk = Walk::new(*ray);
        loop {
            while !walk.current.is_leaf() {
                observer.node();
                walk.visit(&self.tree.nodes[walk.current.index()], stack);
            }
            if walk.current == Child::END {
                return self.outcome(line, &walk);
            }
            observer.leaf(walk.current.lanes().count_ones());
            self.visit_leaf(line, &mut walk, stack);
        }
    }

    /// What a walk that has ended has found.
    #[inline(always)]
    pub(super) fn outcome(&self, line: &Ray<Vec3>, walk: &Walk) -> Option<Confirmed> {
        if walk.place == Place::NONE {
            return None;
        }
        self.confirmed(line, walk.place)
    }

    #[inline(always)]
    pub(super) fn visit_leaf(&self, line: &Ray<Vec3>, walk: &mut Walk, stack: &mut Stack) {
        let leaf = walk.current.index();
        let candidates = walk.candidates(&self.tree.leaves[leaf], stack);
        if candidates.possible != 0 {
            self.take(line, number(leaf), &candidates, walk);
            walk.cull(stack);
        }
        walk.pop(stack);
    }

    /// Takes the nearest of a leaf's candidates, if it is nearer than the nearest so far.
    #[inline(always)]
    fn take(&self, line: &Ray<Vec3>, leaf: u32, candidates: &Candidates, walk: &mut Walk) {
        let mut lanes = candidates.possible;
        while lanes != 0 {
            let lane = lanes.trailing_zeros();
            lanes &= lanes - 1;
            let place = Place { leaf, lane };
            let low = candidates.low.as_array()[lane as usize & 7];
            let high = candidates.high.as_array()[lane as usize & 7];
            let is_certain = candidates.certain >> lane & 1 == 1;
            if is_certain && high < walk.low && low > walk.ray.start[1] {
                (walk.low, walk.high, walk.place) = (low, high, place);
            } else if !is_certain || low <= walk.high {
                self.settle(line, place, walk);
            }
        }
    }

    /// Decides between the nearest so far and another, exactly.
    #[cold]
    #[inline(never)]
    fn settle(&self, line: &Ray<Vec3>, place: Place, walk: &mut Walk) {
        if let Some([low, high]) = self.nearer(line, walk.place, [walk.low, walk.high], place) {
            (walk.low, walk.high, walk.place) = (low, high, place);
        }
    }

    /// Between which bounds s is at another triangle, if it is hit before the one that was the nearest; `known` are the bounds of that.
    #[cold]
    pub(super) fn nearer(
        &self,
        line: &Ray<Vec3>,
        nearest: Place,
        known: [f32; 2],
        other: Place,
    ) -> Option<[f32; 2]> {
        let hit = self.confirmed(line, other)?;
        if nearest != Place::NONE
            && let Some(nearest) = self.confirmed(line, nearest)
            && !hit.is_before(&nearest, &Line::of(line), &self.triangles)
        {
            return None;
        }
        let unit = Prepared::unit_of(line, self.scene.scale);
        #[allow(clippy::cast_possible_truncation, reason = "widened by a rounding")]
        let (low, high) = ((hit.earliest() * unit) as f32, (hit.latest() * unit) as f32);
        Some([low.next_down().min(known[0]), high.next_up().min(known[1])])
    }

    /// Whether anything is hit.
    #[inline(always)]
    pub(super) fn any(&self, line: &Ray<Vec3>, ray: &Prepared, stack: &mut Stack) -> bool {
        let mut walk = Walk::new(*ray);
        loop {
            while !walk.current.is_leaf() {
                walk.visit(&self.tree.nodes[walk.current.index()], stack);
            }
            if walk.current == Child::END {
                return false;
            }
            if self.visit_leaf_for_any(line, &mut walk, stack) {
                return true;
            }
        }
    }

    /// Visits a leaf on the way to any hit, and says whether it has one.
    #[inline(always)]
    pub(super) fn visit_leaf_for_any(
        &self,
        line: &Ray<Vec3>,
        walk: &mut Walk,
        stack: &Stack,
    ) -> bool {
        let leaf = walk.current.index();
        let candidates = walk.candidates(&self.tree.leaves[leaf], stack);
        if candidates.possible != 0 && self.is_any_hit(line, number(leaf), walk, &candidates) {
            return true;
        }
        walk.pop(stack);
        false
    }

    #[inline(always)]
    fn is_any_hit(
        &self,
        line: &Ray<Vec3>,
        leaf: u32,
        walk: &Walk,
        candidates: &Candidates,
    ) -> bool {
        let mut lanes = candidates.possible;
        while lanes != 0 {
            let lane = lanes.trailing_zeros();
            lanes &= lanes - 1;
            let low = candidates.low.as_array()[lane as usize & 7];
            let high = candidates.high.as_array()[lane as usize & 7];
            let is_certain = candidates.certain >> lane & 1 == 1;
            let is_inside = is_certain && high < walk.low && low > walk.ray.start[1];
            if is_inside || self.confirmed(line, Place { leaf, lane }).is_some() {
                return true;
            }
        }
        false
    }
}
