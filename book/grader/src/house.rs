//! Where everything about a chapter is.

use std::env;
use std::path::{Path, PathBuf};

use crate::error::GraderError;

/// The folders of the repository, from its root.
#[derive(Clone, Debug)]
pub struct House {
    root: PathBuf,
    target: PathBuf,
}

impl House {
    /// The house around the folder `start`; build results go to `CARGO_TARGET_DIR` where that is set.
    ///
    /// # Errors
    ///
    /// [`GraderError::OutsideTheHouse`] where neither `start` nor a folder above it contains `book/exercises`.
    pub fn around(start: &Path) -> Result<Self, GraderError> {
        let root = start
            .ancestors()
            .find(|folder| folder.join("book/exercises").is_dir())
            .ok_or_else(|| GraderError::OutsideTheHouse {
                start: start.to_path_buf(),
            })?;
        let target = match env::var_os("CARGO_TARGET_DIR") {
            Some(folder) => start.join(folder),
            None => root.join("target"),
        };
        Ok(Self {
            root: root.to_path_buf(),
            target,
        })
    }

    /// The root folder.
    #[must_use]
    pub fn root(&self) -> &Path {
        &self.root
    }

    /// The folder with one folder of templates for each chapter.
    #[must_use]
    pub fn templates(&self) -> PathBuf {
        self.root.join("book/exercises")
    }

    /// The folder of the reader's packages and progress.
    #[must_use]
    pub fn exercises(&self) -> PathBuf {
        self.root.join("exercises")
    }

    /// The folder with the chapter's theorems.
    #[must_use]
    pub fn tests(&self, chapter: &str) -> PathBuf {
        self.root.join("tests").join(chapter)
    }

    /// The folder with the book's text.
    #[must_use]
    pub fn book_text(&self) -> PathBuf {
        self.root.join("book/src")
    }

    /// The folder of the written book.
    #[must_use]
    pub fn book(&self) -> PathBuf {
        self.root.join("target/book")
    }

    /// The target folder of the reader's packages.
    #[must_use]
    pub fn exercise_target(&self) -> PathBuf {
        self.target.join("exercise")
    }

    /// The scratch folder of `cargo exercise verify`.
    #[must_use]
    pub fn verify_folder(&self) -> PathBuf {
        self.target.join("exercise-verify")
    }

    /// The path as a reader in the root folder would type it.
    #[must_use]
    pub fn shown(&self, path: &Path) -> String {
        let inside = path.strip_prefix(&self.root).unwrap_or(path);
        inside.display().to_string().replace('\\', "/")
    }
}
