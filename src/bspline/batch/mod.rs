//! Many points of a surface at once, as fast as the processor allows.
//!
//! What one point costs is mostly the search for its spans and the divisions of the basis. A surface that is evaluated
//! often is prepared once: a table finds the spans, and every pair of spans keeps its polynomial as a Bézier patch, those of the
//! partial derivatives too. A point then takes Bernstein's polynomials and one weighted sum:
//!
//! ```text
//! S(u,v) = Σᵢ Bᵢᵖ(s) Σⱼ Bⱼᵠ(t) bᵢⱼ          s = (u − uₖ) / (uₖ₊₁ − uₖ),  t = (v − vₗ) / (vₗ₊₁ − vₗ)
//! ```
//!
//! Points are taken in groups, and every step is a plain loop over the group, which the compiler turns into the vector
//! instructions that it may use: two numbers at a time on any x86-64, eight where the build allows it. Nothing is fused, so the bits are
//! the same on every processor.
//!
//! ```text
//! S(u,v) = ΣΣ Bᵢᵖ(s) Bⱼᵠ(t) bᵢⱼ          s = (u − uₖ) (1 / (uₖ₊₁ − uₖ)), t likewise; b the Bézier points of the pair of spans
//! ```
//!
//! # Conventions
//!
//! Lists hold pairs `[u, v]`; grids and their points run as those of [`Surface::points_on_grid`].
//!
//! # Numerics
//!
//! Bézier points and Bernstein's polynomials are means and sums of products of non-negative numbers: nothing cancels, as the coefficients
//! of powers of u would. The inverse of a span's length is rounded before it is used, which a single point avoids by dividing; that, and the
//! rounded Bézier points, make the bound larger. No operation is fused: the bits do not depend on the processor.
//!
//! # Sources
//!
//! G. Farin, *Curves and Surfaces for CAGD*, 5th edition, chapters 5 and 14.
//!
//! *In the course*: slide 19, the five steps, of which all but the last are done beforehand.
//!
//! *In the book*: [Many points at once](../../../bspline/many_points.html).

use std::sync::Arc;

use num_traits::{AsPrimitive, Zero};

use super::{BsplineSurface, Direction};
use crate::algebra::{Scalar, Vector3, VectorSpace, larger};
use crate::surface::{Surface, assert_grid_fits};
use kernel::{FixedDegrees, Kernel};

mod axis;
mod kernel;
mod patches;

/// A B-spline surface prepared for many evaluations: points, partial derivatives and normals at lists of parameters or on grids, written
/// into buffers of the caller.
///
/// # Accuracy
///
/// For parameters in the domain and degrees 1 to 3, each coordinate of a point is within `(16p + 16q + 2)u · M`, `M` the largest
/// coordinate of the `(p + 1)(q + 1)` control points that count, and each coordinate of a partial derivative within `(16p + 16q − 10)u`
/// of the largest coordinate of their derivative's control points (tested as `batch_error_stays_below_its_bound`); measured, about
/// a twentieth of that.
///
/// # Cost
///
/// Degrees 1 to 3 in each direction have loops of their own; they keep `(p + 1)(q + 1) + p (q + 1) + (p + 1) q` vectors for every pair of
/// non-empty spans, 2.5 times 16 vectors for a bicubic patch. Surfaces of other degrees, or with a span whose length or the inverse of
/// it is not a normal number, are evaluated by the functions of [`BsplineSurface`] and have their accuracy.
///
/// The number type converts to a byte, as `f32` and `f64` do: with saturation, and 0 for NaN. The table of spans is made with it.
///
/// # Edge cases
///
/// As the surface: at a knot the piece behind it counts, at the end of the domain the last one; outside, the polynomial of the
/// nearest span goes on; NaN gives NaN.
///
/// # Examples
///
/// ```
/// use facette::bspline::{BsplineSurface, KnotVector, SurfaceEvaluator};
///
/// let knots = [KnotVector::clamped_uniform(2, 4)?, KnotVector::bezier(1)];
/// let net = (0..8).map(|k| [f64::from(k % 4), f64::from(k / 4), f64::from(k % 2)]);
/// let evaluator = SurfaceEvaluator::new(BsplineSurface::new(knots, net.collect())?);
/// let mut points = [[0.0; 3]; 2];
/// evaluator.points(&[[0.0, 1.0], [0.5, 0.5]], &mut points);
/// assert_eq!(points, [[0.0, 1.0, 0.0], [1.5, 0.5, 0.5]]);
/// # Ok::<(), facette::bspline::BsplineError<f64>>(())
/// ```
#[derive(Clone, Debug)]
pub struct SurfaceEvaluator<P: VectorSpace> {
    surface: BsplineSurface<P>,
    /// Shared by clones.
    kernel: Option<Arc<dyn Kernel<P>>>,
}

impl<P> SurfaceEvaluator<P>
where
    P: Vector3,
    P::Scalar: AsPrimitive<u8>,
{
    /// Prepares the surface.
    pub fn new(surface: BsplineSurface<P>) -> Self {
        let kernel = kernel_for(&surface);
        Self { surface, kernel }
    }

    /// The surface.
    pub fn surface(&self) -> &BsplineSurface<P> {
        &self.surface
    }

    /// Writes `S(u, v)` for each pair `[u, v]` of the parameters.
    ///
    /// # Panics
    ///
    /// When there are not as many places as parameters: a caller's bug.
    pub fn points(&self, parameters: &[[P::Scalar; 2]], points: &mut [P]) {
        assert_list_fits(parameters.len(), points.len());
        if let Some(kernel) = &self.kernel {
            return kernel.points(parameters, points);
        }
        for (&[u, v], point) in parameters.iter().zip(points) {
            *point = self.surface.point(u, v);
        }
    }

    /// Writes the point and both partial derivatives `[S, S_u, S_v]` for each pair `[u, v]` of the parameters.
    ///
    /// # Panics
    ///
    /// When there are not as many places as parameters: a caller's bug.
    pub fn partials(&self, parameters: &[[P::Scalar; 2]], partials: &mut [[P; 3]]) {
        assert_list_fits(parameters.len(), partials.len());
        if let Some(kernel) = &self.kernel {
            return kernel.partials(parameters, partials);
        }
        for (&[u, v], partials) in parameters.iter().zip(partials) {
            *partials = point_and_partials(&self.surface, u, v);
        }
    }

    /// Writes a normal for each pair `[u, v]` of the parameters: `S_u × S_v`, of any length; the normal that the surface itself gives
    /// where the two are parallel up to rounding, overflow or are almost too small to be multiplied; the zero vector where it
    /// gives none.
    ///
    /// # Panics
    ///
    /// When there are not as many places as parameters: a caller's bug.
    pub fn normals(&self, parameters: &[[P::Scalar; 2]], normals: &mut [P]) {
        assert_list_fits(parameters.len(), normals.len());
        let mut tangents = [[P::origin(); 2]; GROUP];
        let mut noise = [[P::Scalar::zero(); 2]; GROUP];
        for (parameters, normals) in parameters.chunks(GROUP).zip(normals.chunks_mut(GROUP)) {
            let tangents = &mut tangents[..parameters.len()];
            let noise = &mut noise[..parameters.len()];
            match &self.kernel {
                Some(kernel) => kernel.tangents(parameters, tangents, noise),
                None => tangents.fill([P::origin(); 2]),
            }
            let tangents = tangents.iter().zip(noise);
            for ((&[u, v], (tangents, noise)), normal) in
                parameters.iter().zip(tangents).zip(normals)
            {
                let plain = plain_normal(tangents, *noise);
                *normal = plain.unwrap_or_else(|| self.careful_normal(u, v));
            }
        }
    }

    /// The normal that the surface gives; the zero vector where it gives none.
    #[cold]
    fn careful_normal(&self, u: P::Scalar, v: P::Scalar) -> P {
        let normal = self.surface.normal_vector(u, v);
        normal.unwrap_or_else(P::origin)
    }

    /// Writes the points on the grid of all pairs of `us` and `vs` to `points[row * us.len() + column]`, for `u = us[column]` and
    /// `v = vs[row]`; the same bits as [`SurfaceEvaluator::points`] gives. It is at its best where many neighbours in `us` lie in the same
    /// span.
    ///
    /// # Panics
    ///
    /// When there is not one place for each pair: a caller's bug.
    pub fn points_on_grid(&self, us: &[P::Scalar], vs: &[P::Scalar], points: &mut [P]) {
        assert_grid_fits(us.len(), vs.len(), points.len());
        match &self.kernel {
            Some(kernel) if !us.is_empty() => kernel.points_on_grid(us, vs, points),
            _ => self.surface.points_on_grid(us, vs, points),
        }
    }

    /// Writes `[S, S_u, S_v]` on a grid, in the order of [`SurfaceEvaluator::points_on_grid`]; the same bits as
    /// [`SurfaceEvaluator::partials`] gives.
    ///
    /// # Panics
    ///
    /// When there is not one place for each pair: a caller's bug.
    pub fn partials_on_grid(&self, us: &[P::Scalar], vs: &[P::Scalar], partials: &mut [[P; 3]]) {
        assert_grid_fits(us.len(), vs.len(), partials.len());
        if us.is_empty() {
            return;
        }
        if let Some(kernel) = &self.kernel {
            return kernel.partials_on_grid(us, vs, partials);
        }
        for (row, &v) in partials.chunks_exact_mut(us.len()).zip(vs) {
            for (partials, &u) in row.iter_mut().zip(us) {
                *partials = point_and_partials(&self.surface, u, v);
            }
        }
    }
}

/// So many normals are made from tangents on the stack.
const GROUP: usize = 64;

/// `S_u × S_v` where its direction is sure without more ado: a coordinate of the product is wrong by at most `4u` of the product of
/// the largest coordinates, by its own three operations, and by twice what the rounding of each tangent may change; a normal must have one
/// that is twice as large. Four times that product must be finite, for twice it bounds the coordinates; and so large that `u²` of it is
/// not zero, for denormal numbers to be below all rounding.
#[inline]
fn plain_normal<P: Vector3>([s_u, s_v]: &[P; 2], noise: [P::Scalar; 2]) -> Option<P> {
    let [size_u, size_v] = [largest(*s_u), largest(*s_v)];
    let product = size_u * size_v;
    let roundoff = P::Scalar::unit_roundoff();
    let [four, eight] = [4, 8].map(P::Scalar::from_i32);
    let by_noise = four * (noise[0] * (size_v + noise[1]) + noise[1] * size_u);
    let normal = s_u.cross(*s_v);
    let is_sure = largest(normal) > eight * roundoff * product + by_noise
        && product * roundoff * roundoff > P::Scalar::zero()
        && Scalar::is_finite(four * product);
    is_sure.then_some(normal)
}

/// The largest absolute value of a coordinate; NaN where one is NaN.
#[inline]
fn largest<P: Vector3>(vector: P) -> P::Scalar {
    let [x, y, z] = [0, 1, 2].map(|axis| vector.coordinate(axis).magnitude());
    larger(larger(x, y), z)
}

/// `[S, S_u, S_v]` by the surface's own functions.
fn point_and_partials<P: Vector3>(
    surface: &BsplineSurface<P>,
    u: P::Scalar,
    v: P::Scalar,
) -> [P; 3] {
    let tangents = [[1, 0], [0, 1]].map(|orders| surface.derivative_at(orders, u, v));
    [surface.point(u, v), tangents[0], tangents[1]]
}

/// The kernel for the degrees of the surface, where there is one.
fn kernel_for<P>(surface: &BsplineSurface<P>) -> Option<Arc<dyn Kernel<P>>>
where
    P: Vector3,
    P::Scalar: AsPrimitive<u8>,
{
    macro_rules! kernel {
        ($p:literal, $q:literal) => {
            FixedDegrees::<P::Scalar, { $p + 1 }, { $q + 1 }, $p, $q>::new(surface)
                .map(|kernel| Arc::new(kernel) as Arc<dyn Kernel<P>>)
        };
    }
    let degree = |direction| surface.knots(direction).degree();
    match [degree(Direction::U), degree(Direction::V)] {
        [1, 1] => kernel!(1, 1),
        [1, 2] => kernel!(1, 2),
        [1, 3] => kernel!(1, 3),
        [2, 1] => kernel!(2, 1),
        [2, 2] => kernel!(2, 2),
        [2, 3] => kernel!(2, 3),
        [3, 1] => kernel!(3, 1),
        [3, 2] => kernel!(3, 2),
        [3, 3] => kernel!(3, 3),
        _ => None,
    }
}

/// Panics with the two lengths when a buffer has not one place for each pair of parameters.
fn assert_list_fits(parameters: usize, places: usize) {
    assert!(
        parameters == places,
        "{parameters} pairs of parameters need as many places, not {places}"
    );
}
