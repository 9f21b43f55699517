//! The lines of an OBJ file: comments cut off, continued lines joined.

use super::ObjError;

/// A line of the file without its comment, continued lines joined.
pub(super) struct Statement {
    pub line: usize,
    pub text: String,
}

impl Statement {
    pub fn keyword(&self) -> &str {
        self.words().next().unwrap_or_default()
    }

    pub fn words(&self) -> std::str::SplitWhitespace<'_> {
        self.text.split_whitespace()
    }

    pub fn is_element(&self) -> bool {
        matches!(self.keyword(), "f" | "l")
    }

    /// Whether it is a face of which a corner names a normal, as `1//3` or `1/2/3`.
    pub fn names_normals(&self) -> bool {
        self.keyword() == "f" && self.words().any(|word| normal_of(word).is_some())
    }

    pub fn error(&self, file: &str, what: String) -> ObjError {
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

/// The word for the normal in a corner `1//3` or `1/2/3`.
pub(super) fn normal_of(corner: &str) -> Option<&str> {
    corner.split('/').nth(2).filter(|word| !word.is_empty())
}

/// The statements of a file that say something about geometry, cleaned for `tobj`.
pub(super) fn statements(text: &str) -> Vec<Statement> {
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
    statements.retain(|line| matches!(line.keyword(), "v" | "vn" | "f" | "l" | "o" | "g"));
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
