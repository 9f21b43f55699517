//! Which typical mistake does the code under test behave like? Each suspect function tries it on a few fixed inputs that tell
//! all of them apart.

use facette::algebra::VectorSpace;
use facette::camera::{
    CameraFrame, ImageRectangle, ImageSize, Pixel, flipped_row, half_extent, look_at_axes,
    orthographic_ray, perspective_ray, pixel_centre, project_orthographic, project_perspective,
};

use crate::common::exact::{Exact, fraction};
use crate::common::law::LikelyMistake;
use crate::inputs::{Point, rotation};
use crate::mistakes::{self, MISTAKES, Mistake};

/// Two answers in floating point count as the same up to this part, far above rounding and far below any mistake.
const SAME: f64 = 1e-9;

fn frame_of_probe() -> CameraFrame<Point> {
    let eye = [5, -7, 3].map(|coordinate| fraction(coordinate, 2));
    CameraFrame::from_axes(eye, rotation([3, 1, -2, 1])).expect("a rotation")
}

fn rectangle_and_size() -> (ImageRectangle<Exact>, ImageSize) {
    let [l, r, b, t] = [-1, 4, 2, 5].map(|border| fraction(border, 3));
    let rectangle = ImageRectangle::new(l, r, b, t).expect("positive extents");
    (rectangle, ImageSize::new(7, 4).expect("pixels"))
}

/// The mistake among those of `exercise` that agrees with the code under test; otherwise `general`.
fn found(
    exercise: &str,
    general: &'static str,
    agrees: impl Fn(&Mistake) -> bool,
) -> LikelyMistake {
    let mut candidates = MISTAKES
        .iter()
        .filter(|mistake| mistake.exercise == exercise);
    match candidates.find(|mistake| agrees(mistake)) {
        Some(Mistake { name, hint, .. }) => LikelyMistake { name, hint },
        None => LikelyMistake {
            name: "",
            hint: general,
        },
    }
}

/// Suspects for `look_at_axes`.
pub fn frame() -> LikelyMistake {
    let general = "w is the unit vector along e - c, u the unit vector along up x w, v = w x u";
    let [eye, target, up] = [[5., 3., 1.], [1., 1., -3.], [0., 2., 1.]];
    found("frame", general, |mistake| {
        let wrong = mistakes::look_at_axes(mistake.name, eye, target, up).flatten();
        match (wrong, look_at_axes(eye, target, up)) {
            (Some(wrong), Some(axes)) => {
                wrong.into_iter().zip(axes).all(|(a, b): ([f64; 3], _)| {
                    a.minus(b).largest_coordinate() <= SAME * a.largest_coordinate()
                })
            }
            _ => false,
        }
    })
}

/// Suspects for `pixel_centre` and `flipped_row`.
pub fn pixel() -> LikelyMistake {
    let general = "u = l + (r - l) (i + 1/2) / n_x, and v likewise with b, t, j and n_y";
    let (rectangle, size) = rectangle_and_size();
    let pixel = Pixel { column: 5, row: 1 };
    found("pixel", general, |mistake| {
        let place = mistakes::pixel_centre(mistake.name, &rectangle, size, pixel);
        let row = mistakes::flipped_row(mistake.name, size, 1);
        match (place, row) {
            (Some(wrong), _) => wrong == pixel_centre(&rectangle, size, pixel),
            (None, Some(wrong)) => wrong == flipped_row(size, 1),
            (None, None) => false,
        }
    })
}

/// Suspects for `orthographic_ray` and `perspective_ray`.
pub fn rays() -> LikelyMistake {
    let general = "compare origin and direction with the formulas, term by term";
    let (frame, distance) = (frame_of_probe(), fraction(7, 2));
    let place = [fraction(2, 3), fraction(-5, 4)];
    found("rays", general, |mistake| {
        let flat = mistakes::orthographic_ray(mistake.name, &frame, place);
        let deep = mistakes::perspective_ray(mistake.name, &frame, distance, place);
        match (flat, deep) {
            (Some(wrong), _) => wrong == orthographic_ray(&frame, place),
            (None, Some(wrong)) => wrong == perspective_ray(&frame, distance, place),
            (None, None) => false,
        }
    })
}

/// Suspects for `project_orthographic` and `project_perspective`.
pub fn projection() -> LikelyMistake {
    let general = "the coordinates are (p - e) . u, (p - e) . v and the depth -(p - e) . w";
    let (frame, distance) = (frame_of_probe(), fraction(7, 2));
    let at = |depth: i32| frame.point([fraction(2, 3), fraction(-5, 4), fraction(-depth, 1)]);
    found("projection", general, |mistake| {
        [3, -2].into_iter().all(|depth| {
            let point = at(depth);
            let flat = mistakes::project_orthographic(mistake.name, &frame, point);
            let deep = mistakes::project_perspective(mistake.name, &frame, distance, point);
            match (flat, deep) {
                (Some(wrong), _) => wrong == project_orthographic(&frame, point),
                (None, Some(wrong)) => wrong == project_perspective(&frame, distance, point),
                (None, None) => false,
            }
        })
    })
}

/// Suspects for `half_extent`.
pub fn field_of_view() -> LikelyMistake {
    let general = "half the extent is the distance times the tangent of half the angle";
    found("field_of_view", general, |mistake| {
        [0.7, 1.3].into_iter().all(|angle: f64| {
            let wrong = mistakes::half_extent(mistake.name, angle, 2.5);
            let near = |wrong: f64| (wrong - half_extent(angle, 2.5)).abs() <= SAME * wrong.abs();
            wrong.is_some_and(near)
        })
    })
}

/// Suspects for what no exercise asks the reader to write.
pub fn library() -> LikelyMistake {
    LikelyMistake {
        name: "",
        hint: "a defect of the library: no exercise replaces this code",
    }
}
