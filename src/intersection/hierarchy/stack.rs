//! What waits to be visited.

use wide::u32x8;

use super::node::Child;

/// More than the tree is deep, times the children that wait at each level, and eight more.
const SIZE: usize = 1024;

/// Boxes that are still to be visited: where the ray enters each, as the bits of a number that is not negative, and which it is.
#[derive(Clone, Debug)]
pub(super) struct Stack {
    distances: [u32; SIZE],
    children: [u32; SIZE],
}

impl Stack {
    /// A stack that ends with [`Child::END`], which is never left out.
    pub(super) fn new() -> Box<Self> {
        Box::new(Self {
            distances: [0; SIZE],
            children: [Child::END.0; SIZE],
        })
    }

    #[inline(always)]
    pub(super) fn at(&self, place: usize) -> (f32, Child) {
        (
            f32::from_bits(self.distances[place % SIZE]),
            Child(self.children[place % SIZE]),
        )
    }

    /// Writes eight entries from `top` on, of which the caller counts those that matter.
    #[inline(always)]
    pub(super) fn write(&mut self, top: usize, distances: u32x8, children: u32x8) {
        // No tree is so deep that this is not there.
        if let (Some(near), Some(child)) = (
            self.distances[top..].first_chunk_mut(),
            self.children[top..].first_chunk_mut(),
        ) {
            *near = distances.to_array();
            *child = children.to_array();
        }
    }
}
