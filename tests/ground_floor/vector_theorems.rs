//! The theorems of points and vectors. The book shows their doc comments.

use std::cell::Cell;
use std::fmt::Debug;

use facette::algebra::{Real, Scalar, Vector3, VectorSpace, length, unit_vector};
use glam::{DVec2, DVec3, DVec4, Vec2, Vec3, Vec3A, Vec4};
use num_traits::{One, Signed, ToPrimitive, Zero};
use proptest::prelude::*;

use crate::common::exact::{Exact, fraction};
use crate::common::generators::{
    coordinate, float_coordinate, float_parameter, hard_float_coordinate, hard_float_parameter,
    hard_parameter, point,
};
use crate::common::law::{Verdict, expect_at_most, expect_equal};
use crate::common::oracle::{Big, big, largest_error};
use crate::inputs::{extreme, extreme_f32, finite, finite_f32, law};

/// **The ends of an interpolation.** For finite points $(1-t)\,a+t\,b$ is exactly $a$ at $t=0$ and exactly $b$ at $t=1$, in every
/// number type.
#[test]
fn lerp_is_exact_at_both_ends() {
    let pairs = ([finite(), finite()], [finite_f32(), finite_f32()]);
    let hard = ([extreme(), extreme()], [extreme_f32(), extreme_f32()]);
    law("ground_floor::lerp_is_exact_at_both_ends")
        .on_cases(256)
        .holds(pairs, hard, |&([a, b], [c, d])| {
            ends_are_exact(a, b)?;
            ends_are_exact([a, b, -a], [b, a, a])?;
            ends_are_exact(DVec4::new(a, b, a, b), DVec4::new(b, a, -b, -a))?;
            ends_are_exact(c, d)?;
            ends_are_exact(Vec3A::new(c, d, -c), Vec3A::new(d, c, -d))
        });
    ends_are_exact(fraction(1, 3), fraction(-7, 2)).expect("rational numbers do not round");
}

fn ends_are_exact<P: VectorSpace>(a: P, b: P) -> Verdict {
    expect_equal(
        &[a, b],
        &[a.lerp(b, P::Scalar::zero()), a.lerp(b, P::Scalar::one())],
    )
}

/// **The error of an interpolation.** For $0\le t\le1$ a computed $(1-t)\,a+t\,b$ is at most $3u\max(|a|,|b|)$ away from the true
/// one: the weight $1-t$, the product with $a$ and the sum round once each, and the two parts share the size of the whole.
#[test]
fn lerp_error_stays_below_its_bound() {
    let worst = Cell::new(0.0_f64);
    let inputs = (float_coordinate(), float_coordinate(), float_parameter());
    let hard = (
        hard_float_coordinate(),
        hard_float_coordinate(),
        hard_float_parameter(),
    );
    law("ground_floor::lerp_error_stays_below_its_bound")
        .on_cases(400)
        .holds(inputs, hard, |&(a, b, t)| {
            let size = a.abs().max(b.abs());
            if size == 0.0 {
                return expect_equal(&0.0, &a.lerp(b, t));
            }
            let exact = (big(1.0) - big(t)) * big(a) + big(t) * big(b);
            let error = largest_error([a.lerp(b, t)], &[exact], size * f64::unit_roundoff());
            worst.set(worst.get().max(error));
            expect_at_most("error in u max(|a|, |b|)", 3.0, error)
        });
    assert!(
        worst.get() >= 3.0 / 20.0,
        "the bound is not idle: {}",
        worst.get()
    );
}

/// **Affine combinations.** If $\sum w_i=1$, then $\sum w_i\,(p_i+x)=\sum w_i\,p_i+x$: the combination is a point, wherever the
/// origin lies. If one weight is 1 and the others are 0, it is that point itself.
#[test]
fn combination_with_weights_of_sum_one_is_a_point() {
    let inputs = (
        [point(), point(), point(), point()],
        [coordinate(), coordinate()],
    );
    let hard = (
        point().prop_map(|p| [p; 4]),
        [hard_parameter(), hard_parameter()],
    );
    law("ground_floor::combination_with_weights_of_sum_one_is_a_point").holds(
        inputs,
        hard,
        |&([p, q, r, x], [v, w])| {
            let weights = [v, w, Exact::one() - v - w];
            let moved = VectorSpace::combination(weights, [p.plus(x), q.plus(x), r.plus(x)]);
            let combined = VectorSpace::combination(weights, [p, q, r]);
            expect_equal(&combined.plus(x), &moved)?;
            for axis in 0..3 {
                let sum = v * p[axis] + w * q[axis] + (Exact::one() - v - w) * r[axis];
                expect_equal(&sum, &combined.coordinate(axis))?;
            }
            let [zero, one] = [0, 1].map(Exact::from_i32);
            expect_equal(&q, &VectorSpace::combination([zero, one, zero], [p, q, r]))
        },
    );
    assert_eq!(<[f64; 2]>::combination([], []), <[f64; 2]>::origin());
}

/// **The vector product.** $a\times b$ is orthogonal to both factors, changes its sign with their order, and is as long as their
/// parallelogram is large: $|a\times b|^2+(a\cdot b)^2=|a|^2\,|b|^2$. It is right-handed: $x\times y=z$.
#[test]
fn cross_product_is_orthogonal_to_its_factors() {
    let hard = (point(), coordinate()).prop_map(|(a, factor)| (a, a.times(factor)));
    law("ground_floor::cross_product_is_orthogonal_to_its_factors").holds(
        (point(), point()),
        hard,
        |&(a, b)| {
            let c = a.cross(b);
            expect_equal(&[Exact::zero(); 2], &[c.dot(a), c.dot(b)])?;
            expect_equal(&<[Exact; 3]>::origin().minus(c), &b.cross(a))?;
            let area = a.dot(a) * b.dot(b) - a.dot(b) * a.dot(b);
            expect_equal(&area, &c.dot(c))
        },
    );
    let [x, y, z] = [[1, 0, 0], [0, 1, 0], [0, 0, 1]].map(|axis| axis.map(Exact::from_i32));
    assert_eq!([x.cross(y), y.cross(z), z.cross(x)], [z, x, y]);
}

/// What the methods of a vector give, as bits; every NaN is the same.
fn bits<S: Into<f64>>(number: S) -> u64 {
    let number = number.into();
    if number.is_nan() {
        f64::NAN.to_bits()
    } else {
        number.to_bits()
    }
}

fn computed<V: VectorSpace>(a: V, b: V, t: V::Scalar) -> Vec<u64>
where
    V::Scalar: Into<f64>,
{
    let vectors = [
        a.plus(b),
        a.minus(b),
        a.times(t),
        a.lerp(b, t),
        V::combination([t, t], [a, b]),
        V::origin(),
    ];
    let coordinates =
        |vector: V| (0..V::DIMENSION).map(move |index| bits(vector.coordinate(index)));
    let numbers = vectors.into_iter().flat_map(coordinates);
    numbers.chain([bits(a.largest_coordinate())]).collect()
}

fn by_hand<S: Real + Into<f64>>(a: &[S], b: &[S], t: S) -> Vec<u64> {
    let pair = |operation: fn(S, S, S) -> S| {
        a.iter()
            .zip(b)
            .map(move |(&a, &b)| bits(operation(a, b, t)))
    };
    let largest = a.iter().map(|a| (*a).into().abs()).fold(0.0, f64::max);
    let sums = pair(|a, b, _| a + b).chain(pair(|a, b, _| a - b));
    let multiples = sums.chain(pair(|a, _, t| a * t));
    let mixtures = multiples.chain(pair(|a, b, t| a * (S::one() - t) + b * t));
    let combined = mixtures.chain(pair(|a, b, t| a * t + b * t));
    combined
        .chain(pair(|_, _, _| S::zero()))
        .chain([bits(largest)])
        .collect()
}

fn products<V: Vector3>(a: V, b: V) -> [u64; 4]
where
    V::Scalar: Into<f64>,
{
    let cross = a.cross(b);
    let [x, y, z] = [0, 1, 2].map(|index| bits(cross.coordinate(index)));
    [bits(a.dot(b)), x, y, z]
}

/// **The same bits.** Every vector type computes coordinate by coordinate, each operation rounded once and none fused: `Vec2`,
/// `Vec3`, `Vec3A`, `Vec4`, `DVec2`, `DVec3`, `DVec4` and arrays give the same bits as the same formula on single numbers.
#[test]
fn every_vector_type_gives_the_same_bits() {
    type Input = ([f64; 4], [f64; 4], f64);
    let vector = || prop::array::uniform4(float_coordinate());
    let hard_vector = || prop::array::uniform4(hard_float_coordinate());
    let inputs = (vector(), vector(), float_parameter());
    let hard = (hard_vector(), hard_vector(), hard_float_parameter());
    law("ground_floor::every_vector_type_gives_the_same_bits")
        .on_cases(256)
        .holds(inputs, hard, |&(a, b, t): &Input| {
            let [[ax, ay, az, _], [bx, by, bz, _]] = [a, b];
            let ([a2, b2], [a3, b3]) = ([[ax, ay], [bx, by]], [[ax, ay, az], [bx, by, bz]]);
            expect_equal(&by_hand(&a[..1], &b[..1], t), &computed(ax, bx, t))?;
            expect_equal(
                &by_hand(&a2, &b2, t),
                &computed(DVec2::from(a2), b2.into(), t),
            )?;
            expect_equal(
                &by_hand(&a3, &b3, t),
                &computed(DVec3::from(a3), b3.into(), t),
            )?;
            expect_equal(&by_hand(&a, &b, t), &computed(DVec4::from(a), b.into(), t))?;
            expect_equal(&by_hand(&a, &b, t), &computed(a, b, t))?;
            expect_equal(
                &products(a3, b3),
                &products(DVec3::from(a3), DVec3::from_coordinates(b3)),
            )?;
            in_single_precision(&a.map(narrow), &b.map(narrow), narrow(t))
        });
}

#[allow(
    clippy::cast_possible_truncation,
    reason = "narrowing is what it is for"
)]
fn narrow(number: f64) -> f32 {
    number as f32
}

fn in_single_precision(a: &[f32; 4], b: &[f32; 4], t: f32) -> Verdict {
    let [[ax, ay, az, _], [bx, by, bz, _]] = [*a, *b];
    let ([a2, b2], [a3, b3]) = ([[ax, ay], [bx, by]], [[ax, ay, az], [bx, by, bz]]);
    expect_equal(
        &by_hand(&a2, &b2, t),
        &computed(Vec2::from(a2), b2.into(), t),
    )?;
    expect_equal(
        &by_hand(&a3, &b3, t),
        &computed(Vec3::from(a3), b3.into(), t),
    )?;
    expect_equal(
        &by_hand(&a3, &b3, t),
        &computed(Vec3A::from(a3), b3.into(), t),
    )?;
    expect_equal(&by_hand(a, b, t), &computed(Vec4::from(*a), (*b).into(), t))?;
    let dot = ax * bx + ay * by + az * bz;
    let cross = [ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx];
    let [x, y, z] = cross.map(bits);
    expect_equal(&[bits(dot), x, y, z], &products(a3, b3))?;
    expect_equal(
        &products(a3, b3),
        &products(Vec3::from(a3), Vec3::from_coordinates(b3)),
    )?;
    expect_equal(
        &products(a3, b3),
        &products(Vec3A::from(a3), Vec3A::from_coordinates(b3)),
    )
}

/// How far `length` and `unit_vector` are from the true values, in units of u; a coordinate of the unit vector counts where it is a
/// normal number.
fn length_errors<S: Real + Into<f64> + Debug>(vector: [S; 3], least_normal: f64) -> [f64; 2] {
    let unit = big(S::unit_roundoff().into());
    let coordinates = vector.map(|x| big(x.into()));
    let square = coordinates.iter().fold(Big::zero(), |sum, x| sum + x * x);
    // For a small error e the square of a (1 + e) is a² (1 + 2e).
    let error = |computed: S, square: &Big| {
        let computed = big(computed.into());
        let twice = (&computed * &computed / square - Big::one()).abs() / &unit;
        twice.to_f64().expect("a ratio of finite numbers") / 2.0
    };
    let of_length = error(length(vector), &square);
    let unit_coordinates = unit_vector(vector).expect("a vector with a direction");
    let mut of_unit = 0.0_f64;
    for (computed, x) in unit_coordinates.into_iter().zip(&coordinates) {
        if computed.into().abs() >= least_normal {
            of_unit = of_unit.max(error(computed, &(x * x / &square)));
        }
    }
    [of_length, of_unit]
}

/// **Lengths.** From the smallest vectors to the largest, $|v|=\sqrt{x^2+y^2+z^2}$ has a relative error of at most $5u$, and so has
/// each coordinate of $v/|v|$ that is a normal number: the vector is divided by its largest coordinate before anything is squared.
#[test]
fn length_error_stays_below_its_bound() {
    let decimal = |range: std::ops::RangeInclusive<i32>| {
        (1.0..10.0_f64, range, prop::bool::ANY).prop_map(|(digits, exponent, negative)| {
            digits * 10_f64.powi(exponent) * if negative { -1.0 } else { 1.0 }
        })
    };
    let worst = Cell::new([0.0_f64; 2]);
    let near = prop::array::uniform3(decimal(-1..=1));
    let inputs = (near, -298..=298_i32, -35..=35_i32);
    let ends = [0.0, 1e-300, 1.0, 1e300, -1e300, f64::MIN_POSITIVE];
    let coordinates = prop::array::uniform3(prop::sample::select(ends.to_vec()));
    let hard = (coordinates, Just(0), Just(0))
        .prop_filter("a vector with a direction", |(v, ..)| *v != [0.0; 3]);
    law("ground_floor::length_error_stays_below_its_bound")
        .on_cases(400)
        .holds(inputs, hard, |&(v, wide, narrow_by)| {
            let wide = v.map(|x| x * 10_f64.powi(wide));
            let errors = length_errors(wide, f64::MIN_POSITIVE);
            let [seen_length, seen_unit] = worst.get();
            worst.set([seen_length.max(errors[0]), seen_unit.max(errors[1])]);
            expect_at_most(
                "error of length and unit vector in u",
                5.0,
                errors[0].max(errors[1]),
            )?;
            let single = v.map(|x| narrow(x.clamp(-100.0, 100.0) * 10_f64.powi(narrow_by)));
            if single == [0.0; 3] {
                return Ok(());
            }
            let errors = length_errors(single, f64::from(f32::MIN_POSITIVE));
            expect_at_most(
                "error of length and unit vector in u of f32",
                5.0,
                errors[0].max(errors[1]),
            )
        });
    let [of_length, of_unit] = worst.get();
    assert!(
        of_length >= 0.25 && of_unit >= 0.25,
        "the bound is not idle: {of_length}, {of_unit}"
    );
}
