//! Numbers, points and vectors: what every chapter is written over.
//!
//! A formula of the course is a statement about a field (`+ - * /`) or about real numbers (square roots, cosines).
//! The traits of this module let a signature say which, so that one piece of code runs over `f32` for speed, `f64`
//! for precision and exact rationals for proofs: what needs only a [`Scalar`] can be checked with `==`.
//!
//! ```text
//! Scalar       + - * /, ordering, small rational constants     f32, f64; exact and dual numbers in the tests
//! Real         a Scalar with sqrt, sin, cos                    f32, f64
//! VectorSpace  sums, multiples, affine combinations            every glam vector, [S; N], S itself
//! Vector3      a VectorSpace with dot and cross                Vec3, Vec3A, DVec3, [S; 3]
//! ```
//!
//! # Conventions
//!
//! Vectors are combined by named methods ([`VectorSpace::plus`], [`VectorSpace::lerp`]) instead of operators, because
//! an array `[S; N]` cannot carry operators of ours. Right-handed frames: `x × y = z`.
//!
//! # Numerics
//!
//! Nothing here fuses a multiplication with an addition, so the bits are the same on every processor. Every error bound of the
//! library supposes that nothing overflows, and that what is rounded is not denormal.
//!
//! *In the book*: [Numbers and points](../../../ground_floor.html).

use std::fmt::Debug;
use std::ops::{Div, Neg, Sub};

use glam::{DVec2, DVec3, DVec4, Vec2, Vec3, Vec3A, Vec3Swizzles, Vec4};
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

/// Points and vectors over a [`Scalar`], with the sums and multiples that affine combinations are made of.
pub trait VectorSpace: Copy + Debug + PartialEq + Send + Sync + 'static {
    /// The numbers that multiply these vectors.
    type Scalar: Scalar;

    /// How many coordinates a vector has.
    const DIMENSION: usize;

    /// The origin.
    fn origin() -> Self;

    /// The sum `self + other`.
    #[must_use]
    fn plus(self, other: Self) -> Self;

    /// The difference `self − other`.
    #[must_use]
    fn minus(self, other: Self) -> Self;

    /// The multiple `factor · self`.
    #[must_use]
    fn times(self, factor: Self::Scalar) -> Self;

    /// Coordinate number `index`, which is below [`Self::DIMENSION`].
    ///
    /// # Panics
    ///
    /// When the index is not below the dimension.
    fn coordinate(self, index: usize) -> Self::Scalar;

    /// Linear interpolation `(1 − t) self + t other`.
    ///
    /// # Accuracy
    ///
    /// Each coordinate is within `3u · max(|a|, |b|)` for `0 <= t <= 1`, and exact at `t = 0` and `t = 1` for finite
    /// points: the shorter `a + t (b − a)` misses `b` (hard case `lerp_that_misses_its_end`).
    ///
    /// # Edge cases
    ///
    /// Extrapolates outside `[0, 1]`.
    #[must_use]
    // ANCHOR: lerp
    fn lerp(self, other: Self, t: Self::Scalar) -> Self {
        self.times(Self::Scalar::one() - t).plus(other.times(t))
    }
    // ANCHOR_END: lerp

    /// The sum `Σ weights[i] · points[i]`, added from the left.
    #[must_use]
    fn combination<const N: usize>(weights: [Self::Scalar; N], points: [Self; N]) -> Self {
        let terms = weights.into_iter().zip(points);
        terms
            .map(|(weight, point)| point.times(weight))
            .reduce(Self::plus)
            .unwrap_or_else(Self::origin)
    }

    /// The largest absolute value of a coordinate; NaN where one is NaN.
    fn largest_coordinate(self) -> Self::Scalar {
        let mut largest = Self::Scalar::zero();
        for index in 0..Self::DIMENSION {
            let candidate = self.coordinate(index).magnitude();
            let is_nan = candidate.partial_cmp(&candidate).is_none();
            if candidate > largest || is_nan {
                largest = candidate;
            }
        }
        largest
    }

    /// Whether every coordinate is finite.
    fn has_finite_coordinates(self) -> bool {
        (0..Self::DIMENSION).all(|index| Scalar::is_finite(self.coordinate(index)))
    }
}

/// A [`VectorSpace`] of dimension 3 with the two products of geometry.
pub trait Vector3: VectorSpace {
    /// The vector with these coordinates.
    fn from_coordinates(coordinates: [Self::Scalar; 3]) -> Self;

    /// The scalar product `a · b`.
    fn dot(self, other: Self) -> Self::Scalar;

    /// The vector product `a × b`, right-handed.
    #[must_use]
    fn cross(self, other: Self) -> Self;
}

impl<S: Scalar> VectorSpace for S {
    type Scalar = S;
    const DIMENSION: usize = 1;

    fn origin() -> Self {
        S::zero()
    }

    fn plus(self, other: Self) -> Self {
        self + other
    }

    fn minus(self, other: Self) -> Self {
        self - other
    }

    fn times(self, factor: S) -> Self {
        self * factor
    }

    fn coordinate(self, index: usize) -> S {
        assert!(
            index < Self::DIMENSION,
            "a number has coordinate 0 only, not {index}"
        );
        self
    }
}

impl<S: Scalar, const N: usize> VectorSpace for [S; N] {
    type Scalar = S;
    const DIMENSION: usize = N;

    fn origin() -> Self {
        [S::zero(); N]
    }

    fn plus(self, other: Self) -> Self {
        std::array::from_fn(|index| self[index] + other[index])
    }

    fn minus(self, other: Self) -> Self {
        std::array::from_fn(|index| self[index] - other[index])
    }

    fn times(self, factor: S) -> Self {
        self.map(|coordinate| coordinate * factor)
    }

    fn coordinate(self, index: usize) -> S {
        self[index]
    }
}

impl<S: Scalar> Vector3 for [S; 3] {
    fn from_coordinates(coordinates: [S; 3]) -> Self {
        coordinates
    }

    fn dot(self, other: Self) -> S {
        let [x, y, z] = self;
        x * other[0] + y * other[1] + z * other[2]
    }

    #[rustfmt::skip]
    fn cross(self, other: Self) -> Self {
        let ([ax, ay, az], [bx, by, bz]) = (self, other);
        [
            ay * bz - az * by,
            az * bx - ax * bz,
            ax * by - ay * bx,
        ]
    }
}

macro_rules! glam_vector {
    ($vector:ty, $scalar:ty, $dimension:literal) => {
        impl VectorSpace for $vector {
            type Scalar = $scalar;
            const DIMENSION: usize = $dimension;

            #[inline]
            fn origin() -> Self {
                Self::ZERO
            }

            #[inline]
            fn plus(self, other: Self) -> Self {
                self + other
            }

            #[inline]
            fn minus(self, other: Self) -> Self {
                self - other
            }

            #[inline]
            fn times(self, factor: $scalar) -> Self {
                self * factor
            }

            #[inline]
            fn coordinate(self, index: usize) -> $scalar {
                self[index]
            }
        }
    };
    ($vector:ty, $scalar:ty) => {
        glam_vector!($vector, $scalar, 3);

        impl Vector3 for $vector {
            #[inline]
            fn from_coordinates(coordinates: [$scalar; 3]) -> Self {
                Self::from_array(coordinates)
            }

            #[inline]
            fn dot(self, other: Self) -> $scalar {
                self.dot(other)
            }

            // Not glam's own, which fuses in `Vec3A` where the processor can: other bits than elsewhere.
            #[inline]
            fn cross(self, other: Self) -> Self {
                (self.zxy() * other - self * other.zxy()).zxy()
            }
        }
    };
}

glam_vector!(Vec2, f32, 2);
glam_vector!(Vec4, f32, 4);
glam_vector!(DVec2, f64, 2);
glam_vector!(DVec4, f64, 4);
glam_vector!(Vec3, f32);
glam_vector!(Vec3A, f32);
glam_vector!(DVec3, f64);

/// The Euclidean length of `vector`, without overflow or underflow on the way.
///
/// # Accuracy
///
/// Relative error at most 5u wherever the length itself is a normal number (tested as `length_error_stays_below_its_bound`).
// ANCHOR: length
pub fn length<P>(vector: P) -> P::Scalar
where
    P: Vector3,
    P::Scalar: Real,
{
    let scale = vector.largest_coordinate();
    if scale.is_zero() || !Scalar::is_finite(scale) {
        return scale;
    }
    let scaled = divided(vector, scale);
    scaled.dot(scaled).sqrt() * scale
}
// ANCHOR_END: length

/// The unit vector along `vector`; `None` for a vector that is zero, infinite or NaN.
///
/// # Accuracy
///
/// Each coordinate that is a normal number has a relative error of at most 5u: the vector is scaled by its largest
/// coordinate first, so that squares neither overflow nor underflow (tested as `length_error_stays_below_its_bound`).
pub fn unit_vector<P>(vector: P) -> Option<P>
where
    P: Vector3,
    P::Scalar: Real,
{
    let scale = vector.largest_coordinate();
    if scale.is_zero() || !Scalar::is_finite(scale) {
        return None;
    }
    let scaled = divided(vector, scale);
    Some(divided(scaled, scaled.dot(scaled).sqrt()))
}

/// The larger of two numbers; NaN where one is NaN.
#[inline]
pub(crate) fn larger<S: Scalar>(a: S, b: S) -> S {
    let b_is_nan = b.partial_cmp(&b).is_none();
    if b > a || b_is_nan { b } else { a }
}

/// `vector / divisor` coordinate by coordinate: the reciprocal of a denormal number would overflow.
pub(crate) fn divided<P: Vector3>(vector: P, divisor: P::Scalar) -> P {
    P::from_coordinates([0, 1, 2].map(|index| vector.coordinate(index) / divisor))
}
