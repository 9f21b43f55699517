//! Which typical mistake does the reader's test of a triangle behave like?

use facette::intersection::FacetHit;
use facette::intersection::triangle;
use facette::ray::Ray;

use crate::common::law::LikelyMistake;
use crate::mistakes;
use crate::suspects::{behaviour, found};

type Point = [f64; 3];
type Answer = Option<FacetHit<f64>>;

/// No edge, weight or product of it is like another.
const CORNERS: [Point; 3] = [[0.0, 0.0, 1.0], [3.0, 1.0, 2.0], [1.0, 4.0, 0.5]];

/// A triangle that is a thousand times smaller.
const SMALL: [Point; 3] = [[0.0, 0.0, 0.0], [0.004, 0.0, 0.0], [0.0, 0.004, 0.0]];

/// Rays that tell all mistakes apart: front and back, inside, past each edge, on an edge and at a corner, from behind, along the plane, with a start and an end.
fn cases() -> Vec<([Point; 3], Ray<Point>)> {
    let down = |x, y| Ray::new([x, y, 9.0], [0.0, 0.0, -2.0]);
    let inside = down(1.25, 1.5);
    let hit = triangle::robust(&CORNERS, &inside).map_or(1.0, |hit| hit.t);
    let mut rays = vec![
        inside,
        Ray::new([1.25, 1.5, -9.0], [0.0, 0.0, 2.0]),
        Ray::new([1.25, 1.5, -9.0], [0.0, 0.0, -2.0]),
        inside.after(hit),
        inside.until(hit),
        inside.until(hit / 2.0),
        // So near to the plane that the wrong sign of t changes little else.
        Ray::new(inside.point(hit - 0.01), inside.direction).after(-1.0),
    ];
    rays.extend(
        [
            (2.0, 0.0),
            (3.0, 3.0),
            (-1.0, 2.0),
            (0.5, 2.0),
            (1.5, 0.5),
            (0.0, 0.0),
        ]
        .map(|(x, y)| down(x, y)),
    );
    let mut cases: Vec<_> = rays.into_iter().map(|ray| (CORNERS, ray)).collect();
    let small = Ray::new([0.001, 0.001, 1.0], [0.0, 0.0, -1.0]);
    let in_the_plane = Ray::new([-1.0, 0.001, 0.0], [1.0, 0.0, 0.0]);
    cases.extend([small, in_the_plane].map(|ray| (SMALL, ray)));
    cases
}

fn suspect(
    exercise: &str,
    general: &'static str,
    wrong: fn(&str, &[Point; 3], &Ray<Point>) -> Option<Answer>,
    got: fn(&[Point; 3], &Ray<Point>) -> Answer,
) -> LikelyMistake {
    let of_mistake = |name: &'static str| {
        let answers = cases()
            .into_iter()
            .map(|(corners, ray)| wrong(name, &corners, &ray));
        answers
            .map(|answer| answer.map(|answer| behaviour(|| answer)))
            .collect()
    };
    let of_reader = |_: &'static str| {
        let cases = cases().into_iter();
        cases
            .map(|(corners, ray)| behaviour(|| got(&corners, &ray)))
            .collect()
    };
    found(exercise, general, of_mistake, &of_reader)
}

/// Suspects for the half-planes.
pub fn half_planes() -> LikelyMistake {
    let general = "first t from the plane, then x = o + t d, then the three half-planes, each with its own edge and start";
    suspect(
        "half_planes",
        general,
        mistakes::half_planes,
        triangle::half_planes,
    )
}

/// Suspects for Möller and Trumbore's test.
pub fn moller_trumbore() -> LikelyMistake {
    let general = "compare p = d x e2, the determinant e1.p, s = o - a and q = s x e1 with the page, then the quotients v, w and t";
    suspect(
        "moller_trumbore",
        general,
        mistakes::moller_trumbore,
        triangle::moller_trumbore,
    )
}
