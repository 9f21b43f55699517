//! From a mesh of quadrilaterals to the points of its patches.

use super::adaptive::{Anchored, Patch};
use super::bicubic::reflected;
use super::quad_corner::QuadCorner;
use crate::algebra::VectorSpace;
use crate::subdivision::{Connectivity, Corners};

/// Whether the surface around a vertex is a bicubic B-spline: four quadrilaterals, two along a boundary, or one in a sharp corner.
fn is_regular(connectivity: &Connectivity, vertex: u32, corners: Corners) -> bool {
    let all_quadrilaterals = || {
        let mut around = connectivity.around(vertex);
        around.all(|h| connectivity.half_edges_of(connectivity.face_of(h)).len() == 4)
    };
    let face_count = connectivity.around(vertex).count();
    let has_right_count = if connectivity.is_boundary_vertex(vertex) {
        face_count == 2 || (face_count == 1 && corners == Corners::Sharp)
    } else {
        face_count == 4
    };
    has_right_count && all_quadrilaterals()
}

/// The regular patch of a face, if it is one. Points beyond a boundary are reflected, so that the boundary becomes its own cubic B-spline and
/// a sharp corner stays.
pub(super) fn regular_patch<P: VectorSpace>(
    connectivity: &Connectivity,
    points: &[P],
    face: u32,
    corners: Corners,
) -> Option<Anchored<P, [P; 16]>> {
    let vertices = connectivity.vertices_of(face);
    let is_regular = |&vertex: &u32| is_regular(connectivity, vertex, corners);
    if vertices.len() != 4 || !vertices.iter().all(is_regular) {
        return None;
    }
    let origin = points[vertices[0] as usize];
    let point = |vertex: u32| points[vertex as usize].minus(origin);
    let inner: [P; 4] = std::array::from_fn(|k| point(vertices[k]));
    let first = connectivity.half_edges_of(face).start;
    let twins = [0, 1, 2, 3].map(|k| connectivity.twin(first + k));
    // The two points across each side, in the order of its ends.
    let across: [[P; 2]; 4] = std::array::from_fn(|k| match twins[k] {
        Some(twin) => {
            let outwards = connectivity.next(twin);
            [outwards, connectivity.next(outwards)].map(|h| point(connectivity.target(h)))
        }
        None => [
            reflected(inner[(k + 3) % 4], inner[k]),
            reflected(inner[(k + 2) % 4], inner[(k + 1) % 4]),
        ],
    });
    // The point diagonally across each corner.
    let diagonal: [P; 4] = std::array::from_fn(|k| {
        let before = (k + 3) % 4;
        match [twins[before], twins[k]] {
            [Some(_), Some(twin)] => {
                let inwards = connectivity.twin(connectivity.next(twin));
                let h = inwards.expect("a regular vertex inside has faces all around");
                point(connectivity.origin(connectivity.previous(h)))
            }
            [_, None] => reflected(across[before][0], across[before][1]),
            [None, Some(_)] => reflected(across[k][1], across[k][0]),
        }
    });
    let [p00, p10, p11, p01] = inner;
    let [below, right, above, left] = across;
    #[rustfmt::skip]
    let net = [
        diagonal[0], below[0], below[1], diagonal[1],
        left[1],     p00,      p10,      right[0],
        left[0],     p01,      p11,      right[1],
        diagonal[3], above[1], above[0], diagonal[2],
    ];
    Some(Anchored { origin, local: net })
}

/// The patch of a face of a mesh that was made by a step of the scheme: its first vertex is an old one, the others are regular, and no edge
/// between those others is on the boundary.
pub(super) fn refined_patch<P: VectorSpace>(
    connectivity: &Connectivity,
    points: &[P],
    face: u32,
    corners: Corners,
    found: &mut Vec<Anchored<P, QuadCorner<P>>>,
) -> Patch<P, 16> {
    if let Some(patch) = regular_patch(connectivity, points, face, corners) {
        return Patch::Regular(Box::new(patch));
    }
    found.push(corner_of(connectivity, points, face));
    Patch::Corner(found.len() - 1)
}

/// The corner at the first vertex of a face.
fn corner_of<P: VectorSpace>(
    connectivity: &Connectivity,
    points: &[P],
    face: u32,
) -> Anchored<P, QuadCorner<P>> {
    let first = connectivity.half_edges_of(face).start;
    let vertex = connectivity.origin(first);
    let origin = points[vertex as usize];
    let point = |vertex: u32| points[vertex as usize].minus(origin);
    let around: Vec<u32> = connectivity.around(vertex).collect();
    let is_closed = !connectivity.is_boundary_vertex(vertex);
    let target = |h| point(connectivity.target(h));
    let faces = around.iter().map(|&h| target(connectivity.next(h)));
    let local = QuadCorner {
        is_closed,
        sector: around.iter().position(|&h| h == first).unwrap_or(0),
        centre: point(vertex),
        edges: connectivity.neighbours(vertex).map(point).collect(),
        faces: faces.collect(),
        outer: outer_points(connectivity, first, point)
            .expect("a step puts the edge points and the face point of a face inside"),
    };
    Anchored { origin, local }
}

/// The points a0 ... a6 beyond the face of a half-edge, as [`QuadCorner`] has them.
fn outer_points<P: VectorSpace>(
    connectivity: &Connectivity,
    half_edge: u32,
    point: impl Fn(u32) -> P,
) -> Option<[P; 7]> {
    let next = |h| connectivity.next(h);
    let previous = |h| connectivity.previous(h);
    let twin = |h| connectivity.twin(h);
    let target = |h| point(connectivity.target(h));
    let right = twin(next(half_edge))?;
    let above = twin(next(next(half_edge)))?;
    let [a1, a2] = [next(right), next(next(right))].map(target);
    let diagonal = twin(previous(right))?;
    let [a3, a4] = [next(diagonal), next(next(diagonal))].map(target);
    let a5 = target(next(next(above)));
    let a0 = match twin(next(right)) {
        Some(below) => point(connectivity.origin(previous(below))),
        None => reflected(a2, a1),
    };
    let a6 = match twin(previous(above)) {
        Some(left) => target(next(left)),
        None => reflected(a4, a5),
    };
    Some([a0, a1, a2, a3, a4, a5, a6])
}
