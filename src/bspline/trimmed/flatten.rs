//! A rational curve of the plane as a polygon within a tolerance.

use num_traits::One;

use super::TrimError;
use crate::algebra::{Scalar, VectorSpace};
use crate::bspline::{Homogeneous, RationalCurve};

/// How often a polynomial piece may be halved. Each halving divides its distance from the chord by about four: after 16, what is left is 2⁻³² of it.
const MOST_HALVINGS: u32 = 16;

/// The corners of a polygon from which the curve is not farther away than half the tolerance; gaps at its joints may be a quarter
/// of it. The last corner is not the first one again.
pub(super) fn flattened<S: Scalar>(
    curve: &RationalCurve<[S; 2]>,
    tolerance: S,
) -> Result<Vec<[S; 2]>, TrimError<S>> {
    let gap = tolerance * S::ratio(1, 4);
    let mut corners: Vec<[S; 2]> = Vec::new();
    let mut end: Option<[S; 2]> = None;
    for piece in curve.homogeneous().bezier_pieces() {
        let [start_parameter, end_parameter] = piece.interval;
        let points = piece.curve.control_points().to_vec();
        let start = points[0].projected();
        if let Some(from) = end.filter(|from| from.minus(start).largest_coordinate() > gap) {
            return Err(TrimError::Jump {
                parameter: start_parameter,
                from,
                to: start,
            });
        }
        end = points.last().map(|last| last.projected());
        // √2 / 3 < 1 / 2: a distance measured by its larger coordinate is less than half the tolerance.
        let flat = tolerance * S::ratio(1, 3);
        if !add_corners(points, flat, MOST_HALVINGS, &mut corners) {
            return Err(TrimError::TooManySides {
                tolerance,
                start: start_parameter,
                end: end_parameter,
            });
        }
    }
    let ends = corners.first().copied().zip(end);
    match ends.filter(|(start, end)| end.minus(*start).largest_coordinate() > gap) {
        Some((start, end)) => Err(TrimError::Open { start, end }),
        None => Ok(corners),
    }
}

/// Adds all corners but the last for a Bézier curve; false where the halvings do not suffice.
// ANCHOR: flatten
fn add_corners<S: Scalar>(
    points: Vec<Homogeneous<[S; 2]>>,
    flat: S,
    halvings: u32,
    corners: &mut Vec<[S; 2]>,
) -> bool {
    if is_flat(&points, flat) {
        corners.push(points[0].projected());
        return true;
    }
    if halvings == 0 {
        return false;
    }
    let [left, right] = halves(points);
    add_corners(left, flat, halvings - 1, corners)
        && add_corners(right, flat, halvings - 1, corners)
}
// ANCHOR_END: flatten

/// Whether every control point, and so with positive weights the whole curve, is close to the segment between the first and the last.
fn is_flat<S: Scalar>(points: &[Homogeneous<[S; 2]>], flat: S) -> bool {
    let ends = [points[0], points[points.len() - 1]].map(Homogeneous::projected);
    points.iter().all(|point| {
        let place = point.projected();
        let distance = place.minus(nearest_on_segment(place, ends));
        distance.largest_coordinate() <= flat
    })
}

/// The point of the segment `[a, b]` that is nearest to `point`.
fn nearest_on_segment<S: Scalar>(point: [S; 2], [a, b]: [[S; 2]; 2]) -> [S; 2] {
    let along = b.minus(a);
    let scale = along.largest_coordinate();
    if scale.is_zero() {
        return a;
    }
    let unit = along.map(|coordinate| coordinate / scale);
    let offset = point.minus(a).map(|coordinate| coordinate / scale);
    let share =
        (offset[0] * unit[0] + offset[1] * unit[1]) / (unit[0] * unit[0] + unit[1] * unit[1]);
    if share > S::zero() && share < S::one() {
        return a.lerp(b, share);
    }
    if share < S::one() { a } else { b }
}

/// The control points of the two halves of a Bézier curve, by de Casteljau.
fn halves<P: VectorSpace>(mut points: Vec<P>) -> [Vec<P>; 2] {
    let half = P::Scalar::one() / P::Scalar::from_i32(2);
    let mut left = vec![points[0]];
    for end in (1..points.len()).rev() {
        for index in 0..end {
            points[index] = points[index].lerp(points[index + 1], half);
        }
        left.push(points[0]);
    }
    [left, points]
}
