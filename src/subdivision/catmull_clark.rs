//! One step of Catmull and Clark: every face becomes quadrilaterals, and the limit is a bicubic B-spline where the mesh is regular.
//!
//! ```text
//! face point     the centroid of the face
//! edge point     (Q + R)/2             Q midpoint of the edge, R mean of the two face points beside it
//! vertex point   (Q + 2R + (n−3)S)/n   Q mean of the n face points around S, R mean of the n midpoints
//! ```
//!
//! # Numerics
//!
//! The vertex point is computed as `S + ((Q − S) + 2(R − S))/n`: the same number, but as the vertex and a small difference, so that a mesh
//! far from the origin loses no more than a mesh that is near.
//!
//! # Sources
//!
//! E. Catmull, J. Clark, *Recursively generated B-spline surfaces on arbitrary topological meshes*, 1978.
//!
//! *In the course*: slides 72 to 76 (*schéma de Catmull-Clark*).
//!
//! *In the book*: [Catmull-Clark](../../../subdivision/catmull_clark.html).

use num_traits::One;

use super::boundary::{boundary_vertex_point, mean_offset, midpoint};
use super::connectivity::index_of;
use super::mask::count;
use super::{Connectivity, Corners, Counts, SubdivisionError};
use crate::algebra::VectorSpace;
use crate::mesh::Mesh;

/// The mesh after one step of Catmull-Clark.
///
/// # Shape
///
/// Positions: a vertex point for each of the V old vertices, then an edge point for each of the E edges, then a face point for each face.
/// Faces: quadrilaterals, one for each half-edge h: vertex point of its origin, edge point of h, face point, edge point of the half-edge
/// before h.
///
/// Boundary vertices follow the cubic curve of the boundary, boundary edges their midpoints; vertices without a face stay.
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
/// Linear in the number of half-edges.
///
/// # Examples
///
/// ```
/// use facette::mesh::Mesh;
/// use facette::subdivision::{Connectivity, Corners, catmull_clark};
///
/// let square = Mesh::new(vec![[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]], [[0, 1, 2, 3]])?;
/// let connectivity = Connectivity::new(&square)?;
/// let refined = catmull_clark(&connectivity, &square.positions, Corners::Sharp)?;
/// assert_eq!(refined.faces().next(), Some(&[0, 4, 8, 7][..]));
/// assert_eq!(refined.positions[4], [1.0, 0.0]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn catmull_clark<P: VectorSpace>(
    connectivity: &Connectivity,
    points: &[P],
    corners: Corners,
) -> Result<Mesh<P>, SubdivisionError> {
    connectivity.must_have_points(points.len())?;
    Counts::of(connectivity).after_catmull_clark()?;
    let [vertices, edges, faces, half_edges] = [
        connectivity.vertex_count(),
        connectivity.edge_count(),
        connectivity.face_count(),
        connectivity.half_edge_count(),
    ]
    .map(index_of);
    let face_points: Vec<P> = (0..faces)
        .map(|face| face_point(connectivity, points, face))
        .collect();
    let vertex_points =
        (0..vertices).map(|v| vertex_point(connectivity, points, &face_points, v, corners));
    let edge_points = (0..edges).map(|edge| edge_point(connectivity, points, &face_points, edge));
    let positions = vertex_points
        .chain(edge_points)
        .chain(face_points.iter().copied())
        .collect();
    // ANCHOR: faces
    let new_faces = (0..half_edges).map(|h| {
        let of_edge = |h| vertices + connectivity.edge_of(h);
        [
            connectivity.origin(h),
            of_edge(h),
            vertices + edges + connectivity.face_of(h),
            of_edge(connectivity.previous(h)),
        ]
    });
    // ANCHOR_END: faces
    Ok(Mesh::new(positions, new_faces)?)
}

/// The centroid of a face's vertices.
// ANCHOR: face_point
fn face_point<P: VectorSpace>(connectivity: &Connectivity, points: &[P], face: u32) -> P {
    let vertices = connectivity.vertices_of(face);
    let corners = vertices.iter().map(|&vertex| points[vertex as usize]);
    let base = points[vertices[0] as usize];
    base.plus(mean_offset(base, corners))
}
// ANCHOR_END: face_point

// ANCHOR: edge_point
/// The midpoint of an edge, and half way from there to the mean of the face points beside it.
fn edge_point<P: VectorSpace>(
    connectivity: &Connectivity,
    points: &[P],
    face_points: &[P],
    edge: u32,
) -> P {
    let h = connectivity.half_edge_of(edge);
    let ends = [connectivity.origin(h), connectivity.target(h)];
    let [start, end] = ends.map(|vertex| points[vertex as usize]);
    let q = midpoint(start, end);
    let Some(twin) = connectivity.twin(h) else {
        return q;
    };
    let [left, right] = [h, twin].map(|h| face_points[connectivity.face_of(h) as usize]);
    let r = midpoint(left, right);
    midpoint(q, r)
}
// ANCHOR_END: edge_point

// ANCHOR: vertex_point
/// The mean of face points, midpoints and the old vertex.
fn vertex_point<P: VectorSpace>(
    connectivity: &Connectivity,
    points: &[P],
    face_points: &[P],
    vertex: u32,
    corners: Corners,
) -> P {
    let s = points[vertex as usize];
    if let Some(point) = boundary_vertex_point(connectivity, points, vertex, corners) {
        return point;
    }
    let n = connectivity.valence(vertex);
    if n == 0 {
        return s;
    }
    let around = || connectivity.around(vertex);
    let beside = around().map(|h| face_points[connectivity.face_of(h) as usize]);
    let ends = around().map(|h| points[connectivity.target(h) as usize]);
    let q_offset = mean_offset(s, beside);
    // The midpoint of an edge is half as far away as its other end: this is 2(R − S).
    let twice_r_offset = mean_offset(s, ends);
    let offset = q_offset.plus(twice_r_offset);
    s.plus(offset.times(P::Scalar::one() / count(n)))
}
// ANCHOR_END: vertex_point
