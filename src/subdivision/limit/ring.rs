//! The ring of a vertex: what its limit depends on, gathered as differences from the vertex.

use num_traits::One;

use crate::algebra::{Scalar, VectorSpace};
use crate::subdivision::connectivity::index_of;
use crate::subdivision::mask::count;
use crate::subdivision::{Connectivity, Corners};

/// How a vertex lies in its surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Place {
    /// No face visits it.
    Isolated,
    /// Faces all around it.
    Interior,
    /// On the boundary, and moved by the boundary's rule.
    Boundary,
    /// On the boundary with a single face, and kept.
    Corner,
}

/// The neighbours of a vertex and the centroids of its faces, as vectors from the vertex: no offset of the mesh is left in them.
///
/// # Shape
///
/// Anticlockwise; face number k lies between the neighbours k and k + 1. There are as many neighbours as faces in the interior, and one more
/// on a boundary, where the first and the last are the boundary's own.
pub(super) struct Ring<P: VectorSpace> {
    pub place: Place,
    pub centre: P,
    pub neighbours: Vec<P>,
    pub centroids: Vec<P>,
}

impl<P: VectorSpace> Ring<P> {
    /// The ring of a vertex; `points` has one for each vertex.
    pub fn new(connectivity: &Connectivity, points: &[P], vertex: u32, corners: Corners) -> Self {
        let centre = points[vertex as usize];
        let offset = |vertex: u32| points[vertex as usize].minus(centre);
        let centroid = |half_edge: u32| {
            let face = connectivity.vertices_of(connectivity.face_of(half_edge));
            let sum = sum(face.iter().map(|&vertex| offset(vertex)));
            sum.times(P::Scalar::one() / count(face.len()))
        };
        let neighbours = connectivity.neighbours(vertex).map(offset).collect();
        let centroids: Vec<P> = connectivity.around(vertex).map(centroid).collect();
        let is_boundary = connectivity.is_boundary_vertex(vertex);
        let place = match (centroids.len(), is_boundary, corners) {
            (0, ..) => Place::Isolated,
            (_, false, _) => Place::Interior,
            (1, true, Corners::Sharp) => Place::Corner,
            _ => Place::Boundary,
        };
        Self {
            place,
            centre,
            neighbours,
            centroids,
        }
    }

    /// What `of` makes of the ring of every vertex.
    pub fn of_each<T>(
        connectivity: &Connectivity,
        points: &[P],
        corners: Corners,
        mut of: impl FnMut(&Self) -> T,
    ) -> Vec<T> {
        let vertices = 0..index_of(connectivity.vertex_count());
        vertices
            .map(|vertex| of(&Self::new(connectivity, points, vertex, corners)))
            .collect()
    }

    /// The tangents: those of the inside's modes, `by_modes`, where at least two faces are around. `None` for a vertex that has none.
    pub fn tangents(&self, by_modes: impl FnOnce() -> [P; 2]) -> Option<[P; 2]> {
        match (self.place, self.face_count()) {
            (Place::Isolated, _) | (Place::Interior, ..3) => None,
            (_, 1) => Some(self.tangents_of_one_face()),
            _ => Some(by_modes()),
        }
    }

    /// How many faces are around the vertex.
    pub fn face_count(&self) -> usize {
        self.centroids.len()
    }

    /// Into how many equal parts the masks divide a turn: the valence; on a boundary the faces take half a turn.
    pub fn parts_of_turn(&self) -> usize {
        match self.place {
            Place::Interior => self.face_count(),
            _ => 2 * self.face_count(),
        }
    }

    /// The sum of the neighbours.
    pub fn neighbour_sum(&self) -> P {
        sum(self.neighbours.iter().copied())
    }

    /// The first and the last neighbour: on a boundary the ones along it.
    pub fn ends(&self) -> [P; 2] {
        let end = |point: Option<&P>| point.copied().unwrap_or_else(P::origin);
        [end(self.neighbours.first()), end(self.neighbours.last())]
    }

    /// The limit position where the boundary's rule or none at all decides: the cubic curve's (1, 4, 1)/6.
    pub fn position_off_the_interior(&self) -> P {
        let [first, last] = self.ends();
        match self.place {
            Place::Boundary => {
                let sixth = P::Scalar::ratio(1, 6);
                self.centre.plus(first.plus(last).times(sixth))
            }
            _ => self.centre,
        }
    }

    /// The tangents where no mode of the inside is asked: the sides of a kept corner; and at a rounded one the boundary's tangent and its
    /// second difference, which span the osculating plane.
    fn tangents_of_one_face(&self) -> [P; 2] {
        let [first, last] = self.ends();
        match self.place {
            Place::Corner => [first, last],
            _ => [self.tangent_along(), first.plus(last)],
        }
    }

    /// The tangent of the boundary curve, half the way from the last neighbour to the first.
    pub fn tangent_along(&self) -> P {
        let [first, last] = self.ends();
        first.minus(last).times(P::Scalar::ratio(1, 2))
    }
}

/// The sum of vectors, added from the left.
pub(super) fn sum<P: VectorSpace>(points: impl IntoIterator<Item = P>) -> P {
    points.into_iter().fold(P::origin(), P::plus)
}

/// The sum of multiples, added from the left.
pub(super) fn weighted_sum<P: VectorSpace>(
    weights: impl IntoIterator<Item = P::Scalar>,
    points: &[P],
) -> P {
    sum(weights
        .into_iter()
        .zip(points)
        .map(|(weight, point)| point.times(weight)))
}
