//! What waits to be visited.

use wide::u32x8;

use super::Hierarchy;
use super::build::DEEPEST_BY_COST;
use super::node::Child;

/// More than can wait: seven children at each level, and the eight that are written at once.
const SIZE: usize = 1024;

/// A tree is cut by cost to this depth, then into halves of at most `2^28` triangles; a level more for a root of a few.
const DEEPEST: usize = DEEPEST_BY_COST as usize + Hierarchy::MOST_TRIANGLES.ilog2() as usize + 1;

const _: () = assert!(DEEPEST * 7 + 8 <= SIZE, "the stack holds what may wait");

/// Boxes that are still to be visited: where the ray enters each, as the bits of a number that is not negative, and which it is.
#[derive(Clone, Debug)]
#[repr(C)]
pub(super) struct Stack {
    distances: [u32; SIZE],
    /// Keeps the two apart by other than a power of two, so that their places do not share a set of the cache.
    _apart: [u32; 48],
    children: [u32; SIZE],
}

impl Stack {
    /// A stack that ends with [`Child::END`], which is never left out.
    pub(super) fn new() -> Box<Self> {
        Box::new(Self {
            distances: [0; SIZE],
            _apart: [0; 48],
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
        // No tree is so deep that the minimum matters: it tells the compiler that the slices are there.
        let places = top.min(SIZE - 8)..top.min(SIZE - 8) + 8;
        self.distances[places.clone()].copy_from_slice(distances.as_array());
        self.children[places].copy_from_slice(children.as_array());
    }
}
