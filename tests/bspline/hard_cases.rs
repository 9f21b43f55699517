//! Curves and surfaces that break the textbook formulas, what survives them, and both shown.

use facette::algebra::{Vector3, VectorSpace, unit_vector};
use facette::bspline::{
    BsplineCurve, BsplineError, BsplineSurface, Direction, KnotVector, de_boor_point,
};
use facette::curve::Curve;
use facette::surface::Surface;
use glam::{DVec3, Vec3};

use crate::common::oracle::{big, big_bspline_basis, big_combination, big_point, largest_error};

const UNIT_ROUNDOFF: f64 = f64::EPSILON / 2.0;

fn clamped(degree: usize, breaks: &[f64]) -> KnotVector<f64> {
    KnotVector::clamped(degree, breaks).expect("the hard cases' knots are valid")
}

fn curve(degree: usize, breaks: &[f64], points: &[[f64; 3]]) -> BsplineCurve<[f64; 3]> {
    BsplineCurve::new(clamped(degree, breaks), points.to_vec())
        .expect("one point for each function")
}

/// A hilly surface of degree 3 by 2 with 6 by 5 control points, at an offset.
fn hills(offset: f64) -> BsplineSurface<[f64; 3]> {
    let knots = [
        clamped(3, &[0.0, 0.2, 0.5, 1.0]),
        clamped(2, &[0.0, 0.3, 0.6, 1.0]),
    ];
    let point = |k: i32| {
        let (i, j) = (k % 6, k / 6);
        [
            offset + f64::from(i),
            f64::from(j),
            f64::from((i * i * 3 + j * 5 + i * j) % 7) / 3.0,
        ]
    };
    BsplineSurface::new(knots, (0..30).map(point).collect()).expect("six by five points")
}

/// **Not a number.** NaN in gives NaN out, in every coordinate, for points, derivatives and grids; nothing hangs, nothing panics, and no normal is claimed. The same for infinite parameters, except that a coordinate may be infinite.
#[test]
fn surface_gives_not_a_number_for_not_a_number() {
    let surface = hills(0.0);
    for [u, v] in [[f64::NAN, 0.5], [0.5, f64::NAN], [f64::NAN; 2]] {
        assert!(surface.point(u, v).iter().all(|x| x.is_nan()), "({u}, {v})");
        assert_eq!(surface.normal_vector(u, v), None, "({u}, {v})");
        let mut row = [[0.0; 3]];
        surface.points_on_grid(&[u], &[v], &mut row);
        assert!(row[0].iter().all(|x| x.is_nan()), "({u}, {v})");
    }
    for u in [f64::INFINITY, f64::NEG_INFINITY] {
        assert!(!surface.point(u, 0.5).iter().any(|x| x.is_finite()));
        assert_eq!(surface.normal_vector(u, 0.5), None);
    }
}

/// **Parameters outside.** The end pieces go on beyond the domain, as the polynomials that they are, without a jump: one number outside, the point is within rounding of the edge. Whoever wants another convention clamps the parameters.
#[test]
fn surface_goes_on_beyond_its_domain() {
    let surface = hills(0.0);
    // (6p + 6q + 2) u times the largest coordinate, twice, and a tiny step along a tangent of length below 20.
    let bound = (2.0 * 32.0 * 5.0 + 20.0) * UNIT_ROUNDOFF;
    for v in [0.0, 0.4, 1.0] {
        for [edge, outside] in [[0.0, -f64::EPSILON / 2.0], [1.0, 1.0_f64.next_up()]] {
            let step = surface.point(outside, v).minus(surface.point(edge, v));
            assert!(
                step.largest_coordinate() <= bound,
                "{step:?} at ({outside}, {v})"
            );
        }
    }
    let patches = surface.bezier_patches();
    let first = &patches[0].control_points[..4];
    let bezier = facette::curve::BezierCurve::new(first.to_vec()).expect("four points");
    let [x, y, _] = surface.point(-1.0, 0.0).minus(bezier.point(-5.0));
    assert!(
        x.abs().max(y.abs()) <= 1e-12 * 5.0_f64.powi(3),
        "the first cubic runs from 0 to 0.2"
    );
}

/// **A control point that does not count.** A control point of $10^{300}$ somewhere else changes no bit of a point that it does not move: the sum takes only the $p+1$ control points of the span. A sum over all of them, most weights zero, would turn infinite control points into NaN; a polynomial through all
/// of them would feel it everywhere.
#[test]
fn huge_control_point_elsewhere_changes_nothing() {
    let breaks = [0.0, 1.0, 2.0, 3.0, 4.0, 5.0];
    let points: Vec<_> = (0..8)
        .map(|i| [f64::from(i), 0.1 * f64::from(i * i), 0.3])
        .collect();
    let plain = curve(3, &breaks, &points);
    let mut spiked = points.clone();
    spiked[7] = [1e300, -1e300, 1e300];
    let spiked = curve(3, &breaks, &spiked);
    for u in [0.0, 0.5, 1.7, 3.0, 3.999, 4.0] {
        assert_eq!(plain.point(u), spiked.point(u), "at {u}");
        assert_eq!(plain.derivative(u), spiked.derivative(u), "at {u}");
    }
    assert!(spiked.point(4.5)[0] > 1e298);
}

/// **Large and small control points side by side.** The error of a point is a few units in the last place of the *largest* of its control points, not of the point: next to one of $10^{16}$, a coordinate of size 1 may be wrong by 1. It is the price of adding them; the bound $(6p+1)\mathbf u\cdot M$ tells it beforehand.
#[test]
fn error_is_that_of_the_largest_control_point_of_the_span() {
    let knots = clamped(3, &[0.0, 1.0]);
    let points = [
        [1.0, 0.0, 0.0],
        [1e16, 0.0, 0.0],
        [-1e16, 1.0, 0.0],
        [1.0, 1.0, 0.0],
    ];
    let exact_points = points.map(big_point);
    let (p, largest) = (3.0, 1e16);
    let mut worst: f64 = 0.0;
    for k in 0..=64 {
        let u = 0.5 + f64::from(k) / 3e6;
        let weights = big_bspline_basis(3, knots.knots(), &big(u), 1.0);
        let exact = big_combination(&weights, &exact_points);
        let point = de_boor_point(&knots, &points, u);
        worst = worst.max(largest_error(
            [point[0]],
            &[exact[0].clone()],
            UNIT_ROUNDOFF,
        ));
        let bound = (6.0 * p + 1.0) * largest * UNIT_ROUNDOFF;
        assert!(largest_error(point, &exact, bound) <= 1.0, "at {u}");
    }
    assert!(worst > 1e14, "the largest error was {worst} unit roundoffs");
}

/// **Far from the origin.** At an offset of $10^8$ a point keeps its absolute error, some units in the last place of $10^8$. Its *tangent* keeps more: differences of control points are taken first, and these are exact here, so the derivative is the same as near the origin, bit for bit. A difference of two points
/// at a small distance would have lost half its digits.
#[test]
fn far_surface_keeps_its_tangents() {
    let [near, far] = [hills(0.0), hills(1e8)];
    for [u, v] in [[0.1, 0.2], [0.5, 0.3], [0.77, 0.9], [1.0, 1.0]] {
        assert_eq!(near.partials(u, v), far.partials(u, v), "at ({u}, {v})");
        assert_eq!(
            near.normal_vector(u, v),
            far.normal_vector(u, v),
            "at ({u}, {v})"
        );
        let shift = far.point(u, v)[0] - near.point(u, v)[0] - 1e8;
        assert!(
            shift.abs() <= 32.0 * UNIT_ROUNDOFF * 1e8,
            "{shift} at ({u}, {v})"
        );
    }
    let h = 1e-6;
    let by_difference = (far.point(0.3 + h, 0.2)[0] - far.point(0.3 - h, 0.2)[0]) / (2.0 * h);
    let [s_u, _] = far.partials(0.3, 0.2).expect("a B-spline has derivatives");
    assert!(
        (by_difference - s_u[0]).abs() > 1e-3,
        "the central difference gives {by_difference}"
    );
}

/// **From $10^{-300}$ to $10^{300}$.** Scaling the control points by a power of two scales points and derivatives to the last bit, and leaves the unit normal as it is.
#[test]
fn surface_scales_with_its_control_points() {
    let surface = hills(0.3);
    for exponent in [-990, -100, 100, 990] {
        let scale = 2.0_f64.powi(exponent);
        let scaled = surface.mapped(|p| p.times(scale)).expect("still finite");
        for [u, v] in [[0.3, 0.8], [0.0, 0.5], [1.0, 0.1]] {
            assert_eq!(scaled.point(u, v), surface.point(u, v).times(scale));
            let normals = [&scaled, &surface].map(|s| s.normal_vector(u, v).and_then(unit_vector));
            assert_eq!(normals[0], normals[1], "at 2^{exponent}");
            assert!(normals[0].is_some());
        }
    }
}

/// **A side collapsed to a point.** Where a row of control points coincides, $S_u=0$ along that side and $S_u\times S_v$ says nothing. Just inside, it does: the normal given on the side is the limit, and the normals on the way tend to it.
#[test]
fn normal_at_a_collapsed_side_of_a_net_is_the_limit() {
    let knots = [clamped(2, &[0.0, 0.5, 1.0]), clamped(2, &[0.0, 0.5, 1.0])];
    let point = |k: i32| {
        let (x, y) = (f64::from(k % 4) / 3.0 - 0.5, f64::from(k / 4));
        [x * y, y, 0.3 * y * y - x * x * y]
    };
    let surface =
        BsplineSurface::new(knots, (0..16).map(point).collect()).expect("four by four points");
    for u in [0.0, 0.3, 0.5, 1.0] {
        let [s_u, _] = surface
            .partials(u, 0.0)
            .expect("a B-spline has derivatives");
        assert_eq!(s_u, [0.0; 3]);
        let normal = |v: f64| surface.normal_vector(u, v).and_then(unit_vector);
        let limit = normal(0.0).expect("the normal has a limit");
        for halvings in 2..=26 {
            let distance = 0.5_f64.powi(halvings);
            let away = normal(distance)
                .expect("inside it is regular")
                .minus(limit)
                .largest_coordinate();
            // The normal turns with the distance; S_u is as small as that, with roundoffs of coordinates near 1.
            let bound = 6.0 * distance + 32.0 * f64::EPSILON / distance;
            assert!(
                away <= bound,
                "{away} away at a distance of {distance} from ({u}, 0)"
            );
        }
    }
}

/// **No area, no normal.** A surface whose control points all coincide, or all lie on a line, has points and no normal; rounding does not make one up.
#[test]
fn surface_without_area_has_no_normal() {
    let knots = || [clamped(2, &[0.0, 0.4, 1.0]), clamped(3, &[0.0, 1.0])];
    let on_a_line =
        |k: i32| DVec3::new(0.1, 0.2, 0.7) * f64::from(k * k % 7) + DVec3::new(0.3, 0.0, 1.0);
    for points in [
        vec![DVec3::new(0.1, 0.2, 0.3); 16],
        (0..16).map(on_a_line).collect(),
    ] {
        let surface = BsplineSurface::new(knots(), points).expect("four by four points");
        for [u, v] in [[0.0, 0.0], [0.3, 0.6], [0.4, 1.0], [1.0, 0.5]] {
            assert_eq!(surface.normal_vector(u, v), None, "at ({u}, {v})");
            assert!(surface.point(u, v).is_finite());
        }
    }
}

/// **A seam that is exact.** Neighbouring Bézier pieces share their end point, and neighbouring Bézier patches their edge, bit for bit, so that no crack opens between pieces that are drawn one by one.
#[test]
fn neighbouring_bezier_pieces_share_their_bits() {
    let points: Vec<_> = (0..9)
        .map(|i| {
            [
                0.1 * f64::from(i),
                1.0 / f64::from(i + 3),
                f64::from(i * i).sqrt(),
            ]
        })
        .collect();
    let pieces = curve(3, &[0.0, 0.1, 0.35, 0.36, 0.9, 0.95, 1.0], &points).bezier_pieces();
    assert_eq!(pieces.len(), 6);
    for pair in pieces.windows(2) {
        assert_eq!(
            pair[0].curve.control_points().last(),
            pair[1].curve.control_points().first()
        );
    }
    let patches = hills(0.1).bezier_patches();
    assert_eq!(patches.len(), 9);
    for row in patches.chunks(3) {
        for pair in row.windows(2) {
            let [left, right] = [0, 1].map(|side| &pair[side].control_points);
            for line in 0..3 {
                assert_eq!(left[4 * line + 3], right[4 * line]);
            }
        }
    }
    for (below, above) in patches.iter().zip(&patches[3..]) {
        assert_eq!(below.control_points[8..], above.control_points[..4]);
    }
}

/// **Removal with a tolerance.** In floating point a knot that was inserted can be taken out again only up to rounding: with a tolerance of 0 that may fail, with one of some roundoffs of the largest coordinate it works, and a knot that shapes the curve is refused in both cases, with the distance.
#[test]
fn removal_needs_a_tolerance_in_floating_point() {
    let points: Vec<_> = (0..7)
        .map(|i| [0.1 * f64::from(i), 1.0 / f64::from(i + 3), f64::from(i % 3)])
        .collect();
    let plain = curve(3, &[0.0, 0.3, 0.4, 0.8, 1.0], &points);
    let tolerance = 64.0 * UNIT_ROUNDOFF * 2.0;
    let mut refused = 0;
    for k in 1..40 {
        let knot = f64::from(k) / 40.0 + 1e-3;
        let finer = plain.with_knot(knot).expect("a new inner knot");
        let back = finer
            .without_knot(knot, tolerance)
            .expect("the knot was inserted");
        assert_eq!(back.knots(), plain.knots());
        for (new, old) in back.control_points().iter().zip(plain.control_points()) {
            let away = new.minus(*old).largest_coordinate();
            assert!(away <= 1e-12, "a control point is {away} away after {knot}");
        }
        refused += usize::from(finer.without_knot(knot, 0.0).is_err());
    }
    assert!(refused > 0, "rounding never showed");
    match plain.without_knot(0.4, tolerance) {
        Err(BsplineError::KnotNotRemovable { distance, .. }) => assert!(distance > 1e-3),
        other => unreachable!("a knot that shapes the curve: {other:?}"),
    }
}

/// **Nearly repeated knots in a surface.** Two knots that are one number apart make nearly a crease: the surface goes through it without a jump, the normals are defined on both sides, and points between the two knots there are none. Nothing is divided by zero.
#[test]
fn nearly_repeated_knots_do_no_harm() {
    let half = [0.5, 0.5_f64.next_up(), 0.5_f64.next_up().next_up()];
    let knots = [
        clamped(2, &[0.0, half[0], half[1], half[2], 1.0]),
        clamped(1, &[0.0, 1.0]),
    ];
    let points = (0..12).map(|k| {
        DVec3::new(
            f64::from(k % 6),
            f64::from(k / 6),
            f64::from((k % 6) * (k % 6) % 5),
        )
    });
    let surface = BsplineSurface::new(knots, points.collect()).expect("six by two points");
    let before = surface.point(half[0].next_down(), 0.5);
    for u in half {
        let point = surface.point(u, 0.5);
        // Between the three knots the curve may run from one control point to the next, but no farther.
        assert!(
            point.is_finite() && (point - before).abs().max_element() <= 5.0,
            "{point} at {u}"
        );
        assert!(surface.normal_vector(u, 0.5).is_some_and(DVec3::is_finite));
    }
    let derivatives = surface.derivative_at([1, 0], half[1], 0.5);
    assert!(
        derivatives.is_finite() && derivatives.x > 1e14,
        "{derivatives} between the knots"
    );
}

/// **Single against double precision.** The same surface in `f32` and `f64` differs by the rounding of `f32` alone: $(6p+6q+2)$ unit roundoffs of the largest coordinate, those of the knots, which shift the parameter, and one for the control points.
#[test]
fn single_precision_surface_stays_within_its_rounding() {
    let double = BsplineSurface::new(
        [
            clamped(3, &[0.0, 0.25, 0.5, 1.0]),
            clamped(2, &[0.0, 0.125, 0.75, 1.0]),
        ],
        (0..30)
            .map(|k| DVec3::new(f64::from(k % 6), f64::from(k / 6), f64::from(k * k % 7)))
            .collect(),
    )
    .expect("six by five points");
    let knots = [Direction::U, Direction::V].map(|direction| {
        let vector = double.knots(direction);
        let single = vector
            .knots()
            .iter()
            .map(|&knot| DVec3::splat(knot).as_vec3().x)
            .collect();
        KnotVector::new(vector.degree(), single).expect("these knots are exact in single precision")
    });
    let points = double
        .control_points()
        .iter()
        .map(|point| point.as_vec3())
        .collect();
    let single: BsplineSurface<Vec3> = BsplineSurface::new(knots, points).expect("as many points");
    let bound = 32.0 * 6.0 * f64::from(f32::EPSILON) / 2.0;
    for index in 0..=32_u8 {
        let [u, v] = [f32::from(index) / 32.0, f32::from(32 - index) / 64.0];
        let exact = big_point(double.point(u.into(), v.into()).to_array());
        let error = largest_error(single.point(u, v).as_dvec3().to_array(), &exact, bound);
        assert!(error <= 1.0, "{error} bounds away at ({u}, {v})");
    }
}

/// **Across a triple knot.** Where a knot of a cubic surface stands three times there is a crease: at the knot itself the tangent is the one behind it, the normals of the two sides differ, and no average is made up.
#[test]
fn normal_on_a_crease_is_the_one_behind_it() {
    let knots = KnotVector::new(3, vec![0., 0., 0., 0., 1., 1., 1., 2., 2., 2., 2.]);
    let knots = [knots.expect("a triple inner knot"), clamped(1, &[0.0, 1.0])];
    let roof = [0., 1., 2., 3., 2., 1., 0.];
    let points = (0..14).map(|k| {
        [
            f64::from(k % 7),
            f64::from(k / 7),
            roof[usize::try_from(k % 7).expect("small")],
        ]
    });
    let surface = BsplineSurface::new(knots, points.collect()).expect("seven by two points");
    let normal = |u: f64| {
        surface
            .normal_vector(u, 0.5)
            .and_then(unit_vector)
            .expect("a roof has normals")
    };
    assert_eq!(normal(1.0), normal(1.5));
    assert_eq!(normal(1.0_f64.next_down()), normal(0.5));
    assert!(
        normal(0.5).dot(normal(1.5)).abs() <= 4.0 * f64::EPSILON,
        "the two sides of the roof are at a right angle"
    );
}
