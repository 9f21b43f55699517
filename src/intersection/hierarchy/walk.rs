//! A ray on its way down the tree.

use super::leaf_test::Candidates;
use super::node::{Child, Leaf, Node, number};
use super::order::in_order;
use super::prepared::Prepared;
use super::stack::Stack;

/// The place of a triangle in the tree: its leaf, and its lane there.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Place {
    pub(super) leaf: u32,
    pub(super) lane: u32,
}

impl Place {
    /// Of no triangle.
    pub(super) const NONE: Self = Self {
        leaf: u32::MAX,
        lane: 0,
    };
}

/// A ray on its way, and the nearest triangle so far.
#[derive(Clone, Copy, Debug)]
pub(super) struct Walk {
    pub(super) ray: Prepared,
    /// Between which bounds the nearest triangle's s is; at first those of the end of the ray's interval.
    pub(super) low: f32,
    pub(super) high: f32,
    /// Where it is.
    pub(super) place: Place,
    /// Where the ray is, or [`Child::END`].
    pub(super) current: Child,
    /// How many boxes wait.
    top: u32,
}

impl Walk {
    #[inline(always)]
    pub(super) fn new(ray: Prepared) -> Self {
        Self {
            ray,
            low: ray.end[0],
            high: ray.end[1],
            place: Place::NONE,
            current: Child::ROOT,
            top: 1,
        }
    }

    /// Goes on to the next box that waits. All that wait are before the nearest triangle.
    #[inline(always)]
    pub(super) fn pop(&mut self, stack: &Stack) {
        self.top -= 1;
        self.current = stack.child(self.top as usize);
    }

    // ANCHOR: visit
    /// Visits a node: its children that are met wait, and the walk goes on to the first of all that wait.
    #[inline(always)]
    pub(super) fn visit(&mut self, node: &Node, stack: &mut Stack) {
        let (entries, exits) = self.ray.slabs(&node.planes, self.high);
        let hits = entries.simd_le(exits).to_bitmask() & node.taken;
        let order = in_order(self.ray.octant, hits);
        stack.write(
            self.top as usize,
            entries.to_bits().shuffle_wrapping(order),
            node.children.shuffle_wrapping(order),
        );
        self.top += hits.count_ones();
        self.pop(stack);
    }
    // ANCHOR_END: visit

    /// The triangles of the current leaf that the ray may meet.
    #[inline(always)]
    pub(super) fn candidates(&self, leaf: &Leaf, stack: &Stack) -> Candidates {
        // What was taken from the stack is still there.
        let distance = stack.distance(self.top as usize);
        self.ray
            .candidates(leaf, self.current.lanes(), distance, self.high)
    }

    /// Leaves out what waits behind the nearest triangle.
    #[inline(always)]
    pub(super) fn cull(&mut self, stack: &mut Stack) {
        self.top = number(stack.keep_before(self.top as usize, self.high));
    }
}
