//! Triangle fans: triangles round one corner, whose common edges are tested once.
//!
//! A ray passes an edge on one side or the other. Neighbours share an edge, so that a fan of n triangles round a *hub* has n spokes and
//! n outer edges where single triangles would have 3n. What is computed once cannot disagree with itself:
//!
//! ```text
//! m = d × (hub − o) / |d_z|       sᵢ = m · (rimᵢ − hub)       triangle i:  sᵢ and sᵢ₊₁ of opposite sign, and the outer edge
//! ```
//!
//! # Conventions
//!
//! Triangle i has the corners hub, rimᵢ, rimᵢ₊₁; seen from the front they run anticlockwise. Spokes and outer edges belong to the fan.
//!
//! # Numerics
//!
//! All spokes are multiplied with one vector m, and each sign serves both neighbours: no ray slips between two triangles of a fan, nor through
//! its hub. Between fans it may. Towards the hub m is nothing but rounding: the vector product of two rounded vectors could then point along the ray,
//! and have all spokes on one side. So m is made in the sheared space of [`ShearedRay`], which keeps it perpendicular to the ray.
//!
//! # Sources
//!
//! E. Galin, S. Akkouche, *Fast processing of triangle meshes using triangle fans*, 2005.
//!
//! *In the course*: slide 101 (*éventail de triangles*).
//!
//! *In the book*: [Triangles](../../../../intersection/triangles.html).

use std::fmt::Debug;

use num_traits::Zero;
use thiserror::Error;

use super::triangle::{ShearedRay, facet_hit};
use super::{FacetHit, Side};
use crate::algebra::Vector3;
use crate::ray::Ray;

/// What keeps points from being a fan.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum FanError<S: Debug> {
    /// There is no triangle.
    #[error("the rim has {found} points: a fan needs at least {needed}")]
    RimTooShort {
        /// How many points there are.
        found: usize,
        /// How many it takes: 2 for an open fan, 3 for a closed one.
        needed: usize,
    },
    /// A point has an infinite or NaN coordinate, or lies too far from the hub for the difference to be a number.
    #[error(
        "point {index} of the rim is {point:?}, the hub {hub:?}: both and their difference must be finite"
    )]
    NotFinite {
        /// Which point of the rim, counted from 0.
        index: usize,
        /// Its coordinates.
        point: [S; 3],
        /// Those of the hub.
        hub: [S; 3],
    },
}

/// Triangles that share a corner, each sharing an edge with the next.
///
/// # Edge cases
///
/// t comes from products of three lengths and of two lengths and the direction, and nothing is scaled: where those leave the range of normal
/// numbers, hits are lost. A fan seen from some ten of its sizes may measure 2^±30 in `f32` and 2^±300 in `f64`, with a direction within the same bounds.
///
/// # Examples
///
/// ```
/// use facette::intersection::fan::Fan;
/// use facette::ray::Ray;
///
/// let square = vec![[1., 0., 0.], [0., 1., 0.], [-1., 0., 0.], [0., -1., 0.]];
/// let fan = Fan::closed([0., 0., 0.], square)?;
/// let hit = fan.intersect(&Ray::new([-0.25, -0.5, 3.], [0., 0., -1.])).expect("inside");
/// assert_eq!((hit.triangle, hit.facet.t), (2, 3.0));
/// # Ok::<(), facette::intersection::fan::FanError<f64>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Fan<P> {
    hub: P,
    /// From the hub to each point of the rim; of a closed fan the first stands at the end again.
    spokes: Vec<P>,
}

/// Where a ray meets a fan.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FanHit<S> {
    /// Which triangle, counted from 0.
    pub triangle: usize,
    /// Where on it: the parameters are the weights of rim points i and i + 1.
    pub facet: FacetHit<S>,
}

impl<P: Vector3> Fan<P> {
    /// The fan of the triangles `hub, rim[i], rim[i + 1]`.
    ///
    /// # Errors
    ///
    /// [`FanError::RimTooShort`] for fewer than 2 points, [`FanError::NotFinite`] for a point or the hub.
    pub fn open(hub: P, rim: impl IntoIterator<Item = P>) -> Result<Self, FanError<P::Scalar>> {
        Self::with_at_least(2, hub, rim)
    }

    /// The fan with one more triangle, from the last point of the rim to the first.
    ///
    /// # Errors
    ///
    /// [`FanError::RimTooShort`] for fewer than 3 points, [`FanError::NotFinite`] for a point or the hub.
    pub fn closed(hub: P, rim: impl IntoIterator<Item = P>) -> Result<Self, FanError<P::Scalar>> {
        let mut fan = Self::with_at_least(3, hub, rim)?;
        fan.spokes.push(fan.spokes[0]);
        Ok(fan)
    }

    fn with_at_least(
        needed: usize,
        hub: P,
        rim: impl IntoIterator<Item = P>,
    ) -> Result<Self, FanError<P::Scalar>> {
        let mut spokes = Vec::new();
        for (index, point) in rim.into_iter().enumerate() {
            let spoke = point.minus(hub);
            if !spoke.has_finite_coordinates() {
                let [point, hub] = [point, hub].map(P::coordinates);
                return Err(FanError::NotFinite { index, point, hub });
            }
            spokes.push(spoke);
        }
        let found = spokes.len();
        if found < needed {
            return Err(FanError::RimTooShort { found, needed });
        }
        Ok(Self { hub, spokes })
    }

    /// How many triangles there are.
    pub fn triangle_count(&self) -> usize {
        self.spokes.len() - 1
    }

    /// The nearest hit; of triangles met at the same t, the first.
    ///
    /// # Accuracy
    ///
    /// No ray that passes through the inside of the fan is lost (tested as `fan_loses_no_ray_inside`). The points of the rim are used as the
    /// hub and its spokes, and may be off by a roundoff of the spoke.
    ///
    /// # Cost
    ///
    /// 5 multiplications and additions a triangle; some 30 more where two spokes have opposite signs, which is two triangles in most fans.
    // ANCHOR: fan
    pub fn intersect(&self, ray: &Ray<P>) -> Option<FanHit<P::Scalar>> {
        let view = View::new(self.hub, ray);
        let mut nearest: Option<FanHit<P::Scalar>> = None;
        let mut before = view.side_of(self.spokes[0]);
        for (triangle, ends) in self.spokes.windows(2).enumerate() {
            let after = view.side_of(ends[1]);
            if let Some(facet) = view.between([ends[0], ends[1]], [before, after])
                && nearest.is_none_or(|nearest| facet.t < nearest.facet.t)
            {
                nearest = Some(FanHit { triangle, facet });
            }
            before = after;
        }
        nearest
    }
    // ANCHOR_END: fan
}

/// A hub as a ray sees it, in the sheared space where the ray is an axis.
struct View<P: Vector3> {
    ray: Ray<P>,
    sheared: ShearedRay<P>,
    to_hub: P,
    /// x and y of the hub.
    hub: [P::Scalar; 2],
    m: P,
}

impl<P: Vector3> View<P> {
    fn new(hub: P, ray: &Ray<P>) -> Self {
        let sheared = ShearedRay::new(ray);
        let [x, y, _] = sheared.sheared(hub);
        Self {
            ray: *ray,
            to_hub: hub.minus(ray.origin),
            hub: [x, y],
            m: sheared.moment([x, y]),
            sheared,
        }
    }

    /// The side of the spoke that the ray passes on.
    #[inline]
    fn side_of(&self, spoke: P) -> P::Scalar {
        self.m.dot(spoke)
    }

    /// The hit with the triangle between two spokes whose sides are known.
    #[inline]
    fn between(
        &self,
        [first, second]: [P; 2],
        [before, after]: [P::Scalar; 2],
    ) -> Option<FacetHit<P::Scalar>> {
        let zero = P::Scalar::zero();
        let is_front = before <= zero && after >= zero;
        let is_back = before >= zero && after <= zero;
        if !(is_front || is_back) {
            return None;
        }
        let [x, y, _] = self.sheared.sheared_vector(first);
        let [rim_x, rim_y, _] = self.sheared.sheared_vector(second.minus(first));
        let outer = (self.hub[0] + x) * rim_y - (self.hub[1] + y) * rim_x;
        let is_inside = is_front && outer <= zero || is_back && outer >= zero;
        let sum = outer - after + before;
        let n = first.cross(second);
        let along = self.ray.direction.dot(n);
        if !is_inside || sum.is_zero() || along.is_zero() {
            return None;
        }
        let t = self.to_hub.dot(n) / along;
        facet_hit(&self.ray, t, [-after / sum, before / sum], Side::of(sum))
    }
}
