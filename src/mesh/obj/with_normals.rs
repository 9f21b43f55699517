//! From the corners of a file's faces, which name a position and a normal each, to vertices that have one of either.

use std::collections::HashMap;

use super::Obj;
use crate::algebra::{VectorSpace, unit_vector};
use crate::mesh::{Mesh, MeshError};

impl Obj {
    /// All polygons cut into triangles, with a unit normal at every vertex: the file's where it has one, and otherwise the one that
    /// [`Mesh::vertex_normals`] makes of all triangles there.
    ///
    /// # Shape
    ///
    /// The vertices keep their numbers and their bits. Where the corners at a vertex do not all have the same unit normal, as along a crease, the
    /// vertex is split: the first corner's normal stays with it, and every other one has a copy of it behind the file's own vertices. A vertex of no face has the normal zero.
    ///
    /// # Accuracy
    ///
    /// That of [`unit_vector`] for the file's normals.
    ///
    /// # Errors
    ///
    /// None that a file read by [`Obj::read`] can cause, up to 2³² vertices; those of [`Mesh::new`] for one put together by hand, and
    /// for one that names a normal which it does not have.
    ///
    /// # Examples
    ///
    /// ```
    /// use facette::mesh::Obj;
    ///
    /// let folded = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 1 0 1\nv 0 0 1\nvn 0 0 2\nf 1//1 2//1 3//1 4//1\nf 1 6 5 2\n";
    /// let mesh = Obj::parse("folded.obj", folded)?.mesh_with_normals()?;
    /// assert_eq!((mesh.positions.len(), mesh.face_count()), (8, 4));
    /// assert_eq!((mesh.normals[3], mesh.normals[4]), ([0., 0., 1.], [0., 1., 0.]));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn mesh_with_normals(&self) -> Result<Mesh<[f64; 3]>, MeshError> {
        let is_complete = self.polygons.iter().all(|face| !face.normals.is_empty());
        let computed = if is_complete {
            Vec::new()
        } else {
            self.mesh()?.triangulated().vertex_normals()
        };
        let mut vertices = Vertices::new(&self.positions);
        let mut faces = Vec::with_capacity(self.polygons.len());
        for (face, polygon) in self.polygons.iter().enumerate() {
            let mut corners = Vec::with_capacity(polygon.vertices.len());
            for (place, &vertex) in polygon.vertices.iter().enumerate() {
                let known = self.normal(face, place)?;
                let normal = known.or_else(|| computed.get(vertex as usize).copied());
                corners.push(vertices.with_normal(vertex, normal.unwrap_or_default()));
            }
            faces.push(corners);
        }
        let mut mesh = Mesh::new(vertices.positions, faces)?;
        let normals = vertices.normals.into_iter();
        mesh.normals = normals.map(Option::unwrap_or_default).collect();
        Ok(mesh.triangulated())
    }

    /// The unit normal that a corner names; `None` where its polygon names none.
    fn normal(&self, face: usize, place: usize) -> Result<Option<[f64; 3]>, MeshError> {
        let normals = &self.polygons[face].normals;
        if normals.is_empty() {
            return Ok(None);
        }
        let number = normals.get(place).copied().unwrap_or(u32::MAX);
        let named = self.normals.get(number as usize);
        let unit = named.copied().and_then(unit_vector);
        let no_such = MeshError::NoSuchNormal {
            face,
            normal: number,
            count: self.normals.len(),
        };
        unit.map(Some).ok_or(no_such)
    }
}

/// The vertices of the mesh in the making.
struct Vertices {
    positions: Vec<[f64; 3]>,
    /// `None` as long as no corner has used the vertex.
    normals: Vec<Option<[f64; 3]>>,
    /// The copies of vertices that are split, by the bits of their normals.
    copies: HashMap<(u32, [u64; 3]), u32>,
}

impl Vertices {
    fn new(positions: &[[f64; 3]]) -> Self {
        Self {
            positions: positions.to_vec(),
            normals: vec![None; positions.len()],
            copies: HashMap::new(),
        }
    }

    /// The number of the vertex at the position of `vertex` with this normal.
    fn with_normal(&mut self, vertex: u32, normal: [f64; 3]) -> u32 {
        // A zero has two signs, and one meaning.
        let normal = normal.plus([0.0; 3]);
        match self.normals.get_mut(vertex as usize) {
            // `Mesh::new` refuses the face of a vertex that does not exist.
            None => vertex,
            Some(unused @ None) => {
                *unused = Some(normal);
                vertex
            }
            Some(Some(first)) if first.map(f64::to_bits) == normal.map(f64::to_bits) => vertex,
            Some(Some(_)) => self.copy(vertex, normal),
        }
    }

    fn copy(&mut self, vertex: u32, normal: [f64; 3]) -> u32 {
        let bits = normal.map(f64::to_bits);
        let Self {
            positions,
            normals,
            copies,
        } = self;
        *copies.entry((vertex, bits)).or_insert_with(|| {
            let number = u32::try_from(positions.len()).unwrap_or(u32::MAX);
            positions.push(positions[vertex as usize]);
            normals.push(Some(normal));
            number
        })
    }
}
