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
