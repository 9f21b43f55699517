//! What keeps data from being a camera.

use thiserror::Error;

use crate::algebra::{Scalar, Vector3, check_finite};

/// What is wrong with the data of a camera.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum CameraError<S> {
    /// A point or direction has a coordinate that is infinite or NaN.
    #[error("{what} is {value:?}: every coordinate must be finite")]
    PointNotFinite {
        /// Which one, for example `the eye`.
        what: &'static str,
        /// Its coordinates.
        value: [S; 3],
    },
    /// The eye is the target.
    #[error(
        "the eye and the target are the same point {eye:?}: no direction leads from one to the other"
    )]
    EyeAtTarget {
        /// The point.
        eye: [S; 3],
    },
    /// The direction that should point up is zero.
    #[error("the direction up is {up:?}: it must not be zero")]
    UpIsZero {
        /// Its coordinates.
        up: [S; 3],
    },
    /// The direction that should point up lies along the view.
    #[error(
        "up = {up:?} is parallel to the direction of view {view:?}, up to the rounding of the given numbers: take another direction \
         up, or `CameraFrame::looking_at_with_any_up`"
    )]
    UpAlongView {
        /// The direction up.
        up: [S; 3],
        /// The unit vector from the eye to the target.
        view: [S; 3],
    },
    /// The axes of a frame are not orthonormal.
    #[error(
        "{first} · {second} is {product:?}, where an orthonormal frame has {expected:?} (tolerance {tolerance:?})"
    )]
    NotOrthonormal {
        /// The first axis.
        first: &'static str,
        /// The second axis, which may be the same.
        second: &'static str,
        /// Their scalar product.
        product: S,
        /// What it should be.
        expected: S,
        /// How far it may be from that.
        tolerance: S,
    },
    /// The axes of a frame are a left hand.
    #[error(
        "(u × v) · w is {determinant:?}: the axes must be right-handed, u to the right, v up, w backwards"
    )]
    LeftHanded {
        /// The determinant, which should be 1.
        determinant: S,
    },
    /// A length, ratio or border is infinite or NaN, or a length or ratio is not positive.
    #[error("{what} is {value:?}: it must be {expected}")]
    NumberOutOfRange {
        /// Which number.
        what: &'static str,
        /// Its value.
        value: S,
        /// What is expected, for example `positive and finite`.
        expected: &'static str,
    },
    /// The image rectangle is empty, or its borders are exchanged.
    #[error(
        "{low_name} = {low:?} is not below {high_name} = {high:?}: the image rectangle must have a positive, finite extent"
    )]
    EmptyRectangle {
        /// `left` or `bottom`.
        low_name: &'static str,
        /// Its value.
        low: S,
        /// `right` or `top`.
        high_name: &'static str,
        /// Its value.
        high: S,
    },
    /// The field of view is not an angle between 0 and π.
    #[error(
        "the field of view is {angle:?} rad: it must lie strictly between 0 and π (60° are 1.047 rad)"
    )]
    FieldOfView {
        /// The angle.
        angle: S,
    },
}

impl<S: Scalar> CameraError<S> {
    /// Passes where every coordinate is finite.
    pub(super) fn check_finite<P>(what: &'static str, vector: P) -> Result<(), Self>
    where
        P: Vector3<Scalar = S>,
    {
        check_finite(vector, |value| Self::PointNotFinite { what, value })
    }
}

/// An image without pixels, or with more than can be counted.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[error("an image of {columns} × {rows} pixels: each number must be between 1 and 8388608 = 2^23")]
pub struct ImageSizeError {
    /// How many columns were asked for.
    pub columns: u32,
    /// How many rows.
    pub rows: u32,
}
