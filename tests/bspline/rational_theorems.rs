//! The theorems of rational curves and surfaces, in the order of the text. The book shows their doc comments.

mod inputs;

use facette::algebra::{Vector3, VectorSpace};
use facette::bspline::{
    BsplineCurve, BsplineSurface, KnotVector, RationalCurve, circle, cox_de_boor, sphere,
};
use facette::curve::Curve;
use facette::surface::Surface;
use num_traits::{One, Zero};
use proptest::collection::vec;
use proptest::prelude::*;

use crate::common::dual::{Dual, constant, variable};
use crate::common::exact::{Exact, fraction};
use crate::common::generators::{hard_parameter, parameter, point};
use crate::common::law::{Law, expect_equal};
use crate::suspects;
use inputs::{
    Point, curve, dual_curve, hard_places, hard_weight, integer, knots, places, quarters,
    sphere_places, surface, weight,
};

/// **Weighted means.** A rational curve is $C(u)=\sum_iR_i(u)\,P_i$ with $R_i=w_iN_i/\sum_kw_kN_k$. For positive weights these functions are non-negative and sum to 1: points are convex
/// combinations of their control points, as those of a B-spline are. In homogeneous coordinates $(wP,w)$ nothing is new but the division at the end.
#[test]
fn rational_curve_is_a_weighted_mean() {
    let law = Law::new(
        "bspline::rational_curve_is_a_weighted_mean",
        suspects::library,
    );
    law.holds(places(), hard_places(), |(points, weights, u)| {
        let knots = knots();
        let products: Vec<Exact> = (0..7)
            .map(|i| weights[i] * cox_de_boor(&knots, 3, i, *u))
            .collect();
        let sum = products
            .iter()
            .fold(Exact::zero(), |sum, &product| sum + product);
        let shares: Vec<Exact> = products.iter().map(|&product| product / sum).collect();
        let is_mean = shares.iter().all(|&share| share >= Exact::zero());
        expect_equal(
            &(true, Exact::one()),
            &(
                is_mean,
                shares.iter().fold(Exact::zero(), |sum, &share| sum + share),
            ),
        )?;
        let terms = points
            .iter()
            .zip(&shares)
            .map(|(point, &share)| point.times(share));
        let expected = terms.reduce(VectorSpace::plus).expect("seven terms");
        expect_equal(&expected, &curve(points, weights).point(*u))
    });
}

/// **Equal weights.** With equal weights, whatever their value, a rational curve is the B-spline curve of its control points, in all its derivatives; and a common factor of all weights changes
/// nothing at all.
#[test]
fn equal_weights_give_the_bspline() {
    let law = Law::new("bspline::equal_weights_give_the_bspline", suspects::library);
    law.holds(places(), hard_places(), |(points, weights, u)| {
        let plain = BsplineCurve::new(knots(), points.clone()).expect("finite points");
        let equal = curve(points, &[weights[0]; 7]);
        let scaled: Vec<Exact> = weights.iter().map(|&w| w * weights[0]).collect();
        for order in 0..=4 {
            expect_equal(
                &plain.derivative_at(order, *u),
                &equal.derivative_at(order, *u),
            )?;
            let [one, other] =
                [weights, &scaled].map(|weights| curve(points, weights).derivative_at(order, *u));
            expect_equal(&one, &other)?;
        }
        Ok(())
    });
}

/// **What a weight does.** Raising the weight of one control point moves every point of the curve that it reaches straight towards that control point: $C_{w'}(u)-C_w(u)=\lambda\,\bigl(P_i-C_w(u)\bigr)$ with
/// $\lambda=(w'-w)N_i/\bigl((w'-w)N_i+\sum_kw_kN_k\bigr)$.
#[test]
fn raising_a_weight_pulls_the_curve_straight_to_its_point() {
    let law = Law::new(
        "bspline::raising_a_weight_pulls_the_curve_straight_to_its_point",
        suspects::library,
    );
    law.holds(
        (places(), 0..7_usize),
        (hard_places(), 0..7_usize),
        |((points, weights, u), i)| {
            let more = integer(3);
            let mut raised = weights.clone();
            raised[*i] = raised[*i] + more;
            let before = curve(points, weights).point(*u);
            let knots = knots();
            let sum = (0..7)
                .map(|k| weights[k] * cox_de_boor(&knots, 3, k, *u))
                .fold(Exact::zero(), |a, b| a + b);
            let gained = more * cox_de_boor(&knots, 3, *i, *u);
            let expected = before.lerp(points[*i], gained / (gained + sum));
            expect_equal(&expected, &curve(points, &raised).point(*u))
        },
    );
}

/// **Knots come for free.** Knot insertion and degree elevation know nothing of weights: done to the homogeneous control points, they leave a rational curve as it is.
#[test]
fn refining_the_homogeneous_points_keeps_the_curve() {
    let law = Law::new(
        "bspline::refining_the_homogeneous_points_keeps_the_curve",
        suspects::library,
    );
    law.holds(places(), hard_places(), |(points, weights, u)| {
        let curve = curve(points, weights);
        let finer = curve
            .homogeneous()
            .with_knot(fraction(1, 3))
            .expect("a knot of the domain");
        for other in [finer, curve.homogeneous().elevated()] {
            let other = RationalCurve::from_homogeneous(other).expect("means of positive weights");
            expect_equal(&curve.point(*u), &other.point(*u))?;
        }
        Ok(())
    });
}

/// **Quotient rule.** From $A=wC$, by Leibniz, $C^{(k)}=\bigl(A^{(k)}-\sum_{i=1}^k\binom ki w^{(i)}C^{(k-i)}\bigr)/w$. First and second derivatives are what numbers that carry their own derivative give for the
/// plain formula of the point.
#[test]
fn curve_derivatives_follow_the_quotient_rule() {
    let law = Law::new(
        "bspline::curve_derivatives_follow_the_quotient_rule",
        suspects::library,
    );
    law.holds(places(), hard_places(), |(points, weights, u)| {
        let curve = curve(points, weights);
        let once = dual_curve(&curve);
        let twice = dual_curve(&once);
        let t = Dual {
            value: variable(*u),
            slope: constant(Exact::one()),
        };
        let series = twice.point(t);
        let [value, first, second] = [
            series.map(|x| x.value.value),
            series.map(|x| x.value.slope),
            series.map(|x| x.slope.slope),
        ];
        let got = [0, 1, 2].map(|order| curve.derivative_at(order, *u));
        expect_equal(&[value, first, second], &got)?;
        expect_equal(&Some(first), &curve.derivative(*u))
    });
}

/// **Quotient rule in two variables.** The same rule, $A^{(k,l)}=\sum_{i\le k,\,j\le l}\binom ki\binom lj\,w^{(i,j)}S^{(k-i,\,l-j)}$, gives all partial derivatives. $S_u$, $S_v$, $S_{uv}$, $S_{uu}$ and
/// $S_{vv}$ are what numbers that carry their own derivatives give for the point.
#[test]
fn surface_derivatives_follow_the_quotient_rule() {
    let law = Law::new(
        "bspline::surface_derivatives_follow_the_quotient_rule",
        suspects::library,
    );
    let input = |hard: bool| {
        let weights = if hard {
            hard_weight().boxed()
        } else {
            weight().boxed()
        };
        let place = if hard {
            hard_parameter().boxed()
        } else {
            parameter().boxed()
        };
        let inside = place.prop_map(|t| {
            if t < Exact::zero() || t > Exact::one() {
                fraction(1, 2)
            } else {
                t
            }
        });
        (vec(point(), 12), vec(weights, 12), inside.clone(), inside)
    };
    law.holds(input(false), input(true), |(points, weights, u, v)| {
        let exact = surface(points, weights, |value| value);
        let dual = surface(points, weights, |value| constant(constant(value)));
        let fixed = |t: Exact| constant(constant(t));
        let outer = |t: Exact| Dual {
            value: constant(t),
            slope: constant(Exact::one()),
        };
        let inner = |t: Exact| constant(variable(t));
        let both = |t: Exact| Dual {
            value: variable(t),
            slope: constant(Exact::one()),
        };
        let mixed = dual.point(outer(*u), inner(*v));
        let [s_u, s_v] = [mixed.map(|x| x.slope.value), mixed.map(|x| x.value.slope)];
        expect_equal(&Some([s_u, s_v]), &exact.partials(*u, *v))?;
        let expected = [
            mixed.map(|x| x.value.value),
            s_u,
            s_v,
            mixed.map(|x| x.slope.slope),
            dual.point(both(*u), fixed(*v)).map(|x| x.slope.slope),
            dual.point(fixed(*u), both(*v)).map(|x| x.slope.slope),
        ];
        let orders = [[0, 0], [1, 0], [0, 1], [1, 1], [2, 0], [0, 2]];
        expect_equal(
            &expected,
            &orders.map(|orders| exact.derivative_at(orders, *u, *v)),
        )
    });
}

/// **Circle.** Nine control points, weights 1, 1, 2, 1, 1, 1, 2, 1, 1: the curve satisfies $x^2+y^2=1$ at every parameter, not nearly but exactly; its tangent is perpendicular to the radius. In the
/// first quarter it is $\bigl(\tfrac{1-t^2}{1+t^2},\tfrac{2t}{1+t^2}\bigr)$. No polynomial curve can do this: the leading coefficients of $x^2+y^2$ would have to cancel, and they are squares.
#[test]
fn circle_is_exact() {
    let law = Law::new("bspline::circle_is_exact", suspects::library);
    let around = |t: Exact| t * integer(4);
    let hard = hard_parameter().prop_filter("in the domain", |&t| {
        t >= Exact::zero() && t <= Exact::one()
    });
    law.holds(parameter(), hard, |&share| {
        let circle = circle::<Exact>();
        let u = around(share);
        let [x, y] = circle.point(u);
        expect_equal(&Exact::one(), &(x * x + y * y))?;
        let [dx, dy] = circle.derivative_at(1, u);
        expect_equal(&Exact::zero(), &(x * dx + y * dy))?;
        expect_equal(&true, &(x * dy - y * dx > Exact::zero()))?;
        let (t, w) = (share, Exact::one() + share * share);
        expect_equal(&[(Exact::one() - t * t) / w, (t + t) / w], &circle.point(t))
    });
}

/// **The parameter is not the angle.** The circle passes through $(1,0),(0,1),(-1,0),(0,-1)$ at $0,1,2,3$, but not evenly in between: its speed is $2/(1+t^2)$ in the first quarter, 2 at the start and 1 at the end, and half
/// the parameter leads to $(\tfrac35,\tfrac45)$, an angle of $53.1°$. Rational functions cannot do better: a curve of constant speed round a circle needs sine and cosine.
#[test]
fn circle_parameter_is_not_the_angle() {
    let circle = circle::<Exact>();
    let corners = [0, 1, 2, 3, 4].map(|u| circle.point(integer(u)));
    let expected = [[1, 0], [0, 1], [-1, 0], [0, -1], [1, 0]].map(|corner| corner.map(integer));
    assert_eq!(corners, expected);
    assert_eq!(
        circle.point(fraction(1, 2)),
        [fraction(3, 5), fraction(4, 5)]
    );
    for eighth in 0..8 {
        let t = fraction(eighth, 8);
        let [dx, dy] = circle.derivative_at(1, t);
        let speed = integer(2) / (Exact::one() + t * t);
        assert_eq!(dx * dx + dy * dy, speed * speed);
    }
}

/// **Joints.** Where quarters meet at $(0,\pm1)$, the homogeneous curve has a corner, and yet the circle is continuously differentiable there: the corner lies in the direction of the point itself, which the division
/// takes away. The second derivative jumps, at $(0,1)$ by $(-2,0)$: the speed falls until there and rises from there on. At $(\pm1,0)$, the seam included, both sides are one and the same
/// rational function, and nothing jumps.
#[test]
fn circle_joints_are_once_differentiable() {
    let quarters = quarters();
    let jump = |joint: usize, order: usize| {
        let [before, after] = [&quarters[joint % 4], &quarters[(joint + 1) % 4]];
        let left = before.derivative_at(order, Exact::one());
        after.derivative_at(order, Exact::zero()).minus(left)
    };
    let homogeneous_jump = |joint: usize, order: usize| {
        let [before, after] = [&quarters[joint % 4], &quarters[(joint + 1) % 4]];
        let left = before.homogeneous().derivative_at(order, Exact::one());
        after
            .homogeneous()
            .derivative_at(order, Exact::zero())
            .minus(left)
    };
    let zero = [Exact::zero(); 2];
    for joint in [0, 2] {
        assert_ne!(homogeneous_jump(joint, 1), VectorSpace::origin());
        assert_eq!([jump(joint, 0), jump(joint, 1)], [zero; 2]);
        let along = if joint == 0 { -2 } else { 2 };
        assert_eq!(jump(joint, 2), [along, 0].map(integer));
    }
    for joint in [1, 3] {
        for order in 0..=6 {
            assert_eq!(jump(joint, order), zero);
            assert_eq!(homogeneous_jump(joint, order), VectorSpace::origin());
        }
    }
}

/// **Sphere.** The tensor product of a half circle and a circle satisfies $x^2+y^2+z^2=1$ at every pair of parameters, exactly. The parallels $v=$ const are circles in horizontal planes, the meridians $u=$ const half
/// circles through both poles.
#[test]
fn sphere_is_exact() {
    let law = Law::new("bspline::sphere_is_exact", suspects::library);
    law.holds(sphere_places(false), sphere_places(true), |&(u, v)| {
        let sphere = sphere::<Point>();
        let point = sphere.point(u, v);
        expect_equal(&Exact::one(), &point.dot(point))?;
        let start = sphere.point(Exact::zero(), v);
        expect_equal(&start[2], &point[2])?;
        let [x, y] = circle::<Exact>().point(u);
        expect_equal(&[start[0] * x, start[0] * y], &[point[0], point[1]])?;
        let poles = [0, 2].map(|v| sphere.point(u, integer(v)));
        expect_equal(
            &[[0, 0, -1], [0, 0, 1]].map(|pole| pole.map(integer)),
            &poles,
        )
    });
}

/// **Normals of the sphere.** Everywhere the normal is a positive multiple of the position. That includes the poles, where $S_u=0$ and $S_u\times S_v$ says nothing: there it is the limit along the meridian, to first order $\pm(v-v_0)\,S_{uv}\times S_v$.
#[test]
fn normal_of_the_sphere_is_the_position() {
    let law = Law::new(
        "bspline::normal_of_the_sphere_is_the_position",
        suspects::library,
    );
    law.holds(sphere_places(false), sphere_places(true), |&(u, v)| {
        let sphere = sphere::<Point>();
        let position = sphere.point(u, v);
        let normal = sphere.normal_vector(u, v).unwrap_or_else(Point::origin);
        let is_outward = normal.dot(position) > Exact::zero();
        expect_equal(
            &(Point::origin(), true),
            &(normal.cross(position), is_outward),
        )
    });
    let [s_u, _] = sphere::<Point>()
        .partials(Exact::one(), Exact::zero())
        .expect("known");
    assert_eq!(s_u, Point::origin());
}

/// **Equal weights in two variables.** With equal weights a rational surface is the B-spline surface of its control points: points, partial derivatives and normals.
#[test]
fn equal_weights_give_the_bspline_surface() {
    let law = Law::new(
        "bspline::equal_weights_give_the_bspline_surface",
        suspects::library,
    );
    let input = || (vec(point(), 12), weight(), parameter(), parameter());
    let hard = || {
        (
            vec(point(), 12),
            hard_weight(),
            hard_parameter(),
            hard_parameter(),
        )
    };
    law.holds(input(), hard(), |(points, weight, u, v)| {
        let rational = surface(points, &[*weight; 12], |value| value);
        let breaks = [integer(0), fraction(1, 2), integer(1)];
        let knots = [
            KnotVector::clamped(2, &breaks).expect("increasing"),
            KnotVector::bezier(2),
        ];
        let plain = BsplineSurface::new(knots, points.clone()).expect("4 x 3 points");
        expect_equal(&plain.point(*u, *v), &rational.point(*u, *v))?;
        expect_equal(&plain.partials(*u, *v), &rational.partials(*u, *v))?;
        let orders = [[2, 1], [0, 2], [3, 3]];
        let [expected, got] = [
            orders.map(|orders| plain.derivative_at(orders, *u, *v)),
            orders.map(|orders| rational.derivative_at(orders, *u, *v)),
        ];
        expect_equal(&expected, &got)
    });
}
