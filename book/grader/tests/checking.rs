//! What the grader does with what the tests and the compiler say, and what it remembers.

use std::cell::RefCell;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;
use std::time::{Duration, Instant};

use facette_grader::check::{self, Verdict};
use facette_grader::compiler;
use facette_grader::progress::{self, Progress, State};
use facette_grader::protocol::{self, Failure, Outcome};
use facette_grader::runner;
use facette_grader::theorem::Theorem;
use facette_grader::verify::{self, Mistake};
use facette_grader::watch;

fn theorem(name: &str) -> Theorem {
    Theorem {
        name: name.to_owned(),
        title: format!("Title of {name}"),
        statement: String::new(),
        exercises: vec!["bilinear".to_owned()],
        page: "coons.html".to_owned(),
    }
}

/// An empty folder of its own for each test.
fn scratch(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    if folder.exists() {
        fs::remove_dir_all(&folder).expect("the scratch folder can be removed");
    }
    fs::create_dir_all(&folder).expect("the scratch folder can be made");
    folder
}

const REPORT: &str = "
thread 'theorems::patch' panicked at tests/common/law.rs:1:1:
the law does not hold
theorem: coons::patch
input: u = 1/3, v = 0
expected: [1, 2]
got: [3, 4]
likely mistake: You forgot to subtract S3.
mistake: forgotten_s3
note: run with `RUST_BACKTRACE=1`
";

fn forgotten_s3() -> Failure {
    Failure {
        input: "u = 1/3, v = 0".to_owned(),
        expected: "[1, 2]".to_owned(),
        got: "[3, 4]".to_owned(),
        likely_mistake: Some("You forgot to subtract S3.".to_owned()),
        mistake: Some("forgotten_s3".to_owned()),
    }
}

fn failed(errors: &str) -> Outcome {
    protocol::outcome(Err("ended with exit status: 101".to_owned()), "", errors)
}

#[test]
fn a_failure_is_read_from_the_lines_of_the_protocol() {
    assert_eq!(failed(REPORT), Outcome::Failed(forgotten_s3()));
    let without_mistake = REPORT.replace("mistake: forgotten_s3\n", "");
    let Outcome::Failed(failure) = failed(&without_mistake) else {
        panic!("a failure without a typical mistake is a failure");
    };
    assert_eq!(failure.mistake, None);
    assert!(failure.likely_mistake.is_some());
}

#[test]
fn the_last_of_several_reports_counts() {
    let two = format!("{}{REPORT}", REPORT.replace("u = 1/3", "u = 12345/67891"));
    assert_eq!(failed(&two), Outcome::Failed(forgotten_s3()));
}

#[test]
fn a_stub_is_not_a_failure() {
    let errors =
        "panicked at src/bilinear.rs:9:5:\nnot yet implemented: bilinear_point: the point\n";
    let message = "bilinear_point: the point".to_owned();
    assert_eq!(failed(errors), Outcome::NotWritten(message.clone()));
    let got = REPORT
        .lines()
        .find(|line| line.starts_with("got: "))
        .expect("a report says what it got");
    let report = REPORT.replace(
        got,
        &format!("got: a panic: not yet implemented: {message}"),
    );
    assert_eq!(
        failed(&format!("{errors}{report}")),
        Outcome::NotWritten(message)
    );
}

#[test]
fn a_failure_stays_one_where_the_search_for_its_mistake_meets_another_stub() {
    let errors = "panicked at src/basis.rs:9:5:\nnot yet implemented: cox_de_boor\n";
    assert_eq!(
        failed(&format!("{errors}{REPORT}")),
        Outcome::Failed(forgotten_s3())
    );
}

#[test]
fn other_endings_are_told_as_they_are() {
    let panic = "thread 't' panicked at src/bilinear.rs:9:5:\nattempt to divide by zero\nnote: x\n";
    let told = "it panicked at src/bilinear.rs:9:5: attempt to divide by zero".to_owned();
    assert_eq!(failed(panic), Outcome::Broken(told));
    assert_eq!(
        failed(""),
        Outcome::Broken("the test ended with exit status: 101".to_owned())
    );
}

#[test]
fn a_test_passes_only_where_it_was_run() {
    let passed = "test result: ok. 1 passed; 0 failed";
    assert_eq!(protocol::outcome(Ok(()), passed, ""), Outcome::Passed);
    let none = "test result: ok. 0 passed; 0 failed";
    assert_eq!(
        protocol::outcome(Ok(()), none, ""),
        Outcome::Broken("the test was not run".to_owned())
    );
}

#[test]
fn a_check_stops_at_the_first_theorem_that_fails() {
    let theorems = ["one", "two", "three"].map(theorem);
    let theorems: Vec<&Theorem> = theorems.iter().collect();
    let mut held = Vec::new();
    let verdict = check::check(
        &theorems,
        &|theorem, _| {
            // The first ends last.
            let is_first = theorem.name == "one";
            thread::sleep(Duration::from_millis(if is_first { 30 } else { 0 }));
            Ok(if is_first {
                Outcome::Passed
            } else {
                Outcome::Failed(forgotten_s3())
            })
        },
        &mut |theorem| {
            held.push(theorem.name.clone());
            Ok(())
        },
    );
    let verdict = verdict.expect("the fake runner has no errors");
    assert_eq!(held, ["one"]);
    assert_eq!((verdict.passed, verdict.theorems), (1, 3));
    assert!(!verdict.is_complete() && !verdict.is_not_started());
    assert_eq!(
        verdict.stopped_at.map(|(theorem, _)| theorem.name.as_str()),
        Some("two")
    );
}

fn verdict(theorem: &Theorem, passed: usize, outcome: Outcome) -> Verdict<'_> {
    Verdict {
        passed,
        theorems: 3,
        stopped_at: Some((theorem, outcome)),
    }
}

#[test]
fn progress_is_kept_between_runs() {
    let folder = scratch("progress");
    let two = theorem("two");
    let failing = verdict(&two, 1, Outcome::Failed(forgotten_s3()));
    let mut progress = Progress::read(&folder).expect("no file is no progress");
    let take = |record: &mut progress::Record| record.take(&failing, "f1".to_owned());
    progress
        .change("coons", "bilinear", take)
        .expect("it can be written");
    let give = |record: &mut progress::Record| record.hints_given = 2;
    progress
        .change("coons", "bilinear", give)
        .expect("it can be written");

    let read = Progress::read(&folder).expect("it can be read");
    assert_eq!(read, progress);
    let record = read.record("coons", "bilinear");
    assert_eq!(record.hints_given, 2);
    let state = State::Failing {
        passed: 1,
        theorems: 3,
        stopped_at: "two".to_owned(),
    };
    assert_eq!(record.state("f1", false), state);
    assert_eq!(record.state("f2", false), State::Unchecked);
    assert_eq!(record.state("f1", true), State::NotStarted);
    assert_eq!(
        read.record("coons", "other").state("f1", false),
        State::Unchecked
    );
}

#[test]
fn states_follow_from_results() {
    let one = theorem("one");
    let mut record = progress::Record::default();
    record.take(
        &verdict(&one, 0, Outcome::NotWritten(String::new())),
        "f".to_owned(),
    );
    assert_eq!(record.state("f", false), State::NotStarted);
    let complete = Verdict {
        passed: 3,
        theorems: 3,
        stopped_at: None,
    };
    record.take(&complete, "f".to_owned());
    assert_eq!(record.state("f", false), State::Passed { theorems: 3 });
}

#[test]
fn a_broken_progress_file_says_what_to_do() {
    let folder = scratch("broken-progress");
    fs::write(folder.join("progress.toml"), "[coons\n").expect("it can be written");
    let error = Progress::read(&folder)
        .expect_err("the table is not closed")
        .to_string();
    assert!(
        error.contains("line 1") && error.contains("delete the file"),
        "{error}"
    );
}

#[test]
fn fingerprints_tell_files_apart() {
    let folder = scratch("fingerprints");
    let files = [folder.join("a"), folder.join("b")];
    let missing = progress::fingerprint(&files);
    fs::write(&files[0], "xy").expect("it can be written");
    let first = progress::fingerprint(&files);
    fs::write(&files[0], "x").expect("it can be written");
    fs::write(&files[1], "y").expect("it can be written");
    let shifted = progress::fingerprint(&files);
    assert!(missing != first && first != shifted);
    assert_eq!(shifted, progress::fingerprint(&files));
}

const COMPILER: &str = r#"{"reason":"compiler-artifact","target":{"kind":["lib"],"name":"coons"},"executable":null}
not a message
{"reason":"compiler-message","message":{"level":"warning","rendered":"warning: unused","spans":[]}}
{"reason":"compiler-message","message":{"level":"error","rendered":"error[E0369]: cannot add\n --> src/bilinear.rs:18:8\n","spans":[{"file_name":"src/other.rs","is_primary":false},{"file_name":"src/bilinear.rs","is_primary":true}]}}
{"reason":"compiler-artifact","target":{"kind":["test"],"name":"coons"},"executable":"/t/coons-1"}
"#;

#[test]
fn the_compilers_messages_give_the_binary_or_the_first_error() {
    assert_eq!(
        compiler::test_binary(COMPILER, "coons"),
        Some(PathBuf::from("/t/coons-1"))
    );
    assert_eq!(compiler::test_binary(COMPILER, "bspline"), None);
    let error = compiler::first_error(COMPILER).expect("there is an error");
    assert_eq!(error.file, Some(PathBuf::from("src/bilinear.rs")));
    assert_eq!(
        error.message,
        "error[E0369]: cannot add\n --> src/bilinear.rs:18:8"
    );
    assert_eq!(compiler::first_error("{}"), None);
}

#[cfg(unix)]
#[test]
fn a_test_that_does_not_end_is_ended() {
    let mut command = Command::new("sleep");
    command
        .arg("60")
        .stdout(Stdio::piped())
        .stderr(Stdio::piped());
    let child = command.spawn().expect("sleep can be started");
    let outcome = runner::ended(child, Duration::from_millis(50), &AtomicBool::new(false))
        .expect("it can be waited for");
    assert_eq!(
        outcome,
        Outcome::Broken("the test did not end within 0 s".to_owned())
    );
}

#[test]
fn what_comes_after_a_failure_is_not_waited_for() {
    let theorems = ["one", "two"].map(theorem);
    let theorems: Vec<&Theorem> = theorems.iter().collect();
    let start = Instant::now();
    let run = |theorem: &Theorem, is_unwanted: &AtomicBool| {
        while theorem.name == "two" && !is_unwanted.load(Ordering::Relaxed) {
            assert!(
                start.elapsed() < Duration::from_secs(30),
                "the flag is never set"
            );
            thread::yield_now();
        }
        Ok(Outcome::Failed(forgotten_s3()))
    };
    let verdict =
        check::check(&theorems, &run, &mut |_| Ok(())).expect("the fake runner has no errors");
    assert_eq!((verdict.passed, verdict.theorems), (0, 2));
}

#[test]
fn watching_checks_once_and_after_every_change() {
    let stamps = RefCell::new(vec![1, 1, 1, 2, 2, 2, 3].into_iter());
    let mut checks = 0;
    let look = || stamps.borrow_mut().next();
    let check = || {
        checks += 1;
        Ok(checks < 3)
    };
    watch::watch(look, check, Duration::ZERO).expect("the fake check has no errors");
    assert_eq!(checks, 3);
}

#[test]
fn a_stamp_sees_a_save() {
    let folder = scratch("stamp");
    let before = watch::stamp(&folder);
    fs::write(folder.join("a.rs"), "x").expect("it can be written");
    let after = watch::stamp(&folder);
    assert!(before.is_empty() && after.len() == 1);
    fs::write(folder.join("a.rs"), "xy").expect("it can be written");
    assert_ne!(after, watch::stamp(&folder));
}

#[test]
fn a_mistake_must_be_rejected_by_its_theorem_with_its_hint() {
    let list = "forgotten_s3\tbilinear\tpatch\tYou forgot to subtract S3.\nincomplete\tline\n";
    let mistakes = verify::parse_mistakes(list);
    let mistake = Mistake {
        name: "forgotten_s3".to_owned(),
        exercise: "bilinear".to_owned(),
        rejected_by: "patch".to_owned(),
        hint: "You forgot to subtract S3.".to_owned(),
    };
    assert_eq!(mistakes.as_slice(), std::slice::from_ref(&mistake));

    let judged = |theorem: &str, outcome: &Outcome| {
        verify::judge_mistake(&mistake, Some((theorem, outcome)))
    };
    let rejected = Outcome::Failed(forgotten_s3());
    assert_eq!(judged("patch", &rejected), Ok(()));
    assert_eq!(
        judged("other", &rejected),
        Err("other rejects it before patch".to_owned())
    );
    let mut failure = forgotten_s3();
    failure.mistake = Some("swapped".to_owned());
    let taken_for_another = "patch rejects it, but takes it for swapped".to_owned();
    assert_eq!(
        judged("patch", &Outcome::Failed(failure)),
        Err(taken_for_another)
    );
    let mut failure = forgotten_s3();
    failure.likely_mistake = None;
    assert!(judged("patch", &Outcome::Failed(failure)).is_err());
    assert!(judged("patch", &Outcome::Broken("it panicked".to_owned())).is_err());
    let accepted = verify::judge_mistake(&mistake, None);
    assert_eq!(accepted, Err("no theorem rejects it".to_owned()));
}
