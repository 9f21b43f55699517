//! Fans of triangles, and flat quadrilaterals.

use facette::algebra::{Real, VectorSpace};
use facette::intersection::FacetHit;
use facette::intersection::fan::Fan;
use facette::intersection::quadrilateral::bilinear_patch;
use facette::intersection::triangle::{moller_trumbore, watertight};
use facette::ray::Ray;

use super::triangles::triangle_floats::FloatPlace;
use super::triangles::{Point, Steps, Test, rounded, truth};
use crate::Visitor;
use crate::answers::{Answer, Truth, Truths};
use crate::harness::{Comparison, Effort, lazily};

/// Hands all comparisons to the visitor.
pub fn visit(effort: Effort, visitor: &mut Visitor<'_>) {
    let count = 4 * effort.points;
    for (inputs, spread) in [("typical", 0.8), ("hard", 0.0)] {
        fans(inputs, spread, count, visitor);
    }
    flat_quadrilaterals(count, visitor);
}

/// Triangles around one corner.
struct Wheel {
    hub: Point,
    rim: Vec<Point>,
    rays: Vec<[Point; 2]>,
}

impl Wheel {
    /// Eight triangles, and rays at places inside, or at the spokes where `spread` is 0.
    fn new(spread: f64, count: usize) -> Self {
        let mut steps = Steps(0.0);
        let hub = [0.05, -0.03, 0.1];
        let rim: Vec<Point> = (0..8)
            .map(|index| {
                let angle = std::f64::consts::TAU * f64::from(index) / 8.0;
                [angle.cos(), angle.sin(), 0.2 * steps.next()]
            })
            .collect();
        let rays = (0..count).map(|index| {
            let [a, b] = [rim[index % 8], rim[(index + 1) % 8]];
            let target = hub.lerp(
                a.lerp(b, 0.5 * spread * (1.0 + steps.next())),
                0.5 + 0.4 * steps.next(),
            );
            let origin = [steps.next(), steps.next(), 4.0];
            [origin, target.minus(origin)]
        });
        let rays = rays.collect();
        Self { hub, rim, rays }
    }

    fn corners<S: Real>(&self) -> Vec<[[S; 3]; 3]> {
        (0..8)
            .map(|index| {
                [self.hub, self.rim[index], self.rim[(index + 1) % 8]]
                    .map(|corner| corner.map(S::from_f64))
            })
            .collect()
    }

    fn one_by_one<S: Real>(&self, test: Test<S>) -> impl FnMut(&mut [Option<Answer>]) + use<S> {
        let corners = self.corners::<S>();
        let rays: Vec<_> = self.rays.iter().map(|&ray| rounded::<S>(ray)).collect();
        move |answers| {
            for (slot, ray) in answers.iter_mut().zip(&rays) {
                *slot = None;
                for (surface, corners) in (0_u32..).zip(&corners) {
                    let hit = Answer::of(test(corners, ray).map(|hit| hit.t), surface);
                    if let Some(hit) = hit
                        && slot.is_none_or(|nearest| hit.t < nearest.t)
                    {
                        *slot = Some(hit);
                    }
                }
            }
        }
    }

    fn as_a_fan<S: Real>(&self) -> impl FnMut(&mut [Option<Answer>]) + use<S> {
        let point = |point: Point| point.map(S::from_f64);
        let fan = Fan::closed(point(self.hub), self.rim.iter().copied().map(point));
        let fan = fan.expect("eight finite points");
        let rays: Vec<_> = self.rays.iter().map(|&ray| rounded::<S>(ray)).collect();
        move |answers| {
            for (slot, ray) in answers.iter_mut().zip(&rays) {
                let hit = fan.intersect(ray);
                *slot = hit.and_then(|hit| {
                    let surface = u32::try_from(hit.triangle).expect("one of eight");
                    Answer::of(Some(hit.facet.t), surface)
                });
            }
        }
    }

    /// The nearest of the exact hits, with all triangles that are met there.
    fn truths<S: Real>(&self) -> Vec<Option<Truth>> {
        let corners: Vec<_> = self.corners::<f64>();
        let of_ray = |&[origin, direction]: &[Point; 2]| {
            let hits = (0_u32..).zip(&corners).filter_map(|(surface, &corners)| {
                let place = FloatPlace {
                    corners,
                    origin,
                    direction,
                };
                truth(&place.rounded::<S>(), surface)
            });
            hits.reduce(|mut nearest, hit| {
                if hit.t < nearest.t {
                    return hit;
                }
                if hit.t == nearest.t {
                    nearest.surfaces.extend(hit.surfaces);
                }
                nearest
            })
        };
        self.rays.iter().map(of_ray).collect()
    }
}

fn fans(inputs: &'static str, spread: f64, count: usize, visitor: &mut Visitor<'_>) {
    let wheel = Wheel::new(spread, count);
    let wide: Truths<'_> = lazily(|| wheel.truths::<f64>());
    let narrow: Truths<'_> = lazily(|| wheel.truths::<f32>());
    let comparison = Comparison::new("fan of 8 triangles", inputs, count)
        .answers(
            ["Möller-Trumbore", "f64"],
            &wide,
            wheel.one_by_one::<f64>(moller_trumbore),
        )
        .answers(
            ["watertight", "f64"],
            &wide,
            wheel.one_by_one::<f64>(watertight),
        )
        .answers(["fan", "f64"], &wide, wheel.as_a_fan::<f64>())
        .answers(
            ["Möller-Trumbore", "f32"],
            &narrow,
            wheel.one_by_one::<f32>(moller_trumbore),
        )
        .answers(
            ["watertight", "f32"],
            &narrow,
            wheel.one_by_one::<f32>(watertight),
        )
        .answers(["fan", "f32"], &narrow, wheel.as_a_fan::<f32>());
    visitor(comparison);
}

/// Flat quadrilaterals with small integer corners, once as two triangles, once as a patch.
fn flat_quadrilaterals(count: usize, visitor: &mut Visitor<'_>) {
    let mut steps = Steps(0.0);
    let corners = [[0., 0., 0.], [4., 1., 2.], [5., 5., 4.], [1., 4., 2.]];
    let rays: Vec<[Point; 2]> = (0..count)
        .map(|_| {
            let target = [2.5 + 3.0 * steps.next(), 2.5 + 3.0 * steps.next(), 2.0];
            let origin = [5.0 * steps.next(), 5.0 * steps.next(), 12.0];
            [origin, target.minus(origin)]
        })
        .collect();
    let [wide, narrow]: [Truths<'_>; 2] = [
        lazily(|| quadrilateral_truths::<f64>(corners, &rays)),
        lazily(|| quadrilateral_truths::<f32>(corners, &rays)),
    ];
    let comparison = Comparison::new("quadrilateral lying flat", "typical", count)
        .answers(
            ["two triangles", "f64"],
            &wide,
            on_quadrilateral::<f64>(corners, &rays, two_triangles),
        )
        .answers(
            ["bilinear", "f64"],
            &wide,
            on_quadrilateral::<f64>(corners, &rays, bilinear_patch),
        )
        .answers(
            ["two triangles", "f32"],
            &narrow,
            on_quadrilateral::<f32>(corners, &rays, two_triangles),
        )
        .answers(
            ["bilinear", "f32"],
            &narrow,
            on_quadrilateral::<f32>(corners, &rays, bilinear_patch),
        );
    visitor(comparison);
}

type QuadrilateralTest<S> = fn(&[[S; 3]; 4], &Ray<[S; 3]>) -> Option<FacetHit<S>>;

fn two_triangles<S: Real>(&[a, b, c, d]: &[[S; 3]; 4], ray: &Ray<[S; 3]>) -> Option<FacetHit<S>> {
    moller_trumbore(&[a, b, c], ray).or_else(|| moller_trumbore(&[a, c, d], ray))
}

fn on_quadrilateral<S: Real>(
    corners: [Point; 4],
    rays: &[[Point; 2]],
    test: QuadrilateralTest<S>,
) -> impl FnMut(&mut [Option<Answer>]) + use<S> {
    let corners = corners.map(|corner| corner.map(S::from_f64));
    let rays: Vec<_> = rays.iter().map(|&ray| rounded::<S>(ray)).collect();
    move |answers| {
        for (slot, ray) in answers.iter_mut().zip(&rays) {
            *slot = Answer::of(test(&corners, ray).map(|hit| hit.t), 0);
        }
    }
}

fn quadrilateral_truths<S: Real>(
    [a, b, c, d]: [Point; 4],
    rays: &[[Point; 2]],
) -> Vec<Option<Truth>> {
    let of_ray = |&[origin, direction]: &[Point; 2]| {
        let half = |corners| {
            let place = FloatPlace {
                corners,
                origin,
                direction,
            };
            truth(&place.rounded::<S>(), 0)
        };
        half([a, b, c]).or_else(|| half([a, c, d]))
    };
    rays.iter().map(of_ray).collect()
}
