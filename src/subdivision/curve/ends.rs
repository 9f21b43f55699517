//! Where a polygon ends, and the control points that its limit has beyond.

use std::collections::VecDeque;

use super::PolygonError;
use crate::algebra::VectorSpace;

/// The largest degree of a scheme: `1/d!`, the smallest weight of a limit point, is a normal number in `f32` up to here.
pub const LARGEST_DEGREE: usize = 33;

/// Whether a polygon closes, and what becomes of its ends where it does not.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ends {
    /// An edge joins the last point to the first: n points become 2n.
    Closed,
    /// The rules are applied where they have all their points, so that the ends are lost: n points become 2n − d. The limit is the B-spline of
    /// uniform knots on its domain.
    Open,
    /// The end points stay where they are, and the limit runs from the first to the last along the end edges: n points become 2n for
    /// degree 2, 2n − 1 for odd degrees. No other degree has such a rule.
    ///
    /// It is as if the polygon went on: with the end points doubled for degree 2, with its mirror images through them for odd degrees.
    Kept,
}

/// Refuses degrees that no scheme has, and kept ends where no rule keeps them.
pub(super) fn check_degree(degree: usize, ends: Ends) -> Result<(), PolygonError> {
    check_range(degree, 1)?;
    if ends == Ends::Kept && degree > 2 && degree.is_multiple_of(2) {
        return Err(PolygonError::EndsNotKept { degree });
    }
    Ok(())
}

/// Refuses degrees that are not between `smallest` and [`LARGEST_DEGREE`].
pub(super) fn check_range(degree: usize, smallest: usize) -> Result<(), PolygonError> {
    if (smallest..=LARGEST_DEGREE).contains(&degree) {
        return Ok(());
    }
    Err(PolygonError::Degree {
        found: degree,
        smallest,
        largest: LARGEST_DEGREE,
    })
}

/// How many control points the limit has before the polygon's first.
pub(super) fn phantoms_before(degree: usize, ends: Ends) -> usize {
    match ends {
        Ends::Open => 0,
        Ends::Kept if degree == 2 => 1,
        Ends::Closed | Ends::Kept => (degree - 1) / 2,
    }
}

/// The control points of the limit: the polygon, and what stands for its continuation before and behind it. Its open refinement is that of
/// the polygon, continued likewise. Degree and ends have been checked.
pub(super) fn control_points<P: VectorSpace>(points: &[P], degree: usize, ends: Ends) -> Vec<P> {
    let before = phantoms_before(degree, ends);
    match (ends, points) {
        (Ends::Open, _) | (_, []) => points.to_vec(),
        (Ends::Closed, _) => {
            // The index of P₋ᵦ, counted round the polygon without leaving the numbers that are not negative.
            let first = points.len() - before % points.len();
            let around = (first..).map(|index| points[index % points.len()]);
            around.take(points.len() + degree).collect()
        }
        (Ends::Kept, [first, .., last]) if degree == 2 => [&[*first], points, &[*last]].concat(),
        (Ends::Kept, _) => mirrored(points, before),
    }
}

/// The polygon with so many points more on either side, its mirror images through its ends: `P₋ₖ = 2 P₀ − Pₖ`.
fn mirrored<P: VectorSpace>(points: &[P], phantoms: usize) -> Vec<P> {
    let mut extended = VecDeque::from(points.to_vec());
    let mirror = |end: &P, point: Option<&P>| point.map_or(*end, |&p| end.plus(end.minus(p)));
    for k in 1..=phantoms {
        let [Some(first), Some(last)] = [points.first(), points.last()] else {
            break;
        };
        // k − 1 images stand on either side: Pₖ has the index 2k − 1, counted from either side. A single point is its own image.
        let before = mirror(first, extended.get(2 * k - 1));
        let opposite = extended.len().checked_sub(2 * k);
        let behind = mirror(last, opposite.and_then(|index| extended.get(index)));
        extended.push_front(before);
        extended.push_back(behind);
    }
    extended.into()
}
