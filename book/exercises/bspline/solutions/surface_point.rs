//! A solution of exercise 4: a point of a surface, in the five steps of the course.

use crate::algebra::VectorSpace;
use crate::bspline::{BsplineSurface, Direction};
use reference::bspline::{basis_functions, find_span};

/// The point `S(u, v)` as a double sum.
pub fn surface_point<P: VectorSpace>(surface: &BsplineSurface<P>, u: P::Scalar, v: P::Scalar) -> P {
    let [in_u, in_v] = [surface.knots(Direction::U), surface.knots(Direction::V)];
    let [p, q] = [in_u.degree(), in_v.degree()];

    let i = find_span(in_u, u);
    let mut n_u = vec![u; p + 1];
    basis_functions(in_u, i, u, &mut n_u);

    let j = find_span(in_v, v);
    let mut n_v = vec![v; q + 1];
    basis_functions(in_v, j, v, &mut n_v);

    let mut sum = P::origin();
    for k in 0..=p {
        for l in 0..=q {
            let point = surface.control_point(i - p + k, j - q + l);
            sum = sum.plus(point.times(n_u[k] * n_v[l]));
        }
    }
    sum
}
