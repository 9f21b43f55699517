//! One exercise against its theorems: in the order of the text, up to the first that fails.

use crate::error::GraderError;
use crate::protocol::Outcome;
use crate::theorem::Theorem;

/// What a check has shown.
#[derive(Clone, Debug)]
pub struct Verdict<'a> {
    /// How many theorems hold, from the first on.
    pub passed: usize,
    /// How many there are.
    pub theorems: usize,
    /// The theorem at which the check stopped, and why.
    pub stopped_at: Option<(&'a Theorem, Outcome)>,
}

impl Verdict<'_> {
    /// Whether all theorems hold.
    #[must_use]
    pub fn is_complete(&self) -> bool {
        self.stopped_at.is_none()
    }

    /// Whether the reader has not written anything that a theorem could hold for.
    #[must_use]
    pub fn is_not_started(&self) -> bool {
        let at_stub = matches!(self.stopped_at, Some((_, Outcome::NotWritten(_))));
        at_stub && self.passed == 0
    }
}

/// Runs the theorems one by one with `run`, tells `holds` of each that holds, and stops at the first that does not.
///
/// # Errors
///
/// Those of `run` and `holds`.
pub fn check<'a>(
    theorems: &[&'a Theorem],
    run: &mut dyn FnMut(&Theorem) -> Result<Outcome, GraderError>,
    holds: &mut dyn FnMut(&Theorem) -> Result<(), GraderError>,
) -> Result<Verdict<'a>, GraderError> {
    for (passed, &theorem) in theorems.iter().enumerate() {
        match run(theorem)? {
            Outcome::Passed => holds(theorem)?,
            outcome => {
                let stopped_at = Some((theorem, outcome));
                return Ok(Verdict {
                    passed,
                    theorems: theorems.len(),
                    stopped_at,
                });
            }
        }
    }
    Ok(Verdict {
        passed: theorems.len(),
        theorems: theorems.len(),
        stopped_at: None,
    })
}
