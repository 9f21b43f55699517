//! The extraordinary corners of a surface, and the evaluation of a patch by either way.

use super::EvaluationError;
use super::adaptive::{Anchored, Corner, Cut, Patch, adaptive_jet};
use super::eigenbasis::Eigenbasis;
use super::jet::{Jacobian, combined, pulled_back};
use crate::algebra::{Real, Vector3, VectorSpace, unit_vector};
use crate::mesh::Mesh;
use crate::subdivision::limit::Limit;
use crate::subdivision::{Connectivity, SubdivisionError};
use crate::surface::normal_of_tangents;

/// A patch, the parameters there, and their derivatives in the caller's parameters.
pub(super) type Located<'a, P, const N: usize, S = <P as VectorSpace>::Scalar> =
    (&'a Patch<P, N>, [S; 2], Jacobian<S>);

/// The extraordinary corners of a surface, and their eigenbasis where it is made: what is needed beyond the patches themselves.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct CornerTable<P: VectorSpace, C, const N: usize, const O: usize> {
    pub corners: Vec<Anchored<P, C>>,
    pub eigenbasis: Option<Eigenbasis<P, N, O>>,
}

impl<P: VectorSpace, C: Corner<P, N>, const N: usize, const O: usize> CornerTable<P, C, N, O> {
    /// The jet at the parameters of a patch, in the caller's parameters.
    ///
    /// # Errors
    ///
    /// [`EvaluationError::NoDerivatives`] where a jet of more than the point is asked for at an extraordinary vertex.
    pub fn jet<X: Cut<N>, const K: usize>(
        &self,
        (patch, parameters, jacobian): Located<'_, P, N>,
    ) -> Result<[P; K], EvaluationError> {
        let jet = self.jet_or::<X, K>(patch, parameters, |_| None);
        let jet = jet.ok_or(EvaluationError::NoDerivatives)?;
        Ok(pulled_back(jet, jacobian))
    }

    /// The unit normal, at an extraordinary vertex from the limits there.
    ///
    /// # Errors
    ///
    /// [`EvaluationError::NoNormal`].
    pub fn normal<X: Cut<N>>(
        &self,
        (patch, parameters, jacobian): Located<'_, P, N>,
        at_limit: fn(&C) -> Option<[P; 3]>,
    ) -> Result<P, EvaluationError>
    where
        P: Vector3,
        P::Scalar: Real,
    {
        let jet = self.jet_or::<X, 3>(patch, parameters, at_limit);
        let normal = jet.and_then(|jet| {
            let [_, s_u, s_v] = pulled_back(jet, jacobian);
            normal_of_tangents(s_u, s_v)
        });
        normal
            .and_then(unit_vector)
            .ok_or(EvaluationError::NoNormal)
    }

    /// The jet where [`adaptive_jet`] or the eigenbasis has one, or else what `at_limit` makes of the corner.
    fn jet_or<X: Cut<N>, const K: usize>(
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

/// The limits at the first vertex of a fan of faces, as a jet in directions of no particular length.
pub(super) fn limit_jet<P: VectorSpace, F: AsRef<[u32]>>(
    (points, faces): (Vec<P>, Vec<F>),
    limits: impl Fn(&Connectivity, &[P]) -> Result<Vec<Limit<P>>, SubdivisionError>,
) -> Option<[P; 3]> {
    let fan = Mesh::new(points, faces).ok()?;
    let connectivity = Connectivity::new(&fan).ok()?;
    let limits = limits(&connectivity, &fan.positions).ok()?;
    let limit = limits.first()?;
    let [along, across] = limit.tangents?;
    Some([limit.position, along, across])
}

/// Moves patches, and the corners that were found with them, from coordinates relative to `origin`.
pub(super) fn move_from_origin<P: VectorSpace, C, const N: usize>(
    origin: P,
    patches: &mut [Patch<P, N>],
    corners: &mut [Anchored<P, C>],
) {
    for patch in patches {
        if let Patch::Regular(patch) = patch {
            patch.origin = origin.plus(patch.origin);
        }
    }
    for corner in corners {
        corner.origin = origin.plus(corner.origin);
    }
}
