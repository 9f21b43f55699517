//! The variants of the chapter *subdivision*.

use crate::Visitor;
use crate::harness::Effort;

#[path = "subdivision/curves.rs"]
mod curves;
#[path = "subdivision/evaluation.rs"]
mod evaluation;
#[path = "../subdivision/solids.rs"]
mod solids;
#[path = "subdivision/surfaces.rs"]
mod surfaces;

/// Hands all comparisons to the visitor.
pub fn visit(effort: Effort, visitor: &mut Visitor<'_>) {
    curves::visit(effort, visitor);
    surfaces::visit(effort, visitor);
    evaluation::visit(effort, visitor);
}
