//! A ray and a triangle in floating point, against exact rationals: signs, and the bounds of what `Triangle` gives.

use facette::algebra::Real;
use facette::intersection::triangle::{Triangle, robust};
use facette::intersection::{Hit, Intersect};
use num_traits::{One, Signed, ToPrimitive};

use crate::common::bound::Bound;
use crate::common::law::{Law, Verdict, expect_at_most, expect_equal};
use crate::common::oracle::{Big, big, big_dot, big_minus, big_point};
use crate::suspects;
use crate::triangle_floats::{
    ExactCrossing, FloatPlace, exact_normal, exact_point, exactly, float_places, hard_float_places,
};

fn on_places(theorem: &'static str, check: impl Fn(&FloatPlace) -> Verdict) {
    Law::new(theorem, suspects::library).on_cases(2000).holds(
        float_places(),
        hard_float_places(),
        check,
    );
}

/// Both types of number, each against the exact crossing of its own rounded inputs.
macro_rules! in_both_widths {
    ($place:expr, $check:ident $(, $bounds:expr)?) => {{
        $check::<f32>($place $(, &$bounds[0])?)?;
        $check::<f64>($place $(, &$bounds[1])?)
    }};
}

/// The hit, where exact arithmetic has one.
fn hit_and_crossing<S: Real>(place: &FloatPlace) -> Option<(Hit<[S; 3]>, ExactCrossing)> {
    let triangle = Triangle::new(place.corners::<S>()).expect("finite corners");
    let hit = triangle.intersect(&place.ray::<S>())?;
    Some((
        hit,
        exactly(&place.rounded::<S>()).expect("a hit is no parallel"),
    ))
}

/// **Exact signs.** Whatever finite numbers the triangle and the ray have, `robust` and `Triangle` find a hit if and only if exact arithmetic does, edges and corners
/// included, and on the same side.
///
/// The decision is a matter of signs. With $\mathbf A=\mathbf a-\mathbf o$ and so on, $U=\mathbf d\cdot(\mathbf B\times\mathbf C)$, $V=\mathbf d\cdot(\mathbf C\times\mathbf A)$ and $W=\mathbf d\cdot(\mathbf A\times\mathbf B)$ are the
/// weights $u,v,w$ times $D=U+V+W=\mathbf d\cdot\mathbf n$: the ray hits if none has the sign opposite to another's, and $D\ne0$; and $t=T/D$ with $T=\mathbf A\cdot\mathbf n$. Each is computed with a bound on its own error; if the
/// bound reaches zero, it is computed again, in whole numbers so long that no product of three `f64` fails to fit.
#[test]
fn robust_test_decides_as_exact_arithmetic_does() {
    let theorem = "intersection::robust_test_decides_as_exact_arithmetic_does";
    on_places(theorem, |place| in_both_widths!(place, decides_exactly));
}

fn decides_exactly<S: Real>(place: &FloatPlace) -> Verdict {
    let crossing = exactly(&place.rounded::<S>()).filter(ExactCrossing::is_hit);
    let hit = robust(&place.corners::<S>(), &place.ray::<S>());
    expect_equal(
        &crossing.as_ref().map(|crossing| crossing.side),
        &hit.map(|hit| hit.side),
    )?;
    let triangle = Triangle::new(place.corners::<S>()).expect("finite corners");
    let hit = triangle.intersect(&place.ray::<S>());
    expect_equal(
        &crossing.map(|crossing| crossing.side),
        &hit.map(|hit| hit.side),
    )
}

/// **The error of t.** A hit of `Triangle` has a $t$ within `t_error` of the exact one, and `t_error` is at most $2^{-26}\lvert t\rvert$ in `f64`, $1.3\cdot2^{-24}\lvert t\rvert$ in `f32`.
///
/// $T$ and $D$ are products of three rounded differences each. No product suffers more than 8 roundings, so the error is at most $\gamma_8<9\mathbf u$ times the sum of the products' sizes, which is computed
/// beside it. $t=T/D$ has the sum of both relative errors. If one of them exceeds $2^{-28}$, the whole numbers take over, and leave three roundings: $4\mathbf u$.
#[test]
fn t_of_a_triangle_stays_within_its_bound() {
    let bounds = [Bound::default(), Bound::default()];
    on_places(
        "intersection::t_of_a_triangle_stays_within_its_bound",
        |place| in_both_widths!(place, t_is_within_its_bound, bounds),
    );
    for bound in &bounds {
        bound.is_used_up_to(0.05);
    }
}

fn t_is_within_its_bound<S: Real>(place: &FloatPlace, bound: &Bound) -> Verdict {
    let Some((hit, crossing)) = hit_and_crossing::<S>(place) else {
        return Ok(());
    };
    let (t, t_error) = (hit.t.to_f64(), hit.t_error.to_f64());
    let rounding = S::unit_roundoff().to_f64();
    let is_wide = rounding < f64::from(f32::EPSILON) / 4.0;
    let promised = if is_wide {
        2.0_f64.powi(-26)
    } else {
        1.3 * rounding
    };
    expect_at_most("a bound on t, as a part of t,", promised, t_error / t.abs())?;
    bound.holds(t, &crossing.t, t_error)
}

/// **The error of the coordinates.** The parameters of `robust`, the weights of $\mathbf b$ and $\mathbf c$, are within $2^{-18}$ of the exact ones, are not negative, and add up to $1+3\mathbf u$ at most.
///
/// The fast stage is trusted only where the bounds on the errors of $U$, $V$ and $W$ are below $2^{-20}$ of their sum. If $V$ is too large by $\delta$ and the others by $\epsilon$ together, then $V/(U+V+W)$ is too large by
/// $(1-v)\delta-v\epsilon$ over $D$, to first order: less than $2^{-20}(1+v)$. The bound is for the worst facet that is still computed fast; the errors seen are below $10^{-10}$, since the bounds on $U$, $V$ and $W$ are seldom used up.
#[test]
fn weights_of_a_triangle_stay_within_their_bound() {
    on_places(
        "intersection::weights_of_a_triangle_stay_within_their_bound",
        |place| in_both_widths!(place, weights_are_good),
    );
}

fn weights_are_good<S: Real>(place: &FloatPlace) -> Verdict {
    let Some((hit, crossing)) = hit_and_crossing::<S>(place) else {
        return Ok(());
    };
    let weights = hit
        .parameters
        .expect("a triangle has parameters")
        .map(Real::to_f64);
    for (computed, exact) in weights.into_iter().zip(&crossing.weights[1..]) {
        let error = (big(computed) - exact).abs().to_f64().expect("finite");
        expect_at_most("an error of a weight", 2.0_f64.powi(-18), error)?;
    }
    let is_convex = weights.iter().all(|&weight| weight >= 0.0);
    expect_equal(&true, &is_convex)?;
    let excess = weights[0] + weights[1] - 1.0;
    expect_at_most(
        "an excess over 1",
        4.0 * S::unit_roundoff().to_f64(),
        excess,
    )
}

/// **The point is on the triangle.** The point of a hit is within `point_error` of a point of the triangle, in every coordinate: $\mathbf u\lvert x\rvert+7\mathbf u\,(v\lvert b-a\rvert+w\lvert c-a\rvert)$ in `f64`; in
/// `f32` the point is computed in `f64`, and rounded at the end.
///
/// It is computed as $\mathbf a+(v(\mathbf b-\mathbf a)+w(\mathbf c-\mathbf a))$ from the weights: whatever error those have moves it along the triangle. What is left are three roundings of the
/// terms in parentheses, $3\mathbf u$ more if $v+w$ exceeds 1 by that, and the rounding of the last sum. $\mathbf o+t\,\mathbf d$ instead would be wrong by $\mathbf u\,t\lvert\mathbf d\rvert$, which grows with the distance.
#[test]
fn point_lies_on_the_triangle_within_its_bound() {
    let bounds = [Bound::default(), Bound::default()];
    on_places(
        "intersection::point_lies_on_the_triangle_within_its_bound",
        |place| in_both_widths!(place, point_is_on_the_triangle, bounds),
    );
    for bound in &bounds {
        bound.is_used_up_to(0.05);
    }
}

fn point_is_on_the_triangle<S: Real>(place: &FloatPlace, bound: &Bound) -> Verdict {
    let place = place.rounded::<S>();
    let triangle = Triangle::new(place.corners::<S>()).expect("finite corners");
    let Some(hit) = triangle.intersect(&place.ray::<S>()) else {
        return Ok(());
    };
    // In `f32` the weights are rounded as well, but not those that the point was computed from: ask `f64` for them.
    let wide = Triangle::new(place.corners).expect("finite corners");
    let wide = wide
        .intersect(&place.ray())
        .expect("the same numbers, the same hit");
    let [v, w] = wide.parameters.expect("a triangle has parameters").map(big);
    let sum = (&v + &w).max(Big::one());
    let exact = exact_point(place.corners, &(v / &sum), &(w / &sum));
    for (computed, exact) in hit.point.into_iter().zip(&exact) {
        bound.holds(computed.to_f64(), exact, hit.point_error.to_f64())?;
    }
    Ok(())
}

/// **The error of the normal.** Every coordinate of the unit normal is within $2^{-23}$ of the exact one in `f64`, $2^{-22}$ in `f32`; on well-shaped triangles a few $\mathbf u$.
///
/// A coordinate of $(\mathbf b-\mathbf a)\times(\mathbf c-\mathbf a)$ has four roundings a product. If that may exceed $2^{-26}$ of the longest coordinate, the normal is computed in whole numbers. Dividing by the length adds
/// at most twice as much again, and five roundings.
#[test]
fn normal_of_a_triangle_stays_within_its_bound() {
    on_places(
        "intersection::normal_of_a_triangle_stays_within_its_bound",
        |place| in_both_widths!(place, normal_is_good),
    );
}

fn normal_is_good<S: Real>(place: &FloatPlace) -> Verdict {
    let Some((hit, _)) = hit_and_crossing::<S>(place) else {
        return Ok(());
    };
    let exact = exact_normal(place.rounded::<S>().corners);
    let largest = exact
        .iter()
        .map(Signed::abs)
        .max()
        .expect("three coordinates");
    // A number of three digits more than a float would lose nothing that counts at 2⁻²³.
    let scaled = exact.map(|x| (x / &largest).to_f64().expect("at most 1"));
    let length = scaled.iter().map(|x| x * x).sum::<f64>().sqrt();
    let bound = if S::unit_roundoff().to_f64() > f64::EPSILON {
        2.0_f64.powi(-22)
    } else {
        2.0_f64.powi(-23)
    };
    for (computed, exact) in hit.normal.into_iter().zip(scaled) {
        let error = (computed.to_f64() - exact / length).abs();
        expect_at_most("an error of the normal", bound, error)?;
    }
    Ok(())
}

/// The size of the error that an ordinary test may make in a weight, in units of u, and the exact weights.
fn condition(place: &FloatPlace) -> Option<(f64, ExactCrossing)> {
    let crossing = exactly(place)?;
    let size = |point: &[Big; 3]| {
        point
            .iter()
            .map(Signed::abs)
            .max()
            .expect("three coordinates")
    };
    let [a, b, c] = place.corners.map(big_point);
    let edges = [[&b, &a], [&c, &b], [&a, &c]].map(|[p, q]| size(&big_minus(p, q)));
    let edge = edges.into_iter().max().expect("three edges");
    let reach = [&a, &b, &c, &big_point(place.origin)]
        .map(size)
        .into_iter()
        .max()
        .expect("four points");
    let n = exact_normal(place.corners);
    let d = big_point(place.direction);
    let along = big_dot(&d, &n).abs();
    let length = d
        .iter()
        .fold(Big::from_integer(0.into()), |sum, x| sum + x.abs());
    let condition = length * reach * &edge * &edge * &edge / (along * size(&n));
    Some((condition.to_f64().unwrap_or(f64::INFINITY), crossing))
}

/// **Away from edges all tests agree.** Let $\kappa=\lVert\mathbf d\rVert_1\,R\,h^3/(\lvert D\rvert\,\lVert\mathbf n\rVert_\infty)$, with $R$ the largest coordinate of the corners and the origin, $h$ that of the edges, $D=\mathbf d\cdot\mathbf n$. If all
/// three weights of the exact crossing are at least $1000\,\mathbf u\,\kappa$, every test of the page finds the hit; if one is below $-1000\,\mathbf u\,\kappa$, none does. It holds in `f32` and in `f64`.
///
/// Möller and Trumbore's weights are quotients of products with at most 8 roundings, of sizes up to $4\lVert\mathbf d\rVert_1Rh$ over $\lvert D\rvert$: $90\,\mathbf u\,\kappa$ for the sum of two. Woop's corners err by $4\mathbf u$ of a length up to $2R$, and are
/// multiplied by one of up to $8h$. The half-planes get a point that errs by $190\,\mathbf u\,R\lVert\mathbf d\rVert_1h^2/\lvert D\rvert$, and turn it into a weight by $3.5h/\lVert\mathbf n\rVert$: $665\,\mathbf u\,\kappa$, and a third for
/// their own roundings. The stored planes have as many. What is seen is below $\mathbf u\,\kappa$: the longest of everything stands for everything in $\kappa$, and the four constants for the worst order of a hundred roundings.
#[test]
fn tests_agree_away_from_edges() {
    let law = Law::new(
        "intersection::tests_agree_away_from_edges",
        suspects::library,
    );
    law.on_cases(400)
        .holds(float_places(), hard_float_places(), |place| {
            in_both_widths!(place, agree_away_from_edges)
        });
}

fn agree_away_from_edges<S: Real>(place: &FloatPlace) -> Verdict {
    let place = place.rounded::<S>();
    let Some((condition, crossing)) = condition(&place) else {
        return Ok(());
    };
    let margin = 1000.0 * S::unit_roundoff().to_f64() * condition;
    let depth = crossing.weights.iter().min().expect("three weights");
    let depth = depth.to_f64().unwrap_or(f64::NEG_INFINITY);
    // The sign of t is another matter: the line is asked.
    let line = place.ray::<S>().after(-S::from_f64(1e30));
    if depth.abs() <= margin
        || crossing
            .weights
            .iter()
            .any(|weight| weight.abs() > big(4.0))
    {
        return Ok(());
    }
    for (name, test) in crate::triangle_inputs::closed_tests::<[S; 3]>() {
        let is_hit = test(&place.corners::<S>(), &line).is_some();
        expect_equal(&(name, depth > 0.0), &(name, is_hit))?;
    }
    Ok(())
}
