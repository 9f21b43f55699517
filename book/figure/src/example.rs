//! What the examples of all chapters do alike: write their figures, and end with what went wrong.

use std::error::Error;
use std::io;
use std::path::Path;
use std::process::ExitCode;

use crate::FigureMaker;

/// Makes all figures of a chapter, writes them to `target/figures/<chapter>/` below the current folder, and prints their paths.
///
/// # Errors
/// As [`Figure::write`](crate::Figure::write).
pub fn write_figures(chapter: &str, figures: &[FigureMaker]) -> io::Result<()> {
    let folder = Path::new("target/figures").join(chapter);
    for figure in figures {
        println!("{}", (figure.make)().write(&folder)?.display());
    }
    Ok(())
}

/// The end of a program: an error is printed, and makes it a failure.
#[must_use]
pub fn exit_code(done: Result<(), Box<dyn Error>>) -> ExitCode {
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}
