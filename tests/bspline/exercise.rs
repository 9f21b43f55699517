//! The chapter *bspline* as an exercise: the same theorems, run against the reader's code.
#![allow(clippy::float_cmp, reason = "theorems and hard cases promise the same bits")]

mod basis_theorems;
#[path = "../common/mod.rs"]
mod common;
mod continuity_theorems;
mod control_theorems;
mod curve_derivative_theorems;
mod curve_theorems;
mod divided_differences;
mod identity_theorems;
mod inputs;
mod mistakes;
mod refinement_theorems;
mod shape_theorems;
mod surface_refinement_theorems;
mod surface_theorems;
mod suspects;
