//! No ray slips between triangles that share an edge or a corner.

use facette::algebra::Real;
use facette::intersection::triangle::{
    half_planes, moller_trumbore, robust, strict_half_planes, watertight,
};
use facette::ray::Ray;

use crate::common::dice::Dice;
use crate::triangle_inputs::Test;
use crate::triangle_meshes::Ball;

/// Rays at edges and corners for each type of number and each test.
const RAYS: usize = 100_000;

/// As many for the tests that leak: a lost ray is tried on every face.
const RAYS_TO_LOSE: usize = 10_000;

/// The meshes: rough ones near the origin, far from it, small and large; and one where rays meet corners and edges exactly.
fn meshes() -> Vec<(f64, Ball)> {
    let mut dice = Dice::new(1);
    let places = [
        (1.0, [0.0; 3]),
        (1.0, [300.0, -200.0, 500.0]),
        (1e-3, [0.01, 0.02, -0.01]),
        (1e6, [1e7, 1e6, -1e7]),
    ];
    let mut meshes: Vec<_> = places
        .into_iter()
        .map(|(size, centre)| (size, Ball::rough(size, centre, &mut dice)))
        .collect();
    meshes.push((4.0, Ball::octahedron()));
    meshes
}

/// How many of the rays at edges and corners meet no face at all.
fn lost<S: Real>(test: Test<[S; 3], S>, count: usize) -> usize {
    let meshes = meshes();
    let mut dice = Dice::new(2);
    let rays = (0..count).map(|index| &meshes[index % meshes.len()]);
    rays.filter(|(size, ball)| {
        let (face, ray) = ball.ray_at_the_border(*size, &mut dice);
        !ball.stops(face, &ray, test)
    })
    .count()
}

/// **No ray slips through.** Of 100 000 rays from the inside of closed meshes, aimed at edges and corners, the watertight test and the exact one lose none, in `f32` and in `f64`.
///
/// *Woop's test.* Each corner is sheared once for every ray, alike in all its triangles. The side of an edge is $p_xq_y-p_yq_x$, of two sheared corners; the neighbour computes the same two products, and their difference the
/// other way round. Its computed sign is never the opposite of the exact one, and where it is zero, both neighbours take the edge. So in the sheared plane the decision is exact, for a mesh whose corners have moved a
/// little, all together; a closed mesh that is seen from inside covers every point of that plane.
#[test]
fn no_ray_slips_through_a_closed_mesh() {
    let tests64: [(&str, Test<[f64; 3], f64>); 2] =
        [("watertight", watertight), ("robust", robust)];
    let tests32: [(&str, Test<[f32; 3], f32>); 2] =
        [("watertight", watertight), ("robust", robust)];
    for (name, test) in tests64 {
        assert_eq!(lost(test, RAYS), 0, "{name}, f64");
    }
    for (name, test) in tests32 {
        assert_eq!(lost(test, RAYS), 0, "{name}, f32");
    }
}

/// **The others leak.** On the same rays Möller and Trumbore's test and the half-planes, open or closed, lose some: each neighbour rounds the edge by itself. The open half-planes lose a third or more of the rays at edges,
/// since they lose those that are exact as well.
#[test]
fn ordinary_tests_lose_rays_at_edges() {
    let counts64 = [moller_trumbore, half_planes, strict_half_planes]
        .map(|test| lost::<f64>(test, RAYS_TO_LOSE));
    let counts32 = [moller_trumbore, half_planes, strict_half_planes]
        .map(|test| lost::<f32>(test, RAYS_TO_LOSE));
    println!(
        "of {RAYS_TO_LOSE} rays lost by Möller-Trumbore, closed, open half-planes: f64 {counts64:?}, f32 {counts32:?}"
    );
    for [moller_trumbore, closed, open] in [counts64, counts32] {
        assert!(moller_trumbore > 0 && closed > 0 && open > RAYS_TO_LOSE / 10);
    }
}

/// **A closed mesh has no way out.** Every ray that starts inside a closed mesh meets it.
#[test]
fn rays_from_inside_hit_the_mesh() {
    for (size, ball) in meshes() {
        let mut dice = Dice::new(3);
        for _ in 0..2000 {
            let origin: [f64; 3] =
                std::array::from_fn(|axis| ball.centre[axis] + 0.25 * size * dice.roll());
            let direction = dice.vector();
            let ray = Ray::new(origin, direction);
            assert!(ball.stops(0, &ray, watertight), "{ray:?}");
            assert!(ball.stops(0, &ray, robust), "{ray:?}");
            let ray = Ray::new(origin.map(f32::from_f64), direction.map(f32::from_f64));
            assert!(ball.stops(0, &ray, watertight), "{ray:?}");
            assert!(ball.stops(0, &ray, robust), "{ray:?}");
        }
    }
}
