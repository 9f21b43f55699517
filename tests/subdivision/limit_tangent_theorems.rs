//! The theorems of tangents and normals: left eigenvectors of the schemes as they run, and the splines' partial derivatives where the mesh is
//! regular.

use facette::algebra::VectorSpace;
use facette::mesh::Mesh;
use facette::subdivision::limit::{
    Limit, catmull_clark_ring_eigenvalues, doo_sabin_limits, loop_ring_eigenvalue,
};
use facette::subdivision::mask::turn_cosine;
use facette::subdivision::{Corners, DooSabinWeights, doo_sabin};
use proptest::prelude::*;

use crate::common::dice::Dice;
use crate::common::exact::{Exact, fraction};
use crate::common::law::{Law, expect_equal};
use crate::limit_inputs::{
    VALENCES, circle, half_fan, joined, limits, limits_with, rational_circle, refined,
    root_of_nine, rounds,
};
use crate::meshes::{Topology, double_fan, polygon, quad_fan};
use crate::steps::Scheme;
use crate::suspects;

type Point = [Exact; 3];
type Pair = [Point; 2];

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
/// neighbours are centroids, half a spoke further. The plane and the normal stay. Exact at $n=3,4,6$, with sines in units of $\sin\frac{2\pi}n$.
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
