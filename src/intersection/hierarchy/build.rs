//! The binary tree: triangles split in two, again and again, where the surface area heuristic expects the least work.
//!
//! ```text
//! cost of a split = A(left) ⌈n(left) / 6⌉ + A(right) ⌈n(right) / 6⌉
//! ```
//!
//! A leaf is tested in one go, however many triangles it has; about six of them have the eight corners that fit.
//!
//! The cuts that are tried lie between bins along each axis. A group of a few triangles is sorted along the longest axis, and every cut tried.
//!
//! # Conventions
//!
//! A tree over n triangles has n − 1 inner nodes, in depth-first order: the left child's subtree follows its parent, then comes the right one's. So
//! every subtree is a slice whose length is known beforehand: threads share nothing, and the tree does not depend on how many there are.
//!
//! # Sources
//!
//! I. Wald, *On fast construction of SAH-based bounding volume hierarchies*, 2007, section 3 (bins).

use glam::Vec3;
use wide::f32x8;

use super::bounds::Bounds;
use super::collapse::{Choices, Costs, Subtree};

/// How many bins each axis is cut into at most.
const MOST_BINS: usize = 16;

/// Up to so many triangles are sorted instead.
const SORTED: usize = 5;

/// How many triangles of a mesh have eight corners, more or less.
const IN_A_LEAF: usize = 6;

/// Up to so many triangles make a leaf without further question, if their corners fit.
const ATOMIC: usize = 6;

/// Above so many triangles the two halves are built at the same time.
const PARALLEL: usize = 4096;

/// From this depth on, groups are cut into halves by number: so the depth is at most this and the logarithm of the count.
pub(super) const DEEPEST_BY_COST: u32 = 40;

/// A triangle while the tree is built: its box, with its number in the bits of the first spare lane.
#[derive(Clone, Copy, Debug)]
pub(super) struct Primitive(f32x8);

impl Primitive {
    pub(super) fn new(triangle: u32, corners: [Vec3; 3], is_rounded: bool) -> Self {
        let mut lanes = Bounds::of_points(&corners).0.to_array();
        if is_rounded {
            lanes = lanes.map(f32::next_down);
        }
        lanes[3] = f32::from_bits(triangle);
        Self(f32x8::new(lanes))
    }

    #[inline]
    pub(super) fn bounds(&self) -> Bounds {
        Bounds(self.0)
    }

    #[inline]
    pub(super) fn triangle(&self) -> u32 {
        self.0.as_array()[3].to_bits()
    }

    /// Twice the centre of the box along an axis.
    #[inline]
    fn centre_along(&self, axis: usize) -> f32 {
        let lanes = self.0.as_array();
        lanes[axis] - lanes[axis + 4]
    }

    /// Twice the centre of the box.
    #[inline]
    fn centre(&self) -> Vec3 {
        let [x, y, z, _, p, q, r, _] = self.0.to_array();
        Vec3::new(x - p, y - q, z - r)
    }
}

/// An inner node of the binary tree.
#[derive(Clone, Copy, Debug)]
pub(super) struct BinaryNode {
    /// `[low, high]`.
    bounds: [[f32; 3]; 2],
    /// How many of them are in the left child.
    pub(super) left: u32,
    /// How the subtree becomes children of a wide node.
    pub(super) choices: Choices,
}

impl BinaryNode {
    pub(super) const NONE: Self = Self {
        bounds: [[0.0; 3]; 2],
        left: 0,
        choices: Choices::NONE,
    };

    pub(super) fn low(&self) -> Vec3 {
        self.bounds[0].into()
    }

    pub(super) fn high(&self) -> Vec3 {
        self.bounds[1].into()
    }
}

/// Where the triangles are, for [`build`].
pub(super) struct Builder<'a> {
    /// The triangles, in the units of the tree.
    pub(super) triangles: &'a [[Vec3; 3]],
}

impl Builder<'_> {
    /// Sorts the primitives into the order of the leaves, and fills the nodes of their subtree: one fewer than there are primitives.
    pub(super) fn build(
        &self,
        primitives: &mut [Primitive],
        nodes: &mut [BinaryNode],
        depth: u32,
    ) -> Subtree {
        if let [primitive] = primitives {
            return Subtree::of_triangle(
                primitive.bounds(),
                &self.triangles[primitive.triangle() as usize],
            );
        }
        let count = primitives.len();
        if count <= ATOMIC
            && let Some(subtree) = self.leaf(primitives)
        {
            nodes[0] = BinaryNode {
                bounds: [subtree.bounds.low().into(), subtree.bounds.high().into()],
                left: 1,
                choices: Choices::ONLY_A_LEAF,
            };
            return subtree;
        }
        let left = split(primitives, depth);
        let (left_primitives, right_primitives) = primitives.split_at_mut(left);
        let (node, rest) = nodes
            .split_first_mut()
            .expect("an inner node for two primitives or more");
        let (left_nodes, right_nodes) = rest.split_at_mut(left - 1);
        let mut build_left = || self.build(left_primitives, left_nodes, depth + 1);
        let mut build_right = || self.build(right_primitives, right_nodes, depth + 1);
        let (first, second) = if count > PARALLEL {
            rayon::join(build_left, build_right)
        } else {
            (build_left(), build_right())
        };
        let (subtree, choices) = Costs::join(&first, &second, count);
        *node = BinaryNode {
            bounds: [subtree.bounds.low().into(), subtree.bounds.high().into()],
            left: number(left),
            choices,
        };
        subtree
    }

    /// The leaf of a few triangles; `None` where they have too many corners.
    fn leaf(&self, primitives: &[Primitive]) -> Option<Subtree> {
        let bounds = primitives
            .iter()
            .map(Primitive::bounds)
            .fold(Bounds::EMPTY, Bounds::union);
        let triangles = primitives
            .iter()
            .map(|primitive| &self.triangles[primitive.triangle() as usize]);
        Subtree::of_leaf(bounds, triangles)
    }
}

/// Reorders the primitives so that the first ones belong to the left child, and says how many: at least one, and not all.
fn split(primitives: &mut [Primitive], depth: u32) -> usize {
    let count = primitives.len();
    if count == 2 {
        return 1;
    }
    let centres = primitives.iter().map(Primitive::centre);
    let (low, high) = centres.fold(
        (Vec3::INFINITY, Vec3::NEG_INFINITY),
        |(low, high), centre| (low.min(centre), high.max(centre)),
    );
    let extent = high - low;
    if depth >= DEEPEST_BY_COST || extent == Vec3::ZERO {
        return halves(primitives, extent.max_position());
    }
    if count <= SORTED {
        return sorted(primitives, extent.max_position());
    }
    let bins = Bins::new(primitives, low, extent);
    let Some((axis, bin)) = bins.best_cut() else {
        return halves(primitives, extent.max_position());
    };
    partition(primitives, |primitive| bins.bin(primitive)[axis] < bin)
}

/// Cuts by number at the median along an axis.
fn halves(primitives: &mut [Primitive], axis: usize) -> usize {
    let middle = primitives.len() / 2;
    primitives.select_nth_unstable_by(middle, |a, b| {
        let order = a.centre_along(axis).total_cmp(&b.centre_along(axis));
        order.then(a.triangle().cmp(&b.triangle()))
    });
    middle
}

/// Sorts a few primitives along an axis, and cuts where it costs least.
fn sorted(primitives: &mut [Primitive], axis: usize) -> usize {
    let count = primitives.len();
    for end in 1..count {
        let mut place = end;
        while place > 0
            && primitives[place - 1].centre_along(axis) > primitives[place].centre_along(axis)
        {
            primitives.swap(place - 1, place);
            place -= 1;
        }
    }
    let mut costs = [0.0; SORTED];
    let mut bounds = Bounds::EMPTY;
    for left in 1..count {
        bounds = bounds.union(primitives[left - 1].bounds());
        costs[left] = bounds.half_area() * leaves(left);
    }
    bounds = Bounds::EMPTY;
    let (mut best, mut least) = (count / 2, f32::INFINITY);
    for left in (1..count).rev() {
        bounds = bounds.union(primitives[left].bounds());
        let cost = costs[left] + bounds.half_area() * leaves(count - left);
        if cost < least {
            (best, least) = (left, cost);
        }
    }
    best
}

/// Moves those that belong to the left to the front, and says how many there are. Each is swapped, needed or not: which it is cannot be foretold.
fn partition(primitives: &mut [Primitive], is_left: impl Fn(&Primitive) -> bool) -> usize {
    let mut left = 0;
    for place in 0..primitives.len() {
        let primitive = primitives[place];
        primitives.swap(place, left);
        left += usize::from(is_left(&primitive));
    }
    left
}

/// The primitives of a group sorted into bins along each axis.
struct Bins {
    low: Vec3,
    scale: Vec3,
    count: usize,
    bounds: [[Bounds; MOST_BINS]; 3],
    numbers: [[u32; MOST_BINS]; 3],
}

/// Added to a number below 2¹⁴ it leaves, in the bits above the lowest eight, the number's whole part: a conversion without a branch.
const TO_BITS: f32 = 49_152.0;

/// How much of the last bin is left free, so that no rounding leads beyond it.
const ROOM: f32 = 1.0 / 128.0;

impl Bins {
    fn new(primitives: &[Primitive], low: Vec3, extent: Vec3) -> Self {
        let count = if primitives.len() < 256 { 8 } else { 16 };
        let most = count as f32 - ROOM;
        let scale = extent
            .to_array()
            .map(|extent| if extent > 0.0 { most / extent } else { 0.0 });
        let mut bins = Self {
            low,
            scale: Vec3::from_array(scale).min(Vec3::MAX),
            count,
            bounds: [[Bounds::EMPTY; MOST_BINS]; 3],
            numbers: [[0; MOST_BINS]; 3],
        };
        for primitive in primitives {
            let places = bins.bin(primitive);
            for (axis, bin) in places.into_iter().enumerate() {
                let bounds = &mut bins.bounds[axis][bin];
                *bounds = bounds.union(primitive.bounds());
                bins.numbers[axis][bin] += 1;
            }
        }
        bins
    }

    #[inline]
    fn bin(&self, primitive: &Primitive) -> [usize; 3] {
        let place = (primitive.centre() - self.low) * self.scale + TO_BITS;
        place
            .to_array()
            .map(|place| (place.to_bits() >> 8) as usize & (MOST_BINS - 1))
    }

    // ANCHOR: best_cut
    /// The axis, and the first bin of the right side, of the cut with the least cost; `None` where all are in one bin.
    fn best_cut(&self) -> Option<(usize, usize)> {
        let (mut best, mut least) = (None, f32::INFINITY);
        for axis in 0..3 {
            let (bounds, numbers) = (&self.bounds[axis], &self.numbers[axis]);
            // For each cut, named by the first bin of its right side: the sides' boxes and numbers.
            let (mut left, mut right) = ([Bounds::EMPTY; MOST_BINS], [Bounds::EMPTY; MOST_BINS]);
            let (mut left_numbers, mut right_numbers) = ([0.0; MOST_BINS], [0.0; MOST_BINS]);
            for bin in 1..self.count {
                left[bin] = left[bin - 1].union(bounds[bin - 1]);
                left_numbers[bin] = left_numbers[bin - 1] + numbers[bin - 1] as f32;
            }
            (right[self.count - 1], right_numbers[self.count - 1]) =
                (bounds[self.count - 1], numbers[self.count - 1] as f32);
            for bin in (1..self.count - 1).rev() {
                right[bin] = right[bin + 1].union(bounds[bin]);
                right_numbers[bin] = right_numbers[bin + 1] + numbers[bin] as f32;
            }
            for first in (0..self.count).step_by(LANES) {
                let costs = side_costs(&left, &left_numbers, first)
                    + side_costs(&right, &right_numbers, first);
                for (lane, &cost) in costs.as_array().iter().enumerate() {
                    if cost < least {
                        (best, least) = (Some((axis, first + lane)), cost);
                    }
                }
            }
        }
        best
    }
    // ANCHOR_END: best_cut
}

/// How many cuts are priced at once.
const LANES: usize = 8;

/// The cost of one side of eight cuts, infinite where it is empty.
#[inline(always)]
fn side_costs(bounds: &[Bounds; MOST_BINS], numbers: &[f32; MOST_BINS], first: usize) -> f32x8 {
    let at = |lane: usize| bounds[(first + lane) % MOST_BINS].0;
    let rows = f32x8::transpose([at(0), at(1), at(2), at(3), at(4), at(5), at(6), at(7)]);
    let (x, y, z) = (rows[0] + rows[4], rows[1] + rows[5], rows[2] + rows[6]);
    let area = x * y + y * z + z * x;
    let number = |lane: usize| numbers[(first + lane) % MOST_BINS];
    let numbers = f32x8::new([
        number(0),
        number(1),
        number(2),
        number(3),
        number(4),
        number(5),
        number(6),
        number(7),
    ]);
    let leaves =
        ((numbers + f32x8::splat(IN_A_LEAF as f32 - 1.0)) / f32x8::splat(IN_A_LEAF as f32)).floor();
    numbers
        .simd_gt(f32x8::ZERO)
        .select(area * leaves, f32x8::splat(f32::INFINITY))
}

/// How many leaves so many triangles take, at the least.
#[inline(always)]
fn leaves(triangles: usize) -> f32 {
    triangles.div_ceil(IN_A_LEAF) as f32
}

#[allow(
    clippy::cast_possible_truncation,
    reason = "below Hierarchy::MOST_TRIANGLES"
)]
fn number(count: usize) -> u32 {
    count as u32
}
