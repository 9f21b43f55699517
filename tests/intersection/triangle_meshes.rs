//! Closed meshes, and rays from their inside at edges and corners: the same in every run.

use facette::algebra::{Real, Vector3, VectorSpace};
use facette::ray::Ray;

use crate::common::dice::Dice;
use crate::triangle_inputs::Test;

/// A closed mesh, star-shaped round its centre.
pub struct Ball {
    pub centre: [f64; 3],
    pub positions: Vec<[f64; 3]>,
    pub faces: Vec<[usize; 3]>,
}

impl Ball {
    /// An octahedron cut twice into four, its 66 corners moved at random, of radius about `size`.
    pub fn rough(size: f64, centre: [f64; 3], dice: &mut Dice) -> Self {
        let mut ball = Self::octahedron();
        for _ in 0..2 {
            ball = ball.cut();
        }
        for position in &mut ball.positions {
            let length = position.dot(*position).sqrt();
            let rough = position.times(1.0 / length).plus(dice.vector().times(0.05));
            *position = centre.plus(rough.times(size));
        }
        Self { centre, ..ball }
    }

    /// An octahedron with corners at small integers: rays at them and at its edges meet them exactly.
    pub fn octahedron() -> Self {
        let mut positions = Vec::new();
        for axis in 0..3 {
            for sign in [4.0, -4.0] {
                let mut position = [0.0; 3];
                position[axis] = sign;
                positions.push(position);
            }
        }
        let mut faces = Vec::new();
        for octant in 0..8_usize {
            let [x, y, z] = [octant & 1, 2 + (octant >> 1 & 1), 4 + (octant >> 2)];
            let is_turned = octant.count_ones() % 2 == 1;
            faces.push(if is_turned { [x, z, y] } else { [x, y, z] });
        }
        Self {
            centre: [0.0; 3],
            positions,
            faces,
        }
    }

    /// Every face cut into four at the middles of its edges.
    fn cut(&self) -> Self {
        let mut positions = self.positions.clone();
        let mut middle = |a: usize, b: usize| {
            let point = positions[a].plus(positions[b]).times(0.5);
            let found = positions.iter().position(|&position| position == point);
            found.unwrap_or_else(|| {
                positions.push(point);
                positions.len() - 1
            })
        };
        let mut faces = Vec::new();
        for &[a, b, c] in &self.faces {
            let [ab, bc, ca] = [middle(a, b), middle(b, c), middle(c, a)];
            faces.extend([[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]);
        }
        Self {
            centre: self.centre,
            positions,
            faces,
        }
    }

    pub fn corners<S: Real>(&self, face: usize) -> [[S; 3]; 3] {
        self.faces[face].map(|corner| self.positions[corner].map(S::from_f64))
    }

    /// A ray from near the centre at a corner, or at a point of an edge, of the face that it comes with.
    pub fn ray_at_the_border<S: Real>(&self, size: f64, dice: &mut Dice) -> (usize, Ray<[S; 3]>) {
        let face = dice.index(self.faces.len());
        let [a, b, _] = self.corners::<S>(face);
        let along = match dice.index(4) {
            0 => 0.0,
            1 => dice.roll().midpoint(1.0),
            2 => 0.5,
            _ => 0.25,
        };
        let target = a.plus(b.minus(a).times(S::from_f64(along)));
        let origin = self
            .centre
            .plus(dice.vector().times(0.25 * size))
            .map(S::from_f64);
        (face, Ray::new(origin, target.minus(origin)))
    }

    /// Whether the ray meets a face, `first` being asked before the others.
    pub fn stops<S: Real>(&self, first: usize, ray: &Ray<[S; 3]>, test: Test<[S; 3], S>) -> bool {
        let count = self.faces.len();
        (0..count).any(|step| test(&self.corners((first + step) % count), ray).is_some())
    }
}
