//! Which typical mistake does the code under test behave like? Each suspect function tries it on a few fixed inputs that tell
//! all of them apart.

use std::panic::{AssertUnwindSafe, catch_unwind};

use facette::mesh::Mesh;
use facette::subdivision::curve::{Ends, chaikin_step, cubic_step, double_and_average};
use facette::subdivision::{
    Corners, catmull_clark as catmull_clark_step, loop_subdivision as loop_step,
    loop_subdivision_with,
};

use crate::common::exact::{Exact, fraction};
use crate::common::law::LikelyMistake;
use crate::meshes::{
    Topology, bipyramid, double_fan, fan, grid, polygon as polygon_faces, prism, quad_fan,
};
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

const CORNERS: [Corners; 2] = [Corners::Sharp, Corners::Smooth];
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

/// Points without symmetries for a mesh.
fn scattered(topology: &Topology) -> Vec<[Exact; 3]> {
    polygon(i32::try_from(topology.vertex_count).expect("a small mesh"))
}

/// Suspects for `catmull_clark`.
pub fn catmull_clark() -> LikelyMistake {
    let general = "first the face points, the means of the corners; then (Q + R)/2 on every edge; then (Q + 2R + (n-3)S)/n for every vertex inside";
    let probes = [quad_fan(5), prism(5), grid(2, 1)];
    found("catmull_clark", general, |name| {
        let mut cases = probes
            .iter()
            .flat_map(|probe| CORNERS.map(|corners| (probe, corners)));
        cases.all(|(probe, corners)| {
            let (joined, points) = (probe.connectivity(), scattered(probe));
            let wrong = mistakes::catmull_clark(name, &joined, &points, corners);
            wrong.is_some() && wrong == outcome(|| catmull_clark_step(&joined, &points, corners))
        })
    })
}

/// Suspects for `loop_subdivision` and `loop_subdivision_with`.
pub fn loop_subdivision() -> LikelyMistake {
    let general = "on every edge inside 3/8 (A + B) + 1/8 (C + D), for every vertex inside alpha V + (1 - alpha) Q with the mean Q of its neighbours";
    let probes = [double_fan(5), bipyramid(7), polygon_faces(3)];
    let alpha = |n: usize| fraction(1, i32::try_from(n).expect("a small valence"));
    found("loop", general, |name| {
        if name == "printed_cosine" {
            return has_printed_cosine();
        }
        let mut cases = probes
            .iter()
            .flat_map(|probe| CORNERS.map(|corners| (probe, corners)));
        cases.all(|(probe, corners)| {
            let (joined, points) = (probe.connectivity(), scattered(probe));
            let wrong = mistakes::loop_subdivision_with(name, &joined, &points, corners, &alpha);
            let got = outcome(|| loop_subdivision_with(&joined, &points, corners, alpha));
            wrong.is_some() && wrong == got
        })
    })
}

/// Whether the code under test has the slide's cosine.
fn has_printed_cosine() -> bool {
    let mut points = vec![0.0; 8];
    points[0] = 1.0;
    let joined = fan(7).connectivity();
    let wrong = mistakes::loop_subdivision("printed_cosine", &joined, &points, Corners::Sharp);
    let got = outcome(|| loop_step(&joined, &points, Corners::Sharp));
    let tip = |refined: Option<Result<Mesh<f64>, _>>| {
        refined.and_then(Result::ok).map(|mesh| mesh.positions[0])
    };
    match (tip(wrong), tip(got)) {
        // Roundings may differ; the right weight is a tenth away.
        (Some(wrong), Some(got)) => (wrong - got).abs() < 0.01,
        _ => false,
    }
}
