//! Whether two meshes are the same up to the numbers of their vertices and faces.

use std::cell::RefCell;

use facette::algebra::VectorSpace;
use facette::mesh::Mesh;
use facette::subdivision::{Connectivity, Refinement, Scratch};
use rayon::{ThreadPool, ThreadPoolBuilder};

use crate::common::law::{Broken, Verdict, expect_equal};

/// One, two and three threads, and memory that other meshes have used.
pub struct Threads {
    pools: [ThreadPool; 3],
    used: RefCell<Scratch<[f64; 3]>>,
}

impl Threads {
    pub fn new() -> Self {
        let pool = |threads| ThreadPoolBuilder::new().num_threads(threads).build();
        Self {
            pools: [1, 2, 3].map(|threads| pool(threads).expect("threads")),
            used: RefCell::new(Scratch::new()),
        }
    }

    /// Expects a plan to make the same positions and faces on any number of threads, in used memory and in fresh.
    pub fn expect_same_bits(&self, plan: &Refinement, points: &[[f64; 3]]) -> Verdict {
        let results = self.pools.each_ref().map(|pool| {
            let mut positions = vec![[f64::NAN; 3]; plan.vertex_count()];
            let mut scratch = self.used.take();
            let outcome =
                pool.install(|| plan.positions_into(points, &mut scratch, &mut positions));
            self.used.replace(scratch);
            (outcome.map(|()| positions), pool.install(|| plan.faces()))
        });
        expect_equal(&results[0], &results[1])?;
        expect_equal(&results[0], &results[2])?;
        expect_equal(&results[0].0, &plan.positions(points))
    }
}

fn broken(expected: &str, got: String) -> Verdict {
    Err(Broken {
        expected: expected.to_owned(),
        got,
    })
}

/// For each vertex of the first mesh the vertex of the second that it is, found by walking over both at once from pairs of half-edges that are known to
/// be the same. The walk crosses every edge, so that faces must be joined alike everywhere.
pub fn vertices_of_same_mesh<P: VectorSpace>(
    first: &Mesh<P>,
    second: &Mesh<P>,
    seeds: impl IntoIterator<Item = [u32; 2]>,
) -> Result<Vec<Option<u32>>, Broken> {
    let [a, b] = [first, second].map(|mesh| Connectivity::new(mesh).expect("a manifold"));
    let mut partner = vec![None; a.half_edge_count()];
    let mut vertices = vec![None; a.vertex_count()];
    let mut waiting: Vec<[u32; 2]> = seeds.into_iter().collect();
    while let Some([h, g]) = waiting.pop() {
        match partner[h as usize] {
            Some(known) if known == g => continue,
            Some(known) => {
                broken("one partner", format!("half-edge {h} is {known} and {g}"))?;
            }
            None => partner[h as usize] = Some(g),
        }
        let [origin, other] = [a.origin(h), b.origin(g)];
        if *vertices[origin as usize].get_or_insert(other) != other {
            let known = vertices[origin as usize];
            broken("one vertex", format!("{origin} is {known:?} and {other}"))?;
        }
        waiting.push([a.next(h), b.next(g)]);
        match (a.twin(h), b.twin(g)) {
            (Some(h), Some(g)) => waiting.push([h, g]),
            (None, None) => {}
            _ => broken("a boundary in both", format!("half-edges {h} and {g}"))?,
        }
    }
    let counts = [
        [a.half_edge_count(), b.half_edge_count()],
        [a.vertex_count(), b.vertex_count()],
        [a.face_count(), b.face_count()],
    ];
    let all = partner.iter().all(Option::is_some);
    if counts.iter().any(|[a, b]| a != b) || !all {
        broken("the same counts", format!("{counts:?}, all matched: {all}"))?;
    }
    Ok(vertices)
}

/// Passes where the meshes are the same, points included. Vertices without a face must have the same numbers.
pub fn expect_same_mesh<P: VectorSpace>(
    first: &Mesh<P>,
    second: &Mesh<P>,
    seeds: impl IntoIterator<Item = [u32; 2]>,
) -> Verdict {
    let vertices = vertices_of_same_mesh(first, second, seeds)?;
    for (vertex, (point, partner)) in first.positions.iter().zip(vertices).enumerate() {
        let other = second.positions[partner.map_or(vertex, |other| other as usize)];
        if *point != other {
            broken(
                &format!("vertex {vertex} at {point:?}"),
                format!("{other:?}"),
            )?;
        }
    }
    Ok(())
}
