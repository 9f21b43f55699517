//! What a step does to the numbers of vertices, edges and faces.

use facette::mesh::Mesh;
use facette::subdivision::{Connectivity, Corners, Counts};

use crate::common::law::{Law, LikelyMistake, expect_equal};
use crate::meshes::{
    Topology, hard_topologies, hard_triangle_topologies, topologies, triangle_topologies,
};
use crate::steps::{OF_POLYGONS, OF_TRIANGLES, Scheme, corner_rules};

fn library() -> LikelyMistake {
    LikelyMistake {
        name: "",
        hint: "the library itself breaks this law",
    }
}

fn flat(topology: &Topology) -> Mesh<[crate::common::exact::Exact; 1]> {
    topology.with_points(vec![
        [crate::common::exact::fraction(0, 1)];
        topology.vertex_count
    ])
}

fn counts_of<const N: usize>(mesh: &Mesh<[crate::common::exact::Exact; N]>) -> Counts {
    Counts::of(&Connectivity::new(mesh).expect("a step leaves a manifold"))
}

#[test]
fn steps_keep_eulers_characteristic() {
    let check = |schemes: &'static [Scheme]| {
        move |(topology, corners): &(Topology, Corners)| {
            for scheme in schemes {
                let mut mesh = flat(topology);
                let before = Connectivity::new(&mesh)
                    .expect("a manifold")
                    .euler_characteristic();
                for step in 0..2 {
                    let counted = scheme.counted(counts_of(&mesh), step, *corners);
                    mesh = scheme.step(&mesh, step, *corners);
                    let joined = Connectivity::new(&mesh).expect("a step leaves a manifold");
                    expect_equal(&before, &joined.euler_characteristic())?;
                    let mut got = Counts::of(&joined);
                    if *scheme == Scheme::Sqrt3 {
                        got.corners = counted.corners;
                    }
                    expect_equal(&counted, &got)?;
                }
            }
            Ok(())
        }
    };
    let law = || Law::new("subdivision::steps_keep_eulers_characteristic", library);
    law().holds(
        (topologies(), corner_rules()),
        (hard_topologies(), corner_rules()),
        check(&OF_POLYGONS),
    );
    law().holds(
        (triangle_topologies(), corner_rules()),
        (hard_triangle_topologies(), corner_rules()),
        check(&OF_TRIANGLES),
    );
}
