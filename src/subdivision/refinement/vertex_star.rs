//! Vertices that no regular mask refines, as the schemes with a point for each vertex have them: what does not depend on the scheme.

use super::rows::Grid;
use super::stars::Place;
use super::stars::{StarCorners, Stars, mend};
use super::{Connectivity, Corners, index_of};
use crate::algebra::{Scalar, VectorSpace};

/// A vertex with its own mask.
#[derive(Clone, Copy, Debug)]
pub(super) struct VertexStar {
    vertex: u32,
    faces: u32,
    pub(super) is_boundary: bool,
    stays: bool,
}

impl VertexStar {
    /// The star around a vertex, if it is irregular: `is_regular(faces, is_boundary)` says so.
    fn at(
        connectivity: &Connectivity,
        vertex: u32,
        corners: Corners,
        is_regular: impl Fn(usize, bool) -> bool,
    ) -> Option<Self> {
        let faces = connectivity.around(vertex).count();
        let is_boundary = connectivity.is_boundary_vertex(vertex);
        (faces > 0 && !is_regular(faces, is_boundary)).then(|| Self {
            vertex,
            faces: index_of(faces),
            is_boundary,
            stays: faces == 1 && corners == Corners::Sharp,
        })
    }

    /// How many faces are around the vertex.
    pub(super) fn faces(&self) -> usize {
        self.faces as usize
    }

    /// Its valence.
    pub(super) fn edges(&self) -> usize {
        self.faces() + usize::from(self.is_boundary)
    }

    /// Whether an edge, counted anticlockwise, is on the boundary.
    pub(super) fn is_outer(&self, edge: usize) -> bool {
        self.is_boundary && (edge == 0 || edge + 1 == self.edges())
    }

    /// What the boundary's rule adds to the vertex `v`, given the other ends of its edges; `inside` is asked for a vertex off the boundary.
    pub(super) fn offset<P: VectorSpace>(&self, v: P, ends: &[P], inside: impl FnOnce() -> P) -> P {
        if self.stays {
            P::origin()
        } else if self.is_boundary {
            let beside = ends[0].minus(v).plus(ends[self.edges() - 1].minus(v));
            beside.times(P::Scalar::ratio(1, 8))
        } else {
            inside()
        }
    }

    /// The star's vertex and its neighbours in the ring around a patch: that across the side which begins at the vertex, and that across the side
    /// which ends there. None beyond a boundary.
    fn in_ring<P: VectorSpace>(&self, points: &[P], place: usize) -> [Option<P>; 3] {
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

/// The stars of all irregular vertices. The points of each: its vertex, the other ends of its edges, and what else the scheme needs.
#[derive(Clone, Debug, Default)]
pub(super) struct VertexStars {
    stars: Stars,
    kinds: Vec<VertexStar>,
}

impl VertexStars {
    /// The stars of a mesh. `more(vertex)` are the points of a star beyond its vertex and neighbours; `in_patch(face, corner)` is the entry to be
    /// filled in for a corner of a patch.
    pub(super) fn new<'a, const CORNERS: usize, More: Iterator<Item = u32>>(
        connectivity: &Connectivity,
        corners: Corners,
        is_regular: impl Fn(usize, bool) -> bool,
        more: impl Fn(u32) -> More,
        patches: impl Iterator<Item = &'a mut StarCorners<CORNERS>>,
    ) -> Self {
        let mut patches: Vec<&mut StarCorners<CORNERS>> = patches.collect();
        let mut all = Self::default();
        for vertex in 0..index_of(connectivity.vertex_count()) {
            let Some(star) = VertexStar::at(connectivity, vertex, corners, &is_regular) else {
                continue;
            };
            let neighbours = connectivity.neighbours(vertex);
            let points = std::iter::once(vertex).chain(neighbours);
            let number = all.stars.push(points.chain(more(vertex)));
            all.kinds.push(star);
            for (place, h) in (0..).zip(connectivity.around(vertex)) {
                let face = connectivity.face_of(h);
                let corner = h - connectivity.half_edges_of(face).start;
                patches[face as usize][corner as usize] = (number, place);
            }
        }
        all
    }

    pub(super) fn bytes(&self) -> usize {
        self.kinds.capacity() * size_of::<VertexStar>() + self.stars.bytes()
    }

    /// The valences, star by star.
    pub(super) fn valences(&self) -> impl Iterator<Item = usize> {
        self.kinds.iter().map(VertexStar::edges)
    }

    /// The points on all levels; `refine(number, star, old, new)` makes one level of one star.
    pub(super) fn refine<P: VectorSpace>(
        &self,
        levels: u32,
        points: &[P],
        stored: &mut Vec<P>,
        refine: impl Fn(usize, &VertexStar, &[P], &mut [P]),
    ) {
        self.stars.refine(levels, points, stored, |star, old, new| {
            refine(star, &self.kinds[star], old, new);
        });
    }

    /// Puts the stars' points of a level into the corners of grids.
    pub(super) fn mend<'a, P: VectorSpace, const LANES: usize, const CORNERS: usize>(
        &self,
        patches: impl Iterator<Item = &'a StarCorners<CORNERS>>,
        places: impl Fn(usize, usize) -> [Place; 3],
        (level, stored): (usize, &[P]),
        grid: &mut Grid<P, LANES>,
    ) {
        let points = |star: u32, place| {
            let points = self.stars.points(stored, index_of(level), star);
            self.kinds[star as usize].in_ring(points, place)
        };
        mend(patches, places, points, grid);
    }

    /// Writes the base vertices of the last level, once the patches have given their corners: for each half-edge the point of its origin.
    pub(super) fn write_vertices<P: VectorSpace>(
        &self,
        connectivity: &Connectivity,
        points: &[P],
        (levels, stored): (u32, &[P]),
        corners: &[P],
        out: &mut [P],
    ) {
        for (vertex, (point, out)) in (0..).zip(points.iter().zip(&mut *out)) {
            let outgoing = connectivity.outgoing(vertex);
            *out = outgoing.map_or(*point, |h| corners[h as usize]);
        }
        for (number, star) in (0..).zip(&self.kinds) {
            out[star.vertex as usize] = self.stars.points(stored, levels, number)[0];
        }
    }
}
