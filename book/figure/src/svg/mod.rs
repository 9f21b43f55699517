//! A small writer of SVG drawings that follow the theme of the page.
//!
//! A [`Drawing`] has a `viewBox` and no fixed size, no background, ink in `currentColor`, a `<title>` and a `<desc>`,
//! and no `id`s, so that several may be inlined into one page. Numbers have two decimals.
//!
//! # Conventions
//!
//! x to the right, y down, both in units of the drawing's width and height. A drawing that spans the page is
//! [`PAGE_WIDTH`] wide; text of size 15 then matches the text around it.

mod base64;
mod panels;
mod text;

use std::fmt::Write as _;

pub use panels::{Panel, panels};
pub(crate) use text::estimated_width;
pub use text::{Anchor, escape, literal};

use crate::palette::Colour;
use crate::render::Picture;

/// The width of a drawing that spans the page's column of text.
pub const PAGE_WIDTH: f64 = 750.0;

/// How a line is broken into dashes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Dashes {
    /// An unbroken line.
    #[default]
    Solid,
    /// Long dashes.
    Dashed,
    /// Dots.
    Dotted,
    /// A dash, a dot, a dash.
    DashDotted,
}

/// The dashes of a plot's series, in the order in which they are given out.
pub const DASHES: [Dashes; 4] = [
    Dashes::Solid,
    Dashes::Dashed,
    Dashes::Dotted,
    Dashes::DashDotted,
];

/// How a line is drawn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stroke {
    /// The line's colour.
    pub colour: Colour,
    /// The line's width, in the drawing's units.
    pub width: f64,
    /// The line's dashes, in proportion to its width.
    pub dashes: Dashes,
}

impl Stroke {
    /// A solid line.
    #[must_use]
    pub fn new(colour: Colour, width: f64) -> Self {
        Self {
            colour,
            width,
            dashes: Dashes::Solid,
        }
    }

    /// The same line with these dashes.
    #[must_use]
    pub fn dashes(self, dashes: Dashes) -> Self {
        Self { dashes, ..self }
    }

    fn attributes(self) -> String {
        let lengths: &[f64] = match self.dashes {
            Dashes::Solid => &[],
            Dashes::Dashed => &[4.0, 3.0],
            Dashes::Dotted => &[0.01, 2.2],
            Dashes::DashDotted => &[5.0, 2.5, 0.01, 2.5],
        };
        let mut attributes = format!(
            r#"stroke="{}" stroke-width="{:.2}" stroke-linejoin="round" stroke-linecap="round""#,
            self.colour.css(),
            self.width
        );
        if !lengths.is_empty() {
            let scaled = lengths
                .iter()
                .map(|length| format!("{:.2}", length * self.width));
            let list = scaled.collect::<Vec<_>>().join(" ");
            let _ = write!(attributes, r#" stroke-dasharray="{list}""#);
        }
        attributes
    }
}

/// A drawing in the making. Every method adds one thing on top of what is there.
///
/// # Examples
/// ```
/// use facette_figure::palette::Colour;
/// use facette_figure::svg::{Anchor, Drawing, Stroke};
///
/// let svg = Drawing::new(100.0, 60.0)
///     .arrow([10.0, 50.0], [90.0, 50.0], Stroke::new(Colour::Ink, 1.5))
///     .text([50.0, 40.0], "*P*_1(*u*)", 15.0, Anchor::Middle)
///     .to_svg("An axis", "An arrow to the right, named P1 of u.");
/// assert!(svg.starts_with("<svg"));
/// assert!(svg.contains("viewBox=\"0 0 100 60\""));
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Drawing {
    width: f64,
    height: f64,
    body: String,
}

impl Drawing {
    /// An empty drawing of this size.
    #[must_use]
    pub fn new(width: f64, height: f64) -> Self {
        Self {
            width,
            height,
            body: String::new(),
        }
    }

    /// The drawing's width and height.
    #[must_use]
    pub fn size(&self) -> [f64; 2] {
        [self.width, self.height]
    }

    /// A segment.
    #[must_use]
    pub fn line(self, from: [f64; 2], to: [f64; 2], stroke: Stroke) -> Self {
        self.polyline(&[from, to], stroke)
    }

    /// An open polyline.
    #[must_use]
    pub fn polyline(self, points: &[[f64; 2]], stroke: Stroke) -> Self {
        let list = point_list(points);
        self.element(&format!(
            r#"<polyline points="{list}" fill="none" {}/>"#,
            stroke.attributes()
        ))
    }

    /// A closed polygon, filled with a colour at an opacity between 0 and 1, without outline.
    #[must_use]
    pub fn area(self, points: &[[f64; 2]], fill: Colour, opacity: f64) -> Self {
        let (list, fill) = (point_list(points), fill.css());
        self.element(&format!(
            r#"<polygon points="{list}" fill="{fill}" fill-opacity="{opacity:.2}"/>"#
        ))
    }

    /// A closed polygon's outline.
    #[must_use]
    pub fn outline(self, points: &[[f64; 2]], stroke: Stroke) -> Self {
        let list = point_list(points);
        self.element(&format!(
            r#"<polygon points="{list}" fill="none" {}/>"#,
            stroke.attributes()
        ))
    }

    /// The cubic Bézier curve of four control points.
    #[must_use]
    pub fn bezier(self, [a, b, c, d]: [[f64; 2]; 4], stroke: Stroke) -> Self {
        let rest = point_list(&[b, c, d]);
        self.element(&format!(
            r#"<path d="M{} C{rest}" fill="none" {}/>"#,
            point_list(&[a]),
            stroke.attributes()
        ))
    }

    /// A disc, as for a point.
    #[must_use]
    pub fn disc(self, [x, y]: [f64; 2], radius: f64, fill: Colour) -> Self {
        let fill = fill.css();
        self.element(&format!(
            r#"<circle cx="{x:.2}" cy="{y:.2}" r="{radius:.2}" fill="{fill}"/>"#
        ))
    }

    /// A circle's outline.
    #[must_use]
    pub fn circle(self, [x, y]: [f64; 2], radius: f64, stroke: Stroke) -> Self {
        self.element(&format!(
            r#"<circle cx="{x:.2}" cy="{y:.2}" r="{radius:.2}" fill="none" {}/>"#,
            stroke.attributes()
        ))
    }

    /// A segment with an arrow head at its end. Nothing is drawn where the two points are one.
    #[must_use]
    pub fn arrow(self, from: [f64; 2], to: [f64; 2], stroke: Stroke) -> Self {
        let along = [to[0] - from[0], to[1] - from[1]];
        let length = (along[0] * along[0] + along[1] * along[1]).sqrt();
        if length <= 0.0 {
            return self;
        }
        let [x, y] = along.map(|coordinate| coordinate / length);
        let head = (5.0 * stroke.width).min(length);
        let base = [to[0] - head * x, to[1] - head * y];
        let half = 0.38 * head;
        let left = [base[0] - half * y, base[1] + half * x];
        let right = [base[0] + half * y, base[1] - half * x];
        // The shaft ends inside the head, so that its round end does not blunt the point.
        let end = [base[0] + 0.3 * head * x, base[1] + 0.3 * head * y];
        self.line(from, end, stroke)
            .area(&[to, left, right], stroke.colour, 1.0)
    }

    /// Text with its baseline at a point: `*S*_1` is an italic S with an index, `10^{-3}` has an exponent, `\\_` is an underscore.
    #[must_use]
    pub fn text(self, at: [f64; 2], markup: &str, size: f64, anchor: Anchor) -> Self {
        self.coloured_text(at, markup, size, anchor, Colour::Ink)
    }

    /// [`Drawing::text`] in a colour.
    #[must_use]
    pub fn coloured_text(
        self,
        at: [f64; 2],
        markup: &str,
        size: f64,
        anchor: Anchor,
        colour: Colour,
    ) -> Self {
        let element = text::element(at, markup, size, anchor, colour);
        self.element(&element)
    }

    /// [`Drawing::text`] over a halo in the colour of the page, which keeps it readable over a picture.
    #[must_use]
    pub fn haloed_text(self, at: [f64; 2], markup: &str, size: f64, anchor: Anchor) -> Self {
        let halo = Stroke::new(Colour::Page, 0.3 * size).attributes();
        let under = text::element(at, markup, size, anchor, Colour::Page);
        let under = under.replacen("<text", &format!("<text {halo}"), 1);
        self.element(&under).text(at, markup, size, anchor)
    }

    /// A picture in the rectangle with this upper left corner and size.
    #[must_use]
    pub fn picture(self, [x, y]: [f64; 2], [width, height]: [f64; 2], picture: &Picture) -> Self {
        let data = base64::encode(&picture.to_png());
        self.element(&format!(
            r#"<image x="{x:.2}" y="{y:.2}" width="{width:.2}" height="{height:.2}" href="data:image/png;base64,{data}"/>"#
        ))
    }

    /// Another drawing, scaled to fit the rectangle with this upper left corner and size.
    #[must_use]
    pub fn drawing(self, [x, y]: [f64; 2], [width, height]: [f64; 2], inner: &Self) -> Self {
        self.element(&format!(
            r#"<svg x="{x:.2}" y="{y:.2}" width="{width:.2}" height="{height:.2}" viewBox="0 0 {} {}">
{}</svg>"#,
            number(inner.width),
            number(inner.height),
            inner.body
        ))
    }

    /// Everything drawn so far, as the SVG document with this title and description.
    #[must_use]
    pub fn to_svg(&self, title: &str, description: &str) -> String {
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {} {}\" role=\"img\" \
             font-family=\"system-ui, 'Open Sans', sans-serif\">\n<title>{}</title>\n<desc>{}</desc>\n{}</svg>\n",
            number(self.width),
            number(self.height),
            escape(title),
            escape(description),
            self.body
        )
    }

    /// One element of SVG, written by hand.
    #[must_use]
    pub(crate) fn element(mut self, element: &str) -> Self {
        self.body.push_str(element);
        self.body.push('\n');
        self
    }
}

/// A length without needless decimals.
fn number(value: f64) -> String {
    let text = format!("{value:.2}");
    text.trim_end_matches('0').trim_end_matches('.').to_string()
}

fn point_list(points: &[[f64; 2]]) -> String {
    let pairs = points.iter().map(|[x, y]| format!("{x:.2},{y:.2}"));
    pairs.collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests;
