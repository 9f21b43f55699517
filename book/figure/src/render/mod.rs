//! Pictures of surfaces, curves and points, made by the library's own rays: the same bytes on every machine.
//!
//! # Conventions
//!
//! Right-handed coordinates. Light hangs at the camera: a key light from the upper left, a fill light from the right.
//! Shading is linear and encoded as sRGB at the end; the background is transparent, so a picture sits on a light page
//! and on a dark one.
//!
//! # Numerics
//!
//! Only `+ - * /` and square roots are used, which are correctly rounded everywhere. What a ray meets first is decided exactly, for
//! a ray and positions in single precision around the middle of the scene. Their rounding moves the ray by no more than a 2⁻²¹st part of the
//! scene: a five-hundredth of the way to the next ray, in a picture of a thousand pixels.

pub(crate) mod colour;
mod facets;
mod geometry;
mod library;
mod material;
mod picture;
mod scene;
mod trace;
mod view;

pub use geometry::Triangles;
pub use material::Material;
pub use picture::{Picture, PngError};
pub use scene::Scene;
pub use view::{Lens, View};

#[cfg(test)]
mod tests;
