//! From the binary tree to the nodes and leaves that a ray walks through.

use glam::Vec3;
use wide::f32x8;

use super::build::{BinaryNode, Primitive};
use super::collapse::WIDTH;
use super::node::{Child, Leaf, Node, Tree, number};

impl Tree {
    pub(super) fn new(
        triangles: &[[Vec3; 3]],
        primitives: &[Primitive],
        binary: &[BinaryNode],
    ) -> Self {
        let mut layout = Layout {
            triangles,
            tree: Self {
                nodes: Vec::with_capacity(binary.len() / 12 + 1),
                leaves: Vec::with_capacity(binary.len() / 3 + 1),
                order: primitives.iter().map(Primitive::triangle).collect(),
            },
        };
        if !primitives.is_empty() {
            let root = Range {
                first: 0,
                primitives,
                nodes: binary,
            };
            layout.add_node(root);
        }
        layout.tree
    }
}

/// A subtree of the binary tree: its primitives, where they begin in all, and its nodes.
#[derive(Clone, Copy)]
struct Range<'a> {
    first: usize,
    primitives: &'a [Primitive],
    nodes: &'a [BinaryNode],
}

impl Range<'_> {
    fn children(self) -> [Self; 2] {
        let left = self.nodes[0].left as usize;
        let (first, second) = self.primitives.split_at(left);
        let (first_nodes, second_nodes) = self.nodes[1..].split_at(left - 1);
        [
            Self {
                first: self.first,
                primitives: first,
                nodes: first_nodes,
            },
            Self {
                first: self.first + left,
                primitives: second,
                nodes: second_nodes,
            },
        ]
    }

    fn is_leaf(self) -> bool {
        self.nodes.first().is_none_or(|node| node.choices.is_leaf())
    }

    fn bounds(self) -> [Vec3; 2] {
        match self.nodes {
            [] => [
                self.primitives[0].bounds().low(),
                self.primitives[0].bounds().high(),
            ],
            [node, ..] => [node.low(), node.high()],
        }
    }

    /// The children of a wide node, at most so many.
    fn gather(self, most: usize, children: &mut Vec<Self>) {
        let Some(node) = self.nodes.first().filter(|_| most > 1) else {
            children.push(self);
            return;
        };
        match node.choices.to_the_left(most) {
            0 => self.gather(most - 1, children),
            left => {
                let [first, second] = self.children();
                first.gather(left, children);
                second.gather(most - left, children);
            }
        }
    }
}

struct Layout<'a> {
    triangles: &'a [[Vec3; 3]],
    tree: Tree,
}

impl Layout<'_> {
    fn add_node(&mut self, range: Range<'_>) -> usize {
        let mut children = Vec::with_capacity(WIDTH);
        if range.is_leaf() {
            children.push(range);
        } else {
            range.gather(WIDTH, &mut children);
        }
        let index = self.tree.nodes.len();
        self.tree.nodes.push(Node::EMPTY);
        let places = places(&children);
        for (child, lane) in children.into_iter().zip(places) {
            let reference = if child.is_leaf() {
                self.add_leaf(child)
            } else {
                Child::node(self.add_node(child))
            };
            self.tree.nodes[index].set(lane, reference, child.bounds());
        }
        index
    }

    fn add_leaf(&mut self, range: Range<'_>) -> Child {
        let Some(leaf) = self.filled(range) else {
            // Two corners shared a hash: the leaf becomes a node of smaller ones.
            return Child::node(self.add_small_node(range));
        };
        self.tree.leaves.push(leaf);
        Child::leaf(self.tree.leaves.len() - 1, range.primitives.len())
    }

    /// A node over a leaf whose corners do not fit: two leaves of at most four triangles would hold twelve corners, so each triangle gets its own.
    fn add_small_node(&mut self, range: Range<'_>) -> usize {
        let index = self.tree.nodes.len();
        self.tree.nodes.push(Node::EMPTY);
        for lane in 0..range.primitives.len() {
            let single = Range {
                first: range.first + lane,
                primitives: &range.primitives[lane..=lane],
                nodes: &[],
            };
            let child = self.add_leaf(single);
            self.tree.nodes[index].set(lane, child, single.bounds());
        }
        index
    }

    /// The leaf of these triangles; `None` where they have more corners than fit.
    fn filled(&self, range: Range<'_>) -> Option<Leaf> {
        let mut corners = [[0.0_f32; WIDTH]; 3];
        let mut indices = [[0_u8; WIDTH]; 3];
        let (mut known, mut count) = ([[0_u32; 3]; WIDTH], 0);
        for (lane, primitive) in range.primitives.iter().enumerate() {
            let triangle = &self.triangles[primitive.triangle() as usize];
            for (place, corner) in triangle.iter().enumerate() {
                let bits = corner.to_array().map(f32::to_bits);
                let index = known[..count]
                    .iter()
                    .position(|&other| other == bits)
                    .unwrap_or(count);
                if index == WIDTH {
                    return None;
                }
                known[index] = bits;
                for axis in 0..3 {
                    corners[axis][index] = corner[axis];
                }
                count = count.max(index + 1);
                #[allow(clippy::cast_possible_truncation, reason = "below 8")]
                let index = index as u8;
                indices[place][lane] = index;
            }
        }
        // Places without a corner repeat the first one, so that nothing strange is computed there.
        for row in &mut corners {
            let first = row[0];
            row[count..].fill(first);
        }
        let [low, high] = range.bounds();
        Some(Leaf {
            corners: corners.map(f32x8::new),
            indices,
            size: (high - low).max_element().next_up(),
            first: number(range.first) | number(count - 1) << 28,
        })
    }
}

/// A place for each child, so that the order of `place XOR octant` is roughly front to back for rays of every octant: a place stands for a
/// corner of the node's box, and the children that are farthest out choose first.
fn places(children: &[Range<'_>]) -> [usize; WIDTH] {
    let mut centres = [Vec3::ZERO; WIDTH];
    let mut sum = Vec3::ZERO;
    for (centre, child) in centres.iter_mut().zip(children) {
        let [low, high] = child.bounds();
        *centre = low + high;
        sum += *centre;
    }
    let middle = sum / children.len() as f32;
    let mut order = [0, 1, 2, 3, 4, 5, 6, 7];
    let order = &mut order[..children.len()];
    let out = |child: usize| (centres[child] - middle).abs().element_sum();
    order.sort_unstable_by(|&a, &b| out(b).total_cmp(&out(a)).then(a.cmp(&b)));
    let mut places = [0; WIDTH];
    let mut taken = [false; WIDTH];
    for &mut child in order {
        let [x, y, z] = (centres[child] - middle).to_array();
        let along = |place: usize, bit: usize, x: f32| if place >> bit & 1 == 1 { x } else { -x };
        let out = |place: usize| along(place, 0, x) + along(place, 1, y) + along(place, 2, z);
        let (mut best, mut most) = (0, f32::NEG_INFINITY);
        for place in (0..WIDTH).filter(|&place| !taken[place]) {
            if out(place) > most {
                (best, most) = (place, out(place));
            }
        }
        places[child] = best;
        taken[best] = true;
    }
    places
}
