//! What keeps data from being a B-spline.

use std::fmt;

use thiserror::Error;

/// One of the two parameters of a surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Direction {
    /// The first parameter, with the index i of the control points.
    U,
    /// The second parameter, with the index j.
    V,
}

impl fmt::Display for Direction {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(match self {
            Self::U => "u",
            Self::V => "v",
        })
    }
}

/// What is wrong with knots, control points, or what is asked of them.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum BsplineError<S> {
    /// A degree or a number of control points is larger than any use.
    #[error("{what} {found}: at most {allowed} is possible")]
    TooLarge {
        /// What is too large.
        what: &'static str,
        /// How large it is.
        found: usize,
        /// How large it may be.
        allowed: usize,
    },
    /// There are not enough knots for one span.
    #[error("{found} knots of degree {degree}: at least 2 (p + 1) = {needed} are needed")]
    TooFewKnots {
        /// The degree.
        degree: usize,
        /// How many knots it needs.
        needed: usize,
        /// How many there are.
        found: usize,
    },
    /// A knot is infinite or NaN.
    #[error("knot {index} is {value:?}: every knot must be finite")]
    KnotNotFinite {
        /// Which knot, counted from 0.
        index: usize,
        /// The knot.
        value: S,
    },
    /// A knot is smaller than the one before.
    #[error(
        "knot {index} is {value:?}, less than the {previous:?} before it: knots must not decrease"
    )]
    KnotsDecrease {
        /// Which knot, counted from 0.
        index: usize,
        /// The knot before.
        previous: S,
        /// The knot.
        value: S,
    },
    /// A knot is repeated more often than p + 1 times.
    #[error(
        "the knot {value:?} stands {multiplicity} times, from knot {index} on: degree {degree} allows p + 1 = {allowed}"
    )]
    MultiplicityTooHigh {
        /// Where the first of the equal knots stands, counted from 0.
        index: usize,
        /// The knot.
        value: S,
        /// How often it stands there.
        multiplicity: usize,
        /// The degree.
        degree: usize,
        /// How often it may stand there.
        allowed: usize,
    },
    /// The domain has no length.
    #[error(
        "the domain [u_p, u_(n+1)] = [{start:?}, {end:?}] of knots {first} to {last} is empty: its end must be larger \
         than its start"
    )]
    EmptyDomain {
        /// The index p of the start.
        first: usize,
        /// The index n + 1 of the end.
        last: usize,
        /// The start.
        start: S,
        /// The end.
        end: S,
    },
    /// The control points of a curve are not as many as the knots ask for.
    #[error(
        "{knots} knots and degree p = {degree} ask for {expected} control points (r = n + p + 1, with r + 1 knots and n + 1 \
         points), but there are {found}"
    )]
    WrongPointCount {
        /// How many knots there are.
        knots: usize,
        /// The degree.
        degree: usize,
        /// How many control points they ask for.
        expected: usize,
        /// How many there are.
        found: usize,
    },
    /// The control points of a surface are not as many as the two knot vectors ask for.
    #[error(
        "{} x {} knots of degrees p = {} and q = {} ask for a net of {} x {} control points (r = n + p + 1, s = m + q + 1), \
         but there are {found}", knots[0], knots[1], degrees[0], degrees[1], expected[0], expected[1]
    )]
    WrongNetSize {
        /// How many knots there are, in u and in v.
        knots: [usize; 2],
        /// The degrees p and q.
        degrees: [usize; 2],
        /// How many control points they ask for, in u and in v.
        expected: [usize; 2],
        /// How many control points there are.
        found: usize,
    },
    /// A control point is infinite or NaN.
    #[error("control point {index} is {point}: every coordinate must be finite")]
    PointNotFinite {
        /// Which point, counted from 0.
        index: usize,
        /// The point as text.
        point: String,
    },
    /// A parameter lies outside the domain where it must not.
    #[error("the parameter {parameter:?} lies outside the domain [{start:?}, {end:?}]")]
    OutsideDomain {
        /// The parameter.
        parameter: S,
        /// Where the domain starts.
        start: S,
        /// Where it ends.
        end: S,
    },
    /// A new domain has no length, or is not finite.
    #[error("[{start:?}, {end:?}] is no domain: both ends must be finite, and the second larger")]
    UnusableDomain {
        /// Its start.
        start: S,
        /// Its end.
        end: S,
    },
    /// A knot vector that is to refine another has another degree.
    #[error(
        "the knots that are to be finer have degree {found}, those of the curve {needed}: both must be the same"
    )]
    OtherDegree {
        /// The degree of the curve.
        needed: usize,
        /// The degree of the other knots.
        found: usize,
    },
    /// A knot vector that is to refine another has another domain.
    #[error(
        "the knots that are to be finer have the domain {found:?}, those of the curve {needed:?}: both must be the same"
    )]
    OtherDomain {
        /// The domain of the curve.
        needed: [S; 2],
        /// The domain of the other knots.
        found: [S; 2],
    },
    /// A knot vector does not refine another.
    #[error(
        "the knot {knot:?} stands {found} times in the knots that are to be finer: at least {needed} times, as in those of \
         the curve, is needed"
    )]
    NotFiner {
        /// The knot.
        knot: S,
        /// How often it must stand there.
        needed: usize,
        /// How often it does.
        found: usize,
    },
    /// A knot that is to be removed is not an inner knot.
    #[error(
        "{knot:?} is not a knot between the ends of the domain: only such a knot can be removed"
    )]
    NoInnerKnot {
        /// The value in question.
        knot: S,
    },
    /// A knot cannot be removed without changing the curve.
    #[error(
        "without the knot {knot:?} the control points would move by {distance:?}, where the tolerance is {tolerance:?}"
    )]
    KnotNotRemovable {
        /// The knot.
        knot: S,
        /// The largest change of a coordinate of a control point.
        distance: S,
        /// The largest change that is allowed.
        tolerance: S,
    },
}
