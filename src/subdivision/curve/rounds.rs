//! Many rounds: how many points they make, and the polygon itself.

use super::ends::check_degree;
use super::step::{chaikin_step, cubic_step, lane_riesenfeld_step};
use super::{Ends, PolygonError};
use crate::algebra::VectorSpace;

/// The largest number of rounds: one more would make of a single closed point more points than 32 bits number.
pub const LARGEST_ROUNDS: u32 = 31;

/// The largest number of points, as many as 32 bits can number.
pub const LARGEST_POINT_COUNT: usize = u32::MAX as usize;

/// How many points `count` points become in so many rounds: `2ᵏn` if the polygon is closed, `2ᵏ(n − d) + d` (or none) if its ends are open,
/// and if they are kept `2ᵏn` for degree 2, `2ᵏ(n − 1) + 1` for odd degrees.
///
/// # Errors
///
/// [`PolygonError::Degree`] and [`PolygonError::EndsNotKept`] as [`lane_riesenfeld_step`]; [`PolygonError::TooManyRounds`] above
/// [`LARGEST_ROUNDS`], [`PolygonError::TooManyPoints`] above [`LARGEST_POINT_COUNT`].
pub fn point_count(
    count: usize,
    degree: usize,
    ends: Ends,
    rounds: u32,
) -> Result<usize, PolygonError> {
    check_degree(degree, ends)?;
    check_rounds(rounds)?;
    // What is left over when the spans are doubled.
    let fixed = match ends {
        Ends::Closed => 0,
        Ends::Open => degree,
        Ends::Kept => degree % 2,
    };
    // 2ᵏ(n − f) + f, or none where a polygon with fewer points than f has lost them all.
    let [points, fixed] = [count, fixed].map(|number| number as u128);
    let result = ((points << rounds) + fixed).saturating_sub(fixed << rounds);
    match usize::try_from(result) {
        Ok(result) if result <= LARGEST_POINT_COUNT => Ok(result),
        _ => Err(PolygonError::TooManyPoints {
            count,
            rounds,
            result,
            allowed: LARGEST_POINT_COUNT,
        }),
    }
}

/// Refuses more rounds than are possible.
pub(super) fn check_rounds(rounds: u32) -> Result<(), PolygonError> {
    if rounds <= LARGEST_ROUNDS {
        return Ok(());
    }
    Err(PolygonError::TooManyRounds {
        found: rounds,
        allowed: LARGEST_ROUNDS,
    })
}

/// The polygon after so many rounds: by [`chaikin_step`] for degree 2, [`cubic_step`] for degree 3, [`lane_riesenfeld_step`] otherwise.
///
/// # Accuracy
///
/// Each coordinate within `k max(2, d) u` times the largest of all (`rounding_does_not_pile_up`); with kept ends and a degree above 3, the largest of
/// the mirrored points too.
///
/// # Cost
///
/// Proportional to the number of points in the end, which [`point_count`] says.
///
/// # Errors
///
/// As [`point_count`]; [`PolygonError::OutOfMemory`] where the finer polygon finds no room.
pub fn subdivided<P: VectorSpace>(
    points: &[P],
    degree: usize,
    ends: Ends,
    rounds: u32,
) -> Result<Vec<P>, PolygonError> {
    let in_the_end = point_count(points.len(), degree, ends, rounds)?;
    check_memory::<P>(in_the_end)?;
    let mut finer = points.to_vec();
    for _ in 0..rounds {
        finer = match degree {
            2 => chaikin_step(&finer, ends),
            3 => cubic_step(&finer, ends),
            _ => lane_riesenfeld_step(&finer, degree, ends)?,
        };
    }
    Ok(finer)
}

/// Asks for the memory of a polygon and of the one before it, and gives it back: a step itself could only abort.
fn check_memory<P>(points: usize) -> Result<(), PolygonError> {
    let with_the_polygon_before = points.saturating_add(points / 2);
    let mut probe: Vec<P> = Vec::new();
    probe
        .try_reserve_exact(with_the_polygon_before)
        .map_err(|_| PolygonError::OutOfMemory { points })
}
