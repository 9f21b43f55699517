//! Half-edges: which faces, edges and vertices of a mesh meet.
//!
//! Every corner of every face stands for the half-edge that leaves it: the side of the face from this corner to the next one. The *twin*
//! of a half-edge is the same edge as seen from the face on its other side; along a boundary there is none. With the twin known, every
//! question of a subdivision scheme (the faces beside an edge, the ring around a vertex) is a short walk over arrays of indices.
//!
//! # Conventions
//!
//! Half-edges are numbered face after face, in the order of the corners; edges in the order of their first half-edge. Faces run
//! anticlockwise as seen from outside, and a vertex is walked around anticlockwise.
//!
//! # Sources
//!
//! Kevin Weiler, *Edge-based data structures for solid modeling in curved-surface environments*, 1985; Jonathan Dupuy and Kenneth Vanhoey,
//! *A halfedge refinement rule for parallel Catmull-Clark subdivision*, 2021, section 3 (the arrays).

use std::ops::Range;

use super::SubdivisionError;
use crate::algebra::VectorSpace;
use crate::mesh::Mesh;

/// What stands for "there is none" in the arrays of indices.
const NONE: u32 = u32::MAX;

/// How the faces of a polygon mesh are joined: a two-dimensional manifold with or without boundary, consistently oriented.
///
/// # Shape
///
/// Six 32-bit numbers a half-edge, at most, and one a vertex.
///
/// # Examples
///
/// ```
/// use facette::mesh::Mesh;
/// use facette::subdivision::Connectivity;
///
/// let corners = vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
/// let tetrahedron = Mesh::new(corners, [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]])?;
/// let connectivity = Connectivity::new(&tetrahedron)?;
/// assert_eq!(connectivity.edge_count(), 6);
/// assert_eq!(connectivity.euler_characteristic(), 2);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Connectivity {
    /// Where the half-edges of each face begin, and where the last ones end.
    starts: Vec<u32>,
    origins: Vec<u32>,
    faces: Vec<u32>,
    twins: Vec<u32>,
    edges: Vec<u32>,
    /// The first half-edge of each edge.
    firsts: Vec<u32>,
    /// A half-edge that leaves each vertex; at a boundary the one with nothing on its right, so that a walk from it meets all faces.
    outgoing: Vec<u32>,
}

impl Connectivity {
    /// The connectivity of a mesh. Vertices that no face visits are kept; what shape the faces have does not matter.
    ///
    /// # Errors
    ///
    /// [`SubdivisionError::VertexRepeated`], [`FaceRepeated`](SubdivisionError::FaceRepeated),
    /// [`NonManifoldEdge`](SubdivisionError::NonManifoldEdge),
    /// [`InconsistentOrientation`](SubdivisionError::InconsistentOrientation),
    /// [`NonManifoldVertex`](SubdivisionError::NonManifoldVertex): see [`repaired`](super::repaired) for a mesh that must be mended first.
    /// [`TooLarge`](SubdivisionError::TooLarge) for more corners than 32 bits can name.
    ///
    /// # Cost
    ///
    /// O(n log n) at worst in the number of corners; linear where valences are bounded.
    pub fn new<P: VectorSpace>(mesh: &Mesh<P>) -> Result<Self, SubdivisionError> {
        let corner_count = mesh.faces().map(<[u32]>::len).sum::<usize>();
        if corner_count >= NONE as usize || mesh.positions.len() >= NONE as usize {
            return Err(SubdivisionError::TooLarge {
                levels: 0,
                what: "corners",
            });
        }
        let mut joined = Self {
            starts: Vec::with_capacity(mesh.face_count() + 1),
            origins: Vec::with_capacity(corner_count),
            faces: Vec::with_capacity(corner_count),
            twins: vec![NONE; corner_count],
            edges: vec![NONE; corner_count],
            firsts: Vec::with_capacity(corner_count.div_ceil(2)),
            outgoing: vec![NONE; mesh.positions.len()],
        };
        joined.starts.push(0);
        for (face, vertices) in mesh.faces().enumerate() {
            joined.origins.extend_from_slice(vertices);
            joined.faces.resize(joined.origins.len(), index_of(face));
            joined.starts.push(index_of(joined.origins.len()));
        }
        joined.refuse_repeated_vertices()?;
        joined.find_twins()?;
        joined.refuse_turned_repetitions()?;
        joined.number_edges();
        joined.choose_outgoing()?;
        Ok(joined)
    }

    /// How many vertices there are, with those that no face visits.
    pub fn vertex_count(&self) -> usize {
        self.outgoing.len()
    }

    /// How many edges there are.
    pub fn edge_count(&self) -> usize {
        self.firsts.len()
    }

    /// How many faces there are.
    pub fn face_count(&self) -> usize {
        self.starts.len() - 1
    }

    /// How many half-edges there are: the corners of all faces.
    pub fn half_edge_count(&self) -> usize {
        self.origins.len()
    }

    /// Vertices − edges + faces, vertices without a face left out: 2 for a sphere, 0 for a torus, 1 for a disk.
    pub fn euler_characteristic(&self) -> i64 {
        let used = self.outgoing.iter().filter(|&&h| h != NONE).count();
        let signed = |count: usize| i64::from(index_of(count));
        signed(used) - signed(self.edge_count()) + signed(self.face_count())
    }

    /// The half-edges of a face, in order.
    pub fn half_edges_of(&self, face: u32) -> Range<u32> {
        self.starts[face as usize]..self.starts[face as usize + 1]
    }

    /// The vertices of a face, in order.
    pub fn vertices_of(&self, face: u32) -> &[u32] {
        let Range { start, end } = self.half_edges_of(face);
        &self.origins[start as usize..end as usize]
    }

    /// The vertex where a half-edge begins.
    pub fn origin(&self, half_edge: u32) -> u32 {
        self.origins[half_edge as usize]
    }

    /// The vertex where a half-edge ends.
    pub fn target(&self, half_edge: u32) -> u32 {
        self.origin(self.next(half_edge))
    }

    /// The face that a half-edge belongs to.
    pub fn face_of(&self, half_edge: u32) -> u32 {
        self.faces[half_edge as usize]
    }

    /// The half-edge of the same face that begins where this one ends.
    pub fn next(&self, half_edge: u32) -> u32 {
        let Range { start, end } = self.half_edges_of(self.face_of(half_edge));
        if half_edge + 1 == end {
            start
        } else {
            half_edge + 1
        }
    }

    /// The half-edge of the same face that ends where this one begins.
    pub fn previous(&self, half_edge: u32) -> u32 {
        let Range { start, end } = self.half_edges_of(self.face_of(half_edge));
        if half_edge == start {
            end - 1
        } else {
            half_edge - 1
        }
    }

    /// The same edge seen from its other side; `None` along a boundary.
    pub fn twin(&self, half_edge: u32) -> Option<u32> {
        known(self.twins[half_edge as usize])
    }

    /// The edge that a half-edge is a side of.
    pub fn edge_of(&self, half_edge: u32) -> u32 {
        self.edges[half_edge as usize]
    }

    /// The first half-edge of an edge; its [`twin`](Self::twin) is the other one, if there is one.
    pub fn half_edge_of(&self, edge: u32) -> u32 {
        self.firsts[edge as usize]
    }

    /// Whether an edge has a face on one side only.
    pub fn is_boundary_edge(&self, edge: u32) -> bool {
        self.twin(self.half_edge_of(edge)).is_none()
    }

    /// A half-edge that leaves a vertex: at a boundary vertex the boundary's own, with nothing on its right. `None` for a vertex without
    /// faces.
    pub fn outgoing(&self, vertex: u32) -> Option<u32> {
        known(self.outgoing[vertex as usize])
    }

    /// Whether a vertex is on the boundary. A vertex without faces is not.
    pub fn is_boundary_vertex(&self, vertex: u32) -> bool {
        self.outgoing(vertex)
            .is_some_and(|half_edge| self.twin(half_edge).is_none())
    }

    /// The half-edges that leave a vertex, anticlockwise, one for each face around it.
    ///
    /// At a boundary vertex the walk begins with the boundary's half-edge and meets every edge but the last, whose half-edge *arrives*:
    /// the [`previous`](Self::previous) of the walk's last.
    // ANCHOR: around
    pub fn around(&self, vertex: u32) -> impl Iterator<Item = u32> {
        let first = self.outgoing(vertex);
        std::iter::successors(first, move |&half_edge| {
            self.twin(self.previous(half_edge))
                .filter(|&next| Some(next) != first)
        })
    }
    // ANCHOR_END: around

    /// How many edges meet in a vertex.
    pub fn valence(&self, vertex: u32) -> usize {
        self.around(vertex).count() + usize::from(self.is_boundary_vertex(vertex))
    }

    /// Refuses a mesh of which a face is no triangle.
    ///
    /// # Errors
    ///
    /// [`SubdivisionError::NotATriangle`], with the first such face.
    pub fn must_be_triangles(&self) -> Result<(), SubdivisionError> {
        let lengths = self.starts.windows(2).map(|ends| ends[1] - ends[0]);
        match lengths.enumerate().find(|&(_, length)| length != 3) {
            None => Ok(()),
            Some((face, found)) => Err(SubdivisionError::NotATriangle {
                face,
                found: found as usize,
            }),
        }
    }

    /// Refuses a number of points that is not the number of vertices.
    ///
    /// # Errors
    ///
    /// [`SubdivisionError::PointCount`].
    pub fn must_have_points(&self, found: usize) -> Result<(), SubdivisionError> {
        let expected = self.vertex_count();
        if found == expected {
            Ok(())
        } else {
            Err(SubdivisionError::PointCount { found, expected })
        }
    }

    fn refuse_repeated_vertices(&self) -> Result<(), SubdivisionError> {
        // The face that visited each vertex last, counted from 1.
        let mut visited = vec![0; self.vertex_count()];
        for (&vertex, &face) in self.origins.iter().zip(&self.faces) {
            if visited[vertex as usize] == face + 1 {
                return Err(SubdivisionError::VertexRepeated {
                    face: face as usize,
                    vertex,
                });
            }
            visited[vertex as usize] = face + 1;
        }
        Ok(())
    }

    /// Joins the two half-edges of every edge. Half-edges are sorted into buckets by the smaller of their vertices.
    fn find_twins(&mut self) -> Result<(), SubdivisionError> {
        let ends = |h: u32| {
            let (a, b) = (self.origin(h), self.target(h));
            if a < b { [a, b] } else { [b, a] }
        };
        let half_edges = 0..index_of(self.half_edge_count());
        let mut bucket_ends = vec![0_u32; self.vertex_count() + 1];
        for h in half_edges.clone() {
            bucket_ends[ends(h)[0] as usize + 1] += 1;
        }
        for vertex in 1..bucket_ends.len() {
            bucket_ends[vertex] += bucket_ends[vertex - 1];
        }
        // From here on the entry of a vertex is where its next half-edge goes.
        let mut sorted = vec![(0, 0); self.half_edge_count()];
        for h in half_edges {
            let [smaller, larger] = ends(h);
            let place = &mut bucket_ends[smaller as usize];
            sorted[*place as usize] = (larger, h);
            *place += 1;
        }
        let mut twins = std::mem::take(&mut self.twins);
        let mut start = 0;
        for &end in &bucket_ends[..self.vertex_count()] {
            let bucket = &mut sorted[start..end as usize];
            bucket.sort_unstable();
            for same_edge in bucket.chunk_by(|a, b| a.0 == b.0) {
                match same_edge {
                    [_] => {}
                    &[(_, h), (_, g)] if self.origin(h) != self.origin(g) => {
                        twins[h as usize] = g;
                        twins[g as usize] = h;
                    }
                    refused => return Err(self.refusal(refused)),
                }
            }
            start = end as usize;
        }
        self.twins = twins;
        Ok(())
    }

    /// Refuses two faces that are one and the same, seen from both sides: all edges of the one are edges of the other.
    fn refuse_turned_repetitions(&self) -> Result<(), SubdivisionError> {
        for face in 0..index_of(self.face_count()) {
            let twins = self.half_edges_of(face).map(|h| self.twin(h));
            let mut beyond = twins.map(|twin| twin.map(|g| self.face_of(g)));
            if let Some(other) = beyond.next().flatten()
                && beyond.all(|face| face == Some(other))
            {
                return Err(SubdivisionError::FaceRepeated {
                    face: other as usize,
                    first: face as usize,
                });
            }
        }
        Ok(())
    }

    /// Why these half-edges along one edge cannot be joined.
    fn refusal(&self, along_edge: &[(u32, u32)]) -> SubdivisionError {
        let face = |index: usize| self.face_of(along_edge[index].1);
        let (first, second) = (face(0), face(1));
        if self.are_the_same_face(first, second) {
            return SubdivisionError::FaceRepeated {
                face: second as usize,
                first: first as usize,
            };
        }
        let h = along_edge[0].1;
        let [a, b] = [self.origin(h), self.target(h)];
        if along_edge.len() > 2 {
            return SubdivisionError::NonManifoldEdge {
                edge: [a.min(b), a.max(b)],
                count: along_edge.len(),
            };
        }
        SubdivisionError::InconsistentOrientation {
            edge: [a, b],
            faces: [first as usize, second as usize],
        }
    }

    fn are_the_same_face(&self, first: u32, second: u32) -> bool {
        let sorted = |face| {
            let mut vertices = self.vertices_of(face).to_vec();
            vertices.sort_unstable();
            vertices
        };
        sorted(first) == sorted(second)
    }

    fn number_edges(&mut self) {
        for h in 0..index_of(self.half_edge_count()) {
            let twin = self.twins[h as usize];
            // `NONE` is the largest number: a boundary's half-edge is always the first of its edge.
            if h < twin {
                self.edges[h as usize] = index_of(self.firsts.len());
                self.firsts.push(h);
            } else {
                self.edges[h as usize] = self.edges[twin as usize];
            }
        }
    }

    /// Chooses where the walk around each vertex begins, and makes sure that it meets every face.
    fn choose_outgoing(&mut self) -> Result<(), SubdivisionError> {
        let mut face_counts = vec![0_usize; self.vertex_count()];
        for h in 0..index_of(self.half_edge_count()) {
            let vertex = self.origin(h) as usize;
            face_counts[vertex] += 1;
            if self.outgoing[vertex] == NONE || self.twins[h as usize] == NONE {
                self.outgoing[vertex] = h;
            }
        }
        let vertices = 0..index_of(self.vertex_count());
        let is_split = |&vertex: &u32| self.around(vertex).count() != face_counts[vertex as usize];
        vertices
            .into_iter()
            .find(is_split)
            .map_or(Ok(()), |vertex| {
                let fans = self.fan_count(vertex);
                Err(SubdivisionError::NonManifoldVertex { vertex, fans })
            })
    }

    /// How many fans of faces meet in a vertex.
    fn fan_count(&self, vertex: u32) -> usize {
        let half_edges = 0..index_of(self.half_edge_count());
        let mut leaving: Vec<u32> = half_edges.filter(|&h| self.origin(h) == vertex).collect();
        let mut fans = 0;
        while let Some(start) = leaving.pop() {
            fans += 1;
            for forwards in [true, false] {
                let mut at = start;
                while let Some(next) = self.neighbour(at, forwards) {
                    let Some(place) = leaving.iter().position(|&h| h == next) else {
                        break;
                    };
                    leaving.swap_remove(place);
                    at = next;
                }
            }
        }
        fans
    }

    /// The next half-edge that leaves the same vertex, anticlockwise or clockwise.
    fn neighbour(&self, half_edge: u32, anticlockwise: bool) -> Option<u32> {
        if anticlockwise {
            self.twin(self.previous(half_edge))
        } else {
            self.twin(half_edge).map(|twin| self.next(twin))
        }
    }
}

/// An index as the arrays keep it.
pub(super) fn index_of(count: usize) -> u32 {
    u32::try_from(count).expect("counts were checked to fit 32 bits")
}

fn known(index: u32) -> Option<u32> {
    (index != NONE).then_some(index)
}
