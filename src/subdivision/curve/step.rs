//! One round of each scheme.

use super::ends::{check_degree, control_points, phantoms_before};
use super::{Ends, PolygonError};
use crate::algebra::{Scalar, VectorSpace};

/// The polygon with its corners cut: on every edge from P to P₊ the points `Q = 3/4 P + 1/4 P₊` and `R = 1/4 P + 3/4 P₊`.
///
/// # Shape
///
/// n points become 2n in the order `Q₀ R₀ Q₁ R₁ …`, for open ends 2n − 2 (one for each end of each edge). Kept ends stand before and
/// behind.
///
/// # Accuracy
///
/// Each coordinate within `2u` times the larger of the two points' (`rounding_does_not_pile_up`): `3/4 P` is rounded, a quarter is not, and
/// then the sum, which makes `3/4 u + u` to first order.
///
/// # Edge cases
///
/// One point is a closed polygon with one edge, to itself; nothing is left of one point with open ends. Two points with open ends become
/// two, on the same edge.
///
/// # Source
///
/// Chaikin 1974.
///
/// # Examples
///
/// ```
/// use facette::subdivision::curve::{Ends, chaikin_step};
///
/// let corner = [[0.0, 4.0], [0.0, 0.0], [4.0, 0.0]];
/// assert_eq!(chaikin_step(&corner, Ends::Open), [[0.0, 3.0], [0.0, 1.0], [1.0, 0.0], [3.0, 0.0]]);
/// ```
// ANCHOR: chaikin
pub fn chaikin_step<P: VectorSpace>(points: &[P], ends: Ends) -> Vec<P> {
    let [near, far] = [P::Scalar::ratio(1, 4), P::Scalar::ratio(3, 4)];
    let mut finer = Vec::with_capacity(2 * points.len());
    if ends == Ends::Kept {
        finer.extend(points.first());
    }
    for [p, next] in edges(points, ends) {
        finer.push(p.lerp(next, near));
        finer.push(p.lerp(next, far));
    }
    if ends == Ends::Kept {
        finer.extend(points.last());
    }
    finer
}
// ANCHOR_END: chaikin

/// The polygon refined by the cubic scheme: for every vertex the point `V = (P₋ + 6 P + P₊)/8`, for every edge its midpoint.
///
/// # Shape
///
/// n points become 2n in the order `V₀ E₀ V₁ E₁ …`, for open ends 2n − 3 in the order `E₀ V₁ E₁ … Eₙ₋₂`, for kept ends these between the
/// end points, 2n − 1.
///
/// # Accuracy
///
/// Each coordinate within `3u` times the largest of the three points' (`rounding_does_not_pile_up`): `6/8 P` and two sums are rounded, which makes
/// `3/4 u + 7/8 u + u` to first order.
///
/// # Edge cases
///
/// A closed polygon may have one point or two; with open ends nothing is left of one point, and the midpoint of two.
///
/// # Source
///
/// Lane and Riesenfeld 1980; Catmull and Clark 1978 for the rule of surfaces' boundaries, which is this one with kept ends.
// ANCHOR: cubic
pub fn cubic_step<P: VectorSpace>(points: &[P], ends: Ends) -> Vec<P> {
    let vertex_mask = [1, 6, 1].map(|weight| P::Scalar::ratio(weight, 8));
    let half = P::Scalar::ratio(1, 2);
    let mut finer = Vec::with_capacity(2 * points.len());
    for (index, &p) in points.iter().enumerate() {
        let [before, next] = neighbours(points, index, ends);
        if let (Some(before), Some(next)) = (before, next) {
            finer.push(P::combination(vertex_mask, [before, p, next]));
        } else if ends == Ends::Kept {
            finer.push(p);
        }
        if let Some(next) = next {
            finer.push(p.lerp(next, half));
        }
    }
    finer
}
// ANCHOR_END: cubic

/// The control points of the uniform B-spline of this degree on halved spans: every point twice, and then `degree` times the midpoints of
/// neighbours, each round of which has one point less.
///
/// # Shape
///
/// n points become 2n − d, or none where that is negative.
///
/// # Accuracy
///
/// Each coordinate within `d u` times the largest of the points' (`rounding_does_not_pile_up`): a round of means adds one `u`, the first half of that.
///
/// # Cost
///
/// `d (2n − d)` midpoints, in place.
///
/// # Source
///
/// Lane and Riesenfeld 1980.
// ANCHOR: lane_riesenfeld
pub fn double_and_average<P: VectorSpace>(points: &[P], degree: usize) -> Vec<P> {
    let half = P::Scalar::ratio(1, 2);
    let mut finer: Vec<P> = points.iter().flat_map(|&p| [p, p]).collect();
    for _ in 0..degree {
        for index in 1..finer.len() {
            finer[index - 1] = finer[index - 1].lerp(finer[index], half);
        }
        finer.pop();
    }
    finer
}
// ANCHOR_END: lane_riesenfeld

/// The polygon refined by Lane and Riesenfeld's scheme of any degree: with degree 2 the points of [`chaikin_step`], with degree 3 those of
/// [`cubic_step`], in their order, up to rounding.
///
/// # Errors
///
/// [`PolygonError::Degree`] for degree 0 or one above [`LARGEST_DEGREE`](super::LARGEST_DEGREE), [`PolygonError::EndsNotKept`] for kept ends
/// where no rule keeps them.
pub fn lane_riesenfeld_step<P: VectorSpace>(
    points: &[P],
    degree: usize,
    ends: Ends,
) -> Result<Vec<P>, PolygonError> {
    check_degree(degree, ends)?;
    let mut finer = double_and_average(&control_points(points, degree, ends), degree);
    if ends == Ends::Open {
        return Ok(finer);
    }
    let before = phantoms_before(degree, ends);
    finer.drain(..before.min(finer.len()));
    finer.truncate(match ends {
        Ends::Kept if degree != 2 => (2 * points.len()).saturating_sub(1),
        _ => 2 * points.len(),
    });
    if ends == Ends::Kept {
        write_ends(points, &mut finer);
    }
    Ok(finer)
}

/// Writes the end points of a polygon over those of another, which are the same up to rounding.
pub(super) fn write_ends<P: Copy>(points: &[P], others: &mut [P]) {
    if let ([first, ..], [start, ..]) = (points, &mut *others) {
        *start = *first;
    }
    if let ([.., last], [.., end]) = (points, others) {
        *end = *last;
    }
}

/// The edges of a polygon, each from its first point to its second, in order; a closed polygon has one more, from its last point to its first.
pub fn edges<P: Copy>(points: &[P], ends: Ends) -> impl Iterator<Item = [P; 2]> {
    let closing = match (ends, points) {
        (Ends::Closed, [first, ..]) => points.last().map(|&last| [last, *first]),
        _ => None,
    };
    let inner = points.windows(2).map(|pair| [pair[0], pair[1]]);
    inner.chain(closing)
}

/// The points before and behind the point of this index, where there are any: in a closed polygon every point has both. The index is below the number of
/// points.
pub fn neighbours<P: Copy>(points: &[P], index: usize, ends: Ends) -> [Option<P>; 2] {
    let round_the_end = |end: Option<&P>| end.filter(|_| ends == Ends::Closed).copied();
    let before = match index.checked_sub(1) {
        Some(before) => points.get(before).copied(),
        None => round_the_end(points.last()),
    };
    let next = points.get(index + 1).copied();
    [before, next.or_else(|| round_the_end(points.first()))]
}
