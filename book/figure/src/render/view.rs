//! From where a scene is seen: a camera of the library, with lights at its sides.

use facette::camera::{
    Camera, CameraFrame, ImageRectangle, ImageSize, Pixel, Projection, project_orthographic,
    project_perspective,
};
use facette::ray::Ray;
use glam::DVec3;

use super::geometry::cos_sin;

/// From where, in which direction and through which lens a scene is seen.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct View {
    /// The position of the eye.
    pub eye: DVec3,
    /// The point seen in the middle of the picture.
    pub target: DVec3,
    /// The direction that points up in the picture.
    pub up: DVec3,
    /// What of the scene the picture's height takes in.
    pub lens: Lens,
}

/// The whole vertical angle of [`View::around`], in degrees: little enough that what is near is not drawn much larger.
const FIELD_OF_VIEW: f64 = 30.0;

/// So much of the picture's width and height [`View::around`] fills at most.
const FILLED: f64 = 0.94;

/// What of the scene the picture's height takes in.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Lens {
    /// Central projection; the whole vertical angle in degrees, between 0 and 180.
    Perspective {
        /// The angle between the lowest and the highest ray, in degrees.
        field_of_view: f64,
    },
    /// Parallel projection, of what is behind the eye too.
    Orthographic {
        /// The height of the picture in units of the scene.
        height: f64,
    },
}

impl View {
    /// The central projection with a whole vertical angle in degrees.
    #[must_use]
    pub fn perspective(eye: DVec3, target: DVec3, up: DVec3, field_of_view: f64) -> Self {
        Self {
            eye,
            target,
            up,
            lens: Lens::Perspective { field_of_view },
        }
    }

    /// The parallel projection of this height in units of the scene.
    #[must_use]
    pub fn orthographic(eye: DVec3, target: DVec3, up: DVec3, height: f64) -> Self {
        Self {
            eye,
            target,
            up,
            lens: Lens::Orthographic { height },
        }
    }

    /// The central projection that looks against `towards`, with y up, from as near as lets all these points into the middle of a picture of
    /// this size, with a little room around them: the way to look at a model of which nothing is known.
    ///
    /// # Edge cases
    /// With no points, or all in one place, there is nothing to see.
    #[must_use]
    pub fn around(points: &[DVec3], towards: DVec3, [width, height]: [u32; 2]) -> Self {
        let back = towards.try_normalize().unwrap_or(DVec3::Z);
        let right = DVec3::Y.cross(back).try_normalize().unwrap_or(DVec3::X);
        let up = back.cross(right);
        let (cos, sin) = cos_sin(FIELD_OF_VIEW / 720.0);
        let rise = FILLED * (sin / cos);
        let slopes = [rise * f64::from(width) / f64::from(height), rise];
        // A point at (x, z) is within the slope s of an eye at (a, c) if x − a and a − x are at most s(c − z).
        let ends = [right, up].into_iter().zip(slopes).map(|(axis, slope)| {
            let ends = [axis, -axis].map(|axis| {
                let reach = |point: &DVec3| point.dot(axis) + slope * point.dot(back);
                points.iter().map(reach).reduce(f64::max).unwrap_or(0.0)
            });
            (
                axis * (0.5 * ends[0] - 0.5 * ends[1]),
                (0.5 * ends[0] + 0.5 * ends[1]) / slope,
            )
        });
        let (mut aside, mut distance) = (DVec3::ZERO, f64::NEG_INFINITY);
        for (offset, needed) in ends {
            aside += offset;
            distance = distance.max(needed);
        }
        let depths = points.iter().map(|point| point.dot(back));
        // A target as far away as the points are: one nearby would be lost in the rounding of a distant eye.
        let depth = depths.reduce(f64::min).unwrap_or(0.0);
        let [eye, target] = [distance, depth].map(|along| aside + back * along);
        Self::perspective(eye, target, up, FIELD_OF_VIEW)
    }

    /// Where a point appears in a picture of this size, in pixels from the upper left corner; `None` for a point beside
    /// or behind the eye, and where the view is no camera or the picture has no pixels. For labels drawn over a picture.
    #[must_use]
    pub fn project(&self, point: DVec3, width: u32, height: u32) -> Option<[f64; 2]> {
        let Sight { camera, size, .. } = Sight::new(self, width, height)?;
        let [u, v] = match camera.projection() {
            Projection::Orthographic => project_orthographic(camera.frame(), point),
            Projection::Perspective { distance } => {
                project_perspective(camera.frame(), distance, point)?
            }
        };
        let image = camera.rectangle();
        Some([
            f64::from(size.columns()) * ((u - image.left()) / image.width()),
            f64::from(size.rows()) * ((image.top() - v) / image.height()),
        ])
    }
}

/// A view made ready for a picture of a certain size.
#[derive(Debug, Clone, Copy)]
pub(super) struct Sight {
    camera: Camera<DVec3>,
    size: ImageSize,
    lights: [DVec3; 2],
}

impl Sight {
    /// `None` for a view that is no camera (a coordinate that is not finite, an angle of 0) and for a picture without pixels.
    pub(super) fn new(view: &View, width: u32, height: u32) -> Option<Self> {
        let size = ImageSize::new(width, height).ok()?;
        let frame = frame(view)?;
        let aspect = f64::from(width) / f64::from(height);
        let image = |height: f64| ImageRectangle::centred(aspect * height, height).ok();
        let camera = match view.lens {
            Lens::Perspective { field_of_view } => {
                // Not by the library's angle in radians: sine and cosine differ from one system to another.
                let (cos, sin) = cos_sin(field_of_view / 720.0);
                Camera::perspective(frame, image(2.0 * (sin / cos))?, 1.0).ok()?
            }
            Lens::Orthographic { height } => Camera::orthographic(frame, image(height)?),
        };
        let [right, up, back] = frame.axes();
        let lights = [
            -0.45 * right + 0.65 * up + 0.8 * back,
            0.8 * right - 0.2 * up + 0.5 * back,
        ];
        Some(Self {
            camera,
            size,
            lights: lights.map(DVec3::normalize),
        })
    }

    /// How many columns and rows the picture has.
    pub(super) fn size(&self) -> ImageSize {
        self.size
    }

    /// The directions towards the key light and the fill light.
    pub(super) fn lights(&self) -> [DVec3; 2] {
        self.lights
    }

    /// Whether all rays have one direction.
    pub(super) fn is_parallel(&self) -> bool {
        self.camera.projection() == Projection::Orthographic
    }

    /// The ray through a point of a pixel, `[0, 0]` being its lower left corner.
    pub(super) fn ray(&self, pixel: Pixel, within: [f64; 2]) -> Ray<DVec3> {
        self.camera.pixel_sample_ray(self.size, pixel, within)
    }

    /// How the point of the image plane moves when the place in the picture moves by a pixel to the right, or by one up.
    pub(super) fn pixel_steps(&self) -> [DVec3; 2] {
        let [right, up, _] = self.camera.frame().axes();
        let image = self.camera.rectangle();
        let [columns, rows] = [self.size.columns(), self.size.rows()].map(f64::from);
        [
            right * (image.width() / columns),
            up * (image.height() / rows),
        ]
    }
}

/// The frame of the view. Directions that fail to span one (eye at the target, up along the view) are replaced by others.
fn frame(view: &View) -> Option<CameraFrame<DVec3>> {
    let View {
        eye, target, up, ..
    } = *view;
    CameraFrame::looking_at(eye, target, up)
        .or_else(|_| CameraFrame::looking_at_with_any_up(eye, target))
        .or_else(|_| CameraFrame::from_axes(eye, [DVec3::X, DVec3::Y, DVec3::Z]))
        .ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_target_is_in_the_middle_and_the_field_of_view_spans_the_height() {
        let view = View::perspective(DVec3::new(0.0, 0.0, 2.0), DVec3::ZERO, DVec3::Y, 90.0);
        assert_eq!(view.project(DVec3::ZERO, 80, 60), Some([40.0, 30.0]));
        let [x, y] = view
            .project(DVec3::new(0.0, 2.0, 0.0), 80, 60)
            .expect("in front of the eye");
        // At 45° the height's half is seen at the distance 2: y = 30 - 30 · cot 45°, three roundings of 30.
        assert!((x - 40.0).abs() <= 1e-13 && y.abs() <= 1e-13, "{x} {y}");
        assert_eq!(view.project(DVec3::new(0.0, 0.0, 3.0), 80, 60), None);
    }

    #[test]
    fn a_view_around_points_fills_the_picture_with_them_and_cuts_none_off() {
        let points: Vec<DVec3> = (0..60)
            .map(|i| {
                let (cos, sin) = cos_sin(f64::from(i) / 7.3);
                DVec3::new(cos, 0.02 * f64::from(i), 3.0 * sin) * 1e4
            })
            .collect();
        for [width, height] in [[400, 300], [200, 500], [640, 120]] {
            let view = View::around(&points, DVec3::new(0.5, 0.4, 1.0), [width, height]);
            let [half_width, half_height] = [width, height].map(|size| f64::from(size) / 2.0);
            let projected = points
                .iter()
                .map(|&point| view.project(point, width, height));
            let places = projected.map(|place| place.expect("before the eye"));
            let part = |[x, y]: [f64; 2]| {
                [
                    (x - half_width) / half_width,
                    (y - half_height) / half_height,
                ]
            };
            let parts: Vec<[f64; 2]> = places.map(part).collect();
            let ends = [0, 1].map(|axis| {
                let along = || parts.iter().map(|part| part[axis]);
                [
                    along().fold(f64::MAX, f64::min),
                    along().fold(f64::MIN, f64::max),
                ]
            });
            // A dozen roundings of numbers up to a few times the points' extent.
            let bound = 1e-13;
            let is_filled = |[low, high]: [f64; 2]| {
                (low + FILLED).abs() <= bound && (high - FILLED).abs() <= bound
            };
            let is_inside =
                |[low, high]: [f64; 2]| -FILLED - bound <= low && high <= FILLED + bound;
            assert!(
                ends.into_iter().any(is_filled) && ends.into_iter().all(is_inside),
                "{ends:?}"
            );
        }
    }

    #[test]
    fn parallel_projection_ignores_the_distance() {
        let view = View::orthographic(DVec3::Z, DVec3::ZERO, DVec3::Y, 4.0);
        for z in [-9.0, 0.0, 9.0] {
            assert_eq!(
                view.project(DVec3::new(1.0, 1.0, z), 80, 80),
                Some([60.0, 20.0])
            );
        }
    }

    #[test]
    fn a_view_along_its_own_up_direction_still_has_a_frame() {
        for (eye, up) in [
            (DVec3::Z, DVec3::Z),
            (DVec3::ZERO, DVec3::Y),
            (DVec3::Z, DVec3::ZERO),
        ] {
            let view = View::orthographic(eye, DVec3::ZERO, up, 1.0);
            let [right, up, back] = frame(&view).expect("finite numbers").axes();
            assert_eq!(right.cross(up), back);
        }
    }

    #[test]
    fn what_is_no_camera_or_no_picture_projects_nothing() {
        let view = View::orthographic(DVec3::Z, DVec3::ZERO, DVec3::Y, 1.0);
        let flat = View {
            lens: Lens::Orthographic { height: 0.0 },
            ..view
        };
        let closed = View::perspective(DVec3::Z, DVec3::ZERO, DVec3::Y, 0.0);
        let nowhere = View {
            eye: DVec3::NAN,
            ..view
        };
        for (view, width) in [(flat, 4), (closed, 4), (nowhere, 4), (view, 0)] {
            assert_eq!(view.project(DVec3::ZERO, width, 4), None);
        }
    }
}
