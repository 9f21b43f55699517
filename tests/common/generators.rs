//! Generators of inputs, ordinary and hard. The exact ones draw small fractions, so that polynomials of the degrees that the
//! chapters use stay within [`Exact`](super::exact::Exact).

use proptest::prelude::*;

use super::exact::{Exact, fraction};

/// A coordinate: a fraction with a numerator up to 12 and a denominator up to 6.
pub fn coordinate() -> impl Strategy<Value = Exact> {
    (-12_i32..=12, 1_i32..=6).prop_map(|(numerator, denominator)| fraction(numerator, denominator))
}

/// A point of space.
pub fn point() -> impl Strategy<Value = [Exact; 3]> {
    [coordinate(), coordinate(), coordinate()]
}

/// A parameter between 0 and 1, with a denominator up to 12.
pub fn parameter() -> impl Strategy<Value = Exact> {
    (1_i32..=12).prop_flat_map(|denominator| {
        (0..=denominator).prop_map(move |numerator| fraction(numerator, denominator))
    })
}

/// A parameter at an end, next to one, in the middle, or outside.
pub fn hard_parameter() -> impl Strategy<Value = Exact> {
    const TINY: i32 = 1 << 30;
    prop::sample::select(vec![
        fraction(0, 1),
        fraction(1, 1),
        fraction(1, TINY),
        fraction(TINY - 1, TINY),
        fraction(1, 2),
        fraction(-1, 3),
        fraction(4, 3),
    ])
}

/// A coordinate in floating point: of ordinary size, with all bits in use.
pub fn float_coordinate() -> impl Strategy<Value = f64> {
    -10.0..10.0_f64
}

/// A coordinate far from the origin, tiny, huge, or zero.
pub fn hard_float_coordinate() -> impl Strategy<Value = f64> {
    let far = (-1.0..1.0_f64).prop_map(|offset| 1e8 + offset);
    let tiny = (-1.0..1.0_f64).prop_map(|factor| factor * 1e-30);
    let huge = (-1.0..1.0_f64).prop_map(|factor| factor * 1e30);
    prop_oneof![far, tiny, huge, Just(0.0), Just(1.0 / 3.0)]
}

/// A parameter in floating point, all bits in use.
pub fn float_parameter() -> impl Strategy<Value = f64> {
    0.0..1.0_f64
}

/// A floating-point parameter at an end or one step from it, or denormal.
pub fn hard_float_parameter() -> impl Strategy<Value = f64> {
    let below_one = 1.0 - f64::EPSILON / 2.0;
    prop::sample::select(vec![
        0.0,
        1.0,
        below_one,
        f64::from_bits(1),
        0.5,
        1.0 / 3.0,
        1e-9,
    ])
}
