//! Speed against error: how long each way to compute a quantity takes, and how far from the exact value it ends.
//!
//! `cargo run --release --example speed_against_error -- coons` measures one chapter, without a name all of them; the report
//! goes to `target/speed_against_error/<chapter>.csv`. Leave the machine alone meanwhile. `--quick` tries in a second whether
//! everything runs; its numbers mean nothing, and go to the folder `quick` below. `--peers <file>` adds the rows of a table of the same
//! form, which another program has measured: other libraries are never a dependency of this one. `--repeat <times> <quantity>/<algorithm>/<scalar>/<inputs>` does nothing but
//! evaluate one variant, for a program that counts instructions.

use std::env;
use std::path::Path;
use std::process::ExitCode;

use harness::{Comparison, Effort};
use report::Peers;

mod answers;
mod bspline;
mod camera;
#[path = "../../tests/common/mod.rs"]
#[allow(
    unused_imports,
    reason = "some serve the tests of the tools themselves"
)]
mod common;
mod coons;
#[path = "../../tests/coons/error_theorems/float_inputs.rs"]
#[allow(dead_code, reason = "the generators serve the tests")]
mod float_inputs;
mod harness;
mod intersection;
mod report;
mod subdivision;

/// What is done with a comparison.
type Visitor<'a> = dyn FnMut(Comparison<'_>) + 'a;

/// A chapter with variants to compare.
struct Chapter {
    name: &'static str,
    /// Hands each of its comparisons to the visitor, one after the other.
    visit: fn(Effort, &mut Visitor<'_>),
}

const CHAPTERS: &[Chapter] = &[
    Chapter {
        name: "coons",
        visit: coons::visit,
    },
    Chapter {
        name: "bspline",
        visit: bspline::visit,
    },
    Chapter {
        name: "subdivision",
        visit: subdivision::visit,
    },
    Chapter {
        name: "camera",
        visit: camera::visit,
    },
    Chapter {
        name: "intersection",
        visit: intersection::visit,
    },
];

const FULL: Effort = Effort {
    rounds: 501,
    turn: 2e5,
    points: 256,
    budget: 2e10,
};

const QUICK: Effort = Effort {
    rounds: 3,
    turn: 1e4,
    points: 4,
    budget: 2e7,
};

fn main() -> ExitCode {
    match run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("speed_against_error: {message}");
            ExitCode::FAILURE
        }
    }
}

fn run() -> Result<(), String> {
    let (mut effort, mut names, mut repeat) = (FULL, Vec::new(), None);
    let mut peers = None;
    let mut folder = Path::new("target/speed_against_error");
    let mut arguments = env::args().skip(1);
    while let Some(argument) = arguments.next() {
        match argument.as_str() {
            "--quick" => {
                effort = QUICK;
                folder = Path::new("target/speed_against_error/quick");
            }
            "--peers" => {
                let file = arguments.next().ok_or("--peers needs the name of a file")?;
                peers = Some(report::read_peers(Path::new(&file))?);
            }
            "--repeat" => {
                let times = arguments.next().and_then(|times| times.parse().ok());
                repeat = times.zip(arguments.next());
                if repeat.is_none() {
                    return Err("--repeat needs a number and the name of a variant".to_owned());
                }
            }
            _ => names.push(argument),
        }
    }
    let chapters = chosen(&names)?;
    if peers.is_some() && chapters.len() != 1 {
        return Err("--peers needs the one chapter that the rows belong to".to_owned());
    }
    match repeat {
        Some((times, variant)) => repeat_one(&chapters, &variant, times),
        None => chapters
            .into_iter()
            .try_for_each(|chapter| measure(chapter, effort, folder, peers.as_ref())),
    }
}

/// The chapters with these names; all where none is named.
fn chosen(names: &[String]) -> Result<Vec<&'static Chapter>, String> {
    let known: Vec<&str> = CHAPTERS.iter().map(|chapter| chapter.name).collect();
    if let Some(unknown) = names.iter().find(|name| !known.contains(&name.as_str())) {
        let known = known.join(", ");
        return Err(format!(
            "no chapter is called \"{unknown}\": expected one of {known}"
        ));
    }
    let is_chosen =
        |chapter: &&Chapter| names.is_empty() || names.iter().any(|name| name == chapter.name);
    Ok(CHAPTERS.iter().filter(is_chosen).collect())
}

fn measure(
    chapter: &Chapter,
    effort: Effort,
    folder: &Path,
    peers: Option<&Peers>,
) -> Result<(), String> {
    let mut rows = Vec::new();
    (chapter.visit)(effort, &mut |comparison| {
        rows.extend(comparison.measure(effort));
        eprintln!("{}: {} variants measured", chapter.name, rows.len());
    });
    report::print(chapter.name, &rows);
    let file = report::write(folder, chapter.name, &rows, peers);
    let file = file.map_err(|error| format!("cannot write to {}: {error}", folder.display()))?;
    println!("written to {}", file.display());
    Ok(())
}

fn repeat_one(chapters: &[&Chapter], variant: &str, times: usize) -> Result<(), String> {
    let mut is_found = false;
    for chapter in chapters {
        (chapter.visit)(QUICK, &mut |mut comparison| {
            is_found |= comparison.repeat(variant, times);
        });
    }
    let missing =
        format!("no variant is called \"{variant}\": expected quantity/algorithm/scalar/inputs");
    is_found.then_some(()).ok_or(missing)
}
