//! What keeps a polygon from being subdivided.

use thiserror::Error;

/// What is wrong with a degree, a polygon, or a number of rounds.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum PolygonError {
    /// No scheme here has this degree.
    #[error("degree {found}: expected one from {smallest} to {largest}")]
    Degree {
        /// The degree.
        found: usize,
        /// The smallest that is possible.
        smallest: usize,
        /// The largest.
        largest: usize,
    },
    /// No rule that is the same in every round keeps the ends.
    #[error(
        "degree {degree}: ends are kept for degree 2 and for odd degrees; expected one of these, or a polygon that is closed or open"
    )]
    EndsNotKept {
        /// The degree.
        degree: usize,
    },
    /// More rounds than any polygon that grows can go through.
    #[error("{found} rounds: at most {allowed} are possible, since each doubles the points")]
    TooManyRounds {
        /// How many are asked for.
        found: u32,
        /// How many are possible.
        allowed: u32,
    },
    /// The finer polygon has more points than 32 bits count.
    #[error(
        "{rounds} rounds make {result} points of {count}: at most {allowed} are possible, so fewer rounds are"
    )]
    TooManyPoints {
        /// How many points there are.
        count: usize,
        /// How many rounds are asked for.
        rounds: u32,
        /// How many points they make.
        result: u128,
        /// How many are possible.
        allowed: usize,
    },
    /// The finer polygon does not fit into memory.
    #[error("no memory for {points} points: fewer rounds need less")]
    OutOfMemory {
        /// How many points it has.
        points: usize,
    },
    /// The polygon has no limit curve.
    #[error("{found} points of degree {degree}: a limit curve needs at least {needed}")]
    TooFewPoints {
        /// The degree.
        degree: usize,
        /// How many points it needs.
        needed: usize,
        /// How many there are.
        found: usize,
    },
    /// A point is infinite or NaN.
    #[error("point {index} is {point}: every coordinate must be finite")]
    PointNotFinite {
        /// Which point, counted from 0.
        index: usize,
        /// The point as text.
        point: String,
    },
    /// The control points and their knots make no B-spline.
    #[error("no B-spline: {reason}")]
    NoBspline {
        /// What the B-spline says.
        reason: String,
    },
}
