//! What is to be rendered, and from where.

use glam::DVec3;

use super::geometry::Triangles;
use super::material::Material;
use super::picture::Picture;
use super::trace;
use super::view::View;
use crate::palette::Colour;

/// Surfaces, curves and points, seen from somewhere.
///
/// # Examples
/// ```
/// use facette_figure::palette::Colour;
/// use facette_figure::render::{Material, Scene, Triangles, View};
/// use glam::DVec3;
///
/// let saddle = Triangles::grid(16, 16, |u, v| {
///     let (x, y) = (2.0 * u - 1.0, 2.0 * v - 1.0);
///     (DVec3::new(x, y, x * y), DVec3::new(-y, -x, 1.0))
/// });
/// let view = View::perspective(DVec3::new(3.0, -4.0, 3.0), DVec3::ZERO, DVec3::Z, 30.0);
/// let picture = Scene::new(view)
///     .surface(&saddle, Material::matte(Colour::Sky).isolines(8))
///     .point(DVec3::ZERO, 0.05, Colour::Vermilion)
///     .render(40, 30);
/// assert_eq!(picture.pixel(0, 0), [0, 0, 0, 0]);
/// assert_eq!(picture.pixel(20, 15)[3], 255);
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Scene {
    view: View,
    objects: Vec<Object>,
}

/// Triangles of one material.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Object {
    pub mesh: Triangles,
    pub material: Material,
}

impl Scene {
    /// An empty scene.
    #[must_use]
    pub fn new(view: View) -> Self {
        Self {
            view,
            objects: Vec::new(),
        }
    }

    /// Adds a surface: a mesh of the library, or [`Triangles`].
    #[must_use]
    pub fn surface(mut self, mesh: impl Into<Triangles>, material: Material) -> Self {
        self.objects.push(Object {
            mesh: mesh.into(),
            material,
        });
        self
    }

    /// Adds a curve: a tube of this radius, with round ends, around a polyline.
    #[must_use]
    pub fn tube(self, polyline: &[DVec3], radius: f64, colour: Colour) -> Self {
        let ends = [polyline.first(), polyline.last()];
        let tube = self.surface(Triangles::tube(polyline, radius), Material::matte(colour));
        ends.into_iter()
            .flatten()
            .fold(tube, |scene, &end| scene.point(end, radius, colour))
    }

    /// Adds a point: a ball of this radius.
    #[must_use]
    pub fn point(self, at: DVec3, radius: f64, colour: Colour) -> Self {
        self.surface(Triangles::ball(at, radius), Material::matte(colour))
    }

    /// The view of the scene, for the places of labels ([`View::project`]).
    #[must_use]
    pub fn view(&self) -> &View {
        &self.view
    }

    /// The picture of this size in pixels, transparent where nothing is.
    ///
    /// # Edge cases
    /// Triangles without area in the picture, and those with a NaN or infinite corner, are not seen. Where two surfaces
    /// lie at exactly the same depth, the one added first is seen. A view that is no camera (a coordinate of the eye that is not finite, an angle
    /// or height of 0) sees nothing.
    ///
    /// # Panics
    /// When a triangle of a mesh names a vertex that its lists do not have.
    #[must_use]
    pub fn render(&self, width: u32, height: u32) -> Picture {
        trace::render(&self.objects, &self.view, width, height)
    }
}

impl From<&Triangles> for Triangles {
    fn from(mesh: &Triangles) -> Self {
        mesh.clone()
    }
}
