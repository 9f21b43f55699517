//! One parameter of a prepared surface: the span of a number by a table, and its place within the span.

use std::array::from_fn;

use num_traits::AsPrimitive;

use crate::algebra::Scalar;
use crate::bspline::KnotVector;
use crate::curve::count;

/// How many equal parts the domain is cut into to find a span at once: as many as a byte can name, to which a number is converted
/// with saturation, so that a parameter outside the domain needs no case of its own.
const PARTS: usize = 256;

/// The non-empty spans of a knot vector, counted from 0.
#[derive(Clone, Debug)]
pub(super) struct Axis<S> {
    start: S,
    parts_per_unit: S,
    parts: Box<[Part<S>; PARTS]>,
    /// Where each span but the last ends.
    breaks: Vec<S>,
    spans: Vec<Span<S>>,
}

/// The span that a part of the domain starts in, and the first break in it.
#[derive(Clone, Copy, Debug)]
struct Part<S> {
    next_break: S,
    first: u32,
    last: u32,
}

/// A span: where it starts, and one over its length.
#[derive(Clone, Copy, Debug)]
struct Span<S> {
    start: S,
    inverse_length: S,
}

impl<S: Scalar + AsPrimitive<u8>> Axis<S> {
    /// The spans of `knots`; `None` where the length of one, or one over it, is not a normal number, or where they are more than
    /// 2³² − 1.
    #[allow(
        clippy::cast_possible_truncation,
        reason = "the spans are counted before their numbers become shorter"
    )]
    pub(super) fn new(knots: &KnotVector<S>) -> Option<Self> {
        let intervals: Vec<[S; 2]> = knots
            .spans()
            .map(|span| knots.span_interval(span))
            .collect();
        let spans: Option<Vec<Span<S>>> = intervals.iter().copied().map(Span::new).collect();
        u32::try_from(intervals.len()).ok()?;
        let [start, end] = knots.domain();
        let parts_per_unit = S::from_i32(count(PARTS)) / (end - start);
        let breaks: Vec<S> = intervals
            .iter()
            .skip(1)
            .map(|interval| interval[0])
            .collect();
        // Rounding keeps the order of numbers: a break whose own part comes earlier is behind every parameter of this part, and one
        // whose part comes later is ahead of all.
        let part = |number| {
            let part_of = |&u: &S| part_of(u, start, parts_per_unit);
            let first = breaks.partition_point(|u| part_of(u) < number);
            let last = breaks.partition_point(|u| part_of(u) <= number);
            let next_break = breaks.get(first).copied().unwrap_or(start);
            let [first, last] = [first, last].map(|span| span as u32);
            Part {
                next_break,
                first,
                last,
            }
        };
        Some(Self {
            start,
            parts_per_unit,
            parts: Box::new(from_fn(part)),
            breaks,
            spans: spans?,
        })
    }

    /// How many spans there are.
    pub(super) fn span_count(&self) -> usize {
        self.spans.len()
    }

    /// The span of `u`, as [`find_span`](crate::bspline::find_span) chooses it, and the place of `u` in it: from 0 at its start to 1
    /// at its end.
    #[inline]
    pub(super) fn locate(&self, u: S) -> (usize, S) {
        let part = &self.parts[part_of(u, self.start, self.parts_per_unit)];
        let [first, last] = [part.first as usize, part.last as usize];
        let is_behind = part.next_break <= u;
        let mut span = last.min(first + usize::from(is_behind));
        if last - first > 1 {
            span = self.search(first, last, u);
        }
        let Span {
            start,
            inverse_length,
        } = self.spans[span];
        (span, (u - start) * inverse_length)
    }

    /// The span of `u` in a part with several breaks.
    #[cold]
    fn search(&self, first: usize, last: usize, u: S) -> usize {
        first + self.breaks[first..last].partition_point(|&knot| knot <= u)
    }
}

/// In which part of the domain `u` lies.
#[inline]
fn part_of<S: Scalar + AsPrimitive<u8>>(u: S, start: S, parts_per_unit: S) -> usize {
    let part: u8 = ((u - start) * parts_per_unit).as_();
    usize::from(part)
}

impl<S: Scalar> Span<S> {
    /// The span of an interval; `None` where rounding takes more from `length · (1 / length)` than it takes from normal numbers.
    fn new([start, end]: [S; 2]) -> Option<Self> {
        let length = end - start;
        let inverse_length = S::one() / length;
        let miss = (length * inverse_length - S::one()).magnitude();
        let roundoff = S::unit_roundoff();
        (miss <= roundoff + roundoff).then_some(Self {
            start,
            inverse_length,
        })
    }
}
