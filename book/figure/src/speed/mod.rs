//! The scatter plot of speed against error, from the CSV file that the example `speed_against_error` writes.
//!
//! One panel a quantity. Across, the largest absolute error, with a place of its own for exact results; up, the time of
//! an evaluation: the lower left corner wins. The shape of a point is its scalar type; filled points are typical
//! inputs, hollow ones hard inputs, and a dotted line joins the two of one algorithm. A row without error (a yardstick
//! such as writing the output once) becomes a horizontal guide.

mod table;

use std::fmt;

use table::{Inputs, Row};

use crate::palette::{Colour, SERIES};
use crate::plot::{Look, Plot, PlotError, Shape};
use crate::svg::{Anchor, Dashes, Drawing, PAGE_WIDTH};
use crate::{Content, Figure};

/// Why a report cannot be drawn.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum SpeedError {
    /// A line of the file is not what it should be.
    Line {
        /// The number of the line, from 1.
        line: usize,
        /// What is wrong, and what was expected.
        message: String,
    },
    /// The file has no rows.
    Empty,
    /// The rows of a quantity cannot be plotted.
    Plot {
        /// The quantity.
        quantity: String,
        /// What the plot refuses.
        source: PlotError,
    },
}

impl fmt::Display for SpeedError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Line { line, message } => {
                write!(formatter, "line {line} of the speed report: {message}")
            }
            Self::Empty => write!(formatter, "the speed report has no rows"),
            Self::Plot { quantity, source } => {
                write!(
                    formatter,
                    "the speed report's quantity \"{quantity}\": {source}"
                )
            }
        }
    }
}

impl std::error::Error for SpeedError {}

/// The figure `speed_against_error` of a chapter: from the measurements made here, if there are any (below the current folder, the
/// repository's root), otherwise from the committed ones.
///
/// # Errors
/// As [`scatter`].
pub fn of_chapter(chapter: &str, committed: &str) -> Result<Figure, SpeedError> {
    scatter(
        &report(chapter, committed),
        "speed_against_error",
        "Speed against error for each quantity of the chapter: the lower left corner wins. The reading is below.".to_owned(),
        ALTERNATIVE.to_owned(),
    )
}

/// The figure `name` of those quantities of a chapter that begin with `beginning`; `name` begins with `speed_`.
///
/// # Errors
/// As [`scatter`]; [`SpeedError::Empty`] where no quantity begins so.
pub fn of_quantities(
    chapter: &str,
    committed: &str,
    name: &'static str,
    beginning: &str,
) -> Result<Figure, SpeedError> {
    let report = report(chapter, committed);
    let is_kept = |line: &&str| {
        line.starts_with('#') || line.starts_with("quantity,") || line.starts_with(beginning)
    };
    let chosen: Vec<&str> = report.lines().filter(is_kept).collect();
    scatter(
        &chosen.join("\n"),
        name,
        "Speed against error: the lower left corner wins. The reading is below.".to_owned(),
        ALTERNATIVE.to_owned(),
    )
}

const ALTERNATIVE: &str = "Scatter plots with the error across and the time up, one for each quantity; the same numbers stand in the table below.";

/// The report measured here, where there is one; otherwise the committed one.
fn report(chapter: &str, committed: &str) -> String {
    let path = format!("target/speed_against_error/{chapter}.csv");
    std::fs::read_to_string(path).unwrap_or_else(|_| committed.to_owned())
}

const PANEL_HEIGHT: f64 = 360.0;
const HEADING: f64 = 32.0;
const LINE: f64 = 20.0;

/// The figure of a speed report: one scatter plot a quantity, in the order of the file.
///
/// # Errors
/// When a line cannot be read, when there are no rows, or when a time is not a positive number.
///
/// # Examples
/// ```
/// use facette_figure::speed::scatter;
///
/// let csv = "# processor: an invented one\n\
///     quantity,algorithm,scalar,threads,inputs,n,ns_per_eval,spread,ratio,max_ulp,max_abs,rms,wrong\n\
///     point,direct,f64,1,typical,1000,12.5,0.02,1,3,4.4e-16,1e-16,\n";
/// let words = ("Speed against error.".to_string(), "One point.".to_string());
/// let figure = scatter(csv, "speed", words.0, words.1)?;
/// assert_eq!(figure.file_name(), "speed.svg");
/// # Ok::<(), facette_figure::speed::SpeedError>(())
/// ```
pub fn scatter(
    csv: &str,
    name: &'static str,
    caption: String,
    alternative: String,
) -> Result<Figure, SpeedError> {
    let rows = table::read(csv)?;
    let mut quantities: Vec<&str> = Vec::new();
    for row in &rows {
        if !quantities.contains(&row.quantity.as_str()) {
            quantities.push(&row.quantity);
        }
    }
    let mut parts = Vec::new();
    for quantity in quantities {
        let rows: Vec<&Row> = rows.iter().filter(|row| row.quantity == quantity).collect();
        let explain = |source| SpeedError::Plot {
            quantity: quantity.to_string(),
            source,
        };
        parts.push((
            quantity,
            panel(quantity, &rows).map_err(explain)?,
            unplaced(&rows),
        ));
    }
    let drawing = stack(&parts, &table::circumstances(csv));
    let svg = drawing.to_svg("Speed against error", &alternative);
    Ok(Figure {
        name,
        caption,
        alternative,
        content: Content::Svg(svg),
    })
}

/// The panels below each other, each under its heading, and what cannot be placed in words.
fn stack(parts: &[(&str, Drawing, Vec<String>)], circumstances: &str) -> Drawing {
    let heights = parts
        .iter()
        .map(|(_, _, notes)| HEADING + PANEL_HEIGHT + LINE * notes.len() as f64);
    let total = heights.sum::<f64>() + 1.5 * LINE;
    let mut drawing = Drawing::new(PAGE_WIDTH, total);
    let mut top = 0.0;
    for (quantity, plot, notes) in parts {
        drawing = drawing
            .text([0.0, top + 22.0], quantity, 16.0, Anchor::Start)
            .drawing([0.0, top + HEADING], [PAGE_WIDTH, PANEL_HEIGHT], plot);
        top += HEADING + PANEL_HEIGHT;
        for note in notes {
            drawing = drawing.text([66.0, top + 16.0], note, 13.0, Anchor::Start);
            top += LINE;
        }
    }
    drawing.text([PAGE_WIDTH, total - 2.0], circumstances, 12.0, Anchor::End)
}

/// Rows whose error is infinite or no number: they have no place on the axis, and are told in words.
fn unplaced(rows: &[&Row]) -> Vec<String> {
    let is_unplaced = |row: &&&Row| row.error.is_some_and(|error| !error.is_finite());
    let tell = |row: &&Row| {
        format!(
            "not shown: {}, {}, {} inputs, {} ns: the error is not finite",
            row.algorithm,
            row.scalar,
            row.inputs.name(),
            row.nanoseconds
        )
    };
    rows.iter().filter(is_unplaced).map(tell).collect()
}

fn panel(quantity: &str, rows: &[&Row]) -> Result<Drawing, PlotError> {
    let title = format!("Time against error: {quantity}");
    let mut plot = Plot::new(&title, "largest absolute error", "time per evaluation / ns")
        .log_x()
        .log_y()
        .height(PANEL_HEIGHT);
    let algorithms = distinct(rows, |row| row.algorithm.as_str());
    let scalars = distinct(rows, |row| row.scalar.as_str());
    let names_n = distinct(rows, |row| row.n.as_str()).len() > 1;
    plot = add_legend(plot, &scalars);
    let mut pairs: Vec<(&Row, [f64; 2])> = Vec::new();
    for row in rows {
        let Some(error) = row.error else {
            plot = plot.guide(row.nanoseconds, &row.label(names_n));
            continue;
        };
        if !error.is_finite() {
            continue;
        }
        let colour = SERIES[position(&algorithms, &row.algorithm) % SERIES.len()];
        let (shape, is_filled) = (shape(&scalars, &row.scalar), row.inputs == Inputs::Typical);
        let look = Look::Marks { shape, is_filled };
        let point = [error, row.nanoseconds];
        let partner = pairs.iter().find(|(other, _)| other.is_same_variant(row));
        plot = match partner {
            Some((_, other)) => plot.series(
                "",
                &[*other, point],
                Look::Line(Dashes::Dotted),
                Colour::Faint,
            ),
            None => plot.note(point, &row.label(names_n), Colour::Ink),
        };
        plot = plot.series(&row.algorithm, &[point], look, colour);
        pairs.push((row, point));
    }
    plot.to_drawing()
}

/// The shapes of the scalar types, then what filled and hollow mean.
fn add_legend(plot: Plot, scalars: &[&str]) -> Plot {
    let filled = |shape| Look::Marks {
        shape,
        is_filled: true,
    };
    let plot = scalars.iter().fold(plot, |plot, scalar| {
        plot.legend_entry(scalar, filled(shape(scalars, scalar)), Colour::Ink)
    });
    let hollow = Look::Marks {
        shape: Shape::Disc,
        is_filled: false,
    };
    plot.legend_entry(
        "typical inputs (filled)",
        filled(Shape::Disc),
        Colour::Faint,
    )
    .legend_entry("hard inputs (hollow)", hollow, Colour::Faint)
}

/// A disc for f64, a triangle for f32, and further shapes for other types in the order of their appearance.
fn shape(scalars: &[&str], scalar: &str) -> Shape {
    match scalar {
        "f64" => Shape::Disc,
        "f32" => Shape::Triangle,
        _ => {
            let others: Vec<_> = scalars
                .iter()
                .filter(|name| !["f32", "f64"].contains(name))
                .copied()
                .collect();
            if position(&others, scalar).is_multiple_of(2) {
                Shape::Square
            } else {
                Shape::Diamond
            }
        }
    }
}

fn distinct<'a>(rows: &[&'a Row], key: impl Fn(&'a Row) -> &'a str) -> Vec<&'a str> {
    let mut found = Vec::new();
    for row in rows.iter().copied().filter(|row| row.error.is_some()) {
        if !found.contains(&key(row)) {
            found.push(key(row));
        }
    }
    found
}

fn position(names: &[&str], name: &str) -> usize {
    names.iter().position(|other| *other == name).unwrap_or(0)
}

#[cfg(test)]
mod tests;
