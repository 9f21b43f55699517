//! A solution of exercise 2: the same roots without the loss of digits.

use crate::algebra::{Real, Vector3};
use num_traits::Zero;

/// Both roots by projection, smaller first, or `None`.
pub fn roots_by_projection<P>(p: P, d: P, r: P::Scalar) -> Option<[P::Scalar; 2]>
where
    P: Vector3,
    P::Scalar: Real,
{
    let dd = d.dot(d);
    let b = p.dot(d);
    let across = p.minus(d.times(b / dd));
    let h = across.dot(across).sqrt();
    let discriminant = dd * (r - h) * (r + h);
    if discriminant < P::Scalar::zero() {
        return None;
    }
    let root = discriminant.sqrt();
    let distance = p.dot(p).sqrt();
    let c = (distance - r) * (distance + r);
    if b > P::Scalar::zero() {
        // q is negative: q / d.d is the smaller root.
        let q = -(b + root);
        Some([q / dd, c / q])
    } else {
        let q = root - b;
        if q.is_zero() {
            return Some([q, q]);
        }
        Some([c / q, q / dd])
    }
}
