//! The variants of the chapter *camera*: the directions of the rays of an image, and the frame.

use facette::algebra::{Real, Scalar, Vector3};
use facette::camera::{
    Camera, CameraFrame, ImageRectangle, ImageSize, Pixel, look_at_axes, perspective_ray,
    pixel_centre,
};
use facette::ray::Ray;
use glam::{DVec3, Vec3A};
use num_traits::Signed;

use crate::Visitor;
use crate::common::oracle::{Big, big, big_cross, big_length, big_minus, big_point};
use crate::float_inputs::{FloatPoint, coordinates, rounded};
use crate::harness::{Comparison, Effort, Exact, ExactPoint, lazily};
use variants::{AddedRow, SteppedRow, ray_through_s, slides_place, textbook_axes};

#[path = "../../tests/camera/variants.rs"]
mod variants;

/// A point type of this report.
trait CameraPoint: FloatPoint + Vector3<Scalar: Real + Into<f64>> {}

impl<P: FloatPoint + Vector3<Scalar: Real + Into<f64>>> CameraPoint for P {}

/// How far the image plane lies before the eye.
const DISTANCE: i32 = 1;

/// An image to be seen: eye, target, up, and the borders l, r, b, t.
struct View {
    name: &'static str,
    points: [[f64; 3]; 3],
    borders: [f64; 4],
}

const VIEWS: [View; 2] = [
    View {
        name: "typical",
        points: [[3.1, 1.2, 2.3], [0.1, 0.2, 0.3], [0.0, 0.0, 1.0]],
        borders: [-1.0, 1.0, -0.55, 0.55],
    },
    View {
        name: "hard",
        points: [[1e7, -1e7, 1e7], [-2e7, 3e7, 1e6], [0.1, 0.3, 0.9]],
        borders: [0.3, 0.7, -0.9, -0.6],
    },
];

/// A view in one type of points, with the size of its image.
struct Image<P: CameraPoint> {
    camera: Camera<P>,
    distance: P::Scalar,
    size: ImageSize,
}

impl<P: CameraPoint> Image<P> {
    fn new(view: &View, size: ImageSize) -> Self {
        let [eye, target, up] = view.points.map(P::rounded);
        let [l, r, b, t] = view.borders.map(rounded::<P>);
        let distance = P::Scalar::from_i32(DISTANCE);
        let frame = CameraFrame::looking_at(eye, target, up).expect("the views have frames");
        let rectangle = ImageRectangle::new(l, r, b, t).expect("the views have rectangles");
        let camera = Camera::perspective(frame, rectangle, distance);
        Self {
            camera: camera.expect("a positive distance"),
            distance,
            size,
        }
    }

    fn rows(&self) -> impl Iterator<Item = u32> + use<P> {
        0..self.size.rows()
    }

    fn columns(&self) -> impl Iterator<Item = u32> + use<P> {
        0..self.size.columns()
    }

    /// Fills the directions row by row: `start` prepares a row, `ray` gives the ray of a column.
    fn fill<R>(
        &self,
        start: impl Fn(&Self, u32) -> R,
        ray: impl Fn(&mut R, u32) -> Ray<P>,
    ) -> impl FnMut(&mut [P]) {
        move |directions| {
            let width = self.size.columns() as usize;
            for (row, directions) in self.rows().zip(directions.chunks_exact_mut(width)) {
                let mut row = start(self, row);
                for (direction, column) in directions.iter_mut().zip(self.columns()) {
                    *direction = ray(&mut row, column).direction;
                }
            }
        }
    }

    fn through_s(&self) -> impl FnMut(&mut [P]) {
        let half = [P::Scalar::ratio(1, 2); 2];
        let Self {
            camera,
            distance,
            size,
        } = self;
        self.fill(
            |_, row| row,
            move |&mut row, column| {
                let place = slides_place(camera.rectangle(), *size, Pixel { column, row }, half);
                ray_through_s(camera.frame(), *distance, place)
            },
        )
    }

    fn pixel_ray(&self) -> impl FnMut(&mut [P]) {
        let Self { camera, size, .. } = self;
        self.fill(
            |_, row| row,
            move |&mut row, column| camera.pixel_ray(*size, Pixel { column, row }),
        )
    }

    fn centre_and_ray(&self) -> impl FnMut(&mut [P]) {
        let Self {
            camera,
            distance,
            size,
        } = self;
        self.fill(
            |_, row| row,
            move |&mut row, column| {
                let place = pixel_centre(camera.rectangle(), *size, Pixel { column, row });
                perspective_ray(camera.frame(), *distance, place)
            },
        )
    }

    fn stepped(&self) -> impl FnMut(&mut [P]) {
        self.fill(
            |image, row| SteppedRow::new(&image.camera, image.distance, image.size, row),
            |row, column| row.ray(column),
        )
    }

    fn added(&self) -> impl FnMut(&mut [P]) {
        self.fill(
            |image, row| AddedRow::new(&image.camera, image.distance, image.size, row),
            |row, _| row.next().expect("a row has no end"),
        )
    }

    /// The exact directions, for the frame and the rectangle as they are stored.
    fn exact(&self) -> Vec<ExactPoint> {
        let rectangle = self.camera.rectangle();
        let number = |value: P::Scalar| big(value.into());
        let [l, b] = [rectangle.left(), rectangle.bottom()].map(number);
        let [r, t] = [rectangle.right(), rectangle.top()].map(number);
        let axes = self.camera.frame().axes();
        let [x, y, z] = axes.map(|axis| big_point(coordinates(axis)));
        let part =
            |index: u32, count: u32| big(f64::from(2 * index + 1)) / big(f64::from(2 * count));
        let rows = self
            .rows()
            .flat_map(|row| self.columns().map(move |column| (row, column)));
        rows.map(|(row, column)| {
            let u = &l + (&r - &l) * part(column, self.size.columns());
            let v = &b + (&t - &b) * part(row, self.size.rows());
            std::array::from_fn(|k| &u * &x[k] + &v * &y[k] - number(self.distance) * &z[k])
        })
        .collect()
    }
}

/// Hands all comparisons to the visitor.
pub fn visit(effort: Effort, visitor: &mut Visitor<'_>) {
    let columns = 8 * u32::try_from(effort.points).expect("a small number of points");
    let size = ImageSize::new(columns, 2).expect("an image with pixels");
    for view in &VIEWS {
        directions(view, size, visitor);
    }
    for (name, lean) in [("typical", 1.0), ("hard", 1e-4)] {
        frames(name, lean, effort.points, visitor);
    }
}

fn directions(view: &View, size: ImageSize, visitor: &mut Visitor<'_>) {
    let f64 = Image::<[f64; 3]>::new(view, size);
    let f32 = Image::<[f32; 3]>::new(view, size);
    let dvec3 = Image::<DVec3>::new(view, size);
    let vec3a = Image::<Vec3A>::new(view, size);
    let [wide, narrow] = [lazily(|| f64.exact()), lazily(|| f32.exact())];
    let rays = (size.columns() * size.rows()) as usize;
    let comparison = Comparison::new("direction of a pixel's ray", view.name, rays)
        .variant(["through s", "f64"], &wide, f64.through_s())
        .variant(["perspective_ray", "f64"], &wide, f64.centre_and_ray())
        .variant(["pixel_ray", "f64"], &wide, f64.pixel_ray())
        .variant(["start + i step", "f64"], &wide, f64.stepped())
        .variant(["added up", "f64"], &wide, f64.added())
        .variant(["perspective_ray", "DVec3"], &wide, dvec3.centre_and_ray())
        .variant(["pixel_ray", "DVec3"], &wide, dvec3.pixel_ray())
        .variant(["through s", "f32"], &narrow, f32.through_s())
        .variant(["perspective_ray", "f32"], &narrow, f32.centre_and_ray())
        .variant(["pixel_ray", "f32"], &narrow, f32.pixel_ray())
        .variant(["start + i step", "f32"], &narrow, f32.stepped())
        .variant(["added up", "f32"], &narrow, f32.added())
        .variant(
            ["perspective_ray", "Vec3A"],
            &narrow,
            vec3a.centre_and_ray(),
        )
        .variant(["pixel_ray", "Vec3A"], &narrow, vec3a.pixel_ray())
        .variant(["start + i step", "Vec3A"], &narrow, vec3a.stepped());
    visitor(comparison);
}

/// Views in all directions, with an up that leans away from the view by `lean` of its length.
fn views<P: CameraPoint>(lean: f64, count: usize) -> Vec<[P; 3]> {
    let view = |index: usize| {
        // Steps of the golden ratio and of its square root fill the square evenly.
        let part = |step: f64| (index as f64 * step).fract() - 0.5;
        let target = [part(0.618_034), part(0.786_151), part(0.414_214) + 1.0];
        let aside = [part(0.732_051), part(0.236_068), part(0.449_490)];
        let up = [0, 1, 2].map(|k| target[k] + lean * aside[k]);
        [[0.0; 3], target, up].map(P::rounded)
    };
    (0..count).map(view).collect()
}

/// One frame, three axes.
fn frames(name: &'static str, lean: f64, count: usize, visitor: &mut Visitor<'_>) {
    let (f64, f32) = (
        views::<[f64; 3]>(lean, count),
        views::<[f32; 3]>(lean, count),
    );
    let vec3a = views::<Vec3A>(lean, count);
    let [wide, narrow]: [Exact<'_>; 2] =
        [lazily(|| exact_frames(&f64)), lazily(|| exact_frames(&f32))];
    let comparison = Comparison::new("frame", name, count)
        .with_points_each(3)
        .variant(["textbook", "f64"], &wide, each(&f64, textbook))
        .variant(["look_at_axes", "f64"], &wide, each(&f64, library))
        .variant(["textbook", "f32"], &narrow, each(&f32, textbook))
        .variant(["look_at_axes", "f32"], &narrow, each(&f32, library))
        .variant(["look_at_axes", "Vec3A"], &narrow, each(&vec3a, library));
    visitor(comparison);
}

fn each<P: CameraPoint>(views: &[[P; 3]], axes: fn([P; 3]) -> [P; 3]) -> impl FnMut(&mut [P]) {
    move |all| {
        for (slots, view) in all.chunks_exact_mut(3).zip(views) {
            slots.copy_from_slice(&axes(*view));
        }
    }
}

fn textbook<P: CameraPoint>([eye, target, up]: [P; 3]) -> [P; 3] {
    textbook_axes(eye, target, up)
}

fn library<P: CameraPoint>([eye, target, up]: [P; 3]) -> [P; 3] {
    look_at_axes(eye, target, up).unwrap_or([P::origin(); 3])
}

fn exact_frames<P: CameraPoint>(views: &[[P; 3]]) -> Vec<ExactPoint> {
    let of_view = |view: &[P; 3]| {
        let [eye, target, up] = view.map(|point| big_point(coordinates(point)));
        let w = unit(&big_minus(&eye, &target));
        let u = unit(&big_cross(&up, &w));
        let v = big_cross(&w, &u);
        [u, v, w]
    };
    views.iter().flat_map(of_view).collect()
}

/// The unit vector to 60 digits, which is exact enough to measure errors of the sixteenth.
fn unit(vector: &ExactPoint) -> ExactPoint {
    let length = big_length(vector);
    std::array::from_fn(|k| shortened(&(&vector[k] / &length)))
}

/// The nearest multiple of 10⁻⁶⁰: without it numerators double with every operation.
fn shortened(value: &Big) -> Big {
    let scale = num_bigint::BigInt::from(10).pow(60);
    let scaled = value * Big::from_integer(scale.clone());
    let rounded = scaled.abs().round() * scaled.signum();
    Big::new(rounded.to_integer(), scale)
}
