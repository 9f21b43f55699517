//! The variants for curves: points of the limit of a closed polygon, by rounds alone, by rounds and the limit mask, and by the B-spline's formula.

use facette::algebra::Scalar;
use facette::bspline::{BsplineCurve, de_boor_point};
use facette::curve::Curve;
use facette::subdivision::curve::{Ends, limit_curve, limit_points, subdivided};

use crate::Visitor;
use crate::common::oracle::{Big, big, big_point};
use crate::float_inputs::{FloatPoint, coordinates};
use crate::harness::{Comparison, Effort, Exact, ExactPoint, lazily};

/// A scheme, and what its rows are called.
struct Scheme {
    degree: usize,
    quantity: &'static str,
}

const SCHEMES: [Scheme; 2] = [
    Scheme {
        degree: 2,
        quantity: "curve: Chaikin",
    },
    Scheme {
        degree: 3,
        quantity: "curve: cubic",
    },
];

/// A closed polygon of eight points.
const POLYGON: [[f64; 3]; 8] = [
    [3.0, 0.2, 0.1],
    [2.3, 1.9, -0.4],
    [0.3, 2.6, 0.7],
    [-1.7, 1.4, 1.3],
    [-3.1, 0.3, -0.6],
    [-1.9, -2.2, -1.1],
    [0.1, -1.3, 0.9],
    [2.7, -1.8, 0.3],
];

/// What is asked for: the degree, the number of rounds, and the polygon, moved by so much.
struct Task<P> {
    degree: usize,
    rounds: u32,
    polygon: Vec<P>,
}

impl<P: FloatPoint> Task<P> {
    fn new(degree: usize, rounds: u32, offset: f64) -> Self {
        let moved = POLYGON.map(|point| P::rounded(point.map(|coordinate| coordinate + offset)));
        Self {
            degree,
            rounds,
            polygon: moved.to_vec(),
        }
    }

    fn finer(&self) -> Vec<P> {
        subdivided(&self.polygon, self.degree, Ends::Closed, self.rounds)
            .expect("a few rounds of a known degree")
    }

    /// The polygon after all rounds.
    fn polygon_itself(&self) -> impl FnMut(&mut [P]) {
        |points| points.copy_from_slice(&self.finer())
    }

    /// The limit points of that polygon.
    fn by_mask(&self) -> impl FnMut(&mut [P]) {
        |points| {
            let limits = limit_points(&self.finer(), self.degree, Ends::Closed);
            points.copy_from_slice(&limits.expect("a known degree"));
        }
    }

    /// The B-spline at the knots of that polygon.
    fn by_formula(&self, point: impl Fn(&BsplineCurve<P>, P::Scalar) -> P) -> impl FnMut(&mut [P]) {
        let curve = limit_curve(&self.polygon, self.degree, Ends::Closed);
        let curve = curve.expect("eight points have a limit");
        move |points| {
            let parts = P::Scalar::from_i32(1 << self.rounds);
            for (index, place) in (0..).zip(points) {
                *place = point(&curve, P::Scalar::from_i32(index) / parts);
            }
        }
    }

    /// The points of the limit at the parameters of the vertices of the polygon after all rounds (even degree: between its knots), or at its knots.
    fn exact(&self, of_vertices: bool) -> Vec<ExactPoint> {
        let exact = |&point: &P| big_point(coordinates(point));
        let mut polygon: Vec<ExactPoint> = self.polygon.iter().map(exact).collect();
        for _ in 0..self.rounds {
            polygon = exact_round(&polygon, self.degree);
        }
        // A vertex of degree 2 stands in the middle of a span, where (1, 6, 1)/8 gives the limit.
        match (self.degree, of_vertices) {
            (2, false) => means(&polygon, &[0.0, 0.5, 0.5].map(big)),
            (2, true) => means(&polygon, &[0.125, 0.75, 0.125].map(big)),
            _ => means(
                &polygon,
                &[1.0, 4.0, 1.0].map(|weight| big(weight) / big(6.0)),
            ),
        }
    }
}

/// For each point the mean of it and its neighbours with these weights, round the polygon.
fn means(polygon: &[ExactPoint], weights: &[Big; 3]) -> Vec<ExactPoint> {
    let count = polygon.len();
    let mean = |index: usize| {
        let around = [index + count - 1, index, index + 1].map(|index| &polygon[index % count]);
        std::array::from_fn(|axis| {
            let terms = around
                .iter()
                .zip(weights)
                .map(|(point, weight)| &point[axis] * weight);
            terms.fold(big(0.0), |sum, term| sum + term)
        })
    };
    (0..count).map(mean).collect()
}

/// A round of the scheme without rounding: for each point or edge two new ones.
fn exact_round(polygon: &[ExactPoint], degree: usize) -> Vec<ExactPoint> {
    let masks = match degree {
        2 => [[0.0, 0.75, 0.25], [0.0, 0.25, 0.75]],
        _ => [[0.125, 0.75, 0.125], [0.0, 0.5, 0.5]],
    };
    let [first, second] = masks.map(|mask| means(polygon, &mask.map(big)));
    first
        .into_iter()
        .zip(second)
        .flat_map(|(a, b)| [a, b])
        .collect()
}

/// Adds the ways to make the points in one precision.
fn variants<'a, P: FloatPoint>(
    comparison: Comparison<'a>,
    scalar: &'static str,
    task: &'a Task<P>,
) -> Comparison<'a> {
    let [vertices, knots]: [Exact<'a>; 2] =
        [true, false].map(|of_vertices| lazily(move || task.exact(of_vertices)));
    let de_boor =
        |curve: &BsplineCurve<P>, u| de_boor_point(curve.knots(), curve.control_points(), u);
    comparison
        .variant(
            ["B-spline by its basis", scalar],
            &knots,
            task.by_formula(BsplineCurve::point),
        )
        .variant(
            ["B-spline by de Boor", scalar],
            &knots,
            task.by_formula(de_boor),
        )
        .variant(["rounds alone", scalar], &vertices, task.polygon_itself())
        .variant(
            ["rounds and the limit mask", scalar],
            &knots,
            task.by_mask(),
        )
}

/// Hands the comparisons of curves to the visitor: 8 · 2ᵏ points each, k = 3 and k = 8, near the origin and far from it.
pub fn visit(_effort: Effort, visitor: &mut Visitor<'_>) {
    for Scheme { degree, quantity } in SCHEMES {
        for (inputs, rounds, offset) in [("typical", 3, 0.0), ("typical", 8, 0.0), ("hard", 8, 1e6)]
        {
            let wide = Task::<[f64; 3]>::new(degree, rounds, offset);
            let narrow = Task::<[f32; 3]>::new(degree, rounds, offset);
            let count = POLYGON.len() << rounds;
            let comparison = Comparison::new(quantity, inputs, count);
            let comparison = variants(comparison, "f64", &wide);
            visitor(variants(comparison, "f32", &narrow));
        }
    }
}
