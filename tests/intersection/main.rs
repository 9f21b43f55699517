//! The chapter *intersection*: its theorems, the hard cases and the snapshots of its figures.
#![allow(
    clippy::float_cmp,
    reason = "theorems and hard cases promise the same bits"
)]

mod box_error_theorems;
mod box_hard_cases;
mod box_inputs;
mod box_theorems;
#[path = "../common/mod.rs"]
mod common;
mod departures;
mod fan_hard_cases;
mod fan_theorems;
mod float_boxes;
mod float_chords;
mod group_theorems;
mod hierarchy_hard_cases;
mod hierarchy_inputs;
mod hierarchy_mesh_theorems;
mod hierarchy_meshes;
mod hierarchy_oracle;
mod hierarchy_packet_theorems;
mod hierarchy_refusal_hard_cases;
mod hierarchy_theorems;
mod main_job;
mod mistakes;
mod offset_hard_cases;
mod offset_theorems;
mod patch_hard_cases;
mod patch_inputs;
mod patch_oracle;
mod patch_theorems;
mod picture_theorems;
mod plane_theorems;
mod quadrilateral_hard_cases;
mod quadrilateral_inputs;
mod quadrilateral_theorems;
mod roots;
mod snapshots;
mod sphere_error_theorems;
mod sphere_hard_cases;
mod sphere_inputs;
mod sphere_theorems;
mod surface_theorems;
mod suspects;
mod triangle_error_theorems;
mod triangle_floats;
mod triangle_hard_cases;
mod triangle_inputs;
mod triangle_mesh_theorems;
mod triangle_meshes;
mod triangle_suspects;
mod triangle_theorems;
mod variants_spheres;
mod variants_surfaces;
mod variants_triangles;
