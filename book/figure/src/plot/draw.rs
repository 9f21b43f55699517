//! The parts of a plot that are laid over its axes.

use super::axis::Axis;
use super::marks::mark;
use super::{Look, SCALE, Series, TEXT_SIZE};
use crate::palette::Colour;
use crate::svg::{Anchor, Drawing, Stroke};

/// Where values lie in the drawing.
pub(super) struct Frame {
    pub axes: [Axis; 2],
    /// Left, right, top, bottom.
    pub area: [f64; 4],
}

impl Frame {
    pub fn place(&self, point: [f64; 2]) -> [f64; 2] {
        let [left, right, top, bottom] = self.area;
        let [across, up] = [0, 1].map(|which| self.axes[which].fraction(point[which]));
        [left + across * (right - left), bottom + up * (top - bottom)]
    }
}

pub(super) fn draw_series(drawing: Drawing, series: &Series, frame: &Frame) -> Drawing {
    let places: Vec<[f64; 2]> = series
        .points
        .iter()
        .map(|&point| frame.place(point))
        .collect();
    match series.look {
        Look::Line(dashes) => {
            drawing.polyline(&places, Stroke::new(series.colour, 2.2).dashes(dashes))
        }
        Look::Marks { shape, is_filled } => places.iter().fold(drawing, |drawing, &place| {
            mark(drawing, place, shape, is_filled, series.colour)
        }),
    }
}

#[allow(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "a length of a drawing, some hundred units; a cast saturates"
)]
pub(super) fn enlarged(length: f64) -> u32 {
    (length * f64::from(SCALE)).round() as u32
}

/// The elements of plotters' document, scaled down, in ink, in the page's font.
pub(super) fn follow_theme(document: &str) -> String {
    let inner = document.split_once('>').map_or("", |(_, rest)| rest);
    let inner = inner.trim().trim_end_matches("</svg>").trim();
    let inked = inner
        .replace("#000000", "currentColor")
        .replace(" font-family=\"sans-serif\"", "")
        .replace(" opacity=\"1\"", "");
    format!(
        "<g transform=\"scale({})\">\n{inked}\n</g>",
        1.0 / f64::from(SCALE)
    )
}

/// The place of the value 0 on a logarithmic x-axis: shaded, and named "0 (exact)" below.
pub(super) fn draw_zero(drawing: Drawing, frame: &Frame) -> Drawing {
    let Some(reserved) = frame.axes[0].reserved() else {
        return drawing;
    };
    let [left, right, top, bottom] = frame.area;
    let end = left + reserved * (right - left);
    let corners = [[left, top], [end, top], [end, bottom], [left, bottom]];
    drawing.area(&corners, Colour::Faint, 0.18).text(
        [f64::midpoint(left, end), bottom + 9.0 + 0.8 * TEXT_SIZE],
        "0 (exact)",
        TEXT_SIZE,
        Anchor::Middle,
    )
}
