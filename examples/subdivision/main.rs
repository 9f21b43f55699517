//! The chapter *Subdivision*: makes its figures.
//!
//! ```text
//! cargo run --release --example subdivision                  figures into target/figures/subdivision/
//! ```

mod figures;

use std::process::ExitCode;

use facette_figure::example::{exit_code, write_figures};

fn main() -> ExitCode {
    let done = if std::env::args().len() > 1 {
        Err("usage: subdivision (without arguments)".into())
    } else {
        write_figures("subdivision", figures::FIGURES).map_err(Into::into)
    };
    exit_code(done)
}
