//! The Bézier patches of a prepared surface, and the loops that sum them: plain loops over arrays of fixed length, which the compiler
//! turns into whatever vector instructions it may use.

use std::array::from_fn;
use std::ops::Range;

use crate::algebra::{Scalar, Vector3, larger};
use crate::bspline::BsplineSurface;

/// So many points are evaluated together: few enough for all intermediate results to stay in the nearest cache.
pub(super) const LANES: usize = 64;

/// A number for each of the points that are evaluated together.
pub(super) type Lanes<S> = [S; LANES];

/// So many neighbours on a grid are evaluated together.
pub(super) const BLOCK: usize = 4;

/// `N` weights for each of the neighbours that are evaluated together.
pub(super) type Block<S, const N: usize> = [[S; BLOCK]; N];

/// A row of a net of Bézier points, in coordinates.
pub(super) type Row<S, const N: usize> = [[S; 3]; N];

/// The polynomials of a surface with `N × M` coefficients, `N` in u and `M` in v: a net for each pair of spans, u running fastest.
#[derive(Clone, Debug)]
pub(super) struct Patches<S, const N: usize, const M: usize> {
    nets: Vec<Net<S, N, M>>,
}

/// The Bézier points of a patch, `M` rows of `N`, on as few cache lines as they can be.
#[derive(Clone, Copy, Debug)]
#[repr(align(64))]
struct Net<S, const N: usize, const M: usize>([Row<S, N>; M]);

impl<S: Scalar, const N: usize, const M: usize> Patches<S, N, M> {
    /// The patches of a surface whose degrees are `N − 1` and `M − 1`.
    pub(super) fn new<P: Vector3<Scalar = S>>(surface: &BsplineSurface<P>) -> Self {
        let net = |points: &[P]| Net(from_fn(|j| from_fn(|i| points[j * N + i].coordinates())));
        let patches = surface.bezier_patches().into_iter();
        Self {
            nets: patches.map(|patch| net(&patch.control_points)).collect(),
        }
    }

    /// The largest absolute value of a coordinate in each net.
    pub(super) fn sizes(&self) -> impl Iterator<Item = S> {
        let coordinates = |Net(net): &Net<S, N, M>| {
            let all = net.as_flattened().as_flattened().iter();
            all.fold(S::zero(), |most, one| larger(most, one.magnitude()))
        };
        self.nets.iter().map(coordinates)
    }

    /// For consecutive patches along u the points of the curve in u at one v.
    pub(super) fn sum_line(
        &self,
        patches: Range<usize>,
        weights: [S; M],
        line: &mut Vec<Row<S, N>>,
    ) {
        line.clear();
        line.extend(self.nets[patches].iter().map(|net| sum_net(net, weights)));
    }

    /// The points of the curves in u: for each lane its patch, weighted in v.
    #[inline]
    pub(super) fn sum_rows(
        &self,
        patches: &[usize],
        weights: &[Lanes<S>; M],
        rows: &mut Lanes<Row<S, N>>,
    ) {
        for lane in 0..patches.len().min(LANES) {
            let weights = weights.each_ref().map(|weights| weights[lane]);
            rows[lane] = sum_net(&self.nets[patches[lane]], weights);
        }
    }
}

/// The weighted sum of the rows of a net, added from the first on.
#[inline]
fn sum_net<S: Scalar, const N: usize, const M: usize>(
    Net(net): &Net<S, N, M>,
    weights: [S; M],
) -> Row<S, N> {
    let mut sums = [[S::zero(); 3]; N];
    let rows = net.each_ref().map(|row| row.as_flattened());
    for (index, sum) in sums.as_flattened_mut().iter_mut().enumerate() {
        *sum = added(from_fn::<S, M, _>(|j| rows[j][index] * weights[j]));
    }
    sums
}

/// The weighted sum of the points of a row, added from the first on.
#[inline]
pub(super) fn sum_row<S: Scalar, const N: usize>(row: &Row<S, N>, weights: [S; N]) -> [S; 3] {
    from_fn(|axis| added(from_fn::<S, N, _>(|i| row[i][axis] * weights[i])))
}

/// The weighted sums of the points of a row, for all lanes of a block; the same sums as [`sum_row`] gives one by one.
#[inline]
pub(super) fn sum_block<S: Scalar, const N: usize>(
    row: &Row<S, N>,
    weights: &Block<S, N>,
) -> [[S; 3]; BLOCK] {
    from_fn(|lane| sum_row(row, weights.map(|weights| weights[lane])))
}

/// The weights of the given places, block by block; those of the last are filled up.
pub(super) fn bernstein_blocks<S: Scalar, const N: usize>(places: &[S]) -> Vec<Block<S, N>> {
    let block = |places: &[S]| {
        let weights: [[S; N]; BLOCK] =
            from_fn(|lane| bernstein(places[lane.min(places.len() - 1)]));
        from_fn(|i| from_fn(|lane| weights[lane][i]))
    };
    places.chunks(BLOCK).map(block).collect()
}

#[inline]
fn added<S: Scalar, const N: usize>(terms: [S; N]) -> S {
    let mut sum = terms[0];
    for &term in &terms[1..] {
        sum = sum + term;
    }
    sum
}

/// Bernstein's polynomials of degree `N − 1` at the numbers `t`, by their recursion: sums of products of `t` and `1 − t`.
#[inline]
pub(super) fn bernstein_lanes<S: Scalar, const N: usize>(
    t: &Lanes<S>,
    weights: &mut [Lanes<S>; N],
) {
    for lane in 0..LANES {
        let values: [S; N] = bernstein(t[lane]);
        for (weights, value) in weights.iter_mut().zip(values) {
            weights[lane] = value;
        }
    }
}

/// Bernstein's polynomials of degree `N − 1` at `t`.
#[inline]
pub(super) fn bernstein<S: Scalar, const N: usize>(t: S) -> [S; N] {
    let s = S::one() - t;
    let mut values = [S::one(); N];
    for degree in 1..N {
        values[degree] = values[degree - 1] * t;
        for index in (1..degree).rev() {
            values[index] = values[index - 1] * t + values[index] * s;
        }
        values[0] = values[0] * s;
    }
    values
}
