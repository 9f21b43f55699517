//! The box in floating point against arbitrary precision.

use std::cell::Cell;

use facette::algebra::VectorSpace;
use facette::intersection::{BoundingBox, Intersect, SlabRay, box_interval};
use facette::ray::Ray;
use num_traits::Signed;
use proptest::prelude::*;

use crate::common::bound::Bound;
use crate::common::law::{Broken, Law, Verdict, expect_equal};
use crate::common::oracle::{Big, big, big_point};
use crate::float_boxes::{
    FloatBox, big_interval, big_interval_between, float_boxes, hard_float_boxes,
};
use crate::float_chords::Float;
use crate::suspects;

/// **The error of entry and exit.** Each $t_k=(b_k-o_k)/d_k$ is a difference and a quotient: within $2\mathbf u\lvert t_k\rvert$, and with the terms in $\mathbf u^2$ within $3\mathbf u\lvert t_k\rvert$ of the
/// number as computed. The same holds for the largest entry and the smallest exit, although the computed one may belong to another slab: $t\mapsto t\pm2\mathbf u\lvert t\rvert$ grows with $t$, so it changes places with maximum and minimum.
///
/// Whether the line hits or misses is decided wrongly only where entry and exit are within these bounds of each other.
///
/// Course: R07, slides 96-98, Ray and box: three slabs and how to combine them.
#[test]
fn box_error_stays_below_its_bound() {
    let bounds = [Bound::default(), Bound::default()];
    let law = Law::new(
        "intersection::box_error_stays_below_its_bound",
        suspects::library,
    );
    law.on_cases(800)
        .holds(float_boxes(), hard_float_boxes(), |place| {
            errors::<f64>(place, &bounds[0])?;
            errors::<f32>(place, &bounds[1])
        });
    for bound in &bounds {
        bound.is_used_up_to(0.05);
    }
}

/// Whether every difference and quotient stays among the normal numbers of the type, as all bounds suppose.
fn is_normal<S: Float>(place: &FloatBox) -> bool {
    let (bounds, ray) = place.rounded::<S>();
    let limit: f64 = if S::unit_roundoff().into() < 1e-10 {
        1e150
    } else {
        1e15
    };
    let is_normal = |value: f64| value == 0.0 || (1.0 / limit..limit).contains(&value.abs());
    [bounds.min(), bounds.max(), ray.origin, ray.direction]
        .iter()
        .flatten()
        .all(|&value| is_normal(value.into()))
        && [bounds.min(), bounds.max()].iter().all(|corner| {
            corner
                .minus(ray.origin)
                .iter()
                .all(|&value| is_normal(value.into()))
        })
}

fn errors<S: Float>(place: &FloatBox, bound: &Bound) -> Verdict {
    let (bounds, ray) = place.rounded::<S>();
    if ray.direction == [S::zero(); 3] || !is_normal::<S>(place) {
        return Ok(());
    }
    let three_u = 3.0 * S::unit_roundoff().into();
    let truth = big_interval(&bounds, &ray);
    let interval = box_interval(&bounds, &ray).map(|ends| ends.map(Into::into));
    match (&truth, interval) {
        (None, None) => Ok(()),
        (Some(truth), Some(ends)) => {
            for (end, truth) in ends.into_iter().zip(truth) {
                bound.holds(end, truth, three_u * end.abs())?;
            }
            Ok(())
        }
        (Some([entry, exit]), None) => {
            let margin = big(2.0 * three_u) * (entry.abs() + exit.abs());
            expect_equal(&true, &(exit - entry <= margin))
        }
        // Found where there is none: box and line are then within the bound in the same way, and the exact interval is empty by less.
        (None, Some([entry, exit])) => {
            let wider = widened(&bounds, &ray, three_u);
            expect_equal(&true, &(wider.is_some() && entry <= exit))
        }
    }
}

/// The true interval in a box whose planes are moved outwards by `part` of their distance from the origin, twice.
fn widened<S: Float>(
    bounds: &BoundingBox<[S; 3]>,
    ray: &Ray<[S; 3]>,
    part: f64,
) -> Option<[Big; 2]> {
    let exactly = |point: [S; 3]| big_point(point.map(Into::into));
    let [min, max, origin, direction] =
        [bounds.min(), bounds.max(), ray.origin, ray.direction].map(exactly);
    let part = big(2.0 * part);
    // Exactly: where the distance is small beside the coordinates, rounding would put the planes back in their places.
    let moved = |corner: &[Big; 3], sign: f64| -> [Big; 3] {
        std::array::from_fn(|axis| {
            &corner[axis] + big(sign) * &part * (&corner[axis] - &origin[axis]).abs()
        })
    };
    let corners = [moved(&min, -1.0), moved(&max, 1.0)];
    big_interval_between(&corners, &[origin, direction])
}

/// **No box is missed.** [`may_be_hit_by`] multiplies by the reciprocal of $d_k$, which is faster than to divide, and rounds three times: each $t_k$ is within $3\mathbf u\lvert t_k\rvert$, up to terms in $\mathbf u^2$. Entry and exit together
/// may be wrong by $6\mathbf u$ of their size. So the test compares the entry with $t_{\text{exit}}+8\mathbf u\lvert t_{\text{exit}}\rvert$; one $\mathbf u$ is for the rounding of this sum, one for all terms in $\mathbf u^2$. What the exact ray meets, it is then said to meet, edges and corners
/// included; and few more: a ray that is wrongly said to meet the box passes within that bound of it.
///
/// Course: R07, slides 96-98, Ray and box: three slabs and how to combine them.
#[test]
fn no_box_is_missed() {
    let [met, gratis] = [Cell::new(0), Cell::new(0)];
    let law = Law::new("intersection::no_box_is_missed", suspects::library);
    let with_ends = |boxes: BoxedStrategy<FloatBox>| {
        (
            boxes,
            prop::sample::select(vec![None, Some(0.5), Some(1.0), Some(3.0)]),
        )
    };
    law.on_cases(1600).holds(
        with_ends(float_boxes().boxed()),
        with_ends(hard_float_boxes().boxed()),
        |(place, end)| {
            for outcome in [meets::<f64>(place, *end)?, meets::<f32>(place, *end)?] {
                let [is_met, is_said] = outcome;
                met.set(met.get() + u32::from(is_met));
                gratis.set(gratis.get() + u32::from(is_said && !is_met));
            }
            Ok(())
        },
    );
    let [met, gratis] = [met.get(), gratis.get()];
    println!("{met} boxes met, {gratis} said to be met besides");
    assert!(
        met > 800 && gratis * 10 < met,
        "{met} boxes met, {gratis} said to be met besides"
    );
}

/// Whether the exact ray meets the box, and whether it is said to.
fn meets<S: Float>(place: &FloatBox, end: Option<f64>) -> Result<[bool; 2], Broken> {
    let (bounds, ray) = place.rounded::<S>();
    let ray = Ray {
        end: end.map(S::nearest),
        ..ray
    };
    if ray.direction == [S::zero(); 3] || !is_normal::<S>(place) {
        return Ok([false; 2]);
    }
    let in_time = |interval: &[Big; 2]| {
        let [entry, exit] = interval;
        !exit.is_negative() && end.is_none_or(|end| *entry <= big(end))
    };
    let is_met = big_interval(&bounds, &ray).is_some_and(|interval| in_time(&interval));
    let is_said = bounds.may_be_hit_by(&SlabRay::new(&ray));
    let verdict = [is_met, is_said];
    if is_met && !is_said {
        expect_equal(&[true; 2], &verdict)?;
    }
    if is_said && !is_met {
        let slack = 16.0 * S::unit_roundoff().into();
        let wider = widened(&bounds, &ray, slack);
        let in_slack = |[entry, exit]: [Big; 2]| {
            let later = end.map(|end| big(end * (1.0 + slack)));
            !exit.is_negative() && later.is_none_or(|end| entry <= end)
        };
        expect_equal(&true, &wider.is_some_and(in_slack))?;
    }
    Ok(verdict)
}

/// **The point of a box lies on its face exactly.** The coordinate along the face's axis is the face's own, the others are kept within the box: so `point_error` is 0, and the point is within the box to the last bit. It is also within
/// the error of $t$ and two roundings of the true point of the ray.
///
/// Course: R07, slide 96, Ray and box: six faces, or three slabs.
#[test]
fn box_hit_lies_on_a_face_exactly() {
    let law = Law::new(
        "intersection::box_hit_lies_on_a_face_exactly",
        suspects::library,
    );
    law.on_cases(400)
        .holds(float_boxes(), hard_float_boxes(), |place| {
            let (bounds, ray) = place.rounded::<f64>();
            let Some(hit) = bounds.intersect(&ray) else {
                return Ok(());
            };
            expect_equal(&(true, 0.0), &(bounds.contains(hit.point), hit.point_error))?;
            let is_on = |axis: usize| {
                hit.point[axis] == bounds.min()[axis] || hit.point[axis] == bounds.max()[axis]
            };
            let axis = (0..3).find(|&axis| hit.normal[axis] != 0.0);
            expect_equal(&Some(true), &axis.map(is_on))?;
            let u = f64::EPSILON / 2.0;
            for axis in 0..3 {
                let on_ray = big(ray.origin[axis]) + big(hit.t) * big(ray.direction[axis]);
                let moved = hit.t_error * ray.direction[axis].abs();
                let rounded =
                    2.0 * u * ((hit.t * ray.direction[axis]).abs() + hit.point[axis].abs());
                Bound::default().holds(hit.point[axis], &on_ray, 2.0 * moved + 2.0 * rounded)?;
            }
            expect_equal(&true, &bounds.is_hit_by(&ray))
        });
}

/// **Powers of two change nothing.** Magnifying the direction by $2^k$ divides a box's and a plane's $t$ by $2^k$ exactly, and magnifying everything leaves $t$ to the last bit, as long as nothing overflows.
///
/// Course: R07, slides 96-98, Ray and box: three slabs and how to combine them.
#[test]
fn powers_of_two_scale_the_box_exactly() {
    let law = Law::new(
        "intersection::powers_of_two_scale_the_box_exactly",
        suspects::library,
    );
    let exponents = |limit: i32| (-limit..=limit, -limit..=limit);
    law.holds(
        (float_boxes(), exponents(20)),
        (float_boxes(), exponents(400)),
        |&(place, (speed, size))| {
            let [speed, size] = [speed, size].map(|exponent| 2.0_f64.powi(exponent));
            let (bounds, ray) = place.rounded::<f64>();
            let larger = BoundingBox::new(bounds.min().times(size), bounds.max().times(size));
            let larger = larger.expect("corners in order");
            let longer = Ray::new(
                ray.origin.times(size),
                ray.direction.times(size).times(speed),
            );
            let expected = box_interval(&bounds, &ray).map(|ends| ends.map(|t| t / speed));
            expect_equal(&expected, &box_interval(&larger, &longer))?;
            let point = |hit: facette::intersection::Hit<[f64; 3]>| big_point(hit.point);
            let scaled = bounds
                .intersect(&ray)
                .map(point)
                .map(|point| point.map(|x| x * big(size)));
            expect_equal(&scaled, &larger.intersect(&longer).map(point))
        },
    );
}
