//! Meshes for all tests of the chapter: named ones of every kind that a scheme may meet, and random ones.
//!
//! A [`Topology`] is the faces alone. [`meshes`] and [`hard_meshes`] (any polygons), [`triangle_meshes`] and [`hard_triangle_meshes`] give it
//! exact points at random, [`float_meshes`] points in floating point.
#![allow(
    dead_code,
    reason = "the tests and the exercises use their part of these"
)]

use std::fmt;

use facette::algebra::{Scalar, VectorSpace};
use facette::mesh::Mesh;
use facette::subdivision::Connectivity;
use proptest::collection::vec;
use proptest::prelude::*;

use crate::common::exact::{Exact, fraction};
use crate::common::generators::{float_coordinate, hard_float_coordinate, point};

/// The faces of a mesh, without points.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Topology {
    /// What it is.
    pub name: String,
    /// How many vertices there are, those without faces too.
    pub vertex_count: usize,
    /// The vertices of each face.
    pub faces: Vec<Vec<u32>>,
}

impl Topology {
    fn new<F: Into<Vec<u32>>>(name: String, faces: impl IntoIterator<Item = F>) -> Self {
        let faces: Vec<Vec<u32>> = faces.into_iter().map(Into::into).collect();
        let vertices = faces.iter().flatten();
        let vertex_count = vertices.max().map_or(0, |&vertex| vertex as usize + 1);
        Self {
            name,
            vertex_count,
            faces,
        }
    }

    /// The mesh of these faces with the given points.
    pub fn with_points<P: VectorSpace>(&self, points: Vec<P>) -> Mesh<P> {
        assert_eq!(points.len(), self.vertex_count, "a point for each vertex");
        Mesh::new(points, &self.faces).expect("the faces name vertices that are there")
    }

    /// How the faces are joined.
    pub fn connectivity(&self) -> Connectivity {
        let points = vec![0.0; self.vertex_count];
        Connectivity::new(&self.with_points(points)).expect("a manifold")
    }

    fn is_manifold(&self) -> bool {
        let points = vec![0.0; self.vertex_count];
        Mesh::new(points, &self.faces).is_ok_and(|mesh| Connectivity::new(&mesh).is_ok())
    }
}

/// A mesh with a name. It shows itself on one line.
#[derive(Clone, PartialEq)]
pub struct Cage<P: VectorSpace> {
    /// What it is.
    pub name: String,
    /// The mesh.
    pub mesh: Mesh<P>,
}

impl<P: VectorSpace> Cage<P> {
    /// How the faces are joined.
    pub fn connectivity(&self) -> Connectivity {
        Connectivity::new(&self.mesh).expect("the generators make manifolds")
    }

    /// The same faces with every point mapped.
    pub fn mapped<Q: VectorSpace>(&self, map: impl FnMut(P) -> Q) -> Cage<Q> {
        let points = self.mesh.positions.iter().copied().map(map).collect();
        Cage {
            name: self.name.clone(),
            mesh: Mesh::new(points, self.mesh.faces()).expect("the points stay finite"),
        }
    }
}

impl<P: VectorSpace> fmt::Debug for Cage<P> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let faces: Vec<_> = self.mesh.faces().collect();
        let points = &self.mesh.positions;
        write!(
            formatter,
            "{}, faces {faces:?}, points {points:?}",
            self.name
        )
    }
}

/// The vertices 0, 4e₁, 4e₂, 4e₃.
pub fn tetrahedron<S: Scalar>() -> Mesh<[S; 3]> {
    let points = [[0, 0, 0], [4, 0, 0], [0, 4, 0], [0, 0, 4]];
    tetrahedron_faces().with_points(in_scalars(&points))
}

/// The cube with corners ±1; bit k of a vertex' number is set where its coordinate k is 1.
pub fn cube<S: Scalar>() -> Mesh<[S; 3]> {
    let corner = |number: i32| [0, 1, 2].map(|bit| if number >> bit & 1 == 1 { 1 } else { -1 });
    let points: Vec<_> = (0..8).map(corner).collect();
    cube_faces().with_points(in_scalars(&points))
}

/// The octahedron with vertices ±e₁, ±e₂, ±e₃ in this order.
pub fn octahedron<S: Scalar>() -> Mesh<[S; 3]> {
    let vertex = |number: usize| {
        let mut point = [0; 3];
        point[number / 2] = if number.is_multiple_of(2) { 1 } else { -1 };
        point
    };
    let points: Vec<_> = (0..6).map(vertex).collect();
    octahedron_faces().with_points(in_scalars(&points))
}

fn in_scalars<S: Scalar>(points: &[[i32; 3]]) -> Vec<[S; 3]> {
    points.iter().map(|point| point.map(S::from_i32)).collect()
}

/// Four triangles, valence 3.
pub fn tetrahedron_faces() -> Topology {
    Topology::new(
        "tetrahedron".into(),
        [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]],
    )
}

/// Six quadrilaterals, valence 3.
#[rustfmt::skip]
pub fn cube_faces() -> Topology {
    let faces = [
        [0, 2, 3, 1], [4, 5, 7, 6],
        [0, 1, 5, 4], [2, 6, 7, 3],
        [0, 4, 6, 2], [1, 3, 7, 5],
    ];
    Topology::new("cube".into(), faces)
}

/// Eight triangles, valence 4.
#[rustfmt::skip]
pub fn octahedron_faces() -> Topology {
    let faces = [
        [0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4],
        [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5],
    ];
    Topology::new("octahedron".into(), faces)
}

/// Quadrilaterals in columns and rows, with a boundary. Vertex i + (columns + 1)j is in column i, row j.
pub fn grid(columns: u32, rows: u32) -> Topology {
    let vertex = |i, j| i + (columns + 1) * j;
    let quad = |i, j| {
        [
            vertex(i, j),
            vertex(i + 1, j),
            vertex(i + 1, j + 1),
            vertex(i, j + 1),
        ]
    };
    let faces = (0..rows).flat_map(|j| (0..columns).map(move |i| quad(i, j)));
    Topology::new(format!("grid of {columns} x {rows}"), faces)
}

/// [`grid`] with each quadrilateral cut along the diagonal that rises with i and j: inner vertices of valence 6.
pub fn triangle_grid(columns: u32, rows: u32) -> Topology {
    cut(
        &grid(columns, rows),
        format!("triangles in a grid of {columns} x {rows}"),
    )
}

fn cut(quads: &Topology, name: String) -> Topology {
    let faces = quads.faces.iter();
    let triangles =
        faces.flat_map(|quad| [[quad[0], quad[1], quad[2]], [quad[0], quad[2], quad[3]]]);
    Topology {
        vertex_count: quads.vertex_count,
        ..Topology::new(name, triangles)
    }
}

/// Quadrilaterals round a torus, closed, valence 4; at least 3 x 3. Vertex i + columns·j.
pub fn torus(columns: u32, rows: u32) -> Topology {
    let vertex = |i, j| i % columns + columns * (j % rows);
    let quad = |i, j| {
        [
            vertex(i, j),
            vertex(i + 1, j),
            vertex(i + 1, j + 1),
            vertex(i, j + 1),
        ]
    };
    let faces = (0..rows).flat_map(|j| (0..columns).map(move |i| quad(i, j)));
    Topology::new(format!("torus of {columns} x {rows}"), faces)
}

/// [`torus`] cut into triangles: valence 6.
pub fn triangle_torus(columns: u32, rows: u32) -> Topology {
    cut(
        &torus(columns, rows),
        format!("triangles on a torus of {columns} x {rows}"),
    )
}

/// A closed ring of quadrilaterals: two boundaries.
pub fn tube(sides: u32) -> Topology {
    let quad = |i| [i, (i + 1) % sides, sides + (i + 1) % sides, sides + i];
    Topology::new(format!("tube of {sides} sides"), (0..sides).map(quad))
}

/// Triangles around vertex 0, which has valence n; the others are 1..=n, anticlockwise.
pub fn fan(n: u32) -> Topology {
    let triangle = |i| [0, 1 + i, 1 + (i + 1) % n];
    Topology::new(format!("fan of {n} triangles"), (0..n).map(triangle))
}

/// Quadrilaterals around vertex 0, which has valence n: edge neighbours 1..=n, then the diagonal ones, anticlockwise.
pub fn quad_fan(n: u32) -> Topology {
    let quad = |i| [0, 1 + i, 1 + n + i, 1 + (i + 1) % n];
    Topology::new(format!("fan of {n} quadrilaterals"), (0..n).map(quad))
}

/// A fan of triangles with a second ring of them, so that the inner ring is off the boundary: valence n in vertex 0, 5 around it.
pub fn double_fan(n: u32) -> Topology {
    let inner = |i| 1 + i % n;
    let outer = |i| 1 + n + i % n;
    let triangles = (0..n).flat_map(|i| {
        [
            [0, inner(i), inner(i + 1)],
            [inner(i), outer(i), inner(i + 1)],
            [inner(i + 1), outer(i), outer(i + 1)],
        ]
    });
    Topology::new(format!("double fan of {n} triangles"), triangles)
}

/// A single face of n vertices.
pub fn polygon(n: u32) -> Topology {
    Topology::new(format!("polygon of {n}"), [(0..n).collect::<Vec<_>>()])
}

/// Two n-gons joined by quadrilaterals, closed.
pub fn prism(n: u32) -> Topology {
    let side = |i: u32| vec![i, (i + 1) % n, n + (i + 1) % n, n + i];
    let ends = [(0..n).rev().collect(), (n..2 * n).collect()];
    let faces = ends.into_iter().chain((0..n).map(side));
    Topology::new(format!("prism over {n} sides"), faces)
}

/// An n-gon joined to an apex, vertex n, by triangles, closed.
pub fn pyramid(n: u32) -> Topology {
    let side = |i: u32| vec![i, (i + 1) % n, n];
    let base: Vec<u32> = (0..n).rev().collect();
    let faces = std::iter::once(base).chain((0..n).map(side));
    Topology::new(format!("pyramid over {n} sides"), faces)
}

/// Triangles from n vertices to the apexes n and n + 1, closed: valence n there.
pub fn bipyramid(n: u32) -> Topology {
    let sides = (0..n).flat_map(|i| [[i, (i + 1) % n, n], [(i + 1) % n, i, n + 1]]);
    Topology::new(format!("bipyramid over {n} sides"), sides)
}

/// A vertex without a face, after all others.
pub fn with_isolated_vertex(topology: Topology) -> Topology {
    Topology {
        name: format!("{} and a vertex", topology.name),
        vertex_count: topology.vertex_count + 1,
        faces: topology.faces,
    }
}

/// Meshes of triangles, closed and with boundaries.
pub fn triangle_topologies() -> impl Strategy<Value = Topology> {
    prop_oneof![
        Just(tetrahedron_faces()),
        Just(octahedron_faces()),
        (1..4_u32, 1..4_u32).prop_map(|(columns, rows)| triangle_grid(columns, rows)),
        (3..5_u32, 3..5_u32).prop_map(|(columns, rows)| triangle_torus(columns, rows)),
        (3..9_u32).prop_map(fan),
        (3..8_u32).prop_map(double_fan),
        (3..8_u32).prop_map(bipyramid),
        random_triangles(),
    ]
}

/// A single triangle, vertices of valence 3 and of many, a vertex without a face.
pub fn hard_triangle_topologies() -> impl Strategy<Value = Topology> {
    prop_oneof![
        Just(polygon(3)),
        Just(fan(3)),
        Just(fan(20)),
        Just(bipyramid(3)),
        Just(with_isolated_vertex(tetrahedron_faces())),
        Just(with_isolated_vertex(fan(5))),
        random_triangles(),
    ]
}

/// Meshes of polygons, closed and with boundaries.
pub fn topologies() -> impl Strategy<Value = Topology> {
    prop_oneof![
        Just(cube_faces()),
        (1..4_u32, 1..4_u32).prop_map(|(columns, rows)| grid(columns, rows)),
        (3..5_u32, 3..5_u32).prop_map(|(columns, rows)| torus(columns, rows)),
        (3..7_u32).prop_map(tube),
        (3..9_u32).prop_map(quad_fan),
        (3..8_u32).prop_map(prism),
        (3..8_u32).prop_map(pyramid),
        random_polygons(),
        random_polygons(),
        triangle_topologies(),
        triangle_topologies(),
    ]
}

/// A single face, an inner vertex of valence 2, faces and vertices of high valence, a vertex without a face.
pub fn hard_topologies() -> impl Strategy<Value = Topology> {
    prop_oneof![
        (3..8_u32).prop_map(polygon),
        Just(quad_fan(2)),
        Just(prism(20)),
        Just(pyramid(20)),
        Just(with_isolated_vertex(grid(2, 1))),
        random_polygons(),
        hard_triangle_topologies(),
    ]
}

/// A random triangulation of the sphere, or of part of it: a tetrahedron whose triangles are split and whose edges are flipped at random,
/// and of which triangles may be left out.
pub fn random_triangles() -> impl Strategy<Value = Topology> {
    vec((0..3_u8, any::<prop::sample::Index>(), 0..3_usize), 0..12).prop_map(|changes| {
        let mut topology = tetrahedron_faces();
        for (kind, face, side) in changes {
            let face = face.index(topology.faces.len());
            let changed = match kind {
                0 => with_face_split(&topology, face),
                1 => with_edge_flipped(&topology, face, side),
                _ => without_face(&topology, face),
            };
            if changed.is_manifold() && !changed.faces.is_empty() {
                topology = changed;
            }
        }
        topology.name = "random triangles".into();
        topology
    })
}

/// A random triangulation of which faces are joined at random.
pub fn random_polygons() -> impl Strategy<Value = Topology> {
    let joints = vec(
        (any::<prop::sample::Index>(), any::<prop::sample::Index>()),
        0..6,
    );
    (random_triangles(), joints).prop_map(|(mut topology, joints)| {
        for (face, side) in joints {
            let face = face.index(topology.faces.len());
            let side = side.index(topology.faces[face].len());
            if let Some(changed) = with_faces_joined(&topology, face, side)
                && changed.is_manifold()
            {
                topology = changed;
            }
        }
        topology.name = "random polygons".into();
        topology
    })
}

fn with_face_split(topology: &Topology, face: usize) -> Topology {
    let mut changed = topology.clone();
    let new = u32::try_from(topology.vertex_count).expect("a small mesh");
    let old = changed.faces.remove(face);
    changed.vertex_count += 1;
    let pieces = (0..old.len()).map(|i| vec![old[i], old[(i + 1) % old.len()], new]);
    changed.faces.extend(pieces);
    changed
}

fn without_face(topology: &Topology, face: usize) -> Topology {
    let mut changed = topology.clone();
    changed.faces.remove(face);
    changed
}

/// The face that has the side of another face in the opposite direction, and the place of that side in it.
fn neighbour(topology: &Topology, face: usize, side: usize) -> Option<(usize, usize)> {
    let vertices = &topology.faces[face];
    let (a, b) = (vertices[side], vertices[(side + 1) % vertices.len()]);
    let sides = topology.faces.iter().enumerate().flat_map(|(other, face)| {
        (0..face.len())
            .map(move |place| (other, place, face[place], face[(place + 1) % face.len()]))
    });
    sides
        .into_iter()
        .find(|&(_, _, c, d)| (c, d) == (b, a))
        .map(|(other, place, ..)| (other, place))
}

fn with_edge_flipped(topology: &Topology, face: usize, side: usize) -> Topology {
    let mut changed = topology.clone();
    let Some((other, place)) = neighbour(topology, face, side) else {
        return changed;
    };
    let from = |face: usize, place: usize| topology.faces[face][place % 3];
    let [a, b, c] = [0, 1, 2].map(|i| from(face, side + i));
    let d = from(other, place + 2);
    changed.faces[face] = vec![a, d, c];
    changed.faces[other] = vec![d, b, c];
    changed
}

/// The face without the given side, and its neighbour there without the same side, as one.
fn with_faces_joined(topology: &Topology, face: usize, side: usize) -> Option<Topology> {
    let (other, place) = neighbour(topology, face, side)?;
    let rotated = |face: usize, place: usize| {
        let mut vertices = topology.faces[face].clone();
        vertices.rotate_left((place + 1) % topology.faces[face].len());
        vertices
    };
    // From the end of the side round to its start, and on round the other face.
    let mut joined = rotated(face, side);
    joined.pop();
    let mut rest = rotated(other, place);
    rest.pop();
    joined.extend(rest);
    let mut changed = topology.clone();
    changed.faces[face] = joined;
    changed.faces.remove(other);
    Some(changed)
}

fn with_exact_points(
    topologies: impl Strategy<Value = Topology>,
) -> impl Strategy<Value = Cage<[Exact; 3]>> {
    topologies.prop_flat_map(|topology| {
        vec(point(), topology.vertex_count).prop_map(move |points| Cage {
            name: topology.name.clone(),
            mesh: topology.with_points(points),
        })
    })
}

/// Meshes of polygons with exact points.
pub fn meshes() -> impl Strategy<Value = Cage<[Exact; 3]>> {
    with_exact_points(topologies())
}

/// Hard meshes of polygons, with exact points of which several may coincide.
pub fn hard_meshes() -> impl Strategy<Value = Cage<[Exact; 3]>> {
    prop_oneof![
        with_exact_points(hard_topologies()),
        with_few_points(topologies()),
    ]
}

/// Meshes of triangles with exact points.
pub fn triangle_meshes() -> impl Strategy<Value = Cage<[Exact; 3]>> {
    with_exact_points(triangle_topologies())
}

/// Hard meshes of triangles, with exact points of which several may coincide.
pub fn hard_triangle_meshes() -> impl Strategy<Value = Cage<[Exact; 3]>> {
    prop_oneof![
        with_exact_points(hard_triangle_topologies()),
        with_few_points(triangle_topologies()),
    ]
}

/// Points of which many coincide, so that faces have no area and edges no length.
fn with_few_points(
    topologies: impl Strategy<Value = Topology>,
) -> impl Strategy<Value = Cage<[Exact; 3]>> {
    (topologies, vec(0..2_i32, 512)).prop_map(|(topology, coordinates)| {
        let coordinates: Vec<_> = coordinates
            .into_iter()
            .map(|value| fraction(value, 1))
            .collect();
        let places = coordinates
            .windows(3)
            .map(|place| [place[0], place[1], place[2]]);
        Cage {
            name: format!("{} on eight places", topology.name),
            mesh: topology.with_points(places.take(topology.vertex_count).collect()),
        }
    })
}

/// Points in floating point: of ordinary size with all bits in use; a quarter of them far away, tiny, huge or zero.
pub fn float_meshes(
    topologies: impl Strategy<Value = Topology>,
) -> impl Strategy<Value = Cage<[f64; 3]>> {
    topologies.prop_flat_map(|topology| {
        let coordinate = || prop_oneof![3 => float_coordinate(), 1 => hard_float_coordinate()];
        vec(
            [coordinate(), coordinate(), coordinate()],
            topology.vertex_count,
        )
        .prop_map(move |points| Cage {
            name: topology.name.clone(),
            mesh: topology.with_points(points),
        })
    })
}

/// Every named topology is a manifold, and every kind of random one that is hoped for comes up.
#[test]
fn generators_make_manifolds_of_all_kinds() {
    use proptest::strategy::ValueTree;
    use proptest::test_runner::TestRunner;

    let mut runner = TestRunner::deterministic();
    let [mut closed, mut open, mut large_faces, mut irregular] = [0; 4];
    for _ in 0..200 {
        let tree = random_polygons().new_tree(&mut runner);
        let topology = tree.expect("a mesh").current();
        let connectivity = topology.connectivity();
        let vertices = 0..u32::try_from(connectivity.vertex_count()).expect("a small mesh");
        let has_boundary = vertices.clone().any(|v| connectivity.is_boundary_vertex(v));
        closed += u32::from(!has_boundary);
        open += u32::from(has_boundary);
        large_faces += u32::from(topology.faces.iter().any(|face| face.len() > 4));
        irregular += u32::from(vertices.into_iter().any(|v| connectivity.valence(v) > 6));
        let tree = topologies().new_tree(&mut runner).expect("a mesh");
        assert!(tree.current().is_manifold());
        let tree = hard_topologies().new_tree(&mut runner).expect("a mesh");
        assert!(tree.current().is_manifold());
    }
    println!("{closed} closed, {open} open, {large_faces} with large faces, {irregular} irregular");
    assert!(closed > 20 && open > 20 && large_faces > 20 && irregular > 10);
}
