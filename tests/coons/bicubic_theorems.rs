//! The theorems of the bicubically blended patch and of the Ferguson patch, in the order of the text.

use facette::algebra::{Scalar, VectorSpace};
use facette::coons::{
    Boundary, CoonsError, Corner, CrossDerivatives, FergusonPatch, HermiteBoundary,
    bicubic_partials, bicubic_point, hermite_basis,
};
use facette::curve::{BezierCurve, Curve};
use facette::surface::Surface;
use num_traits::{One, Zero};
use proptest::prelude::*;

use crate::common::dual::{Dual, constant, slopes, variable};
use crate::common::exact::{Exact, fraction};
use crate::common::generators::{coordinate, hard_parameter, parameter, point};
use crate::common::law::{Broken, Law, Verdict, expect_equal};
use crate::inputs::{
    Net, Point, SurfaceData, bezier, hermite_boundary, nets, surface_data, surface_point, twists_of,
};
use crate::suspects;

type ExactData = HermiteBoundary<BezierCurve<Point>>;

fn net_places(lowest: usize, highest: usize) -> impl Strategy<Value = (Net, Exact, Exact)> {
    (nets(lowest, highest), parameter(), parameter())
}

/// Nets with a side collapsed to a point, and any net at the ends of the parameters, next to them and outside.
fn hard_net_places(lowest: usize, highest: usize) -> impl Strategy<Value = (Net, Exact, Exact)> {
    let collapsed = nets(lowest, highest).prop_map(|mut net| {
        let apex = net[0][0];
        net[0].fill(apex);
        net
    });
    (
        prop_oneof![collapsed, nets(lowest, highest)],
        hard_parameter(),
        hard_parameter(),
    )
}

/// The cross derivatives of the blended patch on an edge, by dual numbers: `S_v` at `(u, end)` or `S_u` at `(end, v)`.
fn across(data: &ExactData, u: Dual<Exact>, v: Dual<Exact>) -> Point {
    slopes(bicubic_point(&dual_data(data), u, v))
}

/// The same data over dual numbers.
fn dual_data(data: &ExactData) -> HermiteBoundary<BezierCurve<[Dual<Exact>; 3]>> {
    use crate::common::dual::dual_bezier as dual;
    let edges = data.boundary();
    let boundary = Boundary::new(
        dual(edges.p1()),
        dual(edges.p2()),
        dual(edges.q1()),
        dual(edges.q2()),
    );
    let cross = CrossDerivatives {
        p1_v: dual(data.p1_v()),
        p2_v: dual(data.p2_v()),
        q1_u: dual(data.q1_u()),
        q2_u: dual(data.q2_u()),
    };
    HermiteBoundary::gregory(boundary.expect("the edges meet"), cross).expect("the slopes fit")
}

/// **Hermite's cubics.** Each of the four cubics carries one datum and is blind to the other three: of the value at 0, the slope
/// at 0, the slope at 1 and the value at 1, the first has $1,0,0,0$, the second $0,1,0,0$, the third $0,0,1,0$ and the fourth $0,0,0,1$.
///
/// Course: A06, slide 12, Coons patches: Hermite interpolation.
/// Exercise: bicubic.
#[test]
fn hermite_basis_carries_one_datum_each() {
    let law = Law::new(
        "coons::hermite_basis_carries_one_datum_each",
        suspects::bicubic,
    );
    law.holds(0..4_usize, 0..4_usize, |&which| {
        let at = |t: i32| hermite_basis(variable(Exact::from_i32(t)))[which];
        let data = [at(0).value, at(0).slope, at(1).slope, at(1).value];
        let expected = [0, 1, 2, 3].map(|datum| Exact::from_i32(i32::from(datum == which)));
        expect_equal(&expected, &data)
    });
}

/// **Cubics are reproduced.** With their own end values and end slopes as weights, Hermite's cubics give back every cubic
/// polynomial.
///
/// Course: A06, slide 12, Coons patches: Hermite interpolation.
/// Exercise: bicubic.
#[test]
fn hermite_basis_reproduces_cubics() {
    let cubic = || [coordinate(), coordinate(), coordinate(), coordinate()];
    let law = Law::new("coons::hermite_basis_reproduces_cubics", suspects::bicubic);
    law.holds(
        (cubic(), parameter()),
        (cubic(), hard_parameter()),
        |&([a, b, c, d], t)| {
            let f = |t: Dual<Exact>| {
                let [a, b, c, d] = [a, b, c, d].map(constant);
                ((d * t + c) * t + b) * t + a
            };
            let [start, end] = [0, 1].map(|t| f(variable(Exact::from_i32(t))));
            let data = [start.value, start.slope, end.slope, end.value];
            expect_equal(
                &f(constant(t)).value,
                &Exact::combination(hermite_basis(t), data),
            )
        },
    );
}

/// **The blended patch carries its curves.** On its edges the bicubically blended patch is the four boundary curves, whatever
/// slopes and twists it is given.
///
/// Course: A06, slide 12, Coons patches: the bicubic patch.
/// Exercise: bicubic.
#[test]
fn bicubic_patch_interpolates_its_four_boundary_curves() {
    let name = "coons::bicubic_patch_interpolates_its_four_boundary_curves";
    let law = Law::new(name, suspects::bicubic);
    law.holds(net_places(2, 4), hard_net_places(2, 4), |(net, u, v)| {
        let data = hermite_boundary(net);
        let [zero, one] = [0, 1].map(Exact::from_i32);
        let s = |u, v| bicubic_point(&data, u, v);
        let edges = data.boundary();
        let expected = [
            edges.p1().point(*u),
            edges.p2().point(*u),
            edges.q1().point(*v),
            edges.q2().point(*v),
        ];
        expect_equal(
            &expected,
            &[s(*u, zero), s(*u, one), s(zero, *v), s(one, *v)],
        )
    });
}

/// **The blended patch has the given slopes.** Across each edge its derivative is the given curve: $S_v(u,0)$, $S_v(u,1)$,
/// $S_u(0,v)$ and $S_u(1,v)$, all along the edge and not at the corners only, if the twists are compatible.
///
/// Course: A06, slide 12, Coons patches: the bicubic patch.
/// Exercise: bicubic.
#[test]
fn bicubic_patch_has_the_given_cross_derivatives() {
    let name = "coons::bicubic_patch_has_the_given_cross_derivatives";
    let law = Law::new(name, suspects::bicubic).on_cases(32);
    law.holds(net_places(2, 4), hard_net_places(2, 4), |(net, u, v)| {
        has_cross_derivatives(&hermite_boundary(net), *u, *v)
    });
}

fn has_cross_derivatives(data: &ExactData, u: Exact, v: Exact) -> Verdict {
    let end = |t: i32| variable(Exact::from_i32(t));
    let got = [
        across(data, constant(u), end(0)),
        across(data, constant(u), end(1)),
        across(data, end(0), constant(v)),
        across(data, end(1), constant(v)),
    ];
    let expected = [
        data.p1_v().point(u),
        data.p2_v().point(u),
        data.q1_u().point(v),
        data.q2_u().point(v),
    ];
    expect_equal(&expected, &got)
}

/// **Bicubic surfaces are reproduced.** The bicubically blended patch of the edges, cross derivatives and twists of a bicubic Bézier
/// surface is that surface, everywhere.
///
/// Course: A06, slide 12, Coons patches: the bicubic patch.
/// Exercise: bicubic.
#[test]
fn bicubic_patch_reproduces_bicubic_surfaces() {
    let name = "coons::bicubic_patch_reproduces_bicubic_surfaces";
    let law = Law::new(name, suspects::bicubic);
    law.holds(net_places(3, 3), hard_net_places(3, 3), |(net, u, v)| {
        expect_equal(
            &surface_point(net, *u, *v),
            &bicubic_point(&hermite_boundary(net), *u, *v),
        )
    });
}

/// **Sixteen vectors.** The Ferguson patch, or bicubic Hermite patch, is fixed by 16 vectors: at each corner the position, the two
/// first derivatives and the twist. Those of a bicubic Bézier surface give back that surface. It knows nothing of boundary
/// *curves*: it is another patch than the bicubically blended one.
///
/// Course: A06, slide 12, Coons patches: the bicubic patch.
/// Erratum: The slide lists for one bicubic Coons patch "4 positions, 8 normal derivatives along the edges, 4 twist vectors". That mixes two patches. With 4 positions, 8 first derivatives at the corners and 4 twists one gets the Ferguson patch; the bicubically blended Coons patch has 4 boundary curves, 4 curves of derivatives across them and 4 twists.
#[test]
fn ferguson_patch_reproduces_bicubic_surfaces_from_sixteen_vectors() {
    let name = "coons::ferguson_patch_reproduces_bicubic_surfaces_from_sixteen_vectors";
    let law = Law::new(name, suspects::library);
    law.holds(net_places(3, 3), hard_net_places(3, 3), |(net, u, v)| {
        let square = std::array::from_fn(|i| std::array::from_fn(|j| net[i][j]));
        let patch = FergusonPatch::from_bezier(square).expect("the points are finite");
        let data = hermite_boundary(net);
        expect_equal(&data.corner_vectors(*u, *v), patch.vectors())?;
        expect_equal(&surface_point(net, *u, *v), &patch.point(*u, *v))?;
        expect_equal(&bicubic_partials(&data, *u, *v), &patch.partials(*u, *v))
    });
}

/// **Across is not perpendicular.** The derivative across an edge need only leave the edge, not be normal to it. The plane
/// $S(u,v)=(u+v,v,0)$ has $S_u=(1,0,0)$ along its edges in $u$ and $S_v=(1,1,0)$ across them, at $45°$; the blended patch of these
/// data is that plane. With the perpendicular $(0,1,0)$ in place of $S_v$ the data contradict the edges in $v$, and are refused.
///
/// Course: A06, slide 12, Coons patches: derivatives across the edges.
/// Erratum: The slide calls the derivatives across the edges "normal". They are only transversal: perpendicular ones would in general contradict the other two edges.
#[test]
fn cross_derivatives_need_not_be_normal_to_the_edge() {
    let at = |x, y| [x, y, 0].map(Exact::from_i32);
    let line = |start, end| bezier::<Point>(&[start, end]);
    let boundary = || {
        let [a, b, c, d] = [at(0, 0), at(1, 0), at(2, 1), at(1, 1)];
        Boundary::new(line(a, b), line(d, c), line(a, d), line(b, c)).expect("the edges meet")
    };
    let cross = |s_v: Point| CrossDerivatives {
        p1_v: bezier(&[s_v, s_v]),
        p2_v: bezier(&[s_v, s_v]),
        q1_u: line(at(1, 0), at(1, 0)),
        q2_u: line(at(1, 0), at(1, 0)),
    };
    let data = HermiteBoundary::gregory(boundary(), cross(at(1, 1))).expect("the data fit");
    let [third, half] = [fraction(1, 3), fraction(1, 2)];
    assert_eq!(
        bicubic_point(&data, third, half),
        [third + half, half, Exact::zero()]
    );
    let refused = HermiteBoundary::gregory(boundary(), cross(at(0, 1)));
    assert!(
        matches!(
            refused,
            Err(CoonsError::DoNotMeet {
                corner: Corner::A,
                first: "p1_v(0)",
                ..
            })
        ),
        "{refused:?}"
    );
}

/// **Twist compatibility.** The twist at a corner can be read off both cross derivatives that meet there,
/// $S_{vu}=\tfrac{d}{du}S_v(u,0)$ and $S_{uv}=\tfrac{d}{dv}S_u(0,v)$. A surface with continuous mixed derivatives needs them equal;
/// data in which they differ are refused, with the corner.
///
/// Course: A06, slide 12, Coons patches: four twist vectors.
#[test]
fn incompatible_twists_are_refused() {
    let law = Law::new("coons::incompatible_twists_are_refused", suspects::library).on_cases(32);
    let nudge = || coordinate().prop_filter("a nudge that moves", |nudge| !nudge.is_zero());
    law.holds(
        (nets(3, 4), nudge()),
        (nets(2, 2), nudge()),
        |(net, nudge)| {
            let mut twists = twists_of(net);
            twists.c[1] = twists.c[1] + *nudge;
            let SurfaceData {
                edges: [p1, p2, q1, q2],
                cross,
            } = surface_data(net);
            let boundary = Boundary::new(p1, p2, q1, q2).expect("a surface's edges meet");
            match HermiteBoundary::new(boundary, cross, twists) {
                Err(CoonsError::DoNotMeet {
                    corner: Corner::C,
                    first: "the twist",
                    gap,
                    ..
                }) => expect_equal(&nudge.magnitude(), &gap),
                other => Err(Broken {
                    expected: "a refusal of the twist at C".to_owned(),
                    got: format!("{other:?}"),
                }),
            }
        },
    );
}

/// Data of a surface whose cross derivatives are changed inside, so that the twists of the two families differ.
fn with_other_twists(net: &Net, [first, second]: [Point; 2]) -> ExactData {
    let SurfaceData {
        edges: [p1, p2, q1, q2],
        cross,
    } = surface_data(net);
    let boundary = Boundary::new(p1, p2, q1, q2).expect("a surface's edges meet");
    let changed = |curve: &BezierCurve<Point>, change: Point| {
        let mut points = curve.control_points().to_vec();
        let last = points.len() - 1;
        points[1] = points[1].plus(change);
        points[last - 1] = points[last - 1].minus(change);
        bezier(&points)
    };
    let cross = CrossDerivatives {
        p1_v: changed(&cross.p1_v, first),
        p2_v: changed(&cross.p2_v, second),
        q2_u: changed(&cross.q2_u, first.plus(second)),
        ..cross
    };
    HermiteBoundary::gregory(boundary, cross).expect("the ends have not changed")
}

/// Parameters strictly between 0 and 1: at a corner itself, a dual number's distance from it has no reciprocal.
fn inside(parameters: impl Strategy<Value = Exact>) -> impl Strategy<Value = Exact> {
    let is_inside = |&t: &Exact| t > Exact::zero() && t < Exact::one();
    parameters.prop_filter("strictly inside", is_inside)
}

type TwistedPlace = (Net, [Point; 2], Exact, Exact);

fn twisted_places() -> impl Strategy<Value = TwistedPlace> {
    (
        nets(3, 4),
        [point(), point()],
        inside(parameter()),
        inside(parameter()),
    )
}

fn hard_twisted_places() -> impl Strategy<Value = TwistedPlace> {
    (
        nets(3, 4),
        [point(), point()],
        inside(hard_parameter()),
        inside(hard_parameter()),
    )
}

/// **Gregory's correction.** Where the two families of cross derivatives disagree about a twist, let the point $(u,v)$ near $A$ see
///
/// $$\frac{u\,S_{uv}+v\,S_{vu}}{u+v}$$
///
/// and likewise at the other corners, with $1-u$ for $u$ at $B$ and $C$, and $1-v$ for $v$ at $C$ and $D$. Then the patch carries all four curves and all
/// four cross derivatives again: along each edge, $S_3$ holds the twist that the other family brings there, and takes away just what is too much.
///
/// Course: A06, slide 12, Coons patches: four twist vectors.
/// Exercise: bicubic.
#[test]
fn gregory_patch_has_cross_derivatives_with_incompatible_twists() {
    let name = "coons::gregory_patch_has_cross_derivatives_with_incompatible_twists";
    let law = Law::new(name, suspects::bicubic).on_cases(32);
    law.holds(
        twisted_places(),
        hard_twisted_places(),
        |(net, changes, u, v)| {
            let data = with_other_twists(net, *changes);
            let [zero, one] = [0, 1].map(Exact::from_i32);
            let s = |u, v| bicubic_point(&data, u, v);
            let edges = data.boundary();
            let curves = [
                edges.p1().point(*u),
                edges.p2().point(*u),
                edges.q1().point(*v),
                edges.q2().point(*v),
            ];
            expect_equal(&curves, &[s(*u, zero), s(*u, one), s(zero, *v), s(one, *v)])?;
            has_cross_derivatives(&data, *u, *v)
        },
    );
}

/// **Partial derivatives of the blended patch.** The derivatives $S_u$ and $S_v$ of the blended patch are those that dual numbers carry through its
/// definition, with compatible twists and with Gregory's.
///
/// Course: A07, slide 12, Coons patches: continuity of the derivative along edges.
#[test]
fn bicubic_partials_agree_with_dual_numbers() {
    let name = "coons::bicubic_partials_agree_with_dual_numbers";
    let law = Law::new(name, suspects::library).on_cases(32);
    law.holds(
        twisted_places(),
        hard_twisted_places(),
        |(net, changes, u, v)| {
            partials_agree(&hermite_boundary(net), *u, *v)?;
            partials_agree(&with_other_twists(net, *changes), *u, *v)
        },
    );
}

/// The partial derivatives are those of dual numbers inside, and the given ones at a corner.
fn partials_agree(data: &ExactData, u: Exact, v: Exact) -> Verdict {
    let s_u = across(data, variable(u), constant(v));
    let s_v = across(data, constant(u), variable(v));
    expect_equal(&Some([s_u, s_v]), &bicubic_partials(data, u, v))?;
    let [zero, one] = [0, 1].map(Exact::from_i32);
    let edges = data.boundary();
    let at_b = [edges.p1().derivative(one), edges.q2().derivative(zero)];
    let got = bicubic_partials(data, one, zero).map_or([None; 2], |partials| partials.map(Some));
    expect_equal(&at_b, &got)
}

/// **Smooth neighbours.** Two bicubically blended patches that share an edge curve and the derivative across it join with a continuous
/// derivative: at each point of the edge both have the same $S$, $S_u$ and $S_v$. The twists at its ends are then shared as well, as the derivative of what is
/// shared; with Gregory's correction the other twists do not matter. The sharing is the condition: patches with the same curve and other slopes join without a gap only.
///
/// Course: A07, slide 12, Coons patches: continuity of the derivative along edges.
/// Erratum: The slide says that the bicubic patch "allows continuity of the derivative along the edges". It does so on a condition: the neighbours must share the edge curve and the derivative across it (and with it the twists at its ends).
#[test]
fn bicubic_patches_that_share_slopes_join_smoothly() {
    let name = "coons::bicubic_patches_that_share_slopes_join_smoothly";
    let law = Law::new(name, suspects::library).on_cases(32);
    law.holds(
        smooth_pairs(parameter()),
        smooth_pairs(hard_parameter()),
        |(below, above, u)| {
            let [below, above] = [below, above].map(hermite_boundary);
            let [zero, one] = [0, 1].map(Exact::from_i32);
            expect_equal(
                &bicubic_point(&below, *u, one),
                &bicubic_point(&above, *u, zero),
            )?;
            expect_equal(
                &bicubic_partials(&below, *u, one),
                &bicubic_partials(&above, *u, zero),
            )
        },
    );
}

/// Two nets of degree 4 of which the second continues the first in v: its first column is the other's last, its second column
/// lies as far behind as the other's last but one before.
fn smooth_pairs(
    parameters: impl Strategy<Value = Exact>,
) -> impl Strategy<Value = (Net, Net, Exact)> {
    (nets(4, 4), nets(4, 4), parameters).prop_map(|(below, mut above, u)| {
        for (low, high) in below.iter().zip(&mut above) {
            high[0] = low[4];
            high[1] = low[4].plus(low[4].minus(low[3]));
        }
        (below, above, u)
    })
}
