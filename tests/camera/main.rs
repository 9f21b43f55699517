//! The chapter *camera*: its theorems, the errors against the oracle, the hard cases and the snapshots of its figures.
#![allow(
    clippy::float_cmp,
    reason = "theorems and hard cases promise the same bits"
)]

#[path = "../common/mod.rs"]
mod common;
mod error_theorems;
mod float_inputs;
mod frame_theorems;
mod hard_cases;
mod image_theorems;
mod inputs;
mod mistakes;
mod place_error_theorems;
mod projection_theorems;
mod ray_theorems;
mod refusal_hard_cases;
mod snapshots;
mod suspects;
mod variants;
