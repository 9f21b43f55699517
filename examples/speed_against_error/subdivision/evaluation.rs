//! The variants for exact evaluation: a point of the limit by local steps, by Stam's eigenbasis, and by a fine mesh's nearest vertex.

use facette::algebra::{Real, VectorSpace};
use facette::mesh::Mesh;
use facette::subdivision::evaluate::{CatmullClarkSurface, LoopSurface};
use facette::subdivision::limit::catmull_clark_limit_positions;
use facette::subdivision::mask::loop_vertex_weight;
use facette::subdivision::{Connectivity, Corners, catmull_clark};

use crate::Visitor;
use crate::common::dice::Dice;
use crate::common::exact::{self, fraction};
use crate::common::oracle::Big;
use crate::float_inputs::FloatPoint;
use crate::harness::{Comparison, Effort, ExactPoint, lazily};

/// How many points are asked for in a run: one in each of 8 x 8 squares of a corner, off the vertices of the finer meshes.
const COUNT: u32 = 64;

/// Levels of the mesh whose nearest vertex stands for the point.
const LEVELS: u32 = 4;

/// A fan of faces around vertex 0, and places at that vertex.
struct Task {
    valence: u32,
    /// Places are divided by 2 to this.
    depth: u32,
    faces: Vec<Vec<u32>>,
    /// Sixteenths.
    points: Vec<[i32; 3]>,
}

#[allow(
    clippy::cast_possible_truncation,
    reason = "sixteenths between -16 and 16"
)]
impl Task {
    fn new(valence: u32, depth: u32, faces: Vec<Vec<u32>>) -> Self {
        let last = faces.iter().flatten().max().copied().unwrap_or(0);
        let mut dice = Dice::new(u64::from(valence));
        let sixteenths = |x: f64| (x * 16.0).round() as i32;
        let points = (0..=last).map(|_| dice.vector().map(sixteenths)).collect();
        Self {
            valence,
            depth,
            faces,
            points,
        }
    }

    fn of_quadrilaterals(n: u32, depth: u32) -> Self {
        let quad = |k| vec![0, 1 + k, 1 + n + k, 1 + (k + 1) % n];
        Self::new(n, depth, (0..n).map(quad).collect())
    }

    fn of_triangles(n: u32, depth: u32) -> Self {
        let triangle = |k| vec![0, 1 + k, 1 + (k + 1) % n];
        Self::new(n, depth, (0..n).map(triangle).collect())
    }

    fn mesh<P: VectorSpace>(&self, point: impl Fn([i32; 3]) -> P) -> (Mesh<P>, Connectivity) {
        let points = self.points.iter().map(|&sixteenths| point(sixteenths));
        let mesh = Mesh::new(points.collect(), &self.faces).expect("the faces name their points");
        let joined = Connectivity::new(&mesh).expect("a fan is a manifold");
        (mesh, joined)
    }

    fn rounded<P: FloatPoint>(&self) -> (Mesh<P>, Connectivity) {
        self.mesh(|point| P::rounded(point.map(|sixteenths| f64::from(sixteenths) / 16.0)))
    }

    /// The face, and the places there as numerators over 256 · 2^depth.
    fn places(&self) -> impl Iterator<Item = (u32, [i32; 2])> {
        let valence = self.valence;
        (0..COUNT).zip(0..).map(move |(index, number): (u32, i32)| {
            (index % valence, [number % 8 * 32 + 21, number / 8 * 32 + 9])
        })
    }

    fn parameters<S: Real>(&self) -> Vec<(u32, [S; 2])> {
        let unit = 1.0 / 256.0 * 0.5_f64.powi(self.depth.cast_signed());
        let place = |numerator: i32| S::from_f64(f64::from(numerator) * unit);
        self.places()
            .map(|(face, place_of)| (face, place_of.map(place)))
            .collect()
    }

    fn exact_points(
        &self,
        exact: impl Fn(u32, [exact::Exact; 2]) -> [exact::Exact; 3],
    ) -> Vec<ExactPoint> {
        let place = |numerator| fraction(numerator, 256 << self.depth);
        self.places()
            .map(|(face, at)| exact(face, at.map(place)).map(to_big))
            .collect()
    }
}

/// The same number without a limit of size.
fn to_big(value: exact::Exact) -> Big {
    let text = format!("{value:?}");
    text.parse().expect("a fraction writes itself as one")
}

fn exact_point(sixteenths: [i32; 3]) -> [exact::Exact; 3] {
    sixteenths.map(|numerator| fraction(numerator, 16))
}

/// Fills the list with the points of a surface at the places of the task.
fn filled<P: VectorSpace>(
    parameters: Vec<(u32, [P::Scalar; 2])>,
    point: impl Fn(u32, [P::Scalar; 2]) -> P,
) -> impl FnMut(&mut [P]) {
    move |points| {
        for (place, &(face, at)) in points.iter_mut().zip(&parameters) {
            *place = point(face, at);
        }
    }
}

/// Adds both ways for Catmull-Clark in one precision.
fn quadrilaterals<'a, P: FloatPoint>(
    comparison: Comparison<'a>,
    scalar: &'static str,
    task: &'a Task,
) -> Comparison<'a>
where
    P::Scalar: Real,
{
    let exact = lazily(move || {
        let (mesh, joined) = task.mesh(exact_point);
        let surface = CatmullClarkSurface::new(&joined, &mesh.positions, Corners::Sharp);
        let surface = surface.expect("finite points");
        task.exact_points(|face, [s, t]| surface.corner_point(4 * face, s, t).expect("a corner"))
    });
    let (mesh, joined) = task.rounded::<P>();
    let surface = CatmullClarkSurface::new(&joined, &mesh.positions, Corners::Sharp);
    let adaptive = surface.expect("finite points");
    let eigenbasis = adaptive.clone().with_eigenbasis();
    let by = |surface: CatmullClarkSurface<P>| {
        filled(task.parameters(), move |face, [s, t]| {
            surface.corner_point(4 * face, s, t).expect("a corner")
        })
    };
    comparison
        .variant(["feature-adaptive", scalar], &exact, by(adaptive))
        .variant(["Stam's eigenbasis", scalar], &exact, by(eigenbasis))
        .variant(
            ["4 levels and the nearest limit point", scalar],
            &exact,
            nearest_of_levels(task, mesh),
        )
}

/// Refines the mesh in every run, and takes the limit of the vertex that is nearest in the parameters.
fn nearest_of_levels<P: FloatPoint>(task: &Task, mesh: Mesh<P>) -> impl FnMut(&mut [P]) {
    let refined = move || {
        let step = |mesh: &Mesh<P>| {
            let joined = Connectivity::new(mesh).expect("a manifold");
            catmull_clark(&joined, &mesh.positions, Corners::Sharp).expect("a small mesh")
        };
        (0..LEVELS).fold(mesh.clone(), |mesh, _| step(&mesh))
    };
    let fine = refined();
    let faces: Vec<&[u32]> = fine.faces().collect();
    let vertex = |(face, parameters): (u32, [f64; 2])| {
        let mut at = (4 * face as usize, parameters);
        for _ in 1..LEVELS {
            let (quadrant, inner) = quadrant(at.1);
            at = (4 * at.0 + quadrant, inner);
        }
        faces[at.0][quadrant(at.1).0] as usize
    };
    let vertices: Vec<usize> = task.parameters().into_iter().map(vertex).collect();
    move |points| {
        let fine = refined();
        let joined = Connectivity::new(&fine).expect("a manifold");
        let limits = catmull_clark_limit_positions(&joined, &fine.positions, Corners::Sharp);
        let limits = limits.expect("a point for each vertex");
        for (place, &vertex) in points.iter_mut().zip(&vertices) {
            *place = limits[vertex];
        }
    }
}

/// The quadrant of a quadrilateral with the parameters, and those in it.
fn quadrant([u, v]: [f64; 2]) -> (usize, [f64; 2]) {
    let [u2, v2] = [u, v].map(|parameter| 2.0 * parameter);
    let [from_right, from_above] = [2.0 - u2, 2.0 - v2];
    match (u < 0.5, v < 0.5) {
        (true, true) => (0, [u2, v2]),
        (false, true) => (1, [v2, from_right]),
        (false, false) => (2, [from_right, from_above]),
        (true, false) => (3, [from_above, u2]),
    }
}

/// Adds both ways for Loop in one precision. The valence must have a rational cosine: 4.
fn triangles<'a, P: FloatPoint>(
    comparison: Comparison<'a>,
    scalar: &'static str,
    task: &'a Task,
) -> Comparison<'a>
where
    P::Scalar: Real,
{
    let exact = lazily(move || {
        let (mesh, joined) = task.mesh(exact_point);
        let weight = |_| loop_vertex_weight(fraction(0, 1));
        let surface = LoopSurface::with_weights(&joined, &mesh.positions, Corners::Sharp, weight);
        let surface = surface.expect("finite points");
        task.exact_points(|face, [s, t]| {
            let [s, t] = [s, t].map(|parameter| parameter / fraction(2, 1));
            let barycentric = [fraction(1, 1) - s - t, s, t];
            surface.point(face, barycentric).expect("a face")
        })
    });
    let (mesh, joined) = task.rounded::<P>();
    let surface = LoopSurface::new(&joined, &mesh.positions, Corners::Sharp);
    let adaptive = surface.expect("finite points");
    let eigenbasis = adaptive.clone().with_eigenbasis();
    let by = |surface: LoopSurface<P>| {
        filled(task.parameters(), move |face, [s, t]: [P::Scalar; 2]| {
            let half = P::Scalar::from_f64(0.5);
            let [s, t] = [s * half, t * half];
            let barycentric = [P::Scalar::from_f64(1.0) - s - t, s, t];
            surface.point(face, barycentric).expect("a face")
        })
    };
    comparison
        .variant(["feature-adaptive", scalar], &exact, by(adaptive))
        .variant(["Stam's eigenbasis", scalar], &exact, by(eigenbasis))
}

/// Hands the comparisons to the visitor: places all over a corner, and a millionth part of it next to the vertex.
pub fn visit(_effort: Effort, visitor: &mut Visitor<'_>) {
    for (inputs, valence, depth) in [("typical", 5, 0), ("hard", 5, 20), ("typical", 20, 2)] {
        let task = Task::of_quadrilaterals(valence, depth);
        let comparison = Comparison::new("limit point: Catmull-Clark", inputs, COUNT as usize)
            .of_size(valence as usize);
        let comparison = quadrilaterals::<[f64; 3]>(comparison, "f64", &task);
        visitor(quadrilaterals::<[f32; 3]>(comparison, "f32", &task));
    }
    for (inputs, depth) in [("typical", 0), ("hard", 20)] {
        let task = Task::of_triangles(4, depth);
        let comparison = Comparison::new("limit point: Loop", inputs, COUNT as usize).of_size(4);
        let comparison = triangles::<[f64; 3]>(comparison, "f64", &task);
        visitor(triangles::<[f32; 3]>(comparison, "f32", &task));
    }
}
