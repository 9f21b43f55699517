//! Boxes with faces along the axes.

mod slabs;

pub use slabs::{BoxSpan, FaceHit, SlabRay, box_interval};

use num_traits::One;

use super::{Hit, Intersect, IntersectionError, Side};
use crate::algebra::{Real, Scalar, Vector3};
use crate::ray::Ray;

/// A box with faces along the axes, its surface included: `min <= x <= max`, coordinate by coordinate. It may be flat, or a single point.
///
/// # Examples
///
/// ```
/// use facette::intersection::BoundingBox;
/// use facette::ray::Ray;
///
/// let dice = BoundingBox::new([-1.0, -1.0, -1.0], [1.0, 1.0, 1.0])?;
/// let span = dice.span(&Ray::new([-3.0, 0.0, 0.0], [2.0, 0.0, 0.0])).expect("straight through");
/// assert_eq!((span.entry, span.exit), (1.0, 2.0));
/// # Ok::<(), facette::intersection::IntersectionError<f64>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BoundingBox<P: Vector3> {
    min: P,
    max: P,
}

impl<P: Vector3> BoundingBox<P> {
    /// The box from `min` to `max`.
    ///
    /// # Errors
    ///
    /// [`IntersectionError::NotFinite`] for a corner with NaN or infinity, [`IntersectionError::BoxIsReversed`] where `min > max`.
    pub fn new(min: P, max: P) -> Result<Self, IntersectionError<P::Scalar>> {
        IntersectionError::check_finite("the lower corner", min)?;
        IntersectionError::check_finite("the upper corner", max)?;
        for axis in 0..P::DIMENSION {
            let [min, max] = [min.coordinate(axis), max.coordinate(axis)];
            if min > max {
                return Err(IntersectionError::BoxIsReversed { axis, min, max });
            }
        }
        Ok(Self { min, max })
    }

    /// The smallest box that holds all of `points`.
    ///
    /// # Errors
    ///
    /// [`IntersectionError::NoPoints`] for none, [`IntersectionError::NotFinite`] for NaN or infinity in one.
    pub fn around(
        points: impl IntoIterator<Item = P>,
    ) -> Result<Self, IntersectionError<P::Scalar>> {
        let mut all: Option<Self> = None;
        for point in points {
            let one = Self::new(point, point)?;
            all = Some(all.map_or(one, |all| all.union(&one)));
        }
        all.ok_or(IntersectionError::NoPoints)
    }

    /// The smallest box that holds both.
    #[must_use]
    pub fn union(&self, other: &Self) -> Self {
        let axes = [0, 1, 2];
        let least =
            |axis| smaller_ignoring_nan(self.min.coordinate(axis), other.min.coordinate(axis));
        let greatest =
            |axis| larger_ignoring_nan(self.max.coordinate(axis), other.max.coordinate(axis));
        Self {
            min: P::from_coordinates(axes.map(least)),
            max: P::from_coordinates(axes.map(greatest)),
        }
    }

    /// The corner with the smallest coordinates.
    pub fn min(&self) -> P {
        self.min
    }

    /// The corner with the largest coordinates.
    pub fn max(&self) -> P {
        self.max
    }

    /// Whether a point is in the box or on its surface.
    pub fn contains(&self, point: P) -> bool {
        (0..P::DIMENSION).all(|axis| self.holds(axis, point.coordinate(axis)))
    }

    /// Whether a coordinate is in the slab of this axis, both planes included.
    fn holds(&self, axis: usize, coordinate: P::Scalar) -> bool {
        self.min.coordinate(axis) <= coordinate && coordinate <= self.max.coordinate(axis)
    }
}

/// The smaller of two numbers; a where b is NaN.
fn smaller_ignoring_nan<S: Scalar>(a: S, b: S) -> S {
    if b < a { b } else { a }
}

/// The larger of two numbers; a where b is NaN.
fn larger_ignoring_nan<S: Scalar>(a: S, b: S) -> S {
    if b > a { b } else { a }
}

impl<P> Intersect for BoundingBox<P>
where
    P: Vector3,
    P::Scalar: Real,
{
    type Point = P;

    /// The nearest point of the box's six faces: from outside where the ray enters, on the front; from inside where it leaves, on the back.
    ///
    /// # Accuracy
    ///
    /// t is within `3u |t|` of that of the faces as they are, since it is one difference and one quotient (tested as `box_error_stays_below_its_bound`). The point
    /// is on the face exactly: `point_error` is 0. A ray whose true entry and exit are within as much of each other, one that grazes an
    /// edge, may be found to hit or to miss; where no hit may be lost, [`BoundingBox::may_be_hit_by`] is meant.
    fn intersect(&self, ray: &Ray<P>) -> Option<Hit<P>> {
        let face = self.face_hit(ray)?;
        if !Scalar::is_finite(face.t) {
            return None;
        }
        let on_ray = ray.point(face.t);
        let forward = ray.direction.coordinate(face.axis) > P::Scalar::from_i32(0);
        let is_max = forward == (face.side == Side::Back);
        let corner = if is_max { self.max } else { self.min };
        let on_face = |axis| {
            if axis == face.axis {
                return corner.coordinate(axis);
            }
            let at_least = larger_ignoring_nan(on_ray.coordinate(axis), self.min.coordinate(axis));
            smaller_ignoring_nan(at_least, self.max.coordinate(axis))
        };
        let one = P::Scalar::one();
        let outward = |axis| match (axis == face.axis, is_max) {
            (true, true) => one,
            (true, false) => -one,
            (false, _) => P::Scalar::from_i32(0),
        };
        Some(Hit {
            t: face.t,
            t_error: P::Scalar::from_i32(3) * P::Scalar::unit_roundoff() * face.t.magnitude(),
            point: P::from_coordinates([0, 1, 2].map(on_face)),
            point_error: P::Scalar::from_i32(0),
            normal: P::from_coordinates([0, 1, 2].map(outward)),
            parameters: None,
            side: face.side,
        })
    }
}
