//! One step of any scheme over exact numbers, for what all schemes have in common.
#![allow(
    dead_code,
    reason = "the tests and the exercises use their part of these"
)]

use facette::algebra::VectorSpace;
use facette::mesh::Mesh;
use facette::subdivision::mask::{
    averaging_weight, doo_sabin_weight, loop_vertex_weight, sqrt3_neighbours_weight, turn_cosine,
};
use facette::subdivision::{
    Connectivity, Corners, Counts, DooSabinWeights, Sqrt3Boundary, SubdivisionError, catmull_clark,
    doo_sabin_with, loop_subdivision_with, sqrt3_with,
};
use proptest::prelude::*;

use crate::common::exact::{Exact, fraction};
use crate::common::law::{Verdict, expect_equal};
use crate::meshes::Topology;

/// A scheme with its options.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scheme {
    CatmullClark,
    DooSabin(DooSabinWeights),
    Loop,
    Sqrt3,
}

/// All schemes that subdivide any polygons.
pub const OF_POLYGONS: [Scheme; 3] = [
    Scheme::CatmullClark,
    Scheme::DooSabin(DooSabinWeights::Own),
    Scheme::DooSabin(DooSabinWeights::Averaging),
];

/// All schemes that subdivide triangles.
pub const OF_TRIANGLES: [Scheme; 5] = [
    Scheme::CatmullClark,
    Scheme::DooSabin(DooSabinWeights::Own),
    Scheme::DooSabin(DooSabinWeights::Averaging),
    Scheme::Loop,
    Scheme::Sqrt3,
];

/// cos(2πk/n) where it is rational, elsewhere the fraction of denominator 4096 next to it.
pub fn rational_cosine(k: usize, n: usize) -> Exact {
    #[allow(clippy::cast_possible_truncation, reason = "4096 at most")]
    let rounded = (turn_cosine::<f64>(k, n) * 4096.0).round() as i32;
    fraction(rounded, 4096)
}

impl Scheme {
    /// Step number `step`, counted from 0, over any vectors; `cosine` gives cos(2πk/n).
    pub fn step_with<P: VectorSpace>(
        self,
        mesh: &Mesh<P>,
        step: u32,
        corners: Corners,
        cosine: impl Fn(usize, usize) -> P::Scalar,
    ) -> Result<Mesh<P>, SubdivisionError> {
        let (joined, points) = (&Connectivity::new(mesh)?, &mesh.positions);
        match self {
            Self::CatmullClark => catmull_clark(joined, points, corners),
            Self::DooSabin(DooSabinWeights::Averaging) => {
                doo_sabin_with(joined, points, corners, averaging_weight)
            }
            Self::DooSabin(DooSabinWeights::Own) => {
                let weight = |n, steps| doo_sabin_weight(n, steps, cosine(steps, n));
                doo_sabin_with(joined, points, corners, weight)
            }
            Self::Loop => {
                let weight = |n| loop_vertex_weight(cosine(1, n));
                loop_subdivision_with(joined, points, corners, weight)
            }
            Self::Sqrt3 => {
                let weight = |n| sqrt3_neighbours_weight(cosine(1, n));
                sqrt3_with(
                    joined,
                    points,
                    Sqrt3Boundary::in_step(step),
                    corners,
                    weight,
                )
            }
        }
    }

    /// Step number `step`, counted from 0, over exact numbers.
    pub fn step<const N: usize>(
        self,
        mesh: &Mesh<[Exact; N]>,
        step: u32,
        corners: Corners,
    ) -> Mesh<[Exact; N]> {
        self.step_with(mesh, step, corners, rational_cosine)
            .expect("a manifold with exact points")
    }

    /// What the library expects of the counts after step number `step`.
    pub fn counted(self, before: Counts, step: u32, corners: Corners) -> Counts {
        let after = match self {
            Self::CatmullClark => before.after_catmull_clark(),
            Self::DooSabin(_) => before.after_doo_sabin(corners),
            Self::Loop => before.after_loop(),
            Self::Sqrt3 => before.after_sqrt3(Sqrt3Boundary::in_step(step)),
        };
        after.expect("a small mesh")
    }
}

/// The faces with points that do not matter.
pub fn flat(topology: &Topology) -> Mesh<[Exact; 1]> {
    topology.with_points(vec![[fraction(0, 1)]; topology.vertex_count])
}

/// Passes where the closed polygons are the same, whatever each begins with and whichever comes first.
pub fn expect_same_cycles<P: VectorSpace>(expected: &[Vec<P>], got: &[Vec<P>]) -> Verdict {
    let is_turned = |a: &Vec<P>, b: &Vec<P>| {
        let doubled = [&a[..], a].concat();
        a.len() == b.len() && doubled.windows(a.len()).any(|turned| turned == &b[..])
    };
    let is_there = |polygon: &Vec<P>| got.iter().any(|other| is_turned(polygon, other));
    if expected.len() == got.len() && expected.iter().all(is_there) {
        return Ok(());
    }
    expect_equal(&expected, &got)
}

/// The points of each boundary, in its direction.
pub fn boundary_polygons<P: VectorSpace>(mesh: &Mesh<P>) -> Vec<Vec<P>> {
    let joined = Connectivity::new(mesh).expect("a manifold");
    let mut seen = vec![false; joined.vertex_count()];
    let mut polygons = Vec::new();
    for edge in (0..).take(joined.edge_count()) {
        let mut vertex = joined.origin(joined.half_edge_of(edge));
        let mut polygon = Vec::new();
        while joined.is_boundary_edge(edge) && !std::mem::replace(&mut seen[vertex as usize], true)
        {
            polygon.push(mesh.positions[vertex as usize]);
            let leaving = joined
                .outgoing(vertex)
                .expect("a boundary vertex has a face");
            vertex = joined.target(leaving);
        }
        if !polygon.is_empty() {
            polygons.push(polygon);
        }
    }
    polygons
}

/// Both rules for corners.
pub fn corner_rules() -> impl Strategy<Value = Corners> {
    prop_oneof![Just(Corners::Sharp), Just(Corners::Smooth)]
}
