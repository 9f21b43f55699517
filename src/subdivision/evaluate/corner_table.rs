//! The extraordinary corners of a surface, and the evaluation of a patch by either way.

use super::adaptive::{Anchored, Corner, Cut, Patch, adaptive_jet};
use super::eigenbasis::Eigenbasis;
use super::jet::combined;
use crate::algebra::VectorSpace;

/// The extraordinary corners of a surface, and their eigenbasis where it is made: what is needed beyond the patches themselves.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct CornerTable<P: VectorSpace, C, const N: usize, const O: usize> {
    pub corners: Vec<Anchored<P, C>>,
    pub eigenbasis: Option<Eigenbasis<P, N, O>>,
}

impl<P: VectorSpace, C: Corner<P, N>, const N: usize, const O: usize> CornerTable<P, C, N, O> {
    /// The jet at the parameters of a patch. `None` where a jet of more than the point is asked for at an extraordinary vertex.
    pub fn jet<X: Cut<N>, const K: usize>(
        &self,
        patch: &Patch<P, N>,
        parameters: [P::Scalar; 2],
    ) -> Option<[P; K]> {
        self.jet_or::<X, K>(patch, parameters, |_| None)
    }

    /// As [`CornerTable::jet`], with a jet from the limits at the corner itself where there is no other.
    pub fn jet_or<X: Cut<N>, const K: usize>(
        &self,
        patch: &Patch<P, N>,
        parameters: [P::Scalar; 2],
        at_limit: fn(&C) -> Option<[P; K]>,
    ) -> Option<[P; K]> {
        match patch {
            Patch::Regular(patch) => {
                let mut jet = combined(&X::weights(parameters), &patch.local);
                jet[0] = patch.origin.plus(jet[0]);
                Some(jet)
            }
            &Patch::Corner(number) => {
                let Anchored { origin, local } = &self.corners[number];
                let jet = match (&self.eigenbasis, local.closed_valence()) {
                    (Some(basis), Some(_)) => basis.jet::<X, K>(number, parameters),
                    _ => adaptive_jet::<P, C, X, N, K>(local, parameters),
                };
                let mut jet = jet.or_else(|| at_limit(local))?;
                jet[0] = origin.plus(jet[0]);
                Some(jet)
            }
        }
    }
}
