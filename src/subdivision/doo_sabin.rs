//! One step of Doo and Sabin: every face shrinks, edges and vertices become faces, and the limit is a biquadratic B-spline where the mesh is
//! regular.
//!
//! ```text
//! in a face p₀ … pₙ₋₁:   p'ᵢ = Σⱼ w(j − i) pⱼ
//!
//! averaging (slides)     p'ᵢ = (pᵢ + (pᵢ₋₁ + pᵢ)/2 + (pᵢ + pᵢ₊₁)/2 + centroid)/4
//! Doo's and Sabin's own  w(0) = (n + 5)/4n,   w(k) = (3 + 2cos(2πk/n))/4n
//! ```
//!
//! For n = 4 both are (9, 3, 1, 3)/16.
//!
//! # Numerics
//!
//! The sum is computed as `pᵢ + Σ w(j − i)(pⱼ − pᵢ)`: the weights sum to 1 whatever they were rounded to.
//!
//! # Sources
//!
//! D. Doo, M. Sabin, *Behaviour of recursive division surfaces near extraordinary points*, 1978. The boundary is that of the biquadratic
//! B-spline with doubled control points at its ends.
//!
//! *In the course*: slides 64 to 71 (*schéma de Doo-Sabin*).
//!
//! *In the book*: [Doo-Sabin](../../../subdivision/doo_sabin.html).

use super::connectivity::index_of;
use super::mask::{averaging_weight, doo_sabin_weight, turn_cosine};
use super::{Connectivity, Corners, Counts, DooSabinWeights, SubdivisionError};
use crate::algebra::{Real, Scalar, VectorSpace};
use crate::mesh::Mesh;

/// The mesh after one step of Doo-Sabin.
///
/// # Shape
///
/// Positions: a point for each corner of each face, with the number of its half-edge; then two for each boundary edge, in the order of the
/// edges: a quarter of the edge from its start, and a quarter from its end; then, with sharp corners, the boundary vertices with a single
/// face, in order.
///
/// Faces: first each old face, shrunken. Then for each edge a quadrilateral, which begins with the corner point of the edge's first
/// half-edge; at the boundary its other side is the two boundary points. Then for each vertex the corner points around it, anticlockwise;
/// at the boundary they are followed by the boundary point before the vertex, the vertex itself if it is a sharp corner, and the boundary
/// point after it. Vertices without a face vanish, and an inner vertex where only two faces meet leaves no face: the quadrilaterals of its
/// two edges are joined.
///
/// # Errors
///
/// [`SubdivisionError::PointCount`]; [`SubdivisionError::TooLarge`] beyond 32-bit numbers; [`SubdivisionError::Mesh`] where a coordinate
/// becomes infinite, as differences of coordinates beyond half the largest number may.
///
/// # Accuracy
///
/// Few units in the last place of the largest coordinate, at any distance from the origin (tested as `far_away_steps_lose_few_ulps`).
///
/// # Cost
///
/// The sum of the squares of the faces' numbers of corners.
///
/// # Examples
///
/// ```
/// use facette::mesh::Mesh;
/// use facette::subdivision::{Connectivity, Corners, DooSabinWeights, doo_sabin};
///
/// let square = Mesh::new(vec![[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]], [[0, 1, 2, 3]])?;
/// let connectivity = Connectivity::new(&square)?;
/// let refined = doo_sabin(&connectivity, &square.positions, DooSabinWeights::Own, Corners::Sharp)?;
/// assert_eq!(refined.positions[..2], [[1.0, 1.0], [3.0, 1.0]]);
/// assert_eq!(refined.face_count(), 1 + 4 + 4);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn doo_sabin<P: VectorSpace>(
    connectivity: &Connectivity,
    points: &[P],
    weights: DooSabinWeights,
    corners: Corners,
) -> Result<Mesh<P>, SubdivisionError>
where
    P::Scalar: Real,
{
    let weight = |n, steps| match weights {
        DooSabinWeights::Own => doo_sabin_weight(n, steps, turn_cosine(steps, n)),
        DooSabinWeights::Averaging => averaging_weight(n, steps),
    };
    doo_sabin_with(connectivity, points, corners, weight)
}

/// [`doo_sabin`] with the weights given as a function: `weight(n, steps)` is that of the corner `steps` corners further, from 1 to n − 1, in
/// a face of n corners. What they leave of 1 is the corner's own.
///
/// # Errors
///
/// Those of [`doo_sabin`].
pub fn doo_sabin_with<P: VectorSpace>(
    connectivity: &Connectivity,
    points: &[P],
    corners: Corners,
    weight: impl Fn(usize, usize) -> P::Scalar,
) -> Result<Mesh<P>, SubdivisionError> {
    connectivity.must_have_points(points.len())?;
    Counts::of(connectivity).after_doo_sabin(corners)?;
    let boundary = Boundary::new(connectivity, corners);
    let positions = boundary.all_points(connectivity, points, weight);
    // ANCHOR: faces
    let faces = (0..index_of(connectivity.face_count()))
        .map(|face| connectivity.half_edges_of(face).collect::<Vec<_>>());
    let of_edges = (0..index_of(connectivity.edge_count())).map(|edge| {
        let h = connectivity.half_edge_of(edge);
        let [beside_start, beside_end] = match connectivity.twin(h) {
            Some(twin) => [connectivity.next(twin), twin],
            None => boundary.points_of(edge),
        };
        vec![h, beside_start, beside_end, connectivity.next(h)]
    });
    let of_vertices = (0..index_of(connectivity.vertex_count()))
        .map(|vertex| {
            let mut around: Vec<u32> = connectivity.around(vertex).collect();
            boundary.close(connectivity, vertex, &mut around);
            around
        })
        .filter(|around| around.len() > 2);
    // ANCHOR_END: faces
    let new_faces = faces.chain(of_edges).chain(of_vertices);
    Ok(Mesh::new(positions, new_faces)?)
}

/// The points of [`doo_sabin_with`] alone, for one who has the faces.
pub(super) fn doo_sabin_points<P: VectorSpace>(
    connectivity: &Connectivity,
    points: &[P],
    corners: Corners,
    weight: impl Fn(usize, usize) -> P::Scalar,
) -> Vec<P> {
    Boundary::new(connectivity, corners).all_points(connectivity, points, weight)
}

// ANCHOR: corner_points
/// The corners of all faces, each moved towards the inside of its face.
fn corner_points<P: VectorSpace>(
    connectivity: &Connectivity,
    points: &[P],
    weight: impl Fn(usize, usize) -> P::Scalar,
) -> Vec<P> {
    let mut shrunken = Vec::with_capacity(connectivity.half_edge_count());
    let mut weights = Vec::new();
    for face in 0..index_of(connectivity.face_count()) {
        let vertices = connectivity.vertices_of(face);
        let n = vertices.len();
        if weights.len() + 1 != n {
            weights = (1..n).map(|steps| weight(n, steps)).collect();
        }
        for (i, &vertex) in vertices.iter().enumerate() {
            let p = points[vertex as usize];
            let others = vertices.iter().cycle().skip(i + 1);
            let terms = weights.iter().zip(others);
            let offset = terms.fold(P::origin(), |sum, (&w, &other)| {
                sum.plus(points[other as usize].minus(p).times(w))
            });
            shrunken.push(p.plus(offset));
        }
    }
    shrunken
}
// ANCHOR_END: corner_points

/// Where the points along the boundary are numbered.
struct Boundary {
    /// The boundary edges, ascending, and the number of the first one's first point.
    edges: Vec<u32>,
    first: u32,
    /// The vertices that stay, ascending.
    sharp: Vec<u32>,
}

impl Boundary {
    fn new(connectivity: &Connectivity, corners: Corners) -> Self {
        let edges = 0..index_of(connectivity.edge_count());
        let vertices = 0..index_of(connectivity.vertex_count());
        let is_sharp =
            |&vertex: &u32| corners == Corners::Sharp && connectivity.is_corner(vertex, 1);
        Self {
            edges: edges
                .filter(|&edge| connectivity.is_boundary_edge(edge))
                .collect(),
            first: index_of(connectivity.half_edge_count()),
            sharp: vertices.filter(is_sharp).collect(),
        }
    }

    /// The corner points of all faces, then those along the boundary.
    fn all_points<P: VectorSpace>(
        &self,
        connectivity: &Connectivity,
        points: &[P],
        weight: impl Fn(usize, usize) -> P::Scalar,
    ) -> Vec<P> {
        let mut positions = corner_points(connectivity, points, weight);
        positions.extend(self.points(connectivity, points));
        positions
    }

    /// Chaikin's points along the boundary, then the corners.
    fn points<P: VectorSpace>(&self, connectivity: &Connectivity, points: &[P]) -> Vec<P> {
        let quarter = P::Scalar::ratio(1, 4);
        let on_edges = self.edges.iter().flat_map(|&edge| {
            let h = connectivity.half_edge_of(edge);
            let ends = [connectivity.origin(h), connectivity.target(h)];
            let [a, b] = ends.map(|vertex| points[vertex as usize]);
            [a.lerp(b, quarter), b.lerp(a, quarter)]
        });
        let corners = self.sharp.iter().map(|&vertex| points[vertex as usize]);
        on_edges.chain(corners).collect()
    }

    /// The numbers of the two points on a boundary edge.
    fn points_of(&self, edge: u32) -> [u32; 2] {
        let place = self.edges.partition_point(|&other| other < edge);
        let first = self.first + 2 * index_of(place);
        [first, first + 1]
    }

    /// Closes the fan of corner points around a boundary vertex.
    fn close(&self, connectivity: &Connectivity, vertex: u32, around: &mut Vec<u32>) {
        if !connectivity.is_boundary_vertex(vertex) {
            return;
        }
        let leaving = connectivity.edge_of(around[0]);
        let arriving = connectivity.edge_of(connectivity.previous(around[around.len() - 1]));
        around.push(self.points_of(arriving)[1]);
        if let Ok(place) = self.sharp.binary_search(&vertex) {
            around.push(self.first + index_of(2 * self.edges.len() + place));
        }
        around.push(self.points_of(leaving)[0]);
    }
}
