//! Points and vectors: arrays, and the vectors of glam.

use std::fmt::Debug;

use glam::{DVec2, DVec3, DVec4, Vec2, Vec3, Vec3A, Vec3Swizzles, Vec4};
use num_traits::{One, Zero};

use super::{Real, Scalar};

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

    /// A row of vectors as the row of their coordinates, one vector after the other: what is done to each coordinate alike can then be done to
    /// many at once. `None` where they do not lie in memory like that.
    fn flattened(row: &[Self]) -> Option<&[Self::Scalar]> {
        let _ = row;
        None
    }

    /// The same row as [`flattened`](Self::flattened), to be written.
    fn flattened_mut(row: &mut [Self]) -> Option<&mut [Self::Scalar]> {
        let _ = row;
        None
    }

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

    /// The coordinates x, y and z.
    #[inline]
    fn coordinates(self) -> [Self::Scalar; 3] {
        [0, 1, 2].map(|axis| self.coordinate(axis))
    }

    /// The coordinates in double precision.
    #[inline]
    fn in_double_precision(self) -> [f64; 3]
    where
        Self::Scalar: Real,
    {
        self.coordinates().map(Real::to_f64)
    }

    /// The vector of the coordinates' absolute values.
    #[inline]
    #[must_use]
    fn absolute(self) -> Self {
        Self::from_coordinates(self.coordinates().map(Scalar::magnitude))
    }

    /// The axis along which the vector runs most, 0 for x, 1 for y, 2 for z: the first of those with the largest absolute value.
    ///
    /// # Edge cases
    ///
    /// A NaN is passed over, unless it comes first.
    ///
    /// # Examples
    ///
    /// ```
    /// use facette::algebra::Vector3;
    ///
    /// assert_eq!([2.0, -3.0, 3.0].largest_axis(), 1);
    /// ```
    #[inline]
    fn largest_axis(self) -> usize {
        let size = |axis: usize| self.coordinate(axis).magnitude();
        let longer = |a: usize, b: usize| if size(b) > size(a) { b } else { a };
        longer(longer(0, 1), 2)
    }

    /// The scalar product `a · b`.
    fn dot(self, other: Self) -> Self::Scalar;

    /// The vector product `a × b`, right-handed.
    #[must_use]
    fn cross(self, other: Self) -> Self;
}

/// Passes where every coordinate is finite; else the error that `refusal` makes of the coordinates.
pub(crate) fn check_finite<P: Vector3, E>(
    vector: P,
    refusal: impl FnOnce([P::Scalar; 3]) -> E,
) -> Result<(), E> {
    if vector.has_finite_coordinates() {
        Ok(())
    } else {
        Err(refusal(vector.coordinates()))
    }
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

    fn flattened(row: &[S]) -> Option<&[S]> {
        Some(row)
    }

    fn flattened_mut(row: &mut [S]) -> Option<&mut [S]> {
        Some(row)
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

    fn flattened(row: &[Self]) -> Option<&[S]> {
        Some(row.as_flattened())
    }

    fn flattened_mut(row: &mut [Self]) -> Option<&mut [S]> {
        Some(row.as_flattened_mut())
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
