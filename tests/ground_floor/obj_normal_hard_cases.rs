//! Normals in OBJ files that are wrong, and what the reader says; readers that fail.

use std::io;

use facette::mesh::{Obj, ObjError};

/// The message about a file of three vertices and two normals, on lines 1 to 5, followed by `text`.
fn complaint(text: &str) -> String {
    let file = format!("v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nvn 0 1 1\n{text}");
    let refusal = Obj::parse("bad.obj", &file).expect_err(text);
    refusal.to_string()
}

/// **Normals that cannot be.** A normal number out of range, one that is no number, a normal at some corners of a face and not at others, a normal that is
/// zero, not finite, or not three numbers: the message says what is wrong, in which line, and quotes it.
#[test]
fn bad_normal_is_refused_with_its_line() {
    let range = "a normal number is out of range: the file has 2 normals (lines \"vn x y z\"), counted from 1; negative numbers count back from the line";
    let corners = "expected the number of a normal at every corner, as 1//3 or 1/2/3, or at none";
    for (line, what) in [
        ("f 1//1 2//2 3//3", range),
        ("f 1//0 2//2 3//1", range),
        ("f 1/9/1 2/9/-3 3/9/1", range),
        ("f 1//1 2//x 3//1", corners),
        ("f 1//1 2 3//1", corners),
        ("f 1//1 2/5 3//1", corners),
        ("f 1//1 2// 3//1", corners),
    ] {
        let expected = format!("bad.obj:7: {what} in \"{line}\"");
        assert_eq!(
            complaint(&format!("f 1//1 2//2 3//1\n{line}\nf 1 2 3\n")),
            expected
        );
    }
    for (line, what) in [
        ("vn 0 0", "expected three numbers x y z"),
        ("vn 0 0 1 1", "expected three numbers x y z"),
        ("vn", "expected three numbers x y z"),
        ("vn 0 0 up", "expected three numbers x y z"),
        ("vn 0 nan 1", "a coordinate is not finite"),
        ("vn 0 0 -1e999", "a coordinate is not finite"),
    ] {
        let expected = format!("bad.obj:6: {what} in \"{line}\"");
        assert_eq!(complaint(&format!("{line}\nf 1//1 2//2 3//1\n")), expected);
    }
    assert_eq!(
        complaint("vn -0 0 0\nf 1//1 2//3 3//1\n"),
        "bad.obj:7: a normal must not be zero, as number 3 is in \"f 1//1 2//3 3//1\""
    );
    let unused = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 0\nf 1/1/ 2/2/ 3/3/\n";
    let read = Obj::parse("unused.obj", unused).expect("no face names the zero normal");
    assert!(read.polygons[0].normals.is_empty());
}

/// **Normals of faces alone.** A file that names normals and has none is told so, and a model put together by hand that names a normal which is not there is refused too.
#[test]
fn normals_that_are_not_there_are_missed() {
    let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1//1 2//1 3//1\n";
    let message = Obj::parse("none.obj", text)
        .expect_err("a refusal")
        .to_string();
    assert!(
        message.starts_with("none.obj:4: a normal number is out of range: the file has 0 normals"),
        "{message}"
    );
    let mut obj = Obj::parse("one.obj", &format!("vn 0 0 1\n{text}")).expect("a valid file");
    obj.polygons[0].normals = vec![0, 7, 0];
    assert_eq!(
        obj.mesh_with_normals().expect_err("a refusal").to_string(),
        "face 0 names normal 7, but only 1 are there, counted from 0, and it must not be zero"
    );
    obj.polygons[0].normals = vec![0];
    assert!(obj.mesh_with_normals().is_err());
    obj.polygons[0].normals.clear();
    obj.polygons[0].vertices[0] = 9;
    assert!(obj.mesh_with_normals().is_err());
}

/// **Faces with normals and faces without.** Within one face it is all corners or none; but a file may have faces of both kinds. Those without have their
/// normals computed, and where they meet the others, vertices are split.
#[test]
fn file_may_have_faces_with_normals_and_without() {
    let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvn 0 3 4\nf 1//1 2//1 3//1\nf 2 4 3\n";
    let mesh = Obj::parse("both.obj", text)
        .expect("a valid file")
        .mesh_with_normals()
        .expect("a mesh");
    assert_eq!(mesh.positions.len(), 6);
    let tilted = [0.0, 0.6, 0.8];
    let up = [0.0, 0.0, 1.0];
    assert_eq!(mesh.normals, [tilted, tilted, tilted, up, up, up]);
    assert_eq!(mesh.faces().collect::<Vec<_>>(), [[0, 1, 2], [4, 3, 5]]);
}

/// A reader that fails after its first bytes.
struct Broken(bool);

impl io::Read for Broken {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        if self.0 {
            return Err(io::Error::other("the line went dead"));
        }
        self.0 = true;
        buffer[..8].copy_from_slice(b"v 0 0 0\n");
        Ok(8)
    }
}

/// **Readers that fail.** A model may come from anywhere. Where the source fails in the middle, the message names it and says why; half a model is never given.
#[test]
fn failing_reader_is_named() {
    let refusal = Obj::from_reader("the modem", Broken(false)).expect_err("a refusal");
    assert!(matches!(refusal, ObjError::File { .. }));
    assert_eq!(refusal.to_string(), "the modem: the line went dead");
    let refusal = Obj::from_reader("bytes", &b"v 0 0\n"[..]).expect_err("a refusal");
    assert_eq!(
        refusal.to_string(),
        "bytes:1: expected three numbers x y z in \"v 0 0\""
    );
}
