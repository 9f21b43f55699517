//! Parameters brought back into one period.

use crate::algebra::Scalar;

/// `t₀ + t₁ − t`, the parameter as far from the other end.
pub(super) fn mirrored<S: Scalar>(t: S, [start, end]: [S; 2]) -> S {
    start + (end - t)
}

/// The parameter of `[start, end)` that lies whole periods from `t`, and whether their number is odd.
///
/// The remainder is found by long division in base 2: every subtraction takes off more than half of what is left and is exact, however
/// many periods there are.
// ANCHOR: wrapped_parameter
pub(super) fn wrapped_parameter<S: Scalar>(t: S, [start, end]: [S; 2]) -> (S, bool) {
    if start <= t && t < end {
        return (t, false);
    }
    let period = end - start;
    let distance = if t < start { start - t } else { t - start };
    if !Scalar::is_finite(distance) || !Scalar::is_finite(period) {
        let not_a_number = (distance + period) * S::zero();
        return (not_a_number, false);
    }
    let (rest, mut is_odd) = remainder(distance, period);
    let mut offset = rest;
    if t < start && !rest.is_zero() {
        offset = period - rest;
        is_odd = !is_odd;
    }
    let inside = start + offset;
    if inside < end {
        (inside, is_odd)
    } else {
        (start, !is_odd)
    }
}
// ANCHOR_END: wrapped_parameter

/// The remainder of `distance / period`, exactly, and whether the quotient is odd.
fn remainder<S: Scalar>(distance: S, period: S) -> (S, bool) {
    let two = S::one() + S::one();
    let mut step = period;
    let mut steps = 0_u32;
    while step <= distance / two {
        step = step * two;
        steps += 1;
    }
    let (mut rest, mut is_odd) = (distance, false);
    for remaining in (0..=steps).rev() {
        is_odd = rest >= step;
        if is_odd {
            rest = rest - step;
        }
        if remaining > 0 {
            step = step / two;
        }
    }
    (rest, is_odd)
}
