//! Inputs that break the textbook's formulas for numbers and vectors, and what survives them.

use facette::algebra::{Scalar, VectorSpace, length, unit_vector};
use glam::Vec3;
use num_traits::{One, Zero};

use crate::common::exact::{Exact, fraction};

/// **The interpolation that misses its end.** The shorter formula $a+t\,(b-a)$ need not give $b$ at $t=1$: from $a=1$ to
/// $b=10^{-17}$ it ends at 0, and from $a=0.7$ to $b=0.1$ it ends at $0.09999999999999998$. Two patches that share the curve would
/// show a crack there. The longer formula $(1-t)\,a+t\,b$ ends at $b$. Over the rational numbers both are the same.
#[test]
fn lerp_that_misses_its_end() {
    let short = |a: f64, b: f64, t: f64| a + t * (b - a);
    for (a, b) in [(1.0, 1e-17), (0.7, 0.1), (1e16, 1.0)] {
        assert_ne!(short(a, b, 1.0), b);
        assert_eq!(a.lerp(b, 1.0), b);
    }
    assert_eq!(short(1.0, 1e-17, 1.0), 0.0);
    assert_eq!(short(0.7, 0.1, 1.0), 0.099_999_999_999_999_98);
    let (a, b, t) = (fraction(7, 10), fraction(1, 10), fraction(2, 3));
    assert_eq!(a.lerp(b, t), a + t * (b - a));
}

/// **Squares that overflow.** $\sqrt{x^2+y^2+z^2}$ is infinite for the vector $(10^{200},0,0)$ and zero for $(10^{-200},0,0)$, though
/// both lengths are perfectly good numbers. So are $\sqrt3\cdot10^{37}$ and $\sqrt3\cdot10^{-37}$ in single precision.
#[test]
fn squares_overflow_where_lengths_do_not() {
    let textbook = |[x, y, z]: [f64; 3]| (x * x + y * y + z * z).sqrt();
    for (size, wrong) in [(1e200, f64::INFINITY), (1e-200, 0.0)] {
        let vector = [size, 0.0, 0.0];
        assert_eq!(textbook(vector), wrong);
        assert_eq!(length(vector), size);
        assert_eq!(unit_vector(vector), Some([1.0, 0.0, 0.0]));
        assert_eq!(length([3.0 * size, 0.0, 4.0 * size]), 5.0 * size);
    }
    for size in [1e37_f32, 1e-37] {
        let vector = Vec3::splat(size);
        let ratio = length(vector) / size;
        assert!((ratio - 3_f32.sqrt()).abs() <= 4.0 * f32::EPSILON);
        assert!(unit_vector(vector).is_some_and(Vec3::is_normalized));
    }
    assert_eq!(
        unit_vector([f64::from_bits(1), 0.0, 0.0]),
        Some([1.0, 0.0, 0.0])
    );
}

/// **Vectors without a direction.** The zero vector has none, nor has one with an infinite or NaN coordinate: `unit_vector` gives
/// `None`, and `length` gives 0, infinity or NaN. NaN wins wherever it stands.
#[test]
fn vector_without_a_direction_has_no_unit_vector() {
    let [zero, infinite, nan] = [0.0, f64::INFINITY, f64::NAN];
    for vector in [
        [zero; 3],
        [-0.0, zero, zero],
        [infinite, 1.0, zero],
        [1.0, 2.0, nan],
        [nan, infinite, 1.0],
    ] {
        assert_eq!(unit_vector(vector), None, "{vector:?}");
    }
    assert_eq!(length([zero; 3]), 0.0);
    assert_eq!(length([1.0, -infinite, zero]), infinite);
    for vector in [
        [nan, 1.0, 2.0],
        [1.0, nan, 2.0],
        [1.0, 2.0, nan],
        [infinite, nan, 1.0],
        [nan, infinite, 1.0],
    ] {
        assert!(length(vector).is_nan(), "{vector:?}");
        assert!(vector.largest_coordinate().is_nan(), "{vector:?}");
        assert!(!vector.has_finite_coordinates());
    }
    assert!([1.0, -2.0, 1.5].has_finite_coordinates());
    assert_eq!([1.0, -2.0, 1.5].largest_coordinate(), 2.0);
    assert!(![1.0, infinite].has_finite_coordinates());
}

/// **Integers that do not fit.** A constant larger than $2^{24}$ is rounded in single precision: $2^{24}+1$ becomes $2^{24}$. In
/// double precision and over the rational numbers every 32-bit integer is itself.
#[test]
fn integer_constant_is_rounded_in_single_precision() {
    let number = (1 << 24) + 1;
    assert_eq!(f32::from_i32(number), 16_777_216.0);
    assert_eq!(f64::from_i32(number), 16_777_217.0);
    assert_eq!(
        Exact::from_i32(number) - Exact::from_i32(number - 1),
        Exact::one()
    );
    assert!(Exact::from_i32(0).is_zero());
}

/// **A coordinate that does not exist.** A single number is a vector of dimension 1. Asking it for its second coordinate is a
/// mistake of the program, and stops it with a message.
#[test]
#[should_panic(expected = "a number has coordinate 0 only, not 1")]
fn number_has_one_coordinate() {
    assert_eq!(2.5_f64.coordinate(0), 2.5);
    let _ = 2.5_f64.coordinate(1);
}
