//! A solution of exercise 2: a point of a curve by de Boor's points.

use crate::algebra::VectorSpace;
use crate::bspline::KnotVector;
use reference::bspline::find_span;

/// The point `C(u)` by repeated interpolation.
pub fn de_boor_point<P: VectorSpace>(
    knots: &KnotVector<P::Scalar>,
    control_points: &[P],
    u: P::Scalar,
) -> P {
    let k = find_span(knots, u);
    let p = knots.degree();
    let u_at = |i: usize| knots.knots()[i];

    // The point number i stands at the place i - (k - p).
    let mut points = control_points[k - p..=k].to_vec();
    for r in 1..=p {
        // From the last to the first, so that points[place - 1] is still the one of the level before.
        for place in (r..=p).rev() {
            let i = k - p + place;
            let a = (u - u_at(i)) / (u_at(i + p + 1 - r) - u_at(i));
            points[place] = points[place - 1].lerp(points[place], a);
        }
    }
    points[p]
}
