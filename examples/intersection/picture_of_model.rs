//! The picture of a model in an OBJ file.

use std::error::Error;
use std::path::{Path, PathBuf};

use facette::mesh::{Mesh, Obj};
use facette_figure::palette::Colour;
use facette_figure::render::{Material, Picture, Scene, View};
use glam::DVec3;

/// The size of the picture in pixels.
const SIZE: [u32; 2] = [960, 720];

/// Where the picture of a model goes if nobody says: never beside the model, where a file of that name may be its texture.
pub fn default_path(model: &Path) -> PathBuf {
    let name = model.file_stem().unwrap_or(model.as_os_str());
    let mut file = name.to_owned();
    file.push(".png");
    Path::new("target/figures/intersection/models").join(file)
}

/// Reads `model`, and writes its picture to `picture`, whole or not at all.
pub fn run(model: &Path, picture: &Path) -> Result<(), Box<dyn Error>> {
    if picture
        .extension()
        .is_none_or(|extension| extension != "png")
    {
        return Err(format!("{}: the picture's name must end in .png", picture.display()).into());
    }
    let file = model.display();
    let obj = Obj::read(model)?;
    if obj.polygons.is_empty() {
        return Err(format!("{file}: there is no face in it (a line \"f 1 2 3\")").into());
    }
    let mesh = obj
        .mesh_with_normals()
        .map_err(|error| format!("{file}: {error}"))?;
    let rendered = picture_of(&mesh);
    if rendered.rgba.chunks(4).all(|pixel| pixel[3] == 0) {
        return Err(format!("{file}: nothing is seen, since no face has an area").into());
    }
    rendered.save(picture)?;
    let normals = match obj
        .polygons
        .iter()
        .filter(|face| face.normals.is_empty())
        .count()
    {
        0 => "normals of the file".to_owned(),
        faces => format!(
            "normals computed at {faces} of {} faces",
            obj.polygons.len()
        ),
    };
    println!(
        "{}: {} vertices, {} triangles, {normals}",
        picture.display(),
        mesh.positions.len(),
        mesh.face_count()
    );
    Ok(())
}

/// The model from the right above in front, y being up as in most files.
fn picture_of(mesh: &Mesh<[f64; 3]>) -> Picture {
    let corners = mesh.triangles().flatten();
    let points: Vec<DVec3> = corners
        .map(|vertex| mesh.positions[vertex as usize].into())
        .collect();
    let view = View::around(&points, DVec3::new(0.55, 0.4, 1.0), SIZE);
    Scene::new(view)
        .surface(mesh, Material::matte(Colour::Sky))
        .render(SIZE[0], SIZE[1])
}
