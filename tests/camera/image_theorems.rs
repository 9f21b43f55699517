//! The theorems of the pixels, over the rationals. The book shows their doc comments.

use facette::algebra::Scalar;
use facette::camera::{ImageSize, Pixel, flipped_row, pixel_centre, pixel_sample};
use num_traits::{One, Zero};

use crate::common::exact::{Exact, fraction};
use crate::common::law::{Law, expect_equal};
use crate::inputs::{hard_shots, number, shots};
use crate::suspects;

/// **From the pixel to the image.** The centre of the pixel in column $i$ and row $j$, of $n_x$ columns and $n_y$ rows, lies at
/// $$u=l+(r-l)\,\frac{i+\tfrac12}{n_x},\qquad v=b+(t-b)\,\frac{j+\tfrac12}{n_y},$$
/// with columns counted from the left and rows from the bottom.
///
/// Course: R03, slide 91, From the pixel to the image: pixel centres.
/// Exercise: pixel.
#[test]
fn pixel_centre_is_half_a_pixel_into_its_pixel() {
    let name = "camera::pixel_centre_is_half_a_pixel_into_its_pixel";
    Law::new(name, suspects::pixel).holds(shots(), hard_shots(), |shot| {
        let pixel = shot.pixel();
        let ([l, b], [width, height]) = (shot.corner, shot.extent);
        let [columns, rows] = shot.pixels.map(number);
        let [i, j] = [pixel.column, pixel.row].map(number);
        let half = fraction(1, 2);
        let expected = [
            l + width * (i + half) / columns,
            b + height * (j + half) / rows,
        ];
        let got = pixel_centre(&shot.rectangle(), shot.size(), pixel);
        expect_equal(&expected, &got)
    });
}

/// **Half a pixel inside.** The centres of the first and of the last pixel are half a pixel inside the borders: $u_0-l=r-u_{n_x-1}=\tfrac{r-l}{2n_x}$, and so for $v$.
/// The centres are neither on the borders nor shifted to one side.
///
/// Course: R03, slide 91, From the pixel to the image: the first and the last centre.
/// Exercise: pixel.
#[test]
fn outer_centres_are_half_a_pixel_inside() {
    let name = "camera::outer_centres_are_half_a_pixel_inside";
    Law::new(name, suspects::pixel).holds(shots(), hard_shots(), |shot| {
        let rectangle = shot.rectangle();
        let centre = |column, row| pixel_centre(&rectangle, shot.size(), Pixel { column, row });
        let [first, last] = [centre(0, 0), centre(shot.pixels[0] - 1, shot.pixels[1] - 1)];
        let half_pixel = [0, 1].map(|axis| shot.extent[axis] / number(2 * shot.pixels[axis]));
        let low = [0, 1].map(|axis| first[axis] - shot.corner[axis]);
        let high = [0, 1].map(|axis| shot.corner[axis] + shot.extent[axis] - last[axis]);
        expect_equal(&[half_pixel; 2], &[low, high])
    });
}

/// **Pixels tile the image.** The right border of a pixel is the left border of its neighbour, its upper border the lower border of the one above it; inside a pixel the place goes
/// linearly from border to border. The outer borders are the rectangle's.
#[test]
fn pixels_tile_the_rectangle() {
    let name = "camera::pixels_tile_the_rectangle";
    Law::new(name, suspects::library).holds(shots(), hard_shots(), |shot| {
        let (rectangle, size) = (shot.rectangle(), shot.size());
        let Pixel { column, row } = shot.pixel();
        let next = Pixel {
            column: column + 1,
            row: row + 1,
        };
        let sample = |pixel, within| pixel_sample(&rectangle, size, pixel, within);
        let low = sample(shot.pixel(), [Exact::zero(); 2]);
        let high = sample(shot.pixel(), [Exact::one(); 2]);
        expect_equal(&sample(next, [Exact::zero(); 2]), &high)?;
        let inside = sample(shot.pixel(), shot.within);
        let between = [0, 1].map(|axis| low[axis] + (high[axis] - low[axis]) * shot.within[axis]);
        expect_equal(&between, &inside)
    });
}

/// **Rows of a file.** An image file begins with the *top* row, where the formula counts from the bottom. Row $j$ from one side is row $n_y-1-j$ from the other; turned twice it is $j$ again, and
/// the first row of the file is the one with the largest $v$.
///
/// Course: R03, slide 91, From the pixel to the image: the order of the rows.
/// Exercise: pixel.
#[test]
fn rows_of_a_file_run_downwards() {
    let name = "camera::rows_of_a_file_run_downwards";
    Law::new(name, suspects::pixel).holds(shots(), hard_shots(), |shot| {
        let (rectangle, size) = (shot.rectangle(), shot.size());
        let row = shot.pixel().row;
        let flipped = flipped_row(size, row);
        expect_equal(&Some(size.rows() - 1 - row), &flipped)?;
        expect_equal(&Some(row), &flipped.and_then(|row| flipped_row(size, row)))?;
        expect_equal(&None, &flipped_row(size, size.rows()))?;
        let first_in_file = Pixel::from_file(size, 0, 0);
        let row = flipped_row(size, 0).unwrap_or(0);
        expect_equal(&Some(Pixel { column: 0, row }), &first_in_file)?;
        let [_, highest] = pixel_centre(&rectangle, size, Pixel { column: 0, row });
        let half_pixel = shot.extent[1] / number(2 * size.rows());
        expect_equal(&(rectangle.top() - half_pixel), &highest)
    });
}

/// **A file holds every pixel once.** Row by row from the top, each row from the left, the pixels come in the order in which an image file stores them.
#[test]
fn pixels_in_file_order_are_all_pixels_once() {
    let name = "camera::pixels_in_file_order_are_all_pixels_once";
    let sizes = [1..=12_u32, 1..=12_u32];
    let hard = proptest::sample::select(vec![[1, 1], [1, 300], [300, 1]]);
    Law::new(name, suspects::library).holds(sizes, hard, |&[columns, rows]| {
        let size = ImageSize::new(columns, rows).expect("a pixel at least");
        let from_the_top: Vec<_> = (0..rows)
            .flat_map(|row| (0..columns).map(move |column| (column, row)))
            .map(|(column, row)| Pixel::from_file(size, column, row))
            .collect();
        let listed: Vec<_> = size.pixels_in_file_order().map(Some).collect();
        expect_equal(&from_the_top, &listed)?;
        let aspect: Exact = size.aspect();
        expect_equal(
            &(number(columns) / Exact::from_i32(rows.cast_signed())),
            &aspect,
        )
    });
}
