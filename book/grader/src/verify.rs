//! The exercises themselves on trial: every stub fails, every solution passes, every typical mistake is rejected by
//! the theorem that names it, with the right hint.
//!
//! Three packages are made in a scratch folder, each as the reader's is made: one with the stubs, one with the
//! solutions, and one whose functions make the typical mistake that `FACETTE_MISTAKE` names, so that all mistakes
//! are compiled once.

use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::sync::atomic::AtomicBool;

use crate::catalogue::{Chapter, Exercise};
use crate::check;
use crate::compiler::{self, Build};
use crate::error::GraderError;
use crate::house::House;
use crate::protocol::{Failure, Outcome};
use crate::runner::TestBinary;
use crate::theorem::{self, Theorem};
use crate::workshop;

/// A typical mistake, as the test `list_mistakes` lists it: one a line, separated by tabs.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Mistake {
    /// Its name.
    pub name: String,
    /// The exercise it is made in.
    pub exercise: String,
    /// The theorem that must reject it.
    pub rejected_by: String,
    /// What the reader must be told.
    pub hint: String,
}

/// The mistakes of a list.
#[must_use]
pub fn parse_mistakes(list: &str) -> Vec<Mistake> {
    list.lines()
        .filter_map(|line| {
            let mut fields = line.split('\t').map(str::to_owned);
            Some(Mistake {
                name: fields.next()?,
                exercise: fields.next()?,
                rejected_by: fields.next()?,
                hint: fields.next()?,
            })
        })
        .collect()
}

/// Whether a mistake is rejected as it must be: the first theorem that fails is the one that names it, and its hint
/// is the mistake's. `Err` says what happened instead.
///
/// # Errors
///
/// What happened instead, in words.
pub fn judge_mistake(
    mistake: &Mistake,
    stopped_at: Option<(&str, &Outcome)>,
) -> Result<(), String> {
    let Some((theorem, outcome)) = stopped_at else {
        return Err("no theorem rejects it".to_owned());
    };
    let Outcome::Failed(Failure {
        likely_mistake,
        mistake: name,
        ..
    }) = outcome
    else {
        return Err(format!(
            "{theorem} ends without a counterexample: {outcome:?}"
        ));
    };
    if theorem != mistake.rejected_by {
        return Err(format!(
            "{theorem} rejects it before {}",
            mistake.rejected_by
        ));
    }
    if name.as_deref() != Some(&mistake.name) {
        let found = name.as_deref().unwrap_or("no mistake");
        return Err(format!("{theorem} rejects it, but takes it for {found}"));
    }
    if likely_mistake.as_deref() != Some(mistake.hint.trim()) {
        return Err(format!(
            "{theorem} rejects it with the hint {likely_mistake:?}"
        ));
    }
    Ok(())
}

/// Puts all exercises of the chapters on trial; returns whether all is as it must be.
///
/// # Errors
///
/// [`GraderError`] where a package cannot be built at all.
pub fn verify(
    house: &House,
    chapters: &[Chapter],
    screen: &mut dyn Write,
) -> Result<bool, GraderError> {
    let mut tally = Tally {
        screen,
        passed: 0,
        failed: 0,
    };
    for chapter in chapters {
        let theorems = theorem::read(house, chapter)?;
        let trial = Trial {
            house,
            chapter,
            theorems: &theorems,
        };
        trial.names(&mut tally)?;
        trial.stubs(&mut tally)?;
        trial.solutions(&mut tally)?;
        trial.mistakes(&mut tally)?;
    }
    writeln!(
        tally.screen,
        "{} passed, {} failed",
        tally.passed, tally.failed
    )?;
    Ok(tally.failed == 0)
}

struct Tally<'a> {
    screen: &'a mut dyn Write,
    passed: usize,
    failed: usize,
}

impl Tally<'_> {
    fn count(&mut self, what: &str, result: Result<(), String>) -> Result<(), GraderError> {
        match result {
            Ok(()) => {
                self.passed += 1;
                writeln!(self.screen, "passed  {what}")?;
            }
            Err(why) => {
                self.failed += 1;
                writeln!(self.screen, "FAILED  {what}: {why}")?;
            }
        }
        Ok(self.screen.flush()?)
    }
}

struct Trial<'a> {
    house: &'a House,
    chapter: &'a Chapter,
    theorems: &'a [Theorem],
}

impl Trial<'_> {
    /// Every exercise that a theorem names exists.
    fn names(&self, tally: &mut Tally) -> Result<(), GraderError> {
        let chapter = &self.chapter.name;
        for theorem in self.theorems {
            for name in &theorem.exercises {
                if self.chapter.exercise(name).is_err() {
                    let why = format!("chapter {chapter} has no exercise `{name}`");
                    tally.count(&format!("{chapter}::{}", theorem.name), Err(why))?;
                }
            }
        }
        Ok(())
    }

    fn grading(&self, exercise: &str) -> Result<Vec<&Theorem>, GraderError> {
        theorem::of_exercise(self.theorems, &self.chapter.name, exercise)
    }

    /// No theorem of an exercise holds for its stub.
    fn stubs(&self, tally: &mut Tally) -> Result<(), GraderError> {
        let binary = self.built(&self.package("stubs")?)?;
        for exercise in &self.chapter.exercises {
            let mut result = Ok(());
            for theorem in self.grading(&exercise.name)? {
                let outcome = binary.run(&theorem.name, None, &AtomicBool::new(false))?;
                if !matches!(outcome, Outcome::NotWritten(_)) {
                    let name = &theorem.name;
                    result = Err(format!("{name} does not meet the stub: {outcome:?}"));
                }
            }
            tally.count(
                &format!("{}: the stub fails every theorem", self.name(exercise)),
                result,
            )?;
        }
        Ok(())
    }

    /// Every theorem of an exercise holds for its solution.
    fn solutions(&self, tally: &mut Tally) -> Result<(), GraderError> {
        let package = self.package("solutions")?;
        let templates = self.house.templates().join(&self.chapter.name);
        for exercise in &self.chapter.exercises {
            workshop::copy(
                &templates.join(exercise.solution()),
                &package.join(&exercise.file),
            )?;
        }
        let binary = self.built(&package)?;
        for exercise in &self.chapter.exercises {
            let grading = self.grading(&exercise.name)?;
            let (name, count) = (self.name(exercise), grading.len());
            let what = format!("{name}: the solution passes all its theorems ({count})");
            let result = match stop(&binary, &grading, None)? {
                None => Ok(()),
                Some((theorem, outcome)) => Err(format!("{}: {outcome:?}", theorem.name)),
            };
            tally.count(&what, result)?;
        }
        Ok(())
    }

    /// Every typical mistake is rejected.
    fn mistakes(&self, tally: &mut Tally) -> Result<(), GraderError> {
        let package = self.package("mistakes")?;
        let templates = self.house.templates().join(&self.chapter.name);
        let (root, lib) = (root_of(self.house), package.join("src/lib.rs"));
        workshop::refresh(&templates.join("verify.rs"), &lib, &root)?;
        let binary = self.built(&package)?;
        let list = binary.list_of_mistakes()?;
        let mistakes = parse_mistakes(&list);
        if mistakes.is_empty() {
            let why = Err("tests/<chapter>/mistakes.rs lists none".to_owned());
            tally.count(&format!("{}: typical mistakes", self.chapter.name), why)?;
        }
        for mistake in mistakes {
            let what = format!(
                "{}/{}, mistake {}: rejected by {} with its hint",
                self.chapter.name, mistake.exercise, mistake.name, mistake.rejected_by
            );
            let grading = self.grading(&mistake.exercise)?;
            let stopped_at = stop(&binary, &grading, Some(&mistake.name))?;
            let stopped_at = stopped_at.as_ref();
            let stopped_at = stopped_at.map(|(theorem, outcome)| (theorem.name.as_str(), outcome));
            tally.count(&what, judge_mistake(&mistake, stopped_at))?;
        }
        Ok(())
    }

    /// A fresh package with the chapter's stubs.
    fn package(&self, kind: &str) -> Result<PathBuf, GraderError> {
        let package = self
            .house
            .verify_folder()
            .join(&self.chapter.name)
            .join(kind);
        let sources = package.join("src");
        if sources.is_dir() {
            fs::remove_dir_all(&sources).map_err(GraderError::file("remove", &sources))?;
        }
        workshop::place(self.house, self.chapter, &package, &root_of(self.house))?;
        Ok(package)
    }

    fn built(&self, package: &Path) -> Result<TestBinary, GraderError> {
        match compiler::build(package, &self.target(), &self.chapter.name)? {
            Build::Ready(path) => TestBinary::open(&path, package),
            Build::Broken(error) => {
                let package = package.to_path_buf();
                Err(GraderError::Cargo {
                    package,
                    message: error.message,
                })
            }
        }
    }

    fn target(&self) -> PathBuf {
        self.house.exercise_target()
    }

    fn name(&self, exercise: &Exercise) -> String {
        format!("{}/{}", self.chapter.name, exercise.name)
    }
}

/// The first theorem that does not hold, and why.
fn stop<'a>(
    binary: &TestBinary,
    grading: &[&'a Theorem],
    mistake: Option<&str>,
) -> Result<Option<(&'a Theorem, Outcome)>, GraderError> {
    let run = |theorem: &Theorem, is_unwanted: &AtomicBool| {
        binary.run(&theorem.name, mistake, is_unwanted)
    };
    Ok(check::check(grading, &run, &mut |_| Ok(()))?.stopped_at)
}

fn root_of(house: &House) -> String {
    house.root().display().to_string().replace('\\', "/")
}
