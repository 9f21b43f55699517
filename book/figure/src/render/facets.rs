//! The triangles of a scene as the hierarchy of boxes wants them: single precision, around the origin, of size 1.

use facette::intersection::hierarchy::Hierarchy;
use facette::ray::Ray;
use glam::{DVec3, Vec3};

use super::scene::Object;
use super::view::{Lens, View};

/// Where the scene is put: its middle to the origin, and its size to about 1. There single precision resolves the 2⁻²⁴th part of it, wherever it came
/// from, and no product overflows.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Placement {
    centre: DVec3,
    /// A power of two, so that nothing is rounded by it.
    factor: f64,
}

impl Placement {
    /// The placement of the box around these points; infinite and NaN ones do not count.
    fn of(points: impl Iterator<Item = DVec3>) -> Self {
        let finite = points.filter(|point| point.is_finite());
        let around = finite.fold(None, |around: Option<[DVec3; 2]>, point| {
            let [low, high] = around.unwrap_or([point; 2]);
            Some([low.min(point), high.max(point)])
        });
        let [low, high] = around.unwrap_or_default();
        let half = (high * 0.5 - low * 0.5).max_element();
        Self {
            centre: low * 0.5 + high * 0.5,
            factor: 1.0 / power_of_two_below(half),
        }
    }

    fn place(&self, point: DVec3) -> DVec3 {
        (point - self.centre) * self.factor
    }

    /// The same view of the scene where it is put.
    pub(super) fn view(&self, view: &View) -> View {
        let lens = match view.lens {
            perspective @ Lens::Perspective { .. } => perspective,
            Lens::Orthographic { height } => Lens::Orthographic {
                height: height * self.factor,
            },
        };
        View {
            eye: self.place(view.eye),
            target: self.place(view.target),
            up: view.up,
            lens,
        }
    }
}

/// The largest power of two up to a number, between 2⁻¹⁰⁰⁰ and 2¹⁰⁰⁰, so that its reciprocal is one too.
fn power_of_two_below(number: f64) -> f64 {
    let clamped = number.clamp(1.0 / LARGEST_POWER, LARGEST_POWER);
    let exponent = clamped.to_bits() >> 52 << 52;
    f64::from_bits(exponent)
}

const LARGEST_POWER: f64 = f64::from_bits((1023 + 1000) << 52);

/// A triangle of the scene.
#[derive(Debug, Clone, Copy)]
pub(super) struct Facet {
    /// The number of the object that it belongs to.
    pub object: usize,
    /// Its number among the triangles of that object.
    pub triangle: usize,
    /// Where its corners are put.
    pub corners: [DVec3; 3],
}

impl Facet {
    /// A vector along the normal, as long as twice the area.
    pub(super) fn normal(&self) -> DVec3 {
        let [a, b, c] = self.corners;
        (b - a).cross(c - a)
    }

    /// How the weights of the corners change when a point of the facet moves along `step`.
    pub(super) fn weight_changes(&self, step: DVec3) -> [f64; 3] {
        let [a, b, c] = self.corners;
        let normal = self.normal();
        let square = normal.dot(normal);
        let second = step.dot((c - a).cross(normal)) / square;
        let third = step.dot(normal.cross(b - a)) / square;
        [-second - third, second, third]
    }
}

/// All triangles of a scene that can be seen, and the hierarchy over them.
#[derive(Debug)]
pub(super) struct Facets {
    pub list: Vec<Facet>,
    pub hierarchy: Hierarchy,
    pub placement: Placement,
}

impl Facets {
    /// The triangles of these objects, in order, those with a NaN or infinite corner left out.
    pub(super) fn new(objects: &[Object]) -> Self {
        let used = objects.iter().flat_map(|object| {
            let mesh = &object.mesh;
            let vertices = mesh.triangles.iter().flatten();
            vertices.map(|&vertex| mesh.positions[vertex as usize])
        });
        let placement = Placement::of(used);
        let mut list = Vec::new();
        for (number, object) in objects.iter().enumerate() {
            for (triangle, corners) in object.mesh.triangles.iter().enumerate() {
                let points = corners.map(|corner| object.mesh.positions[corner as usize]);
                if points.iter().all(|point| point.is_finite()) {
                    list.push(Facet {
                        object: number,
                        triangle,
                        corners: points.map(|point| placement.place(point)),
                    });
                }
            }
        }
        let single: Vec<_> = list
            .iter()
            .map(|facet| facet.corners.map(DVec3::as_vec3))
            .collect();
        let hierarchy = Hierarchy::new(&single)
            .expect("finite corners of size 1, and no more than memory holds");
        Self {
            list,
            hierarchy,
            placement,
        }
    }
}

/// No point of a scene that is put around the origin is farther from it: its coordinates are below 2, and 2√3 < 4.
const REACH: f64 = 4.0;

/// A ray in single precision that starts where it comes near the scene, and how much of t is left behind there.
///
/// So the rounding of origin and direction moves the ray by no more than a 2⁻²¹st part of the scene, however far away the eye is. Where all rays have one
/// direction the eye is nowhere, and what is behind it is seen too.
pub(super) fn single(ray: &Ray<DVec3>, is_parallel: bool) -> (Ray<Vec3>, f64) {
    let direction = ray.direction;
    let square = direction.length_squared();
    let before = -ray.origin.dot(direction) / square - REACH / square.sqrt();
    let left = if is_parallel { before } else { before.max(0.0) };
    let moved = Ray::new(ray.point(left).as_vec3(), direction.as_vec3());
    (moved, left)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scenes_of_any_size_are_put_around_the_origin() {
        for size in [1e-300, 1e-3, 1.0, 12.0, 1e300] {
            let corners = [
                DVec3::new(3.0, 4.0, 5.0),
                DVec3::new(5.0, 4.0, 5.5),
                DVec3::NAN,
            ];
            let points = corners.map(|corner| corner * size);
            let placement = Placement::of(points.into_iter());
            let [low, high] = [points[0], points[1]].map(|point| placement.place(point));
            let half = (high - low).max_element() / 2.0;
            assert!((1.0..2.0).contains(&half), "{size}: {half}");
            assert!((low + high).abs().max_element() <= 1e-15, "{size}");
        }
        let nothing = Placement::of(std::iter::empty());
        assert_eq!(nothing.place(DVec3::ZERO), DVec3::ZERO);
    }

    #[test]
    fn weights_change_along_the_edges_from_one_corner_to_the_other() {
        let corners = [
            DVec3::ZERO,
            DVec3::new(2.0, 0.0, 1.0),
            DVec3::new(1.0, 3.0, 0.0),
        ];
        let facet = Facet {
            object: 0,
            triangle: 0,
            corners,
        };
        for (step, expected) in [
            (corners[1], [-1.0, 1.0, 0.0]),
            (corners[2] - corners[1], [0.0, -1.0, 1.0]),
            (facet.normal(), [0.0; 3]),
        ] {
            let changes = facet.weight_changes(step);
            let far = changes
                .iter()
                .zip(expected)
                .map(|(change, expected)| change - expected);
            assert!(
                far.into_iter().all(|gap: f64| gap.abs() <= 1e-15),
                "{changes:?}"
            );
        }
    }

    #[test]
    fn rays_start_near_the_scene_and_never_behind_the_eye() {
        let down = DVec3::new(0.0, 0.0, -2.0);
        for (height, is_parallel, origin, left) in [
            (1e9, false, 4.0, 5e8 - 2.0),
            (1.0, false, 1.0, 0.0),
            (-9.0, false, -9.0, 0.0),
            (-9.0, true, 4.0, -6.5),
        ] {
            let ray = Ray::new(DVec3::new(0.25, 0.5, height), down);
            let expected = Ray::new(Vec3::new(0.25, 0.5, origin), down.as_vec3());
            assert_eq!(single(&ray, is_parallel), (expected, left));
        }
    }
}
