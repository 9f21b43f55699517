//! What a surface inherits from its shape functions: derivatives, continuity at the knots, and what it does not inherit.

use facette::algebra::{Vector3, VectorSpace};
use facette::bspline::{BsplineSurface, Direction, KnotVector, basis_derivatives, cox_de_boor};
use facette::surface::Surface;
use num_traits::{One, Zero};

use crate::common::exact::{Exact, fraction};
use crate::common::law::{Law, Verdict, expect_equal};
use crate::inputs::{Knots, Point, SurfaceCase, expect, hard_surfaces, surfaces, whole};
use crate::suspects;

fn on_surfaces(theorem: &'static str, check: impl Fn(&SurfaceCase) -> Verdict) {
    Law::new(theorem, suspects::library).holds(surfaces(), hard_surfaces(), check);
}

/// The derivatives of order `order` at `u` of the polynomials on `span`, for the functions `span − p` to `span`.
fn row(knots: &Knots, span: usize, u: Exact, order: usize) -> Vec<Exact> {
    let width = knots.degree + 1;
    let mut values = vec![Exact::zero(); (order + 1) * width];
    basis_derivatives(&knots.vector(), span, u, &mut values);
    values.split_off(order * width)
}

/// The derivative of orders `[k, l]` of the polynomial on the rectangle `spans`, by the double sum.
fn derivative_on(
    case: &SurfaceCase,
    spans: [usize; 2],
    [k, l]: [usize; 2],
    [u, v]: [Exact; 2],
) -> Point {
    let [in_u, in_v] = [
        row(&case.knots[0], spans[0], u, k),
        row(&case.knots[1], spans[1], v, l),
    ];
    let [i0, j0] = [
        spans[0] - case.knots[0].degree,
        spans[1] - case.knots[1].degree,
    ];
    let mut sum = Point::origin();
    for (j, &b) in in_v.iter().enumerate() {
        for (i, &a) in in_u.iter().enumerate() {
            sum = sum.plus(case.control_point(i0 + i, j0 + j).times(a * b));
        }
    }
    sum
}

/// **The $(n+1)(m+1)$ shape functions.** The products $N_i^p(u)\,N_j^q(v)$ have in both directions what their factors have in one: they are not negative, sum to 1 on the closed domain, and are positive
/// for at most $(p+1)(q+1)$ pairs, exactly so many strictly inside a rectangle of knots.
///
/// Course: B04, slide 16, shape functions: partition of unity.
/// Course: B06, slide 16, at most (p+1)(q+1) are not zero.
/// Exercise: basis.
#[test]
fn products_of_basis_functions_inherit_their_properties() {
    let name = "bspline::products_of_basis_functions_inherit_their_properties";
    Law::new(name, suspects::basis).holds(surfaces(), hard_surfaces(), |case| {
        let values = [0, 1].map(|d| {
            let (knots, vector) = (&case.knots[d], case.knots[d].vector());
            let value = |function| cox_de_boor(&vector, knots.degree, function, case.at[d]);
            (0..knots.count()).map(value).collect::<Vec<_>>()
        });
        let products: Vec<_> = values[1]
            .iter()
            .flat_map(|&b| values[0].iter().map(move |&a| a * b))
            .collect();
        let sum = products
            .iter()
            .fold(Exact::zero(), |sum, &product| sum + product);
        expect_equal(&Exact::one(), &sum)?;
        let negative = products.iter().any(|&product| product < Exact::zero());
        expect("no negative product", !negative, &products)?;
        let positive = products
            .iter()
            .filter(|&&product| product > Exact::zero())
            .count();
        let [p, q] = case.knots.each_ref().map(|knots| knots.degree);
        expect(
            "at most (p + 1)(q + 1) positive products",
            positive <= (p + 1) * (q + 1),
            positive,
        )?;
        let is_inside = (0..2).all(|d| !case.knots[d].knots.contains(&case.at[d]));
        expect_equal(&is_inside, &(is_inside && positive == (p + 1) * (q + 1)))
    });
}

/// **Derivatives of every order.** $\frac{\partial^{k+l}S}{\partial u^k\partial v^l}$ is the double sum with the derivatives of the functions. The surface that `derivative_surface` gives has $S_u$ (or $S_v$) for its points, and its
/// derivatives are the next ones of $S$.
///
/// Course: B08, slide 17, shape functions: continuity.
#[test]
fn derivatives_of_a_surface_are_surfaces() {
    on_surfaces("bspline::derivatives_of_a_surface_are_surfaces", |case| {
        let surface = case.surface();
        let [u, v] = case.at;
        let spans = [case.knots[0].span_of(u), case.knots[1].span_of(v)];
        for orders in [
            [0, 0],
            [1, 0],
            [0, 1],
            [1, 1],
            [2, 0],
            [1, 2],
            [3, 1],
            [4, 0],
            [0, 4],
        ] {
            let expected = derivative_on(case, spans, orders, case.at);
            expect_equal(
                &(orders, expected),
                &(orders, surface.derivative_at(orders, u, v)),
            )?;
        }
        let in_u = surface.derivative_surface(Direction::U);
        let in_v = surface.derivative_surface(Direction::V);
        let expected = [[1, 0], [0, 1]].map(|orders| derivative_on(case, spans, orders, case.at));
        expect_equal(&expected, &[in_u.point(u, v), in_v.point(u, v)])?;
        let twist = derivative_on(case, spans, [1, 1], case.at);
        let both = in_u.derivative_surface(Direction::V);
        expect_equal(
            &[twist; 2],
            &[both.point(u, v), in_v.derivative_at([1, 0], u, v)],
        )
    });
}

/// **The normal.** Wherever $S_u\times S_v$ is not zero, the normal points along it. Where it is zero, a normal that is given all the same is the limit from inside.
///
/// Course: B08, slide 17, shape functions: continuity.
#[test]
fn surface_normal_points_along_the_product_of_the_partials() {
    on_surfaces(
        "bspline::surface_normal_points_along_the_product_of_the_partials",
        |case| {
            let surface = case.surface();
            let [u, v] = case.at;
            let Some([s_u, s_v]) = surface.partials(u, v) else {
                return expect("partial derivatives everywhere", false, case.at);
            };
            let product = s_u.cross(s_v);
            if product == Point::origin() {
                return Ok(());
            }
            let normal = surface.normal_vector(u, v);
            let along =
                normal.map(|normal| (normal.cross(product), normal.dot(product) > Exact::zero()));
            expect_equal(&Some((Point::origin(), true)), &along)
        },
    );
}

/// By how much the derivative of these orders jumps, at the v of the case, from one span in u to the next.
fn jump_across(case: &SurfaceCase, spans: [usize; 2], span_v: usize, orders: [usize; 2]) -> Point {
    let place = [case.knots[0].knots[spans[1]], case.at[1]];
    let [left, right] = spans.map(|span| derivative_on(case, [span, span_v], orders, place));
    right.minus(left)
}

/// **Continuity in $u$ comes from $U$ alone.** Across a knot of $U$ of multiplicity $k$, all derivatives $\frac{\partial^{a+b}S}{\partial u^a\partial v^b}$ with $a\le p-k$ agree from both sides, at every $v$ and for every $b$, whatever $V$ and the
/// control points are. With $a=p-k+1$ there are control points for which they do not: a single one is enough. Along the knot line the surface is as smooth as $V$ makes it.
///
/// Course: B09, slide 17, shape functions: continuity in u depends on U only.
/// Course: B08, slide 17, continuity.
#[test]
fn continuity_in_u_depends_on_the_knots_in_u_only() {
    on_surfaces(
        "bspline::continuity_in_u_depends_on_the_knots_in_u_only",
        |case| {
            let (in_u, p) = (&case.knots[0], case.knots[0].degree);
            let span_v = case.knots[1].span_of(case.at[1]);
            for pair in in_u.spans().windows(2) {
                let u = in_u.knots[pair[1]];
                let multiplicity = in_u.knots.iter().filter(|&&knot| knot == u).count();
                let jump = |case: &SurfaceCase, orders| {
                    jump_across(case, [pair[0], pair[1]], span_v, orders)
                };
                for a in 0..=p - multiplicity.min(p) {
                    let orders = (0..=case.knots[1].degree).map(|b| [a, b]);
                    let jumps: Vec<_> = orders.map(|orders| jump(case, orders)).collect();
                    if multiplicity <= p {
                        expect_equal(&vec![Point::origin(); jumps.len()], &jumps)?;
                    }
                }
                let next = [p + 1 - multiplicity, 0];
                let one = [Exact::one(); 3];
                let count = case.knots[0].count();
                let is_torn = (0..case.points.len()).any(|index| {
                    let mut points = vec![Point::origin(); case.points.len()];
                    points[index] = one;
                    let is_near = (pair[0] - p..=pair[1]).contains(&(index % count));
                    is_near
                        && jump(
                            &SurfaceCase {
                                points,
                                ..case.clone()
                            },
                            next,
                        ) != Point::origin()
                });
                expect(
                    "a control point that makes the next derivative jump",
                    is_torn,
                    (u, multiplicity),
                )?;
            }
            Ok(())
        },
    );
}

/// **What repeating a knot breaks.** With $p=3$, a knot that stands $k=1,2,3,4$ times breaks the derivative of order $3,2,1,0$ along its line, and none below. So a triple knot gives a crease, and only a knot that stands
/// $p+1=4$ times tears the surface.
///
/// Course: B13, slide 22, repeated knots.
/// Erratum: the slide says that repeated knots make *discontinuities* along lines $u$ = const or $v$ = const. They are discontinuities of the derivative of order $p-k+1$; the surface itself is torn only where $k\ge p+1$.
#[test]
fn repeated_knots_break_one_derivative_after_the_other() {
    for k in 1..=4_usize {
        let inner = vec![1; k];
        let in_u = Knots::integers(3, &[&[0; 4][..], &inner, &[2; 4]].concat());
        let in_v = Knots::integers(1, &[0, 0, 1, 1]);
        let count = in_u.count();
        let height = |index: usize| {
            let i = index % count;
            [
                whole(i),
                whole(index / count),
                whole((7 * i * i * i + 3 * i + index) % 11),
            ]
        };
        let points = (0..2 * count).map(height).collect();
        let case = SurfaceCase {
            knots: [in_u, in_v],
            points,
            at: [Exact::one(), fraction(1, 3)],
        };
        let spans = case.knots[0].spans();
        let jumps = |order: usize| {
            let [left, right] = [spans[0], spans[1]]
                .map(|span| derivative_on(&case, [span, 1], [order, 0], case.at));
            left != right
        };
        assert_eq!(
            (0..=3).find(|&order| jumps(order)),
            Some(4 - k),
            "a knot that stands {k} times"
        );
    }
}

/// The degree-1 surface over the same net: what the eye takes for the control net, with a bilinear patch in each mesh.
fn control_net(points: &[Point], columns: usize) -> BsplineSurface<Point> {
    let side = |count: usize| {
        let breaks: Vec<_> = (0..count).map(whole).collect();
        KnotVector::clamped(1, &breaks).expect("at least two control points")
    };
    let knots = [side(columns), side(points.len() / columns)];
    BsplineSurface::new(knots, points.to_vec()).expect("one knot for each control point")
}

/// **No variation diminishing: a line.** A line may meet a surface more often than its control net. Take $p=2$, $q=1$ without inner knots, and the six control points $(-1,0),(0,2),(1,0)$ and $(-1,3),(0,3),(1,3)$ at any heights $z$.
/// In the middle, at $x=0$, the net spans $2\le y\le3$ only, since the edge between $(0,2)$ and $(0,3)$ is all it has there. The surface begins lower, at $y=1$, where the parabola of the first three points has its
/// top: $S(\tfrac12,v)=(0,1+2v,\cdot)$. So the line $x=0$, $y=\tfrac32$ goes through the surface once, and misses the net.
///
/// For curves this cannot happen: what separates a plane's two sides on the curve separates them on the polygon.
///
/// Course: B16, slide 24, properties of the surface: no variation diminishing.
#[test]
fn line_may_meet_the_surface_and_miss_its_net() {
    let net = [
        [-1, 0, 1],
        [0, 2, 0],
        [1, 0, 2],
        [-1, 3, 0],
        [0, 3, 3],
        [1, 3, 1],
    ];
    let points: Vec<Point> = net
        .iter()
        .map(|point| point.map(|x| fraction(x, 1)))
        .collect();
    let knots = [KnotVector::bezier(2), KnotVector::bezier(1)];
    let surface = BsplineSurface::new(knots, points.clone()).expect("three by two points");
    let [x, y, _] = surface.point(fraction(1, 2), fraction(1, 4));
    assert_eq!([x, y], [fraction(0, 1), fraction(3, 2)]);
    // On the net, x = u − 1 runs from −1 to 1 in each row: the line x = 0 meets it on the edge u = 1 alone.
    let net = control_net(&points, 3);
    for quarter in 0..=8 {
        for eighth in 0..=8 {
            let [u, v] = [fraction(quarter, 4), fraction(eighth, 8)];
            let [x, y, _] = net.point(u, v);
            assert_eq!(x, u - Exact::one());
            assert!(
                !x.is_zero() || y >= fraction(2, 1),
                "the net comes down to {y:?} at x = 0"
            );
        }
    }
}

/// The biquadratic patch with the heights 4, 1, 4 on the diagonal of its net and `low` elsewhere.
fn two_peaks(low: Exact) -> (BsplineSurface<Point>, Vec<Point>) {
    let peak = fraction(4, 1);
    let heights = [peak, low, low, low, Exact::one(), low, low, low, peak];
    let places = heights.into_iter().enumerate();
    let points: Vec<Point> = places
        .map(|(index, height)| [whole(index % 3), whole(index / 3), height])
        .collect();
    let knots = [KnotVector::bezier(2), KnotVector::bezier(2)];
    let surface = BsplineSurface::new(knots, points.clone());
    (surface.expect("three by three points"), points)
}

/// **No variation diminishing: a plane.** A plane may cut a surface into more pieces than its control net. Give the $3\times3$ control points of a biquadratic Bézier patch the heights
///
/// $$\begin{pmatrix}4&-\tfrac{19}{10}&-\tfrac{19}{10}\\-\tfrac{19}{10}&1&-\tfrac{19}{10}\\-\tfrac{19}{10}&-\tfrac{19}{10}&4\end{pmatrix}.$$
///
/// Above the plane $z=0$ the net is in one piece: along its diagonal the height is $4(1-t)^2-\tfrac{38}{10}t(1-t)+t^2>0$, there and back. But on the line $u+v=1$ the height of the surface is $-\tfrac{19}{10}+\tfrac{117}5u^2(1-u)^2\le-\tfrac7{16}$: below the plane all the way. The corners
/// $(0,0)$ and $(1,1)$, both above, lie on different sides of that line: two pieces.
///
/// Course: B16, slide 24, properties of the surface: no variation diminishing.
#[test]
fn plane_may_cut_a_surface_into_more_pieces_than_its_net() {
    let low = fraction(-19, 10);
    let (surface, points) = two_peaks(low);
    let net = control_net(&points, 3);
    for tenth in 0..=20 {
        let t = fraction(tenth, 10);
        let [.., height] = net.point(t, t);
        assert!(
            height > Exact::zero(),
            "the net's diagonal at {t:?} is at {height:?}"
        );
    }
    // A quadratic a (1 − t)² + 2b t (1 − t) + c t² with a, c > 0 has no zero where b² < ac: so nowhere between the samples.
    assert!(low * low < fraction(4, 1));
    for corner in [Exact::zero(), Exact::one()] {
        assert!(surface.point(corner, corner)[2] > Exact::zero());
    }
    // Two polynomials of degree 4 that agree at 5 places are the same; and t (1 - t) is at most 1/4.
    for quarter in 0..=4 {
        let t = fraction(quarter, 4);
        let s = t * (Exact::one() - t);
        let across = surface.point(t, Exact::one() - t)[2];
        assert_eq!(across, low + fraction(117, 5) * s * s);
    }
    assert!(low + fraction(117, 5) * fraction(1, 16) < Exact::zero());
}
