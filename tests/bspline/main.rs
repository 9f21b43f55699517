//! The chapter *bspline*: its theorems, the errors against the oracle, the hard cases and the snapshots of its figures.
#![allow(
    clippy::float_cmp,
    reason = "theorems and hard cases promise the same bits"
)]

mod basis_hard_cases;
mod basis_theorems;
mod batch_theorems;
#[path = "../common/mod.rs"]
mod common;
mod continuity_theorems;
mod control_theorems;
mod curve_derivative_theorems;
mod curve_theorems;
mod divided_differences;
mod error_hard_cases;
mod error_theorems;
mod hard_cases;
mod identity_theorems;
mod inputs;
mod mistakes;
mod normal_hard_cases;
mod periodic_hard_cases;
mod periodic_theorems;
mod rational_hard_cases;
mod rational_theorems;
mod refinement_theorems;
mod shape_theorems;
mod snapshots;
mod surface_refinement_theorems;
mod surface_theorems;
mod suspects;
mod trimmed_hard_cases;
mod trimmed_theorems;
mod variants;
