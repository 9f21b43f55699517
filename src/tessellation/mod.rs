//! Tessellation: any parametric surface cut into triangles that stay within a given distance of it.
//!
//! Pictures, collision tests and milling machines want triangles. A uniform grid either wastes them where the surface is flat or
//! misses the surface where it bends, and says nothing of by how much. Here a tolerance is given and kept, by a bound from
//! the second derivatives:
//!
//! ```text
//! |S(x) − Σ λᵢ S(xᵢ)| <= (l₁² M_uu + 2 l₁ l₂ M_uv + l₂² M_vv) / 8        x = Σ λᵢ xᵢ in a triangle x₁ x₂ x₃
//! ```
//!
//! for **every** triangle in a parameter box of sides `l₁ × l₂` in which the lengths of `S_uu`, `S_uv`, `S_vv` are at most `M_uu`,
//! `M_uv`, `M_vv`. *Proof.* By Taylor's theorem at `x`, with `dᵢ = xᵢ − x` and so `Σ λᵢ dᵢ = 0`, the left side is at most
//! `½ Σ λᵢ (M_uu aᵢ² + 2 M_uv |aᵢbᵢ| + M_vv bᵢ²)`, where `dᵢ = (aᵢ, bᵢ)`. `Σ λᵢ aᵢ²` is the variance of a distribution on an interval of
//! length `l₁`, so at most `l₁²/4`; likewise for `bᵢ`; and `Σ λᵢ |aᵢbᵢ| <= l₁l₂/4` by the inequality of Cauchy and Schwarz.
//!
//! # Conventions
//!
//! A surface is cut along its *breaks*, the parameter lines where it may be less than twice differentiable, into *pieces*.
//! How many points stand on the side of a piece depends on that side's own curve only, so that pieces, and surfaces
//! that share a boundary curve (the same control points, knots and direction), meet in the same bits. Triangles run anticlockwise as seen from where `S_u × S_v` points.
//!
//! # Numerics
//!
//! The tolerance bounds the distance between the triangle and the surface of the exact points; the vertices themselves carry the
//! rounding of [`Surface::point`](crate::surface::Surface::point). The bound is rounded up. Where the grids of the pieces alone have more vertices than
//! allowed, they are refused before any is made; where the refinement or the second normals on creases make them too many, as soon as they are.
//!
//! # Sources
//!
//! D. Filip, R. Magedson, R. Markot, *Surface algorithms using bounds on derivatives*, 1986 (right triangles); T. Popoviciu,
//! *Sur les équations algébriques ayant toutes leurs racines réelles*, 1935 (the variance); M.-C. Rivara, *New
//! longest-edge algorithms for the refinement and/or improvement of unstructured triangulations*, 1997; G. Meisters, *Polygons
//! have ears*, 1975 (trimmed surfaces).
//!
//! *In the course*: slide 48 (*discrétisation nécessaire pour l'affichage*).
//!
//! *In the book*: [Tessellation](../../../tessellation.html).

mod bounds;
mod bspline;
mod cells;
mod error;
mod finish;
mod parameters;
mod plan;
mod refine;
mod stitch;
mod trimmed;

pub use bounds::{Bounded, BoundedSurface, Bounds, Break, Continuity};
pub use cells::{cells_for, chord_error_bound, segments_for};
pub use error::TessellationError;
pub use finish::Tessellation;
pub use trimmed::tessellate_trimmed;

use crate::algebra::{Real, Scalar, Vector3};
use crate::bspline::Direction;

/// The vertices that [`tessellate`] allows: 2²⁴, about 2 GB of points, normals and triangles in double precision.
pub const VERTEX_LIMIT: u32 = 1 << 24;

/// Triangles that stay within `tolerance` (a distance in the unit of the points) of the surface, with a unit normal and the parameters at each
/// vertex.
///
/// # Accuracy
///
/// For every triangle and every point of it, the linear interpolation of its corners is within `tolerance` of the surface's point at the same
/// parameters, up to the rounding of the corners themselves (tested as `triangles_stay_within_the_tolerance`).
///
/// # Errors
///
/// [`TessellationError`] as its variants say; at most [`VERTEX_LIMIT`] vertices are made.
///
/// # Edge cases
///
/// A flat piece has two triangles. Where a side of a piece is collapsed to a point, triangles without area are left out. Where
/// the surface gives no normal, the vertex takes the mean of the triangles around it.
///
/// # Examples
///
/// ```
/// use facette::bspline::{BsplineSurface, KnotVector};
/// use facette::tessellation::tessellate;
///
/// let knots = [KnotVector::bezier(2), KnotVector::bezier(1)];
/// let arch = [[0., 0., 0.], [1., 0., 2.], [2., 0., 0.], [0., 1., 0.], [1., 1., 2.], [2., 1., 0.]];
/// let surface = BsplineSurface::new(knots, arch.to_vec())?;
/// let mesh = tessellate(&surface, 0.01)?.mesh;
/// // |S_uu| = 8: strips of width 1/n are right from 8 / (8 n²) <= 0.01/2 on, so n = 15.
/// assert_eq!((mesh.positions.len(), mesh.face_count()), (32, 30));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn tessellate<S>(
    surface: &S,
    tolerance: S::Scalar,
) -> Result<Tessellation<S::Point>, TessellationError<S::Scalar>>
where
    S: BoundedSurface,
    S::Point: Vector3,
    S::Scalar: Real,
{
    tessellate_within(surface, tolerance, VERTEX_LIMIT)
}

/// As [`tessellate`], with at most `vertex_limit` vertices in the mesh; a place on a crease or a seam counts as often as it has vertices.
///
/// # Errors
///
/// As [`tessellate`].
pub fn tessellate_within<S>(
    surface: &S,
    tolerance: S::Scalar,
    vertex_limit: u32,
) -> Result<Tessellation<S::Point>, TessellationError<S::Scalar>>
where
    S: BoundedSurface,
    S::Point: Vector3,
    S::Scalar: Real,
{
    check_tolerance(tolerance)?;
    let goal = Goal {
        tolerance,
        vertex_limit,
    };
    let parameters = plan::parameter_mesh(surface, goal)?;
    finish::lifted(surface, &parameters, goal)
}

/// What a tessellation shall keep to.
#[derive(Clone, Copy, Debug)]
struct Goal<S> {
    tolerance: S,
    vertex_limit: u32,
}

impl<S: Scalar> Goal<S> {
    fn too_many(self) -> TessellationError<S> {
        TessellationError::TooManyVertices {
            tolerance: self.tolerance,
            limit: self.vertex_limit,
        }
    }

    /// Refuses more vertices than allowed.
    fn check_count(self, vertices: u32) -> Result<(), TessellationError<S>> {
        if vertices <= self.vertex_limit {
            Ok(())
        } else {
            Err(self.too_many())
        }
    }
}

/// Refuses a tolerance that no triangle can keep, and one that is none.
fn check_tolerance<S: Scalar>(tolerance: S) -> Result<(), TessellationError<S>> {
    if tolerance > S::zero() && tolerance.is_finite() {
        Ok(())
    } else {
        Err(TessellationError::Tolerance { tolerance })
    }
}

/// The breaks in u and in v.
type Lines<S> = [Vec<Break<S>>; 2];

/// The lines between the pieces in both directions, checked.
fn intervals<S: BoundedSurface + ?Sized>(
    surface: &S,
) -> Result<Lines<S::Scalar>, TessellationError<S::Scalar>> {
    let breaks = surface.break_lines();
    let directions = [Direction::U, Direction::V].into_iter();
    for ((direction, list), domain) in directions.zip(&breaks).zip(surface.domain()) {
        let increases = list.windows(2).all(|pair| pair[0].at < pair[1].at);
        let [first, last] = [list.first(), list.last()].map(|end| end.map(|end| end.at));
        if list.len() < 2 || !increases || [first, last] != domain.map(Some) {
            return Err(TessellationError::Breaks {
                direction,
                breaks: list.iter().map(|line| line.at).collect(),
                domain,
            });
        }
    }
    Ok(breaks)
}
