//! A triangle with one extraordinary vertex, and the points that its surface depends on.
//!
//! ```text
//!          a4 --- a3
//!         /  \   /  \          the face is (centre, q0, q1), q0 along s, q1 along t
//!       q2 --- q1 --- a2       q2, q3, ... go on around the vertex, anticlockwise
//!         \   /  \   /  \
//!        centre - q0 --- a1
//!             \  /  \   /
//!             q-1 --- a0
//! ```

use num_traits::One;

use super::adaptive::Corner;
use super::bicubic::{midpoint, smoothed};
use super::box_spline::{PLACES, bezier_points};
use crate::algebra::{Scalar, VectorSpace};
use crate::subdivision::connectivity::index_of;
use crate::subdivision::mask::count;

/// The ring around an extraordinary vertex, and the five points beyond it that one of its faces needs.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct TriangleCorner<P: VectorSpace> {
    /// Whether the faces go all around the vertex.
    pub is_closed: bool,
    /// Loop's weight of the vertex in its own new position, where the ring is closed.
    pub vertex_weight: P::Scalar,
    /// Which of the faces around the vertex is meant.
    pub sector: usize,
    /// The vertex.
    pub centre: P,
    /// Its neighbours, anticlockwise: as many as faces, or one more where the ring is open.
    pub ring: Vec<P>,
    /// The points a0 ... a4.
    pub outer: [P; 5],
}

/// Points at whole steps along q0 and q1 from the vertex, each from −1 on: `[j + 1][i + 1]`.
type Lattice<P, const N: usize> = [[P; N]; N];

impl<P: VectorSpace> TriangleCorner<P> {
    /// How many faces there are around the vertex.
    pub fn face_count(&self) -> usize {
        self.ring.len() - usize::from(!self.is_closed)
    }

    /// The neighbour `steps` after the face's first; there must be one.
    fn neighbour(&self, steps: isize) -> P {
        let count = self.ring.len();
        self.ring[(self.sector + count).wrapping_add_signed(steps) % count]
    }

    fn starts_at_boundary(&self) -> bool {
        !self.is_closed && self.sector == 0
    }

    fn ends_at_boundary(&self) -> bool {
        !self.is_closed && self.sector + 1 == self.face_count()
    }

    /// The points around the face. What lies across a boundary makes a parallelogram with what is inside; places that none of the face's regular
    /// patches needs are filled with the vertex.
    fn lattice(&self) -> Lattice<P, 4> {
        let (v, [q0, q1]) = (self.centre, [self.neighbour(0), self.neighbour(1)]);
        let before = if self.starts_at_boundary() {
            across(v, q0, q1)
        } else {
            self.neighbour(-1)
        };
        let after = if self.ends_at_boundary() {
            across(v, q1, q0)
        } else {
            self.neighbour(2)
        };
        let [a0, a1, a2, a3, a4] = self.outer;
        [
            [v, v, before, a0],
            [v, v, q0, a1],
            [after, q1, a2, v],
            [a4, a3, v, v],
        ]
    }

    /// The point of the finer lattice at (i, j) half-steps, for the places that regular patches need.
    fn fine_point(&self, coarse: &Lattice<P, 4>, [i, j]: [isize; 2]) -> P {
        match [i, j] {
            [0, 0] => self.refined_centre(),
            [1, -1] if self.starts_at_boundary() => {
                let [v, q0, q1] = self.fine_triangle(coarse);
                across(v, q0, q1)
            }
            [-1, 1] if self.ends_at_boundary() => {
                let [v, q0, q1] = self.fine_triangle(coarse);
                across(v, q1, q0)
            }
            [1, -1] => self.refined_edge(self.sector + self.ring.len() - 1),
            [-1, 1] => self.refined_edge(self.sector + 2),
            _ => regular_point(coarse, [i, j]),
        }
    }

    fn fine_triangle(&self, coarse: &Lattice<P, 4>) -> [P; 3] {
        [[0, 0], [1, 0], [0, 1]].map(|place| self.fine_point(coarse, place))
    }

    /// The vertex point of the centre.
    // ANCHOR: centre
    fn refined_centre(&self) -> P {
        let v = self.centre;
        if let (false, [first, .., last]) = (self.is_closed, &self.ring[..]) {
            return smoothed(*first, v, *last);
        }
        let rest = P::Scalar::one() - self.vertex_weight;
        v.plus(self.mean_offset().times(rest))
    }
    // ANCHOR_END: centre

    /// How far the mean of the neighbours is from the centre.
    pub fn mean_offset(&self) -> P {
        let offsets = self.ring.iter().map(|point| point.minus(self.centre));
        let sum = offsets.fold(P::origin(), P::plus);
        sum.times(P::Scalar::one() / count(self.ring.len()))
    }

    /// The edge point of the edge of this number, counted around and around where the ring is closed.
    fn refined_edge(&self, number: usize) -> P {
        let neighbours = self.ring.len();
        let k = number % neighbours;
        let (v, q) = (self.centre, self.ring[k]);
        if !self.is_closed && (k == 0 || k + 1 == neighbours) {
            return midpoint(v, q);
        }
        let [before, after] = [k + neighbours - 1, k + 1].map(|k| self.ring[k % neighbours]);
        edge_point([v, q], [before, after])
    }

    /// The faces around the vertex as a mesh, which the vertex is the first of.
    pub fn fan(&self) -> (Vec<P>, Vec<[u32; 3]>) {
        let mut points = vec![self.centre];
        points.extend(&self.ring);
        let neighbours = index_of(self.ring.len());
        let faces = 0..index_of(self.face_count());
        let faces = faces.map(|k| [0, 1 + k, 1 + (k + 1) % neighbours]);
        (points, faces.collect())
    }
}

impl<P: VectorSpace> Corner<P, 15> for TriangleCorner<P> {
    fn closed_valence(&self) -> Option<usize> {
        self.is_closed.then_some(self.ring.len())
    }

    // ANCHOR: limit
    fn limit(&self) -> P {
        let v = self.centre;
        if let (false, [first, .., last]) = (self.is_closed, &self.ring[..]) {
            let towards = midpoint(*first, *last).minus(v);
            return v.plus(towards.times(P::Scalar::ratio(1, 3)));
        }
        // (3v + 8(1 - α)q)/(3 + 8(1 - α)), with the mean q.
        let rest = (P::Scalar::one() - self.vertex_weight) * P::Scalar::from_i32(8);
        let weight = rest / (P::Scalar::from_i32(3) + rest);
        v.plus(self.mean_offset().times(weight))
    }
    // ANCHOR_END: limit

    fn refined(&self) -> Self {
        let coarse = self.lattice();
        let outer = [[2, -1], [2, 0], [1, 1], [0, 2], [-1, 2]];
        Self {
            centre: self.refined_centre(),
            ring: (0..self.ring.len()).map(|k| self.refined_edge(k)).collect(),
            outer: outer.map(|place| regular_point(&coarse, place)),
            ..*self
        }
    }

    fn mapped(mut self, map: impl Fn(P) -> P) -> Self {
        self.centre = map(self.centre);
        for point in self.ring.iter_mut().chain(&mut self.outer) {
            *point = map(*point);
        }
        self
    }

    fn net(&self, part: usize) -> [P; 15] {
        let coarse = self.lattice();
        let ([x, y], step) = [([1, 0], 1), ([1, 1], -1), ([0, 1], 1)][part];
        let place = |[i, j]: [isize; 2]| [x + step * i, y + step * j];
        bezier_points(&PLACES.map(|offset| self.fine_point(&coarse, place(offset))))
    }
}

/// The fourth corner of the parallelogram with the side from `a` to `b` and `c` opposite: what makes a boundary row a cubic B-spline.
pub(super) fn across<P: VectorSpace>(a: P, b: P, c: P) -> P {
    a.plus(b.minus(c))
}

/// Loop's edge point: from the ends of the edge, and the vertices across the two triangles beside it.
fn edge_point<P: VectorSpace>(ends: [P; 2], beside: [P; 2]) -> P {
    let [three, one] = [3, 1].map(|eighths| P::Scalar::ratio(eighths, 8));
    let ends = ends[0].plus(ends[1]).times(three);
    ends.plus(beside[0].plus(beside[1]).times(one))
}

/// The point at (i, j) half-steps of a regular lattice.
fn regular_point<P: VectorSpace>(coarse: &Lattice<P, 4>, [i, j]: [isize; 2]) -> P {
    let at = |[i, j]: [isize; 2]| coarse[(j + 1).unsigned_abs()][(i + 1).unsigned_abs()];
    let [x, y] = [i.div_euclid(2), j.div_euclid(2)];
    match [i.rem_euclid(2), j.rem_euclid(2)] {
        [0, 0] => {
            let around = [[1, 0], [0, 1], [-1, 1], [-1, 0], [0, -1], [1, -1]];
            let around = around.map(|[dx, dy]| at([x + dx, y + dy]));
            let sum = around.into_iter().fold(P::origin(), P::plus);
            let own = at([x, y]).times(P::Scalar::ratio(5, 8));
            own.plus(sum.times(P::Scalar::ratio(1, 16)))
        }
        [1, 0] => edge_point(
            [at([x, y]), at([x + 1, y])],
            [at([x + 1, y - 1]), at([x, y + 1])],
        ),
        [0, _] => edge_point(
            [at([x, y]), at([x, y + 1])],
            [at([x + 1, y]), at([x - 1, y + 1])],
        ),
        _ => edge_point(
            [at([x + 1, y]), at([x, y + 1])],
            [at([x, y]), at([x + 1, y + 1])],
        ),
    }
}
