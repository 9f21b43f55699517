//! Limits of Loop's scheme and of √3: schemes on triangles, whose masks differ in a weight or two.
//!
//! ```text
//! position   v + κ (m − v)         m the mean of the n neighbours q
//!            Loop: κ = 8(1−α)/(11−8α), α the vertex's own weight;   √3: κ = 3α/(1+3α), α the weight of m
//! tangents   2/n Σ cos(2πk/n) qₖ,  2/n Σ sin(2πk/n) qₖ
//! ```

use num_traits::{One, Zero};

use super::ring::{Place, Ring, weighted_sum};
use super::turn::Spokes;
use super::{Limit, turn_point};
use crate::algebra::{Real, Scalar, VectorSpace};
use crate::subdivision::mask::count;
use crate::subdivision::mask::{loop_vertex_weight, sqrt3_neighbours_weight, turn_cosine};
use crate::subdivision::{Connectivity, Corners, SubdivisionError};

/// Where the vertices lie on Loop's limit surface.
///
/// # Errors
///
/// [`SubdivisionError::NotATriangle`], [`SubdivisionError::PointCount`].
///
/// # Accuracy
///
/// For a vertex of valence n within 0.63 (n + 15)u times the largest coordinate difference to a neighbour, and u of the position's own
/// coordinate (tested as `limits_are_as_accurate_as_they_say`).
pub fn loop_limit_positions<P: VectorSpace>(
    connectivity: &Connectivity,
    points: &[P],
    corners: Corners,
) -> Result<Vec<P>, SubdivisionError>
where
    P::Scalar: Real,
{
    let share = |cosine| loop_share(cosine);
    positions(connectivity, points, corners, share)
}

/// Position and tangents of Loop's limit surface at every vertex.
///
/// # Edge cases
///
/// A boundary vertex with a single triangle: its two sides are the tangents where corners are sharp; where they are smooth, the tangent plane
/// is the osculating plane of the boundary curve. A boundary vertex with six triangles or more has no tangent plane in general (see the
/// book); the tangents are then the boundary's, and the direction that the inside approaches slowest.
///
/// # Errors
///
/// [`SubdivisionError::NotATriangle`], [`SubdivisionError::PointCount`].
pub fn loop_limits<P: VectorSpace>(
    connectivity: &Connectivity,
    points: &[P],
    corners: Corners,
) -> Result<Vec<Limit<P>>, SubdivisionError>
where
    P::Scalar: Real,
{
    loop_limits_with(connectivity, points, corners, turn_point)
}

/// [`loop_limits`] with the points of the circle handed in: exact over a field that has them.
///
/// `circle(k, n)` is the point after k of n parts of a turn. All sines may have a common factor for each n: the tangents
/// that are made with sines get it too.
///
/// # Errors
///
/// [`SubdivisionError::NotATriangle`], [`SubdivisionError::PointCount`].
pub fn loop_limits_with<P: VectorSpace>(
    connectivity: &Connectivity,
    points: &[P],
    corners: Corners,
    circle: impl Fn(usize, usize) -> [P::Scalar; 2],
) -> Result<Vec<Limit<P>>, SubdivisionError> {
    let end_weight = |sine: P::Scalar, sines: P::Scalar| sine - sines;
    limits(
        connectivity,
        points,
        corners,
        circle,
        loop_share,
        end_weight,
    )
}

/// Where the vertices lie on the limit surface of √3, for a mesh as in [`sqrt3_limits`].
///
/// # Errors
///
/// [`SubdivisionError::NotATriangle`], [`SubdivisionError::PointCount`].
///
/// # Accuracy
///
/// As [`loop_limit_positions`].
pub fn sqrt3_limit_positions<P: VectorSpace>(
    connectivity: &Connectivity,
    points: &[P],
    corners: Corners,
) -> Result<Vec<P>, SubdivisionError>
where
    P::Scalar: Real,
{
    positions(connectivity, points, corners, sqrt3_share)
}

/// Position and tangents of the limit surface of √3 at every vertex of a control mesh.
///
/// The mesh must be one whose next step leaves the boundary as it is ([`Sqrt3Boundary::Kept`](crate::subdivision::Sqrt3Boundary::Kept)): the
/// control mesh, or what an even number of steps makes of it. A closed mesh may be any.
///
/// # Edge cases
///
/// As [`loop_limits`].
///
/// # Errors
///
/// [`SubdivisionError::NotATriangle`], [`SubdivisionError::PointCount`].
pub fn sqrt3_limits<P: VectorSpace>(
    connectivity: &Connectivity,
    points: &[P],
    corners: Corners,
) -> Result<Vec<Limit<P>>, SubdivisionError>
where
    P::Scalar: Real,
{
    sqrt3_limits_with(connectivity, points, corners, turn_point)
}

/// [`sqrt3_limits`] with the points of the circle handed in, as in [`loop_limits_with`].
///
/// # Errors
///
/// [`SubdivisionError::NotATriangle`], [`SubdivisionError::PointCount`].
pub fn sqrt3_limits_with<P: VectorSpace>(
    connectivity: &Connectivity,
    points: &[P],
    corners: Corners,
    circle: impl Fn(usize, usize) -> [P::Scalar; 2],
) -> Result<Vec<Limit<P>>, SubdivisionError> {
    let end_weight = |sine: P::Scalar, sines: P::Scalar| sine - sines * P::Scalar::ratio(4, 3);
    limits(
        connectivity,
        points,
        corners,
        circle,
        sqrt3_share,
        end_weight,
    )
}

/// How far Loop's limit is on the way from the vertex to the mean of its neighbours.
fn loop_share<S: Scalar>(cosine: S) -> S {
    let others = S::from_i32(8) * (S::one() - loop_vertex_weight(cosine));
    others / (S::from_i32(3) + others)
}

/// How far the limit of √3 is on the way from the vertex to the mean of its neighbours.
fn sqrt3_share<S: Scalar>(cosine: S) -> S {
    let thrice = S::from_i32(3) * sqrt3_neighbours_weight(cosine);
    thrice / (S::one() + thrice)
}

fn positions<P: VectorSpace>(
    connectivity: &Connectivity,
    points: &[P],
    corners: Corners,
    share: impl Fn(P::Scalar) -> P::Scalar,
) -> Result<Vec<P>, SubdivisionError>
where
    P::Scalar: Real,
{
    connectivity.must_be_triangles()?;
    connectivity.must_have_points(points.len())?;
    Ok(Ring::of_each(connectivity, points, corners, |ring| {
        position(ring, || share(turn_cosine(1, ring.face_count())))
    }))
}

fn limits<P: VectorSpace>(
    connectivity: &Connectivity,
    points: &[P],
    corners: Corners,
    circle: impl Fn(usize, usize) -> [P::Scalar; 2],
    share: impl Fn(P::Scalar) -> P::Scalar,
    end_weight: impl Fn(P::Scalar, P::Scalar) -> P::Scalar,
) -> Result<Vec<Limit<P>>, SubdivisionError> {
    connectivity.must_be_triangles()?;
    connectivity.must_have_points(points.len())?;
    let mut spokes = Spokes::new(circle);
    Ok(Ring::of_each(connectivity, points, corners, |ring| Limit {
        position: position(ring, || share(spokes.of(ring.face_count())[1][0])),
        tangents: ring.tangents(|| tangents(ring, spokes.of(ring.parts_of_turn()), &end_weight)),
    }))
}

/// The limit position; `share` is asked in the interior only.
// ANCHOR: position
fn position<P: VectorSpace>(ring: &Ring<P>, share: impl FnOnce() -> P::Scalar) -> P {
    if ring.place != Place::Interior {
        return ring.position_off_the_interior();
    }
    let n = count::<P::Scalar>(ring.face_count());
    ring.centre.plus(ring.neighbour_sum().times(share() / n))
}
// ANCHOR_END: position

/// The tangents where at least two triangles are around: the mode of one turn, and on a boundary of half a turn.
///
/// Half a turn of sines, which vanish at both ends, is a mode of the inside alone; the weight of the ends, `end_weight(sine, sum of the
/// sines)` over 1 + 2 cos, makes it one of the whole.
// ANCHOR: tangents
fn tangents<P: VectorSpace>(
    ring: &Ring<P>,
    spokes: &[[P::Scalar; 2]],
    end_weight: impl Fn(P::Scalar, P::Scalar) -> P::Scalar,
) -> [P; 2] {
    let two = P::Scalar::from_i32(2);
    let mode = |axis: usize| {
        let waves = (0..).map(|k: usize| spokes[k % spokes.len()][axis]);
        weighted_sum(waves, &ring.neighbours)
    };
    let scale = two / count(ring.face_count());
    if ring.place == Place::Interior {
        return [mode(0).times(scale), mode(1).times(scale)];
    }
    let sines = spokes[..ring.face_count()].iter().map(|point| point[1]);
    let sines = sines.fold(P::Scalar::zero(), |sum, sine| sum + sine);
    let [cosine, sine] = spokes[1];
    let at_ends = end_weight(sine, sines) / (P::Scalar::one() + two * cosine);
    let [first, last] = ring.ends();
    let inside = mode(1).plus(first.plus(last).times(at_ends));
    [ring.tangent_along(), inside.times(scale)]
}
// ANCHOR_END: tangents
