//! B-splines: curves and surfaces made of polynomial pieces that join as smoothly as their knots say.
//!
//! One polynomial through many control points wiggles, and feels every one of them everywhere. A B-spline cuts the
//! parameter line at *knots* and blends `p + 1` control points on each span, so that a point moved here changes nothing
//! there:
//!
//! ```text
//! C(u) = Σ Nᵢᵖ(u) Pᵢ                            S(u,v) = ΣΣ Nᵢᵖ(u) Nⱼᵠ(v) Pᵢⱼ
//!
//! Nᵢ⁰(u) = 1 on [uᵢ, uᵢ₊₁), else 0              Nᵢᵖ(u) =   u − uᵢ     Nᵢᵖ⁻¹(u) +  uᵢ₊ₚ₊₁ − u   Nᵢ₊₁ᵖ⁻¹(u)
//!                                                        uᵢ₊ₚ − uᵢ               uᵢ₊ₚ₊₁ − uᵢ₊₁
//! ```
//!
//! # Conventions
//!
//! Degree `p`, control points `P₀ … Pₙ`, knots `u₀ <= … <= u_r` with `r = n + p + 1`; the domain is `[uₚ, uₙ₊₁]`. Spans are
//! half-open, so that at a knot the piece after it counts; the last one is closed. Outside the domain the first or the last
//! polynomial goes on. A net is stored row by row, u (the index i) running fastest: `Pᵢⱼ = points[j (n + 1) + i]`.
//!
//! # Numerics
//!
//! Every weight is a ratio `(u − a) / (b − a)` of two differences of stored numbers, taken before anything is multiplied:
//! knots that nearly coincide, far from 0 or denormal, do no harm. All values of the basis are sums of non-negative terms and
//! come out with a small relative error. Derivatives take the differences of control points first and combine afterwards,
//! so that a surface far from the origin keeps its tangents.
//!
//! # Sources
//!
//! C. de Boor, *On calculating with B-splines*, 1972; M. G. Cox, *The numerical evaluation of B-splines*, 1972; W. Boehm,
//! *Inserting new knots into B-spline curves*, 1980; E. Cohen, T. Lyche, R. Riesenfeld, *Discrete B-splines and subdivision
//! techniques*, 1980; L. Ramshaw, *Blossoming*, 1987; L. Piegl, W. Tiller, *The NURBS Book*, 2nd edition, 1997.
//!
//! *In the course*: slides 13 to 31, "Surfaces B-splines" (*séquence nodale*, *fonctions de forme*, *carreau*).
//!
//! *In the book*: [B-splines](../../../bspline.html).

mod basis;
mod batch;
mod curve;
mod error;
mod knots;
mod net;
mod normal;
mod periodic;
mod rational;
mod refine;
mod surface;
mod trimmed;

pub use basis::{basis_derivatives, basis_functions, cox_de_boor, find_span};
pub use batch::SurfaceEvaluator;
pub(crate) use curve::piece_blossom;
pub use curve::{BezierPiece, BsplineCurve, blossom, curve_point, de_boor_point};
pub use error::{BsplineError, Direction};
pub use knots::KnotVector;
pub use net::BezierPatch;
pub use periodic::{Closing, PeriodicError, PeriodicSurface, closed_surface};
pub use rational::{Homogeneous, RationalCurve, RationalError, RationalSurface, circle, sphere};
pub use refine::insert_knot;
pub use surface::{BsplineSurface, surface_point};
pub use trimmed::{Place, TrimError, TrimmedSurface};
