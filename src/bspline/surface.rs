//! Tensor-product B-spline surfaces.

use num_traits::Zero;

use super::basis::{basis_functions, find_span, triangle, with_buffer};
use super::curve::{BsplineCurve, check_points, weighted_sum};
use super::{BsplineError, Direction, KnotVector, normal, refine};
use crate::algebra::{Scalar, Vector3, VectorSpace, larger};
use crate::curve::count;
use crate::surface::{Surface, assert_grid_fits};

/// The point `S(u, v) = ΣΣ Nᵢ(u) Nⱼ(v) Pᵢⱼ`: span and basis in u, span and basis in v, then the `(p + 1)(q + 1)` control points that
/// count, summed over v first.
///
/// # Accuracy
///
/// In the domain, each coordinate is within `(6p + 6q + 2)u · M`, `M` the largest coordinate of those control points (tested as
/// `surface_error_stays_below_its_bound`).
///
/// # Edge cases
///
/// Outside the domain the polynomial of the nearest span goes on; NaN gives NaN.
///
/// # Source
///
/// Slide 19.
#[inline]
pub fn surface_point<P: VectorSpace>(surface: &BsplineSurface<P>, u: P::Scalar, v: P::Scalar) -> P {
    let (zero, origin) = (P::Scalar::zero(), P::origin());
    let [p, q] = surface.knots.each_ref().map(KnotVector::degree);
    if [p, q] == [3, 3] {
        // Bicubic surfaces are the most used: with lengths that the compiler knows it unrolls every loop.
        let [mut n_u, mut n_v] = [[zero; 4]; 2];
        return five_steps(surface, [u, v], &mut n_u, &mut n_v, &mut [origin; 4]);
    }
    with_buffer(p + 1, zero, |n_u| {
        with_buffer(q + 1, zero, |n_v| {
            with_buffer(p + 1, origin, |points| {
                five_steps(surface, [u, v], n_u, n_v, points)
            })
        })
    })
}

/// As [`surface_point`]; the functions of u and of v, and the control points of the isoparametric curve, are kept in the three buffers.
#[allow(
    clippy::inline_always,
    reason = "the lengths of the buffers are known to the caller only: a third of the time of a bicubic point"
)]
#[inline(always)]
// ANCHOR: surface_point
fn five_steps<P: VectorSpace>(
    surface: &BsplineSurface<P>,
    [u, v]: [P::Scalar; 2],
    n_u: &mut [P::Scalar],
    n_v: &mut [P::Scalar],
    points: &mut [P],
) -> P {
    let [in_u, in_v] = &surface.knots;
    let i = find_span(in_u, u);
    triangle(in_u, i, u, n_u);
    let j = find_span(in_v, v);
    triangle(in_v, j, v, n_v);
    let [p, q] = [n_u.len() - 1, n_v.len() - 1];
    for (l, &weight) in n_v.iter().enumerate() {
        let first = (j - q + l) * surface.columns() + i - p;
        let row = &surface.control_points[first..=first + p];
        for (point, control_point) in points.iter_mut().zip(row) {
            let term = control_point.times(weight);
            *point = if l == 0 { term } else { point.plus(term) };
        }
    }
    weighted_sum(n_u, points)
}
// ANCHOR_END: surface_point

/// A tensor-product B-spline surface `S(u, v) = ΣΣ Nᵢᵖ(u) Nⱼᵠ(v) Pᵢⱼ`.
///
/// # Examples
///
/// ```
/// use facette::bspline::{BsplineSurface, KnotVector};
/// use facette::surface::Surface;
///
/// let knots = [KnotVector::clamped_uniform(2, 4)?, KnotVector::bezier(1)];
/// let points = (0..8).map(|k| [f64::from(k % 4), f64::from(k / 4), f64::from(k % 2)]);
/// let surface = BsplineSurface::new(knots, points.collect())?;
/// assert_eq!(surface.point(0.0, 1.0), [0.0, 1.0, 0.0]);
/// assert_eq!(surface.point(0.5, 0.5), [1.5, 0.5, 0.5]);
/// # Ok::<(), facette::bspline::BsplineError<f64>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct BsplineSurface<P: VectorSpace> {
    knots: [KnotVector<P::Scalar>; 2],
    control_points: Vec<P>,
}

impl<P: VectorSpace> BsplineSurface<P> {
    /// The surface of these knots, in u and in v, and control points.
    ///
    /// # Shape
    ///
    /// `(n + 1)(m + 1)` control points, row by row with u running fastest: `Pᵢⱼ = control_points[j (n + 1) + i]`.
    ///
    /// # Errors
    ///
    /// [`BsplineError::WrongNetSize`] where they do not fit, [`BsplineError::PointNotFinite`] for an infinite or NaN coordinate.
    pub fn new(
        knots: [KnotVector<P::Scalar>; 2],
        control_points: Vec<P>,
    ) -> Result<Self, BsplineError<P::Scalar>> {
        let expected = knots.each_ref().map(KnotVector::control_point_count);
        if expected[0].checked_mul(expected[1]) != Some(control_points.len()) {
            return Err(BsplineError::WrongNetSize {
                knots: knots.each_ref().map(|knots| knots.knots().len()),
                degrees: knots.each_ref().map(KnotVector::degree),
                expected,
                found: control_points.len(),
            });
        }
        check_points(&control_points)?;
        Ok(Self {
            knots,
            control_points,
        })
    }

    /// The surface of knots and control points that are known to fit.
    pub(super) fn of_fitting(knots: [KnotVector<P::Scalar>; 2], control_points: Vec<P>) -> Self {
        Self {
            knots,
            control_points,
        }
    }

    /// The knots in one direction.
    pub fn knots(&self, direction: Direction) -> &KnotVector<P::Scalar> {
        let [in_u, in_v] = &self.knots;
        match direction {
            Direction::U => in_u,
            Direction::V => in_v,
        }
    }

    /// All control points, row by row, u running fastest.
    pub fn control_points(&self) -> &[P] {
        &self.control_points
    }

    /// The number `n + 1` of control points in u, and so the length of a row.
    pub(super) fn columns(&self) -> usize {
        self.knots[0].control_point_count()
    }

    /// The control point `Pᵢⱼ`.
    ///
    /// # Panics
    ///
    /// When there is none of these indices.
    pub fn control_point(&self, i: usize, j: usize) -> P {
        let columns = self.columns();
        assert!(i < columns, "column {i} of a net with {columns} columns");
        self.control_points[j * columns + i]
    }

    /// The same surface with another control point `Pᵢⱼ`: it moves over [`BsplineSurface::support_of`] that point only.
    ///
    /// # Errors
    ///
    /// [`BsplineError::PointNotFinite`].
    ///
    /// # Panics
    ///
    /// As [`BsplineSurface::control_point`].
    pub fn with_control_point(
        mut self,
        i: usize,
        j: usize,
        point: P,
    ) -> Result<Self, BsplineError<P::Scalar>> {
        let index = j * self.columns() + i;
        if self.control_point(i, j) != point {
            self.control_points[index] = point;
        }
        check_points(&self.control_points[index..=index]).map_err(|error| match error {
            BsplineError::PointNotFinite { point, .. } => {
                BsplineError::PointNotFinite { index, point }
            }
            other => other,
        })?;
        Ok(self)
    }

    /// The part `[[uᵢ, uᵢ₊ₚ₊₁], [vⱼ, vⱼ₊ᵩ₊₁]]` of the domain that the control point `Pᵢⱼ` moves.
    ///
    /// # Panics
    ///
    /// When there is no control point of these indices.
    pub fn support_of(&self, i: usize, j: usize) -> [[P::Scalar; 2]; 2] {
        let support = |knots: &KnotVector<P::Scalar>, index: usize| {
            let [start, end] = knots.domain();
            let [from, to] = [
                knots.knots()[index],
                knots.knots()[index + knots.degree() + 1],
            ];
            let [from, to] = [
                if from < start { start } else { from },
                if to > end { end } else { to },
            ];
            [from, to]
        };
        [support(&self.knots[0], i), support(&self.knots[1], j)]
    }

    /// The point `Σ weights[l] · P_(column, first_row + l)` of one column of the net.
    #[inline]
    fn column_point(&self, column: usize, first_row: usize, weights: &[P::Scalar]) -> P {
        let columns = self.columns();
        let rows = self.control_points[first_row * columns + column..].iter();
        let terms = rows.step_by(columns).zip(weights);
        terms
            .map(|(point, &weight)| point.times(weight))
            .reduce(P::plus)
            .unwrap_or_else(P::origin)
    }

    /// The isoparametric curve `v ↦ S(u0, v)`: the B-spline curve with the control points `Qⱼ(u0) = Σ Nᵢ(u0) Pᵢⱼ`.
    pub fn curve_at_u(&self, u0: P::Scalar) -> BsplineCurve<P> {
        self.transposed().curve_at_v(u0)
    }

    /// The isoparametric curve `u ↦ S(u, v0)`: the B-spline curve with the control points `Qᵢ(v0) = Σ Nⱼ(v0) Pᵢⱼ`.
    pub fn curve_at_v(&self, v0: P::Scalar) -> BsplineCurve<P> {
        let in_v = &self.knots[1];
        let span = find_span(in_v, v0);
        let degree = in_v.degree();
        let control_points = with_buffer(degree + 1, P::Scalar::zero(), |n_v| {
            basis_functions(in_v, span, v0, n_v);
            let column = |i| self.column_point(i, span - degree, n_v);
            (0..self.columns()).map(column).collect()
        });
        BsplineCurve::of_fitting(self.knots[0].clone(), control_points)
    }

    /// The derivative `∂ᵏ⁺ˡS / ∂uᵏ∂vˡ` of these orders `[k, l]`; `[0, 0]` is the point. At a knot, that of the span after it; at the end
    /// of the domain, of the last span.
    ///
    /// # Accuracy
    ///
    /// Differences of control points are taken first and combined with weights that sum to 1: a surface far from the origin keeps its
    /// tangents as well as its control points hold them. A first derivative in the domain is within `(6p + 6q)u · D` in each coordinate, `D`
    /// the largest difference quotient of the control points that count (tested as
    /// `partial_derivative_error_stays_below_its_bound`). Higher orders take differences of rounded differences and have no such bound.
    pub fn derivative_at(&self, [k, l]: [usize; 2], u: P::Scalar, v: P::Scalar) -> P {
        let [in_u, in_v] = &self.knots;
        let [p, q] = [in_u.degree(), in_v.degree()];
        if k > p || l > q {
            return P::origin();
        }
        let spans = [find_span(in_u, u), find_span(in_v, v)];
        let columns = q + 1;
        with_buffer((p + 1) * columns, P::origin(), |net| {
            // Column after column: those of the net are the lines of `net`.
            self.copy_local_net(spans, net);
            for column in net.chunks_exact_mut(columns) {
                for order in 1..=l {
                    refine::differentiate(in_v, spans[1], order, 1, column);
                }
            }
            for order in 1..=k {
                refine::differentiate(in_u, spans[0], order, columns, net);
            }
            with_buffer(p + 1 - k, P::Scalar::zero(), |n_u| {
                with_buffer(q + 1 - l, P::Scalar::zero(), |n_v| {
                    triangle(in_u, spans[0], u, n_u);
                    triangle(in_v, spans[1], v, n_v);
                    let sums = net.chunks_exact(columns).zip(&*n_u);
                    sums.map(|(column, &weight)| weighted_sum(n_v, column).times(weight))
                        .reduce(P::plus)
                        .unwrap_or_else(P::origin)
                })
            })
        })
    }

    /// The largest `size` of a control point that counts at these parameters, and of a difference quotient of two of them in u and in v.
    pub(super) fn largest_differences(
        &self,
        u: P::Scalar,
        v: P::Scalar,
        size: impl Fn(P) -> P::Scalar,
    ) -> [P::Scalar; 3] {
        let [in_u, in_v] = &self.knots;
        let [p, q] = [in_u.degree(), in_v.degree()];
        let spans = [find_span(in_u, u), find_span(in_v, v)];
        let largest = |points: &[P]| {
            let sizes = points.iter().map(|&point| size(point));
            sizes.fold(P::Scalar::zero(), larger)
        };
        with_buffer((p + 1) * (q + 1), P::origin(), |net| {
            self.copy_local_net(spans, net);
            let point = largest(net);
            if p > 0 {
                refine::differentiate(in_u, spans[0], 1, q + 1, net);
            }
            let along_u = largest(&net[..p * (q + 1)]);
            self.copy_local_net(spans, net);
            let mut along_v = P::Scalar::zero();
            for column in net.chunks_exact_mut(q + 1).filter(|_| q > 0) {
                refine::differentiate(in_v, spans[1], 1, 1, column);
                along_v = larger(along_v, largest(&column[..q]));
            }
            [point, along_u, along_v]
        })
    }

    /// The factor `(6p + 6q + 4)u`, by which a partial derivative or a point may be wrong, relative to what it is made of.
    pub(super) fn roundoffs(&self) -> P::Scalar {
        let degrees: usize = self.knots.iter().map(KnotVector::degree).sum();
        P::Scalar::from_i32(count(6 * degrees + 4)) * P::Scalar::unit_roundoff()
    }

    /// Copies the control points that count on these spans, column after column.
    pub(super) fn copy_local_net(&self, [i, j]: [usize; 2], net: &mut [P]) {
        let [p, q] = [self.knots[0].degree(), self.knots[1].degree()];
        let columns = self.columns();
        for (column, points) in (i - p..=i).zip(net.chunks_exact_mut(q + 1)) {
            for (row, point) in (j - q..=j).zip(points) {
                *point = self.control_points[row * columns + column];
            }
        }
    }
}

impl<P: VectorSpace> Surface for BsplineSurface<P> {
    type Scalar = P::Scalar;
    type Point = P;

    fn domain(&self) -> [[P::Scalar; 2]; 2] {
        self.knots.each_ref().map(KnotVector::domain)
    }

    fn point(&self, u: P::Scalar, v: P::Scalar) -> P {
        surface_point(self, u, v)
    }

    fn partials(&self, u: P::Scalar, v: P::Scalar) -> Option<[P; 2]> {
        Some([
            self.derivative_at([1, 0], u, v),
            self.derivative_at([0, 1], u, v),
        ])
    }

    /// As [`Surface::normal_vector`]; where a partial derivative vanishes or the two are parallel, as at the pole of a sphere or on a
    /// collapsed edge, the limit from inside the domain, from the higher derivatives. `None` where those say nothing either.
    fn normal_vector(&self, u: P::Scalar, v: P::Scalar) -> Option<P>
    where
        P: Vector3,
    {
        let [_, differences @ ..] = self.largest_differences(u, v, P::largest_coordinate);
        let noise = differences.map(|difference| difference * self.roundoffs());
        let derivative = |orders| self.derivative_at(orders, u, v);
        normal::normal_of(self.knots.each_ref(), [u, v], noise, derivative)
    }

    /// As [`Surface::points_on_grid`]: for each row one isoparametric curve, on which every point takes `p + 1` control points; the
    /// basis in u is evaluated once a column.
    // ANCHOR: points_on_grid
    fn points_on_grid(&self, us: &[P::Scalar], vs: &[P::Scalar], points: &mut [P]) {
        assert_grid_fits(us.len(), vs.len(), points.len());
        if us.is_empty() {
            return;
        }
        let in_u = &self.knots[0];
        let order = in_u.degree() + 1;
        let mut weights = vec![P::Scalar::zero(); us.len() * order];
        let mut firsts = Vec::with_capacity(us.len());
        for (&u, weights) in us.iter().zip(weights.chunks_exact_mut(order)) {
            let span = find_span(in_u, u);
            basis_functions(in_u, span, u, weights);
            firsts.push(span + 1 - order);
        }
        for (row, &v) in points.chunks_exact_mut(us.len()).zip(vs) {
            let curve = self.curve_at_v(v);
            let columns = firsts.iter().zip(weights.chunks_exact(order));
            for (point, (&first, weights)) in row.iter_mut().zip(columns) {
                *point = weighted_sum(weights, &curve.control_points()[first..first + order]);
            }
        }
    }
    // ANCHOR_END: points_on_grid
}
