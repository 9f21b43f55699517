//! The theorems of many surfaces: the nearest of them, by the slides' loop.

use std::cell::Cell;

use facette::algebra::{Vector3, VectorSpace};
use facette::intersection::{BoundingBox, Group, Hit, Intersect, Plane, Side, Sphere, nearest};
use facette::ray::Ray;
use proptest::collection::vec;
use proptest::prelude::*;

use crate::common::law::{Broken, Law, Verdict, expect_equal};
use crate::suspects;

type Point = [f64; 3];
type AnySurface = Box<dyn Intersect<Point = Point>>;

/// A surface that answers with given parameters, whatever the ray: the first of them in the interval.
#[derive(Clone, Debug)]
struct Marks(Vec<f64>);

impl Intersect for Marks {
    type Point = Point;

    fn intersect(&self, ray: &Ray<Point>) -> Option<Hit<Point>> {
        let ahead = self.0.iter().copied().filter(|&t| ray.reaches(t));
        ahead.reduce(f64::min).map(|t| Hit {
            t,
            t_error: 0.0,
            point: ray.point(t),
            point_error: 0.0,
            normal: [1.0, 0.0, 0.0],
            parameters: None,
            side: Side::Front,
        })
    }
}

fn along_x() -> Ray<Point> {
    Ray::new([0.0; 3], [1.0, 0.0, 0.0])
}

/// Members with up to three marks each, before the ray's start, behind it, some at the same place.
fn members() -> impl Strategy<Value = Vec<Vec<f64>>> {
    vec(
        vec(
            (-8..=24_i32).prop_map(|quarters| f64::from(quarters) / 4.0),
            0..3,
        ),
        0..7,
    )
}

/// Members at two places only, and empty ones.
fn hard_members() -> impl Strategy<Value = Vec<Vec<f64>>> {
    vec(
        vec(prop::sample::select(vec![1.0, 2.0, 0.0, -1.0]), 0..2),
        0..5,
    )
}

fn ends() -> impl Strategy<Value = Option<f64>> {
    prop::sample::select(vec![None, Some(0.5), Some(1.0), Some(2.0), Some(4.0)])
}

fn group(members: &[Vec<f64>]) -> Vec<Marks> {
    members.iter().cloned().map(Marks).collect()
}

fn with_end(end: Option<f64>) -> Ray<Point> {
    Ray { end, ..along_x() }
}

/// **The nearest of many.** The answer of a group is the least of its members' answers: its $t$ is the smallest of theirs, and the member is one that has it. Nothing else may depend on the order in which they are asked.
///
/// Course: R12, slide 104, Many surfaces: the loop over all primitives.
/// Exercise: group.
#[test]
fn group_answers_with_the_least_of_its_members() {
    let law = Law::new(
        "intersection::group_answers_with_the_least_of_its_members",
        suspects::group,
    );
    law.on_cases(256)
        .holds(members(), hard_members(), |members| {
            let answer = nearest(&group(members), &along_x()).map(|(member, hit)| (hit.t, member));
            expect_equal(
                &expected(members, &along_x()).map(|(t, _)| t),
                &answer.map(|(t, _)| t),
            )?;
            let is_its_own = answer.is_none_or(|(t, member)| members[member].contains(&t));
            expect_equal(&true, &is_its_own)
        });
}

/// All marks in the interval, the nearest first, then the smallest number.
fn expected(members: &[Vec<f64>], ray: &Ray<Point>) -> Option<(f64, usize)> {
    let marks = members
        .iter()
        .enumerate()
        .flat_map(|(index, marks)| marks.iter().map(move |&t| (t, index)));
    marks
        .filter(|&(t, _)| ray.reaches(t))
        .reduce(|a, b| if b.0 < a.0 { b } else { a })
}

/// **The given maximum is kept.** The best distance so far starts at the ray's own end $t_{\max}$. A group whose only member lies at $t=2$ is missed by a ray that ends at $t_{\max}=1$; and what a ray
/// with an end finds is what the ray without one finds, if that is not beyond.
///
/// Course: R11, slide 104, Many surfaces: the best distance.
/// Exercise: group.
/// Erratum: the slide's loop has a parameter $t_{\max}$, but starts with $t_{\text{best}}=+\infty$ and asks its members up to $t_{\text{best}}$: $t_{\max}$ is ignored, and with $t_{\max}=1$ a sphere at $t=2$ is found. It must start with $t_{\text{best}}=t_{\max}$.
#[test]
fn group_keeps_the_given_maximum() {
    let sphere = Sphere::new([3.0, 0.0, 0.0], 1.0).expect("a positive radius");
    let ray = along_x();
    let law = Law::new(
        "intersection::group_keeps_the_given_maximum",
        suspects::group,
    );
    law.on_cases(256).holds(
        (members(), ends()),
        (hard_members(), ends()),
        |(members, end)| {
            let t = |ray: Ray<Point>| nearest(&[sphere], &ray).map(|(_, hit)| hit.t);
            expect_equal(
                &[Some(2.0), None, Some(2.0)],
                &[t(ray), t(ray.until(1.0)), t(ray.until(2.0))],
            )?;
            let without = nearest(&group(members), &ray).map(|(_, hit)| hit.t);
            let kept = without.filter(|&t| end.is_none_or(|end| t <= end));
            expect_equal(
                &kept,
                &nearest(&group(members), &with_end(*end)).map(|(_, hit)| hit.t),
            )
        },
    );
}

/// **Equal distances.** Where several members are hit at the same $t$, the answer is the one with the smallest number. So it does not depend on how a faster search orders its questions.
///
/// Course: R12, slide 104, Many surfaces: the loop over all primitives.
/// Exercise: group.
#[test]
fn first_of_equally_near_members_is_the_answer() {
    let law = Law::new(
        "intersection::first_of_equally_near_members_is_the_answer",
        suspects::group,
    );
    law.on_cases(256).holds(
        (members(), ends()),
        (hard_members(), ends()),
        |(members, end)| {
            let ray = with_end(*end);
            let answer = nearest(&group(members), &ray).map(|(member, hit)| (hit.t, member));
            expect_equal(&expected(members, &ray), &answer)
        },
    );
}

/// A member that counts how often it is asked, and up to where.
struct Counted<'a> {
    surface: Marks,
    questions: &'a Cell<usize>,
}

impl Intersect for Counted<'_> {
    type Point = Point;

    fn intersect(&self, ray: &Ray<Point>) -> Option<Hit<Point>> {
        self.questions.set(self.questions.get() + 1);
        self.surface.intersect(ray)
    }
}

/// **Linear cost.** The loop asks every member once: its cost grows in proportion to the number of members, whether the ray meets them or not.
///
/// Course: R12, slide 104, Many surfaces: the loop over all primitives.
/// Exercise: group.
#[test]
fn group_asks_every_member_once() {
    let law = Law::new(
        "intersection::group_asks_every_member_once",
        suspects::group,
    );
    law.holds(members(), hard_members(), |members| {
        let questions = Cell::new(0);
        let counted = |surface| Counted {
            surface,
            questions: &questions,
        };
        let counted: Vec<_> = group(members).into_iter().map(counted).collect();
        let _ = nearest(&counted, &along_x());
        expect_equal(&members.len(), &questions.get())
    });
}

/// Spheres, boxes and planes in front of a ray and behind it.
fn surfaces() -> impl Strategy<Value = Vec<(usize, Point, f64)>> {
    let coordinate = || -6.0..6.0_f64;
    vec(
        (
            0..3_usize,
            [coordinate(), coordinate(), coordinate()],
            0.2..3.0_f64,
        ),
        0..8,
    )
}

/// Surfaces that touch, or lie in each other.
fn hard_surfaces() -> impl Strategy<Value = Vec<(usize, Point, f64)>> {
    let coordinate = || (-2..=2_i32).prop_map(f64::from);
    let size = (1..=2_i32).prop_map(f64::from);
    vec(
        (0..3_usize, [coordinate(), coordinate(), coordinate()], size),
        0..8,
    )
}

fn surface(&(kind, place, size): &(usize, Point, f64)) -> AnySurface {
    match kind {
        0 => Box::new(Sphere::new(place, size).expect("a positive radius")),
        1 => Box::new(BoundingBox::new(place, place.plus([size; 3])).expect("corners in order")),
        _ => Box::new(
            Plane::new(place, place.cross([1.0, size, 2.0]).plus([0.0, 0.0, size]))
                .expect("a normal"),
        ),
    }
}

fn all_of(surfaces: &[(usize, Point, f64)]) -> Vec<AnySurface> {
    surfaces.iter().map(surface).collect()
}

/// **A group is a surface.** Spheres, boxes, planes and groups stand in one group behind the same question. A group in a group gives the same hit as its members would beside the others, and a member on its own the same as the group of it.
///
/// Course: R12, slide 104, Many surfaces: the loop over all primitives.
#[test]
fn group_of_groups_is_the_group_of_all() {
    let law = Law::new(
        "intersection::group_of_groups_is_the_group_of_all",
        suspects::library,
    );
    let with_cut = |surfaces| (surfaces, 0..8_usize, 0.5..9.0_f64);
    law.holds(
        with_cut(surfaces().boxed()),
        with_cut(hard_surfaces().boxed()),
        |(surfaces, cut, end)| {
            let (first, second) = surfaces.split_at((*cut).min(surfaces.len()));
            let flat = Group::new(all_of(surfaces));
            let nested = Group::new(vec![Group::new(all_of(first)), Group::new(all_of(second))]);
            for ray in [ray_ahead(), ray_ahead().until(*end)] {
                expect_equal(&flat.intersect(&ray), &nested.intersect(&ray))?;
                let hits = all_of(surfaces)
                    .iter()
                    .filter_map(|surface| surface.intersect(&ray))
                    .map(|hit| hit.t)
                    .reduce(f64::min);
                expect_equal(&hits, &flat.intersect(&ray).map(|hit| hit.t))?;
            }
            Ok(())
        },
    );
}

fn ray_ahead() -> Ray<Point> {
    Ray::new([-5.0, 0.25, 0.125], [1.0, 0.125, -0.0625])
}

/// **A shadow ray's question, to many.** Something is met exactly if the nearest is; the loop may stop at the first member that is hit.
///
/// Course: R04, slide 93, Rays: a half-line, and why it is directional.
#[test]
fn group_is_hit_exactly_where_it_has_a_nearest() {
    let law = Law::new(
        "intersection::group_is_hit_exactly_where_it_has_a_nearest",
        suspects::library,
    );
    let with_end = |surfaces| (surfaces, 0.5..9.0_f64);
    law.holds(
        with_end(surfaces().boxed()),
        with_end(hard_surfaces().boxed()),
        |(surfaces, end)| -> Verdict {
            let group = Group::new(all_of(surfaces));
            for ray in [
                ray_ahead(),
                ray_ahead().until(*end),
                ray_ahead().after(*end),
            ] {
                let nearest = group.nearest(&ray);
                if group.is_hit_by(&ray) != nearest.is_some() {
                    return Err(Broken {
                        expected: format!("{nearest:?}"),
                        got: format!("is_hit_by: {}", group.is_hit_by(&ray)),
                    });
                }
            }
            Ok(())
        },
    );
}
