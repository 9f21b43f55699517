//! Bounds of second derivatives from control points: a derivative lies in the convex hull of its control net on a rectangle.

use num_traits::Zero;

use super::bounds::{BoundedSurface, Bounds, Break, Continuity};
use crate::algebra::{Real, Scalar, Vector3, VectorSpace, larger, length};
use crate::bspline::{
    BsplineSurface, Closing, Direction, Homogeneous, KnotVector, PeriodicSurface, RationalSurface,
    basis_derivatives, find_span, piece_blossom,
};
use crate::surface::{Surface, normal_of_tangents};

/// The derivative surfaces of these orders `[k, l]`.
fn derivatives<Q: VectorSpace, const N: usize>(
    surface: &BsplineSurface<Q>,
    orders: [[usize; 2]; N],
) -> [BsplineSurface<Q>; N] {
    orders.map(|[in_u, in_v]| {
        let directions = [(Direction::U, in_u), (Direction::V, in_v)];
        directions
            .into_iter()
            .fold(surface.clone(), |derivative, (direction, order)| {
                (0..order).fold(derivative, |d, _| d.derivative_surface(direction))
            })
    })
}

/// The middle of an interval.
fn middle<S: Scalar>([start, end]: [S; 2]) -> S {
    start * S::ratio(1, 2) + end * S::ratio(1, 2)
}

/// The spans whose polynomials count on an interval: its own; those on both sides where it is a single knot.
fn spans_on<S: Scalar>(knots: &KnotVector<S>, interval: [S; 2]) -> Vec<usize> {
    let [start, end] = interval;
    if start < end {
        return vec![find_span(knots, middle(interval))];
    }
    let own = find_span(knots, start);
    let before = knots
        .spans()
        .filter(|&span| span < own && knots.span_interval(span)[1] == start);
    before.chain([own]).collect()
}

/// The arguments of the blossoms that are the Bézier points on an interval; one set of arguments where it is a single number.
fn bezier_arguments<S: Scalar>(degree: usize, [start, end]: [S; 2]) -> Vec<Vec<S>> {
    let last = if start < end { degree } else { 0 };
    let arguments = |r| {
        (0..degree)
            .map(|index| if index < degree - r { start } else { end })
            .collect()
    };
    (0..=last).map(arguments).collect()
}

/// The control points, in Bézier form, of the surface on a rectangle: over v first, so that at a clamped side nothing but the side's own
/// control points comes in, in the same order from whichever side.
fn net_on<Q: VectorSpace>(surface: &BsplineSurface<Q>, rectangle: [[Q::Scalar; 2]; 2]) -> Vec<Q> {
    let [in_u, in_v] = [Direction::U, Direction::V].map(|direction| surface.knots(direction));
    let [p, q] = [in_u, in_v].map(KnotVector::degree);
    let across = bezier_arguments(p, rectangle[0]);
    let mut net = Vec::new();
    for j in spans_on(in_v, rectangle[1]) {
        for i in spans_on(in_u, rectangle[0]) {
            for arguments in bezier_arguments(q, rectangle[1]) {
                let point = |column: usize| {
                    let points = (j - q..=j).map(|row| surface.control_point(column, row));
                    piece_blossom(in_v, &points.collect::<Vec<_>>(), j, &arguments)
                };
                let line: Vec<Q> = (i - p..=i).map(point).collect();
                let on_line = |arguments: &Vec<Q::Scalar>| piece_blossom(in_u, &line, i, arguments);
                net.extend(across.iter().map(on_line));
            }
        }
    }
    net
}

/// The largest of the numbers; NaN where one is NaN.
fn largest<S: Scalar>(numbers: impl IntoIterator<Item = S>) -> S {
    numbers.into_iter().fold(S::zero(), larger)
}

/// The knots of the domain, each with how the surface goes on there; degree and multiplicity decide.
fn lines_of<S: Scalar>(knots: &KnotVector<S>) -> Vec<Break<S>> {
    let [start, end] = knots.domain();
    let degree = knots.degree();
    let starts = knots.spans().map(|span| knots.span_interval(span)[0]);
    let continuity = |at: S| match knots.multiplicity(at) {
        _ if at == start => Continuity::Smooth,
        many if many > degree => Continuity::Torn,
        many if many == degree => Continuity::Crease,
        _ => Continuity::Smooth,
    };
    let inner = starts.map(|at| Break {
        at,
        continuity: continuity(at),
    });
    inner.chain([Break::smooth(end)]).collect()
}

/// The derivative of order `[k, l]` at `(u, v)` of the polynomial that the surface is on a piece.
fn derivative_in<Q: VectorSpace>(
    surface: &BsplineSurface<Q>,
    piece: [[Q::Scalar; 2]; 2],
    [k, l]: [usize; 2],
    [u, v]: [Q::Scalar; 2],
) -> Q {
    let weights = |direction, order: usize, at, interval| {
        let knots = surface.knots(direction);
        let span = find_span(knots, middle(interval));
        let mut rows = vec![Q::Scalar::zero(); (order + 1) * (knots.degree() + 1)];
        basis_derivatives(knots, span, at, &mut rows);
        let weights = rows.split_off(order * (knots.degree() + 1));
        (span - knots.degree(), weights)
    };
    let (i, in_u) = weights(Direction::U, k, u, piece[0]);
    let (j, in_v) = weights(Direction::V, l, v, piece[1]);
    // The weights of a derivative sum to 0: what all points have in common is taken away before it is rounded.
    let common = if k + l > 0 {
        surface.control_point(i, j)
    } else {
        Q::origin()
    };
    let mut sum = Q::origin();
    for (row, &weight) in in_v.iter().enumerate() {
        for (column, &other) in in_u.iter().enumerate() {
            let point = surface.control_point(i + column, j + row).minus(common);
            sum = sum.plus(point.times(weight * other));
        }
    }
    sum
}

/// How a surface with these lines closes: where the curves on opposite sides have the same control points.
fn closing_of<Q: VectorSpace>(surface: &BsplineSurface<Q>) -> [Closing; 2] {
    let [[u0, u1], [v0, v1]] = surface.domain();
    let closed = |is_closed| {
        if is_closed {
            Closing::Closed
        } else {
            Closing::Open
        }
    };
    let same = |a: &[Q], b: &[Q]| a == b;
    [
        closed(same(
            surface.curve_at_u(u0).control_points(),
            surface.curve_at_u(u1).control_points(),
        )),
        closed(same(
            surface.curve_at_v(v0).control_points(),
            surface.curve_at_v(v1).control_points(),
        )),
    ]
}

/// As [`BoundedSurface`] says. Closed in a direction where the curves on the two opposite sides have the same control points.
impl<P> BoundedSurface for BsplineSurface<P>
where
    P: Vector3,
    P::Scalar: Real,
{
    fn break_lines(&self) -> [Vec<Break<P::Scalar>>; 2] {
        [Direction::U, Direction::V].map(|direction| lines_of(self.knots(direction)))
    }

    // ANCHOR: bspline_bounds
    fn second_derivative_bounds(&self) -> Bounds<'_, P::Scalar> {
        let second = derivatives(self, [[2, 0], [1, 1], [0, 2]]);
        Box::new(move |rectangle| {
            let bound = |surface| largest(net_on(surface, rectangle).into_iter().map(length));
            second.each_ref().map(bound)
        })
    }
    // ANCHOR_END: bspline_bounds

    fn closing(&self) -> [Closing; 2] {
        closing_of(self)
    }

    fn point_in(&self, piece: [[P::Scalar; 2]; 2], u: P::Scalar, v: P::Scalar) -> P {
        derivative_in(self, piece, [0, 0], [u, v])
    }

    fn normal_in(&self, piece: [[P::Scalar; 2]; 2], u: P::Scalar, v: P::Scalar) -> Option<P> {
        let tangents = [[1, 0], [0, 1]].map(|orders| derivative_in(self, piece, orders, [u, v]));
        normal_of_tangents(tangents[0], tangents[1])
    }
}

/// As the B-spline surface inside, closed as [`PeriodicSurface::closing`] says.
impl<P> BoundedSurface for PeriodicSurface<P>
where
    P: Vector3,
    P::Scalar: Real,
{
    /// Those of the surface inside; where it closes over a knot that stands as often as the degree says, both ends are creases too.
    fn break_lines(&self) -> [Vec<Break<P::Scalar>>; 2] {
        let mut lines = self.surface().break_lines();
        for (index, direction) in [Direction::U, Direction::V].into_iter().enumerate() {
            let knots = self.surface().knots(direction);
            let [start, _] = knots.domain();
            let is_crease = knots.multiplicity(start) >= knots.degree();
            if self.closing()[index] != Closing::Open && is_crease {
                let last = lines[index].len() - 1;
                for end in [0, last] {
                    lines[index][end].continuity = Continuity::Crease;
                }
            }
        }
        lines
    }

    fn second_derivative_bounds(&self) -> Bounds<'_, P::Scalar> {
        self.surface().second_derivative_bounds()
    }

    fn closing(&self) -> [Closing; 2] {
        PeriodicSurface::closing(self)
    }

    fn point_in(&self, piece: [[P::Scalar; 2]; 2], u: P::Scalar, v: P::Scalar) -> P {
        self.surface().point_in(piece, u, v)
    }

    fn normal_in(&self, piece: [[P::Scalar; 2]; 2], u: P::Scalar, v: P::Scalar) -> Option<P> {
        self.surface().normal_in(piece, u, v)
    }
}

/// The bounds of `[|S_uu|, |S_uv|, |S_vv|]` of `S = A / w` from the control nets of the derivatives of `(A, w)`, ordered as
/// `[00, 10, 01, 20, 11, 02]`, by the quotient rule:
///
/// ```text
/// S_u = (A_u − w_u S) / w        S_uu = (A_uu − 2 w_u S_u − w_uu S) / w        S_uv = (A_uv − w_u S_v − w_v S_u − w_uv S) / w
/// ```
///
/// It holds for `S − c` as well, with `c` a point of the surface: that keeps the bounds small far from the origin.
// ANCHOR: quotient_bounds
fn quotient_bounds<P>(nets: &[Vec<Homogeneous<P>>; 6]) -> [P::Scalar; 3]
where
    P: Vector3,
    P::Scalar: Real,
{
    let centre = nets[0]
        .first()
        .map_or_else(P::origin, |point| point.projected());
    let of_points = nets.each_ref().map(|net| {
        let seen_from_centre =
            |h: &Homogeneous<P>| length(h.weighted.minus(centre.times(h.weight)));
        largest(net.iter().map(seen_from_centre))
    });
    let of_weights = nets
        .each_ref()
        .map(|net| largest(net.iter().map(|h| h.weight.magnitude())));
    let weights = nets[0].iter().map(|h| h.weight);
    let smallest = weights.reduce(|a, b| if b < a { b } else { a });
    let w = smallest.unwrap_or_else(P::Scalar::zero);
    let radii = nets[0].iter().map(|h| length(h.projected().minus(centre)));
    let s = largest(radii);
    let [_, a_u, a_v, a_uu, a_uv, a_vv] = of_points;
    let [_, w_u, w_v, w_uu, w_uv, w_vv] = of_weights;
    let [s_u, s_v] = [(a_u + w_u * s) / w, (a_v + w_v * s) / w];
    [
        (a_uu + w_u * s_u + w_u * s_u + w_uu * s) / w,
        (a_uv + w_u * s_v + w_v * s_u + w_uv * s) / w,
        (a_vv + w_v * s_v + w_v * s_v + w_vv * s) / w,
    ]
}
// ANCHOR_END: quotient_bounds

/// So many parts of a rectangle in each direction are bounded by themselves: the quotient rule takes the worst of numerator and denominator apart,
/// and on a smaller part they are nearer to each other.
const PARTS: i32 = 4;

/// The parts of an interval; a single number is one part.
fn parts<S: Scalar>([start, end]: [S; 2]) -> Vec<[S; 2]> {
    if start >= end {
        return vec![[start, end]];
    }
    let at = |part| start * S::ratio(PARTS - part, PARTS) + end * S::ratio(part, PARTS);
    (0..PARTS).map(|part| [at(part), at(part + 1)]).collect()
}

/// The bounds on a rectangle from the derivatives of `(A, w)`; zero on a side that is collapsed to a point, whatever its weights.
fn rational_bounds<P>(
    derivatives: &[BsplineSurface<Homogeneous<P>>; 6],
    rectangle: [[P::Scalar; 2]; 2],
) -> [P::Scalar; 3]
where
    P: Vector3,
    P::Scalar: Real,
{
    let nets = derivatives
        .each_ref()
        .map(|surface| net_on(surface, rectangle));
    let is_a_side = rectangle.iter().any(|[start, end]| start == end);
    if is_a_side && is_one_point(&nets[0]) {
        return [P::Scalar::zero(); 3];
    }
    quotient_bounds(&nets)
}

/// Whether the projected control points are one point. Points times weights that were rounded, and divided by the weights again, may
/// differ by 3u each.
fn is_one_point<P: Vector3>(net: &[Homogeneous<P>]) -> bool {
    let mut points = net.iter().map(|h| h.projected());
    let first = points.next().unwrap_or_else(P::origin);
    let roundoffs = P::Scalar::from_i32(6) * P::Scalar::unit_roundoff();
    points.all(|point| {
        let gap = point.minus(first).largest_coordinate();
        gap <= roundoffs * larger(point.largest_coordinate(), first.largest_coordinate())
    })
}

/// As [`BoundedSurface`] says, by the quotient rule; weights must be positive. Closed where the curves on the two opposite sides
/// have the same control points and weights.
impl<P> BoundedSurface for RationalSurface<P>
where
    P: Vector3,
    P::Scalar: Real,
{
    fn break_lines(&self) -> [Vec<Break<P::Scalar>>; 2] {
        [Direction::U, Direction::V].map(|direction| lines_of(self.knots(direction)))
    }

    fn is_collapsed(&self, side: [[P::Scalar; 2]; 2]) -> bool {
        is_one_point(&net_on(self.homogeneous(), side))
    }

    fn second_derivative_bounds(&self) -> Bounds<'_, P::Scalar> {
        const ORDERS: [[usize; 2]; 6] = [[0, 0], [1, 0], [0, 1], [2, 0], [1, 1], [0, 2]];
        let all = derivatives(self.homogeneous(), ORDERS);
        Box::new(move |rectangle| {
            let [us, vs] = rectangle.map(parts);
            let smaller = vs.iter().flat_map(|&v| us.iter().map(move |&u| [u, v]));
            let bounds = smaller.map(|part| rational_bounds(&all, part));
            bounds.fold([P::Scalar::zero(); 3], |most, bound| {
                [0, 1, 2].map(|which| larger(most[which], bound[which]))
            })
        })
    }

    fn closing(&self) -> [Closing; 2] {
        closing_of(self.homogeneous())
    }

    fn point_in(&self, piece: [[P::Scalar; 2]; 2], u: P::Scalar, v: P::Scalar) -> P {
        derivative_in(self.homogeneous(), piece, [0, 0], [u, v]).projected()
    }

    fn normal_in(&self, piece: [[P::Scalar; 2]; 2], u: P::Scalar, v: P::Scalar) -> Option<P> {
        let [at, in_u, in_v] = [[0, 0], [1, 0], [0, 1]]
            .map(|orders| derivative_in(self.homogeneous(), piece, orders, [u, v]));
        let point = at.projected();
        let tangents = [in_u, in_v].map(|h| h.weighted.minus(point.times(h.weight)));
        normal_of_tangents(tangents[0], tangents[1])
    }
}
