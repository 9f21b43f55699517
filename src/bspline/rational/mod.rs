//! Rational curves and surfaces: B-splines with weights, which hold circles and spheres exactly.
//!
//! No polynomial runs round a circle, but a quotient of two does. Give each control point a weight, let the B-spline
//! run in the space of the points `(w P, w)`, and divide by the last coordinate at the end:
//!
//! ```text
//! S(u,v) = ΣΣ Nᵢ Nⱼ wᵢⱼ Pᵢⱼ / ΣΣ Nᵢ Nⱼ wᵢⱼ
//! ```
//!
//! # Conventions
//!
//! Weights are positive: in the domain the denominator is then positive too, and a point is a convex combination of its
//! control points. Outside the domain the denominator may vanish, and the point is infinite or NaN.
//!
//! # Numerics
//!
//! Weights are positive, so the denominator does not cancel in the domain. Derivatives subtract what the weights alone move: a surface far from
//! the origin loses digits of its tangents there.
//!
//! # Sources
//!
//! L. Piegl, W. Tiller, *The NURBS Book*, 2nd edition, 1997, chapters 4 and 7.
//!
//! *In the course*: not treated; cylinders, spheres and cones of later chapters are exact surfaces of this kind.
//!
//! *In the book*: [Circles and spheres](../../../bspline/rational.html).

mod homogeneous;
mod shapes;

use num_traits::{One, Zero};
use thiserror::Error;

pub use homogeneous::Homogeneous;
pub use shapes::{circle, sphere};

use super::normal::normal_of;
use super::{BsplineCurve, BsplineError, BsplineSurface, Direction, KnotVector};
use crate::algebra::{Scalar, Vector3, VectorSpace};
use crate::curve::Curve;
use crate::surface::Surface;
use homogeneous::quotient_derivatives;

/// What keeps data from being a rational curve or surface.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum RationalError<S: std::fmt::Debug> {
    /// The knots or the weighted control points are refused.
    #[error(transparent)]
    Bspline(#[from] BsplineError<S>),
    /// There is not one weight for each control point.
    #[error("there are {weights} weights for {points} control points: each point needs one")]
    WrongWeightCount {
        /// How many control points there are.
        points: usize,
        /// How many weights there are.
        weights: usize,
    },
    /// A weight is not a positive number that one can divide by.
    #[error(
        "weight {index} is {weight:?}: weights must be finite and positive, and so must their reciprocals"
    )]
    UnusableWeight {
        /// Which weight, counted from 0.
        index: usize,
        /// The weight.
        weight: S,
    },
}

/// A B-spline curve whose control points have weights.
///
/// # Examples
///
/// ```
/// use facette::bspline::{KnotVector, RationalCurve};
/// use facette::curve::Curve;
///
/// // With the weight 1 in the middle this would be a parabola; 3 draws it towards the corner.
/// let corner = [[1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
/// let arc = RationalCurve::new(KnotVector::bezier(2), &corner, &[1.0, 3.0, 1.0])?;
/// assert_eq!(arc.point(0.5), [0.875, 0.875]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct RationalCurve<P: VectorSpace> {
    homogeneous: BsplineCurve<Homogeneous<P>>,
}

impl<P: VectorSpace> RationalCurve<P> {
    /// The curve with these knots, control points and weights.
    ///
    /// # Errors
    ///
    /// [`RationalError::WrongWeightCount`] and [`RationalError::UnusableWeight`] as they say; otherwise as
    /// [`BsplineCurve::new`], where a point that its weight makes overflow counts as not finite.
    pub fn new(
        knots: KnotVector<P::Scalar>,
        control_points: &[P],
        weights: &[P::Scalar],
    ) -> Result<Self, RationalError<P::Scalar>> {
        let weighted = weighted_points(control_points, weights)?;
        Self::from_homogeneous(BsplineCurve::new(knots, weighted)?)
    }

    /// The curve of the points that a B-spline of homogeneous points stands for.
    ///
    /// # Errors
    ///
    /// [`RationalError::UnusableWeight`] for a control point whose weight is not positive.
    pub fn from_homogeneous(
        homogeneous: BsplineCurve<Homogeneous<P>>,
    ) -> Result<Self, RationalError<P::Scalar>> {
        check_weights(homogeneous.control_points())?;
        Ok(Self { homogeneous })
    }

    /// The B-spline of homogeneous points behind it: its knots, its refinement, its pieces.
    pub fn homogeneous(&self) -> &BsplineCurve<Homogeneous<P>> {
        &self.homogeneous
    }

    /// The derivative of this order, by Leibniz' rule for `A = w C`; the point itself for order 0.
    ///
    /// # Edge cases
    ///
    /// At a knot, the derivative of the piece that the homogeneous B-spline takes there.
    pub fn derivative_at(&self, order: usize, u: P::Scalar) -> P {
        let numerators: Vec<_> = (0..=order)
            .map(|k| self.homogeneous.derivative_at(k, u))
            .collect();
        quotient_derivatives(&numerators, order + 1)[order]
    }
}

impl<P: VectorSpace> Curve for RationalCurve<P> {
    type Scalar = P::Scalar;
    type Point = P;

    fn domain(&self) -> [P::Scalar; 2] {
        self.homogeneous.domain()
    }

    fn point(&self, u: P::Scalar) -> P {
        self.homogeneous.point(u).projected()
    }

    fn derivative(&self, u: P::Scalar) -> Option<P> {
        Some(self.derivative_at(1, u))
    }
}

/// A B-spline surface whose control points have weights.
///
/// # Examples
///
/// ```
/// use facette::bspline::sphere;
/// use facette::surface::Surface;
///
/// let [x, y, z] = sphere::<[f64; 3]>().point(0.5, 1.5);
/// assert!((x * x + y * y + z * z - 1.0).abs() < 1e-15);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct RationalSurface<P: VectorSpace> {
    homogeneous: BsplineSurface<Homogeneous<P>>,
}

impl<P: VectorSpace> RationalSurface<P> {
    /// The surface with these knots in u and v, control points and weights.
    ///
    /// # Shape
    ///
    /// Points and weights row by row, u fastest, as [`BsplineSurface::new`] takes them.
    ///
    /// # Errors
    ///
    /// As [`RationalCurve::new`], and [`BsplineSurface::new`].
    pub fn new(
        knots: [KnotVector<P::Scalar>; 2],
        control_points: &[P],
        weights: &[P::Scalar],
    ) -> Result<Self, RationalError<P::Scalar>> {
        let weighted = weighted_points(control_points, weights)?;
        Self::from_homogeneous(BsplineSurface::new(knots, weighted)?)
    }

    /// The surface of the points that a B-spline surface of homogeneous points stands for.
    ///
    /// # Errors
    ///
    /// [`RationalError::UnusableWeight`] for a control point whose weight is not positive.
    pub fn from_homogeneous(
        homogeneous: BsplineSurface<Homogeneous<P>>,
    ) -> Result<Self, RationalError<P::Scalar>> {
        check_weights(homogeneous.control_points())?;
        Ok(Self { homogeneous })
    }

    /// The B-spline surface of homogeneous points behind it: its knots, its refinement, its patches.
    pub fn homogeneous(&self) -> &BsplineSurface<Homogeneous<P>> {
        &self.homogeneous
    }

    /// The knots in one direction.
    pub fn knots(&self, direction: Direction) -> &KnotVector<P::Scalar> {
        self.homogeneous.knots(direction)
    }

    /// The partial derivative of order `k` in u and `l` in v, by Leibniz' rule for `A = w S`.
    ///
    /// # Cost
    ///
    /// All `(k + 1)(l + 1)` lower derivatives on the way.
    pub fn derivative_at(&self, [k, l]: [usize; 2], u: P::Scalar, v: P::Scalar) -> P {
        let orders = (0..=l).flat_map(|j| (0..=k).map(move |i| [i, j]));
        let numerators: Vec<_> = orders
            .map(|orders| self.homogeneous.derivative_at(orders, u, v))
            .collect();
        quotient_derivatives(&numerators, k + 1)[l * (k + 1) + k]
    }
}

impl<P: Vector3> RationalSurface<P> {
    /// How wrong a coordinate of each partial derivative `(A_u − w_u S) / w` can be: `A_u` and `w_u` by roundoffs of the largest difference
    /// quotients that they are made of, `S` by roundoffs of the largest weighted point over `w`.
    fn tangents_noise(&self, u: P::Scalar, v: P::Scalar) -> [P::Scalar; 2] {
        let surface = &self.homogeneous;
        let weight = surface.point(u, v).weight;
        let [point, a_u, a_v] =
            surface.largest_differences(u, v, |h| h.weighted.largest_coordinate());
        let [_, w_u, w_v] = surface.largest_differences(u, v, |h| h.weight.magnitude());
        let two = P::Scalar::from_i32(2);
        [(a_u, w_u), (a_v, w_v)].map(|(of_points, of_weights)| {
            let sum = of_points + two * of_weights * (point / weight);
            sum * surface.roundoffs() / weight
        })
    }
}

/// The homogeneous points of these points and weights.
fn weighted_points<P: VectorSpace>(
    points: &[P],
    weights: &[P::Scalar],
) -> Result<Vec<Homogeneous<P>>, RationalError<P::Scalar>> {
    if points.len() != weights.len() {
        return Err(RationalError::WrongWeightCount {
            points: points.len(),
            weights: weights.len(),
        });
    }
    let pairs = points.iter().zip(weights);
    let weighted: Vec<_> = pairs
        .map(|(&point, &weight)| Homogeneous::new(point, weight))
        .collect();
    check_weights(&weighted)?;
    Ok(weighted)
}

/// Refuses weights that are not positive, and those whose reciprocal overflows.
fn check_weights<P: VectorSpace>(
    points: &[Homogeneous<P>],
) -> Result<(), RationalError<P::Scalar>> {
    let is_usable = |weight: P::Scalar| {
        let positive = weight > P::Scalar::zero();
        positive
            && [weight, P::Scalar::one() / weight]
                .into_iter()
                .all(Scalar::is_finite)
    };
    match points.iter().position(|point| !is_usable(point.weight)) {
        Some(index) => Err(RationalError::UnusableWeight {
            index,
            weight: points[index].weight,
        }),
        None => Ok(()),
    }
}

impl<P: VectorSpace> Surface for RationalSurface<P> {
    type Scalar = P::Scalar;
    type Point = P;

    fn domain(&self) -> [[P::Scalar; 2]; 2] {
        self.homogeneous.domain()
    }

    fn point(&self, u: P::Scalar, v: P::Scalar) -> P {
        self.homogeneous.point(u, v).projected()
    }

    /// `S_u = (A_u − w_u S) / w`, and likewise in v.
    ///
    /// # Accuracy
    ///
    /// The difference cancels what the weights alone move: the error is a few u of `|w_u S| / w`, so a surface far from the origin loses
    /// digits of its tangents where its weights differ.
    // ANCHOR: rational_partials
    fn partials(&self, u: P::Scalar, v: P::Scalar) -> Option<[P; 2]> {
        let at = self.homogeneous.point(u, v);
        let (point, reciprocal) = (at.projected(), P::Scalar::one() / at.weight);
        let partials = self.homogeneous.partials(u, v)?;
        Some(partials.map(|partial| {
            let moved_by_weight = point.times(partial.weight);
            partial.weighted.minus(moved_by_weight).times(reciprocal)
        }))
    }
    // ANCHOR_END: rational_partials

    /// As that of a [`BsplineSurface`]: where a partial derivative vanishes, as at a pole of the sphere, the limit from inside the domain.
    fn normal_vector(&self, u: P::Scalar, v: P::Scalar) -> Option<P>
    where
        P: Vector3,
    {
        let knots = [Direction::U, Direction::V].map(|direction| self.knots(direction));
        normal_of(knots, [u, v], self.tangents_noise(u, v), |orders| {
            self.derivative_at(orders, u, v)
        })
    }

    fn points_on_grid(&self, us: &[P::Scalar], vs: &[P::Scalar], points: &mut [P]) {
        let mut homogeneous = vec![Homogeneous::origin(); points.len()];
        self.homogeneous.points_on_grid(us, vs, &mut homogeneous);
        for (point, place) in points.iter_mut().zip(homogeneous) {
            *point = place.projected();
        }
    }
}
