//! Which typical mistake does the code under test behave like? Each suspect function tries it on a few fixed inputs that tell
//! all of them apart.

use std::panic::{AssertUnwindSafe, catch_unwind};

use facette::intersection::{
    BoundingBox, Intersect, Sphere, box_interval, first_root, nearest, roots_by_projection,
    roots_by_quadratic,
};
use facette::ray::Ray;

use crate::common::law::LikelyMistake;
use crate::mistakes::{self, MISTAKES};

type Point = [f64; 3];

/// What a piece of code does: its answer in words, or a panic. In words, so that NaN is alike.
pub fn behaviour<T: std::fmt::Debug>(code: impl FnOnce() -> T) -> String {
    let answer = catch_unwind(AssertUnwindSafe(|| format!("{:?}", code())));
    answer.unwrap_or_else(|_| "a panic".to_owned())
}

/// The mistake among those of `exercise` that behaves like the code under test; otherwise `general`. Where a mistake is of another function, its behaviour is `None`.
pub fn found(
    exercise: &str,
    general: &'static str,
    wrong: impl Fn(&'static str) -> Option<Vec<String>>,
    got: &impl Fn(&'static str) -> Vec<String>,
) -> LikelyMistake {
    let mut candidates = MISTAKES
        .iter()
        .filter(|mistake| mistake.exercise == exercise);
    let alike = candidates
        .find(|mistake| wrong(mistake.name).is_some_and(|wrong| wrong == got(mistake.name)));
    match alike {
        Some(mistake) => LikelyMistake {
            name: mistake.name,
            hint: mistake.hint,
        },
        None => LikelyMistake {
            name: "",
            hint: general,
        },
    }
}

/// Lines and spheres: one through, one that touches, one that misses, one far away, one next to the surface; with directions of other lengths than 1.
const LINES: [([f64; 3], [f64; 3], f64); 6] = [
    ([-3.0, 0.5, 0.25], [2.0, 0.0, 0.0], 1.5),
    ([-4.0, 2.0, 0.0], [0.5, 0.0, 0.0], 2.0),
    ([-4.0, 3.0, 0.0], [0.5, 0.0, 0.0], 2.0),
    ([1.0, 0.5, 0.25], [1.0, 2.0, 2.0], 3.0),
    ([0.3, 0.4, -1e8], [0.0, 0.0, 1.0], 1.0),
    ([0.0, 0.0, 1e10 + 1e-3], [0.0, 0.0, -1.0], 1e10),
];

/// Roots and intervals: from outside, from inside, from behind, from the first root itself, and with an end before, between and behind the roots.
const INTERVALS: [([f64; 2], f64, Option<f64>); 9] = [
    ([1.0, 2.0], 0.0, None),
    ([-1.0, 2.0], 0.0, None),
    ([-2.0, -1.0], 0.0, None),
    ([1.0, 2.0], 1.0, None),
    ([1.0, 2.0], 0.0, Some(0.5)),
    ([-1.0, 2.0], 0.0, Some(1.0)),
    ([-1.0, 2.0], 0.0, Some(3.0)),
    ([-1.0, 2.0], -3.0, Some(3.0)),
    ([1.0, 2.0], 1.5, None),
];

fn half_line(start: f64, end: Option<f64>) -> Ray<Point> {
    Ray {
        start,
        end,
        ..Ray::new([0.0; 3], [1.0, 0.0, 0.0])
    }
}

/// Suspects for the slides' quadratic and its nearest root.
pub fn sphere() -> LikelyMistake {
    let general = "compare each term of the quadratic with the page; then which of the two roots the ray reaches first";
    let wrong = |name: &'static str| {
        let roots = LINES
            .iter()
            .map(|&(p, d, r)| mistakes::roots_by_quadratic(name, p, d, r));
        let firsts = INTERVALS
            .iter()
            .map(|&(roots, start, end)| mistakes::first_root(name, roots, &half_line(start, end)));
        let roots: Option<Vec<_>> = roots
            .map(|roots| roots.map(|roots| behaviour(|| roots)))
            .collect();
        let firsts: Option<Vec<_>> = firsts
            .map(|first| first.map(|first| behaviour(|| first)))
            .collect();
        roots.or(firsts)
    };
    let got = |name: &'static str| {
        let is_of_roots = mistakes::roots_by_quadratic(name, LINES[0].0, LINES[0].1, 1.0).is_some();
        let roots = LINES
            .iter()
            .map(|&(p, d, r)| behaviour(|| roots_by_quadratic(p, d, r)));
        let firsts = INTERVALS
            .iter()
            .map(|&(roots, start, end)| behaviour(|| first_root(roots, &half_line(start, end))));
        if is_of_roots {
            roots.collect()
        } else {
            firsts.collect()
        }
    };
    found("sphere", general, wrong, &got)
}

/// Suspects for the roots by projection.
pub fn stable() -> LikelyMistake {
    let general = "compute p⊥ first, then the half chord from (r - h)(r + h), then q, and the second root from c / q";
    let wrong = |name: &'static str| {
        let roots = LINES
            .iter()
            .map(|&(p, d, r)| mistakes::roots_by_projection(name, p, d, r));
        roots
            .map(|roots| roots.map(|roots| behaviour(|| roots)))
            .collect()
    };
    let got = |_: &'static str| {
        LINES
            .iter()
            .map(|&(p, d, r)| behaviour(|| roots_by_projection(p, d, r)))
            .collect()
    };
    found("stable", general, wrong, &got)
}

/// Lines at a box: through it both ways, from inside, past it, along an edge's diagonal, parallel inside, outside, and in a face.
const BOX_LINES: [[Point; 2]; 9] = [
    [[-3.0, -2.0, 0.5], [2.0, 1.5, 0.25]],
    [[4.0, 3.0, 0.5], [-2.0, -1.5, 0.125]],
    [[0.25, 0.5, 0.0], [1.0, 2.0, -0.5]],
    [[-3.0, 2.0, 0.0], [1.0, 0.5, 0.125]],
    [[-2.0, 0.0, 0.0], [1.0, 1.0, 0.0]],
    [[-3.0, 0.5, 0.25], [1.0, 0.0, 0.125]],
    [[-3.0, 1.5, 0.25], [1.0, 0.0, 0.125]],
    [[-3.0, 1.0, 0.25], [1.0, 0.0, 0.125]],
    [[-3.0, 0.5, 0.0], [1.0, 0.0, 0.0]],
];

/// Suspects for the slabs' interval.
pub fn slabs() -> LikelyMistake {
    let general = "for each axis find the entry and the exit of one slab, then the largest entry and the smallest exit of the three";
    let Ok(bounds) = BoundingBox::new([-1.0; 3], [1.0; 3]) else {
        return library();
    };
    let ray = |[origin, direction]: [Point; 2]| Ray::new(origin, direction);
    let wrong = |name: &'static str| {
        let intervals = BOX_LINES
            .iter()
            .map(|&line| mistakes::box_interval(name, &bounds, &ray(line)));
        intervals
            .map(|interval| interval.map(|interval| behaviour(|| interval)))
            .collect()
    };
    let got = |_: &'static str| {
        BOX_LINES
            .iter()
            .map(|&line| behaviour(|| box_interval(&bounds, &ray(line))))
            .collect()
    };
    found("slabs", general, wrong, &got)
}

/// A sphere that counts the questions.
struct Counted<'a>(Sphere<Point>, &'a std::cell::Cell<u32>);

impl Intersect for Counted<'_> {
    type Point = Point;

    fn intersect(&self, ray: &Ray<Point>) -> Option<facette::intersection::Hit<Point>> {
        self.1.set(self.1.get() + 1);
        self.0.intersect(ray)
    }
}

/// The answers to two rays, one with an end, among spheres of which the nearest stand second and third, and the number of questions.
fn group_behaviour(ask: impl Fn(&[Counted<'_>], &Ray<Point>) -> Option<usize>) -> Vec<String> {
    let questions = std::cell::Cell::new(0);
    let spheres: Vec<_> = [7.0, 5.0, 5.0, 9.0, 8.0]
        .into_iter()
        .filter_map(|x| Sphere::new([x, 0.0, 0.0], 1.0).ok())
        .map(|sphere| Counted(sphere, &questions))
        .collect();
    let rays = [half_line(0.0, None), half_line(0.0, Some(1.0))];
    let mut answers: Vec<_> = rays
        .iter()
        .map(|ray| behaviour(|| ask(&spheres, ray)))
        .collect();
    answers.push(questions.get().to_string());
    answers
}

/// Suspects for the nearest of many.
pub fn group() -> LikelyMistake {
    let general = "start with the ray as it is and nothing found; ask each member up to the best distance so far; keep what is nearer";
    let wrong = |name: &'static str| {
        mistakes::nearest(name, &[] as &[Sphere<Point>], &half_line(0.0, None))?;
        Some(group_behaviour(|members, ray| {
            let answer = mistakes::nearest(name, members, ray);
            answer.flatten().map(|(member, _)| member)
        }))
    };
    let got = |_: &'static str| {
        group_behaviour(|members, ray| nearest(members, ray).map(|(member, _)| member))
    };
    found("group", general, wrong, &got)
}

/// Suspects for what no exercise asks the reader to write.
pub fn library() -> LikelyMistake {
    LikelyMistake {
        name: "",
        hint: "a defect of the library: no exercise replaces this code",
    }
}
