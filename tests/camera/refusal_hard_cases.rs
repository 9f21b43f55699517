//! Data that make no camera, each refused by name with what would be right.

use facette::camera::{
    Camera, CameraError, CameraFrame, ImageRectangle, ImageSize, ImageSizeError,
};

const UP: [f64; 3] = [0.0, 1.0, 0.0];

fn looking(target: [f64; 3], up: [f64; 3]) -> Result<CameraFrame<[f64; 3]>, CameraError<f64>> {
    CameraFrame::looking_at([0.0; 3], target, up)
}

/// **Up along the view.** If up is parallel to the view, every turn about the view is as good as any other, and the data do not say which: the error says so and names the way out. Parallel means parallel up to rounding: $(0.1,0.2,0.3)$ and three times as much are not multiples of each
/// other in floating point, but no digit of their product is known, also where all its terms are small because the view is near an axis. A camera without an opinion on up takes the coordinate axis that is farthest from the view.
#[test]
fn up_parallel_to_the_view_is_refused() {
    let tenths = [0.1, 0.2, 0.3];
    let view = tenths.map(|coordinate| 3.0 * coordinate);
    let opposite = tenths.map(|coordinate| -7.0 * coordinate);
    let near_an_axis = [0.7, 1e-6, 3e-6];
    let as_near = near_an_axis.map(|coordinate| 3.0 * coordinate);
    for (target, up) in [
        ([0.0, 5.0, 0.0], UP),
        ([0.0, -1e30, 0.0], UP),
        (view, tenths),
        (opposite, tenths),
        (as_near, near_an_axis),
    ] {
        let error = looking(target, up).expect_err("no digit of the product is known");
        assert!(matches!(error, CameraError::UpAlongView { up: named, .. } if named == up));
        assert!(
            error.to_string().contains("looking_at_with_any_up"),
            "{error}"
        );
        assert!(CameraFrame::looking_at_with_any_up([0.0; 3], target).is_ok());
    }
    let error = looking([0.0, 5.0, 0.0], UP).expect_err("parallel");
    assert_eq!(
        error.to_string(),
        "up = [0.0, 1.0, 0.0] is parallel to the direction of view [0.0, 1.0, 0.0], up to the rounding of the given numbers: \
         take another direction up, or `CameraFrame::looking_at_with_any_up`"
    );
}

/// **No opinion on up.** Whatever the view, the axis that is chosen as up is at least 54° away from it: the smallest of three coordinates of a unit vector is at most $1/\sqrt3$. So the frame is as good as any; but it jumps where another axis becomes the smallest, and must jump somewhere, as the hairy
/// ball theorem says. Where two axes are equally far from the view, the first is up.
#[test]
fn any_up_is_far_from_every_view() {
    for [x, y, z] in directions() {
        let target = [x, y, z].map(f64::from);
        let frame = CameraFrame::looking_at_with_any_up([0.0; 3], target).expect("a view");
        let [_, v, _] = frame.axes();
        // The chosen axis is up: v has the cosine of the angle between them, sin 54.7° = √(2/3) or more, in some coordinate.
        let upward = v.into_iter().fold(0.0, f64::max);
        assert!(
            upward >= (2.0_f64 / 3.0).sqrt() - 1e-15,
            "{target:?}: {v:?}"
        );
        assert!(CameraFrame::from_axes([0.0; 3], frame.axes()).is_ok());
    }
    assert!(matches!(
        CameraFrame::looking_at_with_any_up([1.0; 3], [1.0; 3]),
        Err(CameraError::EyeAtTarget { .. })
    ));
    for (target, up) in [
        ([1.0, 1.0, 1.0], [1.0, 0.0, 0.0]),
        ([0.0, 0.0, -3.0], [1.0, 0.0, 0.0]),
        ([-2.0, 0.0, 0.0], UP),
    ] {
        let frame = CameraFrame::looking_at_with_any_up([0.0; 3], target);
        assert_eq!(frame, looking(target, up), "{target:?}");
    }
}

/// All directions in small whole numbers.
fn directions() -> impl Iterator<Item = [i32; 3]> {
    let all = (-3..=3).flat_map(|x| (-3..=3).flat_map(move |y| (-3..=3).map(move |z| [x, y, z])));
    all.filter(|direction| *direction != [0; 3])
}

/// **No view, no up, no number.** An eye at its target, an up that is zero, and coordinates that are NaN or infinite are refused, each by name.
#[test]
fn views_that_are_none_are_refused() {
    let at = CameraFrame::looking_at([1e7, 2.0, 3.0], [1e7, 2.0, 3.0], UP).expect_err("no view");
    let eye = [1e7, 2.0, 3.0];
    assert_eq!(at, CameraError::EyeAtTarget { eye });
    let up = [0.0, -0.0, 0.0];
    assert_eq!(
        looking([1.0, 0.0, 0.0], up),
        Err(CameraError::UpIsZero { up })
    );
    for bad in [f64::NAN, f64::INFINITY] {
        for (target, up, name) in [
            ([bad, 0.0, 0.0], UP, "the target"),
            ([1.0; 3], [0.0, bad, 0.0], "up"),
        ] {
            let error = looking(target, up).expect_err("not a number");
            assert!(matches!(error, CameraError::PointNotFinite { what, .. } if what == name));
        }
        let error = CameraFrame::looking_at_with_any_up([bad, 0.0, 0.0], [0.0; 3]);
        assert!(matches!(
            error,
            Err(CameraError::PointNotFinite {
                what: "the eye",
                ..
            })
        ));
    }
    // A step of the smallest number is a view.
    assert!(looking([5e-324, 0.0, 0.0], UP).is_ok());
}

/// **Axes that are no frame.** Given axes are measured: the error names the pair that is not orthonormal, with its product; a left hand is refused, since it would mirror the picture.
#[test]
fn axes_that_are_no_frame_are_refused() {
    let [x, y, z] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0_f64]];
    let of = |axes| CameraFrame::from_axes([0.0; 3], axes);
    assert!(of([x, y, z]).is_ok());
    let long = of([x, [0.0, 1.001, 0.0], z]).expect_err("v is too long");
    assert!(long.to_string().starts_with("v · v is 1.00200"), "{long}");
    let leaning = of([[0.8, 0.6, 0.0], [0.0, 1.0, 0.0], z]).expect_err("u leans");
    assert!(
        leaning.to_string().starts_with("u · v is 0.6,"),
        "{leaning}"
    );
    let left = of([y, x, z]).expect_err("a left hand");
    assert_eq!(left, CameraError::LeftHanded { determinant: -1.0 });
    assert!(of([x, y, [f64::NAN, 0.0, 1.0]]).is_err());
}

/// **Empty and flipped rectangles.** A rectangle without extent has no pixels, and one with exchanged borders would mirror the picture, which is the job of whoever writes the pixels. Both are refused, as are borders that are no numbers, and an extent that overflows.
#[test]
fn empty_and_flipped_rectangles_are_refused() {
    for (borders, names) in [
        ([2.0, -2.0, -1.0, 1.0], ["left", "right"]),
        ([0.5, 0.5, -1.0, 1.0], ["left", "right"]),
        ([-1.0, 1.0, 1.0, -1.0], ["bottom", "top"]),
        ([-1e308, 1e308, -1.0, 1.0], ["left", "right"]),
    ] {
        let [l, r, b, t] = borders;
        let error = ImageRectangle::new(l, r, b, t).expect_err("no extent");
        let CameraError::EmptyRectangle {
            low_name,
            high_name,
            ..
        } = error
        else {
            panic!("another error: {error}");
        };
        assert_eq!([low_name, high_name], names);
    }
    assert!(ImageRectangle::new(0.0, f64::NAN, 0.0, 1.0).is_err());
    assert!(ImageRectangle::centred(0.0, 1.0).is_err());
    assert!(ImageRectangle::centred(1.0, -1.0).is_err());
}

/// **A field of view is an angle below π.** 0, negative angles, π and more, and NaN are refused, and so is a number of degrees above π that was not converted. Just below π there is an image, though an enormous one. The distance and the aspect ratio must be positive.
#[test]
fn field_of_view_that_is_no_angle_is_refused() {
    use std::f64::consts::PI;
    let of = |angle| ImageRectangle::from_field_of_view(angle, 1.5, 1.0);
    for angle in [0.0, -0.5, PI, 2.0 * PI, 60.0, f64::NAN, f64::INFINITY] {
        let error = of(angle).expect_err("no angle");
        assert!(error.to_string().contains("between 0 and π"), "{error}");
    }
    let widest = of(PI.next_down()).expect("an angle below π");
    assert!(widest.top() > 1e15 && widest.right() > widest.top());
    assert!(ImageRectangle::from_field_of_view(std::f32::consts::PI, 1.0, 1.0).is_err());
    let below = std::f32::consts::PI.next_down();
    assert!(ImageRectangle::from_field_of_view(below, 1.0, 1.0).is_ok());
    for (aspect, distance) in [
        (0.0, 1.0),
        (-1.0, 1.0),
        (f64::NAN, 1.0),
        (1.0, 0.0),
        (1.0, f64::INFINITY),
    ] {
        assert!(ImageRectangle::from_field_of_view(1.0, aspect, distance).is_err());
    }
    let frame = looking([0.0, 0.0, -1.0], UP).expect("a view");
    let rectangle = of(1.0).expect("an angle");
    for distance in [0.0, -1.0] {
        assert!(Camera::perspective(frame, rectangle, distance).is_err());
    }
    assert!(Camera::with_field_of_view(frame, 60.0, 1.0).is_err());
}

/// **Images without pixels.** An image has a pixel at least, and at most $2^{23}$ columns and rows: up to there the centre $i+\tfrac12$ is a number of single precision.
#[test]
fn images_without_pixels_are_refused() {
    for (columns, rows) in [(0, 1), (1, 0), (ImageSize::LARGEST + 1, 1)] {
        let error = ImageSize::new(columns, rows).expect_err("no image");
        assert_eq!(error, ImageSizeError { columns, rows });
    }
    assert!(ImageSize::new(ImageSize::LARGEST, 1).is_ok());
    let last = f32::from_bits((8_388_607.0_f32).to_bits()) + 0.5;
    assert_eq!(last.fract(), 0.5);
}
