//! The chapter *tessellation*: its theorems, the hard cases, its main job and the snapshots of its figures.
#![allow(
    clippy::float_cmp,
    reason = "theorems and hard cases promise the same bits"
)]

mod bound_theorems;
#[path = "../common/mod.rs"]
mod common;
mod hard_cases;
mod inputs;
mod main_job;
mod mesh_theorems;
mod refusal_hard_cases;
mod seam_hard_cases;
mod snapshots;
mod topology_theorems;
