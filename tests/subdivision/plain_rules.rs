//! The rules of the schemes as the slides print them, by a search through the list of faces: no half-edges, no differences.
#![allow(
    dead_code,
    reason = "the tests and the exercises use their part of these"
)]

use facette::algebra::{Scalar, VectorSpace};
use facette::mesh::Mesh;
use facette::subdivision::Corners;
use num_traits::{One, Zero};

/// A mesh whose neighbours are searched for.
pub struct Plain<P> {
    points: Vec<P>,
    faces: Vec<Vec<u32>>,
}

impl<P: VectorSpace> Plain<P> {
    /// The faces and points of a mesh.
    pub fn new(mesh: &Mesh<P>) -> Self {
        Self {
            points: mesh.positions.clone(),
            faces: mesh.faces().map(<[u32]>::to_vec).collect(),
        }
    }

    fn at(&self, vertex: u32) -> P {
        self.points[vertex as usize]
    }

    fn mean_of(&self, vertices: impl IntoIterator<Item = u32>) -> P {
        mean(vertices.into_iter().map(|vertex| self.at(vertex)))
    }

    /// The faces that have an edge between two vertices.
    fn beside(&self, a: u32, b: u32) -> Vec<&Vec<u32>> {
        let has_edge = |face: &&Vec<u32>| {
            let next = |i: usize| face[(i + 1) % face.len()];
            (0..face.len()).any(|i| [face[i], next(i)] == [a, b] || [face[i], next(i)] == [b, a])
        };
        self.faces.iter().filter(has_edge).collect()
    }

    fn around(&self, vertex: u32) -> Vec<&Vec<u32>> {
        let faces = self.faces.iter();
        faces.filter(|face| face.contains(&vertex)).collect()
    }

    /// The vertices with an edge to this one.
    pub fn neighbours(&self, vertex: u32) -> Vec<u32> {
        let vertices = 0..u32::try_from(self.points.len()).expect("a small mesh");
        let is_near = |&other: &u32| !self.beside(vertex, other).is_empty();
        vertices.filter(is_near).collect()
    }

    /// The vertices before and after along the boundary, in no order.
    pub fn boundary_neighbours(&self, vertex: u32) -> Vec<u32> {
        let near = self.neighbours(vertex).into_iter();
        near.filter(|&other| self.beside(vertex, other).len() == 1)
            .collect()
    }

    /// The new place of a vertex that is on the boundary or has no face, by the mask (side, centre, side); `None` elsewhere.
    fn outer_vertex(
        &self,
        vertex: u32,
        corners: Corners,
        [side, centre]: [P::Scalar; 2],
    ) -> Option<P> {
        let (p, faces) = (self.at(vertex), self.around(vertex).len());
        match self.boundary_neighbours(vertex)[..] {
            [] if faces == 0 => Some(p),
            [] => None,
            [_, _] if corners == Corners::Sharp && faces == 1 => Some(p),
            [a, b] => Some(P::combination(
                [side, centre, side],
                [self.at(a), p, self.at(b)],
            )),
            _ => panic!("two boundary edges meet in a boundary vertex"),
        }
    }

    /// The centroid of a face.
    pub fn face_point(&self, face: &[u32]) -> P {
        self.mean_of(face.iter().copied())
    }

    /// Catmull-Clark's point for an edge: the mean of its ends and the face points beside it; the midpoint on a boundary.
    pub fn catmull_clark_edge(&self, [a, b]: [u32; 2]) -> P {
        let ends = [a, b].map(|vertex| self.at(vertex));
        match self.beside(a, b)[..] {
            [f, g] => mean(
                ends.into_iter()
                    .chain([f, g].map(|face| self.face_point(face))),
            ),
            _ => mean(ends),
        }
    }

    /// Catmull-Clark's point for a vertex: (Q + 2R + (n − 3)S)/n.
    pub fn catmull_clark_vertex(&self, vertex: u32, corners: Corners) -> P {
        let cubic = [P::Scalar::ratio(1, 8), P::Scalar::ratio(6, 8)];
        if let Some(point) = self.outer_vertex(vertex, corners, cubic) {
            return point;
        }
        let s = self.at(vertex);
        let faces = self.around(vertex);
        let q = mean(faces.iter().map(|face| self.face_point(face)));
        let midpoints = self.neighbours(vertex).into_iter();
        let r = mean(midpoints.map(|other| self.mean_of([vertex, other])));
        let n = faces.len();
        let [one, two, rest] = [1, 2, small(n) - 3].map(P::Scalar::from_i32);
        P::combination([one, two, rest], [q, r, s]).times(P::Scalar::ratio(1, small(n)))
    }

    /// Loop's point for an edge: 3/8 of its ends, 1/8 of the vertices opposite; the midpoint on a boundary.
    pub fn loop_edge(&self, [a, b]: [u32; 2]) -> P {
        let opposite = |face: &Vec<u32>| {
            let mut vertices = face.iter().copied();
            vertices
                .find(|&vertex| vertex != a && vertex != b)
                .expect("a triangle")
        };
        match self.beside(a, b)[..] {
            [f, g] => {
                let vertices = [a, b, opposite(f), opposite(g)];
                let weights = [3, 3, 1, 1].map(|eighths| P::Scalar::ratio(eighths, 8));
                P::combination(weights, vertices.map(|vertex| self.at(vertex)))
            }
            _ => self.mean_of([a, b]),
        }
    }

    /// Loop's point for a vertex: αV + (1 − α)Q.
    pub fn loop_vertex(
        &self,
        vertex: u32,
        corners: Corners,
        alpha: impl Fn(usize) -> P::Scalar,
    ) -> P {
        let cubic = [P::Scalar::ratio(1, 8), P::Scalar::ratio(6, 8)];
        let inner = || self.towards_the_ring(vertex, |n| P::Scalar::one() - alpha(n));
        self.outer_vertex(vertex, corners, cubic)
            .unwrap_or_else(inner)
    }

    /// √3's point for a vertex: (1 − α)V + αQ; the boundary stays.
    pub fn sqrt3_vertex(&self, vertex: u32, alpha: impl Fn(usize) -> P::Scalar) -> P {
        let stay = [P::Scalar::zero(), P::Scalar::one()];
        let inner = || self.towards_the_ring(vertex, alpha);
        self.outer_vertex(vertex, Corners::Sharp, stay)
            .unwrap_or_else(inner)
    }

    fn towards_the_ring(&self, vertex: u32, weight: impl Fn(usize) -> P::Scalar) -> P {
        let ring = self.neighbours(vertex);
        let weight = weight(ring.len());
        self.at(vertex).lerp(self.mean_of(ring), weight)
    }

    /// Doo-Sabin's point as the slides have it: the mean of a corner, the midpoints of its two sides and the centroid.
    pub fn doo_sabin_corner(&self, face: &[u32], place: usize) -> P {
        let n = face.len();
        let [before, p, after] = [place + n - 1, place, place + 1].map(|i| face[i % n]);
        let sides = [before, after].map(|other| self.mean_of([p, other]));
        mean([self.at(p), sides[0], sides[1], self.face_point(face)])
    }
}

fn small(n: usize) -> i32 {
    i32::try_from(n).expect("a small mesh")
}

/// The mean of some points: their sum over their number.
pub fn mean<P: VectorSpace>(points: impl IntoIterator<Item = P>) -> P {
    let points: Vec<P> = points.into_iter().collect();
    let count = P::Scalar::ratio(1, small(points.len()));
    let sum = points
        .into_iter()
        .reduce(P::plus)
        .expect("at least one point");
    sum.times(count)
}
