//! A law that is tried on many inputs and, when broken, says how: in words, on the smallest input, with the likely mistake.

use std::env;
use std::fmt::{Debug, Write as _};
use std::panic::{AssertUnwindSafe, catch_unwind};

use proptest::strategy::Strategy;
use proptest::test_runner::{
    Config, FileFailurePersistence, RngAlgorithm, TestCaseError, TestError, TestRng, TestRunner,
};

/// How a law was broken: what it promises, and what came instead.
#[derive(Debug)]
pub struct Broken {
    /// What the law promises.
    pub expected: String,
    /// What the code under test gave.
    pub got: String,
}

/// What a law says of one input.
pub type Verdict = Result<(), Broken>;

/// Passes where the two values are the same.
pub fn expect_equal<T: PartialEq + Debug>(expected: &T, got: &T) -> Verdict {
    if expected == got {
        return Ok(());
    }
    Err(Broken {
        expected: format!("{expected:?}"),
        got: format!("{got:?}"),
    })
}

/// Passes where `error` is not more than `bound`, both in the same unit, named by `what`.
pub fn expect_at_most(what: &str, bound: f64, error: f64) -> Verdict {
    if error <= bound {
        return Ok(());
    }
    Err(Broken {
        expected: format!("{what} of at most {bound}"),
        got: format!("{error}"),
    })
}

/// Why a reader's code may break a law.
#[derive(Clone, Copy, Debug)]
pub struct LikelyMistake {
    /// The name of the typical mistake that behaves alike; empty where none does.
    pub name: &'static str,
    /// What to look at.
    pub hint: &'static str,
}

/// A theorem under test: its name, what to suspect when it fails, and how many inputs it is tried on.
pub struct Law {
    theorem: &'static str,
    suspect: fn() -> LikelyMistake,
    cases: u32,
}

impl Law {
    /// The law behind the test `chapter::name`. When it is broken, `suspect` looks for the likely mistake.
    pub fn new(theorem: &'static str, suspect: fn() -> LikelyMistake) -> Self {
        Self {
            theorem,
            suspect,
            cases: 64,
        }
    }

    /// The law tried on `cases` inputs instead of 64.
    pub fn on_cases(self, cases: u32) -> Self {
        Self { cases, ..self }
    }

    /// Tries the law on inputs of which three quarters are `ordinary` and one quarter `hard`.
    ///
    /// # Panics
    ///
    /// Where the law is broken, with the smallest input that breaks it.
    pub fn holds<I: Debug>(
        self,
        ordinary: impl Strategy<Value = I>,
        hard: impl Strategy<Value = I>,
        check: impl Fn(&I) -> Verdict,
    ) {
        let of_hard = self.cases.div_ceil(4);
        let tried = self.try_on("ordinary", self.cases - of_hard, &ordinary, &check);
        let tried_hard = self.try_on("hard", of_hard, &hard, &check);
        assert!(
            4 * tried_hard >= tried + tried_hard,
            "a quarter of the inputs must be hard ones"
        );
    }

    /// How many inputs the law was tried on; panics with the explanation where one breaks it.
    fn try_on<I: Debug>(
        &self,
        kind: &str,
        cases: u32,
        inputs: &impl Strategy<Value = I>,
        check: &impl Fn(&I) -> Verdict,
    ) -> u32 {
        let mut runner = runner(self.theorem, kind, cases);
        let tried = std::cell::Cell::new(0);
        let outcome = runner.run(inputs, |input| {
            tried.set(tried.get() + 1);
            check(&input).map_err(|broken| TestCaseError::fail(broken.got))
        });
        match outcome {
            Ok(()) => tried.get(),
            Err(TestError::Fail(_, smallest)) => panic!("{}", self.explain(&smallest, check)),
            Err(TestError::Abort(reason)) => panic!("{}: no inputs: {reason}", self.theorem),
        }
    }

    /// The report on the smallest input that breaks the law, one line for each thing to know.
    fn explain<I: Debug>(&self, input: &I, check: &impl Fn(&I) -> Verdict) -> String {
        let verdict = catch_unwind(AssertUnwindSafe(|| check(input)));
        let broken = match verdict {
            Ok(Err(broken)) => broken,
            Ok(Ok(())) => Broken {
                expected: "the same answer twice".to_owned(),
                got: "an answer that breaks the law only sometimes".to_owned(),
            },
            Err(panic) => Broken {
                expected: "an answer".to_owned(),
                got: format!("a panic: {}", panic_message(panic.as_ref())),
            },
        };
        let mistake = catch_unwind(self.suspect).unwrap_or(LikelyMistake {
            name: "",
            hint: "the function stops with a panic: is a stub left?",
        });
        let mut report = format!("the law does not hold\ntheorem: {}\n", self.theorem);
        // Writing to a string cannot fail.
        let _ = writeln!(report, "input: {input:?}");
        let _ = writeln!(report, "expected: {}\ngot: {}", broken.expected, broken.got);
        let _ = writeln!(report, "likely mistake: {}", mistake.hint);
        if !mistake.name.is_empty() {
            let _ = writeln!(report, "mistake: {}", mistake.name);
        }
        report
    }
}

fn panic_message(panic: &(dyn std::any::Any + Send)) -> String {
    let text = panic.downcast_ref::<&str>().map(|text| (*text).to_owned());
    text.or_else(|| panic.downcast_ref::<String>().cloned())
        .unwrap_or_default()
}

/// A runner whose inputs are the same in every run of the continuous integration and of an exercise, and others in each run
/// elsewhere. What it finds is kept in `proptest-regressions`, except in an exercise.
fn runner(theorem: &str, kind: &str, cases: u32) -> TestRunner {
    let is_exercise = env::var_os("FACETTE_EXERCISE").is_some();
    let chapter = theorem.split(':').next().unwrap_or(theorem);
    let file: &'static str = format!("proptest-regressions/{chapter}.txt").leak();
    let mut config = Config {
        cases,
        failure_persistence: None,
        ..Config::default()
    };
    if !is_exercise {
        config.failure_persistence = Some(Box::new(FileFailurePersistence::Direct(file)));
    }
    if !is_exercise && env::var_os("CI").is_none() {
        return TestRunner::new(config);
    }
    let mut seed = [0_u8; 32];
    for (index, byte) in theorem.bytes().chain(kind.bytes()).enumerate() {
        let place = &mut seed[index % 32];
        *place = place.wrapping_mul(31).wrapping_add(byte);
    }
    TestRunner::new_with_rng(config, TestRng::from_seed(RngAlgorithm::ChaCha, &seed))
}
