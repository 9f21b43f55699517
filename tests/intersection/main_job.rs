//! The chapter's main job on real input: a model from an OBJ file becomes a picture.

use std::fs;
use std::path::{Path, PathBuf};

use facette_figure::render::Picture;

#[path = "../../examples/intersection/picture_of_model.rs"]
mod picture_of_model;

/// A folder of its own for each test, empty.
fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR"))
        .join("intersection")
        .join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).expect("the target folder can be written");
    folder
}

fn pawn() -> String {
    let path = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/examples/intersection/pawn.obj"
    );
    fs::read_to_string(path).expect("the example's model is in the repository")
}

/// What comes of a model file with this text.
fn run(name: &str, text: &str) -> (Result<(), String>, PathBuf) {
    let folder = folder(name);
    fs::write(folder.join("model.obj"), text).expect("the target folder can be written");
    let done = picture_of_model::run(&folder.join("model.obj"), &folder.join("model.png"));
    (done.map_err(|error| error.to_string()), folder)
}

/// The columns and rows that something is seen in, first and last, and how many pixels it covers.
fn seen(folder: &Path) -> ([u32; 4], usize) {
    let png = fs::read(folder.join("model.png")).expect("there is a picture");
    let picture = Picture::from_png(&png).expect("it is a PNG file");
    let (mut box_of, mut covered) = ([u32::MAX, u32::MAX, 0, 0], 0);
    for (row, column) in
        (0..picture.height).flat_map(|row| (0..picture.width).map(move |column| (row, column)))
    {
        if picture.pixel(column, row)[3] > 0 {
            let [left, top, right, bottom] = box_of;
            box_of = [
                left.min(column),
                top.min(row),
                right.max(column),
                bottom.max(row),
            ];
            covered += 1;
        }
    }
    (box_of, covered)
}

#[test]
fn model_becomes_a_picture_that_shows_all_of_it() {
    let (done, folder) = run("whole", &pawn());
    assert_eq!(done, Ok(()));
    let ([left, top, right, bottom], covered) = seen(&folder);
    assert!(
        covered > 960 * 720 / 10,
        "only {covered} pixels show anything"
    );
    assert!(
        left > 0 && top > 0 && right < 959 && bottom < 719,
        "it is cut off"
    );
    assert!(bottom - top > 720 / 2, "it is small: {top} to {bottom}");
}

#[test]
fn models_of_any_size_and_place_fill_the_picture() {
    let triangle = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.5]];
    for (name, size, place) in [
        ("tiny", 1e-30, 0.0),
        ("huge", 1e30, 0.0),
        ("largest", 1e300, 0.0),
        ("far", 1.0, 1e6),
        ("farther_than_single_precision", 1e-3, 1e6),
    ] {
        let lines = triangle.map(|corner| {
            let [x, y, z] = corner.map(|x: f64| x * size + place);
            format!("v {x:e} {y:e} {z:e}\n")
        });
        let (done, folder) = run(name, &format!("{}f 1 2 3\n", lines.concat()));
        assert_eq!(done, Ok(()), "{name}");
        let (_, covered) = seen(&folder);
        assert!(covered > 960 * 720 / 10, "{name}: only {covered} pixels");
    }
}

#[test]
fn unusable_models_are_explained_and_leave_nothing() {
    let triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    for (name, text, expected) in [
        (
            "empty",
            String::new(),
            "model.obj: there is no vertex in it",
        ),
        (
            "faceless",
            triangle.to_owned(),
            "model.obj: there is no face in it",
        ),
        (
            "numberless",
            pawn().replacen("v 0.924", "v much", 1),
            "model.obj:2: expected three numbers x y z in \"v much",
        ),
        (
            "cornerless",
            format!("{triangle}f 1 2 4\n"),
            "model.obj:4: a vertex number is out of range",
        ),
        (
            "normalless",
            format!("{triangle}f 1//1 2//1 3//1\n"),
            "model.obj:4: a normal number is out of range",
        ),
        (
            "flat",
            "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n".to_owned(),
            "model.obj: nothing is seen, since no face has an area",
        ),
        (
            "point",
            "v 3 3 3\nv 3 3 3\nv 3 3 3\nf 1 2 3\n".to_owned(),
            "model.obj: nothing is seen",
        ),
    ] {
        let (done, folder) = run(name, &text);
        let message = done.expect_err("the file is unusable");
        assert!(message.contains(expected), "{message}");
        let left: Vec<_> = fs::read_dir(folder).expect("the test's folder").collect();
        assert_eq!(left.len(), 1, "more than the model is left: {left:?}");
    }
}

#[test]
fn picture_needs_a_name_of_its_kind_and_a_place() {
    let folder = folder("names");
    let model = folder.join("model.obj");
    fs::write(&model, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
        .expect("the target folder can be written");
    for picture in ["model.obj", "picture", "picture.jpg"] {
        let refused =
            picture_of_model::run(&model, &folder.join(picture)).expect_err("no picture's name");
        assert!(
            refused
                .to_string()
                .ends_with("the picture's name must end in .png"),
            "{refused}"
        );
    }
    let missing = picture_of_model::run(&folder.join("missing.obj"), &folder.join("missing.png"));
    let message = missing.expect_err("there is no such model").to_string();
    assert!(message.contains("missing.obj: "), "{message}");
    let unwritable = picture_of_model::run(&model, &model.join("picture.png"));
    let message = unwritable.expect_err("a file is no folder").to_string();
    assert!(message.starts_with("cannot write "), "{message}");
    assert_eq!(fs::read_dir(&folder).expect("the test's folder").count(), 1);
    let unsaid = picture_of_model::default_path(&model);
    assert_eq!(
        unsaid,
        Path::new("target/figures/intersection/models/model.png")
    );
}
