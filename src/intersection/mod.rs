//! Intersection: where a ray meets a surface, and which of many surfaces it meets first.
//!
//! Most of a ray tracer's time goes into one question: what is the first thing along this half-line? A surface answers for itself by
//! solving an equation in t; a group asks all of its members; a hierarchy of boxes asks few of them.
//!
//! ```text
//! f(o + t d) = 0,   start < t <= end,   t least
//! ```
//!
//! # Conventions
//!
//! As [`Ray`] has them: the start of the interval does not belong to it, its end does. A hit is on the *front* where the ray arrives against the normal,
//! from outside. Facets run anticlockwise as seen from their front, and are closed: edges and corners belong to them. Where two members of a group are hit at the same t, the one with the
//! smaller number is the answer.
//!
//! Whether t belongs to the ray's interval is asked of t as it is returned, rounded to its type; two surfaces are more careful. A
//! [`hierarchy`] asks the exact t, and a [`bezier_patch`] leaves out a t within its error of the interval's start.
//!
//! A hierarchy holds triangles only. Other surfaces stand beside it in a [`Group`], or enter it as the triangles of a
//! [tessellation](crate::tessellation).
//!
//! A surface with a theory of its own is a public module, and its names are found there only. The plain shapes, and what all share, are found here.
//!
//! # Numerics
//!
//! Every hit says how wrong it may be: [`Hit::t_error`] and [`Hit::point_error`] are bounds that the surfaces derive, and the tests hold them
//! to. A ray that [leaves](offset::spawn_ray) a hit starts where the second of them ends.
//!
//! # Sources
//!
//! J. T. Kajiya, *Ray tracing parametric patches*, 1982; A. S. Glassner (ed.), *An Introduction to Ray Tracing*, 1989; M. Pharr, W. Jakob, G.
//! Humphreys, *Physically Based Rendering*, 4th edition, 2023, chapter 6. The surfaces name their own.
//!
//! *In the course*: slides 84 to 105 (*lancer de rayon*, *intersection*).
//!
//! *In the book*: [Intersection](../../../intersection.html).

pub mod bezier_patch;
mod bounding_box;
mod error;
pub mod fan;
mod group;
pub mod hierarchy;
mod hit;
mod limbs;
pub mod offset;
mod plane;
pub mod quadrilateral;
mod sphere;
pub mod triangle;

pub use bounding_box::{BoundingBox, BoxSpan, FaceHit, SlabRay, box_interval};
pub use error::IntersectionError;
pub use group::{Group, nearest};
pub use hit::{FacetHit, Hit, Side};
pub use plane::Plane;
pub use sphere::{Sphere, first_root, roots_by_projection, roots_by_quadratic};

use crate::algebra::{Real, Vector3};
use crate::ray::Ray;

/// What a ray can meet.
pub trait Intersect {
    /// The points of space.
    type Point: Vector3<Scalar: Real>;

    /// The nearest hit in the ray's interval of t; `None` where there is none, or the ray has NaN, an infinite coordinate or no direction.
    fn intersect(&self, ray: &Ray<Self::Point>) -> Option<Hit<Self::Point>>;

    /// Whether anything is met in the ray's interval: the question of a shadow ray, which need not know what and where.
    fn is_hit_by(&self, ray: &Ray<Self::Point>) -> bool {
        self.intersect(ray).is_some()
    }
}
