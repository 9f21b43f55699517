//! Triangles from a control grid in an OBJ file.

use std::error::Error;
use std::path::Path;

use facette::bspline::BsplineSurface;
use facette::mesh::{Mesh, write_obj};
use facette::tessellation::tessellate;
use facette_figure::palette::Colour;
use facette_figure::render::{Picture, Scene, View};
use glam::DVec3;

use super::control_grid;
use super::figures::wires;

/// Reads the surface of `grid`, cuts it into triangles within `tolerance`, and writes them to `out` and their picture beside it.
pub fn run(grid: &Path, tolerance: f64, out: &Path) -> Result<(), Box<dyn Error>> {
    let file = grid.display().to_string();
    let text = std::fs::read_to_string(grid).map_err(|error| format!("{file}: {error}"))?;
    let surface = control_grid::parse(&file, &text)?;
    let mesh = tessellate(&surface, tolerance)?.mesh;
    write_obj(out, "surface", &mesh)?;
    let picture = out.with_extension("png");
    picture_of(&surface, &mesh).save(&picture)?;
    println!(
        "{}: {} vertices, {} triangles within {tolerance}; {}",
        out.display(),
        mesh.positions.len(),
        mesh.face_count(),
        picture.display()
    );
    Ok(())
}

/// The triangles with their edges, seen from above in front.
fn picture_of(surface: &BsplineSurface<DVec3>, mesh: &Mesh<DVec3>) -> Picture {
    let points = surface.control_points();
    let start = points.first().copied().unwrap_or_default();
    let [low, high] = points
        .iter()
        .fold([start; 2], |[low, high], &p| [low.min(p), high.max(p)]);
    let size = (high - low).max_element().max(f64::MIN_POSITIVE);
    let centre = low.midpoint(high);
    let mean = mesh
        .normals
        .iter()
        .sum::<DVec3>()
        .try_normalize()
        .unwrap_or(DVec3::Z);
    let eye = centre + (mean * 1.6 + mean.any_orthonormal_vector() * 1.6) * size;
    let scene = Scene::new(View::orthographic(eye, centre, mean, 1.15 * size));
    wires(scene, mesh, Colour::Sky, 0.0015 * size).render(960, 720)
}
