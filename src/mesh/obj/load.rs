//! What `tobj` is given, what it makes of it, and which line is to blame where it refuses.
//!
//! Positions and normals are read one after the other in the same way: for `tobj` the normals are the positions of a file of their own.

use std::fmt::Write as _;
use std::path::Path;

use tobj::{LoadError, LoadOptions};

use super::ObjError;
use super::statements::{Statement, normal_of};
use crate::algebra::VectorSpace;

/// Which of the numbers in a corner `a/b/c` are read.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Channel {
    /// The first, which names a line `v x y z`.
    Positions,
    /// The third, which names a line `vn x y z`.
    Normals,
}

/// The vectors of a channel, and for each of its elements the numbers of those that it names, counted from 0.
pub(super) struct Numbers {
    pub vectors: Vec<[f64; 3]>,
    pub elements: Vec<Vec<u32>>,
}

impl Channel {
    /// The vectors and elements of the channel in the order of the file.
    pub fn read(self, file: &str, statements: &[Statement]) -> Result<Numbers, ObjError> {
        let mesh = self.load(statements, |_| true);
        let mesh = mesh.map_err(|error| self.blame(file, statements, error))?;
        let mut read = Numbers {
            vectors: Vec::new(),
            elements: Vec::new(),
        };
        let Some(mesh) = mesh else {
            return Ok(read);
        };
        read.vectors = mesh.positions.as_chunks().0.to_vec();
        let lines = statements.iter().filter(|line| self.is_vector(line));
        for (vector, statement) in read.vectors.iter().zip(lines) {
            if !vector.has_finite_coordinates() {
                return Err(statement.error(file, "a coordinate is not finite".to_owned()));
            }
        }
        // The first element is the one that `load` has put before the file's own.
        let mut rest = &mesh.indices[read.vectors.len()..];
        let mut arities = mesh.face_arities.iter().skip(1);
        for _ in statements.iter().filter(|line| self.is_element(line)) {
            let arity = arities.next().map_or(3, |&arity| arity as usize);
            let (element, others) = rest.split_at(arity.min(rest.len()));
            rest = others;
            read.elements.push(element.to_vec());
        }
        Ok(read)
    }

    fn is_vector(self, statement: &Statement) -> bool {
        let keyword = match self {
            Self::Positions => "v",
            Self::Normals => "vn",
        };
        statement.keyword() == keyword
    }

    fn is_element(self, statement: &Statement) -> bool {
        match self {
            Self::Positions => statement.is_element(),
            Self::Normals => statement.names_normals(),
        }
    }

    /// The one mesh that `tobj` makes of the channel in those statements for which `wanted` holds; `None` without vectors.
    ///
    /// Objects and groups are left out, since `tobj` would number the vertices of each anew; and a first face that names all
    /// vertices in order goes before the others, since `tobj` keeps the vertices in the order of their first use.
    fn load(
        self,
        statements: &[Statement],
        wanted: impl Fn(&Statement) -> bool,
    ) -> Result<Option<tobj::Mesh>, LoadError> {
        let is_read =
            |line: &&Statement| (self.is_vector(line) || self.is_element(line)) && wanted(line);
        let wanted: Vec<_> = statements.iter().filter(is_read).collect();
        let vectors = wanted.iter().filter(|line| self.is_vector(line)).count();
        let mut text = String::from("f");
        for vector in 1..=vectors {
            // Writing to a string cannot fail.
            let _ = write!(text, " {vector}");
        }
        for statement in wanted {
            text.push('\n');
            text.push_str(&self.for_tobj(statement));
        }
        let options = LoadOptions::default();
        let no_materials = |_: &Path| Ok((Vec::new(), std::collections::HashMap::default()));
        let (models, _) = tobj::load_obj_buf(&mut text.as_bytes(), &options, no_materials)?;
        Ok(models
            .into_iter()
            .next()
            .map(|model| model.mesh)
            .filter(|_| vectors > 0))
    }

    /// What `tobj` is given for a statement: no colours, and of a face's corners one number only. A corner without it becomes a
    /// word that it refuses.
    fn for_tobj(self, statement: &Statement) -> String {
        let words = statement.words();
        let joined = |words: Vec<&str>| words.join(" ");
        match (self, statement.keyword()) {
            (Self::Positions, "v") if words.clone().count() == 7 => joined(words.take(4).collect()),
            (Self::Positions, "v") => statement.text.clone(),
            (Self::Normals, "vn") if words.clone().count() == 4 => {
                joined(std::iter::once("v").chain(words.skip(1)).collect())
            }
            (Self::Normals, "vn") => "v ?".to_owned(),
            (Self::Positions, _) => joined(
                words
                    .map(|word| match word.split_once('/') {
                        Some(("", _)) => "?",
                        Some((position, _)) => position,
                        None => word,
                    })
                    .collect(),
            ),
            (Self::Normals, _) => {
                let normals = words.skip(1).map(|word| normal_of(word).unwrap_or("?"));
                joined(std::iter::once("f").chain(normals).collect())
            }
        }
    }

    /// The complaint of `tobj` with the line that caused it, found by bisection.
    fn blame(self, file: &str, statements: &[Statement], error: LoadError) -> ObjError {
        let vectors_fail = self.load(statements, |line| !line.is_element()).is_err();
        let up_to = |last: &Statement| {
            self.load(statements, |line| {
                let early = line.line <= last.line;
                if vectors_fail {
                    early && !line.is_element()
                } else {
                    early || !line.is_element()
                }
            })
        };
        let first = statements.partition_point(|statement| up_to(statement).is_ok());
        // A file with several mistakes has several complaints: this line's own is wanted.
        let own = statements.get(first).and_then(|last| up_to(last).err());
        let what = self.explain(statements, own.unwrap_or(error));
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

    /// The complaint of `tobj` in words that say what would be right.
    fn explain(self, statements: &[Statement], error: LoadError) -> String {
        let count = statements
            .iter()
            .filter(|line| self.is_vector(line))
            .count();
        match (error, self) {
            (LoadError::FaceVertexOutOfBounds, Self::Positions) => format!(
                "a vertex number is out of range: the file has {count} vertices, counted from 1; negative numbers count back from the line"
            ),
            (LoadError::FaceVertexOutOfBounds, Self::Normals) => format!(
                "a normal number is out of range: the file has {count} normals (lines \"vn x y z\"), counted from 1; negative numbers count back from the line"
            ),
            (LoadError::FaceParseError, Self::Positions) => {
                "expected vertex numbers, as 1 or 1/2/3".to_owned()
            }
            (LoadError::FaceParseError, Self::Normals) => {
                "expected the number of a normal at every corner, as 1//3 or 1/2/3, or at none"
                    .to_owned()
            }
            (LoadError::PositionParseError, _) => "expected three numbers x y z".to_owned(),
            (LoadError::ScalingByZeroError, _) => {
                "the fourth number divides the others: not 0".to_owned()
            }
            (LoadError::ColorParseError, _) => {
                "expected 3 numbers, 4, or 3 and 3 of a colour".to_owned()
            }
            (other, _) => other.to_string(),
        }
    }
}
