//! A solution of exercise 2: from the pixel to the image plane.

use crate::algebra::Scalar;
use crate::camera::{ImageRectangle, ImageSize, Pixel};

/// The place `[u, v]` of the centre of a pixel.
pub fn pixel_centre<S: Scalar>(
    rectangle: &ImageRectangle<S>,
    size: ImageSize,
    pixel: Pixel,
) -> [S; 2] {
    let [i, j] = [number::<S>(pixel.column), number::<S>(pixel.row)];
    let [n_x, n_y] = [number::<S>(size.columns()), number::<S>(size.rows())];

    let half = S::ratio(1, 2);
    let u = rectangle.left() + rectangle.width() * (i + half) / n_x;
    let v = rectangle.bottom() + rectangle.height() * (j + half) / n_y;
    [u, v]
}

/// The row counted from the other side of the image.
pub fn flipped_row(size: ImageSize, row: u32) -> Option<u32> {
    if row < size.rows() {
        Some(size.rows() - 1 - row)
    } else {
        None
    }
}

/// A whole number in the type S.
fn number<S: Scalar>(n: u32) -> S {
    S::from_i32(n.cast_signed())
}
