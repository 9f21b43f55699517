//! The grader: runs a chapter's theorems against the code of the reader, and says which one fails, in words.
//!
//! ```text
//! book/exercises/coons/   templates: stubs, solutions, hints      ─┐ copied once
//! exercises/coons/        the reader's package (git ignores it)   ←┘
//! tests/coons/            the theorems: the same files hold the library and the reader to them
//! book/src/coons.md       the order in which they run
//! ```
//!
//! One check is: [`workshop`] puts the reader's package in place, [`compiler`] builds it, [`theorem`] lists what the
//! exercise must satisfy, [`runner`] runs the theorems one by one and [`protocol`] reads what they say, [`check`]
//! stops at the first that fails, [`report`] explains it and [`progress`] remembers the result. [`verify`] does the
//! same to the stubs, the solutions and the typical mistakes.
//!
//! The grader depends neither on the library nor on the reader's package, so a type error there leaves hints and
//! reset working.

pub mod catalogue;
pub mod check;
pub mod command_line;
pub mod commands;
pub mod compiler;
pub mod error;
pub mod house;
pub mod plain_text;
pub mod progress;
pub mod protocol;
pub mod report;
pub mod runner;
pub mod theorem;
pub mod verify;
pub mod watch;
pub mod workshop;
