//! What the grader reads: command lines, tables, theorems, formulas.

use std::ffi::OsString;

use facette_grader::catalogue;
use facette_grader::command_line::{self, Command, Target};
use facette_grader::plain_text::{readable, wrapped};
use facette_grader::theorem::{self, Citation, Theorem};

fn command(line: &str) -> Result<Command, String> {
    let arguments = ["grader"].into_iter().chain(line.split_whitespace());
    let arguments: Vec<OsString> = arguments.map(OsString::from).collect();
    command_line::parse(arguments).map_err(|error| error.to_string())
}

fn bilinear() -> Target {
    Target {
        chapter: "coons".to_owned(),
        exercise: Some("bilinear".to_owned()),
    }
}

fn whole_chapter() -> Target {
    Target {
        chapter: "coons".to_owned(),
        exercise: None,
    }
}

#[test]
fn an_action_is_an_option_or_a_word_before_or_after_the_exercise() {
    for line in [
        "coons/bilinear --watch",
        "--watch coons/bilinear",
        "watch coons/bilinear",
        "coons bilinear watch",
    ] {
        assert_eq!(command(line), Ok(Command::Watch(bilinear())), "{line}");
    }
    assert_eq!(command("coons"), Ok(Command::Check(whole_chapter())));
    assert_eq!(
        command("coons/ --check"),
        Ok(Command::Check(whole_chapter()))
    );
    assert_eq!(
        command("coons/bilinear --hint"),
        Ok(Command::Hint(bilinear()))
    );
    assert_eq!(
        command("reset coons/bilinear"),
        Ok(Command::Reset(bilinear()))
    );
}

#[test]
fn without_a_chapter_there_is_the_list() {
    assert_eq!(command(""), Ok(Command::List(None)));
    assert_eq!(command("list"), Ok(Command::List(None)));
    assert_eq!(
        command("list coons"),
        Ok(Command::List(Some(whole_chapter())))
    );
    assert_eq!(command("verify"), Ok(Command::Verify(None)));
    assert_eq!(command("--help"), Ok(Command::Help));
}

#[test]
fn a_command_line_that_is_not_understood_says_why_and_what_is_possible() {
    for (line, complaint) in [
        ("--watch", "`watch` needs a chapter or an exercise"),
        (
            "coons --hint --reset",
            "`hint` and `reset` exclude each other",
        ),
        ("coons bilinear more", "`more` is one word too many"),
        ("coons --solve", "invalid option '--solve'"),
    ] {
        let error = command(line).expect_err(line);
        assert!(error.starts_with(complaint), "{error}");
        assert!(error.contains("cargo exercise verify"), "{error}");
    }
}

const TABLE: &str = r#"
chapter = "coons"
page = "coons.html"
[[exercise]]
name = "bilinear"
title = "The bilinear patch"
file = "src/bilinear.rs"
functions = ["bilinear_point"]
hints = ["first", "second"]
"#;

#[test]
fn a_table_lists_exercises_with_their_hints() {
    let chapter = catalogue::parse(TABLE).expect("the table is right");
    assert_eq!(chapter.name, "coons");
    assert_eq!(chapter.exercises.len(), 1);
    assert_eq!(chapter.exercises[0].hints, ["first", "second"]);
    assert_eq!(
        chapter.exercises[0].solution().to_string_lossy(),
        "solutions/bilinear.rs"
    );
    let unknown = chapter
        .exercise("ruled")
        .expect_err("there is none of that name");
    assert!(
        unknown.to_string().ends_with("its exercises are bilinear"),
        "{unknown}"
    );
}

#[test]
fn a_broken_table_is_refused_with_its_line() {
    let without_file = TABLE.replace("file = \"src/bilinear.rs\"\n", "");
    let error = catalogue::parse(&without_file).expect_err("`file` is missing");
    assert!(
        error.contains("missing field `file`") && error.contains("line 4"),
        "{error}"
    );

    let misspelt = TABLE.replace("hints", "hint");
    let error = catalogue::parse(&misspelt).expect_err("`hint` is no field");
    assert!(error.contains("unknown field `hint`"), "{error}");

    let without_hint = TABLE.replace("\"first\", \"second\"", "");
    let error = catalogue::parse(&without_hint).expect_err("there is no hint");
    assert!(error.contains("exercise `bilinear` has no hint"), "{error}");
}

const TESTS: &str = r"
//! Theorems.

/// A helper, not a theorem.
fn helper() {}

/// **Boundary interpolation.** On its edges the patch is the four curves:
/// $S(u,0)=P_1(u)$.
///
/// A second paragraph.
///
/// Course: A03, slide 10, Coons patches: the definition of the patch.
/// Exercise: bilinear.
/// Exercise: derivative.
#[test]
#[ignore = 'slow']
fn patch_interpolates() {
    assert!(true);
}

#[test]
fn test_without_a_statement() {}

/// **Straight edges.** They give the bilinear surface.
#[test]
fn straight() {}
";

#[test]
fn theorems_are_the_tests_with_a_doc_comment() {
    let theorems = theorem::parse(TESTS);
    let names: Vec<&str> = theorems
        .iter()
        .map(|theorem| theorem.name.as_str())
        .collect();
    assert_eq!(names, ["patch_interpolates", "straight"]);
    let first = &theorems[0];
    assert_eq!(first.title, "Boundary interpolation");
    assert_eq!(
        first.statement,
        "On its edges the patch is the four curves:\n$S(u,0)=P_1(u)$.\n\nA second paragraph."
    );
    assert_eq!(first.exercises, ["bilinear", "derivative"]);
    assert!(theorems[1].exercises.is_empty());
}

#[test]
fn theorems_run_in_the_order_of_the_text() {
    let named = |name: &str| Theorem {
        name: name.to_owned(),
        title: String::new(),
        statement: String::new(),
        exercises: vec![],
        page: String::new(),
    };
    let page =
        "# Coons\n{{#theorem coons::second}} {{#theorem bspline::x}}\n{{#theorem coons::first}}";
    let citations = theorem::cited("coons", "coons/ruled.html", page);
    let citation = |name: &str| Citation {
        name: name.to_owned(),
        page: "coons/ruled.html".to_owned(),
    };
    assert_eq!(citations, [citation("second"), citation("first")]);

    let theorems = vec![named("first"), named("uncited"), named("second")];
    let ordered = theorem::in_order(theorems, &citations, "coons.html");
    let places: Vec<(&str, &str)> = ordered
        .iter()
        .map(|theorem| (theorem.name.as_str(), theorem.page.as_str()))
        .collect();
    let expected = [
        ("second", "coons/ruled.html"),
        ("first", "coons/ruled.html"),
        ("uncited", "coons.html"),
    ];
    assert_eq!(places, expected);
}

#[test]
fn the_pages_of_a_chapter_come_from_the_summary() {
    let summary = "- [Start](start.md)\n- [Coons](./coons.md)\n  - [Twists](coons/twists.md)\n";
    assert_eq!(
        theorem::pages("coons", summary),
        ["coons.md", "coons/twists.md"]
    );
    assert_eq!(theorem::pages("coons", ""), ["coons.md"]);
    assert!(theorem::is_page_of("coons", "coons/twists.md"));
    assert!(!theorem::is_page_of("coons", "coons_patches.md"));
}

#[test]
fn formulas_become_readable() {
    for (markdown, plain) in [
        (
            "On $S_1$ and **all** `a.lerp(b, t)`",
            "On S₁ and all a.lerp(b, t)",
        ),
        (r"$\frac{1}{2}$ of $\frac{a+b}{2}$", "1/2 of (a+b)/2"),
        (r"$$\sum_{i=0}^n b_i \le (1-t)^2$$", "Σ_(i=0)ⁿ bᵢ ≤ (1−t)²"),
        (r"$P_1'(u) \in \mathbb{R}^3$", "P₁′(u) ∈ R³"),
        (r"$\left(u, v\right) \mapsto S_{uv}$", "(u, v) ↦ Sᵤᵥ"),
        (r"$\unknown{x}_{max}$", "unknownx_(max)"),
        ("$unclosed", "unclosed"),
    ] {
        assert_eq!(readable(markdown), plain, "{markdown}");
    }
}

#[test]
fn prose_is_broken_between_words_only() {
    assert_eq!(
        wrapped("one two three\n\nfour", 8),
        ["one two", "three", "", "four"]
    );
    assert_eq!(wrapped("unbreakable", 4), ["unbreakable"]);
    assert_eq!(wrapped("", 4), [""]);
}
