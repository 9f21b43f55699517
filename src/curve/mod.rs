//! Parametric curves: what surfaces are hung on.
//!
//! A Coons patch asks no more of its boundary than a point for each parameter and, for tangents, a derivative. One
//! small trait, [`Curve`], says so; a closure, a polyline and a Bézier curve of any degree stand behind it.
//!
//! ```text
//! C : [t0, t1] → space,   t ↦ C(t)                    Bézier:  C(t) = Σ binomial(n, i) (1 − t)ⁿ⁻ⁱ tⁱ bᵢ
//! ```
//!
//! # Conventions
//!
//! Parameters outside the domain extrapolate: a polynomial goes on as itself, a polyline along its first or last
//! segment, a closure does what it does. NaN gives NaN.
//!
//! # Numerics
//!
//! Bézier curves are evaluated by de Casteljau's repeated interpolation. It costs n(n+1)/2 interpolations where
//! Horner's rule costs n, and gives back an error that grows only with the control points' size, never with the
//! cancellation of large monomial coefficients; the end points come out exactly.
//!
//! # Sources
//!
//! G. Farin, *Curves and Surfaces for CAGD*, 5th edition, chapters 4 and 5.
//!
//! *In the course*: the curves behind "Patches de Coons" (*courbes paramétrées, Bézier ou B-splines ou autres*).
//!
//! *In the book*: [Numbers, points and curves](../../../ground_floor.html).

mod bezier;

use std::marker::PhantomData;

use num_traits::{One, Zero};
use thiserror::Error;

pub use bezier::BezierCurve;

use crate::algebra::{Real, Scalar, Vector3, VectorSpace, length};

/// A point for each parameter of an interval, with the derivative where it is known.
pub trait Curve {
    /// The number type of the parameter.
    type Scalar: Scalar;
    /// The type of the points.
    type Point: VectorSpace<Scalar = Self::Scalar>;

    /// The first and the last parameter `[t0, t1]`, `t0 < t1`.
    fn domain(&self) -> [Self::Scalar; 2];

    /// The point `C(t)`.
    fn point(&self, t: Self::Scalar) -> Self::Point;

    /// The derivative `C'(t)`, where it is known.
    fn derivative(&self, t: Self::Scalar) -> Option<Self::Point>;
}

/// A curve behind a pointer: curves of different kinds become one type.
pub type BoxedCurve<P> =
    Box<dyn Curve<Scalar = <P as VectorSpace>::Scalar, Point = P> + Send + Sync>;

macro_rules! curve_behind_pointer {
    ($pointer:ty) => {
        impl<C: Curve + ?Sized> Curve for $pointer {
            type Scalar = C::Scalar;
            type Point = C::Point;

            fn domain(&self) -> [C::Scalar; 2] {
                (**self).domain()
            }

            fn point(&self, t: C::Scalar) -> C::Point {
                (**self).point(t)
            }

            fn derivative(&self, t: C::Scalar) -> Option<C::Point> {
                (**self).derivative(t)
            }
        }
    };
}

curve_behind_pointer!(Box<C>);
curve_behind_pointer!(&C);

/// What is wrong with the data of a curve.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum CurveError {
    /// A list of points is too short to make the curve.
    #[error("a {kind} needs at least {needed} points, but {found} are given")]
    TooFewPoints {
        /// What was to be made.
        kind: &'static str,
        /// How many points it needs.
        needed: usize,
        /// How many there are.
        found: usize,
    },
    /// A coordinate is infinite or NaN.
    #[error("point {index} of a {kind} is {point}: every coordinate must be finite")]
    NotFinite {
        /// What was to be made.
        kind: &'static str,
        /// Which point, counted from 0.
        index: usize,
        /// The point as text.
        point: String,
    },
}

fn check_points<P: VectorSpace>(
    kind: &'static str,
    needed: usize,
    points: &[P],
) -> Result<(), CurveError> {
    if points.len() < needed {
        return Err(CurveError::TooFewPoints {
            kind,
            needed,
            found: points.len(),
        });
    }
    match points
        .iter()
        .position(|point| !point.has_finite_coordinates())
    {
        Some(index) => {
            let point = format!("{:?}", points[index]);
            Err(CurveError::NotFinite { kind, index, point })
        }
        None => Ok(()),
    }
}

/// The derivative of a [`FunctionCurve`] that has none.
pub type UnknownDerivative<P> = fn(<P as VectorSpace>::Scalar) -> P;

/// A curve given by a function on `[0, 1]`, and by another for its derivative where one is known.
///
/// # Examples
///
/// ```
/// use facette::curve::{Curve, FunctionCurve};
///
/// let parabola = FunctionCurve::new(|t: f64| [t, t * t]);
/// assert_eq!(parabola.point(0.5), [0.5, 0.25]);
/// assert_eq!(parabola.derivative(0.5), None);
///
/// let with_tangent = parabola.with_derivative(|t| [1.0, 2.0 * t]);
/// assert_eq!(with_tangent.derivative(0.5), Some([1.0, 1.0]));
/// ```
#[derive(Clone, Debug)]
pub struct FunctionCurve<P, F, D> {
    point: F,
    derivative: Option<D>,
    points: PhantomData<fn() -> P>,
}

impl<P, F> FunctionCurve<P, F, UnknownDerivative<P>>
where
    P: VectorSpace,
    F: Fn(P::Scalar) -> P,
{
    /// The curve `t ↦ point(t)` on `[0, 1]`, without a derivative.
    pub fn new(point: F) -> Self {
        Self {
            point,
            derivative: None,
            points: PhantomData,
        }
    }

    /// The same curve with its derivative `t ↦ derivative(t)`, which is taken at its word.
    pub fn with_derivative<D>(self, derivative: D) -> FunctionCurve<P, F, D>
    where
        D: Fn(P::Scalar) -> P,
    {
        FunctionCurve {
            point: self.point,
            derivative: Some(derivative),
            points: PhantomData,
        }
    }
}

impl<P, F, D> Curve for FunctionCurve<P, F, D>
where
    P: VectorSpace,
    F: Fn(P::Scalar) -> P,
    D: Fn(P::Scalar) -> P,
{
    type Scalar = P::Scalar;
    type Point = P;

    fn domain(&self) -> [P::Scalar; 2] {
        [P::Scalar::zero(), P::Scalar::one()]
    }

    fn point(&self, t: P::Scalar) -> P {
        (self.point)(t)
    }

    fn derivative(&self, t: P::Scalar) -> Option<P> {
        self.derivative.as_ref().map(|derivative| derivative(t))
    }
}

/// A chain of straight segments through given points, on `[0, 1]`.
#[derive(Clone, Debug, PartialEq)]
pub struct Polyline<P: VectorSpace> {
    points: Vec<P>,
    parameters: Vec<P::Scalar>,
}

impl<P: VectorSpace> Polyline<P> {
    /// The polyline that passes through point number `i` of `n + 1` at `t = i / n`.
    ///
    /// # Errors
    ///
    /// [`CurveError::TooFewPoints`] below two points, [`CurveError::NotFinite`] for an infinite or NaN coordinate.
    pub fn new(points: Vec<P>) -> Result<Self, CurveError> {
        check_points("polyline", 2, &points)?;
        let last = count(points.len() - 1);
        let parameters = (0..=last)
            .map(|index| P::Scalar::ratio(index, last))
            .collect();
        Ok(Self { points, parameters })
    }

    /// The polyline whose parameter is the arc length, divided by the whole length. Where all points coincide, or the length
    /// overflows, it is [`Polyline::new`].
    ///
    /// # Errors
    ///
    /// As [`Polyline::new`].
    pub fn by_arc_length(points: Vec<P>) -> Result<Self, CurveError>
    where
        P: Vector3,
        P::Scalar: Real,
    {
        let mut polyline = Self::new(points)?;
        let mut lengths = vec![P::Scalar::zero()];
        for segment in polyline.points.windows(2) {
            lengths.push(lengths[lengths.len() - 1] + length(segment[1].minus(segment[0])));
        }
        let whole = lengths[lengths.len() - 1];
        if whole > P::Scalar::zero() && Scalar::is_finite(whole) {
            polyline.parameters = lengths.into_iter().map(|part| part / whole).collect();
        }
        Ok(polyline)
    }

    /// The points it passes through, in order.
    pub fn points(&self) -> &[P] {
        &self.points
    }

    /// The number of the segment that carries `t`, among those that have a length in parameters: the last one that begins
    /// at or before `t`; the first or the last one outside the domain.
    fn segment(&self, t: P::Scalar) -> usize {
        let starts = &self.parameters[..self.parameters.len() - 1];
        let has_length = |&segment: &usize| self.parameters[segment] < self.parameters[segment + 1];
        let begun = starts.partition_point(|&start| start <= t);
        let last_begun = (0..begun).rev().find(has_length);
        // Nothing has begun before the domain, nor for NaN.
        last_begun
            .or_else(|| (0..starts.len()).find(has_length))
            .unwrap_or(0)
    }
}

impl<P: VectorSpace> Curve for Polyline<P> {
    type Scalar = P::Scalar;
    type Point = P;

    fn domain(&self) -> [P::Scalar; 2] {
        [P::Scalar::zero(), P::Scalar::one()]
    }

    fn point(&self, t: P::Scalar) -> P {
        // A side so short that its length in parameters is rounded away must not move the ends.
        if t == P::Scalar::zero() {
            return self.points[0];
        }
        if t == P::Scalar::one() {
            return self.points[self.points.len() - 1];
        }
        let segment = self.segment(t);
        let [start, end] = [self.parameters[segment], self.parameters[segment + 1]];
        self.points[segment].lerp(self.points[segment + 1], (t - start) / (end - start))
    }

    /// The direction of the segment; at an inner point that of the segment after it.
    fn derivative(&self, t: P::Scalar) -> Option<P> {
        let segment = self.segment(t);
        let [start, end] = [self.parameters[segment], self.parameters[segment + 1]];
        let side = self.points[segment + 1].minus(self.points[segment]);
        Some(side.times(P::Scalar::one() / (end - start)))
    }
}

/// A number of points as an integer that every scalar type can be made from.
pub(crate) fn count(length: usize) -> i32 {
    i32::try_from(length).unwrap_or(i32::MAX)
}
