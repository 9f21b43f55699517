//! What the tests of limits share: the neighbourhood of a vertex alone, exact points of the circle, and rings of many valences.
#![allow(dead_code, reason = "the tests of limits use their part of these")]

use std::collections::HashMap;

use facette::algebra::{Real, Scalar, Vector3, VectorSpace, length, unit_vector};
use facette::mesh::Mesh;
use facette::subdivision::limit::{
    Limit, catmull_clark_limits_with, loop_limits_with, sqrt3_limits_with, turn_point,
};
use facette::subdivision::{Connectivity, Corners};

use crate::common::dice::Dice;
use crate::common::exact::{Exact, fraction};
use crate::meshes::{Topology, double_fan, quad_fan};
use crate::steps::Scheme;

type Point = [f64; 3];

/// The valences at which everything is tried.
pub const VALENCES: [u32; 11] = [3, 4, 5, 6, 7, 8, 12, 20, 50, 100, 200];

/// How the faces of a mesh are joined.
pub fn joined<P: VectorSpace>(mesh: &Mesh<P>) -> Connectivity {
    Connectivity::new(mesh).expect("a manifold")
}

/// The part of a mesh that is at most `rings` faces away from a vertex, which becomes vertex 0; its faces keep their order around it.
pub fn neighbourhood<P: VectorSpace>(mesh: &Mesh<P>, vertex: u32, rings: usize) -> Mesh<P> {
    let mut reached = vec![false; mesh.positions.len()];
    reached[vertex as usize] = true;
    let faces: Vec<&[u32]> = mesh.faces().collect();
    let mut taken = vec![false; faces.len()];
    for _ in 0..rings {
        let touches = |face: &[u32]| face.iter().any(|&v| reached[v as usize]);
        let found: Vec<usize> = (0..faces.len()).filter(|&f| touches(faces[f])).collect();
        for face in found {
            taken[face] = true;
            for &v in faces[face] {
                reached[v as usize] = true;
            }
        }
    }
    let mut numbers = HashMap::from([(vertex, 0)]);
    let mut positions = vec![mesh.positions[vertex as usize]];
    let mut kept = Vec::new();
    for (face, _) in faces.iter().zip(taken).filter(|(_, taken)| *taken) {
        let renumbered = face.iter().map(|&v| {
            *numbers.entry(v).or_insert_with(|| {
                positions.push(mesh.positions[v as usize]);
                u32::try_from(positions.len() - 1).expect("a small mesh")
            })
        });
        kept.push(renumbered.collect::<Vec<u32>>());
    }
    Mesh::new(positions, kept).expect("a part of a mesh")
}

/// The square root that regular quadrilaterals need.
pub fn root_of_nine(square: Exact) -> Exact {
    assert_eq!(square, fraction(9, 1), "the regular ring's only root");
    fraction(3, 1)
}

/// The point after k of n parts of a turn, sines with a common factor, where [`rational_circle`] has it.
pub fn circle(k: usize, n: usize) -> [Exact; 2] {
    rational_circle(k, n).expect("a rational angle")
}

/// The point of the circle after k of n parts of a turn where the cosine is rational, with the sine in units of the first one; `None` for other
/// n. Angles that a closed ring of rational cosines has: n = 1, 2, 3, 4, 6.
pub fn rational_circle(k: usize, n: usize) -> Option<[Exact; 2]> {
    let twice_first = match n {
        3 => -1,
        4 => 0,
        6 => 1,
        _ => return None,
    };
    // cos and sin of multiples by Chebyshev's recursion: x(k + 1) = 2 cos x(k) − x(k − 1).
    let step = |[before, now]: [Exact; 2]| [now, fraction(twice_first, 1) * now - before];
    let of = |start: [Exact; 2]| (0..k).fold(start, |pair, _| step(pair))[0];
    let cosine = fraction(twice_first, 2);
    Some([
        of([fraction(1, 1), cosine]),
        of([fraction(0, 1), fraction(1, 1)]),
    ])
}

/// The limits at all vertices by the masks of a scheme on vertices, with these points of the circle.
pub fn limits_with<P: VectorSpace>(
    scheme: Scheme,
    mesh: &Mesh<P>,
    corners: Corners,
    circle: impl Fn(usize, usize) -> [P::Scalar; 2],
    root: impl Fn(P::Scalar) -> P::Scalar,
) -> Vec<Limit<P>> {
    let (joined, points) = (&joined(mesh), &mesh.positions);
    match scheme {
        Scheme::CatmullClark => catmull_clark_limits_with(joined, points, corners, circle, root),
        Scheme::Loop => loop_limits_with(joined, points, corners, circle),
        Scheme::Sqrt3 => sqrt3_limits_with(joined, points, corners, circle),
        Scheme::DooSabin(_) => unreachable!("the limits of Doo-Sabin are those of its faces"),
    }
    .expect("a mesh that the scheme takes")
}

/// The limits at all vertices in double precision.
pub fn limits(scheme: Scheme, mesh: &Mesh<[f64; 3]>, corners: Corners) -> Vec<Limit<[f64; 3]>> {
    limits_with(scheme, mesh, corners, turn_point, f64::sqrt)
}

/// The steps after which the boundary of a mesh is as before: two for √3, which refines it in every second.
pub fn rounds(scheme: Scheme) -> u32 {
    if scheme == Scheme::Sqrt3 { 2 } else { 1 }
}

/// A mesh after the given steps in double precision.
pub fn refined(
    scheme: Scheme,
    mesh: &Mesh<[f64; 3]>,
    steps: std::ops::Range<u32>,
    corners: Corners,
) -> Mesh<[f64; 3]> {
    steps.fold(mesh.clone(), |mesh, step| {
        scheme
            .step_with(
                &mesh,
                step,
                corners,
                facette::subdivision::mask::turn_cosine,
            )
            .expect("a small mesh")
    })
}

/// Faces around vertex 0, open on one side: `k` quadrilaterals or triangles on a boundary, whose own half-edge at the vertex goes to vertex 1.
pub fn half_fan(k: u32, is_quad: bool) -> Topology {
    let faces = (0..k).map(|i| {
        if is_quad {
            vec![0, 1 + i, 2 + k + i, 2 + i]
        } else {
            vec![0, 1 + i, 2 + i]
        }
    });
    let vertex_count = if is_quad { 2 + 2 * k } else { 2 + k };
    Topology {
        name: format!("half a fan of {k}"),
        vertex_count: vertex_count as usize,
        faces: faces.collect(),
    }
}

/// A whole number as a scalar.
pub fn whole<S: Scalar>(value: usize) -> S {
    S::from_i32(i32::try_from(value).expect("a small number"))
}

/// The angle between two vectors, in degrees.
pub fn degrees(a: Point, b: Point) -> f64 {
    length(a.cross(b)).atan2(a.dot(b)).to_degrees()
}

/// The unit normal of a face: the sum of the vector products from its first corner.
pub fn face_normal(mesh: &Mesh<Point>, face: &[u32]) -> Point {
    let at = |k: usize| mesh.positions[face[k] as usize].minus(mesh.positions[face[0] as usize]);
    let sum = (1..face.len() - 1).fold([0.0; 3], |sum, k| sum.plus(at(k).cross(at(k + 1))));
    unit_vector(sum).expect("a face with an area")
}

/// The neighbourhood of vertex 0 after 0, 1, ... steps, each moved so that the limit of the vertex is the origin, and scaled to its first
/// size: neither changes an angle, and hundreds of levels lose no digits.
pub fn levels(scheme: Scheme, mesh: &Mesh<Point>, steps: u32) -> Vec<Mesh<Point>> {
    let mut all = vec![mesh.clone()];
    for step in 0..steps {
        let last = &all[all.len() - 1];
        let step = if scheme == Scheme::Sqrt3 { 0 } else { step };
        let fine = neighbourhood(&refined(scheme, last, step..step + 1, Corners::Sharp), 0, 3);
        let limit = limits(scheme, &fine, Corners::Sharp)[0].position;
        all.push(centred(&fine, limit));
    }
    all
}

/// The mesh with `centre` moved to the origin, and scaled by a power of two so that its largest coordinate is between 1 and 2.
pub fn centred(mesh: &Mesh<Point>, centre: Point) -> Mesh<Point> {
    let offsets: Vec<Point> = mesh.positions.iter().map(|p| p.minus(centre)).collect();
    let largest = offsets
        .iter()
        .map(|p| p.largest_coordinate())
        .fold(0.0, f64::max);
    let scale = 1.0 / largest.power_of_two();
    let points = offsets.iter().map(|p| p.times(scale)).collect();
    Mesh::new(points, mesh.faces()).expect("the same faces")
}

/// Vertex 0 in the middle of circles of neighbours, with heights at random.
pub fn hilly(scheme: Scheme, n: u32, seed: u64) -> Mesh<Point> {
    let topology = if scheme == Scheme::CatmullClark {
        quad_fan(n)
    } else {
        double_fan(n)
    };
    let mut dice = Dice::new(seed);
    let place = |vertex: usize| {
        let height = dice.roll();
        let Some(k) = vertex.checked_sub(1) else {
            return [0.0, 0.0, height];
        };
        let (ring, k) = (k / n as usize, k % n as usize);
        let angle = f64::pi() * (2 * k + ring) as f64 / f64::from(n);
        let radius = 1.0 + ring as f64;
        [radius * angle.cos(), radius * angle.sin(), height]
    };
    topology.with_points((0..topology.vertex_count).map(place).collect())
}
