//! What the checks have shown so far, kept in `exercises/progress.toml`.
//!
//! The file is written from test results only. A record carries a fingerprint of the reader's file and of the
//! theorems: where either has changed since, the record no longer speaks for it.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};

use crate::check::Verdict;
use crate::error::GraderError;

/// The result of the last check of an exercise, and how many hints were given.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct Record {
    /// How many theorems held.
    pub passed: usize,
    /// How many there were; 0 before the first check.
    pub theorems: usize,
    /// Whether nothing was written yet.
    pub not_started: bool,
    /// The name of the theorem at which the check stopped.
    pub stopped_at: Option<String>,
    /// Of the file and the theorems that were checked.
    pub fingerprint: String,
    /// How many hints the reader has had.
    pub hints_given: usize,
}

/// How an exercise stands.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum State {
    /// The stub is as it was.
    NotStarted,
    /// Some theorem does not hold.
    Failing {
        /// How many hold before it.
        passed: usize,
        /// How many there are.
        theorems: usize,
        /// Its name.
        stopped_at: String,
    },
    /// All theorems hold.
    Passed {
        /// How many.
        theorems: usize,
    },
    /// The file or the theorems have changed since the last check, or there was none.
    Unchecked,
}

/// The records of all exercises: chapter, then exercise.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Progress {
    path: PathBuf,
    records: BTreeMap<String, BTreeMap<String, Record>>,
}

impl Progress {
    /// Reads `progress.toml` in the folder; without one, there is no progress yet.
    ///
    /// # Errors
    ///
    /// [`GraderError::Table`] for a file that is not one of ours.
    pub fn read(folder: &Path) -> Result<Self, GraderError> {
        let path = folder.join("progress.toml");
        if !path.is_file() {
            return Ok(Self {
                path,
                records: BTreeMap::new(),
            });
        }
        let text = fs::read_to_string(&path).map_err(GraderError::file("read", &path))?;
        match toml::from_str(&text) {
            Ok(records) => Ok(Self { path, records }),
            Err(error) => {
                let message = format!("{error}delete the file: the next checks write it anew");
                Err(GraderError::Table { path, message })
            }
        }
    }

    /// The record of an exercise, empty where there is none.
    #[must_use]
    pub fn record(&self, chapter: &str, exercise: &str) -> Record {
        let record = self
            .records
            .get(chapter)
            .and_then(|records| records.get(exercise));
        record.cloned().unwrap_or_default()
    }

    /// Changes the record of an exercise and writes the file.
    ///
    /// # Errors
    ///
    /// [`GraderError::File`].
    pub fn change(
        &mut self,
        chapter: &str,
        exercise: &str,
        change: impl FnOnce(&mut Record),
    ) -> Result<(), GraderError> {
        let records = self.records.entry(chapter.to_owned()).or_default();
        change(records.entry(exercise.to_owned()).or_default());
        let text = toml::to_string(&self.records).map_err(|error| GraderError::Table {
            path: self.path.clone(),
            message: error.to_string(),
        })?;
        let new = self.path.with_extension("toml.new");
        fs::write(&new, text).map_err(GraderError::file("write", &new))?;
        fs::rename(&new, &self.path).map_err(GraderError::file("write", &self.path))
    }
}

impl Record {
    /// Takes over what a check has shown.
    pub fn take(&mut self, verdict: &Verdict, fingerprint: String) {
        self.passed = verdict.passed;
        self.theorems = verdict.theorems;
        self.not_started = verdict.is_not_started();
        self.stopped_at = verdict
            .stopped_at
            .as_ref()
            .map(|(theorem, _)| theorem.name.clone());
        self.fingerprint = fingerprint;
    }

    /// How the exercise stands, given the fingerprint of now and whether the file still is the stub.
    #[must_use]
    pub fn state(&self, fingerprint: &str, is_untouched: bool) -> State {
        if is_untouched {
            return State::NotStarted;
        }
        if self.theorems == 0 || self.fingerprint != fingerprint {
            return State::Unchecked;
        }
        match &self.stopped_at {
            None => State::Passed {
                theorems: self.theorems,
            },
            Some(_) if self.not_started => State::NotStarted,
            Some(name) => {
                let (passed, theorems) = (self.passed, self.theorems);
                State::Failing {
                    passed,
                    theorems,
                    stopped_at: name.clone(),
                }
            }
        }
    }
}

/// A fingerprint of the files' contents (FNV-1a, 64 bits); a missing file counts as empty.
#[must_use]
pub fn fingerprint(files: &[PathBuf]) -> String {
    const START: u64 = 0xcbf2_9ce4_8422_2325;
    const PRIME: u64 = 0x0000_0100_0000_01b3;
    let mut hash = START;
    for file in files {
        let bytes = fs::read(file).unwrap_or_default();
        let length = bytes.len().to_le_bytes();
        for byte in length.iter().chain(&bytes) {
            hash = (hash ^ u64::from(*byte)).wrapping_mul(PRIME);
        }
    }
    format!("{hash:016x}")
}
