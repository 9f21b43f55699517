//! The chapter *intersection* as an exercise: the same theorems, run against the reader's code.
#![allow(clippy::float_cmp, reason = "theorems and hard cases promise the same bits")]

mod box_inputs;
mod box_theorems;
#[path = "../common/mod.rs"]
mod common;
mod group_theorems;
mod mistakes;
mod roots;
mod sphere_inputs;
mod sphere_theorems;
mod suspects;
mod triangle_inputs;
mod triangle_suspects;
mod triangle_theorems;
