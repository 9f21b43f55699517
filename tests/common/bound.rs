//! A stated bound, and how much of it was used up.

use std::cell::Cell;

use num_traits::{Signed, ToPrimitive, Zero};

use super::law::{Verdict, expect_at_most};
use super::oracle::{Big, big};

/// A bound on an error, with the largest part of it that was used up so far, and how often it promised anything.
#[derive(Default)]
pub struct Bound {
    used: Cell<f64>,
    finite: Cell<u32>,
    infinite: Cell<u32>,
}

impl Bound {
    /// Passes where `computed` is within `bound` of `exact`. An infinite bound promises nothing: it passes, and is counted.
    pub fn holds(&self, computed: f64, exact: &Big, bound: f64) -> Verdict {
        if bound == f64::INFINITY {
            self.infinite.set(self.infinite.get() + 1);
            return Ok(());
        }
        self.holds_error(&(big(computed) - exact), &big(bound))
    }

    /// Passes where `error` is not more than `bound`.
    pub fn holds_error(&self, error: &Big, bound: &Big) -> Verdict {
        self.finite.set(self.finite.get() + 1);
        if error.is_zero() && !bound.is_negative() {
            return Ok(());
        }
        let is_within = error.abs() <= *bound;
        let part = if bound.is_positive() {
            (error.abs() / bound).to_f64().unwrap_or(f64::INFINITY)
        } else {
            f64::INFINITY
        };
        if is_within {
            self.used.set(self.used.get().max(part));
            return Ok(());
        }
        // A quotient just above 1 may round to it, which must not pass.
        expect_at_most(
            "an error, as a part of its bound,",
            1.0,
            part.max(1.0 + f64::EPSILON),
        )
    }

    /// Passes where at least the given part of the bound was used up, and where it was finite at least as often as not: a bound that
    /// says nothing of most inputs would pass all tests.
    pub fn is_used_up_to(&self, part: f64) {
        let (used, finite, infinite) = (self.used.get(), self.finite.get(), self.infinite.get());
        println!(
            "largest error seen: {used:.3} of its bound; infinite {infinite} times, finite {finite} times"
        );
        assert!(
            used >= part,
            "the largest error seen is only {used} of its bound"
        );
        assert!(
            finite >= infinite,
            "the bound is infinite {infinite} times, finite only {finite} times"
        );
    }
}

#[test]
fn a_bound_holds_up_to_itself() {
    let bound = Bound::default();
    assert!(bound.holds(1.5, &big(1.0), 0.5).is_ok());
    assert!(bound.holds(1.5, &big(1.0), 0.5_f64.next_down()).is_err());
    assert!(bound.holds(1.0, &big(1.0), 0.0).is_ok());
    assert!(bound.holds(1.0, &big(2.0), 0.0).is_err());
    bound.is_used_up_to(1.0);
}

#[test]
#[should_panic(expected = "infinite 1 times")]
fn a_bound_that_promises_nothing_does_not_pass() {
    let bound = Bound::default();
    assert!(bound.holds(1.0, &big(2.0), f64::INFINITY).is_ok());
    bound.is_used_up_to(0.0);
}
