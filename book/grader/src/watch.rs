//! Checking again on every save.

use std::fs;
use std::path::{Path, PathBuf};
use std::thread;
use std::time::{Duration, SystemTime};

use crate::error::GraderError;

/// How often the files are looked at: below what a reader notices, and no load on the computer.
pub const PAUSE: Duration = Duration::from_millis(300);

/// When each file was last written, and its length.
pub type Stamp = Vec<(PathBuf, SystemTime, u64)>;

/// The stamp of the files in a folder; what vanishes meanwhile is left out.
#[must_use]
pub fn stamp(folder: &Path) -> Stamp {
    let entries = fs::read_dir(folder).into_iter().flatten().flatten();
    let mut stamp: Stamp = entries
        .filter_map(|entry| {
            let data = entry.metadata().ok()?;
            Some((entry.path(), data.modified().ok()?, data.len()))
        })
        .collect();
    stamp.sort();
    stamp
}

/// Runs `check` now and after every change that `look` sees, until `check` returns false. A change during a check
/// is seen after it.
///
/// # Errors
///
/// Those of `check`.
pub fn watch<S: PartialEq>(
    mut look: impl FnMut() -> S,
    mut check: impl FnMut() -> Result<bool, GraderError>,
    pause: Duration,
) -> Result<(), GraderError> {
    loop {
        let before = look();
        if !check()? {
            return Ok(());
        }
        while look() == before {
            thread::sleep(pause);
        }
    }
}
