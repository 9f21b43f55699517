//! A small book that is whole.

use facette_builder::figures::ChapterFigure;
use facette_builder::problem::Problem;
use facette_builder::render::{Job, build};
use facette_builder::scratch::Scratch;
use facette_figure::{Content, Figure};
use std::fs;

pub const PAGE: &str = "# Patches

The patch $S(u,v)$ of {{#cite coons1967, section 2}} is {{#api coons::Patch}}, made by {{#api coons::Patch::new}}.
See [the errata](errata.md#errata) and ![a dot](dot.png).

{{#figure coons::square}}

{{#figure coons::pixel}}

```rust
{{#include ../../src/coons.rs:heart}}
```

{{#theorem coons::patch_interpolates}}

{{#hard_case coons::corner_is_far}}

{{#remark A08, slide 8, Coons patches: history}}
Published in 1967.
{{#endremark}}

{{#speed coons}}

{{#exercises coons}}

## Sources

All of it.
";

const THEOREMS: &str = "/// **Interpolation of $P_1$.** On the edge $S(u,0)=P_1(u)$.
///
/// Course: A03, slide 10, Coons patches: the definition.
/// Exercise: bilinear.
/// Erratum: The slide says $S_1 + S_2$.
#[test]
fn patch_interpolates() {
    assert_eq!(1, 1);

    assert_eq!(2, 2);
}
";

const HARD_CASES: &str = "/// **Far away.** It still meets.
#[test]
fn corner_is_far() {
    assert_eq!(1, 1);
}
";

const CSV: &str = "# processor: P
# date: 2026-01-02
quantity,algorithm,scalar,threads,inputs,n,ns_per_eval,spread,ratio,max_ulp,max_abs,rms,wrong
point,direct,f64,1,typical,10,5.0,0.1,1.0,2,1e-16,1e-17,
";

const BOOK: &str = "[book]
title = \"T\"
[output.html]
input-404 = \"\"
[output.html.print]
enable = false
";

const SUMMARY: &str = "# Summary

- [Patches](coons.md)
- [Errata](errata.md)
- [Index](indexes/all.md)
";

const INDEXES: &str = "# All

{{#theorem_index}}

{{#slide_map}}

{{#glossary}}

{{#bibliography}}
";

const WORKS: &str = "[[entry]]
key = \"coons1967\"
authors = [\"Steven A. Coons\"]
title = \"Surfaces\"
year = 1967
published = \"MIT\"
";

const TERMS: &str = "[[entry]]
french = \"coin\"
english = \"corner\"
meaning = \"Where $P_1$ begins.\"
chapter = \"coons\"
";

const EXERCISES: &str = "chapter = \"coons\"
page = \"coons.html\"
[[exercise]]
name = \"bilinear\"
title = \"The bilinear patch\"
file = \"src/bilinear.rs\"
functions = [\"bilinear_point\"]
hints = [\"first\"]
";

/// The first bytes of a PNG file, which name its size: 2 by 3 pixels.
const PIXEL: &[u8] = b"\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR\0\0\0\x02\0\0\0\x03";

/// A small book that is whole.
pub fn book() -> Scratch {
    let scratch = Scratch::new();
    for (file, text) in [
        ("book/book.toml", BOOK),
        ("book/src/SUMMARY.md", SUMMARY),
        ("book/src/coons.md", PAGE),
        ("book/src/errata.md", "# Errata\n\n{{#errata}}\n"),
        ("book/src/indexes/all.md", INDEXES),
        ("book/src/dot.png", "dot"),
        ("book/bibliography.toml", WORKS),
        ("book/glossary.toml", TERMS),
        ("book/measurements/coons.csv", CSV),
        ("book/exercises/coons/exercise.toml", EXERCISES),
        ("tests/coons/theorems.rs", THEOREMS),
        ("tests/coons/hard_cases.rs", HARD_CASES),
        (
            "src/coons.rs",
            "//! [the page](../../../coons.html)\n// ANCHOR: heart\nfn f() {}\n// ANCHOR_END: heart\n",
        ),
        (
            "examples/coons.rs",
            "const FIGURES: &[&str] = &[\n    \"square\",\n    \"pixel\",\n];\n",
        ),
        (
            "doc/facette/coons/struct.Patch.html",
            "<section id=\"method.new\"><a href=\"../../../coons.html\">the page</a>",
        ),
    ] {
        scratch.write(file, text);
    }
    scratch
}

pub fn figures() -> Vec<ChapterFigure> {
    let svg = "<svg viewBox=\"0 0 1 1\"><path id=\"p\" d=\"M0 0\"/></svg>";
    [
        ("square", Content::Svg(svg.to_owned())),
        ("pixel", Content::Png(PIXEL.to_vec())),
    ]
    .map(|(name, content)| ChapterFigure {
        chapter: "coons".to_owned(),
        figure: Figure {
            name,
            caption: "The square $[0,1]^2$.".to_owned(),
            alternative: "Four sides.".to_owned(),
            content,
        },
    })
    .to_vec()
}

pub fn build_with(scratch: &Scratch, figures: Vec<ChapterFigure>) -> Vec<Problem> {
    build(Job {
        root: scratch.path(),
        figures,
        rustdoc: &scratch.path().join("doc"),
        output: &scratch.path().join("target/book"),
    })
    .expect("the files can be read and written")
}

pub fn written(scratch: &Scratch, file: &str) -> String {
    fs::read_to_string(scratch.path().join("target/book").join(file)).expect(file)
}

/// Breaks one file by a replacement and returns the problems.
fn broken(file: &str, from: &str, to: &str) -> (Scratch, Vec<Problem>) {
    let scratch = book();
    let text = fs::read_to_string(scratch.path().join(file)).expect(file);
    assert!(text.contains(from), "{file} does not hold {from}");
    scratch.write(file, &text.replacen(from, to, 1));
    scratch.write("target/book/before.txt", "the book that was there");
    let problems = build_with(&scratch, figures());
    (scratch, problems)
}

/// Asserts that a break gives a problem in `place`, a file and a line, that says `message`, and changes nothing.
pub fn refused(file: &str, from: &str, to: &str, place: &str, message: &str) {
    let (scratch, problems) = broken(file, from, to);
    let found = problems
        .iter()
        .map(ToString::to_string)
        .any(|problem| problem.starts_with(&format!("{place}: ")) && problem.contains(message));
    assert!(found, "expected {place}: {message}, got {problems:#?}");
    assert_eq!(written(&scratch, "before.txt"), "the book that was there");
    assert!(!scratch.path().join("target/book.new").exists());
}
