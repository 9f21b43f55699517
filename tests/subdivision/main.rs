//! The chapter *subdivision*: its theorems, the hard cases and the snapshots of its figures.
#![allow(
    clippy::float_cmp,
    reason = "theorems and hard cases promise the same bits"
)]

#[path = "../common/mod.rs"]
mod common;
mod count_theorems;
mod curve_degree_theorems;
mod curve_error_theorems;
mod curve_hard_cases;
mod curve_inputs;
mod curve_shape_theorems;
mod curve_theorems;
mod limit_inputs;
mod limit_tangent_theorems;
mod limit_theorems;
mod meshes;
mod mistakes;
mod snapshots;
mod step_hard_cases;
mod steps;
mod suspects;
