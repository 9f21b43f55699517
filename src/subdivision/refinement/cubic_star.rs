//! Catmull-Clark around the vertices that no regular mask refines.

use num_traits::One;

use super::super::boundary::mean_offset;
use super::super::mask::count;
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
    let is_regular = faces == if is_boundary { 2 } else { 4 };
    (faces > 0 && !is_regular).then(|| Star {
        vertex,
        faces: index_of(faces),
        is_boundary,
        stays: faces == 1 && corners == Corners::Sharp,
    })
}

/// A vertex, the other ends of its edges, and the vertices opposite to it in its faces, both anticlockwise.
pub(super) fn ring(connectivity: &Connectivity, vertex: u32) -> impl Iterator<Item = u32> {
    let ends = connectivity.around(vertex).map(|h| connectivity.target(h));
    let last = connectivity
        .boundary_neighbours(vertex)
        .map(|[before, _]| before);
    let opposite = connectivity
        .around(vertex)
        .map(|h| connectivity.target(connectivity.next(h)));
    std::iter::once(vertex)
        .chain(ends)
        .chain(last)
        .chain(opposite)
}

impl Star {
    fn edges(&self) -> usize {
        self.faces as usize + usize::from(self.is_boundary)
    }

    /// One level: vertex, edge and face points of the ring.
    // ANCHOR: star
    pub(super) fn refine<P: VectorSpace>(&self, old: &[P], new: &mut [P]) {
        let (faces, edges) = (self.faces as usize, self.edges());
        let mean = |points: [P; 4]| points[0].plus(mean_offset(points[0], points.into_iter()));
        let (v, ends, opposite) = (old[0], &old[1..=edges], &old[1 + edges..]);
        let (new_ends, new_opposite) = new[1..].split_at_mut(edges);
        for i in 0..faces {
            new_opposite[i] = mean([v, ends[i], ends[(i + 1) % edges], opposite[i]]);
        }
        for i in 0..edges {
            let is_outer = self.is_boundary && (i == 0 || i + 1 == edges);
            new_ends[i] = if is_outer {
                v.plus(ends[i]).times(P::Scalar::ratio(1, 2))
            } else {
                mean([
                    v,
                    ends[i],
                    new_opposite[(i + faces - 1) % faces],
                    new_opposite[i],
                ])
            };
        }
        let offset = if self.stays {
            P::origin()
        } else if self.is_boundary {
            let beside = ends[0].minus(v).plus(ends[edges - 1].minus(v));
            beside.times(P::Scalar::ratio(1, 8))
        } else {
            let q = mean_offset(v, new_opposite.iter().copied());
            let twice_r = mean_offset(v, ends.iter().copied());
            q.plus(twice_r).times(P::Scalar::one() / count(faces))
        };
        new[0] = v.plus(offset);
    }
    // ANCHOR_END: star

    /// The star's vertex and its neighbours in the ring around a patch: that across the side which begins at the vertex, and that across the side
    /// which ends there. None beyond a boundary, where the ring has a mirror image.
    pub(super) fn in_ring<P: VectorSpace>(&self, points: &[P], place: usize) -> [Option<P>; 3] {
        let ends = &points[1..=self.edges()];
        let [before, after] = if self.is_boundary {
            [place.checked_sub(1), Some(place + 2)]
        } else {
            [place + ends.len() - 1, place + 2].map(|i| Some(i % ends.len()))
        };
        let end = |i: usize| ends.get(i).copied();
        [Some(points[0]), before.and_then(end), after.and_then(end)]
    }
}
