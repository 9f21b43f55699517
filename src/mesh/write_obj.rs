//! The one writer of Wavefront OBJ files.

use std::fmt::{Display, Write as _};
use std::fs;
use std::path::Path;

use super::{Mesh, ObjError};
use crate::algebra::Vector3;

/// Writes `mesh` as the object `name` to the file at `path`, with its normals and parameters (`vt`) where it has them; a
/// failure leaves no half-written file.
///
/// # Accuracy
///
/// Numbers are written with as many digits as it takes to read the same bits back.
///
/// # Errors
///
/// [`ObjError::Name`] for a name that the file could not give back; [`ObjError::File`] where the system refuses.
pub fn write_obj<P>(path: impl AsRef<Path>, name: &str, mesh: &Mesh<P>) -> Result<(), ObjError>
where
    P: Vector3,
    P::Scalar: Display,
{
    let name = name.trim();
    if name.contains(['\n', '\r', '#']) || name.ends_with('\\') {
        return Err(ObjError::Name {
            name: name.to_owned(),
        });
    }
    let path = path.as_ref();
    let mut unfinished = path.as_os_str().to_owned();
    unfinished.push(".unfinished");
    let written =
        fs::write(&unfinished, obj_text(name, mesh)).and_then(|()| fs::rename(&unfinished, path));
    written.map_err(|source| {
        // The first error is the one to report; there may be nothing to remove.
        let _ = fs::remove_file(&unfinished);
        ObjError::File {
            path: path.into(),
            source,
        }
    })
}

/// The OBJ file of a mesh, as text.
fn obj_text<P>(name: &str, mesh: &Mesh<P>) -> String
where
    P: Vector3,
    P::Scalar: Display,
{
    let mut text = format!("o {name}\n");
    let mut line = |keyword: &str, numbers: &[P::Scalar]| {
        text.push_str(keyword);
        for number in numbers {
            let _ = write!(text, " {number}");
        }
        text.push('\n');
    };
    for &position in &mesh.positions {
        line("v", &position.coordinates());
    }
    for parameters in &mesh.parameters {
        line("vt", parameters);
    }
    for &normal in &mesh.normals {
        line("vn", &normal.coordinates());
    }
    for face in mesh.faces() {
        text.push('f');
        for vertex in face.iter().map(|&vertex| u64::from(vertex) + 1) {
            let _ = match (mesh.parameters.is_empty(), mesh.normals.is_empty()) {
                (true, true) => write!(text, " {vertex}"),
                (false, true) => write!(text, " {vertex}/{vertex}"),
                (true, false) => write!(text, " {vertex}//{vertex}"),
                (false, false) => write!(text, " {vertex}/{vertex}/{vertex}"),
            };
        }
        text.push('\n');
    }
    text
}
