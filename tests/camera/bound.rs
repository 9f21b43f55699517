//! A bound on an error, and how much of it was used up.

use std::cell::Cell;

use num_traits::{Signed, ToPrimitive, Zero};

use crate::common::law::{Verdict, expect_at_most};
use crate::common::oracle::Big;

/// A bound on an error, with the largest part of it that was used up.
#[derive(Default)]
pub struct Bound {
    used: Cell<f64>,
}

impl Bound {
    /// Passes where `error` is not more than `bound`.
    pub fn holds(&self, error: &Big, bound: &Big) -> Verdict {
        if error.is_zero() {
            return Ok(());
        }
        let used = (error.abs() / bound).to_f64().unwrap_or(f64::INFINITY);
        self.used.set(self.used.get().max(used));
        expect_at_most("an error, as a part of its bound,", 1.0, used)
    }

    /// Passes where at least the given part of the bound was used up.
    pub fn is_used_up_to(&self, part: f64) {
        let used = self.used.get();
        println!("largest error seen: {used:.3} of its bound");
        assert!(
            used >= part,
            "the largest error seen is only {used} of its bound"
        );
    }
}
