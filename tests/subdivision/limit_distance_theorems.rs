//! The bound on the distance of a level from the limit.

use facette::algebra::VectorSpace;
use facette::mesh::Mesh;
use facette::subdivision::limit::{
    DistanceBound, catmull_clark_distance_bound, loop_distance_bound, turn_point,
};
use facette::subdivision::mask::turn_cosine;
use facette::subdivision::{Connectivity, Corners};

use crate::common::dice::Dice;
use crate::limit_inputs::{half_fan, joined, limits_with, refined};
use crate::meshes::{
    Topology, bipyramid, cube_faces, double_fan, grid, octahedron_faces, polygon, quad_fan,
    tetrahedron_faces, torus, triangle_grid, triangle_torus,
};
use crate::steps::Scheme;

const BOTH: [Corners; 2] = [Corners::Sharp, Corners::Smooth];

fn bound(scheme: Scheme, mesh: &Mesh<[f64; 3]>, corners: Corners) -> DistanceBound<f64> {
    let (joined, points) = (&joined(mesh), &mesh.positions);
    match scheme {
        Scheme::CatmullClark => catmull_clark_distance_bound(joined, points, corners),
        _ => loop_distance_bound(joined, points, corners),
    }
    .expect("a mesh that the scheme takes")
}

/// The points of a level at the parameters of the next level's vertices, in the order of these: the vertices, the middles of the edges, and for
/// quadrilaterals the centroids.
fn at_the_next_vertices(scheme: Scheme, mesh: &Mesh<[f64; 3]>) -> Vec<[f64; 3]> {
    let joined: Connectivity = joined(mesh);
    let at = |v: u32| mesh.positions[v as usize];
    let edges = (0..joined.edge_count()).map(|edge| {
        let h = joined.half_edge_of(u32::try_from(edge).expect("small"));
        at(joined.origin(h)).lerp(at(joined.target(h)), 0.5)
    });
    let centroids = mesh.faces().map(|face| {
        let sum = face.iter().fold([0.0; 3], |sum, &v| sum.plus(at(v)));
        sum.times(1.0 / face.len() as f64)
    });
    let of_faces = if scheme == Scheme::CatmullClark {
        usize::MAX
    } else {
        0
    };
    let vertices = mesh.positions.iter().copied();
    vertices
        .chain(edges)
        .chain(centroids.take(of_faces))
        .collect()
}

/// How far a level is from the limit at the vertices of the next level.
fn distance(scheme: Scheme, mesh: &Mesh<[f64; 3]>, step: u32, corners: Corners) -> f64 {
    let fine = refined(scheme, mesh, step..step + 1, corners);
    let limits = limits_with(scheme, &fine, corners, turn_point, f64::sqrt);
    let pairs = at_the_next_vertices(scheme, mesh).into_iter().zip(limits);
    pairs
        .map(|(point, limit)| point.minus(limit.position).largest_coordinate())
        .fold(0.0, f64::max)
}

fn cages() -> Vec<(Scheme, Topology)> {
    let quads = [
        cube_faces(),
        torus(4, 4),
        grid(3, 3),
        grid(1, 1),
        quad_fan(2),
        quad_fan(5),
        quad_fan(8),
        quad_fan(20),
        half_fan(3, true),
        half_fan(6, true),
    ];
    let triangles = [
        tetrahedron_faces(),
        octahedron_faces(),
        triangle_torus(4, 4),
        triangle_grid(3, 3),
        polygon(3),
        bipyramid(7),
        double_fan(5),
        double_fan(20),
        half_fan(2, false),
        half_fan(7, false),
    ];
    let quads = quads.map(|topology| (Scheme::CatmullClark, topology));
    let triangles = triangles.map(|topology| (Scheme::Loop, topology));
    quads.into_iter().chain(triangles).collect()
}

/// **How far a level is from the limit.** Take a level as bilinear over every quadrilateral (Catmull-Clark) or linear over every triangle (Loop). With $M$ the largest second difference across an edge, $a+b-2v$ for quadrilaterals and $v+q-a-b$ for triangles, the control mesh is nowhere further from the limit than
/// $\beta M/(1-\rho)$, and after $k$ steps than $\rho^k$ times that, in every coordinate. On regular meshes $\rho=\frac14$, with $\beta=\frac14$ for Catmull-Clark and $\frac38$ for Loop. For Catmull-Clark $\rho=\frac23$ at valence 3 and $\frac{18}{25}$ at 5; for Loop $\rho=\frac58+(n-6)\frac{1-\alpha}n$ from valence 7 on. Second
/// differences along a boundary shrink to a quarter, and count apart. Compared with the limit positions of the next level's vertices, at levels 0 to 3. On regular meshes the bound is reached at every level; elsewhere it falls behind with the levels, since the true rate is smaller than $\rho$.
///
/// Course: D24, slide 77, refined meshes converge to the limit surface.
#[test]
fn level_is_no_further_from_the_limit_than_its_bound() {
    let mut worst = [0.0_f64; 4];
    let mut dice = Dice::new(2);
    for (scheme, topology) in cages() {
        for repetition in 0..30 {
            // Points in general, or one of them alone moved by 1.
            let points = (0..topology.vertex_count).map(|v| {
                if repetition < 8 {
                    dice.vector()
                } else {
                    [f64::from(u8::from(v == repetition - 8)), 0.0, 0.0]
                }
            });
            let cage = topology.with_points(points.collect());
            for corners in BOTH {
                let bound = bound(scheme, &cage, corners);
                let mut mesh = cage.clone();
                for level in 0..4_u32 {
                    let got = distance(scheme, &mesh, level, corners);
                    let most = bound.after(level);
                    // Points of size 1 and few operations: 16 u each way.
                    assert!(
                        got <= most + 32.0 * f64::EPSILON,
                        "{} {corners:?}, level {level}: {got} > {most}",
                        topology.name
                    );
                    if most > 0.0 {
                        worst[level as usize] = worst[level as usize].max(got / most);
                    }
                    if level < 3 {
                        mesh = refined(scheme, &mesh, level..level + 1, corners);
                    }
                }
            }
        }
    }
    println!("largest parts of the bounds by level: {worst:.3?}");
    assert!(worst.iter().all(|&part| part >= 0.9), "{worst:?}");
}

/// **The constants of the bound.** They are below 1 at every valence, so that the bound goes to zero, and those that others have published at the valences where they have: $\rho=\frac14$ on regular meshes, $\frac23$ and $\frac{18}{25}$ for Catmull-Clark at valence 3 and 5 (Cheng, Chen and Yong), and less than $0.86$ for Loop at any valence. A tolerance is met
/// at the level that the bound gives.
///
/// Course: D23, slide 76, Catmull-Clark: the rate of convergence.
#[test]
fn rates_of_the_bound_are_below_one() {
    let rate = |scheme, topology: &Topology| {
        let points = vec![[0.0; 3]; topology.vertex_count];
        bound(scheme, &topology.with_points(points), Corners::Sharp).rate
    };
    assert_eq!(rate(Scheme::CatmullClark, &torus(3, 3)), 0.25);
    assert_eq!(rate(Scheme::Loop, &triangle_torus(3, 3)), 0.25);
    assert_eq!(rate(Scheme::CatmullClark, &grid(2, 2)), 0.25);
    assert_eq!(rate(Scheme::Loop, &triangle_grid(2, 2)), 0.375);
    for (n, expected) in [(3, 2.0 / 3.0), (5, 0.72)] {
        assert!((rate(Scheme::CatmullClark, &quad_fan(n)) - expected).abs() < 1e-15);
    }
    for n in 3..=200 {
        let [quads, triangles] = [
            (Scheme::CatmullClark, quad_fan(n)),
            (Scheme::Loop, double_fan(n)),
        ]
        .map(|(scheme, topology)| rate(scheme, &topology));
        assert!(quads < 0.85 && triangles < 0.86, "{n}: {quads} {triangles}");
        if n >= 7 {
            let alpha =
                facette::subdivision::mask::loop_vertex_weight(turn_cosine::<f64>(1, n as usize));
            let w = (1.0 - alpha) / f64::from(n);
            // The ring of the double fan has valence 5 and a boundary of five triangles beyond it.
            let expected = (0.625 + f64::from(n - 6) * w).max(0.625);
            assert!(
                (triangles - expected).abs() < 1e-14,
                "{n}: {triangles}, not {expected}"
            );
        }
    }
    let mesh = torus(4, 4).with_points((0..16).map(|v| [f64::from(v), 0.0, 0.0]).collect());
    let bound = bound(Scheme::CatmullClark, &mesh, Corners::Sharp);
    let level = bound.level_within(1e-3, 20).expect("a few levels");
    assert!(bound.after(level) <= 1e-3 && bound.after(level - 1) > 1e-3);
    assert_eq!(bound.level_within(1e-3, 2), None);
}
