//! The chapter *B-spline surfaces*: makes its figures.
//!
//! ```text
//! cargo run --release --example bspline                  figures into target/figures/bspline/
//! ```

mod figures;

use std::path::Path;
use std::process::ExitCode;

fn main() -> ExitCode {
    let done = if std::env::args().len() > 1 {
        Err("usage: bspline (without arguments)".into())
    } else {
        write_figures()
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

fn write_figures() -> Result<(), Box<dyn std::error::Error>> {
    for figure in figures::FIGURES {
        let path = (figure.make)().write(Path::new("target/figures/bspline"))?;
        println!("{}", path.display());
    }
    Ok(())
}
