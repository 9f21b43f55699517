//! Eigenvalues of the local subdivision matrices, as functions of the valence.
//!
//! A ring that is turned by one neighbour goes through the same step: the matrix is block-circulant, and a discrete Fourier transform cuts it
//! into a small block for each frequency j, which depends on cos(2πj/n) alone. Frequency 0 holds the eigenvalue 1 and the vertex's own approach to
//! its limit; frequency 1 and its mirror image hold the tangents; frequency 2 the saddles.

use crate::algebra::{Real, Scalar};
use crate::subdivision::DooSabinWeights;
use crate::subdivision::mask::{loop_vertex_weight, sqrt3_neighbours_weight, turn_cosine};

/// The eigenvalues that decide how smooth a surface is at a vertex. The largest is always 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Eigenvalues<S> {
    /// λ, the two-fold eigenvalue of the tangents: the ring shrinks by this factor in a step.
    pub tangent: S,
    /// |μ|, the largest absolute value of all the others: the ring's distance from the tangent plane shrinks by it. Curvature is
    /// unbounded where μ > λ², and the surface is flat in the vertex where μ < λ².
    pub next: S,
}

/// The largest eigenvalue beyond the ring, of Catmull-Clark and Loop at every valence: the neighbours of the neighbours, as a fraction.
const OUTER: [i32; 2] = [1, 8];

/// λ and μ of Catmull-Clark at a vertex of valence `n >= 3`.
///
/// # Edge cases
///
/// For n = 3 the frequencies 1 and 2 are the same, so there are no saddles.
pub fn catmull_clark_eigenvalues<S: Real>(n: usize) -> Eigenvalues<S> {
    let [tangent, second] = catmull_clark_ring_eigenvalues(turn_cosine(1, n));
    let [vertex, _] = catmull_clark_vertex_eigenvalues(n);
    let mut next = vec![second, vertex, S::ratio(OUTER[0], OUTER[1])];
    if n >= 4 {
        next.push(catmull_clark_ring_eigenvalues(turn_cosine(2, n))[0]);
    }
    Eigenvalues {
        tangent,
        next: largest(next),
    }
}

/// λ and μ of Loop's scheme at a vertex of valence `n >= 3`.
pub fn loop_eigenvalues<S: Real>(n: usize) -> Eigenvalues<S> {
    let cosine = turn_cosine(1, n);
    let vertex = loop_vertex_eigenvalue(loop_vertex_weight(cosine));
    let mut next = vec![vertex, S::ratio(OUTER[0], OUTER[1])];
    if n >= 4 {
        next.push(loop_ring_eigenvalue(turn_cosine(2, n)));
    }
    Eigenvalues {
        tangent: loop_ring_eigenvalue(cosine),
        next: largest(next),
    }
}

/// |λ| and |μ| of √3 at a vertex of valence `n >= 3`, whose neighbours have valence 6 as they have after two steps.
pub fn sqrt3_eigenvalues<S: Real>(n: usize) -> Eigenvalues<S> {
    let vertex = sqrt3_vertex_eigenvalue(sqrt3_neighbours_weight(turn_cosine(1, n)));
    // Beyond the ring, constants: s' = (2s + r)/18 for the vertices between two neighbours, r' = s/3 for those behind one.
    let outer = (S::one() + S::from_i32(7).sqrt()) / S::from_i32(18);
    let mut next = vec![vertex, outer];
    if n >= 4 {
        next.push(sqrt3_ring_eigenvalue(turn_cosine(2, 2 * n)));
    }
    Eigenvalues {
        tangent: sqrt3_ring_eigenvalue(turn_cosine(1, 2 * n)),
        next: largest(next),
    }
}

/// λ and μ of Doo-Sabin in a face of `n >= 3` corners.
pub fn doo_sabin_eigenvalues<S: Real>(n: usize, weights: DooSabinWeights) -> Eigenvalues<S> {
    let mut next = vec![S::ratio(1, 4)];
    if n >= 4 {
        next.push(doo_sabin_eigenvalue(weights, n, 2, turn_cosine(2, n)));
    }
    Eigenvalues {
        tangent: doo_sabin_eigenvalue(weights, n, 1, turn_cosine(1, n)),
        next: largest(next),
    }
}

/// The two eigenvalues of Catmull-Clark for a frequency j > 0, from cos(2πj/n), the larger one first: (5 + c ± √((1+c)(9+c)))/16.
///
/// # Accuracy
///
/// Each within 12u, relatively: the product of the two is 1/16 for every c, and only the larger is computed as a sum.
pub fn catmull_clark_ring_eigenvalues<S: Real>(cosine: S) -> [S; 2] {
    let larger = catmull_clark_ring_eigenvalue(cosine, Real::sqrt);
    // The determinant of the block is 1/16.
    [larger, S::ratio(1, 16) / larger]
}

/// The larger eigenvalue of Catmull-Clark for a frequency j > 0, with the square root handed in.
pub(super) fn catmull_clark_ring_eigenvalue<S: Scalar>(cosine: S, root: impl Fn(S) -> S) -> S {
    let [one, five, nine, sixteen] = [1, 5, 9, 16].map(S::from_i32);
    (five + cosine + root((one + cosine) * (nine + cosine))) / sixteen
}

/// The two eigenvalues of Catmull-Clark for frequency 0 that are not 1, the larger one first: (3n − 7 ± √(5n² − 30n + 49))/8n.
///
/// # Accuracy
///
/// Each within 24u, relatively, for n >= 3; the smaller is exactly 0 for n = 3.
pub fn catmull_clark_vertex_eigenvalues<S: Real>(n: usize) -> [S; 2] {
    let n = crate::subdivision::mask::count::<S>(n);
    let [three, five, seven, eight, thirty, forty_nine] = [3, 5, 7, 8, 30, 49].map(S::from_i32);
    let root = (five * n * n - thirty * n + forty_nine).sqrt();
    let larger = (three * n - seven + root) / (eight * n);
    // The product of the two, so that the smaller is no difference of large numbers.
    let product = (n - three) / (S::from_i32(16) * n);
    [larger, product / larger]
}

/// The eigenvalue of Loop's scheme for a frequency j > 0, from cos(2πj/n): 3/8 + c/4.
pub fn loop_ring_eigenvalue<S: Scalar>(cosine: S) -> S {
    S::ratio(3, 8) + cosine / S::from_i32(4)
}

/// The eigenvalue of Loop's scheme for frequency 0 that is not 1, from the vertex's own weight: α − 3/8. With Loop's α it is λ².
pub fn loop_vertex_eigenvalue<S: Scalar>(vertex_weight: S) -> S {
    vertex_weight - S::ratio(3, 8)
}

/// The absolute value of √3's eigenvalue for a frequency j > 0, from cos(πj/n), half the angle of the others: 2/3 |c|. The ring turns by πj/n
/// with every step.
pub fn sqrt3_ring_eigenvalue<S: Scalar>(half_angle_cosine: S) -> S {
    S::ratio(2, 3) * half_angle_cosine.magnitude()
}

/// The eigenvalue of √3 for frequency 0 that is not 1, from the weight of the neighbours: 2/3 − α. With Kobbelt's α it is λ².
pub fn sqrt3_vertex_eigenvalue<S: Scalar>(neighbours_weight: S) -> S {
    S::ratio(2, 3) - neighbours_weight
}

/// The eigenvalue of Doo-Sabin for a frequency 0 < j < n, from cos(2πj/n): 1/2 + c/4 for the averaging weights; for Doo's and Sabin's own 1/2
/// for one turn either way, and 1/4 for all others.
pub fn doo_sabin_eigenvalue<S: Scalar>(
    weights: DooSabinWeights,
    n: usize,
    frequency: usize,
    cosine: S,
) -> S {
    match weights {
        DooSabinWeights::Averaging => S::ratio(1, 2) + cosine / S::from_i32(4),
        DooSabinWeights::Own if frequency == 1 || frequency + 1 == n => S::ratio(1, 2),
        DooSabinWeights::Own => S::ratio(1, 4),
    }
}

fn largest<S: Scalar>(values: Vec<S>) -> S {
    values.into_iter().fold(S::zero(), |largest, value| {
        let magnitude = value.magnitude();
        if magnitude > largest {
            magnitude
        } else {
            largest
        }
    })
}
