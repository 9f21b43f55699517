//! Loop's scheme on the patches of a mesh of triangles.

use super::box_spline::{Parts, on_curve, refine, refined_side, write_row};
use super::loop_star;
use super::patches::{PatchOut, PatchSizes, Patches, Source, Workbench};
use super::rows::Grid;
use super::stars::{NONE, Place, StarCorners};
use super::triangles::TriangleNumbering;
use super::vertex_star::VertexStars;
use super::{Connectivity, Corners, index_of};
use crate::algebra::VectorSpace;

/// Where a patch lies: what depends on connectivity alone.
#[derive(Clone, Copy, Debug)]
struct Patch {
    /// The vertices of the patch and of the ring around it, 4 x 4, row-major; `NONE` where there is none.
    stencil: [[u32; 4]; 4],
    /// Which sides are boundaries.
    is_boundary: [bool; 3],
    stars: StarCorners<3>,
}

/// The plan: patches and stars.
#[derive(Clone, Debug)]
pub(super) struct LoopPatches {
    pub(super) numbering: TriangleNumbering,
    levels: u32,
    patches: Vec<Patch>,
    stars: VertexStars,
}

impl LoopPatches {
    /// The plan for `levels` levels on a mesh of triangles.
    pub(super) fn new(connectivity: Connectivity, levels: u32, corners: Corners) -> Self {
        let faces = 0..index_of(connectivity.face_count());
        let mut patches: Vec<Patch> = faces.map(|face| patch_of(&connectivity, face)).collect();
        let stars = VertexStars::new(
            &connectivity,
            corners,
            loop_star::is_regular,
            |_| std::iter::empty(),
            patches.iter_mut().map(|patch| &mut patch.stars),
        );
        Self {
            numbering: TriangleNumbering::new(connectivity, 1 << levels),
            levels,
            patches,
            stars,
        }
    }

    /// How many levels the patches are refined by.
    pub(super) fn levels(&self) -> u32 {
        self.levels
    }

    pub(super) fn bytes(&self) -> usize {
        self.numbering.edges.bytes()
            + self.patches.capacity() * size_of::<Patch>()
            + self.stars.bytes()
    }

    /// The stars' points on all levels; `alpha` gives a vertex' own weight from its valence.
    pub(super) fn refine_stars<P: VectorSpace>(
        &self,
        points: &[P],
        stored: &mut Vec<P>,
        alpha: impl Fn(usize) -> P::Scalar,
    ) {
        let alphas: Vec<_> = self.stars.valences().map(alpha).collect();
        self.stars
            .refine(self.levels, points, stored, |number, star, old, new| {
                loop_star::refine(star, alphas[number], old, new);
            });
    }

    /// Writes the base vertices, once the patches have given their corners.
    pub(super) fn write_vertices<P: VectorSpace>(
        &self,
        points: &[P],
        stored: &[P],
        corners: &[P],
        out: &mut [P],
    ) {
        let stored = (self.levels, stored);
        self.stars.write_vertices(
            &self.numbering.edges.connectivity,
            points,
            stored,
            corners,
            out,
        );
    }
}

impl<P: VectorSpace> Patches<P> for LoopPatches {
    fn sizes(&self) -> PatchSizes {
        PatchSizes {
            corners: 3,
            edge: self.numbering.edges.edge_size(),
            inside: self.numbering.face_size(),
        }
    }

    fn owned_edges(&self, face: usize) -> std::ops::Range<usize> {
        self.numbering.edges.owned_by(face)
    }

    fn grouped(&self) -> usize {
        self.numbering.grouped()
    }

    fn refine_patches<const LANES: usize>(
        &self,
        first: usize,
        from: Source<'_, P>,
        workbench: &mut Workbench<P, LANES>,
        out: PatchOut<'_, P>,
    ) {
        let patches: &[Patch; LANES] = self.patches[first..]
            .first_chunk()
            .expect("groups are whole");
        workbench.prepare(self.levels, 4, refined_side);
        let Workbench { grids, window, row } = workbench;
        let parts = window.parts();
        grids[0].gather(patches.iter().map(|patch| &patch.stencil), from.points);
        mirror(patches, &mut grids[0]);
        for level in 1..self.levels as usize {
            let (coarse, fine) = grids.split_at_mut(level);
            let (coarse, fine) = (&coarse[level - 1], &mut fine[0]);
            refine(coarse, parts, fine);
            let stars = patches.iter().map(|patch| &patch.stars);
            let on_level = (level, from.stars);
            self.stars.mend(stars, first_places, on_level, fine);
            refine_boundaries(patches, coarse, fine);
            mirror(patches, fine);
        }
        let mut writer = Writer {
            coarse: &grids[self.levels as usize - 1],
            sides: self.numbering.edges.sides(first, out.edges),
            edge_size: self.numbering.edges.edge_size(),
            row,
            parts,
        };
        writer.write_inside(out.inside.as_chunks_mut().0);
        writer.write_corners(out.corners);
        for side in 0..3 {
            writer.write_side(side, patches);
        }
    }
}

/// Where a grid keeps a corner; its neighbours across the side that begins there and across the side that ends there; and the two neighbours
/// between them that a corner of valence 6 has.
fn corner_places(corner: usize, side: usize) -> [Place; 5] {
    // The side of the triangle, in pieces; place (1, 1) is its first corner.
    let m = side - 3;
    match corner {
        0 => [(1, 1), (0, 2), (2, 0), (1, 0), (0, 1)],
        1 => [(1, m + 1), (2, m + 1), (0, m + 1), (0, m + 2), (1, m + 2)],
        _ => [(m + 1, 1), (m + 1, 0), (m + 1, 2), (m + 2, 1), (m + 2, 0)],
    }
}

/// The first three of the [`corner_places`]: those that a star gives.
fn first_places(corner: usize, side: usize) -> [Place; 3] {
    let [at, begins, ends, ..] = corner_places(corner, side);
    [at, begins, ends]
}

/// The vertices in and around a face.
fn patch_of(connectivity: &Connectivity, face: u32) -> Patch {
    let mut patch = Patch {
        stencil: [[NONE; 4]; 4],
        is_boundary: [false; 3],
        stars: [(NONE, NONE); 3],
    };
    for (corner, h) in connectivity.half_edges_of(face).enumerate() {
        let places = corner_places(corner, 4);
        let vertex = connectivity.origin(h);
        let mut put = |(row, column): Place, vertex| patch.stencil[row][column] = vertex;
        put(places[0], vertex);
        let twin = connectivity.twin(h);
        patch.is_boundary[corner] = twin.is_none();
        if let Some(twin) = twin {
            put(places[1], connectivity.origin(connectivity.previous(twin)));
        }
        if connectivity.is_boundary_vertex(vertex) || connectivity.valence(vertex) != 6 {
            continue;
        }
        // Anticlockwise from the side that begins here.
        let further = |steps: usize| {
            let turned = (0..steps).try_fold(h, |h, _| connectivity.twin(connectivity.previous(h)));
            turned.map_or(NONE, |h| connectivity.target(h))
        };
        put(places[3], further(3));
        put(places[4], further(4));
    }
    patch
}

/// The place of the point `t` pieces from the start of a side, in a grid of m pieces a side.
fn on_side(side: usize, m: usize, t: usize) -> Place {
    match side {
        0 => (1, t + 1),
        1 => (t + 1, m - t + 1),
        _ => (m - t + 1, 1),
    }
}

/// The lanes of the patches of which a side is a boundary.
fn lanes_at_boundary<const LANES: usize>(
    patches: &[Patch; LANES],
    side: usize,
) -> impl Iterator<Item = usize> {
    let lanes = patches.iter().enumerate();
    lanes.filter_map(move |(lane, patch)| patch.is_boundary[side].then_some(lane))
}

/// Puts boundaries on their own curves.
fn refine_boundaries<P: VectorSpace, const LANES: usize>(
    patches: &[Patch; LANES],
    coarse: &Grid<P, LANES>,
    fine: &mut Grid<P, LANES>,
) {
    let [m, fine_m] = [coarse.side() - 3, fine.side() - 3];
    for side in 0..3 {
        for lane in lanes_at_boundary(patches, side) {
            for t in 1..fine_m {
                let (row, column) = on_side(side, fine_m, t);
                fine.at_mut(row, column)[lane] = on_curve(t, |t| {
                    let (row, column) = on_side(side, m, t);
                    coarse.at(row, column)[lane]
                });
            }
        }
    }
}

/// Beyond a boundary lies the fourth corner of a parallelogram: then the regular mask of an edge on it is the midpoint.
// ANCHOR: mirror
fn mirror<P: VectorSpace, const LANES: usize>(patches: &[Patch; LANES], grid: &mut Grid<P, LANES>) {
    let m = grid.side() - 3;
    for side in 0..3 {
        for lane in lanes_at_boundary(patches, side) {
            for t in 0..m {
                let (a, b) = (on_side(side, m, t), on_side(side, m, t + 1));
                let inside = match side {
                    0 => (2, t + 1),
                    1 => (t + 1, m - t),
                    _ => (m - t, 2),
                };
                let at = |(row, column): Place| grid.at(row, column)[lane];
                let image = at(a).plus(at(b).minus(at(inside)));
                let (row, column) = (a.0 + b.0 - inside.0, a.1 + b.1 - inside.1);
                grid.at_mut(row, column)[lane] = image;
            }
        }
    }
}
// ANCHOR_END: mirror

/// The finest level of patches, written where it belongs.
struct Writer<'a, P, const LANES: usize> {
    coarse: &'a Grid<P, LANES>,
    /// For each side of each patch the inside of its edge, if the patch owns the edge.
    sides: [[Option<&'a mut [P]>; 3]; LANES],
    /// How many points there are inside an edge.
    edge_size: usize,
    /// Room for a row, and for its parts.
    row: &'a mut [[P; LANES]],
    parts: &'a mut Parts<P, LANES>,
}

impl<P: VectorSpace, const LANES: usize> Writer<'_, P, LANES> {
    fn write_inside(&mut self, mut inside: &mut [[P; LANES]]) {
        for row in 1..self.edge_size {
            if let Some(points) = inside.split_off_mut(..self.edge_size - row) {
                write_row(self.coarse, row + 1, 1, self.parts, points);
            }
        }
    }

    /// The fine point in a place of all patches.
    fn at(&mut self, (row, column): Place) -> &[P; LANES] {
        let pair = &mut self.row[..2];
        let wanted = &mut pair[..=column % 2];
        write_row(self.coarse, row, column / 2, self.parts, wanted);
        &pair[column % 2]
    }

    fn write_corners(&mut self, corners: &mut [P]) {
        let m = self.edge_size + 1;
        for corner in 0..3 {
            let points = *self.at(on_side(corner, m, 0));
            for (corners, point) in corners.chunks_exact_mut(3).zip(points) {
                corners[corner] = point;
            }
        }
    }

    fn write_side(&mut self, side: usize, patches: &[Patch; LANES]) {
        let m = self.edge_size + 1;
        if self.sides.iter().all(|sides| sides[side].is_none()) {
            return;
        }
        for t in 1..m {
            let points = *self.at(on_side(side, m, t));
            let lanes = self.sides.iter_mut().zip(patches).zip(points);
            for (lane, ((sides, patch), point)) in lanes.enumerate() {
                let Some(out) = &mut sides[side] else {
                    continue;
                };
                out[t - 1] = if patch.is_boundary[side] {
                    on_curve(t, |t| {
                        let (row, column) = on_side(side, m / 2, t);
                        self.coarse.at(row, column)[lane]
                    })
                } else {
                    point
                };
            }
        }
    }
}
