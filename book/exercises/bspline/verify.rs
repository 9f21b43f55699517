//! The chapter with one typical mistake in it, chosen at run time: what `cargo exercise verify` runs the theorems on.

use std::env;
use std::sync::OnceLock;

// The mistakes call the book's library by its own name.
extern crate reference as facette;

pub use reference::*;

#[path = "@ROOT@/tests/bspline/mistakes.rs"]
#[allow(dead_code, reason = "the tests use more of it than this package")]
pub mod mistakes;

/// The name of the mistake, from `FACETTE_MISTAKE`; empty for none.
fn chosen() -> &'static str {
    static NAME: OnceLock<String> = OnceLock::new();
    NAME.get_or_init(|| env::var("FACETTE_MISTAKE").unwrap_or_default())
}

/// B-splines, with the mistake where it belongs to a function and the book's own elsewhere.
pub mod bspline {
    pub use reference::bspline::*;

    use crate::algebra::{Scalar, VectorSpace};
    use crate::{chosen, mistakes};
    use reference::bspline as right;

    /// Exercise 1, first part.
    pub fn find_span<S: Scalar>(knots: &KnotVector<S>, u: S) -> usize {
        mistakes::find_span(chosen(), knots, u).unwrap_or_else(|| right::find_span(knots, u))
    }

    /// Exercise 1, second part.
    pub fn cox_de_boor<S: Scalar>(knots: &KnotVector<S>, degree: usize, i: usize, u: S) -> S {
        mistakes::cox_de_boor(chosen(), knots, degree, i, u)
            .unwrap_or_else(|| right::cox_de_boor(knots, degree, i, u))
    }

    /// Exercise 1, third part.
    pub fn basis_functions<S: Scalar>(knots: &KnotVector<S>, span: usize, u: S, values: &mut [S]) {
        match mistakes::basis_functions(chosen(), knots, span, u) {
            Some(wrong) => values.copy_from_slice(&wrong),
            None => right::basis_functions(knots, span, u, values),
        }
    }

    /// Exercise 2.
    pub fn de_boor_point<P: VectorSpace>(
        knots: &KnotVector<P::Scalar>,
        control_points: &[P],
        u: P::Scalar,
    ) -> P {
        mistakes::de_boor_point(chosen(), knots, control_points, u)
            .unwrap_or_else(|| right::de_boor_point(knots, control_points, u))
    }

    /// Exercise 3.
    pub fn insert_knot<P: VectorSpace>(
        knots: &KnotVector<P::Scalar>,
        control_points: &[P],
        u: P::Scalar,
    ) -> Vec<P> {
        mistakes::insert_knot(chosen(), knots, control_points, u)
            .unwrap_or_else(|| right::insert_knot(knots, control_points, u))
    }

    /// Exercise 4.
    pub fn surface_point<P: VectorSpace>(
        surface: &BsplineSurface<P>,
        u: P::Scalar,
        v: P::Scalar,
    ) -> P {
        mistakes::surface_point(chosen(), surface, u, v)
            .unwrap_or_else(|| right::surface_point(surface, u, v))
    }
}
