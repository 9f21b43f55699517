//! Surfaces that close: the cylinder, the torus and the Möbius band.
//!
//! A B-spline closes when its knots go on at both ends as they do at the other, and its first `p` control points stand again at
//! the end. Here the distinct points are given once; the repeated ones are made from them:
//!
//! ```text
//! closed    Pᵢ₊ₙ,ⱼ = Pᵢⱼ          S(u + T, v) = S(u, v)                     N distinct columns, T the period
//! flipped   Pᵢ₊ₙ,ⱼ = Pᵢ,ₘ₋ⱼ       S(u + T, v) = S(u, v₀ + v₁ − v)           (the Möbius band; v runs from v₀ to v₁)
//! ```
//!
//! # Conventions
//!
//! A parameter beyond the seam is brought back before anything is evaluated, the end of the domain to its start. Both sides of a
//! seam are therefore evaluated at the same parameter, and are the same bits where nothing is flipped.
//!
//! # Numerics
//!
//! A parameter is wrapped by an exact remainder, so that a thousand million periods away nothing has been rounded. A mirrored parameter
//! `v₀ + v₁ − v` is rounded: the two sides of a Möbius band agree up to that, and meshes identify its vertices by number.
//!
//! # Sources
//!
//! L. Piegl, W. Tiller, *The NURBS Book*, 2nd edition, 1997, section 12.2.
//!
//! *In the course*: slides 26 to 31 (*surfaces cylindriques, toriques, ruban de Moebius*).
//!
//! *In the book*: [Surfaces that close](../../../bspline/closed.html).

mod closing;
mod wrap;

pub use closing::{Closing, PeriodicError};

use super::{BsplineSurface, Direction, KnotVector};
use crate::algebra::{Vector3, VectorSpace};
use crate::surface::{Surface, assert_grid_fits};
use closing::{check_closing, distinct_count};
use wrap::{mirrored, wrapped_parameter};

/// A B-spline surface that closes in one direction or in both.
///
/// # Examples
///
/// A tube round the z axis, from four columns of two points each:
///
/// ```
/// use facette::bspline::{Closing, KnotVector, closed_surface};
/// use facette::surface::Surface;
///
/// let knots = [KnotVector::uniform(2, 4 + 2)?, KnotVector::bezier(1)];
/// let square = [[1., 0.], [0., 1.], [-1., 0.], [0., -1.]];
/// let points = [0., 1.].map(|z| square.map(|[x, y]| [x, y, z]));
/// let tube = closed_surface(knots, points.as_flattened(), [Closing::Closed, Closing::Open])?;
/// assert_eq!(tube.point(0.0, 0.5), [0.5, 0.5, 0.5]);
/// assert_eq!(tube.point(0.0, 0.5), tube.point(4.0, 0.5));
/// # Ok::<(), facette::bspline::PeriodicError<f64>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct PeriodicSurface<P: VectorSpace> {
    surface: BsplineSurface<P>,
    closing: [Closing; 2],
}

/// The surface of these knots and distinct control points that closes as `closing` says, in u and in v.
///
/// # Shape
///
/// A direction that closes has `N = n + 1 − p` distinct points in each row, as many as its domain has spans; an open one `n + 1`. Row by
/// row, u fastest.
///
/// # Errors
///
/// [`PeriodicError`]'s variants as they say; spacings count as equal when they differ by no more than rounding explains.
pub fn closed_surface<P: VectorSpace>(
    knots: [KnotVector<P::Scalar>; 2],
    distinct_points: &[P],
    closing: [Closing; 2],
) -> Result<PeriodicSurface<P>, PeriodicError<P::Scalar>> {
    let [u, v] = &knots;
    let [in_u, in_v] = closing;
    check_closing(Direction::U, [u, v], [in_u, in_v])?;
    check_closing(Direction::V, [v, u], [in_v, in_u])?;
    let expected = [distinct_count(u, in_u), distinct_count(v, in_v)];
    if expected[0] * expected[1] != distinct_points.len() {
        return Err(PeriodicError::WrongPointCount {
            expected,
            found: distinct_points.len(),
        });
    }
    let counts = [u, v].map(KnotVector::control_point_count);
    let pairs = (0..counts[1]).flat_map(|j| (0..counts[0]).map(move |i| [i, j]));
    let points = pairs.map(|pair| {
        let [i, j] = distinct_index(pair, expected, closing);
        distinct_points[j * expected[0] + i]
    });
    let points = points.collect();
    Ok(PeriodicSurface {
        surface: BsplineSurface::new(knots, points)?,
        closing,
    })
}

/// Which of the distinct points the control point `[i, j]` repeats.
// ANCHOR: distinct_index
fn distinct_index([i, j]: [usize; 2], [n, m]: [usize; 2], closing: [Closing; 2]) -> [usize; 2] {
    let is_odd = |turns: usize| turns % 2 == 1;
    match closing {
        [Closing::Flipped, _] if is_odd(i / n) => [i % n, m - 1 - j],
        [_, Closing::Flipped] if is_odd(j / m) => [n - 1 - i, j % m],
        _ => [i % n, j % m],
    }
}
// ANCHOR_END: distinct_index

impl<P: VectorSpace> PeriodicSurface<P> {
    /// The B-spline surface of all control points, the repeated ones included.
    pub fn surface(&self) -> &BsplineSurface<P> {
        &self.surface
    }

    /// How the sides are joined, in u and in v.
    ///
    /// Where u closes, the side `u = u₁` is the side `u = u₀`: its point at `v` is the point `(u₀, v)`, and where it closes with a flip,
    /// the point `(u₀, v₀ + v₁ − v)`; likewise for v. What cuts the surface into triangles makes one vertex of such a pair.
    pub fn closing(&self) -> [Closing; 2] {
        self.closing
    }

    /// How many distinct control points there are, in u and in v.
    pub fn distinct_counts(&self) -> [usize; 2] {
        let directions = [Direction::U, Direction::V];
        std::array::from_fn(|axis| {
            distinct_count(self.surface.knots(directions[axis]), self.closing[axis])
        })
    }

    /// The parameters in the domain of the same point of the surface, the end of a direction that closes brought back to its start; and
    /// whether the way there turns the surface over, so that its normal changes sign.
    ///
    /// # Accuracy
    ///
    /// Parameters in the half-open domain come back unchanged, and its end becomes its start exactly. Elsewhere the distance from the start, the period and
    /// the result are rounded: together at most `4u (|t| + |t₀| + |t₁|)` for a parameter `t` of the domain `[t₀, t₁]`. A flip rounds the other parameter twice.
    ///
    /// # Edge cases
    ///
    /// An infinite parameter of a closing direction gives NaN, as NaN does.
    pub fn wrapped(&self, u: P::Scalar, v: P::Scalar) -> ([P::Scalar; 2], bool) {
        let [domain_u, domain_v] = self.surface.domain();
        let wrap = |closing, t, domain| match closing {
            Closing::Open => (t, false),
            Closing::Closed => (wrapped_parameter(t, domain).0, false),
            Closing::Flipped => wrapped_parameter(t, domain),
        };
        let [in_u, in_v] = self.closing;
        let (u, flips_v) = wrap(in_u, u, domain_u);
        let (v, flips_u) = wrap(in_v, v, domain_v);
        let u = if flips_u { mirrored(u, domain_u) } else { u };
        let v = if flips_v { mirrored(v, domain_v) } else { v };
        ([u, v], flips_u || flips_v)
    }

    /// The partial derivative of order `k` in u and `l` in v.
    ///
    /// At the seam it is that of the surface after it; before it, all orders below the degree are the same. After a flip, a derivative that jumps
    /// at a knot of the mirrored parameter is that from the other side of the knot.
    pub fn derivative_at(&self, [k, l]: [usize; 2], u: P::Scalar, v: P::Scalar) -> P {
        let ([u, v], is_flipped) = self.wrapped(u, v);
        let derivative = self.surface.derivative_at([k, l], u, v);
        let mirrored_order = if self.closing[0] == Closing::Flipped {
            l
        } else {
            k
        };
        if is_flipped && mirrored_order % 2 == 1 {
            return P::origin().minus(derivative);
        }
        derivative
    }
}

impl<P: VectorSpace> Surface for PeriodicSurface<P> {
    type Scalar = P::Scalar;
    type Point = P;

    fn domain(&self) -> [[P::Scalar; 2]; 2] {
        self.surface.domain()
    }

    fn point(&self, u: P::Scalar, v: P::Scalar) -> P {
        let ([u, v], _) = self.wrapped(u, v);
        self.surface.point(u, v)
    }

    fn partials(&self, u: P::Scalar, v: P::Scalar) -> Option<[P; 2]> {
        let ([u, v], is_flipped) = self.wrapped(u, v);
        let [s_u, s_v] = self.surface.partials(u, v)?;
        let negated = |vector: P| P::origin().minus(vector);
        Some(match (is_flipped, self.closing) {
            (true, [Closing::Flipped, _]) => [s_u, negated(s_v)],
            (true, _) => [negated(s_u), s_v],
            (false, _) => [s_u, s_v],
        })
    }

    fn normal_vector(&self, u: P::Scalar, v: P::Scalar) -> Option<P>
    where
        P: Vector3,
    {
        let ([u, v], is_flipped) = self.wrapped(u, v);
        let normal = self.surface.normal_vector(u, v)?;
        Some(if is_flipped {
            P::origin().minus(normal)
        } else {
            normal
        })
    }

    fn points_on_grid(&self, us: &[P::Scalar], vs: &[P::Scalar], points: &mut [P]) {
        assert_grid_fits(us.len(), vs.len(), points.len());
        if !self.closing.contains(&Closing::Flipped) {
            let [[u0, _], [v0, _]] = self.domain();
            let us: Vec<_> = us.iter().map(|&u| self.wrapped(u, v0).0[0]).collect();
            let vs: Vec<_> = vs.iter().map(|&v| self.wrapped(u0, v).0[1]).collect();
            return self.surface.points_on_grid(&us, &vs, points);
        }
        // A flip mirrors each parameter by the other one: there is no grid to hand on.
        let pairs = vs.iter().flat_map(|&v| us.iter().map(move |&u| (u, v)));
        for (point, (u, v)) in points.iter_mut().zip(pairs) {
            *point = self.point(u, v);
        }
    }
}
