//! Other ways to compute the same points. The report of speed against error compares them with the library, and the hard cases
//! refute those that do not survive.
//!
//! | variant | survives cancellation | why it is here |
//! | --- | --- | --- |
//! | [`naive_curve_point`], [`naive_surface_point`] | no: absolute errors of a few u | the definition, baseline of the report |
//! | [`BezierPieces`], [`BezierPatches`] with de Casteljau's scheme | no: the same | what conversion saves |
//! | the same with [`bernstein_horner`] | no: the same | n multiplications of points instead of n(n + 1) |
//! | [`MonomialPieces`], [`MonomialPatches`] | no: errors that grow with the degree | the fewest operations |
//! | [`PowersOfU`] | no: it loses all digits far from 0 | the power basis as it is found in textbooks |
//! | [`compensated_de_boor_point`] | yes: an ulp or so, until the condition number reaches 1/u | what the cure costs |
#![allow(
    dead_code,
    reason = "tests and report each use their part of these variants"
)]

use facette::algebra::{Scalar, VectorSpace};
use facette::bspline::{BsplineSurface, Direction, KnotVector, cox_de_boor, find_span};
use num_traits::One;

/// The sum of control points with basis functions by the recursion that defines them.
pub fn naive_curve_point<P: VectorSpace>(
    knots: &KnotVector<P::Scalar>,
    control_points: &[P],
    u: P::Scalar,
) -> P {
    let span = find_span(knots, u);
    let degree = knots.degree();
    let terms = (span - degree..=span).map(|i| {
        let weight = cox_de_boor(knots, degree, i, u);
        control_points[i].times(weight)
    });
    terms.reduce(P::plus).unwrap_or_else(P::origin)
}

/// The same for a surface: a basis function of v for every control point that counts.
pub fn naive_surface_point<P: VectorSpace>(
    surface: &BsplineSurface<P>,
    u: P::Scalar,
    v: P::Scalar,
) -> P {
    let [in_u, in_v] = [Direction::U, Direction::V].map(|direction| surface.knots(direction));
    let [i, j] = [find_span(in_u, u), find_span(in_v, v)];
    let [p, q] = [in_u.degree(), in_v.degree()];
    let mut sum = P::origin();
    for k in i - p..=i {
        for l in j - q..=j {
            let weight = cox_de_boor(in_u, p, k, u) * cox_de_boor(in_v, q, l, v);
            sum = sum.plus(surface.control_point(k, l).times(weight));
        }
    }
    sum
}

/// The non-empty spans of a knot vector, to find the piece of a parameter and its place there.
#[derive(Clone, Debug)]
pub struct Breaks<S> {
    breaks: Vec<S>,
}

impl<S: Scalar> Breaks<S> {
    /// The breaks of these knots.
    pub fn new(knots: &KnotVector<S>) -> Self {
        let mut breaks: Vec<S> = knots.spans().map(|i| knots.span_interval(i)[0]).collect();
        breaks.push(knots.domain()[1]);
        Self { breaks }
    }

    /// How many pieces there are.
    pub fn pieces(&self) -> usize {
        self.breaks.len() - 1
    }

    /// The piece of `u`, and the place of `u` in it.
    pub fn locate(&self, u: S) -> (usize, S) {
        let inner = &self.breaks[1..self.pieces()];
        let piece = inner.partition_point(|&knot| knot <= u);
        let [start, end] = [self.breaks[piece], self.breaks[piece + 1]];
        (piece, (u - start) / (end - start))
    }
}

/// A curve as its Bézier pieces, each with the same number of control points.
pub struct BezierPieces<P: VectorSpace> {
    breaks: Breaks<P::Scalar>,
    points: Vec<P>,
}

impl<P: VectorSpace> BezierPieces<P> {
    /// The pieces of the curve with these control points.
    pub fn new(curve: &facette::bspline::BsplineCurve<P>) -> Self {
        let pieces = curve.bezier_pieces().into_iter();
        Self {
            breaks: Breaks::new(curve.knots()),
            points: pieces
                .flat_map(|piece| piece.curve.control_points().to_vec())
                .collect(),
        }
    }

    /// The point at `u` as `evaluate` computes it from the control points of a piece and the place there.
    pub fn point(&self, u: P::Scalar, evaluate: impl Fn(&[P], P::Scalar) -> P) -> P {
        let (piece, t) = self.breaks.locate(u);
        let order = self.points.len() / self.breaks.pieces();
        evaluate(&self.points[piece * order..][..order], t)
    }
}

/// A curve as the monomial coefficients of its pieces, each in its own place from 0 to 1.
pub struct MonomialPieces<P: VectorSpace>(BezierPieces<P>);

impl<P: VectorSpace> MonomialPieces<P> {
    /// The coefficients of the pieces of a curve.
    pub fn new(curve: &facette::bspline::BsplineCurve<P>) -> Self {
        let mut pieces = BezierPieces::new(curve);
        let order = curve.degree() + 1;
        for piece in pieces.points.chunks_exact_mut(order) {
            to_monomials(piece);
        }
        Self(pieces)
    }

    /// The point at `u`, by Horner's rule.
    pub fn point(&self, u: P::Scalar) -> P {
        self.0.point(u, horner)
    }
}

/// A curve as the coefficients of its pieces in the powers of its own parameter `u`: no place in a span needs to be computed, and for a span
/// far from 0 beside its length all digits are lost.
pub struct PowersOfU<P: VectorSpace>(BezierPieces<P>);

impl<P: VectorSpace> PowersOfU<P> {
    /// The coefficients of the pieces of a curve.
    pub fn new(curve: &facette::bspline::BsplineCurve<P>) -> Self {
        let MonomialPieces(mut pieces) = MonomialPieces::new(curve);
        let order = curve.degree() + 1;
        let intervals = pieces.breaks.breaks.windows(2);
        for (piece, interval) in pieces.points.chunks_exact_mut(order).zip(intervals) {
            let inverse = P::Scalar::one() / (interval[1] - interval[0]);
            let mut factor = P::Scalar::one();
            for coefficient in &mut *piece {
                *coefficient = coefficient.times(factor);
                factor = factor * inverse;
            }
            // From the powers of u − a to those of u: Horner's rule, once for each coefficient.
            for first in 0..order - 1 {
                for index in (first..order - 1).rev() {
                    piece[index] = piece[index].minus(piece[index + 1].times(interval[0]));
                }
            }
        }
        Self(pieces)
    }

    /// The point at `u`, by Horner's rule.
    pub fn point(&self, u: P::Scalar) -> P {
        self.0.point(u, |coefficients, _| horner(coefficients, u))
    }
}

/// A surface as its Bézier patches.
pub struct BezierPatches<P: VectorSpace> {
    breaks: [Breaks<P::Scalar>; 2],
    orders: [usize; 2],
    points: Vec<P>,
}

impl<P: VectorSpace> BezierPatches<P> {
    /// The patches of a surface.
    pub fn new(surface: &BsplineSurface<P>) -> Self {
        let knots = [Direction::U, Direction::V].map(|direction| surface.knots(direction));
        let patches = surface.bezier_patches().into_iter();
        Self {
            breaks: knots.map(Breaks::new),
            orders: knots.map(|knots| knots.degree() + 1),
            points: patches.flat_map(|patch| patch.control_points).collect(),
        }
    }

    /// The point at `(u, v)`: `evaluate` makes a point of every row, and one of these.
    pub fn point(&self, [u, v]: [P::Scalar; 2], evaluate: impl Fn(&[P], P::Scalar) -> P) -> P {
        let [(column, s), (row, t)] = [self.breaks[0].locate(u), self.breaks[1].locate(v)];
        let [order, rows] = self.orders;
        let patch = row * self.breaks[0].pieces() + column;
        let points = &self.points[patch * order * rows..][..order * rows];
        let mut on_stack = [P::origin(); 32];
        for (place, row) in on_stack.iter_mut().zip(points.chunks_exact(order)) {
            *place = evaluate(row, s);
        }
        evaluate(&on_stack[..rows], t)
    }
}

/// A surface as the monomial coefficients of its patches.
pub struct MonomialPatches<P: VectorSpace>(BezierPatches<P>);

impl<P: VectorSpace> MonomialPatches<P> {
    /// The coefficients of the patches of a surface.
    pub fn new(surface: &BsplineSurface<P>) -> Self {
        let mut patches = BezierPatches::new(surface);
        let [order, rows] = patches.orders;
        for patch in patches.points.chunks_exact_mut(order * rows) {
            patch.chunks_exact_mut(order).for_each(to_monomials);
            for i in 0..order {
                let mut column: Vec<P> = (0..rows).map(|j| patch[j * order + i]).collect();
                to_monomials(&mut column);
                for (j, coefficient) in column.into_iter().enumerate() {
                    patch[j * order + i] = coefficient;
                }
            }
        }
        Self(patches)
    }

    /// The point at `(u, v)`, by Horner's rule in both directions.
    pub fn point(&self, parameters: [P::Scalar; 2]) -> P {
        self.0.point(parameters, horner)
    }
}

/// Replaces Bézier points by coefficients in the powers of t: `binomial(n, i)` times the i-th difference at the first point.
pub fn to_monomials<P: VectorSpace>(points: &mut [P]) {
    let last = points.len() - 1;
    for order in 1..=last {
        for index in (order..=last).rev() {
            points[index] = points[index].minus(points[index - 1]);
        }
    }
    let mut binomial = P::Scalar::one();
    for (i, point) in points.iter_mut().enumerate() {
        *point = point.times(binomial);
        binomial = binomial * number::<P>(last - i) / number::<P>(i + 1);
    }
}

fn number<P: VectorSpace>(value: usize) -> P::Scalar {
    P::Scalar::from_i32(i32::try_from(value).expect("a small degree"))
}

/// The polynomial `c0 + t (c1 + t (c2 + ...))`.
pub fn horner<P: VectorSpace>(coefficients: &[P], t: P::Scalar) -> P {
    let terms = coefficients.iter().rev().copied();
    terms
        .reduce(|sum, coefficient| sum.times(t).plus(coefficient))
        .unwrap_or_else(P::origin)
}

/// De Casteljau's scheme.
pub fn de_casteljau<P: VectorSpace>(points: &[P], t: P::Scalar) -> P {
    if let &[b0, b1, b2, b3] = points {
        let [c0, c1, c2] = [b0.lerp(b1, t), b1.lerp(b2, t), b2.lerp(b3, t)];
        return c0.lerp(c1, t).lerp(c1.lerp(c2, t), t);
    }
    let mut on_stack = [P::origin(); 64];
    let left = &mut on_stack[..points.len()];
    left.copy_from_slice(points);
    for end in (1..left.len()).rev() {
        for index in 0..end {
            left[index] = left[index].lerp(left[index + 1], t);
        }
    }
    left[0]
}

/// Horner's rule on Bernstein's form, by Schumaker and Volk: a polynomial in `t / (1 − t)` times `(1 − t)ⁿ`; from the other end for
/// `t > 1/2`.
pub fn bernstein_horner<P: VectorSpace>(points: &[P], t: P::Scalar) -> P {
    let (s, n) = (P::Scalar::one() - t, points.len() - 1);
    if t > s {
        return nested(points.iter().rev(), n, [t, s]);
    }
    nested(points.iter(), n, [s, t])
}

/// `Σ binomial(n, i) large^(n − i) small^i pᵢ`, the smaller of the two weights over the larger as the variable.
fn nested<'a, P: VectorSpace>(
    points: impl DoubleEndedIterator<Item = &'a P>,
    n: usize,
    [large, small]: [P::Scalar; 2],
) -> P {
    let x = small / large;
    let mut points = points.rev();
    let Some(&last) = points.next() else {
        return P::origin();
    };
    let (mut sum, mut binomial, mut power) = (last, P::Scalar::one(), P::Scalar::one());
    for (i, point) in points.enumerate() {
        binomial = binomial * number::<P>(n - i) / number::<P>(i + 1);
        sum = sum.times(x).plus(point.times(binomial));
        power = power * large;
    }
    sum.times(power)
}

/// The point of a curve by de Boor's points, with the rounding errors of every operation computed exactly and carried along: as
/// if in twice the precision, then rounded once.
///
/// # Source
///
/// Jiang, Li, Cheng, Su 2010, for de Casteljau's scheme; the quotients of de Boor's carry their remainders too.
pub fn compensated_de_boor_point<const N: usize>(
    knots: &KnotVector<f64>,
    control_points: &[[f64; N]],
    u: f64,
) -> [f64; N] {
    let span = find_span(knots, u);
    let degree = knots.degree();
    let mut values = [[0.0; N]; 64];
    let mut errors = [[0.0; N]; 64];
    values[..=degree].copy_from_slice(&control_points[span - degree..=span]);
    for level in 1..=degree {
        for index in (level..=degree).rev() {
            let i = span - degree + index;
            let [a, b] = [i, i + degree + 1 - level].map(|knot| knots.knots()[knot]);
            let [falling, rising] = [ratio([b, u], [b, a]), ratio([u, a], [b, a])];
            for axis in 0..N {
                let [left, right] = [index - 1, index].map(|k| [values[k][axis], errors[k][axis]]);
                [values[index][axis], errors[index][axis]] =
                    combination(falling, left, rising, right);
            }
        }
    }
    std::array::from_fn(|axis| values[degree][axis] + errors[degree][axis])
}

/// `(a − b) / (c − d)` with what rounding takes from it.
fn ratio([a, b]: [f64; 2], [c, d]: [f64; 2]) -> [f64; 2] {
    let [over, over_error] = two_sum(a, -b);
    let [under, under_error] = two_sum(c, -d);
    let quotient = over / under;
    let [product, product_error] = two_product(quotient, under);
    let remainder = (over - product) - product_error;
    let error = (remainder + over_error - quotient * under_error) / under;
    [quotient, error]
}

/// `v x + w y` with its error, from numbers with their errors.
fn combination(
    [v, v_error]: [f64; 2],
    [x, x_error]: [f64; 2],
    [w, w_error]: [f64; 2],
    [y, y_error]: [f64; 2],
) -> [f64; 2] {
    let [vx, vx_error] = two_product(v, x);
    let [wy, wy_error] = two_product(w, y);
    let [sum, sum_error] = two_sum(vx, wy);
    let carried = v * x_error + w * y_error + (v_error * x + w_error * y);
    [sum, carried + (vx_error + wy_error + sum_error)]
}

/// The rounded sum, and its rounding error, exactly.
fn two_sum(a: f64, b: f64) -> [f64; 2] {
    let sum = a + b;
    let used = sum - a;
    [sum, (a - (sum - used)) + (b - used)]
}

/// The rounded product, and its rounding error, exactly: Dekker's way, without a fused operation.
fn two_product(a: f64, b: f64) -> [f64; 2] {
    let product = a * b;
    let ([a_high, a_low], [b_high, b_low]) = (halves(a), halves(b));
    let error = a_low * b_low - (((product - a_high * b_high) - a_low * b_high) - a_high * b_low);
    [product, error]
}

/// A number as the sum of two of half as many bits (Veltkamp).
fn halves(a: f64) -> [f64; 2] {
    let far = 134_217_729.0 * a;
    let high = far - (far - a);
    [high, a - high]
}
