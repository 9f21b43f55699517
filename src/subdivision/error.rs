//! What can be wrong with a mesh, a polygon or a request to subdivide it.

use thiserror::Error;

use crate::mesh::MeshError;

/// Why a mesh or polygon cannot be subdivided as asked.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum SubdivisionError {
    /// A face visits a vertex twice.
    #[error("face {face} visits vertex {vertex} twice: a face needs distinct vertices")]
    VertexRepeated {
        /// Which face, counted from 0.
        face: usize,
        /// The vertex.
        vertex: u32,
    },
    /// Two faces have the same vertices in the same cyclic order, or in the opposite one.
    #[error("face {face} repeats face {first}: every face may be there once")]
    FaceRepeated {
        /// The later of the two, counted from 0.
        face: usize,
        /// The earlier one.
        first: usize,
    },
    /// More than two faces meet along an edge.
    #[error(
        "{count} faces meet along the edge from vertex {} to vertex {}: at most 2 can", edge[0], edge[1]
    )]
    NonManifoldEdge {
        /// The edge's vertices, the smaller number first.
        edge: [u32; 2],
        /// How many faces have this edge.
        count: usize,
    },
    /// Two neighbouring faces run along their common edge in the same direction: seen from one side, one of them is turned over.
    #[error(
        "faces {} and {} both run from vertex {} to vertex {}: one of them is turned over", faces[0], faces[1], edge[0], edge[1]
    )]
    InconsistentOrientation {
        /// The edge's vertices in the direction of both faces.
        edge: [u32; 2],
        /// The faces, counted from 0.
        faces: [usize; 2],
    },
    /// The faces around a vertex are several fans that touch in that vertex alone.
    #[error(
        "the faces around vertex {vertex} form {fans} fans that share no edge: a vertex can have 1"
    )]
    NonManifoldVertex {
        /// The vertex.
        vertex: u32,
        /// How many fans there are.
        fans: usize,
    },
    /// The scheme is made for triangles.
    #[error("face {face} has {found} vertices: this scheme subdivides triangles")]
    NotATriangle {
        /// Which face, counted from 0.
        face: usize,
        /// How many vertices it has.
        found: usize,
    },
    /// What is asked for is had from quadrilaterals.
    #[error(
        "face {face} has {found} vertices: this is for quadrilaterals, which one step of Catmull-Clark makes of any mesh"
    )]
    NotAQuadrilateral {
        /// Which face, counted from 0.
        face: usize,
        /// How many vertices it has.
        found: usize,
    },
    /// There must be one point for each vertex.
    #[error("{found} points for {expected} vertices: there must be one for each")]
    PointCount {
        /// How many points are there.
        found: usize,
        /// How many vertices there are.
        expected: usize,
    },
    /// The caller's memory has not the length of what is to be written.
    #[error("memory for {found} {what} was handed in: there are {expected}")]
    BufferLength {
        /// What is to be written.
        what: &'static str,
        /// How many the memory has room for.
        found: usize,
        /// How many there are.
        expected: usize,
    },
    /// The result has more vertices, edges or corners than 32-bit numbers can name.
    #[error("{levels} levels make more than 2^32 - 1 {what}: ask for fewer")]
    TooLarge {
        /// The levels that were asked for.
        levels: u32,
        /// What there are too many of.
        what: &'static str,
    },
    /// The refined mesh is none: a coordinate of a point is infinite or NaN, or became so.
    #[error("after the step, {0}")]
    Mesh(#[from] MeshError),
}
