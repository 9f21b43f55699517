//! Faces that a fan cuts wrong, and faces without an inside.

use facette::mesh::Mesh;

use crate::inputs::triangle_normal;

/// **A dart.** The fan from the first corner of a face that is not convex may leave it: here its first triangle lies outside and looks the wrong way,
/// and so does the normal of the inner corner, which has no other triangle. Ears stay inside.
#[test]
fn fan_leaves_a_face_that_is_not_convex() {
    let dart = vec![
        [0.0, 1.0, 0.0],
        [-1.0, -1.0, 0.0],
        [0.0, 0.0, 0.0],
        [1.0, -1.0, 0.0],
    ];
    let upward = |mesh: &Mesh<[f64; 3]>| -> Vec<f64> {
        let points = |triangle: [u32; 3]| triangle.map(|vertex| dart[vertex as usize]);
        mesh.triangles()
            .map(|triangle| triangle_normal(points(triangle))[2])
            .collect()
    };
    let mesh = Mesh::new(dart.clone(), [[1, 2, 3, 0]]).expect("one face");
    assert_eq!(upward(&mesh), [-2.0, 4.0]);
    assert_eq!(upward(&mesh.triangulated()), [1.0, 1.0]);
    assert_eq!(mesh.vertex_normals()[2], [0.0, 0.0, -1.0]);
    assert_eq!(mesh.triangulated().vertex_normals(), [[0.0, 0.0, 1.0]; 4]);
}

/// **Faces without an inside.** A face whose corners lie in line or all in one place, a bow tie, one that names a vertex twice, one that is bent
/// to a saddle, one whose squares overflow: all become $n-2$ triangles of their own corners, and nothing stops.
#[test]
fn face_without_an_inside_becomes_a_fan() {
    let line = |count: i32| {
        (0..count)
            .map(|x| [f64::from(x), 0.0, 0.0])
            .collect::<Vec<_>>()
    };
    let bow_tie = vec![
        [0.0, 0.0, 0.0],
        [1.0, 1.0, 0.0],
        [1.0, 0.0, 0.0],
        [0.0, 1.0, 0.0],
    ];
    let saddle = vec![
        [0.0, 0.0, 1.0],
        [1.0, 0.0, -1.0],
        [1.0, 1.0, 1.0],
        [0.0, 1.0, -1.0],
    ];
    let huge = saddle
        .iter()
        .map(|corner| corner.map(|x| x * f64::MAX))
        .collect();
    let tiny = saddle
        .iter()
        .map(|corner| corner.map(|x| x * f64::from_bits(1)))
        .collect();
    for (corners, face) in [
        (line(5), vec![0, 1, 2, 3, 4]),
        (vec![[2.0; 3]; 4], vec![0, 1, 2, 3]),
        (bow_tie.clone(), vec![0, 1, 2, 3]),
        (bow_tie, vec![0, 1, 0, 2, 3]),
        (saddle, vec![0, 1, 2, 3]),
        (huge, vec![0, 1, 2, 3]),
        (tiny, vec![0, 1, 2, 3]),
    ] {
        let mesh = Mesh::new(corners.clone(), [&face]).expect("one face");
        let cut = mesh.triangulated();
        assert_eq!(cut.face_count(), face.len() - 2);
        assert_eq!(cut.positions, corners);
        assert!(cut.faces().all(|triangle| triangle.len() == 3));
        assert!(
            cut.triangles()
                .flatten()
                .all(|vertex| face.contains(&vertex))
        );
    }
}
