//! The chapter *B-spline surfaces*: makes its figures.
//!
//! ```text
//! cargo run --release --example bspline                  figures into target/figures/bspline/
//! ```

mod figures;

use std::process::ExitCode;

use facette_figure::example::{exit_code, write_figures};

fn main() -> ExitCode {
    let done = if std::env::args().len() > 1 {
        Err("usage: bspline (without arguments)".into())
    } else {
        write_figures("bspline", figures::FIGURES).map_err(Into::into)
    };
    exit_code(done)
}
