//! One level of bicubic refinement on a grid: the cubic rule along the rows, then across them.

use super::rows::{Grid, Mask, Window, blend, blend_places};
use crate::algebra::{Scalar, VectorSpace};

/// The cubic rule of an old point: (1, 6, 1)/8.
#[derive(Clone, Copy, Debug)]
struct Even<S> {
    eighth: S,
    three_quarters: S,
}

impl<S: Scalar> Mask<S, 3> for Even<S> {
    fn of<V: VectorSpace<Scalar = S>>(self, [a, b, c]: [V; 3]) -> V {
        let beside = a.plus(c).times(self.eighth);
        b.times(self.three_quarters).plus(beside)
    }
}

/// The cubic rule of a new point: the midpoint.
#[derive(Clone, Copy, Debug)]
struct Odd<S> {
    half: S,
}

impl<S: Scalar> Mask<S, 2> for Odd<S> {
    fn of<V: VectorSpace<Scalar = S>>(self, [a, b]: [V; 2]) -> V {
        a.plus(b).times(self.half)
    }
}

/// Which sides of the patches are boundaries, side by side: first row, last column, last row, first column.
pub(super) type Boundaries<const LANES: usize> = [[bool; LANES]; 4];

/// A row of the fine grid, still as the coarse rows that it is a mask of; these are refined along already.
#[derive(Clone, Copy, Debug)]
pub(super) enum FineRow<'a, P, const LANES: usize> {
    /// An old row between its neighbours. On the boundary of a patch it is refined as the boundary's own curve, whatever is inside.
    Even {
        rows: [&'a [[P; LANES]]; 3],
        on_boundary: Option<&'a [bool; LANES]>,
    },
    /// A new row between two old ones.
    Odd([&'a [[P; LANES]]; 2]),
}

impl<P: VectorSpace, const LANES: usize> FineRow<'_, P, LANES> {
    /// The points from column `start` on.
    pub(super) fn write(self, start: usize, out: &mut [[P; LANES]]) {
        match self {
            Self::Even { rows, on_boundary } => {
                let rows = rows.map(|row| &row[start..]);
                blend(
                    even(),
                    rows.map(<[_]>::as_flattened),
                    out.as_flattened_mut(),
                );
                if let Some(on_boundary) = on_boundary {
                    for (out, kept) in out.iter_mut().zip(rows[1]) {
                        keep_lanes(on_boundary, kept, out);
                    }
                }
            }
            Self::Odd(rows) => {
                let rows = rows.map(|row| row[start..].as_flattened());
                blend(odd(), rows, out.as_flattened_mut());
            }
        }
    }
}

/// Puts the kept points into the lanes that are on a boundary.
fn keep_lanes<P: Copy, const LANES: usize>(
    on_boundary: &[bool; LANES],
    kept: &[P; LANES],
    out: &mut [P; LANES],
) {
    for (lane, _) in on_boundary.iter().enumerate().filter(|lane| *lane.1) {
        out[lane] = kept[lane];
    }
}

fn even<S: Scalar>() -> Even<S> {
    Even {
        eighth: S::ratio(1, 8),
        three_quarters: S::ratio(3, 4),
    }
}

fn odd<S: Scalar>() -> Odd<S> {
    Odd {
        half: S::ratio(1, 2),
    }
}

/// Points along the side of the fine grid, rings included.
pub(super) fn refined_side(side: usize) -> usize {
    2 * side - 3
}

/// Refines a grid of `side` points, and hands the `2 side − 3` fine rows to `visit`, one after the other.
///
/// Beyond a boundary the ring holds no neighbours but mirror images; the points on it follow its own curve and nothing else.
// ANCHOR: refine
pub(super) fn refine_rows<P: VectorSpace, const LANES: usize>(
    coarse: &Grid<P, LANES>,
    boundaries: &Boundaries<LANES>,
    window: &mut Window<P, LANES>,
    mut visit: impl FnMut(usize, FineRow<'_, P, LANES>),
) {
    let [first_row, last_column, last_row, first_column] = boundaries;
    let side = coarse.side();
    let any = |lanes: &[bool; LANES]| lanes.contains(&true);
    let columns = [
        (first_column, 1, 1),
        (last_column, side - 2, refined_side(side) - 2),
    ];
    let columns = columns.map(|column| any(column.0).then_some(column));
    for row in 0..side {
        window.push(|out| {
            let (coarse, out) = (coarse.row(row), &mut out[..refined_side(side)]);
            refine_along(coarse, out);
            for (lanes, old, new) in columns.into_iter().flatten() {
                keep_lanes(lanes, &coarse[old], &mut out[new]);
            }
        });
        if row >= 2 {
            let on_boundary = match row {
                2 => Some(first_row),
                _ if row == side - 1 => Some(last_row),
                _ => None,
            };
            let old = FineRow::Even {
                rows: window.last(),
                on_boundary: on_boundary.filter(|lanes| any(lanes)),
            };
            visit(2 * row - 3, old);
        }
        if row >= 1 {
            visit(2 * row - 2, FineRow::Odd(window.last()));
        }
    }
}

/// The cubic rule along a row of n places: their n − 1 midpoints, and between two of these a point for each place that has two neighbours.
fn refine_along<P: VectorSpace, const LANES: usize>(
    coarse: &[[P; LANES]],
    fine: &mut [[P; LANES]],
) {
    let (even, odd) = (even(), odd());
    let (pairs, last) = fine.as_chunks_mut();
    for ([a, b, c], [new, old]) in coarse.array_windows().zip(pairs) {
        blend_places(odd, [a, b], new);
        blend_places(even, [a, b, c], old);
    }
    if let (Some([a, b]), [last]) = (coarse.last_chunk(), last) {
        blend_places(odd, [a, b], last);
    }
}
// ANCHOR_END: refine

/// Refines a grid into the next one.
pub(super) fn refine<P: VectorSpace, const LANES: usize>(
    coarse: &Grid<P, LANES>,
    boundaries: &Boundaries<LANES>,
    window: &mut Window<P, LANES>,
    fine: &mut Grid<P, LANES>,
) {
    refine_rows(coarse, boundaries, window, |index, row| {
        row.write(0, fine.row_mut(index));
    });
}
