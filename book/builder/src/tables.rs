//! The tables beside the book: bibliography, glossary, exercises.

use crate::problem::{Problems, line_of};
use anyhow::{Context, Result};
use serde::Deserialize;
use serde::de::DeserializeOwned;
use std::fs;
use std::path::{Path, PathBuf};

/// A work that the book cites.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Work {
    /// How pages cite it.
    pub key: String,
    /// Its authors' names, in order.
    pub authors: Vec<String>,
    /// Its title.
    pub title: String,
    /// The year it appeared.
    pub year: u16,
    /// Where it appeared.
    pub published: String,
    /// What one finds in it, where that is worth saying (Markdown).
    pub note: Option<String>,
}

impl Work {
    /// The text of a citation: `Coons 1967`, `Ogita et al. 2005`.
    #[must_use]
    pub fn label(&self) -> String {
        let names = match self.authors.as_slice() {
            [] => self.title.clone(),
            [one] => surname(one).to_owned(),
            [one, two] => format!("{} and {}", surname(one), surname(two)),
            [one, ..] => format!("{} et al.", surname(one)),
        };
        format!("{names} {}", self.year)
    }
}

/// The last word of a name, with the particles before it: `de Boor` of `Carl de Boor`. A particle is a word in small letters.
fn surname(name: &str) -> &str {
    let is_particle = |word: &str| word.chars().all(char::is_lowercase);
    let word_start = |end: usize| name[..end].rfind(' ').map_or(0, |space| space + 1);
    let mut start = word_start(name.len());
    while start > 0 {
        let before = word_start(start - 1);
        if !is_particle(&name[before..start - 1]) {
            break;
        }
        start = before;
    }
    &name[start..]
}

/// A French term of the course.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Term {
    /// The term on the slides.
    pub french: String,
    /// The term in this book.
    pub english: String,
    /// What it means (Markdown).
    pub meaning: String,
    /// The chapter that treats it; none if the book leaves it out or has not come to it.
    pub chapter: Option<String>,
}

/// An exercise of a chapter.
#[derive(Debug, Clone, Deserialize)]
pub struct Exercise {
    /// Its name on the command line.
    pub name: String,
    /// Its name in the book.
    pub title: String,
    /// The file that the reader edits.
    pub file: String,
    /// The functions to write.
    pub functions: Vec<String>,
}

/// The exercises of one chapter.
#[derive(Debug, Clone, Deserialize)]
pub struct ExerciseList {
    /// The chapter.
    pub chapter: String,
    /// The page that explains them.
    pub page: String,
    /// The exercises in their order.
    #[serde(rename = "exercise", default)]
    pub exercises: Vec<Exercise>,
    /// The file it was read from.
    #[serde(skip)]
    pub file: PathBuf,
    /// The text of that file.
    #[serde(skip)]
    pub text: String,
}

/// A table and the file it was read from.
#[derive(Debug, Default)]
pub struct Table<T> {
    /// The rows.
    pub rows: Vec<T>,
    /// The file, relative to the root.
    pub file: PathBuf,
    /// Its text.
    pub text: String,
}

impl<T> Table<T> {
    /// The line of the first place that says `field = "value"`.
    #[must_use]
    pub fn line(&self, field: &str, value: &str) -> usize {
        field_line(&self.text, field, value)
    }
}

/// The line of the first place in a TOML text that says `field = "value"`.
#[must_use]
pub fn field_line(text: &str, field: &str, value: &str) -> usize {
    let wanted = format!("{field} = \"{value}\"");
    text.find(&wanted).map_or(1, |offset| line_of(text, offset))
}

#[derive(Deserialize)]
struct Rows<T> {
    #[serde(default = "Vec::new")]
    entry: Vec<T>,
}

/// Reads a file of `[[entry]]` tables; a missing file is an empty table.
///
/// # Errors
/// Where the file cannot be read.
pub fn read<T: DeserializeOwned>(
    root: &Path,
    file: &str,
    problems: &mut Problems,
) -> Result<Table<T>> {
    let path = PathBuf::from(file);
    let text = match fs::read_to_string(root.join(&path)) {
        Ok(text) => text,
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => String::new(),
        Err(error) => return Err(error).with_context(|| format!("cannot read {file}")),
    };
    let rows = parse::<Rows<T>>(&text, &path, problems).map_or_else(Vec::new, |rows| rows.entry);
    Ok(Table {
        rows,
        file: path,
        text,
    })
}

fn parse<T: DeserializeOwned>(text: &str, file: &Path, problems: &mut Problems) -> Option<T> {
    toml::from_str(text)
        .map_err(|error| {
            let offset = error.span().map_or(0, |span| span.start);
            problems.add(file, line_of(text, offset), error.message());
        })
        .ok()
}

/// Reads `book/exercises/*/exercise.toml`.
///
/// # Errors
/// Where a file or folder cannot be read.
pub fn exercises(root: &Path, problems: &mut Problems) -> Result<Vec<ExerciseList>> {
    let folder = Path::new("book/exercises");
    let mut lists = Vec::new();
    if !root.join(folder).is_dir() {
        return Ok(lists);
    }
    for entry in fs::read_dir(root.join(folder))? {
        let file = folder.join(entry?.file_name()).join("exercise.toml");
        if !root.join(&file).is_file() {
            continue;
        }
        let text = fs::read_to_string(root.join(&file))
            .with_context(|| format!("cannot read {}", file.display()))?;
        if let Some(list) = parse::<ExerciseList>(&text, &file, problems) {
            lists.push(ExerciseList { file, text, ..list });
        }
    }
    lists.sort_by(|a, b| a.chapter.cmp(&b.chapter));
    Ok(lists)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn work(authors: &[&str]) -> Work {
        Work {
            key: "k".into(),
            authors: authors.iter().map(ToString::to_string).collect(),
            title: "T".into(),
            year: 1967,
            published: "P".into(),
            note: None,
        }
    }

    #[test]
    fn citations_name_up_to_two_authors() {
        assert_eq!(work(&["Steven A. Coons"]).label(), "Coons 1967");
        assert_eq!(work(&["A. B", "C. D"]).label(), "B and D 1967");
        assert_eq!(work(&["A. B", "C. D", "E. F"]).label(), "B et al. 1967");
    }

    #[test]
    fn citations_keep_the_particles_of_a_name() {
        assert_eq!(work(&["Carl de Boor"]).label(), "de Boor 1967");
        assert_eq!(
            work(&["A. van der B", "de C"]).label(),
            "van der B and de C 1967"
        );
        assert_eq!(work(&["Euclid"]).label(), "Euclid 1967");
    }

    #[test]
    fn a_broken_table_is_a_problem_with_its_line() {
        let mut problems = Problems::default();
        let text = "[[entry]]\nkey = \"a\"\nyear = \"x\"\n";
        let rows: Option<Rows<Work>> = parse(text, Path::new("b.toml"), &mut problems);
        assert!(rows.is_none());
        assert_eq!(problems.into_sorted()[0].line, 3);
    }

    #[test]
    fn a_row_is_found_by_a_field() {
        assert_eq!(
            field_line(
                "[[entry]]\nkey = \"a\"\n[[entry]]\nkey = \"b\"\n",
                "key",
                "b"
            ),
            4
        );
    }
}
