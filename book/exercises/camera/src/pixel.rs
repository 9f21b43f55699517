//! Exercise 2: from the pixel to the image plane.
//!
//! Replace each `todo!(...)` by your code, save, and run `cargo exercise camera/pixel`.

use crate::algebra::Scalar;
use crate::camera::{ImageRectangle, ImageSize, Pixel};

/// The place `[u, v]` of the **centre** of a pixel. The image is the rectangle from `left` to `right` and from `bottom` to
/// `top`, cut into equal pixels. Columns are counted from the left, rows from the bottom, both from 0.
///
/// What you can use, besides + - * / on numbers of the type S:
///
/// ```text
/// rectangle.left()      the border on the left; so also .right(), .bottom(), .top(); .width(), .height()
/// S::ratio(1, 2)        the number 1/2 in the type S
/// [u, v]                the result: two numbers in brackets
/// ```
pub fn pixel_centre<S: Scalar>(
    rectangle: &ImageRectangle<S>,
    size: ImageSize,
    pixel: Pixel,
) -> [S; 2] {
    // The column i and the row j of the pixel, and the numbers of columns and rows, as numbers of the type S.
    let [i, j] = [number::<S>(pixel.column), number::<S>(pixel.row)];
    let [n_x, n_y] = [number::<S>(size.columns()), number::<S>(size.rows())];

    todo!("pixel_centre: the place [u, v]")
}

/// The row counted from the other side of the image. Image files begin with the **top** row: for row 0 of the file, this is
/// the number of the top row counted from the bottom, and the other way round.
///
/// ```text
/// size.rows()           how many rows the image has
/// Some(row)             the result for a row of the image; None where there is no such row
/// if a < b { x } else { y }
/// ```
pub fn flipped_row(size: ImageSize, row: u32) -> Option<u32> {
    todo!("flipped_row: the row counted from the other side")
}

/// A whole number in the type S.
fn number<S: Scalar>(n: u32) -> S {
    S::from_i32(n.cast_signed())
}
