//! Masks applied to whole rows of points at once.

use crate::algebra::{Scalar, VectorSpace};

/// Weights for N points, written once for points and for their coordinates alike.
pub(super) trait Mask<S: Scalar, const N: usize>: Copy {
    /// The weighted sum.
    fn of<V: VectorSpace<Scalar = S>>(self, points: [V; N]) -> V;
}

/// Applies a mask to N rows, point by point: `out[i]` is the mask of the i-th point of each row.
///
/// The rows may be longer than `out`.
// ANCHOR: blend
#[inline]
pub(super) fn blend<P: VectorSpace, const N: usize>(
    mask: impl Mask<P::Scalar, N>,
    rows: [&[P]; N],
    out: &mut [P],
) {
    let rows = rows.map(|row| &row[..out.len()]);
    let flat_rows = rows.map(P::flattened);
    if flat_rows.iter().all(Option::is_some)
        && let Some(flat_out) = P::flattened_mut(out)
    {
        // A mask does the same to every coordinate: to the processor a row of points is one long row of numbers.
        each(mask, flat_rows.map(Option::unwrap_or_default), flat_out);
    } else {
        each(mask, rows, out);
    }
}

/// Applies a mask to N places, lane by lane.
#[inline]
pub(super) fn blend_places<P: VectorSpace, const LANES: usize, const N: usize>(
    mask: impl Mask<P::Scalar, N>,
    places: [&[P; LANES]; N],
    out: &mut [P; LANES],
) {
    if LANES == 1 {
        out[0] = mask.of(places.map(|place| place[0]));
    } else {
        blend(mask, places.map(|place| &place[..]), out);
    }
}

/// How many numbers are blended in one go.
const CHUNK: usize = 16;

#[inline]
fn each<V: VectorSpace, const N: usize>(
    mask: impl Mask<V::Scalar, N>,
    rows: [&[V]; N],
    out: &mut [V],
) {
    let whole = out.len() - out.len() % CHUNK;
    one_by_one(mask, rows, &mut out[..whole]);
    if whole == out.len() {
        return;
    }
    // The last numbers are part of a chunk that begins earlier: some are written twice, but all at once.
    let start = if whole == 0 { 0 } else { out.len() - CHUNK };
    let rest = rows.map(|row| &row[start..]);
    let out = &mut out[start..];
    match out.first_chunk_mut::<CHUNK>() {
        Some(chunk) => one_by_one(mask, rest, chunk),
        None => one_by_one(mask, rest, out),
    }
}

#[inline]
fn one_by_one<V: VectorSpace, const N: usize>(
    mask: impl Mask<V::Scalar, N>,
    rows: [&[V]; N],
    out: &mut [V],
) {
    // Slices of one length: the loop needs no check of its indices.
    let rows = rows.map(|row| &row[..out.len()]);
    for (index, point) in out.iter_mut().enumerate() {
        *point = mask.of(rows.map(|row| row[index]));
    }
}
// ANCHOR_END: blend

/// Squares of points with a ring of *ghosts* around: copies of the neighbours' points, so that a mask finds its neighbours everywhere.
///
/// In each place lie the points of `LANES` patches, side by side: where patches are small, a row of one is too short to be worth a loop,
/// and that of several is not.
///
/// # Shape
///
/// Row-major; row and column 0 are the ring's.
#[derive(Clone, Debug)]
pub(super) struct Grid<P, const LANES: usize> {
    side: usize,
    points: Vec<[P; LANES]>,
}

impl<P: VectorSpace, const LANES: usize> Grid<P, LANES> {
    /// A grid of `side` x `side` places, the ring included.
    pub(super) fn new(side: usize) -> Self {
        Self {
            side,
            points: vec![[P::origin(); LANES]; side * side],
        }
    }

    /// Bytes that the grid keeps.
    pub(super) fn bytes(&self) -> usize {
        self.points.capacity() * size_of::<[P; LANES]>()
    }

    /// Points along a side, with the ring.
    pub(super) fn side(&self) -> usize {
        self.side
    }

    pub(super) fn at(&self, row: usize, column: usize) -> &[P; LANES] {
        &self.points[row * self.side + column]
    }

    pub(super) fn at_mut(&mut self, row: usize, column: usize) -> &mut [P; LANES] {
        &mut self.points[row * self.side + column]
    }

    /// Fills the corner of the grid with the points of a stencil for each lane. Where a stencil names no vertex, a later step fills in or
    /// nothing uses the place.
    pub(super) fn gather<'a, const SIDE: usize>(
        &mut self,
        stencils: impl Iterator<Item = &'a [[u32; SIDE]; SIDE]>,
        points: &[P],
    ) {
        for (lane, stencil) in stencils.enumerate() {
            for (row, vertices) in stencil.iter().enumerate() {
                for (column, &vertex) in vertices.iter().enumerate() {
                    let point = points.get(vertex as usize).copied();
                    self.at_mut(row, column)[lane] = point.unwrap_or_else(P::origin);
                }
            }
        }
    }

    pub(super) fn row(&self, row: usize) -> &[[P; LANES]] {
        &self.points[row * self.side..][..self.side]
    }

    pub(super) fn row_mut(&mut self, row: usize) -> &mut [[P; LANES]] {
        &mut self.points[row * self.side..][..self.side]
    }
}

/// The last rows that were made, while a walk over a grid needs them.
#[derive(Clone, Debug)]
pub(super) struct Window<P, const LANES: usize> {
    rows: [Vec<[P; LANES]>; 3],
    /// Rows for other purposes.
    parts: [Vec<[P; LANES]>; 3],
    /// How many rows were made; the newest is in place `(made − 1) mod 3`.
    made: usize,
}

impl<P: VectorSpace, const LANES: usize> Window<P, LANES> {
    /// Room for rows of `length` places.
    pub(super) fn new(length: usize) -> Self {
        Self {
            rows: std::array::from_fn(|_| vec![[P::origin(); LANES]; length]),
            parts: std::array::from_fn(|_| vec![[P::origin(); LANES]; length]),
            made: 0,
        }
    }

    /// Bytes that the rows keep.
    pub(super) fn bytes(&self) -> usize {
        let rows = self.rows.iter().chain(&self.parts);
        rows.map(Vec::capacity).sum::<usize>() * size_of::<[P; LANES]>()
    }

    /// Rows for other purposes.
    pub(super) fn parts(&mut self) -> &mut [Vec<[P; LANES]>; 3] {
        &mut self.parts
    }

    /// Makes the next row in the place of the oldest.
    pub(super) fn push(&mut self, make: impl FnOnce(&mut [[P; LANES]])) {
        make(&mut self.rows[self.made % 3]);
        self.made += 1;
    }

    /// The last `N` rows, the oldest first.
    pub(super) fn last<const N: usize>(&self) -> [&[[P; LANES]]; N] {
        std::array::from_fn(|index| self.rows[(self.made + 3 - N + index) % 3].as_slice())
    }
}
