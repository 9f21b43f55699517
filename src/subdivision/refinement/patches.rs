//! Patches on one thread or several: who writes which points.

use std::ops::Range;

use rayon::prelude::*;

use super::rows::{Grid, Window};
use crate::algebra::VectorSpace;

/// How many points there are in the parts of a patch.
#[derive(Clone, Copy, Debug)]
pub(super) struct PatchSizes {
    /// Corners.
    pub(super) corners: usize,
    /// Points inside an edge.
    pub(super) edge: usize,
    /// Points inside the patch.
    pub(super) inside: usize,
}

/// What a patch is refined from.
#[derive(Debug)]
pub(super) struct Source<'a, P> {
    /// The points of level 0.
    pub(super) points: &'a [P],
    /// The points of the stars on all levels.
    pub(super) stars: &'a [P],
}

impl<P> Clone for Source<'_, P> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<P> Copy for Source<'_, P> {}

/// Where the points of one patch go.
#[derive(Debug)]
pub(super) struct PatchOut<'a, P> {
    /// The insides of the edges that the patch owns, one after the other.
    pub(super) edges: &'a mut [P],
    /// The inside of the patch.
    pub(super) inside: &'a mut [P],
    /// Its corners.
    pub(super) corners: &'a mut [P],
}

/// How many small patches are refined together: enough that the points in one place are several of the processor's vectors, few enough that
/// the grids stay in the cache.
pub(super) const LANES: usize = 16;

/// How many of `count` patches are refined `LANES` at a time, so that their points lie side by side: whole groups, where the patches are cut
/// into fewer pieces a side than pays for a loop of its own.
pub(super) fn grouped(count: usize, side: u32) -> usize {
    /// Measured: at 64 a row of one patch alone is as fast.
    const SMALL: u32 = 64;
    if side < SMALL {
        count - count % LANES
    } else {
        0
    }
}

/// Room for the grids of `LANES` patches at a time.
#[derive(Clone, Debug)]
pub(super) struct Workbench<P, const LANES: usize> {
    /// The grid of each level but the finest.
    pub(super) grids: Vec<Grid<P, LANES>>,
    /// Rows on their way from one grid to the next.
    pub(super) window: Window<P, LANES>,
    /// One row on its way to several patches.
    pub(super) row: Vec<[P; LANES]>,
}

impl<P: VectorSpace, const LANES: usize> Workbench<P, LANES> {
    fn new() -> Self {
        Self {
            grids: Vec::new(),
            window: Window::new(0),
            row: Vec::new(),
        }
    }

    /// Makes room for `count` grids of which the first has `side` points a side, and each of the others `refined(side)` where the one before has
    /// `side`.
    pub(super) fn prepare(&mut self, count: u32, side: usize, refined: fn(usize) -> usize) {
        let sides = (0..count).scan(side, |side, _| {
            Some(std::mem::replace(side, refined(*side)))
        });
        let is_ready = self.grids.len() == count as usize
            && self.grids.iter().map(Grid::side).eq(sides.clone());
        if !is_ready {
            self.grids = sides.map(Grid::new).collect();
            let longest = self.grids.last().map_or(0, |grid| refined(grid.side()));
            self.window = Window::new(longest);
            self.row = vec![[P::origin(); LANES]; longest];
        }
    }

    fn bytes(&self) -> usize {
        let row = self.row.capacity() * size_of::<[P; LANES]>();
        self.grids.iter().map(Grid::bytes).sum::<usize>() + self.window.bytes() + row
    }
}

/// What one thread works with.
#[derive(Clone, Debug)]
pub(super) struct Worker<P> {
    one: Workbench<P, 1>,
    several: Workbench<P, LANES>,
}

impl<P: VectorSpace> Worker<P> {
    fn new() -> Self {
        Self {
            one: Workbench::new(),
            several: Workbench::new(),
        }
    }

    fn bytes(&self) -> usize {
        self.one.bytes() + self.several.bytes()
    }
}

/// Room for everything that refining needs beside its result, to be used again and again.
///
/// What is in it does not matter: any scratch serves any plan.
#[derive(Clone, Debug)]
pub struct Scratch<P> {
    pub(super) base: Vec<P>,
    pub(super) stars: Vec<P>,
    pub(super) corners: Vec<P>,
    pub(super) workers: Vec<Worker<P>>,
}

impl<P: VectorSpace> Scratch<P> {
    /// A scratch without room: it grows where it is used.
    pub fn new() -> Self {
        Self {
            base: Vec::new(),
            stars: Vec::new(),
            corners: Vec::new(),
            workers: Vec::new(),
        }
    }

    /// Bytes that it has reserved.
    pub fn bytes(&self) -> usize {
        let points = self.base.capacity() + self.stars.capacity() + self.corners.capacity();
        points * size_of::<P>() + self.workers.iter().map(Worker::bytes).sum::<usize>()
    }
}

impl<P: VectorSpace> Default for Scratch<P> {
    fn default() -> Self {
        Self::new()
    }
}

/// Patches that can be refined one by one, in any order.
pub(super) trait Patches<P: VectorSpace>: Sync {
    fn sizes(&self) -> PatchSizes;

    /// The edges that a patch writes; those of one patch after those of the patch before.
    fn owned_edges(&self, patch: usize) -> Range<usize>;

    /// How many of the patches are refined `LANES` at a time: those of the lower numbers.
    fn grouped(&self) -> usize;

    /// Refines `LANES` patches through all levels, from this one on.
    fn refine_patches<const LANES: usize>(
        &self,
        first: usize,
        from: Source<'_, P>,
        workbench: &mut Workbench<P, LANES>,
        out: PatchOut<'_, P>,
    );
}

/// Patches in a row, and where they write.
struct Job<'a, P> {
    patches: Range<usize>,
    worker: &'a mut Worker<P>,
    out: PatchOut<'a, P>,
}

/// Refines all patches, on as many threads as rayon has here. Each point has one patch that writes it, so that the result is the same
/// whoever works on which.
// ANCHOR: refine_all
pub(super) fn refine_all<P: VectorSpace>(
    plan: &impl Patches<P>,
    count: usize,
    from: Source<'_, P>,
    workers: &mut Vec<Worker<P>>,
    mut out: PatchOut<'_, P>,
) {
    let threads = rayon::current_num_threads();
    let job_count = if threads == 1 { 1 } else { 4 * threads }.min(count);
    workers.resize_with(job_count, Worker::new);
    let start_of = |job: usize| {
        let start = job * count / job_count;
        if start < plan.grouped() {
            start - start % LANES
        } else {
            start
        }
    };
    let jobs = workers.iter_mut().enumerate().map(|(job, worker)| {
        let patches = start_of(job)..start_of(job + 1);
        let out = out.split_off(plan, patches.clone());
        Job {
            patches,
            worker,
            out,
        }
    });
    let jobs: Vec<Job<'_, P>> = jobs.collect();
    if threads > 1 {
        jobs.into_par_iter().for_each(|job| job.run(plan, from));
        return;
    }
    for job in jobs {
        job.run(plan, from);
    }
}
// ANCHOR_END: refine_all

impl<P: VectorSpace> Job<'_, P> {
    fn run(mut self, plan: &impl Patches<P>, from: Source<'_, P>) {
        let mut patches = self.patches;
        let in_groups = plan.grouped().min(patches.end);
        while patches.start < in_groups {
            let group = patches.start..patches.start + LANES;
            let out = self.out.split_off(plan, group.clone());
            plan.refine_patches::<LANES>(group.start, from, &mut self.worker.several, out);
            patches.start = group.end;
        }
        for patch in patches {
            let out = self.out.split_off(plan, patch..patch + 1);
            plan.refine_patches::<1>(patch, from, &mut self.worker.one, out);
        }
    }
}

impl<'a, P: VectorSpace> PatchOut<'a, P> {
    /// What the next patches write.
    fn split_off(&mut self, plan: &impl Patches<P>, patches: Range<usize>) -> PatchOut<'a, P> {
        let PatchSizes {
            corners,
            edge,
            inside,
        } = plan.sizes();
        let count = patches.len();
        let edges = match patches.end.checked_sub(1) {
            Some(last) if count > 0 => {
                plan.owned_edges(patches.start).start..plan.owned_edges(last).end
            }
            _ => 0..0,
        };
        PatchOut {
            edges: whole(self.edges.split_off_mut(..edges.len() * edge)),
            inside: whole(self.inside.split_off_mut(..count * inside)),
            corners: whole(self.corners.split_off_mut(..count * corners)),
        }
    }
}

/// The parts of all patches make up the whole.
fn whole<P>(part: Option<&mut [P]>) -> &mut [P] {
    part.expect("memory for all patches")
}
