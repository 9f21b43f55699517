//! The theorems of numbers. The book shows their doc comments.

use facette::algebra::{Real, Scalar};
use num_traits::{One, Signed, Zero};
use proptest::prelude::*;

use crate::common::dual::{Dual, constant, variable};
use crate::common::exact::{Exact, fraction};
use crate::common::generators::{coordinate, hard_parameter, parameter};
use crate::common::law::{expect_at_most, expect_equal};
use crate::common::oracle::{Big, big, largest_error};
use crate::inputs::{expect, extreme, finite, law};

/// **Fields.** Rational numbers are computed without rounding: $\tfrac{p}{q}\cdot q=p$ holds with $=$, while in floating
/// point the nearest number to $p/q$ is at most $u\,|p/q|$ away. The unit roundoff $u$ is $2^{-24}$ for `f32`, $2^{-53}$ for
/// `f64`, and 0 for exact numbers.
#[test]
fn ratio_is_the_nearest_number() {
    let ratios = (-1000..=1000_i32, 1..=1000_i32);
    let hard = (
        prop::sample::select(vec![i32::MIN, -1, 0, 1, (1 << 24) + 1, i32::MAX]),
        prop::sample::select(vec![1, 3, 7, i32::MAX]),
    );
    law("ground_floor::ratio_is_the_nearest_number").holds(ratios, hard, |&(p, q)| {
        expect_equal(
            &Exact::from_i32(p),
            &(Exact::ratio(p, q) * Exact::from_i32(q)),
        )?;
        let exact = Big::new(p.into(), q.into());
        let unit = f64::unit_roundoff();
        let error = (big(f64::ratio(p, q)) - &exact).abs();
        expect(
            "the nearest f64",
            error <= exact.abs() * big(unit),
            f64::ratio(p, q),
        )?;
        // In single precision the two integers may have been rounded before the division.
        let unit = f64::from(f32::unit_roundoff());
        let error = (big(f64::from(f32::ratio(p, q))) - &exact).abs();
        expect(
            "an f32 within 3u",
            error <= exact.abs() * big(3.0 * unit + 1e-13),
            f32::ratio(p, q),
        )
    });
    assert_eq!(f32::unit_roundoff(), 2_f32.powi(-24));
    assert_eq!(f64::unit_roundoff(), 2_f64.powi(-53));
    assert_eq!(1.0 + f64::unit_roundoff(), 1.0);
    assert!(1.0 + f64::unit_roundoff() * (1.0 + f64::EPSILON) > 1.0);
    assert_eq!(Exact::unit_roundoff(), Exact::zero());
}

/// **Absolute value.** $|x|$ is $x$ or $-x$, whichever is not negative; and what is infinite or NaN is not finite.
#[test]
fn magnitude_is_the_absolute_value() {
    law("ground_floor::magnitude_is_the_absolute_value").holds(finite(), extreme(), |&x| {
        expect_equal(&x.abs(), &x.magnitude())?;
        expect("a finite number", Scalar::is_finite(x), x)
    });
    assert_eq!(fraction(-2, 3).magnitude(), fraction(2, 3));
    assert!(f64::NAN.magnitude().is_nan());
    assert_eq!(f32::NEG_INFINITY.magnitude(), f32::INFINITY);
    for x in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        assert!(!Scalar::is_finite(x));
    }
    assert!(!Scalar::is_finite(f32::NAN) && Scalar::is_finite(f32::MAX));
}

/// **Roots and angles.** `Real` has the square root, the sine and the cosine of real numbers, to the last bit or the one before
/// it. They leave the field of rational numbers, so no exact number offers them.
#[test]
fn real_functions_are_accurate() {
    let angles = -3.0..3.0_f64;
    let hard = prop::sample::select(vec![0.0, 1e-9, std::f64::consts::FRAC_PI_2, 3.0, -0.5]);
    law("ground_floor::real_functions_are_accurate").holds(angles, hard, |&x| {
        let [sin, cos] = series(&big(x));
        // Near a zero of the function its own last bit is finer than the unit of 1 in which the error is counted here.
        expect_at_most(
            "error in u",
            2.0,
            largest_error([Real::sin(x)], &[sin], f64::unit_roundoff()),
        )?;
        expect_at_most(
            "error in u",
            2.0,
            largest_error([Real::cos(x)], &[cos], f64::unit_roundoff()),
        )?;
        let root = big(Real::sqrt(x.abs()));
        let error = (&root * &root - big(x.abs())).abs();
        expect(
            "a root within u",
            error <= big(x.abs()) * big(2.1 * f64::unit_roundoff()),
            x,
        )
    });
    assert!(Real::sqrt(-1.0_f64).is_nan());
    assert_eq!(Real::sqrt(2.25_f32), 1.5);
    assert_eq!([Real::sin(0.0_f32), Real::cos(0.0_f32)], [0.0, 1.0]);
    assert!((Real::sin(0.5_f32) - 0.479_425_55).magnitude() <= f32::EPSILON);
}

/// The sine and the cosine of an angle of at most 3, by 17 terms of their series each: the rest is below 10⁻²¹.
fn series(x: &Big) -> [Big; 2] {
    let mut sums = [Big::zero(), Big::zero()];
    let mut term = Big::one();
    for k in 0..34_i32 {
        let sign = Big::from_integer(if k % 4 < 2 { 1 } else { -1 }.into());
        let sum = &mut sums[usize::from(k % 2 == 0)];
        *sum = &*sum + &sign * &term;
        term = term * x / Big::from_integer((k + 1).into());
    }
    sums
}

/// **Dual numbers.** With $\varepsilon^2=0$ a polynomial satisfies $p(t+\varepsilon)=p(t)+p'(t)\,\varepsilon$. So the derivative
/// of any formula written over a `Scalar` comes for nothing, exactly.
#[test]
fn dual_numbers_carry_the_derivative() {
    let polynomials = (prop::collection::vec(coordinate(), 0..6), parameter());
    let hard = (prop::collection::vec(coordinate(), 6..9), hard_parameter());
    law("ground_floor::dual_numbers_carry_the_derivative").holds(
        polynomials,
        hard,
        |(coefficients, t)| {
            let horner = |sum: Dual<Exact>, &c: &Exact| sum * variable(*t) + constant(c);
            let computed = coefficients.iter().rev().fold(Dual::zero(), horner);
            let mut expected = constant(Exact::zero());
            let mut power = Exact::one();
            for (i, &c) in (0..).zip(coefficients) {
                expected.value = expected.value + c * power;
                // i · c · tⁱ⁻¹, which is 0 for i = 0
                if let Some(next) = coefficients.get(usize::try_from(i).expect("a small index") + 1)
                {
                    expected.slope = expected.slope + Exact::from_i32(i + 1) * *next * power;
                }
                power = power * *t;
            }
            expect_equal(&expected, &computed)
        },
    );
    let on_its_way_up = variable(0.0);
    assert_eq!(on_its_way_up.magnitude(), on_its_way_up);
    let negative = Dual {
        value: -1.0,
        slope: 2.0,
    };
    assert_eq!(
        negative.magnitude(),
        Dual {
            value: 1.0,
            slope: -2.0
        }
    );
    assert!(!Scalar::is_finite(Dual {
        value: 1.0,
        slope: f64::NAN
    }));
}
