//! The chapter *Coons patches*: makes its figures, or a patch from four curves of your own.
//!
//! ```text
//! cargo run --release --example coons                                      figures into target/figures/coons/
//! cargo run --release --example coons -- boundary.obj --out patch.obj      patch.obj and patch.png
//! ```

mod figures;
mod patch_from_file;

use std::path::Path;
use std::process::ExitCode;

use facette_figure::example::{exit_code, write_figures};

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let done = match arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        [] => write_figures("coons", figures::FIGURES).map_err(Into::into),
        [boundary, "--out", patch] | ["--out", patch, boundary] => {
            patch_from_file::run(Path::new(boundary), Path::new(patch))
        }
        _ => Err("usage: coons [BOUNDARY.obj --out PATCH.obj]".into()),
    };
    exit_code(done)
}
