//! The theorems of how the triangles hang together. The book shows their doc comments.

use facette::bspline::{BsplineSurface, KnotVector, sphere};
use facette::mesh::Mesh;
use facette::surface::Surface;
use facette::tessellation::{BoundedSurface, Tessellation};

use crate::inputs::{
    Point, cut, edges, euler_number, expect, hard_sheets, law, moebius_band, sheets, torus, tube,
};

/// **Watertight.** The triangles of an open surface form a disk: every inner edge belongs to two triangles that run along it in opposite directions, every other edge lies on the
/// boundary of the domain, and Euler's number is 1. There is no vertex in the middle of an edge, wherever pieces with different numbers of cells meet.
#[test]
fn open_surface_becomes_a_disk_without_cracks() {
    let theorem = law("tessellation::open_surface_becomes_a_disk_without_cracks");
    theorem.holds(sheets(), hard_sheets(), |sheet| {
        let surface = sheet.surface();
        let tessellation = cut(&surface, sheet.tolerance);
        let welded = tessellation.welded();
        let parameters = parameters_of_places(&tessellation);
        let domain = surface.domain();
        for (edge, uses) in edges(&welded) {
            let ends = edge.map(|place| parameters[place as usize]);
            let is_on_boundary = (0..2).any(|axis| {
                domain[axis]
                    .iter()
                    .any(|&side| ends.iter().all(|end| end[axis] == side))
            });
            let is_right = if is_on_boundary {
                uses == [1, 0] || uses == [0, 1]
            } else {
                uses == [1, 1]
            };
            expect(
                "each edge used as often as it should be",
                is_right,
                (ends, uses),
            )?;
        }
        expect(
            "Euler's number 1",
            euler_number(&welded) == 1,
            euler_number(&welded),
        )
    });
}

/// The parameters of a vertex of each place.
fn parameters_of_places(tessellation: &Tessellation<Point>) -> Vec<[f64; 2]> {
    let count = tessellation.welded().positions.len();
    let mut parameters = vec![[0.0; 2]; count];
    for (&place, &pair) in tessellation
        .places()
        .iter()
        .zip(&tessellation.mesh.parameters)
    {
        parameters[place as usize] = pair;
    }
    parameters
}

/// How many edges are used once, twice in opposite directions, and twice in the same direction; any other use fails.
fn uses(mesh: &Mesh<Point>) -> [usize; 3] {
    let mut counts = [0; 3];
    for uses in edges(mesh).into_values() {
        match uses {
            [1, 0] | [0, 1] => counts[0] += 1,
            [1, 1] => counts[1] += 1,
            [2, 0] | [0, 2] => counts[2] += 1,
            other => unreachable!("an edge is used {other:?} times"),
        }
    }
    counts
}

/// **Closed surfaces close.** The seam of a tube or a torus is an edge like any other: with one vertex for each place, the torus and the sphere have no boundary, the tube two, and all triangles
/// run the same way round. Euler's number is 0 for the tube and the torus, and 2 for the sphere, whose poles are one vertex each.
///
/// Course: B18, slide 26, B-spline surfaces: surfaces that close in one direction or in both.
#[test]
fn tube_torus_and_sphere_have_their_euler_numbers() {
    for tolerance in [0.1, 0.01] {
        let tube = cut(&tube(), tolerance).welded();
        let [boundary, inner, turned] = uses(&tube);
        assert!(boundary > 0 && inner > 0 && turned == 0);
        assert_eq!(euler_number(&tube), 0);
        for (closed, number) in [
            (cut(&torus(), tolerance), 0),
            (cut(&sphere(), tolerance), 2),
        ] {
            let welded = closed.welded();
            let [boundary, _, turned] = uses(&welded);
            assert_eq!([boundary, turned], [0, 0]);
            assert_eq!(euler_number(&welded), number);
        }
    }
}

/// **One side only.** The seam of a Möbius band joins each point with the one at the other end of the side. Euler's number is 0, there is one boundary, twice as long as the band; and
/// the triangles on both sides of the seam, and nowhere else, run along their common edge in the same direction: no orientation fits all.
///
/// Course: B19, slide 28, B-spline surfaces: a Möbius band.
#[test]
fn moebius_band_closes_with_a_flip() {
    let tessellation = cut(&moebius_band(), 0.01);
    let welded = tessellation.welded();
    let [boundary, _, turned] = uses(&welded);
    assert_eq!(euler_number(&welded), 0);
    let on_seam = tessellation
        .mesh
        .parameters
        .iter()
        .filter(|pair| pair[0] == 0.0)
        .count();
    assert_eq!(turned, on_seam - 1, "the edges of the seam");
    assert_eq!(boundary_loops(&welded), [boundary]);
}

/// The numbers of edges of the boundary's loops.
fn boundary_loops(mesh: &Mesh<Point>) -> Vec<usize> {
    let edges = edges(mesh);
    let mut left: Vec<[u32; 2]> = edges
        .iter()
        .filter(|(_, uses)| uses.iter().sum::<usize>() == 1)
        .map(|(&edge, _)| edge)
        .collect();
    let mut loops = Vec::new();
    while let Some([start, mut at]) = left.pop() {
        let mut count = 1;
        while at != start {
            let next = left
                .iter()
                .position(|edge| edge.contains(&at))
                .expect("a boundary has no end");
            let [a, b] = left.swap_remove(next);
            at = if a == at { b } else { a };
            count += 1;
        }
        loops.push(count);
    }
    loops
}

/// **Seams in the same bits.** The vertices of a place have one position, to the bit, also where the two sides of a seam are computed to different ones.
#[test]
fn vertices_of_a_place_have_the_same_bits() {
    fn check(surface: &impl BoundedSurface<Scalar = f64, Point = Point>) {
        let tessellation = cut(surface, 0.01);
        let welded = tessellation.welded();
        let mesh = &tessellation.mesh;
        assert!(
            mesh.positions.len() > welded.positions.len(),
            "the seam has two sides"
        );
        for (&place, &position) in tessellation.places().iter().zip(&mesh.positions) {
            assert_eq!(welded.positions[place as usize], position);
        }
    }
    check(&tube());
    check(&torus());
    check(&moebius_band());
    check(&sphere());
}

/// **Creases keep their normals.** At a knot as often as the degree the surface may have a crease. A place on it has a vertex for each side, with that side's normal; what light does there is not blurred.
///
/// Course: B08, slide 17, B-spline surfaces: a knot of multiplicity k takes away k degrees of smoothness.
#[test]
fn place_on_a_crease_has_a_normal_for_each_side() {
    let knots = [
        KnotVector::clamped(2, &[0., 0.5, 0.5, 1.]),
        KnotVector::clamped(1, &[0., 1.]),
    ];
    let profile = [[0., 0.], [0.5, 1.], [1., 2.], [1.5, 1.], [2., 0.]];
    let points = [0., 1.]
        .into_iter()
        .flat_map(|y| profile.map(|[x, z]| [x, y, z]));
    let roof = BsplineSurface::new(
        knots.map(|knots| knots.expect("a double knot")),
        points.collect(),
    );
    let tessellation = cut(&roof.expect("ten points"), 0.01);
    let mesh = &tessellation.mesh;
    assert_eq!((mesh.face_count(), mesh.positions.len()), (4, 8));
    assert_eq!(tessellation.welded().positions.len(), 6);
    let unit = [2.0, 1.0].map(|x| x / 5.0_f64.sqrt());
    for ((position, normal), parameters) in mesh
        .positions
        .iter()
        .zip(&mesh.normals)
        .zip(&mesh.parameters)
    {
        let on_ridge = parameters[0] == 0.5;
        let is_left = (normal[0] + unit[0]).abs() < 4.0 * f64::EPSILON;
        let is_right = (normal[0] - unit[0]).abs() < 4.0 * f64::EPSILON;
        assert!(is_left || is_right, "{normal:?}");
        assert!(on_ridge || is_left == (position[0] < 1.0));
    }
    let ridge = mesh
        .normals
        .iter()
        .zip(&mesh.parameters)
        .filter(|(_, pair)| pair[0] == 0.5);
    let sum = ridge.fold(0.0, |sum, (normal, _)| sum + normal[0]);
    assert!(
        sum.abs() < 16.0 * f64::EPSILON,
        "two to the left, two to the right"
    );
}
