//! Triangles and meshes that are no hierarchy, and what is said of them.

use facette::intersection::hierarchy::{Hierarchy, HierarchyError, nearest_by_loop};
use facette::mesh::Mesh;
use facette::ray::Ray;
use glam::Vec3;

/// **Corners that are not finite.** They are refused, with the number of the triangle and of the corner.
#[test]
fn corner_that_is_not_finite_is_refused() {
    for bad in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
        let position = Vec3::new(1.0, bad, 2.0);
        let mut triangles = vec![[Vec3::ZERO, Vec3::X, Vec3::Y]; 5];
        triangles[3][2] = position;
        let refusal = Hierarchy::new(&triangles).expect_err("a corner is not finite");
        let HierarchyError::NotFinite {
            triangle, corner, ..
        } = refusal
        else {
            panic!("{refusal}");
        };
        assert_eq!((triangle, corner), (3, 2));
        assert!(
            refusal.to_string().starts_with("corner 2 of triangle 3 is"),
            "{refusal}"
        );
        // The loop, which cannot refuse, never meets such a triangle.
        assert_eq!(
            nearest_by_loop(
                &triangles[3..4],
                &Ray::new(Vec3::new(0.25, 0.25, 1.0), Vec3::NEG_Z)
            ),
            None
        );
    }
}

/// **A mesh beyond single precision.** A corner at $10^{39}$ is finite in double precision, and rounds to infinity in single: the mesh is refused. So is a mesh whose positions were taken away.
#[test]
fn mesh_beyond_single_precision_is_refused() {
    let corners = |far: f64| vec![[0.0; 3], [far, 0.0, 0.0], [0.0, 1.0, 0.0]];
    let of = |far: f64| Mesh::new(corners(far), [[0, 1, 2]]).expect("finite in double precision");
    let kept = Hierarchy::of_mesh(&of(1e38)).expect("finite in single precision");
    assert_eq!(kept.triangles()[0][1], Vec3::X * 1e38);
    assert_eq!(
        Hierarchy::of_mesh(&of(1e39)).expect_err("infinite in single precision"),
        HierarchyError::NotFinite {
            triangle: 0,
            corner: 1,
            position: Vec3::new(f32::INFINITY, 0.0, 0.0),
        }
    );
    let mut short = of(1.0);
    short.positions.pop();
    assert_eq!(
        Hierarchy::of_mesh(&short).expect_err("a vertex without a position"),
        HierarchyError::NoSuchVertex {
            triangle: 0,
            vertex: 2,
            count: 2,
        }
    );
}
