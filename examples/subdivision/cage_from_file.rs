//! A cage from an OBJ file, subdivided, into a file and a picture.

use std::error::Error;

use facette::mesh::{Mesh, write_obj};
use facette::subdivision::{Connectivity, Corners, Counts, Sqrt3Boundary, SubdivisionError};
use facette_figure::palette::Colour;
use facette_figure::render::{Material, Picture, Scene, View};
use glam::DVec3;

use super::cage::{is_same_file, read};
use super::figures::scheme::Scheme;
use super::request::Request;

/// The size of the picture in pixels.
const SIZE: [u32; 2] = [960, 720];

/// More faces are refused: their file would have a gigabyte, and their making would take several of memory.
const MOST_FACES: u64 = 1 << 24;

/// Reads the cage, and writes the refined mesh and its picture: each whole or not at all, and neither where something is wrong before.
pub fn run(request: &Request) -> Result<(), Box<dyn Error>> {
    let file = request.cage.display();
    if let Some(out) = &request.out
        && is_same_file(out, &request.cage)
    {
        return Err(format!("{file}: --out would replace the cage by what is made of it").into());
    }
    let cage = read(request)?;
    let fine = refined(request, &cage).map_err(|what| format!("{file}: {what}"))?;
    let picture = match request.picture {
        Some(_) => Some(picture_of(&fine).ok_or_else(|| {
            format!("{file}: there is nothing to see, since no face has an area")
        })?),
        None => None,
    };
    let [vertices, faces] = [fine.positions.len(), fine.face_count()];
    if let Some(out) = &request.out {
        write_obj(out, &name_of(request), &fine)?;
        println!("{}: {vertices} vertices, {faces} faces", out.display());
    }
    if let Some((path, picture)) = request.picture.as_ref().zip(picture) {
        picture.save(path)?;
        println!("{}: {vertices} vertices, {faces} faces", path.display());
    }
    Ok(())
}

/// The refined mesh that is asked for.
fn refined(request: &Request, cage: &Mesh<DVec3>) -> Result<Mesh<DVec3>, Box<dyn Error>> {
    let Request {
        scheme,
        levels,
        corners,
        ..
    } = *request;
    let connectivity = Connectivity::new(cage)?;
    if face_count(scheme, &connectivity, levels, corners).map_or(true, |faces| faces > MOST_FACES) {
        let too_many = format!("{levels} levels make more than {MOST_FACES} faces: ask for fewer");
        return Err(too_many.into());
    }
    let edges = 0..u32::try_from(connectivity.edge_count())?;
    let has_boundary = edges
        .into_iter()
        .any(|edge| connectivity.is_boundary_edge(edge));
    if request.limit && scheme == Scheme::Sqrt3 && has_boundary && !levels.is_multiple_of(2) {
        return Err(
            "the limit of √3 at a boundary is known on even levels: ask for one level more or less"
                .into(),
        );
    }
    let fine = scheme.refined(cage, levels, corners)?;
    if request.limit {
        return Ok(scheme.on_limit(&fine, corners)?);
    }
    Ok(fine)
}

/// How many faces `levels` steps make.
fn face_count(
    scheme: Scheme,
    cage: &Connectivity,
    levels: u32,
    corners: Corners,
) -> Result<u64, SubdivisionError> {
    let step = |counts: Counts, level| match scheme {
        Scheme::CatmullClark => counts.after_catmull_clark(),
        Scheme::DooSabin => counts.after_doo_sabin(corners),
        Scheme::Loop => counts.after_loop(),
        Scheme::Sqrt3 => counts.after_sqrt3(Sqrt3Boundary::in_step(level)),
    };
    let counts = (0..levels).try_fold(Counts::of(cage), step)?;
    Ok(counts.faces)
}

/// The name of the object in the file: the cage's, if a file can have it.
fn name_of(request: &Request) -> String {
    let stem = request.cage.file_stem().unwrap_or_default();
    let name = stem.to_string_lossy();
    name.replace(['\n', '\r', '#', '\\'], "_")
}

/// The mesh from the right above in front, y being up as in most files: smooth where it has the limit's normals, and otherwise with flat faces;
/// `None` if nothing is seen.
fn picture_of(mesh: &Mesh<DVec3>) -> Option<Picture> {
    let triangles = mesh.triangulated();
    let corners = triangles.triangles().flatten();
    let points: Vec<DVec3> = corners
        .map(|vertex| triangles.positions[vertex as usize])
        .collect();
    let view = View::around(&points, DVec3::new(1.0, 0.75, 1.0), SIZE);
    let [width, height] = SIZE;
    let picture = Scene::new(view)
        .surface(&triangles, Material::matte(Colour::Sky))
        .render(width, height);
    let is_seen = picture.rgba.chunks(4).any(|pixel| pixel[3] > 0);
    is_seen.then_some(picture)
}
