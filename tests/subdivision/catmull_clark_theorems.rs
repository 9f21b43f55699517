//! The theorems of a step of Catmull-Clark. The book shows their doc comments.

use facette::subdivision::{Connectivity, Corners, catmull_clark};
use proptest::prelude::*;

use crate::common::law::{Law, expect_equal};
use crate::meshes::{hard_meshes, hard_topologies, meshes, topologies};
use crate::nets::{cubic_row, grid_of, in_rows, refined_rows};
use crate::plain_rules::Plain;
use crate::steps::{corner_rules, flat};
use crate::suspects;

fn law(theorem: &'static str) -> Law {
    Law::new(theorem, suspects::catmull_clark)
}

/// **Face points and edge points.** The face point of a face is the centroid of its $n$ vertices, $F=\frac1n\sum p_i$. The edge point of an inner edge is the mean of
/// four points, its two ends and the two face points beside it: $P_e=\frac12(Q+R)$ with the midpoint $Q$ of the edge and the mean $R$ of the face points. On the boundary it is the
/// midpoint $Q$.
///
/// Course: D19, slide 73, Catmull-Clark: points on faces.
/// Course: D20, slide 73, Catmull-Clark: points on edges.
/// Exercise: catmull_clark.
#[test]
fn catmull_clark_places_face_points_and_edge_points() {
    let law = law("subdivision::catmull_clark_places_face_points_and_edge_points");
    law.holds(meshes(), hard_meshes(), |cage| {
        let (joined, plain) = (cage.connectivity(), Plain::new(&cage.mesh));
        let refined = catmull_clark(&joined, &cage.mesh.positions, Corners::Sharp);
        let refined = refined.expect("a manifold").positions;
        let (_, new) = refined.split_at(joined.vertex_count());
        let (on_edges, on_faces) = new.split_at(joined.edge_count());
        let face_points: Vec<_> = cage
            .mesh
            .faces()
            .map(|face| plain.face_point(face))
            .collect();
        expect_equal(&face_points, &on_faces.to_vec())?;
        for (edge, got) in (0..).zip(on_edges) {
            let h = joined.half_edge_of(edge);
            let ends = [joined.origin(h), joined.target(h)];
            expect_equal(&plain.catmull_clark_edge(ends), got)?;
        }
        Ok(())
    });
}

/// **Vertex points.** A vertex $S$ inside the mesh with $n$ edges goes to $\dfrac{Q+2R+(n-3)S}{n}$, with the mean $Q$ of the face points around it and the mean $R$ of the *midpoints*
/// of its edges. (The mean of the edge points is $\frac12(Q+R)$; who takes it for $R$ gets $2Q+R$ in the numerator.) A vertex on the boundary goes to $\frac18(A+6S+B)$ between its neighbours $A,B$ along the boundary; with sharp corners it stays if it has a
/// single face.
///
/// Course: D21, slide 73, Catmull-Clark: old vertices.
/// Exercise: catmull_clark.
#[test]
fn catmull_clark_moves_the_old_vertices() {
    let law = law("subdivision::catmull_clark_moves_the_old_vertices");
    let ordinary = (meshes(), corner_rules());
    law.holds(
        ordinary,
        (hard_meshes(), corner_rules()),
        |(cage, corners)| {
            let plain = Plain::new(&cage.mesh);
            let refined = catmull_clark(&cage.connectivity(), &cage.mesh.positions, *corners);
            let refined = refined.expect("a manifold").positions;
            for vertex in (0..).take(cage.mesh.positions.len()) {
                let expected = plain.catmull_clark_vertex(vertex, *corners);
                expect_equal(&expected, &refined[vertex as usize])?;
            }
            Ok(())
        },
    );
}

/// **Quadrilaterals from the first step on.** Each face of $n$ corners becomes $n$ quadrilaterals: corner, edge point, face point, edge point. An old vertex keeps its valence, a face point has that of its face, and every edge
/// point has valence 4, or 3 on the boundary. So after one step the irregular points are as many as they will ever be.
///
/// Course: D22, slide 75, Catmull-Clark: how the points are joined.
/// Exercise: catmull_clark.
#[test]
fn catmull_clark_makes_quadrilaterals_and_keeps_valences() {
    let law = law("subdivision::catmull_clark_makes_quadrilaterals_and_keeps_valences");
    law.holds(topologies(), hard_topologies(), |topology| {
        let mesh = flat(topology);
        let joined = topology.connectivity();
        let refined = catmull_clark(&joined, &mesh.positions, Corners::Sharp).expect("a manifold");
        let (v, e) = (joined.vertex_count(), joined.edge_count());
        let number = |count: usize| u32::try_from(count).expect("a small mesh");
        let of_edge = |h| number(v) + joined.edge_of(h);
        let expected: Vec<_> = (0..number(joined.half_edge_count()))
            .map(|h| {
                let centre = number(v + e) + joined.face_of(h);
                [
                    joined.origin(h),
                    of_edge(h),
                    centre,
                    of_edge(joined.previous(h)),
                ]
            })
            .collect();
        let got: Vec<_> = refined.faces().collect();
        expect_equal(&expected.iter().map(|face| &face[..]).collect(), &got)?;
        let finer = Connectivity::new(&refined).expect("a step leaves a manifold");
        for vertex in 0..number(v) {
            expect_equal(&joined.valence(vertex), &finer.valence(vertex))?;
        }
        for edge in 0..number(e) {
            let expected = if joined.is_boundary_edge(edge) { 3 } else { 4 };
            expect_equal(&expected, &finer.valence(number(v) + edge))?;
        }
        for (face, vertices) in (0..).zip(mesh.faces()) {
            expect_equal(&vertices.len(), &finer.valence(number(v + e) + face))?;
        }
        Ok(())
    });
}

/// **A bicubic B-spline on a grid.** On a grid of quadrilaterals a step of Catmull-Clark is the step of the cubic curve scheme along the rows, then along the columns, with the mask $\frac18(1,4,6,4,1)$: the midpoint
/// insertion of a uniform bicubic B-spline. So wherever the mesh is a grid, the limit is that surface. At the boundary, with sharp corners, each row ends as a curve with
/// $P_{-1}=2P_0-P_1$ does.
///
/// Course: D01, slide 49, subdivision and parametric surfaces.
/// Exercise: catmull_clark.
#[test]
fn catmull_clark_on_a_grid_is_the_bicubic_b_spline() {
    let law = law("subdivision::catmull_clark_on_a_grid_is_the_bicubic_b_spline");
    let grids = (1..5_u32, 1..5_u32).prop_flat_map(|(columns, rows)| grid_of(columns, rows));
    let thin = (1..6_u32).prop_flat_map(|columns| grid_of(columns, 1));
    law.holds(grids, thin, |cage| {
        let refined = catmull_clark(&cage.connectivity(), &cage.mesh.positions, Corners::Sharp);
        let expected = refined_rows(&in_rows(&cage.mesh.positions), cubic_row);
        expect_equal(&expected, &in_rows(&refined.expect("a manifold").positions))
    });
}
