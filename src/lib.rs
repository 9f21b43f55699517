//! Facette: a companion to a course on computer graphics, chapter by chapter.
//!
//! One module is one chapter of the course; the book, the example, the tests and the snapshots of a chapter bear its
//! name. The table lists them in reading order; imports point down only.
//!
//! | floor | modules |
//! | --- | --- |
//! | ground | [`algebra`], [`curve`], [`surface`], [`mesh`] |
//! | surfaces | [`coons`], [`bspline`], [`tessellation`], [`subdivision`] |
//! | rays | [`ray`], [`camera`], [`intersection`] |
//!
//! *In the book*: [the front page](../../index.html).

pub mod algebra;
pub mod bspline;
pub mod camera;
pub mod coons;
pub mod curve;
pub mod intersection;
pub mod mesh;
pub mod ray;
pub mod subdivision;
pub mod surface;
pub mod tessellation;
