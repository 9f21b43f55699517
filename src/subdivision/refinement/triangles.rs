//! How the points of refined triangles are numbered, and the faces between them.

use super::patches::{LANES, grouped};
use super::quads::{Line, Progression, QuadNumbering};
use super::{Connectivity, index_of};

/// A mesh of triangles, each of whose sides is cut into `side` pieces.
///
/// Points are numbered as in [`QuadNumbering`]: vertices, insides of edges, insides of faces, the latter row by row.
#[derive(Clone, Debug)]
pub(super) struct TriangleNumbering {
    /// The vertices and edges.
    pub(super) edges: QuadNumbering,
}

impl TriangleNumbering {
    pub(super) fn new(connectivity: Connectivity, side: u32) -> Self {
        Self {
            edges: QuadNumbering::new(connectivity, side),
        }
    }

    fn face_count(&self) -> usize {
        self.edges.connectivity.face_count()
    }

    /// How many points there are inside a face.
    pub(super) fn face_size(&self) -> usize {
        let inside = self.edges.edge_size();
        inside * inside.saturating_sub(1) / 2
    }

    /// How many of the faces are numbered in groups.
    pub(super) fn grouped(&self) -> usize {
        grouped(self.face_count(), self.edges.side)
    }

    /// How many points there are before the insides of faces.
    fn before(&self) -> usize {
        let connectivity = &self.edges.connectivity;
        connectivity.vertex_count() + connectivity.edge_count() * self.edges.edge_size()
    }

    /// How many points there are.
    pub(super) fn vertex_count(&self) -> usize {
        self.before() + self.face_count() * self.face_size()
    }

    /// How many triangles a face is cut into.
    pub(super) fn triangles_per_face(&self) -> usize {
        let side = self.edges.side as usize;
        side * side
    }

    /// The frame of a face's grid. Columns run along the face's first half-edge, rows towards the vertex opposite to it.
    fn frame(&self, face: u32) -> Frame {
        let h = self.edges.connectivity.half_edges_of(face).start;
        let face = face as usize;
        let (start, step) = if face < self.grouped() {
            let lane = face % LANES;
            ((face - lane) * self.face_size() + lane, LANES)
        } else {
            (face * self.face_size(), 1)
        };
        Frame {
            corners: [0, 1, 2].map(|k| self.edges.connectivity.origin(h + k)),
            sides: [0, 1, 2].map(|k| self.edges.along(h + k)),
            inside: Progression {
                first: index_of(self.before() + start),
                step: index_of(step),
            },
            side: self.edges.side,
        }
    }

    /// The number of a point in a face's grid: row and column together are at most `side`.
    pub(super) fn vertex(&self, face: u32, row: u32, column: u32) -> u32 {
        let frame = self.frame(face);
        if row >= frame.side {
            return frame.corners[2];
        }
        let line = frame.line(row);
        match column {
            0 => line.left,
            last if last >= frame.side - row => line.right,
            _ => line.inner.at(column - 1),
        }
    }

    /// Writes the `side²` triangles of a face, row by row: in each the upright ones, then those upside down between them.
    // ANCHOR: faces
    pub(super) fn write_faces(&self, face: u32, mut out: &mut [[u32; 3]]) {
        let frame = self.frame(face);
        for row in 0..frame.side {
            let upright = (frame.side - row) as usize;
            let Some(triangles) = out.split_off_mut(..2 * upright - 1) else {
                return;
            };
            let (up, down) = triangles.split_at_mut(upright);
            let low = frame.line(row);
            if upright == 1 {
                up[0] = [low.left, low.right, frame.corners[2]];
            } else {
                write_row(low, frame.line(row + 1), up, down);
            }
        }
    }
    // ANCHOR_END: faces
}

/// The triangles between a row and the next, which is not the last.
fn write_row(low: Line, high: Line, up: &mut [[u32; 3]], down: &mut [[u32; 3]]) {
    let (a, b) = (low.inner, high.inner);
    if let [first, middle @ .., last] = up {
        *first = [low.left, a.first, high.left];
        for (t, triangle) in (0..).zip(&mut *middle) {
            *triangle = [a.at(t), a.at(t + 1), b.at(t)];
        }
        *last = [a.at(index_of(middle.len())), low.right, high.right];
    }
    match down {
        [] => {}
        [only] => *only = [a.first, high.right, high.left],
        [first, middle @ .., last] => {
            *first = [a.first, b.first, high.left];
            for (t, triangle) in (1..).zip(&mut *middle) {
                *triangle = [a.at(t), b.at(t), b.at(t - 1)];
            }
            let end = index_of(middle.len());
            *last = [a.at(end + 1), high.right, b.at(end)];
        }
    }
}

/// The numbers of the points around a face's grid and inside.
#[derive(Clone, Copy, Debug)]
struct Frame {
    corners: [u32; 3],
    /// The insides of the sides, in the face's direction.
    sides: [Progression; 3],
    /// Row by row.
    inside: Progression,
    side: u32,
}

impl Frame {
    /// The numbers of the points in a row, from 0 to `side − 1`.
    fn line(&self, row: u32) -> Line {
        let inside = self.side - 1;
        if row == 0 {
            return Line {
                left: self.corners[0],
                inner: self.sides[0],
                right: self.corners[1],
            };
        }
        // The rows below have inside − 1, inside − 2, ... points inside.
        let before = (row - 1) * inside - row * (row - 1) / 2;
        if row >= self.side {
            // The last row is the corner alone.
            return Line {
                left: self.corners[2],
                inner: self.inside,
                right: self.corners[2],
            };
        }
        Line {
            left: self.sides[2].at(inside - row),
            inner: Progression {
                first: self.inside.at(before),
                ..self.inside
            },
            right: self.sides[1].at(row - 1),
        }
    }
}
