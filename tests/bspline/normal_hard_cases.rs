//! Normals and derivatives where rounding is as large as what they are made of.

use facette::bspline::{BsplineCurve, BsplineSurface, KnotVector, SurfaceEvaluator};
use facette::curve::Curve;
use facette::surface::Surface;

use crate::common::oracle::{big, largest_error};

/// A Bézier surface of degree 3 in u with the given columns of `[x, z]`, straight in y.
fn cubic_strip(columns: [[f64; 2]; 4], shift: f64) -> BsplineSurface<[f64; 3]> {
    let knots = [KnotVector::bezier(3), KnotVector::bezier(1)];
    let row = |y: f64| columns.map(|[x, z]| [x + shift, y + shift, z + shift]);
    let points = [row(0.0), row(1.0)].concat();
    BsplineSurface::new(knots, points).expect("eight finite points")
}

/// **Next to a cusp.** With $x=0,1,-1,3$ the flat strip turns back nowhere, but stops at $u=\tfrac13$: $S_u=3(1-3u)^2\,\mathbf e_x$. Within $10^{-8}$ of that place the computed $S_u$
/// is nothing but rounding, of either sign, and so is its product with $S_v$. The normal must be $+z$ all the same, or none; it is found from a coefficient of
/// higher order that outweighs the lower ones together with their rounding.
#[test]
fn normal_next_to_a_cusp_is_not_rounding() {
    let strip = cubic_strip([[0.0, 0.0], [1.0, 0.0], [-1.0, 0.0], [3.0, 0.0]], 0.0);
    let evaluator = SurfaceEvaluator::new(strip.clone());
    let mut found = 0;
    for exponent in 6..=17 {
        for step in -40..=40 {
            let distance = f64::from(step) * 10.0_f64.powi(-exponent) / 40.0;
            let u = 1.0 / 3.0 + distance;
            let mut in_list = [[0.0; 3]];
            evaluator.normals(&[[u, 0.5]], &mut in_list);
            for normal in [strip.normal_vector(u, 0.5), Some(in_list[0])] {
                let Some([x, y, z]) = normal else { continue };
                assert!(
                    [x, y] == [0.0, 0.0] && z >= 0.0,
                    "u = 1/3 + {distance:e}: {z:e}"
                );
                found += usize::from(z > 0.0);
            }
        }
    }
    assert!(found > 1900, "of 1944 normals only {found} are found");
}

/// **A short tangent far from the origin.** Control points are exact numbers: two that lie $10^{-6}$ apart at $10^9$ say exactly where the tangent goes, however large the
/// coordinates are that they share. The normal at the corner is $-z\times$ the tangent's direction, not that of the next control points.
#[test]
fn short_tangents_far_away_are_believed() {
    for [shift, short] in [
        [0.0, 1e-6],
        [1e6, 2.0_f64.powi(-20)],
        [1e9, 2.0_f64.powi(-20)],
    ] {
        let strip = cubic_strip([[0.0, 0.0], [short, 0.0], [0.0, 1.0], [0.0, 2.0]], shift);
        let normal = strip.normal_vector(0.0, 0.0);
        let [x, y, z] = normal.expect("the corner has a tangent plane");
        assert!([x, y] == [0.0, 0.0] && z > 0.0, "shift {shift}: {normal:?}");
    }
}

/// **Spans of denormal length.** Three over a denormal number is infinite, and infinity times a difference of zero is not a number. The difference is multiplied first
/// where that happens: control points that coincide have the derivative 0, and those that hardly differ a finite one.
#[test]
fn denormal_spans_have_derivatives() {
    let knots = KnotVector::new(1, vec![0.0, 0.0, 1e-309, 1.0, 1.0]).expect("valid knots");
    let points: Vec<[f64; 2]> = vec![[0.0, 3.0], [1e-10, 3.0], [1.0, 3.0]];
    let curve = BsplineCurve::new(knots, points).expect("three points");
    let [slope, by_curve] = [
        curve
            .derivative(0.0)
            .expect("a B-spline knows its derivative"),
        curve.derivative_curve().point(0.0),
    ];
    // One difference quotient of degree 1: within 6u of itself, as every first derivative of a curve.
    let exact = [big(1e-10) / big(1e-309), big(0.0)];
    let bound = 6.0 * (f64::EPSILON / 2.0) * 1e299;
    assert!(largest_error(slope, &exact, bound) <= 1.0, "{slope:?}");
    assert_eq!(slope, by_curve);
}

/// **Stretched until knots touch.** A new domain is reached by rounding, and rounding must not exchange two knots that are neighbouring numbers.
#[test]
fn stretching_keeps_the_order_of_near_knots() {
    let first = 0.478_286_777_708_422_f64;
    let mut inner = vec![first];
    for _ in 0..3 {
        inner.push(inner[inner.len() - 1].next_up());
    }
    let breaks = [vec![0.0], inner, vec![1.0]].concat();
    let knots = KnotVector::clamped(5, &breaks).expect("valid knots");
    for k in 1..=2000 {
        let start = -1.283 * f64::from(k) / 7.0;
        let end = start + 1.24 + f64::from(k % 13) / 11.0;
        let moved = knots
            .reparametrised([start, end])
            .expect("knots stay in order");
        assert_eq!(moved.domain(), [start, end]);
        assert!(moved.knots().is_sorted());
    }
}
