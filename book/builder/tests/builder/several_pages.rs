//! A chapter of several pages beside one of a single page, and a chapter without exercises and measurements.

use crate::sample::{book, build_with, figures, written};
use facette_builder::scratch::Scratch;
use std::fs;

const SUMMARY: &str = "# Summary

- [Patches](coons.md)
- [Splines](bspline.md)
  - [The basis](bspline/basis.md)
  - [Exercises](bspline/exercises.md)
- [Triangles](tessellation.md)
- [Errata](errata.md)
- [Index](indexes/all.md)
";

const EXERCISES: &str = "chapter = \"bspline\"
page = \"bspline/exercises.html\"
[[exercise]]
name = \"basis\"
title = \"The basis\"
file = \"src/basis.rs\"
functions = [\"basis_functions\"]
hints = [\"first\"]
";

fn test(name: &str, trailer: &str) -> String {
    format!("/// **On {name}.** Text.\n///\n{trailer}#[test]\nfn {name}() {{\n}}\n")
}

/// The sample book with the two further chapters.
fn longer_book() -> Scratch {
    let scratch = book();
    let course =
        "/// Course: B04, slide 16, the sum is 1.\n/// Exercise: basis.\n/// Erratum: Half open.\n";
    let [hull, sum] = [test("hull", ""), test("sum", course)];
    for (file, text) in [
        ("book/src/SUMMARY.md", SUMMARY),
        (
            "book/src/bspline.md",
            "# Splines\n\nSee [the sum](bspline/basis.md#bspline-sum).\n\n{{#theorem bspline::hull}}\n",
        ),
        (
            "book/src/bspline/basis.md",
            "# The basis\n\n{{#theorem bspline::sum}}\n\nOf {{#cite coons1967}} and {{#api coons::Patch}}.\n\n```rust\n{{#include ../../../src/coons.rs:heart}}\n```\n\n{{#remark B18, slide 26, Closing: words}}\nWords.\n{{#endremark}}\n",
        ),
        (
            "book/src/bspline/exercises.md",
            "# Exercises\n\n{{#exercises bspline}}\n\n## Sources\n\nAll of it.\n",
        ),
        (
            "book/src/tessellation.md",
            "# Triangles\n\n{{#theorem tessellation::bound}}\n\n## Sources\n\nAll of it.\n",
        ),
        ("tests/bspline/basis_theorems.rs", &sum),
        ("tests/bspline/curve_theorems.rs", &hull),
        ("tests/tessellation/theorems.rs", &test("bound", "")),
        ("book/exercises/bspline/exercise.toml", EXERCISES),
    ] {
        scratch.write(file, text);
    }
    scratch
}

/// The problems of the longer book with one text replaced.
fn problems_with(file: &str, from: &str, to: &str) -> Vec<String> {
    let scratch = longer_book();
    let text = fs::read_to_string(scratch.path().join(file)).expect(file);
    assert!(text.contains(from), "{file} does not hold {from}");
    scratch.write(file, &text.replacen(from, to, 1));
    let problems = build_with(&scratch, figures());
    problems.iter().map(ToString::to_string).collect()
}

fn assert_contains(page: &str, parts: &[&str]) {
    for part in parts {
        assert!(page.contains(part), "missing: {part}\n{page}");
    }
}

#[test]
fn theorems_are_counted_through_the_pages_of_a_chapter() {
    let scratch = longer_book();
    let problems = build_with(&scratch, figures());
    assert!(problems.is_empty(), "{problems:#?}");
    let [first, basis] = ["bspline.html", "bspline/basis.html"].map(|page| written(&scratch, page));
    assert_contains(
        &first,
        &["Theorem 2.1", "href=\"bspline/basis.html#bspline-sum\""],
    );
    assert_contains(
        &basis,
        &[
            "Theorem 2.2",
            "cargo test --test bspline -- sum",
            "href=\"../bspline/exercises.html#exercise-basis\">The basis</a>",
            "href=\"../indexes/all.html#work-coons1967\"",
            "href=\"../api/facette/coons/struct.Patch.html\"",
            "fn f() {}",
        ],
    );
    assert_contains(&written(&scratch, "tessellation.html"), &["Theorem 3.1"]);
}

#[test]
fn links_from_other_pages_lead_to_the_page_of_the_chapter() {
    let scratch = longer_book();
    let problems = build_with(&scratch, figures());
    assert!(problems.is_empty(), "{problems:#?}");
    let exercises = written(&scratch, "bspline/exercises.html");
    let graded = "It is graded by <a href=\"../bspline/basis.html#bspline-sum\">Theorem 2.2</a>";
    assert_contains(
        &exercises,
        &["Exercise 2.1", "cargo exercise bspline/basis", graded],
    );
    let all = written(&scratch, "indexes/all.html");
    assert_contains(
        &all,
        &[
            "<a href=\"../bspline.html#bspline-hull\">Theorem 2.1</a>",
            "<a href=\"../bspline/basis.html#bspline-sum\">Theorem 2.2</a>",
            "<a href=\"../bspline/basis.html\">Splines: The basis</a>",
            "<a href=\"../bspline/basis.html#remark-B18-2\">Remark</a>",
            "href=\"#splines\"",
        ],
    );
    assert_eq!(
        all.matches("href=\"#splines\"").count(),
        1,
        "one heading a chapter"
    );
    let errata = written(&scratch, "errata.html");
    assert_contains(
        &errata,
        &["<a href=\"bspline/basis.html#bspline-sum\">Theorem 2.2</a>"],
    );
}

/// File, what is replaced there, by what, how the problem begins.
const REFUSED: &[[&str; 4]] = &[
    [
        "book/src/SUMMARY.md",
        "  - [The basis]",
        "- [The basis]",
        "book/src/bspline/basis.md:1: a page of the chapter `bspline` with a number of its own",
    ],
    [
        "book/src/bspline/exercises.md",
        "## Sources",
        "## Origins",
        "book/src/bspline.md:1: a chapter with theorems but without a section `Sources`",
    ],
    [
        "book/src/bspline/exercises.md",
        "## Sources",
        "## Exercises\n\n## The idea\n\n## Sources",
        "book/src/bspline/exercises.md:7: the section `The idea` stands behind `Exercises`",
    ],
    [
        "book/src/tessellation.md",
        "## Sources",
        "{{#theorem bspline::sum}}\n\n## Sources",
        "book/src/tessellation.md:5: `bspline::sum` belongs to the chapter `bspline`",
    ],
    [
        "book/src/bspline/exercises.md",
        "{{#exercises bspline}}",
        "",
        "book/exercises/bspline/exercise.toml:1: no page lists these exercises",
    ],
    [
        "book/exercises/bspline/exercise.toml",
        "bspline/exercises.html",
        "bspline.html",
        "book/exercises/bspline/exercise.toml:2: page = \"bspline.html\", but",
    ],
];

#[test]
fn pages_of_a_chapter_stand_and_hold_together() {
    for [file, from, to, message] in REFUSED {
        let problems = problems_with(file, from, to);
        let found = problems.iter().any(|problem| problem.starts_with(message));
        assert!(found, "expected {message}, got {problems:#?}");
    }
}
