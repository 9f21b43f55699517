//! A trimmed surface: what lies in a closed polygon of the parameter plane.

use std::collections::HashSet;

use super::bounds::{BoundedSurface, Bounds, Break};
use super::finish::{Tessellation, lifted};
use super::parameters::{Classes, ParameterMesh, Triangle};
use super::refine::{Bending, Conforming, Edge, Whole, sides};
use super::stitch::{usable, vertex_number};
use super::{Goal, TessellationError, VERTEX_LIMIT, check_tolerance, intervals};
use crate::algebra::{Real, Scalar, Vector3};
use crate::bspline::TrimmedSurface;
use crate::mesh::ears;

/// Triangles that stay within `tolerance` of a trimmed surface.
///
/// The sides of its polygon are cut as often as their own bound asks, so that the surface's points on them, too, are followed within the
/// tolerance; the polygon's corners stay as they are. How well the polygon follows the trimming curve was decided when the
/// trimmed surface was made.
///
/// # Accuracy
///
/// As [`tessellate`](super::tessellate).
///
/// # Errors
///
/// As [`tessellate`](super::tessellate), and [`TessellationError::Polygon`] where rounding hides how the loop's polygon is cut; at most
/// [`VERTEX_LIMIT`] vertices are made.
///
/// # Edge cases
///
/// Where the surface closes, the two sides of its seam are not joined.
///
/// # Cost
///
/// O(n²) for the n corners of the polygon.
///
/// # Source
///
/// The triangles of the polygon: Meisters 1975.
///
/// # Examples
///
/// ```
/// use facette::bspline::{BsplineSurface, KnotVector, RationalCurve, TrimmedSurface};
/// use facette::tessellation::tessellate_trimmed;
///
/// let square = [[0., 0., 0.], [1., 0., 0.], [0., 1., 0.], [1., 1., 0.]];
/// let flat = BsplineSurface::new([KnotVector::bezier(1), KnotVector::bezier(1)], square.to_vec())?;
/// let corners = [[0., 0.], [1., 0.], [0.25, 0.25], [0., 1.], [0., 0.]];
/// let outline = RationalCurve::new(KnotVector::clamped_uniform(1, 5)?, &corners, &[1.0; 5])?;
/// let trimmed = TrimmedSurface::new(flat, outline, 1e-6)?;
/// assert_eq!(tessellate_trimmed(&trimmed, 0.01)?.mesh.face_count(), 2);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn tessellate_trimmed<T>(
    trimmed: &TrimmedSurface<T>,
    tolerance: T::Scalar,
) -> Result<Tessellation<T::Point>, TessellationError<T::Scalar>>
where
    T: BoundedSurface,
    T::Point: Vector3,
    T::Scalar: Real,
{
    check_tolerance(tolerance)?;
    let surface = trimmed.surface();
    let lines = intervals(surface)?;
    let goal = Goal {
        tolerance,
        vertex_limit: VERTEX_LIMIT,
    };
    let mut vertices = trimmed.polygon().to_vec();
    let triangles = triangles_of(&vertices)?;
    let mut mesh = Conforming::new(&mut vertices, triangles, goal);
    cut_into_pieces(&mut mesh, &lines)?;
    let bounds = surface.second_derivative_bounds();
    let whole = whole_pieces(&lines, &bounds, goal)?;
    let columns = vertex_number(lines[0].len() - 1);
    let bending = Bending {
        bounds: &bounds,
        of_pieces: &|[column, row]| whole[(row * columns + column) as usize],
    };
    let frozen = cut_boundary(&mut mesh, &bending, tolerance)?;
    let all = (0..vertex_number(mesh.triangles.len())).collect();
    mesh.refine(all, &frozen, &bending)?;
    let triangles = mesh.triangles;
    let parameters = ParameterMesh {
        vertices,
        triangles,
        same: Classes::default(),
    };
    lifted(surface, &parameters, goal)
}

/// The triangles of a polygon, refused where they do not fill it; of which pieces they are is not known yet.
fn triangles_of<S: Scalar>(polygon: &[[S; 2]]) -> Result<Vec<Triangle>, TessellationError<S>> {
    let ears = ears(polygon);
    let [corners, triangles] = [polygon.len(), ears.len()];
    if triangles + 2 < corners {
        return Err(TessellationError::Polygon { corners, triangles });
    }
    let piece = [0; 2];
    let triangles = ears.into_iter().map(|corners| Triangle { corners, piece });
    Ok(triangles.collect())
}

/// Cuts the triangles along the inner lines, until each lies in one piece.
fn cut_into_pieces<S: Scalar>(
    mesh: &mut Conforming<'_, S>,
    lines: &[Vec<Break<S>>; 2],
) -> Result<(), TessellationError<S>> {
    for direction in [0, 1] {
        for line in &lines[direction][1..lines[direction].len() - 1] {
            cut_along(mesh, direction, line.at)?;
        }
    }
    for index in 0..mesh.triangles.len() {
        let points = mesh.points(vertex_number(index));
        mesh.triangles[index].piece = piece_of(lines, points);
    }
    Ok(())
}

/// Cuts every edge that crosses a parameter line at its point on it.
fn cut_along<S: Scalar>(
    mesh: &mut Conforming<'_, S>,
    direction: usize,
    line: S,
) -> Result<(), TessellationError<S>> {
    let mut waiting: Vec<u32> = (0..vertex_number(mesh.triangles.len())).collect();
    while let Some(triangle) = waiting.pop() {
        let corners = mesh.triangles[triangle as usize].corners;
        for cut in sides(corners) {
            let [a, b] = cut.map(|vertex| mesh.vertices[vertex as usize]);
            let [before, after] = [a[direction], b[direction]];
            let is_crossed = (before < line && line < after) || (after < line && line < before);
            if is_crossed {
                let t = (line - before) / (after - before);
                let across = 1 - direction;
                let mut at = [line; 2];
                at[across] = a[across] * (S::one() - t) + b[across] * t;
                waiting.extend(mesh.split_edge(cut, at)?);
                break;
            }
        }
    }
    Ok(())
}

/// What is known of each piece, row by row.
fn whole_pieces<S: Real>(
    [us, vs]: &[Vec<Break<S>>; 2],
    bounds: &Bounds<'_, S>,
    goal: Goal<S>,
) -> Result<Vec<Whole<S>>, TessellationError<S>> {
    let mut pieces = Vec::new();
    for v in vs.windows(2) {
        for u in us.windows(2) {
            let rectangle = [[u[0].at, u[1].at], [v[0].at, v[1].at]];
            let on_piece = usable(bounds(rectangle), rectangle)?;
            let whole = Whole::new(on_piece, rectangle, goal.tolerance);
            let (whole, _) = whole.ok_or_else(|| goal.too_many())?;
            pieces.push(whole);
        }
    }
    Ok(pieces)
}

/// The piece between whose lines a triangle lies.
fn piece_of<S: Scalar>(lines: &[Vec<Break<S>>; 2], points: [[S; 2]; 3]) -> [u32; 2] {
    [0, 1].map(|direction| {
        let third = S::ratio(1, 3);
        let centre = points
            .iter()
            .fold(S::zero(), |sum, point| sum + point[direction] * third);
        let inner = &lines[direction][1..lines[direction].len() - 1];
        vertex_number(inner.partition_point(|line| line.at <= centre))
    })
}

/// Cuts the edges of the boundary until each keeps to half the tolerance by its own bound; returns them all.
fn cut_boundary<S: Scalar>(
    mesh: &mut Conforming<'_, S>,
    bending: &Bending<'_, S>,
    tolerance: S,
) -> Result<HashSet<Edge>, TessellationError<S>> {
    let mut waiting: Vec<u32> = (0..vertex_number(mesh.triangles.len())).collect();
    let mut frozen = HashSet::new();
    let half = tolerance * S::ratio(1, 2);
    while let Some(triangle) = waiting.pop() {
        let Triangle { corners, piece } = mesh.triangles[triangle as usize];
        for side in sides(corners) {
            let is_boundary = mesh
                .neighbours
                .get(&side)
                .is_some_and(|both| both.contains(&u32::MAX));
            if !is_boundary {
                continue;
            }
            let ends = side.map(|vertex| mesh.vertices[vertex as usize]);
            if bending.fits(piece, &ends, half)? {
                frozen.insert(side);
            } else {
                waiting.extend(mesh.bisect(side)?);
                break;
            }
        }
    }
    Ok(frozen)
}
