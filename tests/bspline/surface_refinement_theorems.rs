//! The theorems of refined surfaces: each line of the net is refined as a curve's control points are.

use facette::algebra::VectorSpace;
use facette::bspline::{Direction, insert_knot};
use facette::surface::Surface;
use proptest::prelude::*;

use crate::common::exact::fraction;
use crate::common::generators::{coordinate, parameter};
use crate::common::law::{Law, expect_equal};
use crate::inputs::{SurfaceCase, hard_surfaces, surfaces};
use crate::suspects;

/// **Surfaces, line by line.** A knot inserted in $u$ or in $v$, or a degree raised in one of them, changes the net and not the surface: it is done to each row, or to each column, as to the control points of a curve.
///
/// Course: B12, slide 20, one polynomial for each rectangle of knots.
#[test]
fn refining_a_surface_keeps_it() {
    let law = Law::new("bspline::refining_a_surface_keeps_it", suspects::library);
    let place = || (0..8_usize, parameter());
    let law = law.on_cases(48);
    law.holds(
        (surfaces(), place()),
        (hard_surfaces(), place()),
        |(case, (span, t))| {
            let surface = case.surface();
            let [u, v] = case.at;
            let expected = case.expected();
            for (index, direction) in [Direction::U, Direction::V].into_iter().enumerate() {
                let elevated = surface.elevated(direction);
                expect_equal(&(direction, expected), &(direction, elevated.point(u, v)))?;
                expect_equal(
                    &(case.knots[index].degree + 1),
                    &elevated.knots(direction).degree(),
                )?;
                let knot = case.knots[index].parameter(*span, *t);
                if surface.knots(direction).multiplicity(knot) > case.knots[index].degree {
                    continue;
                }
                let finer = surface
                    .with_knot(direction, knot)
                    .expect("there is room for one more");
                expect_equal(&(direction, expected), &(direction, finer.point(u, v)))?;
                let counts = [&finer, &surface].map(|s| s.knots(direction).control_point_count());
                expect_equal(&(counts[1] + 1), &counts[0])?;
            }
            Ok(())
        },
    );
}

/// **Another domain, the same surface.** Stretching and shifting the domain changes the parameters and no point: with $\varphi(t)=at+b$, the surface over $\varphi(U)$ at $\varphi(u)$ is the surface over $U$ at $u$.
///
/// Course: B19, slide 27, periodic surfaces: knot vectors over other domains.
#[test]
fn stretching_the_domain_keeps_the_surface() {
    let law = Law::new(
        "bspline::stretching_the_domain_keeps_the_surface",
        suspects::library,
    );
    let domains = || {
        (
            coordinate(),
            (1..=12, 1..=6).prop_map(|(a, b)| fraction(a, b)),
        )
    };
    law.holds(
        (surfaces(), domains()),
        (hard_surfaces(), domains()),
        |(case, (start, length))| {
            let domain = [*start, *start + *length];
            let surface = case
                .surface()
                .reparametrised([domain, domain])
                .expect("an interval is a domain");
            expect_equal(&[domain; 2], &surface.domain())?;
            let moved = |d: usize| {
                let [old_start, old_end] = case.knots[d].domain();
                start.lerp(domain[1], (case.at[d] - old_start) / (old_end - old_start))
            };
            expect_equal(&case.expected(), &surface.point(moved(0), moved(1)))
        },
    );
}

/// **Insertion in a surface is insertion in its curves.** The isoparametric curve of a refined surface is the refined isoparametric curve.
///
/// Course: B17, slide 25, isoparametric curves.
/// Exercise: insertion.
#[test]
fn refined_surface_has_refined_isoparametric_curves() {
    let law = Law::new(
        "bspline::refined_surface_has_refined_isoparametric_curves",
        suspects::insertion,
    );
    let place = || (0..8_usize, parameter());
    law.on_cases(48).holds(
        (surfaces(), place()),
        (hard_surfaces(), place()),
        |(case, (span, t))| {
            let SurfaceCase {
                knots, at: [_, v], ..
            } = case;
            let knot = knots[0].parameter(*span, *t);
            let vector = knots[0].vector();
            if vector.multiplicity(knot) > knots[0].degree {
                return Ok(());
            }
            let surface = case.surface();
            let refined = insert_knot(&vector, surface.curve_at_v(*v).control_points(), knot);
            let finer = surface
                .with_knot(Direction::U, knot)
                .expect("there is room for one more");
            expect_equal(&&refined[..], &finer.curve_at_v(*v).control_points())
        },
    );
}
