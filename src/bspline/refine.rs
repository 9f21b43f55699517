//! The same B-spline with other control points: knots inserted and removed, the degree raised, derivatives, Bézier pieces.
//!
//! Each function takes the control points of a curve; a surface applies it to every row or column of its net.

use num_traits::{One, Zero};

use super::basis::find_span;
use super::curve::blossom;
use super::{BsplineError, KnotVector};
use crate::algebra::{Scalar, VectorSpace, larger};
use crate::curve::count;

/// The data of a curve.
type KnotsAndPoints<P> = (KnotVector<<P as VectorSpace>::Scalar>, Vec<P>);

/// The control points of the same curve with one more knot at `u`, which lies in the domain: `Qᵢ = (1 − αᵢ) Pᵢ₋₁ + αᵢ Pᵢ`, where
/// `αᵢ` is 1 up to `i = k − p` and 0 from `i = k + 1` on, `k` the span of `u`.
///
/// # Accuracy
///
/// Each coordinate is within `6u` of the larger of the two points that it comes from.
///
/// # Panics
///
/// When there are not as many control points as basis functions.
///
/// # Source
///
/// Boehm 1980.
// ANCHOR: insert_knot
pub fn insert_knot<P: VectorSpace>(
    knots: &KnotVector<P::Scalar>,
    control_points: &[P],
    u: P::Scalar,
) -> Vec<P> {
    let degree = knots.degree();
    let span = find_span(knots, u);
    let u_at = |index: usize| knots.knots()[index];
    let mut points = control_points[..=span - degree].to_vec();
    for i in span - degree + 1..=span {
        let [falling, rising] = knots.weights(u, [u_at(i), u_at(i + degree)]);
        let left = control_points[i - 1].times(falling);
        points.push(left.plus(control_points[i].times(rising)));
    }
    points.extend_from_slice(&control_points[span..]);
    points
}
// ANCHOR_END: insert_knot

/// Refuses knots that do not hold all inner knots of the others, on the same domain and with the same degree.
pub(super) fn check_finer<S: Scalar>(
    knots: &KnotVector<S>,
    finer: &KnotVector<S>,
) -> Result<(), BsplineError<S>> {
    let [needed, found] = [knots.degree(), finer.degree()];
    if found != needed {
        return Err(BsplineError::OtherDegree { needed, found });
    }
    let [needed, found] = [knots.domain(), finer.domain()];
    if found != needed {
        return Err(BsplineError::OtherDomain { needed, found });
    }
    let [start, end] = needed;
    for (knot, needed) in knots.multiplicities() {
        let found = finer.multiplicity(knot);
        let is_inside = start < knot && knot < end;
        if is_inside && found < needed {
            return Err(BsplineError::NotFiner {
                knot,
                needed,
                found,
            });
        }
    }
    Ok(())
}

/// The control points on finer knots: the blossom of a piece under the support of each new basis function, at that function's
/// inner knots.
// ANCHOR: oslo
pub(super) fn oslo<P: VectorSpace>(
    knots: &KnotVector<P::Scalar>,
    control_points: &[P],
    finer: &KnotVector<P::Scalar>,
) -> Vec<P> {
    let degree = knots.degree();
    let new_point = |j: usize| {
        let arguments = &finer.knots()[j + 1..=j + degree];
        let span = piece_under(knots, finer, j);
        let arguments = outermost_first(knots.span_interval(span), arguments);
        blossom(knots, control_points, span, &arguments)
    };
    (0..finer.control_point_count()).map(new_point).collect()
}
// ANCHOR_END: oslo

/// A span of `knots` that the support of basis function `j` on the finer knots covers: of those in the middle, so that the
/// blossom extrapolates as little as possible. Next to the domain, the nearest span.
fn piece_under<S: Scalar>(knots: &KnotVector<S>, finer: &KnotVector<S>, j: usize) -> usize {
    let [first, last] = finer.end_spans();
    let support = j.clamp(first, last)..=(j + finer.degree()).clamp(first, last);
    let has_length = |&span: &usize| finer.knots()[span] < finer.knots()[span + 1];
    let covered: Vec<usize> = support.clone().filter(has_length).collect();
    let span = covered.get(covered.len() / 2);
    let fallback = || {
        (first..=*support.end())
            .rev()
            .find(has_length)
            .unwrap_or(first)
    };
    find_span(knots, finer.knots()[span.copied().unwrap_or_else(fallback)])
}

/// The arguments, which do not decrease, in the order of their distance from the span: de Boor's first levels interpolate over the
/// widest intervals, and extrapolate least.
fn outermost_first<S: Scalar>([start, end]: [S; 2], arguments: &[S]) -> Vec<S> {
    let mut left = arguments;
    let mut ordered = Vec::with_capacity(arguments.len());
    while let (Some((&lowest, above)), Some((&highest, below))) =
        (left.split_first(), left.split_last())
    {
        let lowest_is_farther = start - lowest > highest - end;
        let (next, rest) = if lowest_is_farther {
            (lowest, above)
        } else {
            (highest, below)
        };
        ordered.push(next);
        left = rest;
    }
    ordered
}

/// The control points of the Bézier curve that the curve is on a span: blossoms at the ends of the span.
pub(super) fn bezier_points<P: VectorSpace>(
    knots: &KnotVector<P::Scalar>,
    control_points: &[P],
    span: usize,
) -> Vec<P> {
    let degree = knots.degree();
    let [start, end] = knots.span_interval(span);
    let mut arguments = vec![start; degree];
    let mut points = vec![blossom(knots, control_points, span, &arguments)];
    for index in (0..degree).rev() {
        arguments[index] = end;
        points.push(blossom(knots, control_points, span, &arguments));
    }
    points
}

/// Without one copy of the inner knot `u`, where inserting it again gives the same control points up to `tolerance`.
pub(super) fn remove_knot<P: VectorSpace>(
    knots: &KnotVector<P::Scalar>,
    control_points: &[P],
    u: P::Scalar,
    tolerance: P::Scalar,
) -> Result<KnotsAndPoints<P>, BsplineError<P::Scalar>> {
    let [start, end] = knots.domain();
    let multiplicity = knots.multiplicity(u);
    if multiplicity == 0 || u <= start || u >= end {
        return Err(BsplineError::NoInnerKnot { knot: u });
    }
    let place = knots.knots().partition_point(|&knot| knot <= u) - 1;
    let mut fewer = knots.knots().to_vec();
    fewer.remove(place);
    let fewer = KnotVector::new(knots.degree(), fewer)?;
    // Inserting `u` into `fewer` mixes the points number `first` to `last`.
    let [first, last] = [place - knots.degree(), place + 1 - multiplicity];
    let points = without_mixing(&fewer, control_points, u, [first, last]);
    let distance = insert_knot(&fewer, &points, u)
        .iter()
        .zip(control_points)
        .map(|(new, old)| new.minus(*old).largest_coordinate())
        .fold(P::Scalar::zero(), larger);
    if distance <= tolerance {
        return Ok((fewer, points));
    }
    Err(BsplineError::KnotNotRemovable {
        knot: u,
        distance,
        tolerance,
    })
}

/// The control points over the knots `fewer` from which the insertion of `u` would have mixed those from `first` to `last`, not included:
/// solved from both sides up to the middle, which one equation more than unknowns leaves to the proof.
fn without_mixing<P: VectorSpace>(
    fewer: &KnotVector<P::Scalar>,
    control_points: &[P],
    u: P::Scalar,
    [first, last]: [usize; 2],
) -> Vec<P> {
    let degree = fewer.degree();
    let weights = |i: usize| fewer.weights(u, [fewer.knots()[i], fewer.knots()[i + degree]]);
    let middle = first.midpoint(last);
    let mut points = control_points.to_vec();
    points.remove(middle);
    for i in first..middle {
        let [falling, rising] = weights(i);
        let rest = control_points[i].minus(points[i - 1].times(falling));
        points[i] = divided(rest, rising);
    }
    for i in (middle + 1..last).rev() {
        let [falling, rising] = weights(i);
        let rest = control_points[i].minus(points[i].times(rising));
        points[i - 1] = divided(rest, falling);
    }
    points
}

/// The vector divided by a number.
fn divided<P: VectorSpace>(vector: P, divisor: P::Scalar) -> P {
    vector.times(P::Scalar::one() / divisor)
}

/// The knots of the same curve at degree `p + 1`: each distinct knot stands one time more. Knots outside the domain are kept as
/// far as the new degree needs them.
pub(super) fn elevated_knots<S: Scalar>(knots: &KnotVector<S>) -> KnotVector<S> {
    let degree = knots.degree() + 1;
    let [start, end] = knots.domain();
    let raised = knots.multiplicities();
    let copies = |&(knot, multiplicity): &(S, usize)| std::iter::repeat_n(knot, multiplicity + 1);
    let all: Vec<S> = raised.iter().flat_map(copies).collect();
    let before = all.partition_point(|&knot| knot <= start);
    let behind = all.partition_point(|&knot| knot < end);
    // The last copy of the start stands at index p + 1, the first copy of the end that far from the last knot.
    let needed = all[before - 1 - degree..=behind + degree].to_vec();
    KnotVector::new(degree, needed).expect("knots of a valid vector, each one time more, are valid")
}

/// The control points at degree `p + 1`: the blossom of that degree is the mean, over the arguments, of the old blossom with
/// that argument left out.
// ANCHOR: elevate
pub(super) fn elevate<P: VectorSpace>(
    knots: &KnotVector<P::Scalar>,
    control_points: &[P],
    elevated: &KnotVector<P::Scalar>,
) -> Vec<P> {
    let degree = elevated.degree();
    let new_point = |j: usize| {
        let arguments = &elevated.knots()[j + 1..=j + degree];
        let span = piece_under(knots, elevated, j);
        let groups = arguments.chunk_by(|a, b| a == b);
        let mut left_out = 0;
        let means = groups.map(|group| {
            let mut others = arguments.to_vec();
            others.remove(left_out);
            let others = outermost_first(knots.span_interval(span), &others);
            left_out += group.len();
            let share = P::Scalar::ratio(count(group.len()), count(degree));
            blossom(knots, control_points, span, &others).times(share)
        });
        means.reduce(P::plus).unwrap_or_else(P::origin)
    };
    (0..elevated.control_point_count()).map(new_point).collect()
}
// ANCHOR_END: elevate

/// Factors whose product is `factor / width`: one, or two where their product overflows and only a difference that is small, or zero,
/// makes a number of it. The second is 2⁶⁰, which brings denormal widths among the normal numbers.
fn slope_factors<S: Scalar>(factor: S, width: S) -> [S; 2] {
    let slope = factor / width;
    if Scalar::is_finite(slope) {
        return [slope, S::one()];
    }
    let scale = S::from_i32(1 << 30) * S::from_i32(1 << 30);
    [factor / (width * scale), scale]
}

/// Replaces the control points of a span, of which `differences − 1` times the differences have been taken, by the
/// differences of order `differences`, in all places but the last that held one. The control points are groups of `length`
/// neighbours in `points`: single points for a curve, columns for the local net of a surface.
pub(super) fn differentiate<P: VectorSpace>(
    knots: &KnotVector<P::Scalar>,
    span: usize,
    differences: usize,
    length: usize,
    points: &mut [P],
) {
    let degree = knots.degree() + 1 - differences;
    let factor = P::Scalar::from_i32(count(degree));
    for index in 0..degree {
        let [start, end] = [span + 1 + index - degree, span + 1 + index];
        let slopes = slope_factors(factor, knots.knots()[end] - knots.knots()[start]);
        for place in index * length..(index + 1) * length {
            let difference = points[place + length].minus(points[place]);
            points[place] = slopes.iter().fold(difference, |d, &slope| d.times(slope));
        }
    }
}

/// The knots and the control points `p (Pᵢ₊₁ − Pᵢ) / (uᵢ₊ₚ₊₁ − uᵢ₊₁)` of the derivative, of degree `p − 1`. A knot that stands `p + 1`
/// times keeps `p` copies: between them the curve jumps, and nothing but the two sides has a derivative.
pub(super) fn derivative<P: VectorSpace>(
    knots: &KnotVector<P::Scalar>,
    control_points: &[P],
) -> KnotsAndPoints<P> {
    let degree = knots.degree();
    if degree == 0 {
        return (knots.clone(), vec![P::origin(); control_points.len()]);
    }
    let old = knots.knots();
    let factor = P::Scalar::from_i32(count(degree));
    let (mut new_knots, mut points) = (old[1..=degree].to_vec(), Vec::new());
    for (i, pair) in control_points.windows(2).enumerate() {
        let [start, end] = [old[i + 1], old[i + degree + 1]];
        if start < end {
            let [slope, scale] = slope_factors(factor, end - start);
            points.push(pair[1].minus(pair[0]).times(slope).times(scale));
            new_knots.push(end);
        }
    }
    let new_knots = KnotVector::new(degree - 1, new_knots);
    (
        new_knots.expect("inner knots of a valid vector, each at most p times, are valid"),
        points,
    )
}
