//! The theorems of the first programs' pictures. The book shows their doc comments.

use facette::camera::{Camera, CameraFrame, ImageRectangle, ImageSize};
use facette::intersection::{Group, Intersect, Sphere};
use glam::DVec3;
use proptest::collection::vec;
use proptest::prelude::*;

use crate::common::law::{Broken, Law, LikelyMistake, Verdict, expect_equal};
use crate::snapshots::figures::first_programs::{
    BLACK, Rgb, Scene, WHITE, first_picture, silhouette,
};

/// A sphere on a grid of sixteenths: its centre, and its radius.
type Ball = ([i32; 3], i32);

/// The pictures have so many columns and rows, of one unit each, that is 16 sixteenths.
const SIZE: u32 = 12;

/// The distance of the camera's plane from the middle, in sixteenths: before all spheres.
const EYE: i32 = 320;

fn law(theorem: &'static str) -> Law {
    Law::new(theorem, || LikelyMistake {
        name: "",
        hint: "the first programs stand in examples/intersection/first_programs.rs: no exercise replaces them",
    })
}

/// Spheres of radius up to 6 whose centres lie within 6 of the middle.
fn balls(most: usize) -> impl Strategy<Value = Vec<Ball>> {
    vec(
        ([-96..=96_i32, -96..=96_i32, -96..=96_i32], 1..=96_i32),
        0..=most,
    )
}

/// Spheres with centres at centres of pixels, of radii that reach others exactly, several of them the same.
fn hard_balls(most: usize) -> impl Strategy<Value = Vec<Ball>> {
    let coordinate = || (-3..=2_i32).prop_map(|pixel| 16 * pixel + 8);
    let radius = prop::sample::select(vec![1, 16, 48, 80]);
    vec((coordinate(), coordinate(), radius), 0..=most).prop_map(|balls| {
        let flat = balls.into_iter().map(|(x, y, radius)| ([x, y, 0], radius));
        flat.collect()
    })
}

/// The camera that looks along −z at the square of side 12 around the middle: its pixels are squares of side 1.
fn camera() -> (Camera<DVec3>, ImageSize) {
    let eye = DVec3::new(0.0, 0.0, f64::from(EYE) / 16.0);
    let frame = CameraFrame::looking_at(eye, DVec3::ZERO, DVec3::Y).expect("a frame");
    let side = f64::from(SIZE);
    let rectangle = ImageRectangle::centred(side, side).expect("a square");
    let size = ImageSize::new(SIZE, SIZE).expect("a picture with pixels");
    (Camera::orthographic(frame, rectangle), size)
}

fn sphere(&([x, y, z], radius): &Ball) -> Sphere<DVec3> {
    let centre = DVec3::new(f64::from(x), f64::from(y), f64::from(z)) / 16.0;
    Sphere::new(centre, f64::from(radius) / 16.0).expect("a positive radius")
}

/// The centre of the pixel in this column and in this row from the top, in sixteenths.
fn centre(column: u32, row: u32) -> [i32; 2] {
    let [column, row] = [column, row].map(|number| i32::try_from(number).expect("a small picture"));
    [16 * column + 8 - 96, 96 - 16 * row - 8]
}

/// `r² − ρ²` in square sixteenths, for a pixel's centre at the distance ρ from the sphere's axis: positive inside its disk.
fn inside(&([x, y, _], radius): &Ball, [u, v]: [i32; 2]) -> i32 {
    radius * radius - (u - x) * (u - x) - (v - y) * (v - y)
}

/// Calls `check` with what the picture shows at each pixel whose centre lies on no sphere's outline.
fn at_each_pixel(
    balls: &[Ball],
    picture: &facette_figure::render::Picture,
    check: impl Fn([i32; 2], Rgb) -> Verdict,
) -> Verdict {
    for (row, column) in (0..SIZE).flat_map(|row| (0..SIZE).map(move |column| (row, column))) {
        let at = centre(column, row);
        let [red, green, blue, alpha] = picture.pixel(column, row);
        expect_equal(&255, &alpha)?;
        if balls.iter().all(|ball| inside(ball, at) != 0) {
            check(at, [red, green, blue])?;
        }
    }
    Ok(())
}

/// **The first program draws a disk.** Seen by parallel rays, a sphere of radius $r$ is white at exactly those pixels whose centres lie nearer than $r$ to its axis of sight, and the rest of the picture is black.
///
/// Course: plan, slide 103, the first program: white on a hit.
#[test]
fn first_program_draws_a_disk() {
    let theorem = law("intersection::first_program_draws_a_disk");
    theorem
        .on_cases(128)
        .holds(balls(1), hard_balls(1), |balls| {
            let (camera, size) = camera();
            let spheres: Vec<_> = balls.iter().map(sphere).collect();
            let picture = silhouette(&camera, size, &Group::new(spheres));
            at_each_pixel(balls, &picture, |at, colour| {
                let is_inside = balls.iter().any(|ball| inside(ball, at) > 0);
                expect_equal(if is_inside { &WHITE } else { &BLACK }, &colour)
            })
        });
}

/// **The second program shows the nearest.** Each pixel has the colour of the sphere whose front $z+\sqrt{r^2-\varrho^2}$ is highest there, $\varrho$ being the distance of the pixel's centre from the sphere's axis, whatever the order of the spheres in the
/// scene; of equal ones the first; and it is black where there is none. Fronts that differ by less than $2^{-40}$ are told apart by rounding, and may show either sphere.
///
/// Course: plan, slide 105, the nearest surface in its colour.
#[test]
fn second_program_shows_the_nearest_surface() {
    let theorem = law("intersection::second_program_shows_the_nearest_surface");
    theorem
        .on_cases(128)
        .holds(balls(8), hard_balls(8), |balls| {
            let (camera, size) = camera();
            let members = balls
                .iter()
                .map(|ball| Box::new(sphere(ball)) as Box<dyn Intersect<Point = DVec3>>);
            let scene = Scene {
                surfaces: Group::new(members.collect()),
                colours: (0..8).map(|number| [200 + number, number, 7]).collect(),
            };
            let picture = first_picture(&camera, size, &scene);
            at_each_pixel(balls, &picture, |at, colour| {
                let front = |ball: &Ball| f64::from(ball.0[2]) + f64::from(inside(ball, at)).sqrt();
                let seen: Vec<_> = (0..balls.len())
                    .filter(|&ball| inside(&balls[ball], at) > 0)
                    .collect();
                let highest = seen
                    .iter()
                    .map(|&ball| front(&balls[ball]))
                    .fold(f64::MIN, f64::max);
                let margin = 16.0 / (1_u64 << 40) as f64;
                let possible: Vec<_> = seen
                    .into_iter()
                    .filter(|&ball| front(&balls[ball]) >= highest - margin)
                    .collect();
                let Some(&first) = possible.first() else {
                    return expect_equal(&BLACK, &colour);
                };
                let are_twins = possible.iter().all(|&other| balls[other] == balls[first]);
                let shown = possible.iter().find(|&&ball| scene.colours[ball] == colour);
                if shown == Some(&first) || (shown.is_some() && !are_twins) {
                    return Ok(());
                }
                Err(Broken {
                    expected: format!("sphere {first} of {possible:?} at {at:?}"),
                    got: format!("the colour {colour:?}"),
                })
            })
        });
}
