//! Where the mesh is regular, limits are points and partial derivatives of splines.

use facette::algebra::VectorSpace;
use facette::bspline::{BsplineSurface, KnotVector};
use facette::subdivision::limit::doo_sabin_limits_with;
use facette::subdivision::{Connectivity, Corners};
use proptest::prelude::*;

use crate::common::exact::{Exact, fraction};
use crate::common::law::{Law, expect_equal};
use crate::limit_inputs::{circle, joined, limits_with, rational_circle, root_of_nine};
use crate::meshes::{grid, triangle_grid};
use crate::steps::Scheme;
use crate::suspects;

type Point = [Exact; 3];
type Pair = [Point; 2];

/// The surface over the 4 × 4 points of a grid of quadrilaterals.
fn spline(degree: usize, count: usize, points: Vec<Point>) -> BsplineSurface<Point> {
    let knots = || KnotVector::uniform(degree, count).expect("enough control points");
    BsplineSurface::new([knots(), knots()], points).expect("a net of control points")
}

/// The two partial derivatives as directions: along the first neighbour of a vertex and a quarter of a turn further.
fn along(direction: [i32; 2], partials: Pair) -> Pair {
    let of = |[x, y]: [i32; 2]| {
        let [x, y] = [x, y].map(|steps| fraction(steps, 1));
        Point::combination([x, y], partials)
    };
    [of(direction), of([-direction[1], direction[0]])]
}

/// Where the first neighbour of a vertex is, in columns and rows of a grid.
fn first_direction(connectivity: &Connectivity, vertex: u32, columns: i32) -> [i32; 2] {
    let first = connectivity.outgoing(vertex).expect("a face");
    let place = |vertex: u32| {
        let vertex = i32::try_from(vertex).expect("a small mesh");
        [vertex % (columns + 1), vertex / (columns + 1)]
    };
    let ([x, y], [x0, y0]) = (place(connectivity.target(first)), place(vertex));
    [x - x0, y - y0]
}

fn grid_points(count: usize) -> impl Strategy<Value = Vec<Point>> {
    let point = [-9..9_i32, -9..9, -9..9].prop_map(|p| p.map(|c| fraction(c, 1)));
    proptest::collection::vec(point, count)
}

/// **Regular Catmull-Clark is the bicubic B-spline.** It has its partial derivatives too. At a regular vertex, at a regular boundary vertex and at a sharp corner of a single face the limit position is the point of the uniform bicubic B-spline surface, and the tangents are its partial
/// derivatives there. Beyond a boundary the net of the B-spline goes on straight: $P_{-1}=2P_0-P_1$. In the inside the surface is therefore $C^2$.
///
/// Course: D23, slide 76, Catmull-Clark is C2 at regular points.
#[test]
fn regular_limits_of_catmull_clark_are_those_of_the_bspline() {
    let law = Law::new(
        "subdivision::regular_limits_of_catmull_clark_are_those_of_the_bspline",
        suspects::library,
    );
    let flat = Just(vec![[fraction(1, 3); 3]; 9]);
    law.holds(
        grid_points(9),
        prop_oneof![flat, grid_points(9)],
        |points| {
            let mesh = grid(2, 2).with_points(points.clone());
            let limits = limits_with(
                Scheme::CatmullClark,
                &mesh,
                Corners::Sharp,
                circle_or_one,
                root_of_nine,
            );
            let extended = extended(points);
            let surface = spline(3, 5, extended);
            let connectivity = joined(&mesh);
            for (vertex, limit) in (0..).zip(&limits) {
                let place = [vertex % 3, vertex / 3]
                    .map(|k: usize| fraction(i32::try_from(k).expect("small"), 1));
                let [u, v] = place;
                expect_equal(
                    &(vertex, surface_at(&surface, [0, 0], u, v)),
                    &(vertex, limit.position),
                )?;
                let partials = [[1, 0], [0, 1]].map(|order| surface_at(&surface, order, u, v));
                let vertex_number = u32::try_from(vertex).expect("small");
                let direction = first_direction(&connectivity, vertex_number, 2);
                let expected = along(direction, partials);
                expect_equal(&(vertex, Some(expected)), &(vertex, limit.tangents))?;
            }
            Ok(())
        },
    );
}

fn circle_or_one(k: usize, n: usize) -> [Exact; 2] {
    rational_circle(k, n).unwrap_or([fraction(1, 1); 2])
}

/// The 3 × 3 points of a grid and one more on each side, straight on.
fn extended(points: &[Point]) -> Vec<Point> {
    let two = fraction(2, 1);
    let beyond = |row: Vec<Point>| {
        let before = row[0].times(two).minus(row[1]);
        let after = row[2].times(two).minus(row[1]);
        [vec![before], row, vec![after]].concat()
    };
    let rows: Vec<Vec<Point>> = points.chunks(3).map(|row| beyond(row.to_vec())).collect();
    let columns: Vec<Vec<Point>> = (0..5)
        .map(|i| beyond(rows.iter().map(|row| row[i]).collect()))
        .collect();
    (0..25).map(|k| columns[k % 5][k / 5]).collect()
}

fn surface_at(surface: &BsplineSurface<Point>, order: [usize; 2], u: Exact, v: Exact) -> Point {
    surface.derivative_at(order, u, v)
}

/// **Regular Loop is the quartic box spline.** Over the triangles of a lattice with edges $d_1,d_2,d_3=d_1+d_2$ the box spline turns a cubic polynomial $f$ of the lattice points into $f+\frac1{12}\left(\partial_{d_1}^2+\partial_{d_2}^2+\partial_{d_3}^2\right)f$, since each
/// direction is averaged over twice. The limit positions and tangents of Loop's scheme at a regular vertex are those; and since the seven points of a ring may have any values of a cubic, this fixes every weight of the masks. The surface is $C^2$ there.
///
/// Course: D24, slide 77, Loop is C2 at regular points.
#[test]
fn regular_limits_of_loop_are_those_of_the_box_spline() {
    let law = Law::new(
        "subdivision::regular_limits_of_loop_are_those_of_the_box_spline",
        suspects::library,
    );
    let coefficients = || proptest::collection::vec(-5..5_i32, 10);
    let hard = (0..10_usize).prop_map(|k| (0..10).map(|j| i32::from(j == k)).collect());
    law.holds(coefficients(), hard, |coefficients: &Vec<i32>| {
        let powers = (0..4).flat_map(|i| (0..4 - i).map(move |j| [i, j]));
        let terms: Vec<([u32; 2], i32)> = powers.zip(coefficients.iter().copied()).collect();
        // The derivative of the polynomial of this order at a lattice point.
        let f = |[k, l]: [u32; 2], [x, y]: [i32; 2]| {
            let falling = |i: u32, k: u32| {
                (0..k)
                    .map(|m| i.cast_signed() - m.cast_signed())
                    .product::<i32>()
            };
            let power = |x: i32, i: u32, k: u32| {
                if i < k {
                    0
                } else {
                    falling(i, k) * x.pow(i - k)
                }
            };
            let value = terms
                .iter()
                .map(|&([i, j], c)| c * power(x, i, k) * power(y, j, l));
            fraction(value.sum(), 1)
        };
        // ∂₁² + ∂₂² + (∂₁ + ∂₂)² = 2 (∂₁² + ∂₁∂₂ + ∂₂²), over 12.
        let g = |[k, l]: [u32; 2], place| {
            let second = f([k + 2, l], place) + f([k + 1, l + 1], place) + f([k, l + 2], place);
            f([k, l], place) + second / fraction(6, 1)
        };
        let points = (0..9).map(|v| [f([0, 0], [v % 3, v / 3]), fraction(0, 1), fraction(0, 1)]);
        let mesh = triangle_grid(2, 2).with_points(points.collect());
        let limit = limits_with(Scheme::Loop, &mesh, Corners::Sharp, circle_or_one, |x| x)[4];
        let connectivity = joined(&mesh);
        let [x, y] = first_direction(&connectivity, 4, 2);
        let along = |[x, y]: [i32; 2]| {
            fraction(x, 1) * g([1, 0], [1, 1]) + fraction(y, 1) * g([0, 1], [1, 1])
        };
        // A sixth of a turn takes d₁ to d₃, d₃ to d₂, d₂ to −d₁: (x, y) to (x − y, x).
        let next = along([x - y, x]);
        let first = along([x, y]);
        let across = (next + next - first) * fraction(2, 3);
        let got = limit.tangents.map(|tangents| tangents.map(|t| t[0]));
        expect_equal(&g([0, 0], [1, 1]), &limit.position[0])?;
        expect_equal(&Some([first, across]), &got)
    });
}

/// **Regular Doo-Sabin is the biquadratic B-spline.** In the middle of a quadrilateral of a regular mesh the limit is the B-spline's point at a knot, and the tangents are its derivatives along the diagonals of the quadrilateral, by half of them.
///
/// Course: D13, slide 64, Doo-Sabin extends Chaikin to biquadratic B-splines.
#[test]
fn regular_limits_of_doo_sabin_are_those_of_the_bspline() {
    let law = Law::new(
        "subdivision::regular_limits_of_doo_sabin_are_those_of_the_bspline",
        suspects::library,
    );
    let flat = Just(vec![[fraction(1, 3); 3]; 9]);
    law.holds(
        grid_points(9),
        prop_oneof![flat, grid_points(9)],
        |points| {
            let mesh = grid(2, 2).with_points(points.clone());
            let connectivity = joined(&mesh);
            let limits = doo_sabin_limits_with(&connectivity, &mesh.positions, circle);
            let surface = spline(2, 3, points.clone());
            for (face, limit) in (0..).zip(limits.expect("nine points")) {
                let [i, j] = [face % 2, face / 2];
                let [u, v] = [i, j].map(|k: i32| fraction(k, 1));
                expect_equal(&surface_at(&surface, [0, 0], u, v), &limit.position)?;
                let first = connectivity.vertices_of(u32::try_from(face).expect("small"))[0];
                let first = i32::try_from(first).expect("small");
                let half_diagonal = [first % 3 - i, first / 3 - j].map(|k| fraction(2 * k - 1, 2));
                let partials = [[1, 0], [0, 1]].map(|order| surface_at(&surface, order, u, v));
                let [x, y] = half_diagonal;
                let expected =
                    [[x, y], [-y, x]].map(|weights| Point::combination(weights, partials));
                expect_equal(&Some(expected), &limit.tangents)?;
            }
            Ok(())
        },
    );
}
