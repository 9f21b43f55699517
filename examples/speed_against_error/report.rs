//! The report: on the screen as a table, on disk as comma-separated values with the circumstances of the measurement.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::{SystemTime, UNIX_EPOCH};
use std::{fs, io};

use crate::harness::Row;

/// Prints the rows as a table.
pub fn print(chapter: &str, rows: &[Row]) {
    let mut table = vec![Row::COLUMNS.map(str::to_owned)];
    table.extend(rows.iter().map(Row::cells));
    let width = |column: usize| table.iter().map(|row| row[column].len()).max();
    let widths: [usize; 13] = std::array::from_fn(|column| width(column).unwrap_or(0));
    println!("{chapter}: ns_per_eval is a median, spread its interquartile range over it,");
    println!("ratio the time over that of the quantity's first row; errors against exact values");
    for row in &table {
        let cells = row.iter().zip(widths);
        let line: Vec<String> = cells
            .map(|(cell, width)| format!("{cell:<width$}"))
            .collect();
        println!("{}", line.join("  ").trim_end());
    }
}

/// The rows that another program has measured, for other libraries: as text, with the comment lines that say how.
pub struct Peers {
    comments: String,
    rows: String,
}

/// Reads the rows of other libraries: comment lines `# key: value`, the names of the columns, the rows.
pub fn read_peers(file: &Path) -> Result<Peers, String> {
    let text = fs::read_to_string(file);
    let text = text.map_err(|error| format!("cannot read {}: {error}", file.display()))?;
    let (mut comments, mut rows) = (String::new(), String::new());
    let mut lines = text
        .lines()
        .enumerate()
        .filter(|(_, line)| !line.is_empty());
    let mut has_header = false;
    for (index, line) in &mut lines {
        let complaint = |expected| format!("{}, line {}: {expected}", file.display(), index + 1);
        if let Some(comment) = line.strip_prefix("# ") {
            let _ = writeln!(comments, "# peers, {comment}");
        } else if has_header {
            if line.split(',').count() != Row::COLUMNS.len() {
                return Err(complaint(format!("expected {} cells", Row::COLUMNS.len())));
            }
            let _ = writeln!(rows, "{line}");
        } else if line == Row::COLUMNS.join(",") {
            has_header = true;
        } else {
            return Err(complaint(format!(
                "expected the header {}",
                Row::COLUMNS.join(",")
            )));
        }
    }
    Ok(Peers { comments, rows })
}

/// Writes the rows to `<folder>/<chapter>.csv`, those of the peers after them, all or nothing.
pub fn write(
    folder: &Path,
    chapter: &str,
    rows: &[Row],
    peers: Option<&Peers>,
) -> io::Result<PathBuf> {
    let mut text = circumstances();
    text.push_str(peers.map_or("", |peers| &peers.comments));
    text.push_str(&Row::COLUMNS.join(","));
    text.push('\n');
    for row in rows {
        text.push_str(&row.cells().join(","));
        text.push('\n');
    }
    text.push_str(peers.map_or("", |peers| &peers.rows));
    fs::create_dir_all(folder)?;
    let file = folder.join(format!("{chapter}.csv"));
    let unfinished = folder.join(format!("{chapter}.csv.unfinished"));
    fs::write(&unfinished, text)?;
    fs::rename(&unfinished, &file)?;
    Ok(file)
}

/// The comment lines that say where and when the times were taken.
fn circumstances() -> String {
    let lines = [
        ("processor", processor()),
        ("date", today()),
        ("compiler", compiler()),
        ("target features", target_features()),
    ];
    let lines = lines.map(|(key, value)| format!("# {key}: {value}\n"));
    lines.concat()
}

/// The processor's name, where the system tells it.
fn processor() -> String {
    let info = fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let line = info.lines().find(|line| line.starts_with("model name"));
    let name = line.and_then(|line| line.split_once(':'));
    name.map_or("unknown", |(_, name)| name.trim()).to_owned()
}

/// The version of the compiler in the search path, which is the one that cargo calls.
fn compiler() -> String {
    let output = Command::new("rustc").arg("--version").output();
    let text = output.map(|output| String::from_utf8_lossy(&output.stdout).into_owned());
    let text = text.unwrap_or_default();
    let version = text.split_whitespace().take(2).collect::<Vec<_>>();
    if version.is_empty() {
        "unknown".to_owned()
    } else {
        version.join(" ")
    }
}

/// The architecture, and the vector instructions that the compiler was allowed to use.
fn target_features() -> String {
    let known = [
        ("sse2", cfg!(target_feature = "sse2")),
        ("sse4.2", cfg!(target_feature = "sse4.2")),
        ("avx", cfg!(target_feature = "avx")),
        ("avx2", cfg!(target_feature = "avx2")),
        ("fma", cfg!(target_feature = "fma")),
        ("avx512f", cfg!(target_feature = "avx512f")),
        ("neon", cfg!(target_feature = "neon")),
    ];
    let on = known
        .into_iter()
        .filter_map(|(name, is_on)| is_on.then_some(name));
    let on: Vec<&str> = on.collect();
    format!("{} with {}", std::env::consts::ARCH, on.join(" and "))
}

/// The date in universal time, as year-month-day.
fn today() -> String {
    let elapsed = SystemTime::now().duration_since(UNIX_EPOCH);
    let mut days = elapsed.map_or(0, |elapsed| elapsed.as_secs() / 86_400);
    let mut year = 1970;
    while days >= days_of_year(year) {
        days -= days_of_year(year);
        year += 1;
    }
    let february = days_of_year(year) - 337;
    let months = [31, february, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31];
    let mut month = 0;
    while days >= months[month] {
        days -= months[month];
        month += 1;
    }
    format!("{year}-{:02}-{:02}", month + 1, days + 1)
}

fn days_of_year(year: u64) -> u64 {
    let is_leap = year.is_multiple_of(4) && (!year.is_multiple_of(100) || year.is_multiple_of(400));
    if is_leap { 366 } else { 365 }
}
