//! How far the mesh of a level is from the limit, at most: from its second differences.
//!
//! Take each level as a surface over the control mesh: bilinear over every quadrilateral, linear over every triangle. Two levels differ at the new
//! points only, where the difference is a *second difference* of the coarser one. Let M be the largest second difference. A step multiplies it by
//! ρ at most, which depends on the valences, and the next level is within β M. So the limit is within
//!
//! ```text
//! β M (1 + ρ + ρ² + ...) = β M / (1 − ρ),     after k steps   ρᵏ β M / (1 − ρ)
//! ```
//!
//! The second differences are: across an inner edge v–q, for quadrilaterals a + b − 2v at both ends, with a and b the neighbours of v on either
//! side of q; for triangles v + q − a − b with the vertices a and b opposite to the edge; along a boundary a + b − 2v, with the neighbours along
//! it. The boundary's own shrink to a quarter in a step and are kept apart, as B.
//!
//! # Sources
//!
//! F. Cheng, G. Chen, J. Yong, *Subdivision depth computation for extra-ordinary Catmull-Clark subdivision surfaces*, 2006 (ρ of Catmull-Clark,
//! which is derived anew here, with boundaries); the other constants are derived in the book.

use num_traits::Zero;

use crate::algebra::{Real, Scalar, VectorSpace, larger};
use crate::subdivision::connectivity::index_of;
use crate::subdivision::mask::count;
use crate::subdivision::mask::{loop_vertex_weight, turn_cosine};
use crate::subdivision::{Connectivity, Corners, SubdivisionError};

/// What bounds the distance of the levels of a mesh from their limit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DistanceBound<S> {
    /// M, the largest second difference across an edge, as the largest absolute value of a coordinate.
    pub inside: S,
    /// B, the largest second difference along the boundary.
    pub boundary: S,
    /// ρ, by which M shrinks in a step at least.
    pub rate: S,
    /// How much of B is added to M in a step.
    pub coupling: S,
    /// β, how much of M the next level differs by at most.
    pub step: S,
}

impl<S: Scalar> DistanceBound<S> {
    /// The bound for these M and B with the worst constants of all vertices.
    fn over(
        connectivity: &Connectivity,
        [inside, boundary]: [S; 2],
        constants: impl Fn(usize, bool) -> Constants<S>,
    ) -> Self {
        let vertices = 0..index_of(connectivity.vertex_count());
        let of_all = vertices.map(|vertex| {
            let faces = connectivity.around(vertex).count();
            constants(faces, connectivity.is_boundary_vertex(vertex))
        });
        let start = [S::ratio(1, 4), S::zero(), S::ratio(1, 8)];
        let [rate, coupling, step] = of_all.fold(start, |worst, constants| {
            [0, 1, 2].map(|k| larger(worst[k], constants[k]))
        });
        Self {
            inside,
            boundary,
            rate,
            coupling,
            step,
        }
    }

    /// The bound on the distance of level `level` from the limit.
    ///
    /// It bounds every coordinate of the difference between points with the same parameters, and so also the distance of every vertex from its
    /// own limit, and the Hausdorff distance in the largest-coordinate norm.
    pub fn after(&self, level: u32) -> S {
        let (mut inside, mut boundary) = (self.inside, self.boundary);
        let quarter = S::ratio(1, 4);
        for _ in 0..level {
            inside = self.rate * inside + self.coupling * boundary;
            boundary = boundary * quarter;
        }
        // All further levels: Σ B = 4/3 B, and Σ M = (M + coupling Σ B)/(1 − ρ).
        let boundaries = boundary * S::ratio(4, 3);
        let insides = (inside + self.coupling * boundaries) / (S::one() - self.rate);
        self.step * insides + boundaries / S::from_i32(8)
    }

    /// The first level that is within `tolerance` of the limit, or `None` if that is not one of the first `most`.
    pub fn level_within(&self, tolerance: S, most: u32) -> Option<u32> {
        (0..=most).find(|&level| self.after(level) <= tolerance)
    }
}

/// The bound for Catmull-Clark on a mesh of quadrilaterals.
///
/// # Errors
///
/// [`SubdivisionError::PointCount`]; [`SubdivisionError::NotAQuadrilateral`]: a mesh with other faces is one of quadrilaterals after its first
/// step, of which this is then the bound.
///
/// # Cost
///
/// Linear in the number of half-edges.
pub fn catmull_clark_distance_bound<P: VectorSpace>(
    connectivity: &Connectivity,
    points: &[P],
    corners: Corners,
) -> Result<DistanceBound<P::Scalar>, SubdivisionError> {
    must_be_quadrilaterals(connectivity)?;
    connectivity.must_have_points(points.len())?;
    let at = |vertex: u32| points[vertex as usize];
    let across = (0..index_of(connectivity.half_edge_count())).filter_map(|h| {
        let twin = connectivity.twin(h)?;
        let [left, right] = [connectivity.previous(h), connectivity.next(twin)];
        let [left, right] = [connectivity.origin(left), connectivity.target(right)];
        let v = at(connectivity.origin(h));
        Some(at(left).minus(v).plus(at(right).minus(v)))
    });
    let inside = largest(across);
    let boundary = boundary_differences(connectivity, points, corners);
    Ok(DistanceBound::over(
        connectivity,
        [inside, boundary],
        quadrilaterals,
    ))
}

/// The bound for Loop's scheme.
///
/// # Errors
///
/// [`SubdivisionError::NotATriangle`], [`SubdivisionError::PointCount`].
///
/// # Cost
///
/// Linear in the number of half-edges.
pub fn loop_distance_bound<P: VectorSpace>(
    connectivity: &Connectivity,
    points: &[P],
    corners: Corners,
) -> Result<DistanceBound<P::Scalar>, SubdivisionError>
where
    P::Scalar: Real,
{
    connectivity.must_be_triangles()?;
    connectivity.must_have_points(points.len())?;
    let at = |vertex: u32| points[vertex as usize];
    let across = (0..index_of(connectivity.edge_count())).filter_map(|edge| {
        let h = connectivity.half_edge_of(edge);
        let twin = connectivity.twin(h)?;
        let [v, q] = [connectivity.origin(h), connectivity.target(h)].map(at);
        let [a, b] = [h, twin].map(|h| at(connectivity.origin(connectivity.previous(h))));
        Some(v.minus(a).plus(q.minus(b)))
    });
    let inside = largest(across);
    let boundary = boundary_differences(connectivity, points, corners);
    Ok(DistanceBound::over(
        connectivity,
        [inside, boundary],
        triangles,
    ))
}

/// What a vertex contributes: ρ, the share of B, and β.
type Constants<S> = [S; 3];

/// The constants of a vertex with `n` quadrilaterals.
///
/// With xₖ the neighbours less the vertex, sₖ = xₖ₋₁ + xₖ₊₁ at the vertex and uₖ the like at the other end of edge k, a step makes of them
/// ½sₖ + (sₖ₋₁ + sₖ₊₁ + uₖ₋₁ + uₖ₊₁)/16 − (7Σs + Σu)/4n² across the edges of the vertex, and at the edge points, along the edge, the sum
/// over both ends of (7Σs + Σu)/8n² − sₖ/8. Other second differences shrink to a quarter. At n = 4 so do these. On a boundary (7Σs + Σu)/8n²
/// is b/8, with its own second difference b.
fn quadrilaterals<S: Scalar>(n: usize, is_on_boundary: bool) -> Constants<S> {
    let quarter = S::ratio(1, 4);
    match (n, is_on_boundary) {
        (0, _) | (4, false) => [quarter, S::zero(), quarter],
        // Two faces that share both their edges at the vertex: neighbours k − 1 and k + 1 are one.
        (2, false) => [S::ratio(3, 4), S::zero(), S::ratio(1, 2)],
        (1 | 2, true) => [quarter, quarter, S::ratio(1, 8)],
        (3, true) => [S::ratio(5, 8), quarter, S::ratio(1, 8)],
        (_, true) => [S::ratio(3, 4), quarter, S::ratio(1, 8)],
        (_, false) => irregular_quadrilaterals(count(n)),
    }
}

fn irregular_quadrilaterals<S: Scalar>(n: S) -> Constants<S> {
    let [one, two, three, four, seven] = [1, 2, 3, 4, 7].map(S::from_i32);
    let [half, eighth, sixteenth] = [2, 8, 16].map(|parts| S::ratio(1, parts));
    let of_u = one / (four * n * n);
    let of_s = seven * of_u;
    let around = (half - of_s).magnitude()
        + two * (sixteenth - of_s).magnitude()
        + (n - three) * of_s
        + two * (sixteenth - of_u).magnitude()
        + (n - two) * of_u;
    let end = (eighth - half * of_s).magnitude() + (n - one) * half * of_s + n * half * of_u;
    [
        larger(around, two * larger(end, eighth)),
        S::zero(),
        larger(one / n, eighth),
    ]
}

/// The constants of a vertex with `n` triangles.
///
/// With xₖ the neighbours less the vertex, sₖ = xₖ − xₖ₋₁ − xₖ₊₁ and w = (1 − α)/n, a step makes of them 3/8 sₖ + (sₖ₋₁ + sₖ₊₁)/8 − wΣs on the
/// edges of the vertex, and t/8 − (sₖ + sₖ₊₁)/8 + wΣs on the third side of its triangle k, with t the one on the side opposite. At n = 6 the
/// identities between the sₖ leave a quarter of both. On a boundary −wΣs is b/8, with its own second difference b.
fn triangles<S: Real>(n: usize, is_on_boundary: bool) -> Constants<S> {
    let [quarter, eighth] = [S::ratio(1, 4), S::ratio(1, 8)];
    match (n, is_on_boundary) {
        (0, _) => [quarter, S::zero(), eighth],
        (1 | 3, true) => [quarter, eighth, eighth],
        (2, true) => [S::ratio(3, 8), eighth, eighth],
        (_, true) => [S::ratio(5, 8), eighth, eighth],
        (6, false) => [quarter, S::zero(), S::ratio(3, 8)],
        (_, false) => {
            let others = S::one() - loop_vertex_weight(turn_cosine(1, n));
            let [two, three] = [2, 3].map(S::from_i32);
            let w = others / count(n);
            let from_eighth = (eighth - w).magnitude();
            let at_vertex =
                (S::ratio(3, 8) - w).magnitude() + two * from_eighth + (count::<S>(n) - three) * w;
            let beside = eighth + two * from_eighth + (count::<S>(n) - two) * w;
            [larger(at_vertex, beside), S::zero(), larger(others, eighth)]
        }
    }
}

/// B: the largest a + b − 2v over the boundary vertices v that are not kept, with a and b before and after them.
fn boundary_differences<P: VectorSpace>(
    connectivity: &Connectivity,
    points: &[P],
    corners: Corners,
) -> P::Scalar {
    let vertices = 0..index_of(connectivity.vertex_count());
    largest(vertices.filter_map(|vertex| {
        let [before, after] = connectivity.boundary_neighbours(vertex)?;
        let is_kept = corners == Corners::Sharp && connectivity.is_corner(vertex, 1);
        let [a, v, b] = [before, vertex, after].map(|vertex| points[vertex as usize]);
        (!is_kept).then(|| a.minus(v).plus(b.minus(v)))
    }))
}

fn must_be_quadrilaterals(connectivity: &Connectivity) -> Result<(), SubdivisionError> {
    let mut faces = 0..index_of(connectivity.face_count());
    let corners_of = |face| connectivity.half_edges_of(face).len();
    match faces.find(|&face| corners_of(face) != 4) {
        None => Ok(()),
        Some(face) => Err(SubdivisionError::NotAQuadrilateral {
            face: face as usize,
            found: corners_of(face),
        }),
    }
}

/// The largest absolute value of a coordinate.
fn largest<P: VectorSpace>(vectors: impl Iterator<Item = P>) -> P::Scalar {
    let sizes = vectors.map(VectorSpace::largest_coordinate);
    sizes.fold(P::Scalar::zero(), larger)
}
