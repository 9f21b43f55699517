//! What the steps of all schemes have in common. The book shows the doc comments.

use facette::algebra::VectorSpace;
use facette::mesh::Mesh;
use facette::subdivision::curve::{Ends, chaikin_step, cubic_step};
use facette::subdivision::{Connectivity, Corners};
use num_traits::Zero;

use crate::common::exact::Exact;
use crate::common::law::{Law, Verdict, expect_equal};
use crate::meshes::{
    Cage, hard_meshes, hard_triangle_meshes, meshes, triangle_meshes, with_isolated_vertex,
};
use crate::steps::{
    OF_POLYGONS, OF_TRIANGLES, Scheme, boundary_polygons, corner_rules, expect_same_cycles,
};
use crate::suspects;

type Point = [Exact; 3];

/// Tries a law of one step on meshes that each scheme takes.
fn holds_for_all(
    theorem: &'static str,
    check: impl Fn(Scheme, &Cage<Point>, u32, Corners) -> Verdict,
) {
    let steps = || (0..2_u32, corner_rules());
    let with = |schemes: &[Scheme], (cage, (step, corners)): &(Cage<Point>, (u32, Corners))| {
        schemes
            .iter()
            .try_for_each(|&scheme| check(scheme, cage, *step, *corners))
    };
    let law = || Law::new(theorem, suspects::library);
    law().holds((meshes(), steps()), (hard_meshes(), steps()), |input| {
        with(&OF_POLYGONS, input)
    });
    let triangles = (triangle_meshes(), steps());
    law().holds(triangles, (hard_triangle_meshes(), steps()), |input| {
        with(&OF_TRIANGLES, input)
    });
}

/// **Affine invariance.** Moving the mesh by an affine map and refining it, or refining and then moving, gives the same mesh, for each scheme: the weights of every mask sum to 1.
///
/// Course: D13, slide 64, Doo-Sabin extends Chaikin's scheme.
#[test]
fn steps_are_affinely_invariant() {
    let map = |[px, py, pz]: Point| {
        let two = num_traits::One::one();
        let sheared: Point = [px + py, py - pz - pz, px + pz];
        sheared.plus([two, Exact::zero(), two + two])
    };
    holds_for_all(
        "subdivision::steps_are_affinely_invariant",
        |scheme, cage, step, corners| {
            let before = scheme.step(&cage.mapped(map).mesh, step, corners).positions;
            let after = scheme.step(&cage.mesh, step, corners).positions;
            expect_equal(&after.into_iter().map(map).collect(), &before)
        },
    );
}

/// **Convex hull.** Every new point is a mean of old ones with weights that are not negative. So in no direction does the refined mesh reach further than the mesh before, for any scheme; and the same holds for the limit. (One exception: Catmull-Clark's rule at an inner vertex of valence 2, where $n-3$ is negative.)
///
/// Course: D15, slide 68, Doo-Sabin: a mean of points of three kinds.
#[test]
fn steps_stay_in_the_convex_hull() {
    let theorem = "subdivision::steps_stay_in_the_convex_hull";
    let directions: Vec<Point> = [[1, 0, 0], [0, 1, 0], [1, 2, 3], [-2, 1, 1], [5, -3, 2]]
        .map(|d| d.map(facette::algebra::Scalar::from_i32))
        .to_vec();
    holds_for_all(theorem, |scheme, cage, step, corners| {
        if has_inner_vertex_of_valence_2(&cage.connectivity()) {
            return Ok(());
        }
        let refined = scheme.step(&cage.mesh, step, corners);
        for direction in &directions {
            let [before, after] = [&cage.mesh, &refined].map(|mesh| extent(mesh, *direction));
            let inside = before[0] <= after[0] && after[1] <= before[1];
            expect_equal(&true, &inside)?;
        }
        Ok(())
    });
}

/// How far a mesh reaches against and along a direction.
fn extent(mesh: &Mesh<Point>, direction: Point) -> [Exact; 2] {
    let dot = |p: &Point| p[0] * direction[0] + p[1] * direction[1] + p[2] * direction[2];
    let values = || mesh.positions.iter().map(dot);
    let least = values().reduce(|a, b| if b < a { b } else { a });
    let largest = values().reduce(|a, b| if b > a { b } else { a });
    [least, largest].map(|value| value.expect("a mesh has points"))
}

fn has_inner_vertex_of_valence_2(joined: &Connectivity) -> bool {
    let mut vertices = (0..).take(joined.vertex_count());
    vertices.any(|v| !joined.is_boundary_vertex(v) && joined.valence(v) == 2)
}

/// **A colour is refined like a position.** The weights depend on the faces alone. Six numbers at each vertex, three of the place and three of a colour, are refined together as they are apart: any quantity may ride on the mesh.
///
/// Course: D01, slide 49, subdivision and parametric surfaces.
#[test]
fn colours_are_refined_like_positions() {
    let theorem = "subdivision::colours_are_refined_like_positions";
    holds_for_all(theorem, |scheme, cage, step, corners| {
        let colour = |[x, y, z]: Point| [y * y, x - z, x * y * z];
        let both = |p: Point| {
            let c = colour(p);
            [p[0], p[1], p[2], c[0], c[1], c[2]]
        };
        let together = scheme.step(&cage.mapped(both).mesh, step, corners);
        let [place, tint] = [
            scheme.step(&cage.mesh, step, corners),
            scheme.step(&cage.mapped(colour).mesh, step, corners),
        ];
        let apart = place.positions.iter().zip(&tint.positions);
        let apart: Vec<[Exact; 6]> = apart
            .map(|(p, c)| [p[0], p[1], p[2], c[0], c[1], c[2]])
            .collect();
        expect_equal(&apart, &together.positions)
    });
}

/// **The boundary is a curve of its own.** With smooth corners the boundary of the refined mesh is its boundary polygon, refined by the closed curve scheme: by Chaikin's for Doo-Sabin, by the cubic one for Catmull-Clark and Loop. Nothing inside the mesh moves it, so two meshes that share a boundary polygon share the limit
/// curve there.
///
/// Course: D27, slide 78, Loop: boundaries.
#[test]
fn boundary_is_refined_as_a_curve() {
    let theorem = "subdivision::boundary_is_refined_as_a_curve";
    holds_for_all(theorem, |scheme, cage, _, _| {
        let round: fn(&[Point], Ends) -> Vec<Point> = match scheme {
            Scheme::Sqrt3 => return Ok(()),
            Scheme::DooSabin(_) => chaikin_step,
            Scheme::CatmullClark | Scheme::Loop => cubic_step,
        };
        let polygons = boundary_polygons(&cage.mesh);
        let expected: Vec<_> = polygons
            .iter()
            .map(|polygon| round(polygon, Ends::Closed))
            .collect();
        let refined = scheme.step(&cage.mesh, 0, Corners::Smooth);
        expect_same_cycles(&expected, &boundary_polygons(&refined))
    });
}

/// **Vertices without a face.** A vertex that no face visits stays where it is, except in Doo-Sabin, where new points come from faces only: there it vanishes. In no scheme does it change what becomes of the others.
///
/// Course: D17, slides 69-70, Doo-Sabin: how the new points are joined.
#[test]
fn vertices_without_a_face_change_nothing() {
    let theorem = "subdivision::vertices_without_a_face_change_nothing";
    let lonely: Point = [1, 2, 3].map(facette::algebra::Scalar::from_i32);
    holds_for_all(theorem, |scheme, cage, step, corners| {
        let topology = crate::meshes::Topology {
            name: cage.name.clone(),
            vertex_count: cage.mesh.positions.len(),
            faces: cage.mesh.faces().map(<[u32]>::to_vec).collect(),
        };
        let mut points = cage.mesh.positions.clone();
        points.push(lonely);
        let longer = with_isolated_vertex(topology).with_points(points);
        let mut got = scheme.step(&longer, step, corners).positions;
        let expected = scheme.step(&cage.mesh, step, corners).positions;
        if !matches!(scheme, Scheme::DooSabin(_)) {
            expect_equal(&lonely, &got.remove(cage.mesh.positions.len()))?;
        }
        expect_equal(&expected, &got)
    });
}
