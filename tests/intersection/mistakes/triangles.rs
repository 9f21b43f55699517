//! The typical mistakes with a triangle.

use facette::algebra::{Scalar, Vector3};
use facette::intersection::{FacetHit, Side};
use facette::ray::Ray;
use num_traits::{One, Zero};

use super::{ALL_HITS, HALF_PLANES, INTERVAL, is_of};

type Answer<S> = Option<FacetHit<S>>;

/// What the mistake makes of the half-planes; `None` for a mistake of another function.
#[allow(
    clippy::option_option,
    reason = "the outer one says whether the mistake is of this function"
)]
pub fn half_planes<P: Vector3>(
    mistake: &str,
    corners: &[P; 3],
    ray: &Ray<P>,
) -> Option<Answer<P::Scalar>> {
    is_of(&[HALF_PLANES], mistake).then(|| wrong_half_planes(mistake, corners, ray))
}

fn wrong_half_planes<P: Vector3>(
    mistake: &str,
    &[a, b, c]: &[P; 3],
    ray: &Ray<P>,
) -> Answer<P::Scalar> {
    let n = b.minus(a).cross(c.minus(a));
    let (along, square, zero) = (ray.direction.dot(n), n.dot(n), P::Scalar::zero());
    if along.is_zero() {
        return None;
    }
    let mut t = a.minus(ray.origin).dot(n) / along;
    if mistake == "reversed_t" {
        t = -t;
    }
    let x = ray.point(t);
    let turned = if mistake == "reversed_normal" {
        zero - P::Scalar::one()
    } else {
        P::Scalar::one()
    };
    let half_plane = |from: P, to: P| {
        let start = if mistake == "one_start_for_all" {
            a
        } else {
            from
        };
        to.minus(from).cross(x.minus(start)).dot(n) * turned
    };
    let last = if mistake == "last_edge_reversed" {
        half_plane(a, c)
    } else {
        half_plane(c, a)
    };
    let sides = [half_plane(b, c), last, half_plane(a, b)];
    let tried = if mistake == "last_edge_forgotten" {
        [sides[0], sides[2], sides[2]]
    } else {
        sides
    };
    let is_inside = |side: P::Scalar| {
        if mistake == "open_half_planes" {
            side > zero
        } else {
            side >= zero
        }
    };
    let is_reached = ray.reaches(t) || mistake == "line_for_ray";
    if !(tried.into_iter().all(is_inside) && is_reached) {
        return None;
    }
    let [v, w] = [sides[1] / square, sides[2] / square];
    Some(FacetHit {
        t,
        parameters: match mistake {
            "exchanged_weights" => [w, v],
            "first_two_weights" => [sides[0] / square, v],
            "weights_not_divided" => [sides[1], sides[2]],
            _ => [v, w],
        },
        side: side(mistake == "reversed_side", along),
    })
}

/// The side by the sign of `d · n`, or the other one.
fn side<S: Scalar>(is_wrong: bool, along: S) -> Side {
    if (along < S::zero()) == is_wrong {
        Side::Back
    } else {
        Side::Front
    }
}

/// What the mistake makes of Möller and Trumbore's test; `None` for a mistake of another function.
#[allow(
    clippy::option_option,
    reason = "the outer one says whether the mistake is of this function"
)]
pub fn moller_trumbore<P: Vector3>(
    mistake: &str,
    corners: &[P; 3],
    ray: &Ray<P>,
) -> Option<Answer<P::Scalar>> {
    is_of(&[ALL_HITS, INTERVAL], mistake).then(|| wrong_moller_trumbore(mistake, corners, ray))
}

fn wrong_moller_trumbore<P: Vector3>(
    mistake: &str,
    &[a, b, c]: &[P; 3],
    ray: &Ray<P>,
) -> Answer<P::Scalar> {
    let [zero, one] = [P::Scalar::zero(), P::Scalar::one()];
    let [e1, e2] = [b.minus(a), c.minus(a)];
    let p = ray.direction.cross(e2);
    let determinant = e1.dot(p);
    let is_small =
        mistake == "fixed_threshold" && determinant.magnitude() < P::Scalar::ratio(1, 1000);
    let is_refused = mistake == "front_only" && determinant < zero;
    if determinant.is_zero() || is_small || is_refused {
        return None;
    }
    let s = ray.origin.minus(a);
    let q = s.cross(e1);
    let [v, w, t] = [s.dot(p), ray.direction.dot(q), e2.dot(q)].map(|x| x / determinant);
    let is_inside = match mistake {
        "square_for_triangle" => v >= zero && w >= zero && v <= one && w <= one,
        "open_border" => v > zero && w > zero && v + w < one,
        _ => v >= zero && w >= zero && v + w <= one,
    };
    let is_reached = match mistake {
        "line_for_the_ray" => true,
        "start_is_included" => t >= ray.start && ray.end.is_none_or(|end| t <= end),
        "end_is_ignored" => t > ray.start,
        _ => ray.reaches(t),
    };
    (is_inside && is_reached).then_some(FacetHit {
        t: if mistake == "undivided_t" {
            t * determinant
        } else {
            t
        },
        parameters: match mistake {
            "weights_exchanged" => [w, v],
            "weights_of_a_and_b" => [one - v - w, v],
            _ => [v, w],
        },
        side: side(mistake == "side_reversed", -determinant),
    })
}
