//! Inputs that a step of a scheme must survive, with values known beforehand.

use facette::algebra::Scalar;
use facette::mesh::Mesh;
use facette::subdivision::mask::loop_vertex_weight;
use facette::subdivision::{
    Connectivity, Corners, Counts, Sqrt3Boundary, SubdivisionError, catmull_clark, doo_sabin_with,
    loop_subdivision_with, sqrt3_with,
};

use crate::common::exact::{Exact, fraction};
use crate::common::law::{Law, expect_equal};
use crate::meshes::{
    Topology, cube, fan, grid, hard_triangle_topologies, octahedron, polygon, prism, pyramid,
    quad_fan, tetrahedron, triangle_topologies,
};
use crate::steps::{OF_POLYGONS, Scheme, corner_rules, flat, rational_cosine};
use crate::suspects;

type Point = [Exact; 3];

fn first<const N: usize>(scheme: Scheme, mesh: &Mesh<[Exact; N]>) -> Mesh<[Exact; N]> {
    scheme.step(mesh, 0, Corners::Sharp)
}

fn over(points: [i32; 3], denominator: i32) -> Point {
    points.map(|numerator| fraction(numerator, denominator))
}

/// **The first round.** In the cube with corners $\pm1$ Catmull-Clark takes a corner to $\left(\frac59,\frac59,\frac59\right)$, so in the cube with corners 0 and 1 the origin goes to $\left(\frac29,\frac29,\frac29\right)$; the edge points have one coordinate 0 and two $\pm\frac34$. In the tetrahedron $0,4e_1,4e_2,4e_3$ the origin goes to $\frac{20}{27}$ in each coordinate by Catmull-Clark and by √3, and to
/// $\frac34$ by Loop. The apex of an octahedron goes to $\frac{33}{64}$ of its height by Loop and to $\frac59$ by √3.
#[test]
fn first_round_of_the_platonic_solids() {
    let refined = first(Scheme::CatmullClark, &cube());
    assert_eq!(refined.positions[7], [fraction(5, 9); 3]);
    let expected = [fraction(3, 4), fraction(3, 4), fraction(0, 1)];
    for edge_point in &refined.positions[8..20] {
        let mut sizes = edge_point.map(Scalar::magnitude);
        sizes.sort_by(|a, b| b.partial_cmp(a).expect("exact numbers are ordered"));
        assert_eq!(sizes, expected);
    }
    let origin = |scheme| first(scheme, &tetrahedron()).positions[0];
    assert_eq!(origin(Scheme::CatmullClark), over([20; 3], 27));
    assert_eq!(origin(Scheme::Loop), over([3; 3], 4));
    assert_eq!(origin(Scheme::Sqrt3), over([20; 3], 27));
    let apex = |scheme| first(scheme, &octahedron()).positions[0];
    assert_eq!(apex(Scheme::Loop), over([33, 0, 0], 64));
    assert_eq!(apex(Scheme::Sqrt3), over([5, 0, 0], 9));
}

/// **√3 leaves nothing open.** The octahedron's 8 triangles become 24, then 72; each flip uses the centroids of the two triangles that its edge really has, so the surface stays closed and Euler's characteristic 2.
#[test]
fn sqrt3_leaves_the_octahedron_closed() {
    let mut mesh = octahedron::<Exact>();
    for (step, faces) in [(0, 24), (1, 72), (2, 216)] {
        mesh = Scheme::Sqrt3.step(&mesh, step, Corners::Sharp);
        let joined = Connectivity::new(&mesh).expect("a step leaves a manifold");
        assert_eq!(
            (joined.face_count(), joined.euler_characteristic()),
            (faces, 2)
        );
        assert_eq!(2 * joined.edge_count(), joined.half_edge_count());
    }
}

/// **Too many to name.** A cube has $24\cdot4^k$ corners of faces after $k$ steps of Catmull-Clark; 32-bit numbers can name those of 13 steps. The fourteenth is refused with what there is too much of, and no memory is asked for.
#[test]
fn refinement_that_cannot_be_numbered_is_refused() {
    let mut counts = Counts::of(&Connectivity::new(&cube::<f64>()).expect("a closed mesh"));
    for _ in 0..13 {
        counts = counts.after_catmull_clark().expect("few enough");
    }
    assert_eq!(counts.half_edges, 24 << 26);
    let too_many = |what| Err(SubdivisionError::TooLarge { levels: 1, what });
    assert_eq!(counts.after_catmull_clark(), too_many("corners"));
    assert_eq!(counts.after_doo_sabin(Corners::Sharp), too_many("corners"));
    counts = counts.after_sqrt3(Sqrt3Boundary::Kept).unwrap_or(counts);
    assert_eq!(counts.after_loop(), too_many("corners"));
    let text = counts.after_loop().expect_err("too many").to_string();
    assert_eq!(
        text,
        "1 levels make more than 2^32 - 1 corners: ask for fewer"
    );
}

/// **Sharp or smooth corners.** A sheet of one quadrilateral keeps its four corners with sharp corners, and has them rounded off with smooth ones: Catmull-Clark takes $(0,0)$ to $\frac18(A+6P+B)=\left(\frac12,\frac12\right)$ in a sheet of side 4. Other programs differ just here.
#[test]
fn corners_of_a_sheet_are_sharp_or_smooth() {
    let sheet = grid(1, 1).with_points(
        [[0, 0], [4, 0], [0, 4], [4, 4]]
            .map(|p| p.map(|c| fraction(c, 1)))
            .to_vec(),
    );
    let joined = Connectivity::new(&sheet).expect("one face");
    let corner = |corners| {
        catmull_clark(&joined, &sheet.positions, corners)
            .expect("one face")
            .positions[0]
    };
    assert_eq!(corner(Corners::Sharp), [fraction(0, 1); 2]);
    assert_eq!(corner(Corners::Smooth), [fraction(1, 2); 2]);
    let quarter = |n, steps| facette::subdivision::mask::averaging_weight(n, steps);
    let cut =
        |corners| doo_sabin_with(&joined, &sheet.positions, corners, quarter).expect("one face");
    let [sharp, smooth] = [Corners::Sharp, Corners::Smooth].map(cut);
    assert_eq!([sharp.positions.len(), smooth.positions.len()], [16, 12]);
    assert_eq!(sharp.positions[12..], sheet.positions);
    assert_eq!(
        smooth.faces().map(<[u32]>::len).filter(|&n| n == 3).count(),
        4
    );
}

/// **A single triangle.** All its edges are boundary: Loop's step takes their midpoints and, with sharp corners, leaves the corners; two steps of √3 make nine triangles of it.
#[test]
fn single_triangle_is_all_boundary() {
    let triangle = polygon(3).with_points(
        [[0, 0, 0], [6, 0, 0], [0, 6, 0]]
            .map(|p| over(p, 1))
            .to_vec(),
    );
    let halves = first(Scheme::Loop, &triangle);
    let expected = [
        [0, 0, 0],
        [6, 0, 0],
        [0, 6, 0],
        [3, 0, 0],
        [3, 3, 0],
        [0, 3, 0],
    ];
    assert_eq!(halves.positions, expected.map(|p| over(p, 1)));
    let smooth = Scheme::Loop.step(&triangle, 0, Corners::Smooth);
    assert_eq!(smooth.positions[0], over([3, 3, 0], 4));
    let thirds = Scheme::Sqrt3.step(&first(Scheme::Sqrt3, &triangle), 1, Corners::Sharp);
    assert_eq!(thirds.face_count(), 9);
    assert_eq!(thirds.positions[..3], triangle.positions);
}

/// **An inner vertex of valence 2.** Two quadrilaterals may share two edges and the vertex between them. There Catmull-Clark's formula has the factor $n-3=-1$: the weights still sum to 1, but the new point may leave the hull of the old ones. Doo-Sabin's face for the vertex would have two corners; it is left out, and the surface stays closed there.
#[test]
fn inner_vertex_of_valence_two_may_leave_the_hull() {
    let topology = quad_fan(2);
    // Vertex 0 is at height 1, all others are at 0.
    let heights: Vec<[Exact; 1]> = (0..5).map(|v| [fraction(i32::from(v == 0), 1)]).collect();
    let mesh = topology.with_points(heights);
    let refined = first(Scheme::CatmullClark, &mesh);
    // Q = 1/4, R = 1/2: (1/4 + 1 − 1)/2.
    assert_eq!(refined.positions[0], [fraction(1, 8)]);
    let opposite: Vec<[Exact; 1]> = mesh
        .positions
        .iter()
        .map(|p| [fraction(1, 1) - p[0]])
        .collect();
    let steep: Vec<[Exact; 1]> = (0..5).map(|v| [fraction(i32::from(v == 3), 1)]).collect();
    for points in [opposite, steep] {
        let mesh = topology.with_points(points);
        let joined = Connectivity::new(&mesh).expect("a disk");
        for scheme in OF_POLYGONS {
            let refined =
                Connectivity::new(&first(scheme, &mesh)).expect("a step leaves a manifold");
            assert_eq!(
                refined.euler_characteristic(),
                joined.euler_characteristic()
            );
        }
    }
}

/// **Prisms and pyramids.** A prism over a pentagon has faces of four and five corners, a pyramid over a hexagon an apex of valence 6 and a face of six corners. Catmull-Clark and Doo-Sabin take both: all faces are quadrilaterals after the one, all inner vertices have valence 4 after the other.
#[test]
fn prisms_and_pyramids_are_subdivided() {
    for topology in [prism(5), pyramid(6), prism(200), pyramid(200)] {
        let mesh = flat(&topology);
        let quads = first(Scheme::CatmullClark, &mesh);
        assert!(
            quads.faces().all(|face| face.len() == 4),
            "{}",
            topology.name
        );
        for scheme in &OF_POLYGONS[1..] {
            let joined = Connectivity::new(&first(*scheme, &mesh)).expect("a manifold");
            let mut vertices = (0..).take(joined.vertex_count());
            assert!(
                vertices.all(|v| joined.valence(v) == 4),
                "{}",
                topology.name
            );
        }
    }
}

/// **Faces that are neither flat nor convex.** The rules look at the corners of a face, not at a shape. In an L the centroid of the corners may lie outside of it, and that is where the face point goes. Heights are refined as if the face were flat, and the plan as if they were not there.
#[test]
fn crooked_faces_are_subdivided_like_flat_ones() {
    let plan = [[0, 0], [5, 0], [5, 1], [1, 1], [1, 5], [0, 5]];
    let heights = [0, 7, -3, 2, 9, 4];
    let crooked: Vec<Point> = plan
        .iter()
        .zip(heights)
        .map(|(&[x, y], z)| over([x, y, z], 1))
        .collect();
    let level: Vec<Point> = plan.iter().map(|&[x, y]| over([x, y, 0], 1)).collect();
    for scheme in OF_POLYGONS {
        let [crooked, level] =
            [&crooked, &level].map(|points| first(scheme, &polygon(6).with_points(points.clone())));
        let plans = crooked.positions.iter().map(|p| [p[0], p[1]]);
        assert!(plans.eq(level.positions.iter().map(|p| [p[0], p[1]])));
    }
    let refined = first(Scheme::CatmullClark, &polygon(6).with_points(crooked));
    assert_eq!(
        refined.positions[12],
        [fraction(2, 1), fraction(2, 1), fraction(19, 6)]
    );
}

/// **Trisection without the step before.** The step of √3 that divides boundary edges expects triangles with at most one of them. It takes others as well, a single triangle for one: their outer pieces stay where the flipped ones would be.
#[test]
fn sqrt3_trisects_any_triangles() {
    let law = Law::new(
        "subdivision::sqrt3_trisects_any_triangles",
        suspects::library,
    );
    let alpha = |n| facette::subdivision::mask::sqrt3_neighbours_weight(rational_cosine(1, n));
    let check = |(topology, corners): &(Topology, Corners)| {
        let (mesh, joined) = (flat(topology), topology.connectivity());
        let boundary = Sqrt3Boundary::Trisected;
        let refined = sqrt3_with(&joined, &mesh.positions, boundary, *corners, alpha);
        let finer = Connectivity::new(&refined.expect("a manifold")).expect("a manifold");
        expect_equal(
            &joined.euler_characteristic(),
            &finer.euler_characteristic(),
        )?;
        let borders = |joined: &Connectivity| 2 * joined.edge_count() - joined.half_edge_count();
        expect_equal(&(3 * borders(&joined)), &borders(&finer))
    };
    let ordinary = (triangle_topologies(), corner_rules());
    law.holds(
        ordinary,
        (hard_triangle_topologies(), corner_rules()),
        check,
    );
}

/// **Weights that do not quite sum to one.** Written as a sum of weighted points, Loop's vertex rule drifts when the mesh is far away: with $\alpha$ and seven times $\frac{1-\alpha}7$, all rounded, a fan at $2^{27}$ whose points coincide no longer coincides with itself. Written as $V+(1-\alpha)(Q-V)$, it does, whatever the weight.
#[test]
fn weights_that_do_not_sum_to_one_let_the_mesh_drift() {
    let far = f64::from(1 << 27);
    let alpha = loop_vertex_weight(facette::subdivision::mask::turn_cosine::<f64>(1, 7));
    let weight = (1.0 - alpha) / 7.0;
    let place = far + 1.0 / 3.0;
    let sum = (0..7).fold(place * alpha, |sum, _| sum + place * weight);
    assert_ne!(sum, place);
    let joined = fan(7).connectivity();
    let refined = loop_subdivision_with(&joined, &[place; 8], Corners::Sharp, |_| alpha);
    assert_eq!(refined.expect("a fan").positions, [place; 8 + 14]);
}
