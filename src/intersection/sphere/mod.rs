//! Spheres.

mod roots;

pub use roots::{first_root, roots_by_projection, roots_by_quadratic};

use num_traits::{One, Zero};

use super::{Hit, Intersect, IntersectionError, Side};
use crate::algebra::{Real, Scalar, Vector3, unit_vector};
use crate::ray::Ray;
use roots::Crossing;

/// A sphere, `|x − c| = r`, whose normal points outwards.
///
/// # Examples
///
/// ```
/// use facette::intersection::{Intersect, Side, Sphere};
/// use facette::ray::Ray;
///
/// let sphere = Sphere::new([0.0, 0.0, 5.0], 2.0)?;
/// let from_outside = Ray::new([0.0, 0.0, 0.0], [0.0, 0.0, 1.0]);
/// let hit = sphere.intersect(&from_outside).expect("it is straight ahead");
/// assert_eq!((hit.t, hit.side), (3.0, Side::Front));
/// let from_inside = Ray::new([0.0, 0.0, 5.0], [0.0, 0.0, 1.0]);
/// let hit = sphere.intersect(&from_inside).expect("there is no way out");
/// assert_eq!((hit.t, hit.side), (2.0, Side::Back));
/// # Ok::<(), facette::intersection::IntersectionError<f64>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere<P: Vector3> {
    centre: P,
    radius: P::Scalar,
}

impl<P: Vector3> Sphere<P> {
    /// The sphere of radius `radius` around `centre`.
    ///
    /// # Errors
    ///
    /// [`IntersectionError::NotFinite`] for a centre with NaN or infinity, [`IntersectionError::Radius`] for a radius that is not positive
    /// and finite.
    pub fn new(centre: P, radius: P::Scalar) -> Result<Self, IntersectionError<P::Scalar>> {
        IntersectionError::check_finite("the centre", centre)?;
        if radius > P::Scalar::zero() && Scalar::is_finite(radius) {
            Ok(Self { centre, radius })
        } else {
            Err(IntersectionError::Radius { radius })
        }
    }

    /// The centre c.
    pub fn centre(&self) -> P {
        self.centre
    }

    /// The radius r.
    pub fn radius(&self) -> P::Scalar {
        self.radius
    }

    /// The discriminant `(d·p)² − (d·d)(p·p − r²)` of the ray's whole line, with `p = o − c`: positive where the line meets the sphere twice,
    /// zero where it touches it, negative where it passes by.
    ///
    /// A field suffices, so that over exact numbers the sign is the truth; in floating point it is not to be trusted near zero.
    pub fn discriminant(&self, ray: &Ray<P>) -> P::Scalar {
        let (p, d) = (ray.origin.minus(self.centre), ray.direction);
        let dp = d.dot(p);
        dp * dp - d.dot(d) * (p.dot(p) - self.radius * self.radius)
    }
}

impl<P> Sphere<P>
where
    P: Vector3,
    P::Scalar: Real,
{
    /// The parameters at which the ray's whole line enters and leaves the sphere; `None` where it passes by. The ray's interval of t does not
    /// matter.
    ///
    /// # Accuracy
    ///
    /// That of the hit's t: see [`Sphere::intersect`].
    pub fn chord(&self, ray: &Ray<P>) -> Option<[P::Scalar; 2]> {
        Some(self.scaled_line(ray)?.roots())
    }

    #[inline]
    fn scaled_line(&self, ray: &Ray<P>) -> Option<ScaledLine<P>> {
        let p = ray.origin.minus(self.centre);
        let length = largest_size(p, self.radius).power_of_two();
        let speed = largest_size(ray.direction, P::Scalar::zero()).power_of_two();
        let [per_length, per_speed] = [length, speed].map(|unit| P::Scalar::one() / unit);
        let crossing = Crossing::of(
            p.times(per_length),
            ray.direction.times(per_speed),
            self.radius * per_length,
        )?;
        Some(ScaledLine {
            crossing,
            length,
            per_speed,
        })
    }

    /// The hit of the near root, `which` = 0, or of the far one: its point is where an arm from the centre ends.
    fn hit(&self, line: &ScaledLine<P>, which: usize) -> Option<Hit<P>> {
        let normal = unit_vector(line.crossing.arm(which))?;
        let point = self.centre.plus(normal.times(self.radius));
        let u = P::Scalar::unit_roundoff();
        let size = P::Scalar::from_i32(7) * self.radius + point.largest_coordinate();
        Some(Hit {
            t: line.roots()[which],
            t_error: line.in_rays_units(line.crossing.errors()[which]),
            point,
            point_error: u * size,
            normal,
            parameters: None,
            side: [Side::Front, Side::Back][which],
        })
    }
}

/// The largest of the coordinates' absolute values and `least`. NaN is passed over: it makes all that follows NaN, whatever the unit.
#[inline]
fn largest_size<P: Vector3>(vector: P, least: P::Scalar) -> P::Scalar {
    let sizes = vector.absolute().coordinates();
    let larger = |a: P::Scalar, b: P::Scalar| if b > a { b } else { a };
    sizes.into_iter().fold(least, larger)
}

/// A line measured in powers of two near the sizes of its numbers, so that no square overflows or underflows.
struct ScaledLine<P: Vector3> {
    crossing: Crossing<P>,
    length: P::Scalar,
    per_speed: P::Scalar,
}

impl<P> ScaledLine<P>
where
    P: Vector3,
    P::Scalar: Real,
{
    /// A parameter as the ray counts it: no product overflows or underflows unless the last one does.
    fn in_rays_units(&self, t: P::Scalar) -> P::Scalar {
        let is_small = |unit: P::Scalar| unit < P::Scalar::one();
        if is_small(self.length) == is_small(self.per_speed) {
            t * self.length * self.per_speed
        } else {
            t * (self.length * self.per_speed)
        }
    }

    fn roots(&self) -> [P::Scalar; 2] {
        self.crossing.roots().map(|t| self.in_rays_units(t))
    }

    /// The first of the two roots in the ray's interval. A parameter too large for its type is none.
    fn first_in(&self, ray: &Ray<P>) -> Option<usize> {
        let is_in = |t: P::Scalar| ray.reaches(t) && Scalar::is_finite(t);
        self.roots().into_iter().position(is_in)
    }
}

impl<P> Intersect for Sphere<P>
where
    P: Vector3,
    P::Scalar: Real,
{
    type Point = P;

    /// The first of the two points of the line that the ray's interval holds: from outside the near one, on the front; from inside the far one,
    /// on the back.
    ///
    /// # Accuracy
    ///
    /// t is within `t_error` of the true parameter where the true line meets the sphere (tested as `sphere_error_stays_below_its_bound`); where t is subnormal, the bound
    /// may underflow, and the smallest positive number is to be added. A
    /// line whose true distance from the centre is within `u (9 |o − c| + 4 r)` of r may be found to touch or to miss. The point is moved onto the sphere: it is within
    /// `point_error = u (7 r + |point|)` of a point of it, however inaccurate t is (`sphere_point_error_stays_below_its_bound`).
    ///
    /// # Edge cases
    ///
    /// From an origin on the sphere only the other point counts, or none: the sign of `(|p| − r)(|p| + r)`, as computed, says on which side
    /// an origin is. Directions of any length from denormal to huge will do.
    fn intersect(&self, ray: &Ray<P>) -> Option<Hit<P>> {
        let line = self.scaled_line(ray)?;
        let which = line.first_in(ray)?;
        self.hit(&line, which)
    }

    fn is_hit_by(&self, ray: &Ray<P>) -> bool {
        let line = self.scaled_line(ray);
        line.is_some_and(|line| line.first_in(ray).is_some())
    }
}
