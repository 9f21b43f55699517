//! LaTeX to `MathML`, at build time.

use crate::markdown::{self, Edit};
use crate::problem::{Place, Problems};
use anyhow::{Context, Result};
use math_core::{LatexToMathML, MathCoreConfig, MathDisplay};
use std::fmt::Write as _;

/// Turns formulas into `MathML`.
pub struct Maths(LatexToMathML);

impl Maths {
    /// A converter without macros of our own.
    ///
    /// # Errors
    /// Where the converter refuses its configuration.
    pub fn new() -> Result<Self> {
        let converter = LatexToMathML::new(MathCoreConfig::default())
            .ok()
            .context("the LaTeX converter refuses its default configuration")?;
        Ok(Maths(converter))
    }

    /// The formula as inline HTML that Markdown leaves alone, or what is wrong with it.
    ///
    /// # Errors
    /// A message that names the formula and the part of it that was not understood.
    pub fn formula(&self, latex: &str, display: bool) -> Result<String, String> {
        let mode = if display {
            MathDisplay::Block
        } else {
            MathDisplay::Inline
        };
        let result = self
            .0
            .convert_with_local_state(latex, mode)
            .map_err(|error| {
                let part = latex.get(error.0.clone()).unwrap_or_default();
                format!(
                    "the formula `{}` does not parse, at `{part}`: {}",
                    latex.trim(),
                    error.error_message()
                )
            })?;
        let safe = protect(&result.mathml);
        Ok(if display {
            format!("<span class=\"formula\">{safe}</span>")
        } else {
            safe
        })
    }

    /// The edits that replace each formula of a Markdown `text` by its `MathML`.
    pub fn edits(&self, text: &str, place: Place<'_>, problems: &mut Problems) -> Vec<Edit> {
        let mut edits = Vec::new();
        for found in markdown::formulas(text) {
            match self.formula(&found.latex, found.display) {
                Ok(html) => edits.push((found.range, html)),
                Err(message) => {
                    problems.add(place.file, place.line(text, found.range.start), message);
                }
            }
        }
        edits
    }
}

/// `MathML` in one line, every punctuation mark of its text as a character reference: Markdown then sees
/// tags and words only.
fn protect(mathml: &str) -> String {
    let mut safe = String::with_capacity(mathml.len() * 2);
    let (mut in_tag, mut in_reference) = (false, false);
    for c in mathml.chars() {
        match c {
            '\n' => safe.push(' '),
            '<' | '>' => {
                in_tag = c == '<';
                safe.push(c);
            }
            _ if in_tag || in_reference => {
                in_reference &= c != ';';
                safe.push(c);
            }
            '&' => {
                in_reference = true;
                safe.push(c);
            }
            _ if c.is_ascii_punctuation() => {
                let _ = write!(safe, "&#{};", u32::from(c));
            }
            _ => safe.push(c),
        }
    }
    safe
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::path::Path;

    #[test]
    fn text_of_a_formula_is_invisible_to_markdown() {
        let safe = protect("<mo form=\"infix\">*</mo><mi>a_b</mi><mo>&lt;</mo>\n<mo>|</mo>");
        assert_eq!(
            safe,
            "<mo form=\"infix\">&#42;</mo><mi>a&#95;b</mi><mo>&lt;</mo> <mo>&#124;</mo>"
        );
    }

    #[test]
    fn formulas_of_the_course_parse() {
        let maths = Maths::new().expect("default configuration");
        for latex in [
            r"S(u,v) = (1-v)P_1(u) + v P_2(u)",
            r"\begin{pmatrix} 1-u & u \end{pmatrix}\begin{pmatrix} A & D \\ B & C \end{pmatrix}",
            r"\frac{\partial^2 S}{\partial u\,\partial v}",
            r"\sum_{i=0}^n \binom{n}{i} t^i (1-t)^{n-i}",
            r"\begin{cases} 0 & u < 0 \\ 1 & u \ge 0 \end{cases}",
            r"\mathbb{Q}, \lVert x \rVert, \hat{n} \cdot \vec{l}",
            r"\begin{aligned} a &= b \\ &= c \end{aligned}",
        ] {
            let html = maths.formula(latex, true).expect(latex);
            assert!(html.contains("<math display=\"block\""), "{html}");
            assert!(!html.contains('\n'));
        }
    }

    #[test]
    fn a_formula_that_does_not_parse_is_a_problem_with_its_line() {
        let maths = Maths::new().expect("default configuration");
        let mut problems = Problems::default();
        let place = Place::new(Path::new("page.md"), 10);
        let edits = maths.edits(
            "good $x$\n\nbad $\\nosuchcommand$ `$code$`",
            place,
            &mut problems,
        );
        assert_eq!(edits.len(), 1);
        let found = problems.into_sorted();
        assert_eq!(found.len(), 1);
        assert_eq!(found[0].line, 12);
        assert!(found[0].message.contains("nosuchcommand"), "{}", found[0]);
    }
}
