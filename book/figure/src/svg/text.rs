//! Text of drawings: escaping, italics, indices and exponents.

use std::fmt::Write as _;

use crate::palette::Colour;

/// Which end of a text stands at its point.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Anchor {
    /// The text begins at the point.
    Start,
    /// The text is centred on the point.
    Middle,
    /// The text ends at the point.
    End,
}

impl Anchor {
    fn name(self) -> &'static str {
        match self {
            Self::Start => "start",
            Self::Middle => "middle",
            Self::End => "end",
        }
    }
}

/// `text` with `&`, `<`, `>` and `"` escaped for XML.
#[must_use]
pub fn escape(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
        .replace('"', "&quot;")
}

/// A piece of text in one style.
#[derive(Debug, Clone, PartialEq, Eq)]
struct Run {
    text: String,
    level: Level,
    italic: bool,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Level {
    Line,
    Index,
    Exponent,
}

impl Level {
    /// How far the run's baseline lies below the line, in parts of the text's size.
    fn drop(self) -> f64 {
        match self {
            Self::Line => 0.0,
            Self::Index => 0.25,
            Self::Exponent => -0.38,
        }
    }
}

/// `text` as markup that shows it letter by letter: names in code are full of underscores.
#[must_use]
pub fn literal(text: &str) -> String {
    let mut markup = String::with_capacity(text.len());
    for character in text.chars() {
        if matches!(character, '*' | '_' | '^' | '\\') {
            markup.push('\\');
        }
        markup.push(character);
    }
    markup
}

/// Splits markup into runs: `*..*` is italic, `_x` and `_{..}` an index, `^x` and `^{..}` an exponent, and `\` takes what follows as it is.
fn runs(markup: &str) -> Vec<Run> {
    let mut runs: Vec<Run> = Vec::new();
    let mut italic = false;
    let mut characters = markup.chars();
    while let Some(character) = characters.next() {
        match character {
            '*' => italic = !italic,
            '_' | '^' => {
                let is_index = character == '_';
                let level = [Level::Exponent, Level::Index][usize::from(is_index)];
                let text = match characters.next() {
                    Some('{') => characters
                        .by_ref()
                        .take_while(|&next| next != '}')
                        .collect(),
                    Some(single) => single.to_string(),
                    None => character.to_string(),
                };
                runs.push(Run {
                    text,
                    level,
                    italic: false,
                });
            }
            '\\' => push_in_line(&mut runs, characters.next().unwrap_or(character), italic),
            _ => push_in_line(&mut runs, character, italic),
        }
    }
    runs
}

/// Adds a character to the last run if that stands in the line and looks the same, and else begins a new one.
fn push_in_line(runs: &mut Vec<Run>, character: char, italic: bool) {
    match runs.last_mut() {
        Some(run) if run.level == Level::Line && run.italic == italic => run.text.push(character),
        _ => runs.push(Run {
            text: character.to_string(),
            level: Level::Line,
            italic,
        }),
    }
}

/// The width of a text in units of its size: an estimate, because a drawing has no fonts to measure with.
pub(crate) fn estimated_width(markup: &str) -> f64 {
    let width = |run: &Run| {
        let scale = if run.level == Level::Line { 1.0 } else { 0.7 };
        scale * 0.54 * run.text.chars().count() as f64
    };
    runs(markup).iter().map(width).sum()
}

/// A `<text>` element with its baseline at `(x, y)`.
pub(super) fn element(
    [x, y]: [f64; 2],
    markup: &str,
    size: f64,
    anchor: Anchor,
    colour: Colour,
) -> String {
    let anchor = anchor.name();
    let fill = colour.css();
    let mut element = format!(
        r#"<text x="{x:.2}" y="{y:.2}" font-size="{size:.2}" text-anchor="{anchor}" fill="{fill}">"#
    );
    let mut dropped = 0.0;
    for run in runs(markup) {
        let text = escape(&run.text);
        let shift = (run.level.drop() - dropped) * size;
        dropped = run.level.drop();
        let mut style = String::new();
        if shift.abs() > 0.0 {
            let _ = write!(style, r#" dy="{shift:.2}""#);
        }
        if run.level != Level::Line {
            let _ = write!(style, r#" font-size="{:.2}""#, 0.7 * size);
        }
        if run.italic {
            style.push_str(
                r#" font-family="'New Computer Modern Math', Georgia, serif" font-style="italic""#,
            );
        }
        if style.is_empty() {
            element.push_str(&text);
        } else {
            let _ = write!(element, "<tspan{style}>{text}</tspan>");
        }
    }
    element.push_str("</text>");
    element
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_index_is_lowered_and_the_line_restored() {
        let text = element(
            [0.0, 0.0],
            "*S*_1 + 10^{-3}",
            20.0,
            Anchor::Start,
            Colour::Ink,
        );
        assert!(
            text.contains(r#"<tspan dy="5.00" font-size="14.00">1</tspan>"#),
            "{text}"
        );
        assert!(
            text.contains(r#"<tspan dy="-5.00"> + 10</tspan>"#),
            "{text}"
        );
        assert!(
            text.contains(r#"<tspan dy="-7.60" font-size="14.00">-3</tspan>"#),
            "{text}"
        );
        assert!(text.contains(r#"font-style="italic">S</tspan>"#), "{text}");
    }

    #[test]
    fn whatever_the_markup_nothing_of_the_text_is_lost_and_tags_are_balanced() {
        for markup in ["", "_", "x^", "a_{b", "<&>\"", "**", "*a_b*", "}}{{"] {
            let text = element([0.0, 0.0], markup, 10.0, Anchor::End, Colour::Ink);
            assert_eq!(
                text.matches("<tspan").count(),
                text.matches("</tspan>").count()
            );
            let letters = |text: &str| text.chars().filter(char::is_ascii_lowercase).count();
            let kept: String = runs(markup).iter().map(|run| run.text.as_str()).collect();
            assert_eq!(letters(&kept), letters(markup));
        }
    }

    #[test]
    fn literal_text_is_shown_letter_by_letter() {
        for text in ["look_at_axes", "a*b^2\\", "", "_"] {
            let shown = runs(&literal(text));
            let in_line = shown
                .iter()
                .all(|run| run.level == Level::Line && !run.italic);
            assert!(in_line, "{text}");
            let letters: String = shown.into_iter().map(|run| run.text).collect();
            assert_eq!(letters, text);
        }
    }

    #[test]
    fn escaped_text_holds_no_markup() {
        assert_eq!(escape("a<b & \"c\">"), "a&lt;b &amp; &quot;c&quot;&gt;");
    }
}
