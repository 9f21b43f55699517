//! The hierarchy of boxes: four kinds of rays at meshes of a hundred to a million triangles, alone and side by side; the loop; the building.

use facette::intersection::Hit;
use facette::intersection::hierarchy::{Found, Hierarchy, Query, nearest_by_loop};
use facette::intersection::offset::{spawn_ray, spawn_ray_to};
use facette::intersection::triangle::moller_trumbore;
use facette::ray::Ray;
use glam::Vec3;

use crate::Visitor;
use crate::answers::{Answer, Truth, Truths};
use crate::harness::{Comparison, Effort, lazily};
use hierarchy_meshes::{Draws, bumpy_ball, cuts_for, ray_at_the_border};
use truths::TruthTree;

#[path = "../../../tests/intersection/hierarchy_meshes.rs"]
mod hierarchy_meshes;
#[path = "../../../tests/intersection/hierarchy_oracle.rs"]
#[allow(dead_code, reason = "the tests use more of it than this report")]
mod hierarchy_oracle;
#[path = "hierarchy/truths.rs"]
mod truths;

/// How many triangles the meshes have, about.
const SIZES: [usize; 5] = [100, 1000, 10_000, 100_000, 1_000_000];

/// How many rays there are of each kind, and how many the loop is asked, which takes long.
const RAYS: u32 = 64 * 64;
const RAYS_FOR_THE_LOOP: usize = 16;

/// How many triangles are built at least before the clock is read.
const BUILT_AT_ONCE: usize = 20_000;

/// How long all turns of a comparison may last, in nanoseconds: there are some thirty.
const BUDGET: f64 = 1.5e9;

/// A mesh, its hierarchy, and what tells the truth about it.
struct Scene {
    hierarchy: Hierarchy,
    truths: TruthTree,
    /// Rays of each kind.
    count: u32,
}

/// Hands all comparisons to the visitor.
pub fn visit(effort: Effort, visitor: &mut Visitor<'_>) {
    let is_quick = effort.points < 16;
    let sizes = if is_quick { &SIZES[..2] } else { &SIZES };
    let count = if is_quick { 64 } else { RAYS };
    for &size in sizes {
        let triangles = bumpy_ball(cuts_for(size));
        let scene = Scene {
            truths: TruthTree::new(&triangles),
            hierarchy: Hierarchy::new(&triangles).expect("finite corners"),
            count,
        };
        rays(&scene, visitor);
        the_loop(&scene, visitor);
        build(&triangles, visitor);
    }
    edges(visitor, count);
}

/// Four kinds of rays.
fn rays(scene: &Scene, visitor: &mut Visitor<'_>) {
    let camera = scene.camera_rays();
    nearest("hierarchy: camera rays", "typical", scene, &camera, visitor);
    nearest(
        "hierarchy: incoherent rays",
        "typical",
        scene,
        &scene.incoherent_rays(),
        visitor,
    );
    nearest(
        "hierarchy: bounces",
        "typical",
        scene,
        &scene.bounces(),
        visitor,
    );
    any(
        "hierarchy: shadow rays",
        scene,
        &scene.shadow_rays(&camera),
        visitor,
    );
}

fn random_in_ball(draws: &mut Draws) -> Vec3 {
    draws.direction() * draws.share().cbrt()
}

impl Scene {
    /// A square of rays from a camera before the ball, row by row: most meet it.
    fn camera_rays(&self) -> Vec<Ray<Vec3>> {
        let side = self.count.isqrt();
        let at = |pixel: u32| 2.0 * (pixel as f32 + 0.5) / side as f32 - 1.0;
        let eye = Vec3::new(0.3, -4.0, 0.9);
        let pixels = (0..side).flat_map(|row| (0..side).map(move |column| (row, column)));
        pixels
            .map(|(row, column)| Ray::new(eye, Vec3::new(at(column), 0.0, -at(row)) - eye))
            .collect()
    }

    /// Rays from all sides, one unlike the other, at points within the ball.
    fn incoherent_rays(&self) -> Vec<Ray<Vec3>> {
        let mut draws = Draws::new(6);
        let rays = (0..self.count).map(|_| {
            let origin = 2.0 * draws.direction();
            Ray::new(origin, random_in_ball(&mut draws) - origin)
        });
        rays.collect()
    }

    fn hits<'a>(&'a self, rays: &'a [Ray<Vec3>]) -> impl Iterator<Item = Hit<Vec3>> + 'a {
        let mut query = self.hierarchy.query();
        let hits = rays.iter().filter_map(move |ray| query.nearest_hit(ray));
        hits.map(|(_, hit)| hit)
    }

    /// Rays that leave the inner side of the ball, by the cosine of the angle to its normal: a room seen from inside.
    fn bounces(&self) -> Vec<Ray<Vec3>> {
        let mut draws = Draws::new(7);
        let from_inside: Vec<_> = (0..self.count)
            .map(|_| Ray::new(Vec3::ZERO, draws.direction()))
            .collect();
        let bounces = self.hits(&from_inside).map(|hit| {
            // A point of the unit sphere on top of the normal: Lambert's cosine.
            spawn_ray(&hit, draws.direction() * 0.999 - hit.normal)
        });
        bounces.collect()
    }

    /// From what the camera sees to a lamp, as often as there are rays.
    fn shadow_rays(&self, camera: &[Ray<Vec3>]) -> Vec<Ray<Vec3>> {
        let lamp = Vec3::new(3.0, -1.0, 2.0);
        let seen: Vec<_> = self
            .hits(camera)
            .map(|hit| spawn_ray_to(&hit, lamp))
            .collect();
        seen.iter().copied().cycle().take(camera.len()).collect()
    }
}

fn answer(found: &Found) -> Answer {
    Answer {
        t: found.hit.t.into(),
        surface: found.triangle,
    }
}

fn answer_all(found: &[Option<Found>], answers: &mut [Option<Answer>]) {
    for (found, slot) in found.iter().zip(answers) {
        *slot = found.as_ref().map(answer);
    }
}

fn alone<'a>(
    mut query: Query<'a>,
    rays: &'a [Ray<Vec3>],
) -> impl FnMut(&mut [Option<Answer>]) + 'a {
    move |answers| {
        for (ray, slot) in rays.iter().zip(answers) {
            *slot = query.nearest(ray).as_ref().map(answer);
        }
    }
}

fn side_by_side<'a>(
    mut query: Query<'a>,
    rays: &'a [Ray<Vec3>],
) -> impl FnMut(&mut [Option<Answer>]) + 'a {
    let mut found = vec![None; rays.len()];
    move |answers| {
        query.nearest_of(rays, &mut found);
        answer_all(&found, answers);
    }
}

/// The first hit of rays, alone and side by side.
fn nearest(
    quantity: &'static str,
    inputs: &'static str,
    scene: &Scene,
    rays: &[Ray<Vec3>],
    visitor: &mut Visitor<'_>,
) {
    let query = || scene.hierarchy.query();
    let truths: Truths<'_> = lazily(|| rays.iter().map(|ray| scene.truths.nearest(ray)).collect());
    let comparison = Comparison::new(quantity, inputs, rays.len())
        .of_size(scene.hierarchy.triangles().len())
        .within(BUDGET)
        .answers(["ray by ray", "f32"], &truths, alone(query(), rays))
        .answers(
            ["side by side", "f32"],
            &truths,
            side_by_side(query(), rays),
        );
    visitor(comparison);
}

/// Whether anything is in the way.
fn any(quantity: &'static str, scene: &Scene, rays: &[Ray<Vec3>], visitor: &mut Visitor<'_>) {
    const YES: Answer = Answer { t: 1.0, surface: 0 };
    let yes = || Truth {
        t: crate::common::oracle::big(1.0),
        surfaces: vec![0],
    };
    let truths: Truths<'_> = lazily(|| {
        rays.iter()
            .map(|ray| scene.truths.nearest(ray).map(|_| yes()))
            .collect()
    });
    let [mut single, mut stream] = [(); 2].map(|()| scene.hierarchy.query());
    let mut is_hit = vec![false; rays.len()];
    let comparison = Comparison::new(quantity, "typical", rays.len())
        .of_size(scene.hierarchy.triangles().len())
        .within(BUDGET)
        .answers(["ray by ray", "f32"], &truths, move |answers| {
            for (ray, slot) in rays.iter().zip(answers) {
                *slot = single.is_hit(ray).then_some(YES);
            }
        })
        .answers(["side by side", "f32"], &truths, move |answers| {
            stream.is_hit_of(rays, &mut is_hit);
            for (is_hit, slot) in is_hit.iter().zip(answers) {
                *slot = is_hit.then_some(YES);
            }
        });
    visitor(comparison);
}

/// Möller and Trumbore's test on every triangle.
fn by_moller_trumbore<'a, S: facette::algebra::Real>(
    scene: &'a Scene,
    rays: &'a [Ray<Vec3>],
) -> impl FnMut(&mut [Option<Answer>]) + use<S> {
    let point = |p: Vec3| p.as_dvec3().to_array().map(S::from_f64);
    let triangles: Vec<_> = scene
        .hierarchy
        .triangles()
        .iter()
        .map(|corners| corners.map(point))
        .collect();
    let rays: Vec<_> = rays
        .iter()
        .map(|ray| Ray::new(point(ray.origin), point(ray.direction)))
        .collect();
    move |answers| {
        for (ray, slot) in rays.iter().zip(answers) {
            let (mut ray, mut best) = (*ray, None);
            for (surface, corners) in (0..).zip(&triangles) {
                if let Some(hit) = moller_trumbore(corners, &ray) {
                    ray = ray.until(hit.t);
                    best = Answer::of(Some(hit.t), surface);
                }
            }
            *slot = best;
        }
    }
}

fn by_loop<'a>(scene: &'a Scene, rays: &'a [Ray<Vec3>]) -> impl FnMut(&mut [Option<Answer>]) + 'a {
    let triangles = scene.hierarchy.triangles();
    move |answers| {
        for (ray, slot) in rays.iter().zip(answers) {
            *slot = nearest_by_loop(triangles, ray).as_ref().map(answer);
        }
    }
}

/// The loop over all triangles, on a few rays; the hierarchy on the same ones.
fn the_loop(scene: &Scene, visitor: &mut Visitor<'_>) {
    let rays = &scene.incoherent_rays()[..RAYS_FOR_THE_LOOP];
    against_the_loop(
        "hierarchy: against the loop",
        "typical",
        scene,
        rays,
        visitor,
    );
}

fn against_the_loop(
    quantity: &'static str,
    inputs: &'static str,
    scene: &Scene,
    rays: &[Ray<Vec3>],
    visitor: &mut Visitor<'_>,
) {
    let truths: Truths<'_> = lazily(|| rays.iter().map(|ray| scene.truths.nearest(ray)).collect());
    let comparison = Comparison::new(quantity, inputs, rays.len())
        .of_size(scene.hierarchy.triangles().len())
        .within(BUDGET)
        .answers(
            ["Möller-Trumbore loop", "f64"],
            &truths,
            by_moller_trumbore::<f64>(scene, rays),
        )
        .answers(
            ["Möller-Trumbore loop", "f32"],
            &truths,
            by_moller_trumbore::<f32>(scene, rays),
        )
        .answers(["exact loop", "f32"], &truths, by_loop(scene, rays))
        .answers(
            ["hierarchy", "f32"],
            &truths,
            alone(scene.hierarchy.query(), rays),
        );
    visitor(comparison);
}

/// Rays at edges and corners, where single precision is in doubt.
fn edges(visitor: &mut Visitor<'_>, count: u32) {
    let triangles = bumpy_ball(cuts_for(1000));
    let scene = Scene {
        truths: TruthTree::new(&triangles),
        hierarchy: Hierarchy::new(&triangles).expect("finite corners"),
        count,
    };
    let mut draws = Draws::new(8);
    let rays: Vec<_> = (0..count / 4)
        .map(|_| ray_at_the_border(&triangles, &mut draws))
        .collect();
    against_the_loop(
        "hierarchy: against the loop",
        "hard",
        &scene,
        &rays,
        visitor,
    );
}

/// Nanoseconds a triangle to build. Small meshes are built several times in a row: to hand work over to the one thread takes longer than to
/// build a hundred triangles.
fn build(triangles: &[[Vec3; 3]], visitor: &mut Visitor<'_>) {
    let size = triangles.len();
    let times = BUILT_AT_ONCE.div_ceil(size);
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(1)
        .build()
        .expect("a thread");
    let all = || {
        for _ in 0..times {
            std::hint::black_box(Hierarchy::new(triangles).expect("finite corners"));
        }
    };
    let comparison = Comparison::new("hierarchy: build", "typical", size * times)
        .of_size(size)
        .within(BUDGET)
        .yardstick::<[f32; 3]>(["one thread", "f32"], |_| pool.install(all))
        .yardstick::<[f32; 3]>(["all threads", "f32"], |_| all())
        .on_threads(rayon::current_num_threads());
    visitor(comparison);
}
