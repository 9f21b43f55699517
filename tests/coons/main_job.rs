//! The chapter's main job on real input: four curves from an OBJ file become a patch and its picture.

use std::fs;
use std::path::{Path, PathBuf};

use facette::mesh::Obj;
use facette_figure::render::Picture;

#[path = "../../examples/coons/patch_from_file.rs"]
mod patch_from_file;

/// A folder of its own for each test, empty.
fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).expect("the target folder can be written");
    folder
}

fn boundary() -> String {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/coons/boundary.obj");
    fs::read_to_string(path).expect("the example's boundary is in the repository")
}

/// What comes of a boundary file with this text.
fn run(name: &str, text: &str) -> (Result<(), String>, PathBuf) {
    let folder = folder(name);
    fs::write(folder.join("boundary.obj"), text).expect("the target folder can be written");
    let done = patch_from_file::run(&folder.join("boundary.obj"), &folder.join("patch.obj"));
    (done.map_err(|error| error.to_string()), folder)
}

#[test]
fn boundary_file_becomes_patch_and_picture() {
    let (done, folder) = run("whole", &boundary());
    assert_eq!(done, Ok(()));
    let patch = Obj::read(folder.join("patch.obj")).expect("what was written can be read");
    assert_eq!(
        (patch.positions.len(), patch.polygons.len()),
        (65 * 65, 2 * 64 * 64)
    );
    let corners = [0, 64, 65 * 65 - 1, 64 * 65].map(|vertex| patch.positions[vertex]);
    assert_eq!(
        corners,
        [[0., 0., 0.], [4., 0., 0.6], [4.2, 3.2, 0.], [0., 3., 0.8]]
    );
    let png = fs::read(folder.join("patch.png")).expect("there is a picture");
    let picture = Picture::from_png(&png).expect("it is a PNG file");
    let covered = picture.rgba.chunks(4).filter(|pixel| pixel[3] > 0).count();
    assert!(
        covered > 960 * 720 / 10,
        "only {covered} pixels show anything"
    );
}

#[test]
fn unusable_boundary_files_are_explained_and_leave_nothing() {
    let parted = boundary().replacen("v 0.000000 0.000000 0.000000", "v 0 0 0.1", 1);
    let nameless = boundary().replace("o Q2", "o R2");
    let unreadable = boundary().replacen("v 4.000000", "v four", 1);
    let doubled = boundary() + "l 1 2 3\n";
    for (name, text, expected) in [
        (
            "parted",
            parted,
            "boundary.obj: at corner A, P1(0) = DVec3(0.0, 0.0, 0.1) and Q1(0)",
        ),
        ("nameless", nameless, "there is no polyline Q2"),
        (
            "unreadable",
            unreadable,
            "boundary.obj:19: expected three numbers x y z in \"v four",
        ),
        ("doubled", doubled, "line 78: a second polyline of Q2"),
    ] {
        let (done, folder) = run(name, &text);
        let message = done.expect_err("the file is unusable");
        assert!(message.contains(expected), "{message}");
        assert!(!folder.join("patch.obj").exists() && !folder.join("patch.png").exists());
    }
}
