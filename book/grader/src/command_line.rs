//! What the reader asks for.

use std::ffi::OsString;

use lexopt::prelude::*;

use crate::error::GraderError;

/// What `cargo exercise help` says.
pub const HELP: &str = "\
cargo exercise                          the exercises and their state
cargo exercise coons                    checks a chapter's exercises in order, until one fails
cargo exercise coons/bilinear           checks one exercise (also: coons bilinear)
cargo exercise coons/bilinear --watch   checks it again on every save
cargo exercise coons/bilinear --hint    gives the next hint
cargo exercise coons/bilinear --reset   restores the stub, keeps your file as <file>.previous
cargo exercise verify                   checks the stubs, the solutions and the typical mistakes

--check is what happens without an option. list, check, watch, hint and reset may stand as words, too.";

/// A chapter, and one of its exercises or all of them.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Target {
    /// The chapter's name.
    pub chapter: String,
    /// The exercise's name.
    pub exercise: Option<String>,
}

/// What is to be done.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Command {
    /// Explain the commands.
    Help,
    /// List the exercises and their state: of all chapters, or of one.
    List(Option<Target>),
    /// Run the theorems.
    Check(Target),
    /// Run the theorems on every save.
    Watch(Target),
    /// Give the next hint.
    Hint(Target),
    /// Restore the stub.
    Reset(Target),
    /// Check the exercises themselves: of all chapters, or of one.
    Verify(Option<Target>),
}

const ACTIONS: [&str; 7] = ["check", "help", "hint", "list", "reset", "verify", "watch"];

/// The command of these arguments, the first of which is the program's name.
///
/// # Errors
///
/// [`GraderError::CommandLine`] says what is not understood and what is possible.
pub fn parse<I>(arguments: I) -> Result<Command, GraderError>
where
    I: IntoIterator<Item = OsString>,
{
    let (actions, names) = split(arguments).map_err(complaint)?;
    let action = match actions.as_slice() {
        [] => None,
        [action] => Some(action.as_str()),
        [first, second, ..] => {
            return Err(complaint(format!(
                "`{first}` and `{second}` exclude each other"
            )));
        }
    };
    let target = target(&names).map_err(complaint)?;
    match (action, target) {
        (Some("help"), _) => Ok(Command::Help),
        (Some("verify"), target) => Ok(Command::Verify(target)),
        (Some("list"), target) => Ok(Command::List(target)),
        (None, None) => Ok(Command::List(None)),
        (None | Some("check"), Some(target)) => Ok(Command::Check(target)),
        (Some("watch"), Some(target)) => Ok(Command::Watch(target)),
        (Some("hint"), Some(target)) => Ok(Command::Hint(target)),
        (Some("reset"), Some(target)) => Ok(Command::Reset(target)),
        (Some(action), _) => Err(complaint(format!(
            "`{action}` needs a chapter or an exercise"
        ))),
    }
}

/// The actions, given as words or as options, and the names that remain.
fn split<I>(arguments: I) -> Result<(Vec<String>, Vec<String>), String>
where
    I: IntoIterator<Item = OsString>,
{
    let (mut actions, mut names) = (Vec::new(), Vec::new());
    let mut parser = lexopt::Parser::from_iter(arguments);
    while let Some(argument) = parser.next().map_err(|error| error.to_string())? {
        match argument {
            Short('h') => actions.push("help".to_owned()),
            Long(name) if ACTIONS.contains(&name) => actions.push(name.to_owned()),
            Value(word) => {
                let word = word.to_string_lossy().into_owned();
                let list = if ACTIONS.contains(&word.as_str()) {
                    &mut actions
                } else {
                    &mut names
                };
                list.push(word);
            }
            other => return Err(other.unexpected().to_string()),
        }
    }
    Ok((actions, names))
}

/// `coons`, `coons/bilinear` or `coons bilinear`.
fn target(names: &[String]) -> Result<Option<Target>, String> {
    let words: Vec<&str> = names
        .iter()
        .flat_map(|name| name.split('/'))
        .filter(|word| !word.is_empty())
        .collect();
    match words.as_slice() {
        [] => Ok(None),
        [chapter] => Ok(Some(Target {
            chapter: (*chapter).to_owned(),
            exercise: None,
        })),
        [chapter, exercise] => Ok(Some(Target {
            chapter: (*chapter).to_owned(),
            exercise: Some((*exercise).to_owned()),
        })),
        [_, _, more @ ..] => Err(format!("`{}` is one word too many", more.join(" "))),
    }
}

fn complaint(message: String) -> GraderError {
    GraderError::CommandLine {
        message,
        help: HELP,
    }
}
