//! A quadrilateral with one extraordinary vertex, and the points that its surface depends on.
//!
//! ```text
//!   a6 - a5 --- a4 --- a3        the face is (centre, e0, f0, e1), e0 along s, e1 along t
//!    |    |      |      |        e2, f1, ... go on around the vertex, anticlockwise
//!   f1 - e1 --- f0 --- a2
//!    |    |      |      |
//!   e2 - centre - e0 - a1
//!          |      |      |
//!         e-1 -- f-1 -- a0
//! ```

use num_traits::One;

use super::adaptive::Corner;
use super::bicubic::{midpoint, reflected, smoothed};
use crate::algebra::{Scalar, VectorSpace};
use crate::subdivision::connectivity::index_of;
use crate::subdivision::mask::count;

/// Points in rows: `grid[y][x]`, x along s.
type Grid<P, const N: usize> = [[P; N]; N];

/// The ring around an extraordinary vertex, and the seven points beyond it that one of its faces needs.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct QuadCorner<P> {
    /// Whether the faces go all around the vertex.
    pub is_closed: bool,
    /// Which of the faces around the vertex is meant.
    pub sector: usize,
    /// The vertex.
    pub centre: P,
    /// The other ends of its edges, anticlockwise: as many as faces, or one more where the ring is open.
    pub edges: Vec<P>,
    /// The points across its faces.
    pub faces: Vec<P>,
    /// The points a0 ... a6.
    pub outer: [P; 7],
}

impl<P: VectorSpace> QuadCorner<P> {
    /// The 4 × 4 points around the face. What lies across a boundary is reflected; the point `[0][0]`, of which there may be none or several,
    /// is not to be used.
    fn grid(&self) -> Grid<P, 4> {
        let (v, [e0, e1]) = (self.centre, [self.edge(0), self.edge(1)]);
        let f0 = self.faces[self.sector];
        let count = self.faces.len();
        let [before, after] = [self.sector + count - 1, self.sector + 1].map(|k| k % count);
        let [below_v, below_e0] = if self.starts_at_boundary() {
            [reflected(e1, v), reflected(f0, e0)]
        } else {
            [self.edge(-1), self.faces[before]]
        };
        let [left_of_v, left_of_e1] = if self.ends_at_boundary() {
            [reflected(e0, v), reflected(f0, e1)]
        } else {
            [self.edge(2), self.faces[after]]
        };
        let [a0, a1, a2, a3, a4, a5, a6] = self.outer;
        [
            [v, below_v, below_e0, a0],
            [left_of_v, v, e0, a1],
            [left_of_e1, e1, f0, a2],
            [a6, a5, a4, a3],
        ]
    }

    /// The end of the edge `steps` after the face's first; there must be one.
    fn edge(&self, steps: isize) -> P {
        let count = self.edges.len();
        self.edges[(self.sector + count).wrapping_add_signed(steps) % count]
    }

    fn starts_at_boundary(&self) -> bool {
        !self.is_closed && self.sector == 0
    }

    fn ends_at_boundary(&self) -> bool {
        !self.is_closed && self.sector + 1 == self.faces.len()
    }

    /// The 5 × 5 points around the corner after one step; `[0][0]` is not to be used.
    fn fine_grid(&self) -> Grid<P, 5> {
        let mut fine = refined_grid(&self.grid());
        // Three of these are not as on a regular grid.
        fine[1][1] = self.refined_centre();
        fine[0][1] = if self.starts_at_boundary() {
            reflected(fine[2][1], fine[1][1])
        } else {
            self.refined_edge(self.sector + self.edges.len() - 1)
        };
        fine[1][0] = if self.ends_at_boundary() {
            reflected(fine[1][2], fine[1][1])
        } else {
            self.refined_edge(self.sector + 2)
        };
        fine
    }

    /// The vertex point of the centre.
    // ANCHOR: centre
    fn refined_centre(&self) -> P {
        let v = self.centre;
        if let (false, [first, .., last]) = (self.is_closed, &self.edges[..]) {
            return smoothed(*first, v, *last);
        }
        // (Q + 2R + (n - 3)S)/n, with Q = (v + 2e + f)/4 and R = (v + e)/2 of the means e and f.
        let [e, f] = self.mean_offsets();
        let weight = |quarters| P::Scalar::ratio(quarters, 4) / count(self.edges.len());
        v.plus(e.times(weight(6))).plus(f.times(weight(1)))
    }
    // ANCHOR_END: centre

    /// How far the mean of the edges' ends, and that of the points across the faces, are from the centre.
    pub fn mean_offsets(&self) -> [P; 2] {
        [&self.edges, &self.faces].map(|points| {
            let offsets = points.iter().map(|point| point.minus(self.centre));
            let sum = offsets.fold(P::origin(), P::plus);
            sum.times(P::Scalar::one() / count(points.len()))
        })
    }

    /// The faces around the vertex as a mesh, which the vertex is the first of.
    pub fn fan(&self) -> (Vec<P>, Vec<[u32; 4]>) {
        let mut points = vec![self.centre];
        points.extend(self.edges.iter().chain(&self.faces));
        let [edges, faces] = [&self.edges, &self.faces].map(|points| index_of(points.len()));
        let face = |k| [0, 1 + k, 1 + edges + k, 1 + (k + 1) % edges];
        (points, (0..faces).map(face).collect())
    }

    /// The edge point of the edge of this number, counted around and around where the ring is closed.
    fn refined_edge(&self, number: usize) -> P {
        let (edges, faces) = (self.edges.len(), self.faces.len());
        let k = number % edges;
        let (v, e) = (self.centre, self.edges[k]);
        if !self.is_closed && (k == 0 || k + 1 == edges) {
            return midpoint(v, e);
        }
        let [e_before, e_after] = [k + edges - 1, k + 1].map(|k| self.edges[k % edges]);
        let [f_before, f_after] = [k + faces - 1, k].map(|k| self.faces[k % faces]);
        let beside = e_before.plus(e_after).plus(f_before.plus(f_after));
        let sixteenth = P::Scalar::ratio(1, 16);
        v.plus(e)
            .times(P::Scalar::ratio(3, 8))
            .plus(beside.times(sixteenth))
    }

    /// The face point of the face of this number.
    fn refined_face(&self, number: usize) -> P {
        let next = (number + 1) % self.edges.len();
        let sides = self.edges[number].plus(self.edges[next]);
        let sum = self.centre.plus(self.faces[number]).plus(sides);
        sum.times(P::Scalar::ratio(1, 4))
    }
}

impl<P: VectorSpace> Corner<P, 16> for QuadCorner<P> {
    fn closed_valence(&self) -> Option<usize> {
        self.is_closed.then_some(self.faces.len())
    }

    // ANCHOR: limit
    fn limit(&self) -> P {
        let v = self.centre;
        if let (false, [first, .., last]) = (self.is_closed, &self.edges[..]) {
            let across = midpoint(*first, *last).minus(v);
            return v.plus(across.times(P::Scalar::ratio(1, 3)));
        }
        // (n v + 4e + f)/(n + 5), with the means e and f.
        let [e, f] = self.mean_offsets();
        let sum = e.times(P::Scalar::from_i32(4)).plus(f);
        v.plus(sum.times(P::Scalar::one() / count(self.edges.len() + 5)))
    }
    // ANCHOR_END: limit

    fn refined(&self) -> Self {
        let fine = self.fine_grid();
        Self {
            is_closed: self.is_closed,
            sector: self.sector,
            centre: fine[1][1],
            edges: (0..self.edges.len())
                .map(|k| self.refined_edge(k))
                .collect(),
            faces: (0..self.faces.len())
                .map(|k| self.refined_face(k))
                .collect(),
            outer: [
                fine[0][3], fine[1][3], fine[2][3], fine[3][3], fine[3][2], fine[3][1], fine[3][0],
            ],
        }
    }

    fn mapped(mut self, map: impl Fn(P) -> P) -> Self {
        self.centre = map(self.centre);
        let points = self.edges.iter_mut().chain(&mut self.faces);
        for point in points.chain(&mut self.outer) {
            *point = map(*point);
        }
        self
    }

    fn net(&self, part: usize) -> [P; 16] {
        let fine = self.fine_grid();
        let [right, up] = [[1, 0], [1, 1], [0, 1]][part];
        std::array::from_fn(|index| fine[up + index / 4][right + index % 4])
    }
}

/// The points of a regular grid after one step, those that a 4 × 4 grid determines.
fn refined_grid<P: VectorSpace>(grid: &Grid<P, 4>) -> Grid<P, 5> {
    let rows = grid.map(refined_row);
    let columns: [[P; 5]; 5] =
        std::array::from_fn(|x| refined_row(std::array::from_fn(|y| rows[y][x])));
    std::array::from_fn(|y| std::array::from_fn(|x| columns[x][y]))
}

fn refined_row<P: VectorSpace>([a, b, c, d]: [P; 4]) -> [P; 5] {
    [
        midpoint(a, b),
        smoothed(a, b, c),
        midpoint(b, c),
        smoothed(b, c, d),
        midpoint(c, d),
    ]
}
