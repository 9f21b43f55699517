//! Whole numbers of many digits: what the exact decisions about triangles are added up in.
//!
//! Two of them are exact, each with the range that its inputs ask for. The [triangle's](super::triangle) long accumulator takes products of any three `f64`,
//! 99 limbs; only signs and rounded quotients are asked of it. The [hierarchy's](super::hierarchy) integers come from `f32` and have 14 limbs, few enough that fractions of
//! them are compared by multiplying crosswise. Both are sums of shifted products in two's complement, which are here.

use std::cmp::Ordering;

/// A whole number in two's complement, least limb first. It wraps around: the users know how large their sums are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Limbs<const N: usize>(pub(super) [u64; N]);

impl<const N: usize> Limbs<N> {
    pub(super) const ZERO: Self = Self([0; N]);

    /// Adds or subtracts the number with these limbs, the first of them at limb number `first`. Limbs beyond the last must be 0.
    #[inline]
    pub(super) fn add<const M: usize>(&mut self, limbs: &[u64; M], first: usize, negated: bool) {
        let mut carry = false;
        for (place, limb) in self.0.iter_mut().skip(first).enumerate() {
            if place >= M && !carry {
                return;
            }
            let other = limbs.get(place).copied().unwrap_or(0);
            (*limb, carry) = if negated {
                limb.borrowing_sub(other, carry)
            } else {
                limb.carrying_add(other, carry)
            };
        }
    }

    #[inline]
    pub(super) fn is_negative(&self) -> bool {
        self.0.last().is_some_and(|limb| limb >> 63 == 1)
    }

    /// Less, equal or greater than 0.
    #[inline]
    pub(super) fn sign(&self) -> Ordering {
        if self.is_negative() {
            Ordering::Less
        } else if self.0.iter().any(|&limb| limb != 0) {
            Ordering::Greater
        } else {
            Ordering::Equal
        }
    }

    /// The absolute value.
    #[inline]
    #[must_use]
    pub(super) fn magnitude(self) -> Self {
        if !self.is_negative() {
            return self;
        }
        let mut magnitude = Self::ZERO;
        magnitude.add(&self.0, 0, true);
        magnitude
    }

    /// The highest limb that is not 0 and the one below it, with the number of the highest; `None` for zero. Of an absolute value.
    #[inline]
    pub(super) fn leading(&self) -> Option<(u128, usize)> {
        let top = self.0.iter().rposition(|&limb| limb != 0)?;
        let below = if top == 0 { 0 } else { self.0[top - 1] };
        Some((u128::from(self.0[top]) << 64 | u128::from(below), top))
    }
}
