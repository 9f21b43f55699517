//! A solution of exercise 1: the frame of a camera.

use crate::algebra::{Real, Vector3, unit_vector};

/// The axes `[u, v, w]` of a camera at the point `eye` that looks at the point `target`.
pub fn look_at_axes<P>(eye: P, target: P, up: P) -> Option<[P; 3]>
where
    P: Vector3,
    P::Scalar: Real,
{
    let w = unit_vector(eye.minus(target))?;
    let u = unit_vector(unit_vector(up)?.cross(w))?;
    let v = w.cross(u);
    Some([u, v, w])
}
