//! Surfaces to cut, and what the tests measure on their triangles.

use std::collections::HashMap;
use std::fmt;

use facette::algebra::{VectorSpace, length};
use facette::bspline::{BsplineSurface, Closing, KnotVector, PeriodicSurface, closed_surface};
use facette::mesh::Mesh;
use facette::surface::Surface;
use facette::tessellation::{BoundedSurface, Tessellation, tessellate};
use proptest::collection::vec;
use proptest::prelude::*;

use crate::common::law::{Broken, Law, LikelyMistake, Verdict};

/// A point of space.
pub type Point = [f64; 3];

/// The law behind the test `tessellation::name`: no exercise replaces this code.
pub fn law(theorem: &'static str) -> Law {
    Law::new(theorem, || LikelyMistake {
        name: "",
        hint: "this is the library's own code: no exercise replaces it",
    })
}

/// Passes where `holds`; otherwise says what was promised of what.
pub fn expect(promise: &str, holds: bool, got: impl fmt::Debug) -> Verdict {
    if holds {
        return Ok(());
    }
    Err(Broken {
        expected: promise.to_owned(),
        got: format!("{got:?}"),
    })
}

/// A B-spline surface over a net of about unit spacing, and a tolerance.
#[derive(Clone)]
pub struct Sheet {
    /// The degrees in u and v.
    pub degrees: [usize; 2],
    /// The breaks in u and v; a number that is repeated is a repeated knot.
    pub breaks: [Vec<f64>; 2],
    /// How far the points are moved from a plane net; as many as the largest sheet has points.
    pub moves: Vec<Point>,
    /// The tolerance.
    pub tolerance: f64,
}

impl fmt::Debug for Sheet {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self {
            degrees,
            breaks,
            moves,
            tolerance,
        } = self;
        write!(
            formatter,
            "degrees {degrees:?}, breaks {breaks:?}, tolerance {tolerance}, moves {:?} ...",
            &moves[..4]
        )
    }
}

impl Sheet {
    /// The surface.
    pub fn surface(&self) -> BsplineSurface<Point> {
        let knots = [0, 1].map(|axis| {
            let knots = KnotVector::clamped(self.degrees[axis], &self.breaks[axis]);
            knots.expect("the generators make valid knots")
        });
        let [columns, rows] = knots.each_ref().map(KnotVector::control_point_count);
        let points = (0..rows).flat_map(|j| (0..columns).map(move |i| (i, j)));
        let points = points
            .zip(&self.moves)
            .map(|((i, j), &[x, y, z])| [i as f64 + x, j as f64 + y, z]);
        BsplineSurface::new(knots, points.collect()).expect("a net of finite points")
    }
}

/// The most control points a sheet may have: 3 + 3 knots inside, doubled, and degree 4.
const MOST_POINTS: usize = 11 * 11;

fn moves(size: f64) -> impl Strategy<Value = Vec<Point>> {
    let move_ = (-size..size, -size..size, -2.0 * size..2.0 * size).prop_map(|(x, y, z)| [x, y, z]);
    vec(move_, MOST_POINTS)
}

fn inner_breaks() -> impl Strategy<Value = Vec<f64>> {
    vec(1..9_u8, 0..=3).prop_map(|mut eighths| {
        eighths.sort_unstable();
        eighths.dedup();
        let inner = eighths.into_iter().map(|eighth| f64::from(eighth) / 9.0);
        [0.0].into_iter().chain(inner).chain([1.0]).collect()
    })
}

/// Sheets of degrees 1 to 4 with up to three simple knots inside.
pub fn sheets() -> impl Strategy<Value = Sheet> {
    let degrees = [1..=4_usize, 1..=4_usize];
    (
        degrees,
        [inner_breaks(), inner_breaks()],
        moves(0.4),
        0.01..0.2_f64,
    )
        .prop_map(|(degrees, breaks, moves, tolerance)| Sheet {
            degrees,
            breaks,
            moves,
            tolerance,
        })
}

/// Sheets with repeated knots, long thin domains, flat parts and single polynomials that only twist.
pub fn hard_sheets() -> impl Strategy<Value = Sheet> {
    let repeated = |degree: usize| {
        let mut breaks = vec![0.0];
        breaks.extend(vec![0.25; degree]);
        breaks.extend([0.5, 1.0]);
        breaks
    };
    let kinds = (
        0..4_usize,
        [1..=3_usize, 1..=3_usize],
        moves(0.4),
        0.02..0.2_f64,
    );
    kinds.prop_map(move |(kind, degrees, moves, tolerance)| {
        let (degrees, breaks) = match kind {
            0 => (degrees, degrees.map(repeated)),
            1 => (degrees, [vec![0.0, 1e-6, 1e6], vec![0.0, 1.0]]),
            2 => ([1, 1], [vec![0.0, 1.0], vec![0.0, 1.0]]),
            _ => (degrees, [vec![-1.0, 1.0], vec![-1.0, 0.5, 1.0]]),
        };
        let moves = if kind == 3 { flattened(&moves) } else { moves };
        Sheet {
            degrees,
            breaks,
            moves,
            tolerance,
        }
    })
}

/// The same moves, but none out of the plane for the first half.
fn flattened(moves: &[Point]) -> Vec<Point> {
    let half = moves.len() / 8;
    let moved = moves.iter().enumerate();
    moved
        .map(|(index, &[x, y, z])| if index < half { [0.0; 3] } else { [x, y, z] })
        .collect()
}

/// The tessellation of a surface within a tolerance, which the test expects to exist.
pub fn cut<T>(surface: &T, tolerance: f64) -> Tessellation<Point>
where
    T: BoundedSurface<Scalar = f64, Point = Point>,
{
    tessellate(surface, tolerance).expect("the surface and the tolerance are usable")
}

/// The largest distance between the triangles and the surface's points at the same parameters, on a lattice of points of each triangle.
pub fn chord_error<T>(surface: &T, mesh: &Mesh<Point>) -> f64
where
    T: BoundedSurface<Scalar = f64, Point = Point>,
{
    const STEPS: u32 = 6;
    let mut largest = 0.0_f64;
    for corners in mesh.triangles() {
        let corners = corners.map(|vertex| vertex as usize);
        for i in 0..=STEPS {
            for j in 0..=STEPS - i {
                let weights = [i, j, STEPS - i - j].map(|part| f64::from(part) / f64::from(STEPS));
                let at = |values: [[f64; 2]; 3]| <[f64; 2]>::combination(weights, values);
                let [u, v] = at(corners.map(|vertex| mesh.parameters[vertex]));
                let on_triangle =
                    Point::combination(weights, corners.map(|vertex| mesh.positions[vertex]));
                largest = largest.max(length(surface.point(u, v).minus(on_triangle)));
            }
        }
    }
    largest
}

/// What rounding adds to a measured chord error: a bound of 64 unit roundoffs of the largest coordinate, for the corners, their combination and the
/// measurement.
pub fn rounding(mesh: &Mesh<Point>) -> f64 {
    let largest = mesh
        .positions
        .iter()
        .map(|point| point.largest_coordinate())
        .fold(0.0, f64::max);
    64.0 * f64::EPSILON / 2.0 * largest
}

/// How often each edge of a mesh is used, forwards and backwards.
pub fn edges(mesh: &Mesh<Point>) -> HashMap<[u32; 2], [usize; 2]> {
    let mut edges: HashMap<[u32; 2], [usize; 2]> = HashMap::new();
    for [a, b, c] in mesh.triangles() {
        for [from, to] in [[a, b], [b, c], [c, a]] {
            let uses = edges.entry([from.min(to), from.max(to)]).or_default();
            uses[usize::from(from > to)] += 1;
        }
    }
    edges
}

/// Euler's number V − E + F of a mesh all of whose vertices are used.
pub fn euler_number(mesh: &Mesh<Point>) -> i64 {
    let count = |number: usize| i64::try_from(number).expect("a small mesh");
    count(mesh.positions.len()) - count(edges(mesh).len()) + count(mesh.face_count())
}

/// A tube that closes in u, over so many spans, with a bulge.
pub fn tube() -> PeriodicSurface<Point> {
    let knots = [
        KnotVector::uniform(3, 8 + 3),
        KnotVector::clamped(2, &[0., 1., 2., 3.]),
    ];
    let ring = |z: usize, radius: f64| {
        (0..8).map(move |i| {
            let angle = f64::from(i) * std::f64::consts::FRAC_PI_4;
            [radius * angle.cos(), radius * angle.sin(), z as f64]
        })
    };
    let radii = [1.0, 1.5, 0.7, 1.0, 1.2];
    let points: Vec<Point> = radii
        .into_iter()
        .enumerate()
        .flat_map(|(z, radius)| ring(z, radius))
        .collect();
    closed(
        knots.map(|knots| knots.expect("integers")),
        &points,
        [Closing::Closed, Closing::Open],
    )
}

/// A torus over 9 × 6 spans.
pub fn torus() -> PeriodicSurface<Point> {
    let knots = [KnotVector::uniform(3, 9 + 3), KnotVector::uniform(2, 6 + 2)];
    let points = (0..6).flat_map(|j| {
        (0..9).map(move |i| {
            let [u, v] =
                [f64::from(i) / 9.0, f64::from(j) / 6.0].map(|t| t * std::f64::consts::TAU);
            let radius = 3.0 + v.cos();
            [radius * u.cos(), radius * u.sin(), v.sin()]
        })
    });
    let points: Vec<Point> = points.collect();
    closed(
        knots.map(|knots| knots.expect("integers")),
        &points,
        [Closing::Closed; 2],
    )
}

/// The slides' Möbius band: 12 × 7 spans.
pub fn moebius_band() -> PeriodicSurface<Point> {
    let breaks: Vec<f64> = (0..=12).map(f64::from).collect();
    let across: Vec<f64> = (0..=7).map(f64::from).collect();
    let knots = [
        KnotVector::periodic(3, &breaks),
        KnotVector::clamped(2, &across),
    ];
    let points = (0..9).flat_map(|j| {
        (0..12).map(move |i| {
            let turn = f64::from(i) / 12.0 * std::f64::consts::TAU;
            let width = f64::from(j) / 8.0 - 0.5;
            let radius = 2.0 + width * (turn / 2.0).cos();
            [
                radius * turn.cos(),
                radius * turn.sin(),
                width * (turn / 2.0).sin(),
            ]
        })
    });
    let points: Vec<Point> = points.collect();
    closed(
        knots.map(|knots| knots.expect("integers")),
        &points,
        [Closing::Flipped, Closing::Open],
    )
}

fn closed(
    knots: [KnotVector<f64>; 2],
    points: &[Point],
    closing: [Closing; 2],
) -> PeriodicSurface<Point> {
    closed_surface(knots, points, closing).expect("uniform knots close")
}

/// The bicubic patch over the square [0, 3]² with these 16 heights, u fastest.
pub fn bicubic(heights: [f64; 16]) -> BsplineSurface<Point> {
    let knots = [KnotVector::bezier(3), KnotVector::bezier(3)];
    let points = heights.into_iter().enumerate();
    let points = points.map(|(index, z)| [(index % 4) as f64, (index / 4) as f64, z]);
    BsplineSurface::new(knots, points.collect()).expect("16 finite points")
}

/// A wavy bicubic patch.
pub fn wave() -> BsplineSurface<Point> {
    bicubic([
        0., 1., -1., 0., 1., 2., 0., -1., 0., -2., 1., 1., 2., 0., -1., 0.,
    ])
}

/// A surface given by a closure, without derivatives.
pub struct Graph<F> {
    /// The domain.
    pub domain: [[f64; 2]; 2],
    /// The point at `(u, v)`.
    pub point: F,
}

impl<F: Fn(f64, f64) -> Point> Surface for Graph<F> {
    type Scalar = f64;
    type Point = Point;

    fn domain(&self) -> [[f64; 2]; 2] {
        self.domain
    }

    fn point(&self, u: f64, v: f64) -> Point {
        (self.point)(u, v)
    }

    fn partials(&self, _: f64, _: f64) -> Option<[Point; 2]> {
        None
    }
}

/// The nearest number in single precision.
#[allow(
    clippy::cast_possible_truncation,
    reason = "rounding is what is wanted"
)]
pub fn single(number: f64) -> f32 {
    number as f32
}
