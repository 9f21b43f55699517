//! Pictures of surfaces, curves and points: a depth buffer in plain arithmetic, the same bytes on every machine.
//!
//! # Conventions
//!
//! Right-handed coordinates. Light hangs at the camera: a key light from the upper left, a fill light from the right.
//! Shading is linear and encoded as sRGB at the end; the background is transparent, so a picture sits on a light page
//! and on a dark one.
//!
//! # Numerics
//!
//! Only `+ - * /` and square roots are used, which are correctly rounded everywhere.

mod camera;
pub(crate) mod colour;
mod geometry;
mod library;
mod material;
mod picture;
mod raster;
mod scene;

pub use camera::{Lens, View};
pub use geometry::Triangles;
pub use material::Material;
pub use picture::{Picture, PngError};
pub use scene::Scene;

#[cfg(test)]
mod tests;
