//! Square roots of the arbitrary-precision oracle, and the true parameters of a line and a sphere.

use num_bigint::BigInt;
use num_traits::{Signed, Zero};

use crate::common::oracle::Big;

/// More than 200 decimal digits.
const BITS: u64 = 700;

/// The square root of a number that is not negative, to a relative error below `2^-690`.
pub fn big_sqrt(value: &Big) -> Big {
    assert!(!value.is_negative(), "{value} has no real root");
    // √(n / d) = √(n d) / d, and √(n d 4^k) = 2^k √(n d): k so large that the integer root has enough bits.
    let product = value.numer() * value.denom();
    let doublings = BITS.saturating_sub(product.bits() / 2);
    let root: BigInt = (product << (2 * doublings)).sqrt();
    Big::new(root, value.denom() << doublings)
}

/// The scalar product.
pub fn big_dot(a: &[Big; 3], b: &[Big; 3]) -> Big {
    let terms = a.iter().zip(b).map(|(a, b)| a * b);
    terms.fold(Big::zero(), |sum, term| sum + term)
}

/// The difference of two points.
pub fn big_minus(a: &[Big; 3], b: &[Big; 3]) -> [Big; 3] {
    std::array::from_fn(|axis| &a[axis] - &b[axis])
}

/// The length of a vector.
pub fn big_length(vector: &[Big; 3]) -> Big {
    big_sqrt(&big_dot(vector, vector))
}

/// The true parameters at which the line `p + t d` meets the sphere of radius r around the origin, smaller first; `None` where it passes by.
pub fn big_roots(p: &[Big; 3], d: &[Big; 3], r: &Big) -> Option<[Big; 2]> {
    let [dd, b] = [big_dot(d, d), big_dot(p, d)];
    let discriminant = &b * &b - &dd * (big_dot(p, p) - r * r);
    if discriminant.is_negative() {
        return None;
    }
    let root = big_sqrt(&discriminant);
    Some([(-&b - &root) / &dd, (-&b + &root) / &dd])
}

/// The distance of the line `p + t d` from the origin.
pub fn big_passing_distance(p: &[Big; 3], d: &[Big; 3]) -> Big {
    let [dd, b] = [big_dot(d, d), big_dot(p, d)];
    big_sqrt(&(big_dot(p, p) - &b * &b / dd))
}

#[test]
fn the_oracle_has_two_hundred_digits_of_a_root() {
    let two = Big::from_integer(2.into());
    let root = big_sqrt(&two);
    let away = (&root * &root - &two).abs();
    let limit = Big::new(1.into(), BigInt::from(10).pow(200));
    assert!(away < limit && !away.is_zero());
    let tiny = Big::new(1.into(), BigInt::from(3).pow(1000));
    let root = big_sqrt(&tiny);
    assert!(((&root * &root - &tiny) / &tiny).abs() < limit);
    assert_eq!(
        big_sqrt(&Big::new(9.into(), 4.into())),
        Big::new(3.into(), 2.into())
    );
    assert_eq!(big_sqrt(&Big::zero()), Big::zero());
}
