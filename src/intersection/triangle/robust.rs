//! A test that decides by exact signs: floating point where its error bound suffices, a long accumulator where it does not.

use std::cmp::Ordering;

use super::accumulator::{LongAccumulator, Scaled};
use super::facet_hit;
use crate::algebra::{Real, Vector3};
use crate::intersection::{FacetHit, Side};
use crate::ray::Ray;

/// Half the digits of `f64`: where the bound on t's relative error is larger, everything is computed exactly.
const HALF_OF_THE_DIGITS: f64 = 1.0 / (1_u64 << 26) as f64;

/// A millionth: where the bound on the error of a barycentric coordinate is larger, everything is computed exactly. Coarser than for t, since
/// a facet of size h seen from the distance L has coordinates good to about `32 u L / h` only, and one at L = 10⁷ h shall stay fast.
const A_MILLIONTH: f64 = 1.0 / (1_u64 << 20) as f64;

/// The unit roundoff u of `f64`.
const UNIT: f64 = f64::EPSILON / 2.0;

/// The hit that exact arithmetic finds, for every triangle and every ray of finite numbers.
///
/// Whether the line meets the triangle, and on which side, is decided by the signs of determinants without any
/// error. An edge belongs to both of its triangles: no ray slips through. Whether t lies in the ray's interval is asked of t as it is returned, rounded to its type.
///
/// # Accuracy
///
/// t has a relative error of at most 2⁻²⁶, usually a few unit roundoffs, and comes with its own bound in
/// [`Triangle`](super::Triangle). A parameter has an error of at most 2⁻¹⁸. Over `f32` the computation runs in `f64`, and rounds at the end.
///
/// # Cost
///
/// As [`moller_trumbore`](super::moller_trumbore) twice where the signs are clear. Within rounding of an edge or of the plane, a few
/// microseconds.
///
/// # Edge cases
///
/// `None` for a triangle without area, and for a ray parallel to its plane, also in it. Nothing overflows: all finite numbers will do.
///
/// # Source
///
/// The filter: Shewchuk 1997, section 4; the determinants in Plücker's form: Davidovič, Engelhardt, Georgiev, Slusallek, Dachsbacher 2012; the accumulator: Kulisch 2013.
pub fn robust<P>(corners: &[P; 3], ray: &Ray<P>) -> Option<FacetHit<P::Scalar>>
where
    P: Vector3<Scalar: Real>,
{
    let answer = decide(
        corners.map(P::in_double_precision),
        ray.origin.in_double_precision(),
        ray.direction.in_double_precision(),
    )?;
    let [t, v, w] = [answer.t, answer.parameters[0], answer.parameters[1]].map(P::Scalar::from_f64);
    facet_hit(ray, t, [v, w], answer.side)
}

/// Where the line of a ray meets a triangle, at any t.
#[derive(Clone, Copy, Debug)]
pub(super) struct Crossing {
    pub t: f64,
    /// A bound on the error of t.
    pub t_error: f64,
    /// The weights of b and c: not negative, with a sum that exceeds 1 by rounding at most, and errors below 2⁻¹⁸.
    pub parameters: [f64; 2],
    pub side: Side,
}

/// The crossing of the line `o + t d` with the triangle; `None` where it misses, is parallel, or something is not finite.
// ANCHOR: decide
pub(super) fn decide(corners: [[f64; 3]; 3], o: [f64; 3], d: [f64; 3]) -> Option<Crossing> {
    match quickly(corners, o, d) {
        Answer::Sure(crossing) => crossing,
        Answer::Unsure => exactly(corners, o, d),
    }
}
// ANCHOR_END: decide

/// What floating point can say: a certain answer, or that it cannot tell.
enum Answer {
    Sure(Option<Crossing>),
    Unsure,
}

/// A computed number and a bound on its error.
#[derive(Clone, Copy)]
struct Bounded {
    value: f64,
    error: f64,
}

impl Bounded {
    /// The sign, where the error leaves no doubt.
    fn sign(self) -> Option<bool> {
        // False for NaN as well.
        (self.value.abs() > self.error).then_some(self.value > 0.0)
    }

    /// Whether the error is at most that part of `whole`; false where either is infinite or NaN, since infinity is not above infinity.
    fn is_within(self, part: f64, whole: f64) -> bool {
        whole.is_finite() && self.error <= whole.abs() * part
    }
}

/// The signed volumes in floating point, with their error bounds.
// ANCHOR: quickly
fn quickly([a, b, c]: [[f64; 3]; 3], o: [f64; 3], d: [f64; 3]) -> Answer {
    let relative = [a, b, c].map(|corner| minus(corner, o));
    let [u, v, w] = [[1, 2], [2, 0], [0, 1]].map(|[from, to]| {
        let edge = minus([a, b, c][from], [a, b, c][to]);
        volume(d, edge, relative[from], relative[to])
    });
    let (Some(u_sign), Some(v_sign), Some(w_sign)) = (u.sign(), v.sign(), w.sign()) else {
        return Answer::Unsure;
    };
    if u_sign != v_sign || v_sign != w_sign {
        return Answer::Sure(None);
    }
    let edges = [minus(b, a), minus(c, a)];
    let [along, height] =
        [d, relative[0]].map(|vector| triple(vector, edges[0], edges[1], sizes(edges[1])));
    let sum = u.value + v.value + w.value;
    let weights_are_good = [u, v, w]
        .iter()
        .all(|volume| volume.is_within(A_MILLIONTH, sum));
    let t_is_good = [along, height]
        .iter()
        .all(|volume| volume.is_within(HALF_OF_THE_DIGITS / 4.0, volume.value));
    if !(weights_are_good && t_is_good) {
        return Answer::Unsure;
    }
    let t = height.value / along.value;
    // (T + δ) / (D + ε): the relative errors added, a little for their products, and the roundings of the division and of this line.
    let relative_error = height.error / height.value.abs() + along.error / along.value.abs();
    let crossing = Crossing {
        t,
        t_error: t.abs() * (relative_error * (1.0 + 4.0 * HALF_OF_THE_DIGITS) + 2.0 * UNIT),
        parameters: [v.value / sum, w.value / sum],
        side: Side::of(along.value),
    };
    Answer::Sure(Some(crossing))
}
// ANCHOR_END: quickly

/// Twice the signed volume that the direction spans with the edge: `d · ((p − q) × (P + Q))`, where P and Q are p and q seen from the origin.
///
/// The sum P + Q and the difference p − q are the same for both neighbours of the edge, up to the sign. The product is twice `d · (P × Q)`,
/// since `(P − Q) × (P + Q) = 2 P × Q`, and the edge is short where the corners are far.
fn volume(d: [f64; 3], edge: [f64; 3], from: [f64; 3], to: [f64; 3]) -> Bounded {
    let sum = [0, 1, 2].map(|axis| from[axis] + to[axis]);
    let size = [0, 1, 2].map(|axis| from[axis].abs() + to[axis].abs());
    triple(d, edge, sum, size)
}

/// The product `x · (y × z)` of three rounded vectors with a bound on the error, where `size` bounds the terms of which z is the sum.
///
/// In [`volume`] each product of three has at most 8 roundings: one in the edge, two in the sum, the two products, the difference, two
/// sums. The heights have as many, the slopes fewer. So the error is at most γ₈ times the sum of the products' sizes, and 9u times
/// the computed sum. What underflows errs by 2⁻¹⁰⁷⁵ a product: less than the smallest normal number, times 1 or a coordinate of x.
// ANCHOR: triple
fn triple(x: [f64; 3], y: [f64; 3], z: [f64; 3], size: [f64; 3]) -> Bounded {
    let (mut value, mut total) = (0.0, 0.0);
    for (i, j, k) in [(0, 1, 2), (1, 2, 0), (2, 0, 1)] {
        value += x[i] * (y[j] * z[k] - y[k] * z[j]);
        total += x[i].abs() * (y[j].abs() * size[k] + y[k].abs() * size[j]);
    }
    let underflow = f64::MIN_POSITIVE * (1.0 + x[0].abs() + x[1].abs() + x[2].abs());
    Bounded {
        value,
        error: 9.0 * UNIT * total + underflow,
    }
}
// ANCHOR_END: triple

fn minus(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn sizes(vector: [f64; 3]) -> [f64; 3] {
    vector.map(f64::abs)
}

/// The same without any error: every determinant is a sum of products of three given numbers.
// ANCHOR: exactly
fn exactly([a, b, c]: [[f64; 3]; 3], o: [f64; 3], d: [f64; 3]) -> Option<Crossing> {
    if ![a, b, c, o, d]
        .iter()
        .flatten()
        .all(|number| number.is_finite())
    {
        return None;
    }
    // d · ((p − o) × (q − o)) = d · (p × q + q × o + o × p)
    let volume = |p: [f64; 3], q: [f64; 3]| {
        let mut sum = LongAccumulator::new();
        for (y, z) in [(p, q), (q, o), (o, p)] {
            sum.add_determinant(1.0, d, y, z);
        }
        sum
    };
    let [u, v, w] = [volume(b, c), volume(c, a), volume(a, b)];
    let signs = [u.sign(), v.sign(), w.sign()];
    if signs.contains(&Ordering::Greater) && signs.contains(&Ordering::Less) {
        return None;
    }
    let mut along = u;
    along += &v;
    along += &w;
    if along.sign() == Ordering::Equal {
        return None;
    }
    // (a − o) · n = a · (b × c) − o · (a × b + b × c + c × a)
    let mut height = LongAccumulator::new();
    height.add_determinant(1.0, a, b, c);
    for (y, z) in [(a, b), (b, c), (c, a)] {
        height.add_determinant(-1.0, o, y, z);
    }
    let side = if along.sign() == Ordering::Less {
        Side::Front
    } else {
        Side::Back
    };
    let along = along.rounded();
    let t = height.rounded().over(along);
    Some(Crossing {
        t,
        t_error: t.abs() * (4.0 * UNIT),
        parameters: [v, w].map(|volume| volume.rounded().over(along)),
        side,
    })
}
// ANCHOR_END: exactly

/// The normal `(b − a) × (c − a)`, which is not zero, over a power of two: every coordinate within 2⁻²⁴ of the largest one.
pub(super) fn normal([a, b, c]: [[f64; 3]; 3]) -> [f64; 3] {
    let [e, f] = [minus(b, a), minus(c, a)];
    let parts = [(1, 2), (2, 0), (0, 1)].map(|(j, k)| {
        let (first, second) = (e[j] * f[k], e[k] * f[j]);
        // Two roundings in the edges, one in the product, one in the difference, and one in hand; underflow as in `triple`.
        let error = 5.0 * UNIT * (first.abs() + second.abs()) + f64::MIN_POSITIVE;
        Bounded {
            value: first - second,
            error,
        }
    });
    let largest = parts
        .iter()
        .fold(0.0, |largest: f64, part| largest.max(part.value.abs()));
    if largest.is_finite()
        && parts
            .iter()
            .all(|part| part.is_within(HALF_OF_THE_DIGITS, largest))
    {
        return parts.map(|part| part.value);
    }
    exact_normal([a, b, c])
}

/// The normal, every coordinate rounded once, over the power of two of the largest.
fn exact_normal(corners: [[f64; 3]; 3]) -> [f64; 3] {
    let [a, b, c] = corners;
    let parts = [(1, 2), (2, 0), (0, 1)].map(|(j, k)| {
        let mut sum = LongAccumulator::new();
        for (p, q) in [(a, b), (b, c), (c, a)] {
            sum.add_product(1.0, p[j], q[k]);
            sum.add_product(-1.0, p[k], q[j]);
        }
        sum.rounded()
    });
    let largest = parts
        .map(Scaled::magnitude)
        .into_iter()
        .fold(i32::MIN, i32::max);
    parts.map(|part| part.relative_to(largest))
}
