//! What the book is made of besides its pages.

use crate::api::Api;
use crate::figures::ChapterFigure;
use crate::maths::Maths;
use crate::problem::Problems;
use crate::tables::{self, Exercise, ExerciseList, Table, Term, Work};
use crate::theorem::{self, Kind, Theorem};
use anyhow::Result;
use std::collections::HashSet;
use std::path::{Path, PathBuf};

/// Theorems, figures, tables, rustdoc: everything that a directive may ask for.
pub struct Material {
    /// The root of the repository.
    pub root: PathBuf,
    /// Theorems and hard cases of all chapters.
    pub theorems: Vec<Theorem>,
    /// Figures of all chapters.
    pub figures: Vec<ChapterFigure>,
    /// The bibliography.
    pub works: Table<Work>,
    /// The glossary.
    pub terms: Table<Term>,
    /// The exercises of each chapter.
    pub exercises: Vec<ExerciseList>,
    /// The rustdoc pages.
    pub api: Api,
    /// The converter of formulas.
    pub maths: Maths,
    /// The works cited so far.
    pub cited: HashSet<String>,
}

impl Material {
    /// Reads everything below `root`.
    ///
    /// # Errors
    /// Where a file or folder cannot be read.
    pub fn read(
        root: &Path,
        figures: Vec<ChapterFigure>,
        rustdoc: &Path,
        problems: &mut Problems,
    ) -> Result<Self> {
        Ok(Material {
            root: root.to_path_buf(),
            theorems: theorem::scan(root, problems)?,
            figures,
            works: tables::read(root, "book/bibliography.toml", problems)?,
            terms: tables::read(root, "book/glossary.toml", problems)?,
            exercises: tables::exercises(root, problems)?,
            api: Api::new(rustdoc),
            maths: Maths::new()?,
            cited: HashSet::new(),
        })
    }

    /// The theorem or hard case `coons::name`.
    #[must_use]
    pub fn theorem(&self, kind: Kind, path: &str) -> Option<&Theorem> {
        self.theorems
            .iter()
            .find(|t| t.kind == kind && t.path() == path)
    }

    /// The figure `coons::name`.
    #[must_use]
    pub fn figure(&self, path: &str) -> Option<&ChapterFigure> {
        let (chapter, name) = path.split_once("::")?;
        self.figures
            .iter()
            .find(|f| f.chapter == chapter && f.figure.name == name)
    }

    /// An exercise of a chapter, and the list it stands in.
    #[must_use]
    pub fn exercise(&self, chapter: &str, name: &str) -> Option<(&ExerciseList, &Exercise)> {
        let list = self.exercises.iter().find(|l| l.chapter == chapter)?;
        let exercise = list.exercises.iter().find(|e| e.name == name)?;
        Some((list, exercise))
    }
}
