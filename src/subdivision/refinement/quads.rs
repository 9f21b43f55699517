//! How the points of refined quadrilaterals are numbered, and the faces between them.

use super::super::Connectivity;
use super::index_of;
use super::patches::{LANES, grouped};

/// A mesh of quadrilaterals, each of which is cut into `side` x `side`.
///
/// Points are numbered: vertices; then the inside of each edge, from the origin of its first half-edge; then the inside of each face, row
/// by row. Where faces are cut into few pieces, `LANES` of them take turns: the first inner point of each, the second of each, and so on.
#[derive(Clone, Debug)]
pub(super) struct QuadNumbering {
    pub(super) connectivity: Connectivity,
    /// Into how many pieces an edge is cut.
    pub(super) side: u32,
    /// The first edge whose first half-edge is in each face, and the number of edges: edges are numbered like their first half-edges, so that
    /// those that a face owns follow each other.
    owned_edges: Vec<u32>,
}

/// Numbers of points in a row: those of its ends, and an arithmetic progression between them.
#[derive(Clone, Copy, Debug)]
pub(super) struct Line {
    pub(super) left: u32,
    pub(super) inner: Progression,
    pub(super) right: u32,
}

/// The numbers `first + step · t` for t = 0, 1, ..., modulo 2³².
#[derive(Clone, Copy, Debug)]
pub(super) struct Progression {
    pub(super) first: u32,
    pub(super) step: u32,
}

impl Progression {
    pub(super) fn at(self, t: u32) -> u32 {
        self.first.wrapping_add(self.step.wrapping_mul(t))
    }

    pub(super) fn ascending(first: u32) -> Self {
        Self { first, step: 1 }
    }

    /// The first `count` terms from the last to the first.
    pub(super) fn reversed(self, count: u32) -> Self {
        Self {
            first: self.at(count.wrapping_sub(1)),
            step: self.step.wrapping_neg(),
        }
    }
}

impl QuadNumbering {
    pub(super) fn new(connectivity: Connectivity, side: u32) -> Self {
        let faces = 0..index_of(connectivity.face_count());
        let mut owned_edges = vec![0];
        let mut count = 0;
        for face in faces {
            let owned = connectivity.half_edges_of(face).filter(|&h| {
                let edge = connectivity.edge_of(h);
                connectivity.half_edge_of(edge) == h
            });
            count += index_of(owned.count());
            owned_edges.push(count);
        }
        Self {
            connectivity,
            side,
            owned_edges,
        }
    }

    /// How many points there are.
    pub(super) fn vertex_count(&self) -> usize {
        self.connectivity.vertex_count()
            + self.connectivity.edge_count() * self.edge_size()
            + self.connectivity.face_count() * self.face_size()
    }

    /// How many quadrilaterals a face is cut into.
    pub(super) fn quads_per_face(&self) -> usize {
        self.side as usize * self.side as usize
    }

    /// How many quadrilaterals there are.
    pub(super) fn quad_count(&self) -> usize {
        self.connectivity.face_count() * self.quads_per_face()
    }

    /// The number of a point in a face's grid.
    pub(super) fn vertex(&self, face: u32, row: u32, column: u32) -> u32 {
        let line = self.frame(face).line(row);
        match column {
            0 => line.left,
            last if last >= self.side => line.right,
            _ => line.inner.at(column - 1),
        }
    }

    /// How many points there are inside an edge.
    pub(super) fn edge_size(&self) -> usize {
        self.side as usize - 1
    }

    /// How many points there are inside a face.
    pub(super) fn face_size(&self) -> usize {
        self.edge_size() * self.edge_size()
    }

    /// The edges that a face owns.
    pub(super) fn owned_by(&self, face: usize) -> std::ops::Range<usize> {
        self.owned_edges[face] as usize..self.owned_edges[face + 1] as usize
    }

    /// How many of the faces are numbered in groups.
    pub(super) fn grouped(&self) -> usize {
        grouped(self.connectivity.face_count(), self.side)
    }

    /// The points inside the edges that the faces from `first` on own, side by side.
    pub(super) fn sides<'a, P, const SIDES: usize, const LANES: usize>(
        &self,
        first: usize,
        mut owned: &'a mut [P],
    ) -> [[Option<&'a mut [P]>; SIDES]; LANES] {
        std::array::from_fn(|lane| {
            let face = index_of(first + lane);
            let h = self.connectivity.half_edges_of(face).start;
            std::array::from_fn(|side| {
                let side = index_of(side);
                let edge = self.connectivity.edge_of(h + side);
                let is_owned = self.connectivity.half_edge_of(edge) == h + side;
                is_owned
                    .then(|| owned.split_off_mut(..self.edge_size()))
                    .flatten()
            })
        })
    }

    pub(super) fn bytes(&self) -> usize {
        self.owned_edges.capacity() * size_of::<u32>() + super::bytes_of(&self.connectivity)
    }

    /// The points inside the edge of a half-edge, in its direction.
    pub(super) fn along(&self, half_edge: u32) -> Progression {
        let edge = self.connectivity.edge_of(half_edge);
        let before = index_of(self.connectivity.vertex_count());
        let inside = self.side - 1;
        let forwards = Progression::ascending(before + edge * inside);
        if self.connectivity.half_edge_of(edge) == half_edge {
            forwards
        } else {
            forwards.reversed(inside)
        }
    }

    /// The frame of a face's grid. Columns run along the face's first half-edge, rows from there to the opposite side.
    // ANCHOR: frame
    fn frame(&self, face: u32) -> Frame {
        let h = self.connectivity.half_edges_of(face).start;
        let edges = self.connectivity.edge_count() * self.edge_size();
        let before = self.connectivity.vertex_count() + edges;
        let face = face as usize;
        let (start, step) = if face < self.grouped() {
            let lane = face % LANES;
            ((face - lane) * self.face_size() + lane, LANES)
        } else {
            (face * self.face_size(), 1)
        };
        Frame {
            corners: [0, 1, 2, 3].map(|k| self.connectivity.origin(h + k)),
            sides: [0, 1, 2, 3].map(|k| self.along(h + k)),
            inside: Progression {
                first: index_of(before + start),
                step: index_of(step),
            },
            side: self.side,
        }
    }
    // ANCHOR_END: frame

    /// Writes the `side` x `side` quadrilaterals of a face, row by row.
    pub(super) fn write_faces(&self, face: u32, out: &mut [[u32; 4]]) {
        let frame = self.frame(face);
        let mut low = frame.line(0);
        for (row, quads) in (1..).zip(out.chunks_exact_mut(self.side as usize)) {
            let high = frame.line(row);
            write_row(low, high, quads);
            low = high;
        }
    }
}

/// The numbers of the points around a face's grid and inside.
#[derive(Clone, Copy, Debug)]
struct Frame {
    corners: [u32; 4],
    /// The insides of the sides, in the face's direction.
    sides: [Progression; 4],
    /// Row by row.
    inside: Progression,
    side: u32,
}

impl Frame {
    /// The numbers of the points in a row, from 0 to `side`.
    // ANCHOR: line
    fn line(&self, row: u32) -> Line {
        let inside = self.side - 1;
        let [south_west, south_east, north_east, north_west] = self.corners;
        let [south, east, north, west] = self.sides;
        if row == 0 {
            Line {
                left: south_west,
                inner: south,
                right: south_east,
            }
        } else if row >= self.side {
            Line {
                left: north_west,
                inner: north.reversed(inside),
                right: north_east,
            }
        } else {
            Line {
                left: west.at(inside - row),
                inner: Progression {
                    first: self.inside.at((row - 1) * inside),
                    ..self.inside
                },
                right: east.at(row - 1),
            }
        }
    }
    // ANCHOR_END: line
}

/// The quadrilaterals between two lines.
// ANCHOR: faces
fn write_row(low: Line, high: Line, quads: &mut [[u32; 4]]) {
    match quads {
        [] => {}
        [only] => *only = [low.left, low.right, high.right, high.left],
        [first, middle @ .., last] => {
            let (a, b) = (low.inner, high.inner);
            *first = [low.left, a.first, b.first, high.left];
            for (t, quad) in (0..).zip(&mut *middle) {
                *quad = [a.at(t), a.at(t + 1), b.at(t + 1), b.at(t)];
            }
            let end = index_of(middle.len());
            *last = [a.at(end), low.right, high.right, b.at(end)];
        }
    }
}
// ANCHOR_END: faces
