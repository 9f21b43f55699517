//! The chapter with one typical mistake in it, chosen at run time: what `cargo exercise verify` runs the theorems on.

use std::env;
use std::sync::OnceLock;

// The mistakes call the book's library by its own name.
extern crate reference as facette;

pub use reference::*;

#[path = "@ROOT@/tests/subdivision/mistakes.rs"]
#[allow(dead_code, reason = "the tests use more of it than this package")]
pub mod mistakes;

/// The name of the mistake, from `FACETTE_MISTAKE`; empty for none.
fn chosen() -> &'static str {
    static NAME: OnceLock<String> = OnceLock::new();
    NAME.get_or_init(|| env::var("FACETTE_MISTAKE").unwrap_or_default())
}

/// Subdivision, with the mistake where it belongs to a function and the book's own elsewhere.
pub mod subdivision {
    pub use reference::subdivision::*;

    use crate::algebra::{Real, VectorSpace};
    use crate::mesh::Mesh;
    use crate::{chosen, mistakes};
    use reference::subdivision::mask::{loop_vertex_weight, turn_cosine};

    /// Exercise 4.
    pub fn catmull_clark<P: VectorSpace>(
        connectivity: &Connectivity,
        points: &[P],
        corners: Corners,
    ) -> Result<Mesh<P>, SubdivisionError> {
        mistakes::catmull_clark(chosen(), connectivity, points, corners)
            .unwrap_or_else(|| reference::subdivision::catmull_clark(connectivity, points, corners))
    }

    /// Exercise 5, with its own weight.
    pub fn loop_subdivision<P: VectorSpace>(
        connectivity: &Connectivity,
        points: &[P],
        corners: Corners,
    ) -> Result<Mesh<P>, SubdivisionError>
    where
        P::Scalar: Real,
    {
        let weight = |n| loop_vertex_weight(turn_cosine(1, n));
        mistakes::loop_subdivision(chosen(), connectivity, points, corners)
            .unwrap_or_else(|| loop_subdivision_with(connectivity, points, corners, weight))
    }

    /// Exercise 5, with any weight.
    pub fn loop_subdivision_with<P: VectorSpace>(
        connectivity: &Connectivity,
        points: &[P],
        corners: Corners,
        weight: impl Fn(usize) -> P::Scalar,
    ) -> Result<Mesh<P>, SubdivisionError> {
        mistakes::loop_subdivision_with(chosen(), connectivity, points, corners, &weight)
            .unwrap_or_else(|| {
                reference::subdivision::loop_subdivision_with(connectivity, points, corners, weight)
            })
    }

    /// Polygons.
    pub mod curve {
        pub use reference::subdivision::curve::*;

        use crate::algebra::VectorSpace;
        use crate::{chosen, mistakes};

        /// Exercise 1.
        pub fn chaikin_step<P: VectorSpace>(points: &[P], ends: Ends) -> Vec<P> {
            mistakes::chaikin_step(chosen(), points, ends)
                .unwrap_or_else(|| reference::subdivision::curve::chaikin_step(points, ends))
        }

        /// Exercise 2.
        pub fn cubic_step<P: VectorSpace>(points: &[P], ends: Ends) -> Vec<P> {
            mistakes::cubic_step(chosen(), points, ends)
                .unwrap_or_else(|| reference::subdivision::curve::cubic_step(points, ends))
        }

        /// Exercise 3.
        pub fn double_and_average<P: VectorSpace>(points: &[P], degree: usize) -> Vec<P> {
            mistakes::double_and_average(chosen(), points, degree)
                .unwrap_or_else(|| reference::subdivision::curve::double_and_average(points, degree))
        }
    }
}
