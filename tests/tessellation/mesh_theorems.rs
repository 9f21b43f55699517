//! The theorems of tessellated surfaces: the tolerance, the sides, the normals. The book shows their doc comments.

use facette::algebra::{Vector3, VectorSpace, length, unit_vector};
use facette::bspline::{BsplineSurface, KnotVector, RationalCurve, TrimmedSurface, sphere};
use facette::mesh::tessellate_uniformly;
use facette::surface::Surface;
use facette::tessellation::{Bounded, tessellate, tessellate_trimmed};
use proptest::prelude::*;

use crate::common::law::expect_at_most;
use crate::inputs::{
    Graph, Point, Sheet, bicubic, chord_error, cut, expect, hard_sheets, law, rounding, sheets,
    single, wave,
};

/// **The tolerance is kept.** Every point of every triangle is within the tolerance of the surface's point at the same parameters, up to the rounding of the corners.
#[test]
fn triangles_stay_within_the_tolerance() {
    let theorem = law("tessellation::triangles_stay_within_the_tolerance");
    theorem.holds(sheets(), hard_sheets(), |sheet| {
        let surface = sheet.surface();
        let mesh = cut(&surface, sheet.tolerance).mesh;
        let most = sheet.tolerance + rounding(&mesh);
        expect_at_most("chord error", most, chord_error(&surface, &mesh))
    });
}

/// **The bound is no giveaway.** On a wavy bicubic patch, and on the graph of $\tfrac12(u^2+v^2)$, the largest error measured is at least a third of the tolerance, and at least a
/// half where all second derivatives are constant.
#[test]
fn largest_chord_error_is_a_good_part_of_the_tolerance() {
    let domain = [[-1.0, 1.0], [-1.0, 1.0]];
    let point = |u: f64, v: f64| [u, v, f64::midpoint(u * u, v * v)];
    let bowl = Bounded::new(Graph { domain, point }, |_| [1.0, 0.0, 1.0]);
    for tolerance in [0.1, 0.03, 0.01, 0.003] {
        let part = chord_error(&wave(), &cut(&wave(), tolerance).mesh) / tolerance;
        assert!((1.0 / 3.0..=1.0).contains(&part), "{part} of {tolerance}");
        let part = chord_error(&bowl, &cut(&bowl, tolerance).mesh) / tolerance;
        assert!((0.5..=1.0).contains(&part), "{part} of {tolerance}");
    }
}

/// **First order.** The error of a triangle falls with its area: half the tolerance takes about twice as many triangles, a sixteenth about sixteen
/// times as many.
#[test]
fn halving_the_tolerance_doubles_the_triangles() {
    for surface in [
        wave(),
        bicubic([
            0., 0., 0., 0., 0., 9., 0., 0., 0., 0., 0., 0., 0., 0., 0., 0.,
        ]),
    ] {
        let mut before = cut(&surface, 0.05).mesh.face_count();
        for tolerance in [0.05 / 16.0, 0.05 / 256.0] {
            let now = cut(&surface, tolerance).mesh.face_count();
            let growth = now as f64 / before as f64;
            assert!(
                (12.0..20.0).contains(&growth),
                "{before} to {now} at {tolerance}"
            );
            before = now;
        }
    }
}

/// **Fewer triangles than a uniform grid.** A bicubic plane of $12\cdot12$ spans, 12 long and wide, with the middle one of its $15\cdot15$ control points raised by 4: the uniform grid that is
/// measured to keep the tolerance $\tau=0.01$ has more than four times as many triangles as the adaptive mesh that promises it.
#[test]
fn bumpy_plane_takes_fewer_triangles_than_a_uniform_grid() {
    let surface = bump();
    let tolerance = 0.01;
    let adaptive = cut(&surface, tolerance).mesh;
    let mut cells = 36;
    let uniform = loop {
        let mesh = tessellate_uniformly(&surface, cells, cells).expect("a usable grid");
        if chord_error(&surface, &mesh) <= tolerance {
            break mesh;
        }
        cells += 12;
    };
    let times = uniform.face_count() as f64 / adaptive.face_count() as f64;
    assert!(
        times > 4.0,
        "{} and {}",
        uniform.face_count(),
        adaptive.face_count()
    );
}

/// A bicubic plane of 12 × 12 spans with one control point raised.
fn bump() -> BsplineSurface<Point> {
    let breaks: Vec<f64> = (0..=12).map(f64::from).collect();
    let knots = [&breaks, &breaks].map(|breaks| KnotVector::clamped(3, breaks).expect("integers"));
    let points = (0..225).map(|k| {
        [
            f64::from(k % 15),
            f64::from(k / 15),
            if k == 112 { 4.0 } else { 0.0 },
        ]
    });
    BsplineSurface::new(knots, points.collect()).expect("finite points")
}

/// **Flat is cheap.** Where nothing bends, each piece has two triangles, however small the tolerance. Control points that move along the plane make no difference to the error, but to the
/// parameters: they count as bending.
#[test]
fn flat_pieces_have_two_triangles() {
    let breaks = [0.0, 1.0, 3.0, 4.0];
    for degree in 1..=4 {
        let knots = KnotVector::clamped(degree, &breaks).expect("increasing breaks");
        let at = knots.greville_abscissae();
        let points = at
            .iter()
            .flat_map(|&v| at.iter().map(move |&u| [u, v, 2.0 * u - v]));
        let surface =
            BsplineSurface::new([knots.clone(), knots.clone()], points.collect()).expect("a net");
        let welded = cut(&surface, 1e-9).welded();
        assert_eq!(
            (welded.positions.len(), welded.face_count()),
            (16, 18),
            "degree {degree}"
        );
    }
}

/// **Neighbours agree.** Two surfaces that share the control points of a side, with the same knots along it, have the same points on it, bit for bit; it makes no difference whether the side runs
/// along u or along v, nor what the surfaces do elsewhere.
#[test]
fn neighbours_share_the_points_of_their_common_side() {
    let theorem = law("tessellation::neighbours_share_the_points_of_their_common_side");
    let pairs = |one| (one, sheets(), any::<bool>());
    theorem.holds(
        pairs(sheets().boxed()),
        pairs(hard_sheets().boxed()),
        |(sheet, other, is_turned)| {
            let first = sheet.surface();
            let second = neighbour(sheet, other, &first);
            let second = if *is_turned {
                second.transposed()
            } else {
                second
            };
            let [mesh, next] = [
                cut(&first, sheet.tolerance).mesh,
                cut(&second, sheet.tolerance).mesh,
            ];
            let start = first.domain()[1][0];
            let across = second.domain()[usize::from(!is_turned)][1];
            let mut side = side_of(&mesh.positions, &mesh.parameters, 1, start);
            let mut same = side_of(
                &next.positions,
                &next.parameters,
                usize::from(!is_turned),
                across,
            );
            let order =
                |a: &Point, b: &Point| a.partial_cmp(b).unwrap_or(std::cmp::Ordering::Equal);
            for points in [&mut side, &mut same] {
                points.sort_by(order);
                points.dedup();
            }
            expect(
                "the same points on the common side",
                side == same,
                (side, same),
            )
        },
    );
}

/// A surface of other degrees and knots in v, whose last row of control points is the first of `first`.
fn neighbour(sheet: &Sheet, other: &Sheet, first: &BsplineSurface<Point>) -> BsplineSurface<Point> {
    let mixed = Sheet {
        degrees: [sheet.degrees[0], other.degrees[1]],
        breaks: [sheet.breaks[0].clone(), other.breaks[1].clone()],
        ..other.clone()
    };
    let mixed = mixed.surface();
    let columns = mixed
        .knots(facette::bspline::Direction::U)
        .control_point_count();
    let rows = mixed.control_points().len() / columns;
    (0..columns).fold(mixed, |surface, i| {
        let moved = surface.with_control_point(i, rows - 1, first.control_point(i, 0));
        moved.expect("a finite point")
    })
}

/// The positions of the vertices at which one parameter has this value.
fn side_of(positions: &[Point], parameters: &[[f64; 2]], axis: usize, value: f64) -> Vec<Point> {
    let both = positions.iter().zip(parameters);
    let on_side = both.filter(|(_, parameters)| parameters[axis] == value);
    on_side.map(|(&position, _)| position).collect()
}

/// **Normals.** On the graph of a function $f$ the normal at each vertex is the unit vector along $(-f_u,-f_v,1)$, within $16\mathbf u$; it points to the side from which the triangles around
/// run anticlockwise. The bicubic patch here is the graph of $f(u,v)=u^2v-v^3/9$.
#[test]
fn normals_are_unit_vectors_on_the_side_of_the_triangles() {
    let surface = cubic_graph();
    let mesh = cut(&surface, 0.001).mesh;
    for ([u, v], normal) in mesh.parameters.iter().zip(&mesh.normals) {
        let exact = unit_vector([-2.0 * u * v, v * v / 3.0 - u * u, 1.0]).expect("a finite vector");
        let error = normal.minus(exact).largest_coordinate();
        assert!(error <= 16.0 * f64::EPSILON, "{normal:?} for {exact:?}");
        assert!((length(*normal) - 1.0).abs() <= 5.0 * f64::EPSILON);
    }
    for corners in mesh.triangles() {
        let [a, b, c] = corners.map(|vertex| mesh.positions[vertex as usize]);
        let facing = b.minus(a).cross(c.minus(a));
        for vertex in corners {
            assert!(facing.dot(mesh.normals[vertex as usize]) > 0.0);
        }
    }
}

/// The graph of u²v − v³/9 over [0, 1]², as a bicubic patch: its control points are blossoms.
fn cubic_graph() -> BsplineSurface<Point> {
    let knots = [KnotVector::bezier(3), KnotVector::bezier(3)];
    let points = (0..16).map(|k| {
        let [i, j] = [f64::from(k % 4), f64::from(k / 4)];
        // The blossoms of u² and of v³ at i and j ones: i(i − 1)/6, and 1 for j = 3 only.
        let height = i * (i - 1.0) / 6.0 * j / 3.0 - if j == 3.0 { 1.0 / 9.0 } else { 0.0 };
        [i / 3.0, j / 3.0, height]
    });
    BsplineSurface::new(knots, points.collect()).expect("finite points")
}

/// **Rational surfaces.** The quotient rule bounds the second derivatives of a rational surface: the triangles of the unit sphere stay within the tolerance of it, in their corners and between them.
/// $|x|=1$ says so without any formula of the surface.
#[test]
fn triangles_of_the_sphere_stay_within_the_tolerance_of_it() {
    let surface = sphere::<Point>();
    for tolerance in [0.1, 0.01] {
        let mesh = cut(&surface, tolerance).mesh;
        let mut largest = 0.0_f64;
        for corners in mesh.triangles() {
            let corners = corners.map(|vertex| mesh.positions[vertex as usize]);
            for weights in [
                [1.0, 0.0, 0.0],
                [0.5, 0.5, 0.0],
                [0.0, 0.5, 0.5],
                [0.5, 0.0, 0.5],
                [1.0 / 3.0; 3],
            ] {
                let error = (length(Point::combination(weights, corners)) - 1.0).abs();
                largest = largest.max(error);
            }
        }
        assert!(largest <= tolerance + rounding(&mesh), "{largest}");
        assert!(largest >= tolerance / 20.0, "only {largest} of {tolerance}");
    }
}

/// **Trimmed surfaces.** The triangles of a trimmed surface keep the tolerance; in the parameter plane they cover its polygon, once: their areas are positive and sum to the polygon's, and
/// the polygon's corners are among their corners.
#[test]
fn triangles_of_a_trimmed_surface_cover_its_polygon() {
    let theorem = law("tessellation::triangles_of_a_trimmed_surface_cover_its_polygon");
    let radii = || proptest::collection::vec(0.1..0.48_f64, 5..14);
    theorem.on_cases(32).holds(
        (sheets(), radii()),
        (hard_sheets(), radii()),
        |(sheet, radii)| {
            let surface = sheet.surface();
            let [[u0, u1], [v0, v1]] = surface.domain();
            let corner = |index: usize| {
                let angle = index as f64 / radii.len() as f64 * std::f64::consts::TAU;
                let radius = radii[index % radii.len()];
                let [x, y] = [0.5 + radius * angle.cos(), 0.5 + radius * angle.sin()];
                [u0 + (u1 - u0) * x, v0 + (v1 - v0) * y]
            };
            let mut corners: Vec<_> = (0..radii.len()).map(corner).collect();
            corners.push(corners[0]);
            let knots = KnotVector::clamped_uniform(1, corners.len()).expect("enough points");
            let outline =
                RationalCurve::new(knots, &corners, &vec![1.0; corners.len()]).expect("a polygon");
            let trimmed =
                TrimmedSurface::new(surface.clone(), outline, 1e-9).expect("a star is simple");
            let mesh = tessellate_trimmed(&trimmed, sheet.tolerance)
                .expect("a usable tolerance")
                .mesh;
            expect_at_most(
                "chord error",
                sheet.tolerance + rounding(&mesh),
                chord_error(&surface, &mesh),
            )?;
            let area = |[a, b, c]: [[f64; 2]; 3]| {
                ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2.0
            };
            let centre = [u0 + (u1 - u0) * 0.5, v0 + (v1 - v0) * 0.5];
            let polygon = trimmed.polygon();
            let around = polygon.iter().zip(polygon.iter().cycle().skip(1));
            let whole: f64 = around.map(|(&a, &b)| area([centre, a, b])).sum();
            let parts: Vec<f64> = mesh
                .triangles()
                .map(|corners| area(corners.map(|vertex| mesh.parameters[vertex as usize])))
                .collect();
            expect(
                "positive areas",
                parts.iter().all(|&part| part > 0.0),
                &parts,
            )?;
            let sum: f64 = parts.iter().sum();
            let difference = ((sum - whole) / whole).abs();
            expect_at_most("relative difference of the areas", 1e-12, difference)?;
            let all = polygon
                .iter()
                .all(|corner| mesh.parameters.contains(corner));
            expect("the polygon's corners", all, polygon)
        },
    );
}

/// **The same in single precision.** What holds in `f64` holds in `f32`, with its rounding: the largest distance, measured in double precision, is within the tolerance and 64 roundoffs of single
/// precision.
#[test]
fn tolerance_is_kept_in_single_precision() {
    let theorem = law("tessellation::tolerance_is_kept_in_single_precision");
    theorem
        .on_cases(32)
        .holds(sheets(), hard_sheets(), |sheet| {
            let double = sheet.surface();
            let knots = [
                facette::bspline::Direction::U,
                facette::bspline::Direction::V,
            ]
            .map(|direction| {
                let knots = double.knots(direction);
                let rounded = knots.knots().iter().map(|&knot| single(knot));
                KnotVector::new(knots.degree(), rounded.collect())
                    .expect("rounding keeps these knots in order")
            });
            let points = double
                .control_points()
                .iter()
                .map(|point| point.map(single));
            let surface = BsplineSurface::new(knots, points.collect()).expect("finite points");
            let tolerance = single(sheet.tolerance);
            let mesh = tessellate(&surface, tolerance)
                .expect("a usable tolerance")
                .mesh;
            let exact = surface
                .control_points()
                .iter()
                .map(|point| point.map(f64::from));
            let knots = [
                facette::bspline::Direction::U,
                facette::bspline::Direction::V,
            ]
            .map(|direction| {
                let knots = surface.knots(direction);
                let exact = knots.knots().iter().map(|&knot| f64::from(knot));
                KnotVector::new(knots.degree(), exact.collect()).expect("the same knots")
            });
            let exact = BsplineSurface::new(knots, exact.collect()).expect("finite points");
            let mut widened = facette::mesh::Mesh::new(
                mesh.positions
                    .iter()
                    .map(|point| point.map(f64::from))
                    .collect(),
                mesh.faces(),
            )
            .expect("the same mesh");
            widened.parameters = mesh
                .parameters
                .iter()
                .map(|pair| pair.map(f64::from))
                .collect();
            let roundoff = f64::from(f32::EPSILON) / f64::EPSILON;
            let most = f64::from(tolerance) + rounding(&widened) * roundoff;
            expect_at_most("chord error", most, chord_error(&exact, &widened))
        });
}
