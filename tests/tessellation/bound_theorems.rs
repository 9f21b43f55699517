//! The theorems of the chord error's bound and of what follows for the number of cells. The book shows their doc comments.

use facette::algebra::{Scalar, VectorSpace};
use facette::tessellation::{cells_for, chord_error_bound, segments_for};
use num_traits::Zero;
use proptest::prelude::*;

use crate::common::exact::{Exact, fraction};
use crate::common::generators::coordinate;
use crate::common::law::expect_equal;
use crate::inputs::{expect, law};

/// A quadratic function, a triangle, and weights of its corners.
#[derive(Clone, Debug)]
struct Chord {
    /// The coefficients of u², uv and v².
    coefficients: [Exact; 3],
    corners: [[Exact; 2]; 3],
    weights: [Exact; 3],
}

impl Chord {
    fn height(&self, [u, v]: [Exact; 2]) -> Exact {
        let [a, b, c] = self.coefficients;
        a * u * u + b * u * v + c * v * v
    }

    fn error(&self) -> Exact {
        let on_surface = self.height(<[Exact; 2]>::combination(self.weights, self.corners));
        let on_triangle =
            Exact::combination(self.weights, self.corners.map(|corner| self.height(corner)));
        (on_surface - on_triangle).magnitude()
    }

    /// The bound from the sides of the box around the corners and the constant second derivatives `2a`, `b`, `2c`.
    fn bound(&self) -> Exact {
        let sides = [0, 1].map(|axis| {
            let [a, b, c] = self.corners.map(|corner| corner[axis]);
            let larger = |a, b| if a > b { a } else { b };
            larger(
                larger((a - b).magnitude(), (b - c).magnitude()),
                (c - a).magnitude(),
            )
        });
        let [a, b, c] = self.coefficients;
        let two = fraction(2, 1);
        chord_error_bound(
            sides,
            [(two * a).magnitude(), b.magnitude(), (two * c).magnitude()],
        )
    }
}

fn weights() -> impl Strategy<Value = [Exact; 3]> {
    [0..=9_i32, 0..=9_i32, 1..=9_i32].prop_map(|parts| {
        let sum: i32 = parts.iter().sum();
        parts.map(|part| fraction(part, sum))
    })
}

fn chords() -> impl Strategy<Value = Chord> {
    let corner = || [coordinate(), coordinate()];
    (
        [coordinate(), coordinate(), coordinate()],
        [corner(), corner(), corner()],
        weights(),
    )
        .prop_map(|(coefficients, corners, weights)| Chord {
            coefficients,
            corners,
            weights,
        })
}

/// Slivers, triangles without area, and middles of edges.
fn hard_chords() -> impl Strategy<Value = Chord> {
    let ends = || {
        prop::sample::select(vec![
            fraction(0, 1),
            fraction(1, 1),
            fraction(1, 1 << 20),
            fraction(-5, 1),
        ])
    };
    let corner = move || [ends(), ends()];
    let halves = prop::sample::select(vec![[1, 1, 0], [0, 1, 1], [1, 0, 1], [2, 0, 0]]);
    let weights = halves.prop_map(|halves| halves.map(|half| fraction(half, 2)));
    (
        [coordinate(), coordinate(), coordinate()],
        [corner(), corner(), corner()],
        weights,
    )
        .prop_map(|(coefficients, corners, weights)| Chord {
            coefficients,
            corners,
            weights,
        })
}

/// **The chord error.** Let $\ell_1\times\ell_2$ be the box around a triangle in the parameter plane, and let $M_{uu}$, $M_{uv}$, $M_{vv}$ bound the
/// lengths of $S_{uu}$, $S_{uv}$, $S_{vv}$ there. Then for $x=\sum\lambda_ix_i$ in the triangle
/// $$\Bigl|S(x)-\sum\lambda_iS(x_i)\Bigr|\le\tfrac18\bigl(\ell_1^2M_{uu}+2\ell_1\ell_2M_{uv}+\ell_2^2M_{vv}\bigr).$$
/// The test takes quadratic functions, whose second derivatives are constant, and any triangle, flat ones too.
///
/// Course: discretisation, slide 48, discretisation for display: how far the triangles are from the surface.
#[test]
fn chord_error_stays_below_the_bound_on_every_triangle() {
    let theorem = law("tessellation::chord_error_stays_below_the_bound_on_every_triangle");
    theorem
        .on_cases(256)
        .holds(chords(), hard_chords(), |chord| {
            let [error, bound] = [chord.error(), chord.bound()];
            expect(
                "an error of at most the bound",
                error <= bound,
                (error, bound),
            )
        });
}

/// **The bound is attained.** In the middle of the diagonal of a box, where the three second derivatives pull the same way, the error *is* the bound:
/// no smaller factor than $\tfrac18$ will do, and no smaller one than 2 for the mixed term.
#[test]
fn chord_error_bound_is_attained_in_the_middle_of_a_diagonal() {
    let theorem = law("tessellation::chord_error_bound_is_attained_in_the_middle_of_a_diagonal");
    let ordinary = (
        [coordinate(), coordinate(), coordinate()],
        [coordinate(), coordinate()],
    );
    let flat = (coordinate(), Just(Exact::zero())).prop_map(|(l1, l2)| [l1, l2]);
    let hard = ([coordinate(), coordinate(), coordinate()], flat);
    theorem.holds(ordinary, hard, |(coefficients, [l1, l2])| {
        let half = fraction(1, 2);
        let zero = Exact::zero();
        let chord = Chord {
            coefficients: coefficients.map(Scalar::magnitude),
            corners: [
                [zero, zero],
                [l1.magnitude(), l2.magnitude()],
                [zero, l2.magnitude()],
            ],
            weights: [half, half, zero],
        };
        expect_equal(&chord.bound(), &chord.error())
    });
}

fn bound() -> impl Strategy<Value = f64> {
    prop_oneof![0.01..100.0_f64, Just(0.0)]
}

/// **The fewest segments.** A side has as many equal segments as its own curve needs for half the tolerance, $n=\lceil\ell\sqrt{M/4\tau}\rceil$, and not one more: with $n-1$ the
/// bound exceeds $\tau/2$. A straight side has one.
#[test]
fn a_side_has_the_fewest_segments_for_half_the_tolerance() {
    let theorem = law("tessellation::a_side_has_the_fewest_segments_for_half_the_tolerance");
    let hard = (
        bound(),
        prop::sample::select(vec![1e-6, 10.0]),
        prop::sample::select(vec![1e-9, 1e9]),
    );
    theorem.holds(
        (bound(), 0.1..10.0_f64, 1e-4..1.0_f64),
        hard,
        |&(bound, length, tolerance)| {
            let count = segments_for(bound, length, tolerance).expect("fewer than 2^24 segments");
            let error = |segments: u32| {
                let side = length / f64::from(segments);
                bound * side * side / 8.0
            };
            let rounding = 1.0 + 32.0 * f64::EPSILON;
            expect(
                "half the tolerance",
                error(count) <= tolerance / 2.0 * rounding,
                error(count),
            )?;
            let is_fewest = count == 1 || error(count - 1) * rounding > tolerance / 2.0;
            expect("the fewest segments", is_fewest, (count, error(count - 1)))
        },
    );
}

/// **Cells of the right shape.** $n\times m$ cells keep the tolerance when $a/n^2+b/nm+c/m^2\le1$, with $a,b,c$ the three terms of the bound for the whole piece over the
/// tolerance. Real numbers would do it with $nm=2\sqrt{ac}+b$ from $n/m=\sqrt{a/c}$; the whole ones found keep the tolerance, and
/// number at most $(n+1)(m+1)$.
#[test]
fn cells_keep_the_tolerance_and_are_hardly_more_than_the_best() {
    let theorem = law("tessellation::cells_keep_the_tolerance_and_are_hardly_more_than_the_best");
    let bounds = || [bound(), bound(), bound()];
    let ruled = [bound(), bound()].prop_map(|[b, c]| [0.0, b, c]);
    let hard = (ruled, [1e-3..1e3, 1e-3..1e3], 1e-3..1.0_f64);
    theorem.holds(
        (bounds(), [0.1..10.0, 0.1..10.0], 1e-3..1.0_f64),
        hard,
        |&(bounds, sides, tolerance)| {
            let [l1, l2] = sides;
            let [columns, rows] =
                cells_for(bounds, sides, tolerance).expect("fewer than 2^24 cells");
            let [n, m] = [columns, rows].map(f64::from);
            let [a, b, c] = [
                bounds[0] * l1 * l1 / 8.0 / tolerance,
                bounds[1] * l1 * l2 / 4.0 / tolerance,
                bounds[2] * l2 * l2 / 8.0 / tolerance,
            ];
            let error = a / n / n + b / n / m + c / m / m;
            expect("the tolerance", error <= 1.0 + 32.0 * f64::EPSILON, error)?;
            // With one of the outer terms zero, the other direction takes all the cells.
            let best = if a == 0.0 || c == 0.0 {
                let of_other = if a == 0.0 { c } else { a };
                [1.0, (b / 2.0 + (b * b / 4.0 + of_other).sqrt()).max(1.0)]
            } else {
                let m = (2.0 * c + b * (c / a).sqrt()).sqrt().max(1.0);
                let k = (1.0 - c / m / m).max(f64::MIN_POSITIVE);
                let n = f64::midpoint(b / m, ((b / m).powi(2) + 4.0 * a * k).sqrt()) / k;
                [n.max(1.0), m]
            };
            let most = (best[0] + 1.0) * (best[1] + 1.0);
            expect(
                "hardly more cells than the best",
                n * m <= most * (1.0 + 1e-9),
                (n * m, most),
            )
        },
    );
}
