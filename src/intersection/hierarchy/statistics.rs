//! What a tree looks like, and what a ray visits in it: for figures and for those who tune.

use glam::Vec3;

use super::node::{Child, Tree};
use super::{Hierarchy, Query};
use crate::ray::Ray;

/// What a traversal tells of itself while it walks: nothing, at no cost, unless somebody counts.
pub(super) trait Observer {
    /// A node is visited: eight boxes are tested.
    fn node(&mut self) {}

    /// A leaf is visited: so many triangles are tested.
    fn leaf(&mut self, _triangles: u32) {}
}

impl Observer for () {}

/// What a ray visited.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Visits {
    /// Nodes, each with eight boxes tested at once.
    pub nodes: u32,
    /// Leaves, each with up to eight triangles tested at once.
    pub leaves: u32,
    /// Triangles in those leaves.
    pub triangles: u32,
}

impl Observer for Visits {
    fn node(&mut self) {
        self.nodes += 1;
    }

    fn leaf(&mut self, triangles: u32) {
        self.leaves += 1;
        self.triangles += triangles;
    }
}

/// What a tree consists of.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Shape {
    /// How many nodes there are.
    pub nodes: usize,
    /// How many leaves.
    pub leaves: usize,
    /// How many children a node has on average, of eight.
    pub children: f64,
    /// How many triangles a leaf has on average, of eight.
    pub triangles: f64,
    /// How many nodes are on the longest way down, the root included.
    pub depth: usize,
    /// How much memory the tree takes, in bytes, beside the triangles themselves.
    pub bytes: usize,
}

impl Query<'_> {
    /// What [`nearest`](Query::nearest) visits for this ray; `None` for one whose numbers leave the fast walk's range.
    pub fn visits(&mut self, ray: &Ray<Vec3>) -> Option<Visits> {
        let mut visits = Visits::default();
        let hierarchy = self.hierarchy;
        self.group.fill(std::slice::from_ref(ray), hierarchy.scene);
        if self.group.ordinary != 1 {
            return None;
        }
        if !hierarchy.triangles.is_empty() {
            hierarchy.nearest(ray, &self.group.ray(0), &mut self.stack, &mut visits);
        }
        Some(visits)
    }
}

impl Hierarchy {
    /// What the tree consists of.
    pub fn shape(&self) -> Shape {
        let Tree {
            nodes,
            leaves,
            order,
            ..
        } = &self.tree;
        let children = self.boxes().iter().map(Vec::len).sum::<usize>();
        Shape {
            nodes: nodes.len(),
            leaves: leaves.len(),
            children: children as f64 / nodes.len().max(1) as f64,
            triangles: order.len() as f64 / leaves.len().max(1) as f64,
            depth: self.boxes().len(),
            bytes: size_of_val(&nodes[..]) + size_of_val(&leaves[..]) + size_of_val(&order[..]),
        }
    }

    /// The boxes level by level, each as its lowest and its highest corner: the boxes of the root's children first.
    pub fn boxes(&self) -> Vec<Vec<[Vec3; 2]>> {
        let mut levels = Vec::new();
        let mut level: Vec<Child> = self
            .tree
            .nodes
            .first()
            .map(|_| Child::ROOT)
            .into_iter()
            .collect();
        while !level.is_empty() {
            let nodes = level
                .iter()
                .filter(|child| !child.is_leaf())
                .map(|child| &self.tree.nodes[child.index()]);
            let below: Vec<_> = nodes.flat_map(super::node::Node::boxes).collect();
            let unscaled = |bounds: [Vec3; 2]| bounds.map(|corner| corner / self.scene.scale);
            level = below.iter().map(|&(child, _)| child).collect();
            if !below.is_empty() {
                levels.push(
                    below
                        .into_iter()
                        .map(|(_, bounds)| unscaled(bounds))
                        .collect(),
                );
            }
        }
        levels
    }
}
