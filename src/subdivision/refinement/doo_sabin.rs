//! Doo-Sabin on the vertices of a mesh where each has four edges: every vertex becomes a block of points.
//!
//! A boundary is that of a tensor product whose outer control points are doubled: beyond it lies, as a ghost, the same point once more.

use super::super::mask::{averaging_weight, doo_sabin_weight};
use super::super::{DooSabinWeights, SubdivisionError};
use super::biquadratic::{refine, refine_rows, refined_side};
use super::blocks::{BlockNumbering, places};
use super::patches::{PatchOut, PatchSizes, Patches, Source, Workbench};
use super::prelude::{Prelude, Rule};
use super::rows::Grid;
use super::stars::{NONE, Place, StarCorners, Stars, mend};
use super::{Connectivity, Corners, Patchwork, Refinement, index_of};
use crate::algebra::{Scalar, VectorSpace};

impl Refinement {
    /// The plan for `levels` levels of Doo-Sabin.
    ///
    /// # Errors
    ///
    /// [`SubdivisionError::TooLarge`] beyond 32-bit numbers.
    ///
    /// # Examples
    ///
    /// The cube's eight vertices of valence 3 become triangles, in the first step for ever.
    ///
    /// ```
    /// use facette::mesh::Mesh;
    /// use facette::subdivision::{Connectivity, Corners, DooSabinWeights, Refinement};
    ///
    /// let corners: Vec<[f64; 3]> = (0..8).map(|n| [n & 1, n >> 1 & 1, n >> 2].map(f64::from)).collect();
    /// let faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    /// let cube = Mesh::new(corners, faces)?;
    /// let connectivity = Connectivity::new(&cube)?;
    /// let plan = Refinement::doo_sabin(&connectivity, 3, DooSabinWeights::Own, Corners::Sharp)?;
    /// assert_eq!(plan.vertex_count(), 24 * 16);
    /// assert_eq!(plan.polygons().len(), 8);
    /// assert_eq!(plan.quad_count() + 8, 24 * 16 + 2);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn doo_sabin(
        connectivity: &Connectivity,
        levels: u32,
        weights: DooSabinWeights,
        corners: Corners,
    ) -> Result<Self, SubdivisionError> {
        let rule = Rule::DooSabin(weights, corners);
        let (prelude, connectivity) = Prelude::new(rule, connectivity, levels)?;
        let rest = levels - prelude.levels();
        // Corners and sides are packed into 32 bits with their blocks.
        let are_named = connectivity.vertex_count() <= u32::MAX as usize / 4;
        let patchwork = if are_named && is_regular(&connectivity, corners) {
            // A mesh without faces vanishes in the first step.
            let rest = if connectivity.face_count() == 0 {
                0
            } else {
                rest
            };
            Patchwork::Biquadratic(BiquadraticBlocks::new(&connectivity, rest, weights))
        } else {
            Patchwork::Unrefined(connectivity)
        };
        Ok(Self {
            levels,
            prelude,
            patchwork,
        })
    }
}

/// Where a block lies: what depends on connectivity alone.
#[derive(Clone, Copy, Debug)]
struct Block {
    /// The vertex and the ring around it, row-major.
    stencil: [[u32; 3]; 3],
    /// The stars are the faces of other than four corners.
    stars: StarCorners<4>,
}

/// The plan: blocks, and a star for each face of other than four corners.
#[derive(Clone, Debug)]
pub(super) struct BiquadraticBlocks {
    pub(super) numbering: BlockNumbering,
    levels: u32,
    weights: DooSabinWeights,
    blocks: Vec<Block>,
    stars: Stars,
}

/// Whether each vertex can become a block: with four edges inside, two faces on the boundary, or one where that is a sharp corner.
pub(super) fn is_regular(connectivity: &Connectivity, corners: Corners) -> bool {
    (0..index_of(connectivity.vertex_count())).all(|vertex| {
        let faces = connectivity.around(vertex).count();
        if connectivity.is_boundary_vertex(vertex) {
            faces == 2 || faces == 1 && corners == Corners::Sharp
        } else {
            faces == 4
        }
    })
}

impl BiquadraticBlocks {
    /// The plan for `levels` levels on a mesh that [`is_regular`].
    pub(super) fn new(connectivity: &Connectivity, levels: u32, weights: DooSabinWeights) -> Self {
        let places = places(connectivity);
        let vertices = 0..index_of(connectivity.vertex_count());
        let mut blocks: Vec<Block> = vertices
            .map(|vertex| block_at(connectivity, vertex))
            .collect();
        let mut stars = Stars::default();
        for face in 0..index_of(connectivity.face_count()) {
            let vertices = connectivity.vertices_of(face);
            if vertices.len() != 4 {
                let star = stars.push(vertices.iter().copied());
                for (place, h) in (0..).zip(connectivity.half_edges_of(face)) {
                    let block = &mut blocks[connectivity.origin(h) as usize];
                    block.stars[places[h as usize] as usize] = (star, place);
                }
            }
        }
        Self {
            numbering: BlockNumbering::new(connectivity, &places, 1 << levels),
            levels,
            weights,
            blocks,
            stars,
        }
    }

    /// How many levels the blocks are refined by.
    pub(super) fn levels(&self) -> u32 {
        self.levels
    }

    pub(super) fn bytes(&self) -> usize {
        let blocks = self.blocks.capacity() * size_of::<Block>();
        self.numbering.bytes() + blocks + self.stars.bytes()
    }

    /// The stars' points on all levels: each face shrinks within itself.
    // ANCHOR: stars
    pub(super) fn refine_stars<P: VectorSpace>(
        &self,
        points: &[P],
        stored: &mut Vec<P>,
        cosine: &impl Fn(usize, usize) -> P::Scalar,
    ) {
        let mut sizes: Vec<usize> = self.stars.sizes().collect();
        sizes.sort_unstable();
        sizes.dedup();
        let weights: Vec<Vec<P::Scalar>> = sizes
            .iter()
            .map(|&n| {
                let weight = |steps| corner_weight(self.weights, n, steps, cosine);
                (1..n).map(weight).collect()
            })
            .collect();
        self.stars
            .refine(self.levels, points, stored, |_, old, new| {
                let n = old.len();
                let weights = &weights[sizes.partition_point(|&size| size < n)];
                for (i, new) in new.iter_mut().enumerate() {
                    let others = old.iter().cycle().skip(i + 1);
                    let offset = weights.iter().zip(others).fold(P::origin(), |sum, term| {
                        sum.plus(term.1.minus(old[i]).times(*term.0))
                    });
                    *new = old[i].plus(offset);
                }
            });
    }
    // ANCHOR_END: stars

    /// Puts the stars' points into the corners of the grids, with their two neighbours in the ring.
    fn mend<P: VectorSpace, const LANES: usize>(
        &self,
        blocks: &[Block; LANES],
        level: usize,
        stored: &[P],
        grid: &mut Grid<P, LANES>,
    ) {
        let points = |star, place| {
            let points: &[P] = self.stars.points(stored, index_of(level), star);
            let n = points.len();
            [place, (place + 1) % n, (place + n - 1) % n].map(|i| Some(points[i]))
        };
        let stars = blocks.iter().map(|block| &block.stars);
        mend(stars, corner_places, points, grid);
    }
}

/// The weight of the corner `steps` corners further in a face of `n` corners.
pub(super) fn corner_weight<S: Scalar>(
    weights: DooSabinWeights,
    n: usize,
    steps: usize,
    cosine: impl Fn(usize, usize) -> S,
) -> S {
    match weights {
        DooSabinWeights::Own => doo_sabin_weight(n, steps, cosine(steps, n)),
        DooSabinWeights::Averaging => averaging_weight(n, steps),
    }
}

impl<P: VectorSpace> Patches<P> for BiquadraticBlocks {
    fn sizes(&self) -> PatchSizes {
        PatchSizes {
            corners: 0,
            edge: 0,
            inside: self.numbering.points_per_block(),
        }
    }

    /// Every point lies inside a block.
    fn owned_edges(&self, _: usize) -> std::ops::Range<usize> {
        0..0
    }

    fn grouped(&self) -> usize {
        self.numbering.grouped()
    }

    // ANCHOR: block
    fn refine_patches<const LANES: usize>(
        &self,
        first: usize,
        from: Source<'_, P>,
        workbench: &mut Workbench<P, LANES>,
        out: PatchOut<'_, P>,
    ) {
        let blocks: &[Block; LANES] = self.blocks[first..]
            .first_chunk()
            .expect("groups are whole");
        workbench.prepare(self.levels, 3, refined_side);
        let Workbench { grids, window, .. } = workbench;
        grids[0].gather(blocks.iter().map(|block| &block.stencil), from.points);
        for level in 1..self.levels as usize {
            let (coarse, fine) = grids.split_at_mut(level);
            refine(&coarse[level - 1], window, &mut fine[0]);
            self.mend(blocks, level, from.stars, &mut fine[0]);
        }
        let side = self.numbering.side as usize;
        let (points, _) = out.inside.as_chunks_mut::<LANES>();
        let rows = points.chunks_exact_mut(side);
        let mut rows = rows.enumerate().map(|(row, points)| (row + 1, points));
        let mut next = rows.next();
        refine_rows(&grids[self.levels as usize - 1], window, |index, row| {
            // The first row and the last are the ring's.
            if let Some((_, out)) = next.take_if(|next| next.0 == index) {
                row.write(1, out);
                next = rows.next();
            }
        });
        for (lane, block) in blocks.iter().enumerate() {
            for (corner, &(star, place)) in block.stars.iter().enumerate() {
                if star != NONE {
                    let (row, column) = corner_places(corner, side + 2)[0];
                    let stars = self.stars.points(from.stars, self.levels, star);
                    points[(row - 1) * side + column - 1][lane] = stars[place as usize];
                }
            }
        }
    }
    // ANCHOR_END: block
}

/// Where a grid keeps a corner, and its neighbours in the ring along the face that the corner lies in: the next one in the face, and the one
/// before.
fn corner_places(corner: usize, side: usize) -> [Place; 3] {
    let (near, far) = (1, side - 2);
    match corner {
        0 => [(far, far), (far, far + 1), (far + 1, far)],
        1 => [(far, near), (far + 1, near), (far, 0)],
        2 => [(near, near), (near, 0), (0, near)],
        _ => [(near, far), (0, far), (near, far + 1)],
    }
}

/// The block of a vertex: its first edge runs to the right, its second up.
// ANCHOR: stencil
fn block_at(connectivity: &Connectivity, vertex: u32) -> Block {
    // Beyond a boundary lies the same row or column again.
    let mut stencil = [[vertex; 3]; 3];
    let ends = [[1, 2], [2, 1], [1, 0], [0, 1]];
    let diagonals = [[2, 2], [2, 0], [0, 0], [0, 2]];
    let mut put = |[row, column]: [usize; 2], vertex| stencil[row][column] = vertex;
    let mut faces = 0;
    for h in connectivity.around(vertex) {
        put(ends[faces], connectivity.target(h));
        // Where the face has not four corners, no point that is used depends on the diagonal.
        put(diagonals[faces], connectivity.target(connectivity.next(h)));
        faces += 1;
    }
    if let Some([before, after]) = connectivity.boundary_neighbours(vertex) {
        put(ends[faces], before);
        // In the rows or columns beyond: what is on the boundary.
        put([0, 2], after);
        if faces == 2 {
            put([0, 0], before);
        } else {
            put([2, 0], before);
        }
    }
    Block {
        stencil,
        stars: [(NONE, NONE); 4],
    }
}
// ANCHOR_END: stencil
