//! Figures of the limit: eigenvalues, normals that come together, curvature, and how fast the meshes converge.

use std::collections::HashMap;

use facette::algebra::{Vector3, VectorSpace, length, unit_vector};
use facette::mesh::Mesh;
use facette::subdivision::limit::{
    DistanceBound, Eigenvalues, catmull_clark_distance_bound, catmull_clark_eigenvalues,
    catmull_clark_limit_positions, catmull_clark_limits, doo_sabin_eigenvalues,
    loop_distance_bound, loop_eigenvalues, loop_limit_positions, sqrt3_eigenvalues, turn_point,
};
use facette::subdivision::{
    Connectivity, Corners, DooSabinWeights, catmull_clark, doo_sabin, loop_subdivision,
};
use facette_figure::Figure;
use facette_figure::plot::Plot;
use facette_figure::svg::{Panel, panels};

use super::solids::{cube, octahedron};

type Point = [f64; 3];

fn plotted(name: &'static str, caption: &str, alternative: &str, plot: &Plot) -> Figure {
    Figure::plotted(name, caption, alternative, plot).expect("the plot has points")
}

/// A scheme's name, and its eigenvalues as a function of the valence.
type Named = (&'static str, fn(usize) -> Eigenvalues<f64>);

const SCHEMES: [Named; 5] = [
    ("Catmull-Clark", catmull_clark_eigenvalues),
    ("Loop", loop_eigenvalues),
    ("√3", sqrt3_eigenvalues),
    ("Doo-Sabin, own weights", own),
    ("Doo-Sabin, averaging", averaging),
];

fn own(n: usize) -> Eigenvalues<f64> {
    doo_sabin_eigenvalues(n, DooSabinWeights::Own)
}

fn averaging(n: usize) -> Eigenvalues<f64> {
    doo_sabin_eigenvalues(n, DooSabinWeights::Averaging)
}

fn against_valence(plot: Plot, value: fn(Eigenvalues<f64>) -> f64) -> Plot {
    SCHEMES.iter().fold(plot, |plot, (name, eigenvalues)| {
        let points = (3..=24).map(|n| [n as f64, value(eigenvalues(n))]);
        plot.line(name, &points.collect::<Vec<_>>())
    })
}

/// λ against the valence, for the four schemes.
pub fn eigenvalues() -> Figure {
    let plot = Plot::new("The eigenvalue λ", "valence n, or corners of the face", "λ");
    plotted(
        "eigenvalues",
        "The eigenvalue $\\lambda$ of the tangents: by this factor the ring of a vertex (for Doo-Sabin the face) shrinks in a step. At a regular vertex it is $\\frac12$, or $\\frac1{\\sqrt3}$ with the scheme $\\sqrt3$. Rings of low valence shrink fast and are crowded, rings of high valence shrink slowly and leave \
         long faces; only Doo's and Sabin's own weights make no difference.",
        "A plot of five curves over the valence from 3 to 24. Four rise and level off between 0.62 and 0.75; the fifth is constant at one half.",
        &against_valence(plot, |e| e.tangent),
    )
}

/// μ/λ² against the valence.
pub fn curvature_growth() -> Figure {
    let plot = Plot::new(
        "Growth of curvature",
        "valence n, or corners of the face",
        "μ / λ²",
    );
    plotted(
        "curvature_growth",
        "The factor $\\mu/\\lambda^2$ by which curvature at the vertex is multiplied in every step. Above 1 it grows without end; below 1 the surface becomes flat. At the regular valence, 4 or 6, it is 1, and the surface a spline. At valence 3 Loop, $\\sqrt3$ and averaging have their largest values: there $\\lambda$ is very small.",
        "A plot of five curves over the valence from 3 to 24. Three begin between 1.8 and 2 at valence 3 and fall to one at 4; Catmull-Clark begins just below one. From 5 or 7 on four curves rise and level off between 1.3 and 1.6. The one of Doo's and Sabin's own weights is constant at one.",
        &against_valence(plot, |e| e.next / (e.tangent * e.tangent)),
    )
}

/// The part of a mesh near the vertices that are wanted, which come first.
fn near(mesh: &Mesh<Point>, wanted: &[u32], rings: usize) -> Mesh<Point> {
    let mut numbers: HashMap<u32, u32> = wanted.iter().copied().zip(0..).collect();
    let mut points: Vec<Point> = wanted.iter().map(|&v| mesh.positions[v as usize]).collect();
    let faces: Vec<&[u32]> = mesh.faces().collect();
    let mut kept = Vec::new();
    for _ in 0..rings {
        let reached = numbers.clone();
        let touches = |face: &&&[u32]| face.iter().any(|v| reached.contains_key(v));
        kept = faces.iter().filter(touches).copied().collect();
        for &v in kept.iter().copied().flatten() {
            let next = u32::try_from(points.len()).expect("a small mesh");
            numbers.entry(v).or_insert_with(|| {
                points.push(mesh.positions[v as usize]);
                next
            });
        }
    }
    let renumbered = kept
        .iter()
        .map(|face| face.iter().map(|v| numbers[v]).collect::<Vec<u32>>());
    Mesh::new(points, renumbered).expect("a part of a mesh")
}

fn joined(mesh: &Mesh<Point>) -> Connectivity {
    Connectivity::new(mesh).expect("a manifold")
}

/// The pyramid over a regular n-gon with one corner lifted; its tip is the last vertex.
fn lopsided_pyramid(n: u32) -> Mesh<Point> {
    let base = (0..n).map(|k| {
        let [x, y] = turn_point::<f64>(k as usize, n as usize);
        [x, y, if k == 0 { 0.5 } else { 0.0 }]
    });
    let sides = (0..n).map(|k| vec![k, (k + 1) % n, n]);
    let faces = sides.chain([(0..n).rev().collect()]);
    Mesh::new(base.chain([[0.0, 0.0, 1.0]]).collect(), faces).expect("a pyramid")
}

/// The largest angle between normals of faces at the n-gon that the tip becomes, after each round, in degrees.
fn angles_at_the_tip(n: u32, weights: DooSabinWeights, rounds: u32) -> Vec<[f64; 2]> {
    let mut mesh = lopsided_pyramid(n);
    let mut angles = Vec::new();
    for round in 1..=rounds {
        let fine = doo_sabin(&joined(&mesh), &mesh.positions, weights, Corners::Sharp);
        let fine = fine.expect("a small mesh");
        // After the first round the tip is the last face, later the first one.
        let tip = if round == 1 { fine.face_count() - 1 } else { 0 };
        let corners = fine.faces().nth(tip).expect("the tip's face").to_vec();
        let part = near(&fine, &corners, 1);
        // The face of the tip first, so that it is the first of the next round.
        let is_tip = |face: &&[u32]| face.iter().all(|&v| v < n);
        let (first, others): (Vec<_>, Vec<_>) = part.faces().partition(is_tip);
        mesh =
            Mesh::new(part.positions.clone(), first.into_iter().chain(others)).expect("as before");
        angles.push([f64::from(round), largest_angle(&mesh)]);
    }
    angles
}

fn largest_angle(mesh: &Mesh<Point>) -> f64 {
    let normals: Vec<Point> = mesh
        .faces()
        .map(|face| {
            let at =
                |k: usize| mesh.positions[face[k] as usize].minus(mesh.positions[face[0] as usize]);
            let sum = (1..face.len() - 1).fold([0.0; 3], |sum, k| sum.plus(at(k).cross(at(k + 1))));
            unit_vector(sum).expect("a face with an area")
        })
        .collect();
    let angle = |a: Point, b: Point| length(a.cross(b)).atan2(a.dot(b)).to_degrees();
    let pairs = normals
        .iter()
        .flat_map(|&a| normals.iter().map(move |&b| angle(a, b)));
    pairs.fold(0.0, f64::max)
}

/// How the normals around an extraordinary point of Doo-Sabin come together.
pub fn doo_sabin_normals() -> Figure {
    let panel = |weights, title| {
        let plot = Plot::new(title, "rounds", "largest angle / °")
            .log_y()
            .height(330.0);
        let plot = [3, 5, 8, 20].into_iter().fold(plot, |plot, n| {
            plot.line(&format!("n = {n}"), &angles_at_the_tip(n, weights, 12))
        });
        Panel::drawing(title, plot.to_drawing().expect("the plot has points"))
    };
    let row = [
        panel(DooSabinWeights::Own, "Doo's and Sabin's own weights"),
        panel(DooSabinWeights::Averaging, "averaging, as on the slides"),
    ];
    Figure::drawn(
        "doo_sabin_normals",
        "The largest angle between two faces around an extraordinary point, the tip of a lopsided pyramid over $n$ sides, round after round of Doo-Sabin. It goes to zero: there is a tangent plane. With Doo's and Sabin's own weights it is halved in every round, whatever $n$; with averaging at $n=20$ it \
         takes fourteen rounds to halve.",
        "Two plots with a logarithmic axis of angles over 12 rounds. In the upper one four lines fall by a half in each round. In the lower one the lines for 3, 5 and 8 fall at different rates, and the one for 20 becomes nearly level.",
        &panels(1, &row),
    )
}

/// A fan of n quadrilaterals: vertex 0 in the middle, with a saddle over it, or a cup.
fn fan(n: u32, is_saddle: bool) -> Mesh<Point> {
    let place = |k: u32, half: usize, radius: f64| {
        let [x, y] = turn_point::<f64>(2 * k as usize + half, 2 * n as usize);
        let [wave, _] = turn_point::<f64>(2 * (2 * k as usize + half), 2 * n as usize);
        [
            radius * x,
            radius * y,
            if is_saddle {
                radius * radius * wave
            } else {
                radius * radius
            },
        ]
    };
    let inner = (0..n).map(|k| place(k, 0, 1.0));
    let outer = (0..n).map(|k| place(k, 1, std::f64::consts::SQRT_2));
    let points = std::iter::once([0.0; 3])
        .chain(inner)
        .chain(outer)
        .collect();
    let faces = (0..n).map(|k| [0, 1 + k, 1 + n + k, 1 + (k + 1) % n]);
    Mesh::new(points, faces).expect("a fan")
}

/// Twice the height over the square of the distance, at the corners of the faces around vertex 0: a normal curvature; the largest of them.
fn largest_curvature(mesh: &Mesh<Point>) -> f64 {
    let limits = catmull_clark_limits(&joined(mesh), &mesh.positions, Corners::Sharp);
    let limit = limits.expect("a point for each vertex")[0];
    let normal = limit.normal().expect("a tangent plane");
    let around = mesh.faces().filter(|face| face.contains(&0)).flatten();
    let bends = around.filter(|&&v| v != 0).map(|&v| {
        let offset = mesh.positions[v as usize].minus(limit.position);
        2.0 * offset.dot(normal).abs() / offset.dot(offset)
    });
    bends.fold(0.0, f64::max)
}

/// Curvature at an extraordinary vertex of Catmull-Clark, level after level.
pub fn curvature_by_level() -> Figure {
    let plot = Plot::new("Curvature at the vertex", "level", "curvature, level 0 = 1").log_y();
    let plot = [(3, false), (4, true), (5, true), (8, true)]
        .into_iter()
        .fold(plot, |plot, (n, is_saddle)| {
            let mut mesh = fan(n, is_saddle);
            let mut points = Vec::new();
            for level in 0..=16 {
                points.push([f64::from(level), largest_curvature(&mesh)]);
                let fine = catmull_clark(&joined(&mesh), &mesh.positions, Corners::Sharp);
                mesh = near(&fine.expect("a small mesh"), &[0], 2);
            }
            let first = points[0][1];
            let scaled: Vec<[f64; 2]> = points.iter().map(|[x, y]| [*x, y / first]).collect();
            plot.line(&format!("n = {n}"), &scaled)
        });
    plotted(
        "curvature_by_level",
        "Curvature at a vertex of valence $n$ under Catmull-Clark, measured by the heights of the corners of its faces over the tangent plane, and their distances. At the regular $n=4$ it converges; at 5 and 8 it grows by the same factor in every level, without end; at 3 it goes to zero, by one percent a level. Control points on a saddle, \
         for $n=3$ on a cup.",
        "A plot with a logarithmic axis over the levels 0 to 16. The line for valence 4 becomes level, those for 5 and 8 rise steadily, the one for 3 falls a little.",
        &plot,
    )
}

/// The cube, or the octahedron.
fn solid(is_quad: bool) -> Mesh<Point> {
    if is_quad { cube() } else { octahedron() }
}

fn bound_of(mesh: &Mesh<Point>, is_quad: bool) -> DistanceBound<f64> {
    let (joined, points) = (&joined(mesh), &mesh.positions);
    if is_quad {
        catmull_clark_distance_bound(joined, points, Corners::Sharp)
    } else {
        loop_distance_bound(joined, points, Corners::Sharp)
    }
    .expect("a mesh that the scheme takes")
}

/// The largest distance of a vertex from its limit, level by level, and the bound.
fn convergence_of(is_quad: bool) -> [Vec<[f64; 2]>; 2] {
    let mut mesh = solid(is_quad);
    let bound = bound_of(&mesh, is_quad);
    let [mut measured, mut bounds] = [Vec::new(), Vec::new()];
    for level in 0..=6_u32 {
        let (connectivity, points) = (joined(&mesh), &mesh.positions);
        let limits = if is_quad {
            catmull_clark_limit_positions(&connectivity, points, Corners::Sharp)
        } else {
            loop_limit_positions(&connectivity, points, Corners::Sharp)
        };
        let limits = limits.expect("a point for each vertex");
        let distances = points
            .iter()
            .zip(limits)
            .map(|(&p, limit)| p.minus(limit).largest_coordinate());
        measured.push([f64::from(level), distances.fold(0.0, f64::max)]);
        bounds.push([f64::from(level), bound.after(level)]);
        let fine = if is_quad {
            catmull_clark(&connectivity, points, Corners::Sharp)
        } else {
            loop_subdivision(&connectivity, points, Corners::Sharp)
        };
        mesh = fine.expect("a small mesh");
    }
    [measured, bounds]
}

/// The distance of a level from the limit.
pub fn mesh_convergence() -> Figure {
    let [cube, cube_bound] = convergence_of(true);
    let [octahedron, octahedron_bound] = convergence_of(false);
    let plot = Plot::new("Distance from the limit", "level", "largest distance")
        .log_y()
        .points("cube, Catmull-Clark", &cube)
        .points("octahedron, Loop", &octahedron)
        .line("cube, bound", &cube_bound)
        .line("octahedron, bound", &octahedron_bound);
    plotted(
        "mesh_convergence",
        "The largest difference of a coordinate between a vertex and its limit (marks), and the bound that is known beforehand, for every point of the mesh (lines). The vertices come nearer by a quarter in every level, as on a regular mesh. The bound looks only one step ahead at a time: at the valence 3 of the cube it allows for $\\rho=\\frac23$, where the true rate of the ring is 0.41, and so it falls behind. A vertex moved by the limit mask has no distance left.",
        "A plot with a logarithmic axis over the levels 0 to 6. Two rows of marks fall by a factor of four a level; two straight lines above them fall less steeply.",
        &plot,
    )
}
