//! Catmull-Clark around the vertices that no regular mask refines.

use num_traits::One;

use super::super::boundary::mean_offset;
use super::super::mask::count;
use super::Connectivity;
use super::vertex_star::VertexStar;
use crate::algebra::{Scalar, VectorSpace};

/// Whether the regular masks serve for a vertex with this number of faces.
pub(super) fn is_regular(faces: usize, is_boundary: bool) -> bool {
    faces == if is_boundary { 2 } else { 4 }
}

/// The vertices opposite to a vertex in its faces, anticlockwise: a star's last points.
pub(super) fn opposite(connectivity: &Connectivity, vertex: u32) -> impl Iterator<Item = u32> {
    let around = connectivity.around(vertex);
    around.map(|h| connectivity.target(connectivity.next(h)))
}

/// One level: vertex, edge and face points of the ring.
// ANCHOR: star
pub(super) fn refine<P: VectorSpace>(star: &VertexStar, old: &[P], new: &mut [P]) {
    let (faces, edges) = (star.faces(), star.edges());
    let mean = |points: [P; 4]| points[0].plus(mean_offset(points[0], points.into_iter()));
    let (v, ends, opposite) = (old[0], &old[1..=edges], &old[1 + edges..]);
    let (new_ends, new_opposite) = new[1..].split_at_mut(edges);
    for i in 0..faces {
        new_opposite[i] = mean([v, ends[i], ends[(i + 1) % edges], opposite[i]]);
    }
    for i in 0..edges {
        new_ends[i] = if star.is_outer(i) {
            v.plus(ends[i]).times(P::Scalar::ratio(1, 2))
        } else {
            let before = new_opposite[(i + faces - 1) % faces];
            mean([v, ends[i], before, new_opposite[i]])
        };
    }
    new[0] = v.plus(star.offset(v, ends, || {
        let q = mean_offset(v, new[1 + edges..].iter().copied());
        let twice_r = mean_offset(v, ends.iter().copied());
        q.plus(twice_r).times(P::Scalar::one() / count(faces))
    }));
}
// ANCHOR_END: star
