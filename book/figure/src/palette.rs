//! Colours that readers with any kind of colour vision tell apart: the palette of Okabe and Ito.
//!
//! In an SVG a colour is a CSS variable with a fallback, so that a theme may set its own shade; ink is the colour of
//! the page's text. Yellow is left out: no shade of it is read on white.
//!
//! *Sources*: Masataka Okabe and Kei Ito, Color Universal Design, 2008.

/// A colour of the palette, or ink: the colour of the text around the figure.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Colour {
    /// The colour of the page's text, black or white by theme.
    Ink,
    /// Ink at low strength: grids, guides, hidden lines.
    Faint,
    /// The colour of the page itself: a halo of it keeps ink readable over a picture, whatever the theme.
    Page,
    /// `#0072b2`.
    Blue,
    /// `#d55e00`.
    Vermilion,
    /// `#009e73`.
    Green,
    /// `#cc79a7`.
    Purple,
    /// `#e69f00`.
    Orange,
    /// `#56b4e9`.
    Sky,
}

/// The colours of a plot's series, in the order in which they are given out.
pub const SERIES: [Colour; 6] = [
    Colour::Blue,
    Colour::Vermilion,
    Colour::Green,
    Colour::Purple,
    Colour::Orange,
    Colour::Sky,
];

impl Colour {
    /// The colour as a CSS value, for `fill` and `stroke`.
    ///
    /// # Examples
    /// ```
    /// use facette_figure::palette::Colour;
    /// assert_eq!(Colour::Blue.css(), "var(--figure-blue, #0072b2)");
    /// assert_eq!(Colour::Ink.css(), "currentColor");
    /// ```
    #[must_use]
    pub fn css(self) -> String {
        let name = match self {
            Self::Ink => return "currentColor".to_string(),
            // The books' themes name their background so.
            Self::Page => return "var(--bg, #ffffff)".to_string(),
            Self::Faint => "faint",
            Self::Blue => "blue",
            Self::Vermilion => "vermilion",
            Self::Green => "green",
            Self::Purple => "purple",
            Self::Orange => "orange",
            Self::Sky => "sky",
        };
        let [red, green, blue] = self.rgb();
        format!("var(--figure-{name}, #{red:02x}{green:02x}{blue:02x})")
    }

    /// The colour as sRGB bytes, for pictures. Ink becomes a grey that is read on white and on navy alike, the
    /// page white.
    #[must_use]
    pub fn rgb(self) -> [u8; 3] {
        match self {
            Self::Ink => [0x78, 0x7e, 0x8a],
            Self::Faint => [0x8c, 0x92, 0x9e],
            Self::Page => [0xff; 3],
            Self::Blue => [0x00, 0x72, 0xb2],
            Self::Vermilion => [0xd5, 0x5e, 0x00],
            Self::Green => [0x00, 0x9e, 0x73],
            Self::Purple => [0xcc, 0x79, 0xa7],
            Self::Orange => [0xe6, 0x9f, 0x00],
            Self::Sky => [0x56, 0xb4, 0xe9],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::render::colour::decode;

    fn luminance(rgb: [u8; 3]) -> f64 {
        let [red, green, blue] = rgb.map(decode);
        0.2126 * red + 0.7152 * green + 0.0722 * blue
    }

    fn contrast(a: [u8; 3], b: [u8; 3]) -> f64 {
        let (a, b) = (luminance(a), luminance(b));
        (a.max(b) + 0.05) / (a.min(b) + 0.05)
    }

    #[test]
    fn every_colour_stands_out_from_the_dark_page_and_the_first_four_from_the_white_page_too() {
        let (white, navy) = ([255; 3], [0x16, 0x19, 0x23]);
        for colour in SERIES {
            assert!(contrast(colour.rgb(), navy) >= 3.0, "{colour:?} on navy");
        }
        // 3 is the contrast that WCAG 2.1 asks of graphics.
        for colour in [Colour::Ink, Colour::Blue, Colour::Vermilion, Colour::Green] {
            assert!(contrast(colour.rgb(), white) >= 3.0, "{colour:?} on white");
        }
    }

    #[test]
    fn series_have_different_colours() {
        for (index, first) in SERIES.iter().enumerate() {
            assert!(
                SERIES[..index]
                    .iter()
                    .all(|second| second.rgb() != first.rgb())
            );
        }
    }
}
