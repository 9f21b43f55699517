//! Parametric surfaces: what tessellation and pictures need to know of a surface, whatever chapter it comes from.
//!
//! ```text
//! S : [u0, u1] × [v0, v1] → space,   (u, v) ↦ S(u, v)
//! ```
//!
//! # Conventions
//!
//! The normal is `S_u × S_v`: with u to the right and v up, it points at the reader. A grid of parameters is stored
//! row by row, u running fastest.
//!
//! *In the book*: [Coons patches](../../../coons.html).

use num_traits::Zero;

use crate::algebra::{Scalar, Vector3, VectorSpace, divided};

/// A surface given by a point for each pair of parameters.
pub trait Surface {
    /// The number type of the parameters.
    type Scalar: Scalar;
    /// The type of the points.
    type Point: VectorSpace<Scalar = Self::Scalar>;

    /// The parameter rectangle `[[u0, u1], [v0, v1]]`.
    fn domain(&self) -> [[Self::Scalar; 2]; 2];

    /// The point `S(u, v)`.
    fn point(&self, u: Self::Scalar, v: Self::Scalar) -> Self::Point;

    /// The partial derivatives `[S_u, S_v]`, where they are known.
    fn partials(&self, u: Self::Scalar, v: Self::Scalar) -> Option<[Self::Point; 2]>;

    /// A normal at the point, of any length: `S_u × S_v`. `None` where the derivatives are not known, or are zero or parallel; a
    /// surface that knows the limit at such a point may give it.
    fn normal_vector(&self, u: Self::Scalar, v: Self::Scalar) -> Option<Self::Point>
    where
        Self::Point: Vector3,
    {
        let [s_u, s_v] = self.partials(u, v)?;
        normal_of_tangents(s_u, s_v)
    }

    /// The points on the grid of all pairs of `us` and `vs`, written to `points[row * us.len() + column]` for `u =
    /// us[column]`, `v = vs[row]`; the same bits as [`Surface::point`] gives.
    ///
    /// # Panics
    ///
    /// When `points.len() != us.len() * vs.len()`: a caller's bug.
    fn points_on_grid(&self, us: &[Self::Scalar], vs: &[Self::Scalar], points: &mut [Self::Point]) {
        assert_grid_fits(us.len(), vs.len(), points.len());
        if us.is_empty() {
            return;
        }
        for (row, &v) in points.chunks_exact_mut(us.len()).zip(vs) {
            for (point, &u) in row.iter_mut().zip(us) {
                *point = self.point(u, v);
            }
        }
    }
}

/// Panics with the three lengths when a grid's buffer has not one place for each pair of parameters.
pub(crate) fn assert_grid_fits(columns: usize, rows: usize, places: usize) {
    assert!(
        columns * rows == places,
        "a grid of {columns} x {rows} parameters needs {} places, not {places}",
        columns * rows
    );
}

/// A normal `a × b` of the plane that two tangents span; `None` where they are parallel up to rounding.
///
/// Each tangent is divided by its largest coordinate first, so that nothing overflows or underflows. A coordinate of
/// the product is then wrong by at most 8 unit roundoffs (four for its own operations, four for the divisions): what is
/// not larger says nothing.
pub(crate) fn normal_of_tangents<P: Vector3>(a: P, b: P) -> Option<P> {
    let scales = [a.largest_coordinate(), b.largest_coordinate()];
    let usable = |&scale: &P::Scalar| scale > P::Scalar::zero() && Scalar::is_finite(scale);
    if !scales.iter().all(usable) {
        return None;
    }
    let normal = divided(a, scales[0]).cross(divided(b, scales[1]));
    let rounding = P::Scalar::from_i32(8) * P::Scalar::unit_roundoff();
    (normal.largest_coordinate() > rounding).then_some(normal)
}
