//! Surfaces that break a tessellation: torn, twisted, collapsed, far away, very small and very large. The book shows their doc comments.

use facette::algebra::VectorSpace;
use facette::bspline::{BsplineSurface, KnotVector, RationalCurve, TrimmedSurface};
use facette::tessellation::{Bounded, tessellate, tessellate_trimmed};

use crate::inputs::{
    Graph, Point, bicubic, chord_error, cut, edges, euler_number, rounding, single, wave,
};

/// **Straight sides around a twist.** The sides of $S=(u,v,uv)$ are straight and have one segment each, but the surface between them is not flat. The triangles next to a side are cut until they are thin enough, and the side
/// stays whole: a neighbour with the same side needs to know nothing.
#[test]
fn straight_sides_stay_whole_around_a_twist() {
    let knots = [KnotVector::bezier(1), KnotVector::bezier(1)];
    let corners = vec![[0., 0., 0.], [1., 0., 0.], [0., 1., 0.], [1., 1., 1.]];
    let surface = BsplineSurface::new(knots, corners).expect("four corners");
    for tolerance in [0.1, 0.01, 0.001] {
        let mesh = cut(&surface, tolerance).mesh;
        assert!(chord_error(&surface, &mesh) <= tolerance + rounding(&mesh));
        let on_boundary = |pair: &&[f64; 2]| {
            pair.iter()
                .any(|&parameter| parameter == 0.0 || parameter == 1.0)
        };
        assert_eq!(mesh.parameters.iter().filter(on_boundary).count(), 4);
        // The bound of a cell is l₁l₂/4: a grid takes 1/(4τ) cells. The thin triangles at the sides may cost four times as much.
        assert!(
            mesh.face_count() as f64 <= 4.0 * 2.0 * 0.25 / tolerance + 16.0,
            "{}",
            mesh.face_count()
        );
        assert_eq!(euler_number(&mesh), 1);
    }
}

/// **A tear.** At a knot that stands $p+1$ times the surface may jump. The two sides are not joined: each has its own points, and the tessellation is two disks.
#[test]
fn torn_surface_falls_into_two_disks() {
    let knots = [
        KnotVector::clamped(1, &[0., 1., 1., 2.]),
        KnotVector::clamped(1, &[0., 1.]),
    ];
    let heights = [0., 0., 5., 5.];
    let points = [0., 1.].into_iter().flat_map(|y| {
        [0., 1., 1., 2.]
            .into_iter()
            .zip(heights)
            .map(move |(x, z)| [x, y, z])
    });
    let surface = BsplineSurface::new(
        knots.map(|knots| knots.expect("multiplicity 2")),
        points.collect(),
    );
    let tessellation = cut(&surface.expect("eight points"), 0.1);
    let welded = tessellation.welded();
    assert_eq!((welded.positions.len(), welded.face_count()), (8, 4));
    assert_eq!(euler_number(&welded), 2);
    for corners in welded.triangles() {
        let heights = corners.map(|vertex| welded.positions[vertex as usize][2]);
        assert!(heights == [0.0; 3] || heights == [5.0; 3], "{heights:?}");
    }
}

/// **A collapsed side.** Where all control points of a side are one point, the side is one vertex: triangles without area are left out, the rest is a disk, and the normal there is a
/// unit vector all the same.
#[test]
fn collapsed_side_is_one_place() {
    let knots = [KnotVector::bezier(2), KnotVector::bezier(2)];
    let points = vec![
        [0., 0., 1.],
        [0., 0., 1.],
        [0., 0., 1.],
        [1., 0., 1.],
        [1., 1., 1.],
        [0., 1., 1.],
        [1., 0., 0.],
        [1., 1., 0.],
        [0., 1., 0.],
    ];
    let surface = BsplineSurface::new(knots, points).expect("nine points");
    let tessellation = cut(&surface, 0.001);
    let welded = tessellation.welded();
    assert_eq!(euler_number(&welded), 1);
    assert_eq!(
        welded
            .positions
            .iter()
            .filter(|&&point| point == [0., 0., 1.])
            .count(),
        1
    );
    for [a, b, c] in welded.triangles() {
        assert!(a != b && b != c && c != a);
    }
    let mesh = &tessellation.mesh;
    let poles = mesh
        .positions
        .iter()
        .zip(&mesh.normals)
        .filter(|(point, _)| point[2] == 1.0 && point[0] == 0.0 && point[1] == 0.0);
    for (_, normal) in poles {
        let length: f64 = normal.iter().map(|x| x * x).sum::<f64>().sqrt();
        assert!((length - 1.0).abs() < 8.0 * f64::EPSILON, "{normal:?}");
    }
}

/// **One point.** A surface whose control points are all the same has no triangles.
#[test]
fn surface_that_is_one_point_has_no_triangles() {
    let knots = [KnotVector::bezier(2), KnotVector::bezier(2)];
    let surface = BsplineSurface::new(knots, vec![[1.0, 2.0, 3.0]; 9]).expect("nine points");
    assert_eq!(cut(&surface, 0.1).mesh.face_count(), 0);
}

/// **Far from the origin.** At $10^8$ the points are rounded to $1.5\cdot10^{-8}$, but their differences, and with them the bounds, are not: the wave moved there has the same triangles as at the origin, within its tolerance up to that rounding.
#[test]
fn far_surface_has_the_same_triangles() {
    let near = wave();
    let far = near
        .mapped(|[x, y, z]| [x + 1e8, y + 1e8, z + 1e8])
        .expect("finite points");
    let [a, b] = [cut(&near, 0.01).mesh, cut(&far, 0.01).mesh];
    assert!(a.faces().eq(b.faces()) && a.parameters == b.parameters);
    assert!(chord_error(&far, &b) <= 0.01 + rounding(&b));
}

/// **Very small, very large.** The surface times $2^k$ with the tolerance times $2^k$ has the same triangles, and points that are $2^k$ times as large to the bit, from $10^{-30}$ to $10^{30}$ and beyond; and so has the domain stretched by $2^k$.
#[test]
fn triangles_do_not_depend_on_the_unit() {
    let surface = wave();
    let unit = cut(&surface, 0.01).mesh;
    for exponent in [-300, -100, 100, 300] {
        let factor = 2.0_f64.powi(exponent);
        let scaled = surface
            .mapped(|point: Point| point.times(factor))
            .expect("finite points");
        let mesh = cut(&scaled, 0.01 * factor).mesh;
        assert!(mesh.faces().eq(unit.faces()));
        assert!(
            mesh.positions
                .iter()
                .zip(&unit.positions)
                .all(|(a, b)| *a == b.times(factor))
        );
        let stretched = surface
            .reparametrised([[0.0, factor], [0.0, 1.0]])
            .expect("an interval");
        let mesh = cut(&stretched, 0.01).mesh;
        assert!(mesh.faces().eq(unit.faces()), "at 2^{exponent}");
    }
}

/// **Single precision at the ends of its range.** The wave times $10^{-30}$ and times $10^{30}$, in `f32`: squares of these lengths are zero or infinite there, but no square is taken.
#[test]
fn lengths_neither_overflow_nor_underflow_in_single_precision() {
    for factor in [1e-30_f32, 1.0, 1e30] {
        let wave = wave();
        let points = wave
            .control_points()
            .iter()
            .map(|point| point.map(|x| single(x) * factor));
        let knots = [KnotVector::bezier(3), KnotVector::bezier(3)];
        let surface = BsplineSurface::new(knots, points.collect()).expect("16 finite points");
        let mesh = tessellate(&surface, 0.01 * factor)
            .expect("a usable tolerance")
            .mesh;
        assert!(
            mesh.face_count() > 100
                && mesh
                    .normals
                    .iter()
                    .all(|normal| normal.has_finite_coordinates())
        );
    }
}

/// **Pieces with different needs.** A spike beside a plane: pieces with hundreds of cells next to pieces with one. No edge has a vertex in its middle.
#[test]
fn coarse_and_fine_pieces_meet_without_cracks() {
    let breaks = [0.0, 1.0, 2.0, 3.0, 4.0, 5.0];
    let knots = [&breaks, &breaks].map(|breaks| KnotVector::clamped(3, breaks).expect("integers"));
    let points = (0..64).map(|k| {
        [
            f64::from(k % 8),
            f64::from(k / 8),
            if k == 18 { 30.0 } else { 0.0 },
        ]
    });
    let surface = BsplineSurface::new(knots, points.collect()).expect("64 points");
    let mesh = cut(&surface, 0.01).mesh;
    assert!(chord_error(&surface, &mesh) <= 0.01 + rounding(&mesh));
    assert_eq!(euler_number(&mesh), 1);
    for (edge, uses) in edges(&mesh) {
        let ends = edge.map(|vertex| mesh.parameters[vertex as usize]);
        let on_side = (0..2).any(|axis| {
            [0.0, 5.0]
                .iter()
                .any(|&side| ends.iter().all(|end| end[axis] == side))
        });
        assert_eq!(
            uses.iter().sum::<usize>(),
            if on_side { 1 } else { 2 },
            "{ends:?}"
        );
    }
}

/// **A long thin domain.** $10^6$ by $10^{-6}$, with bounds given by hand: the cells follow the bounds, not the shape of the domain.
#[test]
fn long_thin_domain_gets_cells_of_the_right_shape() {
    let domain = [[0.0, 1e6], [0.0, 1e-6]];
    let point = |u: f64, v: f64| [u * 1e-6, v * 1e6, (u * 1e-6) * (v * 1e6)];
    let surface = Bounded::new(Graph { domain, point }, |_| [0.0, 1.0, 0.0]);
    let mesh = cut(&surface, 1e-3).mesh;
    assert!(chord_error(&surface, &mesh) <= 1e-3 + rounding(&mesh));
    assert!(mesh.face_count() < 4000, "{}", mesh.face_count());
}

/// **High degree.** A Bézier patch of degree $8\times8$ with alternating heights keeps its tolerance.
#[test]
fn patch_of_degree_eight_keeps_the_tolerance() {
    let knots = [KnotVector::bezier(8), KnotVector::bezier(8)];
    let points = (0..81).map(|k| {
        [
            f64::from(k % 9),
            f64::from(k / 9),
            if k % 2 == 0 { 1.0 } else { -1.0 },
        ]
    });
    let surface = BsplineSurface::new(knots, points.collect()).expect("81 points");
    let mesh = cut(&surface, 0.02).mesh;
    assert!(chord_error(&surface, &mesh) <= 0.02 + rounding(&mesh));
}

/// **A fold.** Control points that turn back make a surface whose partial derivatives vanish somewhere; triangles and tolerance do not mind.
#[test]
fn folded_surface_keeps_the_tolerance() {
    let surface = bicubic([0.; 16])
        .mapped(|[x, y, _]| [x * (3.0 - x), y, 0.0])
        .expect("finite points");
    let mesh = cut(&surface, 0.01).mesh;
    assert!(chord_error(&surface, &mesh) <= 0.01 + rounding(&mesh));
    assert!(
        mesh.normals
            .iter()
            .all(|normal| normal.has_finite_coordinates())
    );
}

/// **A loop of many sides.** A circle of 1500 sides has an ear at every corner. Each cut changes two of them: to look at all of them again takes hundreds of times as long, and looks like a loop without end.
#[test]
fn loop_of_many_sides_is_cut_in_a_moment() {
    const SIDES: usize = 1500;
    let square = [[0., 0., 0.], [1., 0., 0.], [0., 1., 0.], [1., 1., 0.]];
    let knots = [KnotVector::bezier(1), KnotVector::bezier(1)];
    let flat = BsplineSurface::new(knots, square.to_vec()).expect("four points");
    let corner = |index: usize| {
        let angle = (index % SIDES) as f64 / SIDES as f64 * std::f64::consts::TAU;
        [0.5 + 0.4 * angle.cos(), 0.5 + 0.4 * angle.sin()]
    };
    let corners: Vec<_> = (0..=SIDES).map(corner).collect();
    let knots = KnotVector::clamped_uniform(1, corners.len()).expect("enough points");
    let outline = RationalCurve::new(knots, &corners, &[1.0; SIDES + 1]).expect("a polygon");
    let trimmed = TrimmedSurface::new(flat, outline, 1e-9).expect("a circle is simple");
    let mesh = tessellate_trimmed(&trimmed, 0.1)
        .expect("a polygon that can be cut")
        .mesh;
    assert_eq!(mesh.face_count(), SIDES - 2);
}
