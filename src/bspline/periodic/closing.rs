//! How a direction of a surface closes, and which knots allow it.

use thiserror::Error;

use crate::algebra::{Scalar, larger};
use crate::bspline::{BsplineError, Direction, KnotVector};

/// How the two sides of a surface that lie opposite each other in one direction are joined.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Closing {
    /// They are not joined.
    Open,
    /// The end is the start.
    Closed,
    /// The end is the start, run through backwards.
    Flipped,
}

/// What keeps a surface from closing.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum PeriodicError<S: std::fmt::Debug> {
    /// The knots or control points are refused.
    #[error(transparent)]
    Bspline(#[from] BsplineError<S>),
    /// The distinct control points are not as many as the knots ask for.
    #[error(
        "the knots ask for {} x {} distinct control points (in a direction that closes, the last p are made from the first), but \
         there are {found}", expected[0], expected[1]
    )]
    WrongPointCount {
        /// How many the knots ask for, in u and in v.
        expected: [usize; 2],
        /// How many there are.
        found: usize,
    },
    /// The knots of a direction that closes do not go on at the end as they do at the start.
    #[error(
        "the spacing between the knots {index} and {} in {direction} is {first:?}, and one period later {later:?}: a surface closes \
         where they are equal", index + 1
    )]
    SpacingsDiffer {
        /// The direction that closes.
        direction: Direction,
        /// The first of the two knots, counted from 0.
        index: usize,
        /// Their distance.
        first: S,
        /// The distance of the two knots one period later.
        later: S,
    },
    /// A flip needs knots across it that read the same from both ends.
    #[error(
        "to flip {flipped}, the knots in the other direction must be symmetric: the spacing after knot {index} is {spacing:?}, its \
         mirror image {mirrored:?}"
    )]
    NotSymmetric {
        /// The direction that closes with a flip.
        flipped: Direction,
        /// The knot before the spacing, counted from 0.
        index: usize,
        /// The spacing.
        spacing: S,
        /// The spacing as far from the other end.
        mirrored: S,
    },
    /// A flip needs an open direction across it.
    #[error("{flipped} can close with a flip only where the other direction is open")]
    FlipNeedsOpenSides {
        /// The direction that closes with a flip.
        flipped: Direction,
    },
}

/// How many distinct control points these knots take in their direction.
pub(super) fn distinct_count<S: Scalar>(knots: &KnotVector<S>, closing: Closing) -> usize {
    match closing {
        Closing::Open => knots.control_point_count(),
        Closing::Closed | Closing::Flipped => knots.control_point_count() - knots.degree(),
    }
}

/// Checks that a direction can close as it should: its own spacings repeat, and a flip finds symmetric knots across it.
pub(super) fn check_closing<S: Scalar>(
    direction: Direction,
    [own, across]: [&KnotVector<S>; 2],
    [closing, other]: [Closing; 2],
) -> Result<(), PeriodicError<S>> {
    if closing == Closing::Open {
        return Ok(());
    }
    let later = |index| index + distinct_count(own, closing);
    // The first and the last knot of all have no influence in the domain.
    let at_seam = 1..(2 * own.degree()).saturating_sub(1);
    if let Some((index, [first, later])) = first_difference(own, at_seam, later) {
        return Err(PeriodicError::SpacingsDiffer {
            direction,
            index,
            first,
            later,
        });
    }
    if closing == Closing::Closed {
        return Ok(());
    }
    if other != Closing::Open {
        return Err(PeriodicError::FlipNeedsOpenSides { flipped: direction });
    }
    let last = across.knots().len() - 2;
    let inner = across.degree().min(1);
    match first_difference(across, inner..last + 1 - inner, |index| last - index) {
        Some((index, [spacing, mirrored])) => Err(PeriodicError::NotSymmetric {
            flipped: direction,
            index,
            spacing,
            mirrored,
        }),
        None => Ok(()),
    }
}

/// The first of these indices whose spacing, the distance from its knot to the next, differs from that at its partner's; with both.
fn first_difference<S: Scalar>(
    knots: &KnotVector<S>,
    mut indices: std::ops::Range<usize>,
    partner: impl Fn(usize) -> usize,
) -> Option<(usize, [S; 2])> {
    indices.find_map(|index| {
        let pair = [index, partner(index)].map(|knot| {
            let [start, end] = knots.span_interval(knot);
            end - start
        });
        let is_equal = is_equal_up_to_rounding(knots.knots(), pair[0], pair[1]);
        (!is_equal).then_some((index, pair))
    })
}

/// Whether two spacings of these knots may be one and the same before rounding.
///
/// With `M` the largest absolute knot: a knot that is made from another one and a multiple of the period, itself at most `2M`, is wrong by
/// at most `5uM` (`2uM` each for the rounded period and its multiple, `uM` for the sum). Four such knots make the difference of two
/// spacings, each of which is rounded by at most `2uM` once more: `24uM`.
fn is_equal_up_to_rounding<S: Scalar>(knots: &[S], a: S, b: S) -> bool {
    let [first, last] = [knots[0], knots[knots.len() - 1]].map(Scalar::magnitude);
    let largest = larger(first, last);
    (a - b).magnitude() <= S::from_i32(24) * S::unit_roundoff() * largest
}
