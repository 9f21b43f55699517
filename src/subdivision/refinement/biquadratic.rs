//! One level of biquadratic refinement on a grid: Chaikin's rule along the rows, then across them.

use super::rows::{Grid, Mask, Window, blend, blend_places};
use crate::algebra::{Scalar, VectorSpace};

/// Chaikin's rule: a quarter of the way from the first point to the second.
///
/// Computed as a difference, so that two equal points, as a doubled boundary has, give the same point again, bit by bit.
#[derive(Clone, Copy, Debug)]
struct Quarter<S> {
    quarter: S,
}

impl<S: Scalar> Mask<S, 2> for Quarter<S> {
    fn of<V: VectorSpace<Scalar = S>>(self, [near, far]: [V; 2]) -> V {
        near.plus(far.minus(near).times(self.quarter))
    }
}

fn quarter<S: Scalar>() -> Quarter<S> {
    Quarter {
        quarter: S::ratio(1, 4),
    }
}

/// A row of the fine grid, still as the two coarse rows that it lies between, the nearer one first; these are refined along already.
#[derive(Clone, Copy, Debug)]
pub(super) struct FineRow<'a, P, const LANES: usize>([&'a [[P; LANES]]; 2]);

impl<P: VectorSpace, const LANES: usize> FineRow<'_, P, LANES> {
    /// The points from column `start` on.
    pub(super) fn write(self, start: usize, out: &mut [[P; LANES]]) {
        let rows = self.0.map(|row| row[start..].as_flattened());
        blend(quarter(), rows, out.as_flattened_mut());
    }
}

/// Points along the side of the fine grid, rings included: two between each two of the coarse grid.
pub(super) fn refined_side(side: usize) -> usize {
    2 * side - 2
}

/// Refines a grid of `side` points, and hands the `2 side − 2` fine rows to `visit`, one after the other.
// ANCHOR: refine
pub(super) fn refine_rows<P: VectorSpace, const LANES: usize>(
    coarse: &Grid<P, LANES>,
    window: &mut Window<P, LANES>,
    mut visit: impl FnMut(usize, FineRow<'_, P, LANES>),
) {
    let side = coarse.side();
    for row in 0..side {
        window.push(|out| refine_along(coarse.row(row), &mut out[..refined_side(side)]));
        if let Some(before) = row.checked_sub(1) {
            let [low, high] = window.last();
            visit(2 * before, FineRow([low, high]));
            visit(2 * before + 1, FineRow([high, low]));
        }
    }
}

/// Chaikin's rule along a row.
fn refine_along<P: VectorSpace, const LANES: usize>(
    coarse: &[[P; LANES]],
    fine: &mut [[P; LANES]],
) {
    let (pairs, _) = fine.as_chunks_mut();
    for ([a, b], [near_a, near_b]) in coarse.array_windows().zip(pairs) {
        blend_places(quarter(), [a, b], near_a);
        blend_places(quarter(), [b, a], near_b);
    }
}
// ANCHOR_END: refine

/// Refines a grid into the next one.
pub(super) fn refine<P: VectorSpace, const LANES: usize>(
    coarse: &Grid<P, LANES>,
    window: &mut Window<P, LANES>,
    fine: &mut Grid<P, LANES>,
) {
    refine_rows(coarse, window, |index, row| {
        row.write(0, fine.row_mut(index));
    });
}
