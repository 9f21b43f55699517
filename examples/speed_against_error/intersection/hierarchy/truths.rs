//! The exact first hit among a million triangles: a tree of halves, written for nothing but being right.

use facette::intersection::{BoundingBox, SlabRay};
use facette::ray::Ray;
use glam::Vec3;

use super::hierarchy_oracle::{ExactHit, exact_hit};
use crate::answers::Truth;

/// How many triangles a leaf has at most.
const LEAF: usize = 8;

/// A binary tree, halved by number: it shares nothing with the library's hierarchy.
pub struct TruthTree {
    triangles: Vec<[Vec3; 3]>,
    order: Vec<u32>,
    /// The box of the order's part `start..end`, the two halves' trees after it.
    nodes: Vec<Node>,
}

struct Node {
    bounds: BoundingBox<[f64; 3]>,
    start: usize,
    end: usize,
    /// The two halves, above [`LEAF`] triangles.
    children: Option<[usize; 2]>,
}

impl TruthTree {
    pub fn new(triangles: &[[Vec3; 3]]) -> Self {
        let mut tree = Self {
            triangles: triangles.to_vec(),
            order: (0..).zip(triangles).map(|(triangle, _)| triangle).collect(),
            nodes: Vec::new(),
        };
        tree.build(0, triangles.len());
        tree
    }

    fn corners(&self, place: usize) -> [Vec3; 3] {
        self.triangles[self.order[place] as usize]
    }

    fn build(&mut self, start: usize, end: usize) -> usize {
        let corners = (start..end).flat_map(|place| self.corners(place));
        let [low, high] = corners.fold([Vec3::MAX, Vec3::MIN], |[low, high], p| {
            [low.min(p), high.max(p)]
        });
        let [min, max] = [low, high].map(|p| p.as_dvec3().to_array());
        let node = self.nodes.len();
        self.nodes.push(Node {
            bounds: BoundingBox::new(min, max).expect("corners in order"),
            start,
            end,
            children: None,
        });
        if end - start > LEAF {
            let axis = (high - low).max_position();
            let middle = start.midpoint(end);
            let triangles = &self.triangles;
            let centre = |&triangle: &u32| {
                triangles[triangle as usize]
                    .iter()
                    .map(|p| p[axis])
                    .sum::<f32>()
            };
            self.order[start..end]
                .select_nth_unstable_by(middle - start, |a, b| centre(a).total_cmp(&centre(b)));
            self.nodes[node].children = Some([self.build(start, middle), self.build(middle, end)]);
        }
        node
    }

    /// What the ray meets first, exactly, with all triangles that are met at that place.
    pub fn nearest(&self, ray: &Ray<Vec3>) -> Option<Truth> {
        let point = |p: Vec3| p.as_dvec3().to_array();
        let line = SlabRay::new(&Ray::new(point(ray.origin), point(ray.direction)));
        let mut hits: Vec<ExactHit> = Vec::new();
        let mut waiting = vec![0];
        while let Some(node) = waiting.pop() {
            let node = &self.nodes[node];
            if !node.bounds.may_be_hit_by(&line) {
                continue;
            }
            if let Some(children) = node.children {
                waiting.extend(children);
                continue;
            }
            hits.extend(
                (node.start..node.end)
                    .filter_map(|place| exact_hit(self.order[place], self.corners(place), ray)),
            );
        }
        let t = hits.iter().map(|hit| &hit.t).min()?.clone();
        let surfaces = hits
            .iter()
            .filter(|hit| hit.t == t)
            .map(|hit| hit.triangle)
            .collect();
        Some(Truth { t, surfaces })
    }
}
