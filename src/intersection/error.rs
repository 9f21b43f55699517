//! What keeps a surface from being made.

use std::fmt::Debug;

use thiserror::Error;

use crate::algebra::{Scalar, Vector3, check_finite};

/// What is wrong with the data of a surface.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum IntersectionError<S: Debug> {
    /// A point or a vector has a coordinate that is NaN or infinite.
    #[error("{what} is {coordinates:?}: its coordinates must be finite")]
    NotFinite {
        /// What it is the point or vector of.
        what: &'static str,
        /// Its coordinates.
        coordinates: [S; 3],
    },
    /// The radius is no length.
    #[error("the radius is {radius:?}: it must be a positive, finite length")]
    Radius {
        /// The radius.
        radius: S,
    },
    /// A plane's normal has no direction.
    #[error("the normal is the zero vector: a plane needs a direction that it is perpendicular to")]
    NormalIsZero,
    /// A box ends before it begins.
    #[error(
        "along axis {axis} the box runs from {min:?} to {max:?}: it must not end before it begins"
    )]
    BoxIsReversed {
        /// The axis: 0 for x, 1 for y, 2 for z.
        axis: usize,
        /// Where the box begins there.
        min: S,
        /// Where it ends.
        max: S,
    },
    /// A box around nothing.
    #[error("there is no box around no points: at least one is needed")]
    NoPoints,
}

impl<S: Scalar> IntersectionError<S> {
    /// Passes where every coordinate is finite.
    pub(super) fn check_finite<P>(what: &'static str, vector: P) -> Result<(), Self>
    where
        P: Vector3<Scalar = S>,
    {
        check_finite(vector, |coordinates| Self::NotFinite { what, coordinates })
    }
}
