//! Plots of what rounding does to frames and rays, and what does not let it.

use facette::algebra::{Vector3, VectorSpace};
use facette::camera::{
    Camera, CameraFrame, ImageRectangle, ImageSize, Pixel, look_at_axes, perspective_ray,
};
use facette_figure::plot::Plot;
use facette_figure::{Figure, speed};

#[allow(
    clippy::duplicate_mod,
    reason = "the tests of the camera have it beside the figures"
)]
#[path = "../../../tests/camera/variants.rs"]
mod variants;

use variants::{AddedRow, SteppedRow, ray_through_s, textbook_axes};

fn exact(point: [f32; 3]) -> [f64; 3] {
    point.map(f64::from)
}

fn plotted(name: &'static str, caption: &str, alternative: &str, plot: &Plot) -> Figure {
    Figure::plotted(name, caption, alternative, plot).expect("the plot has points")
}

/// The largest scalar product of two different axes.
fn overlap(axes: [[f32; 3]; 3]) -> f64 {
    let [u, v, w] = axes.map(exact);
    let products = [u.dot(v), v.dot(w), w.dot(u)];
    products.map(f64::abs).into_iter().fold(1e-9, f64::max)
}

/// How far the axes are from orthogonal, against the angle between up and the view.
pub fn up_near_the_view() -> Figure {
    let (eye, target): ([f32; 3], _) = ([0.3, 0.2, 0.7], [1.4, -0.5, 2.6]);
    let mut series = [Vec::new(), Vec::new()];
    for step in 0..=28_u8 {
        let angle = 10_f64.powf(-f64::from(step) / 4.5);
        let (mut worst, mut is_known) = ([1e-9_f64; 2], true);
        for turn in 0..24_u8 {
            let turn = f64::from(turn).to_radians() * 15.0;
            let aside = [0.8 * turn.cos(), turn.sin(), 0.3 * (2.0 * turn).sin()];
            #[allow(
                clippy::cast_possible_truncation,
                reason = "the data are in single precision"
            )]
            let aside = aside.map(|part| (2.3 * angle * part) as f32);
            let up = target.minus(eye).plus(aside);
            worst[0] = worst[0].max(overlap(textbook_axes(eye, target, up)));
            match look_at_axes(eye, target, up) {
                Some(axes) => worst[1] = worst[1].max(overlap(axes)),
                None => is_known = false,
            }
        }
        series[0].push([angle, worst[0]]);
        if is_known {
            series[1].push([angle, worst[1]]);
        }
    }
    let title = "The largest scalar product of two axes";
    let plot = Plot::new(
        title,
        "angle between up and the view / rad",
        "largest |a · b|",
    )
    .log_x()
    .log_y()
    .line("textbook", &series[0])
    .line("orthogonalised once more", &series[1]);
    plotted(
        "up_near_the_view",
        "How far the axes are from orthogonal, in `f32`: the smaller the angle between up and the view, the worse the textbook's frame. Orthogonalised once more, it stays at the roundoff; the line ends where nothing of the product is known any more, and the frame is refused.",
        "A plot with logarithmic axes. The textbook's line rises as the angle becomes smaller, by a decade for each decade; the other line stays level below one in a million.",
        &plot,
    )
}

/// The error of a direction against the eye's distance from the origin.
pub fn far_eye() -> Figure {
    let mut series = [Vec::new(), Vec::new()];
    for power in 0..=26_i32 {
        let far = 2_f32.powi(power);
        let eye = [far, -far, far];
        let frame = CameraFrame::looking_at(
            eye,
            eye.plus([-far, 0.5 * far, 0.25 * far]),
            [0.0, 0.0, 1.0],
        );
        let frame = frame.expect("up is not along the view");
        let axes = frame.axes().map(exact);
        let mut worst = [1e-9_f64; 2];
        for step in 0..200_u8 {
            let place = [0.007 * f32::from(step) - 0.7, 0.31];
            let [u, v] = place.map(f64::from);
            let direction = axes[0].times(u).plus(axes[1].times(v)).minus(axes[2]);
            let of = [
                ray_through_s(&frame, 1.0, place),
                perspective_ray(&frame, 1.0, place),
            ];
            for (worst, ray) in worst.iter_mut().zip(of) {
                let error = exact(ray.direction).minus(direction).largest_coordinate();
                *worst = worst.max(error);
            }
        }
        for (points, worst) in series.iter_mut().zip(worst) {
            points.push([f64::from(far), worst]);
        }
    }
    let title = "The error of a direction, far from the origin";
    let plot = Plot::new(
        title,
        "coordinates of the eye",
        "largest error of a direction",
    )
    .log_x()
    .log_y()
    .line("d = s − e", &series[0])
    .line("d without s", &series[1]);
    plotted(
        "far_eye",
        "The largest error of a direction of length about 1, in `f32`. By the slides' detour over $\\mathbf s$ it grows with the distance of the eye from the origin, until at $10^7$ it is as large as the direction itself; \
         without the detour it does not depend on the eye.",
        "A plot with logarithmic axes. One line rises in steps in proportion to the eye's coordinates and reaches 1 beyond ten million; the other stays level near one in ten million.",
        &plot,
    )
}

/// The error of a direction along a row, for directions that are added up, stepped and direct.
pub fn drift() -> Figure {
    let frame = CameraFrame::looking_at([3.0, 1.0, 2.0_f32], [0.1, 0.2, 0.3], [0.0, 0.0, 1.0]);
    let rectangle = ImageRectangle::centred(2.0, 0.5).expect("an extent");
    let camera = Camera::perspective(frame.expect("a view"), rectangle, 1.0).expect("a distance");
    let size = ImageSize::new(4096, 1).expect("pixels");
    let axes = camera.frame().axes().map(exact);
    let error = |column: u32, direction: [f32; 3]| {
        let u = -1.0 + 2.0 * (f64::from(column) + 0.5) / 4096.0;
        let exact_direction = axes[0].times(u).minus(axes[2]);
        exact(direction).minus(exact_direction).largest_coordinate()
    };
    let stepped = SteppedRow::new(&camera, 1.0, size, 0);
    let added: Vec<_> = AddedRow::new(&camera, 1.0, size, 0).take(4096).collect();
    let of = |direction: &dyn Fn(u32) -> [f32; 3]| -> Vec<[f64; 2]> {
        // The largest error among 32 neighbours: the single ones jump.
        let blocks = (0..128_u32).map(|block| 32 * block);
        let largest = |first: u32| {
            let errors = (first..first + 32).map(|column| error(column, direction(column)));
            // A pixel is 2/4096 wide.
            [f64::from(first + 16), 2048.0 * errors.fold(0.0, f64::max)]
        };
        blocks.map(largest).collect()
    };
    let plot = Plot::new(
        "Drift along a row",
        "column",
        "largest error of a direction / pixels",
    )
    .line("added up", &of(&|column| added[column as usize].direction))
    .line(
        "start + i · step",
        &of(&|column| stepped.ray(column).direction),
    )
    .line(
        "direct",
        &of(&|column| camera.pixel_ray(size, Pixel { column, row: 0 }).direction),
    );
    plotted(
        "drift",
        "The error of the directions along a row of 4096 pixels, in `f32`: added up from pixel to pixel, they drift away, by a quarter of a pixel at the end; the other two do not.",
        "A plot. One line climbs away with the column; two others stay close to zero.",
        &plot,
    )
}

/// The scatter plots of the measurements.
pub fn speed_against_error() -> Figure {
    let committed = include_str!("../../../book/measurements/camera.csv");
    speed::of_chapter("camera", committed).expect("the committed measurements can be read")
}
