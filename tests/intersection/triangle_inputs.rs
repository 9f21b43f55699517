//! Triangles and rays over the fractions: aimed inside, at edges and corners, past them, along the plane and at nothing.

use facette::algebra::{Scalar, Vector3, VectorSpace};
use facette::intersection::triangle::{
    BaldwinWeberTriangle, ShevtsovTriangle, half_planes, moller_trumbore, watertight,
};
use facette::intersection::{FacetHit, Side};
use facette::ray::Ray;
use num_traits::{One, Zero};
use proptest::prelude::*;

use crate::common::exact::{Exact, fraction};
use crate::common::generators::{coordinate, parameter, point};
use crate::common::motion::IntegerMotion;

pub type Point = [Exact; 3];

/// A triangle and a ray.
#[derive(Clone, Copy, Debug)]
pub struct Place {
    pub corners: [Point; 3],
    pub origin: Point,
    pub direction: Point,
}

impl Place {
    pub fn ray(&self) -> Ray<Point> {
        Ray::new(self.origin, self.direction)
    }

    /// The place moved by a map of points, and the same of directions.
    pub fn mapped(&self, map: impl Fn(Point) -> Point, turn: impl Fn(Point) -> Point) -> Self {
        Self {
            corners: self.corners.map(&map),
            origin: map(self.origin),
            direction: turn(self.direction),
        }
    }

    pub fn normal(&self) -> Point {
        let [a, b, c] = self.corners;
        b.minus(a).cross(c.minus(a))
    }
}

/// The point with the weights v of b and w of c.
pub fn at_weights([a, b, c]: [Point; 3], [v, w]: [Exact; 2]) -> Point {
    Point::combination([Exact::one() - v - w, v, w], [a, b, c])
}

fn aimed(corners: [Point; 3], origin: Point, weights: [Exact; 2], scale: Exact) -> Place {
    let direction = at_weights(corners, weights).minus(origin).times(scale);
    let z = [0, 0, 1].map(Exact::from_i32);
    let is_zero = direction.largest_coordinate().is_zero();
    Place {
        corners,
        origin,
        direction: if is_zero { z } else { direction },
    }
}

fn corners() -> impl Strategy<Value = [Point; 3]> {
    [point(), point(), point()]
}

/// The length of a direction, relative to the way to the triangle; negative for a ray that runs away from it.
fn scale() -> impl Strategy<Value = Exact> {
    coordinate().prop_map(|scale| if scale.is_zero() { Exact::one() } else { scale })
}

/// Rays at points of the triangle's plane, about half of them inside.
pub fn places() -> impl Strategy<Value = Place> {
    let inside = [parameter(), parameter()].prop_map(|[v, w]| [v, w * (Exact::one() - v)]);
    let around = [parameter(), parameter()].prop_map(|[v, w]| {
        let [two, half] = [fraction(2, 1), fraction(1, 2)];
        [v * two - half, w * two - half]
    });
    let weights = prop_oneof![inside.boxed(), around.boxed()];
    (corners(), point(), weights, scale())
        .prop_map(|(corners, origin, weights, scale)| aimed(corners, origin, weights, scale))
}

/// Weights of a corner, of a point on an edge, and of points beside them by 2⁻²⁹.
fn border_weights() -> impl Strategy<Value = [Exact; 2]> {
    let tiny = || prop::sample::select(vec![-1, 0, 0, 1]).prop_map(|step| fraction(step, 1 << 29));
    let ends = prop::sample::select(vec![[0, 0], [1, 0], [0, 1]]);
    let corner = ends.prop_map(|ends| ends.map(Exact::from_i32));
    let edge = (parameter(), 0..3).prop_map(|(t, edge)| match edge {
        0 => [t, Exact::zero()],
        1 => [Exact::zero(), t],
        _ => [t, Exact::one() - t],
    });
    (prop_oneof![corner, edge], tiny(), tiny())
        .prop_map(|([v, w], step_v, step_w)| [v + step_v, w + step_w])
}

/// Rays at edges and corners and just beside them, along the plane and in it, along axes, from the plane; needles; triangles without area.
pub fn hard_places() -> impl Strategy<Value = Place> {
    let borders = (corners(), point(), border_weights(), scale());
    let borders = borders.prop_map(|(c, origin, weights, scale)| aimed(c, origin, weights, scale));
    (borders, parameter(), 0..6).prop_map(|(place, t, kind)| {
        let [a, b, c] = place.corners;
        let x = place.origin.plus(place.direction);
        let [zero, thin] = [Exact::zero(), fraction(1, 1 << 20)];
        match kind {
            0 => Place {
                direction: b.minus(a).lerp(c.minus(a), t),
                ..place
            },
            1 => Place {
                origin: at_weights(place.corners, [t, t - fraction(1, 3)]),
                ..place
            },
            2 => Place {
                corners: [a, b, a.lerp(b, t)],
                ..place
            },
            3 => Place {
                corners: [a, b, b.lerp(c, thin)],
                direction: a.lerp(b, t).minus(place.origin),
                ..place
            },
            4 => Place {
                origin: [x[0], x[1], x[2] + fraction(3, 1)],
                direction: [zero, zero, fraction(-2, 1)],
                ..place
            },
            _ => place,
        }
    })
}

/// What Gauss's elimination says: t and the weights of b and c, if the three equations have one solution, whether it is a hit or not.
pub fn solved(place: &Place) -> Option<[Exact; 3]> {
    let [a, b, c] = place.corners;
    let columns = [
        b.minus(a),
        c.minus(a),
        place.direction.times(-Exact::one()),
        place.origin.minus(a),
    ];
    let mut rows: [[Exact; 4]; 3] = std::array::from_fn(|row| columns.map(|column| column[row]));
    for step in 0..3 {
        let pivot = (step..3).find(|&row| !rows[row][step].is_zero())?;
        rows.swap(step, pivot);
        let pivot_row = rows[step].map(|entry| entry / rows[step][step]);
        rows[step] = pivot_row;
        for row in (0..3).filter(|&row| row != step) {
            let factor = rows[row][step];
            let reduced =
                std::array::from_fn(|column| rows[row][column] - factor * pivot_row[column]);
            rows[row] = reduced;
        }
    }
    let [v, w, t] = rows.map(|row| row[3]);
    Some([t, v, w])
}

/// The hit that the solution of the equations is, by definition.
pub fn expected(place: &Place) -> Option<FacetHit<Exact>> {
    let [t, v, w] = solved(place)?;
    let zero = Exact::zero();
    let is_inside = v >= zero && w >= zero && v + w <= Exact::one() && t > zero;
    let side = if place.direction.dot(place.normal()) < zero {
        Side::Front
    } else {
        Side::Back
    };
    is_inside.then_some(FacetHit {
        t,
        parameters: [v, w],
        side,
    })
}

/// A test of a ray and a triangle.
pub type Test<P, S> = fn(&[P; 3], &Ray<P>) -> Option<FacetHit<S>>;

/// All tests that are to find the same hit.
pub fn closed_tests<P: Vector3>() -> [(&'static str, Test<P, P::Scalar>); 5] {
    [
        ("half_planes", half_planes),
        ("moller_trumbore", moller_trumbore),
        ("watertight", watertight),
        ("Shevtsov", |corners, ray| {
            ShevtsovTriangle::new(corners)?.intersect(ray)
        }),
        ("Baldwin and Weber", |corners, ray| {
            BaldwinWeberTriangle::new(corners)?.intersect(ray)
        }),
    ]
}

/// The tests without the half-planes, which are an exercise of their own.
pub fn signed_tests<P: Vector3>() -> impl Iterator<Item = (&'static str, Test<P, P::Scalar>)> {
    closed_tests().into_iter().skip(1)
}

/// A rotation and a shift.
pub fn motions() -> impl Strategy<Value = (IntegerMotion, Point)> {
    let rotation =
        [-3..=3_i32, -3..=3, -3..=3].prop_map(|[x, y, z]| IntegerMotion::new([2, x, y, z], [0; 3]));
    (rotation, point())
}

/// Each kind of hit and miss occurs among the generated places.
#[test]
fn generated_places_hit_and_miss() {
    use proptest::strategy::ValueTree;
    use proptest::test_runner::TestRunner;
    let mut runner = TestRunner::deterministic();
    let mut counts = [0; 4];
    for _ in 0..400 {
        let mut count = |place: &Place| {
            let kind = match (solved(place), expected(place)) {
                (None, _) => 0,
                (_, None) => 1,
                (_, Some(hit)) => 2 + usize::from(hit.barycentric().contains(&Exact::zero())),
            };
            counts[kind] += 1;
        };
        count(&places().new_tree(&mut runner).expect("a place").current());
        count(
            &hard_places()
                .new_tree(&mut runner)
                .expect("a place")
                .current(),
        );
    }
    println!("{counts:?} parallel, missed, inside, on an edge");
    assert!(counts.iter().all(|&count| count >= 40), "{counts:?}");
}
