//! Scenes of triangles, and rays at everything that is delicate about them.

use facette::ray::Ray;
use glam::Vec3;
use proptest::prelude::*;

use crate::hierarchy_meshes::{Draws, bumpy_ball};

/// Triangles and rays. The same seed makes the same scene, with fewer triangles if fewer are asked for.
#[derive(Clone, Debug)]
pub struct Scene {
    pub triangles: Vec<[Vec3; 3]>,
    pub rays: Vec<Ray<Vec3>>,
}

/// What kind of triangles.
#[derive(Clone, Copy, Debug)]
enum Kind {
    /// A closed mesh.
    Closed,
    /// Large triangles that cross each other.
    Soup,
    /// Corners at small whole numbers: many hits at the same t, many triangles without area.
    Lattice,
    /// A few triangles, each of them many times.
    Coincident,
    /// Needles and slivers, some of no width.
    Slivers,
}

impl Kind {
    fn triangles(self, count: usize, draws: &mut Draws) -> Vec<[Vec3; 3]> {
        match self {
            Self::Closed => bumpy_ball(4),
            Self::Soup => (0..count)
                .map(|_| [draws.vector(), draws.vector(), draws.vector()])
                .collect(),
            Self::Lattice => (0..count)
                .map(|_| [0; 3].map(|_| (3.0 * draws.vector()).round()))
                .collect(),
            Self::Coincident => {
                let few = Self::Soup.triangles(3, draws);
                (0..count).map(|_| few[draws.index(3)]).collect()
            }
            Self::Slivers => (0..count).map(|_| sliver(draws)).collect(),
        }
    }
}

fn sliver(draws: &mut Draws) -> [Vec3; 3] {
    let [a, b] = [draws.vector(), draws.vector()];
    let width = [0.0, 1e-7, 1e-4, 1e-2][draws.index(4)];
    [a, b, a + (b - a) * draws.share() + width * draws.vector()]
}

/// A ray of one of eight kinds, at a triangle of a scene of about this size.
fn ray(kind: usize, triangles: &[[Vec3; 3]], size: f32, draws: &mut Draws) -> Ray<Vec3> {
    let corners = triangles[draws.index(triangles.len())];
    let [a, b, c] = corners;
    let outside = 2.0 * size * draws.vector();
    let edge_point = a + (b - a) * [0.5, 0.25, draws.share()][draws.index(3)];
    let on_it = a + (b - a) * (0.5 * draws.share()) + (c - a) * (0.5 * draws.share());
    let axis = Vec3::AXES[draws.index(3)] * [1.0, -1.0][draws.index(2)];
    match kind % 8 {
        0 => Ray::new(outside, draws.vector()),
        1 => Ray::new(outside, a - outside),
        2 => Ray::new(outside, edge_point - outside),
        // Along an axis: zeros, and zeros with a sign, in the direction.
        3 => Ray::new(a - axis * size, axis),
        // From a face, and from an edge.
        4 => Ray::new(on_it, draws.vector()),
        5 => Ray::new(edge_point, on_it - outside),
        // In a triangle's plane.
        6 => Ray::new(a + (a - c), (b - a) + (c - a)),
        // The corner is at t = 1, or near it: the interval's end, or its start.
        _ => {
            let ray = Ray::new(outside, a - outside);
            if draws.index(2) == 0 {
                ray.until(1.0)
            } else {
                ray.after(1.0)
            }
        }
    }
}

fn scene(kind: Kind, seed: u64, count: usize, scale: f32, shift: f32) -> Scene {
    let mut draws = Draws::new(seed);
    let mut triangles = kind.triangles(count, &mut draws);
    for corner in triangles.iter_mut().flatten() {
        *corner = *corner * scale + Vec3::splat(shift);
    }
    let size = triangles
        .iter()
        .flatten()
        .fold(0.0_f32, |size, corner| size.max(corner.abs().max_element()));
    let size = if shift == 0.0 { size } else { scale };
    let mut rays: Vec<_> = (0..16)
        .map(|kind| ray(kind, &triangles, size, &mut draws))
        .collect();
    if shift != 0.0 {
        for ray in rays
            .iter_mut()
            .filter(|ray| ray.origin.abs().max_element() < shift / 2.0)
        {
            ray.origin += Vec3::splat(shift);
        }
    }
    Scene { triangles, rays }
}

/// Closed meshes and soups of ordinary size.
pub fn scenes() -> impl Strategy<Value = Scene> {
    let kinds = prop_oneof![Just(Kind::Closed), Just(Kind::Soup)];
    (kinds, any::<u64>(), 1..40_usize)
        .prop_map(|(kind, seed, count)| scene(kind, seed, count, 1.0, 0.0))
}

/// Coincident triangles, hits at the same t, slivers; coordinates far from the origin, tiny, denormal and huge.
pub fn hard_scenes() -> impl Strategy<Value = Scene> {
    let kinds = prop::sample::select(vec![
        Kind::Closed,
        Kind::Soup,
        Kind::Lattice,
        Kind::Lattice,
        Kind::Coincident,
        Kind::Slivers,
    ]);
    let places = prop::sample::select(vec![
        (1.0, 0.0),
        (1.0, 0.0),
        (1e-30, 0.0),
        (1e-43, 0.0),
        (1e30, 0.0),
        (1e37, 0.0),
        (64.0, 1e7),
    ]);
    (kinds, any::<u64>(), 1..24_usize, places)
        .prop_map(|(kind, seed, count, (scale, shift))| scene(kind, seed, count, scale, shift))
}
