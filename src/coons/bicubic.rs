//! The bicubically blended Coons patch: boundary curves, slopes across them, and twists.

use num_traits::{One, Zero};

use super::bilinear::boolean_sum;
use super::hermite::{HermiteBoundary, hermite_basis, hermite_basis_derivative};
use crate::algebra::VectorSpace;
use crate::curve::Curve;
use crate::surface::Surface;

/// The point `S(u, v)` of the bicubically blended Coons patch: as the bilinear one, with Hermite's cubics in the place of
/// `1 − t` and `t`.
///
/// # Accuracy
///
/// For `0 <= u, v <= 1`, each coordinate is within `u (40 M₀ + 13 M₁ + 2 M₂)` of the exact patch of the computed data:
/// `M₀` the largest value of that coordinate among the points of the edges and the corners, `M₁` among the slopes, `M₂`
/// among the twists (tested as `bicubic_error_stays_below_its_bound`). On an edge whose data fit exactly, the point equals
/// the boundary curve's.
///
/// # Cost
///
/// One point of each of the eight curves and 28 multiples of points.
///
/// # Edge cases
///
/// Outside `[0, 1]` the formula extrapolates; with incompatible twists it is singular where the distances from a corner
/// cancel (`u + v = 0`), and takes the twist of `Q1` or `Q2` there.
///
/// # Source
///
/// Farin 2002, section 22.3; Gregory 1974.
// ANCHOR: bicubic_point
pub fn bicubic_point<C: Curve>(data: &HermiteBoundary<C>, u: C::Scalar, v: C::Scalar) -> C::Point {
    let boundary = data.boundary();
    let [in_u, in_v] = [hermite_basis(u), hermite_basis(v)];
    let along_u = [
        boundary.p1().point(u),
        data.p1_v().point(u),
        data.p2_v().point(u),
        boundary.p2().point(u),
    ];
    let along_v = [
        boundary.q1().point(v),
        data.q1_u().point(v),
        data.q2_u().point(v),
        boundary.q2().point(v),
    ];
    let s1 = C::Point::combination(in_v, along_u);
    let s2 = C::Point::combination(in_u, along_v);
    let s3 = tensor_product(in_u, data.corner_vectors(u, v), in_v);
    boolean_sum(s1, s2, s3)
}
// ANCHOR_END: bicubic_point

/// `Σᵢⱼ in_u[i] · vectors[i][j] · in_v[j]`, summed over `i` first.
pub(super) fn tensor_product<P: VectorSpace>(
    in_u: [P::Scalar; 4],
    vectors: [[P; 4]; 4],
    in_v: [P::Scalar; 4],
) -> P {
    let column = |j: usize| P::combination(in_u, vectors.map(|row| row[j]));
    P::combination(in_v, [column(0), column(1), column(2), column(3)])
}

/// The partial derivatives `[S_u, S_v]` of the bicubically blended patch; `None` where a curve's derivative is not known.
///
/// # Edge cases
///
/// With incompatible twists `S_u` and `S_v` are continuous, also at the corners; the mixed derivative there is not.
pub fn bicubic_partials<C: Curve>(
    data: &HermiteBoundary<C>,
    u: C::Scalar,
    v: C::Scalar,
) -> Option<[C::Point; 2]> {
    let boundary = data.boundary();
    let along_u = [boundary.p1(), data.p1_v(), data.p2_v(), boundary.p2()];
    let along_v = [boundary.q1(), data.q1_u(), data.q2_u(), boundary.q2()];
    let [in_u, in_v] = [hermite_basis(u), hermite_basis(v)];
    let [slope_u, slope_v] = [hermite_basis_derivative(u), hermite_basis_derivative(v)];
    let vectors = data.corner_vectors(u, v);
    let [turn_u, turn_v] = data.turning_twists(u, v);
    let s3_u = tensor_product(slope_u, vectors, in_v).plus(turn_u);
    let s3_v = tensor_product(in_u, vectors, slope_v).plus(turn_v);
    let s_u = boolean_sum(
        C::Point::combination(in_v, derivatives(along_u, u)?),
        C::Point::combination(slope_u, along_v.map(|curve| curve.point(v))),
        s3_u,
    );
    let s_v = boolean_sum(
        C::Point::combination(slope_v, along_u.map(|curve| curve.point(u))),
        C::Point::combination(in_u, derivatives(along_v, v)?),
        s3_v,
    );
    Some([s_u, s_v])
}

/// The derivatives of four curves at one parameter, where all are known.
fn derivatives<C: Curve>(curves: [&C; 4], t: C::Scalar) -> Option<[C::Point; 4]> {
    let [first, second, third, fourth] = curves.map(|curve| curve.derivative(t));
    Some([first?, second?, third?, fourth?])
}

/// The bicubically blended Coons patch of a boundary with slopes.
#[derive(Clone, Debug)]
pub struct BicubicPatch<C: Curve> {
    data: HermiteBoundary<C>,
}

impl<C: Curve> BicubicPatch<C> {
    /// The patch that `data` determines.
    pub fn new(data: HermiteBoundary<C>) -> Self {
        Self { data }
    }

    /// The curves and twists that it interpolates.
    pub fn data(&self) -> &HermiteBoundary<C> {
        &self.data
    }
}

impl<C: Curve> Surface for BicubicPatch<C> {
    type Scalar = C::Scalar;
    type Point = C::Point;

    fn domain(&self) -> [[C::Scalar; 2]; 2] {
        [[C::Scalar::zero(), C::Scalar::one()]; 2]
    }

    fn point(&self, u: C::Scalar, v: C::Scalar) -> C::Point {
        bicubic_point(&self.data, u, v)
    }

    fn partials(&self, u: C::Scalar, v: C::Scalar) -> Option<[C::Point; 2]> {
        bicubic_partials(&self.data, u, v)
    }
}
