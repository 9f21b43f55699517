//! Visibility by a depth buffer with 4 × 4 samples a pixel, and the shading of what is seen.
//!
//! A triangle of homogeneous points p₀, p₁, p₂ = (x, y, w) covers the sample s = (x, y, 1) when the three numbers
//! eₖ = (pᵢ × pⱼ) · s have the sign of p₀ · (p₁ × p₂); then eₖ / Σe are the barycentric coordinates of the point in
//! space, and no clipping is needed. Exchanging pᵢ and pⱼ negates eₖ exactly, also when rounded: so no sample falls
//! between two triangles that share an edge.
//!
//! *Sources*: Marc Olano and Trey Greer, Triangle scan conversion using 2D homogeneous coordinates, 1997.

use glam::DVec3;

use super::camera::Camera;
use super::colour::encode;
use super::material::Sample;
use super::picture::Picture;
use super::scene::Object;

/// Samples along each side of a pixel.
const SAMPLES: u32 = 4;
/// Rows of pixels that are worked on at a time.
const BAND: u32 = 16;

/// A triangle made ready: what a sample needs to know.
struct Facet {
    object: usize,
    triangle: usize,
    /// The coefficients of e₀, e₁, e₂, with the sign that makes them positive inside.
    edges: [DVec3; 3],
    depths: [f64; 3],
    /// The least and the greatest pixel position in x and y.
    bounds: [[f64; 2]; 2],
}

impl Facet {
    fn new(object: usize, triangle: usize, points: [DVec3; 3], camera: &Camera) -> Option<Self> {
        let [p, q, r] = points.map(|point| camera.homogeneous(point));
        let volume = p.dot(q.cross(r));
        if volume.abs() <= 0.0 || !volume.is_finite() {
            return None;
        }
        let sign = volume.signum();
        let edges = [q.cross(r), r.cross(p), p.cross(q)].map(|edge| sign * edge);
        let mut bounds = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
        for corner in [p, q, r] {
            let is_in_front = corner.z > 0.0;
            for (bound, coordinate) in bounds.iter_mut().zip([corner.x, corner.y]) {
                let position = coordinate / corner.z;
                let [least, greatest] = if is_in_front {
                    [position; 2]
                } else {
                    [f64::NEG_INFINITY, f64::INFINITY]
                };
                *bound = [bound[0].min(least), bound[1].max(greatest)];
            }
        }
        let depths = points.map(|point| camera.depth(point));
        Some(Self {
            object,
            triangle,
            edges,
            depths,
            bounds,
        })
    }

    /// The barycentric coordinates at a pixel position; `None` outside.
    fn cover(&self, [x, y]: [f64; 2]) -> Option<[f64; 3]> {
        let e = self.edges.map(|edge| edge.x * x + edge.y * y + edge.z);
        let sum = e[0] + e[1] + e[2];
        let is_inside = e.iter().all(|&side| side >= 0.0) && sum > 0.0;
        is_inside.then(|| e.map(|side| side / sum))
    }

    /// The gradient over the picture of a quantity given at the corners, at a pixel position; per pixel.
    fn gradient(&self, corners: [f64; 3], value: f64, [x, y]: [f64; 2]) -> f64 {
        let sum: f64 = self
            .edges
            .iter()
            .map(|edge| edge.x * x + edge.y * y + edge.z)
            .sum();
        let slope = |axis: fn(&DVec3) -> f64| -> f64 {
            let terms = self.edges.iter().zip(corners);
            terms
                .map(|(edge, corner)| (corner - value) * axis(edge))
                .sum::<f64>()
                / sum
        };
        let (along, down) = (slope(|edge| edge.x), slope(|edge| edge.y));
        (along * along + down * down).sqrt()
    }
}

/// The picture of the objects.
pub(super) fn render(objects: &[Object], camera: &Camera, width: u32, height: u32) -> Picture {
    let facets = facets(objects, camera);
    let mut rgba = Vec::with_capacity(4 * width as usize * height as usize);
    let half_line = (f64::from(height) / 700.0).max(0.5);
    for top in (0..height).step_by(BAND as usize) {
        let rows = BAND.min(height - top);
        let seen = visible(&facets, top, [width, rows]);
        for row in 0..rows {
            for column in 0..width {
                let samples = sample_indices(column, row, width);
                let colours = samples.filter_map(|(index, x, y)| {
                    let facet = &facets[seen[index]? as usize];
                    let position = [x, y + f64::from(top)];
                    Some(shade(facet, objects, camera, position, half_line))
                });
                rgba.extend(average(colours));
            }
        }
    }
    Picture {
        width,
        height,
        rgba,
    }
}

/// Index and position, relative to the band, of the samples of a pixel.
fn sample_indices(column: u32, row: u32, width: u32) -> impl Iterator<Item = (usize, f64, f64)> {
    (0..SAMPLES * SAMPLES).map(move |number| {
        let (across, down) = (
            column * SAMPLES + number % SAMPLES,
            row * SAMPLES + number / SAMPLES,
        );
        let index = down as usize * (width * SAMPLES) as usize + across as usize;
        (index, position(across), position(down))
    })
}

/// The pixel position of a sample's row or column.
fn position(sample: u32) -> f64 {
    (f64::from(sample) + 0.5) / f64::from(SAMPLES)
}

fn facets(objects: &[Object], camera: &Camera) -> Vec<Facet> {
    let mut facets = Vec::new();
    for (number, object) in objects.iter().enumerate() {
        for (triangle, corners) in object.mesh.triangles.iter().enumerate() {
            let points = corners.map(|corner| object.mesh.positions[corner as usize]);
            facets.extend(Facet::new(number, triangle, points, camera));
        }
    }
    facets
}

/// For every sample of a band of pixel rows, the nearest facet that covers it.
fn visible(facets: &[Facet], top: u32, [width, rows]: [u32; 2]) -> Vec<Option<u32>> {
    let (columns, lines) = (width * SAMPLES, rows * SAMPLES);
    let mut seen = vec![None; columns as usize * lines as usize];
    let mut nearest = vec![f64::INFINITY; seen.len()];
    for (facet, number) in facets.iter().zip(0_u32..) {
        let [across, down] = facet.bounds;
        let down = down.map(|position| position - f64::from(top));
        for line in sample_range(down, lines) {
            for column in sample_range(across, columns) {
                let at = [position(column), position(line) + f64::from(top)];
                let Some(weights) = facet.cover(at) else {
                    continue;
                };
                let depth = combine(weights, facet.depths);
                let index = line as usize * columns as usize + column as usize;
                if depth < nearest[index] {
                    nearest[index] = depth;
                    seen[index] = Some(number);
                }
            }
        }
    }
    seen
}

/// The samples, of `count` in a row, between two pixel positions.
#[allow(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "a cast of a float saturates at 0 and at the greatest integer, which is meant"
)]
fn sample_range([least, greatest]: [f64; 2], count: u32) -> std::ops::Range<u32> {
    let first = (least * f64::from(SAMPLES) - 1.0) as u32;
    let last = (greatest * f64::from(SAMPLES) + 1.0) as u32;
    first.min(count)..last.min(count)
}

fn combine(weights: [f64; 3], values: [f64; 3]) -> f64 {
    weights[0] * values[0] + weights[1] * values[1] + weights[2] * values[2]
}

fn shade(
    facet: &Facet,
    objects: &[Object],
    camera: &Camera,
    at: [f64; 2],
    half_line: f64,
) -> DVec3 {
    let Object { mesh, material } = &objects[facet.object];
    let corners = mesh.triangles[facet.triangle].map(|corner| corner as usize);
    let weights = facet.cover(at).unwrap_or([1.0 / 3.0; 3]);
    let blend = |points: &[DVec3]| -> DVec3 {
        let terms = corners.iter().zip(weights);
        terms.map(|(&corner, weight)| weight * points[corner]).sum()
    };
    let smooth = if mesh.normals.is_empty() {
        None
    } else {
        blend(&mesh.normals).try_normalize()
    };
    let normal = smooth.unwrap_or_else(|| {
        let [a, b, c] = corners.map(|corner| mesh.positions[corner]);
        (b - a).cross(c - a).normalize_or_zero()
    });
    let parameters = (!mesh.parameters.is_empty()).then(|| {
        [0, 1].map(|which| {
            let values = corners.map(|corner| mesh.parameters[corner][which]);
            let value = combine(weights, values);
            (value, facet.gradient(values, value, at))
        })
    });
    let to_eye = camera.direction_from(blend(&mesh.positions));
    let sample = Sample {
        normal,
        to_eye,
        parameters,
        half_line,
    };
    material.shade(&sample, camera)
}

/// The pixel of the samples that are covered: their mean colour, and their share as alpha.
fn average(colours: impl Iterator<Item = DVec3>) -> [u8; 4] {
    let (mut sum, mut covered) = (DVec3::ZERO, 0_u32);
    for colour in colours {
        sum += colour;
        covered += 1;
    }
    if covered == 0 {
        return [0; 4];
    }
    let [red, green, blue] = (sum / f64::from(covered)).to_array().map(encode);
    let all = SAMPLES * SAMPLES;
    let alpha = u8::try_from((255 * covered + all / 2) / all).unwrap_or(u8::MAX);
    [red, green, blue, alpha]
}
