//! What plans of Catmull-Clark and Loop promise beside their points: the same bits, boundaries, rounding, memory. The book shows the doc comments.

use facette::subdivision::{Connectivity, Corners, Refinement, Scratch, SubdivisionError};
use proptest::collection::vec;
use proptest::prelude::*;

use crate::common::exact::Exact;
use crate::common::law::{Law, Verdict, expect_at_most, expect_equal};
use crate::meshes::{
    Cage, Topology, cube_faces, float_meshes, grid, hard_topologies, hard_triangle_topologies,
    octahedron_faces, topologies, torus, triangle_topologies, triangle_torus,
};
use crate::refinement_match::Threads;
use crate::steps::corner_rules;
use crate::suspects;
use facette::algebra::Scalar;

#[derive(Clone, Copy, Debug)]
enum Kind {
    CatmullClark,
    Loop,
}

impl Kind {
    fn plan(self, joined: &Connectivity, levels: u32, corners: Corners) -> Refinement {
        match self {
            Self::CatmullClark => Refinement::catmull_clark(joined, levels, corners),
            Self::Loop => Refinement::loop_subdivision(joined, levels, corners),
        }
        .expect("a small mesh")
    }
}

type Input = (Cage<[f64; 3]>, (Corners, u32));

fn holds_for_both(theorem: &'static str, check: impl Fn(Kind, &Input) -> Verdict) {
    let law = || Law::new(theorem, suspects::library).on_cases(48);
    let choices = || (corner_rules(), 1..5_u32);
    let polygons = (float_meshes(topologies()), choices());
    let hard = (float_meshes(hard_topologies()), choices());
    law().holds(polygons, hard, |input| check(Kind::CatmullClark, input));
    let triangles = (float_meshes(triangle_topologies()), choices());
    let hard = (float_meshes(hard_triangle_topologies()), choices());
    law().holds(triangles, hard, |input| check(Kind::Loop, input));
}

/// **The same bits, whoever computes them.** Each point of a plan is computed by one patch, with the same operations on one thread or several, in fresh memory or in memory that another mesh has used.
///
/// Course: D22, slides 72-76, Catmull-Clark: the scheme, level after level.
#[test]
fn plan_has_the_same_bits_on_any_number_of_threads() {
    let threads = Threads::new();
    let theorem = "subdivision::plan_has_the_same_bits_on_any_number_of_threads";
    holds_for_both(theorem, |kind, (cage, (corners, levels))| {
        let plan = kind.plan(&cage.connectivity(), *levels, *corners);
        let points = &cage.mesh.positions;
        threads.expect_same_bits(&plan, points)
    });
}

/// **Neighbours meet.** The points of a plan along a boundary are the same, bit by bit, whatever the points inside: two meshes with the same boundary have no gap on any level.
///
/// Course: D27, slide 78, boundaries: they follow the scheme of a curve.
#[test]
fn boundary_of_a_plan_depends_on_the_boundary_alone() {
    let theorem = "subdivision::boundary_of_a_plan_depends_on_the_boundary_alone";
    holds_for_both(theorem, |kind, (cage, (corners, levels))| {
        let joined = cage.connectivity();
        let plan = kind.plan(&joined, *levels, *corners);
        let mut points = cage.mesh.positions.clone();
        let before = plan.positions(&points);
        for (vertex, point) in (0..).zip(&mut points) {
            if !joined.is_boundary_vertex(vertex) {
                *point = [1.0, 2.0, f64::from(vertex)];
            }
        }
        let [Ok(before), Ok(after)] = [before, plan.positions(&points)] else {
            return Ok(());
        };
        let refined = Connectivity::new(&plan.mesh(&points).expect("finite points"));
        let refined = refined.expect("a manifold");
        let vertices = (0..).take(refined.vertex_count());
        vertices
            .filter(|&vertex| refined.is_boundary_vertex(vertex))
            .try_for_each(|v| expect_equal(&before[v as usize], &after[v as usize]))
    });
}

/// **Rounding of a plan.** After $k$ levels of Catmull-Clark on quadrilaterals of regular valence, with boundaries and corners, each coordinate is within $4k\,\mathbf uM$ of the exact one, $M$ the largest coordinate of the mesh.
///
/// Along a row, $\frac34b+\frac18(a+c)$ is rounded three times: the sum $a+c$ by $2\mathbf uM$, of which an eighth counts; the product by $\frac34\mathbf uM$; the sum by $\mathbf uM$: together $2\mathbf uM$. A midpoint is rounded by $\mathbf uM$. Across the rows it is the same, and the masks are means: they pass errors on but do not magnify them.
/// So a level adds $4\mathbf uM$.
///
/// Course: D22, slides 72-76, Catmull-Clark: the scheme, level after level.
#[test]
fn plan_of_catmull_clark_rounds_little() {
    let sheets = || prop_oneof![Just(torus(4, 5)), Just(grid(3, 2)), Just(torus(3, 3))];
    let inputs = |limit: i32| {
        sheets().prop_flat_map(move |topology| {
            let coordinate = || -limit..=limit;
            let points = vec(
                [coordinate(), coordinate(), coordinate()],
                topology.vertex_count,
            );
            (Just(topology), points, 1..4_u32)
        })
    };
    let worst = std::cell::Cell::new(0.0_f64);
    let law = Law::new(
        "subdivision::plan_of_catmull_clark_rounds_little",
        suspects::library,
    );
    law.on_cases(48).holds(
        inputs(1 << 24),
        inputs(12345),
        |(topology, points, levels)| {
            let share = rounding(topology, points, *levels);
            worst.set(worst.get().max(share));
            expect_at_most("error as a share of 4k u M", 1.0, share)
        },
    );
    println!("at most {:.2} of the bound", worst.get());
    assert!(worst.get() > 0.05, "the bound is not idle");
}

/// The largest error of a plan in single precision, as a share of 4k u M.
fn rounding(topology: &Topology, points: &[[i32; 3]], levels: u32) -> f64 {
    let plan = Kind::CatmullClark.plan(&topology.connectivity(), levels, Corners::Sharp);
    let exact: Vec<_> = points.iter().map(|p| p.map(Exact::from_i32)).collect();
    let exact = plan.positions_with(&exact, |_, _| unreachable!("no cosines here"));
    let rounded: Vec<_> = points.iter().map(|p| p.map(f32::from_i32)).collect();
    let rounded = plan.positions(&rounded).expect("as many points");
    let size = points.iter().flatten().map(|c| c.abs()).max().unwrap_or(0);
    let bound = 4.0 * f64::from(levels) * f64::from(f32::unit_roundoff()) * f64::from(size);
    let pairs = exact.expect("as many points").into_iter().zip(rounded);
    let errors = pairs.flat_map(|(exact, rounded)| {
        [0, 1, 2].map(|axis| (exact[axis].to_f64() - f64::from(rounded[axis])).abs())
    });
    let worst = errors.fold(0.0, f64::max);
    if worst == 0.0 { 0.0 } else { worst / bound }
}

/// **A plan is small.** The plan and the room it works in take less memory than what they write (points of three single-precision coordinates, faces of indices), so that all together stay below $2.5$ times the refined mesh: from the cube and the octahedron, and from 4000 quadrilaterals or triangles.
///
/// Course: D28, slide 79, what a level costs.
#[test]
fn plan_is_small() {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(2).build();
    let pool = pool.expect("threads");
    for (kind, topology, levels) in [
        (Kind::CatmullClark, cube_faces(), 7),
        (Kind::CatmullClark, torus(80, 50), 3),
        (Kind::CatmullClark, grid(80, 50), 4),
        (Kind::CatmullClark, triangle_torus(50, 40), 4),
        (Kind::Loop, octahedron_faces(), 7),
        (Kind::Loop, triangle_torus(50, 40), 4),
    ] {
        let plan = kind.plan(&topology.connectivity(), levels, Corners::Sharp);
        let points = vec![[0.0_f32; 3]; topology.vertex_count];
        let mut positions = vec![[0.0_f32; 3]; plan.vertex_count()];
        let mut scratch = Scratch::new();
        let outcome = pool.install(|| plan.positions_into(&points, &mut scratch, &mut positions));
        assert_eq!(outcome, Ok(()));
        let faces = 16 * plan.quad_count() + 12 * plan.triangle_count();
        let share =
            (plan.bytes() + scratch.bytes()) as f64 / (size_of_val(&positions[..]) + faces) as f64;
        println!("{kind:?}, {}, {levels} levels: {share:.3}", topology.name);
        assert!(share < 1.0, "{}: {share}", topology.name);
    }
}

/// **Memory of the wrong length.** Memory that is too short or too long for what is to be written is refused, and says by how much; so is a number of points that is not that of the vertices.
///
/// Course: D22, slides 72-76, Catmull-Clark: the scheme, level after level.
#[test]
fn plan_refuses_memory_of_the_wrong_length() {
    let plan = Kind::CatmullClark.plan(&cube_faces().connectivity(), 2, Corners::Sharp);
    let points = [[0.0; 3]; 8];
    let refused = plan.positions_into(&points, &mut Scratch::new(), &mut [[0.0; 3]; 97]);
    let expected = SubdivisionError::BufferLength {
        what: "positions",
        found: 97,
        expected: 98,
    };
    assert_eq!(refused, Err(expected.clone()));
    let message = "memory for 97 positions was handed in: there are 98";
    assert_eq!(expected.to_string(), message);
    assert!(plan.quads_into(&mut [[0; 4]; 95]).is_err());
    assert!(plan.triangles_into(&mut [[0; 3]; 1]).is_err());
    let short = plan.positions(&points[..7]);
    let counts = SubdivisionError::PointCount {
        found: 7,
        expected: 8,
    };
    assert_eq!(short, Err(counts));
}
