//! The chapter *coons* as an exercise: the same theorems, run against the reader's code.
#![allow(clippy::float_cmp, reason = "theorems and hard cases promise the same bits")]

#[path = "../common/mod.rs"]
mod common;
mod bicubic_theorems;
mod derivative_theorems;
mod inputs;
mod mistakes;
mod suspects;
mod theorems;
