//! The chapter *subdivision*: its theorems, the hard cases and the snapshots of its figures.
#![allow(
    clippy::float_cmp,
    reason = "theorems and hard cases promise the same bits"
)]

mod catmull_clark_theorems;
#[path = "../common/mod.rs"]
mod common;
mod connectivity_hard_cases;
mod count_theorems;
mod curvature_theorems;
mod curve_degree_theorems;
mod curve_error_theorems;
mod curve_hard_cases;
mod curve_inputs;
mod curve_shape_theorems;
mod curve_theorems;
mod doo_sabin_theorems;
mod eigen_theorems;
mod evaluate_error_theorems;
mod evaluate_hard_cases;
mod evaluate_theorems;
mod limit_distance_theorems;
mod limit_error_theorems;
mod limit_hard_cases;
mod limit_inputs;
mod limit_spline_theorems;
mod limit_tangent_theorems;
mod limit_theorems;
mod loop_theorems;
mod mask_theorems;
mod meshes;
mod mistakes;
mod nets;
mod plain_rules;
mod refinement_doo_sabin_theorems;
mod refinement_match;
mod refinement_plan_theorems;
mod refinement_theorems;
mod repair_theorems;
#[path = "../ground_floor/scratch.rs"]
#[allow(dead_code, reason = "the chapter uses its part of this toolbox")]
mod scratch;
mod smoothness_theorems;
mod snapshots;
mod sqrt3_theorems;
mod step_error_theorems;
mod step_hard_cases;
mod step_theorems;
mod steps;
mod suspects;
