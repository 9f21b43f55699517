//! The theorems of exact evaluation: over exact numbers, against the schemes as they run and against splines.

use facette::algebra::{Scalar, VectorSpace};
use facette::bspline::{BsplineSurface, KnotVector};
use facette::mesh::Mesh;
use facette::subdivision::Corners;
use facette::subdivision::evaluate::{CatmullClarkSurface, Derivatives, LoopSurface};
use facette::subdivision::limit::{catmull_clark_limit_positions, loop_limits_with};
use facette::subdivision::mask::loop_vertex_weight;
use num_traits::{One, Zero};
use proptest::prelude::*;

use crate::common::dual::{Dual, constant, variable};
use crate::common::exact::{Exact, fraction};
use crate::common::generators::{hard_parameter, parameter, point};
use crate::common::law::{Law, Verdict, expect_equal};
use crate::limit_inputs::joined;
use crate::meshes::{
    hard_meshes, hard_topologies, hard_triangle_meshes, meshes, topologies, triangle_meshes,
    triangle_torus,
};
use crate::steps::{Scheme, corner_rules, rational_cosine};
use crate::suspects;

type Point = [Exact; 3];

/// The Catmull-Clark surface of a mesh.
fn quadrilaterals<P: VectorSpace>(mesh: &Mesh<P>, corners: Corners) -> CatmullClarkSurface<P> {
    CatmullClarkSurface::new(&joined(mesh), &mesh.positions, corners).expect("finite points")
}

fn rational_weight(n: usize) -> Exact {
    loop_vertex_weight(rational_cosine(1, n))
}

/// Loop's surface of a mesh, with rational cosines in the place of the others.
fn triangles(mesh: &Mesh<Point>, corners: Corners) -> LoopSurface<Point> {
    let surface =
        LoopSurface::with_weights(&joined(mesh), &mesh.positions, corners, rational_weight);
    surface.expect("finite points")
}

/// Parameters of a quadrilateral from those of its corner, as the pages have them.
fn out_of_corner<S: Scalar>(corner: usize, [s, t]: [S; 2]) -> [S; 2] {
    let half = |parameter: S| parameter * S::ratio(1, 2);
    let [far_s, far_t] = [s, t].map(|parameter| S::one() - half(parameter));
    match corner {
        0 => [half(s), half(t)],
        1 => [far_t, half(s)],
        2 => [far_s, far_t],
        _ => [half(t), far_s],
    }
}

/// **A point of the surface is the limit of a vertex.** Refine a mesh twice with Catmull-Clark, and take the limit of every vertex by its mask: it is the point of the surface of the *control mesh* at the vertex' parameters. That holds for
/// faces of any number of corners, with any vertices, on boundaries and in corners, sharp or smooth; over exact numbers there is no difference at all.
///
/// Course: D23, slides 75-76, Catmull-Clark: what the vertices become.
#[test]
fn evaluation_meets_the_limits_of_refined_vertices() {
    let law = Law::new(
        "subdivision::evaluation_meets_the_limits_of_refined_vertices",
        suspects::library,
    );
    law.on_cases(24).holds(
        (meshes(), corner_rules()),
        (hard_meshes(), corner_rules()),
        |(cage, corners)| {
            let surface = quadrilaterals(&cage.mesh, *corners);
            let step = |mesh: &Mesh<Point>| Scheme::CatmullClark.step(mesh, 0, *corners);
            let fine = step(&step(&cage.mesh));
            let limits = catmull_clark_limit_positions(&joined(&fine), &fine.positions, *corners);
            let limits = limits.expect("a point for each vertex");
            let places = [[0, 0], [1, 0], [1, 1], [0, 1]];
            // Of the four faces that a corner becomes, one, and another for each corner.
            for (half_edge, faces) in (0..).zip(fine.faces().collect::<Vec<_>>().chunks(4)) {
                let child = half_edge as usize % 4;
                for (vertex, place) in faces[child].iter().zip(places) {
                    let [s, t] = out_of_corner(child, place.map(Exact::from_i32));
                    let point = surface.corner_point(half_edge, s, t);
                    expect_equal(&Ok(limits[*vertex as usize]), &point)?;
                }
            }
            Ok(())
        },
    );
}

/// The barycentric parameters of the vertices of the four faces that a triangle becomes.
fn children<S: Scalar>([a, b, c]: [[S; 3]; 3]) -> [[[S; 3]; 3]; 4] {
    let middle = |a: [S; 3], b: [S; 3]| a.lerp(b, S::ratio(1, 2));
    let [ab, bc, ca] = [middle(a, b), middle(b, c), middle(c, a)];
    [[a, ab, ca], [b, bc, ab], [c, ca, bc], [ab, bc, ca]]
}

fn whole_triangle<S: Scalar>() -> [[S; 3]; 3] {
    [[1, 0, 0], [0, 1, 0], [0, 0, 1]].map(|place| place.map(S::from_i32))
}

/// **The same for Loop.** The limit of every vertex of the mesh after two steps is the point of the control mesh's surface at its barycentric parameters, with any vertices, boundaries and corners.
///
/// Course: D24, slide 77, Loop: what the vertices become.
#[test]
fn evaluation_meets_the_limits_of_loops_refined_vertices() {
    let law = Law::new(
        "subdivision::evaluation_meets_the_limits_of_loops_refined_vertices",
        suspects::library,
    );
    law.on_cases(24).holds(
        (triangle_meshes(), corner_rules()),
        (hard_triangle_meshes(), corner_rules()),
        |(cage, corners)| {
            let surface = triangles(&cage.mesh, *corners);
            let step = |mesh: &Mesh<Point>| {
                let fine = Scheme::Loop.step_with(mesh, 0, *corners, rational_cosine);
                fine.expect("a mesh of triangles")
            };
            let fine = step(&step(&cage.mesh));
            let circle = |k, n| [rational_cosine(k, n), Exact::one()];
            let limits = loop_limits_with(&joined(&fine), &fine.positions, *corners, circle);
            let limits = limits.expect("a point for each vertex");
            for (face, faces) in (0..).zip(fine.faces().collect::<Vec<_>>().chunks(16)) {
                let child = face as usize % 4;
                let places = children(children(whole_triangle())[child]);
                for (vertices, places) in faces[4 * child..].iter().zip(places) {
                    for (vertex, place) in vertices.iter().zip(places) {
                        let limit = limits[*vertex as usize].position;
                        expect_equal(&Ok(limit), &surface.point(face, place))?;
                    }
                }
            }
            Ok(())
        },
    );
}

/// **A step does not change the surface.** The surface of a mesh and that of the mesh after a step of Catmull-Clark are one: face $h$ of the refined mesh at $(s,t)$ has the point of the corner at half-edge $h$ at $(s,t)$. Loop's face $4f+c$ has that of
/// face $f$ at the parameters of its own four parts.
///
/// Course: D24, slides 76-77, Catmull-Clark and Loop: the limit surface.
#[test]
fn surface_of_the_refined_mesh_is_the_same() {
    let law = Law::new(
        "subdivision::surface_of_the_refined_mesh_is_the_same",
        suspects::library,
    );
    let places = || (parameter(), parameter(), corner_rules());
    let hard = || {
        let [s, t] = [fraction(1, 1 << 5), fraction(1, 1 << 6)];
        (Just(s), Just(t), corner_rules())
    };
    law.on_cases(24).holds(
        (meshes(), triangle_meshes(), places()),
        (hard_meshes(), hard_triangle_meshes(), hard()),
        |(cage, triangular, (s, t, corners))| {
            let before = quadrilaterals(&cage.mesh, *corners);
            let fine = Scheme::CatmullClark.step(&cage.mesh, 0, *corners);
            let after = quadrilaterals(&fine, *corners);
            for half_edge in (0..).take(fine.face_count()).step_by(3) {
                let point = before.corner_point(half_edge, *s, *t);
                expect_equal(&point, &after.point(half_edge, *s, *t))?;
            }
            let before = triangles(&triangular.mesh, *corners);
            let fine = Scheme::Loop.step_with(&triangular.mesh, 0, *corners, rational_cosine);
            let fine = fine.expect("a mesh of triangles");
            let after = triangles(&fine, *corners);
            let sum = *s + *t + Exact::one();
            let inner = [Exact::one() / sum, *s / sum, *t / sum];
            for face in (0..).take(triangular.mesh.face_count()) {
                let part = face % 4;
                let corners = children(whole_triangle())[part as usize];
                let place = <[Exact; 3]>::combination(inner, corners);
                let point = before.point(face, place);
                expect_equal(&point, &after.point(4 * face + part, inner))?;
            }
            Ok(())
        },
    );
}

/// A net of points, and parameters.
type Net = (Vec<Point>, [Exact; 2]);

fn nets() -> impl Strategy<Value = Net> {
    let points = proptest::collection::vec(point(), 25);
    (points, [parameter(), parameter()])
}

fn hard_nets() -> impl Strategy<Value = Net> {
    let points = proptest::collection::vec(point(), 25);
    let ends = prop::sample::select(vec![fraction(0, 1), fraction(1, 1), fraction(1, 1 << 30)]);
    (points, [ends.clone(), ends])
}

/// **On a grid it is the B-spline.** A quadrilateral whose vertices all have valence 4 carries a patch of the uniform bicubic B-spline, and the surface has its points and its derivatives of first and second order.
///
/// Course: D22, slides 72-76, Catmull-Clark: bicubic B-splines.
#[test]
fn evaluation_on_a_grid_is_the_bspline() {
    let law = Law::new(
        "subdivision::evaluation_on_a_grid_is_the_bspline",
        suspects::library,
    );
    law.holds(nets(), hard_nets(), |(points, [u, v])| {
        let mesh = crate::meshes::grid(4, 4).with_points(points.clone());
        let surface = quadrilaterals(&mesh, Corners::Sharp);
        let knots = || KnotVector::uniform(3, 5).expect("enough points");
        let spline = BsplineSurface::new([knots(), knots()], points.clone()).expect("a net");
        let [start, end] = spline.knots(facette::bspline::Direction::U).domain();
        let width = (end - start) * Exact::ratio(1, 2);
        // Faces 5, 6, 9 and 10 are those in the middle; at the end of a span the next one begins.
        for (face, i, j) in [(5, 0, 0), (6, 1, 0), (9, 0, 1), (10, 1, 1)] {
            let place = |index, parameter| start + width * (Exact::from_i32(index) + parameter);
            let (s, t) = (place(i, *u), place(j, *v));
            let scaled = |orders: [usize; 2]| {
                let order = orders[0] + orders[1];
                let point = spline.derivative_at(orders, s, t);
                (0..order).fold(point, |point, _| point.times(width))
            };
            let expected = Derivatives {
                point: scaled([0, 0]),
                first: [[1, 0], [0, 1]].map(scaled),
                second: [[2, 0], [1, 1], [0, 2]].map(scaled),
            };
            expect_equal(&Ok(expected), &surface.derivatives(face, *u, *v))?;
        }
        Ok(())
    });
}

/// **Regular triangles join as the box spline does.** Where all vertices have valence 6, neighbouring triangles of Loop's surface have the same points, first and second derivatives along their common side: the surface is twice differentiable, of degree 4.
///
/// Course: D24, slide 77, Loop: twice differentiable where the valence is 6.
#[test]
fn regular_triangles_join_with_two_derivatives() {
    let law = Law::new(
        "subdivision::regular_triangles_join_with_two_derivatives",
        suspects::library,
    );
    let inputs = |nets| (nets, Just(()));
    law.holds(
        inputs(nets().boxed()),
        inputs(hard_nets().boxed()),
        |((points, [t, _]), ())| {
            let topology = triangle_torus(5, 5);
            let surface = triangles(&topology.with_points(points.clone()), Corners::Sharp);
            let (zero, rest) = (Exact::zero(), Exact::one() - *t);
            for face in [0, 16, 36] {
                // Side by side along the diagonal: (q0, q1, q2) and (q0, q2, q3).
                let below = surface.derivatives(face, [rest, zero, *t]);
                let above = surface.derivatives(face + 1, [rest, *t, zero]);
                let (below, above) = (below.expect("regular"), above.expect("regular"));
                // In x along the first side and y across: (x, y) = (u + v, v), and (u, u + v).
                let in_plane = |jet: &Derivatives<Point>, [x, y]: [[i32; 2]; 2]| {
                    let [s_u, s_v] = jet.first;
                    let [s_uu, s_uv, s_vv] = jet.second;
                    let of = |weights: [i32; 2]| {
                        <Point>::combination(weights.map(Exact::from_i32), [s_u, s_v])
                    };
                    let second = |[a, b]: [i32; 2], [c, d]: [i32; 2]| {
                        let weights = [a * c, a * d + b * c, b * d].map(Exact::from_i32);
                        <Point>::combination(weights, [s_uu, s_uv, s_vv])
                    };
                    let all = [of(x), of(y), second(x, x), second(x, y), second(y, y)];
                    (jet.point, all)
                };
                let expected = in_plane(&below, [[1, 0], [-1, 1]]);
                expect_equal(&expected, &in_plane(&above, [[1, -1], [0, 1]]))?;
            }
            Ok(())
        },
    );
}

/// **The weights are a mean.** What each control point weighs in a point of the surface, its basis function, is found by evaluating with that point 1 and all others 0. The weights of all points sum to 1, so the surface moves with every affine map of its points; and none is
/// negative, so it lies in their convex hull. (For negative weights there must be a vertex with two faces only, whose mask has $n-3<0$.)
///
/// Course: D24, slides 73-78, masks: the new points are barycentres.
#[test]
fn basis_of_evaluation_is_a_mean() {
    let law = Law::new(
        "subdivision::basis_of_evaluation_is_a_mean",
        suspects::library,
    );
    let places = || (parameter(), parameter(), corner_rules());
    let hard = || (hard_parameter(), hard_parameter(), corner_rules());
    law.on_cases(32).holds(
        (topologies(), places()),
        (hard_topologies(), hard()),
        |(topology, (s, t, corners))| {
            let connectivity = topology.connectivity();
            let vertices = 0..topology.vertex_count;
            let has_pairs = (0..).take(topology.vertex_count).any(|vertex| {
                connectivity.valence(vertex) == 2 && !connectivity.is_boundary_vertex(vertex)
            });
            let half_edge = u32::try_from(connectivity.half_edge_count() / 2).unwrap_or(0);
            let mut sum = Exact::zero();
            for vertex in vertices.clone() {
                let mut weights = vec![Exact::zero(); vertices.len()];
                weights[vertex] = Exact::one();
                let surface = CatmullClarkSurface::new(&connectivity, &weights, *corners);
                let surface = surface.expect("finite points");
                let weight = surface.corner_point(half_edge, *s, *t);
                let weight = weight.expect("there is such a half-edge");
                if weight < Exact::zero() && !has_pairs {
                    return expect_equal(&"no negative weight", &"a negative one");
                }
                sum = sum + weight;
            }
            expect_equal(&Exact::one(), &sum)
        },
    );
}

/// Derivatives by running the evaluation itself over dual numbers, once and twice.
fn by_dual_numbers(
    mesh: &Mesh<Point>,
    half_edge: u32,
    [s, t]: [Exact; 2],
    corners: Corners,
) -> [Point; 5] {
    let lifted = mesh.positions.iter();
    let points = lifted.map(|point| point.map(|x| constant(constant(x))));
    let mesh = Mesh::new(points.collect(), mesh.faces()).expect("as before");
    let surface = quadrilaterals::<[Dual<Dual<Exact>>; 3]>(&mesh, corners);
    let at = |outer: [bool; 2], inner: [bool; 2]| {
        let lift = |value, in_outer: bool, in_inner: bool| {
            let value = if in_inner {
                variable(value)
            } else {
                constant(value)
            };
            let slope = if in_outer { One::one() } else { Zero::zero() };
            Dual { value, slope }
        };
        let [u, v] = [lift(s, outer[0], inner[0]), lift(t, outer[1], inner[1])];
        surface.corner_point(half_edge, u, v).expect("a half-edge")
    };
    let [in_s, in_t] = [[true, false], [false, true]];
    let second = |a, b| at(a, b).map(|coordinate| coordinate.slope.slope);
    let first = |a| at(a, [false; 2]).map(|coordinate| coordinate.slope.value);
    [
        first(in_s),
        first(in_t),
        second(in_s, in_s),
        second(in_s, in_t),
        second(in_t, in_t),
    ]
}

fn expect_derivatives(
    mesh: &Mesh<Point>,
    half_edge: u32,
    [s, t]: [Exact; 2],
    corners: Corners,
) -> Verdict {
    let derivatives = quadrilaterals(mesh, corners).corner_derivatives(half_edge, s, t);
    let Derivatives { first, second, .. } = derivatives.expect("not at a vertex");
    let [s_u, s_v] = first;
    let [s_uu, s_uv, s_vv] = second;
    let expected = by_dual_numbers(mesh, half_edge, [s, t], corners);
    expect_equal(&expected, &[s_u, s_v, s_uu, s_uv, s_vv])
}

/// **The derivatives are derivatives.** Run over dual numbers, the evaluation differentiates itself; that gives the same first and second derivatives as the formulas, without any difference, next to an extraordinary vertex too: steps, chain rule and scales are right.
///
/// Course: D23, slide 76, Catmull-Clark: how smooth the surface is.
#[test]
fn derivatives_are_those_of_dual_numbers() {
    let law = Law::new(
        "subdivision::derivatives_are_those_of_dual_numbers",
        suspects::library,
    );
    let inside = (1..12_i32).prop_map(|numerator| fraction(numerator, 12));
    let near = prop::sample::select(vec![fraction(1, 1000), fraction(1, 1 << 9)]);
    law.on_cases(16).holds(
        (meshes(), [inside.clone(), inside], corner_rules()),
        (hard_meshes(), [near.clone(), near], corner_rules()),
        |(cage, place, corners)| {
            let count = cage.connectivity().half_edge_count();
            let half_edge = u32::try_from(count / 2).unwrap_or(0);
            expect_derivatives(&cage.mesh, half_edge, *place, *corners)
        },
    );
}
