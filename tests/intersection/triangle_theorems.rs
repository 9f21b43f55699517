//! The theorems of a ray and a triangle over the fractions, in the order of the text.

use facette::algebra::{Scalar, Vector3, VectorSpace};
use facette::intersection::Side;
use facette::intersection::triangle::{half_planes, moller_trumbore, strict_half_planes};
use facette::ray::Ray;
use num_traits::{One, Zero};
use proptest::prelude::*;

use crate::common::exact::{Exact, fraction};
use crate::common::generators::{parameter, point};
use crate::common::law::{Broken, Law, LikelyMistake, Verdict, expect_equal};
use crate::triangle_inputs::{
    Place, Point, closed_tests, expected, hard_places, motions, places, signed_tests, solved,
};
use crate::{suspects, triangle_suspects};

fn on_places(
    theorem: &'static str,
    suspect: fn() -> LikelyMistake,
    check: impl Fn(&Place) -> Verdict,
) {
    Law::new(theorem, suspect)
        .on_cases(256)
        .holds(places(), hard_places(), check);
}

/// Passes where the test finds what it should; names the test where it does not.
fn expect_named<T: PartialEq + std::fmt::Debug>(name: &str, expected: &T, got: &T) -> Verdict {
    expect_equal(expected, got).map_err(|broken| Broken {
        got: format!("{} by {name}", broken.got),
        ..broken
    })
}

/// **A hit solves the equations.** A ray meets the triangle $\mathbf a\,\mathbf b\,\mathbf c$ where
/// $$\mathbf o+t\,\mathbf d=(1-v-w)\,\mathbf a+v\,\mathbf b+w\,\mathbf c,\qquad v\ge0,\quad w\ge0,\quad v+w\le1,\quad t>0:$$
/// three equations in $t$, $v$, $w$, which have one solution unless the ray is parallel to the plane or the triangle has no area. The test gives that
/// solution if it satisfies the conditions, and nothing otherwise.
///
/// Course: R10, slide 101, Ray and triangle: Möller and Trumbore's algorithm.
/// Exercise: moller_trumbore.
#[test]
fn hit_solves_the_equations() {
    on_places(
        "intersection::hit_solves_the_equations",
        triangle_suspects::moller_trumbore,
        |place| {
            let hit = moller_trumbore(&place.corners, &place.ray());
            expect_equal(&expected(place), &hit)
        },
    );
}

/// **Edges and corners belong to the triangle.** A ray at a corner or at a point of an edge is a hit, if it is not parallel.
///
/// Exercise: moller_trumbore.
#[test]
fn edges_and_corners_belong_to_the_triangle() {
    let theorem = "intersection::edges_and_corners_belong_to_the_triangle";
    let law = Law::new(theorem, triangle_suspects::moller_trumbore);
    law.holds(pairs(), flat_pairs(), |&([a, b, c, _], t, o)| {
        for target in [b.lerp(c, t), a.lerp(b, t), c.lerp(a, t), a] {
            let place = Place {
                corners: [a, b, c],
                origin: o,
                direction: target.minus(o),
            };
            let hit = moller_trumbore(&place.corners, &place.ray());
            let t = solved(&place).map(|_| Exact::one());
            expect_equal(&t, &hit.map(|hit| hit.t))?;
        }
        Ok(())
    });
}

/// **The inside is the intersection of three half-planes.** Let $\mathbf n=(\mathbf b-\mathbf a)\times(\mathbf c-\mathbf a)$, and let $\mathbf x$ be a point of the plane. Then
/// $$(\mathbf b-\mathbf a)\times(\mathbf x-\mathbf a)\cdot\mathbf n=w\,\mathbf n\cdot\mathbf n,\qquad(\mathbf c-\mathbf b)\times(\mathbf x-\mathbf b)\cdot\mathbf n=u\,\mathbf n\cdot\mathbf n,\qquad(\mathbf a-\mathbf c)\times(\mathbf x-\mathbf c)\cdot\mathbf n=v\,\mathbf n\cdot\mathbf n$$
/// with the barycentric coordinates $u=1-v-w$, $v$, $w$ of $\mathbf x$: each half-plane asks for the sign of one of them. The plane's $t$ and three **closed** half-planes, with $\ge$, give the hit that the equations have. The
/// triple products $(\mathbf b-\mathbf a,\mathbf x-\mathbf a,\mathbf n)$ of the slide are the same numbers.
///
/// Course: R09, slide 100, Ray and triangle: three half-planes.
/// Exercise: half_planes.
#[test]
fn three_half_planes_are_the_inside() {
    on_places(
        "intersection::three_half_planes_are_the_inside",
        triangle_suspects::half_planes,
        |place| {
            expect_equal(&expected(place), &half_planes(&place.corners, &place.ray()))?;
            let Some([t, v, w]) = solved(place) else {
                return Ok(());
            };
            let (n, x) = (place.normal(), place.ray().point(t));
            let [a, b, c] = place.corners;
            let edges = [(b, c), (c, a), (a, b)];
            let cross = edges.map(|(from, to)| to.minus(from).cross(x.minus(from)).dot(n));
            let triple = edges.map(|(from, to)| determinant(to.minus(from), x.minus(from), n));
            let weights = [Exact::one() - v - w, v, w].map(|weight| weight * n.dot(n));
            expect_equal(&weights, &cross)?;
            expect_equal(&weights, &triple)
        },
    );
}

/// The determinant of three columns, along the first row.
#[rustfmt::skip]
fn determinant(x: Point, y: Point, z: Point) -> Exact {
    x[0] * (y[1] * z[2] - y[2] * z[1])
        - y[0] * (x[1] * z[2] - x[2] * z[1])
        + z[0] * (x[1] * y[2] - x[2] * y[1])
}

/// Two triangles with the common edge b c, a point of it with the edge's ends, and a point to look from.
type Pair = ([Point; 4], Exact, Point);

fn pairs() -> impl Strategy<Value = Pair> {
    ([point(), point(), point(), point()], parameter(), point())
}

/// Pairs in a plane, seen from above: a square and its diagonal, and the diagonal's ends.
fn flat_pairs() -> impl Strategy<Value = Pair> {
    let at = |x, y| [x, y, 0].map(Exact::from_i32);
    let square = [at(0, 0), at(1, 0), at(0, 1), at(1, 1)];
    let ends = prop::sample::select(vec![fraction(0, 1), fraction(1, 1), fraction(1, 2)]);
    (Just(square), ends, point())
}

/// **Open half-planes leave cracks.** With the strict $>$ of the slide no point of an edge or a corner belongs to the triangle. So a ray through a point of the edge that
/// two triangles share meets neither: a mesh has a crack along every edge, even without any rounding. With $\ge$ the ray meets both, if it is parallel to neither.
///
/// Course: R09, slide 100, Ray and triangle: the half-planes are open.
/// Erratum: The slide asks for $>0$ in all three half-planes. Then the edges and corners belong to no triangle, and a closed mesh lets rays through. It must read $\ge0$; and the normal must be $(\mathbf b-\mathbf a)\times(\mathbf c-\mathbf a)$, since with the opposite one all three signs change and no point is inside.
/// Exercise: half_planes.
#[test]
fn strict_half_planes_leave_cracks() {
    let law = Law::new(
        "intersection::strict_half_planes_leave_cracks",
        triangle_suspects::half_planes,
    );
    law.holds(pairs(), flat_pairs(), |&([a, b, c, d], t, o)| {
        let ray = Ray::new(o, b.lerp(c, t).minus(o));
        for corners in [[a, b, c], [c, b, d]] {
            let place = Place {
                corners,
                origin: o,
                direction: ray.direction,
            };
            if solved(&place).is_none() {
                continue;
            }
            let closed = half_planes(&corners, &ray).map(|hit| hit.t);
            expect_equal(
                &(None, Some(Exact::one())),
                &(strict_half_planes(&corners, &ray), closed),
            )?;
        }
        Ok(())
    });
}

/// **The normal must turn with the corners.** Exchanging two corners turns $\mathbf n$ round, and with it all three half-planes: the inside stays the inside. With the normal
/// $(\mathbf c-\mathbf a)\times(\mathbf b-\mathbf a)$ and the edges in the order $\mathbf a\,\mathbf b\,\mathbf c$, all three numbers are negative inside.
///
/// Course: R09, slide 100, Ray and triangle: an oriented triangle.
/// Exercise: half_planes.
#[test]
fn reversed_normal_turns_the_inside_out() {
    on_places(
        "intersection::reversed_normal_turns_the_inside_out",
        triangle_suspects::half_planes,
        |place| {
            let Some(hit) = half_planes(&place.corners, &place.ray()) else {
                return expect_equal(&None, &expected(place));
            };
            let (n, x) = (
                place.normal().times(-Exact::one()),
                place.ray().point(hit.t),
            );
            let [a, b, c] = place.corners;
            let against = [(a, b), (b, c), (c, a)]
                .map(|(from, to)| to.minus(from).cross(x.minus(from)).dot(n));
            expect_equal(
                &true,
                &against.into_iter().all(|number| number <= Exact::zero()),
            )
        },
    );
}

/// **All tests are one.** Half-planes, Möller-Trumbore, Woop's sheared space, the stored planes of Shevtsov and of Baldwin and Weber: over the fractions they give
/// the same hit, with the same $t$, the same coordinates and the same side. They differ in speed, and in what rounding does to them.
///
/// Course: R10, slide 101, Ray and triangle: Möller and Trumbore, Shevtsov.
#[test]
fn all_tests_find_the_same_hit() {
    on_places(
        "intersection::all_tests_find_the_same_hit",
        suspects::library,
        |place| {
            for (name, test) in closed_tests::<Point>() {
                expect_named(name, &expected(place), &test(&place.corners, &place.ray()))?;
            }
            Ok(())
        },
    );
}

/// **The point has these weights.** Without rounding, $\mathbf o+t\,\mathbf d$ and $(1-v-w)\,\mathbf a+v\,\mathbf b+w\,\mathbf c$ are the same point.
///
/// Exercise: moller_trumbore.
#[test]
fn barycentric_coordinates_reproduce_the_point() {
    let theorem = "intersection::barycentric_coordinates_reproduce_the_point";
    on_places(theorem, triangle_suspects::moller_trumbore, |place| {
        for (name, test) in signed_tests::<Point>() {
            let Some(hit) = test(&place.corners, &place.ray()) else {
                continue;
            };
            let by_weights = Point::combination(hit.barycentric(), place.corners);
            expect_named(name, &place.ray().point(hit.t), &by_weights)?;
        }
        Ok(())
    });
}

/// **Exchanging two corners exchanges the sides.** The triangle $\mathbf a\,\mathbf c\,\mathbf b$ is hit at the same $t$, with the weights exchanged, on the other side.
///
/// Exercise: moller_trumbore.
#[test]
fn exchanging_two_corners_exchanges_the_sides() {
    let theorem = "intersection::exchanging_two_corners_exchanges_the_sides";
    on_places(theorem, triangle_suspects::moller_trumbore, |place| {
        let [a, b, c] = place.corners;
        for (name, test) in signed_tests::<Point>() {
            let hit = test(&place.corners, &place.ray());
            let exchanged = hit.map(|mut hit| {
                hit.parameters.reverse();
                hit.side = match hit.side {
                    Side::Front => Side::Back,
                    Side::Back => Side::Front,
                };
                hit
            });
            expect_named(name, &exchanged, &test(&[a, c, b], &place.ray()))?;
        }
        Ok(())
    });
}

/// **It makes no difference which corner comes first.** The triangle $\mathbf b\,\mathbf c\,\mathbf a$ is hit at the same $t$ and on the same side, and the weights move along.
///
/// Exercise: moller_trumbore.
#[test]
fn turning_the_corners_turns_the_weights() {
    on_places(
        "intersection::turning_the_corners_turns_the_weights",
        triangle_suspects::moller_trumbore,
        |place| {
            let [a, b, c] = place.corners;
            for (name, test) in signed_tests::<Point>() {
                let hit = test(&place.corners, &place.ray());
                let turned = hit.map(|mut hit| {
                    let [u, _, w] = hit.barycentric();
                    hit.parameters = [w, u];
                    hit
                });
                expect_named(name, &turned, &test(&[b, c, a], &place.ray()))?;
            }
            Ok(())
        },
    );
}

/// **Rigid motions.** Turn and shift the triangle and the ray together: $t$, the weights and the side stay.
#[test]
fn triangle_hits_are_invariant_under_rigid_motions() {
    let theorem = "intersection::triangle_hits_are_invariant_under_rigid_motions";
    Law::new(theorem, triangle_suspects::moller_trumbore)
        .on_cases(128)
        .holds(
            (places(), motions()),
            (hard_places(), motions()),
            |(place, (rotation, shift))| {
                let turn = |p: Point| rotation.turned(p);
                let moved = place.mapped(|p| turn(p).plus(*shift), turn);
                for (name, test) in signed_tests::<Point>() {
                    let hit = test(&place.corners, &place.ray());
                    expect_named(name, &hit, &test(&moved.corners, &moved.ray()))?;
                }
                Ok(())
            },
        );
}

/// **Scaling the direction scales t.** With the direction $s\,\mathbf d$, $s>0$, the hit is at $t/s$: the point stays, and so do the weights and the side.
///
/// Exercise: moller_trumbore.
#[test]
fn scaling_the_direction_scales_t_of_a_triangle() {
    let theorem = "intersection::scaling_the_direction_scales_t_of_a_triangle";
    let factor = || (1..=12_i32, 1..=6_i32).prop_map(|(n, d)| fraction(n, d));
    Law::new(theorem, triangle_suspects::moller_trumbore)
        .on_cases(128)
        .holds(
            (places(), factor()),
            (hard_places(), factor()),
            |(place, factor)| {
                let scaled = Ray::new(place.origin, place.direction.times(*factor));
                for (name, test) in signed_tests::<Point>() {
                    let hit = test(&place.corners, &place.ray()).map(|mut hit| {
                        hit.t = hit.t / *factor;
                        hit
                    });
                    expect_named(name, &hit, &test(&place.corners, &scaled))?;
                }
                Ok(())
            },
        );
}

/// **The interval of t is half-open.** A hit at $t$ belongs to the rays that start before $t$ and end at $t$ or later, and to no other.
///
/// Exercise: moller_trumbore.
#[test]
fn triangle_hits_keep_to_the_interval() {
    on_places(
        "intersection::triangle_hits_keep_to_the_interval",
        triangle_suspects::moller_trumbore,
        |place| {
            for (name, test) in signed_tests::<Point>() {
                let Some(hit) = test(&place.corners, &place.ray()) else {
                    continue;
                };
                let step = fraction(1, 1000);
                let asks = [
                    (place.ray().until(hit.t), true),
                    (place.ray().until(hit.t - step), false),
                    (place.ray().after(hit.t), false),
                    (place.ray().after(hit.t - step), true),
                    (place.ray().after(-step).until(hit.t), true),
                ];
                for (ray, is_hit) in asks {
                    expect_named(name, &is_hit, &test(&place.corners, &ray).is_some())?;
                }
            }
            Ok(())
        },
    );
}

/// **Woop's shear keeps t.** In the sheared space the ray is the third axis: the point $\mathbf o+t\,\mathbf d$ becomes $(0,0,t)$, and only it does.
#[test]
fn shear_makes_the_ray_an_axis() {
    let rays = || (point(), point(), parameter(), point());
    Law::new(
        "intersection::shear_makes_the_ray_an_axis",
        suspects::library,
    )
    .holds(
        rays(),
        (
            point(),
            Just([0, 0, -1].map(Exact::from_i32)),
            parameter(),
            point(),
        ),
        |&(o, d, t, other)| {
            if d.largest_coordinate().is_zero() {
                return Ok(());
            }
            let ray = Ray::new(o, d);
            let sheared = facette::intersection::triangle::ShearedRay::new(&ray);
            let zero = Exact::zero();
            expect_equal(&[zero, zero, t], &sheared.sheared(ray.point(t)))?;
            let [x, y, z] = sheared.sheared(other);
            let is_on_the_line = other.minus(ray.point(z)).largest_coordinate().is_zero();
            expect_equal(&is_on_the_line, &(x.is_zero() && y.is_zero()))
        },
    );
}
