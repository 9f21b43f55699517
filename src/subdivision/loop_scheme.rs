//! One step of Loop's scheme: every triangle becomes four, and the limit is a quartic box spline where the mesh is regular.
//!
//! ```text
//! edge point     3/8 (a + b) + 1/8 (c + d)    a, b the ends; c, d the vertices opposite to the edge
//! vertex point   αₙ v + (1 − αₙ) q            q mean of the n neighbours, αₙ = (3/8 + cos(2π/n)/4)² + 3/8
//! ```
//!
//! # Numerics
//!
//! The vertex point is computed as `v + (1 − α)(q − v)`: the weights sum to 1 whatever α was rounded to, so the mesh does not drift when it
//! is moved far away.
//!
//! # Sources
//!
//! C. Loop, *Smooth subdivision surfaces based on triangles*, 1987.
//!
//! *In the course*: slides 77 and 78 (*schéma de Loop*); the cosine printed there is wrong.
//!
//! *In the book*: [Triangles](../../../subdivision/triangles.html).

use num_traits::One;

use super::boundary::{boundary_vertex_point, mean_offset, midpoint};
use super::connectivity::index_of;
use super::mask::{loop_vertex_weight, turn_cosine};
use super::{Connectivity, Corners, Counts, SubdivisionError};
use crate::algebra::{Real, Scalar, VectorSpace};
use crate::mesh::Mesh;

/// The mesh after one step of Loop's scheme.
///
/// # Shape
///
/// Positions: a vertex point for each of the V old vertices, then an edge point for each edge. Faces: four for each old face f, of which 4f,
/// 4f + 1 and 4f + 2 are at its corners, in order, and begin with the corner; 4f + 3 is the middle one and begins with the edge point after
/// the first corner.
///
/// Boundary vertices follow the cubic curve of the boundary, boundary edges their midpoints; vertices without a face stay.
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
/// use facette::subdivision::{Connectivity, Corners, loop_subdivision};
///
/// let triangle = Mesh::new(vec![[0.0, 0.0], [2.0, 0.0], [0.0, 2.0]], [[0, 1, 2]])?;
/// let connectivity = Connectivity::new(&triangle)?;
/// let refined = loop_subdivision(&connectivity, &triangle.positions, Corners::Sharp)?;
/// assert_eq!(refined.faces().last(), Some(&[3, 4, 5][..]));
/// assert_eq!(refined.positions[4], [1.0, 1.0]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn loop_subdivision<P: VectorSpace>(
    connectivity: &Connectivity,
    points: &[P],
    corners: Corners,
) -> Result<Mesh<P>, SubdivisionError>
where
    P::Scalar: Real,
{
    let vertex_weight = |n| loop_vertex_weight(turn_cosine(1, n));
    loop_subdivision_with(connectivity, points, corners, vertex_weight)
}

/// [`loop_subdivision`] with the weight α of an inner vertex given as a function of its valence: for other weights, and for exact ones.
///
/// # Errors
///
/// Those of [`loop_subdivision`].
pub fn loop_subdivision_with<P: VectorSpace>(
    connectivity: &Connectivity,
    points: &[P],
    corners: Corners,
    vertex_weight: impl Fn(usize) -> P::Scalar,
) -> Result<Mesh<P>, SubdivisionError> {
    connectivity.must_be_triangles()?;
    connectivity.must_have_points(points.len())?;
    Counts::of(connectivity).after_loop()?;
    let [vertices, edges, faces] = [
        connectivity.vertex_count(),
        connectivity.edge_count(),
        connectivity.face_count(),
    ]
    .map(index_of);
    let vertex_points =
        (0..vertices).map(|v| vertex_point(connectivity, points, v, corners, &vertex_weight));
    let edge_points = (0..edges).map(|edge| edge_point(connectivity, points, edge));
    let positions = vertex_points.chain(edge_points).collect();
    // ANCHOR: faces
    let new_faces = (0..faces).flat_map(|face| {
        let corner = connectivity.half_edges_of(face).start;
        let [a, b, c] = [0, 1, 2].map(|i| connectivity.origin(corner + i));
        let [ab, bc, ca] = [0, 1, 2].map(|i| vertices + connectivity.edge_of(corner + i));
        [[a, ab, ca], [b, bc, ab], [c, ca, bc], [ab, bc, ca]]
    });
    // ANCHOR_END: faces
    Ok(Mesh::new(positions, new_faces)?)
}

// ANCHOR: edge_point
/// The midpoint of an edge, and a quarter of the way from there to the midpoint of the two vertices opposite to it.
fn edge_point<P: VectorSpace>(connectivity: &Connectivity, points: &[P], edge: u32) -> P {
    let h = connectivity.half_edge_of(edge);
    let start_of = |h| points[connectivity.origin(h) as usize];
    let opposite = |h| start_of(connectivity.previous(h));
    let middle = midpoint(start_of(h), start_of(connectivity.next(h)));
    connectivity.twin(h).map_or(middle, |twin| {
        let beside = midpoint(opposite(h), opposite(twin));
        middle.lerp(beside, P::Scalar::ratio(1, 4))
    })
}
// ANCHOR_END: edge_point

// ANCHOR: vertex_point
/// α v + (1 − α) q, as a step from v towards q.
fn vertex_point<P: VectorSpace>(
    connectivity: &Connectivity,
    points: &[P],
    vertex: u32,
    corners: Corners,
    vertex_weight: &impl Fn(usize) -> P::Scalar,
) -> P {
    let v = points[vertex as usize];
    if let Some(point) = boundary_vertex_point(connectivity, points, vertex, corners) {
        return point;
    }
    let n = connectivity.valence(vertex);
    if n == 0 {
        return v;
    }
    let neighbours = connectivity.around(vertex);
    let ring = neighbours.map(|h| points[connectivity.target(h) as usize]);
    let alpha = vertex_weight(n);
    v.plus(mean_offset(v, ring).times(P::Scalar::one() - alpha))
}
// ANCHOR_END: vertex_point
