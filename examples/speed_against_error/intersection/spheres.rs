//! The variants for spheres and boxes. All inputs are numbers of single precision, so that both precisions have the same truths.

use facette::algebra::{VectorSpace, unit_vector};
use facette::intersection::{
    BoundingBox, Intersect, SlabRay, Sphere, first_root, roots_by_projection, roots_by_quadratic,
};
use facette::ray::Ray;
use num_traits::{AsPrimitive, Signed, Zero};

use super::roots::big_roots;
use super::variants_spheres::{ignoring_slabs, propagating_slabs, slabs_by_sign, unwidened_slabs};
use crate::Visitor;
use crate::answers::{Answer, Truth, Truths};
use crate::common::oracle::{Big, big, big_minus, big_point};
use crate::float_inputs::FloatPoint;
use crate::harness::{Comparison, Effort, lazily};

type Point = [f64; 3];

/// A scalar of this report.
trait Float: facette::algebra::Real + Into<f64> {}

impl Float for f32 {}
impl Float for f64 {}

/// The number that is number `index` of an evenly spread sequence in [−1, 1], one sequence for each `factor`.
fn spread(index: usize, factor: f64) -> f64 {
    2.0 * (index as f64 * factor).fract() - 1.0
}

fn spread_point(index: usize, [x, y, z]: [f64; 3]) -> Point {
    [spread(index, x), spread(index, y), spread(index, z)]
}

fn single(point: Point) -> Point {
    <[f32; 3]>::rounded(point).map(f64::from)
}

const SPHERE: (Point, f64) = ([0.5, -0.25, 0.125], 1.0);

/// The line through a point at the distance `rho` from the centre, from `distance` before it.
fn line(index: usize, rho: f64, distance: f64) -> Ray<Point> {
    let (centre, radius) = SPHERE;
    let direction = unit_vector(spread_point(index, [0.754_877, 0.569_84, 0.430_16]))
        .unwrap_or([0.0, 0.0, 1.0]);
    let other = spread_point(index, [0.618_034, 0.414_214, 0.732_051]);
    let along = direction.times(other.into_iter().zip(direction).map(|(a, b)| a * b).sum());
    let across = unit_vector(other.minus(along)).unwrap_or([1.0, 0.0, 0.0]);
    let nearest = centre.plus(across.times(rho * radius));
    let length = 1.0 + 0.5 * spread(index, 0.236_068);
    Ray::new(
        single(nearest.minus(direction.times(distance))),
        single(direction.times(length)),
    )
}

fn sphere_rays(inputs: &str, count: usize) -> Vec<Ray<Point>> {
    let typical = |index| {
        line(
            index,
            0.6 + 0.6 * spread(index, 0.303),
            3.0 + 2.0 * spread(index, 0.847),
        )
    };
    // From a thousand radii, and every second one within 1 % of the tangent.
    let hard = |index| {
        let near_tangent = 1.0 + 0.01 * spread(index, 0.303);
        let rho = if index.is_multiple_of(2) {
            near_tangent
        } else {
            0.6 + 0.6 * spread(index, 0.303)
        };
        line(index, rho, 1000.0)
    };
    (1..=count)
        .map(|index| {
            if inputs == "hard" {
                hard(index)
            } else {
                typical(index)
            }
        })
        .collect()
}

fn rounded<S: Float>(rays: &[Ray<Point>]) -> Vec<Ray<[S; 3]>>
where
    f64: AsPrimitive<S>,
{
    let point = |point: Point| point.map(AsPrimitive::as_);
    rays.iter()
        .map(|ray| Ray::new(point(ray.origin), point(ray.direction)))
        .collect()
}

fn sphere<S: Float>() -> Sphere<[S; 3]>
where
    f64: AsPrimitive<S>,
{
    let (centre, radius) = SPHERE;
    Sphere::new(centre.map(AsPrimitive::as_), radius.as_()).expect("a positive radius")
}

fn true_sphere_hit(ray: &Ray<Point>) -> Option<Truth> {
    let (centre, radius) = SPHERE;
    let p = big_minus(&big_point(ray.origin), &big_point(centre));
    let roots = big_roots(&p, &big_point(ray.direction), &big(radius))?;
    let t = roots.into_iter().find(Signed::is_positive)?;
    Some(Truth {
        t,
        surfaces: vec![0],
    })
}

/// Fills the answers with what `ask` says of each ray.
fn asking<S, A>(rays: &[Ray<Point>], ask: A) -> impl FnMut(&mut [Option<Answer>]) + use<S, A>
where
    S: Float,
    f64: AsPrimitive<S>,
    A: Fn(&Ray<[S; 3]>) -> Option<S>,
{
    let rays = rounded::<S>(rays);
    move |answers| {
        for (place, ray) in answers.iter_mut().zip(&rays) {
            *place = Answer::of(ask(ray), 0);
        }
    }
}

/// The first root that the ray reaches, by one of the formulas.
fn by_roots<S: Float>(
    ball: Sphere<[S; 3]>,
    roots: impl Fn([S; 3], [S; 3], S) -> Option<[S; 2]>,
) -> impl Fn(&Ray<[S; 3]>) -> Option<S> {
    move |ray| {
        let p = ray.origin.minus(ball.centre());
        first_root(roots(p, ray.direction, ball.radius())?, ray)
    }
}

/// Adds the ways to meet a sphere in one precision.
fn sphere_variants<'a, S: Float>(
    comparison: Comparison<'a>,
    scalar: &'static str,
    rays: &[Ray<Point>],
    truths: &Truths<'a>,
) -> Comparison<'a>
where
    f64: AsPrimitive<S>,
{
    let ball = sphere::<S>();
    let hit = move |ray: &Ray<[S; 3]>| ball.intersect(ray).map(|hit| hit.t);
    let chord = move |ray: &Ray<[S; 3]>| first_root(ball.chord(ray)?, ray);
    comparison
        .answers(
            ["quadratic", scalar],
            truths,
            asking::<S, _>(rays, by_roots(ball, roots_by_quadratic)),
        )
        .answers(
            ["projection", scalar],
            truths,
            asking::<S, _>(rays, by_roots(ball, roots_by_projection)),
        )
        .answers(
            ["projection at any size", scalar],
            truths,
            asking::<S, _>(rays, chord),
        )
        .answers(
            ["hit with bounds", scalar],
            truths,
            asking::<S, _>(rays, hit),
        )
}

/// A box in single precision.
const BOX: [Point; 2] = [[-1.0, -0.5, 0.25], [0.75, 1.5, 2.0]];

fn bounds<S: Float>() -> BoundingBox<[S; 3]>
where
    f64: AsPrimitive<S>,
{
    let [min, max] = BOX.map(|corner| corner.map(AsPrimitive::as_));
    BoundingBox::new(min, max).expect("corners in order")
}

/// Rays that all meet the box in truth: to points in it, or to points of an edge and along the axes in a face.
fn box_rays(inputs: &str, count: usize) -> Vec<Ray<Point>> {
    let [min, max] = BOX;
    let ray = |index: usize| {
        let origin = single(spread_point(index, [0.754_877, 0.569_84, 0.430_16]).times(6.0));
        let weights = spread_point(index, [0.618_034, 0.414_214, 0.732_051]);
        let mut target: Point = std::array::from_fn(|axis| {
            min[axis] + (max[axis] - min[axis]) * (0.5 + 0.49 * weights[axis])
        });
        if inputs == "typical" {
            return Ray::new(origin, single(target.minus(origin)));
        }
        let axis = index % 3;
        target[axis] = max[axis];
        target[(axis + 1) % 3] = min[(axis + 1) % 3];
        if index.is_multiple_of(2) {
            let mut direction = [0.0, -0.0, 0.0];
            direction[(axis + 2) % 3] = 1.0;
            return Ray::new(single(target.minus(direction.times(4.0))), direction);
        }
        Ray::new(origin, single(target.minus(origin)))
    };
    (1..).map(ray).filter(meets_box).take(count).collect()
}

/// Whether the ray truly meets the box.
fn meets_box(ray: &Ray<Point>) -> bool {
    let [min, max] = BOX.map(big_point);
    let [o, d] = [ray.origin, ray.direction].map(big_point);
    let (mut entry, mut exit) = (Big::zero(), big(1e9));
    for axis in 0..3 {
        if d[axis].is_zero() {
            if o[axis] < min[axis] || max[axis] < o[axis] {
                return false;
            }
            continue;
        }
        let mut slab = [&min, &max].map(|corner| (&corner[axis] - &o[axis]) / &d[axis]);
        slab.sort();
        let [near, far] = slab;
        entry = entry.max(near);
        exit = exit.min(far);
    }
    entry <= exit
}

/// Yes, with a t of 0, or no, by one of the tests.
fn by_test<S: Float>(
    bounds: BoundingBox<[S; 3]>,
    test: impl Fn(&BoundingBox<[S; 3]>, &Ray<[S; 3]>) -> bool,
) -> impl Fn(&Ray<[S; 3]>) -> Option<S> {
    move |ray| test(&bounds, ray).then(S::zero)
}

/// Adds the ways to ask whether a box is met, in one precision. The answer is yes or no, and has no error.
fn box_variants<'a, S: Float>(
    comparison: Comparison<'a>,
    scalar: &'static str,
    rays: &[Ray<Point>],
    truths: &Truths<'a>,
) -> Comparison<'a>
where
    f64: AsPrimitive<S>,
{
    let bounds = bounds::<S>();
    let span = move |ray: &Ray<[S; 3]>| {
        bounds
            .span(ray)
            .filter(|span| span.exit >= S::zero())
            .map(|_| S::zero())
    };
    let prepared: Vec<_> = rounded::<S>(rays).iter().map(SlabRay::new).collect();
    let widened = move |answers: &mut [Option<Answer>]| {
        for (place, ray) in answers.iter_mut().zip(&prepared) {
            *place = Answer::of(bounds.may_be_hit_by(ray).then(S::zero), 0);
        }
    };
    comparison
        .answers(
            ["minimum and maximum: NaN spreads", scalar],
            truths,
            asking::<S, _>(rays, by_test(bounds, propagating_slabs)),
        )
        .answers(
            ["minimum and maximum: NaN ignored", scalar],
            truths,
            asking::<S, _>(rays, by_test(bounds, ignoring_slabs)),
        )
        .answers(
            ["sign of d", scalar],
            truths,
            asking::<S, _>(rays, by_test(bounds, slabs_by_sign)),
        )
        .answers(
            ["sign of 1/d", scalar],
            truths,
            asking::<S, _>(rays, by_test(bounds, unwidened_slabs)),
        )
        .answers(["division", scalar], truths, asking::<S, _>(rays, span))
        .answers(["prepared ray widened", scalar], truths, widened)
}

/// Hands the comparisons of spheres and boxes to the visitor.
pub fn visit(effort: Effort, visitor: &mut Visitor<'_>) {
    for inputs in ["typical", "hard"] {
        let rays = sphere_rays(inputs, effort.points);
        let truths: Truths<'_> = lazily(|| rays.iter().map(true_sphere_hit).collect());
        let comparison = Comparison::new("sphere", inputs, rays.len());
        let comparison = sphere_variants::<f64>(comparison, "f64", &rays, &truths);
        visitor(sphere_variants::<f32>(comparison, "f32", &rays, &truths));
    }
    for inputs in ["typical", "hard"] {
        let rays = box_rays(inputs, effort.points);
        let met = || {
            Some(Truth {
                t: Big::zero(),
                surfaces: vec![0],
            })
        };
        let truths: Truths<'_> = lazily(|| rays.iter().map(|_| met()).collect());
        let comparison = Comparison::new("box", inputs, rays.len());
        let comparison = box_variants::<f64>(comparison, "f64", &rays, &truths);
        visitor(box_variants::<f32>(comparison, "f32", &rays, &truths));
    }
}
