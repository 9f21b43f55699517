//! A solution of exercise 4: a step of Catmull-Clark.

use crate::algebra::{Scalar, VectorSpace};
use crate::mesh::Mesh;
use crate::subdivision::{Connectivity, Corners, SubdivisionError};

/// The face point of a face: the centroid of its vertices.
fn face_point<P: VectorSpace>(connectivity: &Connectivity, points: &[P], face: u32) -> P {
    let vertices = connectivity.vertices_of(face);
    let mut sum = P::origin();
    for &vertex in vertices {
        sum = sum.plus(points[vertex as usize]);
    }
    sum.times(P::Scalar::ratio(1, vertices.len() as i32))
}

/// The edge point of an edge: (Q + R)/2, with the midpoint Q of the edge and the mean R of the two face points beside it; on the boundary Q.
fn edge_point<P: VectorSpace>(
    connectivity: &Connectivity,
    points: &[P],
    face_points: &[P],
    edge: u32,
) -> P {
    let h = connectivity.half_edge_of(edge);

    let half = P::Scalar::ratio(1, 2);
    let [a, b] = [connectivity.origin(h), connectivity.target(h)];
    let q = points[a as usize].lerp(points[b as usize], half);
    match connectivity.twin(h) {
        None => q,
        Some(twin) => {
            let [left, right] = [h, twin].map(|h| connectivity.face_of(h) as usize);
            q.lerp(face_points[left].lerp(face_points[right], half), half)
        }
    }
}

/// The new place of a vertex S:
///
/// ```text
/// inside the mesh        (Q + 2R + (n-3) S)/n   n edges; Q: mean of the face points around S, R: mean of the midpoints of its edges
/// on the boundary        (A + 6 S + B)/8        A, B: the vertices before and after S on the boundary
/// on it, in one face     S                      if corners == Corners::Sharp
/// without a face         S
/// ```
fn vertex_point<P: VectorSpace>(
    connectivity: &Connectivity,
    points: &[P],
    face_points: &[P],
    vertex: u32,
    corners: Corners,
) -> P {
    let s = points[vertex as usize];

    if connectivity.outgoing(vertex).is_none() {
        return s;
    }
    if let Some([before, after]) = connectivity.boundary_neighbours(vertex) {
        if corners == Corners::Sharp && connectivity.around(vertex).count() == 1 {
            return s;
        }
        let eighths = [1, 6, 1].map(|weight| P::Scalar::ratio(weight, 8));
        return P::combination(eighths, [points[before as usize], s, points[after as usize]]);
    }
    let n = connectivity.valence(vertex) as i32;
    let [mut q, mut r] = [P::origin(); 2];
    for h in connectivity.around(vertex) {
        let part = P::Scalar::ratio(1, n);
        let end = points[connectivity.target(h) as usize];
        q = q.plus(face_points[connectivity.face_of(h) as usize].times(part));
        r = r.plus(s.lerp(end, P::Scalar::ratio(1, 2)).times(part));
    }
    let weights = [1, 2, n - 3].map(|weight| P::Scalar::ratio(weight, n));
    P::combination(weights, [q, r, s])
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
