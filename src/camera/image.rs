//! The image: a rectangle of the image plane, cut into pixels.

use super::{CameraError, ImageSizeError};
use crate::algebra::{Real, Scalar, VectorSpace};

/// The part of the image plane that is seen: `[left, right] × [bottom, top]` in the coordinates (u, v) of the frame. It need not lie around the origin.
///
/// # Units
///
/// Those of the scene.
///
/// # Examples
///
/// ```
/// use facette::camera::ImageRectangle;
///
/// let rectangle = ImageRectangle::new(-2.0, 2.0, -1.0, 1.0)?;
/// assert_eq!([rectangle.width(), rectangle.height()], [4.0, 2.0]);
/// assert!(ImageRectangle::new(2.0, -2.0, -1.0, 1.0).is_err());
/// # Ok::<(), facette::camera::CameraError<f64>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ImageRectangle<S> {
    left: S,
    right: S,
    bottom: S,
    top: S,
}

impl<S: Scalar> ImageRectangle<S> {
    /// The rectangle with the borders l, r, b, t.
    ///
    /// # Errors
    ///
    /// [`CameraError::NumberOutOfRange`] for a border that is infinite or NaN, [`CameraError::EmptyRectangle`] where left is not below right or bottom not below
    /// top, or the extent between them overflows.
    pub fn new(left: S, right: S, bottom: S, top: S) -> Result<Self, CameraError<S>> {
        let named = [
            ("left", left),
            ("right", right),
            ("bottom", bottom),
            ("top", top),
        ];
        for (what, value) in named {
            if !value.is_finite() {
                let expected = "finite";
                return Err(CameraError::NumberOutOfRange {
                    what,
                    value,
                    expected,
                });
            }
        }
        for (low_name, low, high_name, high) in [
            ("left", left, "right", right),
            ("bottom", bottom, "top", top),
        ] {
            if !(low < high && (high - low).is_finite()) {
                return Err(CameraError::EmptyRectangle {
                    low_name,
                    low,
                    high_name,
                    high,
                });
            }
        }
        Ok(Self {
            left,
            right,
            bottom,
            top,
        })
    }

    /// The rectangle of this width and height with the origin in its middle.
    ///
    /// # Errors
    ///
    /// [`CameraError::NumberOutOfRange`] for a number that is not positive and finite.
    pub fn centred(width: S, height: S) -> Result<Self, CameraError<S>> {
        check_positive("the width", width)?;
        check_positive("the height", height)?;
        let [x, y] = [width, height].map(|extent| extent * S::ratio(1, 2));
        Self::new(-x, x, -y, y)
    }

    /// The rectangle, centred, that is seen at `distance` under the vertical angle `field_of_view` (in radians), `aspect` times as wide as high.
    ///
    /// # Accuracy
    ///
    /// As [`half_extent`], with one rounding more for the width.
    ///
    /// # Errors
    ///
    /// [`CameraError::FieldOfView`] where the angle is not strictly between 0 and π; [`CameraError::NumberOutOfRange`] for a distance or aspect that is not
    /// positive and finite; [`CameraError::EmptyRectangle`] where the rectangle overflows or vanishes.
    pub fn from_field_of_view(
        field_of_view: S,
        aspect: S,
        distance: S,
    ) -> Result<Self, CameraError<S>>
    where
        S: Real,
    {
        let is_angle = field_of_view > S::zero() && field_of_view < S::pi();
        if !is_angle {
            let angle = field_of_view;
            return Err(CameraError::FieldOfView { angle });
        }
        check_positive("the aspect ratio", aspect)?;
        check_positive("the distance of the image plane", distance)?;
        let top = half_extent(field_of_view, distance);
        let right = aspect * top;
        Self::new(-right, right, -top, top)
    }

    /// The left border l.
    #[inline]
    pub fn left(&self) -> S {
        self.left
    }

    /// The right border r.
    #[inline]
    pub fn right(&self) -> S {
        self.right
    }

    /// The lower border b.
    #[inline]
    pub fn bottom(&self) -> S {
        self.bottom
    }

    /// The upper border t.
    #[inline]
    pub fn top(&self) -> S {
        self.top
    }

    /// The extent r − l.
    #[inline]
    pub fn width(&self) -> S {
        self.right - self.left
    }

    /// The extent t − b.
    #[inline]
    pub fn height(&self) -> S {
        self.top - self.bottom
    }
}

/// Half the extent that is seen at `distance` under the whole angle `field_of_view`, in radians between 0 and π: `distance · tan(field_of_view / 2)`.
///
/// # Accuracy
///
/// Relative error at most 6u, if sine and cosine are within an ulp (tested as `half_extent_error_stays_below_its_bound`).
// ANCHOR: half_extent
pub fn half_extent<S: Real>(field_of_view: S, distance: S) -> S {
    let half = field_of_view * S::ratio(1, 2);
    distance * (half.sin() / half.cos())
}
// ANCHOR_END: half_extent

pub(super) fn check_positive<S: Scalar>(
    what: &'static str,
    value: S,
) -> Result<(), CameraError<S>> {
    if value > S::zero() && value.is_finite() {
        return Ok(());
    }
    let expected = "positive and finite";
    Err(CameraError::NumberOutOfRange {
        what,
        value,
        expected,
    })
}

/// How many columns and rows of pixels an image has, at least one of each.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ImageSize {
    columns: u32,
    rows: u32,
}

impl ImageSize {
    /// The largest number of columns or rows: up to there `i + ½` is a number of single precision.
    pub const LARGEST: u32 = 1 << 23;

    /// The size of `columns` by `rows` pixels.
    ///
    /// # Errors
    ///
    /// Where one of them is 0 or above [`ImageSize::LARGEST`].
    pub fn new(columns: u32, rows: u32) -> Result<Self, ImageSizeError> {
        let possible = 1..=Self::LARGEST;
        if possible.contains(&columns) && possible.contains(&rows) {
            Ok(Self { columns, rows })
        } else {
            Err(ImageSizeError { columns, rows })
        }
    }

    /// How many columns there are, `n_x`.
    #[inline]
    pub fn columns(&self) -> u32 {
        self.columns
    }

    /// How many rows there are, `n_y`.
    #[inline]
    pub fn rows(&self) -> u32 {
        self.rows
    }

    /// The width of the image over its height, for square pixels.
    pub fn aspect<S: Scalar>(&self) -> S {
        number::<S>(self.columns) / number(self.rows)
    }

    /// All pixels in the order of an image file: row by row from the top, each from the left.
    pub fn pixels_in_file_order(self) -> impl Iterator<Item = Pixel> {
        let rows = (0..self.rows).rev();
        rows.flat_map(move |row| (0..self.columns).map(move |column| Pixel { column, row }))
    }
}

/// A pixel: the column i counted from the left, and the row j counted from the **bottom**.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Pixel {
    /// The column i, from 0 on the left.
    pub column: u32,
    /// The row j, from 0 at the bottom.
    pub row: u32,
}

impl Pixel {
    /// The pixel in this column and in this row of an image *file*, counted from 0 at the top; `None` outside the image.
    pub fn from_file(size: ImageSize, column: u32, row_from_top: u32) -> Option<Self> {
        let row = flipped_row(size, row_from_top)?;
        (column < size.columns).then_some(Self { column, row })
    }
}

/// The row counted from the other side of the image: from the bottom for one counted from the top, and the other way round. `None` outside the image.
// ANCHOR: flipped_row
#[inline]
pub fn flipped_row(size: ImageSize, row: u32) -> Option<u32> {
    (row < size.rows()).then(|| size.rows() - 1 - row)
}
// ANCHOR_END: flipped_row

/// The place (u, v) of the centre of a pixel on the image plane.
///
/// # Accuracy
///
/// u is within `6u · max(|l|, |r|)` of its exact value, v likewise (tested as `pixel_place_error_stays_below_its_bound`).
///
/// # Edge cases
///
/// A pixel outside the image is outside the rectangle: the grid goes on.
// ANCHOR: pixel_centre
#[inline]
pub fn pixel_centre<S: Scalar>(
    rectangle: &ImageRectangle<S>,
    size: ImageSize,
    pixel: Pixel,
) -> [S; 2] {
    pixel_sample(rectangle, size, pixel, [S::ratio(1, 2); 2])
}
// ANCHOR_END: pixel_centre

/// The place (u, v) of a point inside a pixel, `[0, 0]` being its lower left corner and `[1, 1]` its upper right one.
///
/// # Accuracy
///
/// u is within `8u · max(|l|, |r|)` of its exact value, v likewise (tested as `pixel_place_error_stays_below_its_bound`); the outer borders of the outer pixels are the
/// borders of the rectangle, without rounding.
///
/// # Edge cases
///
/// Outside `[0, 1]` a neighbour of the pixel is sampled.
// ANCHOR: pixel_sample
#[inline]
pub fn pixel_sample<S: Scalar>(
    rectangle: &ImageRectangle<S>,
    size: ImageSize,
    pixel: Pixel,
    [x, y]: [S; 2],
) -> [S; 2] {
    let across = (number::<S>(pixel.column) + x) / number(size.columns());
    let up = (number::<S>(pixel.row) + y) / number(size.rows());
    [
        rectangle.left.lerp(rectangle.right, across),
        rectangle.bottom.lerp(rectangle.top, up),
    ]
}
// ANCHOR_END: pixel_sample

/// The number of a row or column; those beyond 2³¹ − 1 lie outside every image and are that.
#[inline]
pub(super) fn number<S: Scalar>(index: u32) -> S {
    S::from_i32(i32::try_from(index).unwrap_or(i32::MAX))
}
