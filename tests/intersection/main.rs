//! The chapter *intersection*: its theorems, the hard cases and the snapshots of its figures.
#![allow(
    clippy::float_cmp,
    reason = "theorems and hard cases promise the same bits"
)]

mod bound;
#[path = "../common/mod.rs"]
mod common;
mod hierarchy_oracle;
mod hierarchy_theorems;
mod patch_inputs;
mod patch_oracle;
mod patch_theorems;
mod suspects;
