//! The limit itself: where a vertex ends up after infinitely many steps, and which way the surface faces there.
//!
//! One step maps the ring of a vertex to the ring of the same vertex on the next level, by a small matrix S that is the same on every level. So
//! the limit is a matter of eigenvalues. With the left eigenvectors ℓ and the eigenvalues 1 > λ = λ > μ of S,
//!
//! ```text
//! limit position   ℓ₀ · p              ℓ₀ S = ℓ₀,    weights that sum to 1
//! tangents         ℓ₁ · p, ℓ₂ · p      ℓᵢ S = λ ℓᵢ,  weights that sum to 0
//! ```
//!
//! Everything else shrinks faster than λᵏ, so the ring becomes a flat picture of the two tangents. The masks are these eigenvectors in closed
//! form, for every valence.
//!
//! # Conventions
//!
//! The neighbours of a vertex are taken anticlockwise, at equal angles of the parameter plane: a full turn in the interior, half a turn on a
//! boundary, beginning with the boundary's own half-edge. Tangents are scaled so that the regular star (neighbours on the unit circle, or for
//! quadrilaterals parallelograms between them) has the tangents (1, 0) and (0, 1): at regular vertices they are the partial derivatives of the
//! spline. The normal is t₁ × t₂, which points to where the faces run anticlockwise.
//!
//! # Numerics
//!
//! All masks are applied to differences from the vertex, so a mesh far from the origin loses one rounding of the position and nothing of its
//! normal. Many steps are never taken for the limit: at valence 100 twelve steps of Catmull-Clark leave half a percent of the way.
//!
//! # Sources
//!
//! M. Halstead, M. Kass, T. DeRose, *Efficient, fair interpolation using Catmull-Clark surfaces*, 1993 (limit masks); J. Stam, *Exact evaluation
//! of Catmull-Clark subdivision surfaces at arbitrary parameter values*, 1998, and *Evaluation of Loop subdivision surfaces*, 1998 (eigenvalues);
//! L. Kobbelt, *√3-subdivision*, 2000, section 3; D. Doo, M. Sabin, *Behaviour of recursive division surfaces near extraordinary points*, 1978;
//! U. Reif, *A unified approach to subdivision algorithms near extraordinary vertices*, 1995; H. Biermann, A. Levin, D. Zorin, *Piecewise
//! smooth subdivision surfaces with normal control*, 2000 (boundaries). The masks of irregular boundary vertices are derived here.
//!
//! *In the course*: slides 71, 76 to 78 (*points extraordinaires*, *continuité*).
//!
//! *In the book*: [Limits](../../../../subdivision/limits.html).

mod catmull_clark;
mod distance;
mod doo_sabin;
mod eigenvalues;
mod ring;
mod triangles;
mod turn;

pub use catmull_clark::{
    catmull_clark_limit_positions, catmull_clark_limits, catmull_clark_limits_with,
};
pub use distance::{DistanceBound, catmull_clark_distance_bound, loop_distance_bound};
pub use doo_sabin::{doo_sabin_limits, doo_sabin_limits_with};
pub use eigenvalues::{
    Eigenvalues, catmull_clark_eigenvalues, catmull_clark_ring_eigenvalues,
    catmull_clark_vertex_eigenvalues, doo_sabin_eigenvalue, doo_sabin_eigenvalues,
    loop_eigenvalues, loop_ring_eigenvalue, loop_vertex_eigenvalue, sqrt3_eigenvalues,
    sqrt3_ring_eigenvalue, sqrt3_vertex_eigenvalue,
};
pub use triangles::{
    loop_limit_positions, loop_limits, loop_limits_with, sqrt3_limit_positions, sqrt3_limits,
    sqrt3_limits_with,
};
pub use turn::turn_point;

use crate::algebra::{Real, Vector3, VectorSpace, unit_vector};

/// What the limit surface is like at a vertex, or at the middle of a face.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limit<P: VectorSpace> {
    /// The point of the surface.
    pub position: P,
    /// Two directions that span the tangent plane, with t₁ × t₂ along the normal; on a boundary the first runs along it, with the
    /// surface on its left, and the second into the surface. `None` where no face is, or where two faces fold over a vertex.
    pub tangents: Option<[P; 2]>,
}

impl<P: Vector3> Limit<P>
where
    P::Scalar: Real,
{
    /// The unit normal, or `None` where there are no tangents or they are parallel or zero.
    ///
    /// # Accuracy
    ///
    /// As good as the tangents' directions: both are brought to unit length before they are multiplied, so that nothing overflows or
    /// underflows whatever the size of the mesh.
    // ANCHOR: normal
    pub fn normal(&self) -> Option<P> {
        let [along, across] = self.tangents?;
        unit_vector(unit_vector(along)?.cross(unit_vector(across)?))
    }
    // ANCHOR_END: normal
}
