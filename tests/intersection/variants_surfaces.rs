//! Methods that are kept for comparison only: the naive ones, and those of others.

use facette::algebra::{Real, Vector3, VectorSpace};
use facette::bspline::BsplineSurface;
use facette::intersection::Hit;
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

/// The point `o + t d`, whose error grows with t.
pub fn by_parameter<S: Real>(ray: &Ray<[S; 3]>, hit: &Hit<[S; 3]>) -> [S; 3] {
    ray.point(hit.t)
}

/// As ray tracers begin: from `o + t d`, and hits count from t > ε on.
pub fn by_epsilon<S: Real>(
    arriving: &Ray<[S; 3]>,
    hit: &Hit<[S; 3]>,
    direction: [S; 3],
    epsilon: f64,
) -> Ray<[S; 3]> {
    Ray::new(by_parameter(arriving, hit), direction).after(S::from_f64(epsilon))
}

/// The offset of Wächter and Binder 2019 (*Ray Tracing Gems*, chapter 6): up to 256 units in the last place along the normal, or 2⁻¹⁶ for a coordinate below 2⁻⁵.
pub fn by_integer_offset<S: Real>(hit: &Hit<[S; 3]>, direction: [S; 3]) -> Ray<[S; 3]> {
    let [n, d] = [hit.normal, direction].map(|v| v.map(|x| single(x.to_f64())));
    let sign = if n[0] * d[0] + n[1] * d[1] + n[2] * d[2] < 0.0 {
        -1.0
    } else {
        1.0
    };
    let origin = [0, 1, 2].map(|axis| {
        let (p, n) = (single(hit.point[axis].to_f64()), sign * n[axis]);
        if p.abs() < 1.0 / 32.0 {
            return S::from_f64((p + n / 65536.0).into());
        }
        #[allow(
            clippy::cast_possible_truncation,
            reason = "at most 256 in absolute value"
        )]
        let steps = (256.0 * n) as i32;
        let steps = if p < 0.0 { -steps } else { steps };
        S::from_f64(f32::from_bits(p.to_bits().wrapping_add_signed(steps)).into())
    });
    Ray::new(origin, direction)
}

fn single(x: f64) -> f32 {
    <f32 as Real>::from_f64(x)
}
