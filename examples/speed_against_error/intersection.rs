//! The variants of the chapter *intersection*, one file for each kind of surface.

use crate::Visitor;
use crate::harness::Effort;

#[path = "intersection/facets.rs"]
mod facets;
#[path = "intersection/triangles.rs"]
mod triangles;

/// Hands all comparisons to the visitor.
pub fn visit(effort: Effort, visitor: &mut Visitor<'_>) {
    triangles::visit(effort, visitor);
    facets::visit(effort, visitor);
}
