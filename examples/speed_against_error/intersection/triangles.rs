//! Single triangles.

use facette::algebra::{Real, VectorSpace};
use facette::intersection::FacetHit;
use facette::intersection::triangle::{
    BaldwinWeberTriangle, ShearedRay, ShevtsovTriangle, half_planes, moller_trumbore, robust,
    strict_half_planes, watertight,
};
use facette::ray::Ray;

use crate::Visitor;
use crate::answers::{Answer, Truth, Truths};
use crate::harness::{Comparison, Effort, lazily};
use triangle_floats::{ExactCrossing, FloatPlace, exactly};

/// A test of a triangle that is kept as a `T`.
type StoredTest<T, S> = fn(&T, &Ray<[S; 3]>) -> Option<FacetHit<S>>;

#[path = "../../../tests/intersection/triangle_floats.rs"]
#[allow(dead_code, reason = "the tests use more of it than this report")]
pub mod triangle_floats;

pub type Point = [f64; 3];
pub type Test<S> = fn(&[[S; 3]; 3], &Ray<[S; 3]>) -> Option<FacetHit<S>>;

/// How many triangles each ray is tried on.
const TRIANGLES: usize = 16;

/// Numbers between −1 and 1 that fill the interval evenly: multiples of an irrational number.
pub struct Steps(pub f64);

impl Steps {
    pub fn next(&mut self) -> f64 {
        self.0 += 1.0;
        // Squares keep neighbours from marching in step.
        2.0 * (self.0 * self.0 * 0.618_033_988_749_894_9).fract() - 1.0
    }

    pub fn vector(&mut self) -> Point {
        [self.next(), self.next(), self.next()]
    }
}

/// Triangles, and rays of which each is tried on all of them.
struct Scene {
    triangles: Vec<[Point; 3]>,
    rays: Vec<[Point; 2]>,
}

impl Scene {
    /// Triangles of any shape, and rays through the inside of one of them.
    fn typical(count: usize) -> Self {
        let mut steps = Steps(0.0);
        let triangles: Vec<_> = (0..TRIANGLES)
            .map(|_| [steps.vector(), steps.vector(), steps.vector()])
            .collect();
        let rays = (0..count).map(|index| {
            let [a, b, c] = triangles[index % TRIANGLES];
            let [v, w] = [0.3 + 0.25 * steps.next(), 0.3 + 0.25 * steps.next()];
            let target = a.plus(b.minus(a).times(v)).plus(c.minus(a).times(w));
            let origin = steps.vector().times(4.0);
            [origin, target.minus(origin)]
        });
        let rays = rays.collect();
        Self { triangles, rays }
    }

    /// A cap of triangles around corners that they share, 1000 from the origin, half of them slivers; rays at their edges and corners.
    fn hard(count: usize) -> Self {
        let mut steps = Steps(0.0);
        let far = [700.0, -500.0, 600.0];
        let rim: Vec<Point> = (0..TRIANGLES / 2)
            .map(|index| {
                let angle = std::f64::consts::TAU * index as f64 / (TRIANGLES / 2) as f64;
                far.plus([angle.cos(), angle.sin(), 0.2 * steps.next()])
            })
            .collect();
        let hub = far.plus([0.05, 0.03, 0.4]);
        let mut triangles = Vec::new();
        for (index, &a) in rim.iter().enumerate() {
            let b = rim[(index + 1) % rim.len()];
            let beyond = a.lerp(b, 0.5).plus(a.lerp(b, 0.5).minus(hub).times(1e-3));
            triangles.extend([[hub, a, b], [b, a, beyond]]);
        }
        let rays = (0..count).map(|index| {
            let [a, b, _] = triangles[index % TRIANGLES];
            let along = [0.0, 0.5, 0.25, 0.5 + 0.5 * steps.next()][index % 4];
            let target = a.lerp(b, along);
            let origin = far.plus([3.0 * steps.next(), 3.0 * steps.next(), 5.0]);
            [origin, target.minus(origin)]
        });
        let rays = rays.collect();
        Self { triangles, rays }
    }

    fn corners<S: Real>(&self) -> Vec<[[S; 3]; 3]> {
        self.triangles
            .iter()
            .map(|corners| corners.map(|corner| corner.map(S::from_f64)))
            .collect()
    }

    fn rays<S: Real>(&self) -> Vec<Ray<[S; 3]>> {
        self.rays.iter().map(|ray| rounded(*ray)).collect()
    }

    /// Each ray on each triangle, one after the other.
    fn each<S: Real>(&self, test: Test<S>) -> impl FnMut(&mut [Option<Answer>]) + use<S> {
        let (triangles, rays) = (self.corners::<S>(), self.rays::<S>());
        move |answers| {
            for (answers, ray) in answers.chunks_exact_mut(TRIANGLES).zip(&rays) {
                for (slot, corners) in answers.iter_mut().zip(&triangles) {
                    *slot = Answer::of(test(corners, ray).map(|hit| hit.t), 0);
                }
            }
        }
    }

    /// The shear computed once a ray.
    fn sheared<S: Real>(&self) -> impl FnMut(&mut [Option<Answer>]) + use<S> {
        let (triangles, rays) = (self.corners::<S>(), self.rays::<S>());
        move |answers| {
            for (answers, ray) in answers.chunks_exact_mut(TRIANGLES).zip(&rays) {
                let ray = ShearedRay::new(ray);
                for (slot, corners) in answers.iter_mut().zip(&triangles) {
                    *slot = Answer::of(ray.intersect(corners).map(|hit| hit.t), 0);
                }
            }
        }
    }

    /// Triangles prepared by `store`.
    fn stored<S: Real, T>(
        &self,
        store: fn(&[[S; 3]; 3]) -> Option<T>,
        test: StoredTest<T, S>,
    ) -> impl FnMut(&mut [Option<Answer>]) + use<S, T> {
        let triangles: Vec<Option<T>> = self.corners::<S>().iter().map(store).collect();
        let rays = self.rays::<S>();
        move |answers| {
            for (answers, ray) in answers.chunks_exact_mut(TRIANGLES).zip(&rays) {
                for (slot, triangle) in answers.iter_mut().zip(&triangles) {
                    let hit = triangle.as_ref().and_then(|triangle| test(triangle, ray));
                    *slot = Answer::of(hit.map(|hit| hit.t), 0);
                }
            }
        }
    }

    /// What exact arithmetic says of the inputs as the type has them.
    fn truths<S: Real>(&self) -> Vec<Option<Truth>> {
        let pairs = self.rays.iter().flat_map(|&[origin, direction]| {
            self.triangles.iter().map(move |&corners| FloatPlace {
                corners,
                origin,
                direction,
            })
        });
        pairs.map(|place| truth(&place.rounded::<S>(), 0)).collect()
    }
}

pub fn rounded<S: Real>(ray: [Point; 2]) -> Ray<[S; 3]> {
    let [origin, direction] = ray.map(|point| point.map(S::from_f64));
    Ray::new(origin, direction)
}

pub fn truth(place: &FloatPlace, surface: u32) -> Option<Truth> {
    let crossing = exactly(place).filter(ExactCrossing::is_hit)?;
    Some(Truth {
        t: crossing.t,
        surfaces: vec![surface],
    })
}

/// Hands all comparisons to the visitor.
pub fn visit(effort: Effort, visitor: &mut Visitor<'_>) {
    let count = 4 * effort.points;
    for (inputs, scene) in [
        ("typical", Scene::typical(count)),
        ("hard", Scene::hard(count)),
    ] {
        triangles(&scene, inputs, visitor);
    }
}

fn triangles(scene: &Scene, inputs: &'static str, visitor: &mut Visitor<'_>) {
    let wide: Truths<'_> = lazily(|| scene.truths::<f64>());
    let narrow: Truths<'_> = lazily(|| scene.truths::<f32>());
    let mut comparison = Comparison::new("triangle", inputs, scene.rays.len() * TRIANGLES);
    comparison = in_one_width::<f64>(comparison, scene, "f64", &wide);
    comparison = in_one_width::<f32>(comparison, scene, "f32", &narrow);
    visitor(comparison);
}

fn in_one_width<'a, S: Real>(
    comparison: Comparison<'a>,
    scene: &'a Scene,
    scalar: &'static str,
    truths: &Truths<'a>,
) -> Comparison<'a> {
    let shevtsov = scene.stored::<S, _>(ShevtsovTriangle::new, ShevtsovTriangle::intersect);
    let baldwin_weber =
        scene.stored::<S, _>(BaldwinWeberTriangle::new, BaldwinWeberTriangle::intersect);
    comparison
        .answers(
            ["half-planes >=", scalar],
            truths,
            scene.each::<S>(half_planes),
        )
        .answers(
            ["half-planes >", scalar],
            truths,
            scene.each::<S>(strict_half_planes),
        )
        .answers(
            ["Möller-Trumbore", scalar],
            truths,
            scene.each::<S>(moller_trumbore),
        )
        .answers(["watertight", scalar], truths, scene.each::<S>(watertight))
        .answers(
            ["watertight with kept shear", scalar],
            truths,
            scene.sheared::<S>(),
        )
        .answers(["Shevtsov", scalar], truths, shevtsov)
        .answers(["Baldwin-Weber", scalar], truths, baldwin_weber)
        .answers(["exact signs", scalar], truths, scene.each::<S>(robust))
}
