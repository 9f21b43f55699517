//! What the builder refuses in the pages of a chapter taken together: a chapter is the page `<name>.md` and, where it has
//! outgrown one page, the pages of the folder `<name>/`.

use crate::directive::Directive;
use crate::page::{Page, first_of};
use crate::problem::{Place, Problems};
use crate::survey::{Reading, Survey};
use std::collections::BTreeSet;

/// The sections of a page that have a fixed name, in their fixed order. No page needs all of them, and others may stand between.
const SECTIONS: [&str; 9] = [
    "The idea",
    "Definitions",
    "The algorithm",
    "Theorems",
    "What goes wrong in floating point",
    "Speed against error",
    "From the slides",
    "Exercises",
    "Sources",
];

/// Checks all chapters.
pub fn check(pages: &[Page], survey: &Survey, problems: &mut Problems) {
    let mut without_sources = BTreeSet::new();
    for (page, reading) in pages.iter().zip(&survey.readings) {
        numbers(pages, page, problems);
        order(page, reading, problems);
        let cites = statements(page, reading, problems);
        if cites && !has_sources(pages, survey, page) && without_sources.insert(page.chapter()) {
            let message =
                "a chapter with theorems but without a section `Sources` on any of its pages";
            problems.add(&page.file, 1, message);
        }
    }
}

/// The sections stand in their order on each page.
fn order(page: &Page, reading: &Reading, problems: &mut Problems) {
    let below_the_title = reading.outline.headings.iter().skip(1);
    let headings = below_the_title.map(|heading| heading.trim());
    let places = headings.filter_map(|h| SECTIONS.iter().position(|section| *section == h));
    let places: Vec<usize> = places.collect();
    for pair in places.windows(2).filter(|pair| pair[1] <= pair[0]) {
        let [before, after] = [SECTIONS[pair[0]], SECTIONS[pair[1]]];
        let line = page
            .text
            .lines()
            .position(|line| line.trim_start_matches('#').trim() == after);
        let message = format!(
            "the section `{after}` stands behind `{before}`: expected the order {}",
            SECTIONS.join(", ")
        );
        problems.add(&page.file, line.map_or(1, |line| line + 1), message);
    }
}

/// The pages of a chapter share its number, by which theorems and figures are counted.
fn numbers(pages: &[Page], page: &Page, problems: &mut Problems) {
    let Some(first) = first_of(pages, &page.chapter()) else {
        return;
    };
    if first.number != page.number {
        let message = format!(
            "a page of the chapter `{}` with a number of its own: expected it in SUMMARY.md below {} and indented",
            page.chapter(),
            first.path.display()
        );
        problems.add(&page.file, 1, message);
    }
}

/// Theorems and hard cases stand in pages of their own chapter, where the exercises' grader looks for them. Returns
/// whether the page has any.
fn statements(page: &Page, reading: &Reading, problems: &mut Problems) -> bool {
    let mut cites = false;
    for found in &reading.directives {
        let Ok(Directive::Theorem(path) | Directive::HardCase(path)) = &found.directive else {
            continue;
        };
        cites = true;
        let chapter = path.split("::").next().unwrap_or_default();
        if !page.is_of(chapter) {
            let line = Place::new(&page.file, 1).line(&page.text, found.range.start);
            let message = format!(
                "`{path}` belongs to the chapter `{chapter}`: expected it in {chapter}.md or in a page of {chapter}/"
            );
            problems.add(&page.file, line, message);
        }
    }
    cites
}

/// Whether some page of the same chapter has a section `Sources`.
fn has_sources(pages: &[Page], survey: &Survey, page: &Page) -> bool {
    let chapter = page.chapter();
    let of_chapter = pages.iter().zip(&survey.readings);
    of_chapter
        .filter(|(other, _)| other.is_of(&chapter))
        .flat_map(|(_, reading)| &reading.outline.headings)
        .any(|heading| heading.trim() == "Sources")
}
