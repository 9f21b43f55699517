//! The theorems of the two kinds of rays, over the rationals. The book shows their doc comments.

use facette::algebra::{Scalar, VectorSpace};
use facette::camera::{
    Camera, CameraFrame, ImageRectangle, Pixel, orthographic_ray, perspective_ray,
};
use num_traits::{One, Zero};

use crate::common::exact::{Exact, fraction};
use crate::common::law::{Law, expect_equal};
use crate::inputs::{Point, dot, hard_shots, motion, moved, number, positive, rotation, shots};
use crate::suspects;

/// **Orthographic rays.** The ray through the place $(u,v)$ begins at $\mathbf e+u\,\mathbf u+v\,\mathbf v$, on the plane through the eye, and runs along $-\mathbf w$. So all
/// rays are parallel, and their directions are unit.
///
/// Course: R01, slide 88, Orthographic rays: p = e + u u + v v and d = −w.
/// Exercise: rays.
#[test]
fn orthographic_rays_are_parallel() {
    let law = Law::new("camera::orthographic_rays_are_parallel", suspects::rays);
    law.holds(shots(), hard_shots(), |shot| {
        let [u, v] = shot.place();
        let ray = orthographic_ray(&shot.frame(), [u, v]);
        let back = rotation(shot.quaternion)[2];
        expect_equal(&shot.at([u, v, Exact::zero()]), &ray.origin)?;
        expect_equal(&back.map(|coordinate| -coordinate), &ray.direction)
    });
}

/// **Perspective rays.** The ray through the place $(u,v)$ begins at the eye and is on the image plane at $t=1$, in the point
/// $\mathbf s=\mathbf e+u\,\mathbf u+v\,\mathbf v-D\,\mathbf w$. The slides write $d$ for the distance $D$ of the image plane, and $\mathbf d$ for the direction.
///
/// Course: R02, slide 90, Perspective rays: s = e + u u + v v − d w, p = e and d = s − e.
/// Exercise: rays.
#[test]
fn perspective_rays_reach_the_image_plane_at_one() {
    let name = "camera::perspective_rays_reach_the_image_plane_at_one";
    Law::new(name, suspects::rays).holds(shots(), hard_shots(), |shot| {
        let [u, v] = shot.place();
        let ray = perspective_ray(&shot.frame(), shot.distance, [u, v]);
        expect_equal(&shot.eye, &ray.origin)?;
        expect_equal(&shot.at([u, v, -shot.distance]), &ray.point(Exact::one()))
    });
}

/// **A direction that is not unit.** The direction of a perspective ray has the length $\sqrt{u^2+v^2+D^2}$, more for a pixel at the border than for one in the middle.
/// So the parameters $t$ of two rays are no distances, and cannot be compared; but $t\,D$ is the depth of the point in front of the eye on each of them.
///
/// Course: R02, slide 90, Perspective rays: the direction is not unit.
/// Exercise: rays.
#[test]
fn direction_is_not_unit_but_counts_depth() {
    let name = "camera::direction_is_not_unit_but_counts_depth";
    Law::new(name, suspects::rays).holds(shots(), hard_shots(), |shot| {
        let [u, v] = shot.place();
        let distance = shot.distance;
        let ray = perspective_ray(&shot.frame(), distance, [u, v]);
        let squared = u * u + v * v + distance * distance;
        expect_equal(&squared, &dot(ray.direction, ray.direction))?;
        let t = shot.within[0];
        let [_, _, behind] = shot.frame().coordinates(ray.point(t));
        expect_equal(&(t * distance), &-behind)
    });
}

/// **Corners.** The rays through the four corners of the outer pixels pass through the corners of the image rectangle: under the orthographic projection they begin there,
/// under the perspective one they are there at $t=1$. It does not matter whether the rectangle lies around the origin.
///
/// Course: R03, slide 91, From the pixel to the image: the borders l, r, b, t.
#[test]
fn corner_rays_pass_through_the_corners() {
    let law = Law::new(
        "camera::corner_rays_pass_through_the_corners",
        suspects::library,
    );
    law.holds(shots(), hard_shots(), |shot| {
        let [orthographic, perspective] = shot.cameras();
        let ([l, b], [width, height]) = (shot.corner, shot.extent);
        let [last_column, last_row] = shot.pixels.map(|count| count - 1);
        for [x, y] in [[0, 0], [1, 0], [1, 1], [0, 1]] {
            let pixel = Pixel {
                column: x * last_column,
                row: y * last_row,
            };
            let [x, y] = [x, y].map(number);
            let [u, v] = [l + x * width, b + y * height];
            let sample =
                |camera: &Camera<Point>| camera.pixel_sample_ray(shot.size(), pixel, [x, y]);
            let got = [
                sample(&orthographic).point(Exact::zero()),
                sample(&perspective).point(Exact::one()),
            ];
            let expected = [Exact::zero(), -shot.distance].map(|z| shot.at([u, v, z]));
            expect_equal(&expected, &got)?;
        }
        Ok(())
    });
}

/// **Rigid motions.** If the frame is turned and shifted, its rays are turned and shifted with it, and nothing else happens: origin and direction of the moved camera's rays are
/// the moved origin and the turned direction, at the same $t$.
#[test]
fn moving_the_frame_moves_the_rays() {
    let name = "camera::moving_the_frame_moves_the_rays";
    Law::new(name, suspects::rays).holds(
        (shots(), motion()),
        (hard_shots(), motion()),
        |(shot, (quaternion, by))| {
            let motion = |point| moved(*quaternion, *by, point);
            let turn = |vector| moved(*quaternion, [Exact::zero(); 3], vector);
            let frame = shot.frame();
            let moved = CameraFrame::from_axes(motion(frame.eye()), frame.axes().map(turn));
            let moved = moved.expect("a rigid motion keeps a frame orthonormal");
            for (still, moved) in [
                [frame, moved].map(|frame| orthographic_ray(&frame, shot.place())),
                [frame, moved].map(|frame| perspective_ray(&frame, shot.distance, shot.place())),
            ]
            .map(|[still, moved]| (still, moved))
            {
                expect_equal(&motion(still.origin), &moved.origin)?;
                expect_equal(&turn(still.direction), &moved.direction)?;
            }
            Ok(())
        },
    );
}

/// **Only the ratio counts.** An image plane $k$ times as far away with a rectangle $k$ times as large gives the same picture: the ray of each pixel keeps its origin, and its
/// direction is $k$ times as long. So the distance is a matter of taste, and a field of view says all.
#[test]
fn larger_image_plane_farther_away_gives_the_same_picture() {
    let name = "camera::larger_image_plane_farther_away_gives_the_same_picture";
    let scaled = (shots(), positive());
    Law::new(name, suspects::library).holds(scaled, (hard_shots(), positive()), |(shot, k)| {
        let [_, near] = shot.cameras();
        let rectangle = shot.rectangle();
        let borders = [
            rectangle.left(),
            rectangle.right(),
            rectangle.bottom(),
            rectangle.top(),
        ];
        let [l, r, b, t] = borders.map(|border| border * *k);
        let rectangle = ImageRectangle::new(l, r, b, t).expect("a larger rectangle");
        let far = Camera::perspective(shot.frame(), rectangle, shot.distance * *k);
        let far = far.expect("a positive distance");
        let [near, far] = [near, far].map(|camera| camera.pixel_ray(shot.size(), shot.pixel()));
        expect_equal(&near.origin, &far.origin)?;
        expect_equal(&near.direction.times(*k), &far.direction)
    });
}

/// **The orthographic projection is the limit of the perspective one.** Move the eye back by $D$ and put the image plane at the distance $D$, where the eye was. At the depth $z$ behind the
/// image plane, the perspective ray of a place $(u,v)$ is beside the orthographic ray by exactly $\tfrac zD(u\,\mathbf u+v\,\mathbf v)$, which goes to zero as $D$ grows.
#[test]
fn orthographic_is_the_limit_of_perspective() {
    let name = "camera::orthographic_is_the_limit_of_perspective";
    let law = Law::new(name, suspects::rays);
    law.holds(shots(), hard_shots(), |shot| {
        let [u, v] = shot.place();
        let frame = shot.frame();
        let [right, up, back] = frame.axes();
        let depth = fraction(5, 3);
        for distance in [1, 1000, 1_000_000_000].map(Exact::from_i32) {
            let eye = shot.eye.plus(back.times(distance));
            let behind = CameraFrame::from_axes(eye, frame.axes()).expect("the same axes");
            let perspective = perspective_ray(&behind, distance, [u, v]);
            let there = perspective.point((distance + depth) / distance);
            let straight = orthographic_ray(&frame, [u, v]).point(depth);
            let beside = right.times(u).plus(up.times(v)).times(depth / distance);
            expect_equal(&beside, &there.minus(straight))?;
        }
        Ok(())
    });
}
