//! Inputs that break the textbook formulas of this chapter, what survives them, and both shown.

use facette::algebra::{Vector3, VectorSpace};
use facette::camera::{
    Camera, CameraFrame, ImageRectangle, ImageSize, Pixel, look_at_axes, orthographic_ray,
    perspective_ray, pixel_sample, project_perspective,
};
use facette::ray::Ray;

use crate::variants::{AddedRow, SteppedRow, ray_through_s, slides_place, textbook_axes};

/// The unit roundoff of `f32`, in `f64`.
const SINGLE: f64 = 5.960_464_477_539_063e-8;

fn exact(point: [f32; 3]) -> [f64; 3] {
    point.map(f64::from)
}

/// The largest of `|a · b|` over the pairs of different axes, without rounding that counts.
fn largest_overlap(axes: [[f32; 3]; 3]) -> f64 {
    let [u, v, w] = axes.map(exact);
    [u.dot(v), v.dot(w), w.dot(u)]
        .map(f64::abs)
        .into_iter()
        .fold(0.0, f64::max)
}

/// **Up near the view.** When up is nearly parallel to the view, the product $\mathbf{up}\times\mathbf w$ is small, and what rounding adds to it need not be perpendicular to $\mathbf w$. At an angle of about $10^{-5}$ the
/// textbook's axes in `f32` miss being orthogonal by more than 100 times the bound of $20\varepsilon$: pictures are sheared. Orthogonalised once more, the axes stay within it.
#[test]
fn up_near_the_view_needs_a_second_orthogonalisation() {
    let (eye, target): ([f32; 3], _) = ([0.3, 0.2, 0.7], [1.4, -0.5, 2.6]);
    let mut worst: f64 = 0.0;
    for step in 1..=32_i16 {
        // Along the view, beside a small step aside.
        let aside = [1e-5, -2e-6, 3e-6].map(|part: f32| part * f32::from(step));
        let up = target.minus(eye).plus(aside);
        worst = worst.max(largest_overlap(textbook_axes(eye, target, up)));
        let axes = look_at_axes(eye, target, up).expect("up is known to its last digits");
        assert!(largest_overlap(axes) <= 20.0 * SINGLE, "step {step}");
    }
    assert!(worst > 100.0 * 20.0 * SINGLE, "{worst}");
}

/// **An axis is never parallel by rounding.** An up along a coordinate axis has no rounding to speak of, and each coordinate of its product with the view is a coordinate of the view: it is known to the last digit, however small it is. So a camera that looks straight
/// down but for $10^{-20}$ has its frame, where a fixed threshold on the angle would refuse it.
#[test]
fn axis_up_is_known_however_near_the_view() {
    let axes = look_at_axes([0.0, 1e-20, 1.0_f32], [0.0; 3], [0.0, 0.0, 1.0]);
    let expected = [[-1.0, 0.0, 0.0], [0.0, -1.0, 1e-20], [0.0, 1e-20, 1.0]];
    assert_eq!(axes, Some(expected));
}

/// **Lengths that overflow.** Squares of coordinates of $10^{30}$ overflow in `f32`, and those of $10^{-30}$ vanish: the textbook's normalisation gives zeros and NaN. Scaled by the largest coordinate first, the frame is that of ordinary size. The difference of
/// eye and target may itself overflow: then half of each is taken.
#[test]
fn huge_and_tiny_views_have_a_frame() {
    let expected = look_at_axes([1.0, 2.0, 2.0_f32], [0.0; 3], [0.0, 1.0, 0.0]);
    for power in [100, -100] {
        let scale = 2_f32.powi(power);
        let eye = [1.0, 2.0, 2.0].map(|coordinate| coordinate * scale);
        let up = [0.0, scale, 0.0];
        let textbook = textbook_axes(eye, [0.0; 3], up);
        assert!(
            textbook
                .iter()
                .any(|axis| !axis.has_finite_coordinates() || *axis == [0.0; 3])
        );
        assert_eq!(look_at_axes(eye, [0.0; 3], up), expected);
    }
    let eye = [0.5, 1.0, 1.0].map(|part| part * f32::MAX);
    let target = eye.map(|coordinate| -coordinate);
    assert!(!eye.minus(target).has_finite_coordinates());
    assert_eq!(look_at_axes(eye, target, [0.0, 1.0, 0.0]), expected);
}

/// **The direction through $\mathbf s-\mathbf e$.** The slides compute the point $\mathbf s$ of the image plane and then $\mathbf d=\mathbf s-\mathbf e$. With the eye at $10^7$ and an image plane at distance 1, $\mathbf s$ is rounded to whole numbers
/// in `f32`: of 640 columns only 5 directions are left. Without the detour over $\mathbf s$ all are different, and each is within its bound.
#[test]
fn direction_through_s_loses_its_digits_far_away() {
    let eye = [1e7, 1e7, 1e7_f32];
    let frame = CameraFrame::looking_at(eye, eye.plus([0.0, 0.0, -4.0]), [0.0, 1.0, 0.0]);
    let frame = frame.expect("a view");
    let size = ImageSize::new(640, 480).expect("pixels");
    let rectangle = ImageRectangle::centred(4.0, 3.0).expect("a rectangle");
    let distinct = |ray: &dyn Fn([f32; 2]) -> Ray<[f32; 3]>| {
        let mut across: Vec<f32> = (0..640)
            .map(|column| {
                let pixel = Pixel { column, row: 0 };
                let place = pixel_sample(&rectangle, size, pixel, [0.5; 2]);
                ray(place).direction[0]
            })
            .collect();
        across.dedup();
        across.len()
    };
    assert_eq!(distinct(&|place| ray_through_s(&frame, 1.0, place)), 5);
    assert_eq!(distinct(&|place| perspective_ray(&frame, 1.0, place)), 640);
}

/// **What the data have lost.** An eye at $10^7$ in `f32` can only stand on whole numbers, and so can its target. The frame is exact for the numbers that are given; but if a target 0.4 to the right was meant, the camera looks straight ahead: the data have lost it, and no
/// formula brings it back. Put the origin near the camera.
#[test]
fn far_target_is_rounded_before_the_camera_sees_it() {
    let frame = |origin: f32| {
        let eye = [origin, 0.0, 4.0];
        let target = [origin + 0.4, 0.0, 0.0];
        CameraFrame::looking_at(eye, target, [0.0, 1.0, 0.0]).expect("a view")
    };
    let [near, far] = [frame(0.0), frame(1e7)].map(|frame| frame.axes()[2]);
    assert!(near[0] < -0.09);
    assert_eq!(far, [0.0, 0.0, 1.0]);
}

/// **The last border.** $l+(r-l)\cdot1$ is not $r$ where the difference is rounded: of the rectangles whose borders are tenths, the slides' form misses some by an ulp, and a tile to their right begins elsewhere. The interpolation
/// $(1-s)\,l+s\,r$ meets the border always.
#[test]
fn slides_form_misses_the_last_border() {
    let size = ImageSize::new(3, 3).expect("pixels");
    let last = Pixel { column: 2, row: 2 };
    let mut missed = 0;
    for (low, high) in (-20..20_i32).flat_map(|low| (low + 1..=20).map(move |high| (low, high))) {
        let [low, high] = [low, high].map(|tenths| f64::from(tenths) / 10.0);
        let rectangle = ImageRectangle::new(low, high, low, high).expect("an extent");
        assert_eq!(pixel_sample(&rectangle, size, last, [1.0; 2]), [high; 2]);
        missed += usize::from(slides_place(&rectangle, size, last, [1.0; 2]) != [high; 2]);
    }
    assert!(missed > 0, "the slides' form missed no border");
}

/// **Rays by addition drift.** One might compute the first direction of a row and add a step for each pixel. Each sum rounds, and the errors add up: after 4096 columns in `f32` the direction is off by more than a hundred times the bound of the direct formula,
/// and by a quarter of a pixel. Start plus $i$ steps has no such drift.
#[test]
fn added_directions_drift() {
    let camera: Camera<[f32; 3]> = wide_camera();
    let size = ImageSize::new(4096, 1).expect("pixels");
    let exact_direction = |column: u32| {
        let [u, v] = {
            let across = (f64::from(column) + 0.5) / 4096.0;
            let rectangle = camera.rectangle();
            let [l, r] = [rectangle.left(), rectangle.right()].map(f64::from);
            let [b, t] = [rectangle.bottom(), rectangle.top()].map(f64::from);
            [l + (r - l) * across, f64::midpoint(b, t)]
        };
        let [x, y, z] = camera.frame().axes().map(exact);
        x.times(u).plus(y.times(v)).minus(z)
    };
    let worst = |directions: &mut dyn Iterator<Item = [f32; 3]>| {
        let errors = directions.zip(0..).map(|(direction, column)| {
            exact(direction)
                .minus(exact_direction(column))
                .largest_coordinate()
        });
        errors.fold(0.0, f64::max)
    };
    let added = AddedRow::new(&camera, 1.0, size, 0);
    let stepped = SteppedRow::new(&camera, 1.0, size, 0);
    let direct = |column| camera.pixel_ray(size, Pixel { column, row: 0 });
    let [added, stepped, direct] = [
        worst(&mut added.take(4096).map(|ray| ray.direction)),
        worst(&mut (0..4096).map(|column| stepped.ray(column).direction)),
        worst(&mut (0..4096).map(|column| direct(column).direction)),
    ];
    // |u u_k| + |v v_k| + |D w_k| is at most 3; 6u of the place, at most 1 here.
    let bound = (3.0 * 3.0 + 6.0) * SINGLE;
    assert!(
        direct <= bound && stepped <= 2.0 * bound,
        "{direct} {stepped}"
    );
    assert!(added > 100.0 * bound, "{added}");
}

/// A camera with a wide image, looking nowhere in particular.
fn wide_camera() -> Camera<[f32; 3]> {
    let frame = CameraFrame::looking_at([3.0, 1.0, 2.0], [0.1, 0.2, 0.3], [0.0, 0.0, 1.0]);
    let rectangle = ImageRectangle::centred(2.0, 0.5).expect("a rectangle");
    Camera::perspective(frame.expect("a view"), rectangle, 1.0).expect("a distance")
}

/// **Points beside and behind the eye.** Dividing by the depth without a look at its sign puts a point behind the eye upside down into the image, and one beside the eye at infinity or at NaN. None of them has an image; nor has a point so near to the plane of the eye
/// that its place overflows.
#[test]
fn points_beside_and_behind_the_eye_are_not_projected() {
    let frame = CameraFrame::looking_at([0.0_f64; 3], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]);
    let frame = frame.expect("a view");
    let plain = |point: [f64; 3]| [point[0] / -point[2], point[1] / -point[2]];
    let [ahead, behind] = [[0.5, 0.25, -2.0], [0.5, 0.25, 2.0]];
    assert_eq!(plain(behind), plain(ahead).map(|place| -place));
    assert!(plain([0.0; 3])[0].is_nan());
    assert!(plain([1.0, 0.0, 0.0])[0].is_infinite());
    assert_eq!(project_perspective(&frame, 1.0, ahead), Some([0.25, 0.125]));
    for point in [
        behind,
        [0.0; 3],
        [1.0, 0.0, 0.0],
        [1e10, 0.0, -1e-300],
        [f64::NAN, 0.0, -1.0],
        [0.0, 0.0, f64::NAN],
    ] {
        assert_eq!(project_perspective(&frame, 1.0, point), None, "{point:?}");
    }
}

/// **Points without a place.** Infinity minus infinity is NaN, and comparing the depth alone lets it pass: an orthographic camera would put the point $(-\infty,-\infty,0)$ at $(\mathrm{NaN},\cdot)$. Nor has a point an image whose place, or whose position in the file, is beyond the largest number.
#[test]
fn points_without_a_place_are_not_projected() {
    let frame = CameraFrame::looking_at([3.0_f64, 2.0, 1.0], [0.0; 3], [0.0, 0.0, 1.0]);
    let frame = frame.expect("a view");
    let rectangle = ImageRectangle::centred(2.0, 2.0).expect("a rectangle");
    let size = ImageSize::new(640, 480).expect("pixels");
    let infinite = [-f64::INFINITY, -f64::INFINITY, 0.0];
    let [u, ..] = frame.coordinates(infinite);
    assert!(u.is_nan());
    let cameras = [
        Camera::orthographic(frame, rectangle),
        Camera::perspective(frame, rectangle, 1.0).expect("a distance"),
    ];
    for camera in cameras {
        assert!(camera.position_in_file(size, [0.0; 3]).is_some());
        let nan = [f64::NAN, 0.0, 0.0];
        for point in [infinite, [-f64::INFINITY, 0.0, 0.0], nan] {
            assert_eq!(camera.project(point), None, "{point:?}");
            assert_eq!(camera.position_in_file(size, point), None, "{point:?}");
        }
    }
    // A place that is a number, at a position that is none.
    let far = [-1e308, 1e308, 0.0];
    assert!(cameras[0].project(far).is_some());
    assert_eq!(cameras[0].position_in_file(size, far), None);
}

/// **An image of one pixel.** Its ray goes through the middle of the rectangle, wherever that lies, and its row is the first from both sides.
#[test]
fn image_of_one_pixel_looks_through_the_middle() {
    let frame = CameraFrame::looking_at([0.0_f64; 3], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]);
    let rectangle = ImageRectangle::new(1.0, 2.0, -4.0, -3.0).expect("a rectangle");
    let camera = Camera::perspective(frame.expect("a view"), rectangle, 1.0).expect("a distance");
    let size = ImageSize::new(1, 1).expect("a pixel");
    let pixel = Pixel::from_file(size, 0, 0).expect("the pixel");
    assert_eq!(pixel, Pixel { column: 0, row: 0 });
    assert_eq!(camera.pixel_ray(size, pixel).direction, [1.5, -3.5, -1.0]);
}

/// **NaN in, NaN out.** A place that is NaN or infinite gives a ray that no surface meets, and a pixel outside the image gives a ray outside the rectangle.
#[test]
fn not_a_number_in_not_a_number_out() {
    let camera = wide_camera();
    assert!(camera.ray([f32::NAN, 0.0]).direction[0].is_nan());
    let size = ImageSize::new(4, 4).expect("pixels");
    let outside = Pixel { column: 4, row: 0 };
    let [u, _] = pixel_sample(camera.rectangle(), size, outside, [0.5; 2]);
    assert!(u > camera.rectangle().right());
    assert_eq!(Pixel::from_file(size, 4, 0), None);
    assert_eq!(Pixel::from_file(size, 0, 4), None);
}

/// **Vectors of a vector unit.** The rays are the same to the bit over arrays, `Vec3` and `Vec3A`: nothing is fused, and each coordinate is computed by itself. The frame is the same over arrays and `Vec3`; `Vec3A` adds the three products of a length in another order, which
/// moves its axes by a rounding or two.
#[test]
fn glam_vectors_give_the_same_rays() {
    let (eye, target, up) = ([0.3, 0.2, 0.7_f32], [1.4, -0.5, 2.6], [0.1, 1.0, -0.2]);
    let arrays = look_at_axes(eye, target, up).expect("a view");
    let plain = look_at_axes::<glam::Vec3>(eye.into(), target.into(), up.into());
    assert_eq!(
        plain.map(|axes| axes.map(|axis| axis.to_array())),
        Some(arrays)
    );
    let aligned = look_at_axes::<glam::Vec3A>(eye.into(), target.into(), up.into());
    for (aligned, axis) in aligned.expect("a view").into_iter().zip(arrays) {
        let apart = exact(aligned.to_array()).minus(exact(axis));
        assert!(apart.largest_coordinate() <= 20.0 * SINGLE);
    }
    let frame = CameraFrame::from_axes(eye, arrays).expect("orthonormal axes");
    let wide = CameraFrame::from_axes(glam::Vec3A::from(eye), arrays.map(Into::into));
    let wide = wide.expect("the same axes");
    let place = [0.3, -0.7];
    let [ray, wide_ray] = [
        perspective_ray(&frame, 1.5, place).direction,
        perspective_ray(&wide, 1.5, place).direction.to_array(),
    ];
    assert_eq!(ray, wide_ray);
    let [ray, wide_ray] = [
        orthographic_ray(&frame, place).origin,
        orthographic_ray(&wide, place).origin.to_array(),
    ];
    assert_eq!(ray, wide_ray);
}

/// **Both ends of a ray.** The start of the interval does not belong to the ray, and its end does: a ray that is cut there has every $t$ in one of its two parts, and in one only. To move one end leaves the other where it is, and NaN is nowhere.
#[test]
fn interval_of_a_ray_has_an_end_and_no_start() {
    let whole = Ray::new([1.0, 2.0, 3.0], [0.0, 0.0, -1.0]);
    let reached = |ray: Ray<[f64; 3]>| {
        let parameters = [-1.0, 0.0, 0.5, 2.0, 3.0, 5.0, 1e300, f64::INFINITY];
        parameters.map(|t| u8::from(ray.reaches(t)))
    };
    assert_eq!(reached(whole), [0, 0, 1, 1, 1, 1, 1, 1]);
    assert_eq!(reached(whole.until(2.0)), [0, 0, 1, 1, 0, 0, 0, 0]);
    assert_eq!(reached(whole.after(2.0)), [0, 0, 0, 0, 1, 1, 1, 1]);
    let both = [0, 0, 0, 0, 1, 1, 0, 0];
    assert_eq!(reached(whole.after(2.0).until(5.0)), both);
    assert_eq!(reached(whole.until(5.0).after(2.0)), both);
    assert_eq!(reached(whole.after(-3.0)), [1; 8]);
    assert_eq!(reached(whole.until(2.0).after(2.0)), [0; 8]);
    assert!(!whole.reaches(f64::NAN));
    assert!(!whole.until(f64::NAN).reaches(1.0));
}
