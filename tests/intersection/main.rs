//! The chapter *intersection*: its theorems, the hard cases and the snapshots of its figures.
#![allow(
    clippy::float_cmp,
    reason = "theorems and hard cases promise the same bits"
)]

mod bound;
#[path = "../common/mod.rs"]
mod common;
mod fan_theorems;
mod hierarchy_oracle;
mod hierarchy_theorems;
mod patch_inputs;
mod patch_oracle;
mod patch_theorems;
mod suspects;
mod triangle_error_theorems;
mod triangle_floats;
mod triangle_hard_cases;
mod triangle_inputs;
mod triangle_mesh_theorems;
mod triangle_meshes;
mod triangle_suspects;
mod triangle_theorems;
mod variants_triangles;
