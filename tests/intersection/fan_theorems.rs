//! The theorems of triangle fans.

use facette::algebra::{Real, VectorSpace};
use facette::intersection::fan::Fan;
use facette::intersection::triangle::moller_trumbore;
use facette::ray::Ray;
use proptest::collection::vec;
use proptest::prelude::*;

use crate::common::dice::Dice;
use crate::common::exact::{Exact, fraction};
use crate::common::generators::{parameter, point};
use crate::common::law::{Law, expect_equal};
use crate::suspects;
use crate::triangle_inputs::{Point, Test, at_weights};

/// A hub, a rim, an origin, and where to aim: weights on one triangle.
type Place = (Point, Vec<Point>, Point, usize, [Exact; 2]);

fn fans(weights: impl Strategy<Value = [Exact; 2]>) -> impl Strategy<Value = Place> {
    (point(), vec(point(), 3..=6), point(), 0..6_usize, weights)
}

fn inside() -> impl Strategy<Value = [Exact; 2]> {
    [parameter(), parameter()].prop_map(|[v, w]| [v, w * (fraction(1, 1) - v)])
}

/// At the hub, on the spokes, at the rim.
fn on_spokes() -> impl Strategy<Value = [Exact; 2]> {
    (parameter(), 0..4_usize).prop_map(|(t, kind)| {
        let [zero, one] = [0, 1].map(|x| fraction(x, 1));
        [[zero, zero], [t, zero], [zero, t], [t, one - t]][kind]
    })
}

/// **A fan is its triangles.** The nearest hit of a fan is the nearest among those of its triangles, and the first of them where several are met at the same $t$; so for open fans and for closed ones.
///
/// The triangle between two spokes has three edges. The ray passes a spoke on the side $s_i=\mathbf m\cdot(\mathbf p_i-\mathbf h)$ with $\mathbf m=\mathbf d\times(\mathbf h-\mathbf o)$ over the longest coordinate of $\mathbf d$, one scalar product each; $s_i$ and $-s_{i+1}$ are the weights of $\mathbf p_{i+1}$ and $\mathbf p_i$,
/// times $\mathbf d\cdot\mathbf n$.
///
/// Course: R10, slide 101, Ray and triangle: Galin and Akkouche's fans.
#[test]
fn fan_is_its_triangles() {
    let law = Law::new("intersection::fan_is_its_triangles", suspects::library);
    law.on_cases(256).holds(
        fans(inside()),
        fans(on_spokes()),
        |(hub, rim, o, which, weights)| {
            let mut closed = rim.clone();
            closed.push(rim[0]);
            let target = which % rim.len();
            let corners = [*hub, closed[target], closed[target + 1]];
            let ray = Ray::new(*o, at_weights(corners, *weights).minus(*o));
            let fan = Fan::closed(*hub, rim.clone()).expect("finite points");
            expect_equal(
                &nearest(*hub, &closed, &ray),
                &fan.intersect(&ray).map(|hit| (hit.triangle, hit.facet)),
            )?;
            let fan = Fan::open(*hub, rim.clone()).expect("finite points");
            expect_equal(
                &nearest(*hub, rim, &ray),
                &fan.intersect(&ray).map(|hit| (hit.triangle, hit.facet)),
            )
        },
    );
}

type Numbered = (usize, facette::intersection::FacetHit<Exact>);

fn nearest(hub: Point, rim: &[Point], ray: &Ray<Point>) -> Option<Numbered> {
    let mut nearest: Option<Numbered> = None;
    for (index, side) in rim.windows(2).enumerate() {
        let hit = moller_trumbore(&[hub, side[0], side[1]], ray);
        if let Some(hit) = hit
            && nearest.is_none_or(|(_, nearest)| hit.t < nearest.t)
        {
            nearest = Some((index, hit));
        }
    }
    nearest
}

/// A fan seen from above, and a ray at its hub or at a point of a spoke.
fn fan_and_ray<S: Real>(dice: &mut Dice) -> ([S; 3], Vec<[S; 3]>, Ray<[S; 3]>) {
    let hub = dice.vector().times(0.1);
    let count = 5 + dice.index(8);
    let rim: Vec<[f64; 3]> = (0..count)
        .map(|index| {
            let angle = std::f64::consts::TAU * (index as f64 + 0.4 * dice.roll()) / count as f64;
            [angle.cos(), angle.sin(), 0.3 * dice.roll()]
        })
        .collect();
    let along = if dice.index(2) == 0 {
        0.0
    } else {
        0.25 + 0.25 * dice.roll()
    };
    let target = hub.lerp(rim[dice.index(count)], along);
    let origin = [dice.roll(), dice.roll(), 3.0 + dice.roll()];
    let [hub, origin, direction] = [hub, origin, target.minus(origin)].map(|p| p.map(S::from_f64));
    let rim = rim.into_iter().map(|p| p.map(S::from_f64)).collect();
    (hub, rim, Ray::new(origin, direction))
}

/// How many of the rays that are aimed at hubs and spokes of fans meet none of their triangles.
pub fn lost<S: Real>(count: usize, test: Option<Test<[S; 3], S>>) -> usize {
    let mut dice = Dice::new(7);
    let rays = (0..count).map(|_| fan_and_ray::<S>(&mut dice));
    rays.filter(|(hub, rim, ray)| {
        let Some(test) = test else {
            let fan = Fan::closed(*hub, rim.clone()).expect("finite points");
            return fan.intersect(ray).is_none();
        };
        (0..rim.len()).all(|i| test(&[*hub, rim[i], rim[(i + 1) % rim.len()]], ray).is_none())
    })
    .count()
}

/// **A fan loses no ray inside.** Rays at the hub and the spokes of 100 000 fans all hit, in `f32` and in `f64`.
///
/// All spokes are multiplied with the same computed vector $\mathbf m$, which is perpendicular to the ray up to a roundoff of its own length, however short it is. Around a hub that the ray meets, $\mathbf m$ is nothing but rounding; still, spokes that
/// surround the ray lie on both sides of it, and going once around, the products change their sign from $\le0$ to $\ge0$ somewhere. Since each product serves both triangles at its spoke, there is one with $s_i\le0\le s_{i+1}$.
#[test]
fn fan_loses_no_ray_inside() {
    assert_eq!(lost::<f64>(100_000, None), 0);
    assert_eq!(lost::<f32>(100_000, None), 0);
}
