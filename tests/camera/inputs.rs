//! Cameras over the rationals, ordinary and hard, for the tests of this chapter.

use facette::algebra::{Scalar, VectorSpace};
use facette::camera::{Camera, CameraFrame, ImageRectangle, ImageSize, Pixel};
use num_traits::{One, Zero};
use proptest::prelude::*;

use crate::common::exact::{Exact, fraction};
use crate::common::generators::{coordinate, parameter, point};
use crate::common::motion::IntegerMotion;

/// A point of space over the rationals.
pub type Point = [Exact; 3];

/// A camera, a pixel of its image, and two points of the scene in front of it.
#[derive(Clone, Debug)]
pub struct Shot {
    /// The quaternion whose rotation gives the axes: rational ones, by the parametrisation of Euler and Rodrigues.
    pub quaternion: [i32; 4],
    /// The eye.
    pub eye: Point,
    /// How far the image plane lies before it.
    pub distance: Exact,
    /// The left and the lower border.
    pub corner: [Exact; 2],
    /// The width and the height of the rectangle.
    pub extent: [Exact; 2],
    /// The number of columns and rows.
    pub pixels: [u32; 2],
    /// The column and the row, as parts of those numbers.
    pub pixel: [Exact; 2],
    /// A place inside the pixel.
    pub within: [Exact; 2],
    /// Two points by their coordinates in the frame: to the right, above, and in front.
    pub points: [Point; 2],
}

/// The axes of the rotation by a quaternion that is not zero: rational numbers, orthonormal and right-handed.
pub fn rotation(quaternion: [i32; 4]) -> [Point; 3] {
    IntegerMotion::new(quaternion, [0; 3]).axes()
}

impl Shot {
    /// The frame.
    pub fn frame(&self) -> CameraFrame<Point> {
        CameraFrame::from_axes(self.eye, rotation(self.quaternion)).expect("a rotation")
    }

    /// The rectangle of the image.
    pub fn rectangle(&self) -> ImageRectangle<Exact> {
        let ([l, b], [width, height]) = (self.corner, self.extent);
        ImageRectangle::new(l, l + width, b, b + height).expect("positive extents")
    }

    /// The size of the image.
    pub fn size(&self) -> ImageSize {
        let [columns, rows] = self.pixels;
        ImageSize::new(columns, rows).expect("a pixel at least")
    }

    /// The pixel.
    pub fn pixel(&self) -> Pixel {
        let index = |part: Exact, count: u32| {
            (0..count)
                .rev()
                .find(|&index| number(index) <= part * number(count))
                .unwrap_or(0)
        };
        let [columns, rows] = self.pixels;
        // A large image is looked at in its first and last pixels, which need no search.
        let [column, row] = if columns.max(rows) > 64 {
            [columns - 1, 0]
        } else {
            [index(self.pixel[0], columns), index(self.pixel[1], rows)]
        };
        Pixel { column, row }
    }

    /// The camera with each of the two projections.
    pub fn cameras(&self) -> [Camera<Point>; 2] {
        let (frame, rectangle) = (self.frame(), self.rectangle());
        let perspective = Camera::perspective(frame, rectangle, self.distance);
        [
            Camera::orthographic(frame, rectangle),
            perspective.expect("a positive distance"),
        ]
    }

    /// A place of the image plane, inside the rectangle.
    pub fn place(&self) -> [Exact; 2] {
        [0, 1].map(|axis| self.corner[axis] + self.extent[axis] * self.pixel[axis])
    }

    /// The two points of the scene.
    pub fn scene_points(&self) -> [Point; 2] {
        self.points.map(|[x, y, z]| self.frame().point([x, y, -z]))
    }

    /// The point `e + u u + v v + w w`, written out: what the rays are compared with.
    pub fn at(&self, [x, y, z]: Point) -> Point {
        let [u, v, w] = rotation(self.quaternion);
        let sum = |k: usize| self.eye[k] + x * u[k] + y * v[k] + z * w[k];
        [sum(0), sum(1), sum(2)]
    }
}

/// The whole number `value`.
pub fn number(value: u32) -> Exact {
    Exact::from_i32(i32::try_from(value).expect("a small number"))
}

/// A positive number of ordinary size.
pub fn positive() -> impl Strategy<Value = Exact> {
    (1..=12, 1..=6).prop_map(|(numerator, denominator)| fraction(numerator, denominator))
}

fn scene_point(depth: impl Strategy<Value = Exact>) -> impl Strategy<Value = Point> {
    (coordinate(), coordinate(), depth).prop_map(|(x, y, z)| [x, y, z])
}

fn shots_of(
    quaternion: impl Strategy<Value = [i32; 4]>,
    eye: impl Strategy<Value = Point>,
    [distance, extent]: [BoxedStrategy<Exact>; 2],
    pixels: impl Strategy<Value = [u32; 2]>,
) -> impl Strategy<Value = Shot> {
    let image = ([coordinate(), coordinate()], [extent.clone(), extent]);
    let place = ([parameter(), parameter()], [parameter(), parameter()]);
    let points = [scene_point(distance.clone()), scene_point(distance.clone())];
    (quaternion, eye, distance, image, pixels, place, points).prop_map(
        |(quaternion, eye, distance, (corner, extent), pixels, (pixel, within), points)| Shot {
            quaternion,
            eye,
            distance,
            corner,
            extent,
            pixels,
            pixel,
            within,
            points,
        },
    )
}

/// Cameras in general position, with images of up to 12 by 12 pixels and rectangles that are hardly ever centred.
pub fn shots() -> impl Strategy<Value = Shot> {
    let quaternion = (1..=4, [-4..=4, -4..=4, -4..=4]).prop_map(|(a, [b, c, d])| [a, b, c, d]);
    let sizes = [positive().boxed(), positive().boxed()];
    shots_of(quaternion, point(), sizes, [1..=12_u32, 1..=12_u32])
}

/// Cameras that look along an axis or nearly so, from far away, with image planes at tiny and huge distances, images of one pixel, one
/// row, or the largest number of columns.
pub fn hard_shots() -> impl Strategy<Value = Shot> {
    const FAR: i32 = 1_000_000_007;
    let quaternion = prop::sample::select(vec![
        [1, 0, 0, 0],
        [0, 1, 0, 0],
        [0, 0, 1, 0],
        [1, 1, 0, 0],
        [1, 0, -1, 0],
        [1000, 1, 0, 0],
        [1, 1, 1, 1],
    ]);
    let far = prop::sample::select(vec![
        [fraction(FAR, 1), fraction(-FAR, 3), fraction(FAR, 7)],
        [Exact::zero(); 3],
        [fraction(1, FAR); 3],
    ]);
    let extreme = || {
        prop::sample::select(vec![
            fraction(1, FAR),
            Exact::one(),
            fraction(FAR, 1),
            fraction(1, 3),
        ])
        .boxed()
    };
    let pixels = prop::sample::select(vec![[1, 1], [7, 1], [1, 9], [ImageSize::LARGEST, 1]]);
    shots_of(quaternion, far, [extreme(), extreme()], pixels)
}

/// A rigid motion: the quaternion of its rotation, and its translation.
pub fn motion() -> impl Strategy<Value = ([i32; 4], Point)> {
    let quaternion = (1..=3, [-3..=3, -3..=3, -3..=3]).prop_map(|(a, [b, c, d])| [a, b, c, d]);
    (quaternion, point())
}

/// The sum of products of coordinates.
pub fn dot(a: Point, b: Point) -> Exact {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// The point moved by a rotation and a translation.
pub fn moved(quaternion: [i32; 4], by: Point, point: Point) -> Point {
    let turned = IntegerMotion::new(quaternion, [0; 3]).turned(point);
    turned.plus(by)
}
