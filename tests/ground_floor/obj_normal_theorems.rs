//! The theorems of normals in OBJ files. The book shows their doc comments.

use std::collections::HashSet;
use std::fmt::Write as _;

use facette::algebra::{Scalar, VectorSpace};
use facette::mesh::{Mesh, Obj, write_obj};
use proptest::collection::vec;
use proptest::prelude::*;

use crate::common::law::{Verdict, expect_at_most, expect_equal};
use crate::inputs::{expect, law};
use crate::scratch::Scratch;

/// A file: 6 vertices, normals of whole coordinates, and for each face its vertices, and its normals where it names them.
#[derive(Clone, Debug)]
struct Model {
    positions: Vec<[f64; 3]>,
    normals: Vec<[f64; 3]>,
    faces: Vec<(Vec<u32>, Option<Vec<u32>>)>,
}

impl Model {
    fn text(&self) -> String {
        let mut text = String::new();
        for [x, y, z] in &self.positions {
            let _ = writeln!(text, "v {x} {y} {z}");
        }
        for [x, y, z] in &self.normals {
            let _ = writeln!(text, "vn {x} {y} {z}");
        }
        for (vertices, normals) in &self.faces {
            text.push('f');
            for (place, vertex) in vertices.iter().enumerate() {
                let _ = match normals {
                    Some(normals) => write!(text, " {}//{}", vertex + 1, normals[place] + 1),
                    None => write!(text, " {}", vertex + 1),
                };
            }
            text.push('\n');
        }
        text
    }

    fn read(&self) -> Obj {
        Obj::parse("model.obj", &self.text()).expect("a valid file")
    }
}

fn whole() -> impl Strategy<Value = f64> {
    (-6..=6_i32).prop_map(f64::from)
}

fn models(
    normals: impl Strategy<Value = Vec<[f64; 3]>>,
    naming: impl Strategy<Value = bool>,
) -> impl Strategy<Value = Model> {
    let triangles = prop::sample::subsequence((0..6_u32).collect::<Vec<_>>(), 3).prop_shuffle();
    let corners = (triangles, vec(any::<prop::sample::Index>(), 3), naming);
    (
        vec([whole(), whole(), whole()], 6),
        normals,
        vec(corners, 1..=8),
    )
        .prop_map(|(positions, normals, faces)| {
            let named = |(vertices, chosen, is_naming): (_, Vec<prop::sample::Index>, bool)| {
                let number = |choice: prop::sample::Index| {
                    u32::try_from(choice.index(normals.len())).expect("few normals")
                };
                let chosen = is_naming.then(|| chosen.into_iter().map(number).collect());
                (vertices, chosen)
            };
            let faces = faces.into_iter().map(named).collect();
            Model {
                positions,
                normals,
                faces,
            }
        })
}

/// Normals that are not zero.
fn ordinary_normals() -> impl Strategy<Value = Vec<[f64; 3]>> {
    let coordinate = || prop_oneof![(-9..=-1_i32), (1..=9_i32)].prop_map(f64::from);
    vec([coordinate(), coordinate(), coordinate()], 1..=5)
}

/// The same direction several times, once with a negative zero, opposite ones, tiny and huge ones.
fn hard_normals() -> impl Strategy<Value = Vec<[f64; 3]>> {
    Just(vec![
        [0.0, 0.0, 2.0],
        [-0.0, 0.0, 0.5],
        [0.0, 0.0, -1.0],
        [0.0, 1e-310, 1e-310],
        [0.0, 1e300, 1e300],
    ])
}

/// The unit vector along `n`, by the textbook's formula after a division by the largest coordinate.
fn textbook_unit(n: [f64; 3]) -> [f64; 3] {
    let largest = n.iter().fold(0.0_f64, |largest, x| largest.max(x.abs()));
    let [x, y, z] = n.map(|x| x / largest);
    let length = (x * x + y * y + z * z).sqrt();
    [x / length, y / length, z / length]
}

/// **Normals are kept.** A file's mesh has the same faces, and at each of their corners the position that the file names there, with the same bits,
/// and the normal that it names there, as a unit vector: within $10\,u$, since both that vector and the one of the textbook are within $5\,u$ of the truth.
#[test]
fn corners_keep_their_positions_and_normals() {
    let theorem = law("ground_floor::corners_keep_their_positions_and_normals");
    theorem.on_cases(128).holds(
        models(ordinary_normals(), Just(true)),
        models(hard_normals(), Just(true)),
        |model| {
            let mesh = model.read().mesh_with_normals().expect("a mesh");
            expect_equal(&model.faces.len(), &mesh.face_count())?;
            for (face, (vertices, normals)) in mesh.faces().zip(&model.faces) {
                let normals = normals.as_ref().expect("every face names normals");
                for ((&made, &vertex), &normal) in face.iter().zip(vertices).zip(normals) {
                    let bits = |point: [f64; 3]| point.map(f64::to_bits);
                    let position = model.positions[vertex as usize];
                    expect_equal(&bits(position), &bits(mesh.positions[made as usize]))?;
                    let expected = textbook_unit(model.normals[normal as usize]);
                    let error = mesh.normals[made as usize]
                        .minus(expected)
                        .largest_coordinate();
                    expect_at_most(
                        "error of the normal in u",
                        10.0,
                        error / f64::unit_roundoff(),
                    )?;
                }
            }
            Ok(())
        },
    );
}

/// **Vertices are split only where they must be.** A vertex keeps its place. It has a copy for each further unit normal that a corner gives it, and none for a
/// normal that differs in length only: as many vertices as there are different pairs of a vertex and a unit normal, and those that no face uses.
#[test]
fn vertices_are_split_only_where_normals_differ() {
    let theorem = law("ground_floor::vertices_are_split_only_where_normals_differ");
    theorem.on_cases(128).holds(
        models(ordinary_normals(), any::<bool>()),
        models(hard_normals(), any::<bool>()),
        |model| {
            let mesh = model.read().mesh_with_normals().expect("a mesh");
            let kept = mesh.positions[..model.positions.len()].to_vec();
            expect_equal(&model.positions, &kept)?;
            let used: HashSet<u32> = mesh.faces().flatten().copied().collect();
            let corners = mesh.faces().flatten();
            let named = model.faces.iter().flat_map(|(vertices, _)| vertices);
            let pairs: HashSet<_> = corners
                .zip(named)
                .map(|(&made, &vertex)| (vertex, mesh.normals[made as usize].map(f64::to_bits)))
                .collect();
            expect_equal(&pairs.len(), &used.len())?;
            let of_faces = model.faces.iter().flat_map(|(vertices, _)| vertices);
            let unused = model.positions.len() - of_faces.collect::<HashSet<_>>().len();
            expect_equal(&mesh.positions.len(), &(used.len() + unused))
        },
    );
}

/// **Normals are computed where the file has none.** A corner of a face without normals has the normal that is made of all triangles at its vertex, those of faces with normals included.
#[test]
fn faces_without_normals_have_computed_ones() {
    let theorem = law("ground_floor::faces_without_normals_have_computed_ones");
    theorem.on_cases(128).holds(
        models(ordinary_normals(), any::<bool>()),
        models(hard_normals(), Just(false)),
        |model| {
            let mesh = model.read().mesh_with_normals().expect("a mesh");
            let faces = model.faces.iter().map(|(vertices, _)| vertices);
            let plain = Mesh::new(model.positions.clone(), faces).expect("a mesh");
            let computed = plain.vertex_normals();
            for (face, (vertices, normals)) in mesh.faces().zip(&model.faces) {
                if normals.is_some() {
                    continue;
                }
                for (&made, &vertex) in face.iter().zip(vertices) {
                    expect_equal(&computed[vertex as usize], &mesh.normals[made as usize])?;
                }
            }
            Ok(())
        },
    );
}

/// **Normals come back from a file.** A mesh with unit normals that is written to a file and read again has the same faces, the same bits of its positions,
/// and its normals within $6\,u$: they are made unit vectors once more, at the cost of $5\,u$, and were within $u$ of length 1.
#[test]
fn mesh_with_normals_comes_back_from_a_file() {
    let scratch = Scratch::new();
    let theorem = law("ground_floor::mesh_with_normals_comes_back_from_a_file");
    theorem.holds(
        models(ordinary_normals(), Just(true)),
        models(hard_normals(), Just(true)),
        |model| there_and_back(&scratch, model),
    );
}

fn there_and_back(scratch: &Scratch, model: &Model) -> Verdict {
    let mesh = model.read().mesh_with_normals().expect("a mesh");
    let path = scratch.path("normals.obj");
    write_obj(&path, "model", &mesh).expect("a writable folder");
    let file = std::fs::File::open(&path).expect("it was written");
    let read =
        Obj::from_reader("normals.obj", std::io::BufReader::new(file)).expect("a valid file");
    let back = read.mesh_with_normals().expect("a mesh");
    expect_equal(&mesh.positions, &back.positions)?;
    expect("the same faces", mesh.faces().eq(back.faces()), &back)?;
    for (normal, again) in mesh.normals.iter().zip(&back.normals) {
        let error = normal.minus(*again).largest_coordinate() / f64::unit_roundoff();
        expect_at_most("change of the normal in u", 6.0, error)?;
    }
    Ok(())
}
