//! Exercise 5: the field of view.
//!
//! Replace `todo!(...)` by your code, save, and run `cargo exercise camera/field_of_view`.

use crate::algebra::Real;

/// Half the height of the image rectangle that is seen at `distance` under the vertical angle `field_of_view`: the whole angle between the lowest and the
/// highest ray, in radians.
///
/// What you can use:
///
/// ```text
/// x.sin()   x.cos()     sine and cosine of an angle in radians
/// S::from_i32(2)        the number 2 in the type S
/// ```
pub fn half_extent<S: Real>(field_of_view: S, distance: S) -> S {
    todo!("half_extent: half the height")
}
