//! `cargo book`: builds the book.

use anyhow::{Context, Result, bail};
use facette_builder::render::Job;
use facette_builder::{api, chapters, figures, measure, render};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Instant;

const HELP: &str = "\
cargo book [--measure] [--open]

Builds the book: target/book/index.html.

  --measure  first measures speed against error on this machine
  --open     opens the book when it is built
  --help     prints this text";

#[derive(Default)]
struct Options {
    measure: bool,
    open: bool,
    help: bool,
}

fn main() -> ExitCode {
    match run() {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(error) => {
            eprintln!("error: {error:#}");
            ExitCode::FAILURE
        }
    }
}

fn options() -> Result<Options> {
    use lexopt::prelude::{Long, Short, Value};
    let mut options = Options::default();
    let mut parser = lexopt::Parser::from_env();
    while let Some(argument) = parser.next()? {
        match argument {
            Long("measure") => options.measure = true,
            Long("open") => options.open = true,
            Long("help") | Short('h') => options.help = true,
            // mdBook calls us so (see book/book.toml) and hands its own reading of the book in, which we do not need.
            Value(word) if word == "render" => {
                std::io::copy(&mut std::io::stdin(), &mut std::io::sink())?;
            }
            other => bail!("{}\n\n{HELP}", other.unexpected()),
        }
    }
    Ok(options)
}

fn run() -> Result<bool> {
    let options = options()?;
    if options.help {
        println!("{HELP}");
        return Ok(true);
    }
    let start = Instant::now();
    let root = root(&std::env::current_dir()?)?;
    std::env::set_current_dir(&root)?;
    if options.measure {
        measure::measure(&root)?;
    }
    measure::set_old_aside(&root)?;
    let (figures, tally) = figures::make(&root, chapters::CHAPTERS)?;
    let (made, kept) = (tally.made, tally.kept);
    println!("{} figures, {made} made, {kept} kept", made + kept);
    let rustdoc = api::document(&root)?;
    let output = root.join("target/book");
    let problems = render::build(Job {
        root: &root,
        figures,
        rustdoc: &rustdoc,
        output: &output,
    })?;
    for problem in &problems {
        eprintln!("{problem}");
    }
    if !problems.is_empty() {
        let count = problems.len();
        eprintln!("error: the book was not written; problems found: {count}");
        return Ok(false);
    }
    let seconds = start.elapsed().as_secs_f64();
    println!("target/book/index.html written in {seconds:.1} s");
    if options.open {
        opener::open(output.join("index.html")).context("cannot open the book")?;
    }
    Ok(true)
}

/// The folder, here or above, that holds book/book.toml.
fn root(here: &Path) -> Result<PathBuf> {
    here.ancestors()
        .find(|folder| folder.join("book/book.toml").is_file())
        .map(Path::to_path_buf)
        .with_context(|| format!("no book/book.toml in {} or above it", here.display()))
}
