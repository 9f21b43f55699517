//! Facets of all kinds and sizes, hits on them, and directions in which rays leave.

use facette::algebra::{Real, Vector3, VectorSpace, unit_vector};
use facette::bspline;
use facette::intersection::bezier_patch::PatchIntersector;
use facette::intersection::triangle::Triangle;
use facette::intersection::{Hit, Intersect, Plane, Sphere};
use facette::ray::Ray;
use proptest::prelude::*;

/// What a ray leaves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    Sphere,
    Plane,
    Triangle,
    /// A biquadratic dome, met on its convex side.
    Dome,
}

/// A facet at a place, a ray that arrives, and a direction in which another leaves.
#[derive(Clone, Copy, Debug)]
pub struct Departure {
    pub kind: Kind,
    /// The size of the scene in units.
    pub scale: f64,
    /// The facet's place and size, as parts of the scale.
    pub place: [f64; 3],
    pub size: f64,
    /// Turns the facet: a normal, of any length.
    pub normal: [f64; 3],
    /// Where on the facet, from 0 to 1.
    pub at: [f64; 2],
    /// Where the arriving ray comes from: added to the normal, and how far.
    pub slant: [f64; 3],
    pub distance: f64,
    /// In which direction the ray leaves: tangential part, and the part along the normal.
    pub tangential: [f64; 3],
    pub along: f64,
}

/// A facet as something to be met.
pub type Facet<S> = Box<dyn Intersect<Point = [S; 3]>>;

impl Departure {
    fn n(&self) -> [f64; 3] {
        unit_vector(self.normal).unwrap_or([0.0, 0.0, 1.0])
    }

    /// Two unit vectors that span the plane perpendicular to the normal: `a × b = n`.
    fn tangents(&self) -> [[f64; 3]; 2] {
        let n = self.n();
        let least = (0..3)
            .min_by(|&i, &j| n[i].abs().total_cmp(&n[j].abs()))
            .unwrap_or(0);
        let mut axis = [0.0; 3];
        axis[least] = 1.0;
        let a = unit_vector(axis.cross(n)).expect("not parallel");
        [a, n.cross(a)]
    }

    fn extent(&self) -> f64 {
        self.size * self.scale
    }

    fn centre(&self) -> [f64; 3] {
        self.place.times(self.scale)
    }

    /// A point at `[x, y]` in the tangent plane at the centre, and so high above it.
    fn local(&self, [x, y]: [f64; 2], height: f64) -> [f64; 3] {
        let [a, b] = self.tangents();
        let r = self.extent();
        let in_plane = a.times(x * r).plus(b.times(y * r));
        self.centre()
            .plus(in_plane)
            .plus(self.n().times(height * r))
    }

    /// The facet, moved along its normal; a sphere grows instead.
    pub fn facet<S: Real>(&self, lifted: f64) -> Facet<S> {
        let round = |p: [f64; 3]| p.plus(self.n().times(lifted)).map(S::from_f64);
        match self.kind {
            Kind::Sphere => {
                let radius = S::from_f64(self.extent() + lifted);
                let centre = self.centre().map(S::from_f64);
                Box::new(Sphere::new(centre, radius).expect("a radius"))
            }
            Kind::Plane => {
                let point = round(self.local([0.3, -0.2], 0.0));
                Box::new(Plane::new(point, self.normal.map(S::from_f64)).expect("a normal"))
            }
            Kind::Triangle => {
                let corners = [[-1.0, -1.0], [3.0, -1.0], [-1.0, 3.0]];
                let corners = corners.map(|corner| round(self.local(corner, 0.0)));
                Box::new(Triangle::new(corners).expect("finite corners"))
            }
            Kind::Dome => {
                let bend = [-1.0, 1.0, -1.0];
                let points = (0..9).map(|k| {
                    let [i, j] = [k % 3, k / 3];
                    let place = [i as f64 - 1.0, j as f64 - 1.0];
                    round(self.local(place, bend[i] + bend[j]))
                });
                let patch = PatchIntersector::new(bspline::BezierPatch {
                    domain: [[S::zero(), S::one()]; 2],
                    degrees: [2, 2],
                    control_points: points.collect(),
                });
                Box::new(patch.expect("a patch"))
            }
        }
    }

    /// Where the ray is aimed at, and the normal there.
    fn target(&self) -> ([f64; 3], [f64; 3]) {
        let [x, y] = self.at.map(|at| 2.0 * at - 1.0);
        let [a, b] = self.tangents();
        let n = self.n();
        match self.kind {
            Kind::Sphere => {
                let tilted = n.plus(a.times(x)).plus(b.times(y));
                let arm = unit_vector(tilted).expect("never 0");
                (self.centre().plus(arm.times(self.extent())), arm)
            }
            Kind::Plane => (self.local([x, y], 0.0), n),
            // Half the square that lies in the triangle with corners (−1, −1), (3, −1), (−1, 3).
            Kind::Triangle => (self.local([0.95 * x, 0.95 * y], 0.0), n),
            Kind::Dome => {
                let [x, y] = [0.9 * x, 0.9 * y];
                let tilted = n.plus(a.times(2.0 * x)).plus(b.times(2.0 * y));
                let normal = unit_vector(tilted).expect("never 0");
                (self.local([x, y], -(x * x + y * y)), normal)
            }
        }
    }

    /// The arriving ray.
    pub fn arriving<S: Real>(&self) -> Ray<[S; 3]> {
        let (target, normal) = self.target();
        let from = unit_vector(normal.times(1.3).plus(self.slant)).expect("never 0");
        let origin = target.plus(from.times(self.distance * self.extent()));
        let origin = origin.map(S::from_f64);
        let direction = target.minus(origin.map(S::to_f64));
        Ray::new(origin, direction.map(S::from_f64))
    }

    /// The direction in which a ray leaves a hit: to the outside of what is curved, to either side of what is flat.
    pub fn direction<S: Real>(&self, hit: &Hit<[S; 3]>) -> [S; 3] {
        let normal = hit.normal.map(S::to_f64);
        let in_plane = self
            .tangential
            .minus(normal.times(self.tangential.dot(normal)));
        let is_flat = matches!(self.kind, Kind::Plane | Kind::Triangle);
        let along = if is_flat {
            self.along
        } else {
            self.along.abs()
        };
        in_plane.plus(normal.times(along)).map(S::from_f64)
    }
}

fn departures(
    exponents: impl Strategy<Value = f64>,
    sizes: impl Strategy<Value = f64>,
    distances: impl Strategy<Value = f64>,
    alongs: impl Strategy<Value = f64>,
) -> impl Strategy<Value = Departure> {
    let vector = || [-1.0..1.0_f64, -1.0..1.0, -1.0..1.0];
    let kind = prop::sample::select(vec![Kind::Sphere, Kind::Plane, Kind::Triangle, Kind::Dome]);
    let facet = (kind, exponents, vector(), sizes, vector());
    let rays = (
        [0.0..1.0_f64, 0.0..1.0],
        vector(),
        distances,
        vector(),
        alongs,
    );
    (facet, rays).prop_map(
        |((kind, exponent, place, size, normal), (at, slant, distance, tangential, along))| {
            Departure {
                kind,
                scale: 10.0_f64.powf(exponent),
                place,
                size,
                normal,
                at,
                slant,
                distance,
                tangential,
                along,
            }
        },
    )
}

/// Scenes from 1e-3 to 1e7 units.
pub fn anywhere() -> impl Strategy<Value = Departure> {
    let sides = prop_oneof![0.01..1.0_f64, -1.0..-0.01_f64];
    departures(-3.0..7.0_f64, 0.1..1.0_f64, 1.0..3.0_f64, sides)
}

/// Facets that are a thousandth of the scene, rays from afar and from close by, and directions near the tangent plane.
pub fn awkward() -> impl Strategy<Value = Departure> {
    let exponents = prop::sample::select(vec![-3.0, 0.0, 6.0, 7.0]);
    let distances = prop::sample::select(vec![1e-2, 1.0, 1e3]);
    let alongs = prop::sample::select(vec![1e-5, -1e-5, 1e-3, -1e-3, 1.0]);
    departures(
        exponents,
        prop::sample::select(vec![1e-3, 1e-2, 1.0]),
        distances,
        alongs,
    )
}
