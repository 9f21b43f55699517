//! The bicubic Hermite patch, or Ferguson patch: 16 vectors and nothing else.

use num_traits::{One, Zero};

use super::bicubic::tensor_product;
use super::boundary::CoonsError;
use super::hermite::{hermite_basis, hermite_basis_derivative};
use crate::algebra::{Scalar, VectorSpace};
use crate::surface::Surface;

/// The bicubic surface with given positions, first derivatives and twists at its four corners:
///
/// ```text
///                    ⎡ S(0,0)    S_v(0,0)   S_v(0,1)   S(0,1)   ⎤
/// S(u,v) = H(u)ᵀ  ·  ⎢ S_u(0,0)  S_uv(0,0)  S_uv(0,1)  S_u(0,1) ⎥  ·  H(v)
///                    ⎢ S_u(1,0)  S_uv(1,0)  S_uv(1,1)  S_u(1,1) ⎥
///                    ⎣ S(1,0)    S_v(1,0)   S_v(1,1)   S(1,1)   ⎦
/// ```
///
/// It interpolates points, where the bicubically blended Coons patch interpolates curves; the two agree when the curves
/// are the cubics of these vectors.
///
/// # Source
///
/// Ferguson 1964; Farin 2002, section 15.6.
#[derive(Clone, Debug, PartialEq)]
pub struct FergusonPatch<P> {
    vectors: [[P; 4]; 4],
}

impl<P: VectorSpace> FergusonPatch<P> {
    /// The patch of the 16 vectors in the order of the matrix above.
    ///
    /// # Errors
    ///
    /// [`CoonsError::NotFinite`] for a coordinate that is infinite or NaN.
    pub fn new(vectors: [[P; 4]; 4]) -> Result<Self, CoonsError<P>> {
        match vectors
            .iter()
            .flatten()
            .find(|vector| !vector.has_finite_coordinates())
        {
            Some(&value) => Err(CoonsError::NotFinite {
                what: "a corner vector",
                value,
            }),
            None => Ok(Self { vectors }),
        }
    }

    /// The bicubic Bézier patch with the control points `net[i][j]`, `i` along u and `j` along v.
    ///
    /// # Errors
    ///
    /// As [`FergusonPatch::new`].
    pub fn from_bezier(net: [[P; 4]; 4]) -> Result<Self, CoonsError<P>> {
        let rows = hermite_data(net, |row: [P; 4], other: [P; 4]| {
            std::array::from_fn(|j| side(row[j], other[j]))
        });
        Self::new(rows.map(|row| hermite_data(row, side)))
    }

    /// The 16 vectors, in the order of the matrix above.
    pub fn vectors(&self) -> &[[P; 4]; 4] {
        &self.vectors
    }
}

/// Value and slope at both ends, from the four control values of a cubic.
fn hermite_data<T: Copy>([b0, b1, b2, b3]: [T; 4], slope: impl Fn(T, T) -> T) -> [T; 4] {
    [b0, slope(b0, b1), slope(b2, b3), b3]
}

/// The slope of a cubic at the end of its control polygon whose side is given.
fn side<P: VectorSpace>(start: P, end: P) -> P {
    end.minus(start).times(P::Scalar::from_i32(3))
}

impl<P: VectorSpace> Surface for FergusonPatch<P> {
    type Scalar = P::Scalar;
    type Point = P;

    fn domain(&self) -> [[P::Scalar; 2]; 2] {
        [[P::Scalar::zero(), P::Scalar::one()]; 2]
    }

    fn point(&self, u: P::Scalar, v: P::Scalar) -> P {
        tensor_product(hermite_basis(u), self.vectors, hermite_basis(v))
    }

    fn partials(&self, u: P::Scalar, v: P::Scalar) -> Option<[P; 2]> {
        let s_u = tensor_product(hermite_basis_derivative(u), self.vectors, hermite_basis(v));
        let s_v = tensor_product(hermite_basis(u), self.vectors, hermite_basis_derivative(v));
        Some([s_u, s_v])
    }
}
