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

pub use random::*;

mod random;

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

    /// Whether the faces can be joined.
    pub fn is_manifold(&self) -> bool {
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

/// The quadrilaterals between columns and rows of vertices, which `vertex` numbers.
fn cells(columns: u32, rows: u32, vertex: impl Fn(u32, u32) -> u32) -> Vec<[u32; 4]> {
    let places = (0..rows).flat_map(|j| (0..columns).map(move |i| (i, j)));
    let quad = |(i, j)| [[i, j], [i + 1, j], [i + 1, j + 1], [i, j + 1]].map(|[i, j]| vertex(i, j));
    places.map(quad).collect()
}

/// Quadrilaterals in columns and rows, with a boundary. Vertex i + (columns + 1)j is in column i, row j.
pub fn grid(columns: u32, rows: u32) -> Topology {
    let faces = cells(columns, rows, |i, j| i + (columns + 1) * j);
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
    let faces = cells(columns, rows, |i, j| i % columns + columns * (j % rows));
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
