//! The chapter *Intersection*: makes its figures.
//!
//! ```text
//! cargo run --release --example intersection                               figures into target/figures/intersection/
//! ```

mod figures;

use std::process::ExitCode;

use facette_figure::example::{exit_code, write_figures};

fn main() -> ExitCode {
    let done = write_figures("intersection", figures::FIGURES).map_err(Into::into);
    exit_code(done)
}
