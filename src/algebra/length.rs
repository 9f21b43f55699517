//! Lengths and directions, which a vector scaled by its largest coordinate has without overflow.

use num_traits::Zero;

use super::{Real, Scalar, Vector3};

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

/// `vector / divisor` coordinate by coordinate: the reciprocal of a denormal number would overflow.
pub(crate) fn divided<P: Vector3>(vector: P, divisor: P::Scalar) -> P {
    P::from_coordinates([0, 1, 2].map(|index| vector.coordinate(index) / divisor))
}
