//! Meshes: points and the faces that join them; a surface cut into triangles; OBJ files in and out.
//!
//! A surface is a formula, a picture needs triangles. This module holds the plainest mesh there is, a list of positions
//! and a list of faces that index it, makes one from any [`Surface`](crate::surface::Surface) on a uniform grid of
//! parameters, and reads and writes the one file format that every modeller knows.
//!
//! # Conventions
//!
//! Vertices are counted from 0 in memory, from 1 in OBJ files. Faces run anticlockwise as seen from outside, where the
//! normal points.
//!
//! # Sources
//!
//! N. Max, *Weights for computing vertex normals from facet normals*, 1999 (for the plain sum, its section 1); G. Meisters, *Polygons
//! have ears*, 1975 (faces that are not convex).
//!
//! *In the course*: "discrétisation nécessaire pour l'affichage", slide 48.
//!
//! *In the book*: [Numbers, points and curves](../../../ground_floor.html).

mod ears;
mod obj;
mod tessellate;
mod triangulate;
mod write_obj;

use num_traits::{One, Zero};
use thiserror::Error;

pub(crate) use ears::{ears, turn};
pub use obj::{Element, Obj, ObjError};
pub use tessellate::tessellate_uniformly;
pub use write_obj::write_obj;

use self::triangulate::fan;
use crate::algebra::{Real, Scalar, Vector3, VectorSpace, divided, unit_vector};

/// What is wrong with the data of a mesh.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum MeshError {
    /// A face has fewer than three vertices.
    #[error("face {face} has {found} vertices: a face needs at least 3")]
    FaceTooSmall {
        /// Which face, counted from 0.
        face: usize,
        /// How many vertices it has.
        found: usize,
    },
    /// A face names a vertex that does not exist.
    #[error("face {face} names vertex {vertex}, but the {count} vertices are counted from 0")]
    NoSuchVertex {
        /// Which face, counted from 0.
        face: usize,
        /// The vertex that it names.
        vertex: u32,
        /// How many vertices there are.
        count: usize,
    },
    /// A face names a normal that does not exist, or is zero or not finite.
    #[error(
        "face {face} names normal {normal}, but only {count} are there, counted from 0, and it must not be zero"
    )]
    NoSuchNormal {
        /// Which face, counted from 0.
        face: usize,
        /// The normal that it names.
        normal: u32,
        /// How many normals there are.
        count: usize,
    },
    /// A position has an infinite or NaN coordinate.
    #[error("position {vertex} is {position}: every coordinate must be finite")]
    NotFinite {
        /// Which position, counted from 0.
        vertex: usize,
        /// The position as text.
        position: String,
    },
    /// A grid has no cells, or more vertices than a 32-bit index can name.
    #[error(
        "a grid of {columns} x {rows} cells: both must be at least 1, and (columns + 1)(rows + 1) below 2^32"
    )]
    UnusableGrid {
        /// Cells along u.
        columns: usize,
        /// Cells along v.
        rows: usize,
    },
}

/// Positions, and the faces that index them; normals and parameters where they are known.
///
/// # Shape
///
/// `normals` and `parameters` are empty or have one entry for each position.
#[derive(Clone, Debug, PartialEq)]
pub struct Mesh<P: VectorSpace> {
    /// The vertices' positions.
    pub positions: Vec<P>,
    /// The vertices' unit normals, or nothing.
    pub normals: Vec<P>,
    /// The vertices' surface parameters `[u, v]`, or nothing.
    pub parameters: Vec<[P::Scalar; 2]>,
    /// The vertices of all faces, face after face.
    corners: Vec<u32>,
    /// Where each face ends in `corners`.
    ends: Vec<usize>,
}

impl<P: VectorSpace> Mesh<P> {
    /// The mesh of these positions and faces, without normals and parameters.
    ///
    /// # Errors
    ///
    /// [`MeshError::FaceTooSmall`], [`MeshError::NoSuchVertex`] and [`MeshError::NotFinite`] as they say.
    pub fn new<F: AsRef<[u32]>>(
        positions: Vec<P>,
        faces: impl IntoIterator<Item = F>,
    ) -> Result<Self, MeshError> {
        let is_bad = |position: &P| !position.has_finite_coordinates();
        if let Some(vertex) = positions.iter().position(is_bad) {
            let position = format!("{:?}", positions[vertex]);
            return Err(MeshError::NotFinite { vertex, position });
        }
        let (mut corners, mut ends) = (Vec::new(), Vec::new());
        for (face, vertices) in faces.into_iter().enumerate() {
            let vertices = vertices.as_ref();
            if vertices.len() < 3 {
                return Err(MeshError::FaceTooSmall {
                    face,
                    found: vertices.len(),
                });
            }
            let count = positions.len();
            if let Some(&vertex) = vertices.iter().find(|&&vertex| vertex as usize >= count) {
                return Err(MeshError::NoSuchVertex {
                    face,
                    vertex,
                    count,
                });
            }
            corners.extend_from_slice(vertices);
            ends.push(corners.len());
        }
        Ok(Self {
            positions,
            normals: Vec::new(),
            parameters: Vec::new(),
            corners,
            ends,
        })
    }

    /// How many faces there are.
    pub fn face_count(&self) -> usize {
        self.ends.len()
    }

    /// The faces in order, each as its vertices.
    pub fn faces(&self) -> impl Iterator<Item = &[u32]> {
        let starts = std::iter::once(&0).chain(&self.ends);
        starts
            .zip(&self.ends)
            .map(|(&start, &end)| &self.corners[start..end])
    }

    /// The faces cut into triangles from their first vertex: right for convex faces. For others see [`Mesh::triangulated`].
    pub fn triangles(&self) -> impl Iterator<Item = [u32; 3]> {
        self.faces().flat_map(fan)
    }

    /// The unit normals of the vertices, each the mean of its triangles' normals weighted by their areas; the zero vector
    /// where a vertex has no triangle, or its normals cancel. Cut faces that are not convex first ([`Mesh::triangulated`]).
    ///
    /// # Source
    ///
    /// Max 1999, section 1: the plain sum of the triangles' vector products.
    // ANCHOR: vertex_normals
    pub fn vertex_normals(&self) -> Vec<P>
    where
        P: Vector3,
        P::Scalar: Real,
    {
        let scales = self.edge_lengths();
        let mut sums = vec![P::origin(); self.positions.len()];
        for triangle in self.triangles() {
            let [a, b, c] = triangle.map(|vertex| self.halved(vertex));
            for vertex in triangle.map(|vertex| vertex as usize) {
                let side = |end: P| divided(end.minus(a), scales[vertex]);
                sums[vertex] = sums[vertex].plus(side(b).cross(side(c)));
            }
        }
        sums.into_iter()
            .map(|sum| unit_vector(sum).unwrap_or_else(P::origin))
            .collect()
    }
    // ANCHOR_END: vertex_normals

    /// Half the longest coordinate difference along the triangles at each vertex: what is divided by it has products that
    /// neither overflow nor, where they count, underflow. 1 for a vertex without extent around it.
    fn edge_lengths(&self) -> Vec<P::Scalar>
    where
        P::Scalar: Real,
    {
        let mut lengths = vec![P::Scalar::zero(); self.positions.len()];
        for triangle in self.triangles() {
            let [a, b, c] = triangle.map(|vertex| self.halved(vertex));
            for side in [b.minus(a), c.minus(a)] {
                let length = side.largest_coordinate();
                for vertex in triangle.map(|vertex| vertex as usize) {
                    lengths[vertex] = if length > lengths[vertex] {
                        length
                    } else {
                        lengths[vertex]
                    };
                }
            }
        }
        lengths
            .into_iter()
            .map(|l| if l.is_zero() { P::Scalar::one() } else { l })
            .collect()
    }

    /// Half the position of a vertex: differences of halves do not overflow.
    fn halved(&self, vertex: u32) -> P {
        self.positions[vertex as usize].times(P::Scalar::ratio(1, 2))
    }
}
