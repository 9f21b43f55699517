//! Floating point against arbitrary precision: every bound that the chapter states is derived here and tried on many inputs.

use std::cell::Cell;

use facette::bspline::{
    BsplineCurve, Direction, KnotVector, basis_functions, curve_point, de_boor_point, find_span,
    surface_point,
};
use facette::curve::Curve;
use facette::surface::Surface;
use num_traits::ToPrimitive;

use crate::common::law::{Law, Verdict, expect_at_most, expect_equal};
use crate::common::oracle::{Big, big_combination, big_point, largest_error, ulp};
use crate::suspects;
use crate::variants::{self, compensated_de_boor_point};
use float_surfaces::{Float, FloatSurface, exact_basis, float_surfaces, hard_float_surfaces, wide};

pub mod float_surfaces;

/// A bound on an error, with the largest part of it that was used up.
#[derive(Default)]
pub struct Bound {
    used: Cell<f64>,
}

impl Bound {
    /// Passes where `computed` is within `factor · u · size` of `exact`; a bound below all normal numbers counts as the smallest of them.
    pub fn holds<S: Float>(&self, computed: S, exact: &Big, factor: f64, size: f64) -> Verdict {
        let roundoff: f64 = S::unit_roundoff().into();
        let smallest = if roundoff > 1e-10 {
            f64::from(f32::MIN_POSITIVE)
        } else {
            f64::MIN_POSITIVE
        };
        let bound = (factor * roundoff * size).max(smallest);
        let used = largest_error([computed.into()], std::array::from_ref(exact), bound);
        self.used.set(self.used.get().max(used));
        expect_at_most("an error, as a part of its bound,", 1.0, used)
    }

    /// The same for each coordinate of a point.
    pub fn holds_for_point<S: Float>(
        &self,
        computed: [S; 3],
        exact: &[Big; 3],
        factor: f64,
        sizes: [f64; 3],
    ) -> Verdict {
        for axis in 0..3 {
            self.holds(computed[axis], &exact[axis], factor, sizes[axis])?;
        }
        Ok(())
    }

    /// Passes where at least the given part of the bound was used up.
    pub fn is_used_up_to(&self, part: f64) {
        let used = self.used.get();
        println!("largest error seen: {used:.3} of its bound");
        assert!(
            used >= part,
            "the largest error seen is only {used} of its bound"
        );
    }
}

/// **The error of the basis.** For $u$ in its span, each of the $p+1$ values that `basis_functions` computes has a relative error of at most
/// $5p\,\mathbf u$, whatever the knots: repeated, nearly so, far from 0.
///
/// A value of degree $d$ is a sum of two products of a weight and a value of degree $d-1$, all of them non-negative, so that relative errors
/// do not grow in the sum. A weight $(u-a)/(b-a)$ has two rounded differences and a rounded quotient, $3\mathbf u$; the product and the
/// sum round once each. That is $5\mathbf u$ a degree; the terms in $\mathbf u^2$ are far below what the last of these sums leaves unused.
#[test]
fn basis_error_stays_below_its_bound() {
    let bounds = [Bound::default(), Bound::default()];
    let name = "bspline::basis_error_stays_below_its_bound";
    Law::new(name, suspects::basis).holds(float_surfaces(), hard_float_surfaces(), |case| {
        basis_error::<f64>(case, &bounds[0])?;
        basis_error::<f32>(case, &bounds[1])
    });
    for bound in &bounds {
        bound.is_used_up_to(0.05);
    }
}

fn basis_error<S: Float>(case: &FloatSurface, bound: &Bound) -> Verdict {
    let rounded = case.rounded::<S>();
    let knots = rounded.surface.knots(Direction::U);
    let [u, _] = rounded.at;
    let span = find_span(knots, u);
    let degree = knots.degree();
    let mut values = vec![S::zero(); degree + 1];
    basis_functions(knots, span, u, &mut values);
    let exact = exact_basis(knots, u);
    for (index, &value) in values.iter().enumerate() {
        let exact = &exact[span - degree + index];
        let size = exact.to_f64().unwrap_or(0.0);
        bound.holds(value, exact, 5.0 * degree as f64, size)?;
    }
    Ok(())
}

/// **The error of a curve point.** Each coordinate of the sum over the basis is within $(6p+1)\,\mathbf u\cdot M$ of the exact point, and that of
/// de Boor's points within $6p\,\mathbf u\cdot M$; $M$ is the largest absolute value of that coordinate among the $p+1$ control points that count.
///
/// The sum: $5p\,\mathbf u$ for the basis, one $\mathbf u$ for the products, $p\,\mathbf u$ for the additions, on weights that sum to 1. De Boor's points: each of
/// the $p$ levels is a combination of two points with weights that are wrong by $3\mathbf u$ and so sum to 1 up to $3\mathbf u$, with one rounding for the
/// products and one for the sum, $5\mathbf u$; the sixth is for what the weights' errors make of the terms in $\mathbf u^2$.
#[test]
fn curve_error_stays_below_its_bound() {
    let bounds: [Bound; 4] = Default::default();
    let name = "bspline::curve_error_stays_below_its_bound";
    Law::new(name, suspects::curve).holds(float_surfaces(), hard_float_surfaces(), |case| {
        curve_error::<f64>(case, &bounds[0], &bounds[1])?;
        curve_error::<f32>(case, &bounds[2], &bounds[3])
    });
    for bound in &bounds {
        bound.is_used_up_to(0.05);
    }
}

fn curve_error<S: Float>(case: &FloatSurface, by_basis: &Bound, by_points: &Bound) -> Verdict {
    let rounded = case.rounded::<S>();
    let knots = rounded.surface.knots(Direction::U);
    let points = &rounded.surface.control_points()[..knots.control_point_count()];
    let (u, span, degree) = (rounded.at[0], rounded.spans[0], knots.degree());
    let exact = big_combination(&exact_basis(knots, u), &all_exact(points));
    let mut sizes = [0.0_f64; 3];
    for &point in &points[span - degree..=span] {
        sizes = std::array::from_fn(|axis| sizes[axis].max(wide(point)[axis].abs()));
    }
    let levels = degree as f64;
    let computed = curve_point(knots, points, u);
    by_basis.holds_for_point(computed, &exact, 6.0 * levels + 1.0, sizes)?;
    let computed = de_boor_point(knots, points, u);
    by_points.holds_for_point(computed, &exact, 6.0 * levels, sizes)
}

fn all_exact<S: Float>(points: &[[S; 3]]) -> Vec<[Big; 3]> {
    points.iter().map(|&point| big_point(wide(point))).collect()
}

/// **The error of a surface point.** Each coordinate of $S(u,v)$ is within $(6p+6q+2)\,\mathbf u\cdot M$ of the exact point, $M$ the largest absolute value
/// of that coordinate among the $(p+1)(q+1)$ control points that count.
///
/// Each of the two sums adds what the sum of a curve point adds: $6q+1$ for the points $Q_i(v)$, whose coordinates are not larger than $M$ but for
/// rounding, and $6p+1$ for the sum of these.
#[test]
fn surface_error_stays_below_its_bound() {
    let bounds = [Bound::default(), Bound::default()];
    let name = "bspline::surface_error_stays_below_its_bound";
    Law::new(name, suspects::surface).holds(float_surfaces(), hard_float_surfaces(), |case| {
        surface_error::<f64>(case, &bounds[0])?;
        surface_error::<f32>(case, &bounds[1])
    });
    for bound in &bounds {
        bound.is_used_up_to(0.05);
    }
}

fn surface_error<S: Float>(case: &FloatSurface, bound: &Bound) -> Verdict {
    let rounded = case.rounded::<S>();
    let [p, q] = [Direction::U, Direction::V].map(|d| rounded.surface.knots(d).degree() as f64);
    let computed = surface_point(&rounded.surface, rounded.at[0], rounded.at[1]);
    let factor = 6.0 * p + 6.0 * q + 2.0;
    bound.holds_for_point(computed, &rounded.exact_point(), factor, rounded.sizes())
}

/// **The error of a partial derivative.** Each coordinate of $S_u$ is within $(6p+6q)\,\mathbf u\cdot D$ of the exact derivative, $D$ the largest absolute value of
/// that coordinate among the difference quotients $p\,(P_{i+1,j}-P_{ij})/(u_{i+p+1}-u_{i+1})$ that count; and likewise $S_v$. The size of the control points
/// themselves does not enter.
///
/// A quotient rounds four times, in two differences, a quotient and a product. The quotients are then combined as the control points of a surface
/// whose degrees are $p-1$ and $q$, $6(p-1)+6q+2$.
#[test]
fn partial_derivative_error_stays_below_its_bound() {
    let bounds = [Bound::default(), Bound::default()];
    let name = "bspline::partial_derivative_error_stays_below_its_bound";
    Law::new(name, suspects::library).holds(float_surfaces(), hard_float_surfaces(), |case| {
        partial_error::<f64>(case, &bounds[0])?;
        partial_error::<f32>(case, &bounds[1])
    });
    for bound in &bounds {
        bound.is_used_up_to(0.05);
    }
}

fn partial_error<S: Float>(case: &FloatSurface, bound: &Bound) -> Verdict {
    let rounded = case.rounded::<S>();
    let [u, v] = rounded.at;
    let [p, q] = [Direction::U, Direction::V].map(|d| rounded.surface.knots(d).degree() as f64);
    for (direction, orders) in [(Direction::U, [1, 0]), (Direction::V, [0, 1])] {
        let (exact, sizes) = rounded.exact_partial(direction);
        let computed = rounded.surface.derivative_at(orders, u, v);
        bound.holds_for_point(computed, &exact, 6.0 * (p + q), sizes)?;
    }
    Ok(())
}

/// **A grid has the same bits.** Whether a point comes alone or with a grid, where the curve of a row and the basis of a column are computed once,
/// it is the same number to the last bit.
#[test]
fn grid_gives_the_same_bits_as_points() {
    let name = "bspline::grid_gives_the_same_bits_as_points";
    Law::new(name, suspects::library).holds(float_surfaces(), hard_float_surfaces(), |case| {
        grid_is_points::<f64>(case)?;
        grid_is_points::<f32>(case)
    });
}

fn grid_is_points<S: Float>(case: &FloatSurface) -> Verdict {
    let rounded = case.rounded::<S>();
    let [u, v] = rounded.at;
    let [[u0, u1], [v0, v1]] = rounded.surface.domain();
    let (us, vs) = ([u, u1, u0 - S::one(), u], [v0, v, v1 + S::one()]);
    let mut grid = [[S::zero(); 3]; 12];
    rounded.surface.points_on_grid(&us, &vs, &mut grid);
    let points = vs.iter().flat_map(|&v| us.map(|u| (u, v)));
    let points = points.map(|(u, v)| bits(surface_point(&rounded.surface, u, v)));
    expect_equal(&points.collect::<Vec<_>>(), &grid.map(bits).to_vec())
}

/// The bits of a point: equal numbers of opposite signs differ, and NaN is equal to itself.
pub fn bits<S: Float>(point: [S; 3]) -> [u64; 3] {
    wide(point).map(f64::to_bits)
}

/// **Degrees up to 60.** On one span and on seven, the errors of a curve point grow with the degree as their bounds do, $(6p+1)\,\mathbf u\cdot M$ by the basis and
/// $6p\,\mathbf u\cdot M$ by de Boor's points: there is no degree from which on one cannot compute.
#[test]
fn error_grows_with_the_degree_and_no_faster() {
    for degree in [5, 10, 20, 40, 60] {
        for spans in [1, 7] {
            let knots = KnotVector::<f64>::clamped_uniform(degree, degree + spans);
            let knots = knots.expect("more control points than the degree");
            let coordinate = |k: usize| ((k * k * 7 + 3) % 11) as f64 / 11.0 - 0.5;
            let points: Vec<[f64; 1]> = (0..degree + spans).map(|k| [coordinate(k)]).collect();
            let stored: Vec<[Big; 1]> = points.iter().map(|&point| big_point(point)).collect();
            for u in [0.0, 0.1, 0.5, 0.77, 1.0] {
                let exact = big_combination(&exact_basis(&knots, u), &stored);
                let unit = f64::EPSILON / 2.0 * 0.5 * degree as f64;
                let by_basis = largest_error(curve_point(&knots, &points, u), &exact, unit);
                let by_points = largest_error(de_boor_point(&knots, &points, u), &exact, unit);
                assert!(by_basis <= 6.0 + 1.0 / degree as f64, "degree {degree}");
                assert!(by_points <= 6.0, "degree {degree}, u = {u}: {by_points}");
            }
        }
    }
}

/// The curve of the hard case below: near `u = 1/2` its height is `(u − 1/2)³` times 8, and its control points are of size 1.
fn curve_with_a_triple_zero() -> BsplineCurve<[f64; 1]> {
    let knots = KnotVector::clamped(3, &[0.0, 0.375, 0.625, 1.0]).expect("valid knots");
    let blossom = |a: f64, b: f64, c: f64| [8.0 * (a - 0.5) * (b - 0.5) * (c - 0.5)];
    let points = knots.knots()[1..9]
        .windows(3)
        .map(|u| blossom(u[0], u[1], u[2]));
    BsplineCurve::new(knots.clone(), points.collect()).expect("six finite points")
}

/// **Cancellation.** Where a coordinate crosses 0, its error of a few $\mathbf u\cdot M$ is large beside the
/// coordinate itself. The curve with the blossom $8(a-\tfrac12)(b-\tfrac12)(c-\tfrac12)$ is $8(u-\tfrac12)^3$, with control points of size up to 1: at a distance of
/// $2^{-16}$ from the zero, de Boor's points and Bézier pieces have lost at least four decimal digits, the sum over the basis and monomials all of them. With the
/// rounding error of each operation carried along (twice the precision, about fifteen times the price), the result is within one unit in the last place.
#[test]
fn compensated_evaluation_cures_cancellation() {
    let curve = curve_with_a_triple_zero();
    let (knots, points) = (curve.knots(), curve.control_points());
    let mut worst = [0.0_f64; 5];
    for step in 1..=64 {
        let u = 0.5 + f64::from(step) * 2.0_f64.powi(-22) * (1.0 + 2.0_f64.powi(-29));
        let stored: Vec<[Big; 1]> = points.iter().map(|&point| big_point(point)).collect();
        let exact = big_combination(&exact_basis(knots, u), &stored);
        let unit = ulp(exact[0].to_f64().unwrap_or(0.0), f64::EPSILON / 2.0);
        let computed = [
            compensated_de_boor_point(knots, points, u),
            curve.point(u),
            de_boor_point(knots, points, u),
            variants::BezierPieces::new(&curve).point(u, variants::de_casteljau),
            variants::MonomialPieces::new(&curve).point(u),
        ];
        for (worst, computed) in worst.iter_mut().zip(computed) {
            *worst = worst.max(largest_error(computed, &exact, unit));
        }
    }
    println!("errors in units in the last place: {worst:?}");
    assert!(worst[0] <= 1.0, "compensated: {} ulps", worst[0]);
    assert!(worst[1..].iter().all(|&ulps| ulps > 1e4));
}
