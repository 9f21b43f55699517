//! The chapter *Tessellation*: makes its figures, or triangles from a control grid of your own.
//!
//! ```text
//! cargo run --release --example tessellation                                   figures into target/figures/tessellation/
//! cargo run --release --example tessellation -- control_grid.obj --tolerance 0.001 --out surface.obj
//! ```
//!
//! The second reads a B-spline surface from an OBJ file and writes `surface.obj` and `surface.png`.

mod control_grid;
mod figures;
mod surface_from_file;

use std::path::Path;
use std::process::ExitCode;

use facette_figure::example::{exit_code, write_figures};

const USAGE: &str = "usage: tessellation [CONTROL_GRID.obj --tolerance DISTANCE --out SURFACE.obj]";

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let done = match arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        [] => write_figures("tessellation", figures::FIGURES).map_err(Into::into),
        [grid, "--tolerance", tolerance, "--out", surface] => match tolerance.parse() {
            Ok(tolerance) => surface_from_file::run(Path::new(grid), tolerance, Path::new(surface)),
            Err(_) => Err(format!("the tolerance \"{tolerance}\" is not a number; {USAGE}").into()),
        },
        _ => Err(USAGE.into()),
    };
    exit_code(done)
}
