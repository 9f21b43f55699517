//! Where rays meet patches, to many digits: by Newton's method in arbitrary precision, and by a quadratic equation.

use facette::ray::Ray;
use num_bigint::BigInt;
use num_traits::{Signed, ToPrimitive, Zero};

use crate::common::oracle::{Big, big, big_bernstein, big_cross, big_dot, big_minus, big_sqrt};
use crate::patch_inputs::big_patch_point;

/// A root in arbitrary precision.
pub struct ExactRoot {
    pub t: Big,
}

/// So many binary digits after the point are kept.
const DIGITS: usize = 160;

fn rounded(x: &Big) -> Big {
    let scale = BigInt::from(1) << DIGITS;
    let scaled = (x * Big::from_integer(scale.clone())).round();
    scaled / Big::from_integer(scale)
}

/// The patch's partial derivative, from the differences of its control points.
fn partial(degrees: [usize; 2], points: &[[f64; 3]], [u, v]: [&Big; 2], along_u: bool) -> [Big; 3] {
    let [p, q] = degrees;
    let lower = if along_u { [p - 1, q] } else { [p, q - 1] };
    let step = if along_u { 1 } else { p + 1 };
    let degree = if along_u { p } else { q };
    let [in_u, in_v] = [big_bernstein(lower[0], u), big_bernstein(lower[1], v)];
    let mut sum = [const { None }; 3].map(|none: Option<Big>| none.unwrap_or_else(Big::zero));
    for (j, b) in in_v.iter().enumerate() {
        for (i, a) in in_u.iter().enumerate() {
            let at = j * (p + 1) + i;
            for axis in 0..3 {
                let difference = big(points[at + step][axis]) - big(points[at][axis]);
                sum[axis] += a * b * difference * Big::from_integer(degree.into());
            }
        }
    }
    sum
}

/// The root that Newton's method on `S(u, v) − o − t d = 0` converges to from these parameters: four steps double the digits from 7 to 100 and over.
///
/// # Panics
///
/// Where it does not converge: the start is no root up to rounding.
pub fn refined_root(
    degrees: [usize; 2],
    points: &[[f64; 3]],
    ray: &Ray<[f64; 3]>,
    start: [f64; 2],
) -> ExactRoot {
    let [origin, d] = [ray.origin, ray.direction].map(|p| p.map(big));
    let [mut u, mut v] = start.map(big);
    let mut t = Big::zero();
    for _ in 0..5 {
        let s = big_patch_point(degrees, points, [&u, &v]);
        let [s_u, s_v] = [true, false].map(|along_u| partial(degrees, points, [&u, &v], along_u));
        // S + a S_u + b S_v = o + t d, by Cramer's rule with d · (S_u × S_v).
        let r = big_minus(&origin, &s);
        let n = big_cross(&s_u, &s_v);
        let determinant = big_dot(&d, &n);
        let steps = [
            big_dot(&d, &big_cross(&r, &s_v)),
            big_dot(&d, &big_cross(&s_u, &r)),
        ];
        t = rounded(&(-big_dot(&r, &n) / &determinant));
        u = rounded(&(u + &steps[0] / &determinant));
        v = rounded(&(v + &steps[1] / &determinant));
    }
    let s = big_patch_point(degrees, points, [&u, &v]);
    let left = (0..3).map(|i| (&s[i] - &origin[i] - &t * &d[i]).abs());
    let left = left.fold(Big::zero(), |a, b| if b > a { b } else { a });
    let size = big_dot(&d, &d).to_f64().expect("finite").sqrt();
    assert!(
        left.to_f64().expect("finite") <= 1e-40 * (1.0 + size),
        "Newton's method does not converge from {start:?}"
    );
    ExactRoot { t }
}

/// The parameters t > 0 at which the ray meets the bilinear patch with corners `S(0,0), S(1,0), S(0,1), S(1,1)`, in order. `None` where a root is too near
/// to a side, to the other root, or to the ray's start, for floating point to be asked; or where the equation degenerates.
pub fn bilinear_roots(corners: &[[f64; 3]], ray: &Ray<[f64; 3]>) -> Option<Vec<f64>> {
    let margin = big(1e-9);
    let [a, b, c, e] = [0, 1, 2, 3].map(|i| corners[i].map(big));
    let [origin, d] = [ray.origin, ray.direction].map(|p| p.map(big));
    // S(u, v) − o = k0 + k1 u + k2 v + k3 u v; its product with two planes through the ray.
    let twist = big_minus(&big_minus(&e, &b), &big_minus(&c, &a));
    let k = [
        big_minus(&a, &origin),
        big_minus(&b, &a),
        big_minus(&c, &a),
        twist,
    ];
    let axis = (0..3).max_by(|&i, &j| d[i].abs().cmp(&d[j].abs()))?;
    let planes = [1, 2].map(|step| {
        let other = (axis + step) % 3;
        k.each_ref()
            .map(|k| &k[other] * &d[axis] - &k[axis] * &d[other])
    });
    let [f, g] = planes;
    // v = −(f0 + f1 u)/(f2 + f3 u) in the second equation.
    let c0 = &g[0] * &f[2] - &f[0] * &g[2];
    let c1 = &g[0] * &f[3] + &g[1] * &f[2] - &f[1] * &g[2] - &f[0] * &g[3];
    let c2 = &g[1] * &f[3] - &f[1] * &g[3];
    if c2.is_zero() {
        return None;
    }
    let four = Big::from_integer(4.into());
    let discriminant = &c1 * &c1 - four * &c2 * &c0;
    if discriminant.abs() <= &margin * (&c1 * &c1 + (&c2 * &c0).abs()) {
        return None;
    }
    if discriminant.is_negative() {
        return Some(Vec::new());
    }
    let root = big_sqrt(&discriminant);
    let [zero, one, two] = [0, 1, 2].map(|n| Big::from_integer(n.into()));
    let mut found = Vec::new();
    for sign in [-1, 1] {
        let u = (Big::from_integer(sign.into()) * &root - &c1) / (&two * &c2);
        let mut below = &f[2] + &f[3] * &u;
        let mut above = &f[0] + &f[1] * &u;
        if below.abs() < (&g[2] + &g[3] * &u).abs() {
            below = &g[2] + &g[3] * &u;
            above = &g[0] + &g[1] * &u;
        }
        if below.is_zero() {
            return None;
        }
        let v = -above / below;
        let is_near = |x: &Big| x.abs() < margin || (x - &one).abs() < margin;
        if is_near(&u) || is_near(&v) {
            return None;
        }
        let is_inside = |x: &Big| *x > zero && *x < one;
        if !(is_inside(&u) && is_inside(&v)) {
            continue;
        }
        let depth = &k[0][axis] + &k[1][axis] * &u + &k[2][axis] * &v + &k[3][axis] * &u * &v;
        let t = depth / &d[axis];
        if t.abs() < margin {
            return None;
        }
        if t > zero {
            found.push(t.to_f64()?);
        }
    }
    found.sort_by(f64::total_cmp);
    Some(found)
}
