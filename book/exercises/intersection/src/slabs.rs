//! Exercise 3: the part of a line that is in a box.
//!
//! Replace `todo!(...)` by your code, save, and run `cargo exercise intersection/slabs`.

use crate::algebra::Vector3;
use crate::intersection::BoundingBox;
use crate::ray::Ray;
use num_traits::Zero;

/// The parameters `[entry, exit]` between which the whole line of the ray is in the box, its surface included; `None` where it
/// misses.
///
/// For each axis, with o and d the coordinates of origin and direction:
///
/// ```text
/// (min - o) / d    and    (max - o) / d           where the line crosses the two planes: which is the entry depends on d
/// d = 0                                           the line is in this slab everywhere, if min <= o <= max, or nowhere
/// ```
///
/// How the three entries and the three exits combine is left to you, as on the slides.
///
/// What you can use:
///
/// ```text
/// v.coordinate(axis)        the coordinate of a vector: axis 0, 1 or 2
/// bounds.min()              the corner with the smallest coordinates;   bounds.max()   the one with the largest
/// ray.origin, ray.direction
/// d.is_zero()               whether the number d is 0
/// P::Scalar::zero()         the number 0
/// ```
///
/// The numbers may be exact fractions, which have no infinity: start with `let mut interval: Option<[P::Scalar; 2]> = None;`
/// and the first slab that has an entry and an exit.
pub fn box_interval<P: Vector3>(bounds: &BoundingBox<P>, ray: &Ray<P>) -> Option<[P::Scalar; 2]> {
    todo!("box_interval: [entry, exit], or None")
}
