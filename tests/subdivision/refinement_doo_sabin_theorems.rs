//! Plans of Doo-Sabin against the steps they stand for. The book shows the doc comments.

use facette::mesh::Mesh;
use facette::subdivision::{Connectivity, Corners, Counts, DooSabinWeights, Refinement, Scratch};
use proptest::prelude::*;

use crate::common::exact::Exact;
use crate::common::law::{Law, Verdict, expect_at_most, expect_equal};
use crate::meshes::{
    Cage, Topology, cube_faces, float_meshes, grid, hard_meshes, hard_topologies, meshes,
    topologies, torus, triangle_torus,
};
use crate::refinement_match::{Threads, expect_same_mesh};
use crate::steps::{Scheme, corner_rules, flat, rational_cosine};
use crate::suspects;

type Point = [Exact; 3];

fn law(theorem: &'static str) -> Law {
    Law::new(theorem, suspects::library)
}

fn weights() -> impl Strategy<Value = DooSabinWeights> {
    prop_oneof![Just(DooSabinWeights::Own), Just(DooSabinWeights::Averaging)]
}

fn stepped<const N: usize>(
    weights: DooSabinWeights,
    mesh: &Mesh<[Exact; N]>,
    levels: u32,
    corners: Corners,
) -> Mesh<[Exact; N]> {
    (0..levels).fold(mesh.clone(), |mesh, step| {
        Scheme::DooSabin(weights).step(&mesh, step, corners)
    })
}

/// Whether a step makes a block of 2 x 2 points of every vertex.
fn is_patchwork(joined: &Connectivity, corners: Corners) -> bool {
    (0..).take(joined.vertex_count()).all(|vertex| {
        let (edges, faces) = (joined.valence(vertex), joined.around(vertex).count());
        let is_sharp = corners == Corners::Sharp && edges == 2;
        edges == 4 && faces == 4 || edges == 3 && faces == 2 || is_sharp && faces == 1
    })
}

/// How many steps it takes to reach a mesh of blocks, and that mesh.
fn patchwork<const N: usize>(
    mesh: &Mesh<[Exact; N]>,
    levels: u32,
    corners: Corners,
) -> (u32, Connectivity) {
    let after = |steps| {
        let mesh = stepped(DooSabinWeights::Averaging, mesh, steps, corners);
        Connectivity::new(&mesh).expect("a manifold")
    };
    let reached = |&steps: &u32| steps == levels || is_patchwork(&after(steps), corners);
    let steps = (0..=levels).find(reached).unwrap_or(levels);
    (steps, after(steps))
}

/// The refined mesh with exact cosines.
fn planned(plan: &Refinement, points: &[Point]) -> Mesh<Point> {
    let positions = plan
        .positions_with(points, rational_cosine)
        .expect("a point for each vertex");
    Mesh::new(positions, plan.faces()).expect("a mesh")
}

/// **A plan of Doo-Sabin is its steps.** Refined by blocks, through any number of levels, a mesh has the same faces and exactly the same points as after as many steps one by one, up to the numbers of vertices and faces: with faces of any number of sides, vertices of any valence, boundaries, sharp
/// and round corners, both kinds of weights.
///
/// Where to begin a comparison needs no search: a step numbers the shrunken faces like the faces, and the plan puts those of four corners after all other quadrilaterals, and the rest after these. From there a walk over both meshes at once must meet the same faces.
///
/// Course: D16, slides 64-71, Doo-Sabin: the scheme, level after level.
#[test]
fn plan_of_doo_sabin_is_its_steps() {
    let law = law("subdivision::plan_of_doo_sabin_is_its_steps").on_cases(48);
    let choices = || (corner_rules(), weights(), 0..4_u32);
    let inputs = (meshes(), choices());
    law.holds(inputs, (hard_meshes(), choices()), |input| {
        let (cage, (corners, weights, levels)) = input;
        agrees(cage, *corners, *weights, *levels)
    });
}

fn agrees(cage: &Cage<Point>, corners: Corners, weights: DooSabinWeights, levels: u32) -> Verdict {
    let joined = cage.connectivity();
    let plan = Refinement::doo_sabin(&joined, levels, weights, corners).expect("a small mesh");
    let planned = planned(&plan, &cage.mesh.positions);
    let steps = stepped(weights, &cage.mesh, levels, corners);
    let (before, base) = patchwork(&cage.mesh, levels, corners);
    if !is_patchwork(&base, corners) {
        // Nothing is refined but by steps, and the faces are theirs.
        return expect_equal(&steps, &planned);
    }
    let side = 1 << (levels - before);
    let faces = || {
        (0..)
            .take(base.face_count())
            .map(|face| base.half_edges_of(face))
    };
    let in_faces = faces().filter(|face| face.len() == 4).count();
    let mut quads = 4 * u32::try_from(plan.quad_count() - in_faces).expect("a small mesh");
    let mut polygons = 4 * u32::try_from(plan.quad_count()).expect("a small mesh");
    let mut seeds = Vec::new();
    for face in faces() {
        let place = if face.len() == 4 {
            &mut quads
        } else {
            &mut polygons
        };
        seeds.push([face.start, *place]);
        *place += u32::try_from(face.len()).expect("a small mesh");
    }
    expect_same_mesh(&steps, &planned, seeds.iter().copied())?;
    if side == 1 {
        return Ok(());
    }
    // The corner of a block far from its row 0 and column 0 lies in the face of the vertex's first half-edge.
    let joined = Connectivity::new(&planned).expect("a manifold");
    for ([_, h], face) in seeds.into_iter().zip(faces()) {
        let vertex = base.origin(face.start);
        if base.outgoing(vertex) == Some(face.start) {
            let corner = plan.vertex(vertex, side - 1, side - 1);
            expect_equal(&corner, &joined.origin(h))?;
        }
    }
    Ok(())
}

/// **What a plan of Doo-Sabin holds.** With $V_0$ vertices and $E_0$ edges of a mesh in which four edges meet in every inner vertex, $k$ levels make $4^kV_0$ points. Of the faces, $(2^k-1)^2V_0$ lie within a block, $2^k-1$ along each edge, and one in each face, with as many corners as the face. So the extraordinary faces stay as they
/// are while all else multiplies, and $V-E+F$ is that of the mesh.
///
/// Course: D17, slides 69-70, Doo-Sabin: how the new points are joined.
#[test]
fn plan_of_doo_sabin_has_the_steps_counts() {
    let law = law("subdivision::plan_of_doo_sabin_has_the_steps_counts");
    let choices = || (corner_rules(), 0..5_u32);
    let inputs = (topologies(), choices());
    law.holds(inputs, (hard_topologies(), choices()), |input| {
        let (topology, (corners, levels)) = input;
        counted(topology, *corners, *levels)
    });
}

fn counted(topology: &Topology, corners: Corners, levels: u32) -> Verdict {
    let before = topology.connectivity();
    let weights = DooSabinWeights::Own;
    let plan = Refinement::doo_sabin(&before, levels, weights, corners).expect("a small mesh");
    let foretold = (0..levels).fold(Counts::of(&before), |counts, _| {
        counts.after_doo_sabin(corners).expect("a small mesh")
    });
    let mesh = plan
        .mesh(&vec![0.0; topology.vertex_count])
        .expect("a mesh");
    let after = Connectivity::new(&mesh).expect("a manifold");
    expect_equal(&foretold, &Counts::of(&after))?;
    let characteristic = Connectivity::euler_characteristic;
    expect_equal(&characteristic(&before), &characteristic(&after))?;
    let (steps, base) = patchwork(&flat(topology), levels, corners);
    let side = 1_usize << (levels - steps);
    let others = (0..).take(base.face_count());
    let others = others.filter(|&face| base.half_edges_of(face).len() != 4);
    let inside = (side - 1) * (side - 1) * base.vertex_count();
    let faces = inside + (side - 1) * base.edge_count() + base.face_count();
    expect_equal(&(side * side * base.vertex_count()), &plan.vertex_count())?;
    if is_patchwork(&base, corners) {
        expect_equal(&others.count(), &plan.polygons().len())?;
    }
    expect_equal(&faces, &(plan.quad_count() + plan.polygons().len()))
}

/// **The same bits on any number of threads.** Each point of a plan is computed by one block, with the same operations whoever works on which block, in fresh memory or in used memory.
///
/// Course: D13, slide 64, Doo-Sabin extends Chaikin's scheme.
#[test]
fn plan_of_doo_sabin_has_the_same_bits_on_any_number_of_threads() {
    let law = law("subdivision::plan_of_doo_sabin_has_the_same_bits_on_any_number_of_threads");
    let threads = Threads::new();
    let choices = || (corner_rules(), weights(), 1..5_u32);
    let inputs = (float_meshes(topologies()), choices());
    let hard = (float_meshes(hard_topologies()), choices());
    law.holds(inputs, hard, |(cage, (corners, weights, levels))| {
        let (joined, points) = (cage.connectivity(), &cage.mesh.positions);
        let plan =
            Refinement::doo_sabin(&joined, *levels, *weights, *corners).expect("a small mesh");
        threads.expect_same_bits(&plan, points)
    });
}

/// **The boundary minds its own points.** Whatever the points inside are, the points of a plan along the boundary are the same, bit by bit: two meshes that meet along a boundary meet there on every level.
///
/// Course: D27, slide 78, boundaries: they follow the scheme of a curve.
#[test]
fn boundary_of_a_plan_of_doo_sabin_depends_on_the_boundary_alone() {
    let law = law("subdivision::boundary_of_a_plan_of_doo_sabin_depends_on_the_boundary_alone");
    let choices = || (corner_rules(), weights(), 1..5_u32);
    let inputs = (float_meshes(topologies()), choices());
    let hard = (float_meshes(hard_topologies()), choices());
    law.holds(inputs, hard, |(cage, (corners, weights, levels))| {
        let joined = cage.connectivity();
        let plan =
            Refinement::doo_sabin(&joined, *levels, *weights, *corners).expect("a small mesh");
        let mut points = cage.mesh.positions.clone();
        let before = plan.positions(&points);
        for (vertex, point) in (0..).zip(&mut points) {
            if !joined.is_boundary_vertex(vertex) {
                *point = [1.0, 2.0, f64::from(vertex)];
            }
        }
        let [Ok(before), Ok(after)] = [before, plan.positions(&points)] else {
            return Ok(());
        };
        let mesh = plan.mesh(&points).expect("finite points");
        let refined = Connectivity::new(&mesh).expect("a manifold");
        let on_boundary = |&vertex: &u32| refined.is_boundary_vertex(vertex);
        let vertices = (0..).take(refined.vertex_count()).filter(on_boundary);
        vertices
            .into_iter()
            .try_for_each(|vertex| expect_equal(&before[vertex as usize], &after[vertex as usize]))
    });
}

/// **A plan of Doo-Sabin is small.** The plan and the room it works in take at most a fifth of the memory of what they write (points of three single-precision coordinates, faces of four indices): from the cube through seven levels, from 4000 quadrilaterals or triangles through three or four.
///
/// Course: D28, slide 79, what a level costs.
#[test]
fn plan_of_doo_sabin_is_small() {
    for (topology, levels) in [
        (cube_faces(), 7),
        (torus(80, 50), 3),
        (torus(80, 50), 4),
        (grid(80, 50), 3),
        (triangle_torus(50, 40), 4),
    ] {
        let (weights, corners) = (DooSabinWeights::Own, Corners::Sharp);
        let joined = topology.connectivity();
        let plan = Refinement::doo_sabin(&joined, levels, weights, corners).expect("a small mesh");
        let points = vec![[0.0_f32; 3]; topology.vertex_count];
        let mut positions = vec![[0.0_f32; 3]; plan.vertex_count()];
        let mut scratch = Scratch::new();
        let pool = rayon::ThreadPoolBuilder::new().num_threads(2).build();
        let pool = pool.expect("threads");
        let outcome = pool.install(|| plan.positions_into(&points, &mut scratch, &mut positions));
        assert_eq!(outcome, Ok(()));
        let polygons: usize = plan.polygons().iter().map(Vec::len).sum();
        let output = size_of_val(&positions[..]) + 4 * (4 * plan.quad_count() + polygons);
        let beside = plan.bytes() + scratch.bytes();
        let share = beside as f64 / output as f64;
        println!("{}, {levels} levels: {share:.3}", topology.name);
        let verdict = expect_at_most("memory beside the output", 0.2, share);
        assert!(verdict.is_ok(), "{verdict:?}");
    }
}
