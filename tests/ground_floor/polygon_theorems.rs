//! The theorems of faces that are cut into triangles. The book shows their doc comments.

use std::collections::HashMap;

use facette::algebra::{Vector3, VectorSpace};
use facette::mesh::Mesh;
use num_traits::Zero;
use proptest::collection::vec;
use proptest::prelude::*;

use crate::common::exact::{Exact, fraction};
use crate::common::generators::point;
use crate::common::law::{Verdict, expect_equal};
use crate::inputs::{Point, expect, law, triangle_normal};

/// Twelve directions around the origin, in order, each less than a third of a turn from the fourth after it.
const AROUND: [[i32; 2]; 12] = [
    [6, 0],
    [5, 3],
    [3, 5],
    [0, 6],
    [-3, 5],
    [-5, 3],
    [-6, 0],
    [-5, -3],
    [-3, -5],
    [0, -6],
    [3, -5],
    [5, -3],
];

/// Polygons that are seen whole from the origin: a corner in each of 4 to 12 directions, at any distance.
fn stars() -> impl Strategy<Value = Vec<[Exact; 2]>> {
    (vec(1..=9_i32, 12), vec(any::<bool>(), 12)).prop_map(|(distances, kept)| {
        let directions = AROUND.iter().zip(distances).zip(kept).enumerate();
        directions
            .filter(|&(place, (_, is_kept))| is_kept || place % 3 == 0)
            .map(|(_, (([x, y], distance), _))| {
                [fraction(x * distance, 1), fraction(y * distance, 1)]
            })
            .collect()
    })
}

/// Combs: teeth of any length above a bar, with corners in line where a tooth has none.
fn combs() -> impl Strategy<Value = Vec<[Exact; 2]>> {
    vec(0..=6_i32, 2..=5).prop_map(|teeth| {
        let width = i32::try_from(teeth.len()).expect("five teeth");
        let mut comb = vec![[0, 0], [2 * width, 0]];
        for (tooth, height) in (0..width).zip(teeth).rev() {
            comb.extend([[2 * tooth + 2, 1], [2 * tooth + 1, 1 + height]]);
        }
        comb.push([0, 1]);
        let corners = comb.into_iter();
        corners
            .map(|corner| corner.map(|x| fraction(x, 1)))
            .collect()
    })
}

/// The corners of a polygon in a plane of space, whichever way it looks there.
fn in_space(polygon: &[[Exact; 2]], [origin, across, up]: [Point; 3]) -> Vec<Point> {
    let place = |&[x, y]: &[Exact; 2]| origin.plus(across.times(x)).plus(up.times(y));
    polygon.iter().map(place).collect()
}

/// **Faces of any shape.** A plane polygon of $n$ corners that does not cross itself, convex or not, becomes $n-2$ triangles. They look the way it looks,
/// each side of it belongs to one of them, each other edge to two that run along it in opposite directions, and their areas add up to its area: so they cover it, once.
#[test]
fn face_becomes_triangles_that_cover_it_once() {
    let theorem = law("ground_floor::face_becomes_triangles_that_cover_it_once");
    let planes = || [point(), point(), point()];
    theorem.on_cases(128).holds(
        (stars(), planes()),
        (combs(), planes()),
        |(polygon, plane)| {
            let [_, across, up] = *plane;
            if across.cross(up).largest_coordinate().is_zero() {
                // Two directions in line span no plane: see the hard case of faces without area.
                return Ok(());
            }
            covers_once(&in_space(polygon, *plane))
        },
    );
}

fn covers_once(corners: &[Point]) -> Verdict {
    let count = u32::try_from(corners.len()).expect("few corners");
    let face: Vec<u32> = (0..count).collect();
    let mesh = Mesh::new(corners.to_vec(), [&face]).expect("one face");
    let cut = mesh.triangulated();
    expect_equal(&(corners.len() - 2), &cut.face_count())?;
    let ends = corners.iter().cycle().skip(1);
    let area = corners
        .iter()
        .zip(ends)
        .fold([Exact::zero(); 3], |sum, (&a, &b)| sum.plus(a.cross(b)));
    let mut covered = [Exact::zero(); 3];
    let mut edges: HashMap<[u32; 2], i32> = HashMap::new();
    for triangle in cut.triangles() {
        let normal = triangle_normal(triangle.map(|vertex| corners[vertex as usize]));
        expect(
            "a triangle that looks as the face does",
            normal.dot(area) > Exact::zero(),
            triangle,
        )?;
        covered = covered.plus(normal);
        let [a, b, c] = triangle;
        for edge in [[a, b], [b, c], [c, a]] {
            *edges.entry(edge).or_default() += 1;
        }
    }
    expect_equal(&area, &covered)?;
    expect(
        "each edge once in each direction",
        edges.values().all(|&times| times == 1),
        &edges,
    )?;
    let alone: Vec<_> = edges
        .keys()
        .filter(|&&[a, b]| !edges.contains_key(&[b, a]))
        .collect();
    let is_side = |&&&[a, b]: &&&[u32; 2]| b == (a + 1) % count;
    expect_equal(&corners.len(), &alone.len())?;
    expect_equal(&corners.len(), &alone.iter().filter(is_side).count())
}
