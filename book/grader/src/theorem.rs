//! The theorems of a chapter: read from the doc comments of its tests, in the order in which the book cites them.

use std::fs;
use std::path::{Path, PathBuf};

use crate::catalogue::Chapter;
use crate::error::GraderError;
use crate::house::House;

/// A statement and the test that checks it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Theorem {
    /// The name of the test function.
    pub name: String,
    /// The first sentence of its doc comment, the one in bold.
    pub title: String,
    /// What follows, as Markdown.
    pub statement: String,
    /// The exercises it grades.
    pub exercises: Vec<String>,
    /// The page that cites it, from the folder of the written book.
    pub page: String,
}

/// A citation of a theorem on a page of the book.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Citation {
    /// The name of the test function.
    pub name: String,
    /// The page, from the folder of the written book.
    pub page: String,
}

/// The theorems of the chapter, in the order in which the book cites them; those it does not cite come last.
///
/// # Errors
///
/// [`GraderError::File`] where the tests cannot be read.
pub fn read(house: &House, chapter: &Chapter) -> Result<Vec<Theorem>, GraderError> {
    let mut theorems = Vec::new();
    for path in test_files(&house.tests(&chapter.name))? {
        let text = fs::read_to_string(&path).map_err(GraderError::file("read", &path))?;
        theorems.extend(parse(&text));
    }
    let citations = citations(house, &chapter.name)?;
    Ok(in_order(theorems, &citations, &chapter.page))
}

/// The theorems among them that grade this exercise.
///
/// # Errors
///
/// [`GraderError::Ungraded`] where there is none.
pub fn of_exercise<'a>(
    theorems: &'a [Theorem],
    chapter: &str,
    exercise: &str,
) -> Result<Vec<&'a Theorem>, GraderError> {
    let grading: Vec<&Theorem> = theorems
        .iter()
        .filter(|theorem| theorem.exercises.iter().any(|name| name == exercise))
        .collect();
    if grading.is_empty() {
        let (chapter, exercise) = (chapter.to_owned(), exercise.to_owned());
        return Err(GraderError::Ungraded { chapter, exercise });
    }
    Ok(grading)
}

/// The files of the chapter's theorems: `theorems.rs`, and where it has outgrown one file, `<part>_theorems.rs`.
fn test_files(tests: &Path) -> Result<Vec<PathBuf>, GraderError> {
    let mut files = Vec::new();
    for entry in fs::read_dir(tests).map_err(GraderError::file("list", tests))? {
        let path = entry.map_err(GraderError::file("list", tests))?.path();
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        if name == "theorems.rs" || name.ends_with("_theorems.rs") {
            files.push(path);
        }
    }
    files.sort_by_key(|path| (!path.ends_with("theorems.rs"), path.clone()));
    Ok(files)
}

/// The theorems of a source file: its test functions with a doc comment, in the order of the text.
#[must_use]
pub fn parse(source: &str) -> Vec<Theorem> {
    let mut theorems = Vec::new();
    let (mut comment, mut is_test) = (Vec::new(), false);
    for line in source.lines().map(str::trim) {
        if let Some(text) = line.strip_prefix("///") {
            comment.push(text.strip_prefix(' ').unwrap_or(text));
        } else if line.starts_with("#[") {
            is_test |= line == "#[test]";
        } else {
            if let (true, Some(name), false) = (is_test, function_name(line), comment.is_empty()) {
                theorems.push(from_comment(name, &comment));
            }
            comment.clear();
            is_test = false;
        }
    }
    theorems
}

fn function_name(line: &str) -> Option<&str> {
    let rest = line
        .strip_prefix("pub ")
        .unwrap_or(line)
        .strip_prefix("fn ")?;
    rest.split(|letter: char| !letter.is_alphanumeric() && letter != '_')
        .next()
}

const TRAILERS: [&str; 3] = ["Course:", "Exercise:", "Erratum:"];

fn from_comment(name: &str, comment: &[&str]) -> Theorem {
    let is_trailer = |line: &&str| TRAILERS.iter().any(|trailer| line.starts_with(trailer));
    let exercises = comment
        .iter()
        .filter_map(|line| line.strip_prefix("Exercise:"))
        .map(|exercise| exercise.trim().trim_end_matches('.').to_owned())
        .collect();
    let lines: Vec<&str> = comment
        .iter()
        .copied()
        .filter(|line| !is_trailer(line))
        .collect();
    let text = lines.join("\n");
    let text = text.trim();
    let bold = text
        .strip_prefix("**")
        .and_then(|rest| rest.split_once("**"));
    let (title, statement) = bold.unwrap_or((text.lines().next().unwrap_or(name), text));
    Theorem {
        name: name.to_owned(),
        title: title.trim().trim_end_matches('.').to_owned(),
        statement: statement.trim().to_owned(),
        exercises,
        page: String::new(),
    }
}

/// The citations `{{#theorem chapter::name}}` of one page's text.
#[must_use]
pub fn cited(chapter: &str, page: &str, text: &str) -> Vec<Citation> {
    let opening = format!("{{{{#theorem {chapter}::");
    text.split(&opening)
        .skip(1)
        .filter_map(|rest| rest.split_once("}}"))
        .map(|(name, _)| Citation {
            name: name.trim().to_owned(),
            page: page.to_owned(),
        })
        .collect()
}

/// The citations of the chapter's pages, in the order of the book's summary.
fn citations(house: &House, chapter: &str) -> Result<Vec<Citation>, GraderError> {
    let folder = house.book_text();
    let mut citations = Vec::new();
    for page in pages(chapter, &summary(house)) {
        let path = folder.join(&page);
        if path.is_file() {
            let text = fs::read_to_string(&path).map_err(GraderError::file("read", &path))?;
            let written = page.replace(".md", ".html");
            citations.extend(cited(chapter, &written, &text));
        }
    }
    Ok(citations)
}

/// The book's summary; empty where there is none.
#[must_use]
pub fn summary(house: &House) -> String {
    fs::read_to_string(house.book_text().join("SUMMARY.md")).unwrap_or_default()
}

/// The pages that a summary links to, in its order.
pub fn links(summary: &str) -> impl Iterator<Item = &str> {
    let links = summary.split("](").skip(1);
    let links = links.filter_map(|rest| rest.split_once(')'));
    links.map(|(link, _)| link.trim_start_matches("./"))
}

/// Whether the page is `<chapter>.md` or stands in the folder `<chapter>/`.
#[must_use]
pub fn is_page_of(chapter: &str, page: &str) -> bool {
    let rest = page.strip_prefix(chapter);
    rest.is_some_and(|rest| rest == ".md" || rest.starts_with('/'))
}

/// The chapter's pages `coons.md` and `coons/*.md` among the links of the summary; the first alone without a summary.
#[must_use]
pub fn pages(chapter: &str, summary: &str) -> Vec<String> {
    let links = links(summary).filter(|link| is_page_of(chapter, link));
    let mut pages: Vec<String> = links.map(str::to_owned).collect();
    if pages.is_empty() {
        pages.push(format!("{chapter}.md"));
    }
    pages
}

/// Sorts the theorems as the book cites them and notes the page; what is not cited comes last, on `default_page`.
#[must_use]
pub fn in_order(
    mut theorems: Vec<Theorem>,
    citations: &[Citation],
    default_page: &str,
) -> Vec<Theorem> {
    let position = |name: &str| citations.iter().position(|citation| citation.name == name);
    for theorem in &mut theorems {
        let page = position(&theorem.name).map(|index| citations[index].page.as_str());
        page.unwrap_or(default_page).clone_into(&mut theorem.page);
    }
    theorems.sort_by_key(|theorem| position(&theorem.name).unwrap_or(usize::MAX));
    theorems
}
