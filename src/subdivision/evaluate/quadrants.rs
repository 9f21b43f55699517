//! How a quadrilateral is cut at its corners, and a corner at its vertex.

use super::adaptive::Cut;
use super::bicubic;
use super::jet::Jacobian;
use crate::algebra::Scalar;

/// The parameters of a quadrilateral from those of its corner of this number.
pub(super) fn out_of_quadrant<S: Scalar>(corner: usize, [s, t]: [S; 2]) -> ([S; 2], Jacobian<S>) {
    let (zero, half) = (S::zero(), S::ratio(1, 2));
    let (near_s, near_t) = (s * half, t * half);
    let [far_s, far_t] = [near_s, near_t].map(|near| S::one() - near);
    match corner {
        0 => ([near_s, near_t], [[half, zero], [zero, half]]),
        1 => ([far_t, near_s], [[zero, half], [-half, zero]]),
        2 => ([far_s, far_t], [[-half, zero], [zero, -half]]),
        _ => ([near_t, far_s], [[zero, -half], [half, zero]]),
    }
}

/// The quadrant in which the parameters of a quadrilateral lie; the parameters there, and their derivatives.
pub(super) fn into_quadrant<S: Scalar>([u, v]: [S; 2]) -> (usize, [S; 2], Jacobian<S>) {
    let (zero, half, two) = (S::zero(), S::ratio(1, 2), S::from_i32(2));
    let (from_left, from_below) = (u * two, v * two);
    // Exact: there are at least half as many floating-point numbers below u as there are above 1 - u.
    let [from_right, from_above] = [u, v].map(|parameter| (S::one() - parameter) * two);
    match (u < half, v < half) {
        (true, true) => (0, [from_left, from_below], [[two, zero], [zero, two]]),
        (false, true) => (1, [from_below, from_right], [[zero, -two], [two, zero]]),
        (false, false) => (2, [from_right, from_above], [[-two, zero], [zero, -two]]),
        (true, false) => (3, [from_above, from_left], [[zero, two], [-two, zero]]),
    }
}

/// A corner's regular patches: three quadrants of its parameters.
#[derive(Clone, Copy, Debug)]
pub(super) struct Quadrants;

impl Cut<16> for Quadrants {
    fn weights<S: Scalar, const K: usize>(parameters: [S; 2]) -> [[S; 16]; K] {
        bicubic::weights(parameters)
    }

    fn part<S: Scalar>([s, t]: [S; 2]) -> Option<(usize, [S; 2], Jacobian<S>)> {
        let (zero, one, half, two) = (S::zero(), S::one(), S::ratio(1, 2), S::from_i32(2));
        let part = match (s < half, t < half) {
            (true, true) => return None,
            (false, true) => 0,
            (false, false) => 1,
            (true, false) => 2,
        };
        let [right, up] = [[one, zero], [one, one], [zero, one]][part];
        let inner = [s * two - right, t * two - up];
        Some((part, inner, [[two, zero], [zero, two]]))
    }
}
