//! The variants of the chapter *intersection*, one file for each kind of surface.

mod surfaces;

use crate::Visitor;
use crate::harness::Effort;

#[path = "intersection/facets.rs"]
mod facets;
#[path = "intersection/hierarchy.rs"]
mod hierarchy;
#[path = "../../tests/intersection/roots.rs"]
#[allow(dead_code, reason = "tests and report each use their part")]
mod roots;
#[path = "intersection/spheres.rs"]
mod spheres;
#[path = "intersection/triangles.rs"]
mod triangles;
#[path = "../../tests/intersection/variants_spheres.rs"]
mod variants_spheres;

/// Hands all comparisons to the visitor.
pub fn visit(effort: Effort, visitor: &mut Visitor<'_>) {
    spheres::visit(effort, visitor);
    triangles::visit(effort, visitor);
    facets::visit(effort, visitor);
    surfaces::visit(effort, visitor);
    hierarchy::visit(effort, visitor);
}
