//! `cargo exercise`: see the library of this package.

use std::env;
use std::io;
use std::process::ExitCode;

use facette_grader::command_line;
use facette_grader::commands;

/// All theorems hold: 0; one does not: 1; the command could not be carried out: 2.
fn main() -> ExitCode {
    let outcome = command_line::parse(env::args_os())
        .and_then(|command| commands::run(&command, &mut io::stdout()));
    match outcome {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::from(1),
        Err(error) => {
            eprintln!("cargo exercise: {error}");
            ExitCode::from(2)
        }
    }
}
