//! The theorems of a line and a box, over exact numbers.

use facette::algebra::VectorSpace;
use facette::intersection::{BoundingBox, FaceHit, Side, box_interval};
use facette::ray::Ray;
use num_traits::{One, Zero};
use proptest::prelude::*;

use crate::box_inputs::{BoxPlace, Point, boxes, hard_boxes};
use crate::common::exact::{Exact, fraction};
use crate::common::law::{Law, expect_equal};
use crate::suspects;

/// **The combination of the slabs.** A box is what three slabs have in common. So the line $\mathbf o+t\,\mathbf d$ is in the box exactly for
/// $$\max_kt_k^{\min}\le t\le\min_kt_k^{\max},$$
/// where $t_k^{\min}$ and $t_k^{\max}$ are its entry into slab $k$ and its exit: it is in the box once it has entered the *last* slab, and until it leaves the *first*. If the largest entry
/// is later than the smallest exit, it misses.
///
/// The test asks at each face's $t$, between any two of them, before and behind all, whether the point there is in the box.
///
/// Course: R07, slides 96-98, Ray and box: three slabs and how to combine them.
/// Exercise: slabs.
#[test]
fn line_is_in_the_box_between_the_last_entry_and_the_first_exit() {
    let law = Law::new(
        "intersection::line_is_in_the_box_between_the_last_entry_and_the_first_exit",
        suspects::slabs,
    );
    law.on_cases(256).holds(boxes(), hard_boxes(), |place| {
        let interval = box_interval(&place.bounds(), &place.ray());
        let meets = |&t: &Exact| place.holds(place.ray().point(t));
        let is_met = parameters_of_interest(place).iter().any(meets);
        expect_equal(&is_met, &interval.is_some())?;
        for t in parameters_of_interest(place) {
            let is_between = interval.is_some_and(|[entry, exit]| entry <= t && t <= exit);
            expect_equal(&(t, place.holds(place.ray().point(t))), &(t, is_between))?;
        }
        Ok(())
    });
}

/// The parameters of the faces, and one in each gap between them, before and behind.
fn parameters_of_interest(place: &BoxPlace) -> Vec<Exact> {
    let faces = place.face_parameters();
    let one = Exact::one();
    let mut all = vec![faces[0] - one, faces[faces.len() - 1] + one];
    all.extend(
        faces
            .windows(2)
            .map(|pair| (pair[0] + pair[1]) * fraction(1, 2)),
    );
    all.extend(faces);
    all
}

/// **Parallel to a slab.** Where $d_k=0$ the line never enters slab $k$ and never leaves it: it is in it everywhere, if $\min_k\le o_k\le\max_k$, or nowhere. No division is needed,
/// and none is allowed: $0/0$ is no parameter.
///
/// Course: R07, slides 96-98, Ray and box: three slabs and how to combine them.
/// Exercise: slabs.
#[test]
fn parallel_line_is_in_a_slab_everywhere_or_nowhere() {
    let law = Law::new(
        "intersection::parallel_line_is_in_a_slab_everywhere_or_nowhere",
        suspects::slabs,
    );
    let parallel = |places: BoxedStrategy<BoxPlace>| (places, 0..3_usize, -2..=4_i32);
    law.holds(
        parallel(boxes().boxed()),
        parallel(hard_boxes().boxed()),
        |&(place, axis, halves)| {
            // The coordinate is below the slab, in its lower plane, in it, in its upper plane, or above.
            let mut place = place;
            let width = place.max[axis] - place.min[axis];
            place.origin[axis] = place.min[axis] + width * fraction(halves, 2);
            place.direction[axis] = Exact::zero();
            if place.direction == [Exact::zero(); 3] {
                place.direction[(axis + 1) % 3] = Exact::one();
            }
            let is_in_slab = (0..=2).contains(&halves) || width.is_zero();
            // The interval of the two other axes, or the one of them, by the parameters of their faces.
            let others = |t: &Exact| {
                let point = place.ray().point(*t);
                let is_in = |k: usize| place.min[k] <= point[k] && point[k] <= place.max[k];
                (0..3).all(|k| k == axis || is_in(k))
            };
            let mut inside = place.face_parameters();
            inside.retain(others);
            let interval = inside
                .first()
                .map(|&entry| [entry, inside[inside.len() - 1]]);
            let expected = if is_in_slab { interval } else { None };
            expect_equal(&expected, &box_interval(&place.bounds(), &place.ray()))
        },
    );
}

/// **The nearest of six faces.** The box as a surface is hit where the ray first meets one of its six rectangles: at the entry, if that is in the ray's interval; from inside, at the exit, on the
/// rectangle's back.
///
/// Course: R07, slide 96, Ray and box: six faces, or three slabs.
#[test]
fn box_hit_is_the_nearest_of_its_six_faces() {
    let law = Law::new(
        "intersection::box_hit_is_the_nearest_of_its_six_faces",
        suspects::library,
    );
    law.on_cases(256).holds(boxes(), hard_boxes(), |place| {
        let hit = place.bounds().face_hit(&place.ray());
        let faces: Vec<_> = (0..6)
            .filter_map(|face| meet_rectangle(place, face))
            .collect();
        let nearest = faces
            .iter()
            .map(|face| face.t)
            .reduce(|a, b| if b < a { b } else { a });
        expect_equal(&nearest, &hit.map(|hit| hit.t))?;
        let is_a_face = hit.is_none_or(|hit| faces.contains(&hit));
        expect_equal(&true, &is_a_face)
    });
}

/// The hit of one rectangle, face 0 to 5: axis and end.
fn meet_rectangle(place: &BoxPlace, face: usize) -> Option<FaceHit<Exact>> {
    let (axis, is_max) = (face / 2, face % 2 == 1);
    let d = place.direction[axis];
    if d.is_zero() {
        return None;
    }
    let plane = if is_max {
        place.max[axis]
    } else {
        place.min[axis]
    };
    let t = (plane - place.origin[axis]) / d;
    let point = place.ray().point(t);
    let others = [(axis + 1) % 3, (axis + 2) % 3];
    let is_in = others
        .iter()
        .all(|&k| place.min[k] <= point[k] && point[k] <= place.max[k]);
    // The outward normal is the axis, or its opposite.
    let approach = if is_max { d } else { -d };
    let side = if approach < Exact::zero() {
        Side::Front
    } else {
        Side::Back
    };
    (is_in && t > Exact::zero()).then_some(FaceHit { t, axis, side })
}

/// **When a box is hit.** A half-line $t>0$ has a point in the box exactly if $t_{\text{entry}}\le t_{\text{exit}}$ and $t_{\text{exit}}>0$. With $t_{\text{entry}}>0$ it starts outside; with
/// $t_{\text{entry}}\le0$ it starts in the box, or on its surface, and sees its inside.
///
/// Course: R07, slides 96-98, Ray and box: three slabs and how to combine them.
#[test]
fn box_is_hit_if_the_exit_lies_ahead() {
    let law = Law::new(
        "intersection::box_is_hit_if_the_exit_lies_ahead",
        suspects::library,
    );
    law.on_cases(256).holds(boxes(), hard_boxes(), |place| {
        let zero = Exact::zero();
        let hit = place.bounds().face_hit(&place.ray());
        let ahead = parameters_of_interest(place)
            .into_iter()
            .filter(|&t| t > zero);
        let has_points_ahead = ahead
            .map(|t| place.ray().point(t))
            .any(|point| place.holds(point));
        expect_equal(&has_points_ahead, &hit.is_some())?;
        let starts_inside = place.holds(place.origin);
        expect_equal(
            &hit.map(|_| starts_inside),
            &hit.map(|hit| hit.side == Side::Back),
        )
    });
}

/// **Symmetries.** Exchanging axes, mirroring them, shifting and magnifying box and ray together leaves entry and exit as they are; a direction $\lambda>0$ times as long divides them by $\lambda$; the opposite
/// direction exchanges them and turns their signs.
///
/// Course: R07, slides 96-98, Ray and box: three slabs and how to combine them.
/// Exercise: slabs.
#[test]
fn box_interval_has_the_symmetries_of_the_box() {
    let law = Law::new(
        "intersection::box_interval_has_the_symmetries_of_the_box",
        suspects::slabs,
    );
    let moves = |places: BoxedStrategy<BoxPlace>| {
        (
            places,
            0..3_usize,
            [any::<bool>(), any::<bool>(), any::<bool>()],
            1..5_i32,
        )
    };
    law.holds(
        moves(boxes().boxed()),
        moves(hard_boxes().boxed()),
        |&(place, turns, mirrored, factor)| {
            let factor = fraction(factor, 3);
            let moved = |vector: Point| {
                let mut vector: Point = std::array::from_fn(|axis| {
                    if mirrored[axis] {
                        -vector[axis]
                    } else {
                        vector[axis]
                    }
                });
                vector.rotate_left(turns);
                vector.times(factor)
            };
            let bounds =
                BoundingBox::around([moved(place.min), moved(place.max)]).expect("two points");
            let interval = box_interval(&place.bounds(), &place.ray());
            let ray = Ray::new(moved(place.origin), moved(place.direction));
            expect_equal(&interval, &box_interval(&bounds, &ray))?;
            let longer = Ray::new(ray.origin, ray.direction.times(factor));
            let shorter_t = interval.map(|ends| ends.map(|t| t / factor));
            expect_equal(&shorter_t, &box_interval(&bounds, &longer))?;
            let backward = Ray::new(ray.origin, [Exact::zero(); 3].minus(ray.direction));
            let reversed = interval.map(|[entry, exit]| [-exit, -entry]);
            expect_equal(&reversed, &box_interval(&bounds, &backward))
        },
    );
}

/// **Boxes around things.** The box around points holds each of them and has a point on each of its faces; the union of two boxes holds both and is the box around their corners.
///
/// Course: R07, slide 96, Ray and box: six faces, or three slabs.
#[test]
fn box_around_points_is_the_smallest_that_holds_them() {
    let law = Law::new(
        "intersection::box_around_points_is_the_smallest_that_holds_them",
        suspects::library,
    );
    let points = || prop::collection::vec(crate::common::generators::point(), 1..6);
    law.holds(
        (points(), points()),
        (points(), points()),
        |(points, others)| {
            let around = |points: &[Point]| {
                BoundingBox::around(points.iter().copied()).expect("finite points")
            };
            let [one, other] = [around(points), around(others)];
            expect_equal(&true, &points.iter().all(|&point| one.contains(point)))?;
            let touches = |axis: usize| {
                let has = |end: Exact| points.iter().any(|point| point[axis] == end);
                has(one.min()[axis]) && has(one.max()[axis])
            };
            expect_equal(&[true; 3], &[0, 1, 2].map(touches))?;
            let all = [points.clone(), others.clone()].concat();
            expect_equal(&around(&all), &one.union(&other))
        },
    );
}
