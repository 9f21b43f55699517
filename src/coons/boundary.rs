//! Four curves that meet in four corners.

use std::fmt;

use thiserror::Error;

use crate::algebra::{Scalar, VectorSpace};
use crate::curve::Curve;

/// So many unit roundoffs of the largest coordinate may lie between two curves that count as meeting.
///
/// A Bézier curve ends exactly on its control points; an end that is computed, as by a closure with sines and products of
/// the size of the result, may be off by the roundoffs of some thirty operations. Two such ends: 60, rounded up to a power
/// of two so that the product with a roundoff is exact. Where more has been lost, the caller knows how much, and says so
/// ([`Boundary::with_tolerance`]).
pub(super) const ROUNDOFFS_OF_A_GAP: i32 = 64;

/// A corner of a patch.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Corner {
    /// `u = 0, v = 0`.
    A,
    /// `u = 1, v = 0`.
    B,
    /// `u = 1, v = 1`.
    C,
    /// `u = 0, v = 1`.
    D,
}

impl fmt::Display for Corner {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Debug::fmt(self, formatter)
    }
}

/// One value for each corner: `a` at (0, 0), `b` at (1, 0), `c` at (1, 1), `d` at (0, 1).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Corners<P> {
    /// At u = 0, v = 0.
    pub a: P,
    /// At u = 1, v = 0.
    pub b: P,
    /// At u = 1, v = 1.
    pub c: P,
    /// At u = 0, v = 1.
    pub d: P,
}

/// What keeps given curves from bounding a patch.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum CoonsError<P: VectorSpace> {
    /// A curve does not run over `[0, 1]`.
    #[error("the curve {curve} runs over [{start:?}, {end:?}], where a patch needs [0, 1]")]
    DomainIsNotUnit {
        /// Which curve.
        curve: &'static str,
        /// Its first parameter.
        start: P::Scalar,
        /// Its last parameter.
        end: P::Scalar,
    },
    /// A value at a corner is infinite or NaN.
    #[error("{what} is {value:?}: every coordinate must be finite")]
    NotFinite {
        /// Which value, for example `P1(0)`.
        what: &'static str,
        /// The value.
        value: P,
    },
    /// Two values that must agree at a corner do not.
    #[error(
        "at corner {corner}, {first} = {first_value:?} and {second} = {second_value:?} must agree, but are {gap:?} \
         apart, where the tolerance is {tolerance:?}"
    )]
    DoNotMeet {
        /// Which corner.
        corner: Corner,
        /// The first value's name, for example `P1(1)`.
        first: &'static str,
        /// The first value.
        first_value: P,
        /// The second value's name, for example `Q2(0)`.
        second: &'static str,
        /// The second value.
        second_value: P,
        /// The largest difference of a coordinate.
        gap: P::Scalar,
        /// The largest difference that is allowed.
        tolerance: P::Scalar,
    },
    /// A curve has no derivative where one is needed.
    #[error(
        "the derivative of {curve} is not known at {parameter:?}, but smooth blending needs it"
    )]
    DerivativeUnknown {
        /// Which curve.
        curve: &'static str,
        /// Where.
        parameter: P::Scalar,
    },
}

/// A value with the name by which an error calls it.
pub(super) type Named<P> = (&'static str, P);

/// Two values that must agree at a corner.
pub(super) type Meeting<P> = (Corner, Named<P>, Named<P>);

/// Checks that all values are finite and that those of each meeting agree within the tolerance; by default
/// [`ROUNDOFFS_OF_A_GAP`] roundoffs of the largest coordinate of them all, and of the data from which they come.
pub(super) fn check_meetings<P: VectorSpace>(
    meetings: &[Meeting<P>],
    data: &[P],
    tolerance: Option<P::Scalar>,
) -> Result<(), CoonsError<P>> {
    let larger = |a: P::Scalar, b: P::Scalar| if b > a { b } else { a };
    let sizes = data.iter().map(|vector| vector.largest_coordinate());
    let mut largest = sizes.fold(P::Scalar::from_i32(0), larger);
    for &(what, value) in meetings
        .iter()
        .flat_map(|(_, first, second)| [first, second])
    {
        if !value.has_finite_coordinates() {
            return Err(CoonsError::NotFinite { what, value });
        }
        largest = larger(largest, value.largest_coordinate());
    }
    let allowed = P::Scalar::from_i32(ROUNDOFFS_OF_A_GAP) * P::Scalar::unit_roundoff() * largest;
    let tolerance = tolerance.unwrap_or(allowed);
    for &(corner, (first, first_value), (second, second_value)) in meetings {
        let gap = first_value.minus(second_value).largest_coordinate();
        let meet = gap <= tolerance;
        if !meet {
            return Err(CoonsError::DoNotMeet {
                corner,
                first,
                first_value,
                second,
                second_value,
                gap,
                tolerance,
            });
        }
    }
    Ok(())
}

pub(super) fn check_domain<C: Curve>(
    name: &'static str,
    curve: &C,
) -> Result<(), CoonsError<C::Point>> {
    let [start, end] = curve.domain();
    if start == C::Scalar::from_i32(0) && end == C::Scalar::from_i32(1) {
        return Ok(());
    }
    Err(CoonsError::DomainIsNotUnit {
        curve: name,
        start,
        end,
    })
}

/// Four curves that bound a patch, checked to meet:
///
/// ```text
/// P1(0) = A = Q1(0)     P1(1) = B = Q2(0)     Q2(1) = C = P2(1)     Q1(1) = D = P2(0)
/// ```
///
/// # Edge cases
///
/// Where two curves meet only up to the tolerance, the corner is the end of `P1` or `P2`: a patch then takes `Q1` and
/// `Q2` exactly, and misses `P1` and `P2` by no more than the gap.
#[derive(Clone, Debug)]
pub struct Boundary<C: Curve> {
    p1: C,
    p2: C,
    q1: C,
    q2: C,
    corners: Corners<C::Point>,
}

impl<C: Curve> Boundary<C> {
    /// The boundary of four curves that meet up to rounding: 64 unit roundoffs of the largest coordinate of a corner.
    ///
    /// # Errors
    ///
    /// [`CoonsError::DomainIsNotUnit`] for a curve that does not run over `[0, 1]`, [`CoonsError::NotFinite`] for an end
    /// that is infinite or NaN, [`CoonsError::DoNotMeet`] with the corner and the gap.
    pub fn new(p1: C, p2: C, q1: C, q2: C) -> Result<Self, CoonsError<C::Point>> {
        Self::checked([p1, p2, q1, q2], None)
    }

    /// The boundary of four curves whose ends lie at most `tolerance` apart in each coordinate, in the unit of the
    /// coordinates, `0 <= tolerance`.
    ///
    /// # Errors
    ///
    /// As [`Boundary::new`]; a tolerance that is negative or NaN lets nothing meet.
    pub fn with_tolerance(
        curves: [C; 4],
        tolerance: C::Scalar,
    ) -> Result<Self, CoonsError<C::Point>> {
        Self::checked(curves, Some(tolerance))
    }

    fn checked(
        [p1, p2, q1, q2]: [C; 4],
        tolerance: Option<C::Scalar>,
    ) -> Result<Self, CoonsError<C::Point>> {
        for (name, curve) in [("P1", &p1), ("P2", &p2), ("Q1", &q1), ("Q2", &q2)] {
            check_domain(name, curve)?;
        }
        let ends = [C::Scalar::from_i32(0), C::Scalar::from_i32(1)];
        let [[a, b], [d, c]] = [&p1, &p2].map(|curve| ends.map(|end| curve.point(end)));
        let [[q1_start, q1_end], [q2_start, q2_end]] =
            [&q1, &q2].map(|curve| ends.map(|end| curve.point(end)));
        let meetings = [
            (Corner::A, ("P1(0)", a), ("Q1(0)", q1_start)),
            (Corner::B, ("P1(1)", b), ("Q2(0)", q2_start)),
            (Corner::C, ("P2(1)", c), ("Q2(1)", q2_end)),
            (Corner::D, ("P2(0)", d), ("Q1(1)", q1_end)),
        ];
        check_meetings(&meetings, &[], tolerance)?;
        Ok(Self {
            p1,
            p2,
            q1,
            q2,
            corners: Corners { a, b, c, d },
        })
    }

    /// The edge v = 0, from A to B.
    pub fn p1(&self) -> &C {
        &self.p1
    }

    /// The edge v = 1, from D to C.
    pub fn p2(&self) -> &C {
        &self.p2
    }

    /// The edge u = 0, from A to D.
    pub fn q1(&self) -> &C {
        &self.q1
    }

    /// The edge u = 1, from B to C.
    pub fn q2(&self) -> &C {
        &self.q2
    }

    /// The four corners, taken from `P1` and `P2`.
    pub fn corners(&self) -> Corners<C::Point> {
        self.corners
    }
}
