//! Polygons of the parameter plane: what is inside, and whether they meet themselves.

use super::TrimError;
use crate::algebra::{Scalar, VectorSpace};
use crate::mesh::turn;

/// Where a point lies with respect to a polygon.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// Inside.
    Inside,
    /// On a side, or so near to it that rounding hides on which side of it.
    Edge,
    /// Outside.
    Outside,
}

type Point<S> = [S; 2];

/// The points, each once, those outside the domain moved to its edge where that is not farther than a quarter of the tolerance.
pub(super) fn moved_into<S: Scalar>(
    domain: [[S; 2]; 2],
    points: Vec<Point<S>>,
    tolerance: S,
) -> Result<Vec<Point<S>>, TrimError<S>> {
    let allowed = tolerance * S::ratio(1, 4);
    let mut polygon: Vec<Point<S>> = Vec::with_capacity(points.len());
    for point in points {
        let moved = std::array::from_fn(|axis| clamped(point[axis], domain[axis]));
        if point.minus(moved).largest_coordinate() > allowed {
            return Err(TrimError::OutsideDomain { point, domain });
        }
        if polygon.last() != Some(&moved) {
            polygon.push(moved);
        }
    }
    while polygon.len() > 1 && polygon.first() == polygon.last() {
        polygon.pop();
    }
    Ok(polygon)
}

fn clamped<S: Scalar>(value: S, [low, high]: [S; 2]) -> S {
    if value < low {
        return low;
    }
    if value > high { high } else { value }
}

/// The sides `[start, end]` of a polygon, in order.
fn sides<S: Scalar>(polygon: &[Point<S>]) -> impl Iterator<Item = [Point<S>; 2]> {
    let ends = polygon.iter().cycle().skip(1);
    polygon.iter().zip(ends).map(|(&start, &end)| [start, end])
}

/// Where a point lies with respect to a polygon: how often the polygon winds around it decides.
///
/// A side counts where it crosses the point's height on the right of the point. It owns its lower end and not its upper one, so that a corner
/// at that height is counted once. Where a side crosses that height, only a point in its bounding box can be so near to its line that the sign of
/// the turn is lost: elsewhere the two products have different signs, and nothing cancels.
// ANCHOR: place_of
pub(super) fn place_of<S: Scalar>(polygon: &[Point<S>], point: Point<S>) -> Place {
    if !point.has_finite_coordinates() {
        return Place::Outside;
    }
    let zero = S::zero();
    let mut winding = 0_i32;
    for [start, end] in sides(polygon) {
        let side = turn(start, end, point);
        if side.is_zero() && is_in_box(point, [start, end]) {
            return Place::Edge;
        }
        let [from_below, to_below] = [start[1] <= point[1], end[1] <= point[1]];
        match (from_below, to_below) {
            (true, false) if side > zero => winding += 1,
            (false, true) if side < zero => winding -= 1,
            _ => (),
        }
    }
    if winding == 0 {
        Place::Outside
    } else {
        Place::Inside
    }
}
// ANCHOR_END: place_of

/// The smaller and the larger of the two coordinates on this axis.
fn extent<S: Scalar>([a, b]: [Point<S>; 2], axis: usize) -> [S; 2] {
    if a[axis] < b[axis] {
        return [a[axis], b[axis]];
    }
    [b[axis], a[axis]]
}

/// Whether a point lies in the closed bounding box of a side.
fn is_in_box<S: Scalar>(point: Point<S>, side: [Point<S>; 2]) -> bool {
    [0, 1].into_iter().all(|axis| {
        let [low, high] = extent(side, axis);
        low <= point[axis] && point[axis] <= high
    })
}

/// Twice the area that a polygon encloses, positive where it runs anticlockwise; 0 where rounding hides the sign.
///
/// Each of the n products is rounded three times, and the sum as often as it has terms: together at most `(2n + 4)u` of the sum of their
/// absolute values.
pub(super) fn double_area<S: Scalar>(polygon: &[Point<S>]) -> S {
    let [mut area, mut products, mut roundings] = [S::zero(), S::zero(), S::from_i32(4)];
    let origin = polygon[0];
    for [start, end] in sides(polygon) {
        let ([ax, ay], [bx, by]) = (start.minus(origin), end.minus(origin));
        area = area + (ax * by - ay * bx);
        products = products + (ax * by).magnitude() + (ay * bx).magnitude();
        roundings = roundings + S::from_i32(2);
    }
    if area.magnitude() > roundings * S::unit_roundoff() * products {
        return area;
    }
    S::zero()
}

/// Two sides of a polygon that have more in common than neighbours must, by the numbers of their first corners.
///
/// # Cost
///
/// The sides are sorted by where they begin in u, and compared with those that begin before they end: about n log n for sides that are short.
pub(super) fn first_crossing<S: Scalar>(polygon: &[Point<S>]) -> Option<[usize; 2]> {
    let sides: Vec<_> = sides(polygon).collect();
    let low = |side: usize| extent(sides[side], 0)[0];
    let mut order: Vec<usize> = (0..sides.len()).collect();
    order.sort_by(|&a, &b| {
        low(a)
            .partial_cmp(&low(b))
            .unwrap_or(std::cmp::Ordering::Equal)
    });
    for (place, &side) in order.iter().enumerate() {
        let [_, high] = extent(sides[side], 0);
        let overlapping = order[place + 1..]
            .iter()
            .take_while(|&&other| low(other) <= high);
        for &other in overlapping {
            let pair = [side.min(other), side.max(other)];
            if meet(&sides, pair) {
                return Some(pair);
            }
        }
    }
    None
}

/// Whether two sides meet, other than neighbours in their common corner.
fn meet<S: Scalar>(sides: &[[Point<S>; 2]], [first, second]: [usize; 2]) -> bool {
    let ([a, b], [c, d]) = (sides[first], sides[second]);
    if second == first + 1 {
        return folds_back(a, b, d);
    }
    if first == 0 && second + 1 == sides.len() {
        return folds_back(c, d, b);
    }
    let boxes_overlap = [0, 1].into_iter().all(|axis| {
        let ([low, high], [other_low, other_high]) = (extent([a, b], axis), extent([c, d], axis));
        low <= other_high && other_low <= high
    });
    boxes_overlap
        && may_separate(turn(a, b, c), turn(a, b, d))
        && may_separate(turn(c, d, a), turn(c, d, b))
}

/// Whether two turns have not the same sign for sure.
fn may_separate<S: Scalar>(one: S, other: S) -> bool {
    let zero = S::zero();
    !((one > zero && other > zero) || (one < zero && other < zero))
}

/// Whether the path `a b c` turns back onto itself at `b`.
fn folds_back<S: Scalar>(a: Point<S>, b: Point<S>, c: Point<S>) -> bool {
    let ([ax, ay], [cx, cy]) = (a.minus(b), c.minus(b));
    turn(a, b, c).is_zero() && ax * cx + ay * cy > S::zero()
}
