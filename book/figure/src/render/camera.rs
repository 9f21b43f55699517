//! From points of the scene to pixels.

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

/// What of the scene the picture's height takes in.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Lens {
    /// Central projection; the whole vertical angle in degrees, between 0 and 180.
    Perspective {
        /// The angle between the lowest and the highest ray, in degrees.
        field_of_view: f64,
    },
    /// Parallel projection.
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

    /// Where a point appears in a picture of this size, in pixels from the upper left corner; `None` for a point beside
    /// or behind the eye. For labels drawn over a picture.
    #[must_use]
    pub fn project(&self, point: DVec3, width: u32, height: u32) -> Option<[f64; 2]> {
        let DVec3 { x, y, z: w } = Camera::new(self, width, height).homogeneous(point);
        (w > 0.0).then(|| [x / w, y / w])
    }
}

/// A view made ready for a picture of a certain size.
#[derive(Debug, Clone, Copy)]
pub(super) struct Camera {
    eye: DVec3,
    right: DVec3,
    up: DVec3,
    back: DVec3,
    is_perspective: bool,
    /// Pixels for a unit of the scene: at distance 1 from the eye, or everywhere.
    scale: f64,
    centre: [f64; 2],
    lights: [DVec3; 2],
}

impl Camera {
    /// Directions that fail to span a frame (eye at the target, up along the view) are replaced by arbitrary ones.
    pub(super) fn new(view: &View, width: u32, height: u32) -> Self {
        let back = (view.eye - view.target).try_normalize().unwrap_or(DVec3::Z);
        let right = view
            .up
            .cross(back)
            .try_normalize()
            .unwrap_or_else(|| back.any_orthonormal_vector());
        let half_height = f64::from(height) / 2.0;
        let (is_perspective, scale) = match view.lens {
            Lens::Perspective { field_of_view } => {
                let (cos, sin) = cos_sin(field_of_view / 720.0);
                (true, half_height * cos / sin)
            }
            Lens::Orthographic { height } => (false, 2.0 * half_height / height),
        };
        let centre = [f64::from(width) / 2.0, half_height];
        let up = back.cross(right);
        let lights = [
            -0.45 * right + 0.65 * up + 0.8 * back,
            0.8 * right - 0.2 * up + 0.5 * back,
        ];
        Self {
            eye: view.eye,
            right,
            up,
            back,
            is_perspective,
            scale,
            centre,
            lights: lights.map(DVec3::normalize),
        }
    }

    /// The directions towards the key light and the fill light.
    pub(super) fn lights(&self) -> [DVec3; 2] {
        self.lights
    }

    /// `(x, y, w)` such that the point appears at the pixel position `(x/w, y/w)`, if w > 0.
    pub(super) fn homogeneous(&self, point: DVec3) -> DVec3 {
        let relative = point - self.eye;
        let w = if self.is_perspective {
            self.depth(point)
        } else {
            1.0
        };
        let x = self.scale * relative.dot(self.right) + w * self.centre[0];
        let y = -self.scale * relative.dot(self.up) + w * self.centre[1];
        DVec3::new(x, y, w)
    }

    /// The distance from the plane of the eye, positive in front.
    pub(super) fn depth(&self, point: DVec3) -> f64 {
        -(point - self.eye).dot(self.back)
    }

    /// The unit vector from a point towards the eye.
    pub(super) fn direction_from(&self, point: DVec3) -> DVec3 {
        if self.is_perspective {
            (self.eye - point).try_normalize().unwrap_or(self.back)
        } else {
            self.back
        }
    }
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
        let view = View::orthographic(DVec3::Z, DVec3::ZERO, DVec3::Z, 1.0);
        let Camera {
            right, up, back, ..
        } = Camera::new(&view, 4, 4);
        assert_eq!(right.cross(up), back);
    }
}
