//! What is known of a place where a ray meets a surface.

use crate::algebra::{Real, Scalar, Vector3};

/// The side of a surface that a ray arrives on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// Against the normal: `d · n < 0`, from outside.
    Front,
    /// Along the normal: `d · n > 0`, from inside; and across it, `d · n = 0`, where a curved surface is only touched.
    Back,
}

impl Side {
    /// The side that a ray arrives on, from `d · n` or a multiple of it with the same sign.
    #[inline]
    pub(super) fn of<S: Scalar>(along: S) -> Self {
        if along < S::zero() {
            Self::Front
        } else {
            Self::Back
        }
    }
}

/// Where a ray meets a facet: what a field (`+ − × ÷`) suffices for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FacetHit<S> {
    /// The ray's parameter.
    pub t: S,
    /// The place on the facet: on a triangle `a b c` the weights of b and c, the rest being a's; on a quadrilateral u and v.
    pub parameters: [S; 2],
    /// The side that is hit.
    pub side: Side,
}

impl<S: Scalar> FacetHit<S> {
    /// The barycentric coordinates on a triangle: the weights of its corners, `[1 − v − w, v, w]`.
    #[inline]
    pub fn barycentric(&self) -> [S; 3] {
        let [v, w] = self.parameters;
        [S::one() - v - w, v, w]
    }
}

/// Where a ray meets a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit<P: Vector3> {
    /// The ray's parameter.
    pub t: P::Scalar,
    /// A bound on the error of t.
    pub t_error: P::Scalar,
    /// The point, which need not be `o + t d` to the last bit: where the surface knows a nearer one, it is that.
    pub point: P,
    /// A bound on the error of the point: within so much of every coordinate there is a point of the surface.
    pub point_error: P::Scalar,
    /// The unit normal of the surface, on its front.
    pub normal: P,
    /// The place on a facet or a patch, as [`FacetHit::parameters`]; `None` on a surface without parameters.
    pub parameters: Option<[P::Scalar; 2]>,
    /// The side that is hit.
    pub side: Side,
}

/// The bound on the error of `value` once it is rounded to the type in which it is handed out, rounded up itself.
pub(super) fn rounded_bound<S: Real>(value: f64, error: f64) -> S {
    let unit = S::unit_roundoff().to_f64();
    let is_rounded = unit > f64::unit_roundoff();
    let rounding = if is_rounded { value.abs() * unit } else { 0.0 };
    S::from_f64((error + rounding) * (1.0 + 4.0 * unit))
}
