//! One level of Loop's regular masks on triangular grids.
//!
//! A triangle with `side` pieces a side is kept in the half of a square grid: column i, row j, with i + j ≤ side; neighbours are
//! (±1, 0), (0, ±1), (1, −1), (−1, 1).

use super::rows::{Grid, Mask, blend_places};
use crate::algebra::{Scalar, VectorSpace};

/// Loop's mask of a vertex of valence 6: 5/8, and 1/16 for each neighbour.
#[derive(Clone, Copy, Debug)]
struct Vertex<S> {
    own: S,
    neighbour: S,
}

impl<S: Scalar> Mask<S, 7> for Vertex<S> {
    fn of<V: VectorSpace<Scalar = S>>(self, [v, a, b, c, d, e, f]: [V; 7]) -> V {
        let ring = a.plus(d).plus(b.plus(e)).plus(c.plus(f));
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

/// Writes the fine points of a row from column `2 · first` on; row and column 0 are the ring's.
// ANCHOR: row
pub(super) fn write_row<P: VectorSpace, const LANES: usize>(
    coarse: &Grid<P, LANES>,
    row: usize,
    first: usize,
    out: &mut [[P; LANES]],
) {
    let (vertex, edge) = (vertex(), edge());
    let is_old = row % 2 == 1;
    let at = row.div_ceil(2);
    let (pairs, last) = out.as_chunks_mut();
    let end = first + pairs.len();
    // An old row runs between its neighbours above and below, a new one between two old ones.
    let below = if is_old { coarse.row(at - 1) } else { &[] };
    let (on, above) = (coarse.row(at), coarse.row(at + 1));
    let windows = on[first..]
        .array_windows()
        .zip(above[first..].array_windows());
    if is_old {
        let below = below[first + 1..].array_windows();
        for ((([p, q, r], [s, t]), [u, v]), [new, old]) in windows.zip(below).zip(pairs) {
            blend_places(edge, [p, q, s, u], new);
            blend_places(vertex, [q, p, u, v, r, t, s], old);
        }
    } else {
        for (([p, q, r], [s, t]), [diagonal, upright]) in windows.zip(pairs) {
            blend_places(edge, [q, s, p, t], diagonal);
            blend_places(edge, [q, t, r, s], upright);
        }
    }
    if let [last] = last {
        let [p, q, s] = [&on[end], &on[end + 1], &above[end]];
        if is_old {
            blend_places(edge, [p, q, s, &below[end + 1]], last);
        } else {
            blend_places(edge, [q, s, p, &above[end + 1]], last);
        }
    }
}
// ANCHOR_END: row

/// Refines a grid into the next one.
pub(super) fn refine<P: VectorSpace, const LANES: usize>(
    coarse: &Grid<P, LANES>,
    fine: &mut Grid<P, LANES>,
) {
    for row in 0..fine.side() {
        let length = row_length(fine.side(), row);
        write_row(coarse, row, 0, &mut fine.row_mut(row)[..length]);
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
