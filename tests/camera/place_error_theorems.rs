//! Places of pixels and the field of view against arbitrary precision: each bound is derived here and tried on many inputs.

use std::f64::consts::PI;

use facette::algebra::Scalar;
use facette::camera::{ImageRectangle, ImageSize, Pixel, half_extent, pixel_centre, pixel_sample};
use num_traits::{One, Signed, Zero};
use proptest::prelude::*;

use crate::common::bound::Bound;
use crate::common::law::{Law, Verdict, expect_equal};
use crate::common::oracle::{Big, big};
use crate::float_inputs::FloatPoint;
use crate::suspects;

/// A rectangle's side, a number of pixels, a pixel and a place inside it, in `f64`.
type Side = (f64, f64, u32, f64, f64);

fn sides() -> impl Strategy<Value = Side> {
    (
        -10.0..10.0_f64,
        0.1..10.0_f64,
        1..=4096_u32,
        0.0..1.0_f64,
        0.0..1.0_f64,
    )
}

/// Rectangles far to one side of the origin, tiny and huge, with one pixel or the largest number of them.
fn hard_sides() -> impl Strategy<Value = Side> {
    let side = prop::sample::select(vec![
        (1e7, 3.0),
        (-1e7, 1.0),
        (1e-30, 1e-30),
        (-1e30, 1.5e30),
        (0.1, 0.6),
        (-1.0, 2.0),
    ]);
    let count = prop::sample::select(vec![1, 3, 1920, ImageSize::LARGEST]);
    let part = || prop_oneof![Just(0.0), Just(1.0), 0.0..1.0_f64];
    (side, count, part(), part())
        .prop_map(|((low, extent), count, pixel, within)| (low, extent, count, pixel, within))
}

fn rectangle<P: FloatPoint>(low: f64, extent: f64) -> ImageRectangle<P::Scalar> {
    let [low, high] = [low, low + extent].map(P::number);
    ImageRectangle::new(low, high, low, high).expect("an extent")
}

/// **The error of a place.** In floating point, the $u$ of a pixel's centre is within $6\varepsilon\cdot M$ of its exact value, and that of any other place in the pixel within $8\varepsilon\cdot M$, with $M=\max(\lvert l\rvert,\lvert r\rvert)$; so is $v$.
///
/// The number $i+\tfrac12$ needs no rounding up to $2^{23}$ pixels; another $i+x$ rounds once, and both once in the quotient $s$. The interpolation $(1-s)\,l+s\,r$ turns that into
/// $\varepsilon\lvert r-l\rvert\le2\varepsilon\cdot M$ each, and rounds by $3\varepsilon\cdot M$ itself: 5, or 7, and one more for all terms in $\varepsilon^2$.
#[test]
fn pixel_place_error_stays_below_its_bound() {
    let bounds = [Bound::default(), Bound::default()];
    let name = "camera::pixel_place_error_stays_below_its_bound";
    let law = Law::new(name, suspects::library).on_cases(512);
    law.holds(sides(), hard_sides(), |side| {
        place_error::<[f32; 3]>(side, &bounds[0])?;
        place_error::<[f64; 3]>(side, &bounds[1])
    });
    for bound in &bounds {
        bound.is_used_up_to(0.05);
    }
}

fn pixel_of(count: u32, part: f64) -> u32 {
    #[allow(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "a part of a small number"
    )]
    let index = (f64::from(count) * part) as u32;
    index.min(count - 1)
}

fn place_error<P: FloatPoint>(
    &(low, extent, count, part, within): &Side,
    bound: &Bound,
) -> Verdict {
    let rectangle = rectangle::<P>(low, extent);
    let index = pixel_of(count, part);
    let size = ImageSize::new(count, count).expect("a pixel at least");
    let pixel = Pixel {
        column: index,
        row: index,
    };
    let within = P::number(within);
    let [l, r] = [rectangle.left(), rectangle.right()].map(|border| big(border.into()));
    let largest = l.abs().max(r.abs());
    let exact = |within: Big| {
        let across = (big(f64::from(index)) + within) / big(f64::from(count));
        &l + (&r - &l) * across
    };
    let centre = pixel_centre(&rectangle, size, pixel);
    let sample = pixel_sample(&rectangle, size, pixel, [within; 2]);
    for (roundoffs, exact, places) in [
        (6.0, exact(big(0.5)), centre),
        (8.0, exact(big(within.into())), sample),
    ] {
        let allowed = big(roundoffs * P::roundoff()) * &largest;
        for place in places {
            bound.holds_error(&(big(place.into()) - &exact), &allowed)?;
        }
    }
    Ok(())
}

/// **Borders without rounding.** In floating point too, the outer borders of the outer pixels are the borders of the rectangle, and neighbours share their border, both to the bit. So images that are computed in tiles of the
/// same size, or panoramas whose rectangles share a border, have no gap.
///
/// $i+1$ and $(i+1)+0$ are the same number. At the borders the quotient is 0 or 1, and the interpolation $(1-s)\,l+s\,r$ with a weight of 0 and a weight of 1 rounds nothing.
#[test]
fn borders_of_pixels_are_exact_in_floating_point() {
    let name = "camera::borders_of_pixels_are_exact_in_floating_point";
    let law = Law::new(name, suspects::library).on_cases(256);
    law.holds(sides(), hard_sides(), |side| {
        borders::<[f32; 3]>(side)?;
        borders::<[f64; 3]>(side)
    });
}

fn borders<P: FloatPoint>(&(low, extent, count, part, _): &Side) -> Verdict {
    let rectangle = rectangle::<P>(low, extent);
    let size = ImageSize::new(count, count).expect("a pixel at least");
    let [zero, one] = [0, 1].map(P::Scalar::from_i32);
    let sample = |index: u32, within| {
        let pixel = Pixel {
            column: index,
            row: index,
        };
        pixel_sample(&rectangle, size, pixel, [within; 2])
    };
    expect_equal(&[rectangle.left(), rectangle.bottom()], &sample(0, zero))?;
    expect_equal(
        &[rectangle.right(), rectangle.top()],
        &sample(count - 1, one),
    )?;
    let index = pixel_of(count, part);
    expect_equal(&sample(index, one), &sample(index + 1, zero))
}

/// **The error of the field of view.** The half extent $D\tan\tfrac\theta2$ has a relative error of at most $6\varepsilon$ for every angle strictly between 0 and $\pi$, if sine and cosine are within an ulp ($2\varepsilon$).
///
/// Half of the angle is exact; sine and cosine err by $2\varepsilon$ each, and the quotient and the product round. Near $\pi$ the result is as sensitive to the *given* angle as $\theta/\sin\theta$ says, but that error is in the data.
#[test]
fn half_extent_error_stays_below_its_bound() {
    let bounds = [Bound::default(), Bound::default()];
    let name = "camera::half_extent_error_stays_below_its_bound";
    let angles = (0.01..PI, 0.1..10.0_f64);
    let hard = (
        prop::sample::select(vec![1e-30, 1e-7, 0.5, PI - 1e-2, PI - 1e-4, PI - 1e-6]),
        prop::sample::select(vec![1e-6, 1.0, 1e30]),
    );
    Law::new(name, suspects::library).holds(angles, hard, |&(angle, distance)| {
        extent_error::<[f32; 3]>(angle, distance, &bounds[0])?;
        extent_error::<[f64; 3]>(angle, distance, &bounds[1])
    });
    for bound in &bounds {
        bound.is_used_up_to(0.05);
    }
}

fn extent_error<P: FloatPoint>(angle: f64, distance: f64, bound: &Bound) -> Verdict {
    let [angle, distance] = [angle, distance].map(P::number);
    let half = big(angle.into()) / big(2.0);
    let tangent = alternating(&half, 1) / alternating(&half, 0);
    let exact = big(distance.into()) * tangent;
    let computed = big(half_extent(angle, distance).into());
    let allowed = big(6.0 * P::roundoff()) * &exact;
    bound.holds_error(&(computed - &exact), &allowed)
}

/// The series `Σ (−1)ⁿ xᵏ / k!` over k = first, first + 2, ...: sine from 1, cosine from 0, to more than 30 digits below π/2.
fn alternating(x: &Big, first: u32) -> Big {
    let mut term = if first == 0 { Big::one() } else { x.clone() };
    let mut sum = Big::zero();
    let square = x * x;
    for n in 0..18_u32 {
        sum += &term;
        let k = 2 * n + first;
        term = -term * &square / big(f64::from((k + 1) * (k + 2)));
    }
    sum
}
