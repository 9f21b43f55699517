//! The finest rows of patches on their way to where they belong.

use super::cubic::FineRow;
use crate::algebra::VectorSpace;

/// The finest rows of patches, written where they belong.
pub(super) struct Writer<'a, P, const LANES: usize> {
    /// For each side of each patch the inside of its edge, if the patch owns the edge.
    pub(super) sides: [[Option<&'a mut [P]>; 4]; LANES],
    pub(super) inside: &'a mut [[P; LANES]],
    /// The corners, patch by patch.
    pub(super) corners: &'a mut [P],
    /// How many points there are inside an edge.
    pub(super) edge_size: usize,
    /// Room for a row.
    pub(super) row: &'a mut [[P; LANES]],
}

impl<P: VectorSpace, const LANES: usize> Writer<'_, P, LANES> {
    /// Writes a row of the finest grid, in which row and column 0 are the ring's.
    pub(super) fn write_row(&mut self, index: usize, row: FineRow<'_, P, LANES>) {
        let (first, last) = (1, self.edge_size + 2);
        if index < first || index > last {
            return;
        }
        if index == first {
            self.write_side(0, [0, 1], row);
        } else if index == last {
            self.write_side(2, [3, 2], row);
        } else {
            let above = index - 2;
            let inside = &mut self.inside[above * self.edge_size..][..self.edge_size];
            row.write(2, inside);
            self.write_ends(3, self.edge_size - 1 - above, first, row);
            self.write_ends(1, above, last, row);
        }
    }

    /// Writes the points of one column into the sides that it belongs to.
    fn write_ends(&mut self, side: usize, place: usize, column: usize, row: FineRow<'_, P, LANES>) {
        if self.sides.iter().all(|sides| sides[side].is_none()) {
            return;
        }
        let points = &mut self.row[..1];
        row.write(column, points);
        for (sides, point) in self.sides.iter_mut().zip(points[0]) {
            if let Some(points) = &mut sides[side] {
                points[place] = point;
            }
        }
    }

    /// Writes the first row or the last, from corner to corner.
    fn write_side(&mut self, side: usize, ends: [usize; 2], row: FineRow<'_, P, LANES>) {
        let points = &mut self.row[..self.edge_size + 2];
        row.write(1, points);
        let [first, inside @ .., last] = points else {
            return;
        };
        let lanes = self.sides.iter_mut().zip(self.corners.chunks_exact_mut(4));
        for (lane, (sides, corners)) in lanes.enumerate() {
            corners[ends[0]] = first[lane];
            corners[ends[1]] = last[lane];
            if let Some(points) = &mut sides[side] {
                for (point, inside) in points.iter_mut().zip(&*inside) {
                    *point = inside[lane];
                }
                // The face runs along its third side from right to left.
                if side == 2 {
                    points.reverse();
                }
            }
        }
    }
}
