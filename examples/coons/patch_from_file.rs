//! A patch from four curves in an OBJ file.

use std::error::Error;
use std::path::Path;

use facette::algebra::VectorSpace;
use facette::coons::{Boundary, CoonsPatch};
use facette::curve::Polyline;
use facette::mesh::{Mesh, Obj, tessellate_uniformly, write_obj};
use facette_figure::palette::Colour;
use facette_figure::render::{Material, Picture, Scene, View};
use glam::DVec3;

/// Cells along each side of the patch.
const CELLS: usize = 64;

/// Two ends count as meeting when they are no further apart than this part of the boundary's size: files carry six or
/// seven digits.
const MEETING: f64 = 1e-5;

/// Reads the objects P1, P2, Q1, Q2 from `boundary`, writes their patch to `patch` and its picture beside it.
pub fn run(boundary: &Path, patch: &Path) -> Result<(), Box<dyn Error>> {
    let file = boundary.display();
    let obj = Obj::read(boundary)?;
    let curves = ["P1", "P2", "Q1", "Q2"].map(|name| curve(&obj, name));
    let [p1, p2, q1, q2] = curves.map(|found| found.map_err(|error| format!("{file}: {error}")));
    let curves = [p1?, p2?, q1?, q2?];
    let points: Vec<DVec3> = curves
        .iter()
        .flat_map(|curve| curve.points().to_vec())
        .collect();
    let tolerance = MEETING * size(&points);
    let boundary =
        Boundary::with_tolerance(curves, tolerance).map_err(|error| format!("{file}: {error}"))?;
    let mesh = tessellate_uniformly(&CoonsPatch::new(boundary.clone()), CELLS, CELLS)?;
    write_obj(patch, "patch", &mesh)?;
    let picture = patch.with_extension("png");
    picture_of(&mesh, &boundary).save(&picture)?;
    println!(
        "{}: {} vertices, {} triangles; {}",
        patch.display(),
        mesh.positions.len(),
        mesh.face_count(),
        picture.display()
    );
    Ok(())
}

/// The polyline of the object `name`, its parameter the arc length.
fn curve(obj: &Obj, name: &str) -> Result<Polyline<DVec3>, String> {
    let named: Vec<_> = obj
        .polylines
        .iter()
        .filter(|line| line.object == name)
        .collect();
    match named[..] {
        [polyline] => {
            let points = obj.points(polyline).into_iter().map(DVec3::from).collect();
            Polyline::by_arc_length(points).map_err(|error| format!("{name}: {error}"))
        }
        [] => {
            let mut found: Vec<_> = obj
                .polylines
                .iter()
                .map(|line| line.object.as_str())
                .collect();
            found.dedup();
            Err(format!(
                "there is no polyline {name} (a line \"o {name}\", then one line \"l 1 2 3 ...\"); \
                 the file has polylines in {found:?}"
            ))
        }
        [_, second, ..] => Err(format!("line {}: a second polyline of {name}", second.line)),
    }
}

/// The longest side of the box around the points.
fn size(points: &[DVec3]) -> f64 {
    let start = points.first().copied().unwrap_or_default();
    let [low, high] = points.iter().fold([start; 2], |[low, high], &point| {
        [low.min(point), high.max(point)]
    });
    (high - low).largest_coordinate()
}

/// The patch with its lines of constant parameters and its boundary, seen from above in front.
fn picture_of(mesh: &Mesh<DVec3>, boundary: &Boundary<Polyline<DVec3>>) -> Picture {
    let size = size(&mesh.positions).max(f64::MIN_POSITIVE);
    let count = mesh.positions.len().max(1) as f64;
    let centre = mesh.positions.iter().sum::<DVec3>() / count;
    let mean_normal = mesh
        .normals
        .iter()
        .sum::<DVec3>()
        .try_normalize()
        .unwrap_or(DVec3::Z);
    let aside = mean_normal.any_orthonormal_vector();
    let eye = centre + (mean_normal * 1.6 + aside * 1.6) * size;
    let mut scene = Scene::new(View::orthographic(eye, centre, mean_normal, 1.15 * size))
        .surface(mesh, Material::matte(Colour::Sky).isolines(8));
    for (curve, colour) in [
        (boundary.p1(), Colour::Blue),
        (boundary.p2(), Colour::Blue),
        (boundary.q1(), Colour::Vermilion),
        (boundary.q2(), Colour::Vermilion),
    ] {
        scene = scene.tube(curve.points(), 0.008 * size, colour);
    }
    scene.render(960, 720)
}
