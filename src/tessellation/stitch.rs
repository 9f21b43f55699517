//! The inside of a piece: how it is filled, chains of vertices zipped together, sides divided.

use super::TessellationError;
use super::cells::number;
use super::refine::Whole;
use crate::algebra::Scalar;

/// How a piece is filled with triangles.
#[derive(Clone, Copy, Debug)]
pub(super) enum Fill {
    /// Between its lower and its upper side.
    AlongU,
    /// Between its right and its left side.
    AlongV,
    /// With a grid of so many columns and rows, both at least 2.
    Grid([u32; 2]),
}

/// The inside of a piece.
#[derive(Clone, Copy, Debug)]
pub(super) struct Inner<S> {
    /// How it is filled.
    pub fill: Fill,
    /// What is known of the piece.
    pub whole: Whole<S>,
}

impl<S> Inner<S> {
    /// The inside of a piece that needs so many columns and rows, between sides (bottom, right, top, left) of so many segments.
    pub fn new(
        [columns, rows]: [u32; 2],
        [bottom, right, top, left]: [u32; 4],
        whole: Whole<S>,
    ) -> Self {
        let fill = if rows == 1 && right == 1 && left == 1 {
            Fill::AlongU
        } else if columns == 1 && bottom == 1 && top == 1 {
            Fill::AlongV
        } else {
            Fill::Grid([columns.max(2), rows.max(2)])
        };
        Self { fill, whole }
    }

    /// How many vertices it has, those of the sides not counted.
    pub fn vertices(&self) -> u64 {
        match self.fill {
            Fill::AlongU | Fill::AlongV => 0,
            Fill::Grid([columns, rows]) => u64::from(columns - 1) * u64::from(rows - 1),
        }
    }
}

/// The triangles between two chains of vertices, the second on the left of the first, that run the same way; `position` rises along both.
///
/// The next triangle stands on the chain whose next segment has the lower middle.
// ANCHOR: zipped
pub(super) fn zipped<S: Scalar>(
    right: &[u32],
    left: &[u32],
    position: impl Fn(u32) -> S,
) -> Vec<[u32; 3]> {
    let middle = |chain: &[u32], at: usize| {
        let ends = [chain.get(at), chain.get(at + 1)];
        let [Some(&start), Some(&end)] = ends else {
            return None;
        };
        Some(position(start) * S::ratio(1, 2) + position(end) * S::ratio(1, 2))
    };
    let [mut r, mut l] = [0, 0];
    let mut triangles = Vec::new();
    loop {
        let on_the_right = match (middle(right, r), middle(left, l)) {
            (Some(a), Some(b)) => a <= b,
            (Some(_), None) => true,
            (None, Some(_)) => false,
            (None, None) => return triangles,
        };
        if on_the_right {
            triangles.push([right[r], right[r + 1], left[l]]);
            r += 1;
        } else {
            triangles.push([right[r], left[l + 1], left[l]]);
            l += 1;
        }
    }
}
// ANCHOR_END: zipped

/// The parameters that divide a side of the rectangle into equal segments, without its ends.
pub(super) fn division<S: Scalar>(
    rectangle: [[S; 2]; 2],
    direction: usize,
    segments: u32,
) -> Result<Vec<S>, TessellationError<S>> {
    let [start, end] = rectangle[direction];
    let parameter = |step: u32| {
        let t = number::<S>(step) / number(segments);
        start * (S::one() - t) + end * t
    };
    let inner: Vec<S> = (1..segments).map(parameter).collect();
    let mut before = start;
    for &next in inner.iter().chain([&end]) {
        if next > before {
            before = next;
        } else {
            let mut at = rectangle.map(|[start, _]| start);
            at[direction] = before;
            return Err(TessellationError::ParametersTooClose { at });
        }
    }
    Ok(inner)
}

/// The bounds, where they are finite and not negative.
pub(super) fn usable<S: Scalar>(
    bounds: [S; 3],
    rectangle: [[S; 2]; 2],
) -> Result<[S; 3], TessellationError<S>> {
    let is_usable = |bound: &S| *bound >= S::zero() && bound.is_finite();
    if bounds.iter().all(is_usable) {
        Ok(bounds)
    } else {
        Err(TessellationError::Bounds { rectangle, bounds })
    }
}

/// An index as the meshes store it; plans of more than 2³² vertices are refused before.
pub(super) fn vertex_number(index: usize) -> u32 {
    u32::try_from(index).unwrap_or(u32::MAX)
}
