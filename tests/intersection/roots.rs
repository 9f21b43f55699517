//! The true parameters of a line and a sphere, with the arbitrary-precision oracle.

use num_traits::Signed;

use crate::common::oracle::{Big, big_dot, big_sqrt};

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
