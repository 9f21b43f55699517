//! Basis functions by another definition, the oracle of this chapter's theorems: divided differences of truncated powers.

use facette::algebra::VectorSpace;
use num_traits::{One, Zero};

use crate::common::exact::Exact;
use crate::inputs::{Knots, whole};

/// `N_i^p(u) = (u_{i+p+1} − u_i) [u_i, …, u_{i+p+1}] (t − u)₊^p`: the divided difference, in t, of a truncated power. It knows nothing of
/// the recursion. From the right at every parameter, but from the left at the end of the domain.
pub fn divided_difference_basis(knots: &Knots, function: usize, u: Exact) -> Exact {
    let own = knots.support(function);
    let from_left = u == knots.domain()[1];
    let p = knots.degree;
    // The k-th derivative of the truncated power, over k!.
    let taylor = |t: Exact, k: usize| {
        let beyond = t > u || (from_left && t == u);
        let binomial = (0..k).fold(Exact::one(), |product, j| {
            product * whole(p - j) / whole(j + 1)
        });
        if beyond {
            binomial * num_traits::pow(t - u, p - k)
        } else {
            Exact::zero()
        }
    };
    let mut differences: Vec<_> = own.iter().map(|&t| taylor(t, 0)).collect();
    for order in 1..own.len() {
        for j in 0..own.len() - order {
            let width = own[j + order] - own[j];
            differences[j] = if width.is_zero() {
                taylor(own[j], order)
            } else {
                (differences[j + 1] - differences[j]) / width
            };
        }
    }
    (own[p + 1] - own[0]) * differences[0]
}

/// The values of all n + 1 basis functions at `u`, by divided differences.
pub fn all_values(knots: &Knots, u: Exact) -> Vec<Exact> {
    (0..knots.count())
        .map(|function| divided_difference_basis(knots, function, u))
        .collect()
}

/// The sum `Σ weights[i] · points[i]`.
pub fn weighted_sum<P: VectorSpace>(weights: &[P::Scalar], points: &[P]) -> P {
    let terms = points.iter().zip(weights);
    terms.fold(P::origin(), |sum, (point, &weight)| {
        sum.plus(point.times(weight))
    })
}
