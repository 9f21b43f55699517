//! What waits to be visited.

use wide::{f32x8, u32x8};

use super::Hierarchy;
use super::build::DEEPEST_BY_COST;
use super::node::Child;
use super::order::in_order;

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

    /// What waits in a place.
    #[inline(always)]
    pub(super) fn child(&self, place: usize) -> Child {
        Child(self.children[place % SIZE])
    }

    /// Where the ray enters it.
    #[inline(always)]
    pub(super) fn distance(&self, place: usize) -> f32 {
        f32::from_bits(self.distances[place % SIZE])
    }

    /// Leaves out what is behind `end`, of the first `count` entries; says how many stay. Without a branch for each.
    #[inline(always)]
    pub(super) fn keep_before(&mut self, count: usize, end: f32) -> usize {
        let (mut read, mut kept) = (0, 0);
        while read < count {
            let (distances, children) = self.read(read);
            let is_there = (1_u32 << (count - read).min(8)) - 1;
            let stays = f32x8::from_bits(distances)
                .simd_le(f32x8::splat(end))
                .to_bitmask()
                & is_there;
            // For the octant of three negative signs, lanes keep their order.
            let order = in_order(7, stays);
            self.write(
                kept,
                distances.shuffle_wrapping(order),
                children.shuffle_wrapping(order),
            );
            kept += stays.count_ones() as usize;
            read += 8;
        }
        kept
    }

    #[inline(always)]
    fn read(&self, place: usize) -> (u32x8, u32x8) {
        let places = place.min(SIZE - 8)..place.min(SIZE - 8) + 8;
        let eight = |row: &[u32]| u32x8::new(row.try_into().unwrap_or([0; 8]));
        (
            eight(&self.distances[places.clone()]),
            eight(&self.children[places]),
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
