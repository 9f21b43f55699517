//! The boundary as a curve of its own: who comes before and after a boundary vertex, and the cubic rule for it.
//!
//! *In the course*: slide 78, "Cas des frontières"; the curve's rule is on slide 63.

use super::{Connectivity, Corners};
use crate::algebra::{Scalar, VectorSpace};
use num_traits::{One, Zero};

impl Connectivity {
    /// The vertices before and after a boundary vertex along the boundary, with the faces on the left; `None` for other vertices.
    pub fn boundary_neighbours(&self, vertex: u32) -> Option<[u32; 2]> {
        if !self.is_boundary_vertex(vertex) {
            return None;
        }
        let first = self.outgoing(vertex)?;
        let last = self.around(vertex).last()?;
        Some([self.origin(self.previous(last)), self.target(first)])
    }

    /// The other ends of a vertex's edges, anticlockwise; at a boundary vertex from the one after it along the boundary to the one before.
    pub fn neighbours(&self, vertex: u32) -> impl Iterator<Item = u32> {
        let last = self.boundary_neighbours(vertex).map(|[before, _]| before);
        self.around(vertex).map(|h| self.target(h)).chain(last)
    }

    /// Whether a vertex is on the boundary and has at most `faces` faces.
    pub(super) fn is_corner(&self, vertex: u32, faces: usize) -> bool {
        self.is_boundary_vertex(vertex) && self.around(vertex).nth(faces).is_none()
    }
}

/// The midpoint of two points, the same for both orders.
pub(super) fn midpoint<P: VectorSpace>(a: P, b: P) -> P {
    a.lerp(b, P::Scalar::ratio(1, 2))
}

/// The mean of the points less `base`: added to `base`, it loses no digit to a far origin.
pub(super) fn mean_offset<P: VectorSpace>(base: P, points: impl Iterator<Item = P>) -> P {
    let (mut sum, mut count) = (P::origin(), P::Scalar::zero());
    for point in points {
        sum = sum.plus(point.minus(base));
        count = count + P::Scalar::one();
    }
    sum.times(P::Scalar::one() / count)
}

// ANCHOR: boundary_vertex
/// The new position of a vertex on the boundary by the cubic curve's mask (1, 6, 1)/8; `None` for other vertices.
pub(super) fn boundary_vertex_point<P: VectorSpace>(
    connectivity: &Connectivity,
    points: &[P],
    vertex: u32,
    corners: Corners,
) -> Option<P> {
    let [before, after] = connectivity.boundary_neighbours(vertex)?;
    let [a, p, b] = [before, vertex, after].map(|vertex| points[vertex as usize]);
    if corners == Corners::Sharp && connectivity.is_corner(vertex, 1) {
        return Some(p);
    }
    let offset = a.minus(p).plus(b.minus(p));
    Some(p.plus(offset.times(P::Scalar::ratio(1, 8))))
}
// ANCHOR_END: boundary_vertex
