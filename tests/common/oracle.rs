//! The arbitrary-precision oracle: every finite `f64` is a rational number, and no result is too large or too small.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive, Zero};

/// A rational number of any size.
pub type Big = BigRational;

/// The number that `value` is, exactly.
///
/// # Panics
///
/// For an infinite value or NaN.
pub fn big(value: f64) -> Big {
    Big::from_float(value).expect("a finite number")
}

/// The point that `point` is, exactly.
pub fn big_point<const N: usize>(point: [f64; N]) -> [Big; N] {
    point.map(big)
}

/// The difference of two points.
pub fn big_minus(a: &[Big; 3], b: &[Big; 3]) -> [Big; 3] {
    std::array::from_fn(|axis| &a[axis] - &b[axis])
}

/// The scalar product.
pub fn big_dot(a: &[Big; 3], b: &[Big; 3]) -> Big {
    let terms = a.iter().zip(b).map(|(a, b)| a * b);
    terms.fold(Big::zero(), |sum, term| sum + term)
}

/// The vector product.
pub fn big_cross(a: &[Big; 3], b: &[Big; 3]) -> [Big; 3] {
    [(1, 2), (2, 0), (0, 1)].map(|(j, k)| &a[j] * &b[k] - &a[k] * &b[j])
}

/// How many bits of a square root are kept at least: more than 200 decimal digits.
const ROOT_BITS: u64 = 700;

/// The square root of a number that is not negative, to a relative error below `2^-690`.
pub fn big_sqrt(value: &Big) -> Big {
    assert!(!value.is_negative(), "{value} has no real root");
    // √(n / d) = √(n d) / d, and √(n d 4^k) = 2^k √(n d): k so large that the integer root has enough bits.
    let product = value.numer() * value.denom();
    let doublings = ROOT_BITS.saturating_sub(product.bits() / 2);
    let root: BigInt = (product << (2 * doublings)).sqrt();
    Big::new(root, value.denom() << doublings)
}

/// The length of a vector, to a relative error below `2^-690`.
pub fn big_length(vector: &[Big; 3]) -> Big {
    big_sqrt(&big_dot(vector, vector))
}

/// The point `Σ weights[i] · points[i]`.
pub fn big_combination<const N: usize>(weights: &[Big], points: &[[Big; N]]) -> [Big; N] {
    assert_eq!(weights.len(), points.len(), "one weight for each point");
    std::array::from_fn(|axis| {
        let terms = weights
            .iter()
            .zip(points)
            .map(|(weight, point)| weight * &point[axis]);
        terms.fold(Big::zero(), |sum, term| sum + term)
    })
}

/// The Bernstein polynomials of degree `n` at `t`: `binomial(n, i) (1 − t)ⁿ⁻ⁱ tⁱ`.
pub fn big_bernstein(n: usize, t: &Big) -> Vec<Big> {
    let s = Big::from_integer(1.into()) - t;
    let power = |base: &Big, exponent: usize| num_traits::pow(base.clone(), exponent);
    let mut binomial = BigInt::from(1);
    let mut values = Vec::new();
    for i in 0..=n {
        values.push(Big::from_integer(binomial.clone()) * power(&s, n - i) * power(t, i));
        binomial = binomial * (n - i) / (i + 1);
    }
    values
}

/// The point of the Bézier curve with these control points, by Bernstein's sum.
pub fn big_bezier<const N: usize>(control_points: &[[f64; N]], t: &Big) -> [Big; N] {
    let points: Vec<_> = control_points
        .iter()
        .map(|&point| big_point(point))
        .collect();
    big_combination(&big_bernstein(points.len() - 1, t), &points)
}

/// The B-spline basis functions of this degree at `u`, all of them, by Cox and de Boor's recursion: spans are half-open, but the one
/// that ends at `closed` has that end too. A term over 0 is 0.
pub fn big_bspline_basis(degree: usize, knots: &[f64], u: &Big, closed: f64) -> Vec<Big> {
    let knots: Vec<_> = knots.iter().map(|&knot| big(knot)).collect();
    let one = Big::from_integer(1.into());
    let at_the_end = *u == big(closed);
    let indicator = |span: &[Big]| {
        let holds = span[0] <= *u && *u < span[1];
        let ends = span[0] < span[1] && span[1] == *u;
        let is_inside = if at_the_end { ends } else { holds };
        if is_inside { one.clone() } else { Big::zero() }
    };
    let mut values: Vec<Big> = knots.windows(2).map(indicator).collect();
    for d in 1..=degree {
        let part = |weight: Big, width: Big, value: &Big| {
            if value.is_zero() {
                Big::zero()
            } else {
                weight / width * value
            }
        };
        values = (0..values.len() - 1)
            .map(|i| {
                let rising = part(u - &knots[i], &knots[i + d] - &knots[i], &values[i]);
                let width = &knots[i + d + 1] - &knots[i + 1];
                rising + part(&knots[i + d + 1] - u, width, &values[i + 1])
            })
            .collect();
    }
    values
}

/// How far the coordinates of `computed` are from `exact`, at most: in multiples of `unit`.
///
/// # Panics
///
/// Where a computed coordinate is not finite.
pub fn largest_error<const N: usize>(computed: [f64; N], exact: &[Big; N], unit: f64) -> f64 {
    let errors = computed.into_iter().zip(exact).map(|(computed, exact)| {
        let error = (big(computed) - exact).abs() / big(unit);
        error.to_f64().expect("a ratio of finite numbers")
    });
    errors.fold(0.0, f64::max)
}

/// The spacing of the floating-point numbers next to `value`, for a format with the given unit roundoff.
pub fn ulp(value: f64, unit_roundoff: f64) -> f64 {
    let mut binade = 1.0_f64;
    let value = value.abs().max(f64::MIN_POSITIVE);
    while binade * 2.0 <= value {
        binade *= 2.0;
    }
    while binade > value {
        binade /= 2.0;
    }
    binade * 2.0 * unit_roundoff
}

#[test]
fn the_oracle_knows_what_floating_point_loses() {
    let tenth = big(0.1);
    assert_ne!(tenth, Big::new(1.into(), 10.into()));
    assert_eq!(
        largest_error(
            [0.1 + 0.2],
            &[big(0.1) + big(0.2)],
            ulp(0.3, f64::EPSILON / 2.0)
        ),
        0.5
    );
    assert_eq!(big_bernstein(2, &big(0.5)), [0.25, 0.5, 0.25].map(big));
    let bezier = [0.0, 0.0, 0.0, 1.0, 1.0, 1.0];
    assert_eq!(
        big_bspline_basis(2, &bezier, &big(0.5), 1.0),
        [0.25, 0.5, 0.25].map(big)
    );
    assert_eq!(
        big_bspline_basis(2, &bezier, &big(1.0), 1.0),
        [0.0, 0.0, 1.0].map(big)
    );
    assert_eq!(ulp(1.0, f64::EPSILON / 2.0), f64::EPSILON);
    assert_eq!(ulp(0.75, f64::EPSILON / 2.0), f64::EPSILON / 2.0);
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
