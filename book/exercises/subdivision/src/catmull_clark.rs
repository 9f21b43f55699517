//! Exercise 4: a step of Catmull-Clark.
//!
//! Replace each `todo!(...)` by your code, save, and run `cargo exercise subdivision/catmull_clark`.

use crate::algebra::{Scalar, VectorSpace};
use crate::mesh::Mesh;
use crate::subdivision::{Connectivity, Corners, SubdivisionError};

/// The face point of a face: the centroid of its vertices.
///
/// What you can use:
///
/// ```text
/// connectivity.vertices_of(face)    the vertices of a face, a list of numbers
/// points[vertex as usize]           the point of a vertex
/// P::origin()                       the point 0, to begin a sum with
/// p.plus(q), p.times(t)             the sum of two points, a multiple of one
/// P::Scalar::ratio(1, 4)            the fraction 1/4; so also ratio(1, count as i32)
/// ```
fn face_point<P: VectorSpace>(connectivity: &Connectivity, points: &[P], face: u32) -> P {
    todo!("face_point: the mean of the face's vertices")
}

/// The edge point of an edge: (Q + R)/2, with the midpoint Q of the edge and the mean R of the two face points beside it; on the boundary Q.
///
/// What you can use, besides:
///
/// ```text
/// connectivity.half_edge_of(edge)   h, one of the half-edges along the edge
/// connectivity.origin(h)            the vertex where a half-edge begins; .target(h): where it ends
/// connectivity.twin(h)              Some(the half-edge on the other side), or None on the boundary
/// connectivity.face_of(h)           the face of a half-edge
/// p.lerp(q, t)                      the point (1-t) p + t q
/// ```
fn edge_point<P: VectorSpace>(
    connectivity: &Connectivity,
    points: &[P],
    face_points: &[P],
    edge: u32,
) -> P {
    let h = connectivity.half_edge_of(edge);

    todo!("edge_point: (Q + R)/2, or Q on the boundary")
}

/// The new place of a vertex S:
///
/// ```text
/// inside the mesh        (Q + 2R + (n-3) S)/n   n edges; Q: mean of the face points around S, R: mean of the midpoints of its edges
/// on the boundary        (A + 6 S + B)/8        A, B: the vertices before and after S on the boundary
/// on it, in one face     S                      if corners == Corners::Sharp
/// without a face         S
/// ```
///
/// What you can use, besides:
///
/// ```text
/// connectivity.outgoing(vertex)               None for a vertex without a face
/// connectivity.boundary_neighbours(vertex)    Some([before, after]), or None for a vertex that is not on the boundary
/// connectivity.around(vertex)                 the half-edges that leave a vertex, one for each of its faces; .count() is how many
/// connectivity.valence(vertex)                n, how many edges it has
/// P::combination([a, b, c], [p, q, r])        the point a p + b q + c r
/// ```
fn vertex_point<P: VectorSpace>(
    connectivity: &Connectivity,
    points: &[P],
    face_points: &[P],
    vertex: u32,
    corners: Corners,
) -> P {
    let s = points[vertex as usize];

    todo!("vertex_point: where the vertex goes")
}

/// The mesh after one step: your points, and the faces between them. You need not change this.
pub fn catmull_clark<P: VectorSpace>(
    connectivity: &Connectivity,
    points: &[P],
    corners: Corners,
) -> Result<Mesh<P>, SubdivisionError> {
    connectivity.must_have_points(points.len())?;
    let vertices = connectivity.vertex_count() as u32;
    let edges = connectivity.edge_count() as u32;
    let faces = connectivity.face_count() as u32;
    let face_points: Vec<P> = (0..faces)
        .map(|face| face_point(connectivity, points, face))
        .collect();
    let mut positions = Vec::new();
    for vertex in 0..vertices {
        positions.push(vertex_point(connectivity, points, &face_points, vertex, corners));
    }
    for edge in 0..edges {
        positions.push(edge_point(connectivity, points, &face_points, edge));
    }
    positions.extend(&face_points);
    let new_faces = (0..connectivity.half_edge_count() as u32).map(|h| {
        [
            connectivity.origin(h),
            vertices + connectivity.edge_of(h),
            vertices + edges + connectivity.face_of(h),
            vertices + connectivity.edge_of(connectivity.previous(h)),
        ]
    });
    Ok(Mesh::new(positions, new_faces)?)
}
