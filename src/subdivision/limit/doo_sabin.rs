//! Limits of Doo-Sabin: every face shrinks to a point of the surface, its centroid, whichever weights are used.
//!
//! The new corners of a face are means of its old corners that are the same for each corner, turned: a circulant matrix. Its eigenvectors are
//! the waves around the face, so the tangents are its waves of one turn.

use num_traits::One;

use super::ring::{sum, weighted_sum};
use super::turn::Spokes;
use super::{Limit, turn_point};
use crate::algebra::{Real, Scalar, VectorSpace};
use crate::subdivision::connectivity::index_of;
use crate::subdivision::mask::count;
use crate::subdivision::{Connectivity, SubdivisionError};

/// Position and tangents of the limit surface of Doo-Sabin in the middle of every face.
///
/// Both kinds of weights have these limits, and a boundary does not change them. After one step every vertex and edge is a face, so that the
/// limits in its middle are had from [`doo_sabin`](crate::subdivision::doo_sabin)'s mesh. The tangents of a regular polygon with corners on the unit
/// circle are (1, 0) and (0, 1).
///
/// # Errors
///
/// [`SubdivisionError::PointCount`].
///
/// # Accuracy
///
/// For a face of n corners within (n + 4)u times the largest coordinate difference to its first corner, and u of the position's own coordinate.
///
/// # Examples
///
/// ```
/// use facette::mesh::Mesh;
/// use facette::subdivision::{Connectivity, limit::doo_sabin_limits};
///
/// let square = Mesh::new(vec![[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [2.0, 2.0, 0.0], [0.0, 2.0, 0.0]], [[0, 1, 2, 3]])?;
/// let limits = doo_sabin_limits(&Connectivity::new(&square)?, &square.positions)?;
/// assert_eq!(limits[0].position, [1.0, 1.0, 0.0]);
/// assert_eq!(limits[0].normal(), Some([0.0, 0.0, 1.0]));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn doo_sabin_limits<P: VectorSpace>(
    connectivity: &Connectivity,
    points: &[P],
) -> Result<Vec<Limit<P>>, SubdivisionError>
where
    P::Scalar: Real,
{
    doo_sabin_limits_with(connectivity, points, turn_point)
}

/// [`doo_sabin_limits`] with the points of the circle handed in: exact over a field that has them.
///
/// `circle(k, n)` is the point after k of n parts of a turn.
///
/// # Errors
///
/// [`SubdivisionError::PointCount`].
// ANCHOR: limits
pub fn doo_sabin_limits_with<P: VectorSpace>(
    connectivity: &Connectivity,
    points: &[P],
    circle: impl Fn(usize, usize) -> [P::Scalar; 2],
) -> Result<Vec<Limit<P>>, SubdivisionError> {
    connectivity.must_have_points(points.len())?;
    let mut spokes = Spokes::new(circle);
    let faces = 0..index_of(connectivity.face_count());
    Ok(faces
        .map(|face| {
            let vertices = connectivity.vertices_of(face);
            let first = points[vertices[0] as usize];
            let offset = |&vertex: &u32| points[vertex as usize].minus(first);
            let offsets: Vec<P> = vertices.iter().map(offset).collect();
            let spokes = spokes.of(offsets.len());
            let share = P::Scalar::one() / count(offsets.len());
            let wave = |axis: usize| {
                let waves = spokes.iter().map(|point| point[axis]);
                weighted_sum(waves, &offsets).times(share * P::Scalar::from_i32(2))
            };
            Limit {
                position: first.plus(sum(offsets.iter().copied()).times(share)),
                tangents: Some([wave(0), wave(1)]),
            }
        })
        .collect())
}
// ANCHOR_END: limits
