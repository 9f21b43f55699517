//! The chapter *coons* as an exercise: the same theorems, run against the reader's code.

#[path = "../common/mod.rs"]
mod common;
mod bicubic_theorems;
mod inputs;
mod mistakes;
mod suspects;
mod theorems;
