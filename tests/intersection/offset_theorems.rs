//! The theorems of rays that leave surfaces, in the order of the text. The book shows their doc comments.

use std::cell::Cell;

use facette::algebra::{Real, Vector3, VectorSpace, length, unit_vector};
use facette::intersection::offset::{spawn_ray, spawn_ray_to};
use facette::intersection::{Hit, Intersect, Plane};
use facette::ray::Ray;
use proptest::prelude::*;

use crate::common::law::{Broken, Law, Verdict, expect_at_most, expect_equal};
use crate::departures::{Departure, Kind, anywhere, awkward};
use crate::suspects;

/// The hit of the arriving ray; rays that rounding leads past an edge are counted.
fn arrival<S: Real>(departure: &Departure, missed: &Cell<u32>) -> Option<Hit<[S; 3]>> {
    let hit = departure.facet::<S>(0.0).intersect(&departure.arriving());
    missed.set(missed.get() + u32::from(hit.is_none()));
    hit
}

fn leaves<S: Real>(departure: &Departure, missed: &Cell<u32>) -> Verdict {
    let Some(hit) = arrival::<S>(departure, missed) else {
        return Ok(());
    };
    let ray = spawn_ray(&hit, departure.direction(&hit));
    match departure.facet::<S>(0.0).intersect(&ray) {
        None => Ok(()),
        Some(again) => Err(Broken {
            expected: "no hit of the facet that the ray leaves".to_owned(),
            got: format!("{again:?}\nby {ray:?}\nfrom {hit:?}"),
        }),
    }
}

/// **What is left is not met again.** A ray that leaves a hit point by `spawn_ray` does not meet the facet that it leaves: a plane or a triangle, to either side; a sphere or a dome of a Bézier patch, to the outside. In scenes
/// from $10^{-3}$ to $10^7$ units, with facets from a thousandth of the scene to all of it, and from there or from a thousand times as far, in both precisions.
///
/// A point $x$ of the facet lies within $e$ of the computed point $\hat x$ in every coordinate, so $|n\cdot(\hat x-x)|\le e\,|n|_1$ with $|n|_1=|n_x|+|n_y|+|n_z|$. The origin $\hat x+2e|n|_1n$ is thus at least
/// $e\,|n|_1$ beyond the tangent plane at $x$. What is rounded afterwards, in the sum and in the next intersection, is less than that.
///
/// Course: R04, slide 93, t > 0.
///
/// Erratum: the slide imposes $t>0$ so that a ray leaves its origin behind. For an exact origin that is right. A computed hit point lies beside its surface, and from there the surface itself has a hit with $t>0$, as often as not: the origin must be moved by the error of the point.
#[test]
fn ray_that_leaves_a_facet_does_not_meet_it_again() {
    let missed = [Cell::new(0), Cell::new(0)];
    let law = Law::new(
        "intersection::ray_that_leaves_a_facet_does_not_meet_it_again",
        suspects::library,
    );
    law.on_cases(4000)
        .holds(anywhere(), awkward(), |departure| {
            leaves::<f64>(departure, &missed[0])?;
            leaves::<f32>(departure, &missed[1])
        });
    let missed = missed.map(Cell::into_inner);
    println!("missed on arrival: {missed:?}");
    assert!(
        missed[0] <= 40 && missed[1] <= 800,
        "{missed:?} of 4000 rays miss"
    );
}

fn sees<S: Real>(departure: &Departure, missed: &Cell<u32>) -> Verdict {
    let Some(hit) = arrival::<S>(departure, missed) else {
        return Ok(());
    };
    let errors = if departure.kind == Kind::Dome {
        400.0
    } else {
        20.0
    };
    let gap = errors * hit.point_error.to_f64();
    let above = departure.facet::<S>(gap);
    let ray = spawn_ray(&hit, hit.normal);
    match above.intersect(&ray) {
        Some(seen) if seen.t.to_f64() <= 2.0 * gap => Ok(()),
        other => Err(Broken {
            expected: format!("a hit at most {gap} away"),
            got: format!("{other:?}\nby {ray:?}\nfrom {hit:?}"),
        }),
    }
}

/// **What is in front is met.** A second facet, twenty point errors in front of the first, is met by the ray that leaves the first along its normal. At $1$ unit in double precision that is $10^{-14}$ units; no fixed distance does that at all scales.
///
/// The origin is at most $2\sqrt3\,e$ and three units in the last place of each coordinate away, together less than $14e$, since $e\ge\mathbf u|x|$. The second facet's own error, and the rounding of its corners or its radius, are
/// left $6e$. A Bézier patch does not count a root that its own bound on $t$ cannot tell from the start; that bound is larger, and the patch stands 400 errors in front.
#[test]
fn ray_that_leaves_a_facet_meets_what_is_in_front() {
    let missed = [Cell::new(0), Cell::new(0)];
    let law = Law::new(
        "intersection::ray_that_leaves_a_facet_meets_what_is_in_front",
        suspects::library,
    );
    let away_from_edges = |mut departure: Departure| {
        departure.at = departure.at.map(|at| 0.25 + at / 2.0);
        departure
    };
    let [ordinary, hard] = [
        anywhere().prop_map(away_from_edges).boxed(),
        awkward().prop_map(away_from_edges).boxed(),
    ];
    law.on_cases(4000).holds(ordinary, hard, |departure| {
        sees::<f64>(departure, &missed[0])?;
        sees::<f32>(departure, &missed[1])
    });
    assert!(
        missed.iter().all(|missed| missed.get() <= 800),
        "{missed:?}"
    );
}

fn is_near<S: Real>(departure: &Departure, missed: &Cell<u32>, largest: &Cell<f64>) -> Verdict {
    let Some(hit) = arrival::<S>(departure, missed) else {
        return Ok(());
    };
    let origin = spawn_ray(&hit, departure.direction(&hit)).origin;
    let offset = origin.map(S::to_f64).minus(hit.point.map(S::to_f64));
    let error = hit.point_error.to_f64();
    let ulps = 2.0 * S::unit_roundoff().to_f64() * hit.point.map(S::to_f64).largest_coordinate();
    let bound = 2.0 * 3.0_f64.sqrt() * error + 3.0 * 3.0_f64.sqrt() * ulps;
    largest.set(largest.get().max(length(offset) / bound));
    expect_at_most("an offset", bound, length(offset))
}

/// **No farther than needed.** The origin is at most $2\sqrt3$ point errors and three units in the last place of each coordinate away from the point.
///
/// $|n|_1\le\sqrt3$ for a unit vector. The step away from the surface is at most two units, and both sums together round by one.
#[test]
fn offset_is_at_most_four_point_errors_and_three_units() {
    let (missed, largest_part) = (Cell::new(0), Cell::new(0.0));
    let law = Law::new(
        "intersection::offset_is_at_most_four_point_errors_and_three_units",
        suspects::library,
    );
    law.on_cases(2000)
        .holds(anywhere(), awkward(), |departure| {
            is_near::<f64>(departure, &missed, &largest_part)?;
            is_near::<f32>(departure, &missed, &largest_part)
        });
    println!("largest offset seen: {} of its bound", largest_part.get());
    assert!(largest_part.get() >= 0.5);
}

/// **A shadow ray ends before its lamp.** `spawn_ray_to` runs from a hit to a point, over $0<t<1$. A wall that the lamp itself hangs in does not darken it, when its hit comes out at $t=1$; a wall anywhere between does; one behind does not.
///
/// Course: R04, slide 93, a shadow ray needs t < 1 as well.
#[test]
fn shadow_ray_ends_before_its_lamp() {
    let law = Law::new(
        "intersection::shadow_ray_ends_before_its_lamp",
        suspects::library,
    );
    let whole = |range: std::ops::RangeInclusive<i32>| range.prop_map(f64::from);
    let ordinary = (
        whole(-50..=50),
        whole(-50..=50),
        whole(1..=100),
        0.01..0.99_f64,
    );
    let hard = (whole(-50..=50), whole(-50..=50), whole(1..=1), Just(1e-12));
    law.on_cases(500)
        .holds(ordinary, hard, |&(x, y, height, part)| {
            let plane = |z: f64| Plane::new([0.0, 0.0, z], [0.0, 0.0, 1.0]).expect("a normal");
            let floor = plane(0.0);
            let down = Ray::new([0.0, 0.0, 7.0], [0.0, 0.0, -1.0]);
            let hit = floor.intersect(&down).expect("it falls on the floor");
            let ray = spawn_ray_to(&hit, [x, y, height]);
            let is_dark = |z: f64| plane(z).is_hit_by(&ray);
            let found = [
                is_dark(0.0),
                is_dark(part * height),
                is_dark(height),
                is_dark(height * 1.5),
            ];
            expect_equal(&[false, true, false, false], &found)
        });
}

/// **From inside a sphere.** A ray that leaves the inside of a sphere inwards meets it once more, at the other end of the chord, $t=2r\cos\theta$ for a unit direction at the angle $\theta$ to the normal; the end that it
/// leaves is not found.
///
/// Course: R06, slide 95, origin inside: the larger root.
#[test]
fn ray_inside_a_sphere_crosses_to_the_other_side() {
    let missed = Cell::new(0);
    let law = Law::new(
        "intersection::ray_inside_a_sphere_crosses_to_the_other_side",
        suspects::library,
    );
    let as_sphere = |mut departure: Departure| {
        departure.kind = Kind::Sphere;
        departure
    };
    let [ordinary, hard] = [
        anywhere().prop_map(as_sphere).boxed(),
        awkward().prop_map(as_sphere).boxed(),
    ];
    law.on_cases(2000).holds(ordinary, hard, |departure| {
        let Some(hit) = arrival::<f64>(departure, &missed) else {
            return Ok(());
        };
        let outwards = departure.direction(&hit);
        let direction = unit_vector(outwards.times(-1.0)).expect("a direction");
        let cos = -direction.dot(hit.normal);
        let chord = 2.0 * departure.size * departure.scale * cos;
        if chord <= 100.0 * hit.point_error / cos {
            return Ok(());
        }
        let far = departure
            .facet::<f64>(0.0)
            .intersect(&spawn_ray(&hit, direction));
        let Some(far) = far else {
            return Err(Broken {
                expected: format!("a hit at {chord}"),
                got: "none".to_owned(),
            });
        };
        // The offset of at most 14 errors along the normal changes the chord by that over the cosine, and the normal has a roundoff or two.
        let slack = 30.0 * hit.point_error / cos;
        expect_at_most("a distance in t", slack, (far.t - chord).abs())
    });
}
