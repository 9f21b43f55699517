//! The triangle as a surface: hits with error bounds and a unit normal.

use super::robust::{decide, normal};
use crate::algebra::{Real, Scalar, Vector3, VectorSpace, unit_vector};
use crate::intersection::hit::rounded_bound;
use crate::intersection::{Hit, Intersect, IntersectionError};
use crate::ray::Ray;

/// A triangle whose corners run anticlockwise as seen from its front.
///
/// # Accuracy
///
/// Hit or miss, and the side, are those of exact arithmetic ([`robust`](super::robust)). The point comes from the barycentric coordinates, not
/// from `o + t d`, whose error grows with t: it lies on the triangle up to `u |x| + 7u (v |b − a| + w |c − a|)`, coordinate by
/// coordinate (tested as `point_lies_on_the_triangle_within_its_bound`). The normal's coordinates have errors of at most 2⁻²³, usually a few u.
///
/// # Edge cases
///
/// A triangle without area is never hit.
///
/// # Examples
///
/// ```
/// use facette::intersection::triangle::Triangle;
/// use facette::intersection::{Intersect, Side};
/// use facette::ray::Ray;
///
/// let triangle = Triangle::new([[0., 0., 0.], [4., 0., 0.], [0., 4., 0.]])?;
/// let hit = triangle.intersect(&Ray::new([1., 1., 6.], [0., 0., -2.])).expect("the ray points at it");
/// assert_eq!((hit.t, hit.point, hit.normal), (3.0, [1., 1., 0.], [0., 0., 1.]));
/// assert_eq!((hit.parameters, hit.side), (Some([0.25, 0.25]), Side::Front));
/// # Ok::<(), facette::intersection::IntersectionError<f64>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Triangle<P> {
    corners: [P; 3],
}

impl<P: Vector3> Triangle<P> {
    /// The triangle with the corners a, b and c.
    ///
    /// # Errors
    ///
    /// [`IntersectionError::NotFinite`] for a corner with a coordinate that is NaN or infinite.
    pub fn new(corners: [P; 3]) -> Result<Self, IntersectionError<P::Scalar>> {
        for (what, corner) in ["corner a", "corner b", "corner c"]
            .into_iter()
            .zip(corners)
        {
            IntersectionError::check_finite(what, corner)?;
        }
        Ok(Self { corners })
    }

    /// The corners a, b and c.
    pub fn corners(&self) -> [P; 3] {
        self.corners
    }
}

impl<P: Vector3<Scalar: Real>> Intersect for Triangle<P> {
    type Point = P;

    fn intersect(&self, ray: &Ray<P>) -> Option<Hit<P>> {
        let corners = self.corners.map(P::in_double_precision);
        let crossing = decide(
            corners,
            ray.origin.in_double_precision(),
            ray.direction.in_double_precision(),
        )?;
        let t = P::Scalar::from_f64(crossing.t);
        if !(ray.reaches(t) && t.is_finite()) {
            return None;
        }
        let (point, point_error) = point_on(corners, crossing.parameters);
        Some(Hit {
            t,
            t_error: rounded_bound(crossing.t, crossing.t_error),
            point: P::from_coordinates(point.map(P::Scalar::from_f64)),
            point_error: rounded_bound(point.largest_coordinate(), point_error),
            normal: P::from_coordinates(unit_vector(normal(corners))?.map(P::Scalar::from_f64)),
            parameters: Some(crossing.parameters.map(P::Scalar::from_f64)),
            side: crossing.side,
        })
    }
}

/// The point `a + (v (b − a) + w (c − a))` and a bound on its distance from the triangle, for each coordinate.
///
/// Each product has three roundings, in the edge, the product and the sum: 3u. The weights may add up to 1 + 3u, which moves the
/// point out of the triangle by 3u times the same. One more u for the terms of higher order. The last sum rounds by u of the result.
///
/// Where a difference overflows, everything is divided by 16 before, which leaves room for the bound as well: `7/8 + 1/16` of the largest number.
// ANCHOR: point_on
fn point_on([a, b, c]: [[f64; 3]; 3], [v, w]: [f64; 2]) -> ([f64; 3], f64) {
    let unit = f64::EPSILON / 2.0;
    let mut error = 0.0_f64;
    let point = [0, 1, 2].map(|axis| {
        let overflows = !(b[axis] - a[axis] + (c[axis] - a[axis])).is_finite();
        let scale = if overflows { 1.0 / 16.0 } else { 1.0 };
        let [a, b, c] = [a, b, c].map(|corner| corner[axis] * scale);
        let [along_b, along_c] = [v * (b - a), w * (c - a)];
        let point = a + (along_b + along_c);
        let along = 7.0 * (along_b.abs() + along_c.abs());
        error = error.max(unit * (point.abs() + along) / scale);
        point / scale
    });
    (point, error)
}
// ANCHOR_END: point_on
