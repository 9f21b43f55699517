//! Evaluation in floating point: the two ways against each other and against exact numbers, derivatives and normals next to a vertex.

use std::cell::Cell;

use facette::algebra::{Real, Vector3, VectorSpace, length};
use facette::mesh::Mesh;
use facette::subdivision::Corners;
use facette::subdivision::evaluate::{CatmullClarkSurface, LoopSurface};
use facette::subdivision::limit::catmull_clark_eigenvalues;
use proptest::prelude::*;

use crate::common::dice::Dice;
use crate::common::exact::{Exact, fraction};
use crate::common::law::{Law, Verdict, expect_at_most};
use crate::common::oracle::{Big, largest_error};
use crate::limit_inputs::joined;
use crate::meshes::{Topology, double_fan, quad_fan};
use crate::suspects;

type Point = [f64; 3];

const U: f64 = f64::EPSILON / 2.0;

/// Points with coordinates between −1 and 1.
fn random_mesh(topology: &Topology, seed: u64) -> Mesh<Point> {
    let mut dice = Dice::new(seed);
    let points = (0..topology.vertex_count).map(|_| dice.vector());
    topology.with_points(points.collect())
}

fn quadrilaterals(mesh: &Mesh<Point>) -> CatmullClarkSurface<Point> {
    let surface = CatmullClarkSurface::new(&joined(mesh), &mesh.positions, Corners::Sharp);
    surface.expect("finite points")
}

fn triangles(mesh: &Mesh<Point>) -> LoopSurface<Point> {
    LoopSurface::new(&joined(mesh), &mesh.positions, Corners::Sharp).expect("finite points")
}

/// A valence, a seed for points, and parameters at the extraordinary vertex.
type Place = (u32, u64, [f64; 2]);

fn places() -> impl Strategy<Value = Place> {
    let near = (0..40_i32, 0.3..1.0_f64, 0.0..1.0_f64)
        .prop_map(|(steps, s, ratio)| [s * 0.5_f64.powi(steps), s * ratio * 0.5_f64.powi(steps)]);
    (3..=50_u32, any::<u64>(), near)
}

/// Valences at which eigenvalues coincide or nearly do, and extreme ones; parameters down to the smallest number.
fn hard_places() -> impl Strategy<Value = Place> {
    let valence = prop::sample::select(vec![3, 4, 6, 8, 12, 100, 199, 200]);
    let tiny = prop::sample::select(vec![1e-30, 1e-300, f64::MIN_POSITIVE, f64::from_bits(8)]);
    let near = (tiny, prop::bool::ANY).prop_map(|(tiny, swapped)| {
        if swapped {
            [0.0, tiny]
        } else {
            [tiny, tiny / 3.0]
        }
    });
    (valence, any::<u64>(), near)
}

/// The largest part of a bound that was used up.
#[derive(Default)]
struct Used(Cell<f64>);

impl Used {
    fn within(&self, what: &str, bound: f64, error: f64) -> Verdict {
        self.0.set(self.0.get().max(error / bound));
        expect_at_most(what, bound, error)
    }

    fn at_least(&self, part: f64) {
        println!("used up: {}", self.0.get());
        assert!(self.0.get() >= part, "only {} of the bound", self.0.get());
    }
}

fn steps_to([s, t]: [f64; 2]) -> f64 {
    (-s.max(t).log2()).max(0.0).ceil()
}

/// **Stam's way and the adaptive way give the same point.** With control points no further than $D$ from each other in any coordinate, the two differ by at most $(2n+64)\,\mathbf u D$ at a vertex of valence $n$, for every parameter down to the smallest numbers.
///
/// The sum of the two bounds of the next theorem. Both are sums of every rounding at its worst. Of those only the last few, of the largest numbers, are seen: a distance of $\mathbf uD$, a hundredth of the bound.
#[test]
fn stam_and_adaptive_evaluation_agree_within_their_bound() {
    let used = [Used::default(), Used::default()];
    let law = Law::new(
        "subdivision::stam_and_adaptive_evaluation_agree_within_their_bound",
        suspects::library,
    );
    law.holds(places(), hard_places(), |&(n, seed, [s, t])| {
        let bound = (2.0 * f64::from(n) + 64.0) * U * 2.0;
        let adaptive = quadrilaterals(&random_mesh(&quad_fan(n), seed));
        let [a, b] = [adaptive.clone(), adaptive.with_eigenbasis()]
            .map(|surface| surface.corner_point(0, s, t).expect("a half-edge"));
        used[0].within("a distance", bound, a.minus(b).largest_coordinate())?;
        let adaptive = triangles(&random_mesh(&double_fan(n), seed));
        let [a, b] = [adaptive.clone(), adaptive.with_eigenbasis()].map(|surface| {
            surface
                .point(0, [1.0 - s - t, s / 2.0, t / 2.0])
                .expect("a face")
        });
        used[1].within("a distance", bound, a.minus(b).largest_coordinate())
    });
    // Why so little: see above.
    for used in &used {
        used.at_least(0.002);
    }
}

/// **The same derivatives, to the last bits at any depth.** After $k$ steps tangents of the two ways differ by at most $(2k+40n)\,\mathbf u$ of their length, down to parameters of $2^{-1074}$.
///
/// The eigenvalue $2\lambda$ is rounded, and its $k$-th power has $k$ times that error, and $\log_2k$ roundings of its own: $2k\,\mathbf u$. What each step of the adaptive way rounds is relative to what is left; $40n\,\mathbf u$ is what a ring of $2n+1$ points with tangents that nearly cancel may add at the start.
#[test]
fn both_ways_have_the_same_tangents_at_any_depth() {
    let used = [Used::default(), Used::default()];
    let law = Law::new(
        "subdivision::both_ways_have_the_same_tangents_at_any_depth",
        suspects::library,
    );
    law.holds(places(), hard_places(), |&(n, seed, [s, t])| {
        let bound = (2.0 * steps_to([s, t]) + 40.0 * f64::from(n)) * U;
        let part = |a: [Point; 2], b: [Point; 2]| {
            let size = |v: Point| v.largest_coordinate();
            let apart = size(a[0].minus(b[0])).max(size(a[1].minus(b[1])));
            apart / size(a[0]).max(size(a[1]))
        };
        let adaptive = quadrilaterals(&random_mesh(&quad_fan(n), seed));
        let [a, b] = [adaptive.clone(), adaptive.with_eigenbasis()].map(|surface| {
            surface
                .corner_derivatives(0, s, t)
                .expect("no vertex")
                .first
        });
        used[0].within("a part of the tangents", bound, part(a, b))?;
        // At valence 3 Loop's tangents halve with the parameters, and would be denormal numbers themselves.
        let adaptive = triangles(&random_mesh(&double_fan(n.max(4)), seed));
        let place = [1.0 - s - t, s / 2.0, t / 2.0];
        let [a, b] = [adaptive.clone(), adaptive.with_eigenbasis()]
            .map(|surface| surface.derivatives(0, place).expect("no vertex").first);
        used[1].within("a part of the tangents", bound, part(a, b))
    });
    for used in &used {
        used.at_least(0.05);
    }
}

/// **The error against exact numbers.** For control points that are small whole numbers, the adaptive way is within $32\,\mathbf u D$ of the exact point, and Stam's within $(2n+32)\,\mathbf u D$, in double and in single precision, $D$ the largest difference of coordinates.
///
/// The mean of $n$ differences, summed in turn, is wrong by $(\frac n2+4)\,\mathbf uD$; in the limit mask and in the step before, such means weigh $\frac5{n+5}$ and less, which makes $5\,\mathbf uD$ each. The 16 weights of a regular patch are wrong by $17\,\mathbf u$, their sum by 16 more, of points that are no further than $0.6D$ from the limit. Two
/// sums remain. Later steps round what has become smaller. Stam's $2n$ coordinates are rounded once each at the least. The exact point comes from the adaptive way over fractions, whose every mask is rational. That all roundings go the same way is not to be expected: a fiftieth of the bound is seen.
#[test]
fn evaluation_error_stays_below_its_bound() {
    let used = [Used::default(), Used::default()];
    let law = Law::new(
        "subdivision::evaluation_error_stays_below_its_bound",
        suspects::library,
    );
    let places = |steps: std::ops::Range<u32>| {
        let coordinates = proptest::collection::vec([-50..50_i32, -50..50, -50..50], 64);
        (3..12_u32, coordinates, (0..8_i32, 1..8_i32), steps)
    };
    law.on_cases(48)
        .holds(places(0..6), places(6..14), |(n, whole, (a, b), steps)| {
            let topology = quad_fan(*n);
            let whole = &whole[..topology.vertex_count];
            let place = [*a, *b].map(|numerator| fraction(numerator, 8 << steps));
            let exact =
                topology.with_points(whole.iter().map(|p| p.map(|x| fraction(x, 1))).collect());
            let exact = CatmullClarkSurface::new(&joined(&exact), &exact.positions, Corners::Sharp);
            let exact = exact.expect("finite").corner_point(0, place[0], place[1]);
            let exact = exact.expect("a half-edge").map(to_big);
            let bounds = [32.0, f64::from(2 * *n + 32)].map(|roundings| roundings * 100.0);
            let [s, t] = [*a, *b].map(|numerator| f64::from(numerator) / f64::from(8 << steps));
            let double = topology.with_points(whole.iter().map(|p| p.map(f64::from)).collect());
            let surface = quadrilaterals(&double);
            let both = [surface.clone(), surface.with_eigenbasis()];
            for (surface, bound) in both.into_iter().zip(bounds) {
                let point = surface.corner_point(0, s, t).expect("a half-edge");
                used[0].within("an error", bound, largest_error(point, &exact, U))?;
            }
            let single: Vec<_> = whole.iter().map(|p| p.map(|x| x as f32)).collect();
            let single = topology.with_points(single);
            let surface =
                CatmullClarkSurface::new(&joined(&single), &single.positions, Corners::Sharp);
            let surface = surface.expect("finite points");
            let both = [surface.clone(), surface.with_eigenbasis()];
            for (surface, bound) in both.into_iter().zip(bounds) {
                let point = surface.corner_point(0, f32::from_f64(s), f32::from_f64(t));
                let point = point.expect("a half-edge").map(f64::from);
                let unit = f64::from(f32::EPSILON / 2.0);
                used[1].within("an error", bound, largest_error(point, &exact, unit))?;
            }
            Ok(())
        });
    for used in &used {
        used.at_least(0.01);
    }
}

/// The same number without a limit of size.
fn to_big(value: Exact) -> Big {
    let text = format!("{value:?}");
    let part = |text: &str| text.parse().expect("a whole number");
    match text.split_once('/') {
        Some((numerator, denominator)) => Big::new(part(numerator), part(denominator)),
        None => Big::from_integer(part(&text)),
    }
}

/// **Derivatives are multiplied by $2\lambda$.** Halve the parameters near a vertex of valence $n$: the ring shrinks by $\lambda$, the parameters by $\frac12$, and the first derivatives are multiplied by $2\lambda$ in the end. With Catmull-Clark that is 0.82 at $n=3$: derivatives vanish in the vertex. At $n=4$ it is 1, and from $n=5$ on more
/// than 1: derivatives are unbounded. The surface is smooth, its parameters are not.
///
/// What remains of other modes after 900 steps is $(\mu/\lambda)^{900}$, nothing for $n\le8$; two quotients of lengths with the error of the theorem before are $4\cdot1000\,\mathbf u$ and more: the bound is $2^{-40}$.
///
/// Course: D23, slide 76, Catmull-Clark: continuity at extraordinary points.
#[test]
fn derivatives_grow_by_twice_the_eigenvalue() {
    let law = Law::new(
        "subdivision::derivatives_grow_by_twice_the_eigenvalue",
        suspects::library,
    );
    let direction = || (0.5..1.0_f64, 0.0..1.0_f64);
    law.on_cases(32).holds(
        (4..8_u32, any::<u64>(), direction()),
        (Just(3_u32), any::<u64>(), direction()),
        |&(n, seed, (s, t))| {
            let surface = quadrilaterals(&random_mesh(&quad_fan(n), seed)).with_eigenbasis();
            let size = |steps: i32| {
                let unit = 0.5_f64.powi(steps);
                let derivatives = surface.corner_derivatives(0, s * unit, t * unit);
                length(derivatives.expect("no vertex").first[0])
            };
            let growth = 2.0 * catmull_clark_eigenvalues::<f64>(n as usize).tangent;
            let error = (size(901) / size(900) / growth - 1.0).abs();
            expect_at_most("a relative error", 0.5_f64.powi(40), error)
        },
    );
}

/// **Normals approach the limit's.** At the parameters $2^{-k}(s,t)$ the unit normal is within $100\,(\mu/\lambda)^k$ of the one that the limit mask gives at the vertex, $\mu$ the third eigenvalue, up to the rounding of tangents: from every face around the vertex, so that the surface has a tangent plane there.
///
/// The tangents are $\lambda^k$ times those of the limit, plus terms in $\mu^k$; 100 is for rings whose tangents are short, of which those with an area below a tenth are left out, and counted.
///
/// Course: D23, slide 76, Catmull-Clark: C1 at extraordinary points.
#[test]
fn normals_near_a_vertex_approach_the_limits() {
    let left_out = Cell::new(0);
    let law = Law::new(
        "subdivision::normals_near_a_vertex_approach_the_limits",
        suspects::library,
    );
    law.holds(places(), hard_places(), |&(n, seed, [s, t])| {
        let surface = quadrilaterals(&random_mesh(&quad_fan(n), seed)).with_eigenbasis();
        let faces = (0..n.min(12)).map(|face| 4 * face);
        let at_vertex = surface.corner_normal(0, 0.0, 0.0).expect("tangents");
        let eigenvalues = catmull_clark_eigenvalues::<f64>(n as usize);
        let decay = (eigenvalues.next / eigenvalues.tangent).powf(steps_to([s, t]));
        for half_edge in faces {
            let derivatives = surface
                .corner_derivatives(half_edge, s, t)
                .expect("no vertex");
            let [a, b] = derivatives.first;
            if length(a.cross(b)) < 0.1 * length(a) * length(b) {
                left_out.set(left_out.get() + 1);
                continue;
            }
            let normal = surface
                .corner_normal(half_edge, s, t)
                .expect("two tangents");
            let apart = normal.minus(at_vertex).largest_coordinate();
            expect_at_most("a distance of normals", 100.0 * decay + 1e5 * U, apart)?;
        }
        Ok(())
    });
    println!("left out: {}", left_out.get());
    assert!(left_out.get() < 64 * 6);
}
