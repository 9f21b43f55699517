//! Numbers, points and vectors: what every chapter is written over.
//!
//! A formula of the course is a statement about a field (`+ - * /`) or about real numbers (square roots, cosines).
//! The traits of this module let a signature say which, so that one piece of code runs over `f32` for speed, `f64`
//! for precision and exact rationals for proofs: what needs only a [`Scalar`] can be checked with `==`.
//!
//! ```text
//! Scalar       + - * /, ordering, small rational constants     f32, f64; exact and dual numbers in the tests
//! Real         a Scalar with sqrt, sin, cos                    f32, f64
//! VectorSpace  sums, multiples, affine combinations            every glam vector, [S; N], S itself
//! Vector3      a VectorSpace with dot and cross                Vec3, Vec3A, DVec3, [S; 3]
//! ```
//!
//! # Conventions
//!
//! Vectors are combined by named methods ([`VectorSpace::plus`], [`VectorSpace::lerp`]) instead of operators, because
//! an array `[S; N]` cannot carry operators of ours. Right-handed frames: `x × y = z`.
//!
//! # Numerics
//!
//! Nothing here fuses a multiplication with an addition, so the bits are the same on every processor. Every error bound of the
//! library supposes that nothing overflows, and that what is rounded is not denormal.
//!
//! *In the book*: [Numbers and points](../../../ground_floor.html).

mod length;
mod number;
mod vector;

pub(crate) use length::divided;
pub use length::{length, unit_vector};
pub(crate) use number::larger;
pub use number::{Real, Scalar};
pub(crate) use vector::check_finite;
pub use vector::{Vector3, VectorSpace};
