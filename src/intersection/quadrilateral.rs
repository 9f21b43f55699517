//! Quadrilateral facets: the bilinear patch of four corners, flat or twisted.
//!
//! Four points need not lie in a plane. The surface that they span without further choice is ruled twice: every line `u = const` and every line
//! `v = const` on it is straight.
//!
//! ```text
//! S(u,v) = a + u (b − a) + v (d − a) + uv k,    k = (c − d) − (b − a)
//! ```
//!
//! A ray meets the line `u = const` where both lie in one plane. That is a quadratic equation in u; v and t follow.
//!
//! # Conventions
//!
//! Corners a, b, c, d run anticlockwise as seen from the front: `S(0,0) = a`, `S(1,0) = b`, `S(1,1) = c`, `S(0,1) = d`. The normal is `S_u × S_v`. Edges belong to
//! the facet. A ray that only touches it, or runs in it, misses.
//!
//! # Numerics
//!
//! The quadratic equation is solved without cancellation, then one step of Newton's method on all three unknowns repairs what the
//! coefficients lost. The bound on the error of t comes from the residual that is left.
//!
//! The coefficients are volumes, and the discriminant has the squares of volumes. So lengths, the direction and the coefficients are measured
//! in powers of two near their own sizes: this rounds nothing, and the answer has the same digits at every size whose differences of
//! points are normal numbers.
//!
//! # Sources
//!
//! S. D. Ramsey, K. Potter, C. Hansen, *Ray bilinear patch intersections*, 2004; A. Reshetov, *Cool patches: a geometric approach to
//! ray/bilinear patch intersections*, 2019.
//!
//! *In the course*: slide 99 asks for triangles; slide 9 has this surface as S₃.
//!
//! *In the book*: [Triangles](../../../../intersection/triangles.html).

use num_traits::{One, Zero};

use super::triangle::facet_hit;
use super::{FacetHit, Hit, Intersect, IntersectionError, Side};
use crate::algebra::{Real, Scalar, Vector3, VectorSpace, larger, unit_vector};
use crate::ray::Ray;
use crate::surface::Surface;

/// The bilinear patch of four corners.
///
/// # Accuracy
///
/// The point lies on the patch up to `u |x| + 7u (u ((1 − v) |b − a| + v |c − d|) + v |d − a|)`, coordinate by coordinate (tested as
/// `point_lies_on_the_quadrilateral_within_its_bound`). The bound on t holds for the ray's line and the patch beyond its edges; it is infinite
/// where the ray is so nearly tangent that rounding cannot tell whether they meet.
///
/// # Edge cases
///
/// Not watertight: of two facets with a common edge, both may miss a ray within rounding of it. A planar facet may have any shape; where it
/// overlaps itself, a point may have two pairs of parameters, of which one is given. Any size will do, as long as the differences of the corners, and those to the
/// ray's origin, are normal numbers (hard case `quadrilateral_may_have_any_size`).
///
/// # Examples
///
/// ```
/// use facette::intersection::quadrilateral::Quadrilateral;
/// use facette::intersection::{Intersect, Side};
/// use facette::ray::Ray;
///
/// let saddle = [[0., 0., 0.], [2., 0., 1.], [2., 2., 0.], [0., 2., 1.]];
/// let saddle = Quadrilateral::new(saddle)?;
/// let hit = saddle.intersect(&Ray::new([1., 1., 3.], [0., 0., -1.])).expect("the ray points at it");
/// assert_eq!((hit.t, hit.point, hit.side), (2.5, [1., 1., 0.5], Side::Front));
/// # Ok::<(), facette::intersection::IntersectionError<f64>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quadrilateral<P> {
    corners: [P; 4],
}

impl<P: Vector3> Quadrilateral<P> {
    /// The patch with the corners a, b, c and d.
    ///
    /// # Errors
    ///
    /// [`IntersectionError::NotFinite`] for a corner with a coordinate that is NaN or infinite.
    pub fn new(corners: [P; 4]) -> Result<Self, IntersectionError<P::Scalar>> {
        let names = ["corner a", "corner b", "corner c", "corner d"];
        for (what, corner) in names.into_iter().zip(corners) {
            IntersectionError::check_finite(what, corner)?;
        }
        Ok(Self { corners })
    }

    /// The corners a, b, c and d.
    pub fn corners(&self) -> [P; 4] {
        self.corners
    }
}

impl<P: Vector3> Surface for Quadrilateral<P> {
    type Scalar = P::Scalar;
    type Point = P;

    fn domain(&self) -> [[P::Scalar; 2]; 2] {
        [[P::Scalar::zero(), P::Scalar::one()]; 2]
    }

    // ANCHOR: point
    fn point(&self, u: P::Scalar, v: P::Scalar) -> P {
        let [a, b, c, d] = self.corners;
        let along_u = b.minus(a).lerp(c.minus(d), v).times(u);
        a.plus(along_u.plus(d.minus(a).times(v)))
    }
    // ANCHOR_END: point

    fn partials(&self, u: P::Scalar, v: P::Scalar) -> Option<[P; 2]> {
        let [a, b, c, d] = self.corners;
        Some([
            b.minus(a).lerp(c.minus(d), v),
            d.minus(a).lerp(c.minus(b), u),
        ])
    }
}

impl<P: Vector3<Scalar: Real>> Intersect for Quadrilateral<P> {
    type Point = P;

    fn intersect(&self, ray: &Ray<P>) -> Option<Hit<P>> {
        let (facet, t_error) = nearest_crossing(&self.corners, ray)?;
        let [u, v] = facet.parameters;
        let [s_u, s_v] = self.partials(u, v)?;
        let (point, point_error) = self.point_with_error(u, v);
        Some(Hit {
            t: facet.t,
            t_error,
            point,
            point_error,
            normal: unit_vector(in_its_unit(s_u).cross(in_its_unit(s_v)))?,
            parameters: Some(facet.parameters),
            side: facet.side,
        })
    }
}

impl<P: Vector3<Scalar: Real>> Quadrilateral<P> {
    /// The point `S(u, v)` with a bound on its error.
    ///
    /// In the largest term, `u ((1 − v) (b − a))`, six roundings: the difference, 1 − v, two products and two sums; one more for the terms of
    /// higher order. The last sum rounds by u of the result.
    fn point_with_error(&self, u: P::Scalar, v: P::Scalar) -> (P, P::Scalar) {
        let [a, b, c, d] = self.corners;
        let point = self.point(u, v);
        let (unit, w) = (P::Scalar::unit_roundoff(), P::Scalar::one() - v);
        let mut largest = P::Scalar::zero();
        for axis in 0..3 {
            let size = |end: P, start: P| end.minus(start).coordinate(axis).magnitude();
            let along = u * (w * size(b, a) + v * size(c, d)) + v * size(d, a);
            let error = point.coordinate(axis).magnitude() + P::Scalar::from_i32(7) * along;
            largest = larger(largest, unit * error);
        }
        // Seven of the bound's own roundings.
        (
            point,
            largest * (P::Scalar::one() + P::Scalar::from_i32(8) * unit),
        )
    }
}

/// The nearest hit of a ray with the bilinear patch of four corners, as [`Quadrilateral`] has them.
///
/// # Accuracy
///
/// As [`Quadrilateral`], which gives the bound on the error of t as well.
///
/// # Source
///
/// The equation: Ramsey, Potter, Hansen 2004, in the form of Reshetov 2019; the bound: module documentation.
pub fn bilinear_patch<P>(corners: &[P; 4], ray: &Ray<P>) -> Option<FacetHit<P::Scalar>>
where
    P: Vector3<Scalar: Real>,
{
    nearest_crossing(corners, ray).map(|(hit, _)| hit)
}

/// The nearest hit, with a bound on the error of its t.
// ANCHOR: nearest
fn nearest_crossing<P>(corners: &[P; 4], ray: &Ray<P>) -> Option<(FacetHit<P::Scalar>, P::Scalar)>
where
    P: Vector3<Scalar: Real>,
{
    let patch = Seen::new(corners, ray);
    let hits = patch.lines_in_a_plane_with_the_ray().map(|u| {
        let place = patch.improved(patch.on_line(u)?)?;
        let [u, v, t] = place;
        let is_inside = [u, v]
            .iter()
            .all(|&x| x >= P::Scalar::zero() && x <= P::Scalar::one());
        let along = patch.direction.dot(patch.normal(u, v));
        if !is_inside || along.is_zero() {
            return None;
        }
        let hit = facet_hit(ray, patch.in_rays_units(t), [u, v], Side::of(along))?;
        Some((hit, patch.in_rays_units(patch.error_of_t(place))))
    });
    match hits {
        [Some(first), Some(second)] if second.0.t < first.0.t => Some(second),
        [first, second] => first.or(second),
    }
}
// ANCHOR_END: nearest

/// A patch and a ray as the equations have them, `A + u E + v G + uv k = t d`, lengths and d in powers of two near their sizes.
struct Seen<P: Vector3> {
    /// a as seen from the ray's origin.
    a: P,
    /// `b − a`.
    e: P,
    /// `d − a`.
    g: P,
    /// `(c − d) − (b − a)`.
    k: P,
    /// b as seen from the ray's origin, and `c − b`: what the line u = 1 needs.
    end: [P; 2],
    /// The sizes of the terms of k, coordinate by coordinate.
    k_size: P,
    direction: P,
    /// The unit of lengths.
    length: P::Scalar,
    /// What the direction is multiplied by.
    per_speed: P::Scalar,
}

impl<P: Vector3<Scalar: Real>> Seen<P> {
    fn new([a, b, c, d]: &[P; 4], ray: &Ray<P>) -> Self {
        let [from_a, from_b] = [a, b].map(|corner| corner.minus(ray.origin));
        let sides = [b.minus(*a), c.minus(*d), d.minus(*a), c.minus(*b)];
        let vectors = [from_a, from_b, sides[0], sides[1], sides[2], sides[3]];
        let length = vectors
            .map(VectorSpace::largest_coordinate)
            .into_iter()
            .fold(P::Scalar::zero(), larger)
            .power_of_two();
        let per_length = P::Scalar::one() / length;
        let [a, b, e, opposite, g, end] = vectors.map(|vector| vector.times(per_length));
        Self {
            a,
            e,
            g,
            k: opposite.minus(e),
            end: [b, end],
            k_size: opposite.absolute().plus(e.absolute()),
            direction: in_its_unit(ray.direction),
            length,
            per_speed: P::Scalar::one() / ray.direction.largest_coordinate().power_of_two(),
        }
    }

    /// A parameter of the scaled ray, or its error, as one of the ray itself.
    fn in_rays_units(&self, t: P::Scalar) -> P::Scalar {
        t * self.length * self.per_speed
    }

    /// The roots of `d · (P × Q) = 0`, where `P = A + u E` is on the edge from a to b and `Q = G + u k` runs along the line: infinite or NaN
    /// where there are fewer than two.
    // ANCHOR: quadratic
    fn lines_in_a_plane_with_the_ray(&self) -> [P::Scalar; 2] {
        let volume = |p: P, q: P| self.direction.dot(p.cross(q));
        let at_0 = volume(self.a, self.g);
        let at_1 = volume(self.end[0], self.end[1]);
        let square = volume(self.e, self.k);
        let linear = at_1 - at_0 - square;
        // For a narrow patch, whose volumes are small in any unit.
        let largest = larger(
            larger(at_0.magnitude(), square.magnitude()),
            linear.magnitude(),
        );
        let per_largest = P::Scalar::one() / largest.power_of_two();
        let [at_0, linear, square] = [at_0, linear, square].map(|volume| volume * per_largest);
        let four = P::Scalar::from_i32(4);
        let root = (linear * linear - four * square * at_0).sqrt();
        // The sum of two numbers of the same sign: no cancellation.
        let sum = if linear < P::Scalar::zero() {
            linear - root
        } else {
            linear + root
        };
        let half = sum / P::Scalar::from_i32(-2);
        [half / square, at_0 / half]
    }
    // ANCHOR_END: quadratic

    /// Where on the line u = const the ray meets it: u, v and t; `None` where they are parallel.
    fn on_line(&self, u: P::Scalar) -> Option<[P::Scalar; 3]> {
        let p = self.a.plus(self.e.times(u));
        let q = self.g.plus(self.k.times(u));
        let m = q.cross(self.direction);
        let square = m.dot(m);
        if !Scalar::is_finite(u) || square.is_zero() {
            return None;
        }
        let v = self.direction.cross(p).dot(m) / square;
        Some([u, v, q.cross(p).dot(m) / square])
    }

    /// `A + u E + v (G + u k) − t d`.
    fn residual(&self, [u, v, t]: [P::Scalar; 3]) -> P {
        let along = self.g.plus(self.k.times(u)).times(v);
        let point = self.a.plus(self.e.times(u)).plus(along);
        point.minus(self.direction.times(t))
    }

    fn tangents(&self, u: P::Scalar, v: P::Scalar) -> [P; 2] {
        [self.e.plus(self.k.times(v)), self.g.plus(self.k.times(u))]
    }

    fn normal(&self, u: P::Scalar, v: P::Scalar) -> P {
        let [s_u, s_v] = self.tangents(u, v);
        s_u.cross(s_v)
    }

    /// One step of Newton's method; `None` where the ray is tangent.
    // ANCHOR: newton
    fn improved(&self, [u, v, t]: [P::Scalar; 3]) -> Option<[P::Scalar; 3]> {
        let [s_u, s_v] = self.tangents(u, v);
        let (d, n) = (self.direction, s_u.cross(s_v));
        let determinant = d.dot(n);
        if determinant.is_zero() {
            return None;
        }
        let rest = self.residual([u, v, t]);
        Some([
            u - rest.dot(s_v.cross(d)) / determinant,
            v - rest.dot(d.cross(s_u)) / determinant,
            t + rest.dot(n) / determinant,
        ])
    }
    // ANCHOR_END: newton

    /// A bound on the distance of t from that of a true crossing of the line and the patch; infinite where none is certain.
    ///
    /// Let F be the residual and `(x, y, z)` what u, v and t lack. The patch is bilinear, so `F + x S_u + y S_v − z d + xy k = 0` exactly, and by
    /// Cramer's rule, with `D = d · (S_u × S_v)`,
    ///
    /// ```text
    /// x = −(F + xy k) · (S_v × d) / D,    y = −(F + xy k) · (d × S_u) / D,    z = (F + xy k) · (S_u × S_v) / D
    /// ```
    ///
    /// Let `α, β, γ` bound the parts with F and `λ, μ, ν` those with k. If `4 λ β <= 1` and `4 μ α <= 1`, the right-hand sides map the
    /// rectangle `|x| <= 2α, |y| <= 2β` into itself, so that there is a solution in it (Brouwer), with `|z| <= γ + 4 ν α β`.
    fn error_of_t(&self, place: [P::Scalar; 3]) -> P::Scalar {
        let [u, v, _] = place;
        let [one, four] = [1, 4].map(P::Scalar::from_i32);
        let unit = P::Scalar::unit_roundoff();
        let spread = self.k_size;
        let s_u = self.e.absolute().plus(spread.times(v));
        let s_v = self.g.absolute().plus(spread.times(u));
        let d = self.direction.absolute();
        // Three roundings in S_u and S_v each, two products, a difference, two sums: 11, and one more.
        let lost = P::Scalar::from_i32(12) * unit * d.dot(positive_cross(s_u, s_v));
        let determinant = self.direction.dot(self.normal(u, v)).magnitude() - lost;
        let is_regular = determinant > P::Scalar::zero();
        if !is_regular {
            return one / P::Scalar::zero();
        }
        let residual = self
            .residual(place)
            .absolute()
            .plus(self.rounding_of_residual(place));
        let crosses = [
            positive_cross(s_v, d),
            positive_cross(d, s_u),
            positive_cross(s_u, s_v),
        ];
        let [alpha, beta, gamma] = crosses.map(|cross| residual.dot(cross) / determinant);
        let [lambda, mu, nu] = crosses.map(|cross| spread.dot(cross) / determinant);
        if !(four * lambda * beta <= one && four * mu * alpha <= one) {
            return one / P::Scalar::zero();
        }
        // 16 roundings or fewer in the bound itself, all of positive numbers.
        (gamma + four * nu * alpha * beta) * (one + P::Scalar::from_i32(16) * unit)
    }

    /// A bound on the rounding of the residual: 8 roundings at most in each of its terms, and one more.
    fn rounding_of_residual(&self, [u, v, t]: [P::Scalar; 3]) -> P {
        let along = self.g.absolute().plus(self.k_size.times(u)).times(v);
        let point = self
            .a
            .absolute()
            .plus(self.e.absolute().times(u))
            .plus(along);
        let total = point.plus(self.direction.absolute().times(t.magnitude()));
        total.times(P::Scalar::from_i32(9) * P::Scalar::unit_roundoff())
    }
}

/// The vector with its largest coordinate between 1 and 2, by a power of two.
fn in_its_unit<P: Vector3<Scalar: Real>>(vector: P) -> P {
    vector.times(P::Scalar::one() / vector.largest_coordinate().power_of_two())
}

/// The vector product with sums for differences: a bound on it for vectors of sizes.
fn positive_cross<P: Vector3>(x: P, y: P) -> P {
    let part =
        |j: usize, k: usize| x.coordinate(j) * y.coordinate(k) + x.coordinate(k) * y.coordinate(j);
    P::from_coordinates([part(1, 2), part(2, 0), part(0, 1)])
}
