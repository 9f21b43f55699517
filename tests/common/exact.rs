//! Rational numbers without rounding: what theorems are checked over, with `==`.

use std::fmt;
use std::ops::{Add, Div, Mul, Neg, Sub};

use facette::algebra::Scalar;
use num_rational::Ratio;
use num_traits::{FromPrimitive, One, Zero};

/// 1024 bits with a sign; the `p` makes an overflow panic, in release builds too.
type Wide = bnum::t!(I1024p);

/// A rational number whose numerator and denominator have at most 1023 bits; an overflow panics.
///
/// Polynomials of degree up to about 20 at parameters with a few digits stay within; [`super::oracle`] has no such limit.
#[derive(Clone, Copy, PartialEq, PartialOrd)]
pub struct Exact(Ratio<Wide>);

/// The fraction `numerator / denominator`.
pub fn fraction(numerator: i32, denominator: i32) -> Exact {
    Exact(Ratio::new(wide(numerator), wide(denominator)))
}

fn wide(value: i32) -> Wide {
    Wide::from_i32(value).expect("32 bits fit into 1024")
}

impl fmt::Debug for Exact {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "{}", self.0)
    }
}

macro_rules! operation {
    ($operation:ident, $method:ident) => {
        impl $operation for Exact {
            type Output = Self;

            fn $method(self, other: Self) -> Self {
                Self($operation::$method(self.0, other.0))
            }
        }
    };
}

operation!(Add, add);
operation!(Sub, sub);
operation!(Mul, mul);
operation!(Div, div);

impl Neg for Exact {
    type Output = Self;

    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl Zero for Exact {
    fn zero() -> Self {
        Self(Ratio::zero())
    }

    fn is_zero(&self) -> bool {
        self.0.is_zero()
    }
}

impl One for Exact {
    fn one() -> Self {
        Self(Ratio::one())
    }
}

impl Scalar for Exact {
    fn unit_roundoff() -> Self {
        Self::zero()
    }

    fn from_i32(value: i32) -> Self {
        Self(Ratio::from_integer(wide(value)))
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
