//! The picture of a scene: 4 × 4 rays a pixel, and the shading of what they meet first.
//!
//! The camera and the hierarchy of boxes are the library's. The hierarchy decides exactly which triangle is first, so no ray falls between two triangles that share
//! an edge, and the bytes are the same however many threads share the work.
//!
//! *Sources*: H. Igehy, *Tracing ray differentials*, 1999 (how wide a line of constant parameter is in the picture).

use std::thread;

use facette::camera::Pixel;
use facette::intersection::hierarchy::{Found, Query};
use facette::ray::Ray;
use glam::DVec3;

use super::colour::encode;
use super::facets::{Facet, Facets, single};
use super::material::Sample;
use super::picture::Picture;
use super::scene::Object;
use super::view::{Sight, View};

/// Rays along each side of a pixel.
const SAMPLES: usize = 4;
/// Rays through a pixel.
const RAYS: usize = SAMPLES * SAMPLES;

/// What the rays of a picture have in common.
struct Tracer<'a> {
    objects: &'a [Object],
    facets: &'a Facets,
    sight: Sight,
    /// Half the width of an isoparametric line, in pixels.
    half_line: f64,
}

/// The picture of the objects; transparent where the view is no camera.
pub(super) fn render(objects: &[Object], view: &View, width: u32, height: u32) -> Picture {
    let mut rgba = vec![0; 4 * width as usize * height as usize];
    let facets = Facets::new(objects);
    if let Some(sight) = Sight::new(&facets.placement.view(view), width, height) {
        let tracer = Tracer {
            objects,
            facets: &facets,
            sight,
            half_line: (f64::from(height) / 700.0).max(0.5),
        };
        tracer.render(&mut rgba);
    }
    Picture {
        width,
        height,
        rgba,
    }
}

impl Tracer<'_> {
    /// Fills the bytes of the picture, its rows dealt out among the processor's threads.
    fn render(&self, rgba: &mut [u8]) {
        let threads = thread::available_parallelism().map_or(1, usize::from);
        let mut hands: Vec<Vec<(u32, &mut [u8])>> = (0..threads).map(|_| Vec::new()).collect();
        let bytes = 4 * self.sight.size().columns() as usize;
        for (row, line) in (0..).zip(rgba.chunks_mut(bytes)) {
            hands[row as usize % threads].push((row, line));
        }
        thread::scope(|scope| {
            for hand in hands {
                scope.spawn(move || {
                    let mut query = self.facets.hierarchy.query();
                    for (row, line) in hand {
                        self.fill_row(&mut query, row, line);
                    }
                });
            }
        });
    }

    fn fill_row(&self, query: &mut Query<'_>, row_from_top: u32, line: &mut [u8]) {
        let row = self.sight.size().rows() - 1 - row_from_top;
        for (column, bytes) in (0..).zip(line.chunks_exact_mut(4)) {
            let pixel = self.pixel(query, Pixel { column, row });
            bytes.copy_from_slice(&pixel);
        }
    }

    /// The four bytes of a pixel.
    // ANCHOR: pixel
    fn pixel(&self, query: &mut Query<'_>, pixel: Pixel) -> [u8; 4] {
        average((0..RAYS).filter_map(|number| {
            let [across, down] = [number % SAMPLES, number / SAMPLES].map(position);
            let ray = self.sight.ray(pixel, [across, 1.0 - down]);
            let (moved, left) = single(&ray, self.sight.is_parallel());
            let found = query.nearest(&moved)?;
            Some(self.shade(&found, &ray, left + f64::from(found.hit.t)))
        }))
    }
    // ANCHOR_END: pixel

    /// The colour of what a ray meets at t.
    fn shade(&self, found: &Found, ray: &Ray<DVec3>, t: f64) -> DVec3 {
        let facet = &self.facets.list[found.triangle as usize];
        let Object { mesh, material } = &self.objects[facet.object];
        let corners = mesh.triangles[facet.triangle].map(|corner| corner as usize);
        let [second, third] = found.hit.parameters.map(f64::from);
        let weights = [1.0 - second - third, second, third];
        let smooth = if mesh.normals.is_empty() {
            None
        } else {
            let terms = corners.iter().zip(weights);
            let blend: DVec3 = terms
                .map(|(&corner, weight)| weight * mesh.normals[corner])
                .sum();
            blend.try_normalize()
        };
        let normal = smooth.unwrap_or_else(|| facet.normal().normalize_or_zero());
        let parameters = (!mesh.parameters.is_empty()).then(|| {
            let steps = self.steps_on(facet, ray, t);
            [0, 1].map(|which| {
                let values = corners.map(|corner| mesh.parameters[corner][which]);
                let [along, up] = steps.map(|changes| combine(changes, values));
                (combine(weights, values), (along * along + up * up).sqrt())
            })
        });
        let sample = Sample {
            normal,
            to_eye: -ray.direction.normalize_or_zero(),
            parameters,
            half_line: self.half_line,
        };
        material.shade(&sample, self.sight.lights())
    }

    /// How the weights of a facet's corners change when the ray moves by a pixel to the right, or by one up.
    ///
    /// The hit point o + t d moves with o and d, and along d so far that it stays in the facet's plane.
    // ANCHOR: steps_on
    fn steps_on(&self, facet: &Facet, ray: &Ray<DVec3>, t: f64) -> [[f64; 3]; 2] {
        let (normal, d) = (facet.normal(), ray.direction);
        self.sight.pixel_steps().map(|step| {
            let step = if self.sight.is_parallel() {
                step
            } else {
                t * step
            };
            facet.weight_changes(step - d * (normal.dot(step) / normal.dot(d)))
        })
    }
    // ANCHOR_END: steps_on
}

/// Where a ray passes through its pixel, of one row or column of rays.
fn position(number: usize) -> f64 {
    (number as f64 + 0.5) / SAMPLES as f64
}

fn combine(weights: [f64; 3], values: [f64; 3]) -> f64 {
    weights[0] * values[0] + weights[1] * values[1] + weights[2] * values[2]
}

/// The pixel of the rays that meet something: their mean colour, and their share as alpha.
fn average(colours: impl Iterator<Item = DVec3>) -> [u8; 4] {
    let (mut sum, mut covered) = (DVec3::ZERO, 0_usize);
    for colour in colours {
        sum += colour;
        covered += 1;
    }
    if covered == 0 {
        return [0; 4];
    }
    let [red, green, blue] = (sum / covered as f64).to_array().map(encode);
    let alpha = u8::try_from((255 * covered + RAYS / 2) / RAYS).unwrap_or(u8::MAX);
    [red, green, blue, alpha]
}
