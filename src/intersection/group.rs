//! Groups: the first of many surfaces, by asking all of them.

use super::{Hit, Intersect};
use crate::ray::Ray;

/// The nearest hit among `members`, with the number of the member that is hit; where several are hit at the same t, the first of them.
///
/// The best distance so far starts at the ray's own end, so that what lies beyond it is never found.
///
/// # Cost
///
/// Every member is asked once: linear in their number.
///
/// # Source
///
/// Slide 104, with the end of the ray kept.
///
/// # Examples
///
/// ```
/// use facette::intersection::{Sphere, nearest};
/// use facette::ray::Ray;
///
/// let spheres = [Sphere::new([0.0, 0.0, 9.0], 1.0)?, Sphere::new([0.0, 0.0, 5.0], 1.0)?];
/// let ray = Ray::new([0.0, 0.0, 0.0], [0.0, 0.0, 1.0]);
/// let (member, hit) = nearest(&spheres, &ray).expect("two spheres ahead");
/// assert_eq!((member, hit.t), (1, 4.0));
/// assert!(nearest(&spheres, &ray.until(1.0)).is_none());
/// # Ok::<(), facette::intersection::IntersectionError<f64>>(())
/// ```
// ANCHOR: nearest
pub fn nearest<T: Intersect>(members: &[T], ray: &Ray<T::Point>) -> Option<(usize, Hit<T::Point>)> {
    let mut best: Option<(usize, Hit<T::Point>)> = None;
    let mut shortened = *ray;
    for (index, member) in members.iter().enumerate() {
        if let Some(hit) = member.intersect(&shortened) {
            let is_nearer = best.is_none_or(|(_, nearest)| hit.t < nearest.t);
            if is_nearer {
                shortened.end = Some(hit.t);
                best = Some((index, hit));
            }
        }
    }
    best
}
// ANCHOR_END: nearest

/// Surfaces that are met as one: the linear loop, kept as the oracle of faster ones.
///
/// # Examples
///
/// Members of different kinds stand behind pointers:
///
/// ```
/// use facette::intersection::{Group, Intersect, Plane, Sphere};
/// use facette::ray::Ray;
///
/// let group: Group<Box<dyn Intersect<Point = [f64; 3]>>> = Group::new(vec![
///     Box::new(Plane::new([0.0, 0.0, 0.0], [0.0, 0.0, 1.0])?),
///     Box::new(Sphere::new([0.0, 0.0, 2.0], 1.0)?),
/// ]);
/// let ray = Ray::new([0.0, 0.0, 9.0], [0.0, 0.0, -1.0]);
/// let (member, hit) = group.nearest(&ray).expect("the sphere is above the plane");
/// assert_eq!((member, hit.t), (1, 6.0));
/// # Ok::<(), facette::intersection::IntersectionError<f64>>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Group<T> {
    members: Vec<T>,
}

impl<T> Group<T> {
    /// The group of these members, which may be none.
    pub fn new(members: Vec<T>) -> Self {
        Self { members }
    }

    /// The members, in the order of their numbers.
    pub fn members(&self) -> &[T] {
        &self.members
    }
}

impl<T: Intersect> Group<T> {
    /// The nearest hit and the number of the member that is hit, as [`nearest`] finds it.
    pub fn nearest(&self, ray: &Ray<T::Point>) -> Option<(usize, Hit<T::Point>)> {
        nearest(&self.members, ray)
    }
}

impl<T: Intersect> Intersect for Group<T> {
    type Point = T::Point;

    fn intersect(&self, ray: &Ray<T::Point>) -> Option<Hit<T::Point>> {
        self.members.intersect(ray)
    }

    fn is_hit_by(&self, ray: &Ray<T::Point>) -> bool {
        self.members.is_hit_by(ray)
    }
}

impl<T: Intersect> Intersect for [T] {
    type Point = T::Point;

    fn intersect(&self, ray: &Ray<T::Point>) -> Option<Hit<T::Point>> {
        nearest(self, ray).map(|(_, hit)| hit)
    }

    fn is_hit_by(&self, ray: &Ray<T::Point>) -> bool {
        self.iter().any(|member| member.is_hit_by(ray))
    }
}

impl<T: Intersect + ?Sized> Intersect for Box<T> {
    type Point = T::Point;

    fn intersect(&self, ray: &Ray<T::Point>) -> Option<Hit<T::Point>> {
        (**self).intersect(ray)
    }

    fn is_hit_by(&self, ray: &Ray<T::Point>) -> bool {
        (**self).is_hit_by(ray)
    }
}

impl<T: Intersect + ?Sized> Intersect for &T {
    type Point = T::Point;

    fn intersect(&self, ray: &Ray<T::Point>) -> Option<Hit<T::Point>> {
        (**self).intersect(ray)
    }

    fn is_hit_by(&self, ray: &Ray<T::Point>) -> bool {
        (**self).is_hit_by(ray)
    }
}
