//! The theorems of tangents and normals: left eigenvectors of the schemes as they run, and the splines' partial derivatives where the mesh is
//! regular.

use facette::algebra::VectorSpace;
use facette::bspline::{BsplineSurface, KnotVector};
use facette::mesh::Mesh;
use facette::subdivision::limit::{
    Limit, catmull_clark_ring_eigenvalues, doo_sabin_limits, doo_sabin_limits_with,
    loop_ring_eigenvalue,
};
use facette::subdivision::mask::turn_cosine;
use facette::subdivision::{Connectivity, Corners, DooSabinWeights, doo_sabin};
use proptest::prelude::*;

use crate::common::dice::Dice;
use crate::common::exact::{Exact, fraction};
use crate::common::law::{Law, expect_equal};
use crate::limit_inputs::{
    VALENCES, half_fan, joined, limits, limits_with, rational_circle, refined, rounds,
};
use crate::meshes::{Topology, double_fan, grid, polygon, quad_fan, triangle_grid};
use crate::steps::Scheme;
use crate::suspects;

type Point = [Exact; 3];
type Pair = [Point; 2];

/// The square root that regular quadrilaterals need.
fn root_of_nine(square: Exact) -> Exact {
    assert_eq!(square, fraction(9, 1), "the regular ring's only root");
    fraction(3, 1)
}

fn circle(k: usize, n: usize) -> [Exact; 2] {
    rational_circle(k, n).expect("a rational angle")
}

fn steps_with_rational_cosines(scheme: Scheme, mesh: &Mesh<Point>) -> Mesh<Point> {
    (0..rounds(scheme)).fold(mesh.clone(), |mesh, step| {
        // Only vertex 0 is looked at: what weights its neighbours have does not matter.
        let cosine = |k, n| rational_circle(k, n).map_or(fraction(0, 1), |point| point[0]);
        scheme
            .step_with(&mesh, step, Corners::Sharp, cosine)
            .expect("exact points")
    })
}

fn tangents_at_vertex_0(scheme: Scheme, mesh: &Mesh<Point>) -> Pair {
    // Cosines that are wrong stand at other vertices only.
    let circle = |k, n| rational_circle(k, n).unwrap_or([fraction(1, 1); 2]);
    let root = |square| {
        if square == fraction(9, 1) {
            root_of_nine(square)
        } else {
            fraction(1, 1)
        }
    };
    limits_with(scheme, mesh, Corners::Sharp, circle, root)[0]
        .tangents
        .expect("faces around")
}

fn with_random_points(
    topologies: Vec<(Scheme, Topology, [Exact; 2])>,
) -> impl Strategy<Value = (Scheme, Mesh<Point>, [Exact; 2])> {
    prop::sample::select(topologies).prop_flat_map(|(scheme, topology, factors)| {
        proptest::collection::vec([-9..9_i32, -9..9, -9..9], topology.vertex_count).prop_map(
            move |points| {
                let points = points.iter().map(|p| p.map(|c| fraction(c, 1))).collect();
                (scheme, topology.with_points(points), factors)
            },
        )
    })
}

/// **A step shrinks the tangents by their eigenvalues.** At an interior vertex both tangents become $\lambda$ times what they were, so that their plane stays. On a boundary the tangent along it becomes half as long (for $\sqrt3$ a third in two
/// steps), the one across shrinks by the eigenvalue of half a turn. With $\lambda=\frac38+\frac14\cos\frac{2\pi}n$ for Loop this is exact at $n=3,4,6$ and for 2 and 3 triangles on a boundary, for $\sqrt3$ (after two steps) likewise, for Catmull-Clark in the regular cases.
///
/// Course: D24, slide 77, Loop: tangent planes at every vertex.
#[test]
fn tangents_are_eigenvectors_of_a_step() {
    let half = fraction(1, 2);
    let third = fraction(1, 3);
    let loops = |c: i32| loop_ring_eigenvalue(fraction(c, 2));
    let inside = [3, 4, 6].map(|n| {
        (
            Scheme::Loop,
            double_fan(n),
            [loops([-1, 0, 0, 1][n as usize - 3]); 2],
        )
    });
    let mut cages = inside.to_vec();
    cages.push((Scheme::CatmullClark, quad_fan(4), [half; 2]));
    let hard = vec![
        (Scheme::Loop, half_fan(2, false), [half, loops(0)]),
        (Scheme::Loop, half_fan(3, false), [half, loops(1)]),
        (Scheme::Sqrt3, half_fan(2, false), [third, fraction(2, 9)]),
        (Scheme::Sqrt3, half_fan(3, false), [third, third]),
        (Scheme::CatmullClark, half_fan(2, true), [half, half]),
        (Scheme::CatmullClark, half_fan(1, true), [half, half]),
        (Scheme::Loop, half_fan(1, false), [half, half]),
        (Scheme::Sqrt3, half_fan(1, false), [third, third]),
    ];
    let law = Law::new(
        "subdivision::tangents_are_eigenvectors_of_a_step",
        suspects::library,
    );
    law.holds(
        with_random_points(cages),
        with_random_points(hard),
        |(scheme, mesh, [along, across])| {
            let before = tangents_at_vertex_0(*scheme, mesh);
            let after = tangents_at_vertex_0(*scheme, &steps_with_rational_cosines(*scheme, mesh));
            expect_equal(&[before[0].times(*along), before[1].times(*across)], &after)
        },
    );
}

/// **The ring of √3 turns.** One step of $\sqrt3$ at an interior vertex multiplies $t_1+it_2$ by $\lambda=\frac13\left(1+e^{2\pi i/n}\right)=\frac23\cos\frac\pi n\,e^{i\pi/n}$: the tangents shrink, and turn by $\frac\pi n$ in their plane, since the new
/// neighbours are centroids, half a turn of a spoke further. The plane and the normal stay. Exact at $n=3,4,6$, with sines in units of $\sin\frac{2\pi}n$.
///
/// Course: D03, slide 50, √3: its local matrix has complex eigenvalues.
#[test]
fn ring_of_sqrt3_turns_by_half_a_spoke() {
    let law = Law::new(
        "subdivision::ring_of_sqrt3_turns_by_half_a_spoke",
        suspects::library,
    );
    let cages = |valences: &[u32]| {
        let of = |&n: &u32| (Scheme::Sqrt3, double_fan(n), [fraction(0, 1); 2]);
        with_random_points(valences.iter().map(of).collect())
    };
    law.holds(cages(&[4, 6]), cages(&[3]), |(scheme, mesh, _)| {
        let n = joined(mesh).valence(0);
        let [cosine, _] = circle(1, n);
        let one = fraction(1, 1);
        let [t1, t2] = tangents_at_vertex_0(*scheme, mesh);
        let third = fraction(1, 3);
        // In units of the sine, t₂ stands for itself over sin(2π/n).
        let sine_squared = one - cosine * cosine;
        let turned = [
            t1.times(one + cosine)
                .minus(t2.times(sine_squared))
                .times(third),
            t2.times(one + cosine).plus(t1).times(third),
        ];
        let cosine = |k, n| rational_circle(k, n).map_or(fraction(0, 1), |point| point[0]);
        let step = scheme.step_with(mesh, 0, Corners::Sharp, cosine);
        let step = step.expect("exact points");
        expect_equal(&turned, &tangents_at_vertex_0(*scheme, &step))
    });
}

fn random_points(topology: &Topology, seed: u64) -> Mesh<[f64; 3]> {
    let mut dice = Dice::new(seed);
    let points = (0..topology.vertex_count).map(|_| dice.vector()).collect();
    topology.with_points(points)
}

fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.minus(b).largest_coordinate()
}

/// **At every valence.** The tangents are eigenvectors at all valences, inside and on boundaries: $t\mapsto\lambda t$ with
///
/// $$\lambda_{\text{CC}}=\tfrac1{16}\left(5+c+\sqrt{(1+c)(9+c)}\right),\quad\lambda_{\text{Loop}}=\tfrac38+\tfrac14c,\quad|\lambda_{\sqrt3}|=\tfrac23\cos\tfrac\pi n,\qquad c=\cos\tfrac{2\pi}n,$$
///
/// and on a boundary with $k$ faces across the boundary the same with $n=2k$. Points have coordinates up to 1, so differences up to 2. A difference of two new points is off by $8\mathbf u$ at most, a weight by $8\mathbf u$ of it, and the absolute values of the weights that matter sum to $\frac4\pi$ at large $n$, 2 at small:
/// $2(8+16)\mathbf u$ from these, and $12\mathbf u$ from $\lambda$ and the last operations. A sum of $n$ terms adds less than $2n\mathbf u$.
///
/// Course: D24, slide 77, Catmull-Clark and Loop: tangent planes at extraordinary points.
#[test]
fn tangents_are_eigenvectors_at_every_valence() {
    let mut worst = 0.0_f64;
    for n in VALENCES {
        let bound = f64::from(2 * n + 60) * f64::EPSILON / 2.0;
        let c = turn_cosine::<f64>(1, n as usize);
        let [cc, _] = catmull_clark_ring_eigenvalues(c);
        let cases = [
            (Scheme::CatmullClark, quad_fan(n), [cc; 2]),
            (Scheme::Loop, double_fan(n), [loop_ring_eigenvalue(c); 2]),
            (
                Scheme::CatmullClark,
                half_fan(n, true),
                across(Scheme::CatmullClark, n),
            ),
            (Scheme::Loop, half_fan(n, false), across(Scheme::Loop, n)),
            (Scheme::Sqrt3, half_fan(n, false), across(Scheme::Sqrt3, n)),
        ];
        for (scheme, topology, factors) in cases {
            for seed in 0..(400 / u64::from(n)).max(4) {
                let part =
                    eigenvector_error(scheme, &random_points(&topology, seed), factors) / bound;
                assert!(
                    part <= 1.0,
                    "{scheme:?} {n}: a tangent is off by {part} of the bound"
                );
                worst = worst.max(part);
            }
        }
    }
    println!("largest part of the bound: {worst:.3}");
    assert!(worst >= 0.05, "the bound is never used up: {worst}");
}

/// How far the tangents after a step are from multiples of those before.
fn eigenvector_error(scheme: Scheme, mesh: &Mesh<[f64; 3]>, factors: [f64; 2]) -> f64 {
    let tangents = |mesh: &Mesh<[f64; 3]>| {
        let limit = limits(scheme, mesh, Corners::Sharp)[0];
        limit.tangents.expect("faces around")
    };
    let before = tangents(mesh);
    let after = tangents(&refined(scheme, mesh, 0..rounds(scheme), Corners::Sharp));
    let error = |i: usize| distance(before[i].times(factors[i]), after[i]);
    error(0).max(error(1))
}

/// The eigenvalues on a boundary with k faces: along it and across.
fn across(scheme: Scheme, k: u32) -> [f64; 2] {
    let c = turn_cosine::<f64>(1, 2 * k as usize);
    match scheme {
        Scheme::CatmullClark => [0.5, catmull_clark_ring_eigenvalues(c)[0]],
        Scheme::Loop => [0.5, loop_ring_eigenvalue(c)],
        _ => [1.0 / 3.0, (2.0 + 2.0 * c) / 9.0],
    }
}

/// **Normals stay.** A step leaves the normal where it is: at interior vertices of Catmull-Clark, Loop and $\sqrt3$ and in the faces of Doo-Sabin, with either weights. Where the tangents are not nearly parallel, the angle between the normals
/// before and after is less than $(n+20)\mathbf u$.
///
/// Course: D24, slide 77, normals at extraordinary points.
#[test]
fn normals_are_not_turned_by_a_step() {
    let mut worst = 0.0_f64;
    for (seed, n) in (100..).zip(VALENCES) {
        for scheme in [Scheme::CatmullClark, Scheme::Loop, Scheme::Sqrt3] {
            let topology = if scheme == Scheme::CatmullClark {
                quad_fan(n)
            } else {
                double_fan(n)
            };
            let mesh = bowl(&topology, n, seed);
            let after = refined(scheme, &mesh, 0..2, Corners::Sharp);
            let normal =
                |mesh: &Mesh<[f64; 3]>| normal_of(&limits(scheme, mesh, Corners::Sharp)[0]);
            worst = worst.max(distance(normal(&mesh), normal(&after)) / f64::from(n + 20));
        }
        for weights in [DooSabinWeights::Own, DooSabinWeights::Averaging] {
            let topology = polygon(n);
            let mesh = bowl(&topology, n, seed);
            let step = doo_sabin(&joined(&mesh), &mesh.positions, weights, Corners::Sharp);
            let step = step.expect("a single face");
            let normal = |mesh: &Mesh<[f64; 3]>| {
                let limits = doo_sabin_limits(&joined(mesh), &mesh.positions);
                normal_of(&limits.expect("a point for each vertex")[0])
            };
            worst = worst.max(distance(normal(&mesh), normal(&step)) / f64::from(n + 20));
        }
    }
    let bound = f64::EPSILON / 2.0;
    println!("largest part of the bound: {:.3}", worst / bound);
    assert!(worst <= bound && worst >= bound / 20.0, "{}", worst / bound);
}

fn normal_of(limit: &Limit<[f64; 3]>) -> [f64; 3] {
    limit.normal().expect("tangents in two directions")
}

/// Neighbours on the unit circle (of the double fan and of the quadrilaterals' diagonals on larger ones), and heights at random.
fn bowl(topology: &Topology, n: u32, seed: u64) -> Mesh<[f64; 3]> {
    let mut dice = Dice::new(seed);
    let first_on_circle = topology.vertex_count % n as usize;
    let points = (0..topology.vertex_count).map(|vertex| {
        let height = 0.5 * dice.roll();
        let Some(place) = vertex.checked_sub(first_on_circle) else {
            return [0.0, 0.0, height];
        };
        let (k, circle) = (place % n as usize, place / n as usize);
        let radius = (1 + circle) as f64;
        let angle = |k: usize| turn_cosine::<f64>(2 * k + circle, 2 * n as usize);
        let sine = turn_cosine::<f64>(4 * (2 * k + circle) + 6 * n as usize, 8 * n as usize);
        [radius * angle(k), radius * sine, height]
    });
    topology.with_points(points.collect())
}

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

/// **Regular Catmull-Clark is the bicubic B-spline**, with its partial derivatives. At a regular vertex, at a regular boundary vertex and at a sharp corner of a single face the limit position is the point of the uniform bicubic B-spline surface, and the tangents are its partial
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
            let falling = |i: u32, k: u32| (0..k).map(|m| i as i32 - m as i32).product::<i32>();
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
