//! What a test says when it ends.
//!
//! A theorem that fails panics with these lines, each at the start of a line of standard error:
//!
//! ```text
//! theorem: coons::patch_interpolates_its_four_boundary_curves
//! input: P1 = ..., u = 1/3, v = 0
//! expected: ...
//! got: ...
//! likely mistake: You forgot to subtract S3 ...
//! mistake: forgotten_s3
//! ```
//!
//! A stub panics with "not yet implemented", as `todo!` does.

/// What running one theorem has shown.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// It holds.
    Passed,
    /// A function that it needs is still a stub; with the stub's message.
    NotWritten(String),
    /// It does not hold.
    Failed(Failure),
    /// The test ended otherwise: by a panic of its own, a crash, or not at all. In words.
    Broken(String),
}

/// Why a theorem does not hold.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Failure {
    /// The smallest input on which it fails.
    pub input: String,
    /// What the theorem says.
    pub expected: String,
    /// What the reader's code says.
    pub got: String,
    /// The typical mistake with the same result, in words.
    pub likely_mistake: Option<String>,
    /// The name of that mistake.
    pub mistake: Option<String>,
}

const STUB: &str = "not yet implemented";

/// What a test has shown, from the way it ended (`Ok`, or how it failed) and what it wrote.
#[must_use]
pub fn outcome(ending: Result<(), String>, output: &str, errors: &str) -> Outcome {
    match ending {
        Ok(()) if output.contains("1 passed") => return Outcome::Passed,
        Ok(()) => return Outcome::Broken("the test was not run".to_owned()),
        Err(_) => {}
    }
    let failure = failure(errors);
    // A report counts by what the reader's code did: the search for the likely mistake may meet the stub of another function.
    let told = failure.as_ref().map_or(errors, |failure| &failure.got);
    if let Some(line) = told.lines().find(|line| line.contains(STUB)) {
        let message = line.split_once(STUB).map_or("", |(_, rest)| rest);
        return Outcome::NotWritten(message.trim_start_matches(':').trim().to_owned());
    }
    match failure {
        Some(failure) => Outcome::Failed(failure),
        None => Outcome::Broken(panic_message(errors).unwrap_or_else(|| ending_in_words(ending))),
    }
}

/// The last block that begins with a line `theorem:`.
fn failure(errors: &str) -> Option<Failure> {
    let lines: Vec<&str> = errors.lines().collect();
    let start = lines
        .iter()
        .rposition(|line| line.starts_with("theorem: "))?;
    let value = |key: &str| {
        let found = lines[start..]
            .iter()
            .find_map(|line| line.strip_prefix(key));
        found.map(|value| value.trim().to_owned())
    };
    Some(Failure {
        input: value("input:").unwrap_or_default(),
        expected: value("expected:").unwrap_or_default(),
        got: value("got:").unwrap_or_default(),
        likely_mistake: value("likely mistake:"),
        mistake: value("mistake:"),
    })
}

/// The message of the last panic, with the place in the source.
fn panic_message(errors: &str) -> Option<String> {
    let (_, last) = errors.rsplit_once("panicked at ")?;
    let message: Vec<&str> = last
        .lines()
        .take_while(|line| !line.starts_with("note: ") && !line.is_empty())
        .collect();
    Some(format!("it panicked at {}", message.join(" ")))
}

fn ending_in_words(ending: Result<(), String>) -> String {
    match ending {
        Ok(()) => "the test was not run".to_owned(),
        Err(how) => format!("the test {how}"),
    }
}
