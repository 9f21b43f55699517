//! The first two programs of the course (slides 102 to 105): a sphere in white, then the nearest of many surfaces in its colour.

use facette::camera::{Camera, ImageSize};
use facette::intersection::{Group, Intersect};
use facette::ray::Ray;
use facette_figure::render::Picture;
use glam::DVec3;

/// A colour as an image file stores it.
pub type Rgb = [u8; 3];

pub const WHITE: Rgb = [255; 3];
pub const BLACK: Rgb = [0; 3];

/// For each pixel: white where its ray meets the surface, and black elsewhere.
// ANCHOR: silhouette
pub fn silhouette(
    camera: &Camera<DVec3>,
    size: ImageSize,
    surface: &impl Intersect<Point = DVec3>,
) -> Picture {
    let colour = |pixel| {
        let ray = camera.pixel_ray(size, pixel);
        if surface.is_hit_by(&ray) {
            WHITE
        } else {
            BLACK
        }
    };
    picture(size, size.pixels_in_file_order().map(colour))
}
// ANCHOR_END: silhouette

/// Surfaces of any kind, each with a colour.
// ANCHOR: trace
pub struct Scene {
    pub surfaces: Group<Box<dyn Intersect<Point = DVec3>>>,
    pub colours: Vec<Rgb>,
}

impl Scene {
    /// The colour of the nearest surface along the ray, and black where there is none.
    pub fn trace(&self, ray: &Ray<DVec3>) -> Rgb {
        match self.surfaces.nearest(ray) {
            Some((surface, _)) => self.colours[surface],
            None => BLACK,
        }
    }
}
// ANCHOR_END: trace

/// For each pixel: the colour of what its ray meets first.
// ANCHOR: first_picture
pub fn first_picture(camera: &Camera<DVec3>, size: ImageSize, scene: &Scene) -> Picture {
    let colour = |pixel| {
        let ray = camera.pixel_ray(size, pixel);
        scene.trace(&ray)
    };
    picture(size, size.pixels_in_file_order().map(colour))
}
// ANCHOR_END: first_picture

/// The picture of these colours, which come row by row from the top.
fn picture(size: ImageSize, colours: impl Iterator<Item = Rgb>) -> Picture {
    let rgba = colours.flat_map(|[red, green, blue]| [red, green, blue, 255]);
    Picture {
        width: size.columns(),
        height: size.rows(),
        rgba: rgba.collect(),
    }
}
