//! How many vertices, edges and faces a step makes: arithmetic on counts, before any mesh is made.
//!
//! *In the course*: slides 69 and 70 (Doo-Sabin), 75 (Catmull-Clark), 77 (Loop), 79 (√3).

use super::{Connectivity, Corners, Sqrt3Boundary, SubdivisionError};

/// The counts of a mesh that tell those of its refinements.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Counts {
    /// Vertices, those without a face too.
    pub vertices: u64,
    /// Edges.
    pub edges: u64,
    /// Faces.
    pub faces: u64,
    /// Half-edges: corners of all faces.
    pub half_edges: u64,
    /// Edges with a face on one side only; there are as many boundary vertices.
    pub boundary_edges: u64,
    /// Boundary vertices with a single face, or that had one before a step of √3 that kept the boundary.
    pub corners: u64,
    /// Vertices without a face.
    pub isolated: u64,
    /// Inner vertices where two edges meet, and two faces.
    pub of_valence_2: u64,
}

impl Counts {
    /// The counts of a mesh.
    ///
    /// # Cost
    ///
    /// A walk over all vertices.
    pub fn of(connectivity: &Connectivity) -> Self {
        let [edges, half_edges] = [connectivity.edge_count(), connectivity.half_edge_count()];
        let mut counts = Self {
            vertices: connectivity.vertex_count() as u64,
            edges: edges as u64,
            faces: connectivity.face_count() as u64,
            half_edges: half_edges as u64,
            boundary_edges: (2 * edges - half_edges) as u64,
            corners: 0,
            isolated: 0,
            of_valence_2: 0,
        };
        for vertex in (0..).take(connectivity.vertex_count()) {
            counts.corners += u64::from(connectivity.is_corner(vertex, 1));
            counts.isolated += u64::from(connectivity.outgoing(vertex).is_none());
            let is_inner = !connectivity.is_boundary_vertex(vertex);
            counts.of_valence_2 += u64::from(is_inner && connectivity.valence(vertex) == 2);
        }
        counts
    }

    /// The counts after a step of Catmull-Clark.
    ///
    /// # Errors
    ///
    /// [`SubdivisionError::TooLarge`] where 32-bit numbers cannot name all vertices or corners, here and below.
    pub fn after_catmull_clark(self) -> Result<Self, SubdivisionError> {
        let after = Self {
            vertices: self.vertices + self.edges + self.faces,
            edges: 2 * self.edges + self.half_edges,
            faces: self.half_edges,
            half_edges: 4 * self.half_edges,
            boundary_edges: 2 * self.boundary_edges,
            ..self
        };
        after.checked()
    }

    /// The counts after a step of Loop's scheme on triangles.
    ///
    /// # Errors
    ///
    /// [`SubdivisionError::TooLarge`].
    pub fn after_loop(self) -> Result<Self, SubdivisionError> {
        let after = Self {
            vertices: self.vertices + self.edges,
            edges: 2 * self.edges + self.half_edges,
            faces: 4 * self.faces,
            half_edges: 4 * self.half_edges,
            boundary_edges: 2 * self.boundary_edges,
            ..self
        };
        after.checked()
    }

    /// The counts after a step of √3 on triangles. In a step that trisects the boundary, each triangle has at most one boundary edge, as
    /// after a step that keeps it.
    ///
    /// # Errors
    ///
    /// [`SubdivisionError::TooLarge`].
    pub fn after_sqrt3(self, boundary: Sqrt3Boundary) -> Result<Self, SubdivisionError> {
        let [added, boundary_edges] = match boundary {
            Sqrt3Boundary::Kept => [self.faces, self.boundary_edges],
            Sqrt3Boundary::Trisected => [self.faces + self.boundary_edges, 3 * self.boundary_edges],
        };
        let half_edges = 3 * self.half_edges;
        let after = Self {
            vertices: self.vertices + added,
            edges: half_edges.midpoint(boundary_edges),
            faces: self.half_edges,
            half_edges,
            boundary_edges,
            ..self
        };
        after.checked()
    }

    /// The counts after a step of Doo-Sabin. Only with sharp corners do vertices with a single face remain, and each adds one vertex; an inner vertex
    /// of valence 2 leaves no face.
    ///
    /// # Errors
    ///
    /// [`SubdivisionError::TooLarge`].
    pub fn after_doo_sabin(self, corners: Corners) -> Result<Self, SubdivisionError> {
        let kept = match corners {
            Corners::Sharp => self.corners,
            Corners::Smooth => 0,
        };
        let vertices = self.half_edges + 2 * self.boundary_edges + kept;
        let with_face = self.vertices - self.isolated - self.of_valence_2;
        let after = Self {
            vertices,
            edges: vertices + 2 * self.edges - self.of_valence_2,
            faces: self.faces + self.edges + with_face,
            half_edges: self.half_edges + 4 * self.edges + vertices - 2 * self.of_valence_2,
            boundary_edges: 2 * self.boundary_edges + kept,
            corners: kept,
            isolated: 0,
            of_valence_2: 0,
        };
        after.checked()
    }

    /// The counts where 32-bit numbers can name everything that is counted.
    fn checked(self) -> Result<Self, SubdivisionError> {
        let named = [
            (self.vertices, "vertices"),
            (self.edges, "edges"),
            (self.faces, "faces"),
            (self.half_edges, "corners"),
        ];
        match named.iter().find(|named| named.0 >= u64::from(u32::MAX)) {
            None => Ok(self),
            Some(&(_, what)) => Err(SubdivisionError::TooLarge { levels: 1, what }),
        }
    }
}
