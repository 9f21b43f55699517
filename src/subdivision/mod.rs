//! Subdivision: curves and surfaces that are what a polygon or a mesh becomes when one cuts its corners for ever.
//!
//! A spline surface needs a rectangular net of control points; a model has corners where three or five faces meet. A *subdivision
//! scheme* starts from a mesh of any connectivity and replaces it by a finer one, whose points are weighted means of the old ones:
//!
//! ```text
//! pₖ₊₁ = S pₖ         limit = lim Sᵏ p₀         each row of S: a mask, weights that sum to 1
//! ```
//!
//! Where the mesh is regular the limit is a B-spline (or a box spline); elsewhere there is no formula, and the masks' eigenvalues say what
//! the surface is like.
//!
//! # Conventions
//!
//! Polygons and meshes are lists of points and of indices, counted from 0. A step is named by its scheme; the masks are pure functions of the
//! valence, apart from connectivity and positions. Meshes of polygons are [`Mesh`](crate::mesh::Mesh)es, joined by [`Connectivity`]; the points may be of
//! any [`VectorSpace`](crate::algebra::VectorSpace), so that a colour is refined like a position. Level 0 is the control mesh.
//!
//! # Numerics
//!
//! Masks with weights that are not negative make means, which magnify no error: k steps add at most k times the rounding of one. Many steps
//! are never taken for the limit, which has masks of its own.
//!
//! # Sources
//!
//! G. Chaikin, *An algorithm for high speed curve generation*, 1974; R. Riesenfeld, *On Chaikin's algorithm*, 1975; J. Lane, R. Riesenfeld,
//! *A theoretical development for the computer generation and display of piecewise polynomial surfaces*, 1980.
//!
//! *In the course*: slides 49 to 79, "Surfaces de subdivision".
//!
//! *In the book*: [Subdivision](../../../subdivision.html).

mod boundary;
mod catmull_clark;
mod connectivity;
mod counts;
pub mod curve;
mod doo_sabin;
mod error;
pub mod evaluate;
pub mod limit;
mod loop_scheme;
pub mod mask;
mod refinement;
mod repair;
mod sqrt3;

pub use catmull_clark::catmull_clark;
pub use connectivity::Connectivity;
pub use counts::Counts;
pub use doo_sabin::{doo_sabin, doo_sabin_with};
pub use error::SubdivisionError;
pub use loop_scheme::{loop_subdivision, loop_subdivision_with};
pub use mask::{Corners, DooSabinWeights};
pub use refinement::{Refinement, Scratch};
pub use repair::{Repair, repaired};
pub use sqrt3::{Sqrt3Boundary, sqrt3, sqrt3_with};
