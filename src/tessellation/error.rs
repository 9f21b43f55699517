//! What keeps a surface from being tessellated.

use std::fmt::Debug;

use thiserror::Error;

use crate::bspline::Direction;
use crate::mesh::MeshError;

/// What is wrong with a tolerance or a surface.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum TessellationError<S: Debug> {
    /// The tolerance is no distance.
    #[error("the tolerance is {tolerance:?}: it must be a positive, finite distance")]
    Tolerance {
        /// The tolerance.
        tolerance: S,
    },
    /// The triangles would be too many.
    #[error(
        "a chord error of {tolerance:?} needs more than {limit} vertices here: take a larger tolerance, or allow more vertices"
    )]
    TooManyVertices {
        /// The tolerance.
        tolerance: S,
        /// How many vertices are allowed.
        limit: u32,
    },
    /// The parameters cannot be told apart any more.
    #[error(
        "next to (u, v) = ({:?}, {:?}) the parameters of neighbouring vertices are one number: the tolerance is too small for \
         this type of number", at[0], at[1]
    )]
    ParametersTooClose {
        /// Parameters of the place.
        at: [S; 2],
    },
    /// A second derivative has no usable bound.
    #[error(
        "on [{:?}, {:?}] x [{:?}, {:?}] the bounds of |S_uu|, |S_uv|, |S_vv| are {bounds:?}: they must be finite and not negative",
        rectangle[0][0], rectangle[0][1], rectangle[1][0], rectangle[1][1]
    )]
    Bounds {
        /// The parameter rectangle.
        rectangle: [[S; 2]; 2],
        /// The bounds of the second derivatives there.
        bounds: [S; 3],
    },
    /// The breaks do not cut the domain into pieces.
    #[error(
        "the breaks in {direction} are {breaks:?}: they must increase from {:?} to {:?}, the ends of the domain",
        domain[0], domain[1]
    )]
    Breaks {
        /// The direction, u or v.
        direction: Direction,
        /// Their parameters.
        breaks: Vec<S>,
        /// The domain in that direction.
        domain: [S; 2],
    },
    /// Breaks of a closure that tear its surface.
    #[error(
        "the break at {direction} = {at:?} is said to be torn, but the wrapped surface has one point there for both sides: make it a crease, \
         or implement `BoundedSurface::point_in` for a surface that jumps"
    )]
    TornBreak {
        /// The direction, u or v.
        direction: Direction,
        /// Its parameter.
        at: S,
    },
    /// A polygon cannot be cut into triangles.
    #[error(
        "the loop's polygon of {corners} corners could be cut into {triangles} triangles only, not {}: rounding hides on which side of each \
         other its other corners lie", corners - 2
    )]
    Polygon {
        /// How many corners it has.
        corners: usize,
        /// How many triangles could be cut off.
        triangles: usize,
    },
    /// Sides that are said to be joined do not meet.
    #[error(
        "the surface is said to close in {direction}, but at {at:?} along the seam its two sides are {gap:?} apart, where rounding \
         explains {allowed:?}"
    )]
    SeamOpen {
        /// The direction, u or v.
        direction: Direction,
        /// The parameter along the seam.
        at: S,
        /// The distance, in the largest coordinate.
        gap: S,
        /// What rounding explains.
        allowed: S,
    },
    /// A seam joins sides that are cut into different pieces.
    #[error(
        "the surface is said to close in {direction} with a flip, but its breaks across are not symmetric: {first:?} after the start, {last:?} \
         before the end"
    )]
    SeamNotSymmetric {
        /// The direction that closes.
        direction: Direction,
        /// The length of a piece.
        first: S,
        /// The length of its mirror image.
        last: S,
    },
    /// The surface has a point that is not finite.
    #[error(transparent)]
    Mesh(#[from] MeshError),
}
