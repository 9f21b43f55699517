//! The theorems of the masks: weights as functions of the valence. The book shows their doc comments.

use facette::subdivision::mask::{
    averaging_weight, doo_sabin_weight, loop_vertex_weight, sqrt3_neighbours_weight, turn_cosine,
};
use num_bigint::BigInt;
use num_traits::{One, Signed, ToPrimitive, Zero};
use proptest::prelude::*;

use crate::common::exact::{Exact, fraction};
use crate::common::law::{Law, expect_at_most, expect_equal};
use crate::steps::rational_cosine;
use crate::suspects;

/// How many bits after the point the cosines of this file have.
const BITS: u32 = 256;

fn whole(value: usize) -> BigInt {
    BigInt::from(value) << BITS
}

/// arctan(1/x) in multiples of 2⁻²⁵⁶, by its power series.
fn arctan_of_reciprocal(x: usize) -> BigInt {
    let (mut power, mut sum, mut odd) = (whole(1) / x, BigInt::zero(), 1_usize);
    while !power.is_zero() {
        let term = &power / odd;
        sum += if odd % 4 == 1 { term } else { -term };
        power /= x * x;
        odd += 2;
    }
    sum
}

/// cos(2πk/n) in multiples of 2⁻²⁵⁶, for 0 ≤ k < n: Machin's π, and the power series of the cosine.
fn big_cosine(k: usize, n: usize) -> BigInt {
    let pi = 16 * arctan_of_reciprocal(5) - 4 * arctan_of_reciprocal(239);
    let angle = 2 * pi * k / n;
    let (mut term, mut sum, mut even) = (whole(1), BigInt::zero(), 0_usize);
    while !term.is_zero() {
        sum += &term;
        even += 2;
        let once: BigInt = (&term * &angle) >> BITS;
        let twice: BigInt = (once * &angle) >> BITS;
        term = -twice / (even * (even - 1));
    }
    sum
}

/// The error of a computed cosine in units of roundoff, 2⁻⁵³.
fn error_of(computed: f64, exact: &BigInt) -> f64 {
    let computed = num_rational::BigRational::from_float(computed).expect("a finite number");
    let difference = computed * whole(1) - exact.clone();
    let unit = BigInt::one() << (BITS - 53);
    (difference.abs() / unit).to_f64().expect("a ratio")
}

/// **Cosines of parts of a turn.** `turn_cosine` gives $\cos\frac{2\pi k}n$ within $3\mathbf u$, and the number itself wherever it is rational: $1,\frac12,0,-\frac12,-1$. The angle is first brought into the eighth of a turn next to an axis, in whole numbers, so it is at most $\frac\pi4$; there
/// $2\pi$, its product with $k$ and the quotient by $n$ are wrong by at most $\frac52\mathbf u$ of the angle together, which moves the cosine by at most $\frac52\cdot\frac\pi4\sin\frac\pi4\mathbf u<\frac32\mathbf u$ and the sine by less than $2\mathbf u$; the function itself adds at most $\mathbf u$.
///
/// Course: D16, slide 68, Doo-Sabin: faces with any number of corners.
#[test]
fn turn_cosine_is_within_three_roundoffs() {
    let worst = std::cell::Cell::new(0.0_f64);
    let law = Law::new(
        "subdivision::turn_cosine_is_within_three_roundoffs",
        suspects::library,
    );
    let parts = |n: std::ops::RangeInclusive<usize>| n.prop_flat_map(|n| (0..n, Just(n)));
    law.on_cases(400)
        .holds(parts(1..=300), parts(1..=24), |&(k, n)| {
            let computed: f64 = turn_cosine(k, n);
            let error = error_of(computed, &big_cosine(k, n));
            worst.set(worst.get().max(error));
            expect_at_most("an error, in units of roundoff,", 3.0, error)?;
            let halves = [(0, 2), (2, 1), (3, 0), (4, -1), (6, -2)];
            for (twelfths, halves) in halves {
                if twelfths * n == 12 * k {
                    expect_equal(&(f64::from(halves) / 2.0), &computed)?;
                }
            }
            expect_equal(&computed, &turn_cosine(n - k, n))
        });
    println!("largest error seen: {} of 3", worst.get());
    assert!(worst.get() > 3.0 / 20.0, "only {}", worst.get());
}

/// **The weights of a mask sum to one.** So do Doo's and Sabin's, $\frac{n+5}{4n}+\sum_{k=1}^{n-1}\frac{3+2\cos(2\pi k/n)}{4n}=1$, since the cosines of all parts of a turn sum to 0; and those of the slides' mean, for every $n\ge3$. All of them are positive: each new point is a mean.
///
/// Course: D16, slide 68, Doo-Sabin: faces with any number of corners.
#[test]
fn doo_sabin_weights_are_those_of_a_mean() {
    for n in 3..=200 {
        let averaging: Vec<Exact> = (0..n).map(|steps| averaging_weight(n, steps)).collect();
        assert!(averaging.iter().all(|&weight| weight > Exact::zero()));
        assert_eq!(
            averaging.into_iter().fold(Exact::zero(), |a, b| a + b),
            Exact::one()
        );
        let own = |steps| doo_sabin_weight::<f64>(n, steps, turn_cosine(steps, n));
        assert!((0..n).all(|steps| own(steps) > 0.0));
    }
    // Where all cosines are rational.
    for n in [3, 4, 6] {
        let own = (0..n).map(|steps| doo_sabin_weight(n, steps, rational_cosine(steps, n)));
        assert_eq!(own.fold(Exact::zero(), |a, b| a + b), Exact::one());
    }
}

/// **Loop's and Kobbelt's weights are those of means.** For every valence $n\ge3$ Loop's $\alpha_n$ lies between $\frac{7}{16}$ and $\frac{49}{64}$, and Kobbelt's between $\frac29$ and $\frac59$; both go monotonically with the valence. At valence 6 Loop's is $\frac58$, and Kobbelt's $\frac13$.
///
/// Course: D26, slide 78, Loop: any valence.
#[test]
fn weights_of_triangles_go_with_the_valence() {
    let loops = |n| loop_vertex_weight::<f64>(turn_cosine(1, n));
    let kobbelts = |n| sqrt3_neighbours_weight::<f64>(turn_cosine(1, n));
    for n in 3..200 {
        assert!(loops(n) < loops(n + 1) && kobbelts(n) > kobbelts(n + 1));
    }
    let [first, last] = [loops(3), loops(200)];
    assert!(first == 7.0 / 16.0 && last < 49.0 / 64.0);
    assert!(kobbelts(3) <= 5.0 / 9.0 && kobbelts(200) > 2.0 / 9.0);
    assert_eq!(loop_vertex_weight(fraction(1, 2)), fraction(5, 8));
    let kobbelts = [3, 4, 6].map(|n| sqrt3_neighbours_weight::<Exact>(rational_cosine(1, n)));
    assert_eq!(kobbelts, [fraction(5, 9), fraction(4, 9), fraction(1, 3)]);
}
