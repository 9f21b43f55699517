//! The one reader of Wavefront OBJ files.
//!
//! The crate `tobj` parses; this layer does around it what it does not: comments behind a statement, continued lines, byte
//! order marks and vertex colours go first; polygons and polylines are told apart; every complaint names the line.

mod load;
mod statements;
mod with_normals;

use std::path::{Path, PathBuf};
use std::{fs, io};

use num_traits::Zero;
use thiserror::Error;

use self::load::Channel;
use self::statements::statements;
use super::{Mesh, MeshError};
use crate::algebra::VectorSpace;

/// What is wrong with an OBJ file.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum ObjError {
    /// The file cannot be read or written.
    #[error("{}: {source}", path.display())]
    File {
        /// Which file.
        path: PathBuf,
        /// What the system says.
        source: io::Error,
    },
    /// A line cannot be understood, or names what does not exist.
    #[error("{file}:{line}: {what} in \"{statement}\"")]
    Line {
        /// The file's name.
        file: String,
        /// Which line, counted from 1.
        line: usize,
        /// What is wrong, and what would be right.
        what: String,
        /// The statement without its comment, shortened.
        statement: String,
    },
    /// A name would not survive in a file.
    #[error("the name {name:?} of an object must be one line without #, and not end in \\")]
    Name {
        /// The name.
        name: String,
    },
    /// The file has no vertices.
    #[error(
        "{file}: there is no vertex in it (a line \"v x y z\"): is it an OBJ file, in plain text?"
    )]
    Empty {
        /// The file's name.
        file: String,
    },
}

/// A polygon or a polyline of a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Element {
    /// The name given by the last `o` or `g` line before it; empty where there is none.
    pub object: String,
    /// The line that it stands on, counted from 1.
    pub line: usize,
    /// The vertices, counted from 0.
    pub vertices: Vec<u32>,
    /// The normals of the same corners, counted from 0; empty where the file names none.
    pub normals: Vec<u32>,
}

/// The geometry of an OBJ file. Texture coordinates and materials are not read.
#[derive(Clone, Debug, PartialEq)]
pub struct Obj {
    /// The vertices' positions in the order of the file.
    pub positions: Vec<[f64; 3]>,
    /// The normals (`vn` lines) in the order of the file, of any length.
    pub normals: Vec<[f64; 3]>,
    /// The faces (`f` lines) in the order of the file.
    pub polygons: Vec<Element>,
    /// The polylines (`l` lines) in the order of the file.
    pub polylines: Vec<Element>,
}

impl Obj {
    /// Reads the file at `path`.
    ///
    /// # Errors
    ///
    /// [`ObjError`], with the line where one is to blame: unreadable numbers, coordinates that are not finite, indices out of
    /// range, faces with fewer than 3 vertices or a repeated one, with a normal at some corners only or with a normal that is zero, polylines
    /// with fewer than 2 vertices or the same one twice in a row.
    pub fn read(path: impl AsRef<Path>) -> Result<Self, ObjError> {
        let path = path.as_ref();
        let file = fs::File::open(path).map_err(|source| ObjError::File {
            path: path.into(),
            source,
        })?;
        Self::from_reader(&path.display().to_string(), file)
    }

    /// Reads all that `reader` gives, an open file or bytes in memory, and parses it; the name is for the messages.
    ///
    /// # Errors
    ///
    /// As [`Obj::read`].
    ///
    /// # Examples
    ///
    /// ```
    /// use facette::mesh::Obj;
    ///
    /// let bytes: &[u8] = b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    /// assert_eq!(Obj::from_reader("in memory", bytes)?.polygons.len(), 1);
    /// # Ok::<(), facette::mesh::ObjError>(())
    /// ```
    pub fn from_reader(file: &str, mut reader: impl io::Read) -> Result<Self, ObjError> {
        let mut bytes = Vec::new();
        reader
            .read_to_end(&mut bytes)
            .map_err(|source| ObjError::File {
                path: file.into(),
                source,
            })?;
        Self::parse(file, &String::from_utf8_lossy(&bytes))
    }

    /// Parses the text of a file, whose name is for the messages.
    ///
    /// # Errors
    ///
    /// As [`Obj::read`].
    pub fn parse(file: &str, text: &str) -> Result<Self, ObjError> {
        let statements = statements(text);
        let read = Channel::Positions.read(file, &statements)?;
        if read.vectors.is_empty() {
            return Err(ObjError::Empty {
                file: file.to_owned(),
            });
        }
        let named = Channel::Normals.read(file, &statements)?;
        let mut obj = Self {
            positions: read.vectors,
            normals: named.vectors,
            polygons: Vec::new(),
            polylines: Vec::new(),
        };
        let mut vertices = read.elements.into_iter();
        let mut normals = named.elements.into_iter();
        let mut object = "";
        for statement in &statements {
            if let "o" | "g" = statement.keyword() {
                object = statement.text.trim_start()[1..].trim();
            }
            if statement.is_element() {
                let of_face = statement.names_normals().then(|| normals.next()).flatten();
                let element = Element {
                    object: object.to_owned(),
                    line: statement.line,
                    vertices: vertices.next().unwrap_or_default(),
                    normals: of_face.unwrap_or_default(),
                };
                let is_face = statement.keyword() == "f";
                obj.keep(element, is_face)
                    .map_err(|what| statement.error(file, what))?;
            }
        }
        Ok(obj)
    }

    /// Files an element under polygons or polylines, or says what is wrong with it.
    fn keep(&mut self, element: Element, is_face: bool) -> Result<(), String> {
        let (kind, least) = if is_face {
            ("face", 3)
        } else {
            ("polyline", 2)
        };
        let vertices = &element.vertices;
        if vertices.len() < least {
            return Err(format!(
                "a {kind} needs at least {least} vertices, this has {}",
                vertices.len()
            ));
        }
        let repeated = if is_face {
            repeated(vertices)
        } else {
            repeated_at_once(vertices)
        };
        if let Some(vertex) = repeated {
            return Err(format!(
                "a {kind} must not name vertex {} twice",
                vertex + 1
            ));
        }
        let is_zero =
            |&&normal: &&u32| self.normals[normal as usize].largest_coordinate().is_zero();
        if let Some(normal) = element.normals.iter().find(is_zero) {
            return Err(format!(
                "a normal must not be zero, as number {} is",
                normal + 1
            ));
        }
        let list = if is_face {
            &mut self.polygons
        } else {
            &mut self.polylines
        };
        list.push(element);
        Ok(())
    }

    /// All polygons as one mesh, without normals.
    ///
    /// # Errors
    ///
    /// None that a file read by [`Obj::read`] can cause; those of [`Mesh::new`] for one put together by hand.
    pub fn mesh(&self) -> Result<Mesh<[f64; 3]>, MeshError> {
        Mesh::new(
            self.positions.clone(),
            self.polygons.iter().map(|polygon| &polygon.vertices),
        )
    }

    /// The positions of a polyline's or polygon's vertices.
    ///
    /// # Panics
    ///
    /// For an element of another file, whose vertices this one has not.
    pub fn points(&self, element: &Element) -> Vec<[f64; 3]> {
        element
            .vertices
            .iter()
            .map(|&vertex| self.positions[vertex as usize])
            .collect()
    }
}

/// A vertex that stands in the list more than once.
fn repeated(vertices: &[u32]) -> Option<u32> {
    let mut sorted = vertices.to_vec();
    sorted.sort_unstable();
    repeated_at_once(&sorted)
}

/// A vertex that stands in the list twice in a row.
fn repeated_at_once(vertices: &[u32]) -> Option<u32> {
    vertices
        .windows(2)
        .find(|pair| pair[0] == pair[1])
        .map(|pair| pair[0])
}
