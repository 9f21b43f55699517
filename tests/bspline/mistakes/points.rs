//! The typical mistakes with control points: points of curves and surfaces, and knot insertion.

use facette::algebra::VectorSpace;
use facette::bspline::{BsplineSurface, Direction, KnotVector};
use num_traits::One;

use super::basis::{span_of, values_on};
use super::{CURVE, INSERTION, SURFACE, is_of};

/// What the mistake makes of a point of a curve; `None` for a mistake of another function.
pub fn de_boor_point<P: VectorSpace>(
    mistake: &str,
    knots: &KnotVector<P::Scalar>,
    control_points: &[P],
    u: P::Scalar,
) -> Option<P> {
    is_of(CURVE, mistake).then(|| wrong_point(mistake, knots, control_points, u))
}

fn wrong_point<P: VectorSpace>(
    mistake: &str,
    knots: &KnotVector<P::Scalar>,
    control_points: &[P],
    u: P::Scalar,
) -> P {
    let at = |index: usize| knots.knots()[index];
    let (p, k) = (knots.degree(), span_of(knots, u));
    let shift = if mistake == "points_after_the_span" {
        p
    } else {
        0
    };
    let mut old = control_points[k - p + shift..=k + shift].to_vec();
    let levels = if mistake == "curve_one_level_short" {
        p.saturating_sub(1)
    } else {
        p
    };
    for level in 1..=levels {
        let mut new = old.clone();
        for place in level..=p {
            let i = k - p + place;
            let [start, end] = match mistake {
                "same_denominator_on_every_level" => [i, i + p],
                "weight_of_de_casteljau" => [k, k + 1],
                _ => [i, i + p + 1 - level],
            };
            let weight = (u - at(start)) / (at(end) - at(start));
            let left = if mistake == "overwritten_points" {
                new[place - 1]
            } else {
                old[place - 1]
            };
            new[place] = match mistake {
                "exchanged_weights_of_the_points" => old[place].lerp(left, weight),
                _ => left.lerp(old[place], weight),
            };
        }
        old = new;
    }
    old[p]
}

/// What the mistake makes of knot insertion; `None` for a mistake of another function.
pub fn insert_knot<P: VectorSpace>(
    mistake: &str,
    knots: &KnotVector<P::Scalar>,
    control_points: &[P],
    u: P::Scalar,
) -> Option<Vec<P>> {
    is_of(INSERTION, mistake).then(|| wrong_insertion(mistake, knots, control_points, u))
}

fn wrong_insertion<P: VectorSpace>(
    mistake: &str,
    knots: &KnotVector<P::Scalar>,
    control_points: &[P],
    u: P::Scalar,
) -> Vec<P> {
    let at = |index: usize| knots.knots()[index];
    let (p, k) = (knots.degree(), span_of(knots, u));
    let early = usize::from(mistake == "insertion_range_too_early");
    let mut points = control_points[..(k - p + 1 - early).max(1)].to_vec();
    for i in points.len()..=k.saturating_sub(early) {
        let [start, end] = match mistake {
            "same_weight_for_all" => [k, k + p],
            "denominator_of_p_plus_one_spans" => [i, i + p + 1],
            _ => [i, i + p],
        };
        let weight = (u - at(start)) / (at(end) - at(start));
        let [left, right] = [control_points[i - 1], control_points[i]];
        points.push(match mistake {
            "exchanged_weights_of_the_insertion" => right.lerp(left, weight),
            "mixed_with_new_points" => points[i - 1].lerp(right, weight),
            _ => left.lerp(right, weight),
        });
    }
    match mistake {
        "forgotten_tail" => {}
        "replaced_points" => points.extend_from_slice(&control_points[k + 1..]),
        "curve_point_put_in" => {
            points = control_points.to_vec();
            points.insert(
                k - p + p.div_ceil(2),
                wrong_point("", knots, control_points, u),
            );
        }
        _ => points.extend_from_slice(&control_points[k.saturating_sub(early)..]),
    }
    points
}

/// What the mistake makes of a point of a surface; `None` for a mistake of another function.
pub fn surface_point<P: VectorSpace>(
    mistake: &str,
    surface: &BsplineSurface<P>,
    u: P::Scalar,
    v: P::Scalar,
) -> Option<P> {
    is_of(SURFACE, mistake).then(|| wrong_surface_point(mistake, surface, u, v))
}

fn wrong_surface_point<P: VectorSpace>(
    mistake: &str,
    surface: &BsplineSurface<P>,
    u: P::Scalar,
    v: P::Scalar,
) -> P {
    let [in_u, in_v] = [surface.knots(Direction::U), surface.knots(Direction::V)];
    let [u, v] = if mistake == "exchanged_parameters" {
        [v, u]
    } else {
        [u, v]
    };
    let i = span_of(in_u, u);
    let j = if mistake == "span_of_u_for_v" {
        i
    } else {
        span_of(in_v, v)
    };
    let n_u = values_on(in_u, i, u);
    let n_v = match mistake {
        "functions_of_u_for_v" => n_u.clone(),
        "forgotten_weights_of_v" => vec![P::Scalar::one(); in_v.degree() + 1],
        _ => values_on(in_v, j, v),
    };
    let [p, q] = [in_u.degree(), in_v.degree()];
    let [first_column, first_row] = match mistake {
        "exchanged_degrees" => [i - q, j - p],
        "points_of_the_first_rectangle" => [0, 0],
        _ => [i - p, j - q],
    };
    let columns = in_u.control_point_count();
    let mut sum = P::origin();
    for (l, &b) in n_v.iter().enumerate() {
        for (k, &a) in n_u.iter().enumerate() {
            let [column, row] = [first_column + k, first_row + l];
            let place = match mistake {
                "transposed_net" => column * columns + row,
                "row_length_n" => row * (columns - 1) + column,
                _ => row * columns + column,
            };
            sum = sum.plus(surface.control_points()[place].times(a * b));
        }
    }
    sum
}
