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

#![allow(
    clippy::inline_always,
    reason = "the inner loops of a ray: left to itself the compiler calls functions there, and keeps vectors in memory"
)]

mod bounds;
mod build;
mod careful;
mod collapse;
mod confirm;
mod exact;
mod finish;
mod hit_point;
mod layout;
mod leaf_test;
mod node;
mod order;
mod packet;
mod prepared;
mod stack;
mod statistics;
mod stream;
mod traverse;
mod walk;

use glam::Vec3;
use thiserror::Error;

use self::build::{BinaryNode, Builder, Primitive};
use self::confirm::{Confirmed, Line, confirm};
use self::finish::Arrived;
use self::node::Tree;
use self::prepared::{Group, Scene};
use self::stack::Stack;
pub use self::statistics::{Shape, Visits};
use self::stream::{Any, Nearest, Walkers};
use crate::algebra::{Real, Vector3};
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
    tree: Tree,
    scene: Scene,
}

impl Hierarchy {
    /// How many triangles a hierarchy holds at most.
    pub const MOST_TRIANGLES: usize = 1 << 28;

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
        check_finite(triangles)?;
        let triangles = triangles.to_vec();
        let largest = triangles.iter().flatten().fold(0.0_f32, |largest, corner| {
            largest.max(corner.abs().max_element())
        });
        let scale = scale(largest);
        let mut scene = Scene {
            scale,
            largest: largest * scale,
            grain: 0.0,
        };
        let tree = if scene.is_scaled() {
            let scaled: Vec<_> = triangles
                .iter()
                .map(|corners| corners.map(|corner| corner * scale))
                .collect();
            build_tree(&scaled, true)
        } else {
            build_tree(&triangles, false)
        };
        scene.grain = tree.grain();
        Ok(Self {
            triangles,
            tree,
            scene,
        })
    }

    /// The hierarchy over the triangles of a mesh, in the mesh's order, their corners rounded to single precision.
    ///
    /// # Accuracy
    ///
    /// A corner in double precision is moved by at most u = 2⁻²⁴ of each coordinate, and by 2⁻¹⁵⁰ where that is denormal in single precision. Triangles that share a
    /// vertex share the rounded one, so that a closed mesh stays closed; a triangle smaller than the rounding may lose its area, and is not hit then.
    ///
    /// # Errors
    ///
    /// As [`Hierarchy::new`], with [`HierarchyError::NotFinite`] also for a coordinate beyond `f32::MAX`; [`HierarchyError::NoSuchVertex`] where positions were taken away.
    ///
    /// # Examples
    ///
    /// ```
    /// use facette::intersection::hierarchy::Hierarchy;
    /// use facette::mesh::Mesh;
    /// use facette::ray::Ray;
    /// use glam::{DVec3, Vec3};
    ///
    /// let square = Mesh::new(vec![DVec3::ZERO, DVec3::X, DVec3::new(1.0, 1.0, 0.0), DVec3::Y], [[0, 1, 2, 3]])?;
    /// let hierarchy = Hierarchy::of_mesh(&square)?;
    /// let ray = Ray::new(Vec3::new(0.25, 0.5, 2.0), Vec3::NEG_Z);
    /// assert_eq!(hierarchy.query().nearest(&ray).map(|found| found.triangle), Some(1));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn of_mesh<P>(mesh: &Mesh<P>) -> Result<Self, HierarchyError>
    where
        P: Vector3<Scalar: Real>,
    {
        let count = mesh.positions.len();
        let single = |point: &P| Vec3::from_array(point.in_double_precision().map(f32::from_f64));
        let position = |triangle, vertex: u32| {
            let found = mesh.positions.get(vertex as usize).map(single);
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
        confirmed.hit(corners)
    }

    /// A query, which keeps its stack from ray to ray: make one for each thread.
    pub fn query(&self) -> Query<'_> {
        Query {
            hierarchy: self,
            stack: Stack::new(),
            walkers: Walkers::new(),
            group: Group::new(),
        }
    }
}

fn check_finite(triangles: &[[Vec3; 3]]) -> Result<(), HierarchyError> {
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
    Ok(())
}

/// The power of two that brings the largest coordinate into a range where products of three of them are ordinary numbers.
fn scale(largest: f32) -> f32 {
    const ORDINARY: std::ops::RangeInclusive<f32> = 1.0 / (1 << 20) as f32..=(1 << 20) as f32;
    if largest == 0.0 || ORDINARY.contains(&largest) {
        return 1.0;
    }
    // 2^-k for a largest coordinate in [2^k, 2^(k+1)); the exponent of a denormal number counts as that of the least normal one.
    let exponent = (largest.to_bits() >> 23).clamp(1, 253);
    f32::from_bits((254 - exponent) << 23)
}

/// The tree over these triangles. Where scaling may have rounded their coordinates, the boxes are widened by a rounding.
fn build_tree(triangles: &[[Vec3; 3]], is_rounded: bool) -> Tree {
    let mut primitives: Vec<_> = (0..)
        .zip(triangles)
        .map(|(triangle, &corners)| Primitive::new(triangle, corners, is_rounded))
        .collect();
    let mut binary = vec![BinaryNode::NONE; triangles.len().saturating_sub(1)];
    if !triangles.is_empty() {
        Builder { triangles }.build(&mut primitives, &mut binary, 0);
    }
    Tree::new(triangles, &primitives, &binary)
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
    stack: Box<Stack>,
    walkers: Walkers,
    group: Group,
}

impl Query<'_> {
    /// The first triangle that the ray meets.
    #[inline]
    pub fn nearest(&mut self, ray: &Ray<Vec3>) -> Option<Found> {
        let hierarchy = self.hierarchy;
        if hierarchy.triangles.is_empty() {
            return None;
        }
        self.group.fill(std::slice::from_ref(ray), hierarchy.scene);
        let hit = if self.group.ordinary == 1 {
            hierarchy.nearest(ray, &self.group.ray(0), &mut self.stack, &mut ())
        } else {
            hierarchy.walk_carefully(&Line::new(ray)?, false)
        };
        hit.as_ref().map(found)
    }

    /// The first triangle that the ray meets, and the whole hit.
    pub fn nearest_hit(&mut self, ray: &Ray<Vec3>) -> Option<(u32, Hit<Vec3>)> {
        let found = self.nearest(ray)?;
        Some((found.triangle, self.hierarchy.hit(ray, &found)?))
    }

    /// Whether the ray meets any triangle.
    pub fn is_hit(&mut self, ray: &Ray<Vec3>) -> bool {
        let hierarchy = self.hierarchy;
        if hierarchy.triangles.is_empty() {
            return false;
        }
        self.group.fill(std::slice::from_ref(ray), hierarchy.scene);
        if self.group.ordinary == 1 {
            return hierarchy.any(ray, &self.group.ray(0), &mut self.stack);
        }
        Line::new(ray).is_some_and(|line| hierarchy.walk_carefully(&line, true).is_some())
    }

    /// [`nearest`](Self::nearest) of many rays: `found[i]` is that of `rays[i]`. Where one slice is longer, its rest is left alone.
    pub fn nearest_of(&mut self, rays: &[Ray<Vec3>], found: &mut [Option<Found>]) {
        let count = rays.len().min(found.len());
        let (rays, found) = (&rays[..count], &mut found[..count]);
        if self.hierarchy.triangles.is_empty() {
            found.fill(None);
        } else {
            self.walkers.walk(
                self.hierarchy,
                rays,
                &mut Nearest {
                    answers: found,
                    arrived: Arrived::new(),
                },
            );
        }
    }

    /// [`is_hit`](Self::is_hit) of many rays.
    pub fn is_hit_of(&mut self, rays: &[Ray<Vec3>], hit: &mut [bool]) {
        let count = rays.len().min(hit.len());
        let (rays, hit) = (&rays[..count], &mut hit[..count]);
        if self.hierarchy.triangles.is_empty() {
            hit.fill(false);
        } else {
            self.walkers
                .walk(self.hierarchy, rays, &mut Any { answers: hit });
        }
    }
}

fn found(best: &Confirmed) -> Found {
    Found {
        triangle: best.triangle,
        hit: best.facet_hit(),
    }
}

// ANCHOR: nearest_by_loop
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
// ANCHOR_END: nearest_by_loop
