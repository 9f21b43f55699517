//! Limits of Catmull-Clark.
//!
//! One mask serves for faces of any number of corners. Written with the faces' centroids it is the composite of the first step, after which
//! all faces are quadrilaterals, with the mask for quadrilaterals: with the vertex v, n neighbours e and n centroids c,
//!
//! ```text
//! position   (n(n−1) v + 2 Σ e + 4 Σ c) / n(n+5)
//! tangents   Σ cos(2πk/n) (A/(4+A) eₖ + cₖ₋₁ + cₖ),  likewise with sines,   A = 16λ − 4
//! ```

use num_traits::{One, Zero};

use super::eigenvalues::catmull_clark_ring_eigenvalue;
use super::ring::{Place, Ring, sum, weighted_sum};
use super::turn::Spokes;
use super::{Limit, turn_point};
use crate::algebra::{Real, Scalar, VectorSpace};
use crate::subdivision::connectivity::index_of;
use crate::subdivision::mask::count;
use crate::subdivision::{Connectivity, Corners, SubdivisionError};

/// Where the vertices lie on the limit surface of Catmull-Clark. The weights are rational: the answer is exact over a field.
///
/// # Errors
///
/// [`SubdivisionError::PointCount`].
///
/// # Accuracy
///
/// For a vertex of valence n in faces of at most m corners within 6(n + m + 5)/(n + 5) u times the largest coordinate difference to a corner of
/// its faces, and u of the position's own coordinate (tested as `limits_are_as_accurate_as_they_say`).
///
/// # Cost
///
/// Linear in the number of corners of the faces around all vertices.
pub fn catmull_clark_limit_positions<P: VectorSpace>(
    connectivity: &Connectivity,
    points: &[P],
    corners: Corners,
) -> Result<Vec<P>, SubdivisionError> {
    connectivity.must_have_points(points.len())?;
    let vertices = 0..index_of(connectivity.vertex_count());
    Ok(vertices
        .map(|vertex| position(&Ring::new(connectivity, points, vertex, corners)))
        .collect())
}

/// Position and tangents of the limit surface of Catmull-Clark at every vertex.
///
/// # Accuracy
///
/// Positions as [`catmull_clark_limit_positions`]; tangents at inner vertices within 2(n + m + 40)u times the largest coordinate difference to
/// a corner of the faces, wherever the mesh lies (tested as `limits_are_as_accurate_as_they_say`).
///
/// # Edge cases
///
/// A boundary vertex with a single face: its two sides are the tangents where corners are sharp. Where they are smooth, the tangent plane is
/// the osculating plane of the boundary curve, and the refined mesh's normals approach it as slowly as 1 over the number of steps. A boundary
/// vertex with four faces or more has no tangent plane in general (see the book); the tangents are then the boundary's, and the direction
/// that the inside approaches slowest. A vertex in two faces that share both its edges has none.
///
/// # Errors
///
/// [`SubdivisionError::PointCount`].
///
/// # Examples
///
/// ```
/// use facette::mesh::Mesh;
/// use facette::subdivision::{Connectivity, Corners, limit::catmull_clark_limits};
///
/// let corner = |i: u32| [i & 1, i >> 1 & 1, i >> 2].map(f64::from);
/// let faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
/// let cube = Mesh::new((0..8).map(corner).collect(), faces)?;
/// let connectivity = Connectivity::new(&cube)?;
/// let limits = catmull_clark_limits(&connectivity, &cube.positions, Corners::Sharp)?;
/// assert_eq!(limits[0].position, [0.25; 3]);
/// assert!(limits[0].normal().unwrap()[0] < -0.577);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn catmull_clark_limits<P: VectorSpace>(
    connectivity: &Connectivity,
    points: &[P],
    corners: Corners,
) -> Result<Vec<Limit<P>>, SubdivisionError>
where
    P::Scalar: Real,
{
    catmull_clark_limits_with(connectivity, points, corners, turn_point, Real::sqrt)
}

/// [`catmull_clark_limits`] with the points of the circle and the square root handed in: over a field that lacks some, exact where it has them.
///
/// `circle(k, n)` is the point after k of n parts of a turn. All sines may have a common factor for each n: the tangents
/// that are made with sines get it too.
///
/// # Errors
///
/// [`SubdivisionError::PointCount`].
pub fn catmull_clark_limits_with<P: VectorSpace>(
    connectivity: &Connectivity,
    points: &[P],
    corners: Corners,
    circle: impl Fn(usize, usize) -> [P::Scalar; 2],
    root: impl Fn(P::Scalar) -> P::Scalar,
) -> Result<Vec<Limit<P>>, SubdivisionError> {
    connectivity.must_have_points(points.len())?;
    let mut spokes = Spokes::new(circle);
    let limits = Ring::of_each(connectivity, points, corners, |ring| Limit {
        position: position(ring),
        tangents: ring.tangents(|| tangents(ring, spokes.of(ring.parts_of_turn()), &root)),
    });
    Ok(limits)
}

// ANCHOR: position
fn position<P: VectorSpace>(ring: &Ring<P>) -> P {
    if ring.place != Place::Interior {
        return ring.position_off_the_interior();
    }
    let n = count::<P::Scalar>(ring.face_count());
    let [two, four, five] = [2, 4, 5].map(P::Scalar::from_i32);
    let offsets = sum(ring.centroids.iter().copied()).times(four);
    let offsets = offsets.plus(ring.neighbour_sum().times(two));
    ring.centre
        .plus(offsets.times(P::Scalar::one() / (n * (n + five))))
}
// ANCHOR_END: position

/// The tangents where at least two faces are around: the mode of one turn, and on a boundary of half a turn.
fn tangents<P: VectorSpace>(
    ring: &Ring<P>,
    spokes: &[[P::Scalar; 2]],
    root: impl Fn(P::Scalar) -> P::Scalar,
) -> [P; 2] {
    let [one, two, four, sixteen] = [1, 2, 4, 16].map(P::Scalar::from_i32);
    let cosine = spokes[1][0];
    let lambda = catmull_clark_ring_eigenvalue(cosine, root);
    let a = sixteen * lambda - four;
    // The tangent of the regular star is n/2 (A + 2 + 2 cos) times a unit vector.
    let scale = two * four / (count::<P::Scalar>(spokes.len()) * (a + two + two * cosine));
    let mode = |axis: usize| {
        let wave = |k: usize| spokes[k % spokes.len()][axis];
        let at_edges = weighted_sum((0..).map(wave), &ring.neighbours).times(a / (a + four));
        let at_faces = weighted_sum((0..).map(|k| wave(k) + wave(k + 1)), &ring.centroids);
        at_edges.plus(at_faces).times(scale)
    };
    if ring.place == Place::Interior {
        return [mode(0), mode(1)];
    }
    // Half a turn of sines, which vanish at both ends, is a mode of the inside alone; the ends' weights make it one of the whole.
    let sine = spokes[1][1];
    let half = ring.face_count();
    let sines = spokes[..half].iter().map(|point| point[1]);
    let sines = sines.fold(P::Scalar::zero(), |sum, sine| sum + sine);
    let at_ends = (sine - (a / two + one) * sines) / a;
    let [first, last] = ring.ends();
    let ends = first.plus(last).times(at_ends * scale);
    // Only half of the star is there: its tangent is half as long.
    [ring.tangent_along(), mode(1).plus(ends).times(two)]
}
