//! A solution of exercise 5: the field of view.

use crate::algebra::Real;

/// Half the height of the image rectangle that is seen at `distance` under the vertical angle `field_of_view`.
pub fn half_extent<S: Real>(field_of_view: S, distance: S) -> S {
    let half = field_of_view / S::from_i32(2);
    distance * (half.sin() / half.cos())
}
