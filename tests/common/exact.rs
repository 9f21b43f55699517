//! Rational numbers without rounding: what theorems are checked over, with `==`.

use std::cmp::Ordering;
use std::fmt;
use std::ops::{Add, Div, Mul, Neg, Sub};

use facette::algebra::Scalar;
use num_rational::Ratio;
use num_traits::{
    CheckedAdd, CheckedDiv, CheckedMul, CheckedSub, FromPrimitive, One, ToPrimitive, Zero,
};

/// 1024 bits with a sign; the `p` makes an overflow panic, in release builds too.
type Wide = bnum::t!(I1024p);

/// A rational number whose numerator and denominator have at most 1023 bits; an overflow panics.
///
/// Polynomials of degree up to about 20 at parameters with a few digits stay within; [`super::oracle`] has no such limit.
/// Numbers that fit into 128 bits are kept in 128 bits, where an operation costs a tenth.
#[derive(Clone, Copy, PartialEq)]
pub struct Exact(Number);

/// Every number has one form only, so that equal numbers are equal: narrow where it fits, and in lowest terms.
#[derive(Clone, Copy, PartialEq)]
#[allow(
    clippy::large_enum_variant,
    reason = "scalars are `Copy`: the wide number cannot stand behind a pointer"
)]
enum Number {
    Narrow(Ratio<i128>),
    Wide(Ratio<Wide>),
}

use Number::Narrow;

impl Exact {
    /// The number in double precision, within two units in the last place.
    pub fn to_f64(self) -> f64 {
        let quotient = |numerator: Option<f64>, denominator: Option<f64>| {
            let parts = numerator.zip(denominator);
            parts.map_or(f64::NAN, |(numerator, denominator)| numerator / denominator)
        };
        match self.0 {
            Narrow(ratio) => quotient(ratio.numer().to_f64(), ratio.denom().to_f64()),
            Number::Wide(ratio) => quotient(ratio.numer().to_f64(), ratio.denom().to_f64()),
        }
    }

    fn widened(self) -> Ratio<Wide> {
        match self.0 {
            Narrow(ratio) => Ratio::new_raw(wide(*ratio.numer()), wide(*ratio.denom())),
            Number::Wide(ratio) => ratio,
        }
    }

    fn narrowed(ratio: Ratio<Wide>) -> Self {
        match (ratio.numer().to_i128(), ratio.denom().to_i128()) {
            (Some(numerator), Some(denominator)) => {
                Self(Narrow(Ratio::new_raw(numerator, denominator)))
            }
            _ => Self(Number::Wide(ratio)),
        }
    }
}

fn wide(value: i128) -> Wide {
    Wide::from_i128(value).expect("128 bits fit into 1024")
}

/// The fraction `numerator / denominator`.
pub fn fraction(numerator: i32, denominator: i32) -> Exact {
    Exact(Narrow(Ratio::new(numerator.into(), denominator.into())))
}

impl fmt::Debug for Exact {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0 {
            Narrow(ratio) => write!(formatter, "{ratio}"),
            Number::Wide(ratio) => write!(formatter, "{ratio}"),
        }
    }
}

impl PartialOrd for Exact {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        match (self.0, other.0) {
            (Narrow(a), Narrow(b)) => a.partial_cmp(&b),
            _ => self.widened().partial_cmp(&other.widened()),
        }
    }
}

macro_rules! operation {
    ($operation:ident, $method:ident, $checked:ident) => {
        impl $operation for Exact {
            type Output = Self;

            fn $method(self, other: Self) -> Self {
                if let (Narrow(a), Narrow(b)) = (self.0, other.0)
                    && let Some(result) = a.$checked(&b)
                {
                    return Self(Narrow(result));
                }
                Self::narrowed($operation::$method(self.widened(), other.widened()))
            }
        }
    };
}

operation!(Add, add, checked_add);
operation!(Sub, sub, checked_sub);
operation!(Mul, mul, checked_mul);
operation!(Div, div, checked_div);

impl Neg for Exact {
    type Output = Self;

    fn neg(self) -> Self {
        Self::zero() - self
    }
}

impl Zero for Exact {
    fn zero() -> Self {
        Self(Narrow(Ratio::zero()))
    }

    fn is_zero(&self) -> bool {
        matches!(self.0, Narrow(ratio) if ratio.is_zero())
    }
}

impl One for Exact {
    fn one() -> Self {
        Self(Narrow(Ratio::one()))
    }
}

impl Scalar for Exact {
    fn unit_roundoff() -> Self {
        Self::zero()
    }

    fn from_i32(value: i32) -> Self {
        Self(Narrow(Ratio::from_integer(value.into())))
    }

    fn is_finite(self) -> bool {
        true
    }
}

#[test]
fn exact_numbers_do_not_round() {
    let third = fraction(1, 3);
    assert_eq!(third + third + third, Exact::one());
    assert_eq!(fraction(-2, 4), fraction(1, -2));
    assert!(fraction(1, 3) < fraction(1, 2));
}

#[test]
#[should_panic(expected = "overflow")]
fn an_exact_number_that_does_not_fit_panics() {
    let mut power = fraction(3, 1);
    for _ in 0..10 {
        power = power * power;
    }
}

#[test]
fn narrow_and_wide_numbers_are_the_same_numbers() {
    // 3^100 needs 159 bits: the powers cross the border between the two widths, and come back.
    let mut power = Exact::one();
    for _ in 0..100 {
        power = power * fraction(3, 1);
    }
    assert!(matches!(power.0, Number::Wide(_)) && power > fraction(i32::MAX, 1));
    for _ in 0..100 {
        power = power / fraction(3, 1);
    }
    assert_eq!(power, Exact::one());
    let below = fraction(1, 3) - fraction(i32::MAX, 1) * fraction(i32::MAX, 1);
    assert_eq!(-(-below) - below, Exact::zero());
}
