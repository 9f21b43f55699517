//! Loop's scheme around the vertices that no regular mask refines: those on a boundary, and those of another valence than 6.

use num_traits::One;

use super::super::boundary::mean_offset;
use super::{Connectivity, Corners, index_of};
use crate::algebra::{Scalar, VectorSpace};

/// A vertex with its own mask.
#[derive(Clone, Copy, Debug)]
pub(super) struct Star {
    pub(super) vertex: u32,
    faces: u32,
    is_boundary: bool,
    stays: bool,
}

/// The star around a vertex, if no regular mask refines it.
pub(super) fn star_at(connectivity: &Connectivity, vertex: u32, corners: Corners) -> Option<Star> {
    let faces = connectivity.around(vertex).count();
    let is_boundary = connectivity.is_boundary_vertex(vertex);
    (faces > 0 && (is_boundary || faces != 6)).then(|| Star {
        vertex,
        faces: index_of(faces),
        is_boundary,
        stays: faces == 1 && corners == Corners::Sharp,
    })
}

/// A vertex and the other ends of its edges, anticlockwise.
pub(super) fn ring(connectivity: &Connectivity, vertex: u32) -> impl Iterator<Item = u32> {
    let ends = connectivity.around(vertex).map(|h| connectivity.target(h));
    let neighbours = connectivity.boundary_neighbours(vertex);
    let last = neighbours.map(|[before, _]| before);
    std::iter::once(vertex).chain(ends).chain(last)
}

impl Star {
    /// Its valence.
    pub(super) fn edges(&self) -> usize {
        self.faces as usize + usize::from(self.is_boundary)
    }

    /// One level: the vertex point and the edge points around it; `alpha` is the weight of the vertex.
    // ANCHOR: star
    pub(super) fn refine<P: VectorSpace>(&self, alpha: P::Scalar, old: &[P], new: &mut [P]) {
        let edges = self.edges();
        let half = P::Scalar::ratio(1, 2);
        let (v, ends) = (old[0], &old[1..]);
        for i in 0..edges {
            let middle = v.plus(ends[i]).times(half);
            let is_outer = self.is_boundary && (i == 0 || i + 1 == edges);
            new[1 + i] = if is_outer {
                middle
            } else {
                let beside = ends[(i + edges - 1) % edges].plus(ends[(i + 1) % edges]);
                middle.lerp(beside.times(half), P::Scalar::ratio(1, 4))
            };
        }
        let offset = if self.stays {
            P::origin()
        } else if self.is_boundary {
            let beside = ends[0].minus(v).plus(ends[edges - 1].minus(v));
            beside.times(P::Scalar::ratio(1, 8))
        } else {
            mean_offset(v, ends.iter().copied()).times(P::Scalar::one() - alpha)
        };
        new[0] = v.plus(offset);
    }
    // ANCHOR_END: star

    /// The star's vertex and its neighbours in the ring around a patch: that across the side which begins at the vertex, and that across the side
    /// which ends there. None beyond a boundary.
    pub(super) fn in_ring<P: VectorSpace>(&self, points: &[P], place: usize) -> [Option<P>; 3] {
        let ends = &points[1..];
        let [before, after] = if self.is_boundary {
            [place.checked_sub(1), Some(place + 2)]
        } else {
            [place + ends.len() - 1, place + 2].map(|i| Some(i % ends.len()))
        };
        let end = |i: usize| ends.get(i).copied();
        [Some(points[0]), before.and_then(end), after.and_then(end)]
    }
}
