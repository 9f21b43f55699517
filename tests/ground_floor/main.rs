//! The chapter *ground floor*: numbers, points, curves, surfaces and meshes, and the fragments of "Just enough Rust".
#![allow(
    clippy::float_cmp,
    reason = "these theorems promise exact values, and say where they do not"
)]

#[path = "../common/mod.rs"]
mod common;
mod curve_hard_cases;
mod curve_theorems;
mod inputs;
mod mesh_hard_cases;
mod mesh_theorems;
mod number_theorems;
mod obj_hard_cases;
mod obj_normal_hard_cases;
mod obj_normal_theorems;
mod obj_theorems;
mod polygon_hard_cases;
mod polygon_theorems;
mod polyline_theorems;
mod rust_tour;
mod scratch;
mod vector_hard_cases;
mod vector_theorems;
