//! One level of Loop's regular masks on triangular grids.
//!
//! A triangle with `side` pieces a side is kept in the half of a square grid: column i, row j, with i + j ≤ side; neighbours are
//! (±1, 0), (0, ±1), (1, −1), (−1, 1).

use super::rows::{Grid, Mask, blend};
use crate::algebra::{Scalar, VectorSpace};

/// The sum of four points: part of a ring, since more rows at once than four are more than the processor keeps at hand.
#[derive(Clone, Copy, Debug)]
struct Sum;

impl<S: Scalar> Mask<S, 4> for Sum {
    fn of<V: VectorSpace<Scalar = S>>(self, [a, b, c, d]: [V; 4]) -> V {
        a.plus(b).plus(c.plus(d))
    }
}

/// Loop's mask of a vertex of valence 6: 5/8, and 1/16 for each neighbour; four of the neighbours are summed already.
#[derive(Clone, Copy, Debug)]
struct Vertex<S> {
    own: S,
    neighbour: S,
}

impl<S: Scalar> Mask<S, 4> for Vertex<S> {
    fn of<V: VectorSpace<Scalar = S>>(self, [v, four, e, f]: [V; 4]) -> V {
        let ring = four.plus(e.plus(f));
        v.times(self.own).plus(ring.times(self.neighbour))
    }
}

/// Loop's mask of an edge: 3/8 for its ends, 1/8 for the vertices opposite to it.
#[derive(Clone, Copy, Debug)]
struct Edge<S> {
    end: S,
    opposite: S,
}

impl<S: Scalar> Mask<S, 4> for Edge<S> {
    fn of<V: VectorSpace<Scalar = S>>(self, [a, b, c, d]: [V; 4]) -> V {
        let ends = a.plus(b).times(self.end);
        ends.plus(c.plus(d).times(self.opposite))
    }
}

fn vertex<S: Scalar>() -> Vertex<S> {
    Vertex {
        own: S::ratio(5, 8),
        neighbour: S::ratio(1, 16),
    }
}

fn edge<S: Scalar>() -> Edge<S> {
    Edge {
        end: S::ratio(3, 8),
        opposite: S::ratio(1, 8),
    }
}

/// Points along the side of the fine grid, ring included.
pub(super) fn refined_side(side: usize) -> usize {
    2 * side - 3
}

/// How many places of a row are in use in a grid of `side` places a side, ring included.
pub(super) fn row_length(side: usize, row: usize) -> usize {
    side.min(side + 1 - row)
}

/// Room for the old and the new points of a row before they are put together.
pub(super) type Parts<P, const LANES: usize> = [Vec<[P; LANES]>; 3];

/// Writes the fine points of a row from column `2 · first` on; row and column 0 are the ring's.
// ANCHOR: row
pub(super) fn write_row<P: VectorSpace, const LANES: usize>(
    coarse: &Grid<P, LANES>,
    row: usize,
    first: usize,
    [new, old, sums]: &mut Parts<P, LANES>,
    out: &mut [[P; LANES]],
) {
    let at = row.div_ceil(2);
    let from = |row: usize, skip: usize| coarse.row(row)[first + skip..].as_flattened();
    let on = |skip| from(at, skip);
    let above = |skip| from(at + 1, skip);
    let new = &mut new[..out.len().div_ceil(2)];
    let old = &mut old[..out.len() / 2];
    if row % 2 == 1 {
        // An old row, between the rows above and below: the midpoints along it, and its own points.
        let below = |skip| from(at - 1, skip);
        let sums = &mut sums[..old.len()];
        blend(
            edge(),
            [on(0), on(1), above(0), below(1)],
            new.as_flattened_mut(),
        );
        blend(
            Sum,
            [on(0), on(2), above(0), below(2)],
            sums.as_flattened_mut(),
        );
        let vertex_rows = [on(1), sums.as_flattened(), above(1), below(1)];
        blend(vertex(), vertex_rows, old.as_flattened_mut());
    } else {
        // A new row, between two old ones: the edges that lean to the left, and those upright.
        let diagonal = [on(1), above(0), on(0), above(1)];
        blend(edge(), diagonal, new.as_flattened_mut());
        blend(
            edge(),
            [on(1), above(1), on(2), above(0)],
            old.as_flattened_mut(),
        );
    }
    let (pairs, last) = out.as_chunks_mut();
    for ([first, second], (new, old)) in pairs.iter_mut().zip(new.iter().zip(&*old)) {
        first.copy_from_slice(new);
        second.copy_from_slice(old);
    }
    if let ([out], Some(new)) = (last, new.last()) {
        out.copy_from_slice(new);
    }
}
// ANCHOR_END: row

/// Refines a grid into the next one.
pub(super) fn refine<P: VectorSpace, const LANES: usize>(
    coarse: &Grid<P, LANES>,
    parts: &mut Parts<P, LANES>,
    fine: &mut Grid<P, LANES>,
) {
    for row in 0..fine.side() {
        let length = row_length(fine.side(), row);
        write_row(coarse, row, 0, parts, &mut fine.row_mut(row)[..length]);
    }
}

/// The point of the boundary's own curve that is `t` pieces from the start of a side of the fine grid, between its ends.
pub(super) fn on_curve<P: VectorSpace>(t: usize, coarse: impl Fn(usize) -> P) -> P {
    let p = coarse(t / 2);
    let after = coarse(t / 2 + 1);
    if t % 2 == 1 {
        return p.plus(after).times(P::Scalar::ratio(1, 2));
    }
    let beside = coarse(t / 2 - 1).plus(after);
    p.times(P::Scalar::ratio(3, 4))
        .plus(beside.times(P::Scalar::ratio(1, 8)))
}
