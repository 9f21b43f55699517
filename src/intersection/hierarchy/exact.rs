//! Exact arithmetic for rays and triangles of `f32`: integers wide enough that nothing is ever rounded.
//!
//! Every finite `f32` is a whole multiple of 2⁻¹⁴⁹. So every product of three of them is a whole multiple of 2⁻⁴⁴⁷, below 2³⁸⁴, and a sum
//! of a few such products fits into 896 bits with its sign. The volumes that decide where a ray passes a triangle are such sums.
//!
//! ```text
//! d · (b − o) × (c − o)  = |d b c| − |d o c| − |d b o|                          18 products
//! (a − o) · (b − o) × (c − o) = |a b c| − |o b c| − |a o c| − |a b o|           24 products
//! ```
//!
//! Why this is not the triangle's long accumulator is said in [`limbs`](crate::intersection::limbs), where the digits are that both have.
//!
//! # Numerics
//!
//! The answer is exact for every finite input, denormal numbers included: there is no overflow, no underflow, and no tolerance. It costs
//! about a microsecond, and is asked for only where arithmetic of `f64` cannot decide.
//!
//! # Sources
//!
//! J. R. Shewchuk, *Adaptive precision floating-point arithmetic and fast robust geometric predicates*, 1997 (the idea of an exact stage
//! behind a filter).

use std::cmp::Ordering;

use glam::Vec3;

use crate::intersection::limbs::Limbs;

/// How many 64-bit digits an [`Integer`] has: 831 bits for a product, 5 for the count of products, 1 for the sign.
const DIGITS: usize = 14;

/// The exponent of the least bit of an `f32`.
const LEAST_EXPONENT: u64 = 149;

/// A whole number of 896 bits, as sign and magnitude.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Integer {
    sign: Ordering,
    magnitude: Limbs<DIGITS>,
}

/// A number as `mantissa · 2^exponent` in units of 2⁻¹⁴⁹.
fn decomposed(value: f32) -> (i64, u32) {
    let bits = value.to_bits();
    let (exponent, fraction) = ((bits >> 23) & 0xff, i64::from(bits & 0x7f_ffff));
    let (magnitude, shift) = if exponent == 0 {
        (fraction, 0)
    } else {
        (fraction | 0x80_0000, exponent - 1)
    };
    (
        if value.is_sign_negative() {
            -magnitude
        } else {
            magnitude
        },
        shift,
    )
}

/// A sum of products in two's complement, on its way to an [`Integer`].
struct Sum(Limbs<DIGITS>);

impl Sum {
    fn zero() -> Self {
        Self(Limbs::ZERO)
    }

    /// Adds `±x y z`, in units of 2⁻⁴⁴⁷.
    fn add_product(&mut self, factors: [f32; 3], negated: bool) {
        let (mut product, mut shift) = (1_i128, 0);
        for factor in factors {
            let (mantissa, exponent) = decomposed(factor);
            product *= i128::from(mantissa);
            shift += exponent;
        }
        if product == 0 {
            return;
        }
        self.add_shifted(product.unsigned_abs(), shift, negated != (product < 0));
    }

    /// Adds `± magnitude · 2^shift`.
    fn add_shifted(&mut self, magnitude: u128, shift: u32, negated: bool) {
        let pieces = shifted(magnitude, shift % 64);
        self.0.add(&pieces, (shift / 64) as usize, negated);
    }

    fn finish(self) -> Integer {
        Integer {
            sign: self.0.sign(),
            magnitude: self.0.magnitude(),
        }
    }
}

impl Integer {
    /// The number `value · 2^shift`, in units of 2⁻⁴⁴⁷.
    fn of_product(value: i128, shift: u32) -> Self {
        let mut sum = Sum::zero();
        sum.add_shifted(value.unsigned_abs(), shift, value < 0);
        sum.finish()
    }

    /// Less, equal or greater than 0.
    pub(super) fn sign(&self) -> Ordering {
        self.sign
    }

    /// The sum of three numbers below 2⁸⁹².
    pub(super) fn sum(terms: [&Self; 3]) -> Self {
        let mut sum = Sum::zero();
        for term in terms {
            sum.0.add(&term.magnitude.0, 0, term.sign == Ordering::Less);
        }
        sum.finish()
    }

    /// The number times 2⁻⁴⁴⁷, within a relative error of 2⁻⁵².
    pub(super) fn to_f64(self) -> f64 {
        let Some((leading, top)) = self.magnitude.leading() else {
            return 0.0;
        };
        // The power of two 2^(64 (top − 1) − 447), put together from its biased exponent.
        let exponent = 64 * top as u64 + 1023 - 64 - 3 * LEAST_EXPONENT;
        let magnitude = leading as f64 * f64::from_bits(exponent << 52);
        if self.sign == Ordering::Less {
            -magnitude
        } else {
            magnitude
        }
    }

    /// The magnitude of a product of two numbers.
    fn product(&self, other: &Self) -> [u64; 2 * DIGITS] {
        let mut product = [0_u64; 2 * DIGITS];
        for (i, &x) in self
            .magnitude
            .0
            .iter()
            .enumerate()
            .filter(|(_, x)| **x != 0)
        {
            let mut carry = 0_u64;
            for (j, &y) in other.magnitude.0.iter().enumerate() {
                (product[i + j], carry) = x.carrying_mul_add(y, carry, product[i + j]);
            }
            product[i + DIGITS] = carry;
        }
        product
    }
}

/// The number moved up by less than 64 places, as limbs.
#[allow(
    clippy::cast_possible_truncation,
    reason = "the limbs are cut out of the wide number"
)]
fn shifted(number: u128, places: u32) -> [u64; 3] {
    let low = number << places;
    let high = number.checked_shr(128 - places).unwrap_or(0);
    [low as u64, (low >> 64) as u64, high as u64]
}

/// A rational number, `numerator / denominator`; the denominator is not 0.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ratio {
    numerator: Integer,
    denominator: Integer,
}

impl Ratio {
    /// The finite number `value`.
    pub(super) fn from_f32(value: f32) -> Self {
        let whole = |value: f32| {
            let (mantissa, shift) = decomposed(value);
            let mut sum = Sum::zero();
            sum.add_shifted(mantissa.unsigned_abs().into(), shift, mantissa < 0);
            sum.finish()
        };
        Self {
            numerator: whole(value),
            denominator: whole(1.0),
        }
    }

    fn sign(&self) -> Ordering {
        if self.denominator.sign == Ordering::Less {
            self.numerator.sign.reverse()
        } else {
            self.numerator.sign
        }
    }

    /// The number, within a relative error of 2⁻⁵⁰.
    pub(super) fn to_f64(self) -> f64 {
        self.numerator.to_f64() / self.denominator.to_f64()
    }

    /// The order of two numbers.
    pub(super) fn compare(&self, other: &Self) -> Ordering {
        let (sign, other_sign) = (self.sign(), other.sign());
        if sign != other_sign {
            return sign.cmp(&other_sign);
        }
        let left = self.numerator.product(&other.denominator);
        let right = other.numerator.product(&self.denominator);
        let magnitudes = left.iter().rev().cmp(right.iter().rev());
        if sign == Ordering::Less {
            magnitudes.reverse()
        } else {
            magnitudes
        }
    }
}

/// What decides where a line passes a triangle, exactly, up to the same factor in all of them.
#[derive(Clone, Copy, Debug)]
pub(super) struct Volumes {
    /// `d · (b − o) × (c − o)` and the same of the other two edges: the weights of the corners times `determinant`.
    pub(super) edges: [Integer; 3],
    /// `d · (b − a) × (c − a)`, the sum of the edges.
    pub(super) determinant: Integer,
    /// `(a − o) · (b − o) × (c − o)`: t times `determinant`.
    pub(super) distance: Integer,
}

impl Volumes {
    /// Of the line `o + t d` and the triangle with these corners; all coordinates finite.
    pub(super) fn new(o: Vec3, d: Vec3, corners: [Vec3; 3]) -> Self {
        Self::of_near_numbers(o, d, corners).unwrap_or_else(|| Self::of_any_numbers(o, d, corners))
    }

    /// Where the coordinates do not differ in size by more than 2¹⁶, they are whole numbers of 40 bits: differences have 41, cross products 83, and
    /// volumes at most 83 + 41 + 2 = 126.
    fn of_near_numbers(o: Vec3, d: Vec3, corners: [Vec3; 3]) -> Option<Self> {
        let [a, b, c] = corners;
        let (points, unit) = whole_numbers([o, a, b, c])?;
        let ([d], speed) = whole_numbers([d])?;
        let [a, b, c] = [1, 2, 3]
            .map(|corner: usize| [0, 1, 2].map(|axis| points[corner][axis] - points[0][axis]));
        let edges = [[b, c], [c, a], [a, b]].map(|[p, q]| volume(d, p, q));
        let [first, second, third] = edges;
        let wide = |volume, unit| Integer::of_product(volume, unit);
        Some(Self {
            edges: edges.map(|edge| wide(edge, speed + 2 * unit)),
            determinant: wide(first + second + third, speed + 2 * unit),
            distance: wide(volume(a, b, c), 3 * unit),
        })
    }

    fn of_any_numbers(o: Vec3, d: Vec3, corners: [Vec3; 3]) -> Self {
        let [a, b, c] = corners;
        let edge = |p: Vec3, q: Vec3| {
            let mut sum = Sum::zero();
            add_determinant(&mut sum, [d, p, q], false);
            add_determinant(&mut sum, [d, o, q], true);
            add_determinant(&mut sum, [d, p, o], true);
            sum.finish()
        };
        let edges = [edge(b, c), edge(c, a), edge(a, b)];
        let [first, second, third] = &edges;
        let mut distance = Sum::zero();
        add_determinant(&mut distance, [a, b, c], false);
        for corners in [[o, b, c], [a, o, c], [a, b, o]] {
            add_determinant(&mut distance, corners, true);
        }
        Self {
            determinant: Integer::sum([first, second, third]),
            edges,
            distance: distance.finish(),
        }
    }

    /// The ray's parameter; the determinant is not 0.
    pub(super) fn t(&self) -> Ratio {
        Ratio {
            numerator: self.distance,
            denominator: self.determinant,
        }
    }
}

/// The coordinates as multiples of one power of two, and its exponent over 2⁻¹⁴⁹; `None` where that takes more than 40 bits.
fn whole_numbers<const N: usize>(points: [Vec3; N]) -> Option<([[i64; 3]; N], u32)> {
    let (mut least, mut most) = (u32::MAX, 0);
    for coordinate in points.iter().flat_map(Vec3::to_array).filter(|&x| x != 0.0) {
        let shift = decomposed(coordinate).1;
        (least, most) = (least.min(shift), most.max(shift));
    }
    if least == u32::MAX {
        least = 0;
    }
    if most > least + 16 {
        return None;
    }
    let whole = |coordinate: f32| {
        let (mantissa, shift) = decomposed(coordinate);
        mantissa << shift.saturating_sub(least)
    };
    Some((points.map(|point| point.to_array().map(whole)), least))
}

/// `x · y × z`.
fn volume(x: [i64; 3], y: [i64; 3], z: [i64; 3]) -> i128 {
    let minor = |j: usize, k: usize| {
        i128::from(y[j]) * i128::from(z[k]) - i128::from(y[k]) * i128::from(z[j])
    };
    i128::from(x[0]) * minor(1, 2) + i128::from(x[1]) * minor(2, 0) + i128::from(x[2]) * minor(0, 1)
}

/// Adds `± x · y × z`.
fn add_determinant(sum: &mut Sum, [x, y, z]: [Vec3; 3], negated: bool) {
    for (i, j, k) in [(0, 1, 2), (1, 2, 0), (2, 0, 1)] {
        sum.add_product([x[i], y[j], z[k]], negated);
        sum.add_product([x[i], y[k], z[j]], !negated);
    }
}

/// `(b − a) × (c − a)`, each coordinate exact before it is rounded to `f64`.
pub(super) fn normal(corners: [Vec3; 3]) -> [f64; 3] {
    // The determinant for a line along an axis is that coordinate of the normal.
    Vec3::AXES.map(|axis| Volumes::new(Vec3::ZERO, axis, corners).determinant.to_f64())
}
