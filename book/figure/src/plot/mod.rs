//! Plots of lines and points with named axes, linear or logarithmic.
//!
//! The axes are drawn by the crate plotters, at four times the size because it rounds to whole pixels; lines, points,
//! labels and the legend are laid over them by [`Drawing`], so that they follow the page's theme and differ by dashes
//! and shapes, not by colour alone.

mod axis;
mod draw;
mod error;
mod labels;
mod marks;

use plotters::prelude::{BLACK, ChartBuilder, Color, IntoDrawingArea, SVGBackend, TRANSPARENT};
use plotters::style::IntoFont;

use axis::Axis;
use draw::{Frame, draw_series, draw_zero, enlarged, follow_theme};
pub use error::PlotError;
use labels::Rectangle;
pub(crate) use marks::Shape;
use marks::legend;

use crate::palette::{Colour, SERIES};
use crate::svg::{Anchor, DASHES, Dashes, Drawing, PAGE_WIDTH, Stroke};

/// A plot in the making.
///
/// # Examples
/// ```
/// use facette_figure::plot::Plot;
///
/// let points: Vec<[f64; 2]> = (1..=20).map(f64::from).map(|n| [n, 1.0 / (n * n)]).collect();
/// let svg = Plot::new("Chord error", "segments n", "error / length")
///     .log_x()
///     .log_y()
///     .line("1/n²", &points)
///     .to_svg("A straight line that falls two decades for each decade of n.")?;
/// assert!(svg.contains("segments n"));
/// # Ok::<(), facette_figure::plot::PlotError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Plot {
    title: String,
    labels: [String; 2],
    is_logarithmic: [bool; 2],
    height: f64,
    series: Vec<Series>,
    legend: Vec<Entry>,
    notes: Vec<Note>,
    guides: Vec<(f64, String)>,
}

/// Points that are drawn alike.
#[derive(Debug, Clone, PartialEq)]
struct Series {
    name: String,
    points: Vec<[f64; 2]>,
    look: Look,
    colour: Colour,
}

/// How the points of a series are shown.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Look {
    Line(Dashes),
    Marks { shape: Shape, is_filled: bool },
}

/// A line of the legend.
#[derive(Debug, Clone, PartialEq)]
struct Entry {
    name: String,
    look: Look,
    colour: Colour,
}

/// A text beside a point.
#[derive(Debug, Clone, PartialEq)]
struct Note {
    at: [f64; 2],
    text: String,
    colour: Colour,
}

/// How many times larger plotters draws.
const SCALE: u32 = 4;
const TEXT_SIZE: f64 = 13.0;
/// Plotters writes a font's size smaller than it was asked for, by this factor.
const FONT_FACTOR: f64 = 1.24;

impl Plot {
    /// An empty plot. The title names it for those who do not see it; the labels name the axes and their units.
    #[must_use]
    pub fn new(title: &str, x_label: &str, y_label: &str) -> Self {
        Self {
            title: title.to_string(),
            labels: [x_label, y_label].map(str::to_string),
            is_logarithmic: [false; 2],
            height: 400.0,
            series: Vec::new(),
            legend: Vec::new(),
            notes: Vec::new(),
            guides: Vec::new(),
        }
    }

    /// The same plot with a logarithmic x-axis. A value 0 has a marked place of its own, left of all others.
    #[must_use]
    pub fn log_x(mut self) -> Self {
        self.is_logarithmic[0] = true;
        self
    }

    /// The same plot with a logarithmic y-axis.
    #[must_use]
    pub fn log_y(mut self) -> Self {
        self.is_logarithmic[1] = true;
        self
    }

    /// The same plot with this height; it is 750 wide and 400 high unless told.
    #[must_use]
    pub fn height(self, height: f64) -> Self {
        Self { height, ..self }
    }

    /// Adds a line, in the next colour and dashes.
    #[must_use]
    pub fn line(self, name: &str, points: &[[f64; 2]]) -> Self {
        let index = self.legend.len();
        let look = Look::Line(DASHES[index % DASHES.len()]);
        self.series(name, points, look, SERIES[index % SERIES.len()])
            .entry(name, index, look)
    }

    /// Adds points, in the next colour and shape.
    #[must_use]
    pub fn points(self, name: &str, points: &[[f64; 2]]) -> Self {
        let index = self.legend.len();
        let look = Look::Marks {
            shape: Shape::ALL[index % Shape::ALL.len()],
            is_filled: true,
        };
        self.series(name, points, look, SERIES[index % SERIES.len()])
            .entry(name, index, look)
    }

    fn entry(self, name: &str, index: usize, look: Look) -> Self {
        self.legend_entry(name, look, SERIES[index % SERIES.len()])
    }

    /// Adds points or a line of a given look, without a line in the legend.
    pub(crate) fn series(
        mut self,
        name: &str,
        points: &[[f64; 2]],
        look: Look,
        colour: Colour,
    ) -> Self {
        self.series.push(Series {
            name: name.to_string(),
            points: points.to_vec(),
            look,
            colour,
        });
        self
    }

    /// Adds a line to the legend.
    pub(crate) fn legend_entry(mut self, name: &str, look: Look, colour: Colour) -> Self {
        self.legend.push(Entry {
            name: name.to_string(),
            look,
            colour,
        });
        self
    }

    /// Adds a text beside a point, where there is room for it.
    pub(crate) fn note(mut self, at: [f64; 2], text: &str, colour: Colour) -> Self {
        self.notes.push(Note {
            at,
            text: text.to_string(),
            colour,
        });
        self
    }

    /// Adds a horizontal guide with its text at the right end.
    pub(crate) fn guide(mut self, y: f64, text: &str) -> Self {
        self.guides.push((y, text.to_string()));
        self
    }

    /// The plot as an SVG document, with a description of what is to be seen.
    ///
    /// # Errors
    /// When there is nothing to plot, or a value has no place on its axis.
    pub fn to_svg(&self, description: &str) -> Result<String, PlotError> {
        Ok(self.to_drawing()?.to_svg(&self.title, description))
    }

    /// The plot as a drawing, for a grid of panels.
    ///
    /// # Errors
    /// When there is nothing to plot, or a value has no place on its axis.
    pub fn to_drawing(&self) -> Result<Drawing, PlotError> {
        self.check()?;
        let axes = [0, 1].map(|which| self.axis(which));
        let (mut drawing, legend_height) =
            legend(Drawing::new(PAGE_WIDTH, self.height), &self.legend);
        let (background, area) = self.draw_axes(&axes, legend_height)?;
        drawing = drawing.element(&background);
        let frame = Frame { axes, area };
        drawing = draw_zero(drawing, &frame);
        let mut obstacles = self.obstacles(&frame);
        drawing = self.draw_guides(drawing, &frame, &mut obstacles);
        let (lines, marks): (Vec<&Series>, Vec<&Series>) = self
            .series
            .iter()
            .partition(|series| matches!(series.look, Look::Line(_)));
        for series in lines.into_iter().chain(marks) {
            drawing = draw_series(drawing, series, &frame);
        }
        Ok(self.draw_notes(drawing, &frame, obstacles))
    }

    fn values(&self, which: usize) -> impl Iterator<Item = f64> + Clone {
        let guides = self
            .guides
            .iter()
            .map(|guide| guide.0)
            .filter(move |_| which == 1);
        let points = self.series.iter().flat_map(|series| &series.points);
        points.map(move |point| point[which]).chain(guides)
    }

    fn axis(&self, which: usize) -> Axis {
        if self.is_logarithmic[which] {
            Axis::logarithmic(self.values(which))
        } else {
            Axis::linear(self.values(which))
        }
    }

    fn check(&self) -> Result<(), PlotError> {
        if self.values(0).next().is_none() {
            return Err(PlotError::Empty {
                title: self.title.clone(),
            });
        }
        for series in &self.series {
            for (index, point) in series.points.iter().enumerate() {
                let [is_log_x, is_log_y] = self.is_logarithmic;
                let is_placed = point.iter().all(|value| value.is_finite())
                    && !(is_log_x && point[0] < 0.0)
                    && !(is_log_y && point[1] <= 0.0);
                if !is_placed {
                    let (series, point) = (series.name.clone(), *point);
                    return Err(PlotError::Misplaced {
                        series,
                        index,
                        point,
                    });
                }
            }
        }
        Ok(())
    }

    /// The axes drawn by plotters, as an element of SVG, and the rectangle between them: left, right, top, bottom.
    fn draw_axes(&self, axes: &[Axis; 2], top: f64) -> Result<(String, [f64; 4]), PlotError> {
        let mut text = String::new();
        let size = (enlarged(PAGE_WIDTH), enlarged(self.height));
        let area = {
            let root = SVGBackend::with_string(&mut text, size).into_drawing_area();
            let mut chart = ChartBuilder::on(&root)
                .margin_top(enlarged(top + 8.0))
                .margin_right(enlarged(32.0))
                .x_label_area_size(enlarged(46.0))
                .y_label_area_size(enlarged(66.0))
                .build_cartesian_2d(axes[0].clone(), axes[1].clone())
                .map_err(PlotError::axes)?;
            chart
                .configure_mesh()
                .bold_line_style(BLACK.mix(0.15).stroke_width(SCALE))
                .light_line_style(TRANSPARENT)
                .max_light_lines(0)
                .axis_style(BLACK.mix(0.6).stroke_width(SCALE))
                .set_all_tick_mark_size(enlarged(5.0))
                .label_style(("sans-serif", enlarged(FONT_FACTOR * TEXT_SIZE)).into_font())
                .axis_desc_style(
                    ("sans-serif", enlarged(FONT_FACTOR * (TEXT_SIZE + 0.5))).into_font(),
                )
                .x_desc(&self.labels[0])
                .y_desc(&self.labels[1])
                .draw()
                .map_err(PlotError::axes)?;
            root.present().map_err(PlotError::axes)?;
            let (across, down) = chart.plotting_area().get_pixel_range();
            [across.start, across.end, down.start, down.end]
                .map(|pixel| f64::from(pixel) / f64::from(SCALE))
        };
        Ok((follow_theme(&text), area))
    }

    /// Draws the guides with their texts, and adds both to the obstacles.
    fn draw_guides(
        &self,
        mut drawing: Drawing,
        frame: &Frame,
        obstacles: &mut Vec<Rectangle>,
    ) -> Drawing {
        let [left, right, ..] = frame.area;
        for (value, text) in &self.guides {
            let [_, y] = frame.place([1.0, *value]);
            let at = labels::on_guide(y, text, obstacles, frame.area, TEXT_SIZE);
            let stroke = Stroke::new(Colour::Faint, 1.4).dashes(Dashes::Dashed);
            drawing = drawing.line([left, y], [right, y], stroke).text(
                at,
                text,
                TEXT_SIZE,
                Anchor::Start,
            );
            obstacles.push([left, right, y - 3.0, y + 3.0]);
            obstacles.push(labels::text_rectangle(at, text, TEXT_SIZE));
        }
        drawing
    }

    /// What the notes should not cover: marks and lines.
    fn obstacles(&self, frame: &Frame) -> Vec<Rectangle> {
        let mut obstacles = Vec::new();
        for series in &self.series {
            let places: Vec<_> = series
                .points
                .iter()
                .map(|&point| frame.place(point))
                .collect();
            if matches!(series.look, Look::Line(_)) {
                let segments = places.windows(2).map(|pair| [pair[0], pair[1]]);
                obstacles.extend(segments.flat_map(labels::along_segment));
            } else {
                obstacles.extend(places.into_iter().map(labels::around_mark));
            }
        }
        obstacles
    }

    fn draw_notes(&self, drawing: Drawing, frame: &Frame, obstacles: Vec<Rectangle>) -> Drawing {
        let wanted: Vec<([f64; 2], &str)> = self
            .notes
            .iter()
            .map(|note| (frame.place(note.at), note.text.as_str()))
            .collect();
        let places = labels::place(&wanted, obstacles, frame.area, TEXT_SIZE);
        self.notes.iter().zip(&wanted).zip(places).fold(
            drawing,
            |drawing, ((note, want), place)| {
                let drawing = match place.leader {
                    Some(end) => drawing.line(want.0, end, Stroke::new(Colour::Faint, 1.0)),
                    None => drawing,
                };
                let anchor = Anchor::Start;
                drawing.coloured_text(place.baseline, &note.text, TEXT_SIZE, anchor, note.colour)
            },
        )
    }
}

#[cfg(test)]
mod tests;
