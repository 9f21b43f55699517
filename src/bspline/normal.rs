//! Normals, also where a partial derivative vanishes.

use num_traits::{One, Zero};

use super::KnotVector;
use super::basis::find_span;
use crate::algebra::{Scalar, Vector3, VectorSpace, divided, larger};
use crate::curve::count;

/// The coefficients of a polynomial in `s`, each with a bound on what rounding may have made of its coordinates.
type Series<P> = Vec<(P, <P as VectorSpace>::Scalar)>;

/// A normal at `parameters` of the surface whose derivatives of orders `[k, l]` there are `derivative([k, l])`. Each coordinate of a first
/// derivative in u is wrong by no more than `noise[0]`, in v by no more than `noise[1]`.
///
/// Where `S_u × S_v` says nothing, the surface is followed along a diagonal of the span towards its middle, `(u + s a, v + s b)`: the
/// coefficient of the power series of `S_u × S_v` in `s` that outweighs all others, and all rounding, at some small `s` points in the
/// direction of the limit. `None` where there is none.
///
/// # Cost
///
/// Two derivatives at ordinary places; `2 (p + 1)(q + 1)` of all orders where the normal is a limit.
pub(super) fn normal_of<P: Vector3>(
    knots: [&KnotVector<P::Scalar>; 2],
    parameters: [P::Scalar; 2],
    noise: [P::Scalar; 2],
    derivative: impl Fn([usize; 2]) -> P,
) -> Option<P> {
    let steps = [
        step_inward(knots[0], parameters[0]),
        step_inward(knots[1], parameters[1]),
    ];
    let degrees = knots.map(KnotVector::degree);
    let first = |axis: usize| {
        let step = steps[axis].magnitude();
        let orders = if axis == 0 { [1, 0] } else { [0, 1] };
        vec![(derivative(orders).times(step), noise[axis] * step)]
    };
    if let Some(plain) = leading_product(&first(0), &first(1)) {
        return Some(plain);
    }
    let along = |axis: usize| series(steps, degrees, noise[axis], axis, &derivative);
    leading_product(&along(0), &along(1))
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

/// The partial derivative in one parameter along the diagonal, for parameters measured in steps.
///
/// A derivative of order `k` more takes `k` more differences, weighed in step units by no more than `(2 (p + q))ᵏ / k!` together: so much
/// larger is its rounding.
fn series<P: Vector3>(
    [a, b]: [P::Scalar; 2],
    [p, q]: [usize; 2],
    noise: P::Scalar,
    axis: usize,
    derivative: &impl Fn([usize; 2]) -> P,
) -> Series<P> {
    let [in_u, in_v] = [powers_over_factorials(a, p), powers_over_factorials(b, q)];
    // The parameter of the derivative itself is measured in steps too; its sign is that of the parameter.
    let unit = [a, b][axis].magnitude();
    let growth = P::Scalar::from_i32(2) * P::Scalar::from_i32(count(p + q));
    let mut rounding = noise * unit;
    let coefficient = |k: usize| {
        let orders = (0..=k.min(p)).filter(|i| k - i <= q);
        let terms = orders.map(|i| {
            let mut orders = [i, k - i];
            orders[axis] += 1;
            derivative(orders).times(in_u[i] * in_v[k - i] * unit)
        });
        let sum = terms.reduce(P::plus).unwrap_or_else(P::origin);
        if k > 0 {
            rounding = rounding * growth / P::Scalar::from_i32(count(k));
        }
        (sum, rounding)
    };
    (0..=p + q).map(coefficient).collect()
}

/// `step⁰ / 0!, step¹ / 1!, …` up to the power `highest`.
fn powers_over_factorials<S: Scalar>(step: S, highest: usize) -> Vec<S> {
    let mut terms = vec![S::one()];
    for k in 1..=highest {
        terms.push(terms[k - 1] * step / S::from_i32(count(k)));
    }
    terms
}

/// The coefficient of the vector product of two series that points in the direction of the product at small `s`.
fn leading_product<P: Vector3>(a: &Series<P>, b: &Series<P>) -> Option<P> {
    let [a, b] = [scaled(a)?, scaled(b)?];
    let orders = 0..a.len() + b.len() - 1;
    let product: Series<P> = orders
        .map(|order| coefficient_of_product(&a, &b, order))
        .collect();
    (0..product.len())
        .find(|&order| is_leading(&product, order))
        .map(|order| product[order].0)
}

/// One coefficient of the product. A coordinate of a vector product of `a` and `b` is wrong by at most `4u |a| |b|` by its own
/// operations, with the sum, the scaling and some room `8u |a| |b|`, and by twice what the rounding of each may change.
fn coefficient_of_product<P: Vector3>(
    a: &Series<P>,
    b: &Series<P>,
    order: usize,
) -> (P, P::Scalar) {
    let [two, eight] = [2, 8].map(P::Scalar::from_i32);
    let roundoffs = eight * P::Scalar::unit_roundoff();
    let (mut sum, mut rounding) = (P::origin(), P::Scalar::zero());
    for (i, &(a, noise_a)) in a.iter().enumerate() {
        let Some(&(b, noise_b)) = order.checked_sub(i).and_then(|j| b.get(j)) else {
            continue;
        };
        let [size_a, size_b] = [a, b].map(P::largest_coordinate);
        sum = sum.plus(a.cross(b));
        let by_noise = two * (noise_a * (size_b + noise_b) + noise_b * size_a);
        rounding = rounding + by_noise + roundoffs * size_a * size_b;
    }
    (sum, rounding)
}

/// So many halvings of `s` are tried: at a smaller `s` nothing but the first coefficient is left in double precision.
const HALVINGS: usize = 60;

/// Whether the coefficient of this order, taken at some `s` from 1 down, is twice as large as all others and all rounding together; or
/// comes first, after nothing but zeros without rounding.
fn is_leading<P: Vector3>(product: &Series<P>, order: usize) -> bool {
    let size = product[order].0.largest_coordinate();
    let (two, zero) = (P::Scalar::from_i32(2), P::Scalar::zero());
    let before = product[..order].iter();
    let nothing_before = before
        .clone()
        .all(|&(term, rounding)| term.largest_coordinate().is_zero() && rounding.is_zero());
    if nothing_before && size > two * product[order].1 {
        return true;
    }
    let mut s = P::Scalar::one();
    for _ in 0..HALVINGS {
        let (mut power, mut own, mut others) = (P::Scalar::one(), zero, zero);
        for (k, &(term, rounding)) in product.iter().enumerate() {
            if k == order {
                own = power * size;
                others = others + power * rounding;
            } else {
                others = others + power * (term.largest_coordinate() + rounding);
            }
            power = power * s;
        }
        if own > two * others {
            return true;
        }
        s = s / two;
    }
    false
}

/// The series divided by the largest of its coordinates; `None` where that is zero or not finite.
fn scaled<P: Vector3>(series: &Series<P>) -> Option<Series<P>> {
    let largest = series
        .iter()
        .map(|(term, _)| term.largest_coordinate())
        .fold(P::Scalar::zero(), larger);
    let is_usable = largest > P::Scalar::zero() && Scalar::is_finite(largest);
    let divide = |&(term, rounding): &(P, P::Scalar)| (divided(term, largest), rounding / largest);
    is_usable.then(|| series.iter().map(divide).collect())
}
