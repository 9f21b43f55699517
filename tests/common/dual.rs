//! Dual numbers: a value and its derivative, carried through every operation.

use std::cmp::Ordering;
use std::ops::{Add, Div, Mul, Neg, Sub};

use facette::algebra::{Scalar, VectorSpace};
use facette::curve::{BezierCurve, Curve};
use num_traits::{One, Zero};

/// `value + slope · ε` with `ε² = 0`: what a function makes of `t + ε` is its value and its derivative at `t`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dual<S> {
    /// The number itself.
    pub value: S,
    /// Its derivative.
    pub slope: S,
}

/// A number that does not vary.
pub fn constant<S: Scalar>(value: S) -> Dual<S> {
    Dual {
        value,
        slope: S::zero(),
    }
}

/// The variable with respect to which the derivative is taken.
pub fn variable<S: Scalar>(value: S) -> Dual<S> {
    Dual {
        value,
        slope: S::one(),
    }
}

/// The derivatives of a point's coordinates.
pub fn slopes<S: Scalar, const N: usize>(point: [Dual<S>; N]) -> [S; N] {
    point.map(|coordinate| coordinate.slope)
}

/// A Bézier curve with the same control points over dual numbers.
pub fn dual_bezier<S: Scalar, const N: usize>(
    curve: &BezierCurve<[S; N]>,
) -> BezierCurve<[Dual<S>; N]> {
    let control_points = curve
        .control_points()
        .iter()
        .map(|point| point.map(constant))
        .collect();
    BezierCurve::new(control_points).expect("the curve's points are finite")
}

impl<S: Scalar> PartialOrd for Dual<S> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        self.value.partial_cmp(&other.value)
    }
}

impl<S: Scalar> Add for Dual<S> {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            value: self.value + other.value,
            slope: self.slope + other.slope,
        }
    }
}

impl<S: Scalar> Sub for Dual<S> {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        Self {
            value: self.value - other.value,
            slope: self.slope - other.slope,
        }
    }
}

impl<S: Scalar> Mul for Dual<S> {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let slope = self.slope * other.value + self.value * other.slope;
        Self {
            value: self.value * other.value,
            slope,
        }
    }
}

impl<S: Scalar> Div for Dual<S> {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        let value = self.value / other.value;
        Self {
            value,
            slope: (self.slope - value * other.slope) / other.value,
        }
    }
}

impl<S: Scalar> Neg for Dual<S> {
    type Output = Self;

    fn neg(self) -> Self {
        Self {
            value: -self.value,
            slope: -self.slope,
        }
    }
}

impl<S: Scalar> Zero for Dual<S> {
    fn zero() -> Self {
        constant(S::zero())
    }

    fn is_zero(&self) -> bool {
        self.value.is_zero() && self.slope.is_zero()
    }
}

impl<S: Scalar> One for Dual<S> {
    fn one() -> Self {
        constant(S::one())
    }
}

impl<S: Scalar> Scalar for Dual<S> {
    fn unit_roundoff() -> Self {
        constant(S::unit_roundoff())
    }

    fn from_i32(value: i32) -> Self {
        constant(S::from_i32(value))
    }

    fn is_finite(self) -> bool {
        Scalar::is_finite(self.value) && Scalar::is_finite(self.slope)
    }
}

#[test]
fn dual_numbers_differentiate() {
    use super::exact::{Exact, fraction};
    let t = variable(fraction(2, 3));
    let square_over = t * t / (t + Dual::one());
    // (t² / (t + 1))' = (t² + 2t) / (t + 1)²
    assert_eq!(
        square_over,
        Dual {
            value: fraction(4, 15),
            slope: fraction(16, 25)
        }
    );
    let curve = BezierCurve::new(vec![[fraction(0, 1)], [fraction(1, 1)], [fraction(0, 1)]]);
    let curve: BezierCurve<[Exact; 1]> = curve.expect("three finite points");
    assert_eq!(slopes(dual_bezier(&curve).point(t)), [fraction(-2, 3)]);
    assert_eq!(<[Dual<Exact>; 1]>::DIMENSION, 1);
}
