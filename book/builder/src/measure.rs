//! Speed against error: the measured tables, and measuring anew.

use crate::sources;
use anyhow::{Context, Result, ensure};
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// The harness, an example.
const HARNESS: &str = "speed_against_error";
/// Where it writes.
const FOLDER: &str = "target/speed_against_error";
/// The columns of its tables.
pub const COLUMNS: [&str; 13] = [
    "quantity",
    "algorithm",
    "scalar",
    "threads",
    "inputs",
    "n",
    "ns_per_eval",
    "spread",
    "ratio",
    "max_ulp",
    "max_abs",
    "rms",
    "wrong",
];

/// A table of measurements.
#[derive(Debug, Default, PartialEq, Eq)]
pub struct Measurements {
    /// Processor, date, compiler, ...: the comment lines `# key: value`.
    pub labels: Vec<(String, String)>,
    /// One row a variant, columns as in [`COLUMNS`], by quantity.
    pub rows: Vec<Vec<String>>,
}

/// Reads a table.
///
/// # Errors
/// The line and what is wrong with it.
pub fn parse(text: &str) -> Result<Measurements, (usize, String)> {
    let mut table = Measurements::default();
    let mut header = false;
    for (index, line) in text.lines().enumerate() {
        let line = line.trim();
        if let Some(comment) = line.strip_prefix('#') {
            if let Some((key, value)) = comment.split_once(':') {
                let pair = (key.trim().to_owned(), value.trim().to_owned());
                table.labels.push(pair);
            }
            continue;
        }
        let cells: Vec<String> = line.split(',').map(|c| c.trim().to_owned()).collect();
        if line.is_empty() {
        } else if !header {
            header = true;
            if cells != COLUMNS {
                let message = format!("expected the header `{}`", COLUMNS.join(","));
                return Err((index + 1, message));
            }
        } else if cells.len() == COLUMNS.len() {
            table.rows.push(cells);
        } else {
            let message = format!("{} cells, expected {}", cells.len(), COLUMNS.len());
            return Err((index + 1, message));
        }
    }
    check_labels(&table)?;
    let order: Vec<String> = table.rows.iter().map(|row| row[0].clone()).collect();
    table
        .rows
        .sort_by_key(|row| order.iter().position(|quantity| *quantity == row[0]));
    Ok(table)
}

fn check_labels(table: &Measurements) -> Result<(), (usize, String)> {
    for label in ["processor", "date"] {
        if !table.labels.iter().any(|(key, _)| key == label) {
            return Err((
                1,
                format!("the table does not say its {label}: expected a line `# {label}: ...`"),
            ));
        }
    }
    Ok(())
}

/// The chapter's table: the one measured here, else the committed one.
#[must_use]
pub fn table_file(root: &Path, chapter: &str) -> Option<PathBuf> {
    [FOLDER, "book/measurements"]
        .iter()
        .map(|folder| Path::new(folder).join(format!("{chapter}.csv")))
        .find(|file| root.join(file).is_file())
}

/// Sets the tables aside that were measured here with other sources, so that neither the pages nor the
/// figures show them.
///
/// # Errors
/// Where a file cannot be read or renamed.
pub fn set_old_aside(root: &Path) -> Result<()> {
    let Ok(entries) = fs::read_dir(root.join(FOLDER)) else {
        return Ok(());
    };
    let measured_by_us = has_key(root);
    for entry in entries {
        let table = entry?.path();
        if table.extension().is_none_or(|e| e != "csv") {
            continue;
        }
        if !measured_by_us && !is_newer(root, &table)? {
            let old = table.with_extension("csv.old");
            eprintln!(
                "measurements of other sources are set aside: {}",
                old.display()
            );
            fs::rename(&table, &old)
                .with_context(|| format!("cannot rename {}", table.display()))?;
        }
    }
    Ok(())
}

/// Whether the last `--measure` belongs to this processor and the present sources.
fn has_key(root: &Path) -> bool {
    let kept = fs::read_to_string(root.join(FOLDER).join("key"));
    matches!((kept, key(root)), (Ok(kept), Ok(key)) if kept == key)
}

/// Whether a table is newer than every source that it measures: then the harness was run by hand.
fn is_newer(root: &Path, table: &Path) -> Result<bool> {
    let written = fs::metadata(table)?.modified()?;
    for file in measured_sources(root)? {
        if fs::metadata(root.join(file))?.modified()? > written {
            return Ok(false);
        }
    }
    Ok(true)
}

fn measured_sources(root: &Path) -> Result<BTreeSet<PathBuf>> {
    let mut files = sources::of_example(root, HARNESS)?;
    files.retain(|file| !file.starts_with("book/figure"));
    Ok(files)
}

/// Processor and sources: what a measurement depends on.
fn key(root: &Path) -> Result<String> {
    sources::hash(root, &measured_sources(root)?, &[&processor()])
}

/// The processor's name, where the system tells it.
fn processor() -> String {
    let info = fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    info.lines()
        .find(|line| line.starts_with("model name"))
        .map_or_else(|| std::env::consts::ARCH.to_owned(), str::to_owned)
}

/// Measures anew, unless this processor has already measured these sources.
///
/// # Errors
/// Where the harness cannot be run or fails.
pub fn measure(root: &Path) -> Result<()> {
    if has_key(root) {
        eprintln!("measurements: kept, neither processor nor sources have changed");
        return Ok(());
    }
    eprintln!("measuring speed against error; leave the machine alone for a while");
    let status = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()))
        .args(["run", "--release", "--quiet", "--example", HARNESS])
        .current_dir(root)
        .status()
        .context("cannot run cargo")?;
    ensure!(status.success(), "the example {HARNESS} failed");
    let folder = root.join(FOLDER);
    fs::create_dir_all(&folder)?;
    fs::write(folder.join("key"), key(root)?).context("cannot keep the key of the measurements")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scratch::Scratch;

    const HEAD: &str = "# processor: P\n# date: 2026-01-02\nquantity,algorithm,scalar,threads,inputs,n,ns_per_eval,spread,ratio,max_ulp,max_abs,rms,wrong\n";

    #[test]
    fn a_table_is_grouped_by_quantity() {
        let row = |q: &str| format!("{q},direct,f64,1,typical,10,5.0,0.1,1.0,2,1e-16,1e-17,\n");
        let text = format!("{HEAD}{}{}{}", row("point"), row("normal"), row("point"));
        let table = parse(&text).expect("well formed");
        let quantities: Vec<&str> = table.rows.iter().map(|r| r[0].as_str()).collect();
        assert_eq!(quantities, ["point", "point", "normal"]);
        assert_eq!(table.labels[0], ("processor".into(), "P".into()));
    }

    #[test]
    fn malformed_tables_name_the_line() {
        assert_eq!(parse(&format!("{HEAD}a,b\n")).expect_err("short").0, 4);
        assert_eq!(parse("# processor: P\na,b\n").expect_err("header").0, 2);
        let message = parse(&HEAD.replace("# date", "# day")).expect_err("date").1;
        assert!(message.contains("does not say its date"));
    }

    #[test]
    fn measurements_of_old_sources_give_way_to_the_committed_ones() {
        let scratch = Scratch::new();
        let root = scratch.path();
        scratch.write("book/measurements/coons.csv", HEAD);
        scratch.write("target/speed_against_error/coons.csv", HEAD);
        scratch.write("examples/speed_against_error.rs", "");
        let shown = || {
            set_old_aside(root).expect("readable");
            table_file(root, "coons").expect("a table")
        };
        let key = key(root).expect("readable");
        scratch.write("target/speed_against_error/key", &key);
        assert!(shown().starts_with("target"), "measured by us");
        scratch.write("examples/speed_against_error.rs", "changed");
        assert!(shown().starts_with("book"), "of old sources");
        assert!(
            root.join("target/speed_against_error/coons.csv.old")
                .is_file()
        );
        scratch.write("target/speed_against_error/coons.csv", HEAD);
        assert!(shown().starts_with("target"), "measured by hand");
    }
}
