//! The feature-adaptive way: refine around the extraordinary vertex until the parameter lies in a regular patch.

use num_traits::{One, Zero};

use super::jet::{Jacobian, combined, pulled_back};
use crate::algebra::{Scalar, VectorSpace};

/// Something near the point `origin`, in points relative to it.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Anchored<P, T> {
    pub origin: P,
    pub local: T,
}

/// A piece of a surface.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Patch<P, const N: usize> {
    /// A polynomial.
    Regular(Box<Anchored<P, [P; N]>>),
    /// The corner of this number, of all the surface's corners.
    Corner(usize),
}

/// An irregular patch with its extraordinary vertex at the parameter (0, 0), and N points to each regular patch.
pub(super) trait Corner<P: VectorSpace, const N: usize>: Clone + Sized {
    /// How many faces there are around the vertex; `None` where it is on the boundary.
    fn closed_valence(&self) -> Option<usize>;

    /// The point of the limit surface that belongs to the vertex.
    fn limit(&self) -> P;

    /// The same corner after one step: the surface above the half of the parameters next to the vertex.
    fn refined(&self) -> Self;

    /// The corner of other points.
    fn mapped(self, map: impl Fn(P) -> P) -> Self;

    /// The points of regular patch number `part` after one step.
    fn net(&self, part: usize) -> [P; N];
}

/// How a corner is cut, and what the points of a regular patch weigh.
pub(super) trait Cut<const N: usize> {
    /// The weights of a regular patch's points in a jet.
    fn weights<S: Scalar, const K: usize>(parameters: [S; 2]) -> [[S; N]; K];

    /// The regular patch, of three, in which the parameters of a corner lie, the parameters there, and their derivatives; `None` where they
    /// lie in the half next to the vertex.
    fn part<S: Scalar>(parameters: [S; 2]) -> Option<(usize, [S; 2], Jacobian<S>)>;
}

/// The jet at parameters other than (0, 0), where only a jet of 1 is defined: the limit point.
///
/// # Numerics
///
/// After each step the limit point of the corner is taken off: what is left has the size of the neighbourhood that is left, and so have its
/// rounding errors. It is doubled as well, so that derivatives come out as they are. Both are exact but for the subtraction.
///
/// # Cost
///
/// O(n) a step for valence n, and ⌈-log₂ max(s, t)⌉ steps: few hundred at most for positive floating-point numbers, few thousand operations
/// of `f64`.
// ANCHOR: adaptive
pub(super) fn adaptive_jet<P, C, X, const N: usize, const K: usize>(
    corner: &C,
    mut parameters: [P::Scalar; 2],
) -> Option<[P; K]>
where
    P: VectorSpace,
    C: Corner<P, N>,
    X: Cut<N>,
{
    if let Some((part, inner, jacobian)) = X::part(parameters) {
        let jet = combined(&X::weights(inner), &corner.net(part));
        return Some(pulled_back(jet, jacobian));
    }
    let mut limit = corner.limit();
    if parameters.iter().all(P::Scalar::is_zero) {
        return (K == 1).then_some([limit; K]);
    }
    let (half, two) = (P::Scalar::ratio(1, 2), P::Scalar::from_i32(2));
    let mut corner = corner.clone().mapped(|point| point.minus(limit));
    let (mut unit, mut steps) = (P::Scalar::one(), 0);
    let (part, inner, jacobian) = loop {
        corner = corner.refined();
        let rest = corner.limit();
        limit = limit.plus(rest.times(unit));
        corner = corner.mapped(|point| point.minus(rest).times(two));
        parameters = parameters.map(|parameter| parameter + parameter);
        (unit, steps) = (unit * half, steps + 1);
        if let Some(found) = X::part(parameters) {
            break found;
        }
    };
    let mut jet = pulled_back(combined(&X::weights(inner), &corner.net(part)), jacobian);
    jet[0] = limit.plus(jet[0].times(unit));
    // The points are doubled once a step; a second derivative grows by four.
    for second in jet.iter_mut().skip(3) {
        *second = (0..steps).fold(*second, |point, _| point.times(two));
    }
    Some(jet)
}
// ANCHOR_END: adaptive
