//! Meshes that no scheme can take, each refused by name, and odd ones that are sound.

use facette::mesh::{Mesh, MeshError, Obj, write_obj};
use facette::subdivision::{
    Connectivity, Corners, SubdivisionError, catmull_clark, loop_subdivision, repaired,
};

use crate::meshes::{cube, pyramid};
use crate::scratch::Scratch;

fn mesh(vertices: usize, faces: &[&[u32]]) -> Mesh<f64> {
    let positions = (0..i32::try_from(vertices).expect("a small mesh")).map(f64::from);
    Mesh::new(positions.collect(), faces).expect("the faces name vertices that are there")
}

/// The refusal of a mesh, and how it reads; repair mends the mesh.
fn refusal(vertices: usize, faces: &[&[u32]]) -> (SubdivisionError, String) {
    let mesh = mesh(vertices, faces);
    let refusal = Connectivity::new(&mesh).expect_err("not a manifold");
    let (mended, _) = repaired(&mesh).expect("finite points");
    assert!(Connectivity::new(&mended).is_ok(), "{refusal}");
    let text = refusal.to_string();
    (refusal, text)
}

/// **Refused by name.** A face that visits a vertex twice, a face that is there twice (turned over or not), an edge with three faces, two neighbours of which one is turned over, and two fans that touch in one vertex: each is refused with the element that is wrong. Repair mends each of them.
#[test]
fn unsound_meshes_are_refused_by_name() {
    let cases: [(usize, &[&[u32]], SubdivisionError); 6] = [
        (
            4,
            &[&[0, 1, 2], &[0, 1, 3, 1]],
            SubdivisionError::VertexRepeated { face: 1, vertex: 1 },
        ),
        (
            3,
            &[&[0, 1, 2], &[1, 2, 0]],
            SubdivisionError::FaceRepeated { face: 1, first: 0 },
        ),
        (
            3,
            &[&[0, 1, 2], &[0, 2, 1]],
            SubdivisionError::FaceRepeated { face: 1, first: 0 },
        ),
        (
            5,
            &[&[0, 1, 2], &[1, 0, 3], &[0, 1, 4]],
            SubdivisionError::NonManifoldEdge {
                edge: [0, 1],
                count: 3,
            },
        ),
        (
            4,
            &[&[0, 1, 2], &[0, 1, 3]],
            SubdivisionError::InconsistentOrientation {
                edge: [0, 1],
                faces: [0, 1],
            },
        ),
        (
            5,
            &[&[0, 1, 2], &[0, 3, 4]],
            SubdivisionError::NonManifoldVertex { vertex: 0, fans: 2 },
        ),
    ];
    for (vertices, faces, expected) in cases {
        assert_eq!(refusal(vertices, faces).0, expected);
    }
    let (_, text) = refusal(5, &[&[0, 1, 2], &[1, 0, 3], &[0, 1, 4]]);
    assert_eq!(
        text,
        "3 faces meet along the edge from vertex 0 to vertex 1: at most 2 can"
    );
}

/// **A corner that stands twice.** A face that visits a vertex twice in a row has only one corner too many. Repair drops that corner and keeps the face; a face that comes back to a vertex later is no polygon, and is left out.
#[test]
fn corner_that_stands_twice_is_dropped() {
    let doubled = mesh(4, &[&[0, 1, 1, 2], &[2, 1, 3, 2], &[0, 1, 0, 3]]);
    let (mended, repair) = repaired(&doubled).expect("finite points");
    let faces: Vec<_> = mended.faces().collect();
    assert_eq!(faces, [&[0, 1, 2], &[2, 1, 3]]);
    assert_eq!((repair.corners_dropped, repair.faces_dropped), (2, 1));
    assert_eq!((repair.faces_turned, repair.vertices_added), (0, 0));
}

/// **Two tetrahedra that share a vertex.** Both are closed, and every edge has two faces; only the walk around the shared vertex tells that it meets but one of them. Repair gives each tetrahedron a vertex of its own.
#[test]
fn two_tetrahedra_that_share_a_vertex_are_cut_apart() {
    let faces: [&[u32]; 8] = [
        &[0, 2, 1],
        &[0, 1, 3],
        &[1, 2, 3],
        &[2, 0, 3],
        &[3, 5, 4],
        &[3, 4, 6],
        &[4, 5, 6],
        &[5, 3, 6],
    ];
    let (refused, _) = refusal(7, &faces);
    assert_eq!(
        refused,
        SubdivisionError::NonManifoldVertex { vertex: 3, fans: 2 }
    );
    let (mended, repair) = repaired(&mesh(7, &faces)).expect("finite points");
    assert_eq!((repair.vertices_added, mended.positions[7]), (1, 3.0));
    let joined = Connectivity::new(&mended).expect("two spheres");
    assert_eq!(joined.euler_characteristic(), 4);
}

/// **A Möbius band.** Its faces cannot all be turned to agree. It is refused where two of them run the same way; repair cuts it open along one edge, and a band with two sides is left.
#[test]
fn moebius_band_is_cut_open() {
    let faces: Vec<Vec<u32>> = (0..5)
        .map(|i| {
            let [a, b] = [2 * i, 2 * i + 1];
            if i == 4 {
                vec![a, 1, 0, b]
            } else {
                vec![a, a + 2, b + 2, b]
            }
        })
        .collect();
    let faces: Vec<&[u32]> = faces.iter().map(|face| &face[..]).collect();
    let (refused, _) = refusal(10, &faces);
    assert!(
        matches!(refused, SubdivisionError::InconsistentOrientation { .. }),
        "{refused}"
    );
    let (mended, repair) = repaired(&mesh(10, &faces)).expect("finite points");
    assert_eq!(repair.vertices_added, 2);
    let joined = Connectivity::new(&mended).expect("a strip");
    assert_eq!(joined.euler_characteristic(), 1);
}

/// **No face of two corners.** A face needs three corners; a mesh refuses less before any scheme sees it.
#[test]
fn face_of_two_corners_is_no_face() {
    let refused = Mesh::new(vec![0.0, 1.0], [[0, 1]]).expect_err("a 2-gon");
    assert_eq!(refused, MeshError::FaceTooSmall { face: 0, found: 2 });
}

/// **Sound, though odd.** Faces without area, vertices without a face, a single triangle, several vertices in one place: the connectivity does not look at the points, so all of these can be refined.
#[test]
fn faces_without_area_are_fine() {
    let flat = Mesh::new(vec![[0.5; 3]; 5], [[0, 1, 2], [0, 2, 3]]).expect("a mesh");
    let joined = Connectivity::new(&flat).expect("two triangles");
    let refined = catmull_clark(&joined, &flat.positions, Corners::Sharp).expect("a mesh");
    assert_eq!(refined.positions, [[0.5; 3]; 5 + 5 + 2]);
    assert_eq!(joined.outgoing(4), None);
    let refined = loop_subdivision(&joined, &flat.positions, Corners::Smooth).expect("a mesh");
    assert_eq!(refined.positions, [[0.5; 3]; 5 + 5]);
}

/// **Wrong requests.** A scheme for triangles names the first face that is none; a number of points that is not that of the vertices is refused; and so is a coordinate that is not finite.
#[test]
fn wrong_requests_are_refused_by_name() {
    let pyramid = pyramid(4).with_points(vec![0.0; 5]);
    let joined = Connectivity::new(&pyramid).expect("a closed mesh");
    let refused = loop_subdivision(&joined, &pyramid.positions, Corners::Sharp);
    assert_eq!(
        refused,
        Err(SubdivisionError::NotATriangle { face: 0, found: 4 })
    );
    let refused = catmull_clark(&joined, &[0.0; 4], Corners::Sharp).expect_err("4 points");
    assert_eq!(
        refused,
        SubdivisionError::PointCount {
            found: 4,
            expected: 5
        }
    );
    assert_eq!(
        refused.to_string(),
        "4 points for 5 vertices: there must be one for each"
    );
    let mut points = pyramid.positions.clone();
    points[2] = f64::NAN;
    let refused = catmull_clark(&joined, &points, Corners::Sharp).expect_err("not a number");
    assert!(
        refused
            .to_string()
            .contains("every coordinate must be finite"),
        "{refused}"
    );
}

/// **Polygons stay polygons in a file.** A mesh of faces with three, four and five corners is written to an OBJ file and read again with the same faces: nothing is cut into triangles on the way.
#[test]
fn polygons_stay_polygons_in_a_file() {
    let scratch = Scratch::new();
    let path = scratch.path("cage.obj");
    let positions = (0..6_i32)
        .map(|i| [f64::from(i), f64::from(i * i % 5), 0.25])
        .collect();
    let cage = pyramid(5).with_points(positions);
    write_obj(&path, "cage", &cage).expect("a writable folder");
    let read = Obj::read(&path)
        .expect("an OBJ file")
        .mesh()
        .expect("a mesh");
    assert_eq!(read, cage);
    let text = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nf 1 2 3 4\nf 2 5 3\n";
    let read = Obj::parse("cage.obj", text)
        .expect("an OBJ file")
        .mesh()
        .expect("a mesh");
    assert_eq!(
        read.faces().collect::<Vec<_>>(),
        [&[0, 1, 2, 3][..], &[1, 4, 2]]
    );
    assert_eq!(
        Connectivity::new(&read).expect("a manifold").edge_count(),
        6
    );
    assert!(Connectivity::new(&cube::<f64>()).is_ok());
}
