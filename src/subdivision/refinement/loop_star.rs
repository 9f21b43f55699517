//! Loop's scheme around the vertices that no regular mask refines: those on a boundary, and those of another valence than 6.

use num_traits::One;

use super::super::boundary::mean_offset;
use super::vertex_star::VertexStar;
use crate::algebra::{Scalar, VectorSpace};

/// Whether the regular masks serve for a vertex with this number of faces.
pub(super) fn is_regular(faces: usize, is_boundary: bool) -> bool {
    faces == 6 && !is_boundary
}

/// One level: the vertex point and the edge points around it; `alpha` is the weight of the vertex.
// ANCHOR: star
pub(super) fn refine<P: VectorSpace>(
    star: &VertexStar,
    alpha: P::Scalar,
    old: &[P],
    new: &mut [P],
) {
    let edges = star.edges();
    let half = P::Scalar::ratio(1, 2);
    let (v, ends) = (old[0], &old[1..]);
    for i in 0..edges {
        let middle = v.plus(ends[i]).times(half);
        new[1 + i] = if star.is_outer(i) {
            middle
        } else {
            let beside = ends[(i + edges - 1) % edges].plus(ends[(i + 1) % edges]);
            middle.lerp(beside.times(half), P::Scalar::ratio(1, 4))
        };
    }
    new[0] = v.plus(star.offset(v, ends, || {
        mean_offset(v, ends.iter().copied()).times(P::Scalar::one() - alpha)
    }));
}
// ANCHOR_END: star
