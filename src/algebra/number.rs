//! Numbers: fields, and what real numbers have besides.

use std::fmt::Debug;
use std::ops::{Div, Neg, Sub};

use num_traits::{One, Zero};

/// A field of numbers with an order: what a formula without roots and cosines is written over.
///
/// A ring with division by its units (dual numbers) may implement it too; it is then ordered by its real part.
pub trait Scalar:
    Copy
    + Debug
    + PartialOrd
    + Zero
    + One
    + Sub<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + Send
    + Sync
    + 'static
{
    /// The largest relative error of one rounded operation: 2⁻²⁴ for `f32`, 2⁻⁵³ for `f64`, 0 where nothing is rounded.
    fn unit_roundoff() -> Self;

    /// The integer `value`, rounded where the type cannot hold it (`f32` beyond 2²⁴).
    fn from_i32(value: i32) -> Self;

    /// Whether the number is neither infinite nor NaN.
    fn is_finite(self) -> bool;

    /// The constant `numerator / denominator`.
    ///
    /// # Edge cases
    ///
    /// A zero denominator does what the type's own division does.
    #[must_use]
    fn ratio(numerator: i32, denominator: i32) -> Self {
        Self::from_i32(numerator) / Self::from_i32(denominator)
    }

    /// The absolute value; NaN for NaN.
    #[must_use]
    fn magnitude(self) -> Self {
        if self < Self::zero() { -self } else { self }
    }
}

/// A [`Scalar`] with the functions that leave a field: lengths and angles need it, and say so in their type.
pub trait Real: Scalar {
    /// The square root; NaN for a negative number.
    #[must_use]
    fn sqrt(self) -> Self;

    /// The sine of an angle in radians.
    #[must_use]
    fn sin(self) -> Self;

    /// The cosine of an angle in radians.
    #[must_use]
    fn cos(self) -> Self;

    /// The number nearest to π: below it in `f64`, above it in `f32`.
    fn pi() -> Self;

    /// The largest power of two that is not above the absolute value, as a unit to measure lengths in: multiplying by it or by its
    /// reciprocal rounds nothing.
    ///
    /// # Edge cases
    ///
    /// The smallest normal number where the absolute value is below that, zero included: so the reciprocal is finite. Infinite for infinity
    /// and NaN.
    #[must_use]
    fn power_of_two(self) -> Self;

    /// The same number in double precision.
    fn to_f64(self) -> f64;

    /// The number nearest to `value`.
    fn from_f64(value: f64) -> Self;
}

macro_rules! real_number {
    ($float:ident) => {
        impl Scalar for $float {
            fn unit_roundoff() -> Self {
                $float::EPSILON / 2.0
            }

            #[allow(
                clippy::cast_precision_loss,
                clippy::cast_lossless,
                reason = "rounding is documented; one body serves both widths"
            )]
            fn from_i32(value: i32) -> Self {
                value as $float
            }

            fn is_finite(self) -> bool {
                self.is_finite()
            }
        }

        impl Real for $float {
            fn sqrt(self) -> Self {
                self.sqrt()
            }

            fn sin(self) -> Self {
                self.sin()
            }

            fn cos(self) -> Self {
                self.cos()
            }

            fn pi() -> Self {
                std::$float::consts::PI
            }

            fn power_of_two(self) -> Self {
                let exponent = $float::INFINITY.to_bits();
                $float::from_bits(self.to_bits() & exponent).max($float::MIN_POSITIVE)
            }

            #[inline]
            fn to_f64(self) -> f64 {
                f64::from(self)
            }

            #[inline]
            #[allow(
                clippy::cast_possible_truncation,
                reason = "rounding is documented; one body serves both widths"
            )]
            fn from_f64(value: f64) -> Self {
                value as $float
            }
        }
    };
}

real_number!(f32);
real_number!(f64);

/// The larger of two numbers; NaN where one is NaN.
#[inline]
pub(crate) fn larger<S: Scalar>(a: S, b: S) -> S {
    let b_is_nan = b.partial_cmp(&b).is_none();
    if b > a || b_is_nan { b } else { a }
}
