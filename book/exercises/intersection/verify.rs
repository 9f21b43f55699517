//! The chapter with one typical mistake in it, chosen at run time: what `cargo exercise verify` runs the theorems on.

use std::env;
use std::sync::OnceLock;

// The mistakes call the book's library by its own name.
extern crate reference as facette;

pub use reference::*;

#[path = "@ROOT@/tests/intersection/mistakes.rs"]
#[allow(dead_code, reason = "the tests use more of it than this package")]
pub mod mistakes;

/// The name of the mistake, from `FACETTE_MISTAKE`; empty for none.
fn chosen() -> &'static str {
    static NAME: OnceLock<String> = OnceLock::new();
    NAME.get_or_init(|| env::var("FACETTE_MISTAKE").unwrap_or_default())
}

/// Intersections, with the mistake where it belongs to a function and the book's own elsewhere.
pub mod intersection {
    pub use reference::intersection::*;

    use crate::algebra::{Real, Vector3};
    use crate::ray::Ray;
    use crate::{chosen, mistakes};
    use reference::intersection as right;

    /// Exercise 1, first part.
    pub fn roots_by_quadratic<P>(p: P, d: P, r: P::Scalar) -> Option<[P::Scalar; 2]>
    where
        P: Vector3,
        P::Scalar: Real,
    {
        mistakes::roots_by_quadratic(chosen(), p, d, r)
            .unwrap_or_else(|| right::roots_by_quadratic(p, d, r))
    }

    /// Exercise 1, second part.
    pub fn first_root<P: Vector3>(roots: [P::Scalar; 2], ray: &Ray<P>) -> Option<P::Scalar> {
        mistakes::first_root(chosen(), roots, ray).unwrap_or_else(|| right::first_root(roots, ray))
    }

    /// Exercise 2.
    pub fn roots_by_projection<P>(p: P, d: P, r: P::Scalar) -> Option<[P::Scalar; 2]>
    where
        P: Vector3,
        P::Scalar: Real,
    {
        mistakes::roots_by_projection(chosen(), p, d, r)
            .unwrap_or_else(|| right::roots_by_projection(p, d, r))
    }

    /// Exercise 3.
    pub fn box_interval<P: Vector3>(
        bounds: &BoundingBox<P>,
        ray: &Ray<P>,
    ) -> Option<[P::Scalar; 2]> {
        mistakes::box_interval(chosen(), bounds, ray)
            .unwrap_or_else(|| right::box_interval(bounds, ray))
    }

    /// Exercise 4.
    pub fn nearest<T: Intersect>(
        members: &[T],
        ray: &Ray<T::Point>,
    ) -> Option<(usize, Hit<T::Point>)> {
        mistakes::nearest(chosen(), members, ray).unwrap_or_else(|| right::nearest(members, ray))
    }

    /// Triangles, likewise.
    pub mod triangle {
        pub use reference::intersection::triangle::*;

        use crate::algebra::Vector3;
        use crate::intersection::FacetHit;
        use crate::ray::Ray;
        use crate::{chosen, mistakes};
        use reference::intersection::triangle as right;

        /// Exercise 5.
        pub fn half_planes<P: Vector3>(
            corners: &[P; 3],
            ray: &Ray<P>,
        ) -> Option<FacetHit<P::Scalar>> {
            mistakes::half_planes(chosen(), corners, ray)
                .unwrap_or_else(|| right::half_planes(corners, ray))
        }

        /// Exercise 6.
        pub fn moller_trumbore<P: Vector3>(
            corners: &[P; 3],
            ray: &Ray<P>,
        ) -> Option<FacetHit<P::Scalar>> {
            mistakes::moller_trumbore(chosen(), corners, ray)
                .unwrap_or_else(|| right::moller_trumbore(corners, ray))
        }
    }
}
