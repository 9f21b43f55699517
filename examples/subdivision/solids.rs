//! Two closed control meshes of a few faces.

use facette::algebra::Real;
use facette::mesh::Mesh;

/// The cube with corners ±1: three faces around each vertex.
pub fn cube<S: Real>() -> Mesh<[S; 3]> {
    let corner = |k: i32| [0, 1, 2].map(|axis| S::from_i32(2 * (k >> axis & 1) - 1));
    #[rustfmt::skip]
    let faces = [
        [0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4],
        [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5],
    ];
    Mesh::new((0..8).map(corner).collect(), faces).expect("a cube")
}

/// The octahedron with its tips on the axes, at ±1: four faces around each vertex.
pub fn octahedron<S: Real>() -> Mesh<[S; 3]> {
    let tip = |k: usize| {
        let mut point = [S::zero(); 3];
        point[k / 2] = if k.is_multiple_of(2) {
            S::one()
        } else {
            -S::one()
        };
        point
    };
    #[rustfmt::skip]
    let faces = [
        [0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4],
        [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5],
    ];
    Mesh::new((0..6).map(tip).collect(), faces).expect("an octahedron")
}
