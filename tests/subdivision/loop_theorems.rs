//! The theorems of a step of Loop's scheme. The book shows their doc comments.

use facette::algebra::{Scalar, VectorSpace};
use facette::subdivision::mask::{loop_vertex_weight, turn_cosine};
use facette::subdivision::{Connectivity, Corners, loop_subdivision, loop_subdivision_with};
use num_traits::{One, Zero};
use proptest::prelude::*;

use crate::common::exact::{Exact, fraction};
use crate::common::law::{Law, expect_at_most, expect_equal};
use crate::meshes::{
    fan, hard_triangle_meshes, hard_triangle_topologies, triangle_meshes, triangle_topologies,
};
use crate::nets::triangle_grid_of;
use crate::plain_rules::Plain;
use crate::steps::{corner_rules, flat, rational_cosine};
use crate::suspects;

fn law(theorem: &'static str) -> Law {
    Law::new(theorem, suspects::loop_subdivision)
}

fn alpha(n: usize) -> Exact {
    loop_vertex_weight(rational_cosine(1, n))
}

/// **Edge points.** Loop's scheme puts a point on each edge: $\frac38(A+B)+\frac18(C+D)$, with the ends $A,B$ and the two vertices $C,D$ opposite to the edge in its triangles. On the boundary it is the midpoint
/// $\frac12(A+B)$.
///
/// Course: D24, slide 77, Loop: four triangles for one.
/// Exercise: loop.
#[test]
fn loop_puts_a_point_on_every_edge() {
    let law = law("subdivision::loop_puts_a_point_on_every_edge");
    law.holds(triangle_meshes(), hard_triangle_meshes(), |cage| {
        let (joined, plain) = (cage.connectivity(), Plain::new(&cage.mesh));
        let points = &cage.mesh.positions;
        let refined = loop_subdivision_with(&joined, points, Corners::Sharp, alpha);
        let refined = refined.expect("a manifold").positions;
        for (edge, got) in (0..).zip(&refined[joined.vertex_count()..]) {
            let h = joined.half_edge_of(edge);
            let ends = [joined.origin(h), joined.target(h)];
            expect_equal(&plain.loop_edge(ends), got)?;
        }
        Ok(())
    });
}

/// **Vertex points.** A vertex $V$ inside the mesh with $n$ neighbours goes to $\alpha_nV+(1-\alpha_n)Q$, with the mean $Q$ of its neighbours. A vertex on the boundary moves along it, whatever is inside: to $\frac18(A+6V+B)$ between its neighbours
/// $A,B$ on the boundary, as in the cubic curve scheme. With sharp corners a vertex with a single triangle stays; with smooth ones it moves too, and the corner is rounded off.
///
/// Course: D27, slide 78, Loop: boundaries.
/// Exercise: loop.
#[test]
fn loop_moves_the_old_vertices() {
    let law = law("subdivision::loop_moves_the_old_vertices");
    let ordinary = (triangle_meshes(), corner_rules());
    let hard = (hard_triangle_meshes(), corner_rules());
    law.holds(ordinary, hard, |(cage, corners)| {
        let (joined, plain) = (cage.connectivity(), Plain::new(&cage.mesh));
        let refined = loop_subdivision_with(&joined, &cage.mesh.positions, *corners, alpha);
        let refined = refined.expect("a manifold").positions;
        for vertex in (0..).take(joined.vertex_count()) {
            let expected = plain.loop_vertex(vertex, *corners, alpha);
            expect_equal(&expected, &refined[vertex as usize])?;
        }
        Ok(())
    });
}

/// **Four triangles for one.** A triangle $ABC$ with the edge points $D,E,F$ on $AB,BC,CA$ becomes the triangles $ADF$, $BED$, $CFE$ and $DEF$. Old vertices keep their valence; edge points have valence 6, or 4 on the boundary: so no step adds an irregular vertex.
///
/// Course: D24, slide 77, Loop: four triangles for one.
/// Exercise: loop.
#[test]
fn loop_makes_four_triangles_of_one_and_keeps_valences() {
    let law = law("subdivision::loop_makes_four_triangles_of_one_and_keeps_valences");
    law.holds(
        triangle_topologies(),
        hard_triangle_topologies(),
        |topology| {
            let (mesh, joined) = (flat(topology), topology.connectivity());
            let refined = loop_subdivision_with(&joined, &mesh.positions, Corners::Sharp, alpha);
            let refined = refined.expect("a manifold");
            let number = |count: usize| u32::try_from(count).expect("a small mesh");
            let v = number(joined.vertex_count());
            let quartered = |face: u32| {
                let h = joined.half_edges_of(face).start;
                let [a, b, c] = [0, 1, 2].map(|i| joined.origin(h + i));
                let [d, e, f] = [0, 1, 2].map(|i| v + joined.edge_of(h + i));
                [[a, d, f], [b, e, d], [c, f, e], [d, e, f]]
            };
            let expected: Vec<_> = (0..number(joined.face_count()))
                .flat_map(quartered)
                .collect();
            let got: Vec<_> = refined.faces().collect();
            expect_equal(&expected.iter().map(|face| &face[..]).collect(), &got)?;
            let finer = Connectivity::new(&refined).expect("a step leaves a manifold");
            for vertex in 0..v {
                expect_equal(&joined.valence(vertex), &finer.valence(vertex))?;
            }
            for edge in 0..number(joined.edge_count()) {
                let expected = if joined.is_boundary_edge(edge) { 4 } else { 6 };
                expect_equal(&expected, &finer.valence(v + edge))?;
            }
            Ok(())
        },
    );
}

/// The coefficients of (1 + x)²(1 + y)²(1 + xy)². Entry [j][i] belongs to $x^iy^j$.
fn box_spline_mask() -> [[i32; 5]; 5] {
    let mut mask = [[0; 5]; 5];
    mask[0][0] = 1;
    for [di, dj] in [[1, 0], [1, 0], [0, 1], [0, 1], [1, 1], [1, 1]] {
        for j in (0..5).rev() {
            for i in (0..5).rev() {
                if i >= di && j >= dj {
                    mask[j][i] += mask[j - dj][i - di];
                }
            }
        }
    }
    mask
}

/// **A box spline where all valences are 6.** The edges of a regular triangulation run in three directions. Along each of them the quartic box spline is averaged twice, so one refinement has the generating function
/// $$\tfrac1{16}(1+x)^2(1+y)^2(1+xy)^2.$$
/// Away from the boundary of a regular triangulation, a step of Loop's scheme has just these weights; its limit there is the box spline, and $C^2$.
///
/// Course: D24, slide 77, Loop: four triangles for one.
/// Exercise: loop.
#[test]
fn loop_on_a_regular_mesh_is_the_quartic_box_spline() {
    let law = law("subdivision::loop_on_a_regular_mesh_is_the_quartic_box_spline");
    let mask = box_spline_mask();
    assert_eq!(mask[2], [1, 6, 10, 6, 1]);
    let grids =
        (2..5_u32, 2..5_u32).prop_flat_map(|(columns, rows)| triangle_grid_of(columns, rows));
    law.holds(grids, triangle_grid_of(2, 2), |cage| {
        let points = &cage.mesh.positions;
        let refined = loop_subdivision_with(&cage.connectivity(), points, Corners::Sharp, alpha);
        let refined = refined.expect("a manifold");
        let finer = Connectivity::new(&refined).expect("a step leaves a manifold");
        let two = fraction(2, 1);
        for (vertex, got) in (0..).zip(&refined.positions) {
            if finer.is_boundary_vertex(vertex) {
                continue;
            }
            let mut sum = [Exact::zero(); 5];
            for point in points {
                // The new point (k, l) has from the old point (i, j) the weight of x^(k − 2i + 2) y^(l − 2j + 2).
                let exponent = |axis: usize| two * got[axis] - two * point[axis] + two;
                let place =
                    [4, 3].map(|axis| (0..5).find(|&e| Exact::from_i32(e) == exponent(axis)));
                if let [Some(j), Some(i)] = place {
                    let [j, i] = [j, i].map(|e| usize::try_from(e).expect("at most 4"));
                    sum = sum.plus(point.times(fraction(mask[j][i], 16)));
                }
            }
            expect_equal(&sum, got)?;
        }
        Ok(())
    });
}

/// **Loop's weight.** A vertex with $n$ neighbours keeps the share
/// $$\alpha_n=\Bigl(\tfrac38+\tfrac14\cos\tfrac{2\pi}n\Bigr)^2+\tfrac38$$
/// of itself. At $n=6$ that is $\frac58$, the weight of the box spline; at $n=3$ it is $\frac7{16}$, at $n=4$ $\frac{33}{64}$.
///
/// In `f64` the new vertex is within $20\mathbf u$ of $\alpha_n$ where the vertex is 1 and its neighbours are 0: $3\mathbf u$ of the cosine come down to less than $\frac12\mathbf u$ of $\alpha_n$, its own operations add at most
/// $2\mathbf u$, and the mean of $n$ equal numbers with the rounded factor $\frac1n$ is wrong by at most $2\mathbf u$, before the product and the sum; up to $n=200$ the sum of $n$ ones is exact.
///
/// Course: D26, slide 78, Loop: any valence.
/// Erratum: the slide prints $\cos\frac{3\pi}n$. It is $\cos\frac{2\pi}n$: with the printed cosine the weight at valence 6 is $\frac{33}{64}$, and the scheme is not even the box spline on a regular mesh.
/// Exercise: loop.
#[test]
fn loop_weight_has_the_cosine_of_a_full_turn() {
    let exact = |n: usize| loop_vertex_weight::<Exact>(rational_cosine(1, n));
    assert_eq!(
        [3, 4, 6].map(exact),
        [fraction(7, 16), fraction(33, 64), fraction(5, 8)]
    );
    // cos(3π/6) = 0.
    assert_eq!(loop_vertex_weight(Exact::zero()), fraction(33, 64));
    let law = law("subdivision::loop_weight_has_the_cosine_of_a_full_turn");
    law.holds(3..=12_u32, prop_oneof![Just(6_u32), 13..=200_u32], |&n| {
        let topology = fan(n);
        let mut points = vec![0.0; topology.vertex_count];
        points[0] = 1.0;
        let refined = loop_subdivision(&topology.connectivity(), &points, Corners::Sharp);
        let got = refined.expect("a manifold").positions[0];
        let alpha: f64 = loop_vertex_weight(turn_cosine(1, n as usize));
        let error = (got - alpha).abs() / f64::unit_roundoff();
        expect_at_most("an error, in units of roundoff,", 20.0, error)
    });
}

/// **One weight does not fit all valences.** With the weight $\frac58$ of valence 6 at a vertex of valence 3, the height of the vertex over its neighbours and the size of the ring both shrink to a quarter at each step: the tip stays as steep as it was, and the limit is a cone.
/// With Loop's $\alpha_3=\frac7{16}$ the height shrinks to $\frac1{16}$, and the tip becomes flat.
///
/// Course: D25, slide 78, Loop: other valences than 6.
#[test]
fn loop_weight_of_valence_six_makes_a_cone_at_valence_three() {
    // Height, and two coordinates of a triangle with its centre below the tip.
    let start = [[1, 0, 0], [0, 2, -1], [0, -1, 2], [0, -1, -1]].map(|p| p.map(Exact::from_i32));
    let ring_of = |weight: Exact| {
        let mut points = start.to_vec();
        let mut ratios = Vec::new();
        for _ in 0..5 {
            let joined = fan(3).connectivity();
            let refined = loop_subdivision_with(&joined, &points, Corners::Sharp, |_| weight);
            let refined = refined.expect("a manifold").positions;
            let edge_to = |v: u32| {
                joined.edge_of(
                    joined
                        .around(0)
                        .find(|&h| joined.target(h) == v)
                        .expect("a neighbour"),
                )
            };
            let ring = [1, 2, 3].map(|v| refined[4 + edge_to(v) as usize]);
            points = [&refined[..1], &ring].concat();
            ratios.push((points[0][0] - points[1][0]) / points[1][1]);
        }
        ratios
    };
    let half = fraction(1, 2);
    assert_eq!(ring_of(fraction(5, 8)), [half; 5]);
    let quarter = fraction(1, 4);
    let mut expected = half;
    for ratio in ring_of(fraction(7, 16)) {
        expected = expected * quarter;
        assert_eq!(ratio, expected);
    }
    assert!(expected < Exact::one());
}
