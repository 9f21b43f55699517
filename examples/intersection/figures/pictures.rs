//! The first programs' pictures, and a model from a file.

use std::collections::HashMap;

use facette::camera::{Camera, CameraFrame, ImageSize};
use facette::intersection::{BoundingBox, Group, Sphere};
use facette::mesh::{Mesh, Obj};
use facette_figure::Figure;
use facette_figure::palette::Colour;
use facette_figure::render::{Material, Picture, Scene as Surfaces, View};
use facette_figure::svg::{Panel, panels};
use glam::DVec3;

use super::first_programs::{Scene, first_picture, silhouette};

/// The camera of the first programs: before the scene, a little above it.
pub fn camera(size: ImageSize) -> Camera<DVec3> {
    let (eye, target) = (DVec3::new(0.0, 1.5, 7.0), DVec3::new(0.0, 0.2, 0.0));
    let frame = CameraFrame::looking_at(eye, target, DVec3::Y).expect("the view is not vertical");
    Camera::with_field_of_view(frame, 35_f64.to_radians(), size.aspect())
        .expect("the angle lies between 0 and π")
}

/// The sphere of the first program.
pub fn sphere() -> Sphere<DVec3> {
    ball([-0.5, 0.3, 0.0], 1.1)
}

fn ball([x, y, z]: [f64; 3], radius: f64) -> Sphere<DVec3> {
    Sphere::new(DVec3::new(x, y, z), radius).expect("a sphere of positive radius")
}

/// The scene of the second program: three spheres that run into each other and into a flat box.
pub fn scene() -> Scene {
    let slab = BoundingBox::new(DVec3::new(-2.2, -1.0, -1.6), DVec3::new(2.2, -0.6, 1.4));
    Scene {
        surfaces: Group::new(vec![
            Box::new(slab.expect("the corners are in order")),
            Box::new(sphere()),
            Box::new(ball([0.9, 0.1, 0.5], 0.8)),
            Box::new(ball([1.3, 0.7, -0.7], 0.9)),
        ]),
        colours: [Colour::Faint, Colour::Sky, Colour::Vermilion, Colour::Green]
            .map(Colour::rgb)
            .to_vec(),
    }
}

/// The pictures of the first two programs, `columns` wide and three quarters as high.
pub fn first_pictures(columns: u32) -> [Picture; 2] {
    let size = ImageSize::new(columns, columns * 3 / 4).expect("a picture has pixels");
    let camera = camera(size);
    [
        silhouette(&camera, size, &sphere()),
        first_picture(&camera, size, &scene()),
    ]
}

/// White on a hit, then the nearest surface's colour.
pub fn first_programs() -> Figure {
    let [white, coloured] = first_pictures(736);
    let row = [
        Panel::picture("white on a hit", white),
        Panel::picture("the colour of the nearest", coloured),
    ];
    Figure::drawn(
        "first_programs",
        "The pictures of the first two programs. On the left a ray for each pixel, and white where it meets the sphere. On the right four surfaces, each in its colour: where two run into each other, \
         the border is where the other one becomes the nearest. No light yet, so nothing looks round.",
        "Two black pictures. On the left a white disk. On the right three flat disks, blue, orange and green, that cut into each other and into a grey slab below them.",
        &panels(2, &row),
    )
}

/// The chapter's model, as its file has it.
pub fn pawn() -> Obj {
    Obj::parse("pawn.obj", include_str!("../pawn.obj")).expect("the model is in the repository")
}

/// The model without normals, with computed ones and with those of its file.
pub fn shadings() -> [Mesh<[f64; 3]>; 3] {
    let kept = pawn().mesh_with_normals().expect("a readable model");
    let computed = without_normals(pawn());
    let computed = computed.mesh_with_normals().expect("a readable model");
    let mut flat = computed.clone();
    flat.normals.clear();
    [flat, computed, kept]
}

/// The model as a file without normals would have it: with one vertex for each place.
fn without_normals(mut model: Obj) -> Obj {
    let mut at: HashMap<[u64; 3], u32> = HashMap::new();
    let places = model.positions.iter().map(|place| place.map(f64::to_bits));
    let first: Vec<u32> = places
        .zip(0..)
        .map(|(place, vertex)| *at.entry(place).or_insert(vertex))
        .collect();
    for face in &mut model.polygons {
        face.normals.clear();
        for vertex in &mut face.vertices {
            *vertex = first[*vertex as usize];
        }
    }
    model
}

/// A picture of the model.
pub fn portrait(mesh: &Mesh<[f64; 3]>) -> Surfaces {
    let middle = DVec3::new(0.0, 1.3, 0.0);
    let view = View::perspective(middle + DVec3::new(3.5, 3.0, 6.0), middle, DVec3::Y, 25.0);
    Surfaces::new(view).surface(mesh, Material::matte(Colour::Sky))
}

/// Flat, smeared, right: what normals do.
pub fn normals() -> Figure {
    let labels = [
        "one for each triangle",
        "computed at the vertices",
        "kept from the file",
    ];
    let row: Vec<Panel> = labels
        .iter()
        .zip(shadings())
        .map(|(label, mesh)| Panel::picture(label, portrait(&mesh).render(486, 560)))
        .collect();
    Figure::drawn(
        "normals",
        "One mesh, three kinds of normals. With one normal for each triangle, the triangles show. Normals computed at the vertices hide them, and smear the sharp edges of foot and collar. \
         The file's own normals know which edges are sharp.",
        "Three pictures of a chess pawn. The first is made of flat facets. The second is smooth, with dark and light smears at the edges of its foot and collar. The third is smooth with clean sharp edges.",
        &panels(3, &row),
    )
}
