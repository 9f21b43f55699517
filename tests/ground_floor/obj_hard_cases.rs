//! OBJ files that are wrong, and what the reader says; files that cannot be read or written.

use std::fs;

use facette::mesh::{Mesh, Obj, ObjError, write_obj};

use crate::scratch::Scratch;

/// The message about a file of four vertices, on lines 1 to 4, followed by `text`.
fn complaint(text: &str) -> String {
    let file = format!("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n{text}");
    let refusal = Obj::parse("bad.obj", &file).expect_err(text);
    refusal.to_string()
}

/// **Faces that cannot be.** A vertex number that is 0, too large, or not a number, fewer than three vertices, a vertex named twice:
/// the message says what is wrong, in which line, and quotes it.
#[test]
fn bad_face_is_refused_with_its_line() {
    let range = "a vertex number is out of range: the file has 4 vertices, counted from 1; negative numbers count back from the line";
    let numbers = "expected vertex numbers, as 1 or 1/2/3";
    for (line, what) in [
        ("f 0 1 2", range),
        ("f 1 2 5", range),
        ("f 1 2 -5", range),
        ("f 1 2 4294967297", range),
        ("f 1 2 99999999999999999999", numbers),
        ("f 1 two 3", numbers),
        ("f 1 2 3.5", numbers),
        ("f 1 /2 3", numbers),
        ("f 1 2", "a face needs at least 3 vertices, this has 2"),
        ("f", "a face needs at least 3 vertices, this has 0"),
        ("f 1 2 3 2", "a face must not name vertex 2 twice"),
        ("f 1 2 3 1", "a face must not name vertex 1 twice"),
        ("l 3", "a polyline needs at least 2 vertices, this has 1"),
        ("l 1 2 2 3", "a polyline must not name vertex 2 twice"),
        ("l 1 2 9", range),
    ] {
        let expected = format!("bad.obj:7: {what} in \"{line}\"");
        assert_eq!(
            complaint(&format!("# a face\nf 1 2 3\n{line} # here\nf 1 3 4\n")),
            expected
        );
    }
}

/// **Vertices that cannot be.** Too few coordinates, a word that is no number, a number that is not finite or too large to be, a fourth
/// coordinate 0: the message says what is wrong and in which line.
#[test]
fn bad_vertex_is_refused_with_its_line() {
    for (line, what) in [
        ("v", "expected three numbers x y z"),
        ("v 1 2", "expected three numbers x y z"),
        ("v 1 2 x", "expected three numbers x y z"),
        ("v 1,5 2 3", "expected three numbers x y z"),
        ("v 1/2 2 3", "expected three numbers x y z"),
        ("v 1 2 3 w", "expected three numbers x y z"),
        ("v 1 2 3 0", "the fourth number divides the others: not 0"),
        (
            "v 1 2 3 0.5 0.5",
            "expected 3 numbers, 4, or 3 and 3 of a colour",
        ),
        (
            "v 1 2 3 1 0.5 0.5 0.5",
            "expected 3 numbers, 4, or 3 and 3 of a colour",
        ),
        ("v nan 0 0", "a coordinate is not finite"),
        ("v 0 inf 0", "a coordinate is not finite"),
        ("v 0 0 -1e999", "a coordinate is not finite"),
        ("v 1e300 0 0 1e-300", "a coordinate is not finite"),
    ] {
        let expected = format!("bad.obj:6: {what} in \"{line}\"");
        assert_eq!(complaint(&format!("f 1 2 3\n{line}\nf 1 3 4\n")), expected);
    }
    let coloured =
        Obj::parse("c.obj", "v 0 0 0\nv 1 2 3 0.5 0.5 1\n").expect("one vertex with a colour");
    assert_eq!(coloured.positions, [[0.0; 3], [1.0, 2.0, 3.0]]);
    let halved = Obj::parse("w.obj", "v 2 4 6 2\n").expect("a vertex with a fourth coordinate");
    assert_eq!(halved.positions, [[1.0, 2.0, 3.0]]);
}

/// **Several mistakes in one file.** The reader complains of the first mistake among the vertices, or else of the first face or polyline
/// that it cannot understand, each with its own words; and a continued line is named by its first line.
#[test]
fn first_mistake_is_the_one_reported() {
    let first = complaint("f 1 2 7\nf 1 two 3\n");
    assert!(
        first.starts_with("bad.obj:5: a vertex number is out of range"),
        "{first}"
    );
    let first = complaint("f 1 two 3\nf 1 2 7\n");
    assert!(
        first.starts_with("bad.obj:5: expected vertex numbers"),
        "{first}"
    );
    let first = complaint("f 1 two 3\nv 1 2\n");
    assert!(
        first.starts_with("bad.obj:6: expected three numbers"),
        "{first}"
    );
    let continued = complaint("f 1 \\\n 2 \\\n 7\n");
    assert!(
        continued.starts_with("bad.obj:5: a vertex number")
            && continued.ends_with("in \"f 1  2  7\""),
        "{continued}"
    );
    let long = complaint(&format!("f 1 2 3{}\n", " 99".repeat(40)));
    assert!(long.ends_with(" 99 9 ...\"") && long.len() < 200, "{long}");
}

/// **Files that are empty, missing, or no files.** An empty file is not an empty mesh: the message says that there is no vertex. A
/// missing file and a folder are named with what the system says of them.
#[test]
fn file_without_vertices_is_refused() {
    for text in ["", "\n\n", "# nothing\no name\n", "vn 0 0 1\n"] {
        let refusal = Obj::parse("empty.obj", text).expect_err("a refusal");
        assert_eq!(
            refusal.to_string(),
            "empty.obj: there is no vertex in it (a line \"v x y z\"): is it an OBJ file, in plain text?"
        );
    }
    let faces_only = Obj::parse("faces.obj", "\nf 1 2 3\n")
        .expect_err("a refusal")
        .to_string();
    assert!(
        faces_only
            .starts_with("faces.obj:2: a vertex number is out of range: the file has 0 vertices"),
        "{faces_only}"
    );
    let scratch = Scratch::new();
    for path in [scratch.path("missing.obj"), scratch.path("")] {
        let refusal = Obj::read(&path).expect_err("a refusal");
        assert!(matches!(&refusal, ObjError::File { path: named, .. } if *named == path));
        let message = refusal.to_string();
        assert!(
            message.starts_with(&format!("{}: ", path.display())),
            "{message}"
        );
    }
}

/// **Bytes that are no text.** A comment in an old encoding is no obstacle. The same bytes among the numbers are refused with the line.
#[test]
fn bytes_that_are_no_text_are_refused_where_they_matter() {
    let scratch = Scratch::new();
    let fine = scratch.file("fine.obj", b"# cr\xe9\xe9 hier\nv 1 2 3\n");
    assert_eq!(
        Obj::read(fine).expect("a readable file").positions,
        [[1.0, 2.0, 3.0]]
    );
    let broken = scratch.file("broken.obj", b"v 1 2 3\nv 1 \xff 3\n");
    let message = Obj::read(&broken).expect_err("a refusal").to_string();
    assert!(
        message.starts_with(&format!("{}:2: expected three numbers", broken.display())),
        "{message}"
    );
}

/// **A failing write leaves nothing behind.** The file is written beside its place and then moved there. If the system refuses, what was
/// there stays as it was, and no unfinished file remains.
#[test]
fn failing_write_leaves_nothing_behind() {
    let triangle = vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    let mesh = Mesh::new(triangle, [[0, 1, 2]]).expect("a triangle");
    let scratch = Scratch::new();

    let nowhere = scratch.path("missing").join("mesh.obj");
    let refusal = write_obj(&nowhere, "name", &mesh)
        .expect_err("a refusal")
        .to_string();
    assert!(
        refusal.starts_with(&nowhere.display().to_string()),
        "{refusal}"
    );
    assert!(scratch.names().is_empty());

    let folder = scratch.path("folder.obj");
    fs::create_dir(&folder).expect("a new folder");
    assert!(write_obj(&folder, "name", &mesh).is_err());
    assert_eq!(scratch.names(), ["folder.obj"]);

    let kept = scratch.file("kept.obj", "v 7 7 7\n");
    fs::create_dir(scratch.path("kept.obj.unfinished")).expect("a new folder");
    assert!(write_obj(&kept, "name", &mesh).is_err());
    assert_eq!(
        fs::read_to_string(&kept).expect("the file is there"),
        "v 7 7 7\n"
    );

    let written = scratch.file("written.obj", "v 7 7 7\n");
    write_obj(&written, "name", &mesh).expect("a writable folder");
    assert_eq!(
        scratch.names(),
        [
            "folder.obj",
            "kept.obj",
            "kept.obj.unfinished",
            "written.obj"
        ]
    );
}

/// **What the file says.** Positions, parameters and normals are written where the mesh has them, and the corners of faces name them.
#[test]
fn written_file_names_parameters_and_normals() {
    let scratch = Scratch::new();
    let path = scratch.path("mesh.obj");
    let positions = vec![[0.0, 0.0, 0.1], [1.0, 0.0, 0.0], [0.0, 1.0, 1e-7]];
    let mut mesh = Mesh::new(positions, [[0, 1, 2]]).expect("a triangle");
    let written = |mesh: &Mesh<[f64; 3]>| {
        write_obj(&path, "one triangle", mesh).expect("a writable folder");
        fs::read_to_string(&path).expect("the file is there")
    };
    let positions = "o one triangle\nv 0 0 0.1\nv 1 0 0\nv 0 1 0.0000001\n";
    let (parameters, normals) = ("vt 0 0\nvt 1 0\nvt 0 1\n", "vn 0 0 1\nvn 0 0 1\nvn 0 0 1\n");
    assert_eq!(written(&mesh), format!("{positions}f 1 2 3\n"));
    mesh.normals = vec![[0.0, 0.0, 1.0]; 3];
    assert_eq!(
        written(&mesh),
        format!("{positions}{normals}f 1//1 2//2 3//3\n")
    );
    mesh.parameters = vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
    assert_eq!(
        written(&mesh),
        format!("{positions}{parameters}{normals}f 1/1/1 2/2/2 3/3/3\n")
    );
    mesh.normals.clear();
    assert_eq!(
        written(&mesh),
        format!("{positions}{parameters}f 1/1 2/2 3/3\n")
    );
}

/// **Half a comment.** A `#` begins a comment only at the start of a word: some programs write NaN as `1.#QNAN`, and cutting there would make
/// it 1. Lines may end as on old computers, with a lone carriage return.
#[test]
fn number_with_a_hash_is_no_number() {
    let refused =
        Obj::parse("nan.obj", "v 0 0 1.#QNAN # not a number\n").map_err(|e| e.to_string());
    let expected = "nan.obj:1: expected three numbers x y z in \"v 0 0 1.#QNAN\"";
    assert_eq!(refused, Err(expected.to_owned()));
    let read = Obj::parse("old.obj", "# old\rv 0 0 1#\rv 1 0 0 # b\r").map_err(|e| e.to_string());
    assert_eq!(
        read,
        Err("old.obj:2: expected three numbers x y z in \"v 0 0 1#\"".to_owned())
    );
    let read = Obj::parse("old.obj", "# old\rv 0 0 1 #\rv 1 0 0 # b\r").map(|obj| obj.positions);
    assert_eq!(read.ok(), Some(vec![[0., 0., 1.], [1., 0., 0.]]));
}

/// **Names that a file could not give back.** A name with a line break would write statements of its own, one with `#` would end early, one with
/// a backslash at its end would swallow the next line: they are refused, and nothing is written.
#[test]
fn object_names_that_break_the_file_are_refused() {
    let path = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("named.obj");
    let _ = std::fs::remove_file(&path);
    let mesh = Mesh::new(vec![[0.0, 0.0, 0.0]; 3], [[0, 1, 2]]).expect("one triangle");
    for name in ["a\nv 9 9 9", "a # b", "a\\", "a\r"] {
        let refused = write_obj(&path, &format!("x{name}y").replace("\\y", "\\"), &mesh);
        let message = refused
            .err()
            .map(|error| error.to_string())
            .unwrap_or_default();
        assert!(
            message.contains("must be one line without #"),
            "{name:?}: {message}"
        );
        assert!(!path.exists());
    }
}
