//! The chapter *coons*: its theorems, the errors against the oracle, the hard cases and the snapshots of its figures.
#![allow(
    clippy::float_cmp,
    reason = "theorems and hard cases promise the same bits"
)]

mod bicubic_theorems;
mod boundary_hard_cases;
#[path = "../common/mod.rs"]
mod common;
mod derivative_theorems;
mod error_theorems;
mod hard_cases;
mod inputs;
mod main_job;
mod mistakes;

mod snapshots;
mod suspects;
mod theorems;
mod variants;
