//! The theorems of rays and Bézier patches, in the order of the text. The book shows their doc comments.

use std::cell::Cell;

use facette::algebra::{Real, Vector3, VectorSpace, length};
use facette::bspline::{BsplineSurface, KnotVector};
use facette::intersection::bezier_patch::PatchIntersector;
use facette::intersection::{Hit, Intersect, nearest};
use facette::ray::Ray;
use facette::surface::Surface;
use proptest::prelude::*;

use crate::common::bound::Bound;
use crate::common::law::{Broken, Law, Verdict, expect_at_most, expect_equal};
use crate::common::oracle::big;
use crate::patch_inputs::{ThroughAPoint, big_patch_point, hard, near_meeting, patch, wild};
use crate::patch_oracle::{bilinear_roots, refined_root};
use crate::suspects;

/// Rays nearer to the tangent plane than this are left out, and counted: the patch says of itself that it may take them for edge-on.
const NEARLY_EDGE_ON: f64 = 1.0 / (1 << 20) as f64;

/// How far from parallel the ray is to the tangent plane of the patch: `|d · (S_u × S_v)| / (|d| |S_u| |S_v|)`.
fn transversality(surface: &BsplineSurface<[f64; 3]>, [u, v]: [f64; 2], d: [f64; 3]) -> f64 {
    let [s_u, s_v] = surface
        .partials(u, v)
        .expect("a polynomial has derivatives");
    let scale = length(d) * length(s_u) * length(s_v);
    if scale > 0.0 {
        d.dot(s_u.cross(s_v)).abs() / scale
    } else {
        0.0
    }
}

/// The ray through the input's point in a type with fewer digits, which hold it too.
fn meets_its_point<S>(input: &ThroughAPoint, skipped: &Cell<u32>) -> Verdict
where
    S: Real,
{
    let patch = input.patch::<S>();
    let double = input.patch::<f64>();
    let is_kept = input
        .point()
        .iter()
        .chain(&input.ray().origin)
        .all(|&x| S::from_f64(x).to_f64() == x);
    let ray = input.ray();
    if !is_kept
        || transversality(double.surface(), input.parameters(), ray.direction) < NEARLY_EDGE_ON
    {
        skipped.set(skipped.get() + 1);
        return Ok(());
    }
    let to = |p: [f64; 3]| p.map(S::from_f64);
    let ray = Ray::new(to(ray.origin), to(ray.direction));
    let found = patch.intersect(&ray);
    let t = f64::from(input.t);
    let first = found.map(|hit| hit.t.to_f64() - hit.t_error.to_f64());
    if first.is_none_or(|first| first > t) {
        return Err(Broken {
            expected: format!("a hit at t = {t} or before"),
            got: format!("{found:?}"),
        });
    }
    // Others may be nearer: each is passed, until the ray has come to the point or beyond it.
    let mut from = ray;
    while let Some(hit) = patch.intersect(&from) {
        let [at, error] = [hit.t.to_f64(), hit.t_error.to_f64()];
        if (at - t).abs() <= error {
            return Ok(());
        }
        if at > t {
            break;
        }
        from = from.after(hit.t);
    }
    Err(Broken {
        expected: format!("a hit at t = {t} within its t_error"),
        got: format!("{:?} and none after it", from.start),
    })
}

/// **No root is missed.** Take any Bézier patch, with folds, crossings and degrees up to four, and a ray that passes through a point of it. The patch is hit there, or before. Passing on from hit to hit,
/// the ray comes to the point itself, within `t_error` of its $t$: in the middle of the patch, on its sides and in its corners, in both precisions. Left out are rays within $10^{-6}$ of the tangent
/// plane, where a rounding of the patch moves the root by a million roundings.
///
/// The point and the ray are made of whole numbers and powers of two, so that the ray passes through the point *exactly*.
///
/// Course: R10, slide 101, more methods of intersection.
#[test]
fn no_root_of_a_patch_is_missed() {
    let skipped = [Cell::new(0), Cell::new(0)];
    let law = Law::new(
        "intersection::no_root_of_a_patch_is_missed",
        suspects::library,
    );
    law.on_cases(1000).holds(wild(), hard(), |input| {
        meets_its_point::<f64>(input, &skipped[0])?;
        meets_its_point::<f32>(input, &skipped[1])
    });
    let skipped = skipped.map(Cell::into_inner);
    println!("left out: {skipped:?} of 1000");
    assert!(
        skipped[0] <= 100 && skipped[1] <= 700,
        "{skipped:?} of 1000 rays left out"
    );
}

/// The patch and the ray in single precision or in double, with hits as doubles.
fn keeps_its_bounds<S>(input: &ThroughAPoint, bounds: [&Bound; 2], hits: &Cell<u32>) -> Verdict
where
    S: Real,
{
    let (points, ray) = near_meeting(input);
    let to = |p: [f64; 3]| p.map(S::from_f64);
    let points: Vec<[S; 3]> = points.into_iter().map(to).collect();
    let ray = Ray::new(to(ray.origin), to(ray.direction));
    let Some(hit) = patch(input.degrees, points.clone()).intersect(&ray) else {
        return Ok(());
    };
    let wide = |p: [S; 3]| p.map(S::to_f64);
    let points: Vec<[f64; 3]> = points.into_iter().map(wide).collect();
    let ray = Ray::new(wide(ray.origin), wide(ray.direction));
    let [u, v] = hit
        .parameters
        .expect("a patch has parameters")
        .map(S::to_f64);
    let surface = patch(input.degrees, points.clone());
    if transversality(surface.surface(), [u, v], ray.direction) < 0.01 {
        return Ok(());
    }
    hits.set(hits.get() + 1);
    let exact = refined_root(input.degrees, &points, &ray, [u, v]);
    bounds[0].holds(hit.t.to_f64(), &exact.t, hit.t_error.to_f64())?;
    let on_surface = big_patch_point(input.degrees, &points, [&big(u), &big(v)]);
    for (computed, exact) in wide(hit.point).into_iter().zip(&on_surface) {
        bounds[1].holds(computed, exact, hit.point_error.to_f64())?;
    }
    Ok(())
}

/// **Two bounds.** The $t$ of a hit is within `t_error` of the exact root, for the exact patch and ray. The point of the hit is within `point_error` of the exact point of the patch at the hit's
/// parameters, coordinate by coordinate: so it lies next to the patch, however far away the ray began.
///
/// *The first.* In the ray's coordinates, with the largest coordinate of $P_{ij}-o$ as the unit, projecting costs $9\mathbf u$, each halving in $u$ or $v$ another $2p\,\mathbf u$ or $2q\,\mathbf u$, the
/// evaluation $6(p+q)\mathbf u$ and the certificate's equations $5\mathbf u$ of their size. Let $\varepsilon$ be the sum. As the certificate has $|G(x)-G(y)|\ge\frac34|x-y|$, the root is at most
/// $\frac43(|G(x)|+\varepsilon)$ away from $x$, and its depth differs by at most that times the largest derivatives. These are worst cases of sums of dozens of roundings, all of one sign: the largest error seen is a thirtieth to a hundredth in double
/// precision; in single precision the bound is that of rounding $t$, and is nearly attained.
///
/// *The second.* The point is evaluated as a B-spline without inner knots: $(6p+6q+2)\mathbf u$ of the largest coordinate.
#[test]
fn patch_hits_keep_their_bounds() {
    let bounds = std::array::from_fn::<_, 4, _>(|_| Bound::default());
    let hits = Cell::new(0);
    let law = Law::new(
        "intersection::patch_hits_keep_their_bounds",
        suspects::library,
    );
    law.on_cases(64).holds(wild(), hard(), |input| {
        keeps_its_bounds::<f64>(input, [&bounds[0], &bounds[1]], &hits)?;
        keeps_its_bounds::<f32>(input, [&bounds[2], &bounds[3]], &hits)
    });
    assert!(hits.get() >= 64, "{} hits of 128 rays", hits.get());
    for (bound, part) in bounds.iter().zip([0.003, 0.03, 0.2, 0.2]) {
        bound.is_used_up_to(part);
    }
}

/// **The nearest of two.** A bilinear patch is met where a quadratic equation in $u$ says, at most twice. For every ray, the hit is the nearer root of that equation with $u$ and $v$ in $[0,1]$, and there is no hit where there is no
/// such root.
///
/// The roots are computed from the equation's exact coefficients, to 100 binary digits; rays whose roots lie within $10^{-9}$ of a side of the patch or of each other are left out.
///
/// Course: R06, slide 95, the nearest root with t > 0.
#[test]
fn nearest_root_of_a_bilinear_patch_is_that_of_its_quadratic() {
    let [near, skipped, twice] = [Cell::new(0), Cell::new(0), Cell::new(0)];
    let law = Law::new(
        "intersection::nearest_root_of_a_bilinear_patch_is_that_of_its_quadratic",
        suspects::library,
    );
    let saddles = |input: ThroughAPoint| ThroughAPoint {
        degrees: [1, 1],
        control_points: input.control_points[..4].to_vec(),
        ..input
    };
    let [ordinary, difficult] = [
        wild().prop_map(saddles).boxed(),
        hard().prop_map(saddles).boxed(),
    ];
    law.on_cases(2000).holds(ordinary, difficult, |input| {
        let (points, ray) = near_meeting(input);
        let Some(roots) = bilinear_roots(&points, &ray) else {
            skipped.set(skipped.get() + 1);
            return Ok(());
        };
        twice.set(twice.get() + u32::from(roots.len() == 2));
        let hit = patch([1, 1], points).intersect(&ray);
        match (roots.first(), hit) {
            (None, None) => Ok(()),
            (Some(&t), Some(hit)) => {
                near.set(near.get() + 1);
                // The oracle's t is rounded to double precision at the end.
                let rounding = 4.0 * f64::EPSILON * t.abs();
                expect_at_most("a distance in t", hit.t_error + rounding, (hit.t - t).abs())
            }
            other => Err(Broken {
                expected: format!("{:?}", other.0),
                got: format!("{:?}", other.1),
            }),
        }
    });
    println!("{near:?} hits, {twice:?} of them twice, {skipped:?} left out");
    assert!(near.get() >= 500 && twice.get() >= 50 && skipped.get() <= 500);
}

/// **A graph from above.** The patch $z=f(x,y)$ over a square is met by a vertical ray exactly once, at the height $f$: $t=o_z-f(o_x,o_y)$. With $x=pu$ and $y=qv$ as linear functions in Bézier form the control points are
/// $(i,j,f_{ij})$.
#[test]
fn graph_is_hit_at_its_height() {
    let law = Law::new(
        "intersection::graph_is_hit_at_its_height",
        suspects::library,
    );
    let as_graph = |mut input: ThroughAPoint| {
        let columns = input.degrees[0] + 1;
        for (place, point) in input.control_points.iter_mut().enumerate() {
            let [i, j] = [place % columns, place / columns];
            point[0] = i32::try_from(i).expect("a small degree");
            point[1] = i32::try_from(j).expect("a small degree");
        }
        input.direction = [0, 0, -1];
        input
    };
    let [ordinary, difficult] = [
        wild().prop_map(as_graph).boxed(),
        hard().prop_map(as_graph).boxed(),
    ];
    law.on_cases(500).holds(ordinary, difficult, |input| {
        let patch = input.patch::<f64>();
        let ray = input.ray();
        let Some(hit) = patch.intersect(&ray) else {
            return Err(Broken {
                expected: format!("a hit at {}", input.t),
                got: "none".to_owned(),
            });
        };
        expect_at_most(
            "a distance in t",
            hit.t_error,
            (hit.t - f64::from(input.t)).abs(),
        )?;
        expect_equal(
            &None,
            &patch.intersect(&ray.after(hit.t)).map(|second| second.t),
        )
    });
}

/// **Across the seams.** A B-spline surface is met as its Bézier pieces. Neighbours share the control points of their common side, so a ray aimed at it exactly, or at a corner where four pieces meet, hits one of them at least.
#[test]
fn no_ray_slips_between_the_pieces_of_a_surface() {
    let knots = KnotVector::new(2, vec![0., 0., 0., 1., 2., 2., 3., 3., 3.]).expect("knots");
    let heights = [
        3, -1, 4, 1, -5, 9, 2, -6, 5, 3, -5, 8, 9, 7, -9, 3, 2, 3, -8, 4, 6, 2, -6, 4, 3, 3, 8, 3,
        2, 7, -9, 5, 0, 2, 8, 8,
    ];
    let point =
        |(k, &height): (usize, &i32)| [(k % 6) as f64, (k / 6) as f64, f64::from(height) / 4.0];
    let points = heights.iter().enumerate().map(point).collect();
    let surface = BsplineSurface::new([knots.clone(), knots], points).expect("a net of 6 x 6");
    let pieces = PatchIntersector::pieces_of(&surface).expect("of degree 2");
    assert_eq!(pieces.len(), 9);
    let on_a_seam = (
        prop::sample::select(vec![1.0, 2.0]),
        0.0..=3.0_f64,
        any::<bool>(),
    )
        .prop_map(|(knot, other, turned)| if turned { [other, knot] } else { [knot, other] });
    let at_a_corner = prop::sample::select(vec![[1.0, 1.0], [1.0, 2.0], [2.0, 1.0], [2.0, 2.0]]);
    let direction = || (-0.3..0.3_f64, -0.3..0.3_f64).prop_map(|(x, y)| [x, y, -1.0]);
    let law = Law::new(
        "intersection::no_ray_slips_between_the_pieces_of_a_surface",
        suspects::library,
    );
    let [ordinary, difficult] = [
        (on_a_seam, direction()).boxed(),
        (at_a_corner, direction()).boxed(),
    ];
    law.on_cases(1000)
        .holds(ordinary, difficult, |&([u, v], d)| {
            // The origin is rounded: the ray passes the seam within a rounding, on either side.
            let origin = surface.point(u, v).minus(d.times(8.0));
            let found: Option<(usize, Hit<[f64; 3]>)> = nearest(&pieces, &Ray::new(origin, d));
            if found.is_some() || transversality(&surface, [u, v], d) < NEARLY_EDGE_ON {
                return Ok(());
            }
            Err(Broken {
                expected: "a hit".to_owned(),
                got: "none".to_owned(),
            })
        });
}
