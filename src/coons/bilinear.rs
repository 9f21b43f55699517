//! The bilinear Coons patch: the sum of two ruled surfaces less the bilinear surface of the corners.

use num_traits::{One, Zero};

use super::boundary::{Boundary, Corners, ROUNDOFFS_OF_A_GAP};
use crate::algebra::{Scalar, Vector3, VectorSpace};
use crate::curve::Curve;
use crate::surface::{Surface, assert_grid_fits, normal_of_tangents};

/// The points of the three ruled surfaces `[S₁, S₂, S₃]` at `(u, v)`.
///
/// # Source
///
/// Coons 1967; slide 9.
#[inline]
// ANCHOR: ruled_surfaces
pub fn ruled_surfaces<C: Curve>(
    boundary: &Boundary<C>,
    u: C::Scalar,
    v: C::Scalar,
) -> [C::Point; 3] {
    let Corners { a, b, c, d } = boundary.corners();
    let s1 = boundary.p1().point(u).lerp(boundary.p2().point(u), v);
    let s2 = boundary.q1().point(v).lerp(boundary.q2().point(v), u);
    let s3 = a.lerp(b, u).lerp(d.lerp(c, u), v);
    [s1, s2, s3]
}
// ANCHOR_END: ruled_surfaces

/// The point `S(u, v) = S₁ + S₂ − S₃` of the bilinear Coons patch.
///
/// # Accuracy
///
/// For `0 <= u, v <= 1`, each coordinate is within `16u·M` of the exact patch of the computed curve points, `M` the
/// largest coordinate of those points and of the corners (tested as `point_error_stays_below_its_bound`). On an
/// edge whose curves meet exactly, the point equals the boundary curve's.
///
/// # Cost
///
/// One point of each of the four curves, five interpolations and a compensated sum of three terms.
///
/// # Edge cases
///
/// Outside `[0, 1]` the formula extrapolates; NaN gives NaN. Where the sum of two coordinates overflows, the result is NaN.
#[inline]
// ANCHOR: bilinear_point
pub fn bilinear_point<C: Curve>(boundary: &Boundary<C>, u: C::Scalar, v: C::Scalar) -> C::Point {
    let [s1, s2, s3] = ruled_surfaces(boundary, u, v);
    boolean_sum(s1, s2, s3)
}
// ANCHOR_END: bilinear_point

/// The sum `s1 + s2 − s3` with the two rounding errors carried along; exact where `s3` equals `s1` or `s2`, as long as
/// `s1 + s2` does not overflow (proof and test: `edges_are_exact_in_floating_point`).
#[inline]
// ANCHOR: boolean_sum
pub(super) fn boolean_sum<P: VectorSpace>(s1: P, s2: P, s3: P) -> P {
    let (sum, first_error) = two_sum(s1, s2);
    let (difference, second_error) = two_sum(sum, P::origin().minus(s3));
    difference.plus(first_error.plus(second_error))
}

/// The rounded sum `a + b` and its rounding error, coordinate by coordinate.
#[inline]
fn two_sum<P: VectorSpace>(a: P, b: P) -> (P, P) {
    let sum = a.plus(b);
    let b_used = sum.minus(a);
    let a_used = sum.minus(b_used);
    (sum, a.minus(a_used).plus(b.minus(b_used)))
}
// ANCHOR_END: boolean_sum

/// The partial derivatives `[S_u, S_v]` of the bilinear Coons patch; `None` where a curve's derivative is not known.
///
/// # Accuracy
///
/// For `0 <= u, v <= 1`, each coordinate is within `19u·M` of the exact derivatives of the patch with the computed points
/// and derivatives, `M` the largest coordinate of those and of the corners (tested as
/// `partials_error_stays_below_its_bound`).
// ANCHOR: bilinear_partials
pub fn bilinear_partials<C: Curve>(
    boundary: &Boundary<C>,
    u: C::Scalar,
    v: C::Scalar,
) -> Option<[C::Point; 2]> {
    let Corners { a, b, c, d } = boundary.corners();
    let [p1, p2] = [boundary.p1(), boundary.p2()];
    let [q1, q2] = [boundary.q1(), boundary.q2()];
    let s_u = boolean_sum(
        p1.derivative(u)?.lerp(p2.derivative(u)?, v),
        q2.point(v).minus(q1.point(v)),
        b.minus(a).lerp(c.minus(d), v),
    );
    let s_v = boolean_sum(
        q1.derivative(v)?.lerp(q2.derivative(v)?, u),
        p2.point(u).minus(p1.point(u)),
        d.minus(a).lerp(c.minus(b), u),
    );
    Some([s_u, s_v])
}
// ANCHOR_END: bilinear_partials

/// The mixed derivative, or twist, `S_uv` of the bilinear Coons patch; `None` where a curve's derivative is not known.
fn bilinear_mixed_partial<C: Curve>(
    boundary: &Boundary<C>,
    u: C::Scalar,
    v: C::Scalar,
) -> Option<C::Point> {
    let Corners { a, b, c, d } = boundary.corners();
    let along_u = boundary
        .p2()
        .derivative(u)?
        .minus(boundary.p1().derivative(u)?);
    let along_v = boundary
        .q2()
        .derivative(v)?
        .minus(boundary.q1().derivative(v)?);
    Some(boolean_sum(along_u, along_v, c.minus(d).minus(b.minus(a))))
}

/// The bilinear Coons patch of a boundary.
///
/// # Examples
///
/// ```
/// use facette::coons::{Boundary, CoonsPatch};
/// use facette::curve::BezierCurve;
/// use facette::surface::Surface;
///
/// let curve = |points: &[[f64; 3]]| BezierCurve::new(points.to_vec());
/// let patch = CoonsPatch::new(Boundary::new(
///     curve(&[[0., 0., 0.], [1., 0., 2.], [2., 0., 0.]])?,
///     curve(&[[0., 2., 0.], [1., 2., 2.], [2., 2., 0.]])?,
///     curve(&[[0., 0., 0.], [0., 2., 0.]])?,
///     curve(&[[2., 0., 0.], [2., 2., 0.]])?,
/// )?);
/// assert_eq!(patch.point(0.5, 0.5), [1.0, 1.0, 1.0]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct CoonsPatch<C: Curve> {
    boundary: Boundary<C>,
}

impl<C: Curve> CoonsPatch<C> {
    /// The patch that `boundary` determines.
    pub fn new(boundary: Boundary<C>) -> Self {
        Self { boundary }
    }

    /// The four curves.
    pub fn boundary(&self) -> &Boundary<C> {
        &self.boundary
    }

    /// The two tangents that span the tangent plane: on an edge, the edge curve's own derivative; where that vanishes
    /// (a side collapsed to a point), its limit direction from inside the patch, by l'Hôpital's rule.
    fn tangents(&self, u: C::Scalar, v: C::Scalar) -> Option<[C::Point; 2]> {
        let [s_u, s_v] = bilinear_partials(&self.boundary, u, v)?;
        let mixed = bilinear_mixed_partial(&self.boundary, u, v)?;
        let boundary = &self.boundary;
        let along_u = edge_tangent(v, u, [boundary.p1(), boundary.p2()], mixed);
        let along_v = edge_tangent(u, v, [boundary.q1(), boundary.q2()], mixed);
        Some([along_u.unwrap_or(s_u), along_v.unwrap_or(s_v)])
    }
}

/// The tangent of the edge curve on which `across` puts the point, at the parameter `along`; `None` off both edges.
///
/// Next to a side that is collapsed to a point at `across = 0`, the tangent is `across · mixed`, which gives the direction;
/// at `across = 1` it comes from the other side.
fn edge_tangent<C: Curve>(
    across: C::Scalar,
    along: C::Scalar,
    edges: [&C; 2],
    mixed: C::Point,
) -> Option<C::Point> {
    let (edge, inward) = if across.is_zero() {
        (edges[0], mixed)
    } else if across == C::Scalar::one() {
        (edges[1], C::Point::origin().minus(mixed))
    } else {
        return None;
    };
    let tangent = edge.derivative(along)?;
    Some(if is_collapsed(edge, tangent, mixed) {
        inward
    } else {
        tangent
    })
}

/// Whether a side is one point: the derivatives at both ends, in the middle and at the place in question are not more than
/// rounding beside the mixed derivative. One of them alone may vanish on a curve too, where it has a cusp or stands still.
fn is_collapsed<C: Curve>(edge: &C, tangent: C::Point, mixed: C::Point) -> bool {
    let roundoff = C::Scalar::from_i32(ROUNDOFFS_OF_A_GAP) * C::Scalar::unit_roundoff();
    let allowed = roundoff * mixed.largest_coordinate();
    let vanishes = |tangent: C::Point| tangent.largest_coordinate() <= allowed;
    let elsewhere = [0, 1, 2].map(|halves| edge.derivative(C::Scalar::ratio(halves, 2)));
    vanishes(tangent) && elsewhere.into_iter().flatten().all(vanishes)
}

impl<C: Curve> Surface for CoonsPatch<C> {
    type Scalar = C::Scalar;
    type Point = C::Point;

    fn domain(&self) -> [[C::Scalar; 2]; 2] {
        [[C::Scalar::zero(), C::Scalar::one()]; 2]
    }

    fn point(&self, u: C::Scalar, v: C::Scalar) -> C::Point {
        bilinear_point(&self.boundary, u, v)
    }

    fn partials(&self, u: C::Scalar, v: C::Scalar) -> Option<[C::Point; 2]> {
        bilinear_partials(&self.boundary, u, v)
    }

    /// As [`Surface::normal_vector`]; on a side that is collapsed to a point, the limit from inside.
    ///
    /// # Accuracy
    ///
    /// The tangents carry the error of [`bilinear_partials`]; where one of them is hardly larger, as very near to a collapsed
    /// side, the direction is as uncertain as that.
    fn normal_vector(&self, u: C::Scalar, v: C::Scalar) -> Option<C::Point>
    where
        C::Point: Vector3,
    {
        let [along_u, along_v] = self.tangents(u, v)?;
        normal_of_tangents(along_u, along_v)
    }

    /// As [`Surface::points_on_grid`], with each curve evaluated once a row or column: `2(n + m)` curve points instead
    /// of `4nm`.
    // ANCHOR: row_wise_grid
    fn points_on_grid(&self, us: &[C::Scalar], vs: &[C::Scalar], points: &mut [C::Point]) {
        assert_grid_fits(us.len(), vs.len(), points.len());
        if us.is_empty() {
            return;
        }
        let Corners { a, b, c, d } = self.boundary.corners();
        let [p1, p2] = [self.boundary.p1(), self.boundary.p2()];
        let columns: Vec<_> = us
            .iter()
            .map(|&u| (u, p1.point(u), p2.point(u), a.lerp(b, u), d.lerp(c, u)))
            .collect();
        for (row, &v) in points.chunks_exact_mut(us.len()).zip(vs) {
            let [q1, q2] = [self.boundary.q1().point(v), self.boundary.q2().point(v)];
            for (point, &(u, p1, p2, bottom, top)) in row.iter_mut().zip(&columns) {
                *point = boolean_sum(p1.lerp(p2, v), q1.lerp(q2, u), bottom.lerp(top, v));
            }
        }
    }
    // ANCHOR_END: row_wise_grid
}
