//! What the reader sees.

use std::io::{self, Write};

use crate::catalogue::{Chapter, Exercise};
use crate::check::Verdict;
use crate::compiler::CompileError;
use crate::house::House;
use crate::plain_text::{readable, wrapped};
use crate::progress::State;
use crate::protocol::{Failure, Outcome};
use crate::theorem::Theorem;
use crate::workshop;

/// The width of a line of prose, without the margin of its label.
const WIDTH: usize = 78;

/// The margin of labelled lines.
const LABEL: usize = 18;

/// One line for one exercise: a mark, its name, its title and its state.
///
/// # Errors
///
/// Those of `screen`, as for all functions of this module.
pub fn state(
    screen: &mut dyn Write,
    chapter: &Chapter,
    exercise: &Exercise,
    state: &State,
) -> io::Result<()> {
    let (mark, words) = match state {
        State::NotStarted => ('·', "not started".to_owned()),
        State::Unchecked => ('?', "changed since the last check".to_owned()),
        State::Passed { theorems } => ('✓', format!("all {theorems} theorems hold")),
        State::Failing {
            passed,
            theorems,
            stopped_at,
        } => (
            '✗',
            format!("{passed} of {theorems} theorems hold; then {stopped_at}"),
        ),
    };
    let name = format!("{}/{}", chapter.name, exercise.name);
    writeln!(screen, "  {mark} {name:18} {:38} {words}", exercise.title)
}

/// The heading of a check: the exercise and the file to write.
///
/// # Errors
///
/// Those of `screen`.
pub fn heading(
    screen: &mut dyn Write,
    house: &House,
    chapter: &Chapter,
    exercise: &Exercise,
) -> io::Result<()> {
    let file = house.shown(&workshop::folder(house, chapter).join(&exercise.file));
    writeln!(
        screen,
        "{}/{}: {}   ({file})",
        chapter.name, exercise.name, exercise.title
    )
}

/// The tick of a theorem that holds.
///
/// # Errors
///
/// Those of `screen`.
pub fn holds(screen: &mut dyn Write, theorem: &Theorem) -> io::Result<()> {
    writeln!(screen, "  ✓ {}", readable(&theorem.title))?;
    screen.flush()
}

/// Why a check stopped, or that it did not.
///
/// # Errors
///
/// Those of `screen`.
pub fn verdict(
    screen: &mut dyn Write,
    house: &House,
    chapter: &Chapter,
    exercise: &Exercise,
    verdict: &Verdict,
) -> io::Result<()> {
    let Some((theorem, outcome)) = &verdict.stopped_at else {
        return writeln!(screen, "  All {} theorems hold.\n", verdict.theorems);
    };
    let mark = if matches!(outcome, Outcome::NotWritten(_)) {
        '·'
    } else {
        '✗'
    };
    writeln!(screen, "  {mark} {}\n", readable(&theorem.title))?;
    labelled(screen, "The theorem", &readable(&theorem.statement))?;
    match outcome {
        Outcome::Passed => {}
        Outcome::NotWritten(message) => not_written(screen, exercise, message)?,
        Outcome::Failed(failure) => failed(screen, failure)?,
        Outcome::Broken(how) => exactly(screen, "What happened", how)?,
    }
    let page = format!("{}#{}-{}", theorem.page, chapter.name, theorem.name);
    exactly(screen, "Read", &house.shown(&house.book().join(page)))?;
    if !house.book().join(&theorem.page).is_file() {
        exactly(screen, "", "(`cargo book` writes the book)")?;
    }
    let (chapter, exercise) = (&chapter.name, &exercise.name);
    exactly(
        screen,
        "A hint",
        &format!("cargo exercise {chapter}/{exercise} --hint"),
    )?;
    writeln!(screen)
}

fn not_written(screen: &mut dyn Write, exercise: &Exercise, message: &str) -> io::Result<()> {
    let functions = exercise.functions.join(", ");
    exactly(
        screen,
        "Not written yet",
        if message.is_empty() {
            &functions
        } else {
            message
        },
    )
}

fn failed(screen: &mut dyn Write, failure: &Failure) -> io::Result<()> {
    exactly(screen, "Smallest input", &failure.input)?;
    exactly(screen, "Expected", &failure.expected)?;
    exactly(screen, "Got", &failure.got)?;
    match &failure.likely_mistake {
        Some(mistake) => labelled(screen, "Likely mistake", &readable(mistake)),
        None => Ok(()),
    }
}

/// The compiler's first error, and what it means for the chapter's exercises.
///
/// # Errors
///
/// Those of `screen`.
pub fn compile_error(
    screen: &mut dyn Write,
    chapter: &Chapter,
    error: &CompileError,
) -> io::Result<()> {
    let name = &chapter.name;
    let culprit = error.file.as_ref().and_then(|file| {
        chapter
            .exercises
            .iter()
            .find(|exercise| file.ends_with(&exercise.file))
    });
    writeln!(
        screen,
        "The code of chapter {name} does not compile. The first error:\n"
    )?;
    for line in error.message.lines() {
        writeln!(screen, "    {line}")?;
    }
    let file = culprit.map_or("one of your files".to_owned(), |exercise| {
        format!("exercises/{name}/{}", exercise.file.display())
    });
    let exercise = culprit.map_or("<exercise>", |exercise| exercise.name.as_str());
    let advice = format!(
        "As long as {file} does not compile, no exercise of this chapter can be checked. Correct it, or set it aside: \
         `cargo exercise {name}/{exercise} --reset` restores the stub and keeps your file beside it."
    );
    writeln!(screen)?;
    for line in wrapped(&advice, WIDTH) {
        writeln!(screen, "{line}")?;
    }
    Ok(())
}

/// Prose with a label, broken into lines.
fn labelled(screen: &mut dyn Write, label: &str, text: &str) -> io::Result<()> {
    for (index, line) in wrapped(text, WIDTH).iter().enumerate() {
        let label = if index == 0 { label } else { "" };
        exactly(screen, label, line)?;
    }
    Ok(())
}

/// One line with a label, never broken.
fn exactly(screen: &mut dyn Write, label: &str, text: &str) -> io::Result<()> {
    let line = format!("    {label:LABEL$}{text}");
    writeln!(screen, "{}", line.trim_end())
}

/// Hint number `number`, counted from 1.
///
/// # Errors
///
/// Those of `screen`.
pub fn hint(
    screen: &mut dyn Write,
    chapter: &Chapter,
    exercise: &Exercise,
    number: usize,
) -> io::Result<()> {
    let count = exercise.hints.len();
    writeln!(
        screen,
        "{}/{}, hint {number} of {count}:\n",
        chapter.name, exercise.name
    )?;
    let text = number
        .checked_sub(1)
        .and_then(|index| exercise.hints.get(index));
    for line in wrapped(&readable(text.map_or("", String::as_str)), WIDTH) {
        writeln!(screen, "    {line}")?;
    }
    Ok(())
}
