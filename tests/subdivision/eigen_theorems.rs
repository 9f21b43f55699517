//! The eigenvalues of the local subdivision matrices, read from the schemes as they run.

use facette::mesh::Mesh;
use facette::subdivision::limit::{
    Eigenvalues, catmull_clark_eigenvalues, catmull_clark_ring_eigenvalues,
    catmull_clark_vertex_eigenvalues, doo_sabin_eigenvalue, doo_sabin_eigenvalues,
    loop_eigenvalues, loop_ring_eigenvalue, loop_vertex_eigenvalue, sqrt3_eigenvalues,
    sqrt3_ring_eigenvalue, sqrt3_vertex_eigenvalue,
};
use facette::subdivision::mask::{loop_vertex_weight, sqrt3_neighbours_weight, turn_cosine};
use facette::subdivision::{Corners, DooSabinWeights};

use crate::common::dice::Dice;
use crate::limit_inputs::{joined, neighbourhood};
use crate::meshes::{double_fan, polygon, quad_fan};
use crate::steps::Scheme;

/// The valences of the theorems.
const ALL: std::ops::RangeInclusive<usize> = 3..=50;

/// Waves are applied in a step of a few operations, with sums of up to 100 terms of size 1 at most: their error stays below this.
const ROUNDING: f64 = 128.0 * f64::EPSILON;

fn small(n: usize) -> u32 {
    u32::try_from(n).expect("a small number")
}

fn step(scheme: Scheme, mesh: &Mesh<f64>) -> Mesh<f64> {
    scheme
        .step_with(mesh, 0, Corners::Sharp, turn_cosine)
        .expect("a small mesh")
}

/// The values at vertex 0, at its neighbours, and at the corners opposite to it in its faces.
fn ring(mesh: &Mesh<f64>) -> (f64, Vec<f64>, Vec<f64>) {
    let joined = joined(mesh);
    let at = |vertex: u32| mesh.positions[vertex as usize];
    let neighbours = joined.around(0).map(|h| at(joined.target(h))).collect();
    let opposite = joined
        .around(0)
        .map(|h| at(joined.target(joined.next(h))))
        .collect();
    (at(0), neighbours, opposite)
}

fn assert_close(what: &str, expected: f64, got: f64) {
    assert!(
        (expected - got).abs() <= ROUNDING,
        "{what}: expected {expected}, got {got}"
    );
}

/// cos(π(2jk + j·half)/n): a wave of frequency j at spoke k, or half a spoke further.
fn wave(j: usize, k: usize, half: usize, n: usize) -> f64 {
    turn_cosine(2 * j * k + j * half, 2 * n)
}

/// The amplitude of a wave in the values, by the spoke where it is largest.
fn amplitude(values: &[f64], wave: impl Fn(usize) -> f64) -> f64 {
    let sum: f64 = values
        .iter()
        .enumerate()
        .map(|(k, value)| value * wave(k))
        .sum();
    let norm: f64 = (0..values.len()).map(|k| wave(k) * wave(k)).sum();
    sum / norm
}

/// **Eigenvalues of Catmull-Clark.** A wave of frequency $j$ on the neighbours and on the corners opposite stays such a wave. For $0<j<n$, $c=\cos\frac{2\pi j}n$, its two eigenvalues are $\frac1{16}\left(5+c\pm\sqrt{(1+c)(9+c)}\right)$, and their product is $\frac1{16}$.
/// Constant values, with the vertex itself, have the eigenvalues $1$ and $\mu_\pm=\dfrac{3n-7\pm\sqrt{5n^2-30n+49}}{8n}$. Read from a step of the scheme for $n=3,\dots,50$ and every $j$: trace and determinant of each block.
///
/// Course: D23, slide 76, Catmull-Clark at extraordinary points.
#[test]
fn blocks_of_catmull_clark_have_these_eigenvalues() {
    for n in ALL {
        let topology = quad_fan(small(n));
        let applied = |v: f64, e: &dyn Fn(usize) -> f64, f: &dyn Fn(usize) -> f64| {
            let points = std::iter::once(v).chain((0..n).map(e)).chain((0..n).map(f));
            ring(&step(
                Scheme::CatmullClark,
                &topology.with_points(points.collect()),
            ))
        };
        for j in 1..n {
            if 2 * j == n {
                // Every corner opposite lies on a node of the wave.
                let (_, e, _) = applied(0.0, &|k| wave(j, k, 0, n), &|_| 0.0);
                assert_close(
                    "frequency n/2",
                    catmull_clark_ring_eigenvalues(-1.0)[0],
                    e[0],
                );
                continue;
            }
            let [at, beside] = [0, 1].map(|half| move |k| wave(j, k, half, n));
            let (_, ee, ef) = applied(0.0, &at, &|_| 0.0);
            let (_, fe, ff) = applied(0.0, &|_| 0.0, &beside);
            let [[a, b], [c, d]] =
                [(ee, ef), (fe, ff)].map(|(e, f)| [amplitude(&e, at), amplitude(&f, beside)]);
            let [larger, smaller] = catmull_clark_ring_eigenvalues(turn_cosine::<f64>(j, n));
            assert_close("trace", larger + smaller, a + d);
            assert_close("determinant", larger * smaller, a * d - b * c);
        }
        let columns = [(1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)].map(|(v, e, f)| {
            let (v, e, f) = applied(v, &|_| e, &|_| f);
            [v, e[0], f[0]]
        });
        let [larger, smaller] = catmull_clark_vertex_eigenvalues::<f64>(n);
        assert_close(
            "trace of constants",
            1.0 + larger + smaller,
            (0..3).map(|k| columns[k][k]).sum(),
        );
        assert_close(
            "determinant of constants",
            larger * smaller,
            determinant(columns),
        );
    }
}

fn determinant([a, b, c]: [[f64; 3]; 3]) -> f64 {
    a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0])
        + a[2] * (b[0] * c[1] - b[1] * c[0])
}

/// **Eigenvalues of Loop and √3.** A wave of frequency $0<j<n$ on the neighbours is multiplied by $\frac38+\frac14\cos\frac{2\pi j}n$ in Loop's scheme; in $\sqrt3$ by $\frac23\cos\frac{\pi j}n$, and moved on by half a spoke. Constant values and the vertex have the eigenvalues 1 and
/// $\mu=\alpha-\frac38$ (Loop), $\mu=\frac23-\alpha$ ($\sqrt3$), both $\lambda^2$: that is what the weights are chosen for. Read from a step of the scheme for $n=3,\dots,50$ and every $j$.
///
/// Course: D24, slide 77, Loop at extraordinary points.
#[test]
fn blocks_of_the_triangle_schemes_have_these_eigenvalues() {
    for n in ALL {
        let topology = double_fan(small(n));
        let applied = |scheme, v: f64, q: &dyn Fn(usize) -> f64| {
            let outer = vec![0.0; topology.vertex_count - 1 - n];
            let points = std::iter::once(v).chain((0..n).map(q)).chain(outer);
            let (v, q, _) = ring(&step(scheme, &topology.with_points(points.collect())));
            (v, q)
        };
        for j in 1..n {
            let at = |k| wave(j, k, 0, n);
            let (_, q) = applied(Scheme::Loop, 0.0, &at);
            assert_close(
                "Loop",
                loop_ring_eigenvalue(turn_cosine(j, n)),
                amplitude(&q, at),
            );
            // The ring begins with the centroid before the first neighbour.
            let (_, q) = applied(Scheme::Sqrt3, 0.0, &at);
            if 2 * j == n {
                assert_close("√3 on nodes", 0.0, q[0]);
            } else {
                let before = |k| wave(j, k + n - 1, 1, n);
                let lambda = sqrt3_ring_eigenvalue(turn_cosine(j, 2 * n));
                assert_close("√3", lambda, amplitude(&q, before).abs());
            }
        }
        let cosine = turn_cosine::<f64>(1, n);
        let mus = [
            (
                Scheme::Loop,
                loop_vertex_eigenvalue(loop_vertex_weight(cosine)),
            ),
            (
                Scheme::Sqrt3,
                sqrt3_vertex_eigenvalue(sqrt3_neighbours_weight(cosine)),
            ),
        ];
        for (scheme, mu) in mus {
            let (vv, _) = applied(scheme, 1.0, &|_| 0.0);
            let (_, qq) = applied(scheme, 0.0, &|_| 1.0);
            assert_close("trace of constants", 1.0 + mu, vv + qq[0]);
        }
        let squares =
            [loop_eigenvalues::<f64>(n), sqrt3_eigenvalues(n)].map(|e| e.tangent * e.tangent);
        assert_close("Loop's μ is λ²", squares[0], mus[0].1);
        assert_close("√3's μ is λ²", squares[1], mus[1].1);
    }
}

/// **Eigenvalues of Doo-Sabin.** In an $n$-gon a wave of frequency $0<j<n$ is multiplied by $\frac12+\frac14\cos\frac{2\pi j}n$ with the averaging weights of the slides; with Doo's and Sabin's own by $\frac12$ for $j=1$ and $j=n-1$, and by $\frac14$ for all others. So their faces shrink by the same half at every
/// $n$, and become flat at the same rate; with averaging $\lambda$ runs from $\frac38$ at $n=3$ to $\frac34$. Read from a step of the scheme for $n=3,\dots,50$ and every $j$.
///
/// Course: D16, slide 68, Doo-Sabin on n-gons: two kinds of weights.
#[test]
fn blocks_of_doo_sabin_have_these_eigenvalues() {
    for n in ALL {
        let topology = polygon(small(n));
        for weights in [DooSabinWeights::Own, DooSabinWeights::Averaging] {
            for j in 1..n {
                let at = |k| wave(j, k, 0, n);
                let mesh = topology.with_points((0..n).map(at).collect());
                let shrunken = step(Scheme::DooSabin(weights), &mesh).positions[..n].to_vec();
                let expected = doo_sabin_eigenvalue(weights, n, j, turn_cosine(j, n));
                assert_close("wave", expected, amplitude(&shrunken, at));
            }
        }
    }
}

/// All eigenvalues λ and μ for a valence: Catmull-Clark, Loop, √3, Doo-Sabin's own and averaging.
fn all_of(n: usize) -> [Eigenvalues<f64>; 5] {
    [
        catmull_clark_eigenvalues(n),
        loop_eigenvalues(n),
        sqrt3_eigenvalues(n),
        doo_sabin_eigenvalues(n, DooSabinWeights::Own),
        doo_sabin_eigenvalues(n, DooSabinWeights::Averaging),
    ]
}

/// **The order that makes a tangent plane.** For $n=3,\dots,50$ (and 200) all four schemes have $1>\lambda=\lambda>|\mu|$: two equal eigenvalues next to 1, for one turn either way, and all others smaller. Then the ring, less its limit and over $\lambda^k$, tends to a flat picture of the two tangents. With growing $n$
/// $\lambda$ tends to $\frac{6+2\sqrt5}{16}=0.6545$ for Catmull-Clark, $\frac58$ for Loop, $\frac23$ for $\sqrt3$ and $\frac34$ for averaging, and $\mu$ comes so close to it that many steps are needed to see the plane.
///
/// Course: D23, slide 76, Catmull-Clark: continuity at extraordinary points.
#[test]
fn tangents_have_the_largest_eigenvalue_after_one() {
    for n in ALL.chain([200]) {
        for (scheme, Eigenvalues { tangent, next }) in all_of(n).into_iter().enumerate() {
            assert!(
                tangent < 1.0 && next < tangent,
                "scheme {scheme}, valence {n}"
            );
        }
    }
    let limits = [
        (6.0 + 2.0 * 5.0_f64.sqrt()) / 16.0,
        0.625,
        2.0 / 3.0,
        0.5,
        0.75,
    ];
    for (at_infinity, at_10000) in limits.into_iter().zip(all_of(10_000)) {
        // A cosine is at most half the square of its angle below 1, and each eigenvalue changes by at most a quarter of that.
        let nearly = (std::f64::consts::TAU / 1e4).powi(2) / 8.0;
        assert!((at_infinity - at_10000.tangent).abs() <= nearly);
    }
    let [cc, _, _, _, averaging] = all_of(100);
    // To half a unit of the fifth digit.
    assert!((cc.tangent - 0.654_22).abs() < 5e-6 && (cc.next - 0.653_35).abs() < 5e-6);
    assert!(averaging.next / averaging.tangent > 0.99);
}

/// **What lies beyond the ring counts less.** Values that are zero on a vertex and its ring stay zero there. What remains of the matrix, for the next ring of neighbours, has no eigenvalue above $\frac18$ for Catmull-Clark and Loop: after $k$ steps such values are at most $8\cdot8^{-k}$ times as large. For $\sqrt3$ the largest is $\frac1{18}(1+\sqrt7)=0.2025$. So
/// the eigenvalues of the ring decide, except at $n=3$ for Loop, where $\frac18>\lambda^2=\frac1{16}$, and for $\sqrt3$, where $0.2025>\lambda^2=\frac19$.
///
/// Course: D24, slide 77, Loop at extraordinary points.
#[test]
fn beyond_the_ring_values_shrink_by_an_eighth() {
    for (scheme, rate) in [
        (Scheme::CatmullClark, 0.125_f64),
        (Scheme::Loop, 0.125),
        (Scheme::Sqrt3, (1.0 + 7.0_f64.sqrt()) / 18.0),
    ] {
        let mut worst = 0.0_f64;
        for n in [3, 4, 5, 6, 7, 9, 12, 20, 50] {
            let is_quad = scheme == Scheme::CatmullClark;
            let start = if is_quad { quad_fan(n) } else { double_fan(n) };
            let flat = start.with_points(vec![0.0; start.vertex_count]);
            let wide = (0..3).fold(flat, |mesh, _| neighbourhood(&step(scheme, &mesh), 0, 3));
            let mut dice = Dice::new(u64::from(n));
            let joined = joined(&wide);
            let in_ring = |v: u32| {
                v == 0
                    || joined
                        .around(0)
                        .any(|h| joined.vertices_of(joined.face_of(h)).contains(&v))
            };
            let count = small(wide.positions.len());
            let values = (0..count).map(|v| if in_ring(v) { 0.0 } else { dice.roll() });
            let mut mesh = Mesh::new(values.collect(), wide.faces()).expect("the same faces");
            for k in 0..8 {
                mesh = neighbourhood(&step(scheme, &mesh), 0, 2);
                let largest = mesh.positions.iter().fold(0.0, |a: f64, x| a.max(x.abs()));
                worst = worst.max(largest / rate.powi(k + 1));
            }
        }
        println!("{scheme:?}: {worst:.3}");
        assert!((0.4..=8.0).contains(&worst), "{scheme:?}: {worst}");
    }
}

/// **Where curvature is bounded.** It cannot be where $|\mu|>\lambda^2$, since heights shrink by $\mu$ and squares of lengths by $\lambda^2$. For Catmull-Clark at $n=5$ it is unbounded, $\mu=0.3401>\lambda^2=0.3025$, nor at any $n\ge5$; at $n=3$ the surface is flat in the point, $\mu=\frac16<\lambda^2=0.1682$. For Loop and
/// $\sqrt3$ it is bounded for $n=4,5,6$ and unbounded from 7 on, where saddles have the eigenvalue $\frac38+\frac14\cos\frac{4\pi}n$ and $\frac23\cos\frac{2\pi}n$, and at $n=3$, because of what lies beyond the ring. For Doo-Sabin with averaging it is unbounded at 3 and from 7 on; with its own weights $\mu=\frac14=\lambda^2$ at every $n$,
/// and the eigenvalues alone do not decide.
///
/// Course: D23, slide 76, Catmull-Clark: C2 except at extraordinary points.
#[test]
fn curvature_is_bounded_where_mu_is_at_most_lambda_squared() {
    let excess = |n: usize| all_of(n).map(|e| e.next / (e.tangent * e.tangent));
    let [cc3, loop3, sqrt3_at_3, own3, averaging3] = excess(3);
    assert!(cc3 < 1.0 && (cc3 - 0.1667 / 0.1682).abs() < 1e-3, "{cc3}");
    assert_eq!([loop3, own3], [2.0, 1.0]);
    assert!((sqrt3_at_3 - 0.5 * (1.0 + 7.0_f64.sqrt())).abs() < 1e-14);
    assert!((averaging3 - 16.0 / 9.0).abs() < 1e-15);
    for n in 4..=50 {
        let [cc, loops, sqrt3, own, averaging] = excess(n);
        let is_bounded = |ratio: f64| ratio <= 1.0 + ROUNDING;
        assert_eq!(is_bounded(cc), n <= 4, "Catmull-Clark {n}: {cc}");
        assert_eq!(is_bounded(loops), n <= 6, "Loop {n}: {loops}");
        assert_eq!(is_bounded(sqrt3), n <= 6, "√3 {n}: {sqrt3}");
        assert_eq!(is_bounded(averaging), n <= 6, "averaging {n}: {averaging}");
        assert!(is_bounded(own));
    }
    let Eigenvalues { tangent, next } = catmull_clark_eigenvalues::<f64>(5);
    assert!((next - 0.3401).abs() < 5e-5 && (tangent * tangent - 0.3025).abs() < 5e-5);
}
