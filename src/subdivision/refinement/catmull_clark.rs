//! Catmull-Clark on the patches of a mesh of quadrilaterals.

use super::cubic::{Boundaries, refine, refine_rows, refined_side};
use super::cubic_star;
use super::patches::{PatchOut, PatchSizes, Patches, Source, Workbench};
use super::quad_writer::Writer;
use super::quads::QuadNumbering;
use super::rows::Grid;
use super::stars::{NONE, Place, StarCorners};
use super::vertex_star::VertexStars;
use super::{Connectivity, Corners, index_of};
use crate::algebra::VectorSpace;

/// Where a patch lies: what depends on connectivity alone.
#[derive(Clone, Copy, Debug)]
struct Patch {
    /// The vertices of the patch and of the ring around it, 4 x 4, row-major; `NONE` beyond a boundary.
    stencil: [[u32; 4]; 4],
    /// Which sides are boundaries.
    is_boundary: [bool; 4],
    stars: StarCorners<4>,
}

/// The plan: patches and stars.
#[derive(Clone, Debug)]
pub(super) struct CubicPatches {
    pub(super) numbering: QuadNumbering,
    levels: u32,
    patches: Vec<Patch>,
    stars: VertexStars,
}

impl CubicPatches {
    /// The plan for `levels` levels on a mesh of quadrilaterals.
    pub(super) fn new(connectivity: Connectivity, levels: u32, corners: Corners) -> Self {
        let faces = 0..index_of(connectivity.face_count());
        let mut patches: Vec<Patch> = faces.map(|face| patch_of(&connectivity, face)).collect();
        let stars = VertexStars::new(
            &connectivity,
            corners,
            cubic_star::is_regular,
            |vertex| cubic_star::opposite(&connectivity, vertex),
            patches.iter_mut().map(|patch| &mut patch.stars),
        );
        Self {
            numbering: QuadNumbering::new(connectivity, 1 << levels),
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
        self.numbering.bytes() + self.patches.capacity() * size_of::<Patch>() + self.stars.bytes()
    }

    /// The stars' points on all levels.
    pub(super) fn refine_stars<P: VectorSpace>(&self, points: &[P], stored: &mut Vec<P>) {
        self.stars
            .refine(self.levels, points, stored, |_, star, old, new| {
                cubic_star::refine(star, old, new);
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
        self.stars
            .write_vertices(&self.numbering.connectivity, points, stored, corners, out);
    }
}

impl<P: VectorSpace> Patches<P> for CubicPatches {
    fn sizes(&self) -> PatchSizes {
        PatchSizes {
            corners: 4,
            edge: self.numbering.edge_size(),
            inside: self.numbering.face_size(),
        }
    }

    fn owned_edges(&self, face: usize) -> std::ops::Range<usize> {
        self.numbering.owned_by(face)
    }

    fn grouped(&self) -> usize {
        self.numbering.grouped()
    }

    // ANCHOR: patch
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
        let boundaries = [0, 1, 2, 3].map(|side| {
            let mut lanes = [false; LANES];
            for (lane, patch) in lanes.iter_mut().zip(patches) {
                *lane = patch.is_boundary[side];
            }
            lanes
        });
        workbench.prepare(self.levels, 4, refined_side);
        let Workbench { grids, window, row } = workbench;
        grids[0].gather(patches.iter().map(|patch| &patch.stencil), from.points);
        mirror(&boundaries, &mut grids[0]);
        for level in 1..self.levels as usize {
            let (coarse, fine) = grids.split_at_mut(level);
            refine(&coarse[level - 1], &boundaries, window, &mut fine[0]);
            let stars = patches.iter().map(|patch| &patch.stars);
            let on_level = (level, from.stars);
            self.stars
                .mend(stars, corner_places, on_level, &mut fine[0]);
            mirror(&boundaries, &mut fine[0]);
        }
        let mut writer = Writer {
            sides: self.numbering.sides(first, out.edges),
            inside: out.inside.as_chunks_mut().0,
            corners: out.corners,
            edge_size: self.numbering.edge_size(),
            row,
        };
        let finest_but_one = &grids[self.levels as usize - 1];
        refine_rows(finest_but_one, &boundaries, window, |index, row| {
            writer.write_row(index, row);
        });
    }
    // ANCHOR_END: patch
}

/// Where a grid keeps a corner, its neighbour across the side that begins there, and its neighbour across the side that ends there.
fn corner_places(corner: usize, side: usize) -> [Place; 3] {
    let (near, far) = (1, side - 2);
    match corner {
        0 => [(near, near), (0, near), (near, 0)],
        1 => [(near, far), (near, far + 1), (0, far)],
        2 => [(far, far), (far + 1, far), (far, far + 1)],
        _ => [(far, near), (far, 0), (far + 1, near)],
    }
}

/// The vertices in and around a face.
fn patch_of(connectivity: &Connectivity, face: u32) -> Patch {
    let mut patch = Patch {
        stencil: [[NONE; 4]; 4],
        is_boundary: [false; 4],
        stars: [(NONE, NONE); 4],
    };
    for (corner, h) in connectivity.half_edges_of(face).enumerate() {
        let [at, begins, ends] = corner_places(corner, 4);
        let diagonal = (begins.0 + ends.0 - at.0, begins.1 + ends.1 - at.1);
        let mut put = |(row, column): Place, vertex| patch.stencil[row][column] = vertex;
        put(at, connectivity.origin(h));
        let twin = connectivity.twin(h);
        let before = connectivity.twin(connectivity.previous(h));
        // Two half-edges further a quadrilateral is at the other end of the opposite side.
        let beyond = |h| connectivity.next(connectivity.next(h));
        if let Some(twin) = twin {
            put(begins, connectivity.origin(beyond(twin)));
        }
        if let Some(before) = before {
            put(ends, connectivity.origin(connectivity.previous(before)));
        }
        let opposite = twin
            .map(|twin| connectivity.next(twin))
            .and_then(|h| connectivity.twin(h));
        let opposite = opposite.filter(|_| before.is_some());
        if let Some(opposite) = opposite {
            put(
                diagonal,
                connectivity.target(connectivity.next(connectivity.next(opposite))),
            );
        }
        patch.is_boundary[corner] = twin.is_none();
    }
    patch
}

/// Beyond a boundary lies the mirror image of what is inside: columns first, so that a corner is mirrored twice.
// ANCHOR: mirror
fn mirror<P: VectorSpace, const LANES: usize>(
    boundaries: &Boundaries<LANES>,
    grid: &mut Grid<P, LANES>,
) {
    let last = grid.side() - 1;
    let image = |on: P, inside: P| on.plus(on.minus(inside));
    // Of each side: whether it is a row; the places beyond it, on it and inside.
    let (near, far) = ([0, 1, 2], [last, last - 1, last - 2]);
    for (side, is_row, [beyond, on, inside]) in [
        (3, false, near),
        (1, false, far),
        (0, true, near),
        (2, true, far),
    ] {
        for (lane, _) in boundaries[side].iter().enumerate().filter(|lane| *lane.1) {
            for t in 0..=last {
                let place = |across| if is_row { (across, t) } else { (t, across) };
                let at = |(row, column)| grid.at(row, column)[lane];
                let point = image(at(place(on)), at(place(inside)));
                let (row, column) = place(beyond);
                grid.at_mut(row, column)[lane] = point;
            }
        }
    }
}
// ANCHOR_END: mirror
