//! Floating point against arbitrary precision: every bound that the chapter states is derived here and tried on many inputs.

use std::cell::Cell;

use facette::algebra::Scalar;
use facette::coons::{
    BicubicPatch, Boundary, CoonsPatch, Corners, HermiteBoundary, bicubic_point, bilinear_partials,
    bilinear_point,
};
use facette::curve::{BezierCurve, Curve};
use facette::surface::Surface;
use glam::{DVec3, Vec3A};
use num_traits::{One, Zero};

use crate::common::law::{Law, Verdict, expect_at_most, expect_equal};
use crate::common::oracle::{big, big_point, largest_error};
use crate::suspects;
use crate::variants::HandWrittenPatch;
use exact_patch::{BicubicData, BilinearData, Point};
use float_inputs::{FloatPlace, FloatPoint, coordinates, float_places, hard_float_places};

mod exact_patch;
mod float_inputs;

/// A bound on an error, with the largest part of it that was used up.
#[derive(Default)]
struct Bound {
    used: Cell<f64>,
}

impl Bound {
    /// Passes where each coordinate of `computed` is within `u · Σ factor · M`, one factor for each list of `data`, `M` the
    /// largest value of that coordinate in the list.
    fn holds<P: FloatPoint>(&self, computed: P, exact: &Point, data: &[(f64, &[P])]) -> Verdict {
        let roundoff: f64 = P::Scalar::unit_roundoff().into();
        for (axis, exact) in exact.iter().enumerate() {
            let size = |point: &P| coordinates(*point)[axis].abs();
            let part = |(factor, points): &(f64, &[P])| {
                factor * points.iter().map(size).fold(0.0, f64::max)
            };
            let bound = roundoff * data.iter().map(part).sum::<f64>();
            let bound = if bound > 0.0 {
                bound
            } else {
                f64::MIN_POSITIVE
            };
            let used = largest_error(
                [coordinates(computed)[axis]],
                std::array::from_ref(exact),
                bound,
            );
            self.used.set(self.used.get().max(used));
            expect_at_most("an error, as a part of its bound,", 1.0, used)?;
        }
        Ok(())
    }

    /// Passes where at least the given part of the bound was used up.
    fn is_used_up_to(&self, part: f64) {
        let used = self.used.get();
        println!("largest error seen: {used:.3} of its bound");
        assert!(
            used >= part,
            "the largest error seen is only {used} of its bound"
        );
    }
}

fn exact<P: FloatPoint>(point: P) -> Point {
    big_point(coordinates(point))
}

fn exact_parameters<P: FloatPoint>(place: &FloatPlace) -> [crate::common::oracle::Big; 2] {
    place
        .parameters::<P>()
        .map(|parameter| big(parameter.into()))
}

fn edges<C: Curve>(boundary: &Boundary<C>) -> [&C; 4] {
    [boundary.p1(), boundary.p2(), boundary.q1(), boundary.q2()]
}

fn corners<C: Curve>(boundary: &Boundary<C>) -> [C::Point; 4] {
    let Corners { a, b, c, d } = boundary.corners();
    [a, b, c, d]
}

/// **The error of a point.** In floating point with the unit roundoff $\mathbf u$, each coordinate of $S(u,v)$ is within $16\mathbf u\cdot M$ of
/// the exact patch of the computed curve points, for parameters in $[0,1]$; $M$ is the largest absolute value of that coordinate among the
/// four curve points and the four corners.
///
/// An interpolation $(1-t)a+tb$ rounds $1-t$, two products and the sum: at most $(1-t)\cdot2\mathbf u+t\cdot\mathbf u+\mathbf u\le3\mathbf u$ times $M$. So $S_1$
/// and $S_2$ are within $3\mathbf u\cdot M$ and $S_3$, two interpolations deep, within $6\mathbf u\cdot M$. The compensated sum rounds once, by
/// $\mathbf u\lvert S\rvert\le3\mathbf u\cdot M$; what it neglects is of the order $\mathbf u^2$. Together $15\mathbf u\cdot M$, and one more for all terms in $\mathbf u^2$.
#[test]
fn point_error_stays_below_its_bound() {
    let bounds = [Bound::default(), Bound::default()];
    let law = Law::new(
        "coons::point_error_stays_below_its_bound",
        suspects::library,
    );
    law.holds(float_places(), hard_float_places(), |place| {
        point_error::<[f64; 3]>(place, &bounds[0])?;
        point_error::<[f32; 3]>(place, &bounds[1])
    });
    for bound in &bounds {
        bound.is_used_up_to(0.05);
    }
}

fn point_error<P: FloatPoint>(place: &FloatPlace, bound: &Bound) -> Verdict {
    let boundary = place.boundary::<P>();
    let [u, v] = place.parameters::<P>();
    let computed = bilinear_point(&boundary, u, v);
    let (data, points) = bilinear_data(&boundary, [u, v]);
    let [u, v] = exact_parameters::<P>(place);
    let exact = exact_patch::bilinear(&data, &u, &v);
    bound.holds(computed, &exact, &[(16.0, &points)])
}

/// The computed points on the edges and the corners, without rounding and as they are.
fn bilinear_data<P: FloatPoint>(
    boundary: &Boundary<BezierCurve<P>>,
    [u, v]: [P::Scalar; 2],
) -> (BilinearData, [P; 8]) {
    let [p1, p2, q1, q2] = edges(boundary);
    let edge_points = [p1.point(u), p2.point(u), q1.point(v), q2.point(v)];
    let corners = corners(boundary);
    let data = BilinearData {
        edge_points: edge_points.map(exact),
        corners: corners.map(exact),
    };
    let all = [edge_points, corners].concat();
    (data, std::array::from_fn(|index| all[index]))
}

/// **The error of the partial derivatives.** Each coordinate of $S_u$ and of $S_v$ is within $19\mathbf u\cdot M$ of the exact derivatives
/// of the patch with the computed points and derivatives on its edges, for parameters in $[0,1]$; $M$ is the largest absolute value of that
/// coordinate among those points and derivatives and the corners.
///
/// In $S_u=\bigl[(1-v)P_1'+vP_2'\bigr]+\bigl[Q_2-Q_1\bigr]-\bigl[(1-v)(B-A)+v(C-D)\bigr]$ the first bracket is within $3\mathbf u\cdot M$, the
/// second, of size $2M$, within $2\mathbf u\cdot M$; the third interpolates differences of size $2M$ with an error of $2\mathbf u\cdot M$ each:
/// $2\mathbf u\cdot M+3\mathbf u\cdot2M=8\mathbf u\cdot M$. The sum rounds by $\mathbf u\lvert S_u\rvert\le5\mathbf u\cdot M$. Together $18\mathbf u\cdot M$, and one more for all terms
/// in $\mathbf u^2$.
#[test]
fn partials_error_stays_below_its_bound() {
    let bounds = [Bound::default(), Bound::default()];
    let law = Law::new(
        "coons::partials_error_stays_below_its_bound",
        suspects::library,
    );
    law.holds(float_places(), hard_float_places(), |place| {
        partials_error::<[f64; 3]>(place, &bounds[0])?;
        partials_error::<[f32; 3]>(place, &bounds[1])
    });
    for bound in &bounds {
        bound.is_used_up_to(0.05);
    }
}

fn partials_error<P: FloatPoint>(place: &FloatPlace, bound: &Bound) -> Verdict {
    let boundary = place.boundary::<P>();
    let [u, v] = place.parameters::<P>();
    let computed = bilinear_partials(&boundary, u, v).expect("Bézier curves have derivatives");
    let (data, points) = bilinear_data(&boundary, [u, v]);
    let at = [u, u, v, v];
    let derivatives: [P; 4] = std::array::from_fn(|index| {
        let derivative = edges(&boundary)[index].derivative(at[index]);
        derivative.expect("a Bézier curve has one")
    });
    let [u, v] = exact_parameters::<P>(place);
    let exact_partials = exact_patch::partials(&data, &derivatives.map(exact), &u, &v);
    let all = [&points[..], &derivatives].concat();
    for (computed, exact) in computed.into_iter().zip(&exact_partials) {
        bound.holds(computed, exact, &[(19.0, &all)])?;
    }
    Ok(())
}

/// **The error of the bicubic patch.** Each coordinate of a point of the bicubically blended patch is within
/// $\mathbf u\,(40M_0+13M_1+2M_2)$ of the exact patch of the computed curve points and corner vectors, for parameters in $[0,1]$. $M_0$ is
/// the largest absolute value of that coordinate among points (of the edges, and the corners), $M_1$ among slopes (of the cross
/// derivatives, and the tangents at the corners), $M_2$ among the twists of both families.
///
/// The four cubics are computed with 5, 4, 3 and 3 roundings, their products with one more each, and the sum from the left adds 3,
/// 3, 2 and 1. So a combination errs by $f_0=9h_0+5h_3\le9$ for the points in it, whose weights add up to 1, and by
/// $f_1=8h_1+6\lvert h_2\rvert\le1.76$ for the slopes, whose weights add up to $g=t(1-t)\le\tfrac14$.
///
/// - *Points.* $S_1$, $S_2$ and the two combinations inside $S_3$: $4\cdot9$, and $3$ for the rounding of the sum: $39$.
/// - *Slopes.* $S_1$ and $S_2$: $2\cdot1.76$. In $S_3$, $2\cdot(f_1\cdot1+g\,f_0)\le2\cdot4.01$. The sum: 1. Together $12.6$.
/// - *Twists.* $f_1g+g\,f_1\le0.88$; Gregory's mean errs by 11 itself, with weights of $\tfrac1{16}$: $0.69$; the sum: $\tfrac1{16}$.
///   Together $1.7$.
///
/// The rest of each number is for the terms in $\mathbf u^2$. The errors seen are about a thirtieth of this bound: it adds up more than
/// fifty roundings as if all had the same sign, and they have not.
#[test]
fn bicubic_error_stays_below_its_bound() {
    let bounds = [Bound::default(), Bound::default()];
    let law = Law::new(
        "coons::bicubic_error_stays_below_its_bound",
        suspects::library,
    );
    let law = law.on_cases(128);
    law.holds(float_places(), hard_float_places(), |place| {
        bicubic_error::<[f64; 3]>(place, &bounds[0])?;
        bicubic_error::<[f32; 3]>(place, &bounds[1])
    });
    for bound in &bounds {
        bound.is_used_up_to(0.02);
    }
}

fn bicubic_error<P: FloatPoint>(place: &FloatPlace, bound: &Bound) -> Verdict {
    let hermite = place.hermite::<P>();
    let [u, v] = place.parameters::<P>();
    let computed = bicubic_point(&hermite, u, v);
    let (data, [points, slopes, twists]) = bicubic_data(&hermite, [u, v]);
    let [u, v] = exact_parameters::<P>(place);
    let sizes = [(40.0, &points[..]), (13.0, &slopes), (2.0, &twists)];
    bound.holds(computed, &exact_patch::bicubic(&data, &u, &v), &sizes)
}

/// The computed values of all curves and corner vectors: without rounding, and as they are: points, slopes, twists.
fn bicubic_data<P: FloatPoint>(
    hermite: &HermiteBoundary<BezierCurve<P>>,
    [u, v]: [P::Scalar; 2],
) -> (BicubicData, [Vec<P>; 3]) {
    let [p1, p2, q1, q2] = edges(hermite.boundary());
    let cross = [
        hermite.p1_v(),
        hermite.p2_v(),
        hermite.q1_u(),
        hermite.q2_u(),
    ];
    let [p1_v, p2_v, q1_u, q2_u] = cross;
    let along_u = [p1, p1_v, p2_v, p2].map(|curve| curve.point(u));
    let along_v = [q1, q1_u, q2_u, q2].map(|curve| curve.point(v));
    let vectors = hermite.corner_vectors(u, v);
    let [[p_a, p_b], [p_d, p_c], [q_a, q_d], [q_b, q_c]] = cross.map(|curve| {
        [0, 1].map(|end| {
            let derivative = curve.derivative(P::Scalar::from_i32(end));
            derivative.expect("a Bézier curve has one")
        })
    });
    let [from_p, from_q] = [[p_a, p_b, p_c, p_d], [q_a, q_b, q_c, q_d]];
    let data = BicubicData {
        along_u: along_u.map(exact),
        along_v: along_v.map(exact),
        vectors: vectors.map(|row| row.map(exact)),
        twists_from_p: from_p.map(exact),
        twists_from_q: from_q.map(exact),
    };
    let [
        [a, a_v, d_v, d],
        [a_u, .., d_u],
        [b_u, .., c_u],
        [b, b_v, c_v, c],
    ] = vectors;
    let ends = [0, 3].map(|index| [along_u[index], along_v[index]]);
    let points = [ends.concat(), vec![a, b, c, d]].concat();
    let between = [1, 2].map(|index| [along_u[index], along_v[index]]);
    let tangents = vec![a_u, b_u, c_u, d_u, a_v, b_v, c_v, d_v];
    let slopes = [between.concat(), tangents].concat();
    (data, [points, slopes, [from_p, from_q].concat()])
}

/// **Exact edges in floating point.** Where the curves meet exactly, the patch carries them without any rounding error, bilinear
/// or bicubic, in `f32` and in `f64`, at any distance from the origin and of any size that does not overflow: the computed
/// $S(u,0)$ equals the computed $P_1(u)$, and so on all four edges. Neighbours that share a curve leave no crack.
///
/// On an edge two of the three terms are the same number, since a weight of 1 or 0 rounds nothing: say $S_2=S_3=b$, and $S_1=a$ is
/// the curve's point. Left to right, the rounded $(a+b)-b$ has lost what the first sum rounded away. The compensated sum
/// keeps it: the rounded sum $s$ with its error, $s+e_1=a+b$, then the rounded difference $d$ with its, $d+e_2=s-b$, both without error, so that $d+(e_1+e_2)=a$. Here
/// $e_1+e_2=a-d$ needs no rounding. Where $\lvert a\rvert\le\lvert b\rvert$, already $s-b$ is a floating-point number, and $e_2=0$.
/// Otherwise $d$ is within a factor of 2 of $a$, and the difference of two such numbers is a floating-point number (Sterbenz's
/// lemma). The last sum therefore gives $a$.
///
/// Course: A03, slide 10, Coons patches: the patch carries its four curves.
#[test]
fn edges_are_exact_in_floating_point() {
    let law = Law::new(
        "coons::edges_are_exact_in_floating_point",
        suspects::bilinear,
    );
    let law = law.on_cases(256);
    law.holds(float_places(), hard_float_places(), |place| {
        edges_are_exact::<[f32; 3]>(place)?;
        edges_are_exact::<[f64; 3]>(place)?;
        edges_are_exact::<Vec3A>(place)?;
        edges_are_exact::<DVec3>(place)
    });
}

fn edges_are_exact<P: FloatPoint>(place: &FloatPlace) -> Verdict {
    let hermite = place.hermite::<P>();
    let bilinear = CoonsPatch::new(hermite.boundary().clone());
    let bicubic = BicubicPatch::new(hermite);
    let [u, v] = place.parameters::<P>();
    carries_its_edges(bilinear.boundary(), [u, v], |u, v| bilinear.point(u, v))?;
    carries_its_edges(bicubic.data().boundary(), [u, v], |u, v| {
        bicubic.point(u, v)
    })
}

fn carries_its_edges<P: FloatPoint>(
    boundary: &Boundary<BezierCurve<P>>,
    [u, v]: [P::Scalar; 2],
    patch: impl Fn(P::Scalar, P::Scalar) -> P,
) -> Verdict {
    let [zero, one] = [P::Scalar::zero(), P::Scalar::one()];
    let [p1, p2, q1, q2] = edges(boundary);
    let curves = [p1.point(u), p2.point(u), q1.point(v), q2.point(v)];
    let on_patch = [patch(u, zero), patch(u, one), patch(zero, v), patch(one, v)];
    expect_equal(&curves, &on_patch)
}

/// **Exact tangents along the edges.** By the same argument the derivative along an edge is the edge curve's own, without any rounding error: $S_u(u,0)$ equals the computed
/// $P_1'(u)$, and so on all four edges, on the bilinear and on the bicubically blended patch.
#[test]
fn tangents_along_the_edges_are_exact_in_floating_point() {
    let name = "coons::tangents_along_the_edges_are_exact_in_floating_point";
    Law::new(name, suspects::library).on_cases(256).holds(
        float_places(),
        hard_float_places(),
        |place| {
            tangents_are_exact::<[f64; 3]>(place)?;
            tangents_are_exact::<[f32; 3]>(place)
        },
    );
}

fn tangents_are_exact<P: FloatPoint>(place: &FloatPlace) -> Verdict {
    let data = place.hermite::<P>();
    let bilinear = CoonsPatch::new(data.boundary().clone());
    let bicubic = BicubicPatch::new(data);
    let [u, v] = place.parameters::<P>();
    let [zero, one] = [0, 1].map(P::Scalar::from_i32);
    let [p1, p2, q1, q2] = edges(bilinear.boundary());
    let curves = [
        p1.derivative(u),
        p2.derivative(u),
        q1.derivative(v),
        q2.derivative(v),
    ];
    let along = |surface: &dyn Fn(P::Scalar, P::Scalar) -> Option<[P; 2]>| {
        let [s_u, s_v] = [[[u, zero], [u, one]], [[zero, v], [one, v]]];
        let along_u = s_u.map(|[u, v]| surface(u, v).map(|partials| partials[0]));
        let along_v = s_v.map(|[u, v]| surface(u, v).map(|partials| partials[1]));
        [along_u[0], along_u[1], along_v[0], along_v[1]]
    };
    expect_equal(&curves, &along(&|u, v| bilinear.partials(u, v)))?;
    expect_equal(&curves, &along(&|u, v| bicubic.partials(u, v)))
}

/// **A grid has the same bits.** Whether a point comes alone or with a whole grid, where each curve is evaluated once a row or
/// column, it is the same number to the last bit, for arrays and for the vector types of `glam`.
#[test]
fn grid_gives_the_same_bits_as_points() {
    let law = Law::new(
        "coons::grid_gives_the_same_bits_as_points",
        suspects::library,
    );
    law.holds(float_places(), hard_float_places(), |place| {
        grid_is_points::<[f32; 3]>(place)?;
        grid_is_points::<[f64; 3]>(place)?;
        grid_is_points::<Vec3A>(place)?;
        grid_is_points::<DVec3>(place)
    });
}

/// Compares a grid of 4 by 3 parameters, some outside [0, 1], with its points.
fn grid_is_points<P: FloatPoint>(place: &FloatPlace) -> Verdict {
    let patch = CoonsPatch::new(place.boundary::<P>());
    let [u, v] = place.parameters::<P>();
    let [us, vs] = [
        [P::Scalar::zero(), u, v, u + P::Scalar::one()],
        [v, P::Scalar::one(), u, -v],
    ];
    let vs = &vs[..3];
    let mut grid = [P::origin(); 12];
    patch.points_on_grid(&us, vs, &mut grid);
    let points = vs.iter().flat_map(|&v| us.map(|u| patch.point(u, v)));
    let bits = |point: P| coordinates(point).map(f64::to_bits);
    let points: Vec<_> = points.map(bits).collect();
    expect_equal(&points, &grid.map(bits).to_vec())
}

/// **Type parameters change no bit.** The generic kernel over `[f64; 3]` and the same kernel written out by hand for `f64`, whose
/// speeds the report compares, give the same numbers, point by point and on a grid.
#[test]
fn hand_written_kernel_gives_the_same_bits() {
    let law = Law::new(
        "coons::hand_written_kernel_gives_the_same_bits",
        suspects::library,
    );
    law.holds(float_places(), hard_float_places(), |place| {
        let boundary = place.boundary::<[f64; 3]>();
        let by_hand = edges(&boundary).map(|edge| edge.control_points().to_vec());
        let by_hand = HandWrittenPatch::new(by_hand);
        let patch = CoonsPatch::new(boundary);
        let [u, v] = place.parameters;
        let bits = |point: [f64; 3]| point.map(f64::to_bits);
        expect_equal(&bits(patch.point(u, v)), &bits(by_hand.point(u, v)))?;
        let (us, vs) = ([u, v, 1.0], [v, 0.5]);
        let mut grids = [[[0.0; 3]; 6]; 2];
        patch.points_on_grid(&us, &vs, &mut grids[0]);
        by_hand.points_on_grid(&us, &vs, &mut grids[1]);
        let [generic, by_hand] = grids.map(|grid| grid.map(bits));
        expect_equal(&generic, &by_hand)
    });
}
