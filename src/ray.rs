//! Rays: half-lines with a parameter, which cameras send out and surfaces stop.
//!
//! ```text
//! r(t) = o + t d          start < t <= end
//! ```
//!
//! # Conventions
//!
//! The interval of t is half-open: a ray leaves its start, and reaches its end. By default it is `t > 0`, without an end. The direction need
//! not have length 1: t counts multiples of it, so a ray towards a lamp, with `d = lamp − o`, reaches it at t = 1.
//!
//! # Numerics
//!
//! A ray with a coordinate that is not finite, or with the direction zero, meets nothing: every intersector answers so, since a comparison
//! with NaN is false.
//!
//! *In the course*: slides 88 to 93 (*rayon*, *demi-droite*).
//!
//! *In the book*: [Cameras](../../../camera.html).

use num_traits::Zero;

use crate::algebra::Vector3;

/// A half-line or a segment, `o + t d` for `start < t <= end`.
///
/// # Examples
///
/// ```
/// use facette::ray::Ray;
///
/// let ray = Ray::new([1., 0., 0.], [0., 2., 0.]).until(3.0);
/// assert_eq!(ray.point(3.0), [1., 6., 0.]);
/// assert!(ray.reaches(3.0) && !ray.reaches(0.0));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray<P: Vector3> {
    /// The point o where t = 0.
    pub origin: P,
    /// The direction d, of any length but zero.
    pub direction: P,
    /// Where the interval of t begins; the start itself does not belong to it.
    pub start: P::Scalar,
    /// Where the interval of t ends, the end included; `None` for a ray without an end.
    pub end: Option<P::Scalar>,
}

impl<P: Vector3> Ray<P> {
    /// The half-line `o + t d`, t > 0.
    #[inline]
    pub fn new(origin: P, direction: P) -> Self {
        Self {
            origin,
            direction,
            start: P::Scalar::zero(),
            end: None,
        }
    }

    /// The same ray from `start` on, the start itself left out.
    #[inline]
    #[must_use]
    pub fn after(self, start: P::Scalar) -> Self {
        Self { start, ..self }
    }

    /// The same ray up to `end`, the end included.
    #[inline]
    #[must_use]
    pub fn until(self, end: P::Scalar) -> Self {
        Self {
            end: Some(end),
            ..self
        }
    }

    /// The point `o + t d`.
    #[inline]
    pub fn point(&self, t: P::Scalar) -> P {
        self.origin.plus(self.direction.times(t))
    }

    /// Whether `start < t <= end`; false for NaN.
    #[inline]
    pub fn reaches(&self, t: P::Scalar) -> bool {
        t > self.start && self.end.is_none_or(|end| t <= end)
    }
}
