//! The theorems of OBJ files. The book shows their doc comments.

use std::fmt::Write as _;

use facette::mesh::{Element, Mesh, Obj, write_obj};
use proptest::collection::vec;
use proptest::prelude::*;

use crate::common::law::{Verdict, expect_equal};
use crate::inputs::{expect, extreme, extreme_f32, finite, finite_f32, law};
use crate::scratch::Scratch;

/// Faces of 3 to 6 different vertices out of `count`.
fn faces(count: u32) -> impl Strategy<Value = Vec<Vec<u32>>> {
    let all: Vec<u32> = (0..count).collect();
    vec(prop::sample::subsequence(all, 3..=6).prop_shuffle(), 0..=5)
}

/// **There and back.** A mesh that is written to a file and read again has the same faces, and positions with the same bits: in double
/// precision, and in single precision too, since the shortest decimal fraction that names a number is written.
#[test]
fn mesh_comes_back_from_a_file_with_the_same_bits() {
    let scratch = Scratch::new();
    let meshes = (
        vec([finite(), finite(), finite()], 6),
        vec([finite_f32(), finite_f32(), finite_f32()], 6),
        faces(6),
    );
    let hard = (
        vec([extreme(), extreme(), extreme()], 6),
        vec([extreme_f32(), extreme_f32(), extreme_f32()], 6),
        faces(6),
    );
    law("ground_floor::mesh_comes_back_from_a_file_with_the_same_bits").holds(
        meshes,
        hard,
        |(wide, narrow, faces)| {
            let path = scratch.path("mesh.obj");
            let mesh = Mesh::new(wide.clone(), faces).expect("a mesh");
            write_obj(&path, "wide", &mesh).expect("a writable folder");
            let read = Obj::read(&path).expect("a valid file");
            let bits = |points: &[[f64; 3]]| {
                points
                    .iter()
                    .flatten()
                    .map(|x| x.to_bits())
                    .collect::<Vec<_>>()
            };
            expect_equal(&bits(wide), &bits(&read.positions))?;
            expect_equal(&mesh, &read.mesh().expect("a mesh"))?;

            let mut mesh = Mesh::new(narrow.clone(), faces).expect("a mesh");
            mesh.parameters = narrow.iter().map(|&[u, v, _]| [u, v]).collect();
            write_obj(&path, "narrow", &mesh).expect("a writable folder");
            let read = Obj::read(&path).expect("a valid file");
            #[allow(
                clippy::cast_possible_truncation,
                reason = "the numbers were of single precision"
            )]
            let back: Vec<_> = read
                .positions
                .iter()
                .flatten()
                .map(|&x| (x as f32).to_bits())
                .collect();
            expect_equal(
                &narrow.iter().flatten().map(|x| x.to_bits()).collect(),
                &back,
            )?;
            expect_equal(
                faces,
                &read
                    .polygons
                    .into_iter()
                    .map(|face| face.vertices)
                    .collect(),
            )
        },
    );
}

/// How a writer of files may spell the same thing.
#[derive(Clone, Debug)]
struct Spelling {
    separator: &'static str,
    line_end: &'static str,
    start: &'static str,
    corner: usize,
    vertex: usize,
}

fn spellings() -> impl Strategy<Value = Spelling> {
    let separator = prop::sample::select(vec![" ", "\t", "  ", " \\\n", "\\\n\t"]);
    let line_end = prop::sample::select(vec![
        "\n",
        "\r\n",
        " # v 9 9 9\n",
        "\n\n# a comment\n",
        "\nusemtl red\ns 1\nvn 0 0 1\n",
    ]);
    let start = prop::sample::select(vec!["", "\u{feff}", "# exported\n", "\nmtllib a.mtl\n"]);
    (separator, line_end, start, 0..5_usize, 0..3_usize).prop_map(
        |(separator, line_end, start, corner, vertex)| Spelling {
            separator,
            line_end,
            start,
            corner,
            vertex,
        },
    )
}

fn spelled(points: &[[f64; 3]], faces: &[Vec<u32>], how: &Spelling) -> String {
    let mut text = format!("{}vt 0 0\nvn 0 0 1\nvn 0 0 2\n", how.start);
    let count = points.len();
    for [x, y, z] in points {
        let words = match how.vertex {
            0 => vec![format!("{x}"), format!("{y}"), format!("{z}")],
            1 => vec![
                format!("{x:e}"),
                format!("{y:e}"),
                format!("{z:e}"),
                "1.0".to_owned(),
            ],
            _ => [x, y, z, &0.25, &0.5, &1.0]
                .map(|number| format!("{number}"))
                .to_vec(),
        };
        let _ = write!(
            text,
            "v{0}{1}{2}",
            how.separator,
            words.join(how.separator),
            how.line_end
        );
    }
    for face in faces {
        let corner = |&vertex: &u32| match how.corner {
            0 => format!("{}", vertex + 1),
            1 => format!("{}/7", vertex + 1),
            2 => format!("{}//2", vertex + 1),
            3 => format!("{}/1/2", vertex + 1),
            _ => format!("-{}", count - vertex as usize),
        };
        let corners: Vec<_> = face.iter().map(corner).collect();
        let _ = write!(
            text,
            "f{0}{1}{2}",
            how.separator,
            corners.join(how.separator),
            how.line_end
        );
    }
    text
}

/// **Many spellings, one mesh.** Comments anywhere, lines continued with `\`, tabs, a byte-order mark, the line ends of every
/// system, indices counted from the end, a fourth coordinate 1, colours, texture coordinates and normals: all are read as the
/// plain file is. Vertices that no face uses keep their place.
#[test]
fn every_spelling_of_a_file_gives_the_same_mesh() {
    let coordinate = || (-1000..=1000_i32).prop_map(|x| f64::from(x) / 8.0);
    let points = || vec([coordinate(), coordinate(), coordinate()], 6..=9);
    let plain = spellings().prop_map(|how| Spelling {
        corner: 0,
        vertex: 0,
        ..how
    });
    let theorem = law("ground_floor::every_spelling_of_a_file_gives_the_same_mesh");
    theorem.on_cases(256).holds(
        (points(), faces(6), plain),
        (points(), faces(6), spellings()),
        |(points, faces, how)| {
            let read = Obj::parse("test.obj", &spelled(points, faces, how)).expect("a valid file");
            let mesh = Mesh::new(points.clone(), faces).expect("a mesh");
            expect_equal(&mesh, &read.mesh().expect("a mesh"))
        },
    );
}

const SAMPLE: &str = "\
# two curves and two faces
o P1
v 0 0 0
v 1 0 0.5
v 2 0 0
l 1 2 3
g P2 upper
v 0 1 0
v 2 1 0 # the last
v 9 9 9
l 4 \\
  5
o
f 1 2 3 5 4
vn 0 0 1
f -6 -5 -3
f 1//1 2/7/-1 3//1
";

/// **Polygons and polylines.** Faces and polylines are kept apart, each with the name of its object and the number of its line, in the
/// order of the file.
#[test]
fn polygons_and_polylines_are_kept_apart() {
    let obj = Obj::parse("sample.obj", SAMPLE).expect("a valid file");
    let element = |object: &str, line, vertices: &[u32]| Element {
        object: object.to_owned(),
        line,
        vertices: vertices.to_vec(),
        normals: Vec::new(),
    };
    assert_eq!(
        obj.polylines,
        [
            element("P1", 6, &[0, 1, 2]),
            element("P2 upper", 11, &[3, 4])
        ]
    );
    assert_eq!(
        obj.polygons,
        [
            element("", 14, &[0, 1, 2, 4, 3]),
            element("", 16, &[0, 1, 3]),
            Element {
                normals: vec![0; 3],
                ..element("", 17, &[0, 1, 2])
            }
        ]
    );
    assert_eq!(
        obj.points(&obj.polylines[1]),
        [[0.0, 1.0, 0.0], [2.0, 1.0, 0.0]]
    );
    assert_eq!(obj.positions.len(), 6);
    assert_eq!(obj.mesh().expect("three faces").face_count(), 3);
}

/// **No file stops the reader.** Whatever is done to a valid file (bytes changed, removed, repeated, lines exchanged), reading it gives
/// a mesh or a message that names the file; and the mesh has only faces of existing vertices.
#[test]
fn no_change_of_a_file_stops_the_reader() {
    let change = || {
        let byte = prop::sample::select(b"0123456789 -/.\n\\#vflogeNa\r\t\xff\xc3".to_vec());
        (0..SAMPLE.len(), byte, 0..4_u8)
    };
    let word = prop::sample::select(vec![
        "v",
        "f",
        "l",
        "f 1",
        "l 0",
        "f 1 2 99999999999999999999",
        "v 1e999 0 0",
        "f /1 2 3",
        "vn 0 0 0",
        "f 1//2 2//1 3//1",
        "\\",
    ]);
    let inserted = (0..17_usize, word).prop_map(|(line, word)| {
        let mut lines: Vec<_> = SAMPLE.lines().collect();
        lines.insert(line, word);
        lines.join("\n").into_bytes()
    });
    let changed = vec(change(), 1..=4).prop_map(|changes| {
        let mut bytes = SAMPLE.as_bytes().to_vec();
        for (place, byte, how) in changes {
            let place = place.min(bytes.len() - 1);
            match how {
                0 => bytes[place] = byte,
                1 => bytes.insert(place, byte),
                2 if bytes.len() > 1 => drop(bytes.remove(place)),
                _ => bytes.truncate(place + 1),
            }
        }
        bytes
    });
    let theorem = law("ground_floor::no_change_of_a_file_stops_the_reader");
    theorem
        .on_cases(2000)
        .holds(changed, inserted, |bytes| answers(bytes));
}

fn answers(bytes: &[u8]) -> Verdict {
    match Obj::parse("changed.obj", &String::from_utf8_lossy(bytes)) {
        Ok(obj) => {
            let finite = obj.positions.iter().flatten().all(|x| x.is_finite());
            expect(
                "finite positions",
                finite && !obj.positions.is_empty(),
                &obj.positions,
            )?;
            expect("a mesh", obj.mesh().is_ok(), &obj)?;
            expect("a mesh", obj.mesh_with_normals().is_ok(), &obj)?;
            let mut vertices = obj.polylines.iter().flat_map(|line| &line.vertices);
            expect(
                "existing vertices",
                vertices.all(|&v| (v as usize) < obj.positions.len()),
                &obj,
            )
        }
        Err(error) => {
            let message = error.to_string();
            let names_the_place = message.starts_with("changed.obj:") && !message.contains(":0:");
            expect("a message with file and line", names_the_place, message)
        }
    }
}
