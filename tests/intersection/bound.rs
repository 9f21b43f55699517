//! A stated bound, and how much of it was used up.

use std::cell::Cell;

use num_traits::{Signed, ToPrimitive};

use crate::common::law::{Verdict, expect_at_most};
use crate::common::oracle::{Big, big};

/// The largest part of a bound that was used up so far.
#[derive(Default)]
pub struct Bound {
    used: Cell<f64>,
}

impl Bound {
    /// Passes where `computed` is within `bound` of `exact`. An infinite bound promises nothing.
    pub fn holds(&self, computed: f64, exact: &Big, bound: f64) -> Verdict {
        if bound == f64::INFINITY {
            return Ok(());
        }
        let error = (big(computed) - exact).abs();
        if error <= big(bound) {
            let part = if bound > 0.0 {
                error / big(bound)
            } else {
                error
            };
            let part = part.to_f64().expect("a number up to 1");
            self.used.set(self.used.get().max(part));
            return Ok(());
        }
        expect_at_most("an error", bound, error.to_f64().unwrap_or(f64::INFINITY))
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
