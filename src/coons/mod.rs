//! Coons patches: a surface hung on four boundary curves.
//!
//! A designer draws the four edges of a panel and wants the panel. Coons' answer adds the two ruled surfaces that join
//! opposite edges and takes away what both have counted, the bilinear surface of the four corners:
//!
//! ```text
//! S(u,v) = S₁ + S₂ − S₃          S₁ = (1−v) P₁(u) + v P₂(u)          S₂ = (1−u) Q₁(v) + u Q₂(v)
//!                                S₃ = (1−u)(1−v) A + u(1−v) B + v(1−u) D + uv C
//! ```
//!
//! Hermite's cubics in the place of `1−t` and `t` give the bicubically blended patch, which also takes the slope across
//! each edge from a curve, so that neighbours can join smoothly.
//!
//! # Conventions
//!
//! Parameters in `[0, 1]²`; outside, the formulas extrapolate. `P1` is the edge v = 0, `P2` v = 1, `Q1` u = 0, `Q2`
//! u = 1; the corners are `A = S(0,0)`, `B = S(1,0)`, `C = S(1,1)`, `D = S(0,1)`. The normal is `S_u × S_v`.
//!
//! # Numerics
//!
//! Added from the left in floating point, `S₁ + S₂ − S₃` misses its own boundary by an ulp or two, and neighbours
//! that share a curve show cracks. The three terms are therefore summed with the rounding errors carried along: on an
//! edge two of them are the same number, and the third comes out bit for bit. Interpolation is written
//! `(1−t) a + t b`, which is exact at both ends where `a + t (b − a)` is not.
//!
//! # Sources
//!
//! S. A. Coons, *Surfaces for Computer-Aided Design of Space Forms*, 1967; J. C. Ferguson, *Multivariable curve
//! interpolation*, 1964; J. A. Gregory, *Smooth interpolation without twist constraints*, 1974; G. Farin, *Curves and
//! Surfaces for CAGD*, 5th edition, 2002, chapter 22.
//!
//! *In the course*: slides 8 to 12, "Patches de Coons" (*surface réglée*, *vecteur torsion*).
//!
//! *In the book*: [Coons patches](../../../coons.html).

mod bicubic;
mod bilinear;
mod boundary;
mod ferguson;
mod hermite;

pub use bicubic::{BicubicPatch, bicubic_partials, bicubic_point};
pub use bilinear::{CoonsPatch, bilinear_partials, bilinear_point, ruled_surfaces};
pub use boundary::{Boundary, CoonsError, Corner, Corners};
pub use ferguson::FergusonPatch;
pub use hermite::{
    CrossDerivatives, HermiteBoundary, Twists, hermite_basis, hermite_basis_derivative,
};
