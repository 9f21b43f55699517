//! What the builder wants to know about a page: its formulas, code blocks, headings and images, with their places.

use mdbook_markdown::pulldown_cmark::{
    CodeBlockKind, Event, Options, Parser, Tag, TagEnd, TextMergeWithOffset,
};
use std::ops::Range;

/// A range of bytes of a text, and what takes its place.
pub type Edit = (Range<usize>, String);

/// A formula between dollar signs.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Formula {
    /// Where it stands, dollar signs included.
    pub range: Range<usize>,
    /// What stands between the dollar signs.
    pub latex: String,
    /// Whether it is displayed on a line of its own (`$$`).
    pub display: bool,
}

/// A fenced block of code.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Fence {
    /// Where it stands, fences included.
    pub range: Range<usize>,
    /// The first word after the opening fence.
    pub language: String,
    /// What stands between the fences.
    pub content: String,
}

/// What a page consists of, as far as the builder looks at it.
#[derive(Debug, Default)]
pub struct Outline {
    /// The text of each heading.
    pub headings: Vec<String>,
    /// The fenced blocks.
    pub fences: Vec<Fence>,
    /// Code blocks and code spans: nothing in them is a directive of ours.
    pub code: Vec<Range<usize>>,
    /// Images without alternative text.
    pub silent_images: Vec<Range<usize>>,
    /// Blocks and pieces of raw HTML.
    pub html: Vec<(Range<usize>, String)>,
}

fn options() -> Options {
    Options::ENABLE_TABLES
        | Options::ENABLE_FOOTNOTES
        | Options::ENABLE_STRIKETHROUGH
        | Options::ENABLE_TASKLISTS
        | Options::ENABLE_HEADING_ATTRIBUTES
        | Options::ENABLE_DEFINITION_LIST
        | Options::ENABLE_GFM
        | Options::ENABLE_MATH
}

/// The formulas of a Markdown text. Code spans and `\$` are left alone.
#[must_use]
pub fn formulas(text: &str) -> Vec<Formula> {
    Parser::new_ext(text, options())
        .into_offset_iter()
        .filter_map(|(event, range)| {
            let (latex, display) = match event {
                Event::InlineMath(latex) => (latex, false),
                Event::DisplayMath(latex) => (latex, true),
                _ => return None,
            };
            Some(Formula {
                range,
                latex: latex.into_string(),
                display,
            })
        })
        .collect()
}

/// Reads a page once and notes what the checks need.
#[must_use]
pub fn outline(text: &str) -> Outline {
    let mut outline = Outline::default();
    let mut reader = Reader::default();
    for (event, range) in
        TextMergeWithOffset::new(Parser::new_ext(text, options()).into_offset_iter())
    {
        reader.event(event, range, &mut outline);
    }
    outline
}

/// The elements that are open while a page is read.
#[derive(Default)]
struct Reader {
    heading: Option<String>,
    fence: Option<Fence>,
    image: Option<(Range<usize>, String)>,
}

impl Reader {
    fn event(&mut self, event: Event<'_>, range: Range<usize>, outline: &mut Outline) {
        match event {
            Event::Start(tag) => self.start(&tag, range, outline),
            Event::End(tag) => self.end(tag, outline),
            Event::Text(text) | Event::InlineMath(text) => self.text(&text),
            Event::Code(text) => {
                self.text(&text);
                outline.code.push(range);
            }
            Event::Html(html) | Event::InlineHtml(html) => {
                outline.html.push((range, html.into_string()));
            }
            _ => {}
        }
    }

    fn start(&mut self, tag: &Tag<'_>, range: Range<usize>, outline: &mut Outline) {
        match tag {
            Tag::Heading { .. } => self.heading = Some(String::new()),
            Tag::Image { .. } => self.image = Some((range, String::new())),
            Tag::CodeBlock(kind) => {
                outline.code.push(range.clone());
                let language = match kind {
                    CodeBlockKind::Fenced(info) => info
                        .split([' ', '\t', ','])
                        .next()
                        .unwrap_or_default()
                        .to_owned(),
                    CodeBlockKind::Indented => String::new(),
                };
                self.fence = Some(Fence {
                    range,
                    language,
                    content: String::new(),
                });
            }
            _ => {}
        }
    }

    fn end(&mut self, tag: TagEnd, outline: &mut Outline) {
        match tag {
            TagEnd::Heading(_) => outline.headings.extend(self.heading.take()),
            TagEnd::CodeBlock => outline.fences.extend(self.fence.take()),
            TagEnd::Image => {
                if let Some((range, alternative)) = self.image.take()
                    && alternative.trim().is_empty()
                {
                    outline.silent_images.push(range);
                }
            }
            _ => {}
        }
    }

    fn text(&mut self, text: &str) {
        if let Some(fence) = &mut self.fence {
            fence.content.push_str(text);
        }
        if let Some(heading) = &mut self.heading {
            heading.push_str(text);
        }
        if let Some((_, alternative)) = &mut self.image {
            alternative.push_str(text);
        }
    }
}

/// The text with its edits made. Edits that overlap an earlier one are left out.
#[must_use]
pub fn apply(text: &str, mut edits: Vec<Edit>) -> String {
    edits.sort_by_key(|(range, _)| range.start);
    let mut result = String::with_capacity(text.len() * 2);
    let mut done = 0;
    for (range, replacement) in edits {
        if range.start < done {
            continue;
        }
        result.push_str(&text[done..range.start]);
        result.push_str(&replacement);
        done = range.end;
    }
    result.push_str(&text[done..]);
    result
}

/// Text as HTML: the five characters that mean something there, as references.
#[must_use]
pub fn escape(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
        .replace('"', "&quot;")
        .replace('\'', "&#39;")
}

/// A fence that is longer than any run of backticks in `code`.
#[must_use]
pub fn fenced(language: &str, code: &str) -> String {
    let longest = code
        .split(|c| c != '`')
        .map(str::len)
        .max()
        .unwrap_or_default();
    let fence = "`".repeat(longest.max(2) + 1);
    format!("{fence}{language}\n{}\n{fence}\n", code.trim_end())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn formulas_are_found_and_code_is_left_alone() {
        let text = r"a $x_1$ `$no$` \$5 $$y$$";
        let found = formulas(text);
        assert_eq!(found.len(), 2);
        assert_eq!((found[0].latex.as_str(), found[0].display), ("x_1", false));
        assert_eq!((found[1].latex.as_str(), found[1].display), ("y", true));
        assert_eq!(&text[found[0].range.clone()], "$x_1$");
    }

    #[test]
    fn outline_notes_headings_fences_and_silent_images() {
        let text =
            "# The *idea*\n\n```rust,ignore\nfn f() {}\n```\n\n![](a.png) ![seen](b.png) `x`\n";
        let page = outline(text);
        assert_eq!(page.headings, ["The idea"]);
        assert_eq!(page.fences.len(), 1);
        assert_eq!(page.fences[0].language, "rust");
        assert_eq!(page.fences[0].content, "fn f() {}\n");
        assert_eq!(page.silent_images.len(), 1);
        assert_eq!(page.code.len(), 2);
    }

    #[test]
    fn edits_are_made_in_order() {
        let edits = vec![(4..5, "E".to_owned()), (0..1, "AA".to_owned())];
        assert_eq!(apply("abcdef", edits), "AAbcdEf");
    }

    #[test]
    fn a_fence_outgrows_the_backticks_inside() {
        assert!(fenced("rust", "a ```b").starts_with("````rust\n"));
        assert!(fenced("rust", "a").starts_with("```rust\n"));
    }
}
