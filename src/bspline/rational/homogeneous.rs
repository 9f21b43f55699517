//! Homogeneous points, and the derivatives of their quotients.

use num_traits::{One, Zero};

use crate::algebra::{Scalar, VectorSpace};

/// A point with a weight, stored as `(w P, w)`: it stands for the point `P`.
///
/// Sums and multiples are taken of all coordinates alike, so every algorithm for points runs over these unchanged.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Homogeneous<P: VectorSpace> {
    /// The point times its weight.
    pub weighted: P,
    /// The weight.
    pub weight: P::Scalar,
}

impl<P: VectorSpace> Homogeneous<P> {
    /// The homogeneous point that stands for `point` with this weight.
    pub fn new(point: P, weight: P::Scalar) -> Self {
        Self {
            weighted: point.times(weight),
            weight,
        }
    }

    /// The point that it stands for, `weighted / weight`.
    ///
    /// # Accuracy
    ///
    /// The reciprocal and the product each round once: at most 2u relative in each coordinate.
    ///
    /// # Edge cases
    ///
    /// Infinite or NaN where the weight is zero.
    #[inline]
    // ANCHOR: projected
    pub fn projected(self) -> P {
        self.weighted.times(P::Scalar::one() / self.weight)
    }
    // ANCHOR_END: projected
}

// ANCHOR: homogeneous
impl<P: VectorSpace> VectorSpace for Homogeneous<P> {
    type Scalar = P::Scalar;
    const DIMENSION: usize = P::DIMENSION + 1;

    #[inline]
    fn origin() -> Self {
        Self {
            weighted: P::origin(),
            weight: P::Scalar::zero(),
        }
    }

    #[inline]
    fn plus(self, other: Self) -> Self {
        Self {
            weighted: self.weighted.plus(other.weighted),
            weight: self.weight + other.weight,
        }
    }

    #[inline]
    fn minus(self, other: Self) -> Self {
        Self {
            weighted: self.weighted.minus(other.weighted),
            weight: self.weight - other.weight,
        }
    }

    #[inline]
    fn times(self, factor: P::Scalar) -> Self {
        Self {
            weighted: self.weighted.times(factor),
            weight: self.weight * factor,
        }
    }

    /// The weight comes last.
    #[inline]
    fn coordinate(self, index: usize) -> P::Scalar {
        if index == P::DIMENSION {
            return self.weight;
        }
        self.weighted.coordinate(index)
    }
}
// ANCHOR_END: homogeneous

/// All derivatives of the quotient `S = A / w` up to an order in u and one in v, from those of `A` and `w`.
///
/// Leibniz' rule for `A = w S` reads `A⁽ᵏˡ⁾ = Σ binomial(k, i) binomial(l, j) w⁽ⁱʲ⁾ S⁽ᵏ⁻ⁱ˒ˡ⁻ʲ⁾`; the term with i = j = 0 holds
/// the derivative that is not yet known.
///
/// # Shape
///
/// `numerators[l * columns + k]` is the homogeneous derivative of order k in u and l in v; the quotients are in the same order.
///
/// # Source
///
/// Piegl and Tiller 1997, equations 4.8 and 4.20.
// ANCHOR: quotient_rule
pub(super) fn quotient_derivatives<P: VectorSpace>(
    numerators: &[Homogeneous<P>],
    columns: usize,
) -> Vec<P> {
    let mut quotients: Vec<P> = Vec::with_capacity(numerators.len());
    for (place, numerator) in numerators.iter().enumerate() {
        let (k, l) = (place % columns, place / columns);
        let mut rest = numerator.weighted;
        for (j, i) in (0..=l).flat_map(|j| (0..=k).map(move |i| (j, i))).skip(1) {
            let choices = binomial::<P::Scalar>(k, i) * binomial(l, j);
            let known = quotients[(l - j) * columns + k - i];
            rest = rest.minus(known.times(choices * numerators[j * columns + i].weight));
        }
        quotients.push(rest.times(P::Scalar::one() / numerators[0].weight));
    }
    quotients
}
// ANCHOR_END: quotient_rule

/// `binomial(n, k)`; every product on the way is divisible by its divisor.
fn binomial<S: Scalar>(n: usize, k: usize) -> S {
    let number = |value: usize| S::from_i32(i32::try_from(value).unwrap_or(i32::MAX));
    (0..k).fold(S::one(), |choices, chosen| {
        choices * number(n - chosen) / number(chosen + 1)
    })
}
