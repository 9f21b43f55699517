//! Meshes at random: their faces, and their points.

use proptest::collection::vec;
use proptest::prelude::*;

use super::{
    Cage, Topology, bipyramid, cube_faces, double_fan, fan, grid, octahedron_faces, polygon, prism,
    pyramid, quad_fan, tetrahedron_faces, torus, triangle_grid, triangle_torus, tube,
    with_isolated_vertex,
};
use crate::common::exact::{Exact, fraction};
use crate::common::generators::{float_coordinate, hard_float_coordinate, point};

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
