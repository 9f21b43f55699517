//! The shapes of points, and the legend.

use super::{Entry, Look, TEXT_SIZE};
use crate::palette::Colour;
use crate::svg::{Anchor, Drawing, PAGE_WIDTH, Stroke, estimated_width};

/// The shape of a plotted point.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Shape {
    Disc,
    Triangle,
    Square,
    Diamond,
}

impl Shape {
    pub const ALL: [Self; 4] = [Self::Disc, Self::Triangle, Self::Square, Self::Diamond];

    /// The corners around the origin; none for a disc. All shapes have about the same area.
    fn corners(self) -> &'static [[f64; 2]] {
        match self {
            Self::Disc => &[],
            Self::Triangle => &[[0.0, -6.6], [6.2, 4.4], [-6.2, 4.4]],
            Self::Square => &[[-4.6, -4.6], [4.6, -4.6], [4.6, 4.6], [-4.6, 4.6]],
            Self::Diamond => &[[0.0, -6.6], [6.6, 0.0], [0.0, 6.6], [-6.6, 0.0]],
        }
    }
}

/// A point of this shape: filled, or its outline alone.
pub(super) fn mark(
    drawing: Drawing,
    at: [f64; 2],
    shape: Shape,
    is_filled: bool,
    colour: Colour,
) -> Drawing {
    let stroke = Stroke::new(colour, 1.8);
    if shape == Shape::Disc {
        let radius = 4.6;
        let drawing = drawing.circle(at, radius, stroke);
        return if is_filled {
            drawing.disc(at, radius, colour)
        } else {
            drawing
        };
    }
    let corners: Vec<_> = shape
        .corners()
        .iter()
        .map(|[x, y]| [at[0] + x, at[1] + y])
        .collect();
    let drawing = drawing.outline(&corners, stroke);
    if is_filled {
        drawing.area(&corners, colour, 1.0)
    } else {
        drawing
    }
}

const LEFT: f64 = 66.0;
const ROW: f64 = 22.0;
const SAMPLE: f64 = 30.0;

/// Draws the legend in rows above the plot, and returns the height it takes.
pub(super) fn legend(mut drawing: Drawing, entries: &[Entry]) -> (Drawing, f64) {
    let (mut x, mut y) = (LEFT, ROW / 2.0);
    for entry in entries {
        let width = SAMPLE + 8.0 + estimated_width(&entry.name) * TEXT_SIZE + 20.0;
        if x > LEFT && x + width > PAGE_WIDTH {
            (x, y) = (LEFT, y + ROW);
        }
        drawing = match entry.look {
            Look::Line(dashes) => {
                let stroke = Stroke::new(entry.colour, 2.2).dashes(dashes);
                drawing.line([x, y], [x + SAMPLE, y], stroke)
            }
            Look::Marks { shape, is_filled } => mark(
                drawing,
                [x + SAMPLE / 2.0, y],
                shape,
                is_filled,
                entry.colour,
            ),
        };
        let baseline = [x + SAMPLE + 6.0, y + 0.35 * TEXT_SIZE];
        drawing = drawing.text(baseline, &entry.name, TEXT_SIZE, Anchor::Start);
        x += width;
    }
    let height = if entries.is_empty() {
        0.0
    } else {
        y + ROW / 2.0
    };
    (drawing, height)
}
