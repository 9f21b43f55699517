//! The eigenstructure of Catmull-Clark's corners, in closed form.
//!
//! A ring of n quadrilaterals is the same from every face: cosine and sine waves of frequency m around it stay what they are. For
//! `e_j = E cos(2πmj/n)` and `f_j = F cos(2πm(j + ½)/n)` a step is, with `s = cos(πm/n)`,
//!
//! ```text
//! E' = ((1 + s²) E + (s/2) F)/4         λ± = (2 + s² ± s √(s² + 4))/8,   λ₊ λ₋ = 1/16
//! F' = (2s E + F)/4                     (E, F) = (1, √(s² + 4) − s)  and  (1, −√(s² + 4) − s)
//! ```
//!
//! The two vectors are orthogonal once F is halved, whatever s: nothing is lost in coordinates. Without waves (m = 0) the vertex takes part:
//! the constant has λ = 1, and the two others are
//!
//! ```text
//! μ± = (3n − 7 ± √(5n² − 30n + 49))/8n,   μ₊ μ₋ = (n − 3)/16n,   (v, E, F) = (32μ² − 24μ + 2, 12μ − 2, 8μ + 2)
//! ```
//!
//! # Sources
//!
//! J. Stam, *Exact evaluation of Catmull-Clark subdivision surfaces at arbitrary parameter values*, 1998 (the eigenstructure by Fourier transform is in
//! its appendix A); A. Ball, D. Storry, *Conditions for tangent plane continuity over recursively generated B-spline surfaces*, 1988.

use num_traits::One;

use super::adaptive::Corner;
use super::eigenbasis::{Coordinates, Mode, OuterMode, Spectrum};
use super::quad_corner::QuadCorner;
use crate::algebra::{Real, Scalar, VectorSpace};
use crate::subdivision::mask::turn_cosine;

/// The eigenvectors of the points a0 ... a6 beyond the ring, as columns: three for each side, and the far corner. Their eigenvalues are
/// 1/8, 1/16, 1/32 for each side, 1/64 for the corner.
#[rustfmt::skip]
const OUTER_VECTORS: [[i32; 7]; 7] = [
    [1,  1,  2, 0,  0,  0, 0],
    [1,  0, -1, 0,  0,  0, 0],
    [1, -1,  2, 0,  0,  0, 0],
    [1, -2, 11, 1, 11, -2, 1],
    [0,  0,  0, 0,  2, -1, 1],
    [0,  0,  0, 0, -1,  0, 1],
    [0,  0,  0, 0,  2,  1, 1],
];

/// Which eigenvalue each of these columns has.
const OUTER_DELTAS: [usize; 7] = [0, 1, 2, 3, 2, 1, 0];

/// The outer points in the basis of their eigenvectors.
fn outer_coordinates<P: VectorSpace>([a0, a1, a2, a3, a4, a5, a6]: [P; 7]) -> [P; 7] {
    let times = |point: P, factor| point.times(P::Scalar::from_i32(factor));
    let side = |a: P, b: P, c: P| {
        let mean = a.plus(c).times(P::Scalar::ratio(1, 2));
        let bend = mean.minus(b).times(P::Scalar::ratio(1, 3));
        let slope = a.minus(c).times(P::Scalar::ratio(1, 2));
        [b.plus(bend), slope, bend]
    };
    let [b0, b1, b2] = side(a0, a1, a2);
    let [b6, b5, b4] = side(a6, a5, a4);
    let at_corner = b0.plus(b6).minus(times(b1.plus(b5), 2));
    let b3 = a3.minus(at_corner).minus(times(b2.plus(b4), 11));
    [b0, b1, b2, b3, b4, b5, b6]
}

/// A wave around the ring, or what takes its place at frequency 0.
struct Wave {
    value: f64,
    centre: f64,
    edges: Vec<f64>,
    faces: Vec<f64>,
}

/// The values of all waves around a ring of n faces: a table of cosines, since the same few come again and again.
pub(super) struct Waves {
    /// cos(2πk/8n) for all k.
    cosines: Vec<f64>,
}

impl Waves {
    pub fn new(n: usize) -> Self {
        let cosines = (0..8 * n).map(|k| turn_cosine(k, 8 * n)).collect();
        Self { cosines }
    }

    /// cos(2πmj/n), or the sine: the cosine three quarters of a turn later.
    pub fn at_edge(&self, is_sine: bool, m: usize, j: usize) -> f64 {
        self.after(is_sine, 8 * m * j)
    }

    /// The same at half a face more, cos(2πm(j + ½)/n).
    pub fn at_face(&self, is_sine: bool, m: usize, j: usize) -> f64 {
        self.after(is_sine, 4 * m * (2 * j + 1))
    }

    fn after(&self, is_sine: bool, k: usize) -> f64 {
        let count = self.cosines.len();
        let shift = if is_sine { count / 4 * 3 } else { 0 };
        self.cosines[(k + shift) % count]
    }
}

/// The square root and the cosine of frequency m, of which the eigenvectors are made.
fn root_and_cosine(m: usize, n: usize) -> (f64, f64) {
    let s: f64 = turn_cosine(m, 2 * n);
    ((s * s + 4.0).sqrt(), s)
}

/// The two eigenvalues of frequency 0 other than 1.
fn still_values(n: usize) -> [f64; 2] {
    let n = n as f64;
    let root = (5.0 * n * n - 30.0 * n + 49.0).sqrt();
    let larger = (3.0 * n - 7.0 + root) / (8.0 * n);
    // The product is known; the difference would cancel.
    [larger, (n - 3.0) / (16.0 * n * larger)]
}

/// All modes of the ring but the constant one. Those of one eigenvalue stand together.
fn waves(n: usize) -> Vec<Wave> {
    let mut waves: Vec<Wave> = still_values(n)
        .map(|mu| Wave {
            value: mu,
            centre: 32.0 * mu * mu - 24.0 * mu + 2.0,
            edges: vec![12.0 * mu - 2.0; n],
            faces: vec![8.0 * mu + 2.0; n],
        })
        .into();
    let table = Waves::new(n);
    for m in 1..n.div_ceil(2) {
        let (root, s) = root_and_cosine(m, n);
        let larger = (2.0 + s * s + s * root) / 8.0;
        for (value, f) in [(larger, root - s), (1.0 / (16.0 * larger), -root - s)] {
            for is_sine in [false, true] {
                waves.push(Wave {
                    value,
                    centre: 0.0,
                    edges: (0..n).map(|j| table.at_edge(is_sine, m, j)).collect(),
                    faces: (0..n).map(|j| f * table.at_face(is_sine, m, j)).collect(),
                });
            }
        }
    }
    if n.is_multiple_of(2) {
        // The highest frequency: signs that alternate, in the edges alone and in the faces alone.
        let signs: Vec<f64> = (0..n).map(|j| table.at_edge(false, n / 2, j)).collect();
        for in_edges in [true, false] {
            let either = |is_here| if is_here { signs.clone() } else { vec![0.0; n] };
            waves.push(Wave {
                value: 0.25,
                centre: 0.0,
                edges: either(in_edges),
                faces: either(!in_edges),
            });
        }
    }
    waves
}

/// The eigenstructure of a vertex with n faces around it.
pub(super) fn spectrum<S: Real>(n: usize) -> Spectrum<S, 16, 7> {
    let rounded = |nets: [[f64; 16]; 3]| nets.map(|net| net.map(S::from_f64));
    let nets = |corner: &QuadCorner<f64>| rounded([0, 1, 2].map(|part| corner.net(part)));
    let corner = |wave: &Wave, outer| QuadCorner {
        is_closed: true,
        sector: 0,
        centre: wave.centre,
        edges: wave.edges.clone(),
        faces: wave.faces.clone(),
        outer,
    };
    let mode = |wave: &Wave| {
        let corner = corner(wave, [0.0; 7]);
        Mode {
            value: S::from_f64(wave.value),
            nets: nets(&corner),
            drive: outer_coordinates(corner.refined().outer).map(S::from_f64),
        }
    };
    let still = Wave {
        value: 0.0,
        centre: 0.0,
        edges: vec![0.0; n],
        faces: vec![0.0; n],
    };
    let outer_mode = |j: usize| {
        let outer = OUTER_VECTORS.map(|row| f64::from(row[j]));
        OuterMode {
            delta: OUTER_DELTAS[j],
            nets: nets(&corner(&still, outer)),
        }
    };
    Spectrum {
        modes: waves(n).iter().map(mode).collect(),
        outer: std::array::from_fn(outer_mode),
    }
}

/// The coordinates of a corner that is not on the boundary, in the basis that is number `spectrum` of all.
pub(super) fn coordinates<P>(corner: &QuadCorner<P>, spectrum: usize) -> Coordinates<P, 7>
where
    P: VectorSpace,
    P::Scalar: Real,
{
    let limit = corner.limit();
    let corner = corner.clone().mapped(|point| point.minus(limit));
    let n = corner.edges.len();
    let scaled = |point: P, factor: f64| point.times(P::Scalar::from_f64(factor));
    let [e, f] = corner
        .mean_offsets()
        .map(|offset| corner.centre.plus(offset));
    let [mu, nu] = still_values(n);
    // What remains without the other of the two eigenvectors; the determinant is 40 (μ₊ − μ₋).
    let coordinate = |other: f64, sign: f64| {
        let numerator = scaled(e, 8.0 * other + 2.0).minus(scaled(f, 12.0 * other - 2.0));
        scaled(numerator, sign / (40.0 * (mu - nu)))
    };
    let (of_mu, of_nu) = (coordinate(nu, 1.0), coordinate(mu, -1.0));
    let mut ring = vec![of_mu, of_nu];
    let table = Waves::new(n);
    for m in 1..n.div_ceil(2) {
        let [cosine, sine] =
            [false, true].map(|is_sine| wave_coordinates(&corner, &table, m, is_sine));
        ring.extend([cosine[0], sine[0], cosine[1], sine[1]]);
    }
    if n.is_multiple_of(2) {
        ring.extend([false, true].map(|in_faces| alternating(&corner, in_faces)));
    }
    Coordinates {
        spectrum,
        limit,
        ring,
        outer: outer_coordinates(corner.outer),
    }
}

/// The two coordinates of a frequency, larger eigenvalue first: a discrete Fourier transform, then the eigenvectors of two by two.
// ANCHOR: coordinates
fn wave_coordinates<P>(corner: &QuadCorner<P>, table: &Waves, m: usize, is_sine: bool) -> [P; 2]
where
    P: VectorSpace,
    P::Scalar: Real,
{
    let n = corner.edges.len();
    let scaled = |point: P, factor: f64| point.times(P::Scalar::from_f64(factor));
    let (mut e, mut f) = (P::origin(), P::origin());
    for j in 0..n {
        let k = (corner.sector + j) % n;
        e = e.plus(scaled(corner.edges[k], table.at_edge(is_sine, m, j)));
        f = f.plus(scaled(corner.faces[k], table.at_face(is_sine, m, j)));
    }
    let (root, s) = root_and_cosine(m, n);
    let unit = 2.0 / (n as f64 * 2.0 * root);
    let smaller = scaled(e, root - s).minus(f);
    [scaled(e, root + s).plus(f), smaller].map(|sum| scaled(sum, unit))
}
// ANCHOR_END: coordinates

/// The coordinate of the alternating signs, in the edges or in the faces.
fn alternating<P>(corner: &QuadCorner<P>, in_faces: bool) -> P
where
    P: VectorSpace,
    P::Scalar: Real,
{
    let points = if in_faces {
        &corner.faces
    } else {
        &corner.edges
    };
    let n = points.len();
    let signed = (0..n).map(|j| {
        let point = points[(corner.sector + j) % n];
        if j % 2 == 0 {
            point
        } else {
            P::origin().minus(point)
        }
    });
    let sum = signed.fold(P::origin(), P::plus);
    sum.times(P::Scalar::one() / P::Scalar::from_f64(n as f64))
}
