//! The theorems of meshes and of tessellation. The book shows their doc comments.

use std::collections::HashMap;

use facette::algebra::{Scalar, VectorSpace, length, unit_vector};
use facette::mesh::{Mesh, tessellate_uniformly};
use facette::surface::Surface;
use proptest::collection::vec;
use proptest::prelude::*;

use crate::common::generators::float_coordinate;
use crate::common::law::{expect_at_most, expect_equal};
use crate::inputs::{expect, hard_saddles, law, saddles, triangle_normal};

/// A mesh's vertices on a grid of whole numbers from 0 to 8, and its faces.
type Whole = (Vec<[i32; 3]>, Vec<Vec<u32>>);

fn whole_meshes(largest_face: usize) -> impl Strategy<Value = Whole> {
    let faces = vec(vec(0..6_u32, 3..=largest_face), 0..=6);
    (vec([0..=8_i32, 0..=8_i32, 0..=8_i32], 6), faces)
}

/// Faces that name a vertex twice, and the same face from both sides.
fn hard_whole_meshes() -> impl Strategy<Value = Whole> {
    let faces = vec![vec![0, 1, 1], vec![0, 1, 2], vec![2, 1, 0], vec![3, 4, 5]];
    vec([0..=1_i32, 0..=1_i32, 0..=1_i32], 6).prop_map(move |points| (points, faces.clone()))
}

/// **Faces.** A mesh gives back its faces as they were given. As triangles, a face of $n$ vertices becomes the fan of $n-2$ triangles
/// around its first vertex.
#[test]
fn face_becomes_a_fan_of_triangles() {
    let theorem = law("ground_floor::face_becomes_a_fan_of_triangles");
    theorem.holds(whole_meshes(7), hard_whole_meshes(), |(points, faces)| {
        let positions: Vec<_> = points.iter().map(|p| p.map(f64::from)).collect();
        let mesh = Mesh::new(positions, faces).expect("faces of existing vertices");
        expect_equal(&faces.len(), &mesh.face_count())?;
        let given_back: Vec<Vec<u32>> = mesh.faces().map(<[u32]>::to_vec).collect();
        expect_equal(faces, &given_back)?;
        let mut fans = Vec::new();
        for face in faces {
            for corner in 2..face.len() {
                fans.push([face[0], face[corner - 1], face[corner]]);
            }
        }
        expect_equal(&fans, &mesh.triangles().collect())
    });
}

/// **Vertex normals.** The normal of a vertex is the sum $S$ of the vector products of its triangles, made a unit vector: the mean of
/// the triangles' normals, each counted by its area. A vertex without triangles has the zero vector. In floating point the error
/// is at most $(40\,T/|S|+8)\,u$, with $T$ the sum of the products of the sides' lengths: it grows where normals cancel.
#[test]
fn vertex_normal_is_the_mean_of_its_triangles_by_area() {
    let theorem = law("ground_floor::vertex_normal_is_the_mean_of_its_triangles_by_area");
    theorem.holds(whole_meshes(4), hard_whole_meshes(), |(points, faces)| {
        let positions: Vec<_> = points.iter().map(|p| p.map(f64::from)).collect();
        let mesh = Mesh::new(positions.clone(), faces).expect("faces of existing vertices");
        let mut sums = vec![([0.0_f64; 3], 0.0); positions.len()];
        for triangle in mesh.triangles() {
            let [a, b, c] = triangle.map(|vertex| positions[vertex as usize]);
            // Whole numbers: nothing is rounded here.
            let normal = triangle_normal([a, b, c]);
            let size =
                length(b.minus(a)) * length(c.minus(a)) + length(b.minus(c)) * length(c.minus(a));
            for vertex in triangle.map(|vertex| vertex as usize) {
                let (sum, sizes) = sums[vertex];
                sums[vertex] = (sum.plus(normal), sizes + size);
            }
        }
        for ((sum, sizes), normal) in sums.into_iter().zip(mesh.vertex_normals()) {
            if sizes == 0.0 {
                expect_equal(&[0.0; 3], &normal)?;
            }
            if let Some(expected) = unit_vector(sum) {
                let bound = 40.0 * sizes / length(sum) + 8.0;
                let error = normal.minus(expected).largest_coordinate() / f64::unit_roundoff();
                expect_at_most("error of the normal in u", bound, error)?;
            }
        }
        Ok(())
    });
}

/// **Normals have no size.** A mesh that is $2^k$ times as large has the same vertex normals, to the bit: from $10^{-270}$ to
/// $10^{270}$, where the vector products themselves would be zero or infinite.
#[test]
fn vertex_normals_do_not_depend_on_the_size_of_the_mesh() {
    let points = || {
        vec(
            [float_coordinate(), float_coordinate(), float_coordinate()],
            6,
        )
    };
    let exponents = prop::sample::select(vec![-900, -600, 600, 900]);
    let theorem = law("ground_floor::vertex_normals_do_not_depend_on_the_size_of_the_mesh");
    theorem.holds(
        (points(), -100..=100_i32),
        (points(), exponents),
        |(points, exponent)| {
            let faces = [[0, 1, 2], [0, 2, 3], [3, 4, 5], [5, 1, 0]];
            let mesh = Mesh::new(points.clone(), faces).expect("faces of existing vertices");
            let size = 2_f64.powi(*exponent);
            let resized = points.iter().map(|p| p.times(size)).collect();
            let resized = Mesh::new(resized, faces).expect("faces of existing vertices");
            expect_equal(&mesh.vertex_normals(), &resized.vertex_normals())?;
            for normal in mesh.vertex_normals() {
                let error = (length(normal) - 1.0).abs() / f64::unit_roundoff();
                expect_at_most("error of the length in u", 8.0, error)?;
            }
            Ok(())
        },
    );
}

/// **The grid is a disk.** With $m\times n$ cells there are $(m+1)(n+1)$ vertices and $2mn$ triangles. Each inner edge belongs to two
/// triangles that run along it in opposite directions, $2(m+n)$ edges to one, and Euler's number $V-E+F$ is 1.
#[test]
fn grid_has_the_topology_of_a_disk() {
    let grids = (saddles(), 1..=9_usize, 1..=9_usize);
    let thin = (hard_saddles(), Just(1), 1..=30_usize);
    law("ground_floor::grid_has_the_topology_of_a_disk").holds(grids, thin, |(surface, m, n)| {
        let mesh = tessellate_uniformly(surface, *m, *n).expect("a usable grid");
        let mut edges: HashMap<[u32; 2], Vec<bool>> = HashMap::new();
        for [a, b, c] in mesh.triangles() {
            for [from, to] in [[a, b], [b, c], [c, a]] {
                let forwards = from < to;
                let edge = [from.min(to), from.max(to)];
                edges.entry(edge).or_default().push(forwards);
            }
        }
        let vertices = mesh.positions.len();
        expect_equal(&(*m + 1, *n + 1), &(vertices / (n + 1), vertices / (m + 1)))?;
        expect_equal(&(2 * m * n), &mesh.face_count())?;
        expect_equal(&(edges.len() + 1), &(vertices + mesh.face_count()))?;
        let once = edges.values().filter(|uses| uses.len() == 1).count();
        expect_equal(&(2 * (m + n)), &once)?;
        let opposite = |uses: &Vec<bool>| matches!(uses[..], [_] | [true, false] | [false, true]);
        expect("opposite directions", edges.values().all(opposite), &edges)
    });
}

/// **The vertices lie on the surface.** Vertex $(i,j)$ is the point $S(u_i,v_j)$ with the bits that the surface gives, where $u_i$
/// and $v_j$ divide the sides of the parameter rectangle into equal parts; its ends are exact.
#[test]
fn vertices_lie_on_the_surface() {
    let grids = (saddles(), 1..=7_usize, 1..=7_usize);
    let hard = (hard_saddles(), 1..=7_usize, 1..=7_usize);
    law("ground_floor::vertices_lie_on_the_surface").holds(grids, hard, |(surface, m, n)| {
        let mesh = tessellate_uniformly(surface, *m, *n).expect("a usable grid");
        let points: Vec<_> = mesh
            .parameters
            .iter()
            .map(|&[u, v]| surface.point(u, v))
            .collect();
        expect_equal(&points, &mesh.positions)?;
        let [[u0, u1], [v0, v1]] = surface.domain;
        expect_equal(&Some(&[u0, v0]), &mesh.parameters.first())?;
        expect_equal(&Some(&[u1, v1]), &mesh.parameters.last())?;
        for (index, &[u, v]) in mesh.parameters.iter().enumerate() {
            let [i, j] = [index % (m + 1), index / (m + 1)].map(|k| k as f64);
            let even = [
                u0 + i / *m as f64 * (u1 - u0),
                v0 + j / *n as f64 * (v1 - v0),
            ];
            let size = u0.abs().max(u1.abs()).max(v0.abs()).max(v1.abs());
            let error =
                (u - even[0]).abs().max((v - even[1]).abs()) / (size * f64::unit_roundoff());
            expect_at_most("distance from equal steps in u", 10.0, error)?;
        }
        Ok(())
    });
}

/// **The right side is outside.** Every triangle runs anticlockwise as seen from where the surface's normal $S_u\times S_v$ points, and
/// the vertices carry this normal as a unit vector; where the surface does not know it, the normal of the triangles.
#[test]
fn triangles_face_the_side_of_the_normal() {
    let grids = (saddles(), 1..=7_usize, 1..=7_usize);
    let hard = (hard_saddles(), 1..=7_usize, 1..=7_usize);
    law("ground_floor::triangles_face_the_side_of_the_normal").holds(
        grids,
        hard,
        |(surface, m, n)| {
            let mesh = tessellate_uniformly(surface, *m, *n).expect("a usable grid");
            for triangle in mesh.triangles() {
                let [_, _, z] =
                    triangle_normal(triangle.map(|vertex| mesh.positions[vertex as usize]));
                expect("a triangle that faces upwards", z > 0.0, triangle)?;
            }
            for (&[u, v], &normal) in mesh.parameters.iter().zip(&mesh.normals) {
                let [x, y] = [-surface.factor * v, -surface.factor * u];
                let whole = (x * x + y * y + 1.0).sqrt();
                let true_normal = [x / whole, y / whole, 1.0 / whole];
                let error = normal.minus(true_normal).largest_coordinate() / f64::unit_roundoff();
                // 3u of the vector product, 5u of the unit vector, and 4u of this formula.
                expect_at_most("error of the normal in u", 12.0, error)?;
            }
            expect_equal(&mesh.positions.len(), &mesh.normals.len())
        },
    );
}

/// **Points on a grid.** The points for all pairs of $u$ and $v$ are computed row by row, $u$ running fastest, each with the bits of
/// the single point.
#[test]
fn points_on_a_grid_stand_row_by_row() {
    let grids = (
        saddles(),
        vec(float_coordinate(), 1..6),
        vec(float_coordinate(), 0..6),
    );
    let hard = (
        hard_saddles(),
        vec(float_coordinate(), 0..2),
        vec(float_coordinate(), 0..2),
    );
    law("ground_floor::points_on_a_grid_stand_row_by_row").holds(
        grids,
        hard,
        |(surface, us, vs)| {
            let mut points = vec![[f64::NAN; 3]; us.len() * vs.len()];
            surface.points_on_grid(us, vs, &mut points);
            let mut expected = Vec::new();
            for &v in vs {
                for &u in us {
                    expected.push(surface.point(u, v));
                }
            }
            expect_equal(&expected, &points)
        },
    );
}
