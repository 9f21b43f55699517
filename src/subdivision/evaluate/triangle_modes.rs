//! The eigenstructure of Loop's corners, in closed form.
//!
//! A wave `q_j = cos(2πmj/n)` around a ring of n triangles, and the sine alike, is multiplied by λ = 3/8 + cos(2πm/n)/4 at each step. Without
//! waves there are the constant, with λ = 1, and `(v, q) = (−8(1 − α)/3, 1)` with μ = α − 3/8 = λ₁².
//!
//! # Sources
//!
//! J. Stam, *Evaluation of Loop subdivision surfaces*, 1998.

use num_traits::One;

use super::adaptive::Corner;
use super::eigenbasis::{Coordinates, Mode, OuterMode, Spectrum};
use super::quad_modes::Waves;
use super::triangle_corner::TriangleCorner;
use crate::algebra::{Real, VectorSpace};
use crate::subdivision::mask::turn_cosine;

/// The eigenvectors of the points a0 ... a4 beyond the ring, as columns: three with the eigenvalue 1/8, two with 1/16.
#[rustfmt::skip]
const OUTER_VECTORS: [[i32; 5]; 5] = [
    [1, 0, 0, 0, 0],
    [1, 1, 0, 1, 0],
    [0, 1, 0, 0, 0],
    [0, 1, 1, 0, 1],
    [0, 0, 1, 0, 0],
];

/// Which eigenvalue each of these columns has.
const OUTER_DELTAS: [usize; 5] = [0, 0, 0, 1, 1];

/// The outer points in the basis of their eigenvectors.
fn outer_coordinates<P: VectorSpace>([a0, a1, a2, a3, a4]: [P; 5]) -> [P; 5] {
    let ends = |a: P| a.plus(a2);
    [a0, a2, a4, a1.minus(ends(a0)), a3.minus(ends(a4))]
}

/// The frequencies that have a cosine and a sine; the highest one of an even valence has its cosine alone.
fn waves(n: usize) -> impl Iterator<Item = (usize, bool)> {
    let alternating = n.is_multiple_of(2).then_some((n / 2, false));
    let pairs = (1..n.div_ceil(2)).flat_map(|m| [(m, false), (m, true)]);
    pairs.chain(alternating)
}

/// The eigenstructure of a closed corner's valence and vertex weight.
pub(super) fn spectrum<P>(corner: &TriangleCorner<P>) -> Spectrum<P::Scalar, 15, 5>
where
    P: VectorSpace,
    P::Scalar: Real,
{
    let n = corner.ring.len();
    let vertex_weight = corner.vertex_weight.to_f64();
    let rounded = P::Scalar::from_f64;
    let nets = |corner: &TriangleCorner<f64>| {
        let nets = [0, 1, 2].map(|part| corner.net(part));
        nets.map(|net| net.map(rounded))
    };
    let with = |centre, ring, outer| TriangleCorner {
        is_closed: true,
        vertex_weight,
        sector: 0,
        centre,
        ring,
        outer,
    };
    let mode = |value: f64, corner: &TriangleCorner<f64>| Mode {
        value: rounded(value),
        nets: nets(corner),
        drive: outer_coordinates(corner.refined().outer).map(rounded),
    };
    let centre = -8.0 / 3.0 * (1.0 - vertex_weight);
    let still = with(centre, vec![1.0; n], [0.0; 5]);
    let mut modes = vec![mode(vertex_weight - 0.375, &still)];
    let table = Waves::new(n);
    for (m, is_sine) in waves(n) {
        let value = 0.375 + turn_cosine::<f64>(m, n) / 4.0;
        let ring = (0..n).map(|j| table.at_edge(is_sine, m, j)).collect();
        modes.push(mode(value, &with(0.0, ring, [0.0; 5])));
    }
    let outer_mode = |j: usize| {
        let outer = OUTER_VECTORS.map(|row| f64::from(row[j]));
        OuterMode {
            delta: OUTER_DELTAS[j],
            nets: nets(&with(0.0, vec![0.0; n], outer)),
        }
    };
    Spectrum {
        modes,
        outer: std::array::from_fn(outer_mode),
    }
}

/// The coordinates of a corner that is not on the boundary, in the basis that is number `spectrum` of all: a discrete Fourier transform.
// ANCHOR: coordinates
pub(super) fn coordinates<P>(corner: &TriangleCorner<P>, spectrum: usize) -> Coordinates<P, 5>
where
    P: VectorSpace,
    P::Scalar: Real,
{
    let limit = corner.limit();
    let corner = corner.clone().mapped(|point| point.minus(limit));
    let n = corner.ring.len();
    let mut ring = vec![corner.centre.plus(corner.mean_offset())];
    let table = Waves::new(n);
    for (m, is_sine) in waves(n) {
        let mut sum = P::origin();
        for j in 0..n {
            let weight = P::Scalar::from_f64(table.at_edge(is_sine, m, j));
            sum = sum.plus(corner.ring[(corner.sector + j) % n].times(weight));
        }
        let pairs = if 2 * m == n { n as f64 } else { n as f64 / 2.0 };
        ring.push(sum.times(P::Scalar::one() / P::Scalar::from_f64(pairs)));
    }
    Coordinates {
        spectrum,
        limit,
        ring,
        outer: outer_coordinates(corner.outer),
    }
}
// ANCHOR_END: coordinates
