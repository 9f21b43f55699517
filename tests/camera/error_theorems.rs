//! Frames, rays and projections against arbitrary precision: each bound is derived here and tried on many inputs.

use facette::camera::{
    CameraFrame, look_at_axes, orthographic_ray, perspective_ray, project_orthographic,
    project_perspective,
};
use num_traits::{One, Signed, ToPrimitive, Zero};

use crate::common::bound::Bound;
use crate::common::law::{Broken, Law, Verdict, expect_at_most, expect_equal};
use crate::common::oracle::{Big, big, big_cross, big_dot, big_minus};
use crate::float_inputs::{FloatPoint, FloatView, hard_views, views};
use crate::suspects;

/// Tries a law over `f32` and over `f64`, and sees that a twentieth of each bound is used up.
macro_rules! holds_in_both {
    ($name:ident, $check:ident) => {
        let bounds = [Bound::default(), Bound::default()];
        let law = Law::new(concat!("camera::", stringify!($name)), suspects::library);
        law.on_cases(512).holds(views(), hard_views(), |view| {
            $check::<[f32; 3]>(view, &bounds[0])?;
            $check::<[f64; 3]>(view, &bounds[1])
        });
        for bound in &bounds {
            bound.is_used_up_to(0.05);
        }
    };
}

fn largest(vector: &[Big; 3]) -> Big {
    vector
        .iter()
        .map(Signed::abs)
        .max()
        .expect("three coordinates")
}

fn data<P: FloatPoint>(view: &FloatView) -> [P; 3] {
    [view.eye, view.target, view.up].map(P::rounded)
}

/// The largest of the terms `|a_j b_k| + |a_k b_j|` of a vector product.
fn largest_term(a: &[Big; 3], b: &[Big; 3]) -> Big {
    let term = |j: usize, k: usize| (&a[j] * &b[k]).abs() + (&a[k] * &b[j]).abs();
    largest(&[term(1, 2), term(2, 0), term(0, 1)])
}

/// **Orthonormal within 20 roundoffs.** The six scalar products of the computed axes are within $20\varepsilon$ of 0 and 1, in `f32` and `f64`, for an eye and target of any size that does not
/// overflow, and however near to the view up may be. Where a frame is refused, up and the view are parallel up to $40\varepsilon$.
///
/// A normalised vector has a length within $3.5\varepsilon$ of 1: $\mathbf w\cdot\mathbf w$ and $\mathbf u\cdot\mathbf u$ are within $7\varepsilon$. The first $\mathbf u'$ leans towards $\mathbf w$ by
/// $\lvert\mathbf u'\cdot\mathbf w\rvert=k\le\tfrac18$, since at least $32\varepsilon$ of its product are known and the product itself rounds by $2\varepsilon$ of its largest term. Taking $k\mathbf w$ away leaves
/// $3\varepsilon$ from the computed $k$, $7\varepsilon\,k$ from the length of $\mathbf w$, and $\varepsilon(1+k)$ from product and difference: $5\varepsilon$; normalised once more, with $2\varepsilon$ for the two divisions, at most $8\varepsilon$.
/// The product $\mathbf v=\mathbf w\times\mathbf u$ rounds by $2\sqrt2\,\varepsilon$ and has the length of its factors: $\mathbf v\cdot\mathbf v$ is within $14\varepsilon+4\sqrt2\,\varepsilon<20\varepsilon$ of 1, and $\mathbf v$ within $3\varepsilon$ of being
/// perpendicular to both.
#[test]
fn frame_is_orthonormal_within_its_bound() {
    holds_in_both!(frame_is_orthonormal_within_its_bound, orthonormality);
}

fn orthonormality<P: FloatPoint>(view: &FloatView, bound: &Bound) -> Verdict {
    let [eye, target, up] = data::<P>(view);
    let Some(axes) = look_at_axes(eye, target, up) else {
        return refusal_is_justified(eye, target, up);
    };
    let axes = axes.map(FloatPoint::big);
    let allowed = big(20.0 * P::roundoff());
    for (i, a) in axes.iter().enumerate() {
        for (j, b) in axes.iter().enumerate() {
            let expected = if i == j { Big::one() } else { Big::zero() };
            bound.holds_error(&(big_dot(a, b) - expected), &allowed)?;
        }
    }
    expect_equal(
        &true,
        &big_dot(&big_cross(&axes[0], &axes[1]), &axes[2]).is_positive(),
    )
}

/// A refused frame has no view, no up, or a product `up × (e − c)` that is at most 40u of its largest term: 32u by the test, 8u by its error.
fn refusal_is_justified<P: FloatPoint>(eye: P, target: P, up: P) -> Verdict {
    let back = big_minus(&eye.big(), &target.big());
    let up = up.big();
    let product = largest(&big_cross(&up, &back));
    let allowed = big(40.0 * P::roundoff()) * largest_term(&up, &back);
    expect_equal(&true, &(product <= allowed))
}

/// **How far the image turns.** The axis $\mathbf w$ is within $6\varepsilon$ of its exact value, coordinate by coordinate relatively. The sine of the angle between the computed axis $\mathbf u$ and the exact one is at most
/// $\bigl(8\sqrt3\,\frac m{\lVert\mathbf c\rVert}+12\bigr)\varepsilon$, where $\mathbf c=\mathbf{up}\times(\mathbf e-\mathbf c_0)$ is the exact product with the view and $m$ the largest of its terms
/// $\lvert a_jb_k\rvert+\lvert a_kb_j\rvert$. The quotient is about $1/\sin\varphi$ for an angle $\varphi$ between up and the view: the smaller $\varphi$, the farther the image turns about its middle. That is not the fault of the
/// formula; rounding the data does the same. But for an up along a coordinate axis the quotient stays near 1, as near to the view as it may be.
///
/// The difference $\mathbf e-\mathbf c_0$ rounds by $\varepsilon$, its normalisation by $5\varepsilon$. In the product, each coordinate carries $2\varepsilon$ of up and $3\varepsilon$ of $\mathbf w$ (the common factor does not turn it), $1\varepsilon$ of the products
/// and $1\varepsilon$ of the difference, so at most $8\varepsilon$ of its term, and the vector $8\sqrt3\,\varepsilon\,m$. To that come $2\varepsilon$ from each normalisation, $5\varepsilon$ from the second orthogonalisation and $3\varepsilon$ since it is to the computed
/// $\mathbf w$.
#[test]
fn right_axis_turns_no_more_than_its_bound() {
    holds_in_both!(right_axis_turns_no_more_than_its_bound, turning);
}

fn turning<P: FloatPoint>(view: &FloatView, bound: &Bound) -> Verdict {
    let [eye, target, up] = data::<P>(view);
    let Some([u, _, w]) = look_at_axes(eye, target, up) else {
        return refusal_is_justified(eye, target, up);
    };
    let back = big_minus(&eye.big(), &target.big());
    let up = up.big();
    backwards_axis(&w.exact(), &back, P::roundoff())?;
    let (u, product) = (u.big(), big_cross(&up, &back));
    let beside = big_cross(&u, &product);
    let squared = |vector: &[Big; 3]| big_dot(vector, vector);
    let sine_squared = squared(&beside) / (squared(&u) * squared(&product));
    let root = |square: Big| square.to_f64().unwrap_or(f64::INFINITY).sqrt();
    let term = largest_term(&up, &back);
    let quotient = root(&term * &term / squared(&product));
    let allowed = (8.0 * 3_f64.sqrt() * quotient + 12.0) * P::roundoff();
    bound.holds_error(&big(root(sine_squared)), &big(allowed))
}

/// Each coordinate of w that is a normal number, squared, is within (1 + 6u)² of its exact square.
fn backwards_axis(w: &[f64; 3], back: &[Big; 3], roundoff: f64) -> Verdict {
    let length_squared = big_dot(back, back);
    for (computed, exact) in w.iter().zip(back) {
        let square = exact * exact / &length_squared;
        if square.to_f64().unwrap_or(0.0) < f64::from(f32::MIN_POSITIVE) {
            continue;
        }
        let relative = (big(*computed) * big(*computed) - &square).abs() / square;
        let relative = relative.to_f64().unwrap_or(f64::INFINITY);
        let allowed = 12.0 * roundoff + 36.0 * roundoff * roundoff;
        expect_at_most("a relative error of a square of w", allowed, relative)?;
    }
    Ok(())
}

/// The frame of a view that has one.
fn frame<P: FloatPoint>(view: &FloatView) -> Option<CameraFrame<P>> {
    let [eye, target, up] = data::<P>(view);
    CameraFrame::looking_at(eye, target, up)
        .or_else(|_| CameraFrame::looking_at_with_any_up(eye, target))
        .ok()
}

/// **The error of a ray.** For the frame as it is stored, each coordinate of a perspective direction is within $3\varepsilon\,(\lvert u\,\mathbf u_k\rvert+\lvert v\,\mathbf v_k\rvert+\lvert D\,\mathbf w_k\rvert)$ of its exact
/// value, however far away the eye may be, and each coordinate of an orthographic origin within $3\varepsilon\,(\lvert\mathbf e_k\rvert+\lvert u\,\mathbf u_k\rvert+\lvert v\,\mathbf v_k\rvert)$.
///
/// Three products round by $\varepsilon$ each of themselves, and go through one or two sums that round by $\varepsilon$ of what they have added so far. The eye takes no part in the direction; an orthographic origin near a far eye cannot be better
/// than the spacing of the numbers there.
#[test]
fn ray_error_stays_below_its_bound() {
    holds_in_both!(ray_error_stays_below_its_bound, ray_error);
}

fn ray_error<P: FloatPoint>(view: &FloatView, bound: &Bound) -> Verdict {
    let frame = frame::<P>(view).ok_or(no_frame())?;
    let place = view.place.map(P::number);
    let distance = P::number(view.distance);
    let [u, v, w] = frame.axes().map(FloatPoint::big);
    let [x, y] = place.map(|number| big(number.into()));
    let z = big(distance.into());
    let eye = frame.eye().big();
    let direction = perspective_ray(&frame, distance, place).direction.big();
    let origin = orthographic_ray(&frame, place).origin.big();
    for k in 0..3 {
        let [across, up, back] = [&x * &u[k], &y * &v[k], &z * &w[k]];
        let slack = big(P::SMALLEST) * big(4.0);
        let allowed = |sum: Big| big(3.0 * P::roundoff()) * sum + &slack;
        let size = across.abs() + up.abs();
        bound.holds_error(
            &(&direction[k] - (&across + &up - &back)),
            &allowed(&size + back.abs()),
        )?;
        bound.holds_error(
            &(&origin[k] - (&across + &up + &eye[k])),
            &allowed(&size + eye[k].abs()),
        )?;
    }
    Ok(())
}

fn no_frame() -> Broken {
    Broken {
        expected: "a frame".to_owned(),
        got: "None".to_owned(),
    }
}

/// **The error of a projection.** With the exact coordinates $(x,y,-z)$ of the point in the frame as it is stored, and $\delta_a=4\varepsilon\sum_k\lvert\mathbf a_k\rvert\,\lvert p_k-e_k\rvert$ for an axis $\mathbf a$, the
/// orthographic place is within $\delta_u$ and $\delta_v$, and the perspective $u$ within
/// $$D\,\frac{\delta_u+\delta_w\lvert x/z\rvert}{z-\delta_w}+3\varepsilon\,\lvert u\rvert,$$
/// if $z>\delta_w$. Nearer to the plane of the eye, not even the sign of the depth is known.
///
/// A coordinate is a sum of three products of a difference: four roundings on each. The quotient of two numbers that are off by $\delta_u$ and $\delta_w$ is off by as much as the fraction says, and rounds twice.
#[test]
fn projection_error_stays_below_its_bound() {
    holds_in_both!(projection_error_stays_below_its_bound, projection_error);
}

fn projection_error<P: FloatPoint>(view: &FloatView, bound: &Bound) -> Verdict {
    let frame = frame::<P>(view).ok_or(no_frame())?;
    let (point, distance) = (P::rounded(view.point), P::number(view.distance));
    let from_eye = big_minus(&point.big(), &frame.eye().big());
    let axes = frame.axes().map(FloatPoint::big);
    let [x, y, behind] = axes.each_ref().map(|axis| big_dot(&from_eye, axis));
    let delta = axes.each_ref().map(|axis| {
        let size = (0..3).map(|k| (&axis[k] * &from_eye[k]).abs());
        let size = size.fold(Big::zero(), |sum, term| sum + term);
        big(4.0 * P::roundoff()) * size + big(P::SMALLEST) * big(4.0)
    });
    let flat = project_orthographic(&frame, point).map(|number| big(number.into()));
    bound.holds_error(&(&flat[0] - &x), &delta[0])?;
    bound.holds_error(&(&flat[1] - &y), &delta[1])?;
    let depth = -behind;
    let known = &depth - &delta[2];
    let image = project_perspective(&frame, distance, point);
    if !known.is_positive() {
        let is_behind = -&depth > delta[2];
        return expect_equal(&false, &(is_behind && image.is_some()));
    }
    let image = image.ok_or(Broken {
        expected: "an image".to_owned(),
        got: "None".to_owned(),
    })?;
    let distance = big(distance.into());
    for (computed, (exact, delta_a)) in image.into_iter().zip([(&x, &delta[0]), (&y, &delta[1])]) {
        let place = &distance * exact / &depth;
        let through = &distance * (delta_a + &delta[2] * (exact / &depth).abs()) / &known;
        let allowed = through + big(3.0 * P::roundoff()) * place.abs() + big(P::SMALLEST);
        bound.holds_error(&(big(computed.into()) - place), &allowed)?;
    }
    Ok(())
}
