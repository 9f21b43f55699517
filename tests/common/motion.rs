//! Motions of space with whole numbers for coefficients, by quaternions.

use facette::algebra::{Scalar, VectorSpace};
use proptest::prelude::*;

/// A similarity with integer coefficients: `x → M x + shift`, where M is a rotation times `scale`.
#[derive(Clone, Copy, Debug)]
pub struct IntegerMotion {
    /// The columns of M.
    pub columns: [[i32; 3]; 3],
    /// The factor of lengths.
    pub scale: i32,
    /// The translation.
    pub shift: [i32; 3],
}

impl IntegerMotion {
    /// The rotation by a quaternion (Euler and Rodrigues), times the square of its length, which must not be 0.
    #[rustfmt::skip]
    pub fn new([a, b, c, d]: [i32; 4], shift: [i32; 3]) -> Self {
        let columns = [
            [a * a + b * b - c * c - d * d, 2 * (b * c + a * d), 2 * (b * d - a * c)],
            [2 * (b * c - a * d), a * a - b * b + c * c - d * d, 2 * (c * d + a * b)],
            [2 * (b * d + a * c), 2 * (c * d - a * b), a * a - b * b - c * c + d * d],
        ];
        Self { columns, scale: a * a + b * b + c * c + d * d, shift }
    }

    /// The axes of the rotation, orthonormal and right-handed: the columns over `scale`.
    pub fn axes<S: Scalar>(&self) -> [[S; 3]; 3] {
        let scale = S::from_i32(self.scale);
        self.columns
            .map(|column| column.map(|numerator| S::from_i32(numerator) / scale))
    }

    /// The image of a vector, lengths times `scale`.
    pub fn vector<S: Scalar>(&self, [x, y, z]: [S; 3]) -> [S; 3] {
        let [first, second, third] = self.columns.map(|column| column.map(S::from_i32));
        <[S; 3]>::combination([x, y, z], [first, second, third])
    }

    /// The image of a point.
    pub fn point<S: Scalar>(&self, point: [S; 3]) -> [S; 3] {
        self.vector(point).plus(self.shift.map(S::from_i32))
    }

    /// The vector turned by the rotation alone, lengths kept.
    pub fn turned<S: Scalar>(&self, vector: [S; 3]) -> [S; 3] {
        <[S; 3]>::combination(vector, self.axes())
    }
}

/// Motions by quaternions with small integer coefficients.
pub fn integer_motions() -> impl Strategy<Value = IntegerMotion> {
    let coefficient = || -2..=2_i32;
    let quaternion = [coefficient(), coefficient(), coefficient(), coefficient()];
    (quaternion, [-9..=9_i32, -9..=9, -9..=9]).prop_map(|(quaternion, shift)| {
        let is_zero = quaternion == [0; 4];
        IntegerMotion::new(if is_zero { [1, 1, 0, 0] } else { quaternion }, shift)
    })
}
