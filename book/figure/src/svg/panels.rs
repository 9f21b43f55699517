//! Pictures and drawings side by side, with labels that stay crisp.

use super::{Anchor, Drawing, PAGE_WIDTH};
use crate::render::Picture;

/// One cell of a row or grid of panels.
#[derive(Debug, Clone, PartialEq)]
pub struct Panel {
    label: String,
    sign: Option<String>,
    content: Content,
}

#[derive(Debug, Clone, PartialEq)]
enum Content {
    Picture(Picture),
    Drawing(Drawing),
}

impl Panel {
    /// A picture with its label below it, in the markup of [`Drawing::text`].
    #[must_use]
    pub fn picture(label: &str, picture: Picture) -> Self {
        Self {
            label: label.to_string(),
            sign: None,
            content: Content::Picture(picture),
        }
    }

    /// A drawing with its label below it, in the markup of [`Drawing::text`].
    #[must_use]
    pub fn drawing(label: &str, drawing: Drawing) -> Self {
        Self {
            label: label.to_string(),
            sign: None,
            content: Content::Drawing(drawing),
        }
    }

    /// The same panel with a sign such as `+`, `−` or `=` between it and the one on its left.
    #[must_use]
    pub fn preceded_by(self, sign: &str) -> Self {
        Self {
            sign: Some(sign.to_string()),
            ..self
        }
    }

    /// The content's height over its width.
    fn aspect(&self) -> f64 {
        let [width, height] = match &self.content {
            Content::Picture(picture) => [f64::from(picture.width), f64::from(picture.height)],
            Content::Drawing(drawing) => drawing.size(),
        };
        if width > 0.0 { height / width } else { 1.0 }
    }
}

const GAP: f64 = 14.0;
const LABEL_SIZE: f64 = 16.0;
const LABEL_HEIGHT: f64 = 26.0;

/// The panels row by row in `columns` columns, over the whole width of the page.
///
/// A row is as high as its highest panel; the others are centred in it. `columns` below 1 counts as 1.
///
/// # Examples
/// ```
/// use facette_figure::svg::{Drawing, Panel, panels};
///
/// let square = Drawing::new(10.0, 10.0);
/// let row = [
///     Panel::drawing("*S*_1", square.clone()),
///     Panel::drawing("*S*_2", square).preceded_by("+"),
/// ];
/// let drawing = panels(2, &row);
/// assert_eq!(drawing.size(), [750.0, 394.0]);
/// ```
#[must_use]
pub fn panels(columns: usize, panels: &[Panel]) -> Drawing {
    let columns = columns.max(1);
    let width = (PAGE_WIDTH - GAP * (columns - 1) as f64) / columns as f64;
    let heights: Vec<f64> = panels
        .chunks(columns)
        .map(|row| row_height(row, width))
        .collect();
    let total = heights.iter().sum::<f64>() + GAP * heights.len().saturating_sub(1) as f64;
    let mut drawing = Drawing::new(PAGE_WIDTH, total);
    let mut top = 0.0;
    for (row, height) in panels.chunks(columns).zip(heights) {
        let content_height = row_content_height(row, width);
        for (column, panel) in row.iter().enumerate() {
            let left = column as f64 * (width + GAP);
            drawing = draw(drawing, panel, [left, top], [width, content_height]);
        }
        top += height + GAP;
    }
    drawing
}

fn row_content_height(row: &[Panel], width: f64) -> f64 {
    row.iter()
        .map(|panel| panel.aspect() * width)
        .fold(0.0, f64::max)
}

fn row_height(row: &[Panel], width: f64) -> f64 {
    let labelled = row.iter().any(|panel| !panel.label.is_empty());
    row_content_height(row, width) + if labelled { LABEL_HEIGHT } else { 0.0 }
}

fn draw(drawing: Drawing, panel: &Panel, [left, top]: [f64; 2], [width, row]: [f64; 2]) -> Drawing {
    let height = panel.aspect() * width;
    let corner = [left, top + (row - height) / 2.0];
    let mut drawing = match &panel.content {
        Content::Picture(picture) => drawing.picture(corner, [width, height], picture),
        Content::Drawing(inner) => drawing.drawing(corner, [width, height], inner),
    };
    if let Some(sign) = &panel.sign {
        let at = [left - GAP / 2.0, top + row / 2.0 + 0.35 * LABEL_SIZE];
        drawing = drawing.text(at, sign, 1.3 * LABEL_SIZE, Anchor::Middle);
    }
    if panel.label.is_empty() {
        return drawing;
    }
    let baseline = [left + width / 2.0, top + row + 0.72 * LABEL_HEIGHT];
    drawing.text(baseline, &panel.label, LABEL_SIZE, Anchor::Middle)
}
