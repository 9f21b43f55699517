//! Bézier curves, by de Casteljau's repeated interpolation.

use num_traits::{One, Zero};

use super::{Curve, CurveError, check_points, count};
use crate::algebra::{Scalar, VectorSpace};

/// A Bézier curve of any degree on `[0, 1]`: `C(t) = Σ binomial(n, i) (1 − t)ⁿ⁻ⁱ tⁱ bᵢ`.
///
/// # Accuracy
///
/// A point is within `3n·u·max|bᵢ|` in each coordinate for `0 <= t <= 1`, `n` the degree (tested as
/// `bezier_error_stays_below_its_bound`), and exact at `t = 0` and `t = 1`.
///
/// # Cost
///
/// n(n+1)/2 interpolations; no allocation up to degree 15.
///
/// # Examples
///
/// ```
/// use facette::curve::{BezierCurve, Curve};
///
/// let arch = BezierCurve::new(vec![[0.0, 0.0], [1.0, 2.0], [2.0, 0.0]])?;
/// assert_eq!(arch.point(0.5), [1.0, 1.0]);
/// assert_eq!(arch.derivative(0.0), Some([2.0, 4.0]));
/// # Ok::<(), facette::curve::CurveError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct BezierCurve<P> {
    control_points: Vec<P>,
}

/// So many control points are interpolated on the stack; more need a list of their own.
const STACK_POINTS: usize = 16;

impl<P: VectorSpace> BezierCurve<P> {
    /// The curve of degree `control_points.len() − 1`.
    ///
    /// # Errors
    ///
    /// [`CurveError::TooFewPoints`] for no point at all, [`CurveError::NotFinite`] for an infinite or NaN coordinate.
    pub fn new(control_points: Vec<P>) -> Result<Self, CurveError> {
        check_points("Bézier curve", 1, &control_points)?;
        Ok(Self { control_points })
    }

    /// The curve of control points that are known to be finite, at least one.
    pub(crate) fn of_finite_points(control_points: Vec<P>) -> Self {
        debug_assert!(!control_points.is_empty(), "a curve has a control point");
        Self { control_points }
    }

    /// The control points, `degree + 1` of them.
    pub fn control_points(&self) -> &[P] {
        &self.control_points
    }

    /// The degree `n`, one less than the number of control points.
    pub fn degree(&self) -> usize {
        self.control_points.len() - 1
    }

    /// Runs de Casteljau's scheme until `keep` points are left, and hands them to `finish`.
    ///
    /// Cubics, the most used, have a branch of their own: where the compiler knows the number of points, it unrolls the
    /// loops and keeps the points in registers (the report of speed against error shows what that gives).
    fn interpolated<R>(&self, t: P::Scalar, keep: usize, finish: impl FnOnce(&[P]) -> R) -> R {
        if let &[b0, b1, b2, b3] = &self.control_points[..] {
            let mut cubic = [b0, b1, b2, b3];
            de_casteljau(&mut cubic, keep, t);
            return finish(&cubic[..keep]);
        }
        self.interpolated_at_any_degree(t, keep, finish)
    }

    /// As [`Self::interpolated`]; kept out of it, so that cubics do not pay for its stack.
    #[inline(never)]
    fn interpolated_at_any_degree<R>(
        &self,
        t: P::Scalar,
        keep: usize,
        finish: impl FnOnce(&[P]) -> R,
    ) -> R {
        let count = self.control_points.len();
        let mut on_stack = [P::origin(); STACK_POINTS];
        let mut in_list;
        let points = if count <= STACK_POINTS {
            on_stack[..count].copy_from_slice(&self.control_points);
            &mut on_stack[..count]
        } else {
            in_list = self.control_points.clone();
            &mut in_list[..]
        };
        de_casteljau(points, keep, t);
        finish(&points[..keep])
    }
}

/// Replaces neighbouring points by the point between them, `count` points by `count − 1`, until `keep` are left.
// ANCHOR: de_casteljau
fn de_casteljau<P: VectorSpace>(points: &mut [P], keep: usize, t: P::Scalar) {
    for left in (keep..points.len()).rev() {
        for index in 0..left {
            points[index] = points[index].lerp(points[index + 1], t);
        }
    }
}
// ANCHOR_END: de_casteljau

impl<P: VectorSpace> Curve for BezierCurve<P> {
    type Scalar = P::Scalar;
    type Point = P;

    fn domain(&self) -> [P::Scalar; 2] {
        [P::Scalar::zero(), P::Scalar::one()]
    }

    fn point(&self, t: P::Scalar) -> P {
        self.interpolated(t, 1, |points| points[0])
    }

    /// `C'(t) = n (b₁ − b₀)`, with the last two points of de Casteljau's scheme.
    fn derivative(&self, t: P::Scalar) -> Option<P> {
        if self.degree() == 0 {
            return Some(P::origin());
        }
        let last_side = self.interpolated(t, 2, |points| points[1].minus(points[0]));
        Some(last_side.times(P::Scalar::from_i32(count(self.degree()))))
    }
}
