//! The circle and the sphere, without a root or a cosine.

use super::{Homogeneous, RationalCurve, RationalSurface};
use crate::algebra::{Scalar, Vector3};
use crate::bspline::{BsplineCurve, BsplineSurface, KnotVector};

/// Four quarters of a circle, as homogeneous points `[x, y, w]`: every other one lies on the circle.
///
/// In the first quarter `w = 1 + t²`, `x = 1 − t²`, `y = 2t`: the half-angle formulas with `t = tan(α/2)`.
#[rustfmt::skip]
// ANCHOR: circle_points
const CIRCLE: [[i32; 3]; 9] = [
    [ 1,  0, 1], [ 1,  1, 1],
    [ 0,  2, 2], [-1,  1, 1],
    [-1,  0, 1], [-1, -1, 1],
    [ 0, -2, 2], [ 1, -1, 1],
    [ 1,  0, 1],
];
// ANCHOR_END: circle_points

/// The right half of the circle from `(0, −1)` to `(0, 1)`, in the same form: the profile that the sphere turns about its axis.
const HALF_CIRCLE: [[i32; 3]; 5] = [[0, -1, 1], [1, -1, 1], [2, 0, 2], [1, 1, 1], [0, 1, 1]];

/// The unit circle around the origin, anticlockwise from `(1, 0)`, on `[0, 4]`: one quarter for each unit of the parameter.
///
/// All numbers are rational, so `x² + y² = 1` holds exactly over exact numbers.
///
/// # Edge cases
///
/// The parameter is not the angle: the speed is 2 at `(±1, 0)` and 1 at `(0, ±1)`. The curve is continuously differentiable
/// everywhere, at the joint of its ends too; the second derivative jumps at `(0, 1)` and `(0, −1)`, the parameters 1 and 3
/// (tested as `circle_parameter_is_not_the_angle` and `circle_joints_are_once_differentiable`).
///
/// # Source
///
/// The quarter circle with the weights 1, 1, 2: Piegl and Tiller 1997, section 7.3.
///
/// # Examples
///
/// ```
/// use facette::bspline::circle;
/// use facette::curve::Curve;
///
/// let [x, y] = circle::<f64>().point(0.5);
/// assert!((x - 0.6).abs() <= f64::EPSILON && (y - 0.8).abs() <= f64::EPSILON);
/// assert_eq!(circle::<f64>().point(3.0), [0.0, -1.0]);
/// ```
pub fn circle<S: Scalar>() -> RationalCurve<[S; 2]> {
    let points = CIRCLE.map(|point| {
        let [x, y, weight] = point.map(S::from_i32);
        Homogeneous {
            weighted: [x, y],
            weight,
        }
    });
    valid(
        BsplineCurve::new(quarters(4), points.to_vec())
            .map(|homogeneous| RationalCurve { homogeneous }),
    )
}

/// The unit sphere around the origin on `[0, 4] × [0, 2]`: u runs round the z axis from the x axis on, v from the south to the
/// north pole. `S_u × S_v` points outwards.
///
/// # Edge cases
///
/// The sides `v = 0` and `v = 2` are one point each, where `S_u` vanishes; the normal is known there all the same. Over floating-point numbers
/// a pole may come out an ulp apart for different u.
///
/// # Source
///
/// A surface of revolution: Piegl and Tiller 1997, section 8.5.
pub fn sphere<P: Vector3>() -> RationalSurface<P> {
    let net = HALF_CIRCLE.iter().flat_map(|&[radius, height, weight]| {
        CIRCLE.iter().map(move |&[x, y, w]| {
            let coordinates = [x * radius, y * radius, w * height];
            Homogeneous {
                weighted: P::from_coordinates(coordinates.map(P::Scalar::from_i32)),
                weight: P::Scalar::from_i32(w * weight),
            }
        })
    });
    let knots = [quarters(4), quarters(2)];
    valid(
        BsplineSurface::new(knots, net.collect())
            .map(|homogeneous| RationalSurface { homogeneous }),
    )
}

/// The knots of so many quadratic pieces, a unit of the parameter each, that meet on control points.
fn quarters<S: Scalar>(pieces: i32) -> KnotVector<S> {
    let breaks: Vec<S> = (1..=2 * pieces).map(|half| S::from_i32(half / 2)).collect();
    valid(KnotVector::clamped(2, &breaks))
}

/// What is built from this module's constants, over any number type.
fn valid<T, E: std::fmt::Debug>(built: Result<T, E>) -> T {
    built.expect("the constants are small increasing knots and finite points")
}
