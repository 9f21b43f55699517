//! What the control points of a surface do: maps, hulls, local control, isoparametric curves.

use facette::algebra::{Vector3, VectorSpace};
use facette::bspline::{Direction, surface_point};
use facette::curve::Curve;
use num_traits::One;

use crate::common::exact::{Exact, fraction};
use crate::common::generators::point;
use crate::common::law::{Law, expect_equal};
use crate::divided_differences::{all_values, weighted_sum};
use crate::inputs::{Knots, Point, SurfaceCase, expect, hard_surfaces, surfaces};
use crate::suspects;

/// The point by the function under test.
fn point_at(case: &SurfaceCase, u: Exact, v: Exact) -> Point {
    surface_point(&case.surface(), u, v)
}

/// **Affine invariance.** Mapping the control points by an affine map maps the surface: translations, rotations, scalings and shears may be applied to the net.
///
/// Course: B15, slide 24, properties of the surface: affine invariance.
/// Exercise: surface.
#[test]
fn surface_is_affinely_invariant() {
    let maps = || [point(), point(), point(), point()];
    let law = Law::new("bspline::surface_is_affinely_invariant", suspects::surface);
    law.holds(
        (surfaces(), maps()),
        (hard_surfaces(), maps()),
        |(case, [x, y, z, shift])| {
            let map =
                |[px, py, pz]: Point| Point::combination([px, py, pz], [*x, *y, *z]).plus(*shift);
            let [u, v] = case.at;
            expect_equal(
                &map(point_at(case, u, v)),
                &point_at(&case.mapped(map), u, v),
            )
        },
    );
}

/// **Convex hull.** For $(u,v)$ on the rectangle $[u_{i_0},u_{i_0+1})\times[v_{j_0},v_{j_0+1})$ of the domain, $S(u,v)$ lies in the convex hull of the $(p+1)(q+1)$ points $P_{ij}$ with
/// $i_0-p\le i\le i_0$ and $j_0-q\le j\le j_0$; so the whole surface lies in the hull of its net. The box that `span_box` gives for the rectangle holds the point too.
///
/// Course: B15, slide 24, properties of the surface: convex hull, global and local.
/// Exercise: surface.
#[test]
fn surface_lies_in_the_convex_hull_of_the_points_of_its_rectangle() {
    let law = Law::new(
        "bspline::surface_lies_in_the_convex_hull_of_the_points_of_its_rectangle",
        suspects::surface,
    );
    law.holds(
        (surfaces(), point()),
        (hard_surfaces(), point()),
        |(case, direction)| {
            let height = |p: Point| p.dot(*direction);
            let [u, v] = case.at;
            let [i0, j0] = [case.knots[0].span_of(u), case.knots[1].span_of(v)];
            let [p, q] = case.knots.each_ref().map(|knots| knots.degree);
            let indices = (j0 - q..=j0).flat_map(|j| (i0 - p..=i0).map(move |i| (i, j)));
            let heights: Vec<_> = indices
                .map(|(i, j)| height(case.control_point(i, j)))
                .collect();
            let reached = point_at(case, u, v);
            let is_between = heights.iter().any(|&h| h <= height(reached))
                && heights.iter().any(|&h| h >= height(reached));
            expect(
                "a height between those of the rectangle's points",
                is_between,
                (reached, heights),
            )?;
            let [low, high] = case.surface().span_box([i0, j0]);
            let is_inside =
                (0..3).all(|axis| low[axis] <= reached[axis] && reached[axis] <= high[axis]);
            expect(
                "a point of the box of the rectangle",
                is_inside,
                (reached, low, high),
            )
        },
    );
}

/// **Local control.** Moving $P_{ij}$ moves the surface over $(u_i,u_{i+p+1})\times(v_j,v_{j+q+1})$, everywhere inside, and nowhere else: these are at most $(p+1)(q+1)$ rectangles. The point
/// moves by $N_i^p(u)\,N_j^q(v)$ times the control point's way.
///
/// Course: B15, slide 24, properties of the surface: local control.
/// Exercise: surface.
#[test]
fn moving_a_control_point_moves_exactly_its_rectangles() {
    let name = "bspline::moving_a_control_point_moves_exactly_its_rectangles";
    let which = || (0..400_usize, 0..400_usize);
    Law::new(name, suspects::surface).holds(
        (surfaces(), which()),
        (hard_surfaces(), which()),
        |(case, which)| {
            let [i, j] = [
                which.0 % case.knots[0].count(),
                which.1 % case.knots[1].count(),
            ];
            let by = [Exact::one(), fraction(-2, 1), fraction(1, 3)];
            let surface = case.surface();
            let moved = surface
                .clone()
                .with_control_point(i, j, case.control_point(i, j).plus(by));
            let moved = moved.expect("a finite point");
            let way = |[u, v]: [Exact; 2]| {
                surface_point(&moved, u, v).minus(surface_point(&surface, u, v))
            };
            let [u, v] = case.at;
            let weight = all_values(&case.knots[0], u)[i] * all_values(&case.knots[1], v)[j];
            expect_equal(&by.times(weight), &way(case.at))?;
            let support = surface.support_of(i, j);
            let middle = |knots: &Knots, span: usize| {
                knots.knots[span].lerp(knots.knots[span + 1], fraction(2, 5))
            };
            for span_u in case.knots[0].spans() {
                for span_v in case.knots[1].spans() {
                    let inside = [
                        middle(&case.knots[0], span_u),
                        middle(&case.knots[1], span_v),
                    ];
                    let is_held =
                        (0..2).all(|d| support[d][0] < inside[d] && inside[d] < support[d][1]);
                    let is_listed = (i..=i + case.knots[0].degree).contains(&span_u)
                        && (j..=j + case.knots[1].degree).contains(&span_v);
                    expect_equal(&[is_listed; 2], &[is_held, way(inside) != Point::origin()])?;
                }
            }
            Ok(())
        },
    );
}

/// **Isoparametric curves.** The curve $v\mapsto S(u_0,v)$ is the B-spline of degree $q$ over $V$ with the control points $Q_j(u_0)=\sum_iN_i^p(u_0)\,P_{ij}$, and $u\mapsto S(u,v_0)$ the one of degree $p$ over
/// $U$ with $Q_i(v_0)=\sum_jN_j^q(v_0)\,P_{ij}$.
///
/// Course: B17, slide 25, isoparametric curves.
/// Exercise: surface.
#[test]
fn isoparametric_curves_are_bsplines() {
    let law = Law::new(
        "bspline::isoparametric_curves_are_bsplines",
        suspects::surface,
    );
    law.holds(surfaces(), hard_surfaces(), |case| {
        let [u, v] = case.at;
        let [n, m] = case.knots.each_ref().map(Knots::count);
        let [in_u, in_v] = [all_values(&case.knots[0], u), all_values(&case.knots[1], v)];
        let rows = (0..m).map(|j| (0..n).map(|i| case.control_point(i, j)).collect::<Vec<_>>());
        let columns = (0..n).map(|i| (0..m).map(|j| case.control_point(i, j)).collect::<Vec<_>>());
        let along_v: Vec<_> = rows.map(|row| weighted_sum(&in_u, &row)).collect();
        let along_u: Vec<_> = columns.map(|column| weighted_sum(&in_v, &column)).collect();
        let surface = case.surface();
        let [at_u, at_v] = [surface.curve_at_u(u), surface.curve_at_v(v)];
        expect_equal(&&along_v[..], &at_u.control_points())?;
        expect_equal(&&along_u[..], &at_v.control_points())?;
        expect_equal(
            &[at_u.knots(), at_v.knots()],
            &[surface.knots(Direction::V), surface.knots(Direction::U)],
        )?;
        expect_equal(&[point_at(case, u, v); 2], &[at_u.point(v), at_v.point(u)])
    });
}
