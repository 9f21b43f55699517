//! Boundaries, exact and in floating point, ordinary and hard, for the tests of this chapter.

use std::fmt;

use facette::algebra::VectorSpace;
use facette::coons::{Boundary, CrossDerivatives, HermiteBoundary};
use facette::curve::{BezierCurve, Curve};
use proptest::collection::vec;
use proptest::prelude::*;

use crate::common::exact::{Exact, fraction};
use crate::common::generators::{hard_parameter, parameter, point};

/// A point of space over the rationals.
pub type Point = [Exact; 3];

/// A boundary with the parameters at which a law looks at its patch.
#[derive(Clone)]
pub struct Place {
    /// Control points of the four edges P1, P2, Q1, Q2.
    pub edges: [Vec<Point>; 4],
    /// The first parameter.
    pub u: Exact,
    /// The second parameter.
    pub v: Exact,
}

impl fmt::Debug for Place {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (name, points) in ["P1", "P2", "Q1", "Q2"].into_iter().zip(&self.edges) {
            write!(formatter, "{name} = Bézier{points:?}, ")?;
        }
        write!(formatter, "u = {:?}, v = {:?}", self.u, self.v)
    }
}

/// The Bézier curve with these control points.
pub fn bezier<P: VectorSpace>(points: &[P]) -> BezierCurve<P> {
    BezierCurve::new(points.to_vec()).expect("the generators make finite points")
}

impl Place {
    /// The boundary of the four edges.
    pub fn boundary(&self) -> Boundary<BezierCurve<Point>> {
        let [p1, p2, q1, q2] = self.edges.each_ref().map(|points| bezier(points));
        Boundary::new(p1, p2, q1, q2).expect("the generators make edges that meet")
    }

    /// The points of the four edges at the parameters: `[P1(u), P2(u), Q1(v), Q2(v)]`.
    pub fn edge_points(&self) -> [Point; 4] {
        let [p1, p2, q1, q2] = self.edges.each_ref().map(|points| bezier(points));
        [
            p1.point(self.u),
            p2.point(self.u),
            q1.point(self.v),
            q2.point(self.v),
        ]
    }

    /// The corners A, B, C, D.
    pub fn corners(&self) -> [Point; 4] {
        let [p1, p2, ..] = &self.edges;
        [p1[0], p1[p1.len() - 1], p2[p2.len() - 1], p2[0]]
    }

    /// The same edges seen from other parameters.
    pub fn at(&self, u: Exact, v: Exact) -> Self {
        Self {
            edges: self.edges.clone(),
            u,
            v,
        }
    }

    /// The same place with every control point mapped.
    pub fn mapped(&self, map: impl Fn(Point) -> Point) -> Self {
        let edges = self
            .edges
            .each_ref()
            .map(|points| points.iter().map(|&p| map(p)).collect());
        Self {
            edges,
            u: self.u,
            v: self.v,
        }
    }
}

/// Edges through four corners, each with the given inner control points.
pub fn edges([a, b, c, d]: [Point; 4], inner: [Vec<Point>; 4]) -> [Vec<Point>; 4] {
    let ends = [(a, b), (d, c), (a, d), (b, c)];
    let mut inner = inner.into_iter();
    ends.map(|(start, end)| {
        let inner = inner.next().unwrap_or_default();
        [vec![start], inner, vec![end]].concat()
    })
}

/// Boundaries of curves of degree 1 to 4 with parameters in [0, 1].
pub fn places() -> impl Strategy<Value = Place> {
    let corners = [point(), point(), point(), point()];
    let inner = || vec(point(), 0..=3);
    let inner = [inner(), inner(), inner(), inner()];
    (corners, inner, parameter(), parameter()).prop_map(|(corners, inner, u, v)| Place {
        edges: edges(corners, inner),
        u,
        v,
    })
}

/// Boundaries with a side collapsed to a point, with coincident sides, with all sides straight, or with all corners in one
/// point; and parameters at the ends, next to them and outside.
pub fn hard_places() -> impl Strategy<Value = Place> {
    let degenerate = (places(), 0..4).prop_map(|(place, kind)| {
        let [a, b, c, d] = place.corners();
        let [p1, p2, q1, q2] = place
            .edges
            .each_ref()
            .map(|edge| edge[1..edge.len() - 1].to_vec());
        let edges = match kind {
            0 => edges([a, a, c, d], [vec![a; 2], p2, q1, q2]),
            1 => edges([a, b, b, a], [p1.clone(), p1, q1, q2]),
            2 => edges([a, b, c, d], Default::default()),
            _ => edges([a; 4], [p1, p2, q1, q2]),
        };
        Place { edges, ..place }
    });
    (
        prop_oneof![1 => degenerate, 1 => places()],
        hard_parameter(),
        hard_parameter(),
    )
        .prop_map(|(place, u, v)| place.at(u, v))
}

/// The control points of a tensor-product Bézier surface, `net[i][j]` with i along u.
pub type Net = Vec<Vec<Point>>;

/// Nets of a degree from `lowest` to `highest` in both directions.
pub fn nets(lowest: usize, highest: usize) -> impl Strategy<Value = Net> {
    (lowest..=highest).prop_flat_map(|degree| vec(vec(point(), degree + 1), degree + 1))
}

/// A surface's own boundary data: its edges and the derivatives across them.
pub struct SurfaceData {
    /// The four edges P1, P2, Q1, Q2.
    pub edges: [BezierCurve<Point>; 4],
    /// The four cross derivatives.
    pub cross: CrossDerivatives<BezierCurve<Point>>,
}

/// Edges and cross derivatives of the Bézier surface with this net, by differences of its control points.
pub fn surface_data(net: &Net) -> SurfaceData {
    let last = net.len() - 1;
    let degree = fraction(i32::try_from(last).expect("a small degree"), 1);
    let row = |i: usize| net[i].clone();
    let column = |j: usize| net.iter().map(|row| row[j]).collect::<Vec<_>>();
    let slope = |low: Vec<Point>, high: Vec<Point>| {
        let sides = low
            .into_iter()
            .zip(high)
            .map(|(low, high)| high.minus(low).times(degree));
        bezier(&sides.collect::<Vec<_>>())
    };
    SurfaceData {
        edges: [column(0), column(last), row(0), row(last)].map(|points| bezier(&points)),
        cross: CrossDerivatives {
            p1_v: slope(column(0), column(1)),
            p2_v: slope(column(last - 1), column(last)),
            q1_u: slope(row(0), row(1)),
            q2_u: slope(row(last - 1), row(last)),
        },
    }
}

/// The point of the Bézier surface with this net: the curve in v through the points of the curves in u.
pub fn surface_point(net: &Net, u: Exact, v: Exact) -> Point {
    let degree = net.len() - 1;
    let column = |j: usize| bezier(&net.iter().map(|row| row[j]).collect::<Vec<_>>()).point(u);
    bezier(&(0..=degree).map(column).collect::<Vec<_>>()).point(v)
}

/// The data of the bicubically blended patch with a surface's own boundary, slopes and twists.
pub fn hermite_boundary(net: &Net) -> HermiteBoundary<BezierCurve<Point>> {
    let SurfaceData {
        edges: [p1, p2, q1, q2],
        cross,
    } = surface_data(net);
    let boundary = Boundary::new(p1, p2, q1, q2).expect("a surface's edges meet");
    let twists = twists_of(net);
    HermiteBoundary::new(boundary, cross, twists).expect("a surface's data are compatible")
}

/// The twists of the Bézier surface with this net: `n² (b₁₁ − b₁₀ − b₀₁ + b₀₀)` at A, and so at the other corners.
pub fn twists_of(net: &Net) -> facette::coons::Twists<Point> {
    let last = net.len() - 1;
    let degree = fraction(i32::try_from(last).expect("a small degree"), 1);
    let twist = |i: usize, j: usize| {
        let along_v = net[i + 1][j + 1].minus(net[i + 1][j]);
        let before = net[i][j + 1].minus(net[i][j]);
        along_v.minus(before).times(degree * degree)
    };
    facette::coons::Corners {
        a: twist(0, 0),
        b: twist(last - 1, 0),
        c: twist(last - 1, last - 1),
        d: twist(0, last - 1),
    }
}

/// Data in floating point whose two families disagree about every twist.
#[allow(dead_code, reason = "the exercise runs without the hard cases")]
pub fn incompatible_example() -> HermiteBoundary<BezierCurve<[f64; 3]>> {
    let at = |x: f64, y: f64| [x, y, 0.0];
    let line = |start, end| bezier::<[f64; 3]>(&[start, end]);
    let [a, b, c, d] = [at(0., 0.), at(1., 0.), at(1., 1.), at(0., 1.)];
    let boundary = Boundary::new(line(a, b), line(d, c), line(a, d), line(b, c));
    let [in_u, in_v] = [at(1., 0.), at(0., 1.)];
    let bulge = |end: [f64; 3], height: f64| bezier(&[end, end.plus([0., 0., height]), end]);
    let cross = CrossDerivatives {
        p1_v: bulge(in_v, 1.5),
        p2_v: bulge(in_v, -0.5),
        q1_u: bulge(in_u, -1.0),
        q2_u: bulge(in_u, 0.75),
    };
    HermiteBoundary::gregory(boundary.expect("a square"), cross).expect("the slopes fit")
}
