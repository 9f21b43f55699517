//! Stam's way: powers of eigenvalues instead of steps.
//!
//! The points around an extraordinary vertex after k steps are `Aᵏ p`. In a basis of eigenvectors of the ring, that is of the vertex with the
//! edges and faces around it, each coordinate is multiplied by its eigenvalue λ once a step. The O points beyond the ring depend on the
//! ring and on themselves; of their own matrix the eigenvalues δ and eigenvectors are known as fractions. A ring eigenvector drives the
//! outer coordinates by g, so that after k steps they are
//!
//! ```text
//! δᵏ b + g a h,    h = (λᵏ − δᵏ)/(λ − δ) = λᵏ⁻¹ + λᵏ⁻² δ + ... + δᵏ⁻¹
//! ```
//!
//! # Numerics
//!
//! Eigenvectors of the whole matrix would have `1/(λ − δ)` in them, which is infinite or large where eigenvalues coincide (λ = 1/8 for even
//! valence with Loop, and for multiples of 4 with Catmull-Clark: Jordan blocks) or nearly do. The sum h has neither division nor difference.

use std::collections::HashMap;

use num_traits::Zero;

use super::adaptive::{Anchored, Corner, Cut};
use super::jet::{ORDERS, combined, pulled_back};
use crate::algebra::{Scalar, VectorSpace};

/// One coordinate of the ring: an eigenvalue, and what its eigenvector looks like after a step.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Mode<S, const N: usize, const O: usize> {
    /// The eigenvalue λ.
    pub value: S,
    /// The points of the three regular patches after one step, where the outer points are zero.
    pub nets: [[S; N]; 3],
    /// What one step adds to the outer coordinates.
    pub drive: [S; O],
}

/// One coordinate of the points beyond the ring.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct OuterMode<S, const N: usize> {
    /// The eigenvalue δ = 2^-(3 + this).
    pub delta: usize,
    /// The points of the three regular patches after one step, where the ring is zero.
    pub nets: [[S; N]; 3],
}

/// The eigenstructure of a corner of one valence.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Spectrum<S, const N: usize, const O: usize> {
    /// The ring's modes but for the constant one.
    pub modes: Vec<Mode<S, N, O>>,
    pub outer: [OuterMode<S, N>; O],
}

/// The coordinates of one corner in the basis of its valence.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Coordinates<P, const O: usize> {
    /// Which of the spectra it is.
    pub spectrum: usize,
    /// The limit point, which is the coordinate of the constant mode.
    pub limit: P,
    /// One for each mode.
    pub ring: Vec<P>,
    pub outer: [P; O],
}

/// The eigenstructure of all valences of a surface, and the coordinates of its corners.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Eigenbasis<P: VectorSpace, const N: usize, const O: usize> {
    pub spectra: Vec<Spectrum<P::Scalar, N, O>>,
    /// `None` for corners on the boundary.
    pub corners: Vec<Option<Coordinates<P, O>>>,
}

impl<P: VectorSpace, const N: usize, const O: usize> Eigenbasis<P, N, O> {
    /// The eigenbasis of these corners: one spectrum for each valence of those that are not on the boundary.
    pub fn new<C: Corner<P, N>>(
        corners: &[Anchored<P, C>],
        spectrum: impl Fn(&C) -> Spectrum<P::Scalar, N, O>,
        coordinates: impl Fn(&C, usize) -> Coordinates<P, O>,
    ) -> Self {
        let (mut spectra, mut numbers) = (Vec::new(), HashMap::new());
        let corners = corners.iter().map(|corner| {
            let corner = &corner.local;
            let valence = corner.closed_valence()?;
            let number = *numbers.entry(valence).or_insert_with(|| {
                spectra.push(spectrum(corner));
                spectra.len() - 1
            });
            Some(coordinates(corner, number))
        });
        let corners = corners.collect();
        Self { spectra, corners }
    }

    /// The jet of a corner, as [`adaptive_jet`](super::adaptive::adaptive_jet) gives it.
    pub fn jet<X: Cut<N>, const K: usize>(
        &self,
        corner: usize,
        mut parameters: [P::Scalar; 2],
    ) -> Option<[P; K]> {
        let coordinates = self.corners[corner].as_ref()?;
        if parameters.iter().all(P::Scalar::is_zero) {
            return (K == 1).then_some([coordinates.limit; K]);
        }
        let mut steps = 0;
        let (part, inner, jacobian) = loop {
            if let Some(found) = X::part(parameters) {
                break found;
            }
            parameters = parameters.map(|parameter| parameter + parameter);
            steps += 1;
        };
        let spectrum = &self.spectra[coordinates.spectrum];
        let jet = spectrum.jet(coordinates, part, &X::weights(inner), steps);
        let mut jet = pulled_back(jet, jacobian);
        jet[0] = coordinates.limit.plus(jet[0]);
        Some(jet)
    }
}

impl<S: Scalar, const N: usize, const O: usize> Spectrum<S, N, O> {
    /// The jet after so many steps, in the parameters that are doubled at each; without the constant mode.
    // ANCHOR: jet
    fn jet<P: VectorSpace<Scalar = S>, const K: usize>(
        &self,
        coordinates: &Coordinates<P, O>,
        part: usize,
        weights: &[[S; N]; K],
        steps: u32,
    ) -> [P; K] {
        // Derivatives of order l are multiplied by 2ᵏˡ, which would overflow; the eigenvalues are multiplied by 2ˡ instead.
        let order = |entry: usize| ORDERS[entry][0] + ORDERS[entry][1];
        let highest = K.div_ceil(2) - 1;
        let powers_of = |value| Powers::of_orders(highest, value, steps);
        let outer: [[S; K]; O] =
            std::array::from_fn(|j| combined(weights, &self.outer[j].nets[part]));
        let mut jet = [P::origin(); K];
        let (mut value, mut powers) = (S::zero(), powers_of(S::zero()));
        for (mode, &coordinate) in self.modes.iter().zip(&coordinates.ring) {
            if mode.value != value {
                (value, powers) = (mode.value, powers_of(mode.value));
            }
            let ring = combined(weights, &mode.nets[part]);
            for entry in 0..K {
                let Powers { lambda, driven, .. } = &powers[order(entry)];
                let mut factor = *lambda * ring[entry];
                for j in 0..O {
                    let from_ring = mode.drive[j] * driven[self.outer[j].delta];
                    factor = factor + from_ring * outer[j][entry];
                }
                jet[entry] = jet[entry].plus(coordinate.times(factor));
            }
        }
        for (j, &coordinate) in coordinates.outer.iter().enumerate() {
            for entry in 0..K {
                let delta = powers[order(entry)].deltas[self.outer[j].delta];
                jet[entry] = jet[entry].plus(coordinate.times(delta * outer[j][entry]));
            }
        }
        jet
    }
    // ANCHOR_END: jet
}

/// The eigenvalues of the points beyond the ring: 2⁻³ to 2⁻⁶.
const DELTAS: usize = 4;

/// The powers that k steps multiply with, for derivatives of one order l: of 2ˡλ, of each 2ˡδ, and 2ᵏˡ h.
#[derive(Clone, Copy)]
struct Powers<S> {
    lambda: S,
    deltas: [S; DELTAS],
    driven: [S; DELTAS],
}

impl<S: Scalar> Powers<S> {
    /// The powers for each order up to the highest.
    fn of_orders(highest: usize, value: S, steps: u32) -> [Self; 3] {
        let mut powers = [Self::new(value, 0, steps); 3];
        for (order, powers) in (1..).zip(&mut powers[1..=highest]) {
            *powers = Self::new(value, order, steps);
        }
        powers
    }

    /// By repeated squaring; for h there is `h₂ₖ = hₖ (λᵏ + δᵏ)` and `hₖ₊₁ = λ hₖ + δᵏ`.
    // ANCHOR: powers
    fn new(value: S, order: u32, steps: u32) -> Self {
        let growth = S::from_i32(1 << order);
        let lambda = value * growth;
        let deltas: [S; DELTAS] = std::array::from_fn(|index| growth / S::from_i32(8 << index));
        let mut powers = Self {
            lambda: S::one(),
            deltas: [S::one(); DELTAS],
            driven: [S::zero(); DELTAS],
        };
        for bit in (0..u32::BITS - steps.leading_zeros()).rev() {
            for (h, delta) in powers.driven.iter_mut().zip(&mut powers.deltas) {
                *h = *h * (powers.lambda + *delta);
                *delta = *delta * *delta;
            }
            powers.lambda = powers.lambda * powers.lambda;
            if steps >> bit & 1 == 1 {
                for (index, h) in powers.driven.iter_mut().enumerate() {
                    *h = *h * lambda + powers.deltas[index];
                    powers.deltas[index] = powers.deltas[index] * deltas[index];
                }
                powers.lambda = powers.lambda * lambda;
            }
        }
        // h is homogeneous of degree k − 1 in λ and δ: one factor is missing.
        powers.driven = powers.driven.map(|h| h * growth);
        powers
    }
    // ANCHOR_END: powers
}
