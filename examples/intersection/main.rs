//! The chapter *Intersection*: makes its figures, or the picture of a model of your own.
//!
//! ```text
//! cargo run --release --example intersection                               figures into target/figures/intersection/
//! cargo run --release --example intersection -- model.obj --out picture.png
//! ```
//!
//! Without `--out` the picture goes to `target/figures/intersection/models/`.

mod figures;
mod picture_of_model;

use std::path::Path;
use std::process::ExitCode;

use facette_figure::example::{exit_code, write_figures};

const USAGE: &str = "usage: intersection [MODEL.obj [--out PICTURE.png]]";

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let done = match arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        [] => write_figures("intersection", figures::FIGURES).map_err(Into::into),
        [model] if !model.starts_with('-') => {
            let model = Path::new(model);
            picture_of_model::run(model, &picture_of_model::default_path(model))
        }
        [model, "--out", picture] | ["--out", picture, model] => {
            picture_of_model::run(Path::new(model), Path::new(picture))
        }
        _ => Err(USAGE.into()),
    };
    exit_code(done)
}
