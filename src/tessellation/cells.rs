//! How many cells a chord error needs.

use crate::algebra::{Real, Scalar};

/// The most cells along one direction of one piece: what single precision can count.
const MOST_CELLS: i32 = 1 << 24;

/// The bound `(l₁² M_uu + 2 l₁ l₂ M_uv + l₂² M_vv) / 8` of the chord error of any triangle in a parameter box of these sides.
///
/// # Accuracy
///
/// Rounded up: never below the exact value of the formula, as long as no product underflows, and at most `24u` of it above.
///
/// # Edge cases
///
/// Infinite where the formula overflows; NaN for NaN.
///
/// # Source
///
/// Filip, Magedson and Markot 1986 for right triangles; the module's header for all.
// ANCHOR: chord_error_bound
pub fn chord_error_bound<S: Scalar>([l1, l2]: [S; 2], [m_uu, m_uv, m_vv]: [S; 3]) -> S {
    let twice = S::from_i32(2);
    let sum = m_uu * l1 * l1 + twice * (m_uv * l1 * l2) + m_vv * l2 * l2;
    sum * S::ratio(1, 8) * (S::one() + S::from_i32(16) * S::unit_roundoff())
}
// ANCHOR_END: chord_error_bound

/// The smallest number of equal segments of a curve over an interval of this length, with `|C″|` at most `bound`, whose chord error is
/// at most half the tolerance; `None` where 2²⁴ are not enough.
///
/// Half, because the triangles next to a side also bend across it.
// ANCHOR: segments_for
pub fn segments_for<S: Real>(bound: S, length: S, tolerance: S) -> Option<u32> {
    smallest_count(|n| {
        let error = chord_error_bound([length / n, S::zero()], [bound, S::zero(), S::zero()]);
        error + error <= tolerance
    })
}
// ANCHOR_END: segments_for

/// The numbers `[columns, rows]` of equal cells of a box of these sides whose chord error is at most the tolerance, with the
/// smallest product that the best real numbers and their neighbours give; `None` where 2²⁴ along a side are not enough.
///
/// # Source
///
/// With `a`, `b`, `c` the three terms of the bound over the tolerance, `a/n² + b/(nm) + c/m² = 1` makes `nm` smallest where
/// `n/m = √(a/c)`, and there `m² = 2c + b√(c/a)`.
// ANCHOR: cells_for
pub fn cells_for<S: Real>(bounds: [S; 3], [l1, l2]: [S; 2], tolerance: S) -> Option<[u32; 2]> {
    let fits = |n: S, m: S| chord_error_bound([l1 / n, l2 / m], bounds) <= tolerance;
    let columns_for = |m: u32| Some([smallest_count(|n| fits(n, number(m)))?, m]);
    let middle = best_rows(bounds, [l1, l2], tolerance).unwrap_or(1);
    let rows = [
        middle.saturating_sub(1).max(1),
        middle,
        middle.saturating_add(1),
    ];
    let is_ruled_in_u = bounds[0].is_zero() && bounds[2] > S::zero();
    let single_column = smallest_count(|m| fits(S::one(), m)).filter(|_| is_ruled_in_u);
    let candidates = rows.into_iter().filter_map(columns_for);
    let candidates = candidates.chain(single_column.map(|m| [1, m]));
    candidates.min_by_key(|&[n, m]| u64::from(n) * u64::from(m))
}
// ANCHOR_END: cells_for

/// The real number of rows at which the fewest cells are enough, rounded up; with `a = 0`, where there is no least one, that for `n = m` up to a
/// factor.
fn best_rows<S: Real>([m_uu, m_uv, m_vv]: [S; 3], [l1, l2]: [S; 2], tolerance: S) -> Option<u32> {
    let zero = S::zero();
    let over = |term: S| term / tolerance;
    let a = over(chord_error_bound([l1, zero], [m_uu, zero, zero]));
    let b = over(chord_error_bound([l1, l2], [zero, m_uv, zero]));
    let c = over(chord_error_bound([zero, l2], [zero, zero, m_vv]));
    let square = if a > zero {
        c + c + b * (c / a).sqrt()
    } else {
        c + c + b
    };
    smallest_count(|m: S| m * m >= square)
}

/// The smallest count from 1 to 2²⁴ that fits, where every larger one does too.
fn smallest_count<S: Scalar>(fits: impl Fn(S) -> bool) -> Option<u32> {
    let fits = |count: i32| fits(S::from_i32(count));
    let mut high = 1;
    while !fits(high) {
        if high >= MOST_CELLS {
            return None;
        }
        high *= 2;
    }
    let mut low = high / 2;
    while high - low > 1 {
        let middle = i32::midpoint(low, high);
        if fits(middle) {
            high = middle;
        } else {
            low = middle;
        }
    }
    u32::try_from(high).ok()
}

/// A count as a scalar; counts here are at most 2²⁴ + 1.
pub(super) fn number<S: Scalar>(count: u32) -> S {
    S::from_i32(i32::try_from(count).unwrap_or(i32::MAX))
}
