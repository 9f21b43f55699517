//! Plots, drawings and pictures in one style: what a chapter's example makes and the book shows.
//!
//! A [`Figure`] is a name, a caption, an alternative text and its content: an SVG document that follows the theme of the
//! page, or a PNG picture with a transparent background. A chapter's example lists its figures as [`FigureMaker`]s.
//!
//! | module | what it makes |
//! | --- | --- |
//! | [`palette`] | colours that colour-blind readers tell apart |
//! | [`svg`] | drawings, and pictures side by side under crisp labels |
//! | [`plot`] | lines and points over named axes |
//! | [`speed`] | the scatter plot of speed against error |
//! | [`render`] | pictures of surfaces, curves and points |
//! | [`difference`] | how far two pictures are apart, for snapshots |
//! | [`example`] | what the examples do alike |

#![warn(missing_docs)]

pub mod difference;
pub mod example;
pub mod palette;
pub mod plot;
pub mod render;
pub mod speed;
pub mod svg;

use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU64, Ordering};

/// A figure of the book: its content, and the words that go with it.
///
/// # Examples
/// ```
/// use facette_figure::{Content, Figure};
///
/// let figure = Figure {
///     name: "unit_square",
///     caption: "The unit square $[0,1]^2$.".to_string(),
///     alternative: "A square.".to_string(),
///     content: Content::Svg("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 1 1\"/>".to_string()),
/// };
/// assert_eq!(figure.file_name(), "unit_square.svg");
/// ```
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Figure {
    /// The file's stem, for example `ruled_surfaces`.
    pub name: &'static str,
    /// One or two sentences of Markdown with `$maths$`: what the figure shows and what to notice.
    pub caption: String,
    /// Plain text for those who do not see the figure: what is to be seen.
    pub alternative: String,
    /// The drawing or picture itself.
    pub content: Content,
}

/// What a figure is made of.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Content {
    /// An SVG document, to be inlined into the page.
    Svg(String),
    /// The bytes of a PNG file.
    Png(Vec<u8>),
}

/// One entry of an example's list of figures: the name, and the function that makes the figure.
#[derive(Debug, Clone, Copy)]
pub struct FigureMaker {
    /// The figure's name, the same as [`Figure::name`].
    pub name: &'static str,
    /// Makes the figure.
    pub make: fn() -> Figure,
}

/// Tells apart the temporary files of threads that write the same figure.
static TEMPORARY: AtomicU64 = AtomicU64::new(0);

impl Figure {
    /// The figure of a drawing, with its words.
    #[must_use]
    pub fn drawn(
        name: &'static str,
        caption: &str,
        alternative: &str,
        drawing: &svg::Drawing,
    ) -> Self {
        Self {
            name,
            caption: caption.to_owned(),
            alternative: alternative.to_owned(),
            content: Content::Svg(drawing.to_svg(name, alternative)),
        }
    }

    /// The figure of a plot, with its words.
    ///
    /// # Errors
    ///
    /// Those of [`plot::Plot::to_svg`].
    pub fn plotted(
        name: &'static str,
        caption: &str,
        alternative: &str,
        plot: &plot::Plot,
    ) -> Result<Self, plot::PlotError> {
        Ok(Self {
            name,
            caption: caption.to_owned(),
            alternative: alternative.to_owned(),
            content: Content::Svg(plot.to_svg(alternative)?),
        })
    }

    /// The name of the figure's file: its name with the extension of its content.
    #[must_use]
    pub fn file_name(&self) -> String {
        match self.content {
            Content::Svg(_) => format!("{}.svg", self.name),
            Content::Png(_) => format!("{}.png", self.name),
        }
    }

    /// Writes the figure into `folder` (made if missing) and returns the file's path.
    ///
    /// The file appears whole or not at all: it is written beside its place and then renamed.
    ///
    /// # Errors
    /// What the file system refuses, with the path in the message.
    pub fn write(&self, folder: &Path) -> io::Result<PathBuf> {
        let bytes = match &self.content {
            Content::Svg(text) => text.as_bytes(),
            Content::Png(bytes) => bytes.as_slice(),
        };
        let path = folder.join(self.file_name());
        write_atomically(&path, bytes)?;
        Ok(path)
    }
}

/// Writes `bytes` to `path` by way of a temporary file in the same folder, which is made if missing.
pub(crate) fn write_atomically(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let explain = |error: io::Error| {
        io::Error::new(
            error.kind(),
            format!("cannot write {}: {error}", path.display()),
        )
    };
    if let Some(folder) = path.parent() {
        fs::create_dir_all(folder).map_err(explain)?;
    }
    let number = TEMPORARY.fetch_add(1, Ordering::Relaxed);
    let mut temporary = path.as_os_str().to_owned();
    temporary.push(format!(".{}-{number}.tmp", std::process::id()));
    let temporary = PathBuf::from(temporary);
    let written = fs::write(&temporary, bytes).and_then(|()| fs::rename(&temporary, path));
    if written.is_err() {
        // The error of the write matters more than that of the cleaning.
        let _ = fs::remove_file(&temporary);
    }
    written.map_err(explain)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn figure(content: Content) -> Figure {
        let (caption, alternative) = ("A caption.".to_string(), "A text.".to_string());
        Figure {
            name: "trial",
            caption,
            alternative,
            content,
        }
    }

    #[test]
    fn a_figure_is_written_whole_over_an_older_one_and_nothing_else_is_left() {
        let folder = std::env::temp_dir().join(format!("facette-write-{}", std::process::id()));
        let inner = folder.join("not/there/yet");
        for content in ["<svg>an older and longer one</svg>", "<svg/>"] {
            let path = figure(Content::Svg(content.to_string()))
                .write(&inner)
                .expect("a folder for temporary files");
            assert_eq!(path, inner.join("trial.svg"));
            assert_eq!(fs::read(path).expect("just written"), content.as_bytes());
        }
        let png = figure(Content::Png(vec![1, 2, 3]))
            .write(&inner)
            .expect("the same folder");
        assert_eq!(png, inner.join("trial.png"));
        let count = fs::read_dir(&inner).expect("the same folder").count();
        fs::remove_dir_all(&folder).expect("the folder of this test");
        assert_eq!(count, 2);
    }

    #[test]
    fn a_folder_that_cannot_be_made_is_named() {
        let file = std::env::temp_dir().join(format!("facette-file-{}", std::process::id()));
        fs::write(&file, "not a folder").expect("a folder for temporary files");
        let error = figure(Content::Png(vec![]))
            .write(&file)
            .expect_err("a file is no folder");
        fs::remove_file(&file).expect("the file of this test");
        assert!(error.to_string().starts_with("cannot write "), "{error}");
    }
}
