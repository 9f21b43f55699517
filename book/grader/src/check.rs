//! One exercise against its theorems: in the order of the text, up to the first that fails.

use std::collections::BTreeMap;
use std::io;
use std::num::NonZero;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::mpsc::{self, Receiver, Sender};
use std::thread;

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

/// Runs a theorem; a run that is no longer wanted ends early once the flag is set, with any outcome.
pub type Run<'a> = &'a (dyn Fn(&Theorem, &AtomicBool) -> Result<Outcome, GraderError> + Sync);

/// Runs the theorems with `run`, tells `holds` of each that holds, in their order, and stops at the first that does
/// not. As many run at a time as there are processors; what comes after the first failure is thrown away.
///
/// # Errors
///
/// Those of `run` and `holds`.
pub fn check<'a>(
    theorems: &[&'a Theorem],
    run: Run,
    holds: &mut dyn FnMut(&Theorem) -> Result<(), GraderError>,
) -> Result<Verdict<'a>, GraderError> {
    let (next, is_decided) = (AtomicUsize::new(0), AtomicBool::new(false));
    let (sender, outcomes) = mpsc::channel();
    let work = |sender: Sender<Numbered>| {
        while !is_decided.load(Ordering::Relaxed) {
            let number = next.fetch_add(1, Ordering::Relaxed);
            let Some(theorem) = theorems.get(number) else {
                return;
            };
            if sender.send((number, run(theorem, &is_decided))).is_err() {
                return;
            }
        }
    };
    thread::scope(|scope| {
        for _ in 0..thread::available_parallelism().map_or(1, NonZero::get) {
            let sender = sender.clone();
            scope.spawn(|| work(sender));
        }
        drop(sender);
        let verdict = in_order(theorems, &outcomes, holds);
        is_decided.store(true, Ordering::Relaxed);
        verdict
    })
}

/// The number of a theorem and what its run has shown.
type Numbered = (usize, Result<Outcome, GraderError>);

/// Takes the outcomes in the order of the theorems, whatever order they come in.
fn in_order<'a>(
    theorems: &[&'a Theorem],
    outcomes: &Receiver<Numbered>,
    holds: &mut dyn FnMut(&Theorem) -> Result<(), GraderError>,
) -> Result<Verdict<'a>, GraderError> {
    let mut early = BTreeMap::new();
    for (passed, &theorem) in theorems.iter().enumerate() {
        let outcome = loop {
            if let Some(outcome) = early.remove(&passed) {
                break outcome;
            }
            let (number, outcome) = outcomes.recv().map_err(io::Error::other)?;
            early.insert(number, outcome);
        };
        match outcome? {
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
