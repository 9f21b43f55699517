//! Many levels at once: a plan for a mesh's connectivity, made once, and applied to its points again and again.
//!
//! After one step at most, a mesh of any connectivity is a patchwork: each face of it (each vertex, for Doo-Sabin) will carry a regular grid
//! of points, whatever the level. On a grid the neighbours of a point need no table: they are the row above, the row below, and the places to
//! the left and to the right. So a patch is refined row by row, with the masks of the spline; only the corners of patches can be
//! extraordinary, and their rings are refined on their own.
//!
//! # Conventions
//!
//! A patch of Catmull-Clark is a quadrilateral: column 0 to `side` along its first half-edge, row 0 to `side` from there to the opposite
//! side. Its points are numbered as [`Refinement::vertex`] says.
//!
//! A patch of Doo-Sabin is a vertex, which becomes a block of `side` x `side` points: rows and columns 0 to `side − 1`, columns in the
//! direction of the vertex's first half-edge, rows in that of its second.
//!
//! # Numerics
//!
//! The masks are means, applied along the rows and then across: a level adds a rounding error of few units in the last place. Each point
//! is computed by one patch, the same one whatever the number of threads. A boundary depends on the boundary's points only, bit by bit.
//!
//! # Sources
//!
//! M. Bunnell, *Adaptive tessellation of subdivision surfaces with displacement mapping*, GPU Gems 2, 2005 (patches refined with a ring of
//! neighbours); J. Dupuy, K. Vanhoey, *A halfedge refinement rule for parallel Catmull-Clark subdivision*, 2021 (index arithmetic without
//! searching).
//!
//! *In the course*: slides 64 to 79 (*schémas de subdivision*).
//!
//! *In the book*: [Refinement in patches](../../../subdivision/refinement.html).

mod biquadratic;
mod blocks;
mod box_spline;
mod catmull_clark;
mod cubic;
mod cubic_star;
mod doo_sabin;
mod faces;
mod loop_scheme;
mod loop_star;
mod patches;
mod prelude;
mod quad_writer;
mod quads;
mod rows;
mod stars;
mod triangles;
mod vertex_star;

pub use patches::Scratch;

use self::catmull_clark::CubicPatches;
use self::doo_sabin::BiquadraticBlocks;
use self::loop_scheme::LoopPatches;
use self::patches::{PatchOut, Source, refine_all};
use self::prelude::{Prelude, Rule};
use self::quads::QuadNumbering;
use super::connectivity::index_of;
use super::mask::{loop_vertex_weight, turn_cosine};
use super::{Connectivity, Corners, SubdivisionError};
use crate::algebra::{Real, VectorSpace};
use crate::mesh::Mesh;

/// A plan to refine the points of one mesh by a number of levels.
///
/// # Cost
///
/// Making it is linear in the size of the mesh, whatever the number of levels; so is its memory.
///
/// # Examples
///
/// ```
/// use facette::mesh::Mesh;
/// use facette::subdivision::{Connectivity, Corners, Refinement};
///
/// let square = Mesh::new(vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]], [[0, 1, 2, 3]])?;
/// let plan = Refinement::catmull_clark(&Connectivity::new(&square)?, 3, Corners::Sharp)?;
/// assert_eq!(plan.vertex_count(), 81);
/// let positions = plan.positions(&square.positions)?;
/// assert_eq!(positions[plan.vertex(0, 4, 2) as usize], [0.25, 0.5]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Refinement {
    levels: u32,
    prelude: Prelude,
    patchwork: Patchwork,
}

/// How the mesh after the prelude is refined.
#[derive(Clone, Debug)]
enum Patchwork {
    /// Not at all.
    Unrefined(Connectivity),
    Cubic(CubicPatches),
    Biquadratic(BiquadraticBlocks),
    Loop(LoopPatches),
}

impl Refinement {
    /// The plan for `levels` levels of Catmull-Clark.
    ///
    /// # Errors
    ///
    /// [`SubdivisionError::TooLarge`] beyond 32-bit numbers.
    pub fn catmull_clark(
        connectivity: &Connectivity,
        levels: u32,
        corners: Corners,
    ) -> Result<Self, SubdivisionError> {
        let (prelude, connectivity) =
            Prelude::new(Rule::CatmullClark(corners), connectivity, levels)?;
        // A mesh without faces stays the same on all levels.
        let rest = match connectivity.face_count() {
            0 => 0,
            _ => levels - prelude.levels(),
        };
        let is_quads = prelude::is_quads(&connectivity);
        let patchwork = if is_quads {
            Patchwork::Cubic(CubicPatches::new(connectivity, rest, corners))
        } else {
            Patchwork::Unrefined(connectivity)
        };
        Ok(Self {
            levels,
            prelude,
            patchwork,
        })
    }

    /// The plan for `levels` levels of Loop's scheme.
    ///
    /// # Errors
    ///
    /// [`SubdivisionError::NotATriangle`]; [`SubdivisionError::TooLarge`] beyond 32-bit numbers.
    pub fn loop_subdivision(
        connectivity: &Connectivity,
        levels: u32,
        corners: Corners,
    ) -> Result<Self, SubdivisionError> {
        connectivity.must_be_triangles()?;
        let (prelude, connectivity) = Prelude::new(Rule::Loop, connectivity, levels)?;
        let rest = match connectivity.face_count() {
            0 => 0,
            _ => levels,
        };
        Ok(Self {
            levels,
            prelude,
            patchwork: Patchwork::Loop(LoopPatches::new(connectivity, rest, corners)),
        })
    }

    /// How many levels are refined.
    pub fn levels(&self) -> u32 {
        self.levels
    }

    /// How many points the mesh must have that is refined.
    pub fn source_count(&self) -> usize {
        self.prelude.source_count()
    }

    /// Bytes that the plan keeps.
    pub fn bytes(&self) -> usize {
        let patchwork = match &self.patchwork {
            Patchwork::Unrefined(connectivity) => bytes_of(connectivity),
            Patchwork::Cubic(plan) => plan.bytes(),
            Patchwork::Biquadratic(plan) => plan.bytes(),
            Patchwork::Loop(plan) => plan.bytes(),
        };
        self.prelude.bytes() + patchwork
    }

    /// How many vertices the refined mesh has.
    pub fn vertex_count(&self) -> usize {
        match &self.patchwork {
            Patchwork::Unrefined(connectivity) => connectivity.vertex_count(),
            Patchwork::Cubic(plan) => plan.numbering.vertex_count(),
            Patchwork::Biquadratic(plan) => plan.numbering.vertex_count(),
            Patchwork::Loop(plan) => plan.numbering.vertex_count(),
        }
    }

    /// The number of a point in the grid of a patch.
    ///
    /// # Panics
    ///
    /// When there is no such patch.
    pub fn vertex(&self, patch: u32, row: u32, column: u32) -> u32 {
        match &self.patchwork {
            Patchwork::Unrefined(connectivity) => connectivity.vertices_of(patch)[0],
            Patchwork::Cubic(plan) => plan.numbering.vertex(patch, row, column),
            Patchwork::Biquadratic(plan) => plan.numbering.vertex(patch, row, column),
            Patchwork::Loop(plan) => plan.numbering.vertex(patch, row, column),
        }
    }

    /// The positions of the refined mesh's vertices.
    ///
    /// # Errors
    ///
    /// [`SubdivisionError::PointCount`].
    pub fn positions<P: VectorSpace>(&self, points: &[P]) -> Result<Vec<P>, SubdivisionError>
    where
        P::Scalar: Real,
    {
        self.positions_with(points, turn_cosine)
    }

    /// The [`positions`](Self::positions) with cos(2πk/n) given as a function of k and n: for exact numbers.
    ///
    /// # Errors
    ///
    /// Those of [`positions`](Self::positions).
    pub fn positions_with<P: VectorSpace>(
        &self,
        points: &[P],
        cosine: impl Fn(usize, usize) -> P::Scalar + Sync,
    ) -> Result<Vec<P>, SubdivisionError> {
        let mut positions = vec![P::origin(); self.vertex_count()];
        self.write_positions(points, &mut Scratch::new(), &mut positions, &cosine)?;
        Ok(positions)
    }

    /// Writes the [`positions`](Self::positions) into memory of the caller's.
    ///
    /// # Errors
    ///
    /// [`SubdivisionError::PointCount`] and [`SubdivisionError::BufferLength`].
    pub fn positions_into<P: VectorSpace>(
        &self,
        points: &[P],
        scratch: &mut Scratch<P>,
        out: &mut [P],
    ) -> Result<(), SubdivisionError>
    where
        P::Scalar: Real,
    {
        must_have_length("positions", self.vertex_count(), out.len())?;
        self.write_positions(points, scratch, out, &turn_cosine)
    }

    fn write_positions<P: VectorSpace>(
        &self,
        points: &[P],
        scratch: &mut Scratch<P>,
        out: &mut [P],
        cosine: &(impl Fn(usize, usize) -> P::Scalar + Sync),
    ) -> Result<(), SubdivisionError> {
        self.prelude.must_have_points(points.len())?;
        let base = self.prelude.refine(points, &mut scratch.base, cosine)?;
        let Scratch {
            stars,
            corners,
            workers,
            ..
        } = scratch;
        match &self.patchwork {
            Patchwork::Cubic(plan) if plan.levels() > 0 => {
                plan.refine_stars(base, stars);
                let (vertices, parts) = split(&plan.numbering, 4, base, corners, out);
                let count = plan.numbering.connectivity.face_count();
                let source = Source {
                    points: base,
                    stars,
                };
                refine_all(plan, count, source, workers, parts);
                plan.write_vertices(base, stars, corners, vertices);
            }
            Patchwork::Biquadratic(plan) if plan.levels() > 0 => {
                plan.refine_stars(base, stars, cosine);
                let source = Source {
                    points: base,
                    stars,
                };
                let blocks = PatchOut {
                    edges: &mut [],
                    inside: out,
                    corners: &mut [],
                };
                refine_all(plan, plan.numbering.block_count(), source, workers, blocks);
            }
            Patchwork::Loop(plan) if plan.levels() > 0 => {
                plan.refine_stars(base, stars, |n| loop_vertex_weight(cosine(1, n)));
                let (vertices, parts) = split(&plan.numbering.edges, 3, base, corners, out);
                let count = plan.numbering.edges.connectivity.face_count();
                let source = Source {
                    points: base,
                    stars,
                };
                refine_all(plan, count, source, workers, parts);
                plan.write_vertices(base, stars, corners, vertices);
            }
            _ => out.copy_from_slice(base),
        }
        Ok(())
    }

    /// The refined mesh.
    ///
    /// # Errors
    ///
    /// [`SubdivisionError::PointCount`].
    pub fn mesh<P: VectorSpace>(&self, points: &[P]) -> Result<Mesh<P>, SubdivisionError>
    where
        P::Scalar: Real,
    {
        let positions = self.positions(points)?;
        Ok(Mesh::new(positions, self.faces())?)
    }
}

fn must_have_length(
    what: &'static str,
    expected: usize,
    found: usize,
) -> Result<(), SubdivisionError> {
    if found == expected {
        Ok(())
    } else {
        Err(SubdivisionError::BufferLength {
            what,
            found,
            expected,
        })
    }
}

/// The memory for the vertices, and that for the patches.
fn split<'a, 'out: 'a, P: VectorSpace>(
    edges: &QuadNumbering,
    corner_count: usize,
    base: &[P],
    corners: &'a mut Vec<P>,
    out: &'out mut [P],
) -> (&'out mut [P], PatchOut<'a, P>) {
    let connectivity = &edges.connectivity;
    corners.resize(corner_count * connectivity.face_count(), P::origin());
    let (vertices, rest) = out.split_at_mut(base.len());
    let (edges, inside) = rest.split_at_mut(connectivity.edge_count() * edges.edge_size());
    let patches = PatchOut {
        edges,
        inside,
        corners,
    };
    (vertices, patches)
}

/// Bytes that a connectivity keeps, at most.
fn bytes_of(connectivity: &Connectivity) -> usize {
    let half_edges = connectivity.half_edge_count();
    size_of::<u32>() * (6 * half_edges + connectivity.vertex_count() + 1)
}
