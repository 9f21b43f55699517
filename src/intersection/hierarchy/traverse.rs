//! The walk down the tree: nearest boxes first, and what is behind the nearest hit is left out.

use glam::Vec3;
use wide::{f32x8, u32x8};

use super::Hierarchy;
use super::confirm::{Confirmed, Line, confirm};
use super::node::{Child, Leaf, Node};
use super::order::LANES;
use super::prepared::Prepared;
use super::stack::Stack;
use super::statistics::Observer;

/// The lanes' numbers.
const LANE_NUMBERS: u32x8 = u32x8::new([0, 1, 2, 3, 4, 5, 6, 7]);

/// Which triangles of a leaf the line may meet, and what is known of where.
pub(super) struct Candidates {
    /// A bit for each triangle that may be met.
    pub(super) possible: u32,
    /// A bit for each that is met, if in the ray's interval.
    pub(super) certain: u32,
    /// For those: between which bounds s is.
    pub(super) low: [f32; 8],
    pub(super) high: [f32; 8],
}

#[inline(always)]
fn lanes_of(bytes: &[u8; 8]) -> u32x8 {
    let [a, b, c, d, e, f, g, h] = *bytes;
    u32x8::new([
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

impl Prepared {
    /// Eight triangles at once.
    #[inline(always)]
    pub(super) fn candidates(&self, leaf: &Leaf, lanes: u32) -> Option<Candidates> {
        let [x, y, z] = self.axes;
        let [ox, oy, oz] = self.origin;
        let [sx, sy] = self.shear;
        let pz = leaf.corners[z] - f32x8::splat(oz);
        let px = pz.mul_neg_add(f32x8::splat(sx), leaf.corners[x] - f32x8::splat(ox));
        let py = pz.mul_neg_add(f32x8::splat(sy), leaf.corners[y] - f32x8::splat(oy));
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
        let margin = self.edge_margin * (leaf.size + self.slack);
        let m = f32x8::splat(margin);
        let possible = (least.simd_ge(-m) | most.simd_le(m)).to_bitmask() & lanes;
        if possible == 0 {
            return None;
        }
        let certain = (least.simd_gt(m) | most.simd_lt(-m)).to_bitmask() & lanes;
        let (az, bz, cz) = (at(pz, a), at(pz, b), at(pz, c));
        let reciprocal = f32x8::ONE / (u + v + w);
        let s = (u * az + v * bz + w * cz) * (reciprocal * f32x8::splat(self.sign));
        let error = reciprocal.abs().mul_add(
            f32x8::splat(3.0 * margin * leaf.size),
            f32x8::splat(self.distance_error),
        );
        Some(Candidates {
            possible,
            certain,
            low: (s - error).to_array(),
            high: (s + error).to_array(),
        })
    }
}

/// The nearest triangle so far.
#[derive(Clone, Copy, Debug)]
pub(super) struct Best {
    /// Between these is its s; at first the bounds of the end of the ray's interval.
    pub(super) low: f32,
    pub(super) high: f32,
    /// Where it is: leaf and lane; no such leaf at first.
    place: (u32, u32),
    confirmed: Option<Confirmed>,
}

impl Best {
    /// Nothing yet.
    #[inline(always)]
    fn none(ray: &Prepared) -> Self {
        Self {
            low: ray.end.low,
            high: ray.end.high,
            place: (u32::MAX, 0),
            confirmed: None,
        }
    }
}

/// A ray on its way through the tree.
#[derive(Clone, Copy, Debug)]
pub(super) struct Walk {
    pub(super) ray: Prepared,
    pub(super) best: Best,
    /// Where it is, or [`Child::END`].
    pub(super) current: Child,
    /// How many boxes wait.
    top: usize,
}

impl Walk {
    #[inline(always)]
    pub(super) fn new(ray: Prepared) -> Self {
        Self {
            best: Best::none(&ray),
            ray,
            current: Child::ROOT,
            top: 1,
        }
    }

    /// Goes on to the next box that waits and is not behind the nearest hit.
    #[inline(always)]
    pub(super) fn pop(&mut self, stack: &Stack) {
        loop {
            self.top -= 1;
            let (distance, child) = stack.at(self.top);
            if distance <= self.best.high {
                self.current = child;
                return;
            }
        }
    }

    /// Visits a node: goes on to its nearest child, and lets the others wait; or to what waits already.
    #[inline(always)]
    pub(super) fn visit(&mut self, node: &Node, stack: &mut Stack) {
        let (entries, exits) = self
            .ray
            .slabs(&node.planes, self.ray.start.low, self.best.high);
        let is_missed = entries.simd_gt(exits);
        let keys = (entries.to_bits() & !7 | LANE_NUMBERS) | is_missed.to_bits();
        let hits = !is_missed.to_bitmask() & 0xff;
        let nearest = keys.reduce_min() as usize & 7;
        let others = hits & !(1 << nearest);
        let order = lanes_of(&LANES[self.ray.octant & 7][others as usize & 0xff]);
        let (distance, waiting) = stack.at(self.top - 1);
        let children = u32x8::new(node.children.map(|child| child.0));
        stack.write(
            self.top,
            entries.to_bits().shuffle_wrapping(order),
            children.shuffle_wrapping(order),
        );
        let is_empty = hits == 0;
        self.current = if is_empty {
            waiting
        } else {
            node.children[nearest]
        };
        self.top = self.top + others.count_ones() as usize - usize::from(is_empty);
        if is_empty && distance > self.best.high {
            self.pop(stack);
        }
    }

    /// Visits a node on the way to any hit: all children are as good.
    #[inline(always)]
    pub(super) fn visit_for_any(&mut self, node: &Node, stack: &mut Stack) {
        let (entries, exits) = self
            .ray
            .slabs(&node.planes, self.ray.start.low, self.best.high);
        let hits = entries.simd_le(exits).to_bitmask();
        let order = lanes_of(&LANES[self.ray.octant & 7][hits as usize & 0xff]);
        let children = u32x8::new(node.children.map(|child| child.0));
        stack.write(self.top, u32x8::ZERO, children.shuffle_wrapping(order));
        self.top = self.top + hits.count_ones() as usize - 1;
        self.current = stack.at(self.top).1;
    }
}

impl Hierarchy {
    /// The triangle's number and its corners.
    #[inline(always)]
    fn at(&self, (leaf, lane): (u32, u32)) -> (u32, [Vec3; 3]) {
        let leaf = &self.tree.leaves[leaf as usize];
        let triangle = self.tree.order[(leaf.first + lane) as usize];
        if self.scale == 1.0 {
            return (triangle, leaf.triangle(lane as usize));
        }
        (triangle, self.triangles[triangle as usize])
    }

    #[inline(always)]
    fn confirmed(&self, line: &Line, place: (u32, u32)) -> Option<Confirmed> {
        let (triangle, corners) = self.at(place);
        confirm(line, triangle, corners)
    }

    /// The nearest hit.
    #[inline(always)]
    pub(super) fn nearest<O: Observer>(
        &self,
        line: &Line,
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
    pub(super) fn outcome(&self, line: &Line, walk: &Walk) -> Option<Confirmed> {
        if walk.best.place.0 == u32::MAX {
            return None;
        }
        walk.best
            .confirmed
            .or_else(|| self.confirmed(line, walk.best.place))
    }

    #[inline(always)]
    pub(super) fn visit_leaf(&self, line: &Line, walk: &mut Walk, stack: &Stack) {
        let index = walk.current.index();
        if let Some(candidates) = walk
            .ray
            .candidates(&self.tree.leaves[index], walk.current.lanes())
        {
            self.take(line, index, &candidates, walk);
        }
        walk.pop(stack);
    }

    /// Takes the nearest of a leaf's candidates, if it is nearer than the best one.
    #[inline(always)]
    fn take(&self, line: &Line, leaf: usize, candidates: &Candidates, walk: &mut Walk) {
        let leaf = leaf as u32;
        let mut lanes = candidates.possible;
        while lanes != 0 {
            let lane = lanes.trailing_zeros();
            lanes &= lanes - 1;
            let (low, high) = (
                candidates.low[lane as usize & 7],
                candidates.high[lane as usize & 7],
            );
            let is_certain = candidates.certain >> lane & 1 == 1;
            if is_certain && (low > walk.best.high || high < walk.ray.start.low) {
                continue;
            }
            if is_certain && high < walk.best.low && low > walk.ray.start.high {
                walk.best = Best {
                    low,
                    high,
                    place: (leaf, lane),
                    confirmed: None,
                };
                continue;
            }
            self.settle(line, (leaf, lane), walk);
        }
    }

    /// Decides between the best one and another exactly.
    #[cold]
    #[inline(never)]
    fn settle(&self, line: &Line, place: (u32, u32), walk: &mut Walk) {
        let Some(hit) = self.confirmed(line, place) else {
            return;
        };
        let best = &mut walk.best;
        if best.confirmed.is_none() && best.place.0 != u32::MAX {
            best.confirmed = self.confirmed(line, best.place);
        }
        if let Some(other) = best.confirmed
            && !hit.is_before(&other, line, &self.triangles)
        {
            return;
        }
        let [low, high] = walk.ray.distances(&hit, line, self.scale);
        *best = Best {
            low: low.min(best.low),
            high: high.min(best.high),
            place,
            confirmed: Some(hit),
        };
    }

    /// Whether anything is hit.
    #[inline(always)]
    pub(super) fn any(&self, line: &Line, ray: &Prepared, stack: &mut Stack) -> bool {
        let mut walk = Walk::new(*ray);
        loop {
            while !walk.current.is_leaf() {
                walk.visit_for_any(&self.tree.nodes[walk.current.index()], stack);
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
    pub(super) fn visit_leaf_for_any(&self, line: &Line, walk: &mut Walk, stack: &Stack) -> bool {
        let index = walk.current.index();
        if let Some(candidates) = walk
            .ray
            .candidates(&self.tree.leaves[index], walk.current.lanes())
            && self.is_any_hit(line, &walk.ray, index, &candidates)
        {
            return true;
        }
        walk.pop(stack);
        false
    }

    #[inline(always)]
    fn is_any_hit(
        &self,
        line: &Line,
        ray: &Prepared,
        leaf: usize,
        candidates: &Candidates,
    ) -> bool {
        let mut lanes = candidates.possible;
        while lanes != 0 {
            let lane = lanes.trailing_zeros();
            lanes &= lanes - 1;
            let (low, high) = (
                candidates.low[lane as usize & 7],
                candidates.high[lane as usize & 7],
            );
            if candidates.certain >> lane & 1 == 1 {
                if low > ray.end.high || high < ray.start.low {
                    continue;
                }
                if high < ray.end.low && low > ray.start.high {
                    return true;
                }
            }
            if self.confirmed(line, (leaf as u32, lane)).is_some() {
                return true;
            }
        }
        false
    }
}

impl Prepared {
    /// Between which bounds s is for a confirmed hit.
    fn distances(&self, hit: &Confirmed, line: &Line, scale: f32) -> [f32; 2] {
        let unit = f64::from(line.direction.abs().max_element()) * f64::from(scale);
        #[allow(clippy::cast_possible_truncation, reason = "widened by a rounding")]
        let (low, high) = ((hit.earliest() * unit) as f32, (hit.latest() * unit) as f32);
        [low.next_down(), high.next_up()]
    }
}
