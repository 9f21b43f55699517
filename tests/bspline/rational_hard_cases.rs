//! Inputs on which rational curves and surfaces lose digits, have no normal, or must be refused.

use facette::algebra::{Vector3, unit_vector};
use facette::bspline::{
    BsplineError, Homogeneous, KnotVector, RationalCurve, RationalError, RationalSurface, circle,
    sphere,
};
use facette::curve::Curve;
use facette::surface::Surface;
use glam::DVec3;

/// **Weights that are no weights.** Zero, negative, infinite and NaN weights are refused, and so are weights so small that their reciprocal overflows; so is a list of another length than that of the points,
/// and a point that its weight makes overflow.
#[test]
fn unusable_weights_are_refused() {
    let corner = [[1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    let refused = |weights: &[f64]| {
        RationalCurve::new(KnotVector::bezier(2), &corner, weights).expect_err("no weights")
    };
    for bad in [0.0, -1.0, f64::INFINITY, f64::NAN, f64::from_bits(1)] {
        let error = refused(&[1.0, bad, 1.0]);
        assert!(
            matches!(error, RationalError::UnusableWeight { index: 1, .. }),
            "{error}"
        );
    }
    assert_eq!(
        refused(&[1.0, -0.5, 1.0]).to_string(),
        "weight 1 is -0.5: weights must be finite and positive, and so must their reciprocals"
    );
    assert_eq!(
        refused(&[1.0, 1.0]).to_string(),
        "there are 2 weights for 3 control points: each point needs one"
    );
    let far = RationalCurve::new(KnotVector::bezier(1), &[1e300, 0.0], &[1e300, 1.0]);
    assert!(matches!(
        far,
        Err(RationalError::Bspline(BsplineError::PointNotFinite {
            index: 0,
            ..
        }))
    ));
}

/// **Outside the domain.** Beyond its ends the denominator of a rational curve can pass through zero: the point is then infinite or NaN, and no panic. In the domain positive weights exclude it.
#[test]
fn denominator_may_vanish_outside_the_domain_only() {
    let line =
        RationalCurve::new(KnotVector::bezier(1), &[0.0, 1.0_f64], &[2.0, 1.0]).expect("positive");
    assert!(!line.point(2.0).is_finite());
    assert!((0..=100).all(|k| line.point(f64::from(k) / 100.0).is_finite()));
    assert!(line.point(f64::NAN).is_nan());
}

/// **The circle in floating point.** Weights and basis functions are positive, so the quotient loses only a few roundings. In a quarter all terms of a coordinate have one sign: numerator and denominator are each
/// good to $(6p+1)u=13u$, with the two roundings of the division a coordinate is good to $28u$, and $x^2+y^2$, computed with $2u$ more, is within $58u$ of 1, in `f32` and `f64`. Measured is about a tenth.
#[test]
fn circle_stays_round_in_floating_point() {
    let worst = (0..=4000).map(|k| {
        let [x, y] = circle::<f64>().point(f64::from(k) / 1000.0);
        (x * x + y * y - 1.0).abs() / f64::EPSILON * 2.0
    });
    let worst = worst.fold(0.0, f64::max);
    assert!(
        (3.0..=58.0).contains(&worst),
        "{worst} unit roundoffs in f64"
    );
    let worst = (0..=4000_u16).map(|k| {
        let [x, y] = circle::<f32>().point(f32::from(k) / 1000.0);
        let [x, y] = [f64::from(x), f64::from(y)];
        (x * x + y * y - 1.0).abs() / f64::from(f32::EPSILON) * 2.0
    });
    let worst = worst.fold(0.0, f64::max);
    assert!(
        (3.0..=58.0).contains(&worst),
        "{worst} unit roundoffs in f32"
    );
}

/// **Poles in floating point.** At a pole the computed $S_u$ is not zero but rounding, and a product with it would point anywhere. The normal is taken from the next derivatives instead: at both poles and a smallest step beside them, all round, it is the
/// position to $10^{-15}$. Farther away $S_u$ grows in proportion to the distance $d$ from the pole, while its rounding stays: the normal is off by up to $4u/d$ ($1.0u/d$ is measured at $d=10^{-9}$).
#[test]
fn normal_at_the_poles_is_not_rounding() {
    let sphere = sphere::<DVec3>();
    let u_roundoff = f64::EPSILON / 2.0;
    let off_by = |u: f64, v: f64| {
        let normal = sphere
            .normal_vector(u, v)
            .and_then(unit_vector)
            .expect("a normal");
        let position = sphere.point(u, v);
        assert!(
            normal.dot(position) > 0.0,
            "({u}, {v}): {normal} points inwards"
        );
        normal.cross(position).length()
    };
    for step in 0..=64 {
        let u = f64::from(step) / 16.0;
        for v in [0.0, f64::from_bits(1), 2.0 - f64::EPSILON, 2.0] {
            assert!(
                off_by(u, v) <= 1e-15,
                "({u}, {v}) is off by {}",
                off_by(u, v)
            );
        }
        for distance in [1e-9, 1e-6, 1e-3] {
            assert!(
                off_by(u, distance) <= 4.0 * u_roundoff / distance,
                "({u}, {distance})"
            );
        }
    }
}

/// **Far from the origin.** The weights' own derivative moves a surface that lies far away, and the quotient rule takes that away again: at a distance of $10^8$ the partials of a sphere of radius 1 keep 8 digits of 16. The cure is
/// the one for points: translate first.
#[test]
fn distance_costs_digits_of_the_tangents() {
    let plain = sphere::<[f64; 3]>();
    let far = 1e8;
    let moved: Vec<_> = plain
        .homogeneous()
        .control_points()
        .iter()
        .map(|point| {
            let [x, y, z] = point.weighted;
            Homogeneous {
                weighted: [x + far * point.weight, y, z],
                weight: point.weight,
            }
        })
        .collect();
    let knots = [
        facette::bspline::Direction::U,
        facette::bspline::Direction::V,
    ]
    .map(|d| plain.knots(d).clone());
    let moved = facette::bspline::BsplineSurface::new(knots, moved).expect("finite");
    let moved = RationalSurface::from_homogeneous(moved).expect("the same weights");
    let mut worst = 0.0_f64;
    for (u, v) in (1..40).map(|k| (f64::from(k) / 10.0, f64::from(k) / 20.0)) {
        let [near, away] = [&plain, &moved].map(|sphere| sphere.partials(u, v).expect("known"));
        for (a, b) in near.into_iter().flatten().zip(away.into_iter().flatten()) {
            worst = worst.max((a - b).abs());
        }
    }
    assert!((1e-9..1e-6).contains(&worst), "tangents are off by {worst}");
}

/// **Weights of very different size.** Weights from $10^{-150}$ to $10^{150}$ on one curve are all right: the point of the heaviest weight wins, the ends stay where they are.
#[test]
fn weights_of_very_different_size_keep_the_ends() {
    let weights = [1e-150, 1e150, 1.0];
    let points = [[1.0_f64, 2.0, 3.0], [0.0, 5.0, 0.0], [-4.0, 0.5, 1.0]];
    let curve = RationalCurve::new(KnotVector::bezier(2), &points, &weights).expect("positive");
    assert_eq!(curve.point(1.0), points[2]);
    let first = curve.point(0.0);
    assert!(
        first
            .iter()
            .zip(points[0])
            .all(|(a, b)| (a - b).abs() <= b * 2.0 * f64::EPSILON)
    );
    let middle = curve.point(0.5);
    assert!((middle[1] - 5.0).abs() <= 1e-14 && middle.dot([1.0, 0.0, 0.0]).abs() <= 1e-14);
}
