//! The theorems of the projections, over the rationals. The book shows their doc comments.

use facette::algebra::VectorSpace;
use facette::camera::{
    Pixel, orthographic_ray, perspective_ray, project_orthographic, project_perspective,
};
use num_traits::{One, Zero};

use crate::common::exact::{Exact, fraction};
use crate::common::law::{Broken, Law, Verdict, expect_equal};
use crate::inputs::{Point, Shot, hard_shots, number, shots};
use crate::suspects;

/// The image of a point that must have one.
fn image(shot: &Shot, point: Point) -> Result<[Exact; 2], Broken> {
    project_perspective(&shot.frame(), shot.distance, point).ok_or(Broken {
        expected: format!("an image of the point {point:?}, which is in front of the eye"),
        got: "None".to_owned(),
    })
}

/// **Projection undoes the ray.** Every point of a ray, $t>0$, appears at the place from which the ray was shot, under both projections.
///
/// Exercise: projection.
#[test]
fn projection_undoes_the_ray() {
    let name = "camera::projection_undoes_the_ray";
    Law::new(name, suspects::projection).holds(shots(), hard_shots(), |shot| {
        let (frame, place) = (shot.frame(), shot.place());
        for t in [fraction(1, 1_000_000), Exact::one(), fraction(7, 3)] {
            let on_ray = orthographic_ray(&frame, place).point(t);
            expect_equal(&place, &project_orthographic(&frame, on_ray))?;
            let on_ray = perspective_ray(&frame, shot.distance, place).point(t);
            expect_equal(&place, &image(shot, on_ray)?)?;
        }
        Ok(())
    });
}

/// **A projected point lies on its ray.** Project a point in front of the camera, and shoot the ray through its place: it passes through the point, at $t=z/D$ under the perspective projection and at $t=z$ under the orthographic one,
/// where $z$ is the depth of the point.
///
/// Exercise: projection.
#[test]
fn projected_point_lies_on_its_ray() {
    let name = "camera::projected_point_lies_on_its_ray";
    Law::new(name, suspects::projection).holds(shots(), hard_shots(), |shot| {
        let (frame, depth) = (shot.frame(), shot.points[0][2]);
        let [point, _] = shot.scene_points();
        let ray = orthographic_ray(&frame, project_orthographic(&frame, point));
        expect_equal(&point, &ray.point(depth))?;
        let ray = perspective_ray(&frame, shot.distance, image(shot, point)?);
        expect_equal(&point, &ray.point(depth / shot.distance))
    });
}

/// **What is behind has no image.** A point in the plane of the eye, or behind it, is on no ray with $t>0$ of a perspective camera, and has no image. The formula without this condition shows
/// what is behind the eye upside down.
///
/// Exercise: projection.
#[test]
fn point_behind_the_eye_has_no_image() {
    let name = "camera::point_behind_the_eye_has_no_image";
    Law::new(name, suspects::projection).holds(shots(), hard_shots(), |shot| {
        let [x, y, depth] = shot.points[0];
        let [orthographic, perspective] = shot.cameras();
        for behind in [Exact::zero(), depth] {
            let point = shot.at([x, y, behind]);
            let got = project_perspective(&shot.frame(), shot.distance, point);
            expect_equal(&None, &got)?;
            expect_equal(
                &[None; 2],
                &[&orthographic, &perspective].map(|c| c.project(point)),
            )?;
        }
        Ok(())
    });
}

/// **The image of a line is a line.** Let $A$ and $B$ be points in front of the eye at the depths $z_A$ and $z_B$, with the images $A'$ and $B'$. The point $(1-s)A+sB$ of their segment appears at
/// $(1-s')A'+s'B'$ with
/// $$s'=\frac{s\,z_B}{(1-s)\,z_A+s\,z_B}.$$
/// So a perspective image of a line is a line; but the middle of a segment is not in the middle of its image, unless both ends are equally deep. The orthographic image keeps the parameter, $s'=s$.
///
/// Exercise: projection.
#[test]
fn perspective_image_of_a_line_is_a_line() {
    let name = "camera::perspective_image_of_a_line_is_a_line";
    Law::new(name, suspects::projection).holds(shots(), hard_shots(), |shot| {
        let (frame, [a, b]) = (shot.frame(), shot.scene_points());
        let [z_a, z_b] = shot.points.map(|[.., depth]| depth);
        let [image_a, image_b] = [image(shot, a)?, image(shot, b)?];
        for s in [fraction(1, 2), shot.within[0]] {
            let between = a.lerp(b, s);
            let moved = s * z_b / ((Exact::one() - s) * z_a + s * z_b);
            expect_equal(&image_a.lerp(image_b, moved), &image(shot, between)?)?;
            let [flat_a, flat_b, flat] = [a, b, between].map(|p| project_orthographic(&frame, p));
            expect_equal(&flat_a.lerp(flat_b, s), &flat)?;
        }
        Ok(())
    });
}

/// **Vanishing points.** The lines of the direction $\mathbf g$, not parallel to the image plane, all have the same vanishing point (*point de fuite*)
/// $$V=-\frac D{\mathbf g\cdot\mathbf w}\,(\mathbf g\cdot\mathbf u,\;\mathbf g\cdot\mathbf v),$$
/// the image of $\mathbf e+\mathbf g$. On each of them the image runs towards $V$: at the depth $z$ it is $V+\tfrac{z_0}z(A'-V)$, if the line is at $A'$ at the depth $z_0$.
///
/// Exercise: projection.
#[test]
fn parallel_lines_meet_at_their_vanishing_point() {
    let name = "camera::parallel_lines_meet_at_their_vanishing_point";
    Law::new(name, suspects::projection).holds(shots(), hard_shots(), |shot| {
        // The second point gives the direction of the lines; its depth is positive, so they run away from the eye.
        let [_, [g_u, g_v, g_z]] = shot.points;
        let vanishing = [g_u, g_v].map(|g| shot.distance * g / g_z);
        let direction = shot.scene_points()[1].minus(shot.eye);
        expect_equal(&vanishing, &image(shot, shot.eye.plus(direction))?)?;
        let first = shot.points[0];
        let second = [first[0] + fraction(3, 2), first[1] - Exact::one(), first[2]];
        for [x, y, z_0] in [first, second] {
            let start = shot.at([x, y, -z_0]);
            let image_of_start = image(shot, start)?;
            for s in [1, 1000, 1_000_000_000].map(|s| fraction(s, 1)) {
                let z = z_0 + s * g_z;
                let expected = vanishing.lerp(image_of_start, z_0 / z);
                expect_equal(&expected, &image(shot, start.plus(direction.times(s)))?)?;
            }
        }
        Ok(())
    });
}

/// **Lines parallel to the image plane stay parallel.** If $\mathbf g\cdot\mathbf w=0$, the images of the lines of the direction $\mathbf g$ are parallel to each other, of the direction
/// $(\mathbf g\cdot\mathbf u,\mathbf g\cdot\mathbf v)$, and what is twice as far away appears half as large.
///
/// Exercise: projection.
#[test]
fn lines_parallel_to_the_image_plane_stay_parallel() {
    let name = "camera::lines_parallel_to_the_image_plane_stay_parallel";
    Law::new(name, suspects::projection).holds(shots(), hard_shots(), |shot| {
        let [[x, y, z], [g_u, g_v, _]] = shot.points;
        for depth in [z, z + z] {
            let [start, end] = [[x, y, -depth], [x + g_u, y + g_v, -depth]].map(|p| shot.at(p));
            let [from, to] = [image(shot, start)?, image(shot, end)?];
            let expected = [g_u, g_v].map(|g| shot.distance * g / depth);
            expect_equal(&expected, &to.minus(from))?;
        }
        Ok(())
    });
}

/// **From the pixel into the scene and back.** A point on the ray of the pixel in column $i$ and row $j$ appears in the image file $i+\tfrac12$ pixels from the left and
/// $n_y-j-\tfrac12$ pixels from the *top*.
#[test]
fn position_in_the_file_is_the_pixel_centre() {
    let name = "camera::position_in_the_file_is_the_pixel_centre";
    Law::new(name, suspects::library).holds(shots(), hard_shots(), |shot| {
        let (size, half) = (shot.size(), fraction(1, 2));
        let Pixel { column, row } = shot.pixel();
        let expected = [number(column) + half, number(size.rows() - row) - half];
        for camera in shot.cameras() {
            let on_ray = camera.pixel_ray(size, shot.pixel()).point(fraction(7, 5));
            expect_equal(&Some(expected), &camera.position_in_file(size, on_ray))?;
        }
        coordinates_and_points_agree(shot)
    });
}

/// The frame's coordinates and its points are inverse to each other.
fn coordinates_and_points_agree(shot: &Shot) -> Verdict {
    let frame = shot.frame();
    let coordinates = frame.coordinates(shot.points[0]);
    expect_equal(&shot.points[0], &frame.point(coordinates))
}
