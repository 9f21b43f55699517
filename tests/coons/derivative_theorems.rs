//! The theorems of the bilinear patch's derivatives, in the order of the text.

use facette::algebra::{Scalar, Vector3, VectorSpace};
use facette::coons::{Boundary, CoonsPatch, bilinear_partials, ruled_surfaces};
use facette::curve::Curve;
use facette::surface::Surface;
use num_traits::Zero;
use proptest::prelude::*;

use crate::common::dual::{Dual, constant, dual_bezier, slopes, variable};
use crate::common::exact::{Exact, fraction};
use crate::common::generators::coordinate;
use crate::common::law::{Law, expect_equal};
use crate::inputs::{Place, Point, bezier, edges, hard_places, places};
use crate::suspects;

const ENDS: [i32; 2] = [0, 1];

/// **Derivatives along an edge.** Along an edge the patch runs as its curve does: $S_u(u,0)=P_1'(u)$, $S_u(u,1)=P_2'(u)$,
/// $S_v(0,v)=Q_1'(v)$, $S_v(1,v)=Q_2'(v)$.
///
/// Course: A03, slide 10, Coons patches: the patch carries its four curves.
/// Exercise: derivative.
#[test]
fn partials_along_an_edge_are_the_edge_curves_derivatives() {
    let name = "coons::partials_along_an_edge_are_the_edge_curves_derivatives";
    Law::new(name, suspects::derivative).holds(places(), hard_places(), |place| {
        let boundary = place.boundary();
        let along = [boundary.p1(), boundary.p2()].map(|curve| curve.derivative(place.u));
        let across = [boundary.q1(), boundary.q2()].map(|curve| curve.derivative(place.v));
        let partials = |u, v| bilinear_partials(&boundary, u, v);
        let s_u = ENDS.map(|v| partials(place.u, Exact::from_i32(v)).map(|[s_u, _]| s_u));
        let s_v = ENDS.map(|u| partials(Exact::from_i32(u), place.v).map(|[_, s_v]| s_v));
        expect_equal(&[along, across], &[s_u, s_v])
    });
}

/// **The cross derivative is not free.** How the patch leaves an edge is fixed by the four curves:
///
/// $$S_v(u,0)=P_2(u)-P_1(u)+(1-u)\,Q_1'(0)+u\,Q_2'(0)-\bigl[(1-u)(D-A)+u(C-B)\bigr].$$
///
/// Nothing else can be asked of it: the interior is the boundary's own doing. Whoever moves $P_2$ tilts the patch at $P_1$.
///
/// Course: A05, slide 11, Coons patches: no control of the interior.
/// Exercise: derivative.
#[test]
fn cross_derivative_is_determined_by_the_four_curves() {
    let name = "coons::cross_derivative_is_determined_by_the_four_curves";
    Law::new(name, suspects::derivative).holds(places(), hard_places(), |place| {
        let boundary = place.boundary();
        let [a, b, c, d] = place.corners();
        let [p1, p2, ..] = place.edge_points();
        let [zero, u] = [Exact::zero(), place.u];
        let slopes = [boundary.q1(), boundary.q2()].map(|curve| curve.derivative(zero));
        let [Some(q1), Some(q2)] = slopes else {
            unreachable!("Bézier curves have derivatives")
        };
        let chords = d.minus(a).lerp(c.minus(b), u);
        let expected = p2.minus(p1).plus(q1.lerp(q2, u)).minus(chords);
        let got = bilinear_partials(&boundary, u, zero).map(|[_, s_v]| s_v);
        expect_equal(&Some(expected), &got)
    });
}

/// **Partial derivatives.** Everywhere on the patch, the two partial derivatives are those of
/// $S_1+S_2-S_3$. The test runs that sum over dual numbers $u+\varepsilon$ with $\varepsilon^2=0$, which carry the derivative along without
/// any rule but the product rule.
///
/// Course: A05, slide 11, Coons patches: no control of the interior.
/// Exercise: derivative.
#[test]
fn partials_agree_with_dual_numbers() {
    let law = Law::new(
        "coons::partials_agree_with_dual_numbers",
        suspects::derivative,
    );
    law.holds(places(), hard_places(), |place| {
        let [p1, p2, q1, q2] = place
            .edges
            .each_ref()
            .map(|points| dual_bezier(&bezier(points)));
        let dual = Boundary::new(p1, p2, q1, q2).expect("the edges meet");
        let sum = |u: Dual<Exact>, v: Dual<Exact>| {
            let [s1, s2, s3] = ruled_surfaces(&dual, u, v);
            slopes(s1.plus(s2).minus(s3))
        };
        let s_u = sum(variable(place.u), constant(place.v));
        let s_v = sum(constant(place.u), variable(place.v));
        let got = bilinear_partials(&place.boundary(), place.u, place.v);
        expect_equal(&Some([s_u, s_v]), &got)
    });
}

/// **The normal.** Wherever $S_u\times S_v$ is not zero, the normal of the patch points along it: inside, on the edges and outside.
///
/// Course: A05, slide 11, Coons patches: tangent planes between neighbours.
#[test]
fn normal_points_along_the_product_of_the_partials() {
    let law = Law::new(
        "coons::normal_points_along_the_product_of_the_partials",
        suspects::library,
    );
    law.holds(places(), hard_places(), |place| {
        let patch = CoonsPatch::new(place.boundary());
        let [zero, one] = ENDS.map(Exact::from_i32);
        for [u, v] in [
            [place.u, place.v],
            [place.u, zero],
            [place.u, one],
            [zero, place.v],
            [one, place.v],
        ] {
            let Some([s_u, s_v]) = patch.partials(u, v) else {
                unreachable!("Bézier curves have derivatives")
            };
            let product = s_u.cross(s_v);
            if product == Point::origin() {
                continue;
            }
            let along = patch
                .normal_vector(u, v)
                .map(|normal| (normal.cross(product), normal.dot(product) > Exact::zero()));
            expect_equal(&Some((Point::origin(), true)), &along)?;
        }
        Ok(())
    });
}

/// **No common tangent plane.** Two bilinear patches that share a curve need not be smooth across it, even if every other curve
/// passes smoothly from one patch to the other. Take the shared curve $z=x(1-x)$ over the $x$-axis, straight lines across it at both ends, and
/// straight outer edges: at the middle of the shared curve the normals of the two patches are $(0,\tfrac14,1)$ and $(0,-\tfrac14,1)$. For a
/// middle of height $h$ they are $(0,\pm h,1)$, at an angle $\alpha$ with $\tan\tfrac{\alpha}{2}=h$.
///
/// Course: A05, slide 11, Coons patches: no C1 between neighbours in general.
#[test]
fn neighbouring_patches_have_a_crease_in_general() {
    let heights = (1_i32..=12, 1_i32..=6).prop_map(|(n, d)| fraction(n, d));
    let hard = coordinate().prop_filter("the shared curve is not straight", |h| !h.is_zero());
    let name = "coons::neighbouring_patches_have_a_crease_in_general";
    Law::new(name, suspects::library).holds(heights, hard, |&height| {
        let half = fraction(1, 2);
        let [zero, one] = ENDS.map(Exact::from_i32);
        let shared = vec![[half, zero, height + height]];
        let corners = |y: Exact| [[zero, y, zero], [one, y, zero]];
        let ([a, b], [d, c], [e, f]) = (corners(zero), corners(one), corners(-one));
        let above = edges([a, b, c, d], [shared.clone(), vec![], vec![], vec![]]);
        let below = edges([e, f, b, a], [vec![], shared, vec![], vec![]]);
        let normal = |edges, v| {
            let boundary = Place { edges, u: half, v }.boundary();
            bilinear_partials(&boundary, half, v).map(|[s_u, s_v]| s_u.cross(s_v))
        };
        expect_equal(&Some([zero, height, one]), &normal(above, zero))?;
        expect_equal(&Some([zero, -height, one]), &normal(below, one))
    });
}
