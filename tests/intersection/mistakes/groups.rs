//! The typical mistakes with many surfaces.

use facette::algebra::Vector3;
use facette::intersection::{Hit, Intersect};
use facette::ray::Ray;

use super::{EQUALS, LEAST, MAXIMUM, ONCE, is_of};

/// The number of the member, and its hit.
type Answer<P> = Option<(usize, Hit<P>)>;

/// What the mistake makes of the nearest of many; `None` for a mistake of another function.
#[allow(
    clippy::option_option,
    reason = "the outer one says whether the mistake is of this function"
)]
pub fn nearest<T: Intersect>(
    mistake: &str,
    members: &[T],
    ray: &Ray<T::Point>,
) -> Option<Answer<T::Point>> {
    is_of(&[LEAST, MAXIMUM, EQUALS, ONCE], mistake).then(|| wrong_nearest(mistake, members, ray))
}

fn wrong_nearest<T: Intersect>(
    mistake: &str,
    members: &[T],
    ray: &Ray<T::Point>,
) -> Answer<T::Point> {
    let asked = if mistake == "maximum_forgotten" {
        Ray { end: None, ..*ray }
    } else {
        *ray
    };
    let mut best: Answer<T::Point> = None;
    for (index, member) in members.iter().enumerate() {
        let hit = if mistake == "asked_twice" && member.is_hit_by(&asked) {
            member.intersect(&asked)
        } else if mistake == "asked_twice" {
            None
        } else {
            member.intersect(&asked)
        };
        if let Some(hit) = hit
            && replaces(mistake, &hit, best.as_ref())
        {
            best = Some((index, hit));
        }
    }
    best
}

fn replaces<P: Vector3>(mistake: &str, hit: &Hit<P>, best: Option<&(usize, Hit<P>)>) -> bool {
    best.is_none_or(|(_, best)| match mistake {
        "last_hit" => true,
        "first_hit" => false,
        "farthest" => hit.t > best.t,
        "last_of_equals" => hit.t <= best.t,
        _ => hit.t < best.t,
    })
}
