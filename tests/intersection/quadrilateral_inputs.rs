//! Quadrilaterals and rays whose crossings are small fractions, and what exact arithmetic says of them.

use facette::algebra::VectorSpace;
use facette::intersection::Side;
use facette::intersection::quadrilateral::Quadrilateral;
use facette::ray::Ray;
use num_traits::{One, Signed, Zero};
use proptest::prelude::*;

use crate::common::oracle::{Big, big, big_cross, big_dot, big_minus, big_point};

pub type Point = [f64; 3];
type BigPoint = [Big; 3];

/// A quadrilateral, and a ray that meets its surface at t = 1, u and v.
#[derive(Clone, Copy, Debug)]
pub struct Place {
    pub corners: [Point; 4],
    pub origin: Point,
    pub direction: Point,
}

impl Place {
    pub fn patch(&self) -> Quadrilateral<Point> {
        Quadrilateral::new(self.corners).expect("finite corners")
    }

    pub fn ray(&self) -> Ray<Point> {
        Ray::new(self.origin, self.direction)
    }
}

fn integer_point() -> impl Strategy<Value = Point> {
    [-9..=9_i32, -9..=9, -9..=9].prop_map(|point| point.map(f64::from))
}

fn eighth() -> impl Strategy<Value = f64> {
    (1..=7_i32).prop_map(|eighths| f64::from(eighths) / 8.0)
}

/// The place whose ray leaves the surface point at (u, v) backwards along the direction: everything is a small multiple of 1/64, and exact.
fn through(corners: [Point; 4], [u, v]: [f64; 2], direction: Point) -> Place {
    let patch = Quadrilateral::new(corners).expect("finite corners");
    let target = facette::surface::Surface::point(&patch, u, v);
    let is_zero = direction.largest_coordinate() == 0.0;
    let direction = if is_zero { [0.0, 0.0, 1.0] } else { direction };
    Place {
        corners,
        origin: target.minus(direction),
        direction,
    }
}

/// Twisted quadrilaterals of any shape.
pub fn twisted() -> impl Strategy<Value = Place> {
    let corners = [
        integer_point(),
        integer_point(),
        integer_point(),
        integer_point(),
    ];
    (corners, [eighth(), eighth()], integer_point())
        .prop_map(|(corners, place, direction)| through(corners, place, direction))
}

/// Far from the origin; hardly twisted, so that the quadratic is nearly linear; nearly tangent; thin; with two corners in one.
pub fn hard_twisted() -> impl Strategy<Value = Place> {
    (twisted(), [eighth(), eighth()], 0..5).prop_map(|(place, [u, v], kind)| {
        let [a, b, c, d] = place.corners;
        let small = 2.0_f64.powi(-20);
        let far = [2.0_f64.powi(24), -2.0_f64.powi(22), 3.0];
        let flat = b.plus(d).minus(a);
        let corners = match kind {
            0 => place.corners.map(|corner| corner.plus(far)),
            1 => [a, b, flat.plus(c.times(small)), d],
            2 => [
                a,
                b,
                b.plus(c.minus(b).times(small)),
                a.plus(d.minus(a).times(small)),
            ],
            3 => [a, b, c, a],
            _ => place.corners,
        };
        let [e, g] = [b.minus(a), d.minus(a)];
        let nearly_along = e.plus(c.minus(d).minus(e).times(v)).plus(g.times(small));
        let direction = if kind == 4 {
            nearly_along
        } else {
            place.direction
        };
        through(corners, [u, v], direction)
    })
}

/// Convex quadrilaterals in a plane.
pub fn planar() -> impl Strategy<Value = Place> {
    let shape = prop::sample::select(vec![
        [1.0, 1.0],
        [2.0, 1.0],
        [0.5, 0.75],
        [0.25, 2.0],
        [3.0, 3.0],
    ]);
    let ends = [integer_point(), integer_point(), integer_point()];
    (ends, shape, [eighth(), eighth()], integer_point()).prop_map(
        |([a, e, g], [p, q], place, direction)| {
            let c = a.plus(e.times(p)).plus(g.times(q));
            through([a, a.plus(e), c, a.plus(g)], place, direction)
        },
    )
}

/// Where a line meets the bilinear surface.
#[derive(Clone, Debug)]
pub struct Crossing {
    pub place: [Big; 2],
    pub t: Big,
    pub side: Side,
    /// How steeply the line crosses: 0 for one that touches.
    pub along: Big,
}

impl Crossing {
    pub fn is_inside(&self) -> bool {
        self.place
            .iter()
            .all(|x| !x.is_negative() && *x <= Big::one())
            && self.t.is_positive()
    }

    /// Whether it is inside, or outside, by so much in both parameters.
    pub fn is_clear(&self, margin: f64) -> bool {
        let distance = |x: &Big| x.abs().min((x - Big::one()).abs());
        self.place.iter().all(|x| distance(x) > big(margin))
    }
}

/// The differences that the surface is made of: `A` seen from the origin, `E`, `G` and `k`.
fn terms(place: &Place) -> [BigPoint; 4] {
    let [a, b, c, d] = place.corners.map(big_point);
    let (e, g) = (big_minus(&b, &a), big_minus(&d, &a));
    let k = big_minus(&big_minus(&c, &d), &e);
    [big_minus(&a, &big_point(place.origin)), e, g, k]
}

fn along(start: &BigPoint, direction: &BigPoint, t: &Big) -> BigPoint {
    std::array::from_fn(|axis| &start[axis] + t * &direction[axis])
}

/// v, t and the side on the line u = const; `None` where it is parallel to the ray.
fn on_line(place: &Place, u: Big) -> Option<Crossing> {
    let [a, e, g, k] = terms(place);
    let d = big_point(place.direction);
    let (p, q) = (along(&a, &e, &u), along(&g, &k, &u));
    let m = big_cross(&q, &d);
    let square = big_dot(&m, &m);
    if square.is_zero() {
        return None;
    }
    let v = big_dot(&big_cross(&d, &p), &m) / &square;
    let t = big_dot(&big_cross(&q, &p), &m) / &square;
    let normal = big_cross(&along(&e, &k, &v), &q);
    let steep = big_dot(&d, &normal);
    let side = if steep.is_negative() {
        Side::Front
    } else {
        Side::Back
    };
    Some(Crossing {
        place: [u, v],
        t,
        side,
        along: steep,
    })
}

/// All crossings with the line, given that one has the parameter u: the quadratic's other root is a fraction as well. `None` where the quadratic
/// vanishes, since a line of the surface lies in one plane with the ray for every u.
pub fn crossings(place: &Place, u: f64) -> Option<Vec<Crossing>> {
    let [a, e, g, k] = terms(place);
    let d = big_point(place.direction);
    let volume = |p: &BigPoint, q: &BigPoint| big_dot(&d, &big_cross(p, q));
    let square = volume(&e, &k);
    let linear = volume(&a, &k) + volume(&e, &g);
    let u = big(u);
    let mut roots = vec![u.clone()];
    if !square.is_zero() {
        roots.push(-linear / square - u);
    } else if linear.is_zero() {
        return None;
    }
    roots.into_iter().map(|u| on_line(place, u)).collect()
}

/// What u of the crossing at t = 1 is: the corners' places make it hard to tell otherwise.
pub fn parameter_of(place: &Place) -> Option<f64> {
    let eighths = (1..=7).map(|eighth| f64::from(eighth) / 8.0);
    eighths.into_iter().find(|&u| {
        on_line(place, big(u))
            .is_some_and(|crossing| crossing.t.is_one() && is_on_line(place, &crossing))
    })
}

fn is_on_line(place: &Place, crossing: &Crossing) -> bool {
    let [a, e, g, k] = terms(place);
    let [u, v] = &crossing.place;
    let point = along(&along(&a, &e, u), &along(&g, &k, u), v);
    big_minus(
        &point,
        &along(
            &point.clone().map(|_| Big::zero()),
            &big_point(place.direction),
            &crossing.t,
        ),
    )
    .iter()
    .all(Zero::is_zero)
}

/// The exact surface point.
pub fn exact_point(corners: [Point; 4], [u, v]: [f64; 2]) -> BigPoint {
    let [a, b, c, d] = corners.map(big_point);
    let (u, v) = (big(u), big(v));
    let edge = |start: &BigPoint, end: &BigPoint| along(start, &big_minus(end, start), &u);
    let (below, above) = (edge(&a, &b), edge(&d, &c));
    along(&below, &big_minus(&above, &below), &v)
}

/// The crossing near `[u, v, t]`, to 60 digits, by Newton's method in fractions that are cut off there; `None` where it does not settle.
pub fn refined(place: &Place, start: [f64; 3]) -> Option<[Big; 3]> {
    let [a, e, g, k] = terms(place);
    let d = big_point(place.direction);
    let unit = num_traits::pow(big(2.0), 200);
    let cut = |x: Big| (x * &unit).round() / &unit;
    let mut x = start.map(big);
    for _ in 0..8 {
        let [u, v, t] = &x;
        let (s_u, s_v) = (along(&e, &k, v), along(&g, &k, u));
        let point = along(&along(&a, &e, u), &s_v, v);
        let rest = big_minus(&point, &d.clone().map(|component| component * t));
        let normal = big_cross(&s_u, &s_v);
        let determinant = big_dot(&d, &normal);
        if determinant.is_zero() {
            return None;
        }
        let steps = [
            -big_dot(&rest, &big_cross(&s_v, &d)) / &determinant,
            -big_dot(&rest, &big_cross(&d, &s_u)) / &determinant,
            big_dot(&rest, &normal) / &determinant,
        ];
        let is_settled = steps.iter().all(|step| step.abs() * &unit < big(1024.0));
        let moved: Vec<Big> = x
            .iter()
            .zip(&steps)
            .map(|(x, step)| cut(x + step))
            .collect();
        x = moved.try_into().expect("three numbers");
        if is_settled {
            return Some(x);
        }
    }
    None
}
