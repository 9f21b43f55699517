//! Eight rays that go the same way, as one: each box is tested once for all of them.
//!
//! Neighbours in a picture pass through nearly the same boxes. The packet stands for all lines that start in the box of the eight origins and
//! have slopes between those of the eight rays: interval arithmetic tells where the first of them may enter a box, and the last may leave it.
//! Eight boxes are tested at once for the packet; in a leaf, one triangle at a time is tested by the eight rays at once.
//!
//! # Numerics
//!
//! The margins are those of a single ray ([`prepared`](super::prepared)), with the largest R and q of the eight. Before a leaf's triangles are
//! tested, every ray is tested with the leaf's box: what is certain of a triangle supposes that the ray meets it.
//!
//! # Sources
//!
//! S. Boulos et al., *Packet-based Whitted and distribution ray tracing*, 2007 (interval arithmetic for packets).

use glam::Vec3;
use wide::{f32x8, u32x8};

use super::Hierarchy;
use super::node::{Child, Leaf, Node, number};
use super::order::in_order;
use super::prepared::{Columns, GROUP, Group, Scene, U};
use super::stack::Stack;
use super::walk::Place;
use crate::ray::Ray;

/// How far the rays of a packet may be apart at the far end of the scene, in leaves, for it to pay: measured.
const LARGEST_SPREAD: f32 = 8.0;

/// The lanes' numbers.
const LANE_NUMBERS: u32x8 = u32x8::new([0, 1, 2, 3, 4, 5, 6, 7]);

/// The lines that a packet stands for.
struct Beam {
    /// The planes where they enter: 0, 1, 2 for the low ones, 3, 4, 5 for the high ones.
    near: [usize; 3],
    /// The end of the origins' box from which the way there is longest, and from which the way to the far plane is.
    near_origin: [f32; 3],
    far_origin: [f32; 3],
    /// The least and the largest q.
    least: [f32; 3],
    most: [f32; 3],
    margin: [f32; 3],
    start: f32,
    octant: u32,
}

/// A packet on its way.
pub(super) struct Packet<'a> {
    group: &'a Group,
    beam: Beam,
    /// The nearest triangle of each ray so far: between which bounds its s is, and where it is.
    low: f32x8,
    high: f32x8,
    leaves: [u32; GROUP],
    lanes: [u32; GROUP],
    /// The largest of `high`.
    farthest: f32,
}

fn least(row: f32x8) -> f32 {
    row.to_array().into_iter().fold(f32::INFINITY, f32::min)
}

fn most(row: f32x8) -> f32 {
    row.to_array().into_iter().fold(f32::NEG_INFINITY, f32::max)
}

impl Beam {
    /// The lines of eight rays whose directions have the same signs, and whose origins are in a box.
    #[inline(always)]
    fn new(columns: &Columns, octant: u32, [low_origin, high_origin]: [[f32; 3]; 2]) -> Self {
        let is_backwards = |axis: usize| octant >> axis & 1 == 1;
        let pick = |low: [f32; 3], high: [f32; 3]| {
            [0, 1, 2].map(|axis| {
                if is_backwards(axis) {
                    low[axis]
                } else {
                    high[axis]
                }
            })
        };
        let [qx, qy, qz] = columns.q;
        let [wx, wy, wz] = columns.widening;
        Self {
            near: [0, 1, 2].map(|axis| if is_backwards(axis) { axis + 3 } else { axis }),
            near_origin: pick(low_origin, high_origin),
            far_origin: pick(high_origin, low_origin),
            least: [least(qx), least(qy), least(qz)],
            most: [most(qx), most(qy), most(qz)],
            margin: [most(wx), most(wy), most(wz)],
            start: least(columns.start[0]),
            octant,
        }
    }
}

impl<'a> Packet<'a> {
    /// The group as a packet; `None` where its rays do not go the same way.
    #[inline(always)]
    pub(super) fn new(group: &'a Group, scene: Scene) -> Option<Self> {
        let columns = &group.columns;
        let [octant, axis] = [columns.octant, columns.axis].map(u32x8::to_array);
        let is_same =
            group.ordinary == 0xff && octant == [octant[0]; GROUP] && axis == [axis[0]; GROUP];
        if !is_same {
            return None;
        }
        let [sx, sy] = columns.shear;
        let [ox, oy, oz] = columns.position;
        let low_origin = [least(ox), least(oy), least(oz)];
        let high_origin = [most(ox), most(oy), most(oz)];
        let distance = Vec3::from(high_origin) - Vec3::from(low_origin);
        let slope = (most(sx) - least(sx)).max(most(sy) - least(sy));
        let reach = columns.unit.as_array()[0] / U;
        if distance.max_element() + slope * reach > LARGEST_SPREAD * scene.grain {
            return None;
        }
        let high = columns.end[1];
        Some(Self {
            beam: Beam::new(columns, octant[0], [low_origin, high_origin]),
            low: columns.end[0],
            high,
            leaves: [u32::MAX; GROUP],
            lanes: [0; GROUP],
            farthest: most(high),
            group,
        })
    }

    /// Where the beam enters and leaves the eight boxes of a node.
    #[inline(always)]
    fn slabs(&self, planes: &[f32x8; 6]) -> (f32x8, f32x8) {
        let splat = f32x8::splat;
        let beam = &self.beam;
        let (mut entry, mut exit) = (splat(beam.start), splat(self.farthest));
        for axis in 0..3 {
            let near = beam.near[axis];
            let far = if near < 3 { near + 3 } else { near - 3 };
            let (least, most, margin) = (
                splat(beam.least[axis]),
                splat(beam.most[axis]),
                splat(beam.margin[axis]),
            );
            let way_in = planes[near] - splat(beam.near_origin[axis]);
            let way_out = planes[far] - splat(beam.far_origin[axis]);
            entry = entry.fast_max((way_in * least).fast_min(way_in * most) - margin);
            exit = exit.fast_min((way_out * least).fast_max(way_out * most) + margin);
        }
        (entry, exit)
    }

    /// Where each ray enters one box, and a mask of those that meet it before what they have found.
    #[inline(always)]
    fn entries(&self, node: &Node, lane: usize) -> (f32x8, u32) {
        let columns = &self.group.columns;
        let plane = |index: usize| f32x8::splat(node.planes[index].as_array()[lane]);
        let (mut entry, mut exit) = (columns.start[0], self.high);
        for axis in 0..3 {
            let first = plane(axis).mul_sub(columns.q[axis], columns.entry[axis]);
            let second = plane(axis + 3).mul_sub(columns.q[axis], columns.entry[axis]);
            entry = entry.fast_max(first.fast_min(second));
            exit = exit.fast_min(first.fast_max(second) + columns.widening[axis]);
        }
        (entry, entry.simd_le(exit).to_bitmask())
    }

    /// The way down the tree. With `ANY`, a ray that has met a triangle takes no more part.
    #[inline(always)]
    pub(super) fn walk<const ANY: bool>(
        &mut self,
        hierarchy: &Hierarchy,
        rays: &[Ray<Vec3>],
        stack: &mut Stack,
    ) {
        let nodes = &hierarchy.tree.nodes[..];
        let mut top = 1;
        let mut index = Child::ROOT.index();
        loop {
            let node = &nodes[index];
            let (entries, exits) = self.slabs(&node.planes);
            let hits = entries.simd_le(exits).to_bitmask() & node.taken;
            let order = in_order(self.beam.octant, hits);
            // What waits is a child of a node, by place: its box is needed again.
            let places = u32x8::splat(number(index) << 3) | LANE_NUMBERS;
            stack.write(
                top,
                entries.to_bits().shuffle_wrapping(order),
                places.shuffle_wrapping(order),
            );
            top += hits.count_ones() as usize;
            index = loop {
                top -= 1;
                let (distance, place) = (stack.distance(top), stack.child(top));
                if place == Child::END {
                    return;
                }
                if distance > self.farthest {
                    continue;
                }
                let (node, lane) = (&nodes[(place.0 >> 3) as usize], (place.0 & 7) as usize);
                let child = node.child(lane);
                if !child.is_leaf() {
                    break child.index();
                }
                let (entries, active) = self.entries(node, lane);
                if active != 0 {
                    self.visit_leaf::<ANY>(hierarchy, rays, child, entries, active);
                }
            };
        }
    }

    #[inline(always)]
    fn visit_leaf<const ANY: bool>(
        &mut self,
        hierarchy: &Hierarchy,
        rays: &[Ray<Vec3>],
        child: Child,
        entries: f32x8,
        active: u32,
    ) {
        let leaf = &hierarchy.tree.leaves[child.index()];
        let count = child.lanes().count_ones();
        let corners = self.sheared(leaf);
        let (margin, distance_error) = self.errors(leaf.size, entries);
        for lane in 0..count {
            let [a, b, c] = leaf.corners_of(lane as usize).map(|corner| corners[corner]);
            let u = c[0].mul_sub(b[1], c[1] * b[0]);
            let v = a[0].mul_sub(c[1], a[1] * c[0]);
            let w = b[0].mul_sub(a[1], b[1] * a[0]);
            let least = u.fast_min(v).fast_min(w);
            let most = u.fast_max(v).fast_max(w);
            let possible = (least.simd_ge(-margin) | most.simd_le(margin)).to_bitmask() & active;
            if possible == 0 {
                continue;
            }
            let columns = &self.group.columns;
            let certain = least.simd_gt(margin) | most.simd_lt(-margin);
            let reciprocal = f32x8::ONE / (u + v + w);
            let s = (u * a[2] + v * b[2] + w * c[2]) * (reciprocal * columns.sign);
            let error =
                reciprocal.abs() * (margin * f32x8::splat(3.0 * leaf.size)) + distance_error;
            let (low, high) = (s - error, s + error);
            let is_nearer = certain & high.simd_lt(self.low) & low.simd_gt(columns.start[1]);
            let is_out = certain & (low.simd_gt(self.high) | high.simd_lt(columns.start[0]));
            let taken = is_nearer.to_bitmask() & possible;
            let place = Place {
                leaf: number(child.index()),
                lane,
            };
            self.take::<ANY>(taken, low, high, place);
            let unsettled = possible & !taken & !is_out.to_bitmask();
            self.settle::<ANY>(hierarchy, rays, unsettled, place);
        }
    }

    /// The corners of a leaf in the rays' own coordinates, for eight rays each.
    #[inline(always)]
    fn sheared(&self, leaf: &Leaf) -> [[f32x8; 3]; GROUP] {
        let columns = &self.group.columns;
        let z = columns.axis.as_array()[0] as usize;
        let x = if z == 2 { 0 } else { z + 1 };
        let y = if z == 0 { 2 } else { z - 1 };
        let [x, y, z] = [
            leaf.corners[x].as_array(),
            leaf.corners[y].as_array(),
            leaf.corners[z].as_array(),
        ];
        let mut corners = [[f32x8::ZERO; 3]; GROUP];
        for (index, corner) in corners.iter_mut().enumerate().take(leaf.corner_count()) {
            let pz = f32x8::splat(z[index]) - columns.origin[2];
            let px = f32x8::splat(x[index]) - columns.origin[0];
            let py = f32x8::splat(y[index]) - columns.origin[1];
            *corner = [
                pz.mul_neg_add(columns.shear[0], px),
                pz.mul_neg_add(columns.shear[1], py),
                pz,
            ];
        }
        corners
    }

    /// As [`Prepared::errors`](super::prepared::Prepared::errors), for eight rays.
    #[inline(always)]
    fn errors(&self, size: f32, distance: f32x8) -> (f32x8, f32x8) {
        super::prepared::errors(self.group.columns.unit, f32x8::splat(size), distance)
    }

    #[inline(always)]
    fn take<const ANY: bool>(&mut self, taken: u32, low: f32x8, high: f32x8, place: Place) {
        let mut rest = taken;
        while rest != 0 {
            let ray = rest.trailing_zeros() as usize & 7;
            rest &= rest - 1;
            // For any hit the ray is done: nothing is before minus infinity.
            let (low, high) = if ANY {
                (f32::NEG_INFINITY, f32::NEG_INFINITY)
            } else {
                (low.as_array()[ray], high.as_array()[ray])
            };
            self.low.as_mut_array()[ray] = low;
            self.high.as_mut_array()[ray] = high;
            (self.leaves[ray], self.lanes[ray]) = (place.leaf, place.lane);
        }
        if taken != 0 {
            self.farthest = most(self.high);
        }
    }

    /// Decides between the nearest so far and another, exactly, for some of the rays.
    #[inline(always)]
    fn settle<const ANY: bool>(
        &mut self,
        hierarchy: &Hierarchy,
        rays: &[Ray<Vec3>],
        unsettled: u32,
        place: Place,
    ) {
        let mut rest = unsettled;
        while rest != 0 {
            let ray = rest.trailing_zeros() as usize & 7;
            rest &= rest - 1;
            self.settle_one::<ANY>(hierarchy, &rays[ray], ray, place);
        }
    }

    /// The same for one of them.
    #[cold]
    #[inline(never)]
    fn settle_one<const ANY: bool>(
        &mut self,
        hierarchy: &Hierarchy,
        ray: &Ray<Vec3>,
        lane: usize,
        place: Place,
    ) {
        let (low, high) = (self.low.as_array()[lane], self.high.as_array()[lane]);
        let Some([low, high]) = hierarchy.nearer(ray, self.place(lane), [low, high], place) else {
            return;
        };
        self.take::<ANY>(1 << lane, f32x8::splat(low), f32x8::splat(high), place);
    }

    /// Where the nearest triangle of a ray is.
    #[inline(always)]
    pub(super) fn place(&self, ray: usize) -> Place {
        Place {
            leaf: self.leaves[ray],
            lane: self.lanes[ray],
        }
    }
}
