//! Knot vectors: where a B-spline's pieces meet, and how smoothly.

use super::BsplineError;
use super::basis::find_span;
use crate::algebra::Scalar;
use crate::curve::count;

/// The highest degree of a knot vector: the basis takes p² steps, and loses `5p` roundoffs.
const HIGHEST_DEGREE: usize = (1 << 16) - 1;

/// A degree `p` and the knots `u₀ <= u₁ <= … <= u_r` of a B-spline.
///
/// # Shape
///
/// `r + 1 = n + p + 2` knots carry `n + 1` basis functions. A knot stands at most `p + 1` times; the domain `[uₚ, uₙ₊₁]` is not
/// empty.
///
/// # Examples
///
/// ```
/// use facette::bspline::KnotVector;
///
/// let u = KnotVector::clamped(3, &[0.0, 0.25, 0.5, 0.75, 1.0])?;
/// assert_eq!(u.knots(), [0., 0., 0., 0., 0.25, 0.5, 0.75, 1., 1., 1., 1.]);
/// assert_eq!((u.control_point_count(), u.domain()), (7, [0.0, 1.0]));
/// # Ok::<(), facette::bspline::BsplineError<f64>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct KnotVector<S> {
    degree: usize,
    knots: Vec<S>,
    /// The first and the last span of the domain that is not empty.
    end_spans: [usize; 2],
    /// Whether a difference of two knots can overflow.
    is_wide: bool,
}

impl<S: Scalar> KnotVector<S> {
    /// The knot vector of these knots.
    ///
    /// # Errors
    ///
    /// [`BsplineError::TooLarge`] above degree 65535, [`BsplineError::TooFewKnots`], [`BsplineError::KnotNotFinite`], [`BsplineError::KnotsDecrease`],
    /// [`BsplineError::MultiplicityTooHigh`] and [`BsplineError::EmptyDomain`] as they say, for the first knot at fault.
    pub fn new(degree: usize, knots: Vec<S>) -> Result<Self, BsplineError<S>> {
        check_degree(degree)?;
        let needed = 2 * (degree + 1);
        let found = knots.len();
        if found < needed {
            return Err(BsplineError::TooFewKnots {
                degree,
                needed,
                found,
            });
        }
        check_order(degree, &knots)?;
        let [first, last] = [degree, found - degree - 1];
        let [start, end] = [knots[first], knots[last]];
        let is_not_empty = |&span: &usize| knots[span] < knots[span + 1];
        let end_spans = [
            (first..last).find(is_not_empty),
            (first..last).rev().find(is_not_empty),
        ];
        let [Some(first_span), Some(last_span)] = end_spans else {
            return Err(BsplineError::EmptyDomain {
                first,
                last,
                start,
                end,
            });
        };
        let is_wide = !Scalar::is_finite(knots[found - 1] - knots[0]);
        Ok(Self {
            degree,
            knots,
            end_spans: [first_span, last_span],
            is_wide,
        })
    }

    /// The knots `breaks`, of which the first and the last are repeated until they stand `p + 1` times: the B-spline then starts
    /// and ends on a control point.
    ///
    /// # Errors
    ///
    /// As [`KnotVector::new`], whose indices count the repeated knots too.
    pub fn clamped(degree: usize, breaks: &[S]) -> Result<Self, BsplineError<S>> {
        check_degree(degree)?;
        let (Some(&first), Some(&last)) = (breaks.first(), breaks.last()) else {
            return Self::new(degree, Vec::new());
        };
        let ends = [first, last].map(|end| std::iter::repeat_n(end, degree));
        let [before, after] = ends;
        Self::new(
            degree,
            before.chain(breaks.iter().copied()).chain(after).collect(),
        )
    }

    /// The clamped knots on `[0, 1]` with spans of equal length, for so many control points.
    ///
    /// # Errors
    ///
    /// [`BsplineError::TooFewKnots`] where there are not more control points than the degree says, [`BsplineError::TooLarge`] for a degree
    /// above 65535 or more control points than 32 bits count.
    pub fn clamped_uniform(degree: usize, control_points: usize) -> Result<Self, BsplineError<S>> {
        let spans = spans_for(degree, control_points)?;
        let breaks: Vec<S> = (0..=spans).map(|index| S::ratio(index, spans)).collect();
        Self::clamped(degree, &breaks)
    }

    /// The integers from `−p` on, for so many control points: the domain `[0, n + 1 − p]` with spans of length 1.
    ///
    /// # Errors
    ///
    /// As [`KnotVector::clamped_uniform`].
    pub fn uniform(degree: usize, control_points: usize) -> Result<Self, BsplineError<S>> {
        let spans = spans_for(degree, control_points)?;
        let degree_number = count(degree);
        let knots = (-degree_number..=spans + degree_number).map(S::from_i32);
        Self::new(degree, knots.collect())
    }

    /// The knots `breaks` of one period, with `p` knots on either side that continue them: their spacings are those at the
    /// other end. With `n + 1 = (breaks.len() − 1) + p` control points of which the last `p` repeat the first, the B-spline closes.
    ///
    /// # Errors
    ///
    /// As [`KnotVector::new`].
    pub fn periodic(degree: usize, breaks: &[S]) -> Result<Self, BsplineError<S>> {
        check_degree(degree)?;
        let spans = count(breaks.len().saturating_sub(1));
        let (Some(&first), Some(&last), 1..) = (breaks.first(), breaks.last(), spans) else {
            return Self::new(degree, breaks.to_vec());
        };
        let period = last - first;
        let knot = |index: i32| {
            if (0..=spans).contains(&index) {
                return breaks[index.unsigned_abs() as usize];
            }
            let inside = breaks[index.rem_euclid(spans).unsigned_abs() as usize];
            inside + period * S::from_i32(index.div_euclid(spans))
        };
        let around = count(degree);
        Self::new(degree, (-around..=spans + around).map(knot).collect())
    }

    /// The knots `{0, …, 0, 1, …, 1}`, `p + 1` of each: the basis is Bernstein's.
    ///
    /// # Panics
    ///
    /// Above degree 65535.
    pub fn bezier(degree: usize) -> Self {
        assert!(
            degree <= HIGHEST_DEGREE,
            "degree {degree}: at most {HIGHEST_DEGREE} is possible"
        );
        let ends = [S::zero(), S::one()];
        let knots = ends
            .into_iter()
            .flat_map(|end| std::iter::repeat_n(end, degree + 1));
        Self {
            degree,
            knots: knots.collect(),
            end_spans: [degree; 2],
            is_wide: false,
        }
    }

    /// The degree `p`.
    pub fn degree(&self) -> usize {
        self.degree
    }

    /// The knots, `n + p + 2` of them.
    pub fn knots(&self) -> &[S] {
        &self.knots
    }

    /// The number `n + 1` of basis functions, and so of control points.
    pub fn control_point_count(&self) -> usize {
        self.knots.len() - self.degree - 1
    }

    /// The domain `[uₚ, uₙ₊₁]`, where the basis functions sum to 1.
    pub fn domain(&self) -> [S; 2] {
        [
            self.knots[self.degree],
            self.knots[self.control_point_count()],
        ]
    }

    /// How often `u` stands among the knots; 0 for a number that is none of them.
    pub fn multiplicity(&self, u: S) -> usize {
        let first = self.knots.partition_point(|&knot| knot < u);
        self.knots[first..].iter().take_while(|&&k| k == u).count()
    }

    /// The distinct knots in order, each with its multiplicity.
    pub fn multiplicities(&self) -> Vec<(S, usize)> {
        let groups = self.knots.chunk_by(|a, b| a == b);
        groups.map(|group| (group[0], group.len())).collect()
    }

    /// The spans `i` of the domain with `uᵢ < uᵢ₊₁`, in order.
    pub fn spans(&self) -> impl Iterator<Item = usize> {
        let [first, last] = self.end_spans;
        (first..=last).filter(|&span| self.knots[span] < self.knots[span + 1])
    }

    /// The interval `[uᵢ, uᵢ₊₁]` of a span.
    ///
    /// # Panics
    ///
    /// When there is no such span.
    pub fn span_interval(&self, span: usize) -> [S; 2] {
        [self.knots[span], self.knots[span + 1]]
    }

    /// Greville's abscissae, `(uᵢ₊₁ + … + uᵢ₊ₚ) / p` for each control point: control points with these heights draw the
    /// straight line. At degree 0, where there is no mean, the middles of the spans.
    ///
    /// # Accuracy
    ///
    /// Within `(2p + 1)u` of the largest of the knots; where a sum of knots overflows, infinite.
    pub fn greville_abscissae(&self) -> Vec<S> {
        let means_of = |window: &[S]| {
            let inverse = S::ratio(1, count(window.len()));
            window
                .iter()
                .fold(S::zero(), |sum, &knot| sum + knot * inverse)
        };
        if self.degree == 0 {
            return self.knots.windows(2).map(means_of).collect();
        }
        let inner = &self.knots[1..self.knots.len() - 1];
        inner.windows(self.degree).map(means_of).collect()
    }

    /// The knots moved and stretched so that the domain becomes `[start, end]`: the same curve, run through at another speed.
    ///
    /// # Accuracy
    ///
    /// The ends of the domain come out exactly; knots that coincide still do.
    ///
    /// # Errors
    ///
    /// [`BsplineError::UnusableDomain`] where the new ends are not finite and increasing; as [`KnotVector::new`] where
    /// rounding makes too many knots coincide.
    pub fn reparametrised(&self, [start, end]: [S; 2]) -> Result<Self, BsplineError<S>> {
        let is_usable = start < end && [start, end].into_iter().all(Scalar::is_finite);
        if !is_usable {
            return Err(BsplineError::UnusableDomain { start, end });
        }
        let old = self.domain();
        let mut knots: Vec<S> = Vec::with_capacity(self.knots.len());
        for &knot in &self.knots {
            let [falling, rising] = self.weights(knot, old);
            let moved = start * falling + end * rising;
            // Rounding must not exchange neighbours, nor push them over the end.
            let bounded = if knot <= old[1] && moved > end {
                end
            } else {
                moved
            };
            let previous = knots.last().copied().unwrap_or(bounded);
            knots.push(if bounded < previous {
                previous
            } else {
                bounded
            });
        }
        Self::new(self.degree, knots)
    }

    /// The knots with one more at `u`.
    ///
    /// # Errors
    ///
    /// [`BsplineError::OutsideDomain`] for a knot outside the domain, [`BsplineError::MultiplicityTooHigh`] where it would stand
    /// more than `p + 1` times.
    pub fn with_knot(&self, u: S) -> Result<Self, BsplineError<S>> {
        let [start, end] = self.domain();
        if !(start <= u && u <= end) {
            return Err(BsplineError::OutsideDomain {
                parameter: u,
                start,
                end,
            });
        }
        let mut knots = self.knots.clone();
        knots.insert(find_span(self, u) + 1, u);
        Self::new(self.degree, knots)
    }

    /// The first and the last non-empty span of the domain.
    pub(super) fn end_spans(&self) -> [usize; 2] {
        self.end_spans
    }

    /// The weights `[(b − u) / (b − a), (u − a) / (b − a)]` of the ends of `[a, b]` at `u`.
    ///
    /// # Accuracy
    ///
    /// Each has a relative error of at most 3u. Where `b − a` would overflow, both operands are halved first.
    #[inline]
    pub(super) fn weights(&self, u: S, [a, b]: [S; 2]) -> [S; 2] {
        if self.is_wide && !Scalar::is_finite(b - a) {
            return halved_weights(u, [a, b]);
        }
        let width = b - a;
        [(b - u) / width, (u - a) / width]
    }
}

/// As [`KnotVector::weights`], for an interval whose length overflows.
#[cold]
fn halved_weights<S: Scalar>(u: S, ends: [S; 2]) -> [S; 2] {
    let half = S::ratio(1, 2);
    let [u, a, b] = [u * half, ends[0] * half, ends[1] * half];
    let width = b - a;
    [(b - u) / width, (u - a) / width]
}

/// The number of spans of equal length that give so many control points.
fn spans_for<S>(degree: usize, control_points: usize) -> Result<i32, BsplineError<S>> {
    check_degree(degree)?;
    if control_points <= degree {
        return Err(BsplineError::TooFewKnots {
            degree,
            needed: 2 * (degree + 1),
            found: degree + control_points + 1,
        });
    }
    // The largest knot is counted in 32 bits, the degree beside it.
    let allowed = i32::MAX as usize - HIGHEST_DEGREE;
    if control_points > allowed {
        return Err(BsplineError::TooLarge {
            what: "number of control points",
            found: control_points,
            allowed,
        });
    }
    Ok(count(control_points - degree))
}

/// Refuses degrees that no computation could use.
fn check_degree<S>(degree: usize) -> Result<(), BsplineError<S>> {
    if degree <= HIGHEST_DEGREE {
        return Ok(());
    }
    Err(BsplineError::TooLarge {
        what: "degree",
        found: degree,
        allowed: HIGHEST_DEGREE,
    })
}

/// Checks that the knots are finite, do not decrease, and stand at most `degree + 1` times.
fn check_order<S: Scalar>(degree: usize, knots: &[S]) -> Result<(), BsplineError<S>> {
    let mut first_equal = 0;
    for (index, &value) in knots.iter().enumerate() {
        if !Scalar::is_finite(value) {
            return Err(BsplineError::KnotNotFinite { index, value });
        }
        let previous = knots[index.saturating_sub(1)];
        if value < previous {
            return Err(BsplineError::KnotsDecrease {
                index,
                previous,
                value,
            });
        }
        if value > previous {
            first_equal = index;
        }
        if index - first_equal > degree {
            let equal = knots[first_equal..].iter().take_while(|&&k| k == value);
            return Err(BsplineError::MultiplicityTooHigh {
                index: first_equal,
                value,
                multiplicity: equal.count(),
                degree,
                allowed: degree + 1,
            });
        }
    }
    Ok(())
}
