//! The chapter's main job on real input: a control grid from an OBJ file becomes triangles and their picture.

use std::fs;
use std::path::{Path, PathBuf};

use facette::mesh::Obj;
use facette_figure::render::Picture;

use crate::snapshots::figures;

#[path = "../../examples/tessellation/control_grid.rs"]
mod control_grid;
#[path = "../../examples/tessellation/surface_from_file.rs"]
mod surface_from_file;

/// A folder of its own for each test, empty.
fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR"))
        .join("tessellation")
        .join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).expect("the target folder can be written");
    folder
}

fn grid() -> String {
    let path = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/examples/tessellation/control_grid.obj"
    );
    fs::read_to_string(path).expect("the example's control grid is in the repository")
}

/// What comes of a grid file with this text.
fn run(name: &str, text: &str) -> (Result<(), String>, PathBuf) {
    let folder = folder(name);
    fs::write(folder.join("grid.obj"), text).expect("the target folder can be written");
    let done = surface_from_file::run(&folder.join("grid.obj"), 0.01, &folder.join("surface.obj"));
    (done.map_err(|error| error.to_string()), folder)
}

#[test]
fn control_grid_becomes_triangles_and_picture() {
    let (done, folder) = run("whole", &grid());
    assert_eq!(done, Ok(()));
    let surface = Obj::read(folder.join("surface.obj")).expect("what was written can be read");
    assert!(
        (500..20_000).contains(&surface.polygons.len()),
        "{}",
        surface.polygons.len()
    );
    assert!(
        surface.positions.contains(&[0.0, 0.0, 0.0])
            && surface.positions.contains(&[5.0, 4.0, 1.1053])
    );
    let png = fs::read(folder.join("surface.png")).expect("there is a picture");
    let picture = Picture::from_png(&png).expect("it is a PNG file");
    let covered = picture.rgba.chunks(4).filter(|pixel| pixel[3] > 0).count();
    assert!(
        covered > 960 * 720 / 10,
        "only {covered} pixels show anything"
    );
}

#[test]
fn unusable_grids_are_explained_and_leave_nothing() {
    let change = |from: &str, to: &str| {
        let changed = grid().replacen(from, to, 1);
        assert_ne!(changed, grid(), "the grid has {from}");
        changed
    };
    for (name, text, expected) in [
        (
            "unreadable",
            change("v 0.0000", "v zero"),
            "grid.obj:2: \"zero\" is not a finite number in \"v zero",
        ),
        (
            "no_vertex",
            change("    1 2 ", "    1 77 "),
            "grid.obj:34: vertex 77 is out of range: 30 vertices come before",
        ),
        (
            "rational",
            change("cstype bspline", "cstype rat bspline"),
            "grid.obj:32: expected cstype bspline, without weights",
        ),
        (
            "no_degree",
            change("deg 3 3", "deg 3"),
            "grid.obj:33: expected two degrees",
        ),
        (
            "knots",
            change("parm u 0 0 0 0 1 1 2", "parm u 0 0 0 0 1 3 2"),
            "grid.obj: parm u: knot 6 is 2.0, less than the 3.0 before it",
        ),
        (
            "few_knots",
            change("parm v 0 0", "parm v 0"),
            "grid.obj: surf: ",
        ),
        (
            "part",
            change("surf 0 2", "surf 0 1"),
            "a part of a surface is not read",
        ),
        (
            "no_surface",
            change("surf", "surv"),
            "there is no surface in it",
        ),
        ("empty", String::new(), "there is no surface in it"),
    ] {
        let (done, folder) = run(name, &text);
        let message = done.expect_err("the file is unusable");
        assert!(message.contains(expected), "{name}: {message}");
        assert!(!folder.join("surface.obj").exists() && !folder.join("surface.png").exists());
    }
}
