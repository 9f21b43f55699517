//! Exact evaluation: the limit surface at any parameter of any face, without refining the mesh.
//!
//! Where the mesh is regular, the surface above a face is a polynomial: a patch of the bicubic B-spline (Catmull-Clark) or of the quartic box
//! spline (Loop). Next to an extraordinary vertex it is an infinite sequence of such patches, three to a step, which shrink towards the
//! vertex. The points of the k-th three come from the points around the vertex by k steps of one linear map:
//!
//! ```text
//! pₖ = Aᵏ p₀ = Σ λᵢᵏ aᵢ xᵢ            A xᵢ = λᵢ xᵢ
//! ```
//!
//! Two ways to them are kept here. The *feature-adaptive* one does the k steps, on the few points that count. *Stam's* writes the points in
//! eigenvectors, once for the surface, and raises eigenvalues to the k-th power.
//!
//! # Conventions
//!
//! A quadrilateral has parameters (u, v) in [0, 1]²: its vertices are at (0, 0), (1, 0), (1, 1), (0, 1), in their order. Each corner of any polygon
//! has parameters of its own in [0, 1]²: its vertex at (0, 0), the middle of its half-edge at (1, 0), the face point at (1, 1). On a quadrilateral
//! they are a quarter of the face's. A triangle of Loop's surface has barycentric parameters. Parameters outside are moved to the nearest
//! inside, one by one; NaN gives NaN.
//!
//! # Numerics
//!
//! All points are kept relative to a point of their patch, so that a far origin costs nothing but the rounding of the result. Next to an
//! extraordinary vertex the limit point is taken off at each step: what remains is as small as the neighbourhood, and so are its errors.
//! That keeps derivatives and normals to the last bits, at any depth.
//!
//! Derivatives grow or shrink by 2λ a step. With Catmull-Clark λ is below 1/2 for valence 3, so that they vanish at such a vertex, and above
//! from valence 5 on, so that they are unbounded. The surface is smooth all the same: it is the parameters that are not. At the vertex
//! itself there is a normal, but no derivative.
//!
//! # Sources
//!
//! J. Stam, *Exact evaluation of Catmull-Clark subdivision surfaces at arbitrary parameter values*, 1998, and *Evaluation of Loop subdivision
//! surfaces*, 1998; M. Nießner, C. Loop, M. Meyer, T. DeRose, *Feature-adaptive GPU rendering of Catmull-Clark subdivision surfaces*, 2012; H. Biermann,
//! A. Levin, D. Zorin, *Piecewise smooth subdivision surfaces with normal control*, 2000 (boundaries). The confluent form of the eigenbasis is ours.
//!
//! *In the course*: slides 72 to 78 (*points extraordinaires*).
//!
//! *In the book*: [Evaluation](../../../../subdivision/evaluation.html).

mod adaptive;
mod bicubic;
mod box_spline;
mod catmull_clark;
mod corner_table;
mod eigenbasis;
mod jet;
mod loop_surface;
mod quad_corner;
mod quad_gather;
mod quad_modes;
mod quadrants;
mod triangle_corner;
mod triangle_gather;
mod triangle_modes;

use thiserror::Error;

pub use catmull_clark::CatmullClarkSurface;
pub use loop_surface::LoopSurface;

use super::SubdivisionError;
use crate::algebra::{Scalar, VectorSpace};

/// A point of a surface with its partial derivatives in the parameters (u, v).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Derivatives<P> {
    /// The point.
    pub point: P,
    /// `[S_u, S_v]`.
    pub first: [P; 2],
    /// `[S_uu, S_uv, S_vv]`. On the border between two patches that meet at an extraordinary vertex these are the ones of one side.
    pub second: [P; 3],
}

impl<P> Derivatives<P> {
    fn of_jet([point, s_u, s_v, s_uu, s_uv, s_vv]: [P; 6]) -> Self {
        Self {
            point,
            first: [s_u, s_v],
            second: [s_uu, s_uv, s_vv],
        }
    }
}

/// Why a surface cannot be made or evaluated.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum EvaluationError {
    /// The mesh cannot be subdivided.
    #[error(transparent)]
    Mesh(#[from] SubdivisionError),
    /// A control point has an infinite or NaN coordinate.
    #[error("control point {vertex} is {point}: every coordinate must be finite")]
    PointNotFinite {
        /// Which point, counted from 0.
        vertex: usize,
        /// The point as text.
        point: String,
    },
    /// There is no face of this number.
    #[error("there is no face {face}: the {count} faces are counted from 0")]
    NoSuchFace {
        /// The number.
        face: u32,
        /// How many faces there are.
        count: usize,
    },
    /// There is no half-edge of this number.
    #[error("there is no half-edge {half_edge}: the {count} half-edges are counted from 0")]
    NoSuchHalfEdge {
        /// The number.
        half_edge: u32,
        /// How many half-edges there are.
        count: usize,
    },
    /// A polygon has parameters at its corners only.
    #[error(
        "face {face} has {found} vertices, and two parameters for a whole face need 4: ask at one of its corners"
    )]
    NotAQuadrilateral {
        /// Which face, counted from 0.
        face: u32,
        /// How many vertices it has.
        found: usize,
    },
    /// At an extraordinary vertex there are no derivatives.
    #[error(
        "these are the parameters of an extraordinary vertex, where derivatives vanish or are unbounded: ask for the normal"
    )]
    NoDerivatives,
    /// The tangents are zero or parallel up to rounding.
    #[error("the tangents are zero or parallel here: a normal needs two that span a plane")]
    NoNormal,
}

/// Refuses points that do not fit the mesh or are not finite.
fn check_points<P: VectorSpace>(
    connectivity: &super::Connectivity,
    points: &[P],
) -> Result<(), EvaluationError> {
    connectivity.must_have_points(points.len())?;
    let is_bad = |point: &P| !point.has_finite_coordinates();
    points.iter().position(is_bad).map_or(Ok(()), |vertex| {
        let point = format!("{:?}", points[vertex]);
        Err(EvaluationError::PointNotFinite { vertex, point })
    })
}

/// The nearest number in [0, 1]; NaN for NaN.
fn clamped<S: Scalar>(parameter: S) -> S {
    if parameter < S::zero() {
        S::zero()
    } else if parameter > S::one() {
        S::one()
    } else {
        parameter
    }
}
