//! The typical mistakes of this chapter: wrong implementations that students really write. Each must be rejected by the
//! theorem that names it, and a reader's answer that behaves like one of them gets its hint.

use facette::algebra::{Real, Scalar, Vector3, unit_vector};
use facette::camera::{CameraFrame, ImageRectangle, ImageSize, Pixel};
use facette::ray::Ray;
use num_traits::Zero;

pub use mistake::Mistake;
use mistake::mistake;

#[path = "../common/mistake.rs"]
mod mistake;

/// All typical mistakes of the chapter.
#[rustfmt::skip]
pub const MISTAKES: &[Mistake] = &[
    mistake(["frame", "frame_looks_at_the_target"], "w_towards_the_target",
        "w points the wrong way: it leads backwards, from the target to the eye, so it is along e - c"),
    mistake(["frame", "frame_looks_at_the_target"], "unnormalised_w",
        "w must be a unit vector: divide e - c by its length"),
    mistake(["frame", "up_appears_upright"], "exchanged_product",
        "the factors are exchanged: u = up x w points to the right, w x up to the left"),
    mistake(["frame", "frame_is_orthonormal_and_right_handed"], "left_handed",
        "v points down: v = w x u, and not u x w"),
    mistake(["frame", "frame_is_orthonormal_and_right_handed"], "up_as_v",
        "v is not up itself: up need not be perpendicular to the view. Take v = w x u"),
    mistake(["frame", "frame_is_orthonormal_and_right_handed"], "unnormalised_u",
        "up x w is shorter than 1 where up is not perpendicular to w: make it a unit vector"),
    mistake(["pixel", "pixel_centre_is_half_a_pixel_into_its_pixel"], "corner_for_centre",
        "this is the lower left corner of the pixel: its centre is at i + 1/2"),
    mistake(["pixel", "pixel_centre_is_half_a_pixel_into_its_pixel"], "exchanged_columns_and_rows",
        "columns and rows are exchanged: u comes from the column and n_x, v from the row and n_y"),
    mistake(["pixel", "pixel_centre_is_half_a_pixel_into_its_pixel"], "border_to_border",
        "i / (n - 1) puts the outer centres on the borders: n pixels of equal width have theirs half a pixel inside"),
    mistake(["pixel", "pixel_centre_is_half_a_pixel_into_its_pixel"], "centred_rectangle",
        "the rectangle need not lie around the origin: begin at l and b, not at half the width and height"),
    mistake(["pixel", "pixel_centre_is_half_a_pixel_into_its_pixel"], "counted_from_the_top",
        "rows count from the bottom here: v grows with j"),
    mistake(["pixel", "rows_of_a_file_run_downwards"], "row_kept",
        "row 0 of the file is the top row, the one with the largest number from the bottom"),
    mistake(["pixel", "rows_of_a_file_run_downwards"], "row_one_too_far",
        "n_y - j is one too far: rows are counted from 0, so the last one is n_y - 1"),
    mistake(["rays", "orthographic_rays_are_parallel"], "looking_backwards",
        "w points backwards: the rays run along -w"),
    mistake(["rays", "orthographic_rays_are_parallel"], "started_at_the_eye",
        "all rays begin at the eye: an orthographic ray begins at its own place e + u u + v v"),
    mistake(["rays", "orthographic_rays_are_parallel"], "exchanged_u_and_v",
        "u and v are exchanged: the first number goes along the axis u, to the right"),
    mistake(["rays", "perspective_rays_reach_the_image_plane_at_one"], "image_plane_behind_the_eye",
        "the image plane is in front of the eye, and w points backwards: subtract D w"),
    mistake(["rays", "perspective_rays_reach_the_image_plane_at_one"], "direction_is_s",
        "s is a point: the direction leads from the eye to it, s - e"),
    mistake(["rays", "perspective_rays_reach_the_image_plane_at_one"], "distance_one",
        "the distance D of the image plane is missing: the last term is -D w"),
    mistake(["rays", "perspective_rays_reach_the_image_plane_at_one"], "started_on_the_image_plane",
        "the ray begins at s: it should begin at the eye, and be at s at t = 1"),
    mistake(["projection", "projection_undoes_the_ray"], "forgotten_division",
        "what is farther away must be smaller: divide by the depth"),
    mistake(["projection", "projection_undoes_the_ray"], "mirrored",
        "the coordinate along w is negative in front of the eye: divide by the depth, which is minus that"),
    mistake(["projection", "projection_undoes_the_ray"], "forgotten_distance",
        "the image plane is at the distance D, not 1: multiply by D"),
    mistake(["projection", "projection_undoes_the_ray"], "forgotten_eye",
        "the coordinates count from the eye: take p - e, not p"),
    mistake(["projection", "projection_undoes_the_ray"], "divided_orthographic",
        "the orthographic projection does not divide: distance does not make things smaller"),
    mistake(["projection", "point_behind_the_eye_has_no_image"], "image_of_what_is_behind",
        "a point behind the eye has no image: return None unless the depth is positive"),
    mistake(["field_of_view", "field_of_view_spans_the_height"], "degrees_for_radians",
        "the angle is in radians already: do not convert it"),
    mistake(["field_of_view", "field_of_view_spans_the_height"], "whole_angle",
        "the field of view is the whole angle, from the lower to the upper border: half of it lies above the middle"),
    mistake(["field_of_view", "field_of_view_spans_the_height"], "sine_for_tangent",
        "the distance is the side next to the angle, not the longest one: the tangent is needed, not the sine"),
    mistake(["field_of_view", "field_of_view_spans_the_height"], "whole_height",
        "this is the whole height of the rectangle: half of it was asked for"),
];

/// Whether `name` is a mistake of this exercise that is not in `others`.
fn is_of(exercise: &str, name: &str, others: &[&str]) -> bool {
    let mut mistakes = MISTAKES.iter();
    mistakes.any(|m| m.name == name && m.exercise == exercise) && !others.contains(&name)
}

/// What the mistake makes of the axes; the outer `None` for a mistake of another function.
#[allow(
    clippy::option_option,
    reason = "of which the inner one is the answer of the function that is imitated"
)]
pub fn look_at_axes<P>(mistake: &str, eye: P, target: P, up: P) -> Option<Option<[P; 3]>>
where
    P: Vector3,
    P::Scalar: Real,
{
    is_of("frame", mistake, &[]).then(|| wrong_axes(mistake, eye, target, up))
}

fn wrong_axes<P>(mistake: &str, eye: P, target: P, up: P) -> Option<[P; 3]>
where
    P: Vector3,
    P::Scalar: Real,
{
    let back = eye.minus(target);
    let w = match mistake {
        "w_towards_the_target" => unit_vector(P::origin().minus(back))?,
        "unnormalised_w" => back,
        _ => unit_vector(back)?,
    };
    let u = match mistake {
        "exchanged_product" => unit_vector(w.cross(up))?,
        "unnormalised_u" => unit_vector(up)?.cross(w),
        _ => unit_vector(up.cross(w))?,
    };
    let v = match mistake {
        "left_handed" => u.cross(w),
        "up_as_v" => unit_vector(up)?,
        _ => w.cross(u),
    };
    Some([u, v, w])
}

/// What the mistake makes of a pixel's centre; `None` for a mistake of another function.
pub fn pixel_centre<S: Scalar>(
    mistake: &str,
    rectangle: &ImageRectangle<S>,
    size: ImageSize,
    pixel: Pixel,
) -> Option<[S; 2]> {
    if !is_of("pixel", mistake, &["row_kept", "row_one_too_far"]) {
        return None;
    }
    let number = |n: u32| S::from_i32(i32::try_from(n).unwrap_or(i32::MAX));
    let [mut index, mut count] = [[pixel.column, pixel.row], [size.columns(), size.rows()]];
    if mistake == "exchanged_columns_and_rows" {
        index.reverse();
        count.reverse();
    }
    let [width, height] = [rectangle.width(), rectangle.height()];
    let half = S::ratio(1, 2);
    let parts = [0, 1].map(|axis| match mistake {
        "corner_for_centre" => number(index[axis]) / number(count[axis]),
        "border_to_border" => number(index[axis]) / number((count[axis] - 1).max(1)),
        _ => (number(index[axis]) + half) / number(count[axis]),
    });
    Some(match mistake {
        "centred_rectangle" => [width * (parts[0] - half), height * (parts[1] - half)],
        "counted_from_the_top" => [
            rectangle.left() + width * parts[0],
            rectangle.top() - height * parts[1],
        ],
        _ => [
            rectangle.left() + width * parts[0],
            rectangle.bottom() + height * parts[1],
        ],
    })
}

/// What the mistake makes of a row; the outer `None` for a mistake of another function.
#[allow(
    clippy::option_option,
    reason = "of which the inner one is the answer of the function that is imitated"
)]
pub fn flipped_row(mistake: &str, size: ImageSize, row: u32) -> Option<Option<u32>> {
    let flipped = match mistake {
        "row_kept" => row,
        "row_one_too_far" => size.rows().saturating_sub(row),
        _ => return None,
    };
    Some((row < size.rows()).then_some(flipped))
}

/// What the mistake makes of an orthographic ray; `None` for a mistake of another function.
pub fn orthographic_ray<P: Vector3>(
    mistake: &str,
    frame: &CameraFrame<P>,
    [u, v]: [P::Scalar; 2],
) -> Option<Ray<P>> {
    let ([right, up, back], eye) = (frame.axes(), frame.eye());
    let forward = P::origin().minus(back);
    let origin = eye.plus(right.times(u)).plus(up.times(v));
    Some(match mistake {
        "looking_backwards" => Ray::new(origin, back),
        "started_at_the_eye" => Ray::new(eye, forward),
        "exchanged_u_and_v" => Ray::new(eye.plus(right.times(v)).plus(up.times(u)), forward),
        _ => return None,
    })
}

/// What the mistake makes of a perspective ray; `None` for a mistake of another function.
pub fn perspective_ray<P: Vector3>(
    mistake: &str,
    frame: &CameraFrame<P>,
    distance: P::Scalar,
    [u, v]: [P::Scalar; 2],
) -> Option<Ray<P>> {
    let ([right, up, back], eye) = (frame.axes(), frame.eye());
    let offset = right.times(u).plus(up.times(v));
    let direction = offset.minus(back.times(distance));
    Some(match mistake {
        "image_plane_behind_the_eye" => Ray::new(eye, offset.plus(back.times(distance))),
        "direction_is_s" => Ray::new(eye, eye.plus(direction)),
        "distance_one" => Ray::new(eye, offset.minus(back)),
        "started_on_the_image_plane" => Ray::new(eye.plus(direction), direction),
        _ => return None,
    })
}

/// What the mistake makes of an orthographic image; `None` for a mistake of another function.
pub fn project_orthographic<P: Vector3>(
    mistake: &str,
    frame: &CameraFrame<P>,
    point: P,
) -> Option<[P::Scalar; 2]> {
    let [x, y, behind] = frame.coordinates(point);
    (mistake == "divided_orthographic").then(|| [x, y].map(|coordinate| coordinate / -behind))
}

/// What the mistake makes of a perspective image; the outer `None` for a mistake of another function.
#[allow(
    clippy::option_option,
    reason = "of which the inner one is the answer of the function that is imitated"
)]
pub fn project_perspective<P: Vector3>(
    mistake: &str,
    frame: &CameraFrame<P>,
    distance: P::Scalar,
    point: P,
) -> Option<Option<[P::Scalar; 2]>> {
    if !is_of("projection", mistake, &["divided_orthographic"]) {
        return None;
    }
    let [x, y, behind] = match mistake {
        "forgotten_eye" => frame.axes().map(|axis| point.dot(axis)),
        _ => frame.coordinates(point),
    };
    let is_seen = match mistake {
        "image_of_what_is_behind" => !behind.is_zero(),
        _ => behind < P::Scalar::zero(),
    };
    let image = |coordinate: P::Scalar| match mistake {
        "forgotten_division" => distance * coordinate,
        "mirrored" => distance * coordinate / behind,
        "forgotten_distance" => coordinate / -behind,
        _ => distance * coordinate / -behind,
    };
    Some(is_seen.then(|| [x, y].map(image)))
}

/// What the mistake makes of half the extent; `None` for a mistake of another function.
pub fn half_extent<S: Real>(mistake: &str, field_of_view: S, distance: S) -> Option<S> {
    let half = field_of_view / S::from_i32(2);
    let tangent = |angle: S| angle.sin() / angle.cos();
    Some(match mistake {
        "degrees_for_radians" => distance * tangent(half * S::pi() / S::from_i32(180)),
        "whole_angle" => distance * tangent(field_of_view),
        "sine_for_tangent" => distance * half.sin(),
        "whole_height" => S::from_i32(2) * distance * tangent(half),
        _ => return None,
    })
}

/// Prints the mistakes for the grader: name, exercise and rejecting theorem, with tabs between.
#[test]
#[ignore = "a list for the grader, not a check"]
fn list_mistakes() {
    mistake::print_all(MISTAKES);
}
