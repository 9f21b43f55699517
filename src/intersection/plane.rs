//! Planes.

use num_traits::{One, Zero};

use super::{Hit, Intersect, IntersectionError, Side};
use crate::algebra::{Real, Scalar, Vector3, unit_vector};
use crate::ray::Ray;

/// A plane, `(x − a) · n = 0`, whose front is the side that n points to.
///
/// # Examples
///
/// ```
/// use facette::intersection::{Intersect, Plane, Side};
/// use facette::ray::Ray;
///
/// let floor = Plane::new([0.0, 0.0, 0.0], [0.0, 0.0, 1.0])?;
/// let falling = Ray::new([1.0, 2.0, 3.0], [1.0, 0.0, -2.0]);
/// let hit = floor.intersect(&falling).expect("it falls");
/// assert_eq!((hit.t, hit.point, hit.side), (1.5, [2.5, 2.0, 0.0], Side::Front));
/// # Ok::<(), facette::intersection::IntersectionError<f64>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane<P: Vector3> {
    point: P,
    normal: P,
}

impl<P: Vector3> Plane<P> {
    /// The plane through `point` that is perpendicular to `normal`, which may have any length but zero.
    ///
    /// # Errors
    ///
    /// [`IntersectionError::NotFinite`] for NaN or infinity in one of them, [`IntersectionError::NormalIsZero`] for a normal without direction.
    pub fn new(point: P, normal: P) -> Result<Self, IntersectionError<P::Scalar>> {
        IntersectionError::check_finite("the point", point)?;
        IntersectionError::check_finite("the normal", normal)?;
        if normal.largest_coordinate().is_zero() {
            return Err(IntersectionError::NormalIsZero);
        }
        Ok(Self { point, normal })
    }

    /// The point a.
    pub fn point(&self) -> P {
        self.point
    }

    /// The normal n, as it was given.
    pub fn normal(&self) -> P {
        self.normal
    }

    /// The parameter at which the ray's whole line meets the plane, `t = (a − o)·n / d·n`; `None` where it is parallel, `d·n = 0`, whether it
    /// lies in the plane or not, and for NaN. The ray's interval of t does not matter.
    ///
    /// # Accuracy
    ///
    /// As the hit's t, as long as no product overflows or underflows.
    // ANCHOR: plane
    pub fn parameter(&self, ray: &Ray<P>) -> Option<P::Scalar> {
        let approach = ray.direction.dot(self.normal);
        let is_oblique = approach.magnitude() > P::Scalar::zero();
        is_oblique.then(|| self.point.minus(ray.origin).dot(self.normal) / approach)
    }
    // ANCHOR_END: plane

    /// The side that a ray of this direction arrives on.
    pub fn side(&self, direction: P) -> Side {
        Side::of(direction.dot(self.normal))
    }
}

impl<P> Plane<P>
where
    P: Vector3,
    P::Scalar: Real,
{
    /// Bounds on the rounding of the denominator d·n, and of the numerator (a − o)·n: `γ₃ <= 4u` and `γ₄ <= 5u` times the products' absolute values.
    fn rounding(&self, ray: &Ray<P>) -> [P::Scalar; 2] {
        let u = P::Scalar::unit_roundoff();
        let of_direction = absolute_dot(ray.direction, self.normal);
        let of_distance = absolute_dot(self.point.minus(ray.origin), self.normal);
        [
            P::Scalar::from_i32(4) * u * of_direction,
            P::Scalar::from_i32(5) * u * of_distance,
        ]
    }

    /// A bound on the error of t: those of numerator and denominator, over the least that the denominator can be, and the quotient's own.
    fn t_error(&self, ray: &Ray<P>, t: P::Scalar) -> P::Scalar {
        let [of_direction, of_distance] = self.rounding(ray);
        let least_approach = ray.direction.dot(self.normal).magnitude() - of_direction;
        if least_approach <= P::Scalar::zero() {
            // The line may be parallel: then its t is anything.
            return P::Scalar::one() / P::Scalar::zero();
        }
        let of_quotient = P::Scalar::from_i32(2) * P::Scalar::unit_roundoff() * t.magnitude();
        (of_distance + t.magnitude() * of_direction) / least_approach + of_quotient
    }

    /// The point of the plane below or above `point`, and a bound on its distance from the plane.
    fn projected(&self, point: P) -> (P, P::Scalar) {
        let from_anchor = point.minus(self.point);
        let height = from_anchor.dot(self.normal) / self.normal.dot(self.normal);
        let projected = point.minus(self.normal.times(height));
        let u = P::Scalar::unit_roundoff();
        let roundoffs = P::Scalar::from_i32(12) * from_anchor.largest_coordinate();
        (projected, u * (roundoffs + projected.largest_coordinate()))
    }

    /// The same plane and line measured in powers of two near the sizes of n and d, and the unit of t.
    fn scaled(&self, ray: &Ray<P>) -> (Self, Ray<P>, P::Scalar) {
        let unit = |vector: P| P::Scalar::one() / vector.largest_coordinate().power_of_two();
        let per_speed = unit(ray.direction);
        let plane = Self {
            normal: self.normal.times(unit(self.normal)),
            ..*self
        };
        let line = Ray::new(ray.origin, ray.direction.times(per_speed));
        (plane, line, per_speed)
    }
}

/// `Σ |a_k b_k|`, what the rounding of `a · b` is proportional to.
fn absolute_dot<P: Vector3>(a: P, b: P) -> P::Scalar {
    a.absolute().dot(b.absolute())
}

impl<P> Intersect for Plane<P>
where
    P: Vector3,
    P::Scalar: Real,
{
    type Point = P;

    /// The point where the ray passes through the plane.
    ///
    /// # Accuracy
    ///
    /// t is within `t_error` of the true parameter (tested as `plane_error_stays_below_its_bound`): the more oblique the ray, the larger; infinite where rounding hides
    /// whether the ray is parallel. The point is moved onto the plane along the normal, and is within `point_error = u (12 |x − a| + |point|)` of it,
    /// in largest coordinates, x the point on the ray.
    ///
    /// # Edge cases
    ///
    /// A ray in the plane, or parallel to it, does not meet it.
    fn intersect(&self, ray: &Ray<P>) -> Option<Hit<P>> {
        let (plane, line, per_speed) = self.scaled(ray);
        let scaled_t = plane.parameter(&line)?;
        let t = scaled_t * per_speed;
        if !ray.reaches(t) || !Scalar::is_finite(t) {
            return None;
        }
        let (point, point_error) = plane.projected(line.point(scaled_t));
        Some(Hit {
            t,
            t_error: plane.t_error(&line, scaled_t) * per_speed,
            point,
            point_error,
            normal: unit_vector(plane.normal)?,
            parameters: None,
            side: plane.side(line.direction),
        })
    }
}
