//! Theorems and hard cases, read from the doc comments of the tests.

use crate::problem::Problems;
use anyhow::{Context, Result};
use std::fs;
use std::path::{Path, PathBuf};

/// Which of the two test files of a chapter a statement comes from.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum Kind {
    /// `tests/<chapter>/theorems.rs`, `tests/<chapter>/*_theorems.rs`
    #[default]
    Theorem,
    /// `tests/<chapter>/hard_cases.rs`, `tests/<chapter>/*_hard_cases.rs`
    HardCase,
}

impl Kind {
    /// The file's stem, or the folder's name.
    #[must_use]
    pub fn stem(self) -> &'static str {
        match self {
            Kind::Theorem => "theorems",
            Kind::HardCase => "hard_cases",
        }
    }

    /// The directive that cites it.
    #[must_use]
    pub fn directive(self) -> &'static str {
        match self {
            Kind::Theorem => "theorem",
            Kind::HardCase => "hard_case",
        }
    }

    /// The class of its box.
    #[must_use]
    pub fn class(self) -> &'static str {
        match self {
            Kind::Theorem => "theorem",
            Kind::HardCase => "hard-case",
        }
    }

    /// What its box is called.
    #[must_use]
    pub fn label(self) -> &'static str {
        match self {
            Kind::Theorem => "Theorem",
            Kind::HardCase => "Hard case",
        }
    }
}

/// An entry of the slide map: where the course says it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Topic {
    /// The claim's letter and number, for example `A03`, or a word of the course's plan.
    pub id: String,
    /// The slide or slides, for example `slide 10`.
    pub slide: String,
    /// What is said there.
    pub topic: String,
}

impl Topic {
    /// Reads `A03, slide 10, Coons patches: the definition of the patch.`
    ///
    /// # Errors
    /// A message that says which part is malformed and what is expected.
    pub fn parse(text: &str) -> Result<Self, String> {
        let expected = "expected `<id>, slide <n>, <topic>`, for example `A03, slide 10, Coons patches: the patch.`";
        let mut parts = text.trim().splitn(3, ',').map(str::trim);
        let (Some(id), Some(slide), Some(topic)) = (parts.next(), parts.next(), parts.next())
        else {
            return Err(format!("`{text}` has fewer than three parts: {expected}"));
        };
        if !is_claim(id) {
            return Err(format!(
                "`{id}` is neither a claim's letter and number nor a word of the course's plan: {expected}"
            ));
        }
        let number = slide
            .strip_prefix("slides ")
            .or_else(|| slide.strip_prefix("slide "))
            .unwrap_or_default();
        let is_number = |n: &str| !n.is_empty() && n.chars().all(|c| c.is_ascii_digit());
        if !number.split(['-', '–']).all(is_number) {
            return Err(format!("`{slide}` does not name a slide: {expected}"));
        }
        let topic = topic.trim_end_matches('.');
        if topic.is_empty() {
            return Err(format!("`{text}` has no topic: {expected}"));
        }
        Ok(Topic {
            id: id.to_owned(),
            slide: slide.to_owned(),
            topic: topic.to_owned(),
        })
    }
}

/// `A03`, or a word in small letters for what is no claim: `plan`.
fn is_claim(id: &str) -> bool {
    let digits = id.trim_start_matches(|c: char| c.is_ascii_uppercase());
    let numbered = !digits.is_empty() && digits != id && digits.chars().all(|c| c.is_ascii_digit());
    numbered || (!id.is_empty() && id.chars().all(|c| c.is_ascii_lowercase()))
}

/// A test, and what its doc comment says.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Theorem {
    /// Theorem or hard case.
    pub kind: Kind,
    /// The chapter: the folder's name under `tests/`.
    pub chapter: String,
    /// The test's name.
    pub name: String,
    /// The first bold sentence, without its full stop (Markdown).
    pub title: String,
    /// The statement after the title (Markdown); lines count from `line`.
    pub statement: String,
    /// Where the course says it.
    pub topics: Vec<Topic>,
    /// The exercises that it grades.
    pub exercises: Vec<String>,
    /// What the course says that is wrong.
    pub errata: Vec<String>,
    /// The test's code, attributes and doc comment left out.
    pub code: String,
    /// The file, relative to the root.
    pub file: PathBuf,
    /// The line on which the doc comment begins.
    pub line: usize,
}

impl Theorem {
    /// The identifier of its box in the page.
    #[must_use]
    pub fn anchor(&self) -> String {
        format!("{}-{}", self.chapter, self.name)
    }

    /// How pages cite it: `coons::name`.
    #[must_use]
    pub fn path(&self) -> String {
        format!("{}::{}", self.chapter, self.name)
    }
}

/// Reads the theorems and hard cases of every chapter under `root/tests`.
///
/// # Errors
/// Where a file or folder cannot be read.
pub fn scan(root: &Path, problems: &mut Problems) -> Result<Vec<Theorem>> {
    let mut theorems = Vec::new();
    for chapter in folders(&root.join("tests"))? {
        for kind in [Kind::Theorem, Kind::HardCase] {
            for file in test_files(root, &chapter, kind)? {
                let text = fs::read_to_string(root.join(&file))
                    .with_context(|| format!("cannot read {}", file.display()))?;
                theorems.extend(scan_text(&text, kind, &chapter, &file, problems));
            }
        }
    }
    Ok(theorems)
}

fn folders(parent: &Path) -> Result<Vec<String>> {
    if !parent.is_dir() {
        return Ok(Vec::new());
    }
    let mut names = Vec::new();
    for entry in fs::read_dir(parent)? {
        let entry = entry?;
        if entry.file_type()?.is_dir() {
            names.push(entry.file_name().to_string_lossy().into_owned());
        }
    }
    names.sort();
    Ok(names)
}

/// The Rust files of a chapter that hold statements of this kind: `theorems.rs`, `bicubic_theorems.rs`,
/// `theorems/bicubic.rs`.
fn test_files(root: &Path, chapter: &str, kind: Kind) -> Result<Vec<PathBuf>> {
    let folder = Path::new("tests").join(chapter);
    let mut files = Vec::new();
    for part in [folder.clone(), folder.join(kind.stem())] {
        if !root.join(&part).is_dir() {
            continue;
        }
        for entry in fs::read_dir(root.join(&part))? {
            let file = part.join(entry?.file_name());
            let stem = file.file_stem().unwrap_or_default().to_string_lossy();
            let named = stem == kind.stem() || stem.ends_with(&format!("_{}", kind.stem()));
            if file.extension().is_some_and(|e| e == "rs") && (named || part != folder) {
                files.push(file);
            }
        }
    }
    files.sort();
    Ok(files)
}

/// Reads the tests of one file: each `#[test]` function with the doc comment above it.
pub fn scan_text(
    text: &str,
    kind: Kind,
    chapter: &str,
    file: &Path,
    problems: &mut Problems,
) -> Vec<Theorem> {
    let lines: Vec<&str> = text.lines().collect();
    let mut theorems = Vec::new();
    for (index, line) in lines.iter().enumerate() {
        if line.trim() != "#[test]" {
            continue;
        }
        let Some((name, first, last)) = function(&lines, index) else {
            problems.add(file, index + 1, "no function follows this `#[test]`");
            continue;
        };
        let (line, doc) = doc_comment(&lines, index);
        if doc.is_empty() {
            let message =
                format!("the test `{name}` has no doc comment: its statement belongs there");
            problems.add(file, index + 1, message);
            continue;
        }
        let mut theorem = Theorem {
            kind,
            chapter: chapter.to_owned(),
            name,
            code: code(&lines[first..=last]),
            file: file.to_path_buf(),
            line,
            ..Theorem::default()
        };
        read_doc(&doc, &mut theorem, problems);
        theorems.push(theorem);
    }
    theorems
}

/// The name, first and last line (indices) of the function after the attribute at `index`.
fn function(lines: &[&str], index: usize) -> Option<(String, usize, usize)> {
    let first = (index + 1..lines.len())
        .take_while(|&i| is_attribute(lines[i]) || lines[i].contains("fn "))
        .find(|&i| lines[i].contains("fn "))?;
    let name: String = lines[first]
        .split("fn ")
        .nth(1)?
        .chars()
        .take_while(|c| c.is_alphanumeric() || *c == '_')
        .collect();
    let indent = lines[first].len() - lines[first].trim_start().len();
    let end = format!("{}}}", " ".repeat(indent));
    let last = (first..lines.len()).find(|&i| {
        lines[i].trim_end() == end || (i == first && lines[i].trim_end().ends_with('}'))
    })?;
    Some((name, first, last))
}

fn is_attribute(line: &str) -> bool {
    line.trim_start().starts_with("#[")
}

/// The doc comment above the line `index`, and the number of its first line.
fn doc_comment(lines: &[&str], index: usize) -> (usize, Vec<String>) {
    let above = lines[..index].iter().rev();
    let mut doc: Vec<String> = above
        .skip_while(|line| is_attribute(line))
        .map_while(|line| line.trim_start().strip_prefix("///"))
        .map(|line| line.strip_prefix(' ').unwrap_or(line).to_owned())
        .collect();
    doc.reverse();
    let attributes = lines[..index]
        .iter()
        .rev()
        .take_while(|line| is_attribute(line))
        .count();
    (index - attributes - doc.len() + 1, doc)
}

/// The function without its indentation and without anchors.
fn code(lines: &[&str]) -> String {
    let indent = lines[0].len() - lines[0].trim_start().len();
    lines
        .iter()
        .filter(|line| !line.contains("// ANCHOR"))
        .map(|line| line.get(indent..).unwrap_or_default())
        .collect::<Vec<_>>()
        .join("\n")
}

/// Splits a doc comment into title, statement and trailer lines.
fn read_doc(doc: &[String], theorem: &mut Theorem, problems: &mut Problems) {
    let mut statement: Vec<&str> = Vec::new();
    let mut in_trailer = false;
    for (index, line) in doc.iter().enumerate() {
        let number = theorem.line + index;
        match line.split_once(": ") {
            Some(("Course", rest)) => match Topic::parse(rest) {
                Ok(topic) => theorem.topics.push(topic),
                Err(message) => {
                    problems.add(&theorem.file, number, format!("Course line: {message}"));
                }
            },
            Some(("Exercise", rest)) => theorem
                .exercises
                .push(rest.trim().trim_end_matches('.').to_owned()),
            Some(("Erratum", rest)) => theorem.errata.push(rest.trim().to_owned()),
            _ if line.trim().is_empty() => statement.push(""),
            _ if in_trailer => {
                let message = "text after the trailer lines (Course, Exercise, Erratum): each stands on one line, at the end";
                problems.add(&theorem.file, number, message);
            }
            _ => {
                statement.push(line);
                continue;
            }
        }
        in_trailer |= !line.trim().is_empty();
    }
    let statement = statement.join("\n");
    if let Some((title, rest)) = split_title(&statement) {
        theorem.title = title;
        theorem.statement = rest;
        return;
    }
    let message = format!(
        "the doc comment of `{}` does not begin with its title, a sentence in bold: `**Title.** ...`",
        theorem.name
    );
    problems.add(&theorem.file, theorem.line, message);
}

/// The bold sentence at the beginning, and the text after it with as many line breaks before it.
fn split_title(text: &str) -> Option<(String, String)> {
    let inside = text.strip_prefix("**")?;
    let end = inside.find("**")?;
    let title = inside[..end].replace('\n', " ");
    let title = title.trim().trim_end_matches('.').to_owned();
    if title.is_empty() {
        return None;
    }
    let breaks = inside[..end].matches('\n').count();
    let rest = format!("{}{}", "\n".repeat(breaks), &inside[end + 2..]);
    Some((title, rest.trim_end().to_owned()))
}

#[cfg(test)]
#[path = "theorem_tests.rs"]
mod tests;
