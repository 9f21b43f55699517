//! Closed meshes of any number of triangles, in single precision, and rays at their edges and corners.

use facette::ray::Ray;
use glam::{DVec3, Vec3};

/// Pseudo-random numbers in single precision (Knuth's 64-bit linear congruence, upper bits): figures use them too, without the tests' toolbox.
#[derive(Clone, Debug)]
pub struct Draws(u64);

impl Draws {
    pub fn new(seed: u64) -> Self {
        let mut draws = Self(seed);
        draws.share();
        draws
    }

    /// A number from 0 to 1, 1 left out.
    pub fn share(&mut self) -> f32 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 40) as f32 / (1 << 24) as f32
    }

    /// A number below `count`, which is at most 2²⁴.
    #[allow(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "a share of a count is one of its numbers"
    )]
    pub fn index(&mut self, count: usize) -> usize {
        ((f64::from(self.share()) * count as f64) as usize).min(count - 1)
    }

    /// A point of the cube from −1 to 1.
    pub fn vector(&mut self) -> Vec3 {
        let mut coordinate = || 2.0 * self.share() - 1.0;
        Vec3::new(coordinate(), coordinate(), coordinate())
    }

    /// A direction, all directions being as likely.
    pub fn direction(&mut self) -> Vec3 {
        loop {
            let vector = self.vector();
            if (1e-4..=1.0).contains(&vector.length_squared()) {
                return vector.normalize();
            }
        }
    }
}

/// A bumpy ball of 8 k² triangles around the origin, of radius about 1 and star-shaped: an octahedron of which each face is cut into k² triangles, blown up.
/// Triangles that share a corner have it to the last bit.
pub fn bumpy_ball(k: u32) -> Vec<[Vec3; 3]> {
    let mut triangles = Vec::with_capacity(8 * (k * k) as usize);
    for octant in 0..8_u32 {
        let corner = |i: u32, j: u32| {
            let at = [i, j, k - i - j];
            let signed = [0, 1, 2].map(|axis: usize| {
                let x = f64::from(at[axis]);
                if octant >> axis & 1 == 1 { -x } else { x }
            });
            bumped(DVec3::from_array(signed))
        };
        // Three reflections of the first octant turn the corners the other way round.
        let turned = |[a, b, c]: [Vec3; 3]| {
            if octant.count_ones() % 2 == 1 {
                [a, c, b]
            } else {
                [a, b, c]
            }
        };
        for (i, j) in (0..k).flat_map(|i| (0..k - i).map(move |j| (i, j))) {
            let [a, b, c] = [corner(i, j), corner(i + 1, j), corner(i, j + 1)];
            triangles.push(turned([a, b, c]));
            if i + j + 2 <= k {
                triangles.push(turned([b, corner(i + 1, j + 1), c]));
            }
        }
    }
    triangles
}

fn bumped(p: DVec3) -> Vec3 {
    let p = p.normalize();
    let bumps = (9.0 * p.x).sin() * (8.0 * p.y).cos() + (7.0 * p.z).sin();
    (p * (1.0 + 0.05 * bumps)).as_vec3()
}

/// The k for which a [`bumpy_ball`] has about so many triangles.
#[allow(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "a small positive number"
)]
pub fn cuts_for(triangles: usize) -> u32 {
    (triangles as f64 / 8.0).sqrt().round() as u32
}

/// A ray from near the origin at a corner, or at a point of an edge, of a mesh around it.
pub fn ray_at_the_border(triangles: &[[Vec3; 3]], draws: &mut Draws) -> Ray<Vec3> {
    let corners = triangles[draws.index(triangles.len())];
    let first = draws.index(3);
    let [a, b] = [corners[first], corners[(first + 1) % 3]];
    let along = match draws.index(4) {
        0 => 0.0,
        1 => 0.5,
        2 => 0.25,
        _ => draws.share(),
    };
    let origin = 0.25 * draws.vector();
    Ray::new(origin, a + (b - a) * along - origin)
}
