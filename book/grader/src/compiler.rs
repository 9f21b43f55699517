//! Building the reader's package, and the first error where it does not compile.

use std::env;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use serde::Deserialize;

use crate::error::GraderError;

/// What has come of a build.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Build {
    /// The test binary.
    Ready(PathBuf),
    /// The code does not compile.
    Broken(CompileError),
}

/// The first error of the compiler.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct CompileError {
    /// The file, as the compiler names it: from the package's folder.
    pub file: Option<PathBuf>,
    /// The compiler's message, shortened.
    pub message: String,
}

/// So many lines of a compiler's message are shown.
const MESSAGE_LINES: usize = 24;

#[derive(Deserialize)]
struct Line {
    reason: String,
    message: Option<Diagnostic>,
    target: Option<BuildTarget>,
    executable: Option<PathBuf>,
}

#[derive(Deserialize)]
struct BuildTarget {
    name: String,
    kind: Vec<String>,
}

#[derive(Deserialize)]
struct Diagnostic {
    level: String,
    rendered: Option<String>,
    spans: Vec<Span>,
}

#[derive(Deserialize)]
struct Span {
    file_name: PathBuf,
    is_primary: bool,
}

/// Builds the test named `test` of the package.
///
/// # Errors
///
/// [`GraderError::Start`] without cargo, [`GraderError::Cargo`] where cargo fails for another reason than the code.
pub fn build(package: &Path, target: &Path, test: &str) -> Result<Build, GraderError> {
    let is_first = !target.join("debug").is_dir();
    let mut command = Command::new(cargo());
    command.args(["test", "--no-run", "--message-format=json", "--test", test]);
    command.arg("--target-dir").arg(target).current_dir(package);
    command.stdin(Stdio::null()).stdout(Stdio::piped());
    if is_first {
        command.stderr(Stdio::inherit());
    } else {
        command.arg("--quiet").stderr(Stdio::piped());
    }
    let child = command
        .spawn()
        .map_err(|source| start_error(&cargo(), source))?;
    let output = child
        .wait_with_output()
        .map_err(GraderError::file("build", package))?;
    let text = String::from_utf8_lossy(&output.stdout);
    let built = if output.status.success() {
        test_binary(&text, test).map(Build::Ready)
    } else {
        first_error(&text).map(Build::Broken)
    };
    built.ok_or_else(|| GraderError::Cargo {
        package: package.to_path_buf(),
        message: String::from_utf8_lossy(&output.stderr).trim().to_owned(),
    })
}

fn cargo() -> String {
    env::var("CARGO").unwrap_or_else(|_| "cargo".to_owned())
}

fn start_error(program: &str, source: std::io::Error) -> GraderError {
    GraderError::Start {
        program: program.to_owned(),
        source,
    }
}

fn lines(output: &str) -> impl Iterator<Item = Line> {
    output
        .lines()
        .filter_map(|line| serde_json::from_str(line).ok())
}

/// The binary of the test, from what cargo prints as JSON.
#[must_use]
pub fn test_binary(output: &str, test: &str) -> Option<PathBuf> {
    let is_it =
        |target: &BuildTarget| target.name == test && target.kind.iter().any(|kind| kind == "test");
    lines(output)
        .filter(|line| line.reason == "compiler-artifact")
        .filter(|line| line.target.as_ref().is_some_and(is_it))
        .find_map(|line| line.executable)
}

/// The first error in what cargo prints as JSON.
#[must_use]
pub fn first_error(output: &str) -> Option<CompileError> {
    let diagnostics = lines(output).filter(|line| line.reason == "compiler-message");
    let error = diagnostics
        .filter_map(|line| line.message)
        .find(|message| message.level.starts_with("error"))?;
    let primary = error.spans.iter().find(|span| span.is_primary);
    Some(CompileError {
        file: primary.map(|span| span.file_name.clone()),
        message: shortened(error.rendered.unwrap_or_default().trim_end()),
    })
}

fn shortened(message: &str) -> String {
    let count = message.lines().count();
    let mut kept: Vec<&str> = message.lines().take(MESSAGE_LINES).collect();
    if count > MESSAGE_LINES {
        kept.push("...");
    }
    kept.join("\n")
}
