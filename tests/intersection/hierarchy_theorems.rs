//! The theorems of the page *A hierarchy of boxes*: it answers as the loop does, and the loop exactly.

use std::cell::Cell;

use facette::intersection::hierarchy::{Found, Hierarchy, nearest_by_loop};
use glam::Vec3;
use num_traits::ToPrimitive;

use crate::common::bound::Bound;
use crate::common::law::{Law, Verdict, expect_equal};
use crate::common::oracle::{Big, big_cross, big_length, big_minus, big_point};
use crate::hierarchy_inputs::{Scene, hard_scenes, scenes};
use crate::hierarchy_meshes::Draws;
use crate::hierarchy_oracle::{ExactHit, exact_hit, nearest_exactly};
use crate::suspects;

fn law(theorem: &'static str) -> Law {
    Law::new(theorem, suspects::library)
}

fn built(triangles: &[[Vec3; 3]]) -> Hierarchy {
    Hierarchy::new(triangles).expect("finite corners")
}

/// **The hierarchy is the loop.** For every ray the hierarchy finds the same triangle as the loop over all triangles, on the same side, with the same $t$ and the same weights to the last bit; or like the loop it finds nothing. It leaves out only boxes that the
/// ray misses, or that begin behind what it has found.
///
/// Course: R12, slide 104, Many surfaces: the loop over all primitives.
#[test]
fn hierarchy_finds_what_the_loop_finds() {
    let hits = Cell::new(0);
    let law = law("intersection::hierarchy_finds_what_the_loop_finds");
    law.on_cases(256).holds(scenes(), hard_scenes(), |scene| {
        let hierarchy = built(&scene.triangles);
        let mut query = hierarchy.query();
        for ray in &scene.rays {
            let expected = nearest_by_loop(&scene.triangles, ray);
            hits.set(hits.get() + usize::from(expected.is_some()));
            expect_equal(&(ray, expected), &(ray, query.nearest(ray)))?;
        }
        Ok(())
    });
    assert!(hits.get() > 1500, "{} hits", hits.get());
}

/// **The first hit is the exact one.** Coordinates in single precision are rational numbers. Computed with rational numbers, by the plane and three half-planes, the first hit is on the same triangle and the same side; among triangles hit at equal $t$ it is the
/// one with the smallest number.
///
/// Course: R12, slide 104, Many surfaces: the loop over all primitives.
#[test]
fn first_hit_is_the_exact_one() {
    let hits = Cell::new(0);
    let law = law("intersection::first_hit_is_the_exact_one");
    law.on_cases(32).holds(scenes(), hard_scenes(), |scene| {
        let hierarchy = built(&scene.triangles);
        let mut query = hierarchy.query();
        for ray in &scene.rays {
            let exact = nearest_exactly(&scene.triangles, ray);
            hits.set(hits.get() + usize::from(exact.is_some()));
            let expected = exact.map(|hit| (hit.triangle, hit.side));
            let found = query.nearest(ray);
            let got = found.map(|found| (found.triangle, found.hit.side));
            expect_equal(&(ray, expected), &(ray, got))?;
        }
        Ok(())
    });
    assert!(hits.get() > 150, "{} hits", hits.get());
}

/// What the hierarchy finds, and the exact hit on that triangle.
fn hits_of(
    scene: &Scene,
    mut check: impl FnMut(&Hierarchy, usize, &Found, &ExactHit) -> Verdict,
) -> Verdict {
    let hierarchy = built(&scene.triangles);
    let mut query = hierarchy.query();
    for (index, ray) in scene.rays.iter().enumerate() {
        if let Some(found) = query.nearest(ray) {
            let corners = scene.triangles[found.triangle as usize];
            let exact = exact_hit(found.triangle, corners, ray).expect("a hit is an exact one");
            check(&hierarchy, index, &found, &exact)?;
        }
    }
    Ok(())
}

/// The spacing of the numbers of single precision around `value`.
fn spacing(value: &Big) -> f64 {
    let value = value.to_f64().expect("within the range of f64").abs();
    let exponent = (value.to_bits() >> 52).cast_signed() - 1023;
    let exponent = i32::try_from(exponent.max(-126) - 23).expect("a small number");
    2.0_f64.powi(exponent)
}

/// **$t$ and the weights are rounded once.** The $t$ of what is found is within $\frac12+2^{-10}$ ulp of the exact one, and each of the two weights within $2^{-24}$. They are computed in double precision to $2^{-34}$ at least, or else exactly, and then rounded to the nearest
/// number of single precision: half an ulp, which is at most $2^{-25}$ for weights up to 1.
#[test]
fn t_and_weights_are_rounded_once() {
    let [of_t, of_weights] = [Bound::default(), Bound::default()];
    let law = law("intersection::t_and_weights_are_rounded_once");
    law.on_cases(128).holds(scenes(), hard_scenes(), |scene| {
        hits_of(scene, |_, _, found, exact| {
            let bound = spacing(&exact.t) * (0.5 + 1.0 / 1024.0);
            of_t.holds(found.hit.t.into(), &exact.t, bound)?;
            for (weight, exact) in found.hit.parameters.iter().zip(&exact.weights[1..]) {
                of_weights.holds((*weight).into(), exact, 1.0 / f64::from(1 << 24))?;
            }
            Ok(())
        })
    });
    of_t.is_used_up_to(0.5);
    of_weights.is_used_up_to(0.25);
}

/// **The hit keeps its bounds.** In the whole hit, $t$ is within `t_error` of the exact one, and each coordinate of the point within `point_error`: $u\lvert p\rvert+2^{-34}(\lvert b-a\rvert+\lvert c-a\rvert)$ in the largest coordinates, $u=2^{-24}$, rounded up. Each
/// coordinate of the normal is within $2^{-24}$: its vector product has a relative error of at most $2^{-30}$, or is computed exactly, and the rounding of a coordinate up to 1 is $2^{-25}$.
#[test]
fn hit_of_the_hierarchy_keeps_its_bounds() {
    let [of_t, of_point, of_normal] = [Bound::default(), Bound::default(), Bound::default()];
    let law = law("intersection::hit_of_the_hierarchy_keeps_its_bounds");
    law.on_cases(64).holds(scenes(), hard_scenes(), |scene| {
        hits_of(scene, |hierarchy, ray, found, exact| {
            let hit = hierarchy
                .hit(&scene.rays[ray], found)
                .expect("it was found");
            of_t.holds(hit.t.into(), &exact.t, hit.t_error.into())?;
            let corners = scene.triangles[found.triangle as usize];
            let [a, b, c] = corners.map(|corner| big_point(corner.as_dvec3().to_array()));
            let [u, v, w] = &exact.weights;
            for (axis, coordinate) in hit.point.to_array().into_iter().enumerate() {
                let exact = u * &a[axis] + v * &b[axis] + w * &c[axis];
                of_point.holds(coordinate.into(), &exact, hit.point_error.into())?;
            }
            let normal = big_cross(&big_minus(&b, &a), &big_minus(&c, &a));
            let length = big_length(&normal);
            for (coordinate, exact) in hit.normal.to_array().into_iter().zip(normal) {
                let exact = exact / &length;
                of_normal.holds(coordinate.into(), &exact, 1.0 / f64::from(1 << 24))?;
            }
            Ok(())
        })
    });
    of_t.is_used_up_to(0.25);
    of_point.is_used_up_to(0.25);
    of_normal.is_used_up_to(0.25);
}

/// **Any hit is a hit.** The question of a shadow ray, whether anything is in the way, has the answer yes exactly where there is a nearest hit. It may stop at the first triangle that it finds.
///
/// Course: R04, slide 93, a shadow ray needs t < 1 as well.
#[test]
fn any_hit_agrees_with_the_nearest() {
    let law = law("intersection::any_hit_agrees_with_the_nearest");
    law.on_cases(256).holds(scenes(), hard_scenes(), |scene| {
        let hierarchy = built(&scene.triangles);
        let mut query = hierarchy.query();
        for ray in &scene.rays {
            let is_hit = nearest_by_loop(&scene.triangles, ray).is_some();
            expect_equal(&(ray, is_hit), &(ray, query.is_hit(ray)))?;
        }
        Ok(())
    });
}

/// **A stream answers as single rays do.** Rays that walk down side by side find what each would find alone, whatever walks beside it, whether the nearest hit is asked for or any. One query serves for all of them, and for streams of any length.
#[test]
fn stream_answers_as_single_rays_do() {
    let law = law("intersection::stream_answers_as_single_rays_do");
    law.on_cases(128).holds(scenes(), hard_scenes(), |scene| {
        let hierarchy = built(&scene.triangles);
        let mut query = hierarchy.query();
        let expected: Vec<_> = scene
            .rays
            .iter()
            .map(|ray| nearest_by_loop(&scene.triangles, ray))
            .collect();
        // Shorter than, as long as, and longer than the number of rays that walk at once.
        for length in [0, 1, 5, 16, 61] {
            let rays: Vec<_> = scene.rays.iter().copied().cycle().take(length).collect();
            let expected: Vec<_> = expected.iter().copied().cycle().take(length).collect();
            let mut found = vec![None; length];
            query.nearest_of(&rays, &mut found);
            expect_equal(&expected, &found)?;
            let mut is_hit = vec![true; length];
            query.is_hit_of(&rays, &mut is_hit);
            let expected: Vec<_> = expected.iter().map(Option::is_some).collect();
            expect_equal(&expected, &is_hit)?;
        }
        Ok(())
    });
}

/// **The order does not matter.** Shuffle the triangles, and every ray finds the same triangle under its new number, with the same $t$ and weights to the last bit. Only where several are met at exactly the same $t$ it may be another of them: the one whose number is now the smallest.
#[test]
fn order_of_the_triangles_does_not_matter() {
    let law = law("intersection::order_of_the_triangles_does_not_matter");
    law.on_cases(64).holds(scenes(), hard_scenes(), |scene| {
        let triangles = &scene.triangles;
        let mut order: Vec<usize> = (0..triangles.len()).collect();
        let mut draws = Draws::new(order.len() as u64);
        for place in (1..order.len()).rev() {
            order.swap(place, draws.index(place + 1));
        }
        let shuffled: Vec<_> = order.iter().map(|&triangle| triangles[triangle]).collect();
        let [first, second] = [built(triangles), built(&shuffled)];
        let (mut first, mut second) = (first.query(), second.query());
        for ray in &scene.rays {
            let expected = first.nearest(ray);
            let Some(mut got) = second.nearest(ray) else {
                expect_equal(&(ray, expected), &(ray, None))?;
                continue;
            };
            let place = got.triangle as usize;
            got.triangle = u32::try_from(order[place]).expect("a few triangles");
            if expected != Some(got) {
                let nearest = nearest_exactly(&shuffled, ray).expect("something is met");
                let other = expected.map(|found| triangles[found.triangle as usize]);
                let other = other.and_then(|corners| exact_hit(0, corners, ray));
                expect_equal(&Some(nearest.t), &other.map(|hit| hit.t))?;
                expect_equal(&(nearest.triangle as usize), &place)?;
            }
        }
        Ok(())
    });
}

/// **Boxes lie within boxes.** Each box of the tree lies in one of the level above, and each triangle in one of the first level: so a ray that misses a box misses all that is below it. No coordinate is rounded.
#[test]
fn boxes_lie_within_boxes() {
    let law = law("intersection::boxes_lie_within_boxes");
    law.holds(scenes(), scenes(), |scene| {
        let levels = built(&scene.triangles).boxes();
        let holds = |[low, high]: [Vec3; 2], [from, to]: [Vec3; 2]| {
            low.cmple(from).all() && to.cmple(high).all()
        };
        for pair in levels.windows(2) {
            for &inner in &pair[1] {
                let is_held = pair[0].iter().any(|&outer| holds(outer, inner));
                expect_equal(&(inner, true), &(inner, is_held))?;
            }
        }
        for &[a, b, c] in &scene.triangles {
            let own = [a.min(b).min(c), a.max(b).max(c)];
            let is_held = levels[0].iter().any(|&outer| holds(outer, own));
            expect_equal(&(own, true), &(own, is_held))?;
        }
        Ok(())
    });
}
