//! From the library's meshes to triangles.

use facette::mesh::Mesh;
use glam::DVec3;

use super::geometry::Triangles;

impl From<&Mesh<DVec3>> for Triangles {
    fn from(mesh: &Mesh<DVec3>) -> Self {
        Self {
            positions: mesh.positions.clone(),
            normals: mesh.normals.clone(),
            parameters: mesh.parameters.clone(),
            triangles: mesh.triangles().collect(),
        }
    }
}

impl From<&Mesh<[f64; 3]>> for Triangles {
    fn from(mesh: &Mesh<[f64; 3]>) -> Self {
        let vectors = |list: &[[f64; 3]]| list.iter().map(|&vector| vector.into()).collect();
        Self {
            positions: vectors(&mesh.positions),
            normals: vectors(&mesh.normals),
            parameters: mesh.parameters.clone(),
            triangles: mesh.triangles().collect(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_mesh_of_the_library_keeps_its_positions_and_becomes_triangles() {
        let corners = vec![DVec3::ZERO, DVec3::X, DVec3::X + DVec3::Y, DVec3::Y];
        let mesh = Mesh::new(corners.clone(), [[0, 1, 2, 3]]).expect("a square");
        let triangles = Triangles::from(&mesh);
        assert_eq!(triangles.positions, corners);
        assert_eq!(triangles.triangles.len(), 2);
    }
}
