//! The reader's package of a chapter: copied from the templates on first use, never overwritten.

use std::fs;
use std::path::{Path, PathBuf};
use std::time::SystemTime;

use crate::catalogue::{Chapter, Exercise};
use crate::error::GraderError;
use crate::house::House;

/// What stands in a template for the path of the repository's root.
const ROOT: &str = "@ROOT@";

/// The files that belong to the book; all others under `src` belong to the reader.
const KEPT_UP_TO_DATE: [&str; 2] = ["Cargo.toml", "src/lib.rs"];

/// The folder of the reader's package.
#[must_use]
pub fn folder(house: &House, chapter: &Chapter) -> PathBuf {
    house.exercises().join(&chapter.name)
}

/// Puts the reader's package in place: stubs that are missing are copied, the manifest and the root module are
/// refreshed, the reader's files are left alone. Returns whether the package is new.
///
/// # Errors
///
/// [`GraderError::File`].
pub fn install(house: &House, chapter: &Chapter) -> Result<bool, GraderError> {
    let package = folder(house, chapter);
    let is_new = !package.join("Cargo.toml").is_file();
    place(house, chapter, &package, "../..")?;
    Ok(is_new)
}

/// Puts a package with the chapter's stubs into the folder; `root` is the way from there to the repository.
///
/// # Errors
///
/// [`GraderError::File`].
pub fn place(
    house: &House,
    chapter: &Chapter,
    package: &Path,
    root: &str,
) -> Result<(), GraderError> {
    let templates = house.templates().join(&chapter.name);
    for name in KEPT_UP_TO_DATE {
        refresh(&templates.join(name), &package.join(name), root)?;
    }
    for exercise in &chapter.exercises {
        let own = package.join(&exercise.file);
        if !own.exists() {
            copy(&templates.join(&exercise.file), &own)?;
        }
    }
    lock(house.root(), package)
}

/// Copies a template with the root's path put in; leaves a file that is already so alone, and its time with it.
///
/// # Errors
///
/// [`GraderError::File`].
pub fn refresh(template: &Path, own: &Path, root: &str) -> Result<(), GraderError> {
    let text = fs::read_to_string(template).map_err(GraderError::file("read", template))?;
    let text = text.replace(ROOT, root);
    if fs::read_to_string(own).is_ok_and(|present| present == text) {
        return Ok(());
    }
    write(own, &text)
}

/// Gives the package the versions of the repository, unless it has them: cargo completes the copy.
fn lock(root: &Path, package: &Path) -> Result<(), GraderError> {
    let (versions, own) = (root.join("Cargo.lock"), package.join("Cargo.lock"));
    let is_stale = modified(&own).is_none_or(|time| modified(&versions) > Some(time));
    if versions.is_file() && is_stale {
        let text = fs::read(&versions).map_err(GraderError::file("read", &versions))?;
        fs::write(&own, text).map_err(GraderError::file("write", &own))?;
    }
    Ok(())
}

fn modified(path: &Path) -> Option<SystemTime> {
    path.metadata().and_then(|data| data.modified()).ok()
}

/// Restores the stub of an exercise; what was there is kept beside it. Returns where.
///
/// # Errors
///
/// [`GraderError::File`].
pub fn reset(
    house: &House,
    chapter: &Chapter,
    exercise: &Exercise,
) -> Result<Option<PathBuf>, GraderError> {
    let own = folder(house, chapter).join(&exercise.file);
    let kept = if own.exists() && !is_untouched(house, chapter, exercise) {
        let mut name = own.clone().into_os_string();
        name.push(".previous");
        let kept = PathBuf::from(name);
        fs::rename(&own, &kept).map_err(GraderError::file("rename", &own))?;
        Some(kept)
    } else {
        None
    };
    copy(
        &house.templates().join(&chapter.name).join(&exercise.file),
        &own,
    )?;
    Ok(kept)
}

/// Whether the reader's file still is the stub.
#[must_use]
pub fn is_untouched(house: &House, chapter: &Chapter, exercise: &Exercise) -> bool {
    let stub = fs::read(house.templates().join(&chapter.name).join(&exercise.file));
    let own = fs::read(folder(house, chapter).join(&exercise.file));
    match (stub, own) {
        (Ok(stub), Ok(own)) => stub == own,
        (_, Err(_)) => true,
        (Err(_), Ok(_)) => false,
    }
}

/// Copies a file by its content, so that the copy is newer than what was built from the file it replaces.
///
/// # Errors
///
/// [`GraderError::File`].
pub fn copy(from: &Path, to: &Path) -> Result<(), GraderError> {
    let text = fs::read_to_string(from).map_err(GraderError::file("read", from))?;
    write(to, &text)
}

/// Writes a file and the folders it needs.
///
/// # Errors
///
/// [`GraderError::File`].
pub fn write(path: &Path, text: &str) -> Result<(), GraderError> {
    if let Some(folder) = path.parent() {
        fs::create_dir_all(folder).map_err(GraderError::file("create", folder))?;
    }
    fs::write(path, text).map_err(GraderError::file("write", path))
}
