//! The book in which nothing is wrong.

use crate::sample::{book, build_with, figures, written};

#[test]
fn a_whole_book_is_written() {
    let scratch = book();
    let problems = build_with(&scratch, figures());
    assert!(problems.is_empty(), "{problems:#?}");
    let page = written(&scratch, "coons.html");
    for part in [
        "<section class=\"theorem\" id=\"coons-patch_interpolates\">",
        "Theorem 1.1",
        "<section class=\"hard-case\" id=\"coons-corner_is_far\">",
        "cargo test --test coons -- patch_interpolates",
        "assert_eq!(2, 2);",
        "<figure id=\"figure-coons-square\">",
        "role=\"img\" aria-label=\"Four sides.\"",
        "id=\"coons-square-p\"",
        "<img src=\"figures/coons/pixel.png\" alt=\"Four sides.\" width=\"2\" height=\"3\">",
        "Figure 1.2",
        "<math",
        "href=\"indexes/all.html#work-coons1967\">Coons 1967, section 2</a>",
        "href=\"api/facette/coons/struct.Patch.html#method.new\"",
        "<aside class=\"remark\" id=\"remark-A08-1\">",
        "id=\"exercise-bilinear\"",
        "href=\"#exercise-bilinear\"",
        "processor: P",
        "fn f() {}",
    ] {
        assert!(page.contains(part), "missing: {part}\n{page}");
    }
    assert!(!page.contains("{{#"), "a directive is left");
    let all = written(&scratch, "indexes/all.html");
    assert!(all.contains("href=\"../coons.html#coons-patch_interpolates\">Theorem 1.1</a>"));
    assert!(all.contains("href=\"../coons.html#remark-A08-1\""));
    assert!(written(&scratch, "errata.html").contains("What is true"));
    assert!(
        scratch
            .path()
            .join("target/book/fonts/NewCMMath-Regular.otf")
            .is_file()
    );
    assert!(!scratch.path().join("target/book.new").exists());
}
