//! The directives in the pages: `{{#name arguments}}`.

use std::ops::Range;

/// A directive of this builder.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Directive {
    /// A theorem's box: `{{#theorem coons::name}}`.
    Theorem(String),
    /// A hard case's box: `{{#hard_case coons::name}}`.
    HardCase(String),
    /// A figure: `{{#figure coons::name}}`.
    Figure(String),
    /// A citation, and where in the work: `{{#cite key, section 4.2}}`.
    Cite(String, Option<String>),
    /// A link into the rustdoc: `{{#api coons::CoonsPatch}}`.
    Api(String),
    /// The chapter's exercises: `{{#exercises coons}}`.
    Exercises(String),
    /// The chapter's table of speed against error, `{{#speed coons}}`, or only the quantities that begin with a word: `{{#speed
    /// intersection, sphere}}`.
    Speed(String, Option<String>),
    /// A remark on the course, up to `{{#endremark}}`: `{{#remark A08, slide 8, history}}`.
    Remark(String),
    /// The end of a remark.
    EndRemark,
    /// All theorems.
    TheoremIndex,
    /// What the slides say that is wrong.
    Errata,
    /// Course topic to chapter, theorem and test.
    SlideMap,
    /// French and English terms.
    Glossary,
    /// The works cited.
    Bibliography,
    /// A listing, left to mdBook: the path and anchor.
    Include(String),
}

/// A directive and where it stands.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Found {
    /// The range of bytes, braces included.
    pub range: Range<usize>,
    /// What it says, or why it says nothing.
    pub directive: Result<Directive, String>,
}

/// All directives of a page, those of mdBook included. `\{{#...}}` is text.
#[must_use]
pub fn find(text: &str) -> Vec<Found> {
    let mut found = Vec::new();
    let mut from = 0;
    while let Some(start) = text[from..].find("{{#").map(|at| from + at) {
        let inside = start + 3;
        let line_end = text[inside..]
            .find('\n')
            .map_or(text.len(), |at| inside + at);
        from = inside;
        if text[..start].ends_with('\\') {
            continue;
        }
        let (end, directive) = match text[inside..line_end].find("}}") {
            Some(at) => (inside + at + 2, parse(&text[inside..inside + at])),
            None => (
                line_end,
                Err("this directive is not closed on its line by `}}`".to_owned()),
            ),
        };
        found.push(Found {
            range: start..end,
            directive,
        });
        from = end;
    }
    found
}

/// Reads what stands between `{{#` and `}}`.
fn parse(text: &str) -> Result<Directive, String> {
    let text = text.trim();
    let (name, arguments) = text.split_once(char::is_whitespace).unwrap_or((text, ""));
    let arguments = arguments.trim();
    let one = |make: fn(String) -> Directive| {
        if arguments.is_empty() {
            Err(format!("`{name}` needs an argument"))
        } else {
            Ok(make(arguments.to_owned()))
        }
    };
    let none = |directive: Directive| {
        if arguments.is_empty() {
            Ok(directive)
        } else {
            Err(format!("`{name}` takes no argument, got `{arguments}`"))
        }
    };
    match name {
        "theorem" => one(Directive::Theorem),
        "hard_case" => one(Directive::HardCase),
        "figure" => one(Directive::Figure),
        "cite" => one(|arguments| split(arguments, Directive::Cite)),
        "api" => one(Directive::Api),
        "exercises" => one(Directive::Exercises),
        "speed" => one(|arguments| split(arguments, Directive::Speed)),
        "remark" => one(Directive::Remark),
        "include" => one(Directive::Include),
        "endremark" => none(Directive::EndRemark),
        "theorem_index" => none(Directive::TheoremIndex),
        "errata" => none(Directive::Errata),
        "slide_map" => none(Directive::SlideMap),
        "glossary" => none(Directive::Glossary),
        "bibliography" => none(Directive::Bibliography),
        _ => Err(format!(
            "unknown directive `{name}`; known are theorem, hard_case, figure, cite, api, exercises, speed, remark, \
             endremark, theorem_index, errata, slide_map, glossary, bibliography and mdBook's include"
        )),
    }
}

/// The directive of an argument that may have a second one after a comma.
fn split(arguments: String, make: fn(String, Option<String>) -> Directive) -> Directive {
    match arguments.split_once(',') {
        Some((first, second)) => make(first.trim().to_owned(), Some(second.trim().to_owned())),
        None => make(arguments, None),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn only(text: &str) -> Result<Directive, String> {
        let mut found = find(text);
        assert_eq!(found.len(), 1, "{text}");
        found.remove(0).directive
    }

    #[test]
    fn directives_are_read() {
        assert_eq!(
            only("x {{#theorem coons::a}} y"),
            Ok(Directive::Theorem("coons::a".into()))
        );
        assert_eq!(
            only("{{#cite coons1967}}"),
            Ok(Directive::Cite("coons1967".into(), None))
        );
        assert_eq!(
            only("{{#cite farin, section 4.2}}"),
            Ok(Directive::Cite("farin".into(), Some("section 4.2".into())))
        );
        assert_eq!(
            only("{{#speed intersection, sphere}}"),
            Ok(Directive::Speed(
                "intersection".into(),
                Some("sphere".into())
            ))
        );
        assert_eq!(only("{{#errata}}"), Ok(Directive::Errata));
        assert_eq!(
            only("{{#include ../a.rs:b}}"),
            Ok(Directive::Include("../a.rs:b".into()))
        );
    }

    #[test]
    fn what_is_not_understood_is_said() {
        assert!(only("{{#theorme x}}").is_err_and(|m| m.contains("unknown directive `theorme`")));
        assert!(only("{{#figure}}").is_err_and(|m| m.contains("needs an argument")));
        assert!(only("{{#errata x}}").is_err_and(|m| m.contains("takes no argument")));
        assert!(only("{{#figure coons::a\n}}").is_err_and(|m| m.contains("not closed")));
    }

    #[test]
    fn an_escaped_directive_is_text() {
        assert!(find(r"\{{#theorem x}}").is_empty());
    }
}
