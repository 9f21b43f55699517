//! The exercises of a chapter, as `book/exercises/<chapter>/exercise.toml` lists them.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use serde::Deserialize;

use crate::error::GraderError;
use crate::house::House;
use crate::theorem;

/// The exercises of one chapter, in the order of the text.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Chapter {
    /// The chapter's name, that of its folder.
    #[serde(rename = "chapter")]
    pub name: String,
    /// The chapter's page in the written book.
    pub page: String,
    /// The exercises.
    #[serde(rename = "exercise")]
    pub exercises: Vec<Exercise>,
}

/// One exercise: a file with functions to be written.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Exercise {
    /// Its name within the chapter.
    pub name: String,
    /// Its title.
    pub title: String,
    /// The file the reader writes, from the package's folder.
    pub file: PathBuf,
    /// The functions in it.
    pub functions: Vec<String>,
    /// What `--hint` says, one after the other.
    pub hints: Vec<String>,
}

impl Exercise {
    /// The reference solution in the reader's form, from the template's folder.
    #[must_use]
    pub fn solution(&self) -> PathBuf {
        Path::new("solutions").join(self.file.file_name().unwrap_or_default())
    }
}

impl Chapter {
    /// The exercise with this name.
    ///
    /// # Errors
    ///
    /// [`GraderError::UnknownExercise`] lists those that exist.
    pub fn exercise(&self, name: &str) -> Result<&Exercise, GraderError> {
        let found = self.exercises.iter().find(|exercise| exercise.name == name);
        found.ok_or_else(|| GraderError::UnknownExercise {
            chapter: self.name.clone(),
            name: name.to_owned(),
            known: listed(self.exercises.iter().map(|exercise| exercise.name.as_str())),
        })
    }

    /// The chapter with this name.
    ///
    /// # Errors
    ///
    /// [`GraderError::UnknownChapter`] where it has no folder, [`GraderError::Table`] for a table that is not right.
    pub fn read(house: &House, name: &str) -> Result<Self, GraderError> {
        let known = chapter_names(house)?;
        if !known.iter().any(|chapter| chapter == name) {
            let known = listed(known.iter().map(String::as_str));
            return Err(GraderError::UnknownChapter {
                name: name.to_owned(),
                known,
            });
        }
        let folder = house.templates().join(name);
        let path = folder.join("exercise.toml");
        let text = fs::read_to_string(&path).map_err(GraderError::file("read", &path))?;
        let chapter = parse(&text).and_then(|chapter| chapter.checked(name, &folder));
        chapter.map_err(|message| GraderError::Table { path, message })
    }

    /// All chapters with exercises, in the order of the book's summary; those it does not list come last.
    ///
    /// # Errors
    ///
    /// As [`Chapter::read`].
    pub fn read_all(house: &House) -> Result<Vec<Self>, GraderError> {
        let mut names = chapter_names(house)?;
        let summary = theorem::summary(house);
        names.sort_by_key(|name| place(name, &summary));
        names.iter().map(|name| Self::read(house, name)).collect()
    }

    fn checked(self, folder_name: &str, folder: &Path) -> Result<Self, String> {
        if self.name != folder_name {
            let found = &self.name;
            return Err(format!(
                "chapter = \"{found}\", but its folder is `{folder_name}`"
            ));
        }
        let mut names = BTreeSet::new();
        for exercise in &self.exercises {
            if !names.insert(&exercise.name) {
                return Err(format!("two exercises are named `{}`", exercise.name));
            }
            for file in [exercise.file.clone(), exercise.solution()] {
                if !folder.join(&file).is_file() {
                    let (name, file) = (&exercise.name, file.display());
                    return Err(format!(
                        "exercise `{name}` needs the file {file} beside this one"
                    ));
                }
            }
        }
        Ok(self)
    }
}

/// The table of a chapter from its text.
///
/// # Errors
///
/// What is wrong, with the line, as text.
pub fn parse(text: &str) -> Result<Chapter, String> {
    let chapter: Chapter = toml::from_str(text).map_err(|error| error.to_string())?;
    for exercise in &chapter.exercises {
        let name = &exercise.name;
        if exercise.hints.is_empty() {
            return Err(format!(
                "exercise `{name}` has no hint: `hints` needs at least one"
            ));
        }
        if exercise.functions.is_empty() {
            return Err(format!(
                "exercise `{name}` has no function: `functions` needs at least one"
            ));
        }
    }
    Ok(chapter)
}

fn chapter_names(house: &House) -> Result<Vec<String>, GraderError> {
    let folder = house.templates();
    let entries = fs::read_dir(&folder).map_err(GraderError::file("list", &folder))?;
    let mut names = Vec::new();
    for entry in entries {
        let entry = entry.map_err(GraderError::file("list", &folder))?;
        if entry.path().join("exercise.toml").is_file() {
            names.push(entry.file_name().to_string_lossy().into_owned());
        }
    }
    names.sort();
    Ok(names)
}

/// Where the summary first lists a page of the chapter; behind everything where it lists none.
fn place(chapter: &str, summary: &str) -> usize {
    let mut links = theorem::links(summary);
    let position = links.position(|link| theorem::is_page_of(chapter, link));
    position.unwrap_or(usize::MAX)
}

fn listed<'a>(names: impl Iterator<Item = &'a str>) -> String {
    names.collect::<Vec<_>>().join(", ")
}
