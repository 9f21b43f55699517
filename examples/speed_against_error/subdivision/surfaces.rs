//! The variants for surfaces: a mesh refined step by step, by a plan, and by a plan that is there already; and how far the finer meshes are
//! from the limit.

use std::hint::black_box;

use facette::algebra::{Real, VectorSpace};
use facette::mesh::Mesh;
use facette::subdivision::limit::catmull_clark_limits;
use facette::subdivision::{
    Connectivity, Corners, DooSabinWeights, Refinement, Scratch, catmull_clark, doo_sabin,
    loop_subdivision,
};

use super::solids::{cube, octahedron};
use crate::Visitor;
use crate::common::oracle::big_point;
use crate::float_inputs::coordinates;
use crate::harness::{Comparison, Effort, Exact, lazily};

const CORNERS: Corners = Corners::Sharp;
const OWN: DooSabinWeights = DooSabinWeights::Own;

/// How long all turns of one of the large comparisons may last, in nanoseconds.
const BUDGET: f64 = 1e10;

#[derive(Clone, Copy, PartialEq)]
enum Scheme {
    CatmullClark,
    DooSabin,
    Loop,
}

impl Scheme {
    fn plan(self, connectivity: &Connectivity, levels: u32) -> Refinement {
        match self {
            Self::CatmullClark => Refinement::catmull_clark(connectivity, levels, CORNERS),
            Self::DooSabin => Refinement::doo_sabin(connectivity, levels, OWN, CORNERS),
            Self::Loop => Refinement::loop_subdivision(connectivity, levels, CORNERS),
        }
        .expect("counts of 32 bits")
    }

    fn step<P: VectorSpace<Scalar: Real>>(self, mesh: &Mesh<P>) -> Mesh<P> {
        let connectivity = Connectivity::new(mesh).expect("a manifold");
        match self {
            Self::CatmullClark => catmull_clark(&connectivity, &mesh.positions, CORNERS),
            Self::DooSabin => doo_sabin(&connectivity, &mesh.positions, OWN, CORNERS),
            Self::Loop => loop_subdivision(&connectivity, &mesh.positions, CORNERS),
        }
        .expect("a finite mesh")
    }
}

/// The faces of a refined mesh, in memory of the caller's.
struct Faces {
    quads: Vec<[u32; 4]>,
    triangles: Vec<[u32; 3]>,
}

impl Faces {
    fn of(plan: &Refinement) -> Self {
        Self {
            quads: vec![[0; 4]; plan.quad_count()],
            triangles: vec![[0; 3]; plan.triangle_count()],
        }
    }

    fn write(&mut self, plan: &Refinement) {
        plan.quads_into(&mut self.quads).expect("as many");
        plan.triangles_into(&mut self.triangles).expect("as many");
        black_box((&mut self.quads, &mut self.triangles));
    }

    fn fill(&mut self) {
        self.quads.as_flattened_mut().fill(black_box(1));
        self.triangles.as_flattened_mut().fill(black_box(1));
        black_box((&mut self.quads, &mut self.triangles));
    }
}

fn steps(scheme: Scheme, mesh: Mesh<[f32; 3]>, levels: u32) -> Mesh<[f32; 3]> {
    (0..levels).fold(mesh, |mesh, _| scheme.step(&mesh))
}

fn pool(threads: usize) -> rayon::ThreadPool {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
    pool.build().expect("threads")
}

/// Nanoseconds a face for the whole mesh, and for its positions alone.
fn race(
    [quantity, again, inputs]: [&'static str; 3],
    (scheme, mesh, levels): (Scheme, &Mesh<[f32; 3]>, u32),
    visitor: &mut Visitor<'_>,
) {
    let connectivity = Connectivity::new(mesh).expect("a manifold");
    let plan = scheme.plan(&connectivity, levels);
    let (vertices, count) = (plan.vertex_count(), plan.face_count());
    let points = &mesh.positions;
    let wide: Vec<[f64; 3]> = points.iter().map(|p| p.map(f64::from)).collect();
    let [one, two] = [pool(1), pool(2)];
    let memory = || {
        (
            vec![[0.0_f32; 3]; vertices],
            Faces::of(&plan),
            Scratch::new(),
        )
    };
    let mut written = memory();
    let refine = |(positions, faces, scratch): &mut (Vec<_>, Faces, _)| {
        let plan = scheme.plan(&connectivity, levels);
        plan.positions_into(points, scratch, positions)
            .expect("as many");
        faces.write(&plan);
        black_box(positions);
    };
    let (mut warm, mut both) = (memory(), memory());
    let whole = Comparison::new(quantity, inputs, count)
        .within(BUDGET)
        .yardstick::<[f32; 3]>(["writing the mesh once", "f32"], |_| {
            written.0.as_flattened_mut().fill(black_box(1.0));
            written.1.fill();
            black_box(&mut written.0);
        })
        .yardstick::<[f32; 3]>(["a plan and its use", "f32"], |_| {
            one.install(|| refine(&mut warm));
        })
        .yardstick::<[f32; 3]>(["a plan and its use", "f32"], |_| {
            two.install(|| refine(&mut both));
        })
        .on_threads(2)
        .yardstick::<[f32; 3]>(["a plan into fresh memory", "f32"], |_| {
            one.install(|| refine(&mut memory()));
        })
        .yardstick::<[f32; 3]>(["step by step", "f32"], |_| {
            black_box(steps(scheme, mesh.clone(), levels));
        });
    visitor(whole);
    let positions = || (vec![[0.0_f32; 3]; vertices], Scratch::new());
    let (mut filled, mut alone, mut shared) = (positions().0, positions(), positions());
    let mut double = (vec![[0.0_f64; 3]; vertices], Scratch::new());
    let positions = Comparison::new(again, inputs, vertices)
        .within(BUDGET)
        .yardstick::<[f32; 3]>(["writing the positions once", "f32"], |_| {
            black_box(&mut filled)
                .as_flattened_mut()
                .fill(black_box(1.0));
        })
        .yardstick::<[f32; 3]>(["the plan again", "f32"], |_| {
            let write = || plan.positions_into(points, &mut alone.1, &mut alone.0);
            one.install(write).expect("as many");
        })
        .yardstick::<[f32; 3]>(["the plan again", "f32"], |_| {
            let write = || plan.positions_into(points, &mut shared.1, &mut shared.0);
            two.install(write).expect("as many");
        })
        .on_threads(2)
        .yardstick::<[f64; 3]>(["the plan again", "f64"], |_| {
            let write = || plan.positions_into(&wide, &mut double.1, &mut double.0);
            one.install(write).expect("as many");
        });
    visitor(positions);
}

/// The distance of the vertices from their limit, after some levels alone and with the limit's masks.
fn distance(inputs: &'static str, levels: u32, visitor: &mut Visitor<'_>) {
    let cube = cube();
    let connectivity = Connectivity::new(&cube).expect("a manifold");
    let plan = Scheme::CatmullClark.plan(&connectivity, levels);
    let finer = Mesh::new(vec![[0.0_f64; 3]; plan.vertex_count()], plan.quads());
    let finer = Connectivity::new(&finer.expect("a mesh")).expect("a manifold");
    let wide: Vec<[f64; 3]> = cube.positions.iter().map(|p| p.map(f64::from)).collect();
    let one = pool(1);
    let mut scratch: Scratch<[f32; 3]> = Scratch::new();
    let mut limit_scratch = scratch.clone();
    // Double precision is exact enough to measure single precision by.
    let exact: Exact<'_> = lazily(|| {
        let positions = plan.positions(&wide).expect("as many");
        let limits = catmull_clark_limits(&finer, &positions, CORNERS).expect("as many");
        let points = limits.into_iter().map(|limit| limit.position);
        points.map(|point| big_point(coordinates(point))).collect()
    });
    let comparison = Comparison::new(
        "surface: distance to the limit",
        inputs,
        plan.vertex_count(),
    )
    .variant::<[f32; 3]>(["levels alone", "f32"], &exact, |out| {
        let write = || plan.positions_into(&cube.positions, &mut scratch, out);
        one.install(write).expect("as many");
    })
    .variant::<[f32; 3]>(["levels and the limit's masks", "f32"], &exact, |out| {
        let write = || plan.positions_into(&cube.positions, &mut limit_scratch, out);
        one.install(write).expect("as many");
        let limits = catmull_clark_limits(&finer, out, CORNERS).expect("as many");
        for (out, limit) in out.iter_mut().zip(limits) {
            *out = limit.position;
        }
    });
    visitor(comparison);
}

/// Hands all comparisons to the visitor.
pub fn visit(effort: Effort, visitor: &mut Visitor<'_>) {
    // A quick run does what a long one does, on fewer levels.
    let fewer = if effort.rounds < 10 { 4 } else { 0 };
    let (whole, again) = ("surface: Catmull-Clark", "surface: Catmull-Clark again");
    let from_cube = (Scheme::CatmullClark, &cube(), 9 - fewer);
    race([whole, again, "cube"], from_cube, visitor);
    let dense = steps(Scheme::CatmullClark, cube(), 5);
    let from_dense = (Scheme::CatmullClark, &dense, 4 - fewer / 2);
    race([whole, again, "6144 faces"], from_dense, visitor);
    let (whole, again) = ("surface: Doo-Sabin", "surface: Doo-Sabin again");
    let from_cube = (Scheme::DooSabin, &cube(), 9 - fewer);
    race([whole, again, "cube"], from_cube, visitor);
    let from_dense = (Scheme::DooSabin, &dense, 4 - fewer / 2);
    race([whole, again, "6144 faces"], from_dense, visitor);
    let (whole, again) = ("surface: Loop", "surface: Loop again");
    let from_octahedron = (Scheme::Loop, &octahedron(), 9 - fewer);
    race([whole, again, "octahedron"], from_octahedron, visitor);
    let dense = steps(Scheme::Loop, octahedron(), 4);
    let from_dense = (Scheme::Loop, &dense, 5 - fewer / 2);
    race([whole, again, "2048 faces"], from_dense, visitor);
    for (inputs, levels) in [
        ("1 level", 1),
        ("2 levels", 2),
        ("3 levels", 3),
        ("5 levels", 5),
    ] {
        distance(inputs, levels, visitor);
    }
}
