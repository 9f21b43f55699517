//! The chapter *subdivision* as an exercise: the same theorems, run against the reader's code.
#![allow(clippy::float_cmp, reason = "theorems and hard cases promise the same bits")]

mod catmull_clark_theorems;
#[path = "../common/mod.rs"]
mod common;
mod curve_degree_theorems;
mod curve_inputs;
mod curve_shape_theorems;
mod curve_theorems;
mod loop_theorems;
mod meshes;
mod mistakes;
mod nets;
mod plain_rules;
mod steps;
mod suspects;
