use super::*;

const TEXT: &str = r#"//! Theorems.

/// **Boundary interpolation.** On its edges the patch is
/// the four curves: $S(u,0)=P_1(u)$.
///
/// A second paragraph.
///
/// Course: A03, slide 10, Coons patches: the definition of the patch.
/// Exercise: bilinear.
/// Erratum: The slide says that "it just works".
#[test]
#[ignore = "slow"]
fn patch_interpolates() {
    // ANCHOR: heart
    let x = {
        1
    };
    assert_eq!(x, 1);
}

proptest! {
    /// **Inside
    /// a macro.** Yes.
    #[test]
    fn indented(x in 0..3) {
        prop_assert!(x < 3);
    }
}
"#;

fn scan_sample(text: &str) -> (Vec<Theorem>, Vec<String>) {
    let mut problems = Problems::default();
    let file = Path::new("tests/coons/theorems.rs");
    let theorems = scan_text(text, Kind::Theorem, "coons", file, &mut problems);
    let messages = problems
        .into_sorted()
        .iter()
        .map(ToString::to_string)
        .collect();
    (theorems, messages)
}

#[test]
fn a_doc_comment_is_title_statement_and_trailer() {
    let (theorems, messages) = scan_sample(TEXT);
    assert!(messages.is_empty(), "{messages:?}");
    let theorem = &theorems[0];
    assert_eq!(theorem.name, "patch_interpolates");
    assert_eq!(theorem.title, "Boundary interpolation");
    assert!(theorem.statement.starts_with(" On its edges"));
    assert!(theorem.statement.ends_with("A second paragraph."));
    assert_eq!(theorem.topics[0].slide, "slide 10");
    assert_eq!(
        theorem.topics[0].topic,
        "Coons patches: the definition of the patch"
    );
    assert_eq!(theorem.exercises, ["bilinear"]);
    assert_eq!(theorem.errata, ["The slide says that \"it just works\"."]);
    assert_eq!(theorem.line, 3);
    assert!(theorem.code.starts_with("fn patch_interpolates() {"));
    assert!(theorem.code.ends_with("assert_eq!(x, 1);\n}"));
    assert!(!theorem.code.contains("ANCHOR"));
}

#[test]
fn a_test_inside_a_macro_loses_its_indentation() {
    let (theorems, _) = scan_sample(TEXT);
    assert_eq!(theorems[1].title, "Inside a macro");
    assert_eq!(
        theorems[1].code,
        "fn indented(x in 0..3) {\n    prop_assert!(x < 3);\n}"
    );
    assert_eq!(theorems[1].statement, "\n Yes.");
}

#[test]
fn a_test_without_statement_or_title_is_a_problem() {
    let (_, messages) =
        scan_sample("#[test]\nfn bare() {\n}\n\n/// No title.\n#[test]\nfn plain() {\n}\n");
    assert_eq!(messages.len(), 2);
    assert!(messages[0].contains("theorems.rs:1: the test `bare` has no doc comment"));
    assert!(messages[1].contains("theorems.rs:5: the doc comment of `plain` does not begin"));
}

#[test]
fn text_after_the_trailer_is_a_problem() {
    let (_, messages) =
        scan_sample("/// **T.** x\n/// Erratum: it says\n/// that.\n#[test]\nfn f() {\n}\n");
    assert_eq!(messages.len(), 1);
    assert!(messages[0].contains("theorems.rs:3: text after the trailer lines"));
}

#[test]
fn malformed_topics_say_what_is_expected() {
    assert!(Topic::parse("A03, slides 10-12, a topic, with a comma.").is_ok());
    assert!(Topic::parse("plan, slide 2, the plan of the course.").is_ok());
    for (text, part) in [
        ("A03, slide 10", "fewer than three parts"),
        ("03, slide 10, x", "neither a claim's letter and number"),
        ("A, slide 10, x", "neither a claim's letter and number"),
        ("A03, page 10, x", "does not name a slide"),
        ("A03, slide ten, x", "does not name a slide"),
        ("A03, slide 10, .", "has no topic"),
    ] {
        let message = Topic::parse(text).expect_err(text);
        assert!(message.contains(part), "{message}");
        assert!(message.contains("A03, slide 10"), "{message}");
    }
}

#[test]
fn a_chapter_may_have_several_files_of_theorems() {
    let scratch = crate::scratch::Scratch::new();
    let test = |name: &str| format!("/// **T.** x\n#[test]\nfn {name}() {{}}\n");
    scratch.write("tests/coons/theorems.rs", &test("a"));
    scratch.write("tests/coons/bicubic_theorems.rs", &test("b"));
    scratch.write("tests/coons/theorems/more.rs", &test("c"));
    scratch.write("tests/coons/oracles.rs", &test("not_a_theorem"));
    scratch.write("tests/coons/hard_cases.rs", &test("d"));
    let mut problems = Problems::default();
    let theorems = scan(scratch.path(), &mut problems).expect("readable");
    let mut found: Vec<(&str, &str)> = theorems
        .iter()
        .map(|t| (t.kind.stem(), t.name.as_str()))
        .collect();
    found.sort_unstable();
    let expected = ["a", "b", "c"].map(|name| ("theorems", name));
    assert_eq!(found[0], ("hard_cases", "d"));
    assert_eq!(found[1..], expected);
    assert!(problems.is_empty());
}
