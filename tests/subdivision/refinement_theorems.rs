//! Plans against the steps they stand for. The book shows the doc comments.

use facette::mesh::Mesh;
use facette::subdivision::{Connectivity, Corners, Refinement};

use crate::common::exact::Exact;
use crate::common::law::{Law, Verdict};
use crate::meshes::{Cage, hard_meshes, hard_triangle_meshes, meshes, triangle_meshes};
use crate::refinement_match::expect_same_mesh;
use crate::steps::{Scheme, corner_rules, rational_cosine};
use crate::suspects;

type Input = (Cage<[Exact; 3]>, Corners, u32);

fn stepped(
    scheme: Scheme,
    mesh: &Mesh<[Exact; 3]>,
    levels: u32,
    corners: Corners,
) -> Mesh<[Exact; 3]> {
    (0..levels).fold(mesh.clone(), |mesh, step| scheme.step(&mesh, step, corners))
}

/// The refined mesh, with exact cosines.
fn planned(plan: &Refinement, points: &[[Exact; 3]]) -> Mesh<[Exact; 3]> {
    let positions = plan
        .positions_with(points, rational_cosine)
        .expect("a point for each vertex");
    Mesh::new(positions, plan.faces()).expect("a mesh")
}

/// **A plan of Catmull-Clark is its steps.** Refined by patches, through any number of levels, a mesh has the same faces and exactly the same points as after as many steps one by one, up to the numbers of vertices and faces: with faces of any number of sides, vertices of any valence, boundaries, sharp and round corners.
///
/// The first corner of patch $f$ is found without searching: in the steps, face $4^{k-1}h$ lies at the corner $h$ of the mesh, in the plan it is the first of the patch. From there a walk over both meshes at once must meet the same faces.
///
/// Course: D22, slides 72-76, Catmull-Clark: the scheme, level after level.
#[test]
fn plan_of_catmull_clark_is_its_steps() {
    let theorem = "subdivision::plan_of_catmull_clark_is_its_steps";
    let levels = 1..4_u32;
    let inputs = (meshes(), corner_rules(), levels.clone());
    let hard = (hard_meshes(), corner_rules(), levels);
    Law::new(theorem, suspects::library)
        .on_cases(48)
        .holds(inputs, hard, |input: &Input| {
            let (cage, corners, levels) = input;
            catmull_clark_agrees(cage, *corners, *levels)
        });
}

fn catmull_clark_agrees(cage: &Cage<[Exact; 3]>, corners: Corners, levels: u32) -> Verdict {
    let connectivity = cage.connectivity();
    let plan = Refinement::catmull_clark(&connectivity, levels, corners).expect("a small mesh");
    let steps = stepped(Scheme::CatmullClark, &cage.mesh, levels, corners);
    let planned = planned(&plan, &cage.mesh.positions);
    let is_quads = cage.mesh.faces().all(|face| face.len() == 4);
    // The mesh whose faces are the patches, and how many levels it has gone through.
    let before = u32::from(!is_quads);
    let base = stepped(Scheme::CatmullClark, &cage.mesh, before, corners);
    let rest = levels - before;
    let base = Connectivity::new(&base).expect("a manifold");
    let side = 1 << rest;
    let seeds = (0..u32::try_from(base.face_count()).expect("a small mesh")).map(|face| {
        let h = 4 * face;
        // Half-edge h's corner is face 4^(rest−1) h, whose first half-edge has four times its number.
        let in_steps = if rest == 0 { h } else { h << (2 * rest) };
        [in_steps, 4 * face * side * side]
    });
    expect_same_mesh(&steps, &planned, seeds)
}

/// **A plan of Loop is its steps.** The same for triangles: any valence, boundaries, sharp and round corners.
///
/// In the steps the face $4^kf$ lies at the first corner of face $f$, in the plan it is the first of patch $f$.
///
/// Course: D24, slide 77, Loop: the scheme, level after level.
#[test]
fn plan_of_loop_is_its_steps() {
    let theorem = "subdivision::plan_of_loop_is_its_steps";
    let inputs = (triangle_meshes(), corner_rules(), 0..4_u32);
    let hard = (hard_triangle_meshes(), corner_rules(), 0..4_u32);
    Law::new(theorem, suspects::library)
        .on_cases(48)
        .holds(inputs, hard, |input: &Input| {
            let (cage, corners, levels) = input;
            let connectivity = cage.connectivity();
            let plan = Refinement::loop_subdivision(&connectivity, *levels, *corners);
            let plan = plan.expect("a small mesh");
            let steps = stepped(Scheme::Loop, &cage.mesh, *levels, *corners);
            let planned = planned(&plan, &cage.mesh.positions);
            let faces = 0..u32::try_from(connectivity.face_count()).expect("a small mesh");
            let seeds = faces.map(|face| [(3 * face) << (2 * levels); 2]);
            expect_same_mesh(&steps, &planned, seeds)
        });
}
