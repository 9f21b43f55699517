//! A point with derivatives, as the coefficients that the chain rule acts on.

use num_traits::Zero;

use crate::algebra::{Scalar, VectorSpace};

/// The orders `[k, l]` of `∂ᵏ⁺ˡ/∂sᵏ∂tˡ`, in the order of a jet. A jet of 1 is the point, of 3 has the tangents too, of 6 all of these.
pub(super) const ORDERS: [[usize; 2]; 6] = [[0, 0], [1, 0], [0, 1], [2, 0], [1, 1], [0, 2]];

/// The derivatives `∂(s, t)/∂(u, v)` of an affine change of parameters: `[[∂s/∂u, ∂t/∂u], [∂s/∂v, ∂t/∂v]]`.
pub(super) type Jacobian<S> = [[S; 2]; 2];

/// The derivatives of parameters that are not changed.
pub(super) fn unchanged<S: Scalar>() -> Jacobian<S> {
    let (one, zero) = (S::one(), S::zero());
    [[one, zero], [zero, one]]
}

/// The jet in (u, v) of a surface whose jet in (s, t) this is.
pub(super) fn pulled_back<P: VectorSpace, const K: usize>(
    jet: [P; K],
    jacobian: Jacobian<P::Scalar>,
) -> [P; K] {
    // What does not count is left out: it may be infinite.
    let scaled = |point: P, factor: P::Scalar| {
        if factor.is_zero() {
            P::origin()
        } else {
            point.times(factor)
        }
    };
    let along = |s: P, t: P, [a, b]: [P::Scalar; 2]| scaled(s, a).plus(scaled(t, b));
    let [by_u, by_v] = jacobian;
    let mut result = jet;
    if K >= 3 {
        result[1] = along(jet[1], jet[2], by_u);
        result[2] = along(jet[1], jet[2], by_v);
    }
    if K >= 6 {
        let second = |[a, b]: [P::Scalar; 2], [c, d]: [P::Scalar; 2]| {
            let mixed = scaled(jet[4], a * d + b * c);
            scaled(jet[3], a * c)
                .plus(mixed)
                .plus(scaled(jet[5], b * d))
        };
        result[3] = second(by_u, by_u);
        result[4] = second(by_u, by_v);
        result[5] = second(by_v, by_v);
    }
    result
}

/// The sums of a net's points with each row of weights.
pub(super) fn combined<P: VectorSpace, const N: usize, const K: usize>(
    weights: &[[P::Scalar; N]; K],
    net: &[P; N],
) -> [P; K] {
    weights.each_ref().map(|row| {
        let mut sum = net[0].times(row[0]);
        for (point, &weight) in net.iter().zip(row).skip(1) {
            sum = sum.plus(point.times(weight));
        }
        sum
    })
}
