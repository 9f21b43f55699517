//! What steps do to the numbers of vertices, edges and faces. The book shows the doc comments.

use facette::mesh::Mesh;
use facette::subdivision::{Connectivity, Corners, Counts};
use proptest::prelude::*;

use crate::common::exact::Exact;
use crate::common::law::{Law, Verdict, expect_equal};
use crate::meshes::{
    Topology, hard_topologies, hard_triangle_topologies, random_triangles, topologies, torus,
    triangle_topologies,
};
use crate::steps::{OF_POLYGONS, OF_TRIANGLES, Scheme, corner_rules, flat};
use crate::suspects;

fn holds_for_all(theorem: &'static str, check: impl Fn(Scheme, &Topology, Corners) -> Verdict) {
    let with = |schemes: &[Scheme], (topology, corners): &(Topology, Corners)| {
        schemes
            .iter()
            .try_for_each(|&scheme| check(scheme, topology, *corners))
    };
    let law = || Law::new(theorem, suspects::library);
    let polygons = (topologies(), corner_rules());
    law().holds(polygons, (hard_topologies(), corner_rules()), |input| {
        with(&OF_POLYGONS, input)
    });
    let triangles = (triangle_topologies(), corner_rules());
    let hard = (hard_triangle_topologies(), corner_rules());
    law().holds(triangles, hard, |input| with(&OF_TRIANGLES, input));
}

fn joined(mesh: &Mesh<[Exact; 1]>) -> Connectivity {
    Connectivity::new(mesh).expect("a step leaves a manifold")
}

/// **Euler's characteristic.** No step tears or glues: the refined mesh is again a consistently oriented manifold, it has a boundary only if the mesh before had one, and $V-E+F$ is the same (2 on a sphere, 0 on a torus, 1 on a disk; vertices without a face do not count).
///
/// Course: D17, slides 69-70, Doo-Sabin: how the new points are joined.
#[test]
fn steps_keep_eulers_characteristic() {
    let theorem = "subdivision::steps_keep_eulers_characteristic";
    holds_for_all(theorem, |scheme, topology, corners| {
        let mut mesh = flat(topology);
        let before = joined(&mesh);
        let is_closed = |joined: &Connectivity| 2 * joined.edge_count() == joined.half_edge_count();
        for step in 0..2 {
            mesh = scheme.step(&mesh, step, corners);
            let after = joined(&mesh);
            expect_equal(
                &before.euler_characteristic(),
                &after.euler_characteristic(),
            )?;
            expect_equal(&is_closed(&before), &is_closed(&after))?;
        }
        Ok(())
    });
}

/// **The counts are known before the step.** From the numbers of vertices, edges, faces and corners of faces, of boundary edges and of single-face corners follow those after a step, so a refinement that 32-bit numbers cannot name is refused before any memory is asked for.
///
/// Course: D28, slide 79, √3: fewer triangles than Loop.
#[test]
fn counts_are_known_before_the_step() {
    let theorem = "subdivision::counts_are_known_before_the_step";
    holds_for_all(theorem, |scheme, topology, corners| {
        let mut mesh = flat(topology);
        for step in 0..2 {
            let foretold = scheme.counted(Counts::of(&joined(&mesh)), step, corners);
            mesh = scheme.step(&mesh, step, corners);
            let mut counted = Counts::of(&joined(&mesh));
            if scheme == Scheme::Sqrt3 {
                // A step that keeps the boundary gives a corner its second triangle, which the next one takes away.
                counted.corners = foretold.corners;
            }
            expect_equal(&foretold, &counted)?;
        }
        Ok(())
    });
}

/// **After k steps.** On a closed mesh with $\sum n_f=2E$ corners of faces, $k\ge1$ steps make
/// $$\begin{aligned}
/// \text{Catmull-Clark}\quad&F_k=2E\cdot4^{k-1},&E_k&=2F_k,&V_k&=F_k+\chi,\\
/// \text{Doo-Sabin}\quad&V_k=2E\cdot4^{k-1},&E_k&=2V_k,&F_k&=V_k+\chi,\\
/// \text{Loop}\quad&F_k=4^kF,&E_k&=\tfrac32F_k,&V_k&=\tfrac12F_k+\chi,\\
/// \sqrt3\quad&F_k=3^kF,&E_k&=\tfrac32F_k,&V_k&=\tfrac12F_k+\chi,
/// \end{aligned}$$
/// with Euler's characteristic $\chi=V-E+F$ of the mesh.
///
/// Course: D28, slide 79, √3: fewer triangles than Loop.
#[test]
fn counts_after_k_steps_are_powers() {
    let law = || {
        Law::new(
            "subdivision::counts_after_k_steps_are_powers",
            suspects::library,
        )
    };
    let closed = || {
        let is_closed =
            |topology: &Topology| Counts::of(&topology.connectivity()).boundary_edges == 0;
        random_triangles().prop_filter("closed", is_closed)
    };
    let check = |schemes: &'static [Scheme]| {
        move |topology: &Topology| {
            let start = topology.connectivity();
            let chi = start.euler_characteristic();
            let number = |count: u64| i64::try_from(count).expect("a small mesh");
            for &scheme in schemes {
                let mut counts = Counts::of(&start);
                let [e, f] = [counts.edges, counts.faces].map(number);
                for k in 1..=5_u32 {
                    counts = scheme.counted(counts, k - 1, Corners::Sharp);
                    let [four, three] = [4_i64, 3].map(|base| base.pow(k));
                    let expected = match scheme {
                        Scheme::CatmullClark => [e * four / 2 + chi, e * four, e * four / 2],
                        Scheme::DooSabin(_) => [e * four / 2, e * four, e * four / 2 + chi],
                        Scheme::Loop => [f * four / 2 + chi, f * four / 2 * 3, f * four],
                        Scheme::Sqrt3 => [f * three / 2 + chi, f * three / 2 * 3, f * three],
                    };
                    let got = [counts.vertices, counts.edges, counts.faces].map(number);
                    expect_equal(&expected, &got)?;
                }
            }
            Ok(())
        }
    };
    law().holds(
        closed(),
        Just(crate::meshes::tetrahedron_faces()),
        check(&OF_TRIANGLES),
    );
    let tori = (3..9_u32, 3..9_u32).prop_map(|(columns, rows)| torus(columns, rows));
    law().holds(tori, Just(crate::meshes::prism(20)), check(&OF_POLYGONS));
}

/// **Triangles for Loop and √3.** At each step Loop's scheme makes four triangles of one, √3 three: after $k$ steps √3 has $(3/4)^k$ as many, and its number grows in smaller leaps. But an edge is halved by Loop's step and divided by $\sqrt3$ by the other: for edges shorter by a factor $r$ both need $r^2$ times as many triangles.
///
/// Course: D28, slide 79, √3: fewer triangles than Loop.
#[test]
fn sqrt3_makes_fewer_triangles_than_loop_at_each_step() {
    let start = Counts::of(&crate::meshes::octahedron_faces().connectivity());
    let [mut by_loop, mut by_sqrt3] = [start; 2];
    let mut table = Vec::new();
    for step in 0..6 {
        by_loop = Scheme::Loop.counted(by_loop, step, Corners::Sharp);
        by_sqrt3 = Scheme::Sqrt3.counted(by_sqrt3, step, Corners::Sharp);
        table.push([by_loop.faces, by_sqrt3.faces]);
    }
    let expected = [
        [32, 24],
        [128, 72],
        [512, 216],
        [2048, 648],
        [8192, 1944],
        [32768, 5832],
    ];
    assert_eq!(table, expected);
}
