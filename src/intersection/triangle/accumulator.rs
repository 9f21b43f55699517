//! A number with so many digits that sums of products of three floating-point numbers fit in exactly.
//!
//! Why the hierarchy has a narrower one is said in [`limbs`](crate::intersection::limbs), where the digits are that both have.

use std::cmp::Ordering;
use std::ops::AddAssign;

use crate::intersection::limbs::Limbs;

/// Bits below the unit: the last digit of a product of three denormal numbers is 2⁻³ ˣ ¹⁰⁷⁴.
const FRACTION_BITS: i32 = 3 * 1074;

/// Enough for 3 · 1024 bits above the unit, the bits below it, the carries of 2³⁰ summands, and a sign.
const LIMBS: usize = 99;

/// A sum of products of three `f64`, kept exactly: Kulisch's long accumulator, two's complement, least limb first.
///
/// Nothing overflows, underflows or rounds, whatever finite numbers go in.
///
/// # Source
///
/// Kulisch 2013, chapter 8.
#[derive(Clone, Copy)]
pub(crate) struct LongAccumulator(Limbs<LIMBS>);

/// A number as `mantissa · 2^exponent`, so that a quotient of two of them overflows only where it must.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Scaled {
    /// Between 2⁶³ and 2⁶⁴ in size, or 0.
    mantissa: f64,
    exponent: i32,
}

impl LongAccumulator {
    pub(crate) fn new() -> Self {
        Self(Limbs::ZERO)
    }

    /// Adds `x y z`, which are finite.
    pub(crate) fn add_product(&mut self, x: f64, y: f64, z: f64) {
        let [x, y, z] = [x, y, z].map(Parts::of);
        let product = u128::from(x.digits) * u128::from(y.digits);
        if product == 0 || z.digits == 0 {
            return;
        }
        let place = x.exponent + y.exponent + z.exponent + FRACTION_BITS;
        let place = usize::try_from(place).expect("the smallest exponent is that of the last bit");
        let digits = times(product, z.digits);
        self.0.add(
            &shifted(digits, place % 64),
            place / 64,
            x.is_negative ^ y.is_negative ^ z.is_negative,
        );
    }

    /// Adds `sign · x · (y × z)`, where the sign is 1 or −1.
    pub(crate) fn add_determinant(&mut self, sign: f64, x: [f64; 3], y: [f64; 3], z: [f64; 3]) {
        for (i, j, k) in [(0, 1, 2), (1, 2, 0), (2, 0, 1)] {
            self.add_product(sign * x[i], y[j], z[k]);
            self.add_product(-sign * x[i], y[k], z[j]);
        }
    }

    /// Less, equal or greater than 0.
    pub(crate) fn sign(&self) -> Ordering {
        self.0.sign()
    }

    /// The sum rounded to 53 bits, with a relative error of at most `u (1 + 2⁻¹⁰)`.
    #[allow(
        clippy::cast_possible_truncation,
        reason = "the leading bits are cut out"
    )]
    pub(crate) fn rounded(&self) -> Scaled {
        let Some((leading, top)) = self.0.magnitude().leading() else {
            return Scaled {
                mantissa: 0.0,
                exponent: 0,
            };
        };
        let zeros = leading.leading_zeros();
        // The 64 leading bits; what is cut off is less than 2⁻⁶³ of the number.
        let mantissa = (leading << zeros >> 64) as u64 as f64;
        let place = i32::try_from(64 * top).expect("the accumulator has fewer than 2^13 bits");
        let exponent = place - zeros.cast_signed() - FRACTION_BITS;
        let mantissa = if self.0.is_negative() {
            -mantissa
        } else {
            mantissa
        };
        Scaled { mantissa, exponent }
    }
}

impl AddAssign<&Self> for LongAccumulator {
    fn add_assign(&mut self, other: &Self) {
        self.0.add(&other.0.0, 0, false);
    }
}

impl Scaled {
    /// The quotient, rounded once more; infinite or 0 where it is out of the range of numbers. The divisor is not zero.
    pub(crate) fn over(self, divisor: Self) -> f64 {
        scaled_by(
            self.mantissa / divisor.mantissa,
            self.exponent - divisor.exponent,
        )
    }

    /// The exponent of two of the leading bit; that of zero is the least.
    pub(crate) fn magnitude(self) -> i32 {
        if self.mantissa == 0.0 {
            i32::MIN
        } else {
            self.exponent
        }
    }

    /// The number over `2^exponent`.
    pub(crate) fn relative_to(self, exponent: i32) -> f64 {
        scaled_by(self.mantissa, self.exponent.saturating_sub(exponent))
    }
}

/// A floating-point number as whole digits times a power of two.
#[derive(Clone, Copy)]
struct Parts {
    digits: u64,
    exponent: i32,
    is_negative: bool,
}

impl Parts {
    fn of(number: f64) -> Self {
        debug_assert!(number.is_finite(), "{number} has no digits");
        let bits = number.to_bits();
        let (field, fraction) = (((bits >> 52) & 0x7ff) as i32, bits & ((1 << 52) - 1));
        let (digits, exponent) = if field == 0 {
            (fraction, -1074)
        } else {
            (fraction | 1 << 52, field - 1075)
        };
        Self {
            digits,
            exponent,
            is_negative: bits >> 63 == 1,
        }
    }
}

/// The product of 106 by 53 bits.
#[allow(
    clippy::cast_possible_truncation,
    reason = "the limbs are cut out of the wide product"
)]
fn times(product: u128, digits: u64) -> [u64; 3] {
    let low = (product & u128::from(u64::MAX)) * u128::from(digits);
    let high = (product >> 64) * u128::from(digits) + (low >> 64);
    [low as u64, high as u64, (high >> 64) as u64]
}

/// The digits moved up by less than 64 places.
#[allow(
    clippy::cast_possible_truncation,
    reason = "the limbs are cut out of the wide product"
)]
fn shifted([low, middle, high]: [u64; 3], places: usize) -> [u64; 4] {
    let wide = [low, middle, high].map(|limb| u128::from(limb) << places);
    let part = |limb: u128| [limb as u64, (limb >> 64) as u64];
    let [[a, b], [c, d], [e, f]] = wide.map(part);
    // The parts do not overlap: a sum of the two is an "or".
    [a, b | c, d | e, f]
}

/// `number · 2^exponent`, in steps that the range of numbers allows.
fn scaled_by(number: f64, exponent: i32) -> f64 {
    let mut result = number;
    let mut left = exponent.clamp(-3000, 3000);
    while left != 0 && result != 0.0 {
        let step = left.clamp(-1022, 1022);
        result *= power_of_two(step);
        left -= step;
    }
    result
}

/// 2 to the power `exponent`, from −1022 to 1022.
fn power_of_two(exponent: i32) -> f64 {
    f64::from_bits(u64::from((exponent + 1023).cast_unsigned()) << 52)
}
