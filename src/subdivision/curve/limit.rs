//! The limit of a polygon: its points and tangents, the B-spline that it is, and how far the polygon is from it.

use num_traits::{One, Zero};

use super::ends::{check_degree, check_range, control_points};
use super::rounds::{LARGEST_ROUNDS, check_rounds};
use super::step::write_ends;
use super::{Ends, PolygonError};
use crate::algebra::{Scalar, VectorSpace, larger};
use crate::bspline::{BsplineCurve, KnotVector};
use crate::curve::count;

/// The weights of `degree` neighbouring points in the limit point in their middle: the B-spline of integer knots at its inner knots, `(1, 1)/2` for
/// degree 2 and `(1, 4, 1)/6` for degree 3.
///
/// # Accuracy
///
/// Sums of positive terms: each weight has a relative error of at most `3du`.
///
/// # Errors
///
/// [`PolygonError::Degree`] for degree 0 or one above [`LARGEST_DEGREE`](super::LARGEST_DEGREE).
// ANCHOR: limit_weights
pub fn limit_weights<S: Scalar>(degree: usize) -> Result<Vec<S>, PolygonError> {
    check_range(degree, 1)?;
    let mut weights = vec![S::one()];
    for d in 2..=degree {
        // wⱼ = ((j + 1) wⱼ + (d − j) wⱼ₋₁) / d, from the last to the first: those of degree d − 1 are read before they are written over.
        weights.push(S::zero());
        for j in (0..d).rev() {
            let before = j.checked_sub(1).map_or(S::zero(), |index| weights[index]);
            let sum = S::from_i32(count(j + 1)) * weights[j] + S::from_i32(count(d - j)) * before;
            weights[j] = sum / S::from_i32(count(d));
        }
    }
    Ok(weights)
}
// ANCHOR_END: limit_weights

/// Points of the limit, one at each knot: for odd degrees the place to which each vertex goes, for even degrees one for each edge (Chaikin: the midpoints).
///
/// # Shape
///
/// n points for a closed polygon, beginning with the one of the first point or edge; n + 1 − d for open ends; for kept ends n with odd degrees, and n + 1
/// with degree 2, where the end points come first and last.
///
/// # Accuracy
///
/// Each coordinate within `4du` times the largest of the d points' that count: the weights bring `3(d − 1) u`, the products one more and the sums `d − 1`
/// (`limit_point_error_stays_below_its_bound`).
///
/// # Errors
///
/// [`PolygonError::Degree`] and [`PolygonError::EndsNotKept`], as [`lane_riesenfeld_step`](super::lane_riesenfeld_step).
pub fn limit_points<P: VectorSpace>(
    points: &[P],
    degree: usize,
    ends: Ends,
) -> Result<Vec<P>, PolygonError> {
    check_degree(degree, ends)?;
    let weights = limit_weights(degree)?;
    let mut limits = means(&control_points(points, degree, ends), &weights);
    match ends {
        // The limit closes: its last knot is its first.
        Ends::Closed => limits.truncate(points.len()),
        Ends::Kept => write_ends(points, &mut limits),
        Ends::Open => {}
    }
    Ok(limits)
}

/// The derivatives of the limit at the points of [`limit_points`], by its parameter, which grows by 1 from each of them to the next: `P₊ − P` for degree 2,
/// `(P₊ − P₋)/2` for degree 3.
///
/// # Shape
///
/// As many as limit points.
///
/// # Accuracy
///
/// Differences first, then means: each coordinate within `4du` times the largest difference of neighbours that counts.
///
/// # Errors
///
/// As [`limit_points`]; degree 1 has corners instead of tangents, and is refused.
pub fn limit_tangents<P: VectorSpace>(
    points: &[P],
    degree: usize,
    ends: Ends,
) -> Result<Vec<P>, PolygonError> {
    check_range(degree, 2)?;
    check_degree(degree, ends)?;
    let control_points = control_points(points, degree, ends);
    let differences: Vec<P> = differences(&control_points).collect();
    let mut tangents = means(&differences, &limit_weights(degree - 1)?);
    if ends == Ends::Closed {
        tangents.truncate(points.len());
    }
    Ok(tangents)
}

/// The means of neighbours, as many as there are weights.
fn means<P: VectorSpace>(points: &[P], weights: &[P::Scalar]) -> Vec<P> {
    let mean = |window: &[P]| {
        let terms = window.iter().zip(weights);
        let terms = terms.map(|(&point, &weight)| point.times(weight));
        terms.reduce(P::plus).unwrap_or_else(P::origin)
    };
    points.windows(weights.len()).map(mean).collect()
}

/// The steps from each point to the next.
fn differences<P: VectorSpace>(points: &[P]) -> impl Iterator<Item = P> {
    points.windows(2).map(|pair| pair[1].minus(pair[0]))
}

/// The limit itself, a B-spline with uniform knots: its control points are the polygon's and, where the polygon closes or keeps its ends, those that continue it. The
/// domain begins at 0 and has length n (closed), n − d (open) or n − 1 (kept; n for degree 2).
///
/// # Errors
///
/// As [`limit_points`]; [`PolygonError::TooFewPoints`] for open ends with at most d points and for kept ends with no edge,
/// [`PolygonError::PointNotFinite`] for an infinite or NaN coordinate.
pub fn limit_curve<P: VectorSpace>(
    points: &[P],
    degree: usize,
    ends: Ends,
) -> Result<BsplineCurve<P>, PolygonError> {
    check_degree(degree, ends)?;
    let needed = match ends {
        Ends::Closed => 1,
        Ends::Open => degree + 1,
        Ends::Kept => 2,
    };
    if points.len() < needed {
        let found = points.len();
        return Err(PolygonError::TooFewPoints {
            degree,
            needed,
            found,
        });
    }
    if let Some(index) = points.iter().position(|p| !p.has_finite_coordinates()) {
        let point = format!("{:?}", points[index]);
        return Err(PolygonError::PointNotFinite { index, point });
    }
    let control_points = control_points(points, degree, ends);
    let knots = KnotVector::uniform(degree, control_points.len());
    let curve = knots.and_then(|knots| BsplineCurve::new(knots, control_points));
    curve.map_err(|error| PolygonError::NoBspline {
        reason: error.to_string(),
    })
}

/// How far the polygon after so many rounds can be from the limit, in each coordinate: `(d + 1)/24 · 4⁻ᵏ · max |P₋ − 2P + P₊|`.
///
/// It is the distance from a point of the polygon to the point of the limit with the same parameter, so that it bounds the distance
/// between the two as sets of points as well. A parabola attains it.
///
/// # Errors
///
/// [`PolygonError::Degree`] and [`PolygonError::EndsNotKept`], as [`lane_riesenfeld_step`](super::lane_riesenfeld_step);
/// [`PolygonError::TooManyRounds`] above [`LARGEST_ROUNDS`].
// ANCHOR: distance_bound
pub fn distance_bound<P: VectorSpace>(
    points: &[P],
    degree: usize,
    ends: Ends,
    rounds: u32,
) -> Result<P::Scalar, PolygonError> {
    check_degree(degree, ends)?;
    check_rounds(rounds)?;
    let control_points = control_points(points, degree, ends);
    let first_differences: Vec<P> = differences(&control_points).collect();
    let second_differences = differences(&first_differences).map(P::largest_coordinate);
    let bend = second_differences.fold(P::Scalar::zero(), larger);
    let quarter = P::Scalar::ratio(1, 4);
    let shrunk = (0..rounds).fold(bend, |bend, _| bend * quarter);
    // The polygon of degree 1 is its own limit.
    let factor = if degree == 1 { 0 } else { count(degree) + 1 };
    Ok(shrunk * P::Scalar::ratio(factor, 24))
}
// ANCHOR_END: distance_bound

/// The smallest number of rounds after which [`distance_bound`] is not above `tolerance`, in the unit of the points.
///
/// # Errors
///
/// As [`distance_bound`]; [`PolygonError::TooManyRounds`] where [`LARGEST_ROUNDS`] are not enough, as for a tolerance of 0 or NaN or for points
/// that are not finite.
pub fn rounds_within<P: VectorSpace>(
    points: &[P],
    degree: usize,
    ends: Ends,
    tolerance: P::Scalar,
) -> Result<u32, PolygonError> {
    let mut bound = distance_bound(points, degree, ends, 0)?;
    let quarter = P::Scalar::one() / P::Scalar::from_i32(4);
    for rounds in 0..=LARGEST_ROUNDS {
        if bound <= tolerance {
            return Ok(rounds);
        }
        bound = bound * quarter;
    }
    Err(PolygonError::TooManyRounds {
        found: LARGEST_ROUNDS + 1,
        allowed: LARGEST_ROUNDS,
    })
}
