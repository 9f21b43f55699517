//! A bounding volume hierarchy over triangles: the first triangle along a ray, found among millions by looking at a few.
//!
//! A box around a group of triangles is missed by nearly every ray, and whoever misses the box misses the group. Boxes within boxes make a
//! tree, and a ray walks down only where it meets the boxes: the cost grows like the depth, log n, instead of n.
//!
//! # Conventions
//!
//! A triangle is closed: its edges and corners belong to it. A triangle without area, and a ray in a triangle's plane, make no hit. Among
//! triangles hit at the same t the one with the smaller number is the answer. The interval of t is the ray's, `start < t <= end`, for the
//! exact t of the exact line; a ray without an end ends at `f32::MAX`.
//!
//! # Numerics
//!
//! The coordinates are `f32`, and are taken at their word: which triangle is hit first is decided exactly, as if computed with rational
//! numbers. So no ray slips through an edge, and the answer depends neither on how the tree was built nor on the processor.
//!
//! *In the course*: slide 104 (*groupe de primitives*; "there are better methods").
//!
//! *In the book*: [A hierarchy of boxes](../../../../intersection/hierarchy.html).

mod confirm;
mod exact;
mod hit_point;

use glam::Vec3;
use thiserror::Error;

use self::confirm::{Confirmed, Line, confirm};
use crate::intersection::{FacetHit, Hit, Intersect};
use crate::mesh::Mesh;
use crate::ray::Ray;

/// What is wrong with the triangles of a hierarchy.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum HierarchyError {
    /// A corner has an infinite or NaN coordinate.
    #[error(
        "corner {corner} of triangle {triangle} is {position}: every coordinate must be finite"
    )]
    NotFinite {
        /// Which triangle, counted from 0.
        triangle: usize,
        /// Which of its corners, counted from 0.
        corner: usize,
        /// Where it is.
        position: Vec3,
    },
    /// More triangles than 32-bit numbers can name.
    #[error(
        "{count} triangles: a hierarchy holds at most {}",
        Hierarchy::MOST_TRIANGLES
    )]
    TooMany {
        /// How many there are.
        count: usize,
    },
    /// A triangle of a mesh names a vertex without a position.
    #[error(
        "triangle {triangle} names vertex {vertex}, but the {count} positions are counted from 0"
    )]
    NoSuchVertex {
        /// Which triangle, counted from 0.
        triangle: usize,
        /// The vertex that it names.
        vertex: u32,
        /// How many positions there are.
        count: usize,
    },
}

/// The triangle that a ray meets first, and where.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Found {
    /// Which triangle, counted from 0.
    pub triangle: u32,
    /// Where on it: t and the weights each rounded once, so that t is within `(1/2 + 2⁻¹⁰) ulp`, and each weight within 2⁻²⁴ for weights up to 1.
    pub hit: FacetHit<f32>,
}

/// A tree of boxes over triangles.
#[derive(Clone, Debug)]
pub struct Hierarchy {
    triangles: Vec<[Vec3; 3]>,
    nodes: Vec<Node>,
    order: Vec<u32>,
}

#[derive(Clone, Copy, Debug)]
struct Node {
    low: Vec3,
    high: Vec3,
    /// The right child, the left one follows; or where the leaf's triangles begin.
    first: u32,
    /// How many triangles a leaf has; 0 for an inner node.
    count: u32,
}

impl Hierarchy {
    /// How many triangles a hierarchy holds at most.
    pub const MOST_TRIANGLES: usize = 1 << 30;

    /// The hierarchy over these triangles, which it copies.
    ///
    /// # Errors
    ///
    /// [`HierarchyError::NotFinite`] and [`HierarchyError::TooMany`].
    pub fn new(triangles: &[[Vec3; 3]]) -> Result<Self, HierarchyError> {
        let count = triangles.len();
        if count > Self::MOST_TRIANGLES {
            return Err(HierarchyError::TooMany { count });
        }
        for (triangle, corners) in triangles.iter().enumerate() {
            if let Some(corner) = corners.iter().position(|corner| !corner.is_finite()) {
                let position = corners[corner];
                return Err(HierarchyError::NotFinite {
                    triangle,
                    corner,
                    position,
                });
            }
        }
        let mut hierarchy = Self {
            triangles: triangles.to_vec(),
            nodes: Vec::new(),
            order: (0..count as u32).collect(),
        };
        if count > 0 {
            hierarchy.build(0, count);
        }
        Ok(hierarchy)
    }

    /// The hierarchy over the triangles of a mesh, in the mesh's order.
    ///
    /// # Errors
    ///
    /// As [`Hierarchy::new`], and [`HierarchyError::NoSuchVertex`] where positions were taken away.
    pub fn of_mesh(mesh: &Mesh<Vec3>) -> Result<Self, HierarchyError> {
        let count = mesh.positions.len();
        let position = |triangle, vertex: u32| {
            let found = mesh.positions.get(vertex as usize).copied();
            found.ok_or(HierarchyError::NoSuchVertex {
                triangle,
                vertex,
                count,
            })
        };
        let corners = mesh.triangles().enumerate().map(|(triangle, [a, b, c])| {
            Ok([
                position(triangle, a)?,
                position(triangle, b)?,
                position(triangle, c)?,
            ])
        });
        let corners: Vec<_> = corners.collect::<Result<_, HierarchyError>>()?;
        Self::new(&corners)
    }

    /// The triangles, in the order given.
    pub fn triangles(&self) -> &[[Vec3; 3]] {
        &self.triangles
    }

    /// The whole hit, with point, normal and bounds on their errors, of what a query found for this ray; `None` where this ray does not meet
    /// that triangle.
    pub fn hit(&self, ray: &Ray<Vec3>, found: &Found) -> Option<Hit<Vec3>> {
        let corners = *self.triangles.get(found.triangle as usize)?;
        let confirmed = confirm(&Line::new(ray)?, found.triangle, corners)?;
        Some(confirmed.hit(corners))
    }

    /// A query, which keeps its stack from ray to ray: make one for each thread.
    pub fn query(&self) -> Query<'_> {
        Query {
            hierarchy: self,
            stack: Vec::new(),
        }
    }

    fn build(&mut self, begin: usize, end: usize) {
        let corners = |&i: &u32| self.triangles[i as usize];
        let (mut low, mut high) = (Vec3::MAX, Vec3::MIN);
        for corner in self.order[begin..end].iter().flat_map(corners) {
            (low, high) = (low.min(corner), high.max(corner));
        }
        let node = self.nodes.len();
        let (first, count) = (begin as u32, (end - begin) as u32);
        self.nodes.push(Node {
            low,
            high,
            first,
            count,
        });
        if count <= 4 {
            return;
        }
        let extent = high * 0.5 - low * 0.5;
        let axis = extent.max_position();
        let middle = usize::midpoint(begin, end);
        let triangles = &self.triangles;
        let centre = |i: u32| {
            let [a, b, c] = triangles[i as usize].map(|corner| corner[axis]);
            a.min(b).min(c) * 0.5 + a.max(b).max(c) * 0.5
        };
        self.order[begin..end].select_nth_unstable_by(middle - begin, |&i, &j| {
            centre(i).total_cmp(&centre(j)).then(i.cmp(&j))
        });
        self.build(begin, middle);
        self.nodes[node].first = self.nodes.len() as u32;
        self.nodes[node].count = 0;
        self.build(middle, end);
    }
}

/// For single rays: each makes a [`Query`] of its own, which many rays would share.
impl Intersect for Hierarchy {
    type Point = Vec3;

    fn intersect(&self, ray: &Ray<Vec3>) -> Option<Hit<Vec3>> {
        self.query().nearest_hit(ray).map(|(_, hit)| hit)
    }

    fn is_hit_by(&self, ray: &Ray<Vec3>) -> bool {
        self.query().is_hit(ray)
    }
}

/// A traversal of a hierarchy, with the memory that it needs from ray to ray.
#[derive(Clone, Debug)]
pub struct Query<'a> {
    hierarchy: &'a Hierarchy,
    stack: Vec<u32>,
}

impl Query<'_> {
    /// The first triangle that the ray meets.
    #[inline]
    pub fn nearest(&mut self, ray: &Ray<Vec3>) -> Option<Found> {
        self.walk(ray, false)
    }

    /// The first triangle that the ray meets, and the whole hit.
    pub fn nearest_hit(&mut self, ray: &Ray<Vec3>) -> Option<(u32, Hit<Vec3>)> {
        let found = self.nearest(ray)?;
        Some((found.triangle, self.hierarchy.hit(ray, &found)?))
    }

    /// Whether the ray meets any triangle.
    pub fn is_hit(&mut self, ray: &Ray<Vec3>) -> bool {
        self.walk(ray, true).is_some()
    }

    /// [`nearest`](Self::nearest) of many rays: `found[i]` is that of `rays[i]`. Where one slice is longer, its rest is left alone.
    pub fn nearest_of(&mut self, rays: &[Ray<Vec3>], found: &mut [Option<Found>]) {
        for (ray, found) in rays.iter().zip(found) {
            *found = self.nearest(ray);
        }
    }

    /// [`is_hit`](Self::is_hit) of many rays.
    pub fn is_hit_of(&mut self, rays: &[Ray<Vec3>], hit: &mut [bool]) {
        for (ray, hit) in rays.iter().zip(hit) {
            *hit = self.is_hit(ray);
        }
    }

    fn walk(&mut self, ray: &Ray<Vec3>, any: bool) -> Option<Found> {
        let line = Line::new(ray)?;
        let hierarchy = self.hierarchy;
        let mut best: Option<Confirmed> = None;
        let inverse = 1.0 / line.direction.as_dvec3();
        self.stack.clear();
        if !hierarchy.nodes.is_empty() {
            self.stack.push(0);
        }
        while let Some(index) = self.stack.pop() {
            let node = hierarchy.nodes[index as usize];
            let (mut enter, mut leave) = (
                f64::from(line.start),
                best.map_or(f64::from(line.end), |best| best.latest()),
            );
            for axis in 0..3 {
                let o = f64::from(line.origin[axis]);
                let mut ends = [node.low[axis], node.high[axis]];
                if inverse[axis].is_sign_negative() {
                    ends.reverse();
                }
                let [near, far] = ends.map(|end| (f64::from(end) - o) * inverse[axis]);
                enter = enter.max(near - 1e-14 * near.abs());
                leave = leave.min(far + 1e-14 * far.abs());
            }
            if enter - 1e-14 * enter.abs() > leave + 1e-14 * leave.abs() {
                continue;
            }
            if node.count == 0 {
                self.stack.extend([node.first, index + 1]);
                continue;
            }
            for &triangle in &hierarchy.order[node.first as usize..][..node.count as usize] {
                let hit = confirm(&line, triangle, hierarchy.triangles[triangle as usize]);
                if let Some(hit) = hit
                    && best.is_none_or(|best| hit.is_before(&best, &line, &hierarchy.triangles))
                {
                    best = Some(hit);
                    if any {
                        break;
                    }
                }
            }
        }
        best.map(|best| found(&best))
    }
}

fn found(best: &Confirmed) -> Found {
    Found {
        triangle: best.triangle,
        hit: best.facet_hit(),
    }
}

/// The first of these triangles that the ray meets, by asking each: the slides' linear loop, and what a hierarchy must agree with, bit for bit.
///
/// A triangle with a coordinate that is not finite is never met.
pub fn nearest_by_loop(triangles: &[[Vec3; 3]], ray: &Ray<Vec3>) -> Option<Found> {
    let line = Line::new(ray)?;
    let mut best: Option<Confirmed> = None;
    for (triangle, &corners) in (0..).zip(triangles) {
        if !corners.iter().all(|corner| corner.is_finite()) {
            continue;
        }
        if let Some(hit) = confirm(&line, triangle, corners)
            && best.is_none_or(|best| hit.is_before(&best, &line, triangles))
        {
            best = Some(hit);
        }
    }
    best.as_ref().map(found)
}
