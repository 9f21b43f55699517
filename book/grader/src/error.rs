//! What can keep the grader from grading.

use std::io;
use std::path::{Path, PathBuf};

use thiserror::Error;

/// Why a command could not be carried out: never the reader's mathematics, always its surroundings.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum GraderError {
    /// The command line says something that is not understood.
    #[error("{message}\n\n{help}")]
    CommandLine {
        /// What was wrong.
        message: String,
        /// What is possible.
        help: &'static str,
    },
    /// The current folder is not inside the repository.
    #[error(
        "no folder `book/exercises` in {start} or above it: run `cargo exercise` in the folder of the book's repository"
    )]
    OutsideTheHouse {
        /// The folder in which the search began.
        start: PathBuf,
    },
    /// A file or folder cannot be read or written.
    #[error("cannot {action} {path}: {source}")]
    File {
        /// The verb: read, write, ...
        action: &'static str,
        /// Which file.
        path: PathBuf,
        /// What the system says.
        source: io::Error,
    },
    /// A TOML file does not say what it should.
    #[error("{path}: {message}")]
    Table {
        /// Which file.
        path: PathBuf,
        /// What is wrong in it and what is expected.
        message: String,
    },
    /// There is no such chapter.
    #[error("no exercises for a chapter `{name}`: the chapters with exercises are {known}")]
    UnknownChapter {
        /// The name that was asked for.
        name: String,
        /// Those that exist.
        known: String,
    },
    /// The chapter has no such exercise.
    #[error("chapter `{chapter}` has no exercise `{name}`: its exercises are {known}")]
    UnknownExercise {
        /// The chapter.
        chapter: String,
        /// The name that was asked for.
        name: String,
        /// Those that exist.
        known: String,
    },
    /// An exercise that no theorem grades.
    #[error(
        "no theorem grades {chapter}/{exercise}: a test in tests/{chapter}/theorems.rs needs the line `/// Exercise: {exercise}.`"
    )]
    Ungraded {
        /// The chapter.
        chapter: String,
        /// The exercise.
        exercise: String,
    },
    /// A program cannot be started.
    #[error("cannot start {program}: {source}")]
    Start {
        /// Which program.
        program: String,
        /// What the system says.
        source: io::Error,
    },
    /// Cargo fails for another reason than the reader's code.
    #[error("cargo could not build {package}:\n{message}")]
    Cargo {
        /// The package that was to be built.
        package: PathBuf,
        /// What cargo says.
        message: String,
    },
    /// The tests do not speak the protocol.
    #[error("the test binary {binary} {message}")]
    Binary {
        /// Which binary.
        binary: PathBuf,
        /// What is wrong with it.
        message: String,
    },
    /// The report cannot be written.
    #[error("cannot write the report: {0}")]
    Output(#[from] io::Error),
}

impl GraderError {
    /// For `map_err`: names the file and what was to be done with it.
    pub fn file(action: &'static str, path: &Path) -> impl FnOnce(io::Error) -> Self {
        let path = path.to_path_buf();
        move |source| Self::File {
            action,
            path,
            source,
        }
    }
}
