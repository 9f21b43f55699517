//! From a mesh of triangles to the points of its patches.

use super::adaptive::{Anchored, Patch};
use super::bicubic::reflected;
use super::box_spline::bezier_points;
use super::triangle_corner::{TriangleCorner, across};
use crate::algebra::VectorSpace;
use crate::subdivision::{Connectivity, Corners};

/// Whether the surface around a vertex is a box spline: six triangles, three along a boundary, or one in a sharp corner.
fn is_regular(connectivity: &Connectivity, vertex: u32, corners: Corners) -> bool {
    let face_count = connectivity.around(vertex).count();
    if connectivity.is_boundary_vertex(vertex) {
        face_count == 3 || (face_count == 1 && corners == Corners::Sharp)
    } else {
        face_count == 6
    }
}

/// The regular patch of a face, if it is one, with A at its corner of this number. Points beyond a boundary make parallelograms with what is
/// inside, so that the boundary becomes its own cubic B-spline and a sharp corner stays.
pub(super) fn regular_patch<P: VectorSpace>(
    connectivity: &Connectivity,
    points: &[P],
    face: u32,
    first: usize,
    corners: Corners,
) -> Option<Anchored<P, [P; 15]>> {
    let vertices = connectivity.vertices_of(face);
    let is_regular = |&vertex: &u32| is_regular(connectivity, vertex, corners);
    if !vertices.iter().all(is_regular) {
        return None;
    }
    let origin = points[vertices[first] as usize];
    let point = |vertex: u32| points[vertex as usize].minus(origin);
    let start = connectivity.half_edges_of(face).start;
    let mut sides = [0, 1, 2].map(|k| start + k);
    sides.rotate_left(first);
    let inner = sides.map(|h| point(connectivity.origin(h)));
    let next = |h| connectivity.next(h);
    let twins = sides.map(|h| connectivity.twin(h));
    let opposite = |h| point(connectivity.target(next(h)));
    let beyond: [P; 3] = std::array::from_fn(|k| match twins[k] {
        Some(twin) => opposite(twin),
        None => across(inner[k], inner[(k + 1) % 3], inner[(k + 2) % 3]),
    });
    // Around each corner, the next point after the one across the side that leaves it, and after the one across the side that arrives.
    let tips: [[P; 2]; 3] = std::array::from_fn(|k| {
        let [leaving, arriving] = [k, (k + 2) % 3];
        let [a, b, c] = [k, k + 1, k + 2].map(|k| inner[k % 3]);
        let tip = |spoke: u32, beside: P, third: P| match connectivity.twin(spoke) {
            Some(twin) => opposite(twin),
            None => across(a, beside, third),
        };
        let by_leaving = twins[leaving].map(|twin| tip(next(twin), beyond[leaving], b));
        let by_arriving =
            twins[arriving].map(|twin| tip(connectivity.previous(twin), beyond[arriving], c));
        match [by_leaving, by_arriving] {
            [Some(one), Some(other)] => [one, other],
            [Some(one), None] => [one, across(a, one, beyond[leaving])],
            [None, Some(other)] => [across(a, other, beyond[arriving]), other],
            [None, None] => [reflected(c, a), reflected(b, a)],
        }
    });
    #[rustfmt::skip]
    let net = [
        tips[0][0], beyond[0], tips[1][1],
        tips[0][1], inner[0], inner[1], tips[1][0],
        beyond[2], inner[2], beyond[1],
        tips[2][0], tips[2][1],
    ];
    Some(Anchored {
        origin,
        local: bezier_points(&net),
    })
}

/// The patch at a vertex of a mesh that was made by a step of the scheme: the other two vertices of the face are regular, and the edge between
/// them is not on the boundary.
pub(super) fn refined_patch<P: VectorSpace>(
    connectivity: &Connectivity,
    points: &[P],
    face: u32,
    corners: Corners,
    vertex_weight: impl Fn(usize) -> P::Scalar,
    found: &mut Vec<Anchored<P, TriangleCorner<P>>>,
) -> Patch<P, 15> {
    if let Some(patch) = regular_patch(connectivity, points, face, 0, corners) {
        return Patch::Regular(Box::new(patch));
    }
    found.push(corner_of(connectivity, points, face, vertex_weight));
    Patch::Corner(found.len() - 1)
}

/// The corner at the first vertex of a face.
fn corner_of<P: VectorSpace>(
    connectivity: &Connectivity,
    points: &[P],
    face: u32,
    vertex_weight: impl Fn(usize) -> P::Scalar,
) -> Anchored<P, TriangleCorner<P>> {
    let first = connectivity.half_edges_of(face).start;
    let vertex = connectivity.origin(first);
    let origin = points[vertex as usize];
    let point = |vertex: u32| points[vertex as usize].minus(origin);
    let around: Vec<u32> = connectivity.around(vertex).collect();
    let is_closed = !connectivity.is_boundary_vertex(vertex);
    let local = TriangleCorner {
        is_closed,
        vertex_weight: vertex_weight(around.len()),
        sector: around.iter().position(|&h| h == first).unwrap_or(0),
        centre: point(vertex),
        ring: connectivity.neighbours(vertex).map(point).collect(),
        outer: outer_points(connectivity, first, point)
            .expect("a step puts the triangle between the edge points inside"),
    };
    Anchored { origin, local }
}

/// The points a0 ... a4 beyond the face of a half-edge, as [`TriangleCorner`] has them.
fn outer_points<P: VectorSpace>(
    connectivity: &Connectivity,
    half_edge: u32,
    point: impl Fn(u32) -> P,
) -> Option<[P; 5]> {
    let next = |h| connectivity.next(h);
    let previous = |h| connectivity.previous(h);
    let twin = |h| connectivity.twin(h);
    let [q0, q1] = [half_edge, next(half_edge)].map(|h| point(connectivity.target(h)));
    let opposite = |h| point(connectivity.target(next(h)));
    let middle = twin(next(half_edge))?;
    let a2 = opposite(middle);
    let right = twin(next(middle))?;
    let above = twin(previous(middle))?;
    let [a1, a3] = [right, above].map(opposite);
    let a0 = twin(next(right)).map_or_else(|| across(q0, a1, a2), opposite);
    let a4 = twin(previous(above)).map_or_else(|| across(q1, a3, a2), opposite);
    Some([a0, a1, a2, a3, a4])
}
