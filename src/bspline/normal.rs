//! Normals, also where a partial derivative vanishes.

use num_traits::{One, Zero};

use super::KnotVector;
use super::basis::find_span;
use crate::algebra::{Scalar, Vector3, VectorSpace, divided};
use crate::curve::count;
use crate::surface::normal_of_tangents;

/// A normal at `parameters` of the surface whose derivatives of orders `[k, l]` there are `derivative([k, l])`.
///
/// Where `S_u × S_v` vanishes, the surface is followed along a diagonal of the span towards its middle, `(u + s a, v + s b)`: the first
/// coefficient of the power series of `S_u × S_v` in `s` that is not zero points in the direction of the limit.
pub(super) fn normal_of<P: Vector3>(
    knots: [&KnotVector<P::Scalar>; 2],
    parameters: [P::Scalar; 2],
    derivative: impl Fn([usize; 2]) -> P,
) -> Option<P> {
    let inward = [
        step_inward(knots[0], parameters[0]),
        step_inward(knots[1], parameters[1]),
    ];
    let degrees = knots.map(KnotVector::degree);
    let noise = noise_of(degrees, derivative([0, 0]));
    let [s_u, s_v] = [derivative([1, 0]), derivative([0, 1])];
    let is_clear = |tangent: P, step: P::Scalar| (tangent.times(step)).largest_coordinate() > noise;
    let plain = normal_of_tangents(s_u, s_v);
    if plain.is_some() && is_clear(s_u, inward[0]) && is_clear(s_v, inward[1]) {
        return plain;
    }
    let along = |shift: [usize; 2]| series(inward, degrees, noise, shift, &derivative);
    first_product(&along([1, 0]), &along([0, 1])).or(plain)
}

/// The rounding that the control points carry into differences of them: each is rounded once, at the size of the point, and
/// the differences of all orders weigh them by no more than `2^(p + q)` together, twice over.
fn noise_of<P: VectorSpace>([p, q]: [usize; 2], point: P) -> P::Scalar {
    let two = P::Scalar::from_i32(2);
    let magnified =
        std::iter::repeat_n(two, p + q + 1).fold(P::Scalar::unit_roundoff(), |a, b| a * b);
    magnified * point.largest_coordinate()
}

/// The length of the span of `u`; negative where the way to its middle goes down.
fn step_inward<S: Scalar>(knots: &KnotVector<S>, u: S) -> S {
    let [start, end] = knots.span_interval(find_span(knots, u));
    if u - start < end - u {
        end - start
    } else {
        start - end
    }
}

/// The coefficients, in powers of `s`, of the partial derivative of orders `shift` along the diagonal, for parameters measured in steps.
/// What is not more than noise is 0.
fn series<P: Vector3>(
    [a, b]: [P::Scalar; 2],
    [p, q]: [usize; 2],
    noise: P::Scalar,
    shift: [usize; 2],
    derivative: &impl Fn([usize; 2]) -> P,
) -> Vec<P> {
    let powers_over_factorials = |step: P::Scalar, highest: usize| {
        let mut terms = vec![P::Scalar::one()];
        for k in 1..=highest {
            terms.push(terms[k - 1] * step / P::Scalar::from_i32(count(k)));
        }
        terms
    };
    let [in_u, in_v] = [powers_over_factorials(a, p), powers_over_factorials(b, q)];
    // The parameter of the derivative itself is measured in steps too; its sign is that of the parameter.
    let unit = if shift == [1, 0] { a } else { b }.magnitude();
    let coefficient = |k: usize| {
        let orders = (0..=k.min(p)).filter(|i| k - i <= q);
        let terms = orders.map(|i| {
            let factor = in_u[i] * in_v[k - i] * unit;
            derivative([i + shift[0], k - i + shift[1]]).times(factor)
        });
        let sum = terms.reduce(P::plus).unwrap_or_else(P::origin);
        if sum.largest_coordinate() > noise {
            sum
        } else {
            P::origin()
        }
    };
    (0..=p + q).map(coefficient).collect()
}

/// The first coefficient of the product of two series that is more than rounding.
fn first_product<P: Vector3>(a: &[P], b: &[P]) -> Option<P> {
    let [a, b] = [scaled(a)?, scaled(b)?];
    let rounding = P::Scalar::from_i32(8) * P::Scalar::unit_roundoff();
    (0..a.len() + b.len() - 1).find_map(|order| {
        let pairs = (0..a.len()).filter_map(|i| Some((a[i], *b.get(order.checked_sub(i)?)?)));
        let mut sum = P::origin();
        let mut size = P::Scalar::zero();
        for (a, b) in pairs {
            sum = sum.plus(a.cross(b));
            size = size + a.largest_coordinate() * b.largest_coordinate();
        }
        (sum.largest_coordinate() > rounding * size).then_some(sum)
    })
}

/// The vectors divided by the largest of their coordinates; `None` where that is zero or not finite.
fn scaled<P: Vector3>(vectors: &[P]) -> Option<Vec<P>> {
    let largest = vectors
        .iter()
        .map(|vector| vector.largest_coordinate())
        .fold(
            P::Scalar::zero(),
            |most, one| if one > most { one } else { most },
        );
    let is_usable = largest > P::Scalar::zero() && Scalar::is_finite(largest);
    is_usable.then(|| vectors.iter().map(|&v| divided(v, largest)).collect())
}
