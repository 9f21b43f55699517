//! Trimmed surfaces: the part of a surface whose parameters lie inside a closed curve.
//!
//! A surface over a rectangle has four sides. Where another surface cuts it off along a curve, as the rounded corner of a
//! suitcase does, the equations stay and the domain shrinks to the inside of a loop in the plane of the parameters:
//!
//! ```text
//! { S(u, v) : (u, v) inside the loop }                      the loop: t ↦ (u(t), v(t)), closed, anticlockwise, without self-crossing
//! ```
//!
//! # Conventions
//!
//! The loop is turned into a polygon once, within a tolerance measured in the plane of the parameters, and the polygon limits the
//! surface from then on: the question which points belong to it and the triangles of its picture then agree. Its inside is on the
//! left of its direction; points on it belong to the surface.
//!
//! # Numerics
//!
//! On which side of a line a point lies is the sign of a sum of two products. In floating point it is trusted where it exceeds a bound of its
//! rounding error; nearer to the line than that, the point counts as on it. Over exact numbers the bound is zero.
//!
//! # Sources
//!
//! J. R. Shewchuk, *Adaptive precision floating-point arithmetic and fast robust geometric predicates*, 1997, section 4.1.
//!
//! *In the course*: the corner of a suitcase (*coin de valise*), which triangles fill.
//!
//! *In the book*: [Surfaces cut along a curve](../../../bspline/trimming.html).

mod flatten;
mod polygon;

use thiserror::Error;

use super::RationalCurve;
use crate::algebra::Scalar;
use crate::surface::Surface;
use polygon::{double_area, first_crossing};

pub use polygon::Place;

/// What keeps a loop from limiting a surface.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum TrimError<S: std::fmt::Debug> {
    /// The tolerance is not a positive number.
    #[error("the tolerance is {tolerance:?}: it must be finite and positive")]
    UnusableTolerance {
        /// The tolerance.
        tolerance: S,
    },
    /// The curve does not come back to where it starts.
    #[error("the curve starts at {start:?} and ends at {end:?}: a loop ends where it starts")]
    Open {
        /// Its first point.
        start: [S; 2],
        /// Its last point.
        end: [S; 2],
    },
    /// The curve jumps inside.
    #[error(
        "the curve jumps from {from:?} to {to:?} at the parameter {parameter:?}: a loop is continuous"
    )]
    Jump {
        /// Where it jumps.
        parameter: S,
        /// The point before.
        from: [S; 2],
        /// The point after.
        to: [S; 2],
    },
    /// The tolerance asks for too many sides.
    #[error(
        "within {tolerance:?} the piece from {start:?} to {end:?} of the curve would be more than 2^16 sides: allow more, in the unit of the \
         surface's parameters"
    )]
    TooManySides {
        /// The tolerance.
        tolerance: S,
        /// Where the piece starts.
        start: S,
        /// Where it ends.
        end: S,
    },
    /// A part of the curve lies outside the surface's domain.
    #[error("the curve passes through {point:?}, outside the domain {domain:?} of the surface")]
    OutsideDomain {
        /// The point of the plane of parameters.
        point: [S; 2],
        /// The domain `[[u₀, u₁], [v₀, v₁]]`.
        domain: [[S; 2]; 2],
    },
    /// The curve encloses nothing.
    #[error(
        "the curve encloses no area: its polygon of {sides} sides is flat as far as rounding can tell"
    )]
    NoArea {
        /// How many sides its polygon has.
        sides: usize,
    },
    /// The curve meets itself.
    #[error("the sides from {} to {} and from {} to {} of the curve's polygon meet: a loop must not cross or touch itself", first[0], second[0], first[1], second[1])]
    MeetsItself {
        /// Where the two sides start, as text.
        first: [String; 2],
        /// Where they end, as text.
        second: [String; 2],
    },
    /// The curve runs clockwise.
    #[error(
        "the loop runs clockwise: what is kept lies on its left, so reverse it to keep its inside"
    )]
    Clockwise,
}

/// The part of a surface inside a loop of its parameter plane.
///
/// # Examples
///
/// ```
/// use facette::bspline::{BsplineSurface, KnotVector, RationalCurve, TrimmedSurface};
///
/// let square = [[0., 0., 0.], [1., 0., 0.], [0., 1., 0.], [1., 1., 1.]];
/// let sheet = BsplineSurface::new([KnotVector::bezier(1), KnotVector::bezier(1)], square.to_vec())?;
/// // The corner at (1, 1) is cut off.
/// let corners = [[0., 0.], [1., 0.], [1., 0.5], [0.5, 1.], [0., 1.], [0., 0.]];
/// let knots = KnotVector::clamped_uniform(1, corners.len())?;
/// let outline = RationalCurve::new(knots, &corners, &[1.0; 6])?;
/// let trimmed = TrimmedSurface::new(sheet, outline, 1e-6)?;
/// assert_eq!(trimmed.polygon(), &corners[..5]);
/// assert!(trimmed.contains(0.7, 0.7) && !trimmed.contains(0.8, 0.8));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct TrimmedSurface<F: Surface> {
    surface: F,
    outline: RationalCurve<[F::Scalar; 2]>,
    polygon: Vec<[F::Scalar; 2]>,
}

impl<F: Surface> TrimmedSurface<F> {
    /// The part of `surface` inside the polygon that follows `outline` within `tolerance`, in the unit of the parameters.
    ///
    /// A quarter of the tolerance is for a gap between the ends of the outline and for jumps at knots, another for points that lie outside the
    /// surface's domain and are moved to its edge, and half for the sides.
    ///
    /// # Errors
    ///
    /// [`TrimError`]'s variants as they say.
    pub fn new(
        surface: F,
        outline: RationalCurve<[F::Scalar; 2]>,
        tolerance: F::Scalar,
    ) -> Result<Self, TrimError<F::Scalar>> {
        if !(Scalar::is_finite(tolerance) && tolerance > F::Scalar::from_i32(0)) {
            return Err(TrimError::UnusableTolerance { tolerance });
        }
        let points = flatten::flattened(&outline, tolerance)?;
        let polygon = polygon::moved_into(surface.domain(), points, tolerance)?;
        check_simple(&polygon)?;
        Ok(Self {
            surface,
            outline,
            polygon,
        })
    }

    /// The whole surface.
    pub fn surface(&self) -> &F {
        &self.surface
    }

    /// The loop as it was given.
    pub fn outline(&self) -> &RationalCurve<[F::Scalar; 2]> {
        &self.outline
    }

    /// The corners `[u, v]` of the polygon that limits the surface, anticlockwise, each once.
    pub fn polygon(&self) -> &[[F::Scalar; 2]] {
        &self.polygon
    }

    /// Where the parameters `(u, v)` lie with respect to the polygon.
    ///
    /// # Accuracy
    ///
    /// Inside and outside are certain. In floating point, [`Place::Edge`] may also be said of a point whose distance from the line of a side is a few
    /// unit roundoffs of its distance from that side's ends.
    ///
    /// # Cost
    ///
    /// A look at every side.
    ///
    /// # Edge cases
    ///
    /// NaN and infinite parameters lie outside.
    pub fn place_of(&self, u: F::Scalar, v: F::Scalar) -> Place {
        polygon::place_of(&self.polygon, [u, v])
    }

    /// Whether the parameters `(u, v)` belong to the trimmed surface: inside the polygon, or on it.
    pub fn contains(&self, u: F::Scalar, v: F::Scalar) -> bool {
        self.place_of(u, v) != Place::Outside
    }
}

/// Refuses polygons that are flat, meet themselves or run clockwise.
fn check_simple<S: Scalar>(polygon: &[[S; 2]]) -> Result<(), TrimError<S>> {
    let sides = polygon.len();
    if sides < 3 {
        return Err(TrimError::NoArea { sides });
    }
    if let Some([first, second]) = first_crossing(polygon) {
        let text = |side: usize| format!("{:?}", polygon[side % sides]);
        return Err(TrimError::MeetsItself {
            first: [text(first), text(second)],
            second: [text(first + 1), text(second + 1)],
        });
    }
    let area = double_area(polygon);
    if area < S::zero() {
        return Err(TrimError::Clockwise);
    }
    if area.is_zero() {
        return Err(TrimError::NoArea { sides });
    }
    Ok(())
}
