//! A box as three slabs: the part of a line between two planes, three times, and what the three have in common.

use num_traits::{One, Zero};

use super::{BoundingBox, larger_ignoring_nan, smaller_ignoring_nan};
use crate::algebra::{Real, Scalar, Vector3};
use crate::intersection::Side;
use crate::ray::Ray;

/// The part of a line that is in a box.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BoxSpan<S> {
    /// The parameter where the line enters: the largest of the three slabs' entries.
    pub entry: S,
    /// The parameter where it leaves: the smallest of the three exits.
    pub exit: S,
    /// The axis of the slab that is entered last: its face is where the line enters. The first of several.
    pub entry_axis: usize,
    /// The axis of the slab that is left first. The first of several.
    pub exit_axis: usize,
}

/// Where a ray meets the surface of a box: what a field (`+ − × ÷`) suffices for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FaceHit<S> {
    /// The ray's parameter.
    pub t: S,
    /// The axis that the face is perpendicular to.
    pub axis: usize,
    /// The side of the face that is hit.
    pub side: Side,
}

impl<P: Vector3> BoundingBox<P> {
    /// The part of the ray's whole line that is in the box, its surface included; `None` where there is none, or the ray has NaN, an infinite
    /// coordinate or no direction. The ray's interval of t does not matter.
    ///
    /// A coordinate of the direction that is 0, or −0, is never divided by: then the line is in that slab everywhere or nowhere. So the function
    /// needs a field only, and in floating point it never makes NaN.
    ///
    /// # Accuracy
    ///
    /// Entry and exit are within `3u` of their size from those of the exact line; where those are nearer to each other, hit or miss may be wrong.
    ///
    /// # Source
    ///
    /// Kay and Kajiya 1986; slides 96 to 98.
    // ANCHOR: span
    pub fn span(&self, ray: &Ray<P>) -> Option<BoxSpan<P::Scalar>> {
        let is_finite =
            ray.origin.has_finite_coordinates() && ray.direction.has_finite_coordinates();
        let mut span: Option<BoxSpan<P::Scalar>> = None;
        for axis in 0..P::DIMENSION {
            if ray.direction.coordinate(axis).is_zero() {
                if !self.holds(axis, ray.origin.coordinate(axis)) {
                    return None;
                }
            } else {
                let slab = self.slab(axis, ray);
                span = Some(span.map_or(slab, |span| span.and(slab)));
            }
        }
        span.filter(|span| span.entry <= span.exit && is_finite)
    }
    // ANCHOR_END: span

    /// The part of the ray's line between the two planes of an axis that it is not parallel to.
    #[inline]
    // ANCHOR: slab
    fn slab(&self, axis: usize, ray: &Ray<P>) -> BoxSpan<P::Scalar> {
        let [o, d] = [ray.origin, ray.direction].map(|vector| vector.coordinate(axis));
        let to_min = (self.min.coordinate(axis) - o) / d;
        let to_max = (self.max.coordinate(axis) - o) / d;
        let is_forward = d > P::Scalar::zero();
        let [entry, exit] = if is_forward {
            [to_min, to_max]
        } else {
            [to_max, to_min]
        };
        BoxSpan {
            entry,
            exit,
            entry_axis: axis,
            exit_axis: axis,
        }
    }
    // ANCHOR_END: slab

    /// The nearest point of the box's six faces in the ray's interval of t: where it enters, or else where it leaves.
    ///
    /// Over exact numbers it is exact. A line in the plane of a face meets that face's edges, which belong to the neighbouring faces.
    pub fn face_hit(&self, ray: &Ray<P>) -> Option<FaceHit<P::Scalar>> {
        let span = self.span(ray)?;
        if ray.reaches(span.entry) {
            return Some(FaceHit {
                t: span.entry,
                axis: span.entry_axis,
                side: Side::Front,
            });
        }
        ray.reaches(span.exit).then_some(FaceHit {
            t: span.exit,
            axis: span.exit_axis,
            side: Side::Back,
        })
    }
}

impl<S: Scalar> BoxSpan<S> {
    /// What two slabs have in common; the first wins where they are equal.
    #[inline]
    fn and(self, other: Self) -> Self {
        let [later, earlier] = [other.entry > self.entry, other.exit < self.exit];
        Self {
            entry: if later { other.entry } else { self.entry },
            entry_axis: if later {
                other.entry_axis
            } else {
                self.entry_axis
            },
            exit: if earlier { other.exit } else { self.exit },
            exit_axis: if earlier {
                other.exit_axis
            } else {
                self.exit_axis
            },
        }
    }
}

/// The parameters `[entry, exit]` between which the ray's whole line is in the box: [`BoundingBox::span`] without the faces.
pub fn box_interval<P: Vector3>(bounds: &BoundingBox<P>, ray: &Ray<P>) -> Option<[P::Scalar; 2]> {
    bounds.span(ray).map(|span| [span.entry, span.exit])
}

/// A ray prepared for many boxes: with the reciprocals of its direction's coordinates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SlabRay<P: Vector3> {
    origin: P,
    /// `1 / d`: infinite for a zero, and negative for −0; NaN for a d so small that it has no reciprocal, whose slab then decides nothing.
    reciprocal: P,
    start: P::Scalar,
    end: P::Scalar,
}

impl<P> SlabRay<P>
where
    P: Vector3,
    P::Scalar: Real,
{
    /// The ray with its reciprocals.
    pub fn new(ray: &Ray<P>) -> Self {
        let [zero, one] = [P::Scalar::zero(), P::Scalar::one()];
        let reciprocal = [0, 1, 2].map(|axis| {
            let d = ray.direction.coordinate(axis);
            let reciprocal = one / d;
            let overflows = !d.is_zero() && !Scalar::is_finite(reciprocal);
            // Infinity would put a plane that lies ahead beyond all others, however near it is.
            if overflows {
                P::Scalar::from_f64(f64::NAN)
            } else {
                reciprocal
            }
        });
        Self {
            origin: ray.origin,
            reciprocal: P::from_coordinates(reciprocal),
            start: ray.start,
            end: ray.end.unwrap_or(one / zero),
        }
    }

    /// The same ray up to `end`: of use where a hit has been found there, and only nearer ones count.
    #[must_use]
    pub fn until(self, end: P::Scalar) -> Self {
        Self { end, ..self }
    }
}

impl<P> BoundingBox<P>
where
    P: Vector3,
    P::Scalar: Real,
{
    /// Whether the ray may meet the box: never false where the exact ray meets it, so that nothing in the box is lost.
    ///
    /// Where a coordinate of the direction is 0 and the origin lies in a plane of the slab, the product is 0 · ∞ = NaN. Every comparison with NaN is false, so that it
    /// leaves the interval as it is: the ray runs in the slab's surface, and is in it.
    ///
    /// # Accuracy
    ///
    /// Each parameter is a difference, a reciprocal and a product: within 3u of its size. The exit is widened by `8u |exit|`: six roundings of entry and exit, one of the
    /// sum, one for all terms in u² (tested as `no_box_is_missed`). So a ray that passes by within `8u |t|` may be said to meet the box.
    ///
    /// # Edge cases
    ///
    /// A coordinate of the direction so near to 0 that its reciprocal overflows leaves its slab out: the ray may be said to meet a box that it passes by along that axis.
    ///
    /// # Source
    ///
    /// Williams et al. 2005, section 2; Ize 2013.
    #[inline]
    // ANCHOR: may_be_hit_by
    pub fn may_be_hit_by(&self, ray: &SlabRay<P>) -> bool {
        let [mut entry, mut exit] = [ray.start, ray.end];
        for axis in 0..P::DIMENSION {
            let o = ray.origin.coordinate(axis);
            let reciprocal = ray.reciprocal.coordinate(axis);
            let to_min = (self.min.coordinate(axis) - o) * reciprocal;
            let to_max = (self.max.coordinate(axis) - o) * reciprocal;
            let is_backward = reciprocal < P::Scalar::zero();
            let [near, far] = if is_backward {
                [to_max, to_min]
            } else {
                [to_min, to_max]
            };
            entry = larger_ignoring_nan(entry, near);
            exit = smaller_ignoring_nan(exit, far);
        }
        let widening = P::Scalar::from_i32(8) * P::Scalar::unit_roundoff() * exit.magnitude();
        entry <= exit + widening
    }
    // ANCHOR_END: may_be_hit_by
}
