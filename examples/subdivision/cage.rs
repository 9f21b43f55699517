//! The cage in an OBJ file: read, mended and cut into triangles as asked, or refused with the lines to blame.

use std::error::Error;
use std::path::Path;

use facette::mesh::{Mesh, Obj};
use facette::subdivision::{Connectivity, Repair, SubdivisionError, repaired};
use glam::DVec3;

use super::figures::scheme::Scheme;
use super::request::Request;

/// Reads the cage of a request, as its scheme can take it.
pub fn read(request: &Request) -> Result<Mesh<DVec3>, Box<dyn Error>> {
    let obj = Obj::read(&request.cage)?;
    let file = request.cage.display().to_string();
    if obj.polygons.is_empty() {
        return Err(format!("{file}: there is no face in it (a line \"f 1 2 3 4\")").into());
    }
    let positions = obj.positions.iter().copied().map(DVec3::from).collect();
    let faces = obj.polygons.iter().map(|polygon| &polygon.vertices);
    let mesh = Mesh::new(positions, faces).map_err(|error| format!("{file}: {error}"))?;
    let lines = obj.polygons.iter().map(|polygon| polygon.line).collect();
    let mut cage = Cage { file, mesh, lines };
    if request.repair {
        cage.repair()?;
    } else {
        cage.must_be_manifold()?;
    }
    if request.triangulate {
        return Ok(cage.mesh.triangulated());
    }
    cage.must_suit(request.scheme)?;
    Ok(cage.mesh)
}

/// A cage, and where its faces come from.
struct Cage {
    file: String,
    mesh: Mesh<DVec3>,
    /// The line of each face; empty after a repair, which leaves faces out.
    lines: Vec<usize>,
}

impl Cage {
    fn repair(&mut self) -> Result<(), String> {
        let mended = repaired(&self.mesh).map_err(|error| format!("{}: {error}", self.file))?;
        let Repair {
            faces_dropped,
            faces_turned,
            vertices_added,
            ..
        } = mended.1;
        println!(
            "{}: {faces_dropped} faces left out, {faces_turned} turned over, {vertices_added} vertices doubled",
            self.file
        );
        self.mesh = mended.0;
        self.lines.clear();
        Ok(())
    }

    fn must_be_manifold(&self) -> Result<(), String> {
        match Connectivity::new(&self.mesh) {
            Ok(_) => Ok(()),
            Err(error) => Err(format!("{} (--repair mends it)", self.located(&error))),
        }
    }

    fn must_suit(&self, scheme: Scheme) -> Result<(), String> {
        let polygon = self.mesh.faces().zip(0..).find(|(face, _)| face.len() != 3);
        match polygon.filter(|_| scheme.wants_triangles()) {
            None => Ok(()),
            Some((vertices, face)) => Err(format!(
                "{}: this face has {} vertices, but {} is made for triangles (--triangulate cuts faces first)",
                self.place_of(&[face]),
                vertices.len(),
                scheme.title()
            )),
        }
    }

    /// A complaint in the file's own terms: lines instead of faces, and vertices counted from 1.
    fn located(&self, error: &SubdivisionError) -> String {
        match *error {
            SubdivisionError::FaceRepeated { face, first } => format!(
                "{}: the same face twice: each may be there once",
                self.place_of(&[first, face])
            ),
            SubdivisionError::NonManifoldEdge {
                edge: [a, b],
                count,
            } => format!(
                "{}: {count} faces meet along the edge from vertex {} to vertex {}: at most 2 can",
                self.place_of(&self.faces_with(&[a, b])),
                a + 1,
                b + 1
            ),
            SubdivisionError::InconsistentOrientation {
                edge: [a, b],
                faces,
            } => format!(
                "{}: both faces run from vertex {} to vertex {}: one of them is turned over",
                self.place_of(&faces),
                a + 1,
                b + 1
            ),
            SubdivisionError::NonManifoldVertex { vertex, fans } => format!(
                "{}: the faces around vertex {} form {fans} fans that share no edge: a vertex can have 1",
                self.place_of(&self.faces_with(&[vertex])),
                vertex + 1
            ),
            ref other => format!("{}: {other}", self.file),
        }
    }

    /// The faces that visit all these vertices.
    fn faces_with(&self, vertices: &[u32]) -> Vec<usize> {
        let faces = self.mesh.faces().enumerate();
        let visit_all = |face: &[u32]| vertices.iter().all(|vertex| face.contains(vertex));
        faces
            .filter(|(_, face)| visit_all(face))
            .map(|(number, _)| number)
            .collect()
    }

    /// The file and the lines of these faces, as "cage.obj:3" or "cage.obj:3, 7 and 9".
    fn place_of(&self, faces: &[usize]) -> String {
        let lines = faces.iter().filter_map(|&face| self.lines.get(face));
        let mut lines: Vec<String> = lines.map(ToString::to_string).collect();
        let Some(last) = lines.pop() else {
            return self.file.clone();
        };
        if lines.is_empty() {
            format!("{}:{last}", self.file)
        } else {
            format!("{}:{} and {last}", self.file, lines.join(", "))
        }
    }
}

/// Whether two names are of one file that exists.
pub fn is_same_file(one: &Path, other: &Path) -> bool {
    let full = [one, other].map(Path::canonicalize);
    matches!(full, [Ok(one), Ok(other)] if one == other)
}
