//! The chapter *Cameras*: makes its figures.
//!
//! ```text
//! cargo run --release --example camera                                     figures into target/figures/camera/
//! ```

mod figures;

use std::process::ExitCode;

use facette_figure::example::{exit_code, write_figures};

fn main() -> ExitCode {
    let done = write_figures("camera", figures::FIGURES).map_err(Into::into);
    exit_code(done)
}
