//! Which typical mistake does the code under test behave like? Each suspect function tries it on a few fixed inputs that tell
//! all of them apart.

use std::panic::{AssertUnwindSafe, catch_unwind};

use facette::subdivision::curve::{Ends, chaikin_step, cubic_step, double_and_average};

use crate::common::exact::{Exact, fraction};
use crate::common::law::LikelyMistake;
use crate::mistakes::{self, MISTAKES};

/// A polygon without symmetries.
fn polygon(count: i32) -> Vec<[Exact; 3]> {
    let point = |k: i32| {
        [
            fraction(k * k, 1),
            fraction(3 * k - k * k * k, 2),
            fraction(7, k + 2),
        ]
    };
    (0..count).map(point).collect()
}

/// What a piece of code does: a value, or a panic.
fn outcome<T>(code: impl FnOnce() -> T) -> Option<T> {
    catch_unwind(AssertUnwindSafe(code)).ok()
}

/// The mistake among those of `exercise` that agrees with the code under test; otherwise `general`.
fn found(
    exercise: &str,
    general: &'static str,
    agrees: impl Fn(&'static str) -> bool,
) -> LikelyMistake {
    let mut candidates = MISTAKES
        .iter()
        .filter(|mistake| mistake.exercise == exercise);
    match candidates.find(|mistake| agrees(mistake.name)) {
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

const ALL_ENDS: [Ends; 3] = [Ends::Closed, Ends::Open, Ends::Kept];

/// Suspects for `chaikin_step`.
pub fn chaikin() -> LikelyMistake {
    let general = "on every edge from P to P+ first Q = 3/4 P + 1/4 P+, then R = 1/4 P + 3/4 P+";
    let points = polygon(5);
    found("chaikin", general, |name| {
        ALL_ENDS.into_iter().all(|ends| {
            let wrong = mistakes::chaikin_step(name, &points, ends);
            wrong.is_some() && wrong == outcome(|| chaikin_step(&points, ends))
        })
    })
}

/// Suspects for `cubic_step`.
pub fn cubic() -> LikelyMistake {
    let general = "for every vertex with two neighbours (P- + 6P + P+)/8, for every edge its midpoint, \
                   in the order of the polygon";
    let points = polygon(5);
    found("cubic", general, |name| {
        ALL_ENDS.into_iter().all(|ends| {
            let wrong = mistakes::cubic_step(name, &points, ends);
            wrong.is_some() && wrong == outcome(|| cubic_step(&points, ends))
        })
    })
}

/// Suspects for `double_and_average`.
pub fn lane_riesenfeld() -> LikelyMistake {
    let general = "write every point twice; then, as many times as the degree says, replace the list by the midpoints of its neighbours";
    let points = polygon(6);
    found("lane_riesenfeld", general, |name| {
        [1, 2, 3, 4].into_iter().all(|degree| {
            let wrong = mistakes::double_and_average(name, &points, degree);
            wrong.is_some() && wrong == outcome(|| double_and_average(&points, degree))
        })
    })
}

/// Suspects for what no exercise asks the reader to write.
pub fn library() -> LikelyMistake {
    LikelyMistake {
        name: "",
        hint: "a defect of the library: no exercise replaces this code",
    }
}

/// Suspects for `catmull_clark`.
pub fn catmull_clark() -> LikelyMistake {
    library()
}

/// Suspects for `loop_subdivision`.
pub fn loop_subdivision() -> LikelyMistake {
    library()
}
