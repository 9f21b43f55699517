//! A bicubic patch, directly and as triangles; and rays that leave what they met.

use facette::algebra::{Real, VectorSpace};
use facette::intersection::bezier_patch::PatchIntersector;
use facette::intersection::hierarchy::Hierarchy;
use facette::intersection::offset::spawn_ray;
use facette::intersection::{Hit, Intersect, Sphere};
use facette::ray::Ray;
use facette::tessellation::tessellate;
use glam::{DVec3, Vec3};

use self::patch_inputs::ThroughAPoint;
use self::variants_surfaces::{by_epsilon, by_integer_offset, newton_from_the_middle};
use crate::Visitor;
use crate::answers::{Answer, Truth, Truths};
use crate::common::oracle::big;
use crate::harness::{Comparison, Effort, lazily};

#[allow(dead_code, reason = "the tests use the rest")]
#[path = "../../../tests/intersection/patch_inputs.rs"]
mod patch_inputs;
#[allow(dead_code, reason = "the tests use the rest")]
#[path = "../../../tests/intersection/variants_surfaces.rs"]
mod variants_surfaces;

/// Hands all comparisons to the visitor.
pub fn visit(effort: Effort, visitor: &mut Visitor<'_>) {
    bicubic_patch(effort.points, visitor);
    for (inputs, scale) in [("typical", 1.0), ("hard", 1e7)] {
        departures(inputs, scale, 4 * effort.points, visitor);
    }
}

/// A gently bent bicubic graph, and rays that meet it once, at a whole number for t: single precision holds them exactly.
fn meetings(count: usize) -> Vec<ThroughAPoint> {
    let heights = [0, 1, -1, 0, 1, 0, 2, -1, 0, -2, 1, 1, 1, 0, -1, 0];
    let control_points: Vec<[i32; 3]> = (0..)
        .zip(heights)
        .map(|(k, height)| [4 * (k % 4), 4 * (k / 4), height])
        .collect();
    let whole = |k: usize, modulus: usize| i32::try_from(k % modulus).expect("a small number");
    (0..count)
        .map(|k| ThroughAPoint {
            degrees: [3, 3],
            control_points: control_points.clone(),
            sixteenths: [4 + 4 * whole(k, 3), 4 + 4 * whole(k / 3, 3)],
            direction: [whole(k, 5) - 2, whole(k / 5, 5) - 2, -8],
            t: 1 + whole(k, 7),
        })
        .collect()
}

fn directly<S: Real>(cases: &[ThroughAPoint]) -> impl FnMut(&mut [Option<Answer>]) + use<S> {
    let patch: PatchIntersector<[S; 3]> = cases[0].patch();
    let rays: Vec<Ray<[S; 3]>> = cases
        .iter()
        .map(|case| {
            let ray = case.ray();
            Ray::new(ray.origin.map(S::from_f64), ray.direction.map(S::from_f64))
        })
        .collect();
    move |answers| {
        for (slot, ray) in answers.iter_mut().zip(&rays) {
            *slot = Answer::of(patch.intersect(ray).map(|hit| hit.t), 0);
        }
    }
}

fn as_triangles(
    cases: &[ThroughAPoint],
    tolerance: f64,
) -> impl FnMut(&mut [Option<Answer>]) + use<> {
    let patch: PatchIntersector<[f64; 3]> = cases[0].patch();
    let mesh = tessellate(patch.surface(), tolerance)
        .expect("a usable tolerance")
        .mesh;
    let hierarchy = Hierarchy::of_mesh(&mesh).expect("finite corners");
    let single = |p: [f64; 3]| DVec3::from(p).as_vec3();
    let rays: Vec<Ray<Vec3>> = cases
        .iter()
        .map(|case| Ray::new(single(case.ray().origin), single(case.ray().direction)))
        .collect();
    move |answers| {
        let mut query = hierarchy.query();
        for (slot, ray) in answers.iter_mut().zip(&rays) {
            *slot = Answer::of(query.nearest(ray).map(|found| found.hit.t), 0);
        }
    }
}

fn bicubic_patch(count: usize, visitor: &mut Visitor<'_>) {
    let cases = meetings(count);
    let truths: Truths<'_> = lazily(|| {
        let truth = |case: &ThroughAPoint| Truth {
            t: big(f64::from(case.t)),
            surfaces: vec![0],
        };
        cases.iter().map(|case| Some(truth(case))).collect()
    });
    let patch: PatchIntersector<[f64; 3]> = cases[0].patch();
    let rays: Vec<_> = cases.iter().map(ThroughAPoint::ray).collect();
    let comparison = Comparison::new("bicubic patch", "typical", count)
        .answers(
            ["certified Newton", "f64"],
            &truths,
            directly::<f64>(&cases),
        )
        .answers(
            ["certified Newton", "f32"],
            &truths,
            directly::<f32>(&cases),
        )
        .answers(["Newton from the middle", "f64"], &truths, move |answers| {
            for (slot, ray) in answers.iter_mut().zip(&rays) {
                *slot = Answer::of(newton_from_the_middle(patch.surface(), ray), 0);
            }
        })
        .answers(
            ["triangles within 0.1", "f32"],
            &truths,
            as_triangles(&cases, 0.1),
        )
        .answers(
            ["triangles within 0.001", "f32"],
            &truths,
            as_triangles(&cases, 0.001),
        )
        .answers(
            ["triangles within 0.00001", "f32"],
            &truths,
            as_triangles(&cases, 1e-5),
        );
    visitor(comparison);
}

/// How a ray begins that leaves a hit.
type Start<S> = fn(&Ray<[S; 3]>, &Hit<[S; 3]>, [S; 3]) -> Ray<[S; 3]>;

/// Whether rays that leave a sphere outwards meet it again. The truth is that none does.
fn leave<S: Real>(
    scale: f64,
    count: usize,
    start: Start<S>,
) -> impl FnMut(&mut [Option<Answer>]) + use<S> {
    let to = |p: [f64; 3]| p.map(S::from_f64);
    let centre = [0.3, -0.4, 0.5].times(scale);
    let sphere = Sphere::new(to(centre), S::one()).expect("a radius");
    let hits: Vec<_> = (0..count)
        .filter_map(|k| {
            // Multiples of the golden ratio fill the circle evenly.
            let angle = 0.618_033_988_749_894_9 * std::f64::consts::TAU * k as f64;
            let z = (k as f64 + 0.5) / count as f64;
            let r = f64::sqrt(1.0 - z * z);
            let origin = to(centre.plus([r * angle.cos(), r * angle.sin(), z + 2.0]));
            let ray = Ray::new(origin, to([0.01, 0.02, -1.0]));
            sphere.intersect(&ray).map(|hit| (ray, hit))
        })
        .collect();
    move |answers| {
        for (slot, (ray, hit)) in answers.iter_mut().zip(hits.iter().cycle()) {
            *slot = Answer::of(
                sphere
                    .intersect(&start(ray, hit, hit.normal))
                    .map(|again| again.t),
                0,
            );
        }
    }
}

fn departures(inputs: &'static str, scale: f64, count: usize, visitor: &mut Visitor<'_>) {
    let truths: Truths<'_> = lazily(|| vec![None; count]);
    let comparison = Comparison::new("leaving a sphere", inputs, count)
        .answers(
            ["t > 1e-9", "f64"],
            &truths,
            leave::<f64>(scale, count, |ray, hit, d| by_epsilon(ray, hit, d, 1e-9)),
        )
        .answers(
            ["by the bound", "f64"],
            &truths,
            leave::<f64>(scale, count, |_, hit, d| spawn_ray(hit, d)),
        )
        .answers(
            ["t > 1e-3", "f32"],
            &truths,
            leave::<f32>(scale, count, |ray, hit, d| by_epsilon(ray, hit, d, 1e-3)),
        )
        .answers(
            ["units in the last place", "f32"],
            &truths,
            leave::<f32>(scale, count, |_, hit, d| by_integer_offset(hit, d)),
        )
        .answers(
            ["by the bound", "f32"],
            &truths,
            leave::<f32>(scale, count, |_, hit, d| spawn_ray(hit, d)),
        );
    visitor(comparison);
}
