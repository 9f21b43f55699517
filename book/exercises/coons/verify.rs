//! The chapter with one typical mistake in it, chosen at run time: what `cargo exercise verify` runs the theorems on.

use std::env;
use std::sync::OnceLock;

// The mistakes call the book's library by its own name.
extern crate reference as facette;

pub use reference::*;

#[path = "@ROOT@/tests/coons/mistakes.rs"]
#[allow(dead_code, reason = "the tests use more of it than this package")]
pub mod mistakes;

/// The name of the mistake, from `FACETTE_MISTAKE`; empty for none.
fn chosen() -> &'static str {
    static NAME: OnceLock<String> = OnceLock::new();
    NAME.get_or_init(|| env::var("FACETTE_MISTAKE").unwrap_or_default())
}

/// Coons patches, with the mistake where it belongs to a function and the book's own elsewhere.
pub mod coons {
    pub use reference::coons::*;

    use crate::algebra::Scalar;
    use crate::curve::Curve;
    use crate::{chosen, mistakes};

    /// Exercise 1.
    pub fn bilinear_point<C: Curve>(
        boundary: &Boundary<C>,
        u: C::Scalar,
        v: C::Scalar,
    ) -> C::Point {
        mistakes::bilinear_point(chosen(), boundary, u, v)
            .unwrap_or_else(|| reference::coons::bilinear_point(boundary, u, v))
    }

    /// Exercise 2.
    pub fn bilinear_partials<C: Curve>(
        boundary: &Boundary<C>,
        u: C::Scalar,
        v: C::Scalar,
    ) -> Option<[C::Point; 2]> {
        mistakes::bilinear_partials(chosen(), boundary, u, v)
            .unwrap_or_else(|| reference::coons::bilinear_partials(boundary, u, v))
    }

    /// Exercise 3, first part.
    pub fn hermite_basis<S: Scalar>(t: S) -> [S; 4] {
        mistakes::hermite_basis(chosen(), t)
            .unwrap_or_else(|| reference::coons::hermite_basis(t))
    }

    /// Exercise 3, second part.
    pub fn bicubic_point<C: Curve>(
        data: &HermiteBoundary<C>,
        u: C::Scalar,
        v: C::Scalar,
    ) -> C::Point {
        mistakes::bicubic_point(chosen(), data, u, v)
            .unwrap_or_else(|| reference::coons::bicubic_point(data, u, v))
    }
}
