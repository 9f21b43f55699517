//! The theorem of the page *A hierarchy of boxes* on rays that go the same way.

use facette::intersection::hierarchy::{Hierarchy, nearest_by_loop};
use facette::ray::Ray;
use glam::Vec3;

use crate::hierarchy_meshes::{Draws, bumpy_ball, ray_at_the_border};

/// Sixty-four rays that go the same way, around one at a corner or an edge: from one eye within a narrow cone, or parallel from a small window. One of
/// them may end early.
fn bundle(triangles: &[[Vec3; 3]], draws: &mut Draws, spread: f32) -> Vec<Ray<Vec3>> {
    let axis = ray_at_the_border(triangles, draws);
    let from_outside = draws.index(2) == 0;
    let (origin, direction) = if from_outside {
        (axis.point(3.0), -axis.direction)
    } else {
        (axis.origin, axis.direction)
    };
    let is_parallel = draws.index(2) == 0;
    let mut rays: Vec<_> = (0..63)
        .map(|_| {
            let moved = spread * draws.vector();
            if is_parallel {
                Ray::new(origin + moved, direction)
            } else {
                Ray::new(origin, direction + moved)
            }
        })
        .collect();
    rays.push(Ray::new(origin, direction));
    let short = draws.index(rays.len());
    rays[short] = rays[short].until(draws.share());
    rays
}

/// **A packet answers as single rays do.** Eight rays that go the same way share the tests of the boxes, and nothing else. In bundles of 64 rays around a corner or an edge of a mesh, narrow enough for packets or too wide for them, every ray finds what it finds alone, and what the loop finds, whether the
/// nearest hit is asked for or any.
#[test]
fn packet_answers_as_single_rays_do() {
    let triangles = bumpy_ball(9);
    let hierarchy = Hierarchy::new(&triangles).expect("finite corners");
    let mut query = hierarchy.query();
    let mut draws = Draws::new(6);
    for round in 0..240 {
        let spread = [0.0, 1e-6, 1e-3, 0.02, 0.2][round % 5];
        let rays = bundle(&triangles, &mut draws, spread);
        let (mut found, mut is_hit) = (vec![None; rays.len()], vec![false; rays.len()]);
        query.nearest_of(&rays, &mut found);
        query.is_hit_of(&rays, &mut is_hit);
        for (number, ray) in rays.iter().enumerate() {
            let alone = query.nearest(ray);
            assert_eq!(alone, found[number], "spread {spread}, {ray:?}");
            assert_eq!(alone.is_some(), is_hit[number], "any hit of {ray:?}");
            if number % 9 == 0 {
                assert_eq!(nearest_by_loop(&triangles, ray), alone, "{ray:?}");
            }
        }
    }
}
