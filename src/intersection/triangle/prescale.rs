//! Scaling by powers of two, which changes no digit: what keeps products from overflow and underflow.

use num_traits::Zero;

use crate::algebra::{Real, Vector3, VectorSpace, larger};
use crate::intersection::FacetHit;
use crate::ray::Ray;

/// The answer of `test` for the triangle and the ray, both scaled to coordinates between 1 and 2 by powers of two, which round nothing.
///
/// Positions are multiplied by one factor and the direction by another, so that `t` changes by their quotient. In the middle of
/// the range of numbers the answer has the same bits as without scaling.
///
/// # Examples
///
/// ```
/// use facette::intersection::triangle::{moller_trumbore, prescaled};
/// use facette::ray::Ray;
///
/// let tiny = [[0., 0., 1e-110], [1e-110, 0., 1e-110], [0., 1e-110, 1e-110]];
/// let ray = Ray::new([0.25e-110, 0.25e-110, 0.], [0., 0., 1.]);
/// assert!(moller_trumbore(&tiny, &ray).is_none());
/// assert_eq!(prescaled(&tiny, &ray, moller_trumbore).map(|hit| hit.t), Some(1e-110));
/// ```
pub fn prescaled<P>(
    corners: &[P; 3],
    ray: &Ray<P>,
    test: impl Fn(&[P; 3], &Ray<P>) -> Option<FacetHit<P::Scalar>>,
) -> Option<FacetHit<P::Scalar>>
where
    P: Vector3<Scalar: Real>,
{
    let positions = [ray.origin, corners[0], corners[1], corners[2]];
    let sizes = positions.map(VectorSpace::largest_coordinate);
    let of_positions = unit_of(sizes.into_iter().fold(P::Scalar::zero(), larger));
    let of_direction = unit_of(ray.direction.largest_coordinate());
    let scaled = Ray {
        origin: ray.origin.times(of_positions),
        direction: ray.direction.times(of_direction),
        start: ray.start * of_positions / of_direction,
        end: ray.end.map(|end| end * of_positions / of_direction),
    };
    let hit = test(&corners.map(|corner| corner.times(of_positions)), &scaled)?;
    let t = hit.t / of_positions * of_direction;
    ray.reaches(t).then_some(FacetHit { t, ..hit })
}

/// What to multiply by so that `size` lies between 1 and 2.
fn unit_of<S: Real>(size: S) -> S {
    S::one() / size.power_of_two()
}
