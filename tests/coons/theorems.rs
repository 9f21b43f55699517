//! The theorems of the bilinear Coons patch, in the order of the text. The book shows their doc comments.

use facette::algebra::{Scalar, VectorSpace};
use facette::coons::{Boundary, CoonsError, Corner, Corners, bilinear_point, ruled_surfaces};
use facette::curve::Curve;
use num_traits::{One, Zero};
use proptest::prelude::*;

use crate::common::exact::{Exact, fraction};
use crate::common::generators::{hard_parameter, parameter, point};
use crate::common::law::{Broken, Law, expect_equal};
use crate::inputs::{Place, Point, bezier, edges, hard_places, places};
use crate::suspects;

const ENDS: [i32; 2] = [0, 1];

/// **The boundary is checked.** Four curves bound a patch only if they meet:
/// $P_1(0)=A=Q_1(0)$, $P_1(1)=B=Q_2(0)$, $Q_2(1)=C=P_2(1)$, $Q_1(1)=D=P_2(0)$. Curves that miss each other by more than the
/// tolerance (zero for exact numbers) are refused, and the refusal names the corner, the gap and the tolerance.
///
/// Course: A01, slide 8, Coons patches: four curves that meet in four corners.
#[test]
fn boundary_that_does_not_meet_is_refused() {
    let gaps = (places(), 0..4_usize, 1..=5_i32);
    let hard = (hard_places(), 0..4_usize, Just(1));
    Law::new(
        "coons::boundary_that_does_not_meet_is_refused",
        suspects::library,
    )
    .holds(gaps, hard, |(place, which, sixths)| {
        let gap = fraction(*sixths, 6);
        let mut edges = place.edges.clone();
        let [q1, q2] = [2, 3];
        let (edge, at_end, corner) = [
            (q1, false, Corner::A),
            (q2, false, Corner::B),
            (q2, true, Corner::C),
            (q1, true, Corner::D),
        ][*which];
        let last = if at_end { edges[edge].len() - 1 } else { 0 };
        edges[edge][last][1] = edges[edge][last][1] + gap;
        let [p1, p2, q1, q2] = edges.map(|points| bezier(&points));
        match Boundary::new(p1, p2, q1, q2) {
            Err(CoonsError::DoNotMeet {
                corner: found,
                gap: measured,
                tolerance,
                ..
            }) => expect_equal(&(corner, gap, Exact::zero()), &(found, measured, tolerance)),
            other => Err(Broken {
                expected: format!("a refusal of corner {corner}, gap {gap:?}"),
                got: format!("{other:?}"),
            }),
        }
    });
}

/// **Ruled surfaces.** $S_1$ carries $P_1$ and $P_2$, $S_2$ carries $Q_1$ and $Q_2$, and $S_3$ carries the four corners:
/// $S_1(u,0)=P_1(u)$, $S_1(u,1)=P_2(u)$, $S_2(0,v)=Q_1(v)$, $S_2(1,v)=Q_2(v)$. All three pass through $A,B,C,D$.
///
/// Course: A02, slide 9, Coons patches: three ruled surfaces by linear interpolation.
#[test]
fn ruled_surfaces_interpolate_two_opposite_edges() {
    let law = Law::new(
        "coons::ruled_surfaces_interpolate_two_opposite_edges",
        suspects::library,
    );
    law.holds(places(), hard_places(), |place| {
        let boundary = place.boundary();
        let [p1, p2, q1, q2] = place.edge_points();
        let [zero, one] = ENDS.map(Exact::from_i32);
        let s = |u, v| ruled_surfaces(&boundary, u, v);
        expect_equal(&[p1, p2], &[s(place.u, zero)[0], s(place.u, one)[0]])?;
        expect_equal(&[q1, q2], &[s(zero, place.v)[1], s(one, place.v)[1]])?;
        let corners = [s(zero, zero), s(one, zero), s(one, one), s(zero, one)];
        expect_equal(&place.corners().map(|corner| [corner; 3]), &corners)
    });
}

/// **Corners.** The patch passes through its four corners: $S(0,0)=A$, $S(1,0)=B$, $S(1,1)=C$, $S(0,1)=D$. Each corner is
/// counted by $S_1$ and by $S_2$, and taken away once by $S_3$.
///
/// Course: A04, slide 10, Coons patches: why S3 is subtracted.
/// Exercise: bilinear.
#[test]
fn patch_interpolates_its_four_corners() {
    let law = Law::new(
        "coons::patch_interpolates_its_four_corners",
        suspects::bilinear,
    );
    law.holds(places(), hard_places(), |place| {
        let boundary = place.boundary();
        let [zero, one] = ENDS.map(Exact::from_i32);
        let s = |u, v| bilinear_point(&boundary, u, v);
        let [a, b, c, d] = place.corners();
        let got = Corners {
            a: s(zero, zero),
            b: s(one, zero),
            c: s(one, one),
            d: s(zero, one),
        };
        expect_equal(&Corners { a, b, c, d }, &got)
    });
}

/// **The edges in u.** The patch carries the curves $P_1$ and $P_2$: $S(u,0)=P_1(u)$ and $S(u,1)=P_2(u)$ for every $u$.
///
/// Course: A03, slide 10, Coons patches: the patch carries its four curves.
/// Exercise: bilinear.
#[test]
fn patch_interpolates_p1_and_p2() {
    let law = Law::new("coons::patch_interpolates_p1_and_p2", suspects::bilinear);
    law.holds(places(), hard_places(), |place| {
        let boundary = place.boundary();
        let [p1, p2, ..] = place.edge_points();
        let edges = ENDS.map(|v| bilinear_point(&boundary, place.u, Exact::from_i32(v)));
        expect_equal(&[p1, p2], &edges)
    });
}

/// **The edges in v.** The patch carries the curves $Q_1$ and $Q_2$: $S(0,v)=Q_1(v)$ and $S(1,v)=Q_2(v)$ for every $v$.
///
/// Course: A03, slide 10, Coons patches: the patch carries its four curves.
/// Exercise: bilinear.
#[test]
fn patch_interpolates_q1_and_q2() {
    let law = Law::new("coons::patch_interpolates_q1_and_q2", suspects::bilinear);
    law.holds(places(), hard_places(), |place| {
        let boundary = place.boundary();
        let [_, _, q1, q2] = place.edge_points();
        let edges = ENDS.map(|u| bilinear_point(&boundary, Exact::from_i32(u), place.v));
        expect_equal(&[q1, q2], &edges)
    });
}

/// **The correction.** On the edge $v=0$ the sum of the ruled surfaces is $S_1+S_2=P_1(u)+\bigl[(1-u)A+uB\bigr]$: too much by
/// the chord of that edge, and likewise on the others. So a correction that repairs the sum must be the chord on every edge. The
/// bilinear surface $S_3$ of the corners is; and no other is among the surfaces
/// $k_0+k_1u+k_2v+k_3uv$, since the four corners fix the four coefficients.
///
/// Course: A04, slide 10, Coons patches: why S3 is subtracted.
/// Exercise: bilinear.
#[test]
fn bilinear_surface_of_the_corners_is_the_correction() {
    let law = Law::new(
        "coons::bilinear_surface_of_the_corners_is_the_correction",
        suspects::bilinear,
    );
    law.holds(places(), hard_places(), |place| {
        let boundary = place.boundary();
        let [u, v] = [place.u, place.v];
        let excess = |u, v| {
            let [s1, s2, _] = ruled_surfaces(&boundary, u, v);
            s1.plus(s2).minus(bilinear_point(&boundary, u, v))
        };
        let [a, b, c, d] = place.corners();
        let chords = [a.lerp(b, u), d.lerp(c, u), a.lerp(d, v), b.lerp(c, v)];
        let [zero, one] = ENDS.map(Exact::from_i32);
        let on_edges = [
            excess(u, zero),
            excess(u, one),
            excess(zero, v),
            excess(one, v),
        ];
        expect_equal(&chords, &on_edges)?;
        let twist = a.minus(b).plus(c).minus(d);
        let k = [a, b.minus(a), d.minus(a), twist];
        expect_equal(&Point::combination([one, u, v, u * v], k), &excess(u, v))
    });
}

/// **Straight edges.** Four straight edges, run through at constant speed, give the bilinear patch
/// $(1-u)(1-v)A+u(1-v)B+uvC+(1-u)vD$: then $S_1=S_2=S_3$.
///
/// Course: A02, slide 9, Coons patches: three ruled surfaces by linear interpolation.
/// Exercise: bilinear.
#[test]
fn straight_edges_give_the_bilinear_patch() {
    let corners = || [point(), point(), point(), point()];
    let law = Law::new(
        "coons::straight_edges_give_the_bilinear_patch",
        suspects::bilinear,
    );
    let hard = (corners(), hard_parameter(), hard_parameter());
    law.holds(
        (corners(), parameter(), parameter()),
        hard,
        |&(corners, u, v)| {
            let place = Place {
                edges: edges(corners, Default::default()),
                u,
                v,
            };
            let [s, t] = [u, v].map(|parameter| Exact::one() - parameter);
            let expected = Point::combination([s * t, u * t, u * v, s * v], corners);
            expect_equal(&expected, &bilinear_point(&place.boundary(), u, v))
        },
    );
}

/// **Precision set.** The patch reproduces every surface that is linear in $v$ along lines $u=$ const, every one that is linear
/// in $u$, and their sums: if $F(u,v)=a(u)+v\,b(u)+c(v)+u\,d(v)$ with any curves $a,b,c,d$, then the patch of the four edges of
/// $F$ is $F$.
///
/// So a patch shows what it can and cannot hold: the term $u^2v^2$ is the first that it loses.
///
/// Course: A03, slide 10, Coons patches: the patch carries its four curves.
/// Exercise: bilinear.
#[test]
fn patch_reproduces_sums_of_ruled_surfaces() {
    let quadratic = || [point(), point(), point()];
    let curves = || [quadratic(), quadratic(), quadratic(), quadratic()];
    let law = Law::new(
        "coons::patch_reproduces_sums_of_ruled_surfaces",
        suspects::bilinear,
    );
    let hard = (curves(), hard_parameter(), hard_parameter());
    law.holds(
        (curves(), parameter(), parameter()),
        hard,
        |(curves, u, v)| {
            let [a, b, c, d] = curves.each_ref().map(|points| bezier(points));
            let f = |u, v| {
                let in_u = a.point(u).plus(b.point(u).times(v));
                in_u.plus(c.point(v)).plus(d.point(v).times(u))
            };
            let edge = |start: &dyn Fn(Exact) -> Point| {
                let [p0, middle, p2] = [fraction(0, 1), fraction(1, 2), fraction(1, 1)].map(start);
                let twice = middle.times(fraction(2, 1));
                bezier(&[p0, twice.minus(p0.lerp(p2, fraction(1, 2))), p2])
            };
            let [zero, one] = ENDS.map(Exact::from_i32);
            let p = [zero, one].map(|v| edge(&|u| f(u, v)));
            let q = [zero, one].map(|u| edge(&|v| f(u, v)));
            let ([p1, p2], [q1, q2]) = (p, q);
            let boundary = Boundary::new(p1, p2, q1, q2).expect("edges of one surface meet");
            expect_equal(&f(*u, *v), &bilinear_point(&boundary, *u, *v))
        },
    );
}

/// **Affine invariance.** Moving the boundary by an affine map moves the patch by the same map: it makes no difference whether
/// curves are mapped before or points after.
///
/// Course: A03, slide 10, Coons patches: the patch carries its four curves.
/// Exercise: bilinear.
#[test]
fn patch_is_affinely_invariant() {
    let maps = || [point(), point(), point(), point()];
    let law = Law::new("coons::patch_is_affinely_invariant", suspects::bilinear);
    law.holds(
        (places(), maps()),
        (hard_places(), maps()),
        |(place, [x, y, z, shift])| {
            let map =
                |[px, py, pz]: Point| Point::combination([px, py, pz], [*x, *y, *z]).plus(*shift);
            let s = |place: &Place| bilinear_point(&place.boundary(), place.u, place.v);
            expect_equal(&map(s(place)), &s(&place.mapped(map)))
        },
    );
}

/// **Symmetry.** Exchanging the two families of curves exchanges the parameters and nothing else: the patch of
/// $Q_1,Q_2,P_1,P_2$ at $(v,u)$ is the patch of $P_1,P_2,Q_1,Q_2$ at $(u,v)$.
///
/// Course: A03, slide 10, Coons patches: the patch carries its four curves.
/// Exercise: bilinear.
#[test]
fn exchanging_the_families_exchanges_the_parameters() {
    let law = Law::new(
        "coons::exchanging_the_families_exchanges_the_parameters",
        suspects::bilinear,
    );
    law.holds(places(), hard_places(), |place| {
        let [p1, p2, q1, q2] = place.edges.clone();
        let exchanged = Place {
            edges: [q1, q2, p1, p2],
            u: place.v,
            v: place.u,
        };
        let s = |place: &Place| bilinear_point(&place.boundary(), place.u, place.v);
        expect_equal(&s(place), &s(&exchanged))
    });
}

/// **Outside the hull.** A bilinear patch may leave the convex hull of its boundary, since $S_3$ is subtracted. Take for $P_1$
/// and $P_2$ the arches $z=4u(1-u)$ over two opposite sides of the unit square and for $Q_1$ and $Q_2$ the arches $z=4v(1-v)$ over
/// the other two: no boundary point is higher than 1, but the middle of the patch is at height $1+1-0=2$.
///
/// Course: A05, slide 11, Coons patches: no control of the interior.
#[test]
fn patch_may_leave_the_convex_hull_of_its_boundary() {
    let at = |x, y, z| [x, y, z].map(Exact::from_i32);
    let half = fraction(1, 2);
    let middle = |x, y| vec![[x, y, fraction(2, 1)]];
    let [zero, one] = ENDS.map(Exact::from_i32);
    let corners = [at(0, 0, 0), at(1, 0, 0), at(1, 1, 0), at(0, 1, 0)];
    let inner = [
        middle(half, zero),
        middle(half, one),
        middle(zero, half),
        middle(one, half),
    ];
    let place = Place {
        edges: edges(corners, inner),
        u: half,
        v: half,
    };
    for sixteenth in 0..=16 {
        let parameter = fraction(sixteenth, 16);
        for point in place.at(parameter, parameter).edge_points() {
            assert!(
                point[2] <= one,
                "{point:?} on the boundary is higher than 1"
            );
        }
    }
    assert_eq!(
        bilinear_point(&place.boundary(), half, half),
        [half, half, fraction(2, 1)]
    );
}
