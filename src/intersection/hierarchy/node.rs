//! What a ray walks through: nodes of eight boxes, and leaves of up to eight triangles that share up to eight corners.

use glam::Vec3;
use wide::{f32x8, u32x8};

use super::collapse::WIDTH;

/// A node: the boxes of its children, lane by lane.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(256))]
pub(super) struct Node {
    /// Low x, y, z, then high x, y, z.
    pub(super) planes: [f32x8; 6],
    /// References, each a [`Child`].
    pub(super) children: u32x8,
    /// A bit for each lane that has a child.
    pub(super) taken: u32,
}

impl Node {
    pub(super) fn child(&self, lane: usize) -> Child {
        Child(self.children.as_array()[lane])
    }

    /// The children that there are, with their boxes.
    pub(super) const EMPTY: Self = Self {
        planes: [f32x8::ZERO; 6],
        children: u32x8::ZERO,
        taken: 0,
    };

    /// Puts a child with its box into a lane.
    pub(super) fn set(&mut self, lane: usize, child: Child, [low, high]: [Vec3; 2]) {
        for axis in 0..3 {
            self.planes[axis].as_mut_array()[lane] = low[axis];
            self.planes[axis + 3].as_mut_array()[lane] = high[axis];
        }
        self.children.as_mut_array()[lane] = child.0;
        self.taken |= 1 << lane;
    }

    /// The children that there are, with their boxes.
    pub(super) fn boxes(&self) -> impl Iterator<Item = (Child, [Vec3; 2])> {
        let lanes = (0..WIDTH).filter(|lane| self.taken >> lane & 1 == 1);
        lanes.map(|lane| {
            let plane = |index: usize| self.planes[index].as_array()[lane];
            let low = Vec3::new(plane(0), plane(1), plane(2));
            let high = Vec3::new(plane(3), plane(4), plane(5));
            (self.child(lane), [low, high])
        })
    }
}

/// A reference to a node or, with the highest bit set, to a leaf; the three bits below say how many triangles the leaf has, less one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Child(pub(super) u32);

impl Child {
    pub(super) const ROOT: Self = Self(0);

    /// What is below everything that waits: a leaf that does not exist.
    pub(super) const END: Self = Self(u32::MAX);

    const LEAF: u32 = 1 << 31;
    const COUNT_SHIFT: u32 = 28;

    pub(super) fn node(index: usize) -> Self {
        Self(number(index))
    }

    pub(super) fn leaf(index: usize, count: usize) -> Self {
        Self(Self::LEAF | number(count - 1) << Self::COUNT_SHIFT | number(index))
    }

    #[inline]
    pub(super) fn is_leaf(self) -> bool {
        self.0 & Self::LEAF != 0
    }

    /// Which node or leaf.
    #[inline]
    pub(super) fn index(self) -> usize {
        (self.0 & ((1 << Self::COUNT_SHIFT) - 1)) as usize
    }

    /// A bit for each triangle of a leaf.
    #[inline]
    pub(super) fn lanes(self) -> u32 {
        0xff >> (7 - (self.0 >> Self::COUNT_SHIFT & 7))
    }
}

/// A leaf: a patch of triangles, as corners and, lane by lane, which three of them each triangle has. Two cache lines.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(128))]
pub(super) struct Leaf {
    /// The corners' x, y, z.
    pub(super) corners: [f32x8; 3],
    /// For each triangle its first, second and third corner.
    pub(super) indices: [[u8; WIDTH]; 3],
    /// The longest side of the leaf's box, rounded up.
    pub(super) size: f32,
    /// The place of its first triangle in the order of the leaves; above its 28 bits, how many corners there are, less one.
    pub(super) first: u32,
}

impl Leaf {
    /// The place of its first triangle in the order of the leaves.
    #[inline(always)]
    pub(super) fn first(&self) -> usize {
        self.first as usize & 0xfff_ffff
    }

    #[inline(always)]
    pub(super) fn corner_count(&self) -> usize {
        (self.first >> 28) as usize + 1
    }

    /// Which corners the triangle in this lane has.
    #[inline(always)]
    pub(super) fn corners_of(&self, lane: usize) -> [usize; 3] {
        let at = |corner: usize| self.indices[corner][lane % WIDTH] as usize % WIDTH;
        [at(0), at(1), at(2)]
    }

    /// The corners of the triangle in this lane.
    #[inline(always)]
    pub(super) fn triangle(&self, lane: usize) -> [Vec3; 3] {
        let [x, y, z] = [
            self.corners[0].as_array(),
            self.corners[1].as_array(),
            self.corners[2].as_array(),
        ];
        let at = |corner: usize| {
            let index = self.indices[corner][lane % WIDTH] as usize % WIDTH;
            Vec3::new(x[index], y[index], z[index])
        };
        [at(0), at(1), at(2)]
    }
}

/// The tree that a ray walks through.
#[derive(Clone, Debug, Default)]
pub(super) struct Tree {
    /// The root first; none over no triangles.
    pub(super) nodes: Vec<Node>,
    pub(super) leaves: Vec<Leaf>,
    /// The triangles in the order of the leaves.
    pub(super) order: Vec<u32>,
}

impl Tree {
    /// The mean size of a leaf.
    pub(super) fn grain(&self) -> f32 {
        let sizes = self.leaves.iter().map(|leaf| leaf.size);
        sizes.sum::<f32>() / self.leaves.len().max(1) as f32
    }
}

#[allow(
    clippy::cast_possible_truncation,
    reason = "below Hierarchy::MOST_TRIANGLES, which is below 2^28"
)]
pub(super) fn number(index: usize) -> u32 {
    index as u32
}
