//! What a ray walks through: nodes of eight boxes, and leaves of up to eight triangles that share up to eight corners.

use glam::Vec3;
use wide::f32x8;

use super::build::{BinaryNode, Primitive};
use super::collapse::WIDTH;

/// A node: the boxes of its children, lane by lane.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(64))]
pub(super) struct Node {
    /// Low x, y, z, then high x, y, z; two places are left over, so that three bits name a place. A lane without a child has a box that is
    /// inside out.
    pub(super) planes: [f32x8; 6],
    pub(super) children: [Child; WIDTH],
    pub(super) spare: [u32; WIDTH],
}

impl Node {
    /// The children that there are, with their boxes.
    pub(super) fn boxes(&self) -> impl Iterator<Item = (Child, [Vec3; 2])> {
        let planes = self.planes.map(f32x8::to_array);
        let corner = move |first: usize, lane: usize| {
            Vec3::new(
                planes[first][lane],
                planes[first + 1][lane],
                planes[first + 2][lane],
            )
        };
        (0..WIDTH)
            .map(move |lane| (self.children[lane], [corner(0, lane), corner(3, lane)]))
            .filter(|(_, [low, high])| low.x <= high.x)
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

    fn node(index: usize) -> Self {
        Self(number(index))
    }

    fn leaf(index: usize, count: usize) -> Self {
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
    /// The place of its first triangle in the order of the leaves.
    pub(super) first: u32,
}

impl Leaf {
    /// The corners of the triangle in this lane.
    #[inline]
    pub(super) fn triangle(&self, lane: usize) -> [Vec3; 3] {
        let [x, y, z] = self.corners.map(|row| row.to_array());
        [0, 1, 2].map(|corner| {
            let index = self.indices[corner][lane] as usize & (WIDTH - 1);
            Vec3::new(x[index], y[index], z[index])
        })
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
    pub(super) fn new(
        triangles: &[[Vec3; 3]],
        primitives: &[Primitive],
        binary: &[BinaryNode],
    ) -> Self {
        let mut layout = Layout {
            triangles,
            tree: Self {
                nodes: Vec::with_capacity(binary.len() / 16 + 1),
                leaves: Vec::with_capacity(binary.len() / 4 + 1),
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

impl<'a> Range<'a> {
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
        self.tree.nodes.push(empty_node());
        let mut boxes = [
            [f32::MAX; WIDTH],
            [f32::MAX; WIDTH],
            [f32::MAX; WIDTH],
            [f32::MIN; WIDTH],
            [f32::MIN; WIDTH],
            [f32::MIN; WIDTH],
        ];
        let mut references = [Child::ROOT; WIDTH];
        let places = places(&children);
        for (child, lane) in children.into_iter().zip(places) {
            let [low, high] = child.bounds();
            for axis in 0..3 {
                boxes[axis][lane] = low[axis];
                boxes[axis + 3][lane] = high[axis];
            }
            references[lane] = if child.is_leaf() {
                self.add_leaf(child)
            } else {
                Child::node(self.add_node(child))
            };
        }
        let node = &mut self.tree.nodes[index];
        node.planes = boxes.map(f32x8::new);
        node.children = references;
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
        self.tree.nodes.push(empty_node());
        let mut boxes = [
            [f32::MAX; WIDTH],
            [f32::MAX; WIDTH],
            [f32::MAX; WIDTH],
            [f32::MIN; WIDTH],
            [f32::MIN; WIDTH],
            [f32::MIN; WIDTH],
        ];
        for lane in 0..range.primitives.len() {
            let single = Range {
                first: range.first + lane,
                primitives: &range.primitives[lane..=lane],
                nodes: &[],
            };
            let [low, high] = single.bounds();
            for axis in 0..3 {
                boxes[axis][lane] = low[axis];
                boxes[axis + 3][lane] = high[axis];
            }
            let child = self.add_leaf(single);
            self.tree.nodes[index].children[lane] = child;
        }
        self.tree.nodes[index].planes = boxes.map(f32x8::new);
        index
    }

    /// The leaf of these triangles; `None` where they have more corners than fit.
    fn filled(&self, range: Range<'_>) -> Option<Leaf> {
        let mut corners = [[0.0_f32; WIDTH]; 3];
        let mut indices = [[0_u8; WIDTH]; 3];
        let mut known: Vec<[u32; 3]> = Vec::with_capacity(WIDTH);
        for (lane, primitive) in range.primitives.iter().enumerate() {
            for (place, corner) in self.triangles[primitive.triangle() as usize]
                .iter()
                .enumerate()
            {
                let bits = corner.to_array().map(f32::to_bits);
                let index = known
                    .iter()
                    .position(|&other| other == bits)
                    .unwrap_or(known.len());
                if index == WIDTH {
                    return None;
                }
                if index == known.len() {
                    known.push(bits);
                    for axis in 0..3 {
                        corners[axis][index] = corner[axis];
                    }
                }
                #[allow(clippy::cast_possible_truncation, reason = "below 8")]
                let index = index as u8;
                indices[place][lane] = index;
            }
        }
        // Places without a corner repeat the first one, so that nothing strange is computed there.
        for row in &mut corners {
            let first = row[0];
            row[known.len()..].fill(first);
        }
        let [low, high] = range.bounds();
        Some(Leaf {
            corners: corners.map(f32x8::new),
            indices,
            size: (high - low).max_element().next_up(),
            first: number(range.first),
        })
    }
}

/// A place for each child, so that the order of `place XOR octant` is roughly front to back for rays of every octant: one after the other, the
/// child that is farthest out in the direction of a free corner gets that corner.
fn places(children: &[Range<'_>]) -> [usize; WIDTH] {
    let centres: Vec<Vec3> = children
        .iter()
        .map(|child| child.bounds().into_iter().sum())
        .collect();
    let middle = centres.iter().copied().sum::<Vec3>() / centres.len() as f32;
    let mut places = [usize::MAX; WIDTH];
    let mut free = [true; WIDTH];
    for _ in 0..children.len() {
        let (mut best, mut most) = (None, f32::NEG_INFINITY);
        for (child, &centre) in centres
            .iter()
            .enumerate()
            .filter(|&(child, _)| places[child] == usize::MAX)
        {
            let [x, y, z] = (centre - middle).to_array();
            for place in (0..WIDTH).filter(|&place| free[place]) {
                let along = |bit: usize, x: f32| if place >> bit & 1 == 1 { x } else { -x };
                let out = along(0, x) + along(1, y) + along(2, z);
                if out > most {
                    (best, most) = (Some((child, place)), out);
                }
            }
        }
        if let Some((child, place)) = best {
            places[child] = place;
            free[place] = false;
        }
    }
    places
}

fn empty_node() -> Node {
    Node {
        planes: [f32x8::ZERO; 6],
        children: [Child::ROOT; WIDTH],
        spare: [0; WIDTH],
    }
}

#[allow(
    clippy::cast_possible_truncation,
    reason = "below Hierarchy::MOST_TRIANGLES, which is below 2^28"
)]
fn number(index: usize) -> u32 {
    index as u32
}
