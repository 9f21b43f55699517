//! The theorems of Chaikin's scheme and of the quadratic B-spline that is its limit. The book shows their doc comments.

use facette::algebra::VectorSpace;
use facette::bspline::KnotVector;
use facette::curve::Curve;
use facette::subdivision::curve::{Ends, chaikin_step, limit_curve, limit_points, limit_tangents};
use num_traits::{One, Zero};
use proptest::prelude::*;

use crate::common::exact::{Exact, fraction};
use crate::common::generators::{parameter, point};
use crate::common::law::{Law, expect_equal};
use crate::curve_inputs::{
    Point, continued, hard_polygons, long_hard_polygons, long_polygons, polygons, refined,
    uniform_bspline, whole,
};
use crate::suspects;

/// A matrix with three rows.
type Matrix = [[Exact; 3]; 3];

fn product(a: &Matrix, b: &Matrix) -> Matrix {
    let entry = |row: usize, column: usize| {
        let terms = (0..3).map(|k| a[row][k] * b[k][column]);
        terms.fold(Exact::zero(), |sum, term| sum + term)
    };
    [0, 1, 2].map(|row| [0, 1, 2].map(|column| entry(row, column)))
}

fn applied(matrix: &Matrix, points: [Point; 3]) -> [Point; 3] {
    matrix.map(|row| Point::combination(row, points))
}

/// A matrix of integers over a common denominator.
fn matrix(rows: [[i32; 3]; 3], denominator: i32) -> Matrix {
    rows.map(|row| row.map(|entry| fraction(entry, denominator)))
}

/// The slides' matrix $M$: a piece is $[1\;u\;u^2]\,M\,[P_0\;P_1\;P_2]^T$.
fn piece_matrix() -> Matrix {
    matrix([[1, 1, 0], [-2, 2, 0], [1, -2, 1]], 2)
}

/// **Two points on every edge.** A round of Chaikin's scheme puts $Q=\frac34P+\frac14P_+$ and $R=\frac14P+\frac34P_+$ on the edge from $P$ to $P_+$. A closed
/// polygon of $n$ points has $n$ edges, the last from $P_{n-1}$ to $P_0$, and becomes one of $2n$ points. An open one has $n-1$ edges and becomes
/// one of $2n-2$; its end points are lost. Where they are to be kept, they stand before and behind: $2n$ points.
///
/// Course: D04, slide 54, Chaikin's algorithm: n points become 2n.
/// Exercise: chaikin.
/// Erratum: the slide makes $2n$ points of $P_0,\dots,P_{n-1}$, with $Q_i$ and $R_i$ for $i=0,\dots,n-1$. That needs $P_n$: it holds for a closed polygon, with $P_n=P_0$. An open one has no edge behind its last point: 3 points become 4.
#[test]
fn chaikin_puts_two_points_on_every_edge() {
    Law::new(
        "subdivision::chaikin_puts_two_points_on_every_edge",
        suspects::chaikin,
    )
    .holds(polygons(), hard_polygons(), |points| {
        let n = points.len();
        let part = |a: i32, p: Point, b: i32, next: Point| {
            [0, 1, 2]
                .map(|axis| (fraction(a, 1) * p[axis] + fraction(b, 1) * next[axis]) / whole(4))
        };
        let on_edge = |i: usize| {
            let [p, next] = [points[i], points[(i + 1) % n]];
            [part(3, p, 1, next), part(1, p, 3, next)]
        };
        let closed: Vec<Point> = (0..n).flat_map(on_edge).collect();
        let open = closed[..closed.len().saturating_sub(2)].to_vec();
        let [first, last] = [points.first(), points.last()].map(|end| end.into_iter().copied());
        let kept: Vec<Point> = first.chain(open.clone()).chain(last).collect();
        expect_equal(&closed, &chaikin_step(points, Ends::Closed))?;
        expect_equal(&open, &chaikin_step(points, Ends::Open))?;
        expect_equal(&kept, &chaikin_step(points, Ends::Kept))?;
        let counts = [closed, open, kept].map(|finer| finer.len());
        expect_equal(&[2 * n, (2 * n).saturating_sub(2), 2 * n], &counts)
    });
}

/// **The knots of the slides.** $n+1$ control points of degree 2 need $n+4$ knots $u_0,\dots,u_{n+3}$, since the last function $N_n^2$ ends at
/// $u_{n+3}$. With one knot less there are only $n$ functions, and $P_n$ has none.
///
/// Course: D07, slide 56, Chaikin and B-splines: the knots.
/// Erratum: the slide gives the knots $u_0,\dots,u_{n+2}$ to the points $P_0,\dots,P_n$. They must go up to $u_{n+3}$, with $u_{i+1}-u_i=1$ for $i=0,\dots,n+2$: three control points need six knots, not five.
#[test]
fn n_plus_one_points_of_degree_two_need_n_plus_four_knots() {
    Law::new(
        "subdivision::n_plus_one_points_of_degree_two_need_n_plus_four_knots",
        suspects::library,
    )
    .holds(3..=12_usize, Just(2), |&n| {
        let functions = |knots: usize| {
            let knots = KnotVector::new(2, (0..knots).map(whole).collect()).ok();
            knots.map(|knots| knots.control_point_count())
        };
        expect_equal(&Some(n + 1), &functions(n + 4))?;
        // Five knots of degree 2 have not even a domain.
        let one_less = functions(n + 3);
        expect_equal(&(n > 2).then_some(n), &one_less)
    });
}

/// **The recursion of the slides.** With $N_i^2(u)=\frac{u-u_i}{u_{i+2}-u_i}N_i^1(u)+\frac{u_{i+3}-u}{u_{i+3}-u_{i+1}}N_{i+1}^1(u)$ the quadratic functions sum to 1.
///
/// Course: D06, slide 56, Chaikin and B-splines: the basis functions.
/// Erratum: the slide's second numerator is $u_{i+3}-u_i$, a constant. It must be $u_{i+3}-u$, which falls to 0 at the end of the support. With the slide's, and with integer knots, the functions sum to 2 at every $u$, for example at $u=\frac{21}4$.
#[test]
fn quadratic_functions_sum_to_one_with_the_falling_numerator() {
    Law::new(
        "subdivision::quadratic_functions_sum_to_one_with_the_falling_numerator",
        suspects::library,
    )
    .holds(
        (2..=7_usize, parameter()),
        Just((5, fraction(1, 4))),
        |&(span, t)| {
            let u = whole(span) + t;
            let is_in = |i: usize| whole(i) <= u && u < whole(i) + Exact::one();
            let constant = |i: usize| {
                if is_in(i) {
                    Exact::one()
                } else {
                    Exact::zero()
                }
            };
            let linear =
                |i: usize| (u - whole(i)) * constant(i) + (whole(i + 2) - u) * constant(i + 1);
            // The functions 0 to 9 over the knots 0 to 12.
            let sum = |numerator: fn(Exact, usize) -> Exact| {
                let value = |i: usize| {
                    (u - whole(i)) / whole(2) * linear(i)
                        + numerator(u, i) / whole(2) * linear(i + 1)
                };
                (0..=9).fold(Exact::zero(), |sum, i| sum + value(i))
            };
            let falling = sum(|u, i| whole(i + 3) - u);
            let of_the_slide = sum(|_, i| whole(i + 3) - whole(i));
            expect_equal(&[Exact::one(), whole(2)], &[falling, of_the_slide])
        },
    );
}

/// **Pieces of three points.** On integer knots the quadratic B-spline with $n+1$ control points has $n-1$ pieces. With the local parameter $u\in[0,1]$ the piece number $k$ is, for all $k$ alike,
/// $$P_k(u)=\begin{bmatrix}1&u&u^2\end{bmatrix}M\begin{bmatrix}P_k\\P_{k+1}\\P_{k+2}\end{bmatrix},\qquad M=\frac12\begin{bmatrix}1&1&0\\-2&2&0\\1&-2&1\end{bmatrix}.$$
///
/// Course: D08, slide 57, Chaikin and B-splines: a piece of the curve for each three points.
/// Course: D10, slide 59, Chaikin and B-splines: the matrix M.
#[test]
fn quadratic_bspline_is_a_matrix_times_three_points() {
    Law::new(
        "subdivision::quadratic_bspline_is_a_matrix_times_three_points",
        suspects::library,
    )
    .holds(
        (long_polygons(), parameter()),
        (long_hard_polygons(), Just(Exact::zero())),
        |(points, u)| {
            let curve = uniform_bspline(2, points);
            let pieces = points.len() - 2;
            expect_equal(&[Exact::zero(), whole(pieces)], &curve.knots().domain())?;
            for (k, three) in points.windows(3).enumerate() {
                let rows = applied(&piece_matrix(), [three[0], three[1], three[2]]);
                let piece = Point::combination([Exact::one(), *u, *u * *u], rows);
                expect_equal(&curve.point(whole(k) + *u), &piece)?;
            }
            Ok(())
        },
    );
}

/// **Half a piece has the points that Chaikin cuts.** Let $C$ be the diagonal matrix of $1,\frac12,\frac14$. The first half of a piece is a piece with the control points $M^{-1}CM\,P$; and the second half one with the points $M^{-1}DM\,P$, where $D$ comes from $(1+u)/2$ in place of $u/2$:
/// $$M^{-1}CM=\frac14\begin{bmatrix}3&1&0\\1&3&0\\0&3&1\end{bmatrix},\qquad M^{-1}DM=\frac14\begin{bmatrix}1&3&0\\0&3&1\\0&1&3\end{bmatrix}.$$
/// The rows are the masks of Chaikin: three points become $Q_0,R_0,Q_1,R_1$, of which the first three are those of the first half, and the last three those of the second.
///
/// Course: D11, slides 60-62, Chaikin and B-splines: binary subdivision by M⁻¹CM.
/// Course: D09, slide 59, Chaikin and B-splines: three control points.
/// Exercise: chaikin.
/// Erratum: the slide calls $n=2$ the number of control points. There are three: $n$ is the index of the last.
#[test]
fn half_a_quadratic_piece_has_chaikins_points() {
    let m = piece_matrix();
    let inverse = matrix([[2, -1, 0], [2, 1, 0], [2, 3, 4]], 2);
    let identity = matrix([[1, 0, 0], [0, 1, 0], [0, 0, 1]], 1);
    let c = matrix([[4, 0, 0], [0, 2, 0], [0, 0, 1]], 4);
    let d = matrix([[4, 2, 1], [0, 2, 2], [0, 0, 1]], 4);
    let halves = [c, d].map(|change| product(&inverse, &product(&change, &m)));
    assert_eq!(product(&inverse, &m), identity);
    assert_eq!(halves[0], matrix([[3, 1, 0], [1, 3, 0], [0, 3, 1]], 4));
    assert_eq!(halves[1], matrix([[1, 3, 0], [0, 3, 1], [0, 1, 3]], 4));
    let still = point().prop_map(|p| [p; 3]);
    Law::new(
        "subdivision::half_a_quadratic_piece_has_chaikins_points",
        suspects::chaikin,
    )
    .holds([point(), point(), point()], still, |&points| {
        let finer = chaikin_step(&points, Ends::Open);
        let [q, r] = halves.map(|half| applied(&half, points).to_vec());
        expect_equal(&[q, r], &[finer[..3].to_vec(), finer[1..].to_vec()])
    });
}

/// **Chaikin's limit.** After $k$ rounds the polygon is the control polygon of *the same* uniform quadratic B-spline, that of the first polygon, on spans of length $2^{-k}$. The polygons tend to that curve, whose
/// derivative is continuous.
///
/// Course: D05, slide 55, Chaikin's algorithm: the limit is a uniform quadratic B-spline.
/// Exercise: chaikin.
/// Erratum: the slide dates Riesenfeld's proof 1978. It is of 1975 (*On Chaikin's algorithm*, Computer Graphics and Image Processing 4).
#[test]
fn chaikins_limit_is_the_uniform_quadratic_bspline() {
    Law::new(
        "subdivision::chaikins_limit_is_the_uniform_quadratic_bspline",
        suspects::chaikin,
    )
    .on_cases(32)
    .holds(long_polygons(), long_hard_polygons(), |points| {
        for ends in [Ends::Closed, Ends::Open, Ends::Kept] {
            let (control_points, _) = continued(points, 2, ends);
            let limit = uniform_bspline(2, &control_points);
            let mut finer = points.clone();
            for parts in [2, 4, 8] {
                finer = chaikin_step(&finer, ends);
                let (with_phantoms, _) = continued(&finer, 2, ends);
                expect_equal(&refined(&limit, parts), &with_phantoms)?;
            }
            expect_equal(&Ok(limit), &limit_curve(points, 2, ends))?;
        }
        Ok(())
    });
}

/// **The limit touches every edge in its middle.** The limit of Chaikin's scheme passes through the midpoint of every edge, at the knot $i$ through that of $P_iP_{i+1}$, and its derivative there is
/// $P_{i+1}-P_i$. So are the edges of every later polygon, since it is a control polygon of the same curve.
///
/// Course: D05, slide 55, Chaikin's algorithm: the limit is C¹.
#[test]
fn chaikins_limit_touches_every_edge_in_its_middle() {
    Law::new(
        "subdivision::chaikins_limit_touches_every_edge_in_its_middle",
        suspects::library,
    )
    .holds(long_polygons(), long_hard_polygons(), |points| {
        let limit = uniform_bspline(2, points);
        let edges = points.windows(2);
        let middles = edges
            .clone()
            .map(|edge| [0, 1, 2].map(|axis| (edge[0][axis] + edge[1][axis]) / whole(2)));
        let middles: Vec<Point> = middles.collect();
        let steps: Vec<Point> = edges.map(|edge| edge[1].minus(edge[0])).collect();
        let knots = 0..points.len() - 1;
        let touched = knots.clone().map(|i| limit.point(whole(i)));
        expect_equal(&middles, &touched.collect())?;
        let derivatives = knots.map(|i| limit.derivative_at(1, whole(i)));
        expect_equal(&steps, &derivatives.collect())?;
        expect_equal(&Ok(middles), &limit_points(points, 2, Ends::Open))?;
        expect_equal(&Ok(steps), &limit_tangents(points, 2, Ends::Open))
    });
}
