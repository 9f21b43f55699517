//! What each command does.

use std::env;
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::time::Instant;

use crate::catalogue::{Chapter, Exercise};
use crate::check::{self, Verdict};
use crate::command_line::{Command, HELP, Target};
use crate::compiler::{self, Build};
use crate::error::GraderError;
use crate::house::House;
use crate::progress::{self, Progress, State};
use crate::report;
use crate::runner::TestBinary;
use crate::theorem::{self, Theorem};
use crate::verify;
use crate::watch;
use crate::workshop;

/// Does what the command says in the house around the current folder, and returns whether all is well: every theorem
/// holds that was run.
///
/// # Errors
///
/// [`GraderError`] where the command could not be carried out.
pub fn run(command: &Command, screen: &mut dyn Write) -> Result<bool, GraderError> {
    if *command == Command::Help {
        writeln!(screen, "{HELP}")?;
        return Ok(true);
    }
    let here = env::current_dir().map_err(GraderError::file("find", Path::new(".")))?;
    run_in(&House::around(&here)?, command, screen)
}

/// Does what the command says in this house.
///
/// # Errors
///
/// As [`run`].
pub fn run_in(
    house: &House,
    command: &Command,
    screen: &mut dyn Write,
) -> Result<bool, GraderError> {
    match command {
        Command::Help => Ok(writeln!(screen, "{HELP}").map(|()| true)?),
        Command::List(target) => list(house, target.as_ref(), screen),
        Command::Check(target) => check(house, target, screen),
        Command::Watch(target) => watch(house, target, screen),
        Command::Hint(target) => hint(house, target, screen),
        Command::Reset(target) => reset(house, target, screen),
        Command::Verify(target) => {
            verify::verify(house, &chapters(house, target.as_ref())?, screen)
        }
    }
}

fn chapters(house: &House, target: Option<&Target>) -> Result<Vec<Chapter>, GraderError> {
    match target {
        Some(target) => Ok(vec![Chapter::read(house, &target.chapter)?]),
        None => Chapter::read_all(house),
    }
}

/// The chapter with the reader's package in place.
fn prepared(
    house: &House,
    target: &Target,
    screen: &mut dyn Write,
) -> Result<Chapter, GraderError> {
    let chapter = Chapter::read(house, &target.chapter)?;
    if let Some(name) = &target.exercise {
        chapter.exercise(name)?;
    }
    if workshop::install(house, &chapter)? {
        let folder = house.shown(&workshop::folder(house, &chapter));
        writeln!(
            screen,
            "Your files are in {folder}; nothing will overwrite them.\n"
        )?;
    }
    Ok(chapter)
}

fn list(
    house: &House,
    target: Option<&Target>,
    screen: &mut dyn Write,
) -> Result<bool, GraderError> {
    let progress = Progress::read(&house.exercises())?;
    for chapter in chapters(house, target)? {
        writeln!(
            screen,
            "{}   ({})",
            chapter.name,
            house.shown(&workshop::folder(house, &chapter))
        )?;
        for exercise in &chapter.exercises {
            let state = state(house, &chapter, exercise, &progress)?;
            report::state(screen, &chapter, exercise, &state)?;
        }
    }
    writeln!(
        screen,
        "\n`cargo exercise <chapter>` checks a chapter; `cargo exercise help` says what else there is."
    )?;
    Ok(true)
}

fn state(
    house: &House,
    chapter: &Chapter,
    exercise: &Exercise,
    progress: &Progress,
) -> Result<State, GraderError> {
    let record = progress.record(&chapter.name, &exercise.name);
    let is_untouched = workshop::is_untouched(house, chapter, exercise);
    Ok(record.state(&fingerprint(house, chapter, exercise)?, is_untouched))
}

/// The fingerprint of the reader's file and of everything that grades it.
fn fingerprint(
    house: &House,
    chapter: &Chapter,
    exercise: &Exercise,
) -> Result<String, GraderError> {
    let mut files = vec![workshop::folder(house, chapter).join(&exercise.file)];
    for folder in [house.tests(&chapter.name), house.tests("common")] {
        files.extend(files_in(&folder)?);
    }
    Ok(progress::fingerprint(&files))
}

/// The files of a folder and its subfolders, sorted; none where there is no such folder.
fn files_in(folder: &Path) -> Result<Vec<PathBuf>, GraderError> {
    let mut files = Vec::new();
    if !folder.is_dir() {
        return Ok(files);
    }
    for entry in fs::read_dir(folder).map_err(GraderError::file("list", folder))? {
        let path = entry.map_err(GraderError::file("list", folder))?.path();
        if path.is_dir() {
            files.extend(files_in(&path)?);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            files.push(path);
        }
    }
    files.sort();
    Ok(files)
}

fn check(house: &House, target: &Target, screen: &mut dyn Write) -> Result<bool, GraderError> {
    let chapter = prepared(house, target, screen)?;
    let theorems = theorem::read(house, &chapter)?;
    let Some(binary) = built(house, &chapter, screen)? else {
        return Ok(false);
    };
    let mut progress = Progress::read(&house.exercises())?;
    for exercise in asked_for(&chapter, target)? {
        report::heading(screen, house, &chapter, exercise)?;
        let grading = theorem::of_exercise(&theorems, &chapter.name, &exercise.name)?;
        let verdict = checked(&binary, &grading, screen)?;
        report::verdict(screen, house, &chapter, exercise, &verdict)?;
        let fingerprint = fingerprint(house, &chapter, exercise)?;
        progress.change(&chapter.name, &exercise.name, |record| {
            record.take(&verdict, fingerprint);
        })?;
        if !verdict.is_complete() {
            return Ok(false);
        }
    }
    next(house, &chapter, &progress, screen)?;
    Ok(true)
}

/// The reader's test binary; `None` where the code does not compile, which has then been said.
fn built(
    house: &House,
    chapter: &Chapter,
    screen: &mut dyn Write,
) -> Result<Option<TestBinary>, GraderError> {
    let (package, target) = (workshop::folder(house, chapter), house.exercise_target());
    if !target.is_dir() {
        writeln!(
            screen,
            "The first check builds the tests, which takes a few minutes."
        )?;
        screen.flush()?;
    }
    match compiler::build(&package, &target, &chapter.name)? {
        Build::Ready(path) => TestBinary::open(&path, &package).map(Some),
        Build::Broken(error) => {
            report::compile_error(screen, chapter, &error)?;
            Ok(None)
        }
    }
}

fn checked<'a>(
    binary: &TestBinary,
    grading: &[&'a Theorem],
    screen: &mut dyn Write,
) -> Result<Verdict<'a>, GraderError> {
    check::check(
        grading,
        &|theorem, is_unwanted| binary.run(&theorem.name, None, is_unwanted),
        &mut |theorem| Ok(report::holds(screen, theorem)?),
    )
}

fn asked_for<'a>(chapter: &'a Chapter, target: &Target) -> Result<Vec<&'a Exercise>, GraderError> {
    match &target.exercise {
        Some(name) => Ok(vec![chapter.exercise(name)?]),
        None => Ok(chapter.exercises.iter().collect()),
    }
}

/// Says which exercise of the chapter comes next.
fn next(
    house: &House,
    chapter: &Chapter,
    progress: &Progress,
    screen: &mut dyn Write,
) -> Result<(), GraderError> {
    let name = &chapter.name;
    for exercise in &chapter.exercises {
        if !matches!(
            state(house, chapter, exercise, progress)?,
            State::Passed { .. }
        ) {
            let exercise = &exercise.name;
            writeln!(screen, "Next: cargo exercise {name}/{exercise}")?;
            return Ok(());
        }
    }
    writeln!(screen, "Every exercise of chapter {name} is done.")?;
    Ok(())
}

fn watch(house: &House, target: &Target, screen: &mut dyn Write) -> Result<bool, GraderError> {
    let chapter = prepared(house, target, screen)?;
    let sources = workshop::folder(house, &chapter).join("src");
    watch::watch(
        || watch::stamp(&sources),
        || {
            let start = Instant::now();
            check(house, target, screen)?;
            let seconds = start.elapsed().as_secs_f64();
            writeln!(
                screen,
                "--- {seconds:.1} s; waiting for the next save (Ctrl-C ends)\n"
            )?;
            screen.flush()?;
            Ok(true)
        },
        watch::PAUSE,
    )?;
    Ok(true)
}

/// The exercise that is meant: the one named, or the first that is not done.
fn meant<'a>(
    house: &House,
    chapter: &'a Chapter,
    target: &Target,
    progress: &Progress,
) -> Result<Option<&'a Exercise>, GraderError> {
    if let Some(name) = &target.exercise {
        return chapter.exercise(name).map(Some);
    }
    for exercise in &chapter.exercises {
        if !matches!(
            state(house, chapter, exercise, progress)?,
            State::Passed { .. }
        ) {
            return Ok(Some(exercise));
        }
    }
    Ok(None)
}

fn hint(house: &House, target: &Target, screen: &mut dyn Write) -> Result<bool, GraderError> {
    let chapter = prepared(house, target, screen)?;
    let mut progress = Progress::read(&house.exercises())?;
    let Some(exercise) = meant(house, &chapter, target, &progress)? else {
        writeln!(
            screen,
            "Every exercise of chapter {} is done.",
            chapter.name
        )?;
        return Ok(true);
    };
    let count = exercise.hints.len();
    let given = progress
        .record(&chapter.name, &exercise.name)
        .hints_given
        .min(count);
    let number = (given + 1).min(count);
    report::hint(screen, &chapter, exercise, number)?;
    if given == count {
        let solution = house
            .templates()
            .join(&chapter.name)
            .join(exercise.solution());
        writeln!(
            screen,
            "\nThere are no more hints. A solution is in {}.",
            house.shown(&solution)
        )?;
    }
    progress.change(&chapter.name, &exercise.name, |record| {
        record.hints_given = number;
    })?;
    Ok(true)
}

fn reset(house: &House, target: &Target, screen: &mut dyn Write) -> Result<bool, GraderError> {
    let chapter = prepared(house, target, screen)?;
    let Some(name) = &target.exercise else {
        let known: Vec<&str> = chapter
            .exercises
            .iter()
            .map(|one| one.name.as_str())
            .collect();
        let message = format!(
            "reset needs an exercise of chapter {}: {}",
            chapter.name,
            known.join(", ")
        );
        return Err(GraderError::CommandLine {
            message,
            help: HELP,
        });
    };
    let exercise = chapter.exercise(name)?;
    let file = house.shown(&workshop::folder(house, &chapter).join(&exercise.file));
    match workshop::reset(house, &chapter, exercise)? {
        Some(kept) => writeln!(
            screen,
            "{file} is the stub again; your file is kept as {}.",
            house.shown(&kept)
        )?,
        None => writeln!(screen, "{file} is the stub already.")?,
    }
    Ok(true)
}
