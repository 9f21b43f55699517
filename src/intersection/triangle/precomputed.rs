//! Two tests that store numbers of the triangle beforehand: Shevtsov, Soupikov and Kapustin's, Baldwin and Weber's.

use num_traits::Zero;

use super::facet_hit;
use crate::algebra::{Scalar, Vector3};
use crate::intersection::{FacetHit, Side};
use crate::ray::Ray;

/// The axes of a triangle: along the longest coordinate of its normal, and the two that follow it.
fn axes<P: Vector3>(normal: P) -> [usize; 3] {
    let w = normal.largest_axis();
    [(w + 1) % 3, (w + 2) % 3, w]
}

/// The coordinates along the three axes.
#[inline]
fn along<P: Vector3>(vector: P, axes: [usize; 3]) -> [P::Scalar; 3] {
    axes.map(|axis| vector.coordinate(axis))
}

/// The corners' normal `(b − a) × (c − a)`; `None` where it is zero, infinite or NaN.
fn usable_normal<P: Vector3>([a, b, c]: &[P; 3]) -> Option<P> {
    let n = b.minus(*a).cross(c.minus(*a));
    (n.largest_coordinate() > P::Scalar::zero() && n.has_finite_coordinates()).then_some(n)
}

/// A triangle as Shevtsov, Soupikov and Kapustin store it: the plane divided by the longest coordinate of its normal, and the edges seen
/// along that axis.
///
/// # Accuracy
///
/// The stored constant `n·a / n_w` is rounded: far from the origin, at a distance D, t loses an absolute `u D` or so, where the tests that
/// subtract the ray's origin first lose nothing (hard case `stored_plane_loses_digits_far_away`). Not watertight.
///
/// # Cost
///
/// Nine numbers and an axis a triangle; 21 multiplications and additions, 3 divisions on a hit, none on a miss.
///
/// # Source
///
/// Shevtsov, Soupikov, Kapustin 2007.
#[derive(Clone, Copy, Debug)]
pub struct ShevtsovTriangle<S> {
    axes: [usize; 3],
    /// `n_u / n_w`, `n_v / n_w` and `n·a / n_w`.
    plane: [S; 3],
    /// `a_u` and `a_v`.
    corner: [S; 2],
    /// The edges to b and c over `n_w`, along u and v.
    edges: [[S; 2]; 2],
    /// Whether the normal runs against its longest axis.
    is_reversed: bool,
}

impl<S: Scalar> ShevtsovTriangle<S> {
    /// Computes what is stored; `None` for a triangle without area or with a normal that is not finite.
    pub fn new<P: Vector3<Scalar = S>>(corners: &[P; 3]) -> Option<Self> {
        let n = usable_normal(corners)?;
        let axes = axes(n);
        let [nu, nv, nw] = along(n, axes);
        let [a, b, c] = *corners;
        let [au, av, aw] = along(a, axes);
        let edge = |end: P| {
            let [eu, ev, _] = along(end.minus(a), axes);
            [eu / nw, ev / nw]
        };
        let [nu, nv] = [nu / nw, nv / nw];
        Some(Self {
            axes,
            plane: [nu, nv, nu * au + nv * av + aw],
            corner: [au, av],
            edges: [edge(b), edge(c)],
            is_reversed: nw < S::zero(),
        })
    }

    /// The hit with a ray.
    #[inline]
    // ANCHOR: shevtsov
    pub fn intersect<P: Vector3<Scalar = S>>(&self, ray: &Ray<P>) -> Option<FacetHit<S>> {
        let [ou, ov, ow] = along(ray.origin, self.axes);
        let [du, dv, dw] = along(ray.direction, self.axes);
        let ([nu, nv, np], [au, av]) = (self.plane, self.corner);
        let determinant = du * nu + dv * nv + dw;
        let depth = np - (ou * nu + ov * nv + ow);
        // The point of the plane less a, times the determinant.
        let xu = du * depth - (au - ou) * determinant;
        let xv = dv * depth - (av - ov) * determinant;
        let [[bu, bv], [cu, cv]] = self.edges;
        let v = cv * xu - cu * xv;
        let w = bu * xv - bv * xu;
        let u = determinant - v - w;
        let zero = S::zero();
        let is_inside = (u >= zero && v >= zero && w >= zero && determinant > zero)
            || (u <= zero && v <= zero && w <= zero && determinant < zero);
        if !is_inside {
            return None;
        }
        let along_normal = if self.is_reversed {
            -determinant
        } else {
            determinant
        };
        let parameters = [v / determinant, w / determinant];
        facet_hit(ray, depth / determinant, parameters, Side::of(along_normal))
    }
    // ANCHOR_END: shevtsov
}

/// A triangle as Baldwin and Weber store it: the affine map that takes it to the corners (0,0,0), (1,0,0), (0,1,0), with its third axis
/// chosen so that one column of the map is 0 and 1.
///
/// # Accuracy
///
/// As [`ShevtsovTriangle`]: the three stored constants are rounded where the triangle is far from the origin, so here the barycentric
/// coordinates lose digits too. Not watertight.
///
/// # Cost
///
/// Nine numbers and an axis a triangle; 27 multiplications and additions, one division.
///
/// # Source
///
/// Baldwin, Weber 2016.
#[derive(Clone, Copy, Debug)]
pub struct BaldwinWeberTriangle<S> {
    axes: [usize; 3],
    /// The weights of b and of c and the height over the plane: the coefficients of u and v, and the constant.
    rows: [[S; 3]; 3],
    /// Whether the normal runs against its longest axis.
    is_reversed: bool,
}

impl<S: Scalar> BaldwinWeberTriangle<S> {
    /// Computes what is stored; `None` for a triangle without area or with a normal that is not finite.
    pub fn new<P: Vector3<Scalar = S>>(corners: &[P; 3]) -> Option<Self> {
        let n = usable_normal(corners)?;
        let axes = axes(n);
        let [nu, nv, nw] = along(n, axes);
        let [a, b, c] = *corners;
        let [au, av, aw] = along(a, axes);
        let [[bu, bv, _], [cu, cv, _]] = [b, c].map(|end| along(end.minus(a), axes));
        let row = |u: S, v: S| [u, v, -(u * au + v * av)];
        let mut height = row(nu / nw, nv / nw);
        height[2] = height[2] - aw;
        Some(Self {
            axes,
            rows: [row(cv / nw, -cu / nw), row(-bv / nw, bu / nw), height],
            is_reversed: nw < S::zero(),
        })
    }

    /// The hit with a ray.
    #[inline]
    // ANCHOR: baldwin_weber
    pub fn intersect<P: Vector3<Scalar = S>>(&self, ray: &Ray<P>) -> Option<FacetHit<S>> {
        let [ou, ov, ow] = along(ray.origin, self.axes);
        let [du, dv, dw] = along(ray.direction, self.axes);
        let [weight_of_b, weight_of_c, height] = self.rows;
        let slope = height[0] * du + height[1] * dv + dw;
        if slope.is_zero() {
            return None;
        }
        let t = -(height[0] * ou + height[1] * ov + ow + height[2]) / slope;
        let [xu, xv] = [ou + t * du, ov + t * dv];
        let [v, w] = [weight_of_b, weight_of_c].map(|[u, v, constant]| u * xu + v * xv + constant);
        if !(v >= S::zero() && w >= S::zero() && v + w <= S::one()) {
            return None;
        }
        let along_normal = if self.is_reversed { -slope } else { slope };
        facet_hit(ray, t, [v, w], Side::of(along_normal))
    }
    // ANCHOR_END: baldwin_weber
}
