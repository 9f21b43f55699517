//! The chapter *subdivision*: its theorems, the hard cases and the snapshots of its figures.
#![allow(
    clippy::float_cmp,
    reason = "theorems and hard cases promise the same bits"
)]

#[path = "../common/mod.rs"]
mod common;
mod snapshots;
