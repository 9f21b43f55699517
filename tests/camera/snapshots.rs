//! What the chapter's example makes, kept: numbers as text, drawings with their words.

use std::fmt::Write as _;

use facette::camera::{Camera, CameraFrame, ImageRectangle, ImageSize};

#[path = "../../examples/camera/figures.rs"]
mod figures;
#[path = "../common/snapshots.rs"]
#[allow(dead_code, unused_imports, reason = "this chapter keeps no pictures")]
mod kept;

use kept::{drawing_of, keep, words_of};

/// The words of all figures, and how large each is: a figure that comes out empty changes its line.
#[test]
fn figures_have_captions_alternatives_and_content() {
    keep("camera__figures", &words_of(figures::FIGURES));
}

#[test]
fn drawing_of_the_pixel_grid() {
    keep(
        "camera__pixel_grid",
        &drawing_of(figures::FIGURES, "pixel_grid"),
    );
}

/// The rays of a small image under both projections, in the order of the file.
#[test]
fn rays_of_a_small_image() {
    let frame = CameraFrame::looking_at([4.0, -3.0, 2.0], [0.0, 0.5, 0.25], [0.0, 0.0, 1.0]);
    let frame = frame.expect("a view");
    let rectangle = ImageRectangle::new(-1.0, 2.0, -0.5, 1.0).expect("an extent");
    let perspective = Camera::perspective(frame, rectangle, 1.5).expect("a distance");
    let size = ImageSize::new(3, 2).expect("pixels");
    let mut table = String::from(" i j | orthographic origin            | perspective direction\n");
    for pixel in size.pixels_in_file_order() {
        let origin = Camera::orthographic(frame, rectangle)
            .pixel_ray(size, pixel)
            .origin;
        let direction = perspective.pixel_ray(size, pixel).direction;
        // Rounding, then adding zero, turns -0 into 0, which would print a sign.
        let cells = [origin, direction].map(|point: [f64; 3]| {
            let [x, y, z] = point.map(|value| (value * 1e6).round() / 1e6 + 0.0);
            format!("{x:9.6} {y:9.6} {z:9.6}")
        });
        let _ = writeln!(
            table,
            " {} {} | {} | {}",
            pixel.column, pixel.row, cells[0], cells[1]
        );
    }
    keep("camera__rays", &table);
}
