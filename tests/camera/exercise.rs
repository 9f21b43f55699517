//! The chapter *camera* as an exercise: the same theorems, run against the reader's code.
#![allow(clippy::float_cmp, reason = "theorems and hard cases promise the same bits")]

#[path = "../common/mod.rs"]
mod common;
mod frame_theorems;
mod image_theorems;
mod inputs;
mod mistakes;
mod projection_theorems;
mod ray_theorems;
mod suspects;
