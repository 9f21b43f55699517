//! One step of Kobbelt's √3 scheme: a point in every triangle, every old edge flipped; two steps divide each edge by three.
//!
//! ```text
//! new point      the centroid of a triangle
//! vertex point   (1 − αₙ) v + αₙ q      q mean of the n neighbours, αₙ = (4 − 2cos(2π/n))/9
//! ```
//!
//! The old vertices move: the scheme approximates, it does not interpolate.
//!
//! # Numerics
//!
//! The vertex point is computed as `v + α(q − v)`: the weights sum to 1 whatever α was rounded to.
//!
//! # Sources
//!
//! L. Kobbelt, *√3-subdivision*, 2000; section 5 for the boundary.
//!
//! *In the course*: slide 79 (*schéma √3 de Kobbelt*).
//!
//! *In the book*: [Triangles](../../../subdivision/triangles.html).

use super::boundary::mean_offset;
use super::connectivity::index_of;
use super::mask::{sqrt3_neighbours_weight, turn_cosine};
use super::{Connectivity, Corners, Counts, SubdivisionError};
use crate::algebra::{Real, Scalar, VectorSpace};
use crate::mesh::Mesh;

/// What a step of √3 does at the boundary, whose edges have no second triangle to flip into.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sqrt3Boundary {
    /// The first, third, fifth, ... step: boundary edges and vertices stay.
    Kept,
    /// The second, fourth, ... step: boundary edges are divided by three.
    Trisected,
}

impl Sqrt3Boundary {
    /// What is done in step number `step`, counted from 0.
    pub fn in_step(step: u32) -> Self {
        if step.is_multiple_of(2) {
            Self::Kept
        } else {
            Self::Trisected
        }
    }
}

/// The mesh after one step of √3.
///
/// # Shape
///
/// Positions: the V old vertices, moved; then the centroids of the faces, in order. Where the boundary is trisected, a face with exactly one
/// boundary edge gets no centroid, and two points for each boundary edge follow, in the order of the edges: a third of the way from its
/// start, and a third from its end.
///
/// Faces: one for each half-edge h: its origin, the new point right of it, the new point left of it. For a boundary edge it is the triangle
/// that remains of the face: origin, target and centroid, or its two new points and the vertex opposite. (A face with two boundary edges or
/// three, which no step that keeps the boundary leaves, has its two outer pieces of each at the end of the list.)
///
/// Trisection is the ternary rule of the cubic B-spline: (4, 19, 4)/27 for vertices, (1, 16, 10)/27 for new points. With sharp corners, a
/// vertex with a single face stays: in a step that trisects one with two, since the step before gave it a second. Vertices without a face
/// stay.
///
/// # Errors
///
/// [`SubdivisionError::NotATriangle`]; [`SubdivisionError::PointCount`]; [`SubdivisionError::TooLarge`] beyond 32-bit numbers;
/// [`SubdivisionError::Mesh`] where a coordinate becomes infinite, as differences of coordinates beyond half the largest number may.
///
/// # Accuracy
///
/// Few units in the last place of the largest coordinate, at any distance from the origin (tested as `far_away_steps_lose_few_ulps`).
///
/// # Cost
///
/// Linear in the number of half-edges.
///
/// # Examples
///
/// ```
/// use facette::mesh::Mesh;
/// use facette::subdivision::{Connectivity, Corners, Sqrt3Boundary, sqrt3};
///
/// let triangle = Mesh::new(vec![[0.0, 0.0], [3.0, 0.0], [0.0, 3.0]], [[0, 1, 2]])?;
/// let mut refined = triangle;
/// for step in 0..2 {
///     let connectivity = Connectivity::new(&refined)?;
///     let boundary = Sqrt3Boundary::in_step(step);
///     refined = sqrt3(&connectivity, &refined.positions, boundary, Corners::Sharp)?;
/// }
/// assert_eq!(refined.face_count(), 9);
/// assert_eq!(refined.positions[4..6], [[1.0, 0.0], [2.0, 0.0]]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn sqrt3<P: VectorSpace>(
    connectivity: &Connectivity,
    points: &[P],
    boundary: Sqrt3Boundary,
    corners: Corners,
) -> Result<Mesh<P>, SubdivisionError>
where
    P::Scalar: Real,
{
    let weight = |n| sqrt3_neighbours_weight(turn_cosine(1, n));
    sqrt3_with(connectivity, points, boundary, corners, weight)
}

/// [`sqrt3`] with the weight α of the neighbours' mean given as a function of the valence: for exact weights.
///
/// # Errors
///
/// Those of [`sqrt3`].
pub fn sqrt3_with<P: VectorSpace>(
    connectivity: &Connectivity,
    points: &[P],
    boundary: Sqrt3Boundary,
    corners: Corners,
    neighbours_weight: impl Fn(usize) -> P::Scalar,
) -> Result<Mesh<P>, SubdivisionError> {
    connectivity.must_be_triangles()?;
    connectivity.must_have_points(points.len())?;
    Counts::of(connectivity).after_sqrt3(boundary)?;
    let moved = (0..index_of(connectivity.vertex_count())).map(|vertex| {
        outer_vertex_point(connectivity, points, vertex, boundary, corners)
            .unwrap_or_else(|| inner_vertex_point(connectivity, points, vertex, &neighbours_weight))
    });
    let new_points = NewPoints::new(connectivity, boundary);
    let positions = moved.chain(new_points.positions(points, corners)).collect();
    let of_half_edges = (0..index_of(connectivity.half_edge_count())).map(|h| new_points.face(h));
    let faces = of_half_edges.chain(new_points.outer_pieces());
    Ok(Mesh::new(positions, faces)?)
}

// ANCHOR: vertex_point
/// (1 − α) v + α q, as a step from v towards q; a vertex without a face stays.
fn inner_vertex_point<P: VectorSpace>(
    connectivity: &Connectivity,
    points: &[P],
    vertex: u32,
    neighbours_weight: &impl Fn(usize) -> P::Scalar,
) -> P {
    let v = points[vertex as usize];
    let n = connectivity.valence(vertex);
    if n == 0 {
        return v;
    }
    let neighbours = connectivity.around(vertex);
    let ring = neighbours.map(|h| points[connectivity.target(h) as usize]);
    v.plus(mean_offset(v, ring).times(neighbours_weight(n)))
}
// ANCHOR_END: vertex_point

/// The new position of a vertex on the boundary, by the mask (4, 19, 4)/27 where that is trisected; `None` for other vertices.
fn outer_vertex_point<P: VectorSpace>(
    connectivity: &Connectivity,
    points: &[P],
    vertex: u32,
    boundary: Sqrt3Boundary,
    corners: Corners,
) -> Option<P> {
    let [before, after] = connectivity.boundary_neighbours(vertex)?;
    let [a, p, b] = [before, vertex, after].map(|vertex| points[vertex as usize]);
    if boundary == Sqrt3Boundary::Kept || is_sharp(connectivity, vertex, corners) {
        return Some(p);
    }
    let offset = a.minus(p).plus(b.minus(p));
    Some(p.plus(offset.times(P::Scalar::ratio(4, 27))))
}

/// Whether a vertex stays in a step that trisects the boundary.
fn is_sharp(connectivity: &Connectivity, vertex: u32, corners: Corners) -> bool {
    corners == Corners::Sharp && connectivity.is_corner(vertex, 2)
}

/// Which new points there are, and their numbers.
struct NewPoints<'a> {
    connectivity: &'a Connectivity,
    /// The faces that get a centroid, ascending.
    with_centroid: Vec<u32>,
    /// The edges that are trisected, ascending.
    trisected: Vec<u32>,
}

impl<'a> NewPoints<'a> {
    fn new(connectivity: &'a Connectivity, boundary: Sqrt3Boundary) -> Self {
        let is_trisected =
            |edge| boundary == Sqrt3Boundary::Trisected && connectivity.is_boundary_edge(edge);
        let has_centroid = |&face: &u32| {
            let edges = connectivity
                .half_edges_of(face)
                .map(|h| connectivity.edge_of(h));
            edges.filter(|&edge| is_trisected(edge)).count() != 1
        };
        let faces = 0..index_of(connectivity.face_count());
        let edges = 0..index_of(connectivity.edge_count());
        Self {
            connectivity,
            with_centroid: faces.filter(has_centroid).collect(),
            trisected: edges.filter(|&edge| is_trisected(edge)).collect(),
        }
    }

    /// The positions of the new points, in the order of their numbers.
    fn positions<P: VectorSpace>(&self, points: &[P], corners: Corners) -> Vec<P> {
        let centroids = self.with_centroid.iter().map(|&face| {
            let vertices = self.connectivity.vertices_of(face);
            let [a, b, c] = [0, 1, 2].map(|i| points[vertices[i] as usize]);
            a.plus(mean_offset(a, [a, b, c].into_iter()))
        });
        let on_boundary = self.trisected.iter().flat_map(|&edge| {
            let h = self.connectivity.half_edge_of(edge);
            let [a, b] = [self.connectivity.origin(h), self.connectivity.target(h)];
            [[a, b], [b, a]].map(|[from, to]| self.third_point(points, from, to, corners))
        });
        centroids.chain(on_boundary).collect()
    }

    /// The point on a boundary edge a third of the way from one end, by the mask (1, 16, 10)/27.
    fn third_point<P: VectorSpace>(&self, points: &[P], from: u32, to: u32, corners: Corners) -> P {
        let at = |vertex: u32| points[vertex as usize];
        let (p, ahead) = (at(from), at(to).minus(at(from)));
        let neighbours = self.connectivity.boundary_neighbours(from);
        let behind = neighbours.into_iter().flatten().find(|&v| v != to);
        match behind.filter(|_| !is_sharp(self.connectivity, from, corners)) {
            Some(behind) => {
                let ten = P::Scalar::from_i32(10);
                let offset = ahead.times(ten).plus(at(behind).minus(p));
                p.plus(offset.times(P::Scalar::ratio(1, 27)))
            }
            None => p.plus(ahead.times(P::Scalar::ratio(1, 3))),
        }
    }

    /// The number of the new point on the left of a half-edge, which its edge is flipped to.
    fn beside(&self, half_edge: u32) -> u32 {
        let face = self.connectivity.face_of(half_edge);
        if let Some(centroid) = self.centroid(face) {
            return centroid;
        }
        let [next, previous] = [
            self.connectivity.next(half_edge),
            self.connectivity.previous(half_edge),
        ]
        .map(|h| self.on_edge(self.connectivity.edge_of(h)));
        let near_target = next.map(|points| points[0]);
        let near_origin = previous.map(|points| points[1]);
        near_target
            .or(near_origin)
            .expect("a face without a centroid has one trisected edge, and it is not flipped")
    }

    fn centroid(&self, face: u32) -> Option<u32> {
        let place = self.with_centroid.binary_search(&face).ok()?;
        Some(index_of(self.connectivity.vertex_count() + place))
    }

    fn on_edge(&self, edge: u32) -> Option<[u32; 2]> {
        let place = self.trisected.binary_search(&edge).ok()?;
        let before = self.connectivity.vertex_count() + self.with_centroid.len();
        let first = index_of(before + 2 * place);
        Some([first, first + 1])
    }

    /// The face that a half-edge leads to.
    // ANCHOR: flip
    fn face(&self, half_edge: u32) -> [u32; 3] {
        let origin = self.connectivity.origin(half_edge);
        if let Some(twin) = self.connectivity.twin(half_edge) {
            return [origin, self.beside(twin), self.beside(half_edge)];
        }
        let face = self.connectivity.face_of(half_edge);
        let opposite = self
            .connectivity
            .origin(self.connectivity.previous(half_edge));
        let apex = self.centroid(face).unwrap_or(opposite);
        match self.on_edge(self.connectivity.edge_of(half_edge)) {
            Some([near_origin, near_target]) => [near_origin, near_target, apex],
            None => [origin, self.connectivity.target(half_edge), apex],
        }
    }
    // ANCHOR_END: flip

    /// The outer pieces of the faces with more than one trisected edge.
    fn outer_pieces(&self) -> impl Iterator<Item = [u32; 3]> {
        self.trisected.iter().flat_map(|&edge| {
            let h = self.connectivity.half_edge_of(edge);
            let pair = self
                .on_edge(edge)
                .zip(self.centroid(self.connectivity.face_of(h)));
            let pieces = pair.map(|([near_origin, near_target], centroid)| {
                [
                    [self.connectivity.origin(h), near_origin, centroid],
                    [near_target, self.connectivity.target(h), centroid],
                ]
            });
            pieces.into_iter().flatten()
        })
    }
}
