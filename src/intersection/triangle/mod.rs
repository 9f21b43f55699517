//! Triangles: six ways to ask whether a ray meets one, and the one that always answers right.
//!
//! The ray's line meets the plane of the triangle in one point, unless it is parallel; the question is whether that point is inside:
//!
//! ```text
//! o + t d = (1 − v − w) a + v b + w c,     v >= 0,   w >= 0,   v + w <= 1
//! ```
//!
//! All tests solve these three equations by determinants. They differ in what they compute once for all, and in what rounding does to
//! a ray through an edge:
//!
//! | test | kept a triangle | at a shared edge | far from the origin |
//! | --- | --- | --- | --- |
//! | [`half_planes`] (slides) | nothing | rays are lost | t good, edges wrong by `u t` |
//! | [`strict_half_planes`] (slides) | nothing | all rays are lost | as above |
//! | [`moller_trumbore`] | nothing | rays are lost | good |
//! | [`watertight`] | nothing | no ray is lost | good |
//! | [`ShevtsovTriangle`], [`BaldwinWeberTriangle`] | 9 numbers | rays are lost | digits are lost |
//! | [`robust`], [`Triangle`] | nothing | exact | exact |
//!
//! # Conventions
//!
//! Corners run anticlockwise as seen from the front: the normal is `n = (b − a) × (c − a)`, and a ray with `d · n < 0` hits the front.
//! Edges and corners belong to the triangle. A ray in the plane of a triangle misses it. Parameters are the weights of b and of c.
//!
//! # Numerics
//!
//! All tests but [`robust`] need a field only, and are one and the same over exact numbers.
//!
//! # Sources
//!
//! T. Möller, B. Trumbore, *Fast, minimum storage ray/triangle intersection*, 1997; M. Shevtsov, A. Soupikov, A. Kapustin, *Ray-triangle
//! intersection algorithm for modern CPU architectures*, 2007; S. Woop, C. Benthin, I. Wald, *Watertight ray/triangle intersection*,
//! 2013; D. Baldwin, M. Weber, *Fast ray-triangle intersections by coordinate transformation*, 2016; J. R. Shewchuk, *Adaptive
//! precision floating-point arithmetic and fast robust geometric predicates*, 1997; U. Kulisch, *Computer arithmetic and validity*, 2013.
//!
//! *In the course*: slides 99 to 101 (*intersection rayon-triangle*, *demi-plan*).
//!
//! *In the book*: [Triangles](../../../../intersection/triangles.html).

mod accumulator;
mod facet;
mod half_planes;
mod moller_trumbore;
mod precomputed;
mod prescale;
mod robust;
mod watertight;

pub use facet::Triangle;
pub use half_planes::{half_planes, strict_half_planes};
pub use moller_trumbore::moller_trumbore;
pub use precomputed::{BaldwinWeberTriangle, ShevtsovTriangle};
pub use prescale::prescaled;
pub use robust::robust;
pub use watertight::{ShearedRay, watertight};

use super::{FacetHit, Side};
use crate::algebra::{Scalar, Vector3};
use crate::ray::Ray;

/// The hit, where t belongs to the ray.
#[inline]
pub(super) fn facet_hit<P: Vector3>(
    ray: &Ray<P>,
    t: P::Scalar,
    parameters: [P::Scalar; 2],
    side: Side,
) -> Option<FacetHit<P::Scalar>> {
    let hit = FacetHit {
        t,
        parameters,
        side,
    };
    (ray.reaches(t) && t.is_finite()).then_some(hit)
}
