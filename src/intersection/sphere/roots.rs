//! Where a line meets a sphere: the slides' quadratic, and a form of it that keeps its digits.

use num_traits::{One, Zero};

use crate::algebra::{Real, Scalar, Vector3};
use crate::ray::Ray;

/// The two parameters at which the line `p + t d` meets the sphere of radius r around the origin, by the slides' formula; `None` where it
/// passes by. A tangent line has both the same.
///
/// # Accuracy
///
/// None that could be promised: far from the sphere, and near tangency, the discriminant is a small difference of large numbers (hard cases
/// `far_sphere`, `ray_that_misses_by_an_ulp`, `grazing_ray`). [`roots_by_projection`] survives.
///
/// # Source
///
/// Slides 94 and 95, for any radius.
#[inline]
// ANCHOR: roots_by_quadratic
pub fn roots_by_quadratic<P>(p: P, d: P, r: P::Scalar) -> Option<[P::Scalar; 2]>
where
    P: Vector3,
    P::Scalar: Real,
{
    let [dd, dp, pp] = [d.dot(d), d.dot(p), p.dot(p)];
    let discriminant = dp * dp - dd * (pp - r * r);
    if discriminant >= P::Scalar::zero() {
        let root = discriminant.sqrt();
        Some([(-dp - root) / dd, (-dp + root) / dd])
    } else {
        None
    }
}
// ANCHOR_END: roots_by_quadratic

/// The same two parameters, smaller first, from the distance between line and centre.
///
/// # Accuracy
///
/// As [`Sphere::intersect`](super::Sphere) states, for p and d as they are: both of a size whose squares neither overflow nor underflow.
///
/// # Cost
///
/// Three square roots and three divisions; one square root and two divisions where the line passes by.
///
/// # Source
///
/// Haines, Günther, Akenine-Möller 2019, section 7.2; the two ways to a root: Press et al. 2007, section 5.6.
#[inline]
pub fn roots_by_projection<P>(p: P, d: P, r: P::Scalar) -> Option<[P::Scalar; 2]>
where
    P: Vector3,
    P::Scalar: Real,
{
    Some(Crossing::of(p, d, r)?.roots())
}

/// The first of two roots, the smaller one given first, in the ray's interval of t: from outside the near one, from inside the far one; `None`
/// where the sphere lies behind, or beyond the end.
///
/// # Source
///
/// Slide 95: the nearest of the solutions with t > 0.
#[inline]
// ANCHOR: first_root
pub fn first_root<P: Vector3>(roots: [P::Scalar; 2], ray: &Ray<P>) -> Option<P::Scalar> {
    roots.into_iter().find(|&t| ray.reaches(t))
}
// ANCHOR_END: first_root

/// A line that meets a sphere, with what the error of its parameters depends on.
pub(super) struct Crossing<P: Vector3> {
    d: P,
    /// From the centre to the nearest point of the line, p⊥.
    across: P,
    dd: P::Scalar,
    /// Half the linear coefficient, `p · d`, and half the difference of the roots times dd, `√D`.
    b: P::Scalar,
    root: P::Scalar,
    /// The distance |p|, and the constant term `(|p| − r) (|p| + r)`.
    distance: P::Scalar,
    c: P::Scalar,
    /// A length near the radius; measured in it the radius, |p⊥|, and `(r − |p⊥|) (r + |p⊥|)`.
    unit: P::Scalar,
    radius: P::Scalar,
    passing: P::Scalar,
    gap: P::Scalar,
}

impl<P> Crossing<P>
where
    P: Vector3,
    P::Scalar: Real,
{
    /// The line `p + t d` and the sphere of radius r around the origin; `None` where they do not meet, and for NaN.
    #[inline]
    // ANCHOR: crossing
    pub(super) fn of(p: P, d: P, r: P::Scalar) -> Option<Self> {
        let [dd, b] = [d.dot(d), p.dot(d)];
        let across = p.minus(d.times(b / dd));
        // Measured in this unit, the radius is between 1 and 2: a square that underflows is too small to matter.
        let unit = r.power_of_two();
        let [radius, passing] = [r / unit, norm(across.times(P::Scalar::one() / unit))];
        let gap = (radius - passing) * (radius + passing);
        (gap >= P::Scalar::zero()).then(|| {
            let distance = norm(p);
            Self {
                d,
                across,
                dd,
                b,
                root: (dd * gap).sqrt() * unit,
                distance,
                c: (distance - r) * (distance + r),
                unit,
                radius,
                passing,
                gap,
            }
        })
    }
    // ANCHOR_END: crossing

    /// The sum of b and the root that does not cancel, with its sign turned.
    #[inline]
    fn q(&self) -> P::Scalar {
        if self.b > P::Scalar::zero() {
            -(self.b + self.root)
        } else {
            self.root - self.b
        }
    }

    /// The root `q / d·d` of the larger size, and the other, `c / q`.
    #[inline]
    // ANCHOR: stable_roots
    fn larger_and_smaller(&self) -> [P::Scalar; 2] {
        let q = self.q();
        if q.is_zero() {
            // The line touches the sphere, and does so where t = 0.
            return [q, q];
        }
        [q / self.dd, self.c / q]
    }
    // ANCHOR_END: stable_roots

    /// Both roots, the smaller number first.
    #[inline]
    pub(super) fn roots(&self) -> [P::Scalar; 2] {
        let [larger, smaller] = self.larger_and_smaller();
        if larger < smaller {
            [larger, smaller]
        } else {
            [smaller, larger]
        }
    }

    /// From the centre to the point on the sphere where the line enters (0) or leaves (1) it; its length is r up to rounding.
    #[inline]
    pub(super) fn arm(&self, which: usize) -> P {
        let half_chord = self.d.times(self.root / self.dd);
        if which == 0 {
            self.across.minus(half_chord)
        } else {
            self.across.plus(half_chord)
        }
    }

    /// Bounds on the errors of both roots, in the same order, where the line truly meets the sphere.
    ///
    /// The derivation stands with the test `sphere_error_stays_below_its_bound`.
    #[inline]
    // ANCHOR: root_errors
    pub(super) fn errors(&self) -> [P::Scalar; 2] {
        let u = P::Scalar::unit_roundoff();
        let times = P::Scalar::from_i32;
        let [larger, smaller] = self.larger_and_smaller();
        let speed = self.dd.sqrt();
        let middle = times(8) * u * self.distance / speed;
        let half = self.gap_error() * self.unit / speed + times(4) * u * self.root / self.dd;
        let of_larger = middle + half + times(2) * u * larger.magnitude();
        let q = self.q().magnitude();
        if q.is_zero() {
            return [of_larger; 2];
        }
        let of_c = times(8) * u * self.distance * self.distance + times(4) * u * self.c.magnitude();
        let of_q = of_larger * (smaller / larger).magnitude();
        let of_smaller = of_c / q + of_q + times(2) * u * smaller.magnitude();
        if larger < smaller {
            [of_larger, of_smaller]
        } else {
            [of_smaller, of_larger]
        }
    }
    // ANCHOR_END: root_errors

    /// A bound on the error of `√((r − |p⊥|) (r + |p⊥|))`, in units near the radius.
    #[inline]
    fn gap_error(&self) -> P::Scalar {
        let u = P::Scalar::unit_roundoff();
        let times = P::Scalar::from_i32;
        let of_passing = (times(9) * self.distance / self.unit + times(4) * self.passing) * u;
        let of_gap = of_passing * (times(2) * self.passing + of_passing) + times(3) * u * self.gap;
        // |√a − √b| is at most |a − b| / √a, and √|a − b|; and no half chord is longer than the radius.
        let by_slope = of_gap / self.gap.sqrt();
        let near_tangency = of_gap.sqrt();
        let least = if by_slope < near_tangency {
            by_slope
        } else {
            near_tangency
        };
        if least < self.radius {
            least
        } else {
            self.radius
        }
    }
}

/// The length of a vector whose squares neither overflow nor underflow.
#[inline]
fn norm<P>(vector: P) -> P::Scalar
where
    P: Vector3,
    P::Scalar: Real,
{
    vector.dot(vector).sqrt()
}
