//! Pictures in memory, and their PNG files.

use std::fmt;
use std::io::Cursor;

use image::codecs::png::{CompressionType, FilterType, PngEncoder};
use image::{ExtendedColorType, ImageEncoder, ImageFormat};

/// A picture of sRGB bytes with straight alpha, row by row from the upper left corner.
#[derive(Clone, PartialEq, Eq)]
pub struct Picture {
    /// The number of columns.
    pub width: u32,
    /// The number of rows.
    pub height: u32,
    /// Red, green, blue and alpha of each pixel: `4 · width · height` bytes.
    pub rgba: Vec<u8>,
}

impl fmt::Debug for Picture {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "Picture({} x {})", self.width, self.height)
    }
}

/// What is wrong with the bytes of a PNG file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct PngError(String);

impl fmt::Display for PngError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "not a readable PNG picture: {}", self.0)
    }
}

impl std::error::Error for PngError {}

impl Picture {
    /// The picture as the bytes of a PNG file.
    ///
    /// # Panics
    /// When `rgba` does not hold `4 · width · height` bytes, or the width or height is 0.
    ///
    /// # Examples
    /// ```
    /// use facette_figure::render::Picture;
    ///
    /// let dot = Picture { width: 1, height: 1, rgba: vec![0, 114, 178, 255] };
    /// assert_eq!(Picture::from_png(&dot.to_png()), Ok(dot));
    /// ```
    #[must_use]
    pub fn to_png(&self) -> Vec<u8> {
        let mut bytes = Vec::new();
        PngEncoder::new_with_quality(&mut bytes, CompressionType::Best, FilterType::Adaptive)
            .write_image(
                &self.rgba,
                self.width,
                self.height,
                ExtendedColorType::Rgba8,
            )
            .expect(
                "a picture has 4 bytes a pixel and at least one pixel, and memory takes every byte",
            );
        bytes
    }

    /// Writes the picture to the PNG file at `path`: whole or not at all.
    ///
    /// # Errors
    /// What the file system refuses, with the path in the message.
    pub fn save(&self, path: &std::path::Path) -> std::io::Result<()> {
        crate::write_atomically(path, &self.to_png())
    }

    /// The picture in the bytes of a PNG file of any colour type.
    ///
    /// # Errors
    /// When the bytes are no PNG file or end too early.
    pub fn from_png(bytes: &[u8]) -> Result<Self, PngError> {
        let decoded = image::ImageReader::with_format(Cursor::new(bytes), ImageFormat::Png)
            .decode()
            .map_err(|error| PngError(error.to_string()))?
            .into_rgba8();
        Ok(Self {
            width: decoded.width(),
            height: decoded.height(),
            rgba: decoded.into_raw(),
        })
    }

    /// The four bytes of the pixel in this column and row.
    ///
    /// # Panics
    /// When the picture has no such pixel.
    #[must_use]
    pub fn pixel(&self, column: u32, row: u32) -> [u8; 4] {
        assert!(
            column < self.width && row < self.height,
            "no pixel ({column}, {row}) in {self:?}"
        );
        let start = 4 * (row as usize * self.width as usize + column as usize);
        std::array::from_fn(|channel| self.rgba[start + channel])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn png_keeps_every_byte_even_of_transparent_pixels() {
        let rgba: Vec<u8> = (0..=u8::MAX).collect();
        let picture = Picture {
            width: 16,
            height: 4,
            rgba,
        };
        assert_eq!(Picture::from_png(&picture.to_png()), Ok(picture));
    }

    #[test]
    fn damaged_files_are_refused_with_a_message() {
        let png = Picture {
            width: 2,
            height: 2,
            rgba: vec![7; 16],
        }
        .to_png();
        for bytes in [&png[..png.len() / 2], b"GIF89a", b""] {
            let message = Picture::from_png(bytes).map_err(|error| error.to_string());
            assert!(message.is_err_and(|text| text.starts_with("not a readable PNG picture: ")));
        }
    }
}
