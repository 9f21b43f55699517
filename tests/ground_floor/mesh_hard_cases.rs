//! Meshes and surfaces that make trouble, and what comes of them.

use facette::algebra::{Vector3, VectorSpace};
use facette::mesh::{Mesh, MeshError, tessellate_uniformly};
use facette::surface::Surface;
use glam::Vec3;

use crate::inputs::Saddle;

/// **Meshes that cannot be.** A face of two vertices, a face that names a vertex that does not exist, or a position that is not finite
/// is refused with a message that says which.
#[test]
fn mesh_of_bad_data_is_refused() {
    let square = vec![
        [0.0, 0.0, 0.0],
        [1.0, 0.0, 0.0],
        [1.0, 1.0, 0.0],
        [0.0, 1.0, 0.0],
    ];
    let refusal = |faces: &[Vec<u32>]| {
        let mesh = Mesh::new(square.clone(), faces);
        mesh.expect_err("a refusal").to_string()
    };
    assert_eq!(
        refusal(&[vec![0, 1, 2], vec![2, 3]]),
        "face 1 has 2 vertices: a face needs at least 3"
    );
    assert_eq!(
        refusal(&[vec![]]),
        "face 0 has 0 vertices: a face needs at least 3"
    );
    assert_eq!(
        refusal(&[vec![0, 1, 4]]),
        "face 0 names vertex 4, but the 4 vertices are counted from 0"
    );
    assert_eq!(
        refusal(&[vec![0, 1, u32::MAX]]),
        "face 0 names vertex 4294967295, but the 4 vertices are counted from 0"
    );
    let hole = Mesh::new(vec![[0.0, 0.0], [f64::NAN, 1.0]], [[0, 1, 0]]).expect_err("a refusal");
    assert_eq!(
        hole.to_string(),
        "position 1 is [NaN, 1.0]: every coordinate must be finite"
    );
    let empty = Mesh::new(Vec::<[f64; 3]>::new(), Vec::<[u32; 3]>::new())
        .expect("nothing is wrong with it");
    assert_eq!(
        (empty.face_count(), empty.vertex_normals()),
        (0, Vec::new())
    );
}

/// **Normals at corners.** At the corner of a cube the three faces count alike, so the normal is $(1,1,1)/\sqrt3$. On a flat sheet all
/// normals are the sheet's, exactly. Where two triangles look in opposite directions, the normals cancel and the vertex has none.
#[test]
fn vertex_normals_of_corner_sheet_and_fold() {
    let corner = vec![
        [0.0, 0.0, 0.0],
        [-1.0, 0.0, 0.0],
        [0.0, -1.0, 0.0],
        [0.0, 0.0, -1.0],
    ];
    let corner = Mesh::new(corner, [[0, 1, 2], [0, 2, 3], [0, 3, 1]]).expect("a corner");
    let [x, y, z] = corner.vertex_normals()[0];
    assert_eq!([x, y], [y, z]);
    assert!((x - 1.0 / 3_f64.sqrt()).abs() <= f64::EPSILON);

    let sheet =
        tessellate_uniformly(&flat([[0.0, 3.0], [-1.0, 6.0]]), 3, 7).expect("a usable grid");
    assert!(
        sheet
            .vertex_normals()
            .iter()
            .all(|&normal| normal == [0.0, 0.0, 1.0])
    );

    let fold = vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    let fold = Mesh::new(fold, [[0, 1, 2], [2, 1, 0]]).expect("a fold");
    assert_eq!(fold.vertex_normals(), [[0.0; 3]; 3]);
    let point = Mesh::new(vec![[2.0, 2.0, 2.0]; 3], [[0, 1, 2]]).expect("a point");
    assert_eq!(point.vertex_normals(), [[0.0; 3]; 3]);
}

fn flat(domain: [[f64; 2]; 2]) -> Saddle {
    Saddle {
        domain,
        factor: 0.0,
        has_partials: false,
    }
}

/// **Areas that overflow.** The area of a triangle with sides of $10^{200}$ is infinite and that of one with sides of $10^{-200}$ is zero
/// in floating point. Their normals are as good as any other.
#[test]
fn normals_of_huge_and_tiny_meshes_are_known() {
    for size in [1e200, 1.0, 1e-200] {
        let triangle = vec![
            [size, size, 0.0],
            [2.0 * size, size, 0.0],
            [size, 3.0 * size, 0.0],
        ];
        let mesh = Mesh::new(triangle, [[0, 1, 2]]).expect("a triangle");
        assert_eq!(mesh.vertex_normals(), [[0.0, 0.0, 1.0]; 3]);
    }
    let single = vec![Vec3::ZERO, Vec3::X * 1e-30, Vec3::Y * 1e-30];
    let single = Mesh::new(single, [[0, 1, 2]]).expect("a triangle");
    assert_eq!(single.vertex_normals(), [Vec3::Z; 3]);
}

/// **Grids that cannot be.** A grid without cells, and one with more vertices than a 32-bit number can name, are refused before any
/// memory is asked for; so is a surface with a point that is not finite.
#[test]
fn unusable_grid_is_refused() {
    let surface = flat([[0.0, 1.0], [0.0, 1.0]]);
    for (columns, rows) in [
        (0, 5),
        (5, 0),
        (usize::MAX, 1),
        (1, usize::MAX),
        (usize::MAX, usize::MAX),
        (65535, 65535),
        (u32::MAX as usize, 1),
    ] {
        let refusal = tessellate_uniformly(&surface, columns, rows).expect_err("a refusal");
        assert_eq!(refusal, MeshError::UnusableGrid { columns, rows });
    }
    let message = MeshError::UnusableGrid {
        columns: 0,
        rows: 5,
    }
    .to_string();
    assert!(
        message.starts_with("a grid of 0 x 5 cells: both must be at least 1"),
        "{message}"
    );
    let pole = Saddle {
        domain: [[0.0, 1.0], [0.0, 1.0]],
        factor: f64::INFINITY,
        has_partials: false,
    };
    let refusal = tessellate_uniformly(&pole, 1, 1)
        .expect_err("a refusal")
        .to_string();
    assert!(
        refusal.starts_with("position 0 is [0.0, 0.0, NaN]"),
        "{refusal}"
    );
}

/// A cone with its tip at `v = 0`: there is no normal at the tip.
struct Cone;

impl Surface for Cone {
    type Scalar = f64;
    type Point = [f64; 3];

    fn domain(&self) -> [[f64; 2]; 2] {
        [[0.0, 1.0]; 2]
    }

    fn point(&self, u: f64, v: f64) -> [f64; 3] {
        [v * u, v * (1.0 - u), -v]
    }

    fn partials(&self, u: f64, v: f64) -> Option<[[f64; 3]; 2]> {
        Some([[v, -v, 0.0], [u, 1.0 - u, -1.0]])
    }
}

/// **A point without a normal.** At the tip of a cone $S_u=0$: the surface has no normal there. The tessellation gives the tip the
/// normal of its triangles, and all other vertices the surface's own.
#[test]
fn vertex_without_a_surface_normal_takes_that_of_its_triangles() {
    assert_eq!(Cone.normal_vector(0.5, 0.0), None);
    let mesh = tessellate_uniformly(&Cone, 2, 1).expect("a usable grid");
    let of_triangles = mesh.vertex_normals();
    let third = 1.0 / 3_f64.sqrt();
    for (index, normal) in mesh.normals.iter().enumerate() {
        // The one triangle of the last tip vertex has no area: nothing says where it looks.
        let expected = if index == 2 { [0.0; 3] } else { [third; 3] };
        assert!(
            normal.minus(expected).largest_coordinate() <= f64::EPSILON,
            "{index}: {normal:?}"
        );
    }
    assert_eq!(mesh.normals[1], of_triangles[1]);
}

/// A point with these two tangents.
struct Tangents([[f64; 3]; 2]);

impl Surface for Tangents {
    type Scalar = f64;
    type Point = [f64; 3];

    fn domain(&self) -> [[f64; 2]; 2] {
        [[0.0, 1.0]; 2]
    }

    fn point(&self, _: f64, _: f64) -> [f64; 3] {
        [0.0; 3]
    }

    fn partials(&self, _: f64, _: f64) -> Option<[[f64; 3]; 2]> {
        Some(self.0)
    }
}

/// **Tangents of any length.** Tangents of $10^{-200}$ and $10^{200}$ span a plane, though their vector product underflows or
/// overflows: there is a normal. Tangents that are parallel up to rounding span none, whatever rounding makes of their
/// product.
#[test]
fn normal_is_known_for_tangents_of_any_length_and_not_for_parallel_ones() {
    let normal = |a: [f64; 3], b: [f64; 3]| Tangents([a, b]).normal_vector(0.0, 0.0);
    let (x, y) = ([1.0, 0.0, 0.0], [0.0, 1.0, 0.0]);
    for (long, wide) in [
        (1e-200, 1e-200),
        (1e200, 1e200),
        (1e-300, 1e300),
        (2.0, 0.5),
    ] {
        assert_eq!(normal(x.times(long), y.times(wide)), Some([0.0, 0.0, 1.0]));
        assert_eq!(normal(y.times(long), x.times(wide)), Some([0.0, 0.0, -1.0]));
    }
    let slanted = [0.1, 0.2, 0.3];
    let parallel = slanted.times(0.7);
    assert_ne!(slanted.cross(parallel), [0.0; 3]);
    assert_eq!(normal(slanted, parallel), None);
    assert!(normal(slanted, [0.1, 0.2, 0.3 + 1e-14]).is_some());
    // A coordinate of the product is known up to 8 unit roundoffs: one that is no larger says nothing.
    let known_up_to = 4.0 * f64::EPSILON;
    assert_eq!(normal(x, [1.0, known_up_to, 0.0]), None);
    assert!(normal(x, [1.0, known_up_to * (1.0 + f64::EPSILON), 0.0]).is_some());
    for nothing in [[0.0; 3], [f64::NAN, 1.0, 0.0], [f64::INFINITY, 0.0, 0.0]] {
        assert_eq!(normal(nothing, y), None);
        assert_eq!(normal(y, nothing), None);
    }
}

/// **A list of the wrong length.** The caller brings the list for a grid's points. If its length is not that of the grid, the program
/// has a mistake and stops with the three numbers.
#[test]
#[should_panic(expected = "a grid of 2 x 3 parameters needs 6 places, not 5")]
fn grid_that_does_not_fit_its_list_stops() {
    flat([[0.0, 1.0]; 2]).points_on_grid(&[0.0, 1.0], &[0.0, 0.5, 1.0], &mut [[0.0; 3]; 5]);
}

/// **Large and tiny triangles in one mesh.** Each vertex weighs its triangles by its own scale: a triangle of side $10^{-30}$ beside one of side $10^{30}$ has its
/// normal, and an unused vertex far away changes nothing. Coordinates near the largest number do not overflow.
#[test]
fn vertex_normals_have_a_scale_of_their_own() {
    let triangle = |side: f64| [[0.0, 0.0, 0.0], [side, 0.0, 0.0], [0.0, side, 0.0]];
    let [tiny, large] = [triangle(1e-200), triangle(1e200)];
    let far = [[1e250, -1e250, 1e250]];
    let positions = [&tiny[..], &large[..], &far[..]].concat();
    let mesh = Mesh::new(positions, [[0, 1, 2], [3, 4, 5]]).expect("finite positions");
    let up = [0.0, 0.0, 1.0];
    assert_eq!(
        mesh.vertex_normals(),
        [[up; 6].to_vec(), vec![[0.0; 3]]].concat()
    );
    let huge = [
        [-1.5e308, 0.0, 0.0],
        [1.5e308, 0.0, 0.0],
        [0.0, 1.5e308, 0.0],
    ];
    let mesh = Mesh::new(huge.to_vec(), [[0, 1, 2]]).expect("finite positions");
    assert_eq!(mesh.vertex_normals(), [up; 3]);
}
