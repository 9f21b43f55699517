//! The program behind `cargo book`: it makes the figures, expands the pages' directives, turns formulas into
//! `MathML`, lets mdBook write the pages, and refuses a book in which anything is missing or unused.

pub mod api;
pub mod assets;
pub mod chapter_checks;
pub mod chapters;
pub mod checks;
pub mod complaints;
pub mod directive;
pub mod expand;
pub mod figures;
pub mod html;
pub mod indexes;
pub mod links;
pub mod markdown;
pub mod material;
pub mod maths;
pub mod measure;
pub mod page;
pub mod problem;
pub mod render;
pub mod scratch;
pub mod sections;
pub mod sources;
pub mod survey;
pub mod tables;
pub mod theorem;
