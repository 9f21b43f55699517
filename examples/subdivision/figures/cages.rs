//! The cages of the pictures, and scenes with them.

use facette::mesh::{Mesh, Obj};
use facette::subdivision::Corners;
use facette_figure::palette::Colour;
use facette_figure::render::{Material, Scene, Triangles, View};
use glam::DVec3;

use super::scheme::Scheme;

/// The chapter's cage: a piggy bank.
pub fn piggy_bank() -> Mesh<DVec3> {
    let file = Obj::parse("cage.obj", include_str!("../cage.obj"));
    let file = file.expect("the cage is in the repository");
    let positions = file.positions.iter().copied().map(DVec3::from).collect();
    let faces = file.polygons.iter().map(|polygon| &polygon.vertices);
    Mesh::new(positions, faces).expect("a file's faces name its vertices")
}

/// A saddle of three by three squares, with two corners up and two down.
pub fn handkerchief() -> Mesh<DVec3> {
    let along = || (0..4_i32).map(|i| f64::from(2 * i - 3) / 3.0);
    let positions = along().flat_map(|z| along().map(move |x| DVec3::new(x, 0.4 * x * z, z)));
    let corners = (0..3_u32).flat_map(|row| (0..3).map(move |column| 4 * row + column));
    let faces = corners.map(|a| [a, a + 4, a + 5, a + 1]);
    Mesh::new(positions.collect(), faces).expect("sixteen finite points")
}

/// The cage as a scheme takes it: cut into triangles where it wants them.
pub fn cage_for(scheme: Scheme, cage: &Mesh<DVec3>) -> Mesh<DVec3> {
    if scheme.wants_triangles() {
        cage.triangulated()
    } else {
        cage.clone()
    }
}

/// A cage after so many steps.
pub fn refined(scheme: Scheme, cage: &Mesh<DVec3>, levels: u32, corners: Corners) -> Mesh<DVec3> {
    let cage = cage_for(scheme, cage);
    let fine = scheme.refined(&cage, levels, corners);
    fine.expect("the pictures' cages are manifolds")
}

/// The limit surface of a cage, at the vertices after four steps.
pub fn limit(scheme: Scheme, cage: &Mesh<DVec3>, corners: Corners) -> Mesh<DVec3> {
    let fine = refined(scheme, cage, 4, corners);
    let limit = scheme.on_limit(&fine, corners);
    limit.expect("steps make manifolds")
}

/// The whole of a mesh in a picture of this size, from the left above in front as the bank sees it.
pub fn view_of(mesh: &Mesh<DVec3>, size: [u32; 2]) -> View {
    View::around(&mesh.positions, DVec3::new(1.0, 0.75, 1.0), size)
}

/// A scene with a mesh: smooth where it has normals, flat where not.
pub fn scene_of(view: View, mesh: &Mesh<DVec3>, colour: Colour) -> Scene {
    Scene::new(view).surface(&mesh.triangulated(), Material::matte(colour))
}

/// The edges of a mesh as square bars of this half width, for a scene.
pub fn bars(mesh: &Mesh<DVec3>, half_width: f64) -> Triangles {
    let mut bars = Triangles::default();
    for face in mesh.faces() {
        let next = face.iter().cycle().skip(1);
        for (&from, &to) in face.iter().zip(next) {
            // An edge of two faces is drawn twice, in the same place: that costs nothing that is seen.
            let ends = [from, to].map(|vertex| mesh.positions[vertex as usize]);
            add_bar(&mut bars, ends, half_width);
        }
    }
    bars
}

fn add_bar(bars: &mut Triangles, [from, to]: [DVec3; 2], half_width: f64) {
    let Some(along) = (to - from).try_normalize() else {
        return;
    };
    let side = along.any_orthonormal_vector() * half_width;
    let other = along.cross(side);
    let first = u32::try_from(bars.positions.len()).expect("a picture has fewer edges");
    for end in [from, to] {
        let around = [side, other, -side, -other];
        bars.positions.extend(around.map(|offset| end + offset));
    }
    for i in 0..4 {
        let [a, b] = [first + i, first + (i + 1) % 4];
        bars.triangles.extend([[a, b, b + 4], [a, b + 4, a + 4]]);
    }
}
