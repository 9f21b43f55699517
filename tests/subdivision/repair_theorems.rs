//! The theorems of connectivity and repair. The book shows their doc comments.

use facette::mesh::Mesh;
use facette::subdivision::{Connectivity, Repair, repaired};
use proptest::collection::vec;
use proptest::prelude::*;

use crate::common::law::{Broken, Law, expect_equal};
use crate::meshes::{Topology, hard_topologies, topologies};
use crate::suspects;

fn law(theorem: &'static str) -> Law {
    Law::new(theorem, suspects::library)
}

fn numbered(count: usize) -> Vec<f64> {
    (0..i32::try_from(count).expect("a small mesh"))
        .map(f64::from)
        .collect()
}

/// Faces of 3 to 5 corners out of `vertices` vertices, without regard to anything.
fn any_faces(vertices: u32, faces: usize) -> impl Strategy<Value = Vec<Vec<u32>>> {
    vec(vec(0..vertices, 3..=5), 0..=faces)
}

/// **Whatever the faces, repair makes a manifold.** For any list of faces, with repeated corners, repeated faces, faces turned over, edges with many faces and vertices where fans only touch, repair leaves a mesh whose half-edges can be joined. It moves no point: each vertex that it adds stands where one of the
/// old vertices stands, and no face gets new corners. Repairing again changes nothing.
///
/// Course: plan, slide 49, meshes as input of a scheme.
#[test]
fn repaired_meshes_can_be_joined() {
    let law = law("subdivision::repaired_meshes_can_be_joined").on_cases(256);
    law.holds(any_faces(8, 12), any_faces(4, 12), |faces| {
        let mesh = Mesh::new(numbered(8), faces).expect("the faces name vertices that are there");
        let (mended, repair) = repaired(&mesh).expect("finite points");
        if let Err(refusal) = Connectivity::new(&mended) {
            return Err(Broken {
                expected: "a manifold".to_owned(),
                got: refusal.to_string(),
            });
        }
        expect_equal(&(8 + repair.vertices_added), &mended.positions.len())?;
        expect_equal(&numbered(8), &mended.positions[..8].to_vec())?;
        expect_equal(&faces.len(), &(mended.face_count() + repair.faces_dropped))?;
        // A face as the old vertices that its corners stand on.
        let places = |face: &[u32]| {
            let mut places: Vec<i64> = face
                .iter()
                .map(|&v| whole(mended.positions[v as usize]))
                .collect();
            places.sort_unstable();
            places
        };
        for face in mended.faces() {
            let is_old = |old: &Vec<u32>| {
                let mut old: Vec<i64> = old.iter().map(|&v| i64::from(v)).collect();
                old.sort_unstable();
                old.dedup();
                old == places(face)
            };
            expect_equal(&true, &faces.iter().any(is_old))?;
        }
        let (again, nothing) = repaired(&mended).expect("finite points");
        expect_equal(&(mended, Repair::default()), &(again, nothing))
    });
}

#[allow(
    clippy::cast_possible_truncation,
    reason = "the positions are small whole numbers"
)]
fn whole(position: f64) -> i64 {
    position as i64
}

/// **A sound mesh is left alone.** Repair changes no manifold, with or without boundary: not a point, not a face, not the order of its corners.
///
/// Course: plan, slide 49, meshes as input of a scheme.
#[test]
fn sound_meshes_are_left_alone() {
    let law = law("subdivision::sound_meshes_are_left_alone");
    law.holds(topologies(), hard_topologies(), |topology| {
        let mesh = topology.with_points(numbered(topology.vertex_count));
        let unchanged = (mesh.clone(), Repair::default());
        expect_equal(&unchanged, &repaired(&mesh).expect("finite points"))
    });
}

/// **Turned faces are turned back.** If some faces of a manifold are turned over, repair turns faces until all agree with the first one that they hang together with. It cuts nothing: no vertex is added, and every face is the old one or that turned over.
///
/// Course: plan, slide 49, meshes as input of a scheme.
#[test]
fn turned_faces_are_turned_back() {
    let law = law("subdivision::turned_faces_are_turned_back");
    let turns = || vec(any::<bool>(), 64);
    law.holds(
        (topologies(), turns()),
        (hard_topologies(), turns()),
        |(topology, turns)| {
            let faces = topology.faces.iter().zip(turns.iter().cycle());
            let turned = faces.map(|(face, &is_turned)| {
                let mut face = face.clone();
                if is_turned {
                    face.reverse();
                }
                face
            });
            let mesh = Mesh::new(numbered(topology.vertex_count), turned).expect("a mesh");
            let (mended, repair) = repaired(&mesh).expect("finite points");
            let expected = Repair {
                faces_turned: repair.faces_turned,
                ..Repair::default()
            };
            expect_equal(&expected, &repair)?;
            for (old, new) in topology.faces.iter().zip(mended.faces()) {
                let mut turned = old.clone();
                turned.reverse();
                expect_equal(&true, &(old == new || turned == new))?;
            }
            expect_equal(&true, &Connectivity::new(&mended).is_ok())
        },
    );
}

/// **Half-edges know their neighbours.** In a manifold the twin of the twin is the half-edge itself, and it runs the other way. Walking round a vertex meets each of its faces once; the valences of all vertices sum to twice the edges, the corners of all faces to twice the edges less the boundary edges. A boundary comes back
/// to where it began.
///
/// Course: plan, slide 49, meshes as input of a scheme.
#[test]
fn half_edges_know_their_neighbours() {
    let law = law("subdivision::half_edges_know_their_neighbours");
    law.holds(topologies(), hard_topologies(), |topology| {
        let joined = topology.connectivity();
        let mut boundary_edges = 0;
        for h in (0..).take(joined.half_edge_count()) {
            expect_equal(&h, &joined.previous(joined.next(h)))?;
            match joined.twin(h) {
                Some(twin) => {
                    expect_equal(&Some(h), &joined.twin(twin))?;
                    let [ends, turned] = [h, twin].map(|h| [joined.origin(h), joined.target(h)]);
                    expect_equal(&[ends[1], ends[0]], &turned)?;
                    expect_equal(&joined.edge_of(h), &joined.edge_of(twin))?;
                }
                None => boundary_edges += 1,
            }
        }
        let edges = joined.edge_count();
        expect_equal(&(2 * edges - boundary_edges), &joined.half_edge_count())?;
        let mut valences = 0;
        for vertex in (0..).take(joined.vertex_count()) {
            valences += joined.valence(vertex);
            expect_equal(
                &faces_with(topology, vertex),
                &joined.around(vertex).count(),
            )?;
            if let Some([before, after]) = joined.boundary_neighbours(vertex) {
                let neighbours = [before, after].map(|v| joined.boundary_neighbours(v));
                let [Some([_, here]), Some([there, _])] = neighbours else {
                    return expect_equal(&true, &false);
                };
                expect_equal(&[vertex; 2], &[here, there])?;
            }
        }
        expect_equal(&(2 * edges), &valences)
    });
}

fn faces_with(topology: &Topology, vertex: u32) -> usize {
    let faces = topology.faces.iter();
    faces.filter(|face| face.contains(&vertex)).count()
}
