//! The masks: weights that depend on nothing but valence.
//!
//! Each is a formula in cos(2π/n), which the caller passes in: [`turn_cosine`] gives it in floating point, and where it is rational
//! (n = 3, 4, 6) a proof over exact numbers passes the fraction itself.
//!
//! # Sources
//!
//! Doo-Sabin: D. Doo, M. Sabin, *Behaviour of recursive division surfaces near extraordinary points*, 1978. Catmull-Clark: E. Catmull,
//! J. Clark, *Recursively generated B-spline surfaces on arbitrary topological meshes*, 1978. Loop: C. Loop, *Smooth subdivision surfaces
//! based on triangles*, 1987. √3: L. Kobbelt, *√3-subdivision*, 2000.
//!
//! *In the course*: slides 68 (n-gons), 73, 78; the cosine printed on slide 78 is wrong.

use crate::algebra::{Real, Scalar};

/// What becomes of a boundary vertex that has a single face.
///
/// The boundary itself is refined as the curve of its scheme, without regard to the inside: by Chaikin's rule for Doo-Sabin, by the cubic rule
/// for the others (every second step for √3).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Corners {
    /// It stays where it is: a square sheet keeps its four corners.
    #[default]
    Sharp,
    /// It moves like every boundary vertex, and the corner is rounded off.
    Smooth,
}

/// Which weights Doo-Sabin uses in a face that has not four corners.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum DooSabinWeights {
    /// Doo's and Sabin's own, by a discrete Fourier transform: every face shrinks by the same half.
    #[default]
    Own,
    /// The mean of the corner, the midpoints of its two sides and the centroid, as on the slides.
    Averaging,
}

/// cos(2πk/n), with the exact value wherever it is rational.
///
/// # Accuracy
///
/// Within 3u of the true value: the angle is reduced to an eighth of a turn in whole numbers, before anything is rounded.
///
/// # Edge cases
///
/// NaN for n = 0.
pub fn turn_cosine<S: Real>(k: usize, n: usize) -> S {
    if n == 0 {
        return S::zero() / S::zero();
    }
    let k = k % n;
    // cos(−x) = cos(x): the first half of the turn is enough.
    let k = k.min(n - k);
    if 6 * k == n {
        return S::ratio(1, 2);
    }
    if 3 * k == n {
        return S::ratio(-1, 2);
    }
    if 8 * k <= n {
        S::from_f64(part_of_turn(k, n).cos())
    } else if 8 * k < 3 * n {
        // cos(x) = sin(π/2 − x), which is zero where 4k = n.
        let sine = part_of_turn(n.abs_diff(4 * k), 4 * n).sin();
        S::from_f64(if 4 * k <= n { sine } else { -sine })
    } else {
        S::from_f64(-part_of_turn(n - 2 * k, 2 * n).cos())
    }
}

/// 2πk/n in double precision.
#[allow(
    clippy::cast_precision_loss,
    reason = "no mesh has a vertex of valence 2^53"
)]
fn part_of_turn(k: usize, n: usize) -> f64 {
    2.0 * std::f64::consts::PI * k as f64 / n as f64
}

/// Loop's weight of a vertex in its own new position, from cos(2π/n): α = (3/8 + c/4)² + 3/8. Its n neighbours share the rest.
pub fn loop_vertex_weight<S: Scalar>(cosine: S) -> S {
    let inner = S::ratio(3, 8) + cosine / S::from_i32(4);
    inner * inner + S::ratio(3, 8)
}

/// The weight of the mean of the neighbours in √3's new position of a vertex, from cos(2π/n): α = (4 − 2c)/9. The vertex itself has 1 − α.
pub fn sqrt3_neighbours_weight<S: Scalar>(cosine: S) -> S {
    (S::from_i32(4) - cosine - cosine) / S::from_i32(9)
}

/// Doo's and Sabin's weight of the corner `steps` corners away, in a face of `n` corners, from cos(2π·steps/n): (n + 5)/4n for the corner
/// itself, (3 + 2c)/4n for the others.
pub fn doo_sabin_weight<S: Scalar>(n: usize, steps: usize, cosine: S) -> S {
    let numerator = if steps.is_multiple_of(n) {
        count::<S>(n) + S::from_i32(5)
    } else {
        S::from_i32(3) + cosine + cosine
    };
    numerator / (S::from_i32(4) * count::<S>(n))
}

/// The slides' weight of the corner `steps` corners away, in a face of `n >= 3` corners: 1/2 + 1/4n for the corner itself, 1/8 + 1/4n for the
/// two beside it, 1/4n for the others.
pub fn averaging_weight<S: Scalar>(n: usize, steps: usize) -> S {
    let of_centroid = S::one() / (S::from_i32(4) * count::<S>(n));
    let steps = steps % n;
    match steps.min(n - steps) {
        0 => S::ratio(1, 2) + of_centroid,
        1 => S::ratio(1, 8) + of_centroid,
        _ => of_centroid,
    }
}

/// A number of corners or edges as a scalar.
pub(super) fn count<S: Scalar>(n: usize) -> S {
    S::from_i32(i32::try_from(n).unwrap_or(i32::MAX))
}
