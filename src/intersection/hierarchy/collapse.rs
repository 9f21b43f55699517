//! From the binary tree to nodes of eight children: which subtrees become children, and which become leaves, so that a ray does the least work.
//!
//! ```text
//! C(n, 1) = min( A(n) c(leaf) if n fits into a leaf,  A(n) c(node) + D(n, 8) )
//! D(n, i) = min over 0 < k < i of C(left, k) + C(right, i − k)
//! C(n, i) = min( C(n, i − 1), D(n, i) )
//! ```
//!
//! `C(n, i)` is the least cost of the subtree n as at most i children of one node; A is the box's surface area.
//!
//! # Sources
//!
//! H. Ylitie, T. Karras, S. Laine, *Efficient incoherent ray traversal on GPUs through compressed wide BVHs*, 2017, section 3.

use glam::Vec3;
use wide::u32x8;

use super::bounds::Bounds;

/// How many children a node has, and how many triangles and corners a leaf.
pub(super) const WIDTH: usize = 8;

/// The work of a node, which tests eight boxes.
const NODE_COST: f32 = 1.0;

/// The work of a leaf, which tests eight triangles, in that of a node: measured.
const LEAF_COST: f32 = 1.0;

/// How a subtree becomes children: for each number of children from 2 to 8, how many of them go to the left child, in three bits; 0 where one
/// child fewer is as good. The highest bit is set where the subtree as one child is a leaf.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Choices(u32);

impl Choices {
    pub(super) const NONE: Self = Self(0);

    /// A leaf that nothing is gained by splitting.
    pub(super) const ONLY_A_LEAF: Self = Self(Self::LEAF);

    const LEAF: u32 = 1 << 31;

    pub(super) fn is_leaf(self) -> bool {
        self.0 & Self::LEAF != 0
    }

    /// How many of `children` go to the left child; 0 where one fewer is as good.
    pub(super) fn to_the_left(self, children: usize) -> usize {
        (self.0 >> (3 * (children - 2))) as usize & 7
    }
}

/// What is known of a subtree that has been built.
#[derive(Clone, Copy, Debug)]
pub(super) struct Subtree {
    pub(super) bounds: Bounds,
    costs: Costs,
    corners: Corners,
}

impl Subtree {
    /// A few triangles as a leaf; `None` where they have too many corners.
    pub(super) fn of_leaf<'a>(
        bounds: Bounds,
        triangles: impl Iterator<Item = &'a [Vec3; 3]>,
    ) -> Option<Self> {
        let none = Corners {
            hashes: [0; WIDTH],
            count: 0,
        };
        let corners = triangles
            .map(Corners::of_triangle)
            .fold(none, |corners, more| corners.union(&more));
        corners.fit().then(|| Self {
            bounds,
            costs: Costs([bounds.half_area() * LEAF_COST; WIDTH]),
            corners,
        })
    }

    pub(super) fn of_triangle(bounds: Bounds, corners: &[Vec3; 3]) -> Self {
        Self {
            bounds,
            costs: Costs([bounds.half_area() * LEAF_COST; WIDTH]),
            corners: Corners::of_triangle(corners),
        }
    }
}

/// `C(n, i)` in place i − 1. The last one is for no one: a subtree is one of two parts of a node, and leaves the other at least one child of the eight.
#[derive(Clone, Copy, Debug)]
pub(super) struct Costs([f32; WIDTH]);

impl Costs {
    /// The subtree over two others, with `count` triangles, and how it becomes children.
    pub(super) fn join(left: &Subtree, right: &Subtree, count: usize) -> (Subtree, Choices) {
        let bounds = left.bounds.union(right.bounds);
        let area = bounds.half_area();
        let distributed = distributed(&left.costs, &right.costs);
        let mut costs = [0.0; WIDTH];
        let mut choices = 0;
        let corners = if count <= WIDTH {
            left.corners.union(&right.corners)
        } else {
            Corners::TOO_MANY
        };
        let as_node = area * NODE_COST + distributed[WIDTH].0;
        let as_leaf = area * LEAF_COST;
        let is_leaf = corners.fit() && as_leaf <= as_node;
        costs[0] = if is_leaf { as_leaf } else { as_node };
        for children in 2..=WIDTH {
            let (least, best) = distributed[children];
            let is_better = least < costs[children - 2];
            costs[children - 1] = if is_better {
                least
            } else {
                costs[children - 2]
            };
            if is_better || children == WIDTH {
                choices |= number(best) << (3 * (children - 2));
            }
        }
        if is_leaf {
            choices |= Choices::LEAF;
        }
        let subtree = Subtree {
            bounds,
            costs: Self(costs),
            corners,
        };
        (subtree, Choices(choices))
    }
}

/// `D(n, i)` in place i, and how many children it gives to the left, for i from 2 to 8.
#[inline]
fn distributed(Costs(left): &Costs, Costs(right): &Costs) -> [(f32, usize); WIDTH + 1] {
    let mut distributed = [(0.0, 0); WIDTH + 1];
    for children in 2..=WIDTH {
        let (mut least, mut best) = (f32::INFINITY, 1);
        for k in 1..children {
            let cost = left[k - 1] + right[children - k - 1];
            if cost < least {
                (least, best) = (cost, k);
            }
        }
        distributed[children] = (least, best);
    }
    distributed
}

/// The distinct corners of a few triangles, by a hash of their coordinates: two corners that share a hash are taken for one, which
/// whoever fills the leaf will notice.
#[derive(Clone, Copy, Debug)]
struct Corners {
    hashes: [u32; WIDTH],
    /// How many there are; more than [`WIDTH`] where they do not fit.
    count: usize,
}

impl Corners {
    const TOO_MANY: Self = Self {
        hashes: [0; WIDTH],
        count: WIDTH + 1,
    };

    fn of_triangle(corners: &[Vec3; 3]) -> Self {
        let mut hashes = [0; WIDTH];
        for (hash, corner) in hashes.iter_mut().zip(corners) {
            let [x, y, z] = corner.to_array().map(f32::to_bits);
            // Odd multipliers with well-mixed bits (of the golden ratio's kind).
            *hash = x.wrapping_mul(0x9E37_79B1)
                ^ y.wrapping_mul(0x85EB_CA77).rotate_left(11)
                ^ z.wrapping_mul(0xC2B2_AE3D).rotate_left(22);
        }
        Self { hashes, count: 3 }
    }

    fn fit(&self) -> bool {
        self.count <= WIDTH
    }

    fn union(&self, other: &Self) -> Self {
        if !self.fit() || !other.fit() {
            return Self::TOO_MANY;
        }
        let mut union = *self;
        let known = u32x8::new(self.hashes);
        let valid = (1_u32 << self.count) - 1;
        for &hash in &other.hashes[..other.count] {
            let is_known = known.simd_eq(u32x8::splat(hash)).to_bitmask() & valid != 0;
            if is_known {
                continue;
            }
            if union.count == WIDTH {
                return Self::TOO_MANY;
            }
            union.hashes[union.count] = hash;
            union.count += 1;
        }
        union
    }
}

#[allow(clippy::cast_possible_truncation, reason = "at most 8")]
fn number(children: usize) -> u32 {
    children as u32
}
