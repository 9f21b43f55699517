//! What the builder refuses in the pages and in what belongs to them.

use crate::chapter_checks;
use crate::directive::Directive;
use crate::expand::Expander;
use crate::figures::ChapterFigure;
use crate::page::{Page, normal};
use crate::problem::{Place, Problems, line_of};
use crate::sources;
use crate::survey::{Reading, Survey};
use crate::tables::field_line;
use std::fs;
use std::path::{Path, PathBuf};

/// Checks the pages one by one, then chapter by chapter: listings, images, includes; place, statements, sources.
pub fn pages(root: &Path, pages: &[Page], survey: &Survey, problems: &mut Problems) {
    chapter_checks::check(pages, survey, problems);
    for (page, reading) in pages.iter().zip(&survey.readings) {
        listings(page, reading, problems);
        images(page, reading, problems);
        for found in &reading.directives {
            if let Ok(Directive::Include(target)) = &found.directive {
                let line = Place::new(&page.file, 1).line(&page.text, found.range.start);
                if let Err(message) = include(root, page, target) {
                    problems.add(&page.file, line, message);
                }
            }
        }
    }
}

/// Rust code in a page is an include, nothing else.
fn listings(page: &Page, reading: &Reading, problems: &mut Problems) {
    for fence in &reading.outline.fences {
        let lines = fence.content.lines().map(str::trim);
        let typed = lines
            .filter(|line| !line.is_empty())
            .any(|line| !(line.starts_with("{{#include ") && line.ends_with("}}")));
        if fence.language == "rust" && (typed || fence.content.trim().is_empty()) {
            let line = Place::new(&page.file, 1).line(&page.text, fence.range.start);
            let message = "Rust code typed into the page: expected `{{#include path:anchor}}` and nothing else";
            problems.add(&page.file, line, message);
        }
    }
}

fn images(page: &Page, reading: &Reading, problems: &mut Problems) {
    let place = Place::new(&page.file, 1);
    for range in &reading.outline.silent_images {
        let line = place.line(&page.text, range.start);
        problems.add(&page.file, line, "an image without alternative text");
    }
    for (range, html) in &reading.outline.html {
        for (at, _) in html.match_indices("<img") {
            let end = html[at..].find('>').map_or(html.len(), |end| at + end);
            let tag = &html[at..end];
            if !tag.contains(" alt=\"") || tag.contains(" alt=\"\"") {
                let line = place.line(&page.text, range.start + at);
                problems.add(&page.file, line, "an image without alternative text");
            }
        }
    }
}

/// Checks that the file and the anchor of an include exist.
fn include(root: &Path, page: &Page, target: &str) -> Result<(), String> {
    let (path, anchor) = target.split_once(':').unwrap_or((target, ""));
    let folder = page.file.parent().unwrap_or(Path::new(""));
    let file = normal(&folder.join(path))
        .ok_or_else(|| format!("the include `{path}` leaves the repository"))?;
    let text = fs::read_to_string(root.join(&file))
        .map_err(|error| format!("the include `{path}` cannot be read: {error}"))?;
    if anchor.is_empty() {
        return Ok(());
    }
    if anchor
        .chars()
        .next()
        .is_some_and(|c| c.is_ascii_digit() || c == ':')
    {
        return Err(format!(
            "the include `{target}` counts lines, which move: expected an anchor"
        ));
    }
    for mark in ["ANCHOR", "ANCHOR_END"] {
        let wanted = format!("{mark}: {anchor}");
        if !text.lines().any(|line| line.trim().ends_with(&wanted)) {
            return Err(format!("{} has no line `// {wanted}`", file.display()));
        }
    }
    Ok(())
}

/// Checks that everything that exists is used: theorems, figures, works, exercises.
pub fn unused(expander: &mut Expander<'_>) {
    let (material, survey) = (&expander.material, expander.survey);
    let problems = &mut *expander.problems;
    for theorem in &material.theorems {
        if survey.theorem(theorem.kind, &theorem.path()).is_none() {
            let message = format!(
                "no page cites this test: expected `{{{{#{} {}}}}}` in a chapter",
                theorem.kind.directive(),
                theorem.path()
            );
            problems.add(&theorem.file, theorem.line, message);
        }
        for name in &theorem.exercises {
            if material.exercise(&theorem.chapter, name).is_none() {
                let message = format!(
                    "book/exercises/{}/exercise.toml has no exercise `{name}`",
                    theorem.chapter
                );
                problems.add(&theorem.file, theorem.line, message);
            }
        }
    }
    for figure in &material.figures {
        let path = format!("{}::{}", figure.chapter, figure.figure.name);
        if !survey.figures.contains_key(&path) {
            let message = format!("no page shows the figure `{path}`");
            let (file, line) = figure_place(&material.root, figure);
            problems.add(&file, line, message);
        }
    }
    for work in &material.works.rows {
        if !material.cited.contains(&work.key) {
            let line = material.works.line("key", &work.key);
            let message = format!("no page cites `{}`", work.key);
            problems.add(&material.works.file, line, message);
        }
    }
    ungraded(expander);
    unlisted(expander);
}

/// Where an example names the figure.
fn figure_place(root: &Path, figure: &ChapterFigure) -> (PathBuf, usize) {
    let example = PathBuf::from(format!("examples/{}.rs", figure.chapter));
    let wanted = format!("\"{}\"", figure.figure.name);
    let files = sources::of_example(root, &figure.chapter).unwrap_or_default();
    let examples = files.into_iter().filter(|f| f.starts_with("examples"));
    for file in examples {
        let text = fs::read_to_string(root.join(&file)).unwrap_or_default();
        if let Some(at) = text.find(&wanted) {
            return (file, line_of(&text, at));
        }
    }
    (example, 1)
}

/// An exercise that no theorem grades.
fn ungraded(expander: &mut Expander<'_>) {
    let material = &expander.material;
    for list in &material.exercises {
        for exercise in &list.exercises {
            let graded = material.theorems.iter().any(|theorem| {
                theorem.chapter == list.chapter && theorem.exercises.contains(&exercise.name)
            });
            if !graded {
                let line = field_line(&list.text, "name", &exercise.name);
                let message = format!("no theorem grades the exercise `{}`", exercise.name);
                expander.problems.add(&list.file, line, message);
            }
        }
    }
}

/// Exercises that no page lists.
fn unlisted(expander: &mut Expander<'_>) {
    let readings = &expander.survey.readings;
    for list in &expander.material.exercises {
        let wanted = Ok(Directive::Exercises(list.chapter.clone()));
        let mut directives = readings.iter().flat_map(|reading| &reading.directives);
        if !directives.any(|found| found.directive == wanted) {
            let message = format!(
                "no page lists these exercises: expected `{{{{#exercises {}}}}}` in a page of the chapter",
                list.chapter
            );
            expander.problems.add(&list.file, 1, message);
        }
    }
}
