//! Methods that are kept for comparison only: the naive ones, and those of others.

use facette::algebra::{Vector3, VectorSpace};
use facette::bspline::BsplineSurface;
use facette::ray::Ray;
use facette::surface::Surface;

/// The t that Newton's method on `S(u, v) = o + t d` converges to from the middle of the domain, where it converges inside the domain to a t that the ray reaches.
pub fn newton_from_the_middle(
    surface: &BsplineSurface<[f64; 3]>,
    ray: &Ray<[f64; 3]>,
) -> Option<f64> {
    let [in_u, in_v] = surface.domain();
    let [mut u, mut v] = [in_u, in_v].map(|[start, end]| f64::midpoint(start, end));
    let d = ray.direction;
    let mut t = f64::NAN;
    for _ in 0..50 {
        let [s_u, s_v] = surface.partials(u, v)?;
        let r = ray.origin.minus(surface.point(u, v));
        let n = s_u.cross(s_v);
        let determinant = d.dot(n);
        t = -r.dot(n) / determinant;
        let steps = [
            d.dot(r.cross(s_v)) / determinant,
            d.dot(s_u.cross(r)) / determinant,
        ];
        u += steps[0];
        v += steps[1];
        if steps[0].abs().max(steps[1].abs()) <= 1e-14 {
            break;
        }
    }
    let is_in = |x: f64, [start, end]: [f64; 2]| x >= start && x <= end;
    (is_in(u, in_u) && is_in(v, in_v) && ray.reaches(t)).then_some(t)
}
