//! A solution of exercise 5: a step of Loop's scheme.

use crate::algebra::{Real, Scalar, VectorSpace};
use crate::mesh::Mesh;
use crate::subdivision::mask::turn_cosine;
use crate::subdivision::{Connectivity, Corners, SubdivisionError};

/// Loop's weight of a vertex with n neighbours in its own new place: (3/8 + cos(2π/n)/4)² + 3/8.
///
/// `turn_cosine::<S>(k, n)` is cos(2πk/n), and `S::ratio(3, 8)` the fraction 3/8.
fn vertex_weight<S: Real>(n: usize) -> S {
    let inner = S::ratio(3, 8) + turn_cosine::<S>(1, n) * S::ratio(1, 4);
    inner * inner + S::ratio(3, 8)
}

/// The edge point of an edge AB: 3/8 (A + B) + 1/8 (C + D), with the vertices C and D opposite to the edge in its two triangles; on the boundary
/// the midpoint of A and B.
fn edge_point<P: VectorSpace>(connectivity: &Connectivity, points: &[P], edge: u32) -> P {
    let h = connectivity.half_edge_of(edge);

    let start = |h| points[connectivity.origin(h) as usize];
    let [a, b] = [start(h), start(connectivity.next(h))];
    match connectivity.twin(h) {
        None => a.lerp(b, P::Scalar::ratio(1, 2)),
        Some(twin) => {
            let [c, d] = [h, twin].map(|h| start(connectivity.previous(h)));
            let eighths = [3, 3, 1, 1].map(|weight| P::Scalar::ratio(weight, 8));
            P::combination(eighths, [a, b, c, d])
        }
    }
}

/// The new place of a vertex V:
///
/// ```text
/// inside the mesh             alpha V + (1 - alpha) Q   Q: the mean of its n neighbours; alpha = vertex_weight(n)
/// on the boundary             (A + 6 V + B)/8           A, B: the vertices before and after V on the boundary
/// on it, in one triangle      V                         if corners == Corners::Sharp
/// without a triangle          V
/// ```
fn vertex_point<P: VectorSpace>(
    connectivity: &Connectivity,
    points: &[P],
    vertex: u32,
    corners: Corners,
    vertex_weight: &impl Fn(usize) -> P::Scalar,
) -> P {
    let v = points[vertex as usize];

    if connectivity.outgoing(vertex).is_none() {
        return v;
    }
    if let Some([before, after]) = connectivity.boundary_neighbours(vertex) {
        if corners == Corners::Sharp && connectivity.around(vertex).count() == 1 {
            return v;
        }
        let eighths = [1, 6, 1].map(|weight| P::Scalar::ratio(weight, 8));
        return P::combination(eighths, [points[before as usize], v, points[after as usize]]);
    }
    let n = connectivity.valence(vertex);
    let mut q = P::origin();
    for h in connectivity.around(vertex) {
        let neighbour = points[connectivity.target(h) as usize];
        q = q.plus(neighbour.times(P::Scalar::ratio(1, n as i32)));
    }
    q.lerp(v, vertex_weight(n))
}

/// The mesh after one step, with your weight. You need not change this.
pub fn loop_subdivision<P: VectorSpace>(
    connectivity: &Connectivity,
    points: &[P],
    corners: Corners,
) -> Result<Mesh<P>, SubdivisionError>
where
    P::Scalar: Real,
{
    loop_subdivision_with(connectivity, points, corners, vertex_weight)
}

/// The mesh after one step with any weight: four triangles for each old one, at its corners a, b, c and in its middle.
pub fn loop_subdivision_with<P: VectorSpace>(
    connectivity: &Connectivity,
    points: &[P],
    corners: Corners,
    vertex_weight: impl Fn(usize) -> P::Scalar,
) -> Result<Mesh<P>, SubdivisionError> {
    connectivity.must_be_triangles()?;
    connectivity.must_have_points(points.len())?;
    let vertices = connectivity.vertex_count() as u32;
    let mut positions = Vec::new();
    for vertex in 0..vertices {
        positions.push(vertex_point(connectivity, points, vertex, corners, &vertex_weight));
    }
    for edge in 0..connectivity.edge_count() as u32 {
        positions.push(edge_point(connectivity, points, edge));
    }
    let mut faces: Vec<[u32; 3]> = Vec::new();
    for face in 0..connectivity.face_count() as u32 {
        // The corners, and the numbers of the points on the edges that begin there.
        let h = connectivity.half_edges_of(face).start;
        let [a, b, c] = [h, h + 1, h + 2].map(|h| connectivity.origin(h));
        let [ab, bc, ca] = [h, h + 1, h + 2].map(|h| vertices + connectivity.edge_of(h));

        faces.extend([[a, ab, ca], [b, bc, ab], [c, ca, bc], [ab, bc, ca]]);
    }
    Ok(Mesh::new(positions, faces)?)
}
