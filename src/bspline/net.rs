//! The same surface with another net of control points: what a curve can do, done to every row or column.

use num_traits::Zero;

use super::curve::check_points;
use super::refine;
use super::{BsplineError, BsplineSurface, Direction, KnotVector};
use crate::algebra::{VectorSpace, larger};
use crate::surface::Surface;

/// One polynomial of a B-spline surface, as the Bézier patch that it is.
#[derive(Clone, Debug, PartialEq)]
pub struct BezierPatch<P: VectorSpace> {
    /// The rectangle of the B-spline's parameters that the patch's unit square stands for.
    pub domain: [[P::Scalar; 2]; 2],
    /// The degrees in u and in v.
    pub degrees: [usize; 2],
    /// The `(p + 1)(q + 1)` control points, row by row, u running fastest.
    pub control_points: Vec<P>,
}

impl<P: VectorSpace> BsplineSurface<P> {
    /// The same surface with u and v exchanged.
    #[must_use]
    pub fn transposed(&self) -> Self {
        let [in_u, in_v] = [self.knots(Direction::U), self.knots(Direction::V)];
        let knots = [in_v.clone(), in_u.clone()];
        Self::of_fitting(knots, transposed(self.control_points(), self.columns()))
    }

    /// The surface whose rows (in `direction`) come from `change`, which gives as many points for every row.
    fn with_changed_lines(
        &self,
        direction: Direction,
        knots: KnotVector<P::Scalar>,
        change: impl Fn(&KnotVector<P::Scalar>, &[P]) -> Vec<P>,
    ) -> Self {
        if direction == Direction::V {
            let turned = self.transposed();
            return turned
                .with_changed_lines(Direction::U, knots, change)
                .transposed();
        }
        let in_u = self.knots(Direction::U);
        let rows = self.control_points().chunks_exact(self.columns());
        let points = rows.flat_map(|row| change(in_u, row)).collect();
        Self::of_fitting([knots, self.knots(Direction::V).clone()], points)
    }

    /// The same surface with one more knot in one direction, by Boehm's algorithm on each line of the net.
    ///
    /// # Errors
    ///
    /// As [`KnotVector::with_knot`].
    pub fn with_knot(
        &self,
        direction: Direction,
        knot: P::Scalar,
    ) -> Result<Self, BsplineError<P::Scalar>> {
        let knots = self.knots(direction).with_knot(knot)?;
        Ok(self.with_changed_lines(direction, knots, |old, line| {
            refine::insert_knot(old, line, knot)
        }))
    }

    /// The same surface with degree one higher in one direction.
    #[must_use]
    pub fn elevated(&self, direction: Direction) -> Self {
        let knots = refine::elevated_knots(self.knots(direction));
        self.with_changed_lines(direction, knots.clone(), |old, line| {
            refine::elevate(old, line, &knots)
        })
    }

    /// The partial derivative in one direction, as the B-spline surface of degree one less that it is; zero for degree 0.
    #[must_use]
    pub fn derivative_surface(&self, direction: Direction) -> Self {
        let zeros = vec![P::origin(); self.knots(direction).control_point_count()];
        let (knots, _) = refine::derivative(self.knots(direction), &zeros);
        self.with_changed_lines(direction, knots, |old, line| {
            refine::derivative(old, line).1
        })
    }

    /// The same surface on another domain in each direction.
    ///
    /// # Errors
    ///
    /// As [`KnotVector::reparametrised`].
    pub fn reparametrised(
        &self,
        [in_u, in_v]: [[P::Scalar; 2]; 2],
    ) -> Result<Self, BsplineError<P::Scalar>> {
        let knots = [
            self.knots(Direction::U).reparametrised(in_u)?,
            self.knots(Direction::V).reparametrised(in_v)?,
        ];
        Ok(Self::of_fitting(knots, self.control_points().to_vec()))
    }

    /// The polynomials of the non-empty spans, row by row, u running fastest. Neighbours share their edge's control points bit for
    /// bit where the surface is continuous.
    pub fn bezier_patches(&self) -> Vec<BezierPatch<P>> {
        let [in_u, in_v] = [self.knots(Direction::U), self.knots(Direction::V)];
        let degrees = [in_u.degree(), in_v.degree()];
        let turned = self.transposed();
        let mut patches = Vec::new();
        for span_v in in_v.spans() {
            let columns = turned
                .control_points()
                .chunks_exact(in_v.control_point_count());
            let in_row: Vec<P> = columns
                .flat_map(|column| refine::bezier_points(in_v, column, span_v))
                .collect();
            let rows = transposed(&in_row, degrees[1] + 1);
            for span_u in in_u.spans() {
                let rows = rows.chunks_exact(self.columns());
                patches.push(BezierPatch {
                    domain: [in_u.span_interval(span_u), in_v.span_interval(span_v)],
                    degrees,
                    control_points: rows
                        .flat_map(|row| refine::bezier_points(in_u, row, span_u))
                        .collect(),
                });
            }
        }
        patches
    }

    /// The least box around the control points that count on a pair of spans, as `[lowest, highest]` coordinates: it holds that
    /// part of the surface.
    ///
    /// # Panics
    ///
    /// When one of the spans has no control points.
    pub fn span_box(&self, spans: [usize; 2]) -> [Vec<P::Scalar>; 2] {
        let [p, q] = [
            self.knots(Direction::U).degree(),
            self.knots(Direction::V).degree(),
        ];
        let mut net = vec![P::origin(); (p + 1) * (q + 1)];
        self.copy_local_net(spans, &mut net);
        let along = |axis: usize| net.iter().map(move |point| point.coordinate(axis));
        let lowest = |a: P::Scalar, b: P::Scalar| if b < a { b } else { a };
        let extreme = |choose: &dyn Fn(P::Scalar, P::Scalar) -> P::Scalar| {
            (0..P::DIMENSION)
                .map(|axis| along(axis).reduce(choose).unwrap_or_else(P::Scalar::zero))
                .collect()
        };
        [extreme(&lowest), extreme(&larger)]
    }

    /// The surface of the control points that `map` makes of its own: affine maps move the surface as they move the points.
    ///
    /// # Errors
    ///
    /// [`BsplineError::PointNotFinite`] where `map` gives an infinite or NaN coordinate.
    pub fn mapped<Q>(
        &self,
        map: impl Fn(P) -> Q,
    ) -> Result<BsplineSurface<Q>, BsplineError<Q::Scalar>>
    where
        Q: VectorSpace<Scalar = P::Scalar>,
    {
        let points: Vec<Q> = self
            .control_points()
            .iter()
            .map(|&point| map(point))
            .collect();
        check_points(&points)?;
        let knots = [
            self.knots(Direction::U).clone(),
            self.knots(Direction::V).clone(),
        ];
        Ok(BsplineSurface::of_fitting(knots, points))
    }

    /// The parameters where the surface may be less smooth: the distinct knots of the domain, in u and in v.
    pub fn breaks(&self) -> [Vec<P::Scalar>; 2] {
        let domain = self.domain();
        [Direction::U, Direction::V].map(|direction| {
            let knots = self.knots(direction);
            let starts = knots.spans().map(|span| knots.span_interval(span)[0]);
            starts.chain([domain[direction as usize][1]]).collect()
        })
    }
}

/// The points of a net with so many columns, column by column.
fn transposed<P: Copy>(points: &[P], columns: usize) -> Vec<P> {
    let column = |index: usize| points.iter().skip(index).step_by(columns).copied();
    (0..columns).flat_map(column).collect()
}
