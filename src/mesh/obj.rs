//! The one reader of Wavefront OBJ files.
//!
//! The crate `tobj` parses; this layer does around it what it does not: comments behind a statement, continued lines, byte
//! order marks and vertex colours go first; polygons and polylines are told apart; every complaint names the line.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::{fs, io};

use thiserror::Error;
use tobj::{LoadError, LoadOptions};

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
}

/// The geometry of an OBJ file. Texture coordinates, normals and materials are not read.
#[derive(Clone, Debug, PartialEq)]
pub struct Obj {
    /// The vertices' positions in the order of the file.
    pub positions: Vec<[f64; 3]>,
    /// The faces (`f` lines) in the order of the file.
    pub polygons: Vec<Element>,
    /// The polylines (`l` lines) in the order of the file.
    pub polylines: Vec<Element>,
}

/// A line of the file without its comment, continued lines joined.
struct Statement {
    line: usize,
    text: String,
}

impl Statement {
    fn keyword(&self) -> &str {
        self.text.split_whitespace().next().unwrap_or_default()
    }

    fn is_element(&self) -> bool {
        matches!(self.keyword(), "f" | "l")
    }

    fn error(&self, file: &str, what: String) -> ObjError {
        let mut statement: String = self.text.chars().take(60).collect();
        if statement.len() < self.text.len() {
            statement.push_str(" ...");
        }
        ObjError::Line {
            file: file.to_owned(),
            line: self.line,
            what,
            statement,
        }
    }
}

impl Obj {
    /// Reads the file at `path`.
    ///
    /// # Errors
    ///
    /// [`ObjError`], with the line where one is to blame: unreadable numbers, coordinates that are not finite, indices out of
    /// range, faces with fewer than 3 vertices or a repeated one, polylines with fewer than 2 or the same one twice in a row.
    pub fn read(path: impl AsRef<Path>) -> Result<Self, ObjError> {
        let path = path.as_ref();
        let text = fs::read(path).map_err(|source| ObjError::File {
            path: path.into(),
            source,
        })?;
        Self::parse(&path.display().to_string(), &String::from_utf8_lossy(&text))
    }

    /// Parses the text of a file, whose name is for the messages.
    ///
    /// # Errors
    ///
    /// As [`Obj::read`].
    pub fn parse(file: &str, text: &str) -> Result<Self, ObjError> {
        let statements = statements(text);
        let mesh = load(&statements, |_| true).map_err(|error| blame(file, &statements, error))?;
        let vertices: Vec<_> = statements
            .iter()
            .filter(|line| line.keyword() == "v")
            .collect();
        let Some(mesh) = mesh else {
            return Err(ObjError::Empty {
                file: file.to_owned(),
            });
        };
        let positions: Vec<[f64; 3]> = mesh.positions.as_chunks().0.to_vec();
        for (position, statement) in positions.iter().zip(&vertices) {
            if !position.has_finite_coordinates() {
                return Err(statement.error(file, "a coordinate is not finite".to_owned()));
            }
        }
        let mut obj = Self {
            positions,
            polygons: Vec::new(),
            polylines: Vec::new(),
        };
        // The first element is the one that `load` has put before the file's own.
        let mut rest = &mesh.indices[vertices.len()..];
        let mut arities = mesh.face_arities.iter().skip(1);
        let mut object = "";
        for statement in &statements {
            if let "o" | "g" = statement.keyword() {
                object = statement.text.trim_start()[1..].trim();
            }
            if statement.is_element() {
                let arity = arities.next().map_or(3, |&arity| arity as usize);
                let (vertices, others) = rest.split_at(arity.min(rest.len()));
                rest = others;
                obj.keep(file, statement, object, vertices)?;
            }
        }
        Ok(obj)
    }

    /// Files a checked element under polygons or polylines.
    fn keep(
        &mut self,
        file: &str,
        statement: &Statement,
        object: &str,
        vertices: &[u32],
    ) -> Result<(), ObjError> {
        let is_face = statement.keyword() == "f";
        let (kind, least) = if is_face {
            ("face", 3)
        } else {
            ("polyline", 2)
        };
        if vertices.len() < least {
            let what = format!(
                "a {kind} needs at least {least} vertices, this has {}",
                vertices.len()
            );
            return Err(statement.error(file, what));
        }
        let repeated = if is_face {
            repeated(vertices)
        } else {
            repeated_at_once(vertices)
        };
        if let Some(vertex) = repeated {
            let what = format!("a {kind} must not name vertex {} twice", vertex + 1);
            return Err(statement.error(file, what));
        }
        let list = if is_face {
            &mut self.polygons
        } else {
            &mut self.polylines
        };
        list.push(Element {
            object: object.to_owned(),
            line: statement.line,
            vertices: vertices.to_vec(),
        });
        Ok(())
    }

    /// All polygons as one mesh.
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

/// The statements of a file that say something about geometry, cleaned for `tobj`.
fn statements(text: &str) -> Vec<Statement> {
    let text = text
        .trim_start_matches('\u{feff}')
        .replace("\r\n", "\n")
        .replace('\r', "\n");
    let mut statements: Vec<Statement> = Vec::new();
    let mut continues = false;
    for (index, raw) in text.lines().enumerate() {
        let uncommented = without_comment(raw).trim();
        let (part, goes_on) = match uncommented.strip_suffix('\\') {
            Some(part) => (part, true),
            None => (uncommented, false),
        };
        match statements.last_mut() {
            Some(last) if continues => {
                last.text.push(' ');
                last.text.push_str(part);
            }
            _ => statements.push(Statement {
                line: index + 1,
                text: part.to_owned(),
            }),
        }
        continues = goes_on;
    }
    statements.retain(|line| matches!(line.keyword(), "v" | "f" | "l" | "o" | "g"));
    statements
}

/// The line up to its comment: a `#` at the start of a word.
fn without_comment(line: &str) -> &str {
    let begins = |&(at, _): &(usize, &str)| {
        line[..at]
            .chars()
            .next_back()
            .is_none_or(char::is_whitespace)
    };
    line.match_indices('#')
        .find(begins)
        .map_or(line, |(at, _)| &line[..at])
}

/// What `tobj` is given for a statement: no colours, and of a face's corners the positions only. A corner without a position
/// becomes a word that it refuses.
fn for_tobj(statement: &Statement) -> String {
    let words = statement.text.split_whitespace();
    match statement.keyword() {
        "v" if words.clone().count() == 7 => words.take(4).collect::<Vec<_>>().join(" "),
        "v" => statement.text.clone(),
        _ => words
            .map(|word| match word.split_once('/') {
                Some(("", _)) => "?",
                Some((position, _)) => position,
                None => word,
            })
            .collect::<Vec<_>>()
            .join(" "),
    }
}

/// The one mesh that `tobj` makes of the geometry in those statements for which `wanted` holds; `None` without vertices.
///
/// Objects and groups are left out, since `tobj` would number the vertices of each anew; and a first face that names all
/// vertices in order goes before the others, since `tobj` keeps the vertices in the order of their first use.
fn load(
    statements: &[Statement],
    wanted: impl Fn(&Statement) -> bool,
) -> Result<Option<tobj::Mesh>, LoadError> {
    let geometry = |line: &&Statement| !matches!(line.keyword(), "o" | "g") && wanted(line);
    let wanted: Vec<_> = statements.iter().filter(geometry).collect();
    let vertices = wanted.iter().filter(|line| line.keyword() == "v").count();
    let mut text = String::from("f");
    for vertex in 1..=vertices {
        // Writing to a string cannot fail.
        let _ = write!(text, " {vertex}");
    }
    for statement in wanted {
        text.push('\n');
        text.push_str(&for_tobj(statement));
    }
    let options = LoadOptions::default();
    let no_materials = |_: &Path| Ok((Vec::new(), std::collections::HashMap::default()));
    let (models, _) = tobj::load_obj_buf(&mut text.as_bytes(), &options, no_materials)?;
    Ok(models
        .into_iter()
        .next()
        .map(|model| model.mesh)
        .filter(|_| vertices > 0))
}

/// The complaint of `tobj` with the line that caused it, found by bisection.
fn blame(file: &str, statements: &[Statement], error: LoadError) -> ObjError {
    let vertices_fail = load(statements, |line| !line.is_element()).is_err();
    let up_to = |last: &Statement| {
        load(statements, |line| {
            let early = line.line <= last.line;
            if vertices_fail {
                early && !line.is_element()
            } else {
                early || !line.is_element()
            }
        })
    };
    let first = statements.partition_point(|statement| up_to(statement).is_ok());
    // A file with several mistakes has several complaints: this line's own is wanted.
    let own = statements.get(first).and_then(|last| up_to(last).err());
    let error = own.unwrap_or(error);
    let count = statements
        .iter()
        .filter(|line| line.keyword() == "v")
        .count();
    let what = match error {
        LoadError::FaceVertexOutOfBounds => {
            format!(
                "a vertex number is out of range: the file has {count} vertices, counted from 1; negative numbers count back from the line"
            )
        }
        LoadError::FaceParseError => "expected vertex numbers, as 1 or 1/2/3".to_owned(),
        LoadError::PositionParseError => "expected three numbers x y z".to_owned(),
        LoadError::ScalingByZeroError => "the fourth number divides the others: not 0".to_owned(),
        LoadError::ColorParseError => "expected 3 numbers, 4, or 3 and 3 of a colour".to_owned(),
        other => other.to_string(),
    };
    match statements.get(first) {
        Some(statement) => statement.error(file, what),
        None => ObjError::Line {
            file: file.into(),
            line: 0,
            what,
            statement: String::new(),
        },
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
