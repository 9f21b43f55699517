//! Evaluation with degrees that the compiler knows.

use std::fmt::Debug;
use std::ops::Range;

use num_traits::AsPrimitive;

use super::axis::Axis;
use super::patches::{
    BLOCK, Block, LANES, Lanes, Patches, Row, bernstein, bernstein_blocks, bernstein_lanes,
    sum_block, sum_row,
};
use crate::algebra::{Scalar, Vector3};
use crate::bspline::{BsplineSurface, Direction};
use crate::curve::count;

/// What a prepared surface can do, whatever its degrees. All lists have as many entries as they must.
pub(super) trait Kernel<P: Vector3>: Debug + Send + Sync {
    /// Writes the points at the parameters.
    fn points(&self, parameters: &[[P::Scalar; 2]], points: &mut [P]);

    /// Writes the partial derivatives `[S_u, S_v]` at the parameters, and how wrong a coordinate of each can be.
    fn tangents(
        &self,
        parameters: &[[P::Scalar; 2]],
        tangents: &mut [[P; 2]],
        noise: &mut [[P::Scalar; 2]],
    );

    /// Writes `[S, S_u, S_v]` at the parameters.
    fn partials(&self, parameters: &[[P::Scalar; 2]], partials: &mut [[P; 3]]);

    /// Writes the points of a grid that has columns.
    fn points_on_grid(&self, us: &[P::Scalar], vs: &[P::Scalar], points: &mut [P]);

    /// Writes `[S, S_u, S_v]` of a grid that has columns.
    fn partials_on_grid(&self, us: &[P::Scalar], vs: &[P::Scalar], partials: &mut [[P; 3]]);
}

/// A surface whose patches have `N × M` control points. Those of its derivative in u have `DN = N − 1` in u, and those of its
/// derivative in v `DM = M − 1` in v.
#[derive(Clone, Debug)]
pub(super) struct FixedDegrees<S, const N: usize, const M: usize, const DN: usize, const DM: usize>
{
    axes: [Axis<S>; 2],
    points: Patches<S, N, M>,
    along_u: Patches<S, DN, M>,
    along_v: Patches<S, N, DM>,
    /// How wrong a coordinate of `[S_u, S_v]` can be, for each pair of spans.
    noise: Vec<[S; 2]>,
}

/// What is known of the points that are evaluated together: the patch of each and its place there, the weights of the patch's control
/// points, those of the derivatives' lower degrees too, and the sums over v.
struct Work<S, const N: usize, const M: usize, const DN: usize, const DM: usize> {
    patches: [usize; LANES],
    places: [Lanes<S>; 2],
    in_u: [Lanes<S>; N],
    in_v: [Lanes<S>; M],
    lower_in_u: [Lanes<S>; DN],
    lower_in_v: [Lanes<S>; DM],
    rows: Lanes<Row<S, N>>,
    lower_rows: Lanes<Row<S, DN>>,
}

/// Consecutive parameters u of a grid in the same span, with the weights of the span's control points for the points and for the
/// derivative in u.
struct Run<S, const N: usize, const DN: usize> {
    span: usize,
    columns: Range<usize>,
    weights: Vec<Block<S, N>>,
    lower_weights: Vec<Block<S, DN>>,
}

impl<S: Scalar, const N: usize, const M: usize, const DN: usize, const DM: usize>
    Work<S, N, M, DN, DM>
{
    fn new() -> Self {
        let zero = S::zero();
        Self {
            patches: [0; LANES],
            places: [[zero; LANES]; 2],
            in_u: [[zero; LANES]; N],
            in_v: [[zero; LANES]; M],
            lower_in_u: [[zero; LANES]; DN],
            lower_in_v: [[zero; LANES]; DM],
            rows: [[[zero; 3]; N]; LANES],
            lower_rows: [[[zero; 3]; DN]; LANES],
        }
    }
}

impl<S, const N: usize, const M: usize, const DN: usize, const DM: usize>
    FixedDegrees<S, N, M, DN, DM>
where
    S: Scalar + AsPrimitive<u8>,
{
    /// The surface prepared; `None` where [`Axis::new`] gives none.
    pub(super) fn new<P: Vector3<Scalar = S>>(surface: &BsplineSurface<P>) -> Option<Self> {
        let axis = |direction| Axis::new(surface.knots(direction));
        let axes = [axis(Direction::U)?, axis(Direction::V)?];
        let along_u = Patches::new(&surface.derivative_surface(Direction::U));
        let along_v = Patches::new(&surface.derivative_surface(Direction::V));
        let roundoffs = S::from_i32(count(16 * (N + M))) * S::unit_roundoff();
        let sizes = along_u.sizes().zip(along_v.sizes());
        Some(Self {
            axes,
            points: Patches::new(surface),
            noise: sizes.map(|(u, v)| [u * roundoffs, v * roundoffs]).collect(),
            along_u,
            along_v,
        })
    }

    /// Finds the patches of the parameters, and the weights of their control points.
    fn locate(&self, parameters: &[[S; 2]], work: &mut Work<S, N, M, DN, DM>) {
        let [axis_u, axis_v] = &self.axes;
        let columns = axis_u.span_count();
        let [in_u, in_v] = &mut work.places;
        let lanes = work.patches.iter_mut().zip(in_u).zip(in_v);
        for (&[u, v], ((patch, place_u), place_v)) in parameters.iter().zip(lanes) {
            let ((column, in_column), (row, in_row)) = (axis_u.locate(u), axis_v.locate(v));
            *patch = row * columns + column;
            (*place_u, *place_v) = (in_column, in_row);
        }
        bernstein_lanes(&work.places[0], &mut work.in_u);
        bernstein_lanes(&work.places[1], &mut work.in_v);
    }

    /// The sums over v for the derivative in u, and the weights to sum them with.
    fn sum_along_u(&self, count: usize, work: &mut Work<S, N, M, DN, DM>) {
        bernstein_lanes(&work.places[0], &mut work.lower_in_u);
        let patches = &work.patches[..count];
        self.along_u
            .sum_rows(patches, &work.in_v, &mut work.lower_rows);
    }

    /// The sums over v for the derivative in v.
    fn sum_along_v(&self, count: usize, work: &mut Work<S, N, M, DN, DM>) {
        bernstein_lanes(&work.places[1], &mut work.lower_in_v);
        let patches = &work.patches[..count];
        self.along_v
            .sum_rows(patches, &work.lower_in_v, &mut work.rows);
    }

    /// The parameters u of a grid.
    fn runs(&self, us: &[S]) -> Vec<Run<S, N, DN>> {
        let located: Vec<(usize, S)> = us.iter().map(|&u| self.axes[0].locate(u)).collect();
        let mut end = 0;
        let run = |run: &[(usize, S)]| {
            let start = end;
            end += run.len();
            let places: Vec<S> = run.iter().map(|&(_, place)| place).collect();
            Run {
                span: run[0].0,
                columns: start..end,
                weights: bernstein_blocks(&places),
                lower_weights: bernstein_blocks(&places),
            }
        };
        located.chunk_by(|a, b| a.0 == b.0).map(run).collect()
    }

    /// The patches along the row of v, and the place of v there.
    fn row(&self, v: S) -> (Range<usize>, S) {
        let columns = self.axes[0].span_count();
        let (row, place) = self.axes[1].locate(v);
        (row * columns..(row + 1) * columns, place)
    }
}

impl<P, const N: usize, const M: usize, const DN: usize, const DM: usize> Kernel<P>
    for FixedDegrees<P::Scalar, N, M, DN, DM>
where
    P: Vector3,
    P::Scalar: AsPrimitive<u8>,
{
    fn points(&self, parameters: &[[P::Scalar; 2]], points: &mut [P]) {
        let mut work = Work::<_, N, M, DN, DM>::new();
        let chunks = parameters.chunks(LANES).zip(points.chunks_mut(LANES));
        for (parameters, points) in chunks {
            self.locate(parameters, &mut work);
            let patches = &work.patches[..parameters.len()];
            self.points.sum_rows(patches, &work.in_v, &mut work.rows);
            sum_columns(&work.rows, &work.in_u, points, |point| point);
        }
    }

    fn tangents(
        &self,
        parameters: &[[P::Scalar; 2]],
        tangents: &mut [[P; 2]],
        noise: &mut [[P::Scalar; 2]],
    ) {
        let mut work = Work::<_, N, M, DN, DM>::new();
        let places = tangents.chunks_mut(LANES).zip(noise.chunks_mut(LANES));
        for (parameters, (tangents, noise)) in parameters.chunks(LANES).zip(places) {
            self.locate(parameters, &mut work);
            self.sum_along_u(parameters.len(), &mut work);
            sum_columns(&work.lower_rows, &work.lower_in_u, tangents, |[s_u, _]| s_u);
            self.sum_along_v(parameters.len(), &mut work);
            sum_columns(&work.rows, &work.in_u, tangents, |[_, s_v]| s_v);
            for (noise, &patch) in noise.iter_mut().zip(&work.patches) {
                *noise = self.noise[patch];
            }
        }
    }

    fn partials(&self, parameters: &[[P::Scalar; 2]], partials: &mut [[P; 3]]) {
        let mut work = Work::<_, N, M, DN, DM>::new();
        let chunks = parameters.chunks(LANES).zip(partials.chunks_mut(LANES));
        for (parameters, partials) in chunks {
            self.locate(parameters, &mut work);
            let patches = &work.patches[..parameters.len()];
            self.points.sum_rows(patches, &work.in_v, &mut work.rows);
            sum_columns(&work.rows, &work.in_u, partials, |[s, _, _]| s);
            self.sum_along_u(parameters.len(), &mut work);
            sum_columns(
                &work.lower_rows,
                &work.lower_in_u,
                partials,
                |[_, s_u, _]| s_u,
            );
            self.sum_along_v(parameters.len(), &mut work);
            sum_columns(&work.rows, &work.in_u, partials, |[_, _, s_v]| s_v);
        }
    }

    fn points_on_grid(&self, us: &[P::Scalar], vs: &[P::Scalar], points: &mut [P]) {
        let runs = self.runs(us);
        let mut line = Vec::new();
        for (points, &v) in points.chunks_exact_mut(us.len()).zip(vs) {
            let (patches, place) = self.row(v);
            self.points.sum_line(patches, bernstein(place), &mut line);
            for run in &runs {
                let points = &mut points[run.columns.clone()];
                sum_blocks(&line[run.span], &run.weights, points, |point| point);
            }
        }
    }

    fn partials_on_grid(&self, us: &[P::Scalar], vs: &[P::Scalar], partials: &mut [[P; 3]]) {
        let runs = self.runs(us);
        let [mut line, mut line_of_v] = [Vec::new(), Vec::new()];
        let mut line_of_u = Vec::new();
        for (partials, &v) in partials.chunks_exact_mut(us.len()).zip(vs) {
            let (patches, place) = self.row(v);
            let (weights, lower) = (bernstein(place), bernstein(place));
            self.points.sum_line(patches.clone(), weights, &mut line);
            self.along_u
                .sum_line(patches.clone(), weights, &mut line_of_u);
            self.along_v.sum_line(patches, lower, &mut line_of_v);
            for Run {
                span,
                columns,
                weights,
                lower_weights,
            } in &runs
            {
                let partials = &mut partials[columns.clone()];
                sum_blocks(&line[*span], weights, partials, |[s, _, _]| s);
                sum_blocks(&line_of_u[*span], lower_weights, partials, |[_, s_u, _]| {
                    s_u
                });
                sum_blocks(&line_of_v[*span], weights, partials, |[_, _, s_v]| s_v);
            }
        }
    }
}

/// Sums the row of each lane with its weights in u, and writes the sums to the places that `field` names, one for each lane in use.
#[inline]
fn sum_columns<P: Vector3, T, const N: usize>(
    rows: &Lanes<Row<P::Scalar, N>>,
    weights: &[Lanes<P::Scalar>; N],
    places: &mut [T],
    field: impl Fn(&mut T) -> &mut P,
) {
    for ((lane, row), place) in rows.iter().enumerate().zip(places) {
        let weights = weights.each_ref().map(|weights| weights[lane]);
        *field(place) = P::from_coordinates(sum_row(row, weights));
    }
}

/// Sums one row with the weights of each lane of each block, and writes the sums to the places that `field` names.
#[inline]
fn sum_blocks<P: Vector3, T, const N: usize>(
    row: &Row<P::Scalar, N>,
    blocks: &[Block<P::Scalar, N>],
    places: &mut [T],
    field: impl Fn(&mut T) -> &mut P,
) {
    let (full, rest) = places.as_chunks_mut::<BLOCK>();
    for (places, weights) in full.iter_mut().zip(blocks) {
        for (place, sum) in places.iter_mut().zip(sum_block(row, weights)) {
            *field(place) = P::from_coordinates(sum);
        }
    }
    for weights in &blocks[full.len()..] {
        for (place, sum) in rest.iter_mut().zip(sum_block(row, weights)) {
            *field(place) = P::from_coordinates(sum);
        }
    }
}
