//! The theorems of tensor-product surfaces: points, sizes and special cases.

use facette::algebra::{Scalar, VectorSpace};
use facette::bspline::{BsplineError, BsplineSurface, KnotVector, surface_point};
use facette::curve::{BezierCurve, Curve};
use facette::surface::Surface;
use proptest::collection::vec;
use proptest::prelude::*;

use crate::common::dual::{constant, slopes, variable};
use crate::common::exact::{Exact, fraction};
use crate::common::generators::{hard_parameter, parameter, point};
use crate::common::law::{Law, Verdict, expect_equal};
use crate::inputs::{Knots, Point, SurfaceCase, expect, hard_surfaces, surfaces};
use crate::suspects;

/// Tries a law of `surface_point` on ordinary and hard surfaces with a parameter pair of the closed domain.
fn on_surfaces(theorem: &'static str, check: impl Fn(&SurfaceCase) -> Verdict) {
    Law::new(theorem, suspects::surface).holds(surfaces(), hard_surfaces(), check);
}

/// The point by the function under test.
fn point_at(case: &SurfaceCase, u: Exact, v: Exact) -> Point {
    surface_point(&case.surface(), u, v)
}

/// **The double sum.** The five steps (span of $u$, functions of $u$, span of $v$, functions of $v$, combination of $(p+1)(q+1)$ control points) give
/// $S(u,v)=\sum_{i=0}^n\sum_{j=0}^mN_i^p(u)\,N_j^q(v)\,P_{ij}$. The test sums all $(n+1)(m+1)$ terms, with basis functions by divided differences.
///
/// Course: B11, slide 19, computing a point of the surface.
/// Exercise: surface.
#[test]
fn five_steps_give_the_double_sum() {
    on_surfaces("bspline::five_steps_give_the_double_sum", |case| {
        let [u, v] = case.at;
        expect_equal(&case.expected(), &point_at(case, u, v))
    });
}

/// **How many of each.** $n+1$ by $m+1$ control points need $r+1=n+p+2$ knots in $u$ and $s+1=m+q+2$ in $v$: $r=n+p+1$ and $s=m+q+1$. Any other number of control points is refused,
/// with the numbers that would fit.
///
/// Course: B01, slide 13, B-spline surfaces: definition.
#[test]
fn net_of_another_size_is_refused() {
    let cases = || {
        (
            0..=4_usize,
            0..=4_usize,
            1..=4_usize,
            1..=4_usize,
            1..=60_usize,
        )
    };
    let hard = (
        0..=1_usize,
        0..=1_usize,
        1..=2_usize,
        1..=2_usize,
        1..=9_usize,
    );
    let law = Law::new("bspline::net_of_another_size_is_refused", suspects::library);
    law.holds(cases(), hard, |&(p, q, spans_u, spans_v, found)| {
        let [n_plus_1, m_plus_1] = [p + spans_u, q + spans_v];
        let knots = [
            KnotVector::clamped_uniform(p, n_plus_1),
            KnotVector::clamped_uniform(q, m_plus_1),
        ];
        let knots = knots.map(|knots| knots.expect("more control points than the degree"));
        let lengths = knots.each_ref().map(|knots| knots.knots().len());
        expect_equal(&[n_plus_1 + p + 1, m_plus_1 + q + 1], &lengths)?;
        let refused = BsplineSurface::new(knots, vec![Point::origin(); found]).err();
        let wrong = BsplineError::WrongNetSize {
            knots: lengths,
            degrees: [p, q],
            expected: [n_plus_1, m_plus_1],
            found,
        };
        expect_equal(&(found != n_plus_1 * m_plus_1).then_some(wrong), &refused)
    });
}

/// **The knot vectors of the slides.** $U=\{0,0,0,0,\frac14,\frac12,\frac34,1,1,1,1\}$ with $p=3$ carries 7 functions, and $V=\{0,0,0,\frac15,\frac25,\frac35,\frac35,\frac45,1,1,1\}$
/// with $q=2$, where $\frac35$ is double, 8. The two pictured surfaces have nets of $5\times5$ and $9\times9$ control points.
///
/// Course: B02, slide 15, example of shape functions.
/// Course: B10, slide 18, pictured knot vectors.
/// Erratum: the slides give the degree of $V$ as $p=2$; it is the degree in $v$, $q=2$.
#[test]
fn knot_vectors_of_the_slides_have_these_counts() {
    let quarters = Knots::integers(3, &[0, 0, 0, 0, 1, 2, 3, 4, 4, 4, 4]);
    let fifths = Knots::integers(2, &[0, 0, 0, 1, 2, 3, 3, 4, 5, 5, 5]);
    let unit = [fraction(0, 1), fraction(1, 1)];
    let [u, v] =
        [quarters, fifths].map(|knots| knots.vector().reparametrised(unit).expect("a domain"));
    assert_eq!([&u, &v].map(KnotVector::control_point_count), [7, 8]);
    assert_eq!([&u, &v].map(|knots| knots.spans().count()), [4, 5]);
    assert_eq!(v.multiplicity(fraction(3, 5)), 2);
    let pictured = [
        (3, vec![0, 0, 0, 0, 1, 2, 2, 2, 2], 5),
        (2, vec![0, 0, 0, 1, 2, 3, 3, 3], 5),
        (3, vec![0, 0, 0, 0, 1, 2, 3, 4, 5, 6, 6, 6, 6], 9),
        (2, vec![0, 0, 0, 1, 2, 3, 4, 5, 6, 7, 7, 7], 9),
    ];
    for (degree, knots, count) in pictured {
        assert_eq!(
            Knots::integers(degree, &knots)
                .vector()
                .control_point_count(),
            count
        );
    }
}

/// **Corners.** With clamped knots in both directions the surface passes through the corners of its net: $P_{00}$, $P_{n0}$, $P_{0m}$ and $P_{nm}$.
///
/// Course: B14, slide 23, properties of the surface: the corners.
/// Exercise: surface.
#[test]
fn clamped_surface_interpolates_its_four_corners() {
    on_surfaces(
        "bspline::clamped_surface_interpolates_its_four_corners",
        |case| {
            let is_clamped = |knots: &Knots| {
                let [start, end] = knots.domain();
                knots.knots[0] == start && knots.knots[knots.knots.len() - 1] == end
            };
            if !case.knots.iter().all(is_clamped) {
                return Ok(());
            }
            let [us, vs] = case.knots.each_ref().map(Knots::domain);
            let [n, m] = case.knots.each_ref().map(|knots| knots.count() - 1);
            let corners = [[0, 0], [n, 0], [0, m], [n, m]].map(|[i, j]| case.control_point(i, j));
            let got = [[0, 0], [1, 0], [0, 1], [1, 1]]
                .map(|[i, j]: [usize; 2]| point_at(case, us[i], vs[j]));
            expect_equal(&corners, &got)
        },
    );
}

/// **Bézier patches.** Without inner knots, $U=\{0^{p+1},1^{p+1}\}$ and $V=\{0^{q+1},1^{q+1}\}$, the surface is the Bézier patch of its net: the curve in $v$ through the points of the curves in $u$.
///
/// Course: B14, slide 23, properties of the surface: a Bézier patch as a special case.
/// Exercise: surface.
#[test]
fn surface_without_inner_knots_is_the_bezier_patch() {
    let nets =
        || (0..=4_usize, 0..=4_usize).prop_flat_map(|(p, q)| vec(vec(point(), p + 1), q + 1));
    let law = Law::new(
        "bspline::surface_without_inner_knots_is_the_bezier_patch",
        suspects::surface,
    );
    let hard = (nets(), hard_parameter(), hard_parameter());
    law.holds((nets(), parameter(), parameter()), hard, |(rows, u, v)| {
        let bezier = |points: Vec<Point>| BezierCurve::new(points).expect("at least one point");
        let points = rows
            .iter()
            .map(|row| bezier(row.clone()).point(*u))
            .collect();
        let knots = [
            KnotVector::bezier(rows[0].len() - 1),
            KnotVector::bezier(rows.len() - 1),
        ];
        let surface = BsplineSurface::new(knots, rows.concat()).expect("the net is a rectangle");
        expect_equal(&bezier(points).point(*v), &surface_point(&surface, *u, *v))
    });
}

/// **One patch for each rectangle.** On each rectangle of knots the surface is a Bézier patch of its own: those that `bezier_patches` gives are the surface, point by point. Their polynomials
/// are different ones, but not independent: neighbours share what the continuity at the knot between them demands.
///
/// Course: B12, slide 20, one polynomial for each rectangle of knots.
/// Exercise: surface.
#[test]
fn surface_is_a_bezier_patch_on_each_rectangle_of_knots() {
    on_surfaces(
        "bspline::surface_is_a_bezier_patch_on_each_rectangle_of_knots",
        |case| {
            let patches = case.surface().bezier_patches();
            let [in_u, in_v] = case.knots.each_ref().map(Knots::spans);
            expect_equal(&(in_u.len() * in_v.len()), &patches.len())?;
            let [u, v] = case.at;
            let spans = [case.knots[0].span_of(u), case.knots[1].span_of(v)];
            let interval = |direction: usize| {
                [0, 1].map(|end| case.knots[direction].knots[spans[direction] + end])
            };
            let domain = [interval(0), interval(1)];
            let Some(patch) = patches.iter().find(|patch| patch.domain == domain) else {
                return expect("a patch for each rectangle", false, domain);
            };
            let part = |t: Exact, [start, end]: [Exact; 2]| (t - start) / (end - start);
            let rows = patch.control_points.chunks(case.knots[0].degree + 1);
            let bezier =
                |points: &[Point]| BezierCurve::new(points.to_vec()).expect("at least one point");
            let points: Vec<_> = rows
                .map(|row| bezier(row).point(part(u, domain[0])))
                .collect();
            expect_equal(
                &bezier(&points).point(part(v, domain[1])),
                &point_at(case, u, v),
            )
        },
    );
}

/// **Symmetry.** Exchanging $u$ and $v$, that is the knot vectors and the two indices of the control points, changes nothing but the order of the parameters.
///
/// Course: B01, slide 13, B-spline surfaces: definition.
/// Exercise: surface.
#[test]
fn exchanging_u_and_v_exchanges_the_parameters() {
    on_surfaces(
        "bspline::exchanging_u_and_v_exchanges_the_parameters",
        |case| {
            let [u, v] = case.at;
            let [n, m] = case.knots.each_ref().map(Knots::count);
            let [in_u, in_v] = case.knots.clone();
            let points = (0..n)
                .flat_map(|i| (0..m).map(move |j| case.control_point(i, j)))
                .collect();
            let exchanged = SurfaceCase {
                knots: [in_v, in_u],
                points,
                at: [v, u],
            };
            expect_equal(&exchanged.surface(), &case.surface().transposed())?;
            expect_equal(&point_at(case, u, v), &point_at(&exchanged, v, u))
        },
    );
}

/// **A grid of points.** The points on a grid of parameters are those of `surface_point`, one by one.
///
/// Course: B11, slide 19, computing a point of the surface.
/// Exercise: surface.
#[test]
fn grid_gives_the_points_one_by_one() {
    on_surfaces("bspline::grid_gives_the_points_one_by_one", |case| {
        let [us, vs] = case.knots.each_ref().map(|knots| {
            let inner = (0..3).map(|span| knots.parameter(span, fraction(1, 3)));
            inner.chain(knots.domain()).collect::<Vec<_>>()
        });
        let mut points = vec![Point::origin(); us.len() * vs.len()];
        case.surface().points_on_grid(&us, &vs, &mut points);
        let expected = vs
            .iter()
            .flat_map(|&v| us.iter().map(move |&u| point_at(case, u, v)));
        expect_equal(&expected.collect::<Vec<_>>(), &points)
    });
}

/// **Partial derivatives.** $S_u$ and $S_v$ are what dual numbers $u+\varepsilon$ and $v+\varepsilon$ make of the double sum: the derivatives of the functions, times the same control points.
///
/// Course: B08, slide 17, shape functions: continuity.
/// Exercise: surface.
#[test]
fn surface_partials_agree_with_dual_numbers() {
    on_surfaces(
        "bspline::surface_partials_agree_with_dual_numbers",
        |case| {
            let knots = case.knots.each_ref().map(|knots| {
                let duals = knots.knots.iter().map(|&knot| constant(knot)).collect();
                KnotVector::new(knots.degree, duals)
                    .expect("constant knots are as valid as the numbers")
            });
            let points = case
                .points
                .iter()
                .map(|point| point.map(constant))
                .collect();
            let dual = BsplineSurface::new(knots, points).expect("as many points as before");
            let [u, v] = case.at;
            let s_u = slopes(surface_point(&dual, variable(u), constant(v)));
            let s_v = slopes(surface_point(&dual, constant(u), variable(v)));
            expect_equal(&Some([s_u, s_v]), &case.surface().partials(u, v))
        },
    );
}

/// **Degree one.** Over the knots $\{0,0,1,1\}$ in both directions the surface is the bilinear patch of its four corners.
///
/// Course: B14, slide 23, properties of the surface: a Bézier patch as a special case.
/// Exercise: surface.
#[test]
fn lowest_surface_is_the_bilinear_patch() {
    let corners = || [point(), point(), point(), point()];
    let law = Law::new(
        "bspline::lowest_surface_is_the_bilinear_patch",
        suspects::surface,
    );
    let hard = (corners(), hard_parameter(), hard_parameter());
    law.holds(
        (corners(), parameter(), parameter()),
        hard,
        |&([a, b, d, c], u, v)| {
            let knots = [KnotVector::bezier(1), KnotVector::bezier(1)];
            let surface = BsplineSurface::new(knots, vec![a, b, d, c]).expect("four corners");
            let [s, t] = [u, v].map(|parameter| Exact::from_i32(1) - parameter);
            let expected = Point::combination([s * t, u * t, u * v, s * v], [a, b, c, d]);
            expect_equal(&expected, &surface_point(&surface, u, v))
        },
    );
}
