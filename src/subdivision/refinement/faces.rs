//! The faces of a refined mesh: what they are and how many, whatever the scheme.

use rayon::prelude::*;

use super::super::SubdivisionError;
use super::{Patchwork, Refinement, index_of, must_have_length};

impl Refinement {
    /// How many quadrilaterals the refined mesh has.
    pub fn quad_count(&self) -> usize {
        match &self.patchwork {
            Patchwork::Cubic(plan) => plan.numbering.quad_count(),
            Patchwork::Biquadratic(plan) => plan.numbering.quad_count(),
            _ => 0,
        }
    }

    /// The quadrilaterals of the refined mesh: patch by patch, each row by row.
    pub fn quads(&self) -> Vec<[u32; 4]> {
        let mut quads = vec![[0; 4]; self.quad_count()];
        self.write_quads(&mut quads);
        quads
    }

    /// Writes the [`quads`](Self::quads) into memory of the caller's.
    ///
    /// # Errors
    ///
    /// [`SubdivisionError::BufferLength`].
    pub fn quads_into(&self, out: &mut [[u32; 4]]) -> Result<(), SubdivisionError> {
        must_have_length("quadrilaterals", self.quad_count(), out.len())?;
        self.write_quads(out);
        Ok(())
    }

    fn write_quads(&self, out: &mut [[u32; 4]]) {
        match &self.patchwork {
            Patchwork::Cubic(plan) => {
                let numbering = &plan.numbering;
                for_each_face(out, numbering.quads_per_face(), |face, out| {
                    numbering.write_faces(face, out);
                });
            }
            Patchwork::Biquadratic(plan) => plan.numbering.write_quads(out),
            _ => {}
        }
    }

    /// How many triangles the refined mesh has.
    pub fn triangle_count(&self) -> usize {
        match &self.patchwork {
            Patchwork::Loop(plan) => {
                plan.numbering.edges.connectivity.face_count() * plan.numbering.triangles_per_face()
            }
            _ => 0,
        }
    }

    /// The triangles of the refined mesh: patch by patch, each row by row.
    pub fn triangles(&self) -> Vec<[u32; 3]> {
        let mut triangles = vec![[0; 3]; self.triangle_count()];
        self.write_triangles(&mut triangles);
        triangles
    }

    /// Writes the [`triangles`](Self::triangles) into memory of the caller's.
    ///
    /// # Errors
    ///
    /// [`SubdivisionError::BufferLength`].
    pub fn triangles_into(&self, out: &mut [[u32; 3]]) -> Result<(), SubdivisionError> {
        must_have_length("triangles", self.triangle_count(), out.len())?;
        self.write_triangles(out);
        Ok(())
    }

    fn write_triangles(&self, out: &mut [[u32; 3]]) {
        if let Patchwork::Loop(plan) = &self.patchwork {
            let numbering = &plan.numbering;
            for_each_face(out, numbering.triangles_per_face(), |face, out| {
                numbering.write_faces(face, out);
            });
        }
    }

    /// How many faces the refined mesh has, of all kinds.
    pub fn face_count(&self) -> usize {
        self.quad_count() + self.triangle_count() + self.polygons().len()
    }

    /// The faces that are neither among the [`quads`](Self::quads) nor among the [`triangles`](Self::triangles). With Doo-Sabin one lies at each
    /// extraordinary vertex and in each face of other than four corners, whatever the number of levels. A mesh that is not refined at all has all
    /// its faces here.
    pub fn polygons(&self) -> Vec<Vec<u32>> {
        match &self.patchwork {
            Patchwork::Unrefined(connectivity) => {
                let faces = 0..index_of(connectivity.face_count());
                faces
                    .map(|face| connectivity.vertices_of(face).to_vec())
                    .collect()
            }
            Patchwork::Biquadratic(plan) => plan.numbering.polygons().collect(),
            _ => Vec::new(),
        }
    }

    /// All faces of the refined mesh: quadrilaterals, then triangles, then the others.
    pub fn faces(&self) -> Vec<Vec<u32>> {
        let quads = self.quads().into_iter().map(Vec::from);
        let triangles = self.triangles().into_iter().map(Vec::from);
        quads.chain(triangles).chain(self.polygons()).collect()
    }
}

/// Writes the pieces of each face, on as many threads as there are.
pub(super) fn for_each_face<T: Send>(
    out: &mut [T],
    pieces: usize,
    write: impl Fn(u32, &mut [T]) + Sync,
) {
    if rayon::current_num_threads() > 1 {
        let faces = out.par_chunks_exact_mut(pieces).enumerate();
        faces.for_each(|(face, out)| write(index_of(face), out));
        return;
    }
    for (face, out) in (0..).zip(out.chunks_exact_mut(pieces)) {
        write(face, out);
    }
}
