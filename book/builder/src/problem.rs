//! What is wrong with the book, and where.

use std::fmt;
use std::path::{Path, PathBuf};

/// One thing that is wrong, with the file and line to look at.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub struct Problem {
    /// The file, relative to the root of the repository.
    pub file: PathBuf,
    /// The line, from 1.
    pub line: usize,
    /// What is wrong and what is expected.
    pub message: String,
}

impl fmt::Display for Problem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}: {}", self.file.display(), self.line, self.message)
    }
}

/// The problems found so far: all of them are collected before the builder gives up.
#[derive(Debug, Default)]
pub struct Problems(Vec<Problem>);

impl Problems {
    /// Notes one problem.
    pub fn add(&mut self, file: &Path, line: usize, message: impl Into<String>) {
        self.0.push(Problem {
            file: file.to_path_buf(),
            line,
            message: message.into(),
        });
    }

    /// All problems, by file and line, each once.
    #[must_use]
    pub fn into_sorted(mut self) -> Vec<Problem> {
        self.0.sort();
        self.0.dedup();
        self.0
    }

    /// Whether nothing is wrong.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }
}

/// A place in a file: what a message needs in order to name a line.
#[derive(Debug, Clone, Copy)]
pub struct Place<'a> {
    /// The file, relative to the root of the repository.
    pub file: &'a Path,
    /// The line on which the text begins.
    pub first_line: usize,
}

impl<'a> Place<'a> {
    /// The place of a text that begins at `first_line` of `file`.
    #[must_use]
    pub fn new(file: &'a Path, first_line: usize) -> Self {
        Place { file, first_line }
    }

    /// The line of the byte `offset` of the `text` that begins here.
    #[must_use]
    pub fn line(&self, text: &str, offset: usize) -> usize {
        self.first_line + line_of(text, offset) - 1
    }
}

/// The line, from 1, of the byte `offset` of `text`.
#[must_use]
pub fn line_of(text: &str, offset: usize) -> usize {
    let end = offset.min(text.len());
    1 + text.as_bytes()[..end]
        .split(|&b| b == b'\n')
        .skip(1)
        .count()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn problems_come_sorted_and_once() {
        let mut problems = Problems::default();
        problems.add(Path::new("b.md"), 2, "x");
        problems.add(Path::new("a.md"), 10, "y");
        problems.add(Path::new("b.md"), 2, "x");
        let texts: Vec<String> = problems
            .into_sorted()
            .iter()
            .map(ToString::to_string)
            .collect();
        assert_eq!(texts, ["a.md:10: y", "b.md:2: x"]);
    }

    #[test]
    fn lines_count_from_one_and_offsets_past_the_end_are_the_last_line() {
        assert_eq!(line_of("a\nb\nc", 0), 1);
        assert_eq!(line_of("a\nb\nc", 2), 2);
        assert_eq!(line_of("a\nb\nc", 99), 3);
        assert_eq!(Place::new(Path::new("x"), 7).line("a\nb", 2), 8);
    }
}
