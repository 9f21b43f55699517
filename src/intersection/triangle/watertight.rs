//! Woop, Benthin and Wald's watertight test: shear the world until the ray is the z axis, then ask three edges for a sign.

use num_traits::{One, Zero};

use super::facet_hit;
use crate::algebra::{Scalar, Vector3};
use crate::intersection::{FacetHit, Side};
use crate::ray::Ray;

/// The hit by Woop, Benthin and Wald's test: no ray slips between two triangles that share an edge, or through a corner that they share.
///
/// For many triangles and one ray, keep a [`ShearedRay`].
///
/// # Accuracy
///
/// Which triangle is hit is decided in the sheared plane, where a corner is rounded, but alike for every triangle that has it. Away from
/// edges it agrees with exact arithmetic; next to one, it may choose the neighbour. t is a mean of the corners' depths.
///
/// # Edge cases
///
/// On an edge both neighbours are hit, at a corner all. `None` for a triangle that the ray sees edge on, also when it lies in its plane.
/// Coordinates beyond about 1e±150 in `f64` and 1e±18 in `f32` overflow or underflow: [`prescaled`](super::prescaled) cures that.
///
/// # Source
///
/// Woop, Benthin, Wald 2013, appendix A.
#[inline]
pub fn watertight<P: Vector3>(corners: &[P; 3], ray: &Ray<P>) -> Option<FacetHit<P::Scalar>> {
    ShearedRay::new(ray).intersect(corners)
}

/// A ray with what Woop, Benthin and Wald's test needs of it: the axis that it runs along most, and the shear that turns it into that axis.
#[derive(Clone, Copy, Debug)]
pub struct ShearedRay<P: Vector3> {
    ray: Ray<P>,
    /// x, y and z of the sheared space; x and y exchanged where the ray runs against z, which keeps the winding.
    axes: [usize; 3],
    /// `d_x / d_z`, `d_y / d_z` and `1 / d_z`.
    shear: [P::Scalar; 3],
}

impl<P: Vector3> ShearedRay<P> {
    /// Chooses the axis and computes the shear.
    #[inline]
    // ANCHOR: shear
    pub fn new(ray: &Ray<P>) -> Self {
        let d = |axis: usize| ray.direction.coordinate(axis);
        let z = ray.direction.largest_axis();
        let [mut x, mut y] = [(z + 1) % 3, (z + 2) % 3];
        if d(z) < P::Scalar::zero() {
            (x, y) = (y, x);
        }
        Self {
            ray: *ray,
            axes: [x, y, z],
            shear: [d(x) / d(z), d(y) / d(z), P::Scalar::one() / d(z)],
        }
    }

    /// A point in the sheared space, where the ray is the z axis: its distance from the ray in x and y, its depth along it in z.
    #[inline]
    pub fn sheared(&self, point: P) -> [P::Scalar; 3] {
        self.sheared_vector(point.minus(self.ray.origin))
    }

    /// The same of a difference of two points.
    #[inline]
    pub(in crate::intersection) fn sheared_vector(&self, vector: P) -> [P::Scalar; 3] {
        let [x, y, z] = self.axes.map(|axis| vector.coordinate(axis));
        let [along_x, along_y, along_z] = self.shear;
        [x - along_x * z, y - along_y * z, along_z * z]
    }
    // ANCHOR_END: shear

    /// The vector m with `m · p = x q_y − y q_x` for every p whose sheared coordinates are q: perpendicular to the ray up to a roundoff of its own
    /// length, however short it is.
    #[inline]
    pub(in crate::intersection) fn moment(&self, [x, y]: [P::Scalar; 2]) -> P {
        let mut moment = [P::Scalar::zero(); 3];
        moment[self.axes[0]] = -y;
        moment[self.axes[1]] = x;
        moment[self.axes[2]] = y * self.shear[0] - x * self.shear[1];
        P::from_coordinates(moment)
    }

    /// The hit with a triangle, as [`watertight`] gives it.
    #[inline]
    // ANCHOR: watertight
    pub fn intersect(&self, corners: &[P; 3]) -> Option<FacetHit<P::Scalar>> {
        let [a, b, c] = corners.map(|corner| self.sheared(corner));
        let [u, v, w] = [edge(c, b), edge(a, c), edge(b, a)];
        let zero = P::Scalar::zero();
        let is_front = u >= zero && v >= zero && w >= zero;
        let is_back = u <= zero && v <= zero && w <= zero;
        if !(is_front || is_back) {
            return None;
        }
        let determinant = u + v + w;
        if determinant.is_zero() {
            return None;
        }
        let t = (u * a[2] + v * b[2] + w * c[2]) / determinant;
        let parameters = [v / determinant, w / determinant];
        facet_hit(&self.ray, t, parameters, Side::of(-determinant))
    }
    // ANCHOR_END: watertight
}

/// The side of the edge from q to p that the ray passes on, `p_x q_y − p_y q_x`: twice the area that the edge spans with the ray.
///
/// Rounding is monotone: where the two rounded products differ, their order is that of the exact ones, and the sign is right. Where they are
/// equal, the exact products differ by the difference of the rounding errors, which are floating-point numbers themselves (unless a
/// product is denormal), so that its sign is right as well. What is still zero counts as inside for both neighbours.
#[inline]
// ANCHOR: edge
fn edge<S: Scalar>(p: [S; 3], q: [S; 3]) -> S {
    let difference = p[0] * q[1] - p[1] * q[0];
    if difference.is_zero() {
        product_error(p[0], q[1]) - product_error(p[1], q[0])
    } else {
        difference
    }
}
// ANCHOR_END: edge

/// The rounding error of the product: `a b` less its rounded value, exactly (Dekker 1971).
fn product_error<S: Scalar>(a: S, b: S) -> S {
    let product = a * b;
    let [[a_high, a_low], [b_high, b_low]] = [a, b].map(halves);
    a_low * b_low - (((product - a_high * b_high) - a_low * b_high) - a_high * b_low)
}

/// The number as a sum of two with half the digits each, whose products are exact (Veltkamp 1968).
fn halves<S: Scalar>(number: S) -> [S; 2] {
    let spread = (splitter::<S>() + S::one()) * number;
    let high = spread - (spread - number);
    [high, number - high]
}

/// The least power of two whose square times the unit roundoff is not below 1: 2²⁷ for `f64`, 2¹² for `f32`; 1 where nothing is rounded.
fn splitter<S: Scalar>() -> S {
    let unit = S::unit_roundoff();
    let mut power = S::one();
    while !unit.is_zero() && power * power * unit < S::one() {
        power = power + power;
    }
    power
}
