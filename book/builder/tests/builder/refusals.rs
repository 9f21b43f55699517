//! The whole book with one thing broken at a time: each break is refused, with file and line, and leaves the book
//! that was there before.

use crate::sample::{PAGE, book, build_with, figures, refused};
use facette_figure::Figure;

const COONS: &str = "book/src/coons.md";

#[test]
fn missing_includes_and_anchors_are_refused() {
    refused(
        COONS,
        "coons.rs:heart",
        "none.rs:heart",
        "book/src/coons.md:11",
        "cannot be read",
    );
    refused(
        COONS,
        "rs:heart",
        "rs:soul",
        "book/src/coons.md:11",
        "has no line `// ANCHOR: soul`",
    );
    refused(
        COONS,
        "rs:heart",
        "rs:2:3",
        "book/src/coons.md:11",
        "counts lines",
    );
    refused(
        COONS,
        "{{#include ../../src/coons.rs:heart}}",
        "fn typed() {}",
        "book/src/coons.md:10",
        "typed into the page",
    );
}

/// File, what is replaced there, by what, the place of the problem, what it says.
const DEAD_LINKS: &[[&str; 5]] = &[
    [
        COONS,
        "errata.md#errata",
        "gone.md",
        "book/src/coons.md:4",
        "dead link",
    ],
    [
        COONS,
        "errata.md#errata",
        "errata.md#gone",
        "book/src/coons.md:4",
        "has no `#gone`",
    ],
    [
        COONS,
        "dot.png",
        "gone.png",
        "book/src/coons.md:4",
        "dead link `gone.png`",
    ],
    [
        COONS,
        "dot.png",
        "https://example.org/x.png",
        "book/src/coons.md:4",
        "from elsewhere",
    ],
    [
        COONS,
        "errata.md#errata",
        "../../../x.html",
        "book/src/coons.md:4",
        "leaves the book",
    ],
    [
        "tests/coons/theorems.rs",
        "On the edge",
        "On [an edge](gone.html)",
        "tests/coons/theorems.rs:1",
        "dead link",
    ],
    [
        "doc/facette/coons/struct.Patch.html",
        "coons.html",
        "gone.html",
        "src/lib.rs:1",
        "in the rustdoc: dead link",
    ],
];

#[test]
fn dead_links_are_refused() {
    for [file, from, to, place, message] in DEAD_LINKS {
        refused(file, from, to, place, message);
    }
}

#[test]
fn images_without_words_are_refused() {
    refused(
        COONS,
        "![a dot]",
        "![]",
        "book/src/coons.md:4",
        "without alternative text",
    );
    refused(
        COONS,
        "![a dot](dot.png)",
        "<img src=\"dot.png\">",
        "book/src/coons.md:4",
        "without alternative text",
    );
    for (what, change) in [
        (
            "caption",
            (|f: &mut Figure| f.caption.clear()) as fn(&mut Figure),
        ),
        ("alternative text", |f| f.alternative = " ".to_owned()),
    ] {
        let mut figures = figures();
        change(&mut figures[0].figure);
        let problems = build_with(&book(), figures);
        let wanted = format!("book/src/coons.md:6: the figure `coons::square` has no {what}");
        assert!(
            problems.iter().any(|p| p.to_string() == wanted),
            "{problems:#?}"
        );
    }
}

/// File, what is replaced there, by what, the place of the problem, what it says.
const LONELY: &[[&str; 5]] = &[
    [
        COONS,
        "{{#theorem coons::patch_interpolates}}",
        "",
        "tests/coons/theorems.rs:1",
        "no page cites this test",
    ],
    [
        COONS,
        "{{#hard_case coons::corner_is_far}}",
        "",
        "tests/coons/hard_cases.rs:1",
        "no page cites this test",
    ],
    [
        COONS,
        "{{#theorem coons::patch_interpolates}}",
        "{{#theorem coons::unknown}}",
        "book/src/coons.md:14",
        "no test proves `coons::unknown`",
    ],
    [
        COONS,
        "{{#theorem coons::patch_interpolates}}",
        "{{#theorem coons::corner_is_far}}",
        "book/src/coons.md:14",
        "no test proves",
    ],
    [
        COONS,
        "{{#speed coons}}",
        "{{#theorem coons::patch_interpolates}}",
        "book/src/coons.md:22",
        "a second time",
    ],
    [
        COONS,
        "{{#figure coons::square}}",
        "",
        "examples/coons.rs:2",
        "no page shows the figure",
    ],
    [
        COONS,
        "coons::square",
        "coons::circle",
        "book/src/coons.md:6",
        "no figure `coons::circle`",
    ],
];

#[test]
fn theorems_and_figures_belong_to_exactly_one_page() {
    for [file, from, to, place, message] in LONELY {
        refused(file, from, to, place, message);
    }
}

#[test]
fn citations_and_works_belong_together() {
    refused(
        COONS,
        "coons1967",
        "coons1968",
        "book/src/coons.md:3",
        "unknown citation `coons1968`",
    );
    refused(
        COONS,
        "{{#cite coons1967, section 2}}",
        "Coons",
        "book/bibliography.toml:2",
        "no page cites `coons1967`",
    );
    refused(
        "book/src/indexes/all.md",
        "{{#bibliography}}",
        "",
        "book/src/coons.md:3",
        "no page has `{{#bibliography}}`",
    );
}

#[test]
fn formulas_that_do_not_parse_are_refused_wherever_they_stand() {
    refused(
        COONS,
        "$S(u,v)$",
        "$\\nosuch$",
        "book/src/coons.md:3",
        "does not parse",
    );
    refused(
        "tests/coons/theorems.rs",
        "$S(u,0)=P_1(u)$",
        "$\\frac{1}$",
        "tests/coons/theorems.rs:1",
        "does not parse",
    );
    refused(
        "book/glossary.toml",
        "$P_1$",
        "$\\\\nosuch$",
        "book/glossary.toml:2",
        "does not parse",
    );
}

#[test]
fn directives_and_lines_of_the_course_are_well_formed() {
    refused(
        COONS,
        "{{#speed coons}}",
        "{{#sped coons}}",
        "book/src/coons.md:22",
        "unknown directive `sped`",
    );
    refused(
        COONS,
        "A08, slide 8,",
        "A08, slide,",
        "book/src/coons.md:18",
        "does not name a slide",
    );
    refused(
        COONS,
        "{{#endremark}}",
        "",
        "book/src/coons.md:18",
        "no `{{#endremark}}`",
    );
    refused(
        "tests/coons/theorems.rs",
        "slide 10",
        "page 10",
        "tests/coons/theorems.rs:3",
        "Course line",
    );
}

/// File, what is replaced there, by what, the place of the problem, what it says.
const INCOMPLETE: &[[&str; 5]] = &[
    [
        COONS,
        "## Sources",
        "## Origins",
        "book/src/coons.md:1",
        "without a section `Sources`",
    ],
    [
        "tests/coons/theorems.rs",
        "Exercise: bilinear",
        "Exercise: cubic",
        "tests/coons/theorems.rs:1",
        "no exercise `cubic`",
    ],
    [
        "tests/coons/theorems.rs",
        "/// Exercise: bilinear.\n",
        "",
        "book/exercises/coons/exercise.toml:4",
        "no theorem grades",
    ],
    [
        COONS,
        "{{#exercises coons}}",
        "{{#exercises mesh}}",
        "book/src/coons.md:24",
        "no exercises of `mesh`",
    ],
    [
        COONS,
        "{{#speed coons}}",
        "{{#speed mesh}}",
        "book/src/coons.md:22",
        "no measurements of `mesh`",
    ],
    [
        "book/measurements/coons.csv",
        "point,direct",
        "point",
        "book/measurements/coons.csv:4",
        "12 cells",
    ],
    [
        COONS,
        "coons::Patch::new",
        "coons::Patch::old",
        "book/src/coons.md:3",
        "no public item `coons::Patch::old`",
    ],
    [
        "book/glossary.toml",
        "chapter = \"coons\"",
        "chapter = \"mesh\"",
        "book/glossary.toml:2",
        "no chapter `mesh`",
    ],
];

#[test]
fn chapters_have_sources_exercises_measurements_and_items() {
    for [file, from, to, place, message] in INCOMPLETE {
        refused(file, from, to, place, message);
    }
}

#[test]
fn html_that_does_not_close_is_refused() {
    let open = "<div>\n\nAll of it.";
    let message = "mdBook: unclosed HTML tag";
    refused(COONS, "All of it.", open, "book/src/coons.md:1", message);
}

#[test]
fn all_problems_are_told_together() {
    let scratch = book();
    let page = PAGE
        .replace("$S(u,v)$", "$\\nosuch$")
        .replace("dot.png", "gone.png");
    scratch.write("book/src/coons.md", &page);
    let problems = build_with(&scratch, figures());
    assert_eq!(problems.len(), 2, "{problems:#?}");
}
