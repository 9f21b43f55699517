//! B-spline curves.

use num_traits::Zero;

use super::basis::{basis_functions, find_span, with_buffer};
use super::refine::{self, insert_knot};
use super::{BsplineError, KnotVector};
use crate::algebra::VectorSpace;
use crate::curve::{BezierCurve, Curve};

/// The point `C(u) = Σ Nᵢ(u) Pᵢ`, as the sum of the control points with the basis functions that are not zero.
///
/// # Accuracy
///
/// For `u` in the domain, each coordinate is within `(6p + 1)u · M`, `M` the largest coordinate of the `p + 1` control points
/// (tested as `curve_error_stays_below_its_bound`).
///
/// # Panics
///
/// When there are not as many control points as basis functions.
// ANCHOR: curve_point
pub fn curve_point<P: VectorSpace>(
    knots: &KnotVector<P::Scalar>,
    control_points: &[P],
    u: P::Scalar,
) -> P {
    let span = find_span(knots, u);
    let degree = knots.degree();
    with_buffer(degree + 1, P::Scalar::zero(), |values| {
        basis_functions(knots, span, u, values);
        weighted_sum(values, &control_points[span - degree..=span])
    })
}
// ANCHOR_END: curve_point

/// The sum `Σ weights[i] · points[i]`, added from the left; the points are as many as the weights.
#[inline]
pub(super) fn weighted_sum<P: VectorSpace>(weights: &[P::Scalar], points: &[P]) -> P {
    let terms = weights.iter().zip(points);
    terms
        .map(|(&weight, point)| point.times(weight))
        .reduce(P::plus)
        .unwrap_or_else(P::origin)
}

/// The point `C(u)` by de Boor's points: repeated interpolation between neighbours, as de Casteljau's for a Bézier curve.
///
/// # Accuracy
///
/// For `u` in the domain, each coordinate is within `6pu · M`, `M` the largest coordinate of the `p + 1` control points (tested as
/// `curve_error_stays_below_its_bound`).
///
/// # Cost
///
/// `p (p + 1) / 2` interpolations, each with two divisions.
///
/// # Panics
///
/// When there are not as many control points as basis functions.
///
/// # Source
///
/// de Boor 1972.
// ANCHOR: de_boor_point
pub fn de_boor_point<P: VectorSpace>(
    knots: &KnotVector<P::Scalar>,
    control_points: &[P],
    u: P::Scalar,
) -> P {
    let span = find_span(knots, u);
    let points = &control_points[span - knots.degree()..=span];
    de_boor(knots, points, span, |_| u)
}
// ANCHOR_END: de_boor_point

/// The blossom of the polynomial of a span: the symmetric function of `p` arguments, affine in each, that is the curve's
/// point where all arguments are equal. At the arguments `uⱼ₊₁, …, uⱼ₊ₚ` it is the control point `Pⱼ`.
///
/// # Panics
///
/// When there are not `p` arguments, as many control points as basis functions, or a span of that number.
///
/// # Source
///
/// Ramshaw 1987.
pub fn blossom<P: VectorSpace>(
    knots: &KnotVector<P::Scalar>,
    control_points: &[P],
    span: usize,
    arguments: &[P::Scalar],
) -> P {
    let points = &control_points[span - knots.degree()..=span];
    piece_blossom(knots, points, span, arguments)
}

/// As [`blossom`], from the `p + 1` control points of the span alone.
pub(crate) fn piece_blossom<P: VectorSpace>(
    knots: &KnotVector<P::Scalar>,
    points: &[P],
    span: usize,
    arguments: &[P::Scalar],
) -> P {
    assert!(
        arguments.len() == knots.degree(),
        "a blossom of degree {} takes as many arguments, not {}",
        knots.degree(),
        arguments.len()
    );
    de_boor(knots, points, span, |level| arguments[level - 1])
}

/// De Boor's scheme on the `p + 1` control points of a span, with an argument of its own for each of the levels `1, …, p`.
// ANCHOR: de_boor
fn de_boor<P: VectorSpace>(
    knots: &KnotVector<P::Scalar>,
    control_points: &[P],
    span: usize,
    argument: impl Fn(usize) -> P::Scalar,
) -> P {
    let degree = knots.degree();
    let u_at = |index: usize| knots.knots()[index];
    with_buffer(degree + 1, P::origin(), |points| {
        points.copy_from_slice(control_points);
        for level in 1..=degree {
            for index in (level..=degree).rev() {
                let i = span - degree + index;
                let support = [u_at(i), u_at(i + degree + 1 - level)];
                let [falling, rising] = knots.weights(argument(level), support);
                let left = points[index - 1].times(falling);
                points[index] = left.plus(points[index].times(rising));
            }
        }
        points[degree]
    })
}
// ANCHOR_END: de_boor

/// One polynomial of a B-spline curve, as the Bézier curve that it is.
#[derive(Clone, Debug, PartialEq)]
pub struct BezierPiece<P: VectorSpace> {
    /// The interval of the B-spline's parameter that the Bézier curve's `[0, 1]` stands for.
    pub interval: [P::Scalar; 2],
    /// The Bézier curve.
    pub curve: BezierCurve<P>,
}

/// A B-spline curve `C(u) = Σ Nᵢᵖ(u) Pᵢ`.
///
/// # Examples
///
/// ```
/// use facette::bspline::{BsplineCurve, KnotVector};
/// use facette::curve::Curve;
///
/// let knots = KnotVector::clamped(2, &[0.0, 1.0, 2.0])?;
/// let curve = BsplineCurve::new(knots, vec![[0.0, 0.0], [1.0, 2.0], [3.0, 2.0], [4.0, 0.0]])?;
/// assert_eq!(curve.point(1.0), [2.0, 2.0]);
/// assert_eq!(curve.derivative(1.0), Some([2.0, 0.0]));
/// # Ok::<(), facette::bspline::BsplineError<f64>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct BsplineCurve<P: VectorSpace> {
    knots: KnotVector<P::Scalar>,
    control_points: Vec<P>,
}

impl<P: VectorSpace> BsplineCurve<P> {
    /// The curve of these knots and control points.
    ///
    /// # Errors
    ///
    /// [`BsplineError::WrongPointCount`] where the two do not fit, [`BsplineError::PointNotFinite`] for an infinite or NaN
    /// coordinate.
    pub fn new(
        knots: KnotVector<P::Scalar>,
        control_points: Vec<P>,
    ) -> Result<Self, BsplineError<P::Scalar>> {
        let expected = knots.control_point_count();
        if control_points.len() != expected {
            return Err(BsplineError::WrongPointCount {
                knots: knots.knots().len(),
                degree: knots.degree(),
                expected,
                found: control_points.len(),
            });
        }
        check_points(&control_points)?;
        Ok(Self {
            knots,
            control_points,
        })
    }

    /// The degree and the knots.
    pub fn knots(&self) -> &KnotVector<P::Scalar> {
        &self.knots
    }

    /// The control points, `n + 1` of them.
    pub fn control_points(&self) -> &[P] {
        &self.control_points
    }

    /// The degree `p`.
    pub fn degree(&self) -> usize {
        self.knots.degree()
    }

    /// The derivative of this order at `u`: right-sided at a knot, left-sided at the end of the domain. Order 0 is the point.
    ///
    /// # Accuracy
    ///
    /// The differences of control points are taken first, then combined with weights that sum to 1: a first derivative in the domain is
    /// within `6pu · D` in each coordinate, `D` the largest difference quotient `p (Pᵢ₊₁ − Pᵢ) / (uᵢ₊ₚ₊₁ − uᵢ₊₁)` that counts (a surface with `q = 0`
    /// in `partial_derivative_error_stays_below_its_bound`).
    pub fn derivative_at(&self, order: usize, u: P::Scalar) -> P {
        let degree = self.degree();
        if order > degree {
            return P::origin();
        }
        let span = find_span(&self.knots, u);
        with_buffer(degree + 1, P::origin(), |points| {
            points.copy_from_slice(&self.control_points[span - degree..=span]);
            for differences in 1..=order {
                refine::differentiate(&self.knots, span, differences, 1, points);
            }
            with_buffer(degree + 1 - order, P::Scalar::zero(), |values| {
                super::basis::triangle(&self.knots, span, u, values);
                weighted_sum(values, points)
            })
        })
    }

    /// The derivative as a B-spline of degree `p − 1`; the zero curve for degree 0.
    #[must_use]
    pub fn derivative_curve(&self) -> Self {
        let (knots, control_points) = refine::derivative(&self.knots, &self.control_points);
        Self {
            knots,
            control_points,
        }
    }

    /// The polynomials of the non-empty spans, in order. Neighbours share their end points bit for bit where the curve is
    /// continuous.
    pub fn bezier_pieces(&self) -> Vec<BezierPiece<P>> {
        let piece = |span| BezierPiece {
            interval: self.knots.span_interval(span),
            curve: BezierCurve::of_finite_points(refine::bezier_points(
                &self.knots,
                &self.control_points,
                span,
            )),
        };
        self.knots.spans().map(piece).collect()
    }

    /// The same curve with one more knot at `u`, by Boehm's algorithm.
    ///
    /// # Errors
    ///
    /// As [`KnotVector::with_knot`].
    pub fn with_knot(&self, u: P::Scalar) -> Result<Self, BsplineError<P::Scalar>> {
        Ok(Self {
            knots: self.knots.with_knot(u)?,
            control_points: insert_knot(&self.knots, &self.control_points, u),
        })
    }

    /// The same curve on finer knots, all at once: each control point is a blossom (the Oslo algorithm).
    ///
    /// # Errors
    ///
    /// [`BsplineError::OtherDegree`] and [`BsplineError::OtherDomain`] where they differ, [`BsplineError::NotFiner`] where a knot inside
    /// the domain is missing.
    pub fn refined(&self, finer: &KnotVector<P::Scalar>) -> Result<Self, BsplineError<P::Scalar>> {
        refine::check_finer(&self.knots, finer)?;
        Ok(Self {
            knots: finer.clone(),
            control_points: refine::oslo(&self.knots, &self.control_points, finer),
        })
    }

    /// The same curve with the inner knot `u` one time less, where no coordinate of a control point has to move by more than
    /// `tolerance`, in the unit of the points. Exact numbers take a tolerance of 0.
    ///
    /// # Errors
    ///
    /// [`BsplineError::NoInnerKnot`], or [`BsplineError::KnotNotRemovable`] with the distance.
    pub fn without_knot(
        &self,
        u: P::Scalar,
        tolerance: P::Scalar,
    ) -> Result<Self, BsplineError<P::Scalar>> {
        let (knots, control_points) =
            refine::remove_knot(&self.knots, &self.control_points, u, tolerance)?;
        Ok(Self {
            knots,
            control_points,
        })
    }

    /// The same curve written with degree `p + 1`: every knot stands one time more, so that it is no smoother than before.
    ///
    /// # Cost
    ///
    /// `O(p²)` interpolations for each of the distinct knots around a control point.
    #[must_use]
    pub fn elevated(&self) -> Self {
        let knots = refine::elevated_knots(&self.knots);
        let control_points = refine::elevate(&self.knots, &self.control_points, &knots);
        Self {
            knots,
            control_points,
        }
    }

    /// The same points on another domain: on `[0, 1]` the curve can bound a Coons patch.
    ///
    /// # Errors
    ///
    /// As [`KnotVector::reparametrised`].
    pub fn reparametrised(&self, domain: [P::Scalar; 2]) -> Result<Self, BsplineError<P::Scalar>> {
        Ok(Self {
            knots: self.knots.reparametrised(domain)?,
            control_points: self.control_points.clone(),
        })
    }

    /// The curve of knots and control points that are known to fit.
    pub(super) fn of_fitting(knots: KnotVector<P::Scalar>, control_points: Vec<P>) -> Self {
        debug_assert_eq!(knots.control_point_count(), control_points.len());
        Self {
            knots,
            control_points,
        }
    }
}

/// Refuses control points that are not finite.
pub(super) fn check_points<P: VectorSpace>(
    control_points: &[P],
) -> Result<(), BsplineError<P::Scalar>> {
    let is_bad = |point: &P| !point.has_finite_coordinates();
    match control_points.iter().position(is_bad) {
        Some(index) => Err(BsplineError::PointNotFinite {
            index,
            point: format!("{:?}", control_points[index]),
        }),
        None => Ok(()),
    }
}

impl<P: VectorSpace> Curve for BsplineCurve<P> {
    type Scalar = P::Scalar;
    type Point = P;

    fn domain(&self) -> [P::Scalar; 2] {
        self.knots.domain()
    }

    fn point(&self, t: P::Scalar) -> P {
        curve_point(&self.knots, &self.control_points, t)
    }

    fn derivative(&self, t: P::Scalar) -> Option<P> {
        Some(self.derivative_at(1, t))
    }
}
