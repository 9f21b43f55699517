//! The typical mistakes with a line and a sphere.

use facette::algebra::{Real, Vector3};
use facette::ray::Ray;
use num_traits::{One, Zero};

use super::{CHORD, COUNT, FAR, FIRST, HALF_LINE, NEAR, SAME, is_of};

/// What the mistake makes of the roots by the slides' formula; `None` for a mistake of another function.
#[allow(
    clippy::option_option,
    reason = "the outer one says whether the mistake is of this function"
)]
pub fn roots_by_quadratic<P>(
    mistake: &str,
    p: P,
    d: P,
    r: P::Scalar,
) -> Option<Option<[P::Scalar; 2]>>
where
    P: Vector3,
    P::Scalar: Real,
{
    is_of(&[CHORD, COUNT], mistake).then(|| wrong_roots(mistake, p, d, r))
}

fn wrong_roots<P>(mistake: &str, p: P, d: P, r: P::Scalar) -> Option<[P::Scalar; 2]>
where
    P: Vector3,
    P::Scalar: Real,
{
    let zero = P::Scalar::zero();
    let two = P::Scalar::one() + P::Scalar::one();
    let [mut dd, mut dp, pp] = [d.dot(d), d.dot(p), p.dot(p)];
    let constant = match mistake {
        "radius_of_one" => pp - P::Scalar::one(),
        "radius_not_squared" => pp - r,
        "four_times_the_constant" => two * two * (pp - r * r),
        _ => pp - r * r,
    };
    match mistake {
        "unit_direction_assumed" => dd = P::Scalar::one(),
        "sign_of_the_linear_term" => dp = -dp,
        _ => {}
    }
    let discriminant = dp * dp - dd * constant;
    let is_met = match mistake {
        "tangent_forgotten" => discriminant > zero,
        "negative_discriminant_allowed" => true,
        _ => discriminant >= zero,
    };
    if !is_met {
        return None;
    }
    let root = if mistake == "root_of_nothing" {
        discriminant
    } else {
        discriminant.sqrt()
    };
    let divisor = if mistake == "divided_by_twice_dd" {
        two * dd
    } else {
        dd
    };
    let roots = [(-dp - root) / divisor, (-dp + root) / divisor];
    Some(if mistake == "larger_root_first" {
        [roots[1], roots[0]]
    } else {
        roots
    })
}

/// What the mistake makes of the first root in the interval; `None` for a mistake of another function.
#[allow(
    clippy::option_option,
    reason = "the outer one says whether the mistake is of this function"
)]
pub fn first_root<P: Vector3>(
    mistake: &str,
    roots: [P::Scalar; 2],
    ray: &Ray<P>,
) -> Option<Option<P::Scalar>> {
    let [near, far] = roots;
    let reached = |t: P::Scalar| Some(t).filter(|&t| ray.reaches(t));
    let is_before_end = |t: P::Scalar| ray.end.is_none_or(|end| t <= end);
    is_of(&[FIRST, HALF_LINE], mistake).then(|| match mistake {
        "behind_the_origin" => Some(near).filter(|&t| is_before_end(t)),
        "near_root_only" => reached(near),
        "far_root_first" => reached(far).or(reached(near)),
        "end_ignored" => roots.into_iter().find(|&t| t > ray.start),
        "start_at_zero" => roots
            .into_iter()
            .find(|&t| t > P::Scalar::zero() && is_before_end(t)),
        "start_included" => roots
            .into_iter()
            .find(|&t| t >= ray.start && is_before_end(t)),
        _ => None,
    })
}

/// What the mistake makes of the roots by projection; `None` for a mistake of another function.
#[allow(
    clippy::option_option,
    reason = "the outer one says whether the mistake is of this function"
)]
pub fn roots_by_projection<P>(
    mistake: &str,
    p: P,
    d: P,
    r: P::Scalar,
) -> Option<Option<[P::Scalar; 2]>>
where
    P: Vector3,
    P::Scalar: Real,
{
    if mistake == "slides_quadratic" {
        return Some(wrong_roots("", p, d, r));
    }
    is_of(&[FAR, NEAR, SAME], mistake).then(|| wrong_projection(mistake, p, d, r))
}

fn wrong_projection<P>(mistake: &str, p: P, d: P, r: P::Scalar) -> Option<[P::Scalar; 2]>
where
    P: Vector3,
    P::Scalar: Real,
{
    let zero = P::Scalar::zero();
    let [dd, b, pp] = [d.dot(d), p.dot(d), p.dot(p)];
    let across = p.minus(d.times(b / dd));
    let h = across.dot(across).sqrt();
    let gap = if mistake == "distance_not_squared" {
        r - h
    } else {
        (r - h) * (r + h)
    };
    let is_met = gap >= zero;
    if !is_met {
        return None;
    }
    let speed = if mistake == "speed_forgotten" {
        P::Scalar::one()
    } else {
        dd
    };
    let root = (speed * gap).sqrt();
    if mistake == "difference_of_near_numbers" {
        return Some([(-b - root) / dd, (-b + root) / dd]);
    }
    let q = if b > zero { -(b + root) } else { root - b };
    let distance = pp.sqrt();
    let c = if mistake == "squares_subtracted" {
        pp - r * r
    } else {
        (distance - r) * (distance + r)
    };
    let [one, other] = if q.is_zero() { [q, q] } else { [q / dd, c / q] };
    Some(if one < other {
        [one, other]
    } else {
        [other, one]
    })
}
